"""Ground motions: the program's measures, closed forms, and the scenes they go into."""
import json
import subprocess
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import rockstack
from scenes import PROGRAM, rocking


class GroundMotionTest(unittest.TestCase):
    def test_measures_and_spectrum_are_those_of_the_program(self):
        motion = rockstack.GroundMotion(synthetic=3, peak=4.0, duration=5.0)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "motion.csv"
            rows = "".join(f"{t!r},{a!r}\n" for t, a in zip((np.arange(len(motion.samples)) / 100).tolist(),
                                                           motion.samples.tolist()))
            file.write_text("units: m/s2\n" + rows)
            out = Path(folder) / "out"
            subprocess.run([PROGRAM, "record", file, "--out", out, "--quiet"], check=True)
            told = json.loads((out / "record.json").read_text())
            spectrum = np.genfromtxt(out / "spectrum.csv", delimiter=",", names=True)
            record = rockstack.GroundMotion(record=file)
            np.testing.assert_array_equal(record.samples, motion.samples)
            for name, value in record.measures().items():
                self.assertEqual(value, told[name], name)
            periods, heights = record.spectrum()
            np.testing.assert_array_equal(periods, spectrum["period"])
            np.testing.assert_array_equal(heights, spectrum["pseudo_acceleration"])
            np.testing.assert_array_equal(record.spectrum(periods[::50])[1], heights[::50])

    def test_arrays_make_the_same_scene_as_their_source(self):
        motion = rockstack.GroundMotion(synthetic=1, peak=4.0, duration=5.0)
        of_arrays = rockstack.GroundMotion(samples=motion.samples, interval=motion.interval)
        angles = [rockstack.solve(rocking(ground={"horizontal": ground}), interval=0.01).angles
                  for ground in (motion, of_arrays, dict(of_arrays), {"synthetic": 1, "peak": 4.0, "duration": 5.0})]
        for other in angles[1:]:
            np.testing.assert_array_equal(other, angles[0])
        scene = rocking(ground={"horizontal": motion})
        np.testing.assert_array_equal(scene.horizontal.samples, motion.samples)
        self.assertIsNone(scene.vertical)

    def test_a_trace_is_its_samples_in_its_unit(self):
        def trace(data=(0.0, 1.0, -2.0), **stats):
            return SimpleNamespace(data=np.ma.masked_invalid(data), stats=SimpleNamespace(delta=0.01, **stats))

        wanted = rockstack.GroundMotion(samples=[0.0, 0.01, -0.02], interval=0.01)
        for given, units in ((trace(), "cm/s2"), (trace(units="gal"), None), (trace(units="cm/s**2"), "Gal"),
                             (SimpleNamespace(traces=[trace()]), "cm/s^2")):
            self.assertEqual(rockstack.GroundMotion(given, units=units), wanted)
        self.assertEqual(rockstack.GroundMotion(trace(), units="g", peak=3.0).samples.min(), -3.0)
        for given, units, message in ((trace(), None, "units = None, its own None: must be one unit of acceleration"),
                                      (trace(), "m/s", "units = m/s"), (trace(units="m/s2"), "g", "its own m/s2"),
                                      (trace(units="counts"), None, "counts"), (trace((0.0, np.nan)), "g", "1 of 2 masked"),
                                      (SimpleNamespace(traces=[trace(), trace()]), "g", "2 traces"),
                                      (SimpleNamespace(traces=[]), "g", "0 traces"), ({"samples": [1.0], "interval": 1}, "g", "units")):
            with self.subTest(message), self.assertRaisesRegex(rockstack.InputError, message):
                rockstack.GroundMotion(given, units=units)

    def test_motions_are_equal_by_value_and_read_back(self):
        pulse = rockstack.GroundMotion(pulse="sine", amplitude=3.0, period=1.0)
        samples = rockstack.GroundMotion(samples=np.array([0.0, 1.0]), interval=0.5)
        for motion in (pulse, samples):
            for other in (eval(repr(motion)), rocking(ground={"horizontal": motion}).horizontal):
                self.assertEqual((motion, hash(motion)), (other, hash(other)))
        self.assertNotEqual(pulse, rockstack.GroundMotion({**pulse, "period": 2.0}))
        self.assertNotEqual(pulse, samples)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "motion.txt"
            file.write_text("# dt = 0.5, units: m/s2\n0\n1\n")
            for record in (rockstack.GroundMotion(file), rockstack.GroundMotion(str(file), scale=1.0)):
                self.assertEqual(record, samples)
                self.assertEqual(eval(repr(record)), record)

    def test_a_pulse_is_its_function(self):
        times = np.linspace(0, 1, 11)
        pulse = rockstack.GroundMotion(pulse="sine", amplitude=3.0, period=1.0)
        np.testing.assert_allclose(pulse.acceleration(times), 3 * np.sin(2 * np.pi * times), atol=1e-14)
        self.assertEqual(pulse.acceleration(times.reshape(1, 11)).shape, (1, 11))
        sampled = pulse.sampled(0.1)
        np.testing.assert_array_equal(sampled.samples, pulse.acceleration(sampled.times))

    def test_a_constant_velocity_comes_of_a_half_line(self):
        motion = rockstack.GroundMotion(samples=[0.0, 1.0, 0.0], interval=0.5)
        np.testing.assert_allclose(motion.velocities(), [0, 0.25, 0.5])
        self.assertEqual(motion.husid()[-1], 1)
        self.assertLess(abs(motion.without_base_line().measures()["final_velocity"]), 0.5)

    def test_an_impulse_starts_a_block_as_a_velocity_does(self):
        """A rectangle of length T and area Δv turns a block on the rigid limit at once: the shorter, the nearer. The least
        impulse that is not is followed by weight for T, so that angles differ by order T."""
        def peak(length):
            ground = {"horizontal": {"pulse": "rectangle", "amplitude": 1.0 / length, "period": length}}
            return rockstack.solve(rockstack.Scene(duration=0.2, blocks=[{"width": 0.5, "height": 1.5, "density": 1.0}],
                                                   ground=ground), interval=None).peaks[0]
        coarse, fine, finest = peak(4e-3), peak(2e-3), peak(1e-3)
        self.assertAlmostEqual((coarse - fine) / (fine - finest), 2, delta=0.1)

    def test_wrong_motions_are_refused(self):
        for keys, message in (({"samples": [], "interval": 0.1}, "at least one number"),
                              ({"samples": [1.0, np.nan], "interval": 0.1}, "finite number"),
                              ({"samples": np.ones((2, 2)), "interval": 0.1}, "a number"),
                              ({"samples": [1.0]}, "interval: missing"),
                              ({"samples": [1.0], "interval": 0.0}, "motion.interval = 0"),
                              ({"record": "nowhere.at2"}, "none is at"),
                              ({"samples": [1.0], "interval": 0.1, "period": 1}, "unknown key"),
                              ({"samples": np.ma.masked_equal([1.0, -999.0], -999.0), "interval": 0.1}, "motion: samples: .*masked"),
                              ({"samples": [1.0, np.ma.masked], "interval": 0.1}, "masked"),
                              ({}, "record: missing")):
            with self.subTest(keys=str(keys)), self.assertRaisesRegex(rockstack.InputError, message):
                rockstack.GroundMotion(keys)
        motion = rockstack.GroundMotion(samples=[0.0, 1.0], interval=0.1)
        np.testing.assert_array_equal(rockstack.GroundMotion(samples=np.ma.array([0.0, 1.0]), interval=0.1).samples, [0, 1])
        gaps = np.ma.masked_equal([1.0, 2.0], 2.0)
        for wrong in (lambda: motion.spectrum([0.0]), lambda: motion.spectrum([1e-300]), lambda: motion.spectrum([np.nan]),
                      lambda: motion.spectrum(damping=1.0), lambda: motion.acceleration([-1.0]),
                      lambda: motion.acceleration([np.nan]), lambda: motion.acceleration(gaps),
                      lambda: motion.spectrum(gaps), lambda: rockstack.solve(rocking(), times=gaps),
                      lambda: rockstack.fragility(gaps, [0, 1]), lambda: rockstack.fragility([1.0, 2.0], gaps), lambda: motion.sampled(0.0),
                      lambda: rockstack.GroundMotion(pulse="sine", amplitude=1.0, period=1.0).measures()):
            with self.assertRaises(rockstack.InputError):
                wrong()
