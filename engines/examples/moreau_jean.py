#!/usr/bin/env python3
"""A worker in Python: Moreau and Jean's time stepping for stacked blocks, as an example of engines/README.md.

Each step moves the bodies by half of it, finds the corners that are on a face or in it, and gives the bodies
the velocities that no corner goes deeper with (Signorini in velocities, no restitution) and that Coulomb's cone
allows; then it moves them by the other half. M. Jean, Comput. Methods Appl. Mech. Engrg. 177 (1999) 235-257.
The sweeps begin with the impulses of the step before, which a contact that lasts hardly changes.
"""
import json
import math
import os
import sys
import time

SETTINGS = [
    {"name": "sweeps", "default": 100, "tuned": 400, "least": 1, "most": 1e6, "whole": True},
    {"name": "tolerance", "default": 1e-10, "tuned": 1e-14, "least": 0, "most": 1, "unit": "m/s"},
    {"name": "margin", "default": 0, "tuned": 1e-9, "least": 0, "most": 1, "unit": "m"},  # what is on a face
]
ENGINE = {"name": "moreau-jean", "solver": "gauss-seidel", "version": "1", "licence": "same as rockstack",
          "planar": True, "center_of_mass": True, "lead": 0, "settings": SETTINGS}


class Body:
    """Place, angle and velocities; the ground is a body without inverse masses. Angles clockwise positive."""

    def __init__(self, block=None):
        block = block or {}
        self.place = [block.get("x", 0.0), block.get("y", 0.0), block.get("angle", 0.0)]
        self.rate = [block.get("velocity_x", 0.0), block.get("velocity_y", 0.0), block.get("angular_velocity", 0.0)]
        self.half_width = block.get("width", math.inf) / 2
        self.half_height = block.get("height", 0.0) / 2
        self.offset = block.get("offset_x", 0.0), block.get("offset_y", 0.0)  # of the place from the middle
        self.inverse = [1 / block[key] for key in ("mass", "mass", "inertia")] if block else [0.0, 0.0, 0.0]

    def move(self, duration):
        self.place = [p + duration * v for p, v in zip(self.place, self.rate)]

    def point(self, x, y):
        """A point, from the middle in the body's axes, in the world."""
        c, s = math.cos(self.place[2]), math.sin(self.place[2])
        x, y = x - self.offset[0], y - self.offset[1]
        return self.place[0] + x * c + y * s, self.place[1] - x * s + y * c

    def local(self, x, y):
        """A point of the world in the body's axes, from the middle."""
        c, s = math.cos(self.place[2]), math.sin(self.place[2])
        x, y = x - self.place[0], y - self.place[1]
        return x * c - y * s + self.offset[0], x * s + y * c + self.offset[1]


class Contact:
    """A corner of one body on a face of another: impulses, and how they change both bodies' velocities."""

    def __init__(self, name, upper, lower, point, face, friction):
        s, c = math.sin(face.place[2]), math.cos(face.place[2])
        self.name, self.bodies, self.friction, self.impulse = name, (upper, lower), friction, [0.0, 0.0]
        self.rows = []  # of the normal and of the tangent: what an impulse on the upper body does to either
        for direction in ((s, c), (c, -s)):
            row = []
            for body, sign in ((upper, 1), (lower, -1)):
                x, y = point[0] - body.place[0], point[1] - body.place[1]
                row.append([sign * g for g in (direction[0], direction[1], y * direction[0] - x * direction[1])])
            self.rows.append(row)
        self.mass = [1 / sum(b.inverse[i] * g[i] ** 2 for b, g in zip(self.bodies, row) for i in range(3))
                     for row in self.rows]

    def set_impulse(self, axis, impulse):
        """Gives both bodies what the impulse is more than before, and returns that."""
        step, self.impulse[axis] = impulse - self.impulse[axis], impulse
        for body, g in zip(self.bodies, self.rows[axis]):
            body.rate = [v + step * w * h for v, w, h in zip(body.rate, body.inverse, g)]
        return step

    def solve(self):
        """One step of Gauss and Seidel. Returns the largest change of a velocity."""
        change = 0.0
        for axis, row in enumerate(self.rows):
            rate = sum(g[i] * b.rate[i] for b, g in zip(self.bodies, row) for i in range(3))
            wanted = self.impulse[axis] - self.mass[axis] * rate
            bound = self.friction * self.impulse[0]
            wanted = max(0.0, wanted) if axis == 0 else max(-bound, min(bound, wanted))
            change = max(change, abs(self.set_impulse(axis, wanted) / self.mass[axis]))
        return change


def find_contacts(bodies, friction, margin):
    """Corners that are on a face or in it: each body's lower ones on what is below, and the upper ones of that."""
    contacts = []
    for number, (lower, upper, mu) in enumerate(zip(bodies, bodies[1:], friction)):
        for side in (-1, 1):
            corner = upper.point(side * upper.half_width, -upper.half_height)
            along, height = lower.local(*corner)
            if abs(along) <= lower.half_width and height <= lower.half_height + margin:
                contacts.append(Contact((number, side, "upper"), upper, lower, corner, lower, mu))
            if math.isinf(lower.half_width):
                continue
            corner = lower.point(side * lower.half_width, lower.half_height)
            along, height = upper.local(*corner)
            if abs(along) <= upper.half_width and height >= -upper.half_height - margin:
                contacts.append(Contact((number, side, "lower"), upper, lower, corner, upper, mu))
    return contacts


def take_step(bodies, friction, dt, pull, parameters, impulses):
    """Takes the impulses of the step before, by their contacts' names, and returns its own."""
    for body in bodies[1:]:
        body.move(dt / 2)
        body.rate = [body.rate[0] + dt * pull[0], body.rate[1] + dt * pull[1], body.rate[2]]
    contacts = find_contacts(bodies, friction, parameters["margin"])
    for contact in contacts:
        for axis, impulse in enumerate(impulses.get(contact.name, (0.0, 0.0))):
            contact.set_impulse(axis, impulse)
    for _ in range(parameters["sweeps"]):
        if max((contact.solve() for contact in contacts), default=0.0) <= parameters["tolerance"]:
            break
    for body in bodies[1:]:
        body.move(dt / 2)
    return {contact.name: contact.impulse for contact in contacts}


def run(asked, steps):
    """All samples, the first at the start; and the wall time of stepping alone, s."""
    bodies = [Body()] + [Body(block) for block in asked["blocks"]]
    gravity = asked["gravity"]
    pulls = asked.get("accelerations")
    samples, impulses, spent = [], {}, 0.0
    while True:
        samples.append([(*body.place, *body.rate) for body in bodies[1:]])
        if len(samples) > steps or any(
                abs(body.place[2]) > limit for body, limit in zip(bodies[1:], asked["toppling_angles"])):
            return samples, spent
        k = len(samples) - 1
        pull = (pulls["x"][k], pulls["y"][k]) if pulls else (gravity["x"], gravity["y"])
        start = time.perf_counter()
        impulses = take_step(bodies, asked["friction"], asked["dt"], pull, asked["parameters"], impulses)
        spent += time.perf_counter() - start


def reply_to(asked):
    samples, _ = run(asked, asked["steps"])
    column = {name: [state[i] for sample in samples for state in sample]
              for i, name in enumerate(("x", "y", "angles", "velocity_x", "velocity_y", "velocities"))}
    reply = {"status": "done", "angles": column.pop("angles"), "velocities": column.pop("velocities"),
             "seconds": [run(asked, len(samples) - 1)[1] for _ in range(asked["repeats"])]}
    return {**reply, "bodies": column} if asked["bodies"] else reply


def main():
    message = json.load(sys.stdin)
    reply = {"run": reply_to(message["run"])} if "run" in message else {"engines": [ENGINE]}
    with os.fdopen(3, "w") as stream:
        json.dump({"rockstack": 1, **reply}, stream)


main()
