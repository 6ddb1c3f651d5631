"""Tables of proved events as arrays, which hold what they are read from."""
import csv
import os
import unittest
from fractions import Fraction
from pathlib import Path

import numpy as np

import rockstack

TABLES = Path(os.environ["ROCKSTACK_SOURCE"], "comparisons/canon/proved")


class ProvedTest(unittest.TestCase):
    def test_every_table_is_there_with_all_of_its_cells(self):
        self.assertEqual(rockstack.shipped("proved"), sorted(file.stem for file in TABLES.glob("*.csv")))
        for name in rockstack.shipped("proved"):
            with open(TABLES / f"{name}.csv", newline="") as file:
                cells = list(csv.reader(file))[1:]
            table = rockstack.proved(name)
            blocks = len(cells[0][2])
            self.assertEqual((table["time"].shape, table["angles"].shape), ((len(cells), 2), (len(cells), blocks, 2)))
            texts = np.concatenate([table["time_text"][:, np.newaxis], table["angles_text"]], axis=1).reshape(len(cells), -1)
            words = zip(table["kind"], table["interface"].astype(str), table["from"], table["to"], strict=True)
            self.assertEqual([[*row, *numbers] for row, numbers in zip(words, texts.tolist(), strict=True)], cells)

    def test_doubles_hold_the_bounds_and_are_the_nearest_that_do(self):
        for name in rockstack.shipped("proved"):
            table = rockstack.proved(name)
            for column in ("time", "angles"):
                pairs = zip(table[column].reshape(-1, 2).tolist(), table[f"{column}_text"].reshape(-1, 2).tolist(), strict=True)
                for (low, high), (lower, upper) in pairs:
                    self.assertTrue(Fraction(low) <= Fraction(lower) <= Fraction(upper) <= Fraction(high))
                    self.assertGreater(np.nextafter(low, np.inf), Fraction(lower))
                    self.assertLess(np.nextafter(high, -np.inf), Fraction(upper))

    def test_the_solver_is_within_some_units_of_them(self):
        table = rockstack.proved("shaken-block")
        events = rockstack.solve("shaken-block").events
        self.assertEqual(events["kind"].tolist(), table["kind"].tolist())
        self.assertLess(np.abs(events["time"] - table["time"].mean(axis=1)).max(), 4 * np.spacing(0.9))

    def test_other_names_are_refused(self):
        with self.assertRaisesRegex(rockstack.InputError, "name = nowhere: must be drum-column or"):
            rockstack.proved("nowhere")


if __name__ == "__main__":
    unittest.main()
