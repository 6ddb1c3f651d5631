"""Sweeps: the rows of the program, in arrays that are made once."""
import csv
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
import rockstack
from scenes import PROGRAM, rocking

ENSEMBLE = """title = "shaken"
samples = 3
seed = 5
[scene]
duration = 2.0
[[scene.blocks]]
width = 0.5
height = 1.5
density = 2500.0
[scene.ground.horizontal]
pulse = "sine"
amplitude = 3.0
period = 0.8
[[vary]]
key = "ground.horizontal.amplitude"
values = [1.0, 4.0, 9.0]
[[vary]]
key = "law"
values = ["paper", "consistent"]
[[vary]]
key = "blocks.1.width"
normal = { mean = 0.5, deviation = 0.2 }
"""

MILLION = """
import resource, sys
import rockstack
scene = rockstack.Scene(duration=0.1, blocks=[dict(width=0.5, height=1.5, density=2500)])
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
side = int(sys.argv[1])
line = lambda key, low, high: dict(key=key, range={"from": low, "to": high, "count": side})
table = rockstack.sweep(scene=scene, vary=[line("gravity", 9.0, 10.0), line("blocks.1.width", 0.4, 0.6)])
after = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
size = sum((table.codes(name)[0] if name in ("onset", "motion") else table[name]).nbytes for name in table)
print(table.rows, size, 1024 * (after - before))
"""


class SweepTest(unittest.TestCase):
    def test_rows_are_those_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "ensemble.toml"
            file.write_text(ENSEMBLE)
            subprocess.run([PROGRAM, "sweep", file, "--out", folder + "/out", "--quiet"], check=True)
            with open(folder + "/out/runs.csv") as stream:
                rows = list(csv.DictReader(stream))
            table = rockstack.sweep(file)
        self.assertEqual(table.rows, 18)
        self.assertEqual([name for name in rows[0] if name not in ("run", "status", "reason")],
                         sorted(table, key=list(rows[0]).index))
        for name in table:
            for row, value in zip(rows, table[name].tolist()):
                if row["status"] != "done" and name not in ("ground.horizontal.amplitude", "law", "blocks.1.width"):
                    continue
                told = row[name]
                if isinstance(value, str):
                    self.assertEqual(value, told)
                else:
                    np.testing.assert_equal(value, float(told) if told else np.nan, name)
        self.assertEqual({number: rows[number]["reason"] for number in table.failures}, table.failures)
        self.assertEqual([number for number, row in enumerate(rows) if row["status"] != "done"], sorted(table.failures))

    def test_results_are_read_as_lines_and_as_columns(self):
        """Of texts, numbers, runs that fail and runs without a number; numpy and pandas read the columns by themselves."""
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "ensemble.toml"
            file.write_text(ENSEMBLE.replace("deviation = 0.2", "deviation = 0.5"))
            for form in ("csv", "npz"):
                done = subprocess.run([PROGRAM, "sweep", file, "--out", f"{folder}/{form}", "--format", form, "--quiet"],
                                      capture_output=True, text=True)
                self.assertIn(f" {'runs' if form == 'csv' else 'failures'}.csv says why; the first: ", done.stderr)
            lines, columns = rockstack.read_sweep(folder + "/csv"), rockstack.read_sweep(folder + "/npz")
            self.assertEqual(lines, columns)
            self.assertEqual(list(lines), list(columns))
            self.assertEqual({"paper", "consistent"}, set(columns["law"].tolist()))
            self.assertEqual({"done", "failed"}, set(columns["status"].tolist()))
            with np.load(folder + "/npz/runs.npz") as arrays:
                self.assertEqual(arrays["peak_1"].dtype, np.dtype("<f8"))
                self.assertEqual(arrays["peak_1"].tobytes(), lines["peak_1"].tobytes())
                try:
                    import pandas
                except ImportError:
                    self.skipTest("pandas is not there")
                frame = pandas.DataFrame(dict(arrays))
            self.assertEqual(len(frame), 18)
            self.assertEqual(frame["law"].tolist(), lines["law"].tolist())
            with self.assertRaisesRegex(rockstack.InputError, "must be a folder of a sweep that is finished"):
                rockstack.read_sweep(folder)

    def test_keywords_say_what_a_file_does(self):
        scene = rocking(ground={"horizontal": {"pulse": "sine", "amplitude": 3.0, "period": 0.8}})
        vary = [{"key": "ground.horizontal.amplitude", "values": np.array([1.0, 4.0, 9.0])},
                {"key": "law", "values": ["paper", "consistent"]}]
        table = rockstack.sweep(scene=scene, vary=vary, threads=2)
        for run in range(6):
            values = {"ground.horizontal.amplitude": [1.0, 4.0, 9.0][run // 2], "law": ["paper", "consistent"][run % 2]}
            self.assertEqual(table["peak_1"][run], rockstack.solve(scene.replace(values), interval=None).peaks[0])
        self.assertEqual(table["law"].tolist(), ["paper", "consistent"] * 3)

    def test_directions_of_the_grid_have_names(self):
        """Two keys in step are one direction, drawn values lie along all, and a cell is the run of its coordinates."""
        scene = rocking(ground={"horizontal": {"pulse": "sine", "amplitude": 3.0, "period": 0.8}})
        vary = [{"key": "ground.horizontal.amplitude", "values": [1.0, 2.0, 3.0]},
                {"key": "law", "values": ["paper", "consistent"], "group": "both"},
                {"key": "blocks.1.height", "values": [1.4, 1.6], "group": "both"},
                {"key": "blocks.1.width", "normal": {"mean": 0.5, "deviation": 0.01}}]
        table = rockstack.sweep(scene=scene, vary=vary, samples=4, seed=1)
        self.assertEqual(table.dimensions, ("ground.horizontal.amplitude", "law", "sample"))
        self.assertEqual(table.shape, (3, 2, 4))
        self.assertEqual(table.coordinates["law"], ("law", "blocks.1.height"))
        keys = ("ground.horizontal.amplitude", "law", "blocks.1.height", "blocks.1.width")
        for cell in ((0, 0, 0), (1, 0, 3), (2, 1, 2)):
            one = scene.replace({key: table.grid(key)[cell].item() for key in keys})
            self.assertEqual(rockstack.solve(one, interval=None).peaks[0], table.grid("peak_1")[cell])
        self.assertEqual(rockstack.sweep(scene=scene, vary=vary[:1]).dimensions, ("ground.horizontal.amplitude",))
        try:
            data = table.to_xarray()
        except ImportError:
            self.skipTest("xarray is not there")
        self.assertEqual(dict(data.sizes), dict(zip(table.dimensions, table.shape)))
        np.testing.assert_array_equal(data["blocks.1.height"].sel(law="consistent"), 1.6)
        self.assertEqual(data["peak_1"].sel({"ground.horizontal.amplitude": 2.0, "law": "paper"})[3], table.grid("peak_1")[1, 0, 3])
        np.testing.assert_array_equal(data["blocks.1.width"], table.grid("blocks.1.width"))

    def test_a_run_that_fails_costs_its_row(self):
        table = rockstack.sweep(scene=rocking(), samples=40, seed=1,
                                vary=[{"key": "blocks.1.width", "normal": {"mean": 0.3, "deviation": 0.3}}])
        self.assertTrue(table.failures)
        for run, reason in table.failures.items():
            self.assertTrue(np.isnan(table["peak_1"][run]))
            self.assertEqual(table["motion"][run], "")
            self.assertIn("must be", reason)

    def test_wrong_ensembles_are_refused(self):
        vary = [{"key": "gravity", "values": [9.0]}]
        for keys in ({"scene": rocking()}, {"scene": rocking(), "vary": vary, "samples": 3}, {"vary": vary},
                     {"scene": rocking(), "vary": [{"key": "gravity", "values": [np.nan]}]},
                     {"scene": rocking(), "vary": [{"key": "gravity", "values": np.ones((2, 2))}]},
                     {"scene": rocking(), "vary": vary, "threads": 0}, {"scene": rocking(), "vary": vary, "sample": 2}):
            with self.subTest(keys=str(keys)), self.assertRaises(rockstack.InputError):
                rockstack.sweep(**keys)
        with self.assertRaises(rockstack.InputError):
            rockstack.sweep("no-such-ensemble")

    def test_memory_is_that_of_the_columns(self):
        """What a sweep of 160 000 runs takes beside its 18 MB of columns are scenes under way, and no second copy."""
        if "asan" in os.environ.get("LD_PRELOAD", ""):
            self.skipTest("the sanitizer keeps what is freed")
        answer = subprocess.run([sys.executable, "-c", MILLION, "400"], capture_output=True, text=True, check=True).stdout
        rows, size, taken = map(int, answer.split())
        self.assertEqual(rows, 160000)
        self.assertGreater(size, 100 * rows)
        self.assertLess(taken, size + 2 ** 23)

    def test_tables_are_frames(self):
        table = rockstack.sweep(scene=rocking(), vary=[{"key": "law", "values": ["paper", "consistent"]}])
        try:
            frame = table.to_pandas()
        except ImportError:
            self.skipTest("pandas is not there")
        self.assertEqual(frame["law"].tolist(), ["paper", "consistent"])
        np.testing.assert_array_equal(frame["peak_1"], table["peak_1"])


class FragilityTest(unittest.TestCase):
    def test_a_curve_is_found_again(self):
        """Of 2000 draws at each level the fit is within three standard deviations of its parameters."""
        random = np.random.default_rng(1)
        levels = np.repeat(np.linspace(1, 8, 15), 2000)
        toppled = levels > 3.5 * np.exp(0.4 * random.standard_normal(levels.size))
        curve = rockstack.fragility(levels, toppled)
        self.assertAlmostEqual(curve.median, 3.5, delta=0.06)
        self.assertAlmostEqual(curve.beta, 0.4, delta=0.02)
        self.assertAlmostEqual(float(curve.probability(curve.median)), 0.5)
        self.assertTrue(np.all((curve.lower <= curve.share) & (curve.share <= curve.upper)))

    def test_levels_that_part_all_have_no_curve(self):
        self.assertTrue(np.isnan(rockstack.fragility([1.0, 2.0], [0, 1]).median))

    def test_wrong_shapes_are_refused(self):
        for intensities, toppled in (([1.0], [0, 1]), ([], []), ([[1.0]], [[0]]), ([0.0, 1.0], [0, 1]), ([np.nan], [1])):
            with self.assertRaises(rockstack.InputError):
                rockstack.fragility(intensities, toppled)


class SobolTest(unittest.TestCase):
    def test_shares_of_a_sum(self):
        """Of 2 x + y with independent inputs of one variance: 4/5 and 1/5, either index."""
        random = np.random.default_rng(3)
        a, b = random.standard_normal((2, 4000, 2))
        x = np.stack([a, b, np.column_stack([b[:, 0], a[:, 1]]), np.column_stack([a[:, 0], b[:, 1]])])
        indices = rockstack.sobol_indices((2 * x[..., 0] + x[..., 1]).T, ["x", "y"])
        self.assertEqual((indices.keys, indices.samples.item()), (["x", "y"], 4000))
        for found, lower, upper in ((indices.first, indices.first_lower, indices.first_upper),
                                    (indices.total, indices.total_lower, indices.total_upper)):
            np.testing.assert_allclose(found, [0.8, 0.2], atol=0.08)
            self.assertTrue(np.all((lower < [0.8, 0.2]) & ([0.8, 0.2] < upper)))

    def test_a_sweep_has_the_indices_of_the_program(self):
        text = ENSEMBLE.replace("values = [1.0, 4.0, 9.0]", "one_of = [1.0, 4.0, 9.0]").replace(
            "values = [\"paper\", \"consistent\"]", "one_of = [\"paper\", \"consistent\"]").replace(
            "samples = 3", "samples = 40\nsampling = \"latin hypercube\"").replace("deviation = 0.2", "deviation = 0.05")
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "ensemble.toml"
            file.write_text(text + "[summary]\nindices = [\"toppled\", \"peak_1\"]\n")
            subprocess.run([PROGRAM, "sweep", file, "--out", folder + "/out", "--quiet"], check=True)
            with open(folder + "/out/indices.csv") as stream:
                rows = list(csv.DictReader(stream))
            table = rockstack.sweep(file)
        self.assertEqual((table.dimensions, table.shape), (("sample", "matrix"), (40, 5)))
        self.assertEqual(table["matrix"][:5].tolist(), ["A", "B", "ground.horizontal.amplitude", "law", "blocks.1.width"])
        for outcome in ("toppled", "peak_1"):
            indices = table.indices(outcome)
            told = [row for row in rows if row["outcome"] == outcome]
            self.assertEqual([row["key"] for row in told], indices.keys)
            for name in ("first", "first_lower", "first_upper", "total", "total_lower", "total_upper"):
                np.testing.assert_array_equal([float(row[name]) for row in told], getattr(indices, name))
        self.assertEqual(indices, table.indices("peak_1"))

    def test_what_is_wrong_is_named(self):
        table = rockstack.sweep(scene=rocking(), vary=[{"key": "gravity", "values": [9.0]}])
        with self.assertRaisesRegex(rockstack.InputError, "whose summary has indices"):
            table.indices("peak_1")
        with self.assertRaisesRegex(rockstack.InputError, r"shape \(3, 3\): must be \(samples, 4\)"):
            rockstack.sobol_indices(np.ones((3, 3)), ["x", "y"])


class ThresholdTest(unittest.TestCase):
    def test_a_speed_topples_from_p_times_the_slenderness(self):
        # θ'' = p² (θ − α), Housner 1963: what starts at θ = 0 with more than p α does not come back.
        scene = rocking(duration=30.0, equations="small-angle", initial={"velocities": [0.1]})
        least = np.sqrt(3 * 9.81 / (4 * np.hypot(0.25, 0.75))) * np.arctan(1 / 3)
        found = rockstack.threshold(scene, "initial.velocities.1", 0.0, 4.0, values=20)
        self.assertAlmostEqual(found.first, least, delta=1e-11)
        self.assertEqual([happens for _, _, happens in found.ranges], [False, True])
        self.assertIsNone(rockstack.threshold(scene, "initial.velocities.1", 0.0, 0.1, values=3).first)

    def test_what_is_wrong_is_named(self):
        with self.assertRaisesRegex(rockstack.InputError, "LOW below HIGH"):
            rockstack.threshold(rocking(), "gravity", 9.0, 8.0)
        with self.assertRaisesRegex(rockstack.InputError, "--outcome tilts"):
            rockstack.threshold(rocking(), "gravity", 8.0, 9.0, outcome="tilts")
