"""The ground's acceleration over a piece of time."""
from __future__ import annotations

from fractions import Fraction

import intervals
from chain import Number, real, sine_cosine
from intervals import ZERO
from scene import Pulse, Samples, Scene


def body_force(scene: Scene, start: Fraction, time: Number) -> tuple[Number, Number]:
    """Gravity less the ground's acceleration, per mass, along the ground and across it; `time` is since the piece's start."""
    sine, cosine = intervals.sine_cosine(real(scene.inclination))
    weight = real(scene.gravity)
    level, up = (acceleration(scene.ground[axis], start, time) if axis in scene.ground else ZERO
                 for axis in ("horizontal", "vertical"))
    return weight * sine - level, -(weight * cosine) - up


def still(scene: Scene, start: Fraction) -> bool:
    """Whether it has one acceleration from here on, a piece's start."""
    def constant(motion: Samples | Pulse) -> bool:
        return start >= motion.cuts()[-1]
    return all(constant(motion) for motion in scene.ground.values())


def acceleration(motion: Samples | Pulse, start: Fraction, time: Number) -> Number:
    if isinstance(motion, Samples):
        before = int(start / motion.interval)
        if before + 1 >= len(motion.values):
            return ZERO
        slope = (motion.values[before + 1] - motion.values[before]) / motion.interval
        return time * real(slope) + real(motion.values[before] + slope * (start - before * motion.interval))
    begins, ends = motion.cuts()
    if not begins <= start < ends:
        return ZERO
    if motion.shape == "rectangle":
        return real(motion.amplitude)
    return wave(motion, time + real(start - motion.start))


def wave(pulse: Pulse, elapsed: Number) -> Number:
    turn = (intervals.half_turn() + intervals.half_turn()) / real(pulse.period)
    if pulse.shape != "mavroeidis-papageorgiou":
        sine, cosine = sine_cosine(elapsed * turn, turn)
        return (cosine if pulse.shape == "cosine" else sine) * real(pulse.amplitude)
    centred = elapsed - real(pulse.cycles * pulse.period / 2)
    slow = turn / real(pulse.cycles)
    sine, cosine = sine_cosine(centred * turn + real(pulse.phase), turn)
    slow_sine, slow_cosine = sine_cosine(centred * slow, slow)
    return (sine + sine * slow_cosine + cosine * slow_sine * real(1 / pulse.cycles)) * real(-pulse.amplitude / 2)
