"""The golden set of queries of tests/check/target/golden.c through the Python module: golden.py PAIRS HASH

Exits with 0 if the hash over so many pairs is HASH, in hexadecimal digits.
"""

import sys

import gjk
from golden_set import ask, main, moved

VERTICES = 16
WORKSPACE = gjk.Workspace(20)


class Pair:
    """Two random bodies and the hash of what is asked about them."""

    def __init__(self, random, hash):
        self.random, self.hash = random, hash
        self.size = 1 << (3 + random.below(23))
        self.far = random.below(8) == 0
        self.a = self.make_body()
        self.b = self.make_body()

    def make_body(self):
        random = self.random
        make = self.make_shape()
        pose = gjk.Pose()
        if random.below(4) != 0:
            q = [random.range(-1000, 1000 + (i == 3)) for i in range(4)]
            pose.rotation = gjk.Quat(*q).normalized()
            self.hash.mix(gjk.Status.OK)
        pose.position = gjk.Vec3(*random.vector((1 << 31) - 1 if self.far else 2 * self.size))
        collider = gjk.Collider(make, pose, baked=random.below(2) == 0)
        self.hash.mix(gjk.Status.OK, gjk.Status.OK)  # of gjk_collider_init and gjk_collider_pose
        return collider

    def make_shape(self):
        random, size = self.random, self.size
        # Boxes and hulls are chosen twice as often.
        kind = (0, 1, 2, 3, 3, 4, 4, 4, 5, 6, 7)[random.below(11)]
        x, y, z = (random.range(1, size) for _ in range(3))
        count = 3 if kind == 2 else 4 + random.below(VERTICES - 3)
        grid = size // 2 + 1 if random.below(4) == 0 else 1  # coarse: ties, and parallel faces
        vertices = [[int(c / grid) * grid for c in random.vector(size)] for _ in range(count)]
        radius = random.range(0, size // 2) if random.below(4) == 0 else 0
        shape = (
            lambda: gjk.sphere(radius),
            lambda: gjk.capsule(radius, z),
            lambda: gjk.triangle(vertices, radius),
            lambda: gjk.box(x, y, z, radius),
            lambda: gjk.hull(vertices, radius=radius),
            lambda: gjk.cylinder(x, z, radius),
            lambda: gjk.cone(x, z, radius),
            lambda: gjk.ellipsoid(x, y, z, radius),
        )[kind]()
        shape.size = gjk.Vec3(x, y, z)  # all of it, also for kinds that use less; golden.c does so
        return shape

    def distance(self, cache):
        status, out = ask(gjk.distance, self.a, self.b, cache)
        self.hash.mix(status, out.intersecting, out.saturated, out.distance)
        if not out.intersecting:
            self.hash.mix(*out.point_a, *out.point_b, *out.normal)
        return out

    def decision(self, distance, cache):
        if distance < 0:
            status, out = ask(gjk.intersect, self.a, self.b, cache)
        else:
            status, out = ask(gjk.within, self.a, self.b, distance, cache)
        self.hash.mix(status, out.yes)

    def within_until(self, distance, iterations):
        status, out = ask(gjk.within_until, self.a, self.b, distance, iterations)
        self.hash.mix(status, out.answer)

    def distance_until(self, iterations, error):
        status, out = ask(gjk.distance_until, self.a, self.b, iterations, error)
        self.hash.mix(status, out.intersecting, out.distance, out.lower, out.upper)
        if not out.intersecting:
            self.hash.mix(*out.point_a)

    def penetration(self, cache):
        status, out = ask(gjk.penetration, self.a, self.b, cache, WORKSPACE)
        self.hash.mix(status, out.intersecting)
        if out.intersecting:
            self.hash.mix(out.depth, out.lower, out.upper, *out.point_a, *out.point_b, *out.normal)

    def contacts(self, margin):
        status, out = ask(gjk.contacts, self.a, self.b, margin, 4, None, WORKSPACE)
        self.hash.mix(status, out.count)
        for contact in out:
            self.hash.mix(*contact.point_a, *contact.point_b, contact.distance, contact.id)

    def approach(self, result):
        """Moves B along the normal until the gap is near 0."""
        by = result.distance + self.random.range(-2, 2)
        self.b.move(moved(self.b.position, result.normal, by))
        self.hash.mix(gjk.Status.OK)

    def query(self):
        cache = gjk.Cache()
        result = self.distance(None)
        self.decision(-1, None)
        self.decision(result.distance, None)
        result = self.distance(cache)
        self.penetration(cache)
        self.contacts(0)
        if not result.intersecting and not self.far:
            self.approach(result)
            result = self.distance(cache)
            self.decision(-1, cache)
            self.decision(1, None)
            self.within_until(1 + self.size // 32, 1)
            self.within_until(result.distance, 2)
            self.distance_until(2, 0)
            self.distance_until(0, 1 + self.size // 16)
            self.penetration(None)
            self.contacts(self.size // 8)


if __name__ == "__main__":
    sys.exit(main(Pair, 2026, sys.argv[1:]))
