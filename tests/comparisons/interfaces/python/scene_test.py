"""Scenes from files, mappings and keywords have the checks and messages of scene files."""
import copy
import dataclasses
import math
import pickle
import tempfile
import unittest
from pathlib import Path

import numpy as np
import rockstack
from scenes import BLOCK, TWO, message_of_program, rocking

#: What is wrong with a scene, in the words of either.
WRONG = {
    "unknown key": ({"duration": 1.0, "bloks": []}, 'duration = 1.0\nbloks = []\n'),
    "range": ({"duration": -1.0, "blocks": [BLOCK]},
              'duration = -1.0\n[[blocks]]\nwidth = 0.5\nheight = 1.5\ndensity = 2500.0\n'),
    "not a number": ({"duration": 1.0, "blocks": [{**BLOCK, "width": math.nan}]},
                     'duration = 1.0\n[[blocks]]\nwidth = nan\nheight = 1.5\ndensity = 2500.0\n'),
    "length": ({"duration": 1.0, "blocks": [BLOCK], "initial": {"angles": [0.1, 0.2]}},
               'duration = 1.0\n[[blocks]]\nwidth = 0.5\nheight = 1.5\ndensity = 2500.0\n[initial]\nangles = [0.1, 0.2]\n'),
    "shape": ({"duration": 1.0, "blocks": [BLOCK], "initial": {"angles": np.zeros((1, 1))}},
              'duration = 1.0\n[[blocks]]\nwidth = 0.5\nheight = 1.5\ndensity = 2500.0\n[initial]\nangles = [[0.0]]\n'),
    "kind": ({"duration": True, "blocks": [BLOCK]}, 'duration = true\n'),
    "choice": ({"duration": 1.0, "law": "slippery"}, 'duration = 1.0\nlaw = "slippery"\n'),
    "no blocks": ({"duration": 1.0}, 'duration = 1.0\n'),
    "infinite sample": ({"duration": 1.0, "blocks": [BLOCK],
                         "ground": {"horizontal": {"samples": np.array([0.0, np.inf]), "interval": 0.1}}},
                        'duration = 1.0\n[[blocks]]\nwidth = 0.5\nheight = 1.5\ndensity = 2500.0\n'
                        '[ground.horizontal]\nsamples = [0.0, inf]\ninterval = 0.1\n'),
    "missing": ({"duration": 1.0, "blocks": [{"width": 0.5, "height": 1.5}]},
                'duration = 1.0\n[[blocks]]\nwidth = 0.5\nheight = 1.5\n'),
}


class SceneTest(unittest.TestCase):
    def test_messages_are_those_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "scene.toml"
            for what, (mapping, text) in WRONG.items():
                with self.subTest(what):
                    file.write_text(text)
                    told = message_of_program("solve", str(file), "--out", folder + "/out")
                    with self.assertRaises(rockstack.InputError) as of_file:
                        rockstack.Scene.read(file)
                    self.assertEqual("rockstack: " + str(of_file.exception), told)
                    with self.assertRaises(rockstack.InputError) as of_mapping:
                        rockstack.Scene(mapping)
                    place, message = str(of_mapping.exception).split(": ", 1)
                    self.assertEqual(place, "scene")
                    self.assertTrue(told.endswith(": " + message), (told, message))

    def test_input_errors_are_value_errors(self):
        self.assertTrue(issubclass(rockstack.InputError, ValueError))

    def test_all_ways_make_the_same_scene(self):
        wanted = rockstack.solve(rockstack.Scene.read("three-drums", ["duration=0.5"])).angles
        table = rockstack.Scene.read("three-drums", ["duration=0.5"]).to_dict()
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "three-drums.toml"
            file.write_text(rockstack.Scene(table).to_toml())
            for scene in (rockstack.Scene(table), rockstack.Scene(**table), rockstack.Scene.read(file),
                          copy.copy(rockstack.Scene(table)), pickle.loads(pickle.dumps(rockstack.Scene(table)))):
                np.testing.assert_array_equal(rockstack.solve(scene).angles, wanted)

    def test_texts_read_as_they_were_given(self):
        title = "".join(map(chr, range(1, 0x100))) + "\u2028\U0001f4d0"
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "scene.toml"
            file.write_text(rocking(title=title).to_toml(), encoding="utf-8")
            self.assertEqual(rockstack.Scene.read(file).title, title)

    def test_numbers_of_any_kind_are_numbers(self):
        wanted = rocking().to_dict()
        for block in ({key: np.float64(value) for key, value in BLOCK.items()},
                      {"width": np.float32(0.5), "height": np.array(1.5), "density": np.int16(2500)},
                      {"width": 0.5, "height": 1.5, "density": 2500}):
            self.assertEqual(rocking(blocks=(block,)).to_dict(), wanted)
        with self.assertRaisesRegex(rockstack.InputError, "duration = inf"):
            rocking(duration=10 ** 400)

    def test_what_no_file_can_hold_is_refused(self):
        endless = []
        endless.append(endless)
        for values in ({"blocks": endless}, {"initial": {"angles": object()}}, {"initial": {1: 2}}, {"title": 3},
                       {"ground": {"horizontal": {"samples": "abc", "interval": 0.1}}}):
            with self.subTest(values=str(values)), self.assertRaises(rockstack.InputError):
                rocking(**values)

    def test_any_value_anywhere_is_taken_or_refused(self):
        junk = [None, True, 0, -1.0, math.nan, math.inf, 10 ** 400, "", "ä\n\x00", "\ud800", b"bytes", [], [[]], {}, {"a": 1}, {1: 2}, {"\ud800": 1}, (),
                range(3), object(), np.array(3), np.zeros((0, 3)), np.zeros(3, dtype=complex), np.array(["a"]), np.float32(1),
                np.array([None]), Path("x"), {1.0}, iter([1]), "paper", "1", [True], 1e-300]
        table = rockstack.Scene.read("flexible-foundation").to_dict()
        table["ground"] = {"horizontal": {"pulse": "sine", "amplitude": 1.0, "period": 1.0},
                           "vertical": {"samples": [0.0, 1.0], "interval": 0.1, "peak": 1.0}}

        def places(node, path=()):
            yield path
            for key, value in node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ():
                yield from places(value, (*path, key))

        class Failing:
            def __array__(self):
                raise ArithmeticError("no array")

        with self.assertRaises(ArithmeticError):
            rocking(duration=Failing())
        taken = 0
        for path in places(table):
            for value in junk:
                changed = copy.deepcopy(table)
                parent = changed
                for key in path[:-1]:
                    parent = parent[key]
                if path:
                    parent[path[-1]] = value
                try:
                    rockstack.Scene(changed if path else {"initial": value})
                    taken += 1
                except rockstack.InputError:
                    continue
        self.assertGreater(taken, 0)

    def test_a_scene_is_changed_by_its_keys(self):
        scene = rockstack.Scene(duration=1.0, blocks=TWO)
        taller = scene.replace({"blocks.2.height": 1.5, "initial.angles": np.array([0.0, 0.1])})
        self.assertGreater(scene.slenderness[1], taller.slenderness[1])
        self.assertEqual(taller.to_dict()["initial"], {"angles": [0.0, 0.1]})
        for key, message in {"blocks.3.height": "there are 2 blocks, must be 1 to 2", "blocks.1.depth": "unknown key",
                             "": "must be a scene's key"}.items():
            with self.assertRaisesRegex(rockstack.InputError, message):
                scene.replace({key: 1.0})

    def test_blocks_have_the_keys_of_their_table(self):
        keys = {row["key"] for row in rockstack.keys("scene") if row["table"] == "[[blocks]]"}
        self.assertEqual({field.name for field in dataclasses.fields(rockstack.Block)}, keys)
        block = {"width": 0.5, "height": 1.5, "mass": 3.0, "inertia": 2.0, "center_of_mass": [0.1, -0.2]}
        scene = rocking(blocks=[rockstack.Block(**block)], initial={})
        self.assertEqual(scene.to_dict()["blocks"], [block])
        self.assertEqual(rocking(blocks=scene.blocks, initial={}), scene)
        self.assertEqual((scene.blocks[0].height, scene.blocks[0].center_of_mass[1], scene.blocks[0].density), (1.5, -0.2, None))

    def test_equal_scenes_are_those_of_equal_keys(self):
        scene = rocking()
        for other in (rocking(), scene.replace(duration=1.0), rocking(blocks=[dict(reversed(BLOCK.items()))])):
            self.assertEqual((scene, hash(scene)), (other, hash(other)))
        for other in (scene.replace(duration=2.0), scene.replace({"blocks.1.height": 1.4}, law="paper"), "scene", None):
            self.assertNotEqual(scene, other)
        with tempfile.TemporaryDirectory() as one, tempfile.TemporaryDirectory() as two:
            for folder, sample in ((one, 1), (two, 2)):
                Path(folder, "motion.txt").write_text(f"# dt = 0.1, units: m/s2\n0\n{sample}\n0\n")
            ground = {"horizontal": {"record": "motion.txt"}}
            shaken = [rocking(ground=ground, folder=folder) for folder in (one, one, two)]
            self.assertEqual(shaken[0], shaken[1])
            self.assertNotEqual(shaken[0], shaken[2])
            self.assertEqual(eval(repr(shaken[0])), shaken[0])

    def test_what_is_printed_reads_back(self):
        for name in rockstack.shipped("scenes"):
            scene = rockstack.Scene.read(name)
            with self.subTest(name):
                self.assertEqual(eval(repr(scene)), scene)
        rigid = rocking(law="compliant", contact={"stiffness": [np.inf], "damping": 0.0})
        self.assertEqual(eval(repr(rigid)), rigid)
        self.assertEqual(eval(repr(rigid.blocks)), rigid.blocks)
        long = rocking(ground={"horizontal": {"samples": np.sin(np.arange(1000.0)), "interval": 0.01}})
        self.assertLess(len(repr(long)), 500)
        with self.assertRaisesRegex(rockstack.InputError, "samples"):
            eval(repr(long))

    def test_keys_are_those_of_the_program(self):
        self.assertEqual({row["key"] for row in rockstack.keys("scene") if row["table"] == "[initial]"},
                         {"angles", "velocities", "slip_velocities", "offsets", "gaps", "gap_velocities", "springs"})
        with self.assertRaises(rockstack.InputError):
            rockstack.keys("engine")
        self.assertIn("first-look", {Path(name).stem for name in rockstack.shipped("suites")})
