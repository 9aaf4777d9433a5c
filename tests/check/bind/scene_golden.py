"""The matches of tests/support/scene through the Python module, with saves and rollbacks.

scene_golden.py TICKS HASH [plane]: exits with 0 if the hash over so many ticks is HASH, in hexadecimal digits.
"""

import sys

import gjk
from gjk import BodyKind, Detail, Event, plane, q16
from golden_set import Random

FLAT = len(sys.argv) > 3 and sys.argv[3] == "plane"
OF, AXES = (plane, 2) if FLAT else (gjk, 3)
BODIES, WALL, REACH = 24, 6 if FLAT else 5, q16(4 if FLAT else 3)
WORD, PRIME = (1 << 32) - 1, 0x100000001B3
MASK = (1 << 64) - 1
CORNERS = [
    (30000, 2000, 1000), (-28000, 9000, -3000), (5000, 31000, 2000), (-3000, -30000, 4000), (1000, 2000, 33000),
    (-2000, 900, -31000), (20000, 20000, 12000), (-19000, -18000, -9000),
]  # fmt: skip
FLAT_CORNERS = [(30000, 2000), (9000, 29000), (-25000, 20000), (-28000, -9000), (-3000, -30000), (19000, -18000)]
SAIL = [(-40000, -9000), (41000, 0), (3000, 52000)]
DETAILS = [Detail.DISTANCE, Detail.TOUCH, Detail.TOUCH, Detail.DISTANCE, Detail.DEPTH, Detail.CONTACTS]


def remainder(x, divisor):
    """Of C: with the sign of x."""
    return -(-x % divisor) if x < 0 else x % divisor


def scramble(x):
    x = (x ^ x >> 16) * 0x7FEB352D & WORD
    x = (x ^ x >> 15) * 0x846CA68B & WORD
    return x ^ x >> 16


def dice(a, b, c, limit):
    return scramble(scramble(scramble(a) ^ b) ^ c) % (2 * limit + 1) - limit


def bounce(at, step):
    return -step if (at > REACH and step > 0) or (at < -REACH and step < 0) else step


def sum_of(manifold):
    parts = [remainder(n, d) for n, d in zip(manifold.normal, (5, 7, 11))]
    for c in manifold:
        last = c.point_b.x if FLAT else c.point_b.z
        parts += [remainder(c.point_a.x, 5), remainder(c.point_a.y, 7), remainder(last, 11)]
        parts += [remainder(c.distance, 13), c.id]
    return sum(parts) + manifold.feature_a + manifold.feature_b


class Body:
    """What the game keeps of a body."""

    def __init__(self, id, step, turn):
        self.id, self.step, self.turn = id, step, turn


def shapes():
    half = q16(0.5)
    if FLAT:
        return [
            plane.box(half, half), plane.circle(half), plane.capsule(q16(0.25), q16(0.4)), plane.polygon(FLAT_CORNERS),
            plane.ellipse(half, q16(0.375)), plane.triangle(SAIL), plane.box(q16(6), q16(0.25)),
        ]  # fmt: skip
    return [
        gjk.box(half, half, half), gjk.sphere(half), gjk.capsule(q16(0.25), q16(0.4)), gjk.hull(CORNERS),
        gjk.cylinder(half, q16(0.375)), gjk.box(q16(6), q16(6), q16(0.25)),
    ]  # fmt: skip


def up(height):
    return [0] * (AXES - 1) + [height]


class Match:
    def __init__(self):
        more = {} if FLAT else {"workspace_cells": 400}
        self.scene = OF.Scene(
            shapes(), BODIES, parts=2 * BODIES, own_poses=BODIES, pairs=160, box_margin=q16(0.1), persist=True, **more
        )
        self.tick, self.bodies = 0, [None] * BODIES
        for slot in range(BODIES):
            self.add(slot)

    def add(self, slot):
        def roll(c, limit):
            return dice(slot, self.tick, c, limit)

        fixed = slot == BODIES - 1
        if FLAT:
            turn = plane.Rotation(30000, roll(4, 500)).normalized()
        else:
            turn = gjk.Quat(roll(4, 300), roll(5, 300), roll(6, 300), 30000).normalized()
        parts = [WALL if fixed else slot % WALL]
        if slot % 6 == 5 and not fixed:
            parts.append((1, OF.Pose(up(q16(0.75)))))
        id = self.scene.add(
            parts,
            OF.Pose(up(-REACH) if fixed else [roll(1 + axis, REACH) for axis in range(AXES)]),
            kind=BodyKind.STATIC if fixed else BodyKind.KINEMATIC if slot < 2 else BodyKind.DYNAMIC,
            detail=DETAILS[slot % 6],
            user=slot,
            margin=q16(0.125) if slot % 4 == 0 else 0,
            slot=slot,
        )
        self.bodies[slot] = Body(id, [0] * AXES if slot < 2 else [roll(7 + axis, 3000) for axis in range(AXES)], turn)

    def move(self, slot, input):
        body = self.bodies[slot]
        state = self.scene.get(body.id)
        if state.kind == BodyKind.STATIC or state.asleep:
            return
        push = -2000 if input & 8 else 2000
        position = list(state.pose.position)
        for i in range(AXES):
            body.step[i] = bounce(position[i], push if input >> i & 1 else body.step[i])
            position[i] += body.step[i]
        rotation = state.pose.rotation
        if slot >= 2 or input & 16:
            rotation = body.turn * rotation
        self.scene.move(body.id, OF.Pose(position, rotation))

    def act(self, input):
        slot = 2 + self.tick % (BODIES - 3)
        id = self.bodies[slot].id
        if input & 32 and self.tick % 5 == 0:
            self.scene.set_shape(id, 0, self.tick % WALL)
        if input & 64 and self.tick % 7 == 0:
            self.scene.remove(id)
            self.add(slot)
        if input & 128 and self.tick % 3 == 0:
            id = self.bodies[slot].id
            (self.scene.wake if self.scene.get(id).asleep else self.scene.sleep)(id)

    def react(self, report):
        a, b = (self.bodies[id.slot] for id in (report.a, report.b))
        if a.id != report.a or b.id != report.b:
            return
        if report.event == Event.BEGIN:
            a.step, b.step = b.step, a.step
        elif report.event == Event.PERSIST:
            bend = sum_of(report.manifold) if report.manifold is not None else report.distance
            b.step[0] += remainder(bend, 7) - 3
        else:
            b.step[1] += report.part_b + 1
        b.step[0] = 3000 if b.step[0] > 4000 else -3000 if b.step[0] < -4000 else b.step[0]
        b.step[1] = -3000 if b.step[1] > 4000 else b.step[1]

    def play(self, inputs):
        for slot in range(BODIES):
            self.move(slot, inputs[slot] if slot < 2 else 0)
        for input in inputs:
            self.act(input)
        for report in self.scene.update():
            self.react(report)
        self.tick += 1

    def hash(self):
        value = self.scene.hash()
        for body in self.bodies:
            for word in (*body.step, body.id.generation):
                value = (value ^ word & WORD) * PRIME & MASK
        return value

    def save(self):
        return self.scene.save(), self.tick, [Body(b.id, list(b.step), b.turn) for b in self.bodies]

    def load(self, save):
        self.scene.load(save[0])
        self.tick, self.bodies = save[1], [Body(b.id, list(b.step), b.turn) for b in save[2]]


def input_of(tick, player):
    number = Random(2 * tick + player).u32()
    return number & number >> 8 & 0xFF


def main(ticks, expected):
    match, random, sum, i, loads = Match(), Random(3), 0xCBF29CE484222325, 0, 0
    saved = match.save(), sum
    while i < ticks:
        what = random.below(100)
        if what < 3 or i - saved[0][1] > 30:
            saved = match.save(), sum
        elif what < 5:
            match.load(saved[0])
            sum, i, loads = saved[1], match.tick, loads + 1
        match.play([input_of(i, 0), input_of(i, 1)])
        sum = (sum ^ match.hash()) * PRIME & MASK
        i += 1
    print(f"{sum:016x} after {loads} rollbacks")
    return int(sum != expected or loads == 0)


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]), int(sys.argv[2], 16)))
