"""An engine of your own in a few lines, as a worker program by the form of engines/worker/README.md."""
from __future__ import annotations

import json
import math
import os
import resource
import select
import socketserver
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, ClassVar, NoReturn

import numpy as np

from rockstack import _core
from rockstack.arguments import checked


@checked
@dataclass(frozen=True)
class Setting:
    """A number that shapes a run: its value for who sets nothing, what suits rocking blocks (`tuned`, the default unless
    given), its range, and its unit. choices: names of 0, 1, … where the number stands for one."""

    name: str
    default: float
    tuned: float | None = None
    least: float = 0.0
    most: float = 1e30
    whole: bool = False
    choices: Sequence[str] = ()
    unit: str = ""

    def described(self) -> dict[str, Any]:
        """As an engine's description has it."""
        fields = {**asdict(self), "tuned": self.default if self.tuned is None else self.tuned}
        return {key: value for key, value in fields.items() if key != "choices" or value}


@dataclass(frozen=True)
class Setup:
    """A scene as an engine is told it: boxes on the ground y = 0, bottom to top. SI units."""

    widths: np.ndarray  #: m, (blocks,)
    heights: np.ndarray  #: m, (blocks,)
    masses: np.ndarray  #: kg, (blocks,)
    inertias: np.ndarray  #: about the axis out of the plane, kg·m², (blocks,)
    offsets: np.ndarray  #: of the centre of mass from the box's middle, to its right and up, m, (blocks, 2)
    friction: np.ndarray  #: of the interface under each block, (blocks,)
    dt: float  #: s
    parameters: Mapping[str, float]  #: by the names of the settings


@dataclass(frozen=True)
class Contacts:
    """Corners that are on a face or in it. An impulse of size p_i along normal or tangent i (N·s) changes the rates, as one
    row of 3 × blocks, by inverse_masses * (normals.T @ p), and the corner's speed along it is normals @ rates."""

    gaps: np.ndarray  #: m, negative: in the face; (contacts,)
    friction: np.ndarray  #: (contacts,)
    normals: np.ndarray  #: (contacts, 3 × blocks)
    tangents: np.ndarray  #: (contacts, 3 × blocks)
    interfaces: np.ndarray  #: number of the upper block, from 0; (contacts,)
    along: np.ndarray  #: place on its lower face, from the middle to the right, m; (contacts,)


@dataclass
class _Body:
    """A place, that of the centre of mass, and sizes; points are from the middle. The ground is endless, its face at y = 0."""

    place: Sequence[float] = (0.0, 0.0, 0.0)
    half_width: float = math.inf
    half_height: float = 0.0
    offset: Sequence[float] = (0.0, 0.0)
    sine: float = field(init=False)
    cosine: float = field(init=False)

    def __post_init__(self) -> None:
        self.sine, self.cosine = math.sin(self.place[2]), math.cos(self.place[2])

    def world(self, x: float, y: float) -> tuple[float, float]:
        x, y = x - self.offset[0], y - self.offset[1]
        return (self.place[0] + x * self.cosine + y * self.sine, self.place[1] - x * self.sine + y * self.cosine)

    def local(self, x: float, y: float) -> tuple[float, float]:
        x, y = x - self.place[0], y - self.place[1]
        return x * self.cosine - y * self.sine + self.offset[0], x * self.sine + y * self.cosine + self.offset[1]


class _Unwanted(BaseException):
    """Nobody waits for a run any more."""


#: Passes a question on to the process that knows the engine, and the answer back.
_BRIDGE = """#!{python} -IS
import os, socket, sys
with socket.socket(socket.AF_UNIX) as line, os.fdopen(3, "wb") as answer:
    line.connect({address!r})
    line.sendall(sys.stdin.buffer.read().replace(b"\\n", b" ") + b"\\n")
    while part := line.recv(1 << 16):
        answer.write(part)
"""


class Worker:
    """An engine. Derive from it, name it, write step(), and end the file with `MyEngine().serve()`:

    #!/usr/bin/env python3
    import rockstack

    class Ice(rockstack.Worker):
        name, solver = "ice", "free"

        def step(self, dt, pull):
            self.rates[:, :2] += dt * pull
            self.places += dt * self.rates

    Ice().serve()

    The file is executable; its path is an engine's name: rockstack.simulate(scene, "./ice.py"), `rockstack compare --engine
    ./ice.py`. Each run is a process of its own, so that whatever it does ends that run and nothing else. The class itself is
    an engine's name too, in a notebook as anywhere: rockstack.simulate(scene, Ice). It then answers in this process, where
    it may print, and a run that takes too long ends after its step. An engine that calls bear() in its steps tells forces.

    places: x (right), y (up) in m and the clockwise angle in rad of each block's centre of mass; shape (blocks, 3). rates: theirs,
    m/s and rad/s; shape (blocks, 3). setup: Setup. inverse_masses: 1/kg, 1/kg and 1/(kg·m²), shape (3 × blocks,).
    """

    name: ClassVar[str]  #: small letters, digits, "-"
    solver: ClassVar[str] = "python"  #: likewise
    version: ClassVar[str] = "1"
    licence: ClassVar[str] = "not stated"
    settings: ClassVar[Sequence[Setting]] = ()
    planar: ClassVar[bool] = True  #: knows two dimensions only
    center_of_mass: ClassVar[bool] = False  #: minds setup.offsets, as contacts() does; else such scenes are refused
    lead: ClassVar[float] = 0.5  #: steps by which places are ahead under a constant force: 0.5 of semi-implicit Euler

    setup: Setup
    places: np.ndarray
    rates: np.ndarray
    inverse_masses: np.ndarray

    def start(self) -> None:
        """Called before the first step of a run."""

    def step(self, dt: float, pull: np.ndarray) -> None:
        """Takes places and rates dt (s) further. pull: the acceleration that every block feels in this step, gravity less the
        ground's, m/s², shape (2,)."""
        raise NotImplementedError("step() must be written")

    @checked
    def contacts(self, margin: float = 0.0) -> Contacts:
        """Corners no further than `margin` (m) from the face they meet: of each block's lower corners the one below, and of
        the upper corners of that, its own."""
        setup, count = self.setup, len(self.places)
        bodies = [_Body()] + [_Body(place, width / 2, height / 2, offset) for place, width, height, offset in
                              zip(self.places.tolist(), setup.widths.tolist(), setup.heights.tolist(), setup.offsets.tolist())]
        gaps, friction, normals, tangents, interfaces, places = [], [], [], [], [], []
        for k in range(count):
            below, above = bodies[k], bodies[k + 1]
            for corner, face, sign in ((above, below, 1), (below, above, -1)):
                for side in (-1, 1) if math.isfinite(corner.half_width) else ():
                    point = corner.world(side * corner.half_width, -sign * corner.half_height)
                    along, height = face.local(*point)
                    gap = sign * height - face.half_height
                    if abs(along) <= face.half_width and gap <= margin:
                        gaps.append(gap)
                        friction.append(setup.friction[k])
                        normals.append(self._row(k, bodies, point, (face.sine, face.cosine)))
                        tangents.append(self._row(k, bodies, point, (face.cosine, -face.sine)))
                        interfaces.append(k)
                        places.append(above.local(*point)[0])
        shape = (len(gaps), 3 * count)
        return Contacts(np.array(gaps), np.array(friction), np.reshape(normals, shape), np.reshape(tangents, shape),
                        np.array(interfaces, dtype=int), np.array(places))

    def bear(self, contacts: Contacts, pushes: np.ndarray, rubs: np.ndarray) -> None:
        """Tells what contacts bore in this step: impulses along their normals and tangents, N·s, shape (contacts,). Several calls
        add up. An engine that calls it in each step, without contacts as well, tells forces: simulate(…, forces=True)."""
        self._bears = True
        if self._borne is None:
            return
        for name, impulses in (("pushes", pushes), ("rubs", rubs)):
            if np.shape(impulses) != contacts.gaps.shape:
                raise _core.InputError(f"{name} of shape {np.shape(impulses)}: must be one for each of {len(contacts.gaps)} contacts")
        for k, along, push, rub, normal, tangent in zip(contacts.interfaces, contacts.along, pushes, rubs, contacts.normals,
                                                        contacts.tangents):
            upper = slice(3 * k, 3 * k + 2)
            self._borne[k, :2] += push * normal[upper] + rub * tangent[upper]
            self._borne[k, 2:] += push, push * along

    @staticmethod
    def _row(k: int, bodies: list[_Body], point: tuple[float, float], direction: tuple[float, float]) -> list[float]:
        """What the speed of block k at a point against what is below it is made of, along a direction."""
        row = [0.0] * (3 * (len(bodies) - 1))
        for number, sign in ((k, 1), (k - 1, -1)):
            if number < 0:
                continue
            x, y = point[0] - bodies[number + 1].place[0], point[1] - bodies[number + 1].place[1]
            row[3 * number:3 * number + 3] = [sign * direction[0], sign * direction[1],
                                              sign * (y * direction[0] - x * direction[1])]
        return row

    def serve(self) -> NoReturn:
        """Answers the question on standard input and ends the program."""
        answer = self._reply(sys.stdin.read())
        with os.fdopen(3, "w") as stream:
            stream.write(answer)
        sys.exit(0)

    @classmethod
    @contextmanager
    def program(cls) -> Iterator[Path]:
        """A worker program for as long as the context lasts, which passes what it is asked on to this process. There a
        thread and an object of its own answer each run. Raises InputError where the engine's name or settings are wrong."""
        _core.check_description(cls()._reply('{"describe": true}'))

        class Handler(socketserver.StreamRequestHandler):
            def handle(self) -> None:
                engine, line = cls(), select.poll()
                line.register(self.connection, 0)
                engine._unwanted = lambda: bool(line.poll(0))  # the program has ended, as its time was over
                try:
                    self.wfile.write(engine._reply(self.rfile.readline().decode()).encode())
                except (_Unwanted, BrokenPipeError):
                    return

        class Server(socketserver.ThreadingUnixStreamServer):
            daemon_threads = True

        with tempfile.TemporaryDirectory(prefix="rockstack-") as folder:
            file, address = Path(folder) / cls.name, folder + "/line"
            file.write_text(_BRIDGE.format(python=sys.executable, address=address))
            file.chmod(0o700)
            with Server(address, Handler) as server:
                threading.Thread(target=server.serve_forever, args=(0.01,), daemon=True).start()
                try:
                    yield file
                finally:
                    server.shutdown()

    def _reply(self, question: str) -> str:
        message = json.loads(question)
        answer: dict[str, Any] = ({"run": self._answer(message["run"])} if "run" in message
                                  else {"engines": [self._described()]})
        return json.dumps({"rockstack": 1, **answer})

    _unwanted: Callable[[], bool] = staticmethod(lambda: False)
    _bears = False
    #: Of each interface in the step under way, where it is asked for: impulse to the right and up on the upper block, that across
    #: faces, and its moment about the middle.
    _borne: np.ndarray | None = None

    def _described(self) -> dict[str, Any]:
        return {"name": self.name, "solver": self.solver, "version": self.version, "licence": self.licence,
                "planar": self.planar, "center_of_mass": self.center_of_mass, "lead": self.lead,
                "settings": [setting.described() for setting in self.settings]}

    def _answer(self, run: Mapping[str, Any]) -> dict[str, Any]:
        try:
            places, rates, reactions = self._samples(run, run["steps"])
            if not (np.isfinite(places).all() and np.isfinite(rates).all()):
                return {"status": "not finite", "reason": "a place or a rate is no number any more"}
            answer = {"status": "done", "angles": places[:, :, 2].ravel().tolist(),
                      "velocities": rates[:, :, 2].ravel().tolist(),
                      "peak_memory": 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss,
                      "seconds": [self._seconds(run, len(places) - 1) for _ in range(run["repeats"])]}
        except MemoryError:
            return {"status": "memory limit", "reason": "there is no more memory"}
        except (Exception, SystemExit) as error:  # what an engine raises is its answer
            return {"status": "failed", "reason": " ".join(f"{type(error).__name__}: {error}".split())}
        if run["bodies"]:
            answer["bodies"] = {name: values[:, :, i].ravel().tolist() for name, values, i in
                                (("x", places, 0), ("y", places, 1), ("velocity_x", rates, 0), ("velocity_y", rates, 1))}
        if run.get("reactions") and self._bears:
            answer["reactions"] = {name: [value if math.isfinite(value) else str(value) for value in reactions[..., i].ravel().tolist()]
                                   for i, name in enumerate(("normal", "tangential", "centre"))}
        return answer

    def _begin(self, run: Mapping[str, Any]) -> None:
        blocks = run["blocks"]

        def each(*keys: str) -> np.ndarray:
            return np.array([[block[key] for key in keys] for block in blocks], dtype=float)

        widths, heights, masses, inertias = each("width", "height", "mass", "inertia").T
        self.setup = Setup(widths, heights, masses, inertias, each("offset_x", "offset_y"),
                           np.array(run["friction"], dtype=float), run["dt"], run["parameters"])
        self.places, self.rates = each("x", "y", "angle"), each("velocity_x", "velocity_y", "angular_velocity")
        self.inverse_masses = 1 / each("mass", "mass", "inertia").ravel()
        self.start()

    def _take_step(self, dt: float, pull: np.ndarray) -> None:
        if self._unwanted():
            raise _Unwanted
        self.step(dt, pull)

    @staticmethod
    def _pulls(run: Mapping[str, Any]) -> np.ndarray:
        """Of each step, shape (steps, 2)."""
        shaken = run.get("accelerations")
        if shaken:
            return np.column_stack((shaken["x"], shaken["y"]))
        return np.tile((run["gravity"]["x"], run["gravity"]["y"]), (run["steps"], 1))

    def _reactions(self, angles: np.ndarray, dt: float) -> np.ndarray:
        """Mean force of a step on each upper block, across and along the face below, or its own where it is wider, N, and where it
        acts, m; shape (blocks, 3). angles: where the step starts, rad."""
        below = np.append(math.inf, self.setup.widths[:-1])
        face = np.where(self.setup.widths > below, angles, np.append(0.0, angles[:-1]))
        assert self._borne is not None
        x, y, push, moment = self._borne.T
        centre = np.divide(moment, push, out=np.full(len(push), math.nan), where=push > 0)
        sine, cosine = np.sin(face), np.cos(face)
        return np.column_stack(((x * sine + y * cosine) / dt, (x * cosine - y * sine) / dt, centre))

    def _samples(self, run: Mapping[str, Any], steps: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Places and rates at the start and after each step, shape (samples, blocks, 3), and reactions of each step."""
        self._begin(run)
        pulls, limits = self._pulls(run), np.array(run["toppling_angles"])
        places, rates, reactions = [self.places.copy()], [self.rates.copy()], []
        while len(places) <= steps and not (np.abs(self.places[:, 2]) > limits).any():
            self._borne = np.zeros((len(limits), 4)) if run.get("reactions") else None
            self._take_step(run["dt"], pulls[len(places) - 1])
            if self._borne is not None:
                reactions.append(self._reactions(places[-1][:, 2], run["dt"]))
            places.append(np.array(self.places, dtype=float))
            rates.append(np.array(self.rates, dtype=float))
        self._borne = None
        return np.array(places), np.array(rates), np.array(reactions)

    def _seconds(self, run: Mapping[str, Any], steps: int) -> float:
        """Wall time of the steps alone."""
        self._begin(run)
        pulls = self._pulls(run)
        begin = time.perf_counter()
        for k in range(steps):
            self._take_step(run["dt"], pulls[k])
        return time.perf_counter() - begin
