"""Solutions are those of the program, and their arrays look at them in place."""
import gc
import json
import pickle
import shutil
import subprocess
import sys
import unittest

import numpy as np
import rockstack
from scenes import ENDLESS, LONG, SOURCE, TWO, interrupted, rocking, solved_by_program

LAWS = {"paper": "spanos-free-rocking", "consistent": "three-drums", "unilateral": "thrown-block",
        "compliant": "flexible-foundation"}


class SolveTest(unittest.TestCase):
    def test_the_same_bits_as_the_program_under_every_law(self):
        for law, name in LAWS.items():
            with self.subTest(law):
                overrides = ["duration=1"]
                scene = rockstack.Scene.read(name, overrides)
                self.assertEqual(scene.law, law)
                folder = solved_by_program(SOURCE / "comparisons/scenes" / (name + ".toml"), "--set", overrides[0])
                self.addCleanup(shutil.rmtree, folder)
                rows = np.genfromtxt(folder / "history.csv", delimiter=",", names=True, dtype=None, encoding="utf-8")
                solution = rockstack.solve(scene)
                np.testing.assert_array_equal(solution.times, rows["time"])
                for k in range(len(scene.blocks)):
                    np.testing.assert_array_equal(solution.angles[:, k], rows[f"theta_{k + 1}"])
                    np.testing.assert_array_equal(solution.velocities[:, k], rows[f"omega_{k + 1}"])
                np.testing.assert_array_equal(solution.patterns, rows["pattern"].astype(str))
                events = np.atleast_1d(np.genfromtxt(folder / "events.csv", delimiter=",", names=True, dtype=None,
                                                     encoding="utf-8"))
                self.assertEqual(len(solution.events), len(events))
                for column in ("time", "kind", "interface", "consistency"):
                    np.testing.assert_array_equal(solution.events[column], events[column])
                np.testing.assert_array_equal(solution.events["after"][:, 0], events["omega_after_1"])
                summary = json.loads((folder / "summary.json").read_text())
                self.assertEqual(solution.outcome, {name: summary[name] for name in solution.outcome})
                for name in ("toppled", "topple_time", "peak_ratio", "force_friction", "ground_left", "uplift_1"):
                    self.assertEqual(getattr(solution, name), summary[name])
                self.assertEqual(pickle.loads(pickle.dumps(solution)).peak_ratio, solution.peak_ratio)
                with self.assertRaisesRegex(AttributeError, "no attribute 'peak_ration'"):
                    solution.peak_ration

    def test_shapes(self):
        solution = rockstack.solve(rockstack.Scene.read("thrown-stack", ["duration=0.5"]), interval=0.01)
        samples, blocks = 51, len(solution.scene.blocks)
        for name in ("angles", "velocities", "slips", "gaps", "reactions"):
            self.assertEqual(getattr(solution, name).shape, (samples, blocks), name)
        for name in ("places", "place_rates"):
            self.assertEqual(getattr(solution, name).shape, (samples, blocks, 2), name)
        for name in ("peaks", "uplifts", "slips_left", "largest_slips", "lifts"):
            self.assertEqual(getattr(solution, name).shape, (blocks,), name)
        self.assertEqual(solution.demands["forces"].dtype.names[0], "least_normal")

    def test_laws_of_pivots_have_no_slips_and_tell_demands(self):
        solution = rockstack.solve(rocking())
        self.assertIsNone(solution.slips)
        self.assertIsNone(solution.spring_energies)
        self.assertTrue(solution.valid)
        self.assertGreater(solution.demands["impulses"]["friction"][0], 0)
        self.assertIn("needs friction", solution.verdict)
        slippery = rockstack.solve(rocking(contact={"friction": 0.01}))
        self.assertFalse(slippery.valid)
        self.assertIn("friction", slippery.warnings[0])

    def test_samples_are_where_they_are_asked_for(self):
        times = [0.0, 0.1, 0.7]
        np.testing.assert_array_equal(rockstack.solve(rocking(), times=times).times, times)
        every = rockstack.solve(rocking(), interval=0.1)
        np.testing.assert_array_equal(rockstack.solve(rocking(), times=every.times).angles, every.angles)
        self.assertEqual(len(rockstack.solve(rocking(), interval=None).times), 0)
        self.assertEqual(rockstack.solve(rocking(), interval=None).verdict, "")

    def test_a_name_or_a_file_stands_for_its_scene(self):
        name, file = "housner-block", SOURCE / "comparisons/scenes/housner-block.toml"
        wanted = rockstack.solve(rockstack.Scene.read(name), interval=0.1)
        self.assertEqual([rockstack.solve(name, interval=0.1), *rockstack.solve_many([file, str(file), wanted.scene], interval=0.1)],
                         [wanted] * 4)
        self.assertEqual(wanted.scene, rockstack.Scene.read(name))
        with self.assertRaisesRegex(rockstack.InputError, "no-such-scene"):
            rockstack.solve("no-such-scene")
        if engine := next((engine["name"] for engine in rockstack.engines()), None):
            self.assertEqual(rockstack.simulate(name, engine, 0.01), rockstack.simulate(wanted.scene, engine, 0.01))

    def test_wrong_options_are_refused(self):
        for options in ({"times": [0.2, 0.1]}, {"times": [np.nan]}, {"times": [[0.1]]}, {"times": [-1.0]},
                        {"interval": 0.0}, {"interval": 1e-9}, {"interval": np.nan}, {"tolerance": -1.0}, {"step": 0.0},
                        {"integrator": "euler"}, {"times": [np.inf]}):
            with self.subTest(options=options), self.assertRaises(rockstack.InputError):
                rockstack.solve(rocking(), **options)
        with self.assertRaisesRegex(TypeError, "^scene = {'duration': 1.0}: must be a rockstack.Scene or a text or a path$"):
            rockstack.solve({"duration": 1.0})
        vary = [{"key": "gravity", "values": [9.0]}]
        for wrong in (0, -1, 1025, 10 ** 6):
            for call in (lambda: rockstack.solve_many([rocking()], threads=wrong),
                         lambda: rockstack.sweep(scene=rocking(), vary=vary, threads=wrong),
                         lambda: rockstack.compare(rocking(), jobs=wrong)):
                with self.assertRaisesRegex(rockstack.InputError, f"(threads|jobs) = {wrong}: must be from 1 to 1024"):
                    call()

    def test_many_are_the_ones(self):
        scenes = [rocking(initial={"angles": [angle]}, duration=duration)
                  for angle in (0.05, 0.1, 0.2) for duration in (0.5, 1.0)]
        scenes.append(rockstack.Scene(duration=1.0, blocks=TWO * 2, initial={"angles": [0.05] * 4}))
        for options in ({}, {"interval": None}, {"threads": 1}, {"times": [0.1, 0.2]}):
            for scene, solution in zip(scenes, rockstack.solve_many(scenes, **options)):
                options.pop("threads", None)
                alone = rockstack.solve(scene, **options)
                self.assertIs(solution.scene, scene)
                np.testing.assert_array_equal(solution.angles, alone.angles)
                np.testing.assert_array_equal(solution.peaks, alone.peaks)
                np.testing.assert_array_equal(solution.events["time"], alone.events["time"])
        self.assertEqual(rockstack.solve_many([]), [])

    def test_the_interpreter_is_free_meanwhile(self):
        """A thread that never comes back would keep the main one from its end."""
        for call in (f"rockstack.solve({ENDLESS}, interval=None)", f"rockstack.solve_many([{ENDLESS}], interval=1e3)"):
            program = (f"import os, threading, rockstack\ncalled = threading.Event()\n"
                       f"threading.Thread(target=lambda: (called.set(), {call})).start()\n"
                       "called.wait()\nfor _ in range(10 ** 6): pass\nos._exit(42)")
            with self.subTest(call):
                self.assertEqual(subprocess.run([sys.executable, "-c", program], timeout=300).returncode, 42)

    def test_a_motion_that_cannot_be_followed_keeps_what_is_known(self):
        """At no resolution to speak of, chatter has too many events to wait for."""
        slender = {"width": 0.1, "height": 2.0, "density": 2500.0}
        chatter = rocking(blocks=[slender], initial={"angles": [1e-6]}, duration=2.0)
        with self.assertRaisesRegex(rockstack.Unfinished, "no end is in sight") as raised:
            rockstack.solve(chatter, tolerance=1e-100)
        known = raised.exception.solution
        self.assertGreater(len(known.times), 1000)
        self.assertLess(known.times[-1], 2)
        self.assertGreaterEqual(known.events["time"][-1], known.times[-1])
        whole, unfinished = rockstack.solve_many([rocking(), chatter], tolerance=1e-100, failures="keep")
        self.assertEqual(len(whole.times), 1001)
        np.testing.assert_array_equal(unfinished.solution.angles, known.angles)
        with self.assertRaises(rockstack.Unfinished):
            rockstack.solve_many([rocking(), chatter], tolerance=1e-100)

    def test_keyboard_interrupts_end_what_takes_long(self):
        vary = "vary=[dict(key='gravity', values=[9.0, 9.5, 10.0])]"
        for call in (f"rockstack.solve({LONG}, integrator='rk4', step=0.01, interval=None)",
                     f"rockstack.solve({ENDLESS}, interval=None)", f"rockstack.solve_many([{ENDLESS}] * 3, interval=None)",
                     f"rockstack.solve_many([{ENDLESS}] * 3, times=[1e6])", f"rockstack.sweep(scene={ENDLESS}, {vary})"):
            with self.subTest(call):
                self.assertEqual(interrupted(call), "ended")


class MemoryTest(unittest.TestCase):
    def test_arrays_keep_what_they_look_at(self):
        solution = rockstack.solve(rocking())
        angles, forces, expected = solution.angles, solution.demands["forces"], solution.angles.copy()
        scene_samples = rockstack.GroundMotion(samples=[1.0, 2.0, 3.0], interval=0.1).samples
        del solution
        gc.collect()
        trash = [np.full(expected.size, 1e300) for _ in range(50)]
        np.testing.assert_array_equal(angles, expected)
        np.testing.assert_array_equal(scene_samples, [1.0, 2.0, 3.0])
        self.assertLess(forces["friction"][0], 1)
        self.assertEqual(len(trash), 50)

    def test_arrays_look_at_one_memory_and_cannot_be_written(self):
        solution = rockstack.solve(rocking())
        self.assertTrue(np.shares_memory(solution.angles, solution.angles))
        self.assertFalse(solution.angles.flags.owndata)
        for array in (solution.times, solution.angles, solution.peaks, solution.demands["forces"]):
            with self.assertRaises(ValueError):
                array[...] = 0
        with self.assertRaises(ValueError):
            solution.angles.flags.writeable = True

    def test_a_solution_outlives_its_scene(self):
        solution = rockstack.solve(rocking())
        scene = solution._core
        del solution
        gc.collect()
        self.assertEqual(scene.verdict, scene.verdict)


if __name__ == "__main__":
    unittest.main()
