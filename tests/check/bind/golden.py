"""The golden set of queries of tests/check/target/golden.c through the Python module: golden.py PAIRS HASH

Exits with 0 if the hash over so many pairs is HASH, in hexadecimal digits.
"""

import sys

import gjk
from golden_set import Pair, ask, main

VERTICES = 16
WORKSPACE = gjk.Workspace(20)


class Set(Pair):
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

    def query(self):
        cache = gjk.Cache()
        result = self.query_at_rest(cache)
        self.contacts(0)
        if not result.intersecting and not self.far:
            self.query_close(cache, result)
            self.contacts(self.size // 8)


if __name__ == "__main__":
    sys.exit(main(Set, 2026, sys.argv[1:]))
