"""Arguments of public functions, held against the types that the functions state."""
from __future__ import annotations

import ast
import functools
import inspect
import operator
import os
import reprlib
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any, TypeVar, cast

import numpy as np
from numpy.typing import ArrayLike

from rockstack import _core

Truths = ArrayLike  #: numbers, or whether something is so
Function = TypeVar("Function", bound=Callable[..., Any])


class ArgumentError(_core.InputError, TypeError):
    """An argument of another type than its function states."""


@dataclass(frozen=True)
class Type:
    """What an argument may be: in words, whether a value is of it, and what the function gets of one that is."""

    expected: str
    fits: Callable[[Any], bool]
    converted: Callable[[str, Any], Any] = lambda name, value: value


def wrong(name: str, value: Any, expected: str) -> ArgumentError:
    """The error `name = value: must be …`, on one line."""
    shorter = reprlib.Repr()
    shorter.maxstring = shorter.maxother = shorter.maxlong = 60
    try:
        shown = " ".join(shorter.repr(value).split())
    except Exception:  # whatever a value's own repr() does
        shown = f"a {type(value).__name__}"
    return ArgumentError(f"{name} = {shown}: must be {expected}")


def numbers(name: str, values: Any, kinds: str = "fiu") -> np.ndarray:
    """An array of numbers, and of no dates, texts or complex ones. Raises InputError where a mask hides some, as the gaps of
    a record."""
    if np.ma.is_masked(values):
        raise _core.InputError(f"{name}: {np.ma.count_masked(values)} of {np.size(values)} masked: must be filled first")
    try:
        array = np.asarray(values)
    except (TypeError, ValueError):
        raise wrong(name, values, "an array of numbers") from None
    if array.dtype.kind == "O" and all(map(_is_number, array.flat)):
        return np.reshape([_number(name, value) for value in array.flat], array.shape)
    if array.dtype.kind not in kinds:
        raise wrong(name, values, "an array of numbers")
    return array.astype(float, copy=False)


def checked(function: Function) -> Function:
    """A function, or a class, that refuses arguments of other types than stated, with a line that names the argument, its value and
    what it must be. Raises KeyError for a type that is not known here."""
    if isinstance(function, type):
        checked_class: Any = function
        checked_class.__init__ = checked(vars(function)["__init__"])
        return checked_class
    parameters = inspect.signature(function).parameters.values()
    types = {parameter.name: _stated(ast.parse(parameter.annotation, mode="eval").body) for parameter in parameters
             if parameter.annotation is not parameter.empty}
    places = [parameter.name for parameter in parameters if parameter.kind < parameter.VAR_POSITIONAL]
    others = [parameter.name for parameter in parameters if parameter.kind == parameter.VAR_POSITIONAL]

    def taken(name: str, value: Any) -> Any:
        return _converted(types[name], name, value) if name in types else value

    @functools.wraps(function)
    def call(*given: Any, **named: Any) -> Any:
        known = len(places)
        return function(*map(taken, places, given), *[taken(name, value) for name in others for value in given[known:]],
                        *(() if others else given[known:]), **{name: taken(name, value) for name, value in named.items()})

    return cast(Function, call)


def _converted(types: list[Type], name: str, value: Any) -> Any:
    for one in types:
        if one.fits(value):
            return one.converted(name, value)
    raise wrong(name, value, _words(types))


def _words(types: list[Type]) -> str:
    return " or ".join(one.expected for one in types)


def _is_number(value: Any) -> bool:
    if isinstance(value, (np.ndarray, np.generic)):
        return value.ndim == 0 and value.dtype.kind in "fiu"
    return hasattr(type(value), "__float__") and not isinstance(value, bool) and not hasattr(type(value), "__len__")


def _number(name: str, value: Any) -> float:
    try:
        return float(value)
    except OverflowError:
        return float("inf") if value > 0 else float("-inf")
    except (TypeError, ValueError):
        raise wrong(name, value, "a number") from None


def _is_whole(value: Any) -> bool:
    return hasattr(type(value), "__index__") and not isinstance(value, (bool, np.bool_)) and np.ndim(value) == 0


def _whole(name: str, value: Any) -> int:
    try:
        number = operator.index(value)
    except TypeError:  # an array of something else
        raise wrong(name, value, "a whole number") from None
    most = 2 ** 31 - 1
    if not -most <= number <= most:
        raise wrong(name, value, f"a whole number from {-most} to {most}")
    return number


def _is_truth(value: Any) -> bool:
    return isinstance(value, (bool, np.bool_)) or (isinstance(value, int) and value in (0, 1))


def _is_text(value: Any) -> bool:
    return isinstance(value, str) and value == value.encode(errors="ignore").decode()  # no half of a pair


def _is_path(value: Any) -> bool:
    return hasattr(type(value), "__fspath__") and isinstance(os.fspath(value), str)


def _instance(name: str) -> Type:
    """Those of a class of this package."""
    def fits(value: Any) -> bool:
        import rockstack

        return isinstance(value, getattr(rockstack, name))

    return Type(f"a rockstack.{name}", fits)


def _is_worker(value: Any) -> bool:
    import rockstack

    return isinstance(value, type) and issubclass(value, rockstack.Worker)


def _is_mapping(value: Any) -> bool:
    return hasattr(type(value), "keys") and hasattr(type(value), "__getitem__")


def _list_of(entry: list[Type]) -> Type:
    def fits(value: Any) -> bool:
        one = isinstance(value, (str, bytes, Mapping)) or isinstance(value, np.ndarray) and value.ndim == 0
        return isinstance(value, Iterable) and not one

    return Type(f"a list, each entry {_words(entry)}", fits, lambda name, values: [
        _converted(entry, f"{name}[{place}]", value) for place, value in enumerate(values)])


def _mapping_of(entry: list[Type]) -> Type:
    return Type(f"a mapping, each value {_words(entry)}", _is_mapping, lambda name, values: {
        _converted([_TYPES["str"]], f"a key of {name}", key): _converted(entry, f"{name}[{key!r}]", values[key])
        for key in values.keys()})


_TYPES = {
    "Any": Type("anything", lambda value: True),
    "None": Type("None", lambda value: value is None),
    "bool": Type("True or False", _is_truth, lambda name, value: bool(value)),
    "float": Type("a number", _is_number, _number),
    "int": Type("a whole number", _is_whole, _whole),
    "str": Type("a text", _is_text),
    "os.PathLike[str]": Type("a path", _is_path, lambda name, value: os.fspath(value)),
    "ArrayLike": Type("an array of numbers", lambda value: value is not None, numbers),
    "Truths": Type("an array of numbers or truth values", lambda value: value is not None,
                   lambda name, values: numbers(name, values, "biuf")),
    "type[Worker]": Type("a class derived from rockstack.Worker", _is_worker),
    **{name: _instance(name) for name in ("Motion", "Scene", "Simulation")},
}


def _stated(annotation: ast.expr) -> list[Type]:
    """The types of an annotation."""
    if isinstance(annotation, ast.BinOp):
        return _stated(annotation.left) + _stated(annotation.right)
    if isinstance(annotation, ast.Subscript):
        outer = ast.unparse(annotation.value)
        if outer in ("Sequence", "Iterable"):
            return [_list_of(_stated(annotation.slice))]
        if outer == "Mapping" and isinstance(annotation.slice, ast.Tuple):
            return [_mapping_of(_stated(annotation.slice.elts[1]))]
    return [_TYPES[ast.unparse(annotation)]]
