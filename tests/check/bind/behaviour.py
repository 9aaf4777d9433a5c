"""What the Python module does around the queries: numbers, errors, lifetimes, names. Prints what is wrong."""

import enum
import gc
import math
import sys

import gjk
from checks import check, raises, run
from gjk import plane, q16


def numbers():
    check(q16(0.5) == 32768 and q16(-0.25) == -16384 and gjk.units(q16(0.5)) == 0.5, "q16")
    check(q16(0.6 / 65536) == 1 and q16(0.5 / 65536) == 1 and q16(-0.5 / 65536) == -1, "q16 to the nearest")
    check(gjk.q30(1.0) == gjk.Q30_ONE and gjk.angle(math.pi) == 205887, "q30 and angle")
    raises(OverflowError, q16, 32768)
    # ctypes says with ArgumentError which argument is wrong.
    argument_error = raises(Exception, gjk.box, 0.5, 1, 1)
    check(type(argument_error).__name__ in ("ArgumentError", "TypeError"), "a float is no length")
    raises(Exception, gjk.box, 1 << 31, 1, 1)
    raises(OverflowError, gjk.Vec3, 0, 1 << 31, 0)
    vector = gjk.Vec3(1, 2, 3)
    raises(OverflowError, setattr, vector, "x", 1 << 40)
    check(tuple(vector) == (1, 2, 3), "a refused number changes nothing")
    check(vector == gjk.Vec3(1, 2, 3) and vector != gjk.Vec3(1, 2, 4), "equality")
    check(repr(gjk.Pose()) == "Pose(position=Vec3(x=0, y=0, z=0), rotation=Quat(x=0, y=0, z=0, w=1073741824))", "repr")


def names():
    """Enumerators have the values of the library, and none is missing."""
    prefixes = {gjk.Status: "GJK_ERROR_", gjk.Proof: "GJK_PROOF_", gjk.Answer: "GJK_ANSWER_"}
    prefixes.update({gjk.BodyKind: "GJK_BODY_", gjk.BodyMotion: "GJK_MOTION_", gjk.Detail: "GJK_DETAIL_"})
    prefixes.update({gjk.Event: "GJK_EVENT_", gjk.HullFault: "GJK_HULL_", gjk.MeshFault: "GJK_MESH_"})
    prefixes.update({plane.Proof: "GJK2_PROOF_", plane.Answer: "GJK2_ANSWER_"})
    for kind, prefix in prefixes.items():
        check(issubclass(kind, enum.IntEnum), kind)
        for member in kind:
            name = "GJK_OK" if member == gjk.Status.OK and kind is gjk.Status else prefix + member.name
            check(gjk.constant(name) == member.value, name)
    check(gjk.constant("GJK_CONTACTS_MAX") == 8, "constant")
    raises(KeyError, gjk.constant, "GJK_CONTACTS_LEAST")
    for module in (gjk, plane):
        for name in ("distance", "penetration", "contacts", "cast", "time_of_impact", "check_distance"):
            check(callable(getattr(module, name)), name)


def errors():
    raises(gjk.Error, gjk.sphere, -1, status=gjk.Status.NEGATIVE)
    raises(gjk.Error, gjk.box, gjk.constant("GJK_RADIUS_MAX"), 1, 1, 1, status=gjk.Status.SIZE)
    raises(gjk.Error, gjk.hull, [], status=gjk.Status.EMPTY)
    raises(ValueError, gjk.triangle, [(0, 0, 0), (1, 0, 0)])
    raises(gjk.Error, gjk.Quat.from_axis_angle, (0, 0, 0), 1, status=gjk.Status.ROTATION)
    ball = gjk.Collider(gjk.sphere(q16(1)))
    raises(gjk.Error, ball.pose, gjk.Pose(rotation=(0, 0, 0, 5)), status=gjk.Status.ROTATION)
    raises(gjk.Error, gjk.within, ball, ball, -1, status=gjk.Status.NEGATIVE)
    # An error with an answer: without memory a depth is bounded, not found.
    cube = [(x, y, z) for x in (0, q16(1)) for y in (0, q16(1)) for z in (0, q16(1))]
    a, b = (gjk.Collider(gjk.hull(cube), gjk.Pose((at, 0, 0))) for at in (0, q16(0.5)))
    error = raises(gjk.Error, gjk.penetration, a, b, workspace=gjk.Workspace(0), status=gjk.Status.CAPACITY)
    check(error.result.intersecting and error.result.depth >= q16(0.5), "depth after CAPACITY")
    check(gjk.penetration(a, b).depth == q16(0.5), "depth of cubes")
    apart = gjk.Collider(gjk.sphere(1), gjk.Pose((q16(3), 0, 0)))
    gap = gjk.distance(a, apart)
    gjk.check_distance(a, apart, gap)
    gap.distance += 1
    raises(gjk.Error, gjk.check_distance, a, apart, gap, status=gjk.Status.UNPROVEN)


def lifetimes():
    """What a collider needs lives as long as it does."""

    def corner(direction):
        return [q16(1) if c > 0 else -q16(1) for c in direction]

    cube = [[q16(x), q16(y), q16(z)] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    hulls = [gjk.Collider(gjk.hull(cube, faces), baked=baked) for baked in (False, True)]
    by_function = gjk.Collider(gjk.custom(corner, q16(2)))
    gc.collect()
    junk = [bytearray(200) for _ in range(1000)]
    box = gjk.Collider(gjk.box(q16(1), q16(1), q16(1)), gjk.Pose((q16(3), 0, 0)))
    for collider in hulls:
        check(gjk.distance(collider, box).distance == q16(1), "a hull")
        check(gjk.contacts(collider, box, margin=q16(1)).count == 4, "the faces of a hull")
    check(abs(gjk.distance(by_function, box).distance - q16(1)) <= 2, "a shape by its support function")
    check(len(junk) == 1000, "junk")


def motion():
    wall = gjk.Collider(gjk.box(q16(0.05), q16(2), q16(2)))
    ball = gjk.Collider(gjk.sphere(q16(0.01)), gjk.Pose((q16(-8), 0, 0)))
    hit = gjk.cast(wall, ball, to_b=(q16(8), q16(1), 0))
    check(hit and hit.hit and abs(hit.rest_b.x - q16(-0.06)) <= 2, "cast")
    gjk.check_cast(wall, ball, hit, to_b=(q16(8), q16(1), 0))
    check(not gjk.cast(wall, ball, to_b=(q16(-8), q16(1), 0)), "a miss")
    check(gjk.cast_ray(wall, (q16(-8), 0, 0), (0, 0, 0)).point_a.x == q16(-0.05), "ray")
    still = gjk.Motion(gjk.Pose())
    flight = gjk.Motion(gjk.Pose((q16(-8), 0, 0)), gjk.Pose((q16(8), 0, 0)), spin=(0, 0, gjk.angle(40)))
    impact = gjk.time_of_impact(wall, still, ball, flight)
    check(impact.hit and abs(gjk.units(impact.pose_b.position.x) + 0.06) < 0.01, "time of impact")
    check(flight.pose(gjk.Q30_ONE // 2).position.x == 0, "the pose on the way")


def in_the_plane():
    wall = plane.Collider(plane.box(q16(0.05), q16(2)))
    ball = plane.Collider(plane.circle(q16(0.01)), plane.Pose((q16(-8), 0)))
    check(plane.cast(wall, ball, to_b=(q16(8), q16(1))).hit, "cast in the plane")
    spun = plane.Motion(plane.Pose((q16(-8), 0)), plane.Pose((q16(8), 0)), spin=gjk.angle(40))
    check(plane.time_of_impact(wall, plane.Motion(plane.Pose()), ball, spun).hit, "time of impact in the plane")
    floor = plane.Collider(plane.box(q16(5), q16(1)))
    square = plane.polygon([(q16(x), q16(y)) for x in (-1, 1) for y in (-1, 1)])
    crate = plane.Collider(square, plane.Pose((0, q16(1.5))))
    touch = plane.contacts(floor, crate)
    check(len(touch) == 2 and all(contact.distance == q16(-0.5) for contact in touch), "contacts in the plane")
    quarter = plane.Rotation.from_angle(gjk.angle(math.pi / 2))
    check(tuple(quarter.apply((q16(1), 0))) == (0, q16(1)), "a quarter of a turn")
    there = plane.Pose((q16(1), q16(2)), quarter)
    check(tuple((there * there.inverse()).position) == (0, 0), "a pose and its inverse")
    raises(gjk.Error, plane.polygon, [], status=gjk.Status.EMPTY)


def poses():
    quarter = gjk.Quat.from_axis_angle((0, 0, 1), gjk.angle(math.pi / 2))
    check(tuple(quarter.apply((q16(1), 0, 0))) == (0, q16(1), 0), "a quarter of a turn")
    check(tuple(quarter * quarter.inverse()) == gjk.Quat.IDENTITY, "a rotation and its inverse")
    there = gjk.Pose((q16(1), 0, 0), quarter)
    check(tuple(there.apply((q16(1), 0, 0))) == (q16(1), q16(1), 0), "a point at a pose")
    check(tuple((there.inverse() * there).position) == (0, 0, 0), "a pose and its inverse")
    box = gjk.Collider(gjk.box(q16(1), q16(2), q16(3)), there)
    near = [abs(c - q16(n)) <= 2 for c, n in zip(box.aabb().upper, (3, 1, 3))]
    check(all(near), f"a bounding box {box.aabb()}")
    box.move((0, 0, 0))
    check(tuple(box.centre) == (0, 0, 0), "moved")


sys.exit(run(numbers, names, errors, lifetimes, motion, in_the_plane, poses))
