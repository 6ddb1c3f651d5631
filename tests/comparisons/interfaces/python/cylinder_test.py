"""A round column by Python is that of the program."""
import unittest

import numpy as np

import rockstack


class Cylinders(unittest.TestCase):
    def test_a_steady_wobble_turns_at_its_rate(self):
        motion = rockstack.round_motion("wobble", interval=1.0)
        self.assertEqual(motion.rows, 11)
        np.testing.assert_allclose(motion["azimuth"], 6.611781509202099 * motion["time"], rtol=1e-13)  # the closed form
        self.assertFalse(motion.topples)

    def test_a_mapping_is_a_file(self):
        motion = rockstack.round_motion({"duration": 2, "radius": 0.25, "height": 2, "initial": {"tilt": 0.1, "precession": 0.2}})
        self.assertEqual(list(motion.events["event"][:2]), ["passage", "peak"])
        with self.assertRaisesRegex(rockstack.InputError, "radius = -1"):
            rockstack.round_motion({"duration": 2, "radius": -1, "height": 2})
