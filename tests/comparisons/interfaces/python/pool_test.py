"""What a pool of processes computes comes back whole, and may be copied."""
import copy
import multiprocessing
import os
import pickle
import subprocess
import sys
import unittest

import numpy as np
import rockstack
from scenes import TWO, rocking

MOTIONS = {"paper": "spanos-free-rocking", "unilateral": "thrown-block", "compliant": "flexible-foundation"}


#: Takes in a motion's pickle with each of its bits turned over, and asks it for everything.
FLIPS = """
import pickle, resource
import rockstack
resource.setrlimit(resource.RLIMIT_AS, (2 ** 31, 2 ** 31))
scene = rockstack.Scene(duration=0.1, blocks=[dict(width=0.5, height=1.5, density=2500.0)], initial=dict(angles=[0.1]))
whole = pickle.dumps(rockstack.solve(scene, interval=0.1))
for bit in range(8 * len(whole)):
    flipped = bytearray(whole)
    flipped[bit // 8] ^= 1 << bit % 8
    try:
        motion = pickle.loads(bytes(flipped))
        if isinstance(motion, rockstack.Motion):
            [getattr(motion, name) for name in dir(motion)]
    except Exception:
        continue
print("all")
"""


def checksum(data: bytes) -> bytes:
    """FNV-1a, which packed() ends with."""
    total = 0xcbf29ce484222325
    for byte in data:
        total = (total ^ byte) * 0x100000001b3 % 2 ** 64
    return total.to_bytes(8, "little")


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
                rockstack.fragility([1.0, 1.0, 2.0, 2.0, 3.0, 3.0], [0, 0, 0, 1, 1, 1]),
                rockstack.sobol_indices([[1.0, 2.0, 2.0], [3.0, 1.0, 2.0]], ["x"])]
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

    def test_bytes_of_no_motion_are_refused(self):
        """Cut ones, ones with a bit turned over, longer ones, and those of a motion of other blocks."""
        scene = rocking()
        unpacked = rockstack._core.Motion.unpacked
        whole = rockstack.solve(scene, interval=0.5)._core.packed()
        self.assertEqual(unpacked(scene._core, whole).packed(), whole)
        damaged = [whole[:length] for length in range(0, len(whole), 1 + len(whole) // 50)] + [whole + whole[-8:], b""]
        for bit in range(8 * len(whole)):
            flipped = bytearray(whole)
            flipped[bit // 8] ^= 1 << bit % 8
            damaged.append(bytes(flipped))
        for wrong in damaged:
            with self.assertRaises(rockstack.InputError):
                unpacked(scene._core, wrong)
        with self.assertRaises(rockstack.InputError):
            unpacked(rockstack.Scene(duration=1.0, blocks=TWO)._core, whole)
        for motion in ({"pulse": "sine", "amplitude": 3.0, "period": 1.0}, {"samples": [0.0, 1.0], "interval": 0.5}):
            whole = rockstack.GroundMotion(motion)._core.packed()
            for bit in range(8 * len(whole)):
                flipped = bytearray(whole)
                flipped[bit // 8] ^= 1 << bit % 8
                with self.assertRaises(rockstack.InputError):
                    rockstack._core.GroundMotion.unpacked(bytes(flipped))

    def test_lists_are_of_the_lengths_that_their_blocks_give(self):
        """Under a right checksum, as of another build: counts, kinds, interfaces and patterns, each a number of four or eight
        bytes, are what they may be, or refused; and what is taken can be asked for everything, and tells or refuses."""
        scene = rocking()
        whole = rockstack.solve(scene, interval=0.5)._core.packed()[:-8]
        taken = 0
        for place in range(0, len(whole) - 3, 4):
            for number in (-1, 2, 7, 1000, 2 ** 31 - 1):
                changed = whole[:place] + number.to_bytes(4, "little", signed=True) + whole[place + 4:]
                try:
                    motion = rockstack._core.Motion.unpacked(scene._core, changed + checksum(changed))
                    taken += 1
                    for name in dir(motion):
                        getattr(motion, name)
                except ValueError:
                    continue
        self.assertGreater(taken, 0)

    @unittest.skipIf("ASAN_OPTIONS" in os.environ, "the address sanitizer ends a program that asks for too much memory")
    def test_no_single_bit_of_a_pickle_ends_the_interpreter(self):
        answer = subprocess.run([sys.executable, "-c", FLIPS], capture_output=True, text=True, timeout=600)
        self.assertEqual((answer.returncode, answer.stdout.strip()), (0, "all"), answer.stderr[-300:])


if __name__ == "__main__":
    unittest.main()
