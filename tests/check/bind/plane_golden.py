"""The golden set of queries of tests/check/target/plane_golden.c through the Python module: plane_golden.py PAIRS HASH

Exits with 0 if the hash over so many pairs is HASH, in hexadecimal digits.
"""

import sys

import gjk
from gjk import plane
from golden_set import Pair, ask, main

VERTICES = 12
INT32_MAX = (1 << 31) - 1
POINT, SEGMENT, TRIANGLE, BOX, POLYGON, ELLIPSE, CUSTOM = range(7)


def diamond(reach):
    """A square on its corner, as a user's own shape."""

    def support(direction):
        if abs(direction.x) > abs(direction.y):
            return (-reach if direction.x < 0 else reach, 0)
        return (0, -reach if direction.y < 0 else reach)

    return plane.custom(support, reach)


class Set(Pair):
    module = plane

    def make_body(self):
        shape = self.make_shape()
        pose = self.make_pose(INT32_MAX if self.far else 2 * self.size)
        collider = plane.Collider(shape, pose, baked=self.random.below(2) == 0)
        box = collider.aabb()
        self.hash.mix(gjk.Status.OK, gjk.Status.OK, gjk.Status.OK, *box.lower, *box.upper)
        return collider

    def make_shape(self):
        random, size = self.random, self.size
        # Boxes and polygons are chosen more often.
        kind = (POINT, SEGMENT, TRIANGLE, BOX, BOX, POLYGON, POLYGON, POLYGON, ELLIPSE, CUSTOM)[random.below(10)]
        x = random.range(1, size) if kind != POINT else 0
        y = random.range(1, size) if kind not in (POINT, SEGMENT) else 0
        count = 3 if kind == TRIANGLE else 2 + random.below(VERTICES - 1)
        vertices = self.make_vertices(count, kind == POLYGON)
        radius = random.range(0, size // 2) if random.below(4) == 0 else 0
        shape = (
            lambda: plane.point(),
            lambda: plane.segment(x),
            lambda: plane.triangle(vertices),
            lambda: plane.box(x, y),
            lambda: plane.polygon(vertices),
            lambda: plane.ellipse(x, y),
            lambda: diamond(x),
        )[kind]()
        shape.size = plane.Vec(x, y)  # both, also for kinds that use less; plane_golden.c does so
        shape.convex_radius = radius
        return shape

    def make_vertices(self, count, is_polygon):
        random, size = self.random, self.size
        grid = size // 2 + 1 if random.below(4) == 0 else 1  # coarse: ties, repeated points, flat ones
        vertices = [[int(c / grid) * grid for c in random.vector(size, 2)] for _ in range(count)]
        if is_polygon and random.below(2) == 0:
            vertices = plane.corners(vertices)
            self.hash.mix(gjk.Status.OK, len(vertices))
        return vertices

    def make_rotation(self):
        """No turn, a turn by an angle, by cosine and sine, or one composed of both."""
        random, hash = self.random, self.hash
        raw = plane.Rotation(random.range(-1000, 1000), random.range(-1000, 1001))
        angle = random.range(-500000, 500000)
        kind = random.below(4)
        rotation = plane.Rotation(*plane.Rotation.IDENTITY)
        if kind in (1, 3):
            rotation = plane.Rotation.from_angle(angle)
            hash.mix(gjk.Status.OK)
        if kind == 2:
            rotation = raw.normalized()
            hash.mix(gjk.Status.OK)
        if kind == 3:
            rotation = rotation * raw.normalized()
            hash.mix(gjk.Status.OK, gjk.Status.OK)
        hash.mix(*rotation)
        return rotation

    def make_pose(self, reach):
        v = self.random.vector(reach, 2)
        rotation = self.make_rotation()
        pose = plane.Pose(self.random.vector(reach, 2), rotation)
        if reach < INT32_MAX // 4:
            inverse = pose.inverse()
            for at in (pose.apply(v), inverse.position, (pose * inverse).position):
                self.hash.mix(gjk.Status.OK, *at)
        return pose

    def proven(self, check, *arguments, **named):
        status, _ = ask(check, self.a, self.b, *arguments, **named)
        self.hash.mix(status)

    def gap(self, out):
        self.hash.mix(out.intersecting, out.lower, out.upper)

    def points(self, out):
        self.hash.mix(out.saturated, out.distance, *out.point_a, *out.point_b, *out.normal)

    def distance(self, cache):
        status, out = ask(plane.distance, self.a, self.b, cache)
        self.hash.mix(status)
        self.gap(out)
        if not out.intersecting:
            self.points(out)
        if status == gjk.Status.OK:
            self.proven(plane.check_distance, out)
        return out

    def distance_until(self, iterations, error):
        status, out = ask(plane.distance_until, self.a, self.b, iterations, error)
        self.hash.mix(status)
        self.gap(out)
        if not out.intersecting:
            self.points(out)

    def decision(self, distance, cache):
        if distance < 0:
            status, out = ask(plane.intersect, self.a, self.b, cache)
        else:
            status, out = ask(plane.within, self.a, self.b, distance, cache)
        self.hash.mix(status)
        if status == gjk.Status.OK:
            self.hash.mix(out.yes)
            self.proven(plane.check_decision, out, most=max(distance, 0))

    def penetration(self, cache):
        status, out = ask(plane.penetration, self.a, self.b, cache)
        self.hash.mix(status)
        if status == gjk.Status.ITERATION_LIMIT:
            return
        self.hash.mix(out.intersecting)
        if out.intersecting:
            self.hash.mix(out.lower, out.upper, out.depth, *out.point_a, *out.point_b, *out.normal)
        if status == gjk.Status.OK:
            self.proven(plane.check_penetration, out)

    def signed_distance(self, cache):
        status, out = ask(plane.signed_distance, self.a, self.b, cache)
        self.hash.mix(status, out.lower, out.upper)
        if status != gjk.Status.ITERATION_LIMIT:
            self.points(out)

    def contacts(self, margin, most):
        status, out = ask(plane.contacts, self.a, self.b, margin, most)
        self.hash.mix(status)
        if status not in (gjk.Status.OK, gjk.Status.CAPACITY):
            return
        self.hash.mix(out.count)
        if out.count > 0:
            self.hash.mix(*out.normal, out.feature_a << 16 | out.feature_b)
        for contact in out:
            self.hash.mix(*contact.point_a, *contact.point_b, contact.distance, contact.id)

    def query(self):
        cache = plane.Cache()
        result = self.query_at_rest(cache)
        self.signed_distance(cache)
        self.contacts(0, 2)
        if not result.intersecting and not self.far:
            self.query_close(cache, result)
            self.contacts(self.size // 8, 2)
            self.contacts(self.size // 8, 1)


def refuse(hash, last):
    """What queries answer where they refuse."""
    a = last.a
    unset = plane.Collider(a.shape)
    unset.state = 0
    for query, arguments in (
        (plane.intersect, (a, unset)),
        (plane.within, (a, a, -1)),
        (plane.distance, (None, a)),
        (plane.contacts, (a, a, 0, 3)),
        (plane.Rotation(0, 0).normalized, ()),
    ):
        hash.mix(ask(query, *arguments)[0])


if __name__ == "__main__":
    sys.exit(main(Set, 2027, sys.argv[1:], refuse))
