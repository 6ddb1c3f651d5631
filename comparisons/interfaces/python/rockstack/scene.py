"""The question: blocks, how they start, how the ground moves, and for how long."""
from __future__ import annotations

import os
from collections.abc import ItemsView, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from rockstack import _core
from rockstack.arguments import checked
from rockstack.ground import GroundMotion
from rockstack.numbers import call


@dataclass(frozen=True, repr=False)
class Block:
    """A block by the keys of a table [[blocks]], `rockstack.keys("scene")`; None where it was not given. SI units."""

    width: float  #: m
    height: float  #: m
    density: float | None = None  #: kg/m³, of 1 m of depth
    mass: float | None = None  #: kg, instead of density
    inertia: float | None = None  #: about the centre of mass, kg·m²; None: of a uniform rectangle
    center_of_mass: Sequence[float] | None = None  #: from the block's middle, to the right and up, m; None: there

    def items(self) -> ItemsView[str, Any]:
        """Keys and values, as of a table."""
        return vars(self).items()

    def __repr__(self) -> str:
        return call("Block", vars(self))


class Scene:
    """A scene, checked as a scene file is; it never changes. SI units, angles in rad and clockwise positive.

    Scene(duration=5.0, blocks=[Block(width=1.0, height=2.5, density=2500)], initial={"angles": [0.1]})
    Scene({"duration": 5.0, "blocks": [...]})        the same from a mapping
    Scene.read("scene.toml")                         from a file, or the name of a scene that comes with rockstack

    Keys and tables are those of scene files (`rockstack.keys("scene")`); a block may be a Block or a table, the ground's
    tables may be GroundMotion, and arrays may be numpy's. A path of a record is relative to `folder`, the current one
    unless given. Scenes are equal where all that was given is; repr() is what makes the same scene again.

    Raises InputError with the key, the value and what is allowed: unknown keys, numbers out of range or not finite,
    arrays of another length than there are blocks.
    """

    __slots__ = ("_core", "__weakref__")

    @checked
    def __init__(self, table: Mapping[str, Any] | None = None, /, *, folder: str | os.PathLike[str] = "",
                 **keys: Any):
        self._core = _core.Scene.made({**(table or {}), **keys}, os.path.abspath(folder), "scene")

    @classmethod
    def _of(cls, core: _core.Scene) -> Scene:
        scene = cls.__new__(cls)
        scene._core = core
        return scene

    @classmethod
    @checked
    def read(cls, file: str | os.PathLike[str], overrides: Sequence[str] = ()) -> Scene:
        """A scene file, or a scene that comes with rockstack by its name; `overrides` as the program's --set has them,
        "blocks.2.height=1.4". Raises InputError as the program does."""
        return cls._of(_core.Scene.read(os.fspath(file), list(overrides)))

    @checked
    def replace(self, values: Mapping[str, Any] | None = None, /, **keys: Any) -> Scene:
        """Another scene with some keys changed: `scene.replace({"blocks.2.height": 1.4}, law="paper")`. In keys blocks and
        interfaces count from 1. Raises InputError as Scene()."""
        return self._of(self._core.changed({**(values or {}), **keys}))

    def to_dict(self) -> dict[str, Any]:
        """All that was given, as Scene() takes it."""
        return self._core.document

    def to_toml(self) -> str:
        """The same as the text of a scene file."""
        return "".join(f"{key} = {_toml(value)}\n" for key, value in self.to_dict().items())

    @property
    def title(self) -> str:
        """Heads tables and figures."""
        return self._core.title

    @property
    def duration(self) -> float:
        """s."""
        return self._core.duration

    @property
    def gravity(self) -> float:
        """m/s²."""
        return self._core.gravity

    @property
    def law(self) -> str:
        """Of contact: "consistent", "paper", "unilateral" or "compliant"."""
        return self._core.law

    @property
    def equations(self) -> str:
        """Of motion: "nonlinear", "linear" or "small-angle"."""
        return self._core.equations

    @property
    def blocks(self) -> tuple[Block, ...]:
        """From the bottom up: `scene.blocks[1].height` is of the second one."""
        return tuple(Block(**{key: tuple(value) if isinstance(value, list) else value for key, value in block.items()})
                     for block in self.to_dict()["blocks"])

    @property
    def friction(self) -> np.ndarray:
        """Coulomb's coefficient of each interface, from the ground up; shape (blocks,)."""
        return self._core.friction

    @property
    def slenderness(self) -> np.ndarray:
        """Angle of each block's unstable balance on level ground, rad; shape (blocks,)."""
        return self._core.slenderness

    @property
    def toppling_angles(self) -> np.ndarray:
        """Angle at which each block counts as toppled, rad; shape (blocks,)."""
        return self._core.toppling_angles

    @property
    def horizontal(self) -> GroundMotion | None:
        """The ground's acceleration to the right, m/s²; None where there is none."""
        return self._motion("horizontal")

    @property
    def vertical(self) -> GroundMotion | None:
        """The ground's acceleration upwards, m/s²; None where there is none."""
        return self._motion("vertical")

    def _motion(self, axis: str) -> GroundMotion | None:
        table = self.to_dict().get("ground", {}).get(axis)
        return None if table is None else GroundMotion._of(table, _core.GroundMotion.of_scene(self._core, axis))

    def __reduce__(self):
        return _made, (self.to_dict(), self._core.folder)

    def _value(self) -> dict[str, Any]:
        """What makes it: its keys, and the folder of its records."""
        table = self.to_dict()
        records = any(isinstance(motion, dict) and "record" in motion for motion in table.get("ground", {}).values())
        return {**table, "folder": str(self._core.folder)} if records else table

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Scene) and self._value() == other._value()

    def __hash__(self) -> int:
        return hash((self.title, self.duration, self.law, self._core.blocks))

    def __repr__(self) -> str:
        return call("Scene", self._value())

    def __str__(self) -> str:
        count = "1 block" if self._core.blocks == 1 else f"{self._core.blocks} blocks"
        return f"{self.title}: {count}, {self.duration:g} s, law {self.law}"


def scene_of(scene: Scene | str | os.PathLike[str]) -> Scene:
    """The scene, or that of a file or a name."""
    return scene if isinstance(scene, Scene) else Scene.read(scene)


def _made(table: dict[str, Any], folder: Path) -> Scene:
    return Scene(table, folder=folder)


def _toml(value: Any) -> str:
    """A value on one line, as TOML has it."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key} = {_toml(inner)}" for key, inner in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(_toml, value)) + "]"
    return _core.toml_text(value) if isinstance(value, str) else str(value).lower() if isinstance(value, bool) else repr(value)
