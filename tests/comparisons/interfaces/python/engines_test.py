"""Engines run by workers, of the build and of one's own."""
import copy
import os
import pickle
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path

import numpy as np
import rockstack
from scenes import LONG, PROGRAM, SOURCE, interrupted, message_of_program, rocking

WORKER = f"""#!{sys.executable}
import rockstack

class Ice(rockstack.Worker):
    name, solver = "ice", "free"
    settings = [rockstack.Setting("wind", 0.0, least=-10, most=10, unit="m/s²"),
                rockstack.Setting("fault", 0, most=4, whole=True)]

    def step(self, dt, pull):
        if self.setup.parameters["fault"] == 1:
            raise ValueError("thin\\nice")
        if self.setup.parameters["fault"] == 2:
            self.rates[:] = float("nan")
        if self.setup.parameters["fault"] == 3:
            while True:
                pass
        if self.setup.parameters["fault"] == 4:
            import os
            os.abort()
        self.rates[:, :2] += dt * pull
        self.rates[:, 2] += dt * self.setup.parameters["wind"]
        self.places += dt * self.rates

Ice().serve()
"""


class Moreau(rockstack.Worker):
    """Whole steps of velocities and then of places, with impulses by Gauss and Seidel's method."""

    name, solver = "moreau", "whole-steps"
    rates_told: list = []

    def step(self, dt, pull):
        start = self.rates.copy()
        self.rates[:, :2] += dt * pull
        found = self.contacts(1e-9)
        rows, count = np.vstack((found.normals, found.tangents)), len(found.gaps)
        mass, impulses = rows @ (self.inverse_masses * rows).T, np.zeros(2 * count)
        speeds = rows @ self.rates.ravel()
        for _ in range(2000):
            before = impulses.copy()
            for i in range(2 * count):
                impulses[i] -= (speeds[i] + mass[i] @ impulses) / mass[i, i]
                bound = found.friction[i - count] * impulses[i - count] if i >= count else 0
                impulses[i] = np.clip(impulses[i], -bound, bound) if i >= count else max(impulses[i], 0)
            if np.allclose(before, impulses, rtol=1e-13, atol=0):
                break
        self.rates += (self.inverse_masses * (rows.T @ impulses)).reshape(-1, 3)
        self.places += dt * self.rates
        self.bear(found, impulses[:count], impulses[count:])
        self.rates_told.append((start, self.rates.copy()))


def engine_here() -> str | None:
    """One of this build; those that are off are not there."""
    return next((engine["name"] for engine in rockstack.engines()), None)


class WorkerTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.worker = self.write("ice.py", WORKER)

    def write(self, name: str, text: str) -> Path:
        file = Path(self.folder.name) / name
        file.write_text(text)
        file.chmod(0o755)
        return file

    def test_a_free_body_falls_by_the_scheme_s_own_sum(self):
        scene = rocking(initial={"angles": [0.1], "velocities": [0.5]})
        run = rockstack.simulate(scene, self.worker, 0.01, parameters={"wind": 2.0}, bodies=True)
        step = np.arange(len(run.times))
        np.testing.assert_allclose(run.velocities[:, 0], 0.5 + 0.02 * step, atol=1e-12)
        np.testing.assert_allclose(run.angles[:, 0], 0.1 + 0.005 * step + 1e-4 * step * (step + 1), atol=1e-12)
        self.assertEqual(run.angles.shape, (len(step), 1))
        self.assertEqual(len(run.energy), len(step))

    def test_forces_of_a_block_at_rest_are_its_weight(self):
        scene = rocking(initial={"angles": [0.0]})
        borne = rockstack.simulate(scene, "ode", 0.01, forces=True).reactions
        self.assertTrue(np.isnan(borne["normal"][0, 0]))
        np.testing.assert_allclose(borne["normal"][-1], 0.5 * 1.5 * 2500 * 9.81, rtol=1e-6)
        np.testing.assert_allclose(borne["tangential"][-1], 0, atol=1e-2)
        with self.assertRaisesRegex(rockstack.InputError, "forces: must be left out of ice:free"):
            rockstack.simulate(scene, self.worker, 0.01, forces=True)

    def test_forces_of_an_engine_of_one_s_own_are_those_of_closed_forms(self):
        cube = {"width": 1.0, "height": 1.0, "density": 2500.0}
        weight, slope = 2500 * 9.81, np.radians(20)
        for friction, tilt, tangential in ((0.5, 0.0, 0.0), (1.0, slope, np.sin(slope)), (0.2, slope, 0.2 * np.cos(slope))):
            scene = rocking(blocks=[cube], initial={"angles": [0.0]}, duration=0.2, law="unilateral",
                            contact={"friction": friction}, ground={"inclination": float(tilt)})
            borne = rockstack.simulate(scene, Moreau, 0.01, forces=True).reactions
            self.assertTrue(np.isnan(borne["normal"][0, 0]))
            np.testing.assert_allclose(borne["normal"][1:], weight * np.cos(tilt), rtol=1e-9)
            np.testing.assert_allclose(borne["tangential"][1:], -weight * tangential, atol=1e-6 * weight)

    def test_forces_of_an_engine_of_one_s_own_are_what_moves_its_blocks(self):
        """Through an impact, and at both interfaces, the upper of which has its axes from the lower block or, where wider, its own."""
        for top in (0.5, 0.8):
            blocks = [{"width": 0.6, "height": 1.0, "density": 2500.0}, {"width": top, "height": 1.0, "density": 2500.0}]
            scene = rocking(blocks=blocks, initial={"angles": [0.1, 0.1]}, law="unilateral", contact={"friction": 0.6})
            masses, dt = np.array([0.6, top]) * 2500, 0.005
            Moreau.rates_told = []
            run = rockstack.simulate(scene, Moreau, dt, forces=True)
            rates, borne = np.array(Moreau.rates_told), run.reactions[1:]
            face = np.column_stack((np.zeros(len(borne)), run.angles[:-1, 1 if top > 0.6 else 0]))
            right = borne["normal"] * np.sin(face) + borne["tangential"] * np.cos(face)
            up = borne["normal"] * np.cos(face) - borne["tangential"] * np.sin(face)
            gained = masses[:, None] * (rates[:, 1] - rates[:, 0])[:, :, :2] / dt + masses[:, None] * np.array([0, 9.81])
            expected = np.flip(np.cumsum(np.flip(gained, 1), 1), 1)
            self.assertGreater(borne["normal"].max(), 2 * masses.sum() * 9.81)
            np.testing.assert_allclose(np.stack((right, up), 2), expected, atol=1e-6 * masses.sum() * 9.81)
            centre = borne["centre"]
            np.testing.assert_allclose(np.abs(centre[np.isfinite(centre[:, 0]), 0]).max(), 0.3, rtol=1e-9)

    def test_impulses_of_other_contacts_are_refused(self):
        class Short(Moreau):
            def bear(self, contacts, pushes, rubs):
                super().bear(contacts, pushes[1:], rubs)

        with self.assertRaisesRegex(rockstack.EngineError, r"pushes of shape \(0,\): must be one for each of 1 contacts"):
            rockstack.simulate(rocking(), Short, 0.01, forces=True)
        rockstack.simulate(rocking(), Short, 0.01)

    def test_what_sinks_is_told_whether_or_not_bodies_are_asked_for(self):
        scene = rocking(initial={"angles": [0.0]})
        verdicts = [rockstack.simulate(scene, self.worker, 0.01, bodies=bodies).verdict for bodies in (False, True)]
        self.assertIn("sinks in by", verdicts[0])
        self.assertEqual(*verdicts)

    def test_what_a_worker_does_ends_its_own_run(self):
        for fault, limit, message in ((1, 600, "failed: ValueError: thin ice"), (2, 600, "not finite"), (3, 1, "time limit"),
                                      (4, 600, "signal")):
            with self.subTest(fault=fault), self.assertRaisesRegex(rockstack.EngineError, message):
                rockstack.simulate(rocking(), self.worker, 0.01, parameters={"fault": fault}, time_limit=limit)
        quits = self.write("quits.py", WORKER.replace('raise ValueError("thin\\nice")', 'raise SystemExit("licence expired")'))
        with self.assertRaisesRegex(rockstack.EngineError, "failed: SystemExit: licence expired"):
            rockstack.simulate(rocking(), quits, 0.01, parameters={"fault": 1})
        broken = self.write("broken.py", f"#!{sys.executable}\nraise SystemExit('no engine')\n")
        with self.assertRaisesRegex(rockstack.InputError, "no engine"):
            rockstack.simulate(rocking(), broken)

    def test_a_class_answers_in_this_process_as_its_program_does(self):
        import types
        module = types.ModuleType("ice")
        exec(WORKER.removesuffix("Ice().serve()\n"), module.__dict__)
        seen = []

        class Ice(module.Ice):
            def start(self):
                seen.append(os.getpid())

        scene = rocking(initial={"angles": [0.1], "velocities": [0.5]})
        run = rockstack.simulate(scene, Ice, 0.01, parameters={"wind": 2.0})
        np.testing.assert_array_equal(run.angles, rockstack.simulate(scene, self.worker, 0.01, parameters={"wind": 2.0}).angles)
        self.assertEqual((run.engine, set(seen)), ("ice", {os.getpid()}))
        for fault, message in ((1, "failed: ValueError: thin ice"), (2, "not finite")):
            with self.assertRaisesRegex(rockstack.EngineError, message):
                rockstack.simulate(rocking(), Ice, 0.01, parameters={"fault": fault})

        class Quits(module.Ice):
            def step(self, dt, pull):
                raise SystemExit("licence expired")

        with self.assertRaisesRegex(rockstack.EngineError, "failed: SystemExit: licence expired"):
            rockstack.simulate(rocking(), Quits, 0.01)

        class Slow(module.Ice):
            def step(self, dt, pull):
                time.sleep(0.05)

        begin = threading.active_count()
        with self.assertRaisesRegex(rockstack.EngineError, "time limit"):
            rockstack.simulate(rocking(), Slow, 0.001, time_limit=0.3)
        while threading.active_count() > begin:
            time.sleep(0.01)  # the run that nobody waits for ends after its step
        answers = [rockstack.canon(engine, scenes=["throw"], draws=1) for engine in (Ice, self.worker)]
        self.assertEqual(answers[0]["amounts"].tolist(), answers[1]["amounts"].tolist())
        self.assertEqual(answers[0]["verdict"].tolist(), ["another law"])  # it has no ground to land on
        rows = rockstack.compare(scene, engines=[Ice], dt=[0.01], quick=True, draws=2, jobs=2)
        self.assertEqual(set(rows["engine"]), {"exact", "ice"})
        self.assertEqual(set(rows["status"]), {"done"})

    def test_a_class_is_checked_before_anything_is_written(self):
        file = self.write("kept", "as it was")

        class Ice(rockstack.Worker):
            name, solver = "ice", "free"

        for wrong, message in (({"name": str(file)}, f"name = {file}: must be small letters"), ({"name": "../ice"}, "name = ../ice"),
                               ({"solver": "A"}, "solver = A"), ({"name": 3}, "name` must be a text"), ({"lead": 2.0}, "lead = 2"),
                               ({"settings": [rockstack.Setting("wind", 3.0, most=2.0)]}, "wind = 3: must be within its own range")):
            with self.subTest(message), self.assertRaisesRegex(rockstack.InputError, message):
                with type("Wrong", (Ice,), wrong).program():
                    pass
        self.assertEqual(file.read_text(), "as it was")
        with Ice.program() as program:
            self.assertEqual(program.name, "ice")

    def test_a_question_that_no_worker_can_hold_is_not_made(self):
        """5000 s of a shaken ground in steps of 10 µs are 8 GB."""
        scene = rocking(duration=5000.0, ground={"horizontal": {"pulse": "sine", "amplitude": 1.0, "period": 1.0}})
        with self.assertRaisesRegex(rockstack.EngineError, r"memory limit: 5e\+08 steps of a shaken ground"):
            rockstack.simulate(scene, self.worker, 1e-5)

    def test_the_program_takes_it(self):
        run = subprocess.run([PROGRAM, "list", "engines"], capture_output=True, text=True, check=True,
                             env={**os.environ, "ROCKSTACK_WORKERS": self.folder.name})
        self.write("rockstack-ice", WORKER)
        run = subprocess.run([PROGRAM, "list", "engines"], capture_output=True, text=True, check=True,
                             env={**os.environ, "ROCKSTACK_WORKERS": self.folder.name})
        self.assertIn("ice:free", run.stdout)

    def test_corners_are_those_of_the_example_in_plain_python(self):
        """contacts() by the example's find_contacts, which shares no code with it, on a stack that leans."""
        example = {}
        source = (SOURCE / "engines/examples/moreau_jean.py").read_text().removesuffix("main()\n")
        exec(compile(source, "moreau_jean.py", "exec"), example)
        blocks = [{"x": 0.02, "y": 0.5, "angle": 0.1, "width": 1.2, "height": 1.0, "mass": 2.0, "inertia": 0.3,
                   "offset_x": 0.2, "offset_y": -0.1},
                  {"x": 0.05, "y": 1.45, "angle": -0.05, "width": 1.0, "height": 1.0, "mass": 1.0, "inertia": 0.2,
                   "offset_x": -0.1, "offset_y": 0.3}]
        for block in blocks:  # from the middle to the centre of mass
            c, s, x, y = np.cos(block["angle"]), np.sin(block["angle"]), block["offset_x"], block["offset_y"]
            block["x"], block["y"] = block["x"] + x * c + y * s, block["y"] + y * c - x * s
        worker = rockstack.Worker()
        worker._begin({"blocks": [{"velocity_x": 0, "velocity_y": 0, "angular_velocity": 0, **block} for block in blocks],
                       "friction": [0.3, 0.4], "dt": 0.01, "parameters": {}})
        bodies = [example["Body"]()] + [example["Body"](block) for block in blocks]
        wanted = example["find_contacts"](bodies, [0.3, 0.4], 0.05)
        found = worker.contacts(0.05)
        self.assertGreaterEqual(len(wanted), 3)
        self.assertEqual(sorted(found.friction), sorted(contact.friction for contact in wanted))

        def full(contact, axis):
            row = np.zeros(6)
            for body, part in zip(contact.bodies, contact.rows[axis]):
                if body is not bodies[0]:
                    row[3 * bodies.index(body) - 3:3 * bodies.index(body)] = part
            return row
        for axis, rows in ((0, found.normals), (1, found.tangents)):
            expected = np.array([full(contact, axis) for contact in wanted])
            order = lambda table: table[np.lexsort(np.round(table, 9).T)]
            np.testing.assert_allclose(order(rows), order(expected), atol=1e-12)


class EngineTest(unittest.TestCase):
    def setUp(self):
        self.engine = engine_here()
        if self.engine is None:
            self.skipTest("this build has no engine")

    def test_a_run_is_that_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            scene = SOURCE / "comparisons/scenes/housner-block.toml"
            subprocess.run([PROGRAM, "simulate", scene, "--set", "duration=1", "--engine", self.engine, "--dt", "0.01",
                            "--out", folder, "--quiet", "--no-plots"], check=True)
            rows = np.genfromtxt(folder + "/history.csv", delimiter=",", names=True, dtype=None, encoding="utf-8")
        run = rockstack.simulate(rockstack.Scene.read(scene, ["duration=1"]), self.engine, 0.01)
        np.testing.assert_array_equal(run.angles[:, 0], rows["theta_1"])
        np.testing.assert_array_equal(run.velocities[:, 0], rows["omega_1"])
        np.testing.assert_array_equal(run.patterns, rows["pattern"].astype(str))

    def test_a_difference_is_from_the_exact_motion_at_the_same_times(self):
        scene = rocking(law="unilateral")
        run = rockstack.simulate(scene, self.engine, 0.01)
        exact = rockstack.solve(scene, interval=0.01)
        np.testing.assert_allclose(run.difference(), run.angles - exact.angles[:len(run.times)], atol=1e-12)

    def test_a_run_comes_back_from_another_process(self):
        run = rockstack.simulate(rocking(duration=0.1), self.engine, 0.01, bodies=True)
        other = pickle.loads(pickle.dumps(run))
        self.assertEqual((other.engine, other.warnings, repr(other)), (run.engine, run.warnings, repr(run)))
        np.testing.assert_array_equal(other.angles, run.angles)
        np.testing.assert_array_equal(other.energy, run.energy)

    def test_wrong_wishes_are_refused(self):
        for wish in ({"engine": "no-engine"}, {"dt": 0.0}, {"dt": np.nan}, {"dt": 5.0}, {"settings": "best"},
                     {"parameters": {"speed": 1.0}}, {"time_limit": 0.0}):
            with self.subTest(wish=wish), self.assertRaises(rockstack.InputError):
                rockstack.simulate(rocking(), **{"engine": self.engine, **wish})

    def test_keyboard_interrupts_end_the_worker(self):
        scene = "rockstack.Scene(duration=1e3, blocks=[dict(width=0.5, height=1.5, density=2500)])"
        self.assertEqual(interrupted(f"rockstack.simulate({scene}, {self.engine!r}, 1e-5)"), "ended")
        shaken = f"{LONG}.replace(duration=600.0)"  # whose question takes longer than half a second to make
        self.assertEqual(interrupted(f"rockstack.simulate({shaken}, {self.engine!r}, 1e-5)"), "ended")

    def test_a_comparison_is_a_table_of_its_runs(self):
        scene = rocking(title="One block", duration=0.5)
        rows = rockstack.compare(scene, engines=[self.engine], dt=[0.01], quick=True, draws=2)
        self.assertEqual(rows["status"].tolist(), ["done"] * 3)
        exact = rows["run"][np.flatnonzero(rows["engine"] == "exact")[0]]
        np.testing.assert_array_equal(rows.history(exact)["theta_1"][0], 0.1)
        self.assertTrue(np.isnan(rows["largest_angle_difference"]).any())
        self.assertIn("rad", rows.meanings["largest_angle_difference"])
        with self.assertRaises(rockstack.InputError):
            rows.history("no-run")
        folder = rows.folder
        copied, sent = copy.deepcopy(copy.copy(rows)), pickle.loads(pickle.dumps(rows))
        del rows
        self.assertTrue(folder.is_dir())
        self.assertEqual(copied.history(exact)["theta_1"][0], 0.1)
        del copied
        self.assertFalse(folder.exists())
        self.assertEqual(sent["status"].tolist(), ["done"] * 3)
        for name, value in (("history_interval", -1.0), ("history_interval", np.nan), ("history_interval", 1e308), ("draws", -5),
                            ("draws", 10001), ("dt", np.nan), ("dt", 0.0), ("dt", np.inf)):
            with self.subTest(name=name, value=value), self.assertRaises(rockstack.InputError) as raised:
                rockstack.compare(scene, engines=[self.engine], **{name: [value] if name == "dt" else value})
            told = message_of_program("compare", SOURCE / "comparisons/scenes/housner-block.toml", f"--{name.replace('_', '-')}={value}")
            self.assertEqual(told, f"rockstack: --{str(raised.exception).replace('_', '-')}")
        for wrong in (lambda: rockstack.compare("no-scene"), lambda: rockstack.compare(scene, engines=["no-engine"]),
                      lambda: rockstack.compare("paper", quick=True)):
            with self.assertRaises(rockstack.InputError):
                wrong()

    def test_a_motion_from_elsewhere_has_a_row(self):
        scene = rocking(title="One block", duration=0.5)
        solution = rockstack.solve(scene, interval=0.01)
        lines = ["time,theta_1"] + [f"{time!r},{angle!r}" for time, angle in zip(solution.times.tolist(), solution.angles[:, 0].tolist())]
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "run.csv"
            file.write_text("\n".join(lines) + "\n")
            for files in (file, [file, str(file)]):
                rows = rockstack.compare(scene, engines=[self.engine], dt=[0.01], quick=True, draws=1, trajectories={"elsewhere": files})
                self.assertEqual(rows["engine"].tolist()[-1], "elsewhere")
                self.assertLess(rows["largest_angle_difference"][-1], 1e-12)  # rounding: it is the exact motion
            with self.assertRaisesRegex(rockstack.InputError, "run.csv:1: no column theta_2"):
                rockstack.compare("spanos-free-rocking", trajectories={"elsewhere": file})

    def test_the_canon_tells_a_verdict_a_scene(self):
        answers = rockstack.canon(self.engine, scenes=["throw"], draws=1)
        self.assertEqual(answers["scene"].tolist(), ["throw"])
        self.assertIn(answers["verdict"][0], ("agrees", "converges", "another law", "cannot tell", "scatters"))
        self.assertEqual(answers["amounts"].shape, (1, 5))
        try:
            self.assertEqual(answers.to_pandas()["amounts"][0].shape, (5,))
        except ImportError:
            self.assertIsNone(answers._repr_html_())
        with self.assertRaises(rockstack.InputError):
            rockstack.canon(self.engine, scenes=["no-scene"])
