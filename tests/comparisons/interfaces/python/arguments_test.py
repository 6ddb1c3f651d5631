"""What functions state to take is what they take: anything else is refused by a line that names it."""
import datetime
import inspect
import re
import unittest
from pathlib import Path

import numpy as np
import rockstack
from rockstack.arguments import checked
from scenes import BLOCK, rocking


class Hostile:
    def __repr__(self):
        raise RuntimeError("no words")


DATE = np.datetime64("2026-01-01", "ns")
#: What no type stands for.
NEVER = [object(), Hostile(), 1j, DATE, np.timedelta64(1, "ns"), datetime.date(2026, 1, 1), rockstack, lambda: None]
TEXTS = ["", "x", np.str_("x"), Path("x")]
NUMBERS = [0.5, np.float32(0.5), np.array(0.5)]
#: Values that are of none of the types that begin an annotation.
WRONG = {
    "float": [*TEXTS, [1.0], {}, True, np.bool_(1), b"1", np.ones(1), np.complex64(1)],
    "int": [*TEXTS, *NUMBERS, [1], True, 10 ** 30, b"1", np.ones(1, int)],
    "bool": [*TEXTS, *NUMBERS, 2, [True], np.ones(2, bool)],
    "str": [*NUMBERS, 1, True, b"x", ["x"], {}],
    "type[Worker]": [*NUMBERS, 1, True, b"x", ["x"], int, rockstack.Scene],
    "Scene": [*NUMBERS, 1, True, b"x", {}, rockstack.Scene],
    "Sequence": [*NUMBERS, 1, True, "x", b"x", {}],
    "Mapping": [*NUMBERS, 1, True, "x", b"x", [1]],
    "ArrayLike": ["x", ["1.0"], b"1", [1j], np.ones(2, complex), [DATE], [[1.0], [1.0, 2.0]], [None], True, [True]],
    "Motion": [*NUMBERS, 1, "x", [], {}],
}
WRONG["Truths"] = WRONG["ArrayLike"][:-2]
WRONG.update(Iterable=WRONG["Sequence"], Simulation=WRONG["Motion"])


def functions():
    """The public ones, and the public methods of public classes."""
    for name in rockstack.__all__:
        entry = getattr(rockstack, name)
        if inspect.isfunction(entry):
            yield name, entry
        elif inspect.isclass(entry) and not issubclass(entry, Exception):
            for member, value in vars(entry).items():
                value = getattr(value, "__func__", value)
                if inspect.isfunction(value) and hasattr(value, "__wrapped__") and not hasattr(value, "__self__"):
                    yield f"{name}.{member}", value


def stated(annotation: str) -> list[str]:
    """The types that begin it, without what they hold."""
    while "[" in re.sub(r"(PathLike|type)\[", "", annotation):
        annotation = re.sub(r"(?<!PathLike)(?<!type)\[(?:[^\[\]]|\[[^\[\]]*\])*\]", "", annotation)
    return annotation.split(" | ")


class ArgumentsTest(unittest.TestCase):
    def refused(self, name, call):
        with self.assertRaises(rockstack.InputError) as raised:
            call()
        self.assertIsInstance(raised.exception, TypeError)
        self.assertRegex(str(raised.exception), rf"\A{re.escape(name)}(\[\S+\])? = .+: must be [^\n]+\Z")
        self.assertLess(len(str(raised.exception)), 300)

    def test_what_is_of_no_stated_type_is_refused_by_name(self):
        told = 0
        for name, function in functions():
            places = [parameter for parameter in inspect.signature(function).parameters.values()]
            for number, parameter in enumerate(places):
                types = [] if parameter.annotation is parameter.empty else stated(parameter.annotation)
                if not types or "Any" in types:
                    continue
                known = [kind for kind in types if kind not in ("None", "os.PathLike[str]")]
                allowed = [value for kind in known for value in WRONG[kind]]
                wrong = [value for value in allowed if all(any(value is other for other in WRONG[kind]) for kind in known)
                         and not ("os.PathLike[str]" in types and isinstance(value, Path))]
                for value in [*NEVER, *wrong]:
                    with self.subTest(name=name, argument=parameter.name, value=type(value).__name__):
                        told += 1
                        if parameter.kind in (parameter.POSITIONAL_ONLY, parameter.VAR_POSITIONAL):
                            self.refused(parameter.name, lambda: function(*[None] * number, value))
                        else:
                            self.refused(parameter.name, lambda: function(**{parameter.name: value}))
        self.assertGreater(told, 500)

    def test_a_motion_is_of_a_mapping_a_file_or_a_trace(self):
        motion = rockstack.GroundMotion(samples=[0.0, 1.0], interval=0.1)
        for wrong in (1, [1.0], np.ones(2), DATE, dict):
            with self.subTest(wrong=str(type(wrong))), self.assertRaisesRegex(rockstack.InputError, "must be"):
                rockstack.GroundMotion(wrong)
        self.refused("periods", lambda: motion.spectrum(0.5))
        self.refused("folder", lambda: rockstack.Scene(folder="\udc80"))

    def test_entries_are_named_by_their_places(self):
        scene = rocking()
        self.refused("dt", lambda: rockstack.compare(scene, dt=[0.01, "x"]))
        self.refused("parameters", lambda: rockstack.simulate(scene, parameters={"erp": None}))
        self.refused("scenes", lambda: rockstack.solve_many([scene, 3]))
        with self.assertRaisesRegex(rockstack.InputError, r"^dt\[1\] = 'x': must be a number$"):
            rockstack.compare(scene, dt=[0.01, "x"])

    def test_numbers_of_any_kind_are_taken(self):
        scene, wanted = rocking(), rockstack.solve(rocking(), interval=0.5)
        for interval in (np.float64(0.5), np.float32(0.5), np.array(0.5), np.float16(0.5)):
            self.assertEqual(rockstack.solve(scene, interval=interval), wanted)
        for times in ([0, 0.5, 1], (0.0, 0.5, 1.0), np.array([0, 0.5, 1], np.longdouble), np.array([0, 0.5, 1], object)):
            self.assertEqual(rockstack.solve(scene, times=times), wanted)

    def test_functions_keep_what_they_state(self):
        def function(scene, *, many=()):
            """Says so."""

        function.__annotations__ = {"scene": "Scene", "many": "Sequence[float]"}
        self.assertEqual(inspect.signature(checked(function)), inspect.signature(function))
        self.assertEqual(inspect.getdoc(checked(function)), "Says so.")
        function.__annotations__["many"] = "frozenset[float]"
        with self.assertRaises(KeyError):
            checked(function)

    def test_numbers_that_doubles_cannot_tell_apart_are_no_whole_numbers(self):
        vary = [{"key": "blocks.1.width", "normal": {"mean": 0.5, "deviation": 0.01}}]
        seeded = lambda seed: rockstack.sweep(scene=rocking(duration=0.1), vary=vary, samples=1, seed=seed)
        for seed in (2 ** 53 + 1, np.uint64(2 ** 53 + 1), -1, 10 ** 400):
            with self.assertRaisesRegex(rockstack.InputError, "seed = .*: must be a whole number from 0 to 9007199254740992"):
                seeded(seed)
        self.assertEqual(seeded(2 ** 53), seeded(float(2 ** 53)))
        with self.assertRaisesRegex(rockstack.InputError, "synthetic = 9007199254740994: must be"):
            rockstack.Scene.read("three-drums", ["ground.horizontal.synthetic=9007199254740993", "ground.horizontal.peak=1"])

    def test_dates_are_no_numbers_of_a_scene(self):
        for value in (DATE, np.timedelta64(3, "ns"), np.array([DATE, DATE]), 1j, np.complex128(1), b"1"):
            with self.assertRaisesRegex(rockstack.InputError, "must be a"):
                rocking(duration=value)
            with self.assertRaises(rockstack.InputError):
                rockstack.GroundMotion(samples=value, interval=0.1)
        with self.assertRaises(rockstack.InputError):
            rocking(blocks=[{**BLOCK, "width": DATE}])


if __name__ == "__main__":
    unittest.main()
