"""A scene's decimal numbers as fractions: laws `paper` and `consistent`, equations in full."""
from __future__ import annotations

import tomllib
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import Any

from intervals import Unproved

GRAVITY, STANDARD_GRAVITY = Fraction("9.81"), Fraction("9.80665")


@dataclass
class Block:
    width: Fraction
    height: Fraction
    mass: Fraction
    inertia: Fraction
    centre_x: Fraction  # of mass, from the middle of the lower face
    centre_y: Fraction


@dataclass
class Samples:
    """Lines between values at an interval from 0 on, m/s²; nothing after the last one."""
    interval: Fraction
    values: list[Fraction]

    def cuts(self) -> list[Fraction]:
        return [n * self.interval for n in range(len(self.values))]


@dataclass
class Pulse:
    shape: str
    amplitude: Fraction
    period: Fraction
    start: Fraction
    cycles: Fraction
    phase: Fraction

    def cuts(self) -> list[Fraction]:
        return [self.start, self.start + self.cycles * self.period]


@dataclass
class Scene:
    paper: bool
    duration: Fraction
    gravity: Fraction
    inclination: Fraction
    blocks: list[Block]
    angles: list[Fraction]
    velocities: list[Fraction]
    ground: dict[str, Samples | Pulse] = field(default_factory=dict)

    def pieces(self) -> list[tuple[Fraction, Fraction]]:
        """Between which the ground's acceleration is analytic."""
        cuts = {Fraction(0), self.duration, *(cut for motion in self.ground.values() for cut in motion.cuts())}
        inside = sorted(cut for cut in cuts if 0 <= cut <= self.duration)
        return list(zip(inside, inside[1:], strict=False))


def read_scene(file: Path, duration: str) -> Scene:
    """Follows a scene file; a duration takes the place of its own."""
    document = tomllib.loads(file.read_text(), parse_float=Fraction)
    law = document.get("law", "consistent")
    unknown = set(document) - {"title", "duration", "gravity", "law", "equations", "blocks", "initial", "ground", "contact",
                               "engine", "measured"}
    if law not in ("paper", "consistent") or document.get("equations", "nonlinear") != "nonlinear" or unknown:
        raise Unproved("a scene of other laws, equations or keys")
    ground, start = document.get("ground", {}), document.get("initial", {})
    zeros = [0] * len(document["blocks"])
    return Scene(law == "paper", Fraction(duration or document["duration"]), Fraction(document.get("gravity", GRAVITY)),
                 Fraction(ground.get("inclination", 0)), [read_block(block) for block in document["blocks"]],
                 [Fraction(angle) for angle in start.get("angles", zeros)],
                 [Fraction(rate) for rate in start.get("velocities", zeros)],
                 {axis: read_motion(ground[axis], file.parent) for axis in ("horizontal", "vertical") if axis in ground})


def read_block(block: dict[str, Any]) -> Block:
    if set(block) - {"width", "height", "density", "mass", "inertia", "center_of_mass"}:
        raise Unproved("a block with other keys")
    width, height = Fraction(block["width"]), Fraction(block["height"])
    mass = Fraction(block["mass"]) if "mass" in block else Fraction(block["density"]) * width * height
    offset_x, offset_y = block.get("center_of_mass", (0, 0))
    return Block(width, height, mass, Fraction(block.get("inertia", mass * (width**2 + height**2) / 12)), Fraction(offset_x),
                 height / 2 + Fraction(offset_y))


def read_motion(table: dict[str, Any], folder: Path) -> Samples | Pulse:
    if "pulse" in table:
        shape = table["pulse"]
        if shape not in ("sine", "half-sine", "cosine", "rectangle", "mavroeidis-papageorgiou"):
            raise Unproved(f"a pulse {shape}")
        cycles = Fraction(1, 2) if shape == "half-sine" else Fraction(table.get("cycles", 1))
        return Pulse(shape, Fraction(table["amplitude"]), Fraction(table["period"]), Fraction(table.get("start", 0)), cycles,
                     Fraction(table.get("phase", 0)))
    if set(table) - {"record", "samples", "interval", "scale", "peak"}:
        raise Unproved("a motion of the ground with other keys")
    motion = read_record(folder / table["record"]) if "record" in table else Samples(
        Fraction(table["interval"]), [Fraction(value) for value in table["samples"]])
    factor = Fraction(table.get("scale", 1))
    if "peak" in table:
        factor *= Fraction(table["peak"]) / max(abs(value * factor) for value in motion.values)
    motion.values = [value * factor for value in motion.values]
    return motion


def read_record(file: Path) -> Samples:
    """One value a line, after lines that begin with #, of which one has the interval."""
    lines = file.read_text().splitlines()
    unit = STANDARD_GRAVITY if "# units: g" in lines else Fraction(1)
    intervals = [line.removeprefix("# dt = ").split()[0] for line in lines if line.startswith("# dt = ")]
    return Samples(Fraction(intervals[0]), [unit * Fraction(line) for line in lines if line and not line.startswith("#")])
