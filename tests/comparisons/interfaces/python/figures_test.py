"""Figures show the numbers that they are of, a player those of its motion, and who waits is told how far things are."""
import base64
import csv
import json
import re
import tempfile
import unittest
from pathlib import Path

import numpy as np
import rockstack
from rockstack import _core
from scenes import LONG, rocking

try:
    import matplotlib.pyplot as plt
except ImportError:
    plt = None


def free_fall():
    class Ice(rockstack.Worker):
        name, solver = "ice", "free"

        def step(self, dt, pull):
            self.rates[:, :2] += dt * pull
            self.places += dt * self.rates

    return Ice


@unittest.skipIf(plt is None, "matplotlib is not there")
class FigureTest(unittest.TestCase):
    def tearDown(self):
        plt.close("all")

    def lines(self, axes):
        return {line.get_label(): line.get_xydata() for line in axes.get_lines()}

    def test_motions(self):
        solution = rockstack.solve(rocking(duration=2.0), interval=0.01)
        drawn = self.lines(solution.plot())
        np.testing.assert_array_equal(drawn["block 1"], np.column_stack((solution.times, solution.angles)))
        events = solution.events
        np.testing.assert_array_equal(drawn["impacts"][:, 0], events["time"][events["kind"] == "impact"])
        self.assertGreater(len(drawn["impacts"]), 2)
        run = rockstack.simulate(rocking(duration=0.3), free_fall(), 0.01)
        left, right = solution.plot(run)
        np.testing.assert_array_equal(self.lines(right)["ice, block 1"][:, 1], run.difference()[:, 0])
        self.assertIs(solution.plot(axes=left), left)

    def test_sweeps(self):
        scene = rocking(ground={"horizontal": {"pulse": "sine", "amplitude": 3.0, "period": 0.8}})
        amplitude, period = "ground.horizontal.amplitude", "ground.horizontal.period"
        table = rockstack.sweep(scene=scene, vary=[{"key": amplitude, "values": [1.0, 2.0, 20.0]},
                                                   {"key": period, "values": [0.5, 1.0, 2.0]}])
        ratios = np.where(table.grid("toppled") > 0, np.inf, table.grid("peak_ratio"))
        self.assertTrue(np.isinf(ratios).any() and np.isfinite(ratios).any())
        median = self.lines(table.plot())["median"]
        np.testing.assert_array_equal(median, np.column_stack(([1.0, 2.0, 20.0], np.sort(ratios)[:, 1])))
        mesh, = [one for one in table.plot(kind="map").collections if one.get_array() is not None]
        np.testing.assert_array_equal(mesh.get_array().reshape(3, 3).filled(np.inf), ratios.T)
        with self.assertRaises(rockstack.InputError):
            table.plot(kind="pie")
        curve = rockstack.fragility([1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 4.0, 4.0], [0, 0, 0, 1, 0, 1, 1, 1])
        label, drawn = next((label, line) for label, line in self.lines(curve.plot()).items() if label.startswith("median"))
        np.testing.assert_array_equal(drawn[:, 1], curve.probability(drawn[:, 0]))

    def test_indices(self):
        outcomes = np.random.default_rng(2).standard_normal((3, 50, 4))
        indices = rockstack.sobol_indices(outcomes[0], ["x", "y"])
        bars = [bar.get_height() for bar in indices.plot().patches]
        np.testing.assert_array_equal(bars, [*indices.first, *indices.total])
        indices = rockstack.sobol_indices(outcomes, ["x", "y"])
        drawn = indices.plot([2.0, 4.0, 8.0]).get_lines()[0]
        np.testing.assert_array_equal(drawn.get_xydata(), np.column_stack([[2.0, 4.0, 8.0], indices.total[:, 0]]))

    def test_comparisons(self):
        rows = rockstack.compare(rocking(duration=0.4), engines=[free_fall()], dt=[2e-2, 1e-2], quick=True, draws=2)
        drawn = self.lines(rows.plot())
        for settings in ("default", "tuned"):
            made = np.flatnonzero((rows["settings"] == settings) & (rows["engine"] == "ice"))[::-1]
            made = made[np.argsort(rows["dt"][made])]
            np.testing.assert_array_equal(drawn[settings][:, 1], np.abs(rows["largest_angle_difference"][made]))
        fine = rows["run"][(rows["settings"] == "tuned") & (rows["dt"] == 1e-2)][0]
        axes = rows.plot_differences()
        self.assertEqual(len(axes.get_lines()), 5)  # of four runs, and the impacts
        np.testing.assert_array_equal(self.lines(axes)["tuned"][:, 1], np.abs(rows.file(fine, "difference.csv")["difference_1"]))
        answers = rockstack.canon(free_fall(), scenes=["throw"], draws=1)
        self.assertEqual(answers.plot().patches[0].get_height(), answers["steps_off"][0, 1])


@unittest.skipIf(_core.player is None, "this build has no figures")
class PlayerTest(unittest.TestCase):
    def test_a_page_has_the_motion(self):
        solution = rockstack.solve(rocking(title="<b> & \"c\""), interval=0.01)
        run = rockstack.simulate(rocking(), free_fall(), 0.01)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "player.html"
            rockstack.player(solution, run).write(file)
            page = file.read_text()
        data = json.loads(re.search(r'class="player-data">(.*?)</script>', page, re.S)[1])
        self.assertEqual(data["title"], solution.scene.title)
        self.assertEqual([(track["label"], track["exact"]) for track in data["tracks"]], [("exact", True), ("ice", False)])
        numbers = lambda text: np.frombuffer(base64.b64decode(text), "<f4")
        np.testing.assert_array_equal(numbers(data["tracks"][1]["angles"]), run.angles[:, 0].astype("<f4"))
        times, angles = numbers(data["tracks"][0]["times"]), numbers(data["tracks"][0]["angles"])
        np.testing.assert_array_equal(angles[np.isin(times, solution.times.astype("<f4"))], solution.angles[:, 0].astype("<f4"))
        self.assertIn("srcdoc", solution._repr_html_())
        self.assertNotIn("<script", solution._repr_html_())
        self.assertIsNone(rockstack.solve(rocking(), interval=None)._repr_html_())
        with self.assertRaises(rockstack.InputError):
            rockstack.player()


@unittest.skipIf(_core.draw is None, "this build has no figures")
class PrintTest(unittest.TestCase):
    def test_a_figure_has_what_was_asked_for(self):
        rows = rockstack.compare(rocking(duration=1.0), engines=[free_fall()], dt=[0.01], quick=True, draws=1)
        asked = dict(width=88, unit="mrad", titles=False, panels="θ1", from_=0.25, to=0.5)
        (stem,), left_out = rockstack.draw(rows.folder, **asked)
        self.assertEqual(left_out, [])
        self.assertTrue(all(stem.with_suffix(stem.suffix + ending).is_file() for ending in (".pdf", ".svg", ".png")))
        with open(f"{stem}.csv", encoding="utf-8") as file:
            points = list(csv.DictReader(file))
        self.assertEqual({point["panel"] for point in points}, {"θ₁ (mrad)"})
        x, y = np.array([(float(point["x"]), float(point["y"])) for point in points if point["curve"] == "exact"]).T
        solution = rockstack.solve(rocking(duration=1.0), interval=1e-3)
        np.testing.assert_allclose(y, 1e3 * np.interp(x, solution.times, solution.angles[:, 0]), atol=1e-2)
        self.assertTrue(0.24 < x.min() < 0.26 and 0.49 < x.max() < 0.51)
        for wrong, words in ({"panels": ["slip"]}, 'panels = "slip": must be among θ1'), ({"width": 5}, "draw: width = 5: must be"), \
                ({"wide": 88}, "draw: wide: unknown key"):
            with self.assertRaisesRegex(rockstack.InputError, words):
                rockstack.draw(rows.folder, **wrong)


class ProgressTest(unittest.TestCase):
    def test_who_waits_is_told_and_may_end_it(self):
        """Five short motions and one of days: counts ascend to five, where what is told raises and ends the sixth."""
        told = []

        def tell(done, total):
            told.append((done, total))
            if done == 5:
                raise KeyError("enough")

        request = _core.SolveRequest(None, [1.0], "taylor", 0, 2e-4)
        with self.assertRaises(KeyError):
            _core.solve_many([scene._core for scene in [rocking()] * 5 + [eval(LONG)]], request, 1, tell)
        self.assertEqual(told, sorted(told))
        self.assertEqual(told[-1], (5, 6))

    def test_a_bar_is_shown_where_it_is_wanted(self):
        try:
            import tqdm  # noqa: F401
        except ImportError:
            self.skipTest("tqdm is not there")
        from rockstack.notebook import progress_bar
        with progress_bar(True, "work") as tell:
            tell(1, 4)
        with progress_bar(None, "work") as tell:
            self.assertIsNone(tell)


if __name__ == "__main__":
    unittest.main()
