"""What a pool of processes computes comes back whole, and may be copied."""
import copy
import multiprocessing
import pickle
import unittest

import numpy as np
import rockstack
from scenes import TWO, rocking

MOTIONS = {"paper": "spanos-free-rocking", "unilateral": "thrown-block", "compliant": "flexible-foundation"}


def solved(name: str) -> rockstack.Solution:
    return rockstack.solve(rockstack.Scene.read(name, ["duration=0.3"]), interval=0.01)


def equal(one, other) -> bool:
    """To the bit, with what is not a number."""
    if isinstance(one, dict):
        return one.keys() == other.keys() and all(equal(one[key], other[key]) for key in one)
    if isinstance(one, np.ndarray):
        return one.dtype == other.dtype and one.tobytes() == other.tobytes()
    return one == other


class PoolTest(unittest.TestCase):
    def same(self, one, other):
        names = [name for name in dir(type(one)) if isinstance(getattr(type(one), name), property)]
        self.assertGreater(len(names), 3)
        for name in names:
            if not isinstance(getattr(one, name), rockstack.GroundMotion):
                self.assertTrue(equal(getattr(one, name), getattr(other, name)), name)

    def test_solutions_come_back_from_a_pool(self):
        with multiprocessing.get_context("spawn").Pool(2) as pool:
            for name, made in zip(MOTIONS.values(), pool.map(solved, MOTIONS.values())):
                with self.subTest(name):
                    alone = solved(name)
                    self.same(alone, made)
                    self.assertEqual(alone, made)
                    self.assertEqual(hash(alone), hash(made))
                    self.assertNotEqual(alone, rockstack.solve(alone.scene, interval=0.02))

    def test_what_functions_return_pickles_and_copies(self):
        scene = rockstack.Scene(duration=0.2, blocks=TWO, initial={"angles": [0.1, 0.1]})
        motion = rockstack.GroundMotion(synthetic=1, peak=2.0, duration=1.0)
        pulse = rockstack.GroundMotion(pulse="sine", amplitude=3.0, period=1.0)
        table = rockstack.sweep(scene=scene, vary=[{"key": "gravity", "values": [9.0, 10.0]}])
        kept = [scene, scene.blocks, rockstack.solve(scene), motion, pulse, rocking(ground={"horizontal": motion}).horizontal, table,
                rockstack.fragility([1.0, 1.0, 2.0, 2.0, 3.0, 3.0], [0, 0, 0, 1, 1, 1])]
        if rockstack.engines():
            engine = rockstack.engines()[0]["name"]
            kept += [rockstack.simulate(scene, engine, 0.01, bodies=True), rockstack.canon(engine, scenes=["throw"], draws=1),
                     rockstack.compare(scene, engines=[engine], dt=[0.01], quick=True, draws=2)]
        for value in kept:
            for other in (pickle.loads(pickle.dumps(value)), copy.copy(value), copy.deepcopy(value)):
                with self.subTest(type(value).__name__):
                    self.assertEqual(repr(other), repr(value))
                    self.assertTrue(other == value)
                    if isinstance(value, rockstack.Motion):
                        self.same(value, other)
        for error in (rockstack.InputError("wrong"), rockstack.EngineError("failed"), rockstack.Unfinished("why", kept[2])):
            other = pickle.loads(pickle.dumps(error))
            self.assertEqual((type(other), str(other), vars(other)), (type(error), str(error), vars(error)))

    def test_the_motion_up_to_where_it_was_given_up_comes_back(self):
        chatter = rocking(blocks=[{"width": 0.1, "height": 2.0, "density": 2500.0}], initial={"angles": [1e-6]}, duration=2.0)
        failure, = rockstack.solve_many([chatter], tolerance=1e-100, failures="keep")
        other = pickle.loads(pickle.dumps(failure))
        self.assertEqual(str(other), str(failure))
        self.same(failure.solution, other.solution)

    def test_cut_bytes_are_refused(self):
        scene = rocking()
        whole = rockstack.solve(scene)._core.packed()
        for length in range(0, len(whole), 1 + len(whole) // 50):
            with self.assertRaises(rockstack.InputError):
                rockstack._core.Motion.unpacked(scene._core, whole[:length])


if __name__ == "__main__":
    unittest.main()
