"""What the Python module does around ground of the plane: its kinds, queries, scenes, errors, lifetimes."""

import gc
import sys

import gjk
from checks import check, raises, run
from gjk import BodyKind, Detail, Event, Status, plane, q16
from gjk.plane import Pose, Tile

ONE = q16(1)
FORMS = {"#": Tile(4, 4), "/": Tile(0, 4), "-": Tile(4, 4, 0, True)}


def ball(x, y):
    return plane.Collider(plane.circle(q16(0.5)), Pose((x, y)))


def level():
    return plane.tiles(b"########" b"      ##", 8, ONE, FORMS)


def chain():
    ground = plane.chain([(x * ONE, 0) for x in range(50, -1, -1)])
    check(ground.within(ball(ONE, 2 * ONE), 2 * ONE) and not ground.within(ball(ONE, 2 * ONE), ONE), "within")
    check(ground.distance(ball(q16(10.5), ONE))[0] == 39, "the nearest segment")
    check(ground.distance(ball(q16(10.5), ONE))[1].distance == q16(0.5), "how near")
    check(ground.distance(ball(q16(10.5), -ONE)) is None, "from behind it is not there")
    segment, result = ground.cast(ball(q16(10.5), 3 * ONE), (q16(10.5), 0))
    check(segment == 39 and abs(result.rest_b.y - q16(0.5)) <= 2, "cast")
    check(ground.cast(ball(q16(10.5), -ONE), (q16(10.5), 3 * ONE)) is None, "up through it")
    segment, result = ground.cast_ray((q16(0.5), ONE), (q16(0.5), -ONE))
    check(segment == 49 and result.point_a.y == 0 and result.normal.y == gjk.Q30_ONE, "ray")
    check(ground.cast_ray((q16(0.5), -ONE), (q16(0.5), ONE)) is None, "a ray from behind")
    lifted = Pose((0, 2 * ONE))
    check(ground.within(ball(ONE, 2 * ONE), 0, lifted) and not ground.within(ball(ONE, 2 * ONE)), "at a pose")
    rake = plane.Collider(plane.box(20 * ONE, ONE), Pose((25 * ONE, ONE)))
    numbers = [contact.segment for contact in ground.contacts(rake, 5)]
    check(len(numbers) >= 40 and len(set(numbers)) == len(numbers), "more contacts than there was room for at first")
    check(all(len(contact.manifold) > 0 for contact in ground.contacts(rake, 5)), "each has points")


def profile():
    ground = plane.heights([0, 0, None, 100, 100], ONE, 10)
    check(ground.distance(ball(q16(0.5), ONE))[1].distance == q16(0.5), "a height of 0")
    check(ground.cast_ray((q16(3.5), 9 * ONE), (q16(3.5), -ONE))[1].point_a.y == 100 << 10, "one of 100 2^10 LSB")
    check(ground.cast_ray((q16(1.5), 9 * ONE), (q16(1.5), -ONE)) is None, "a hole")
    raises(OverflowError, plane.heights, [0, 40000], ONE)
    raises(gjk.Error, plane.heights, [0, None], ONE, status=Status.EMPTY)


def grid():
    ground = level()
    (contact,) = ground.contacts(ball(2 * ONE, q16(1.4)))
    check(contact.segment == 4 * 5 + 2, "a surface in one piece")
    check(contact.manifold.contact[0].distance == q16(1.4) - q16(1.5), "how deep")
    check(ground.cast(ball(4 * ONE, 3 * ONE), (9 * ONE, 3 * ONE)) is None, "over the wall")
    check(ground.cast(ball(4 * ONE, q16(1.6)), (9 * ONE, q16(1.6)))[0] == 4 * 14 + 3, "against the wall")
    ground.cells[14] = ord(" ")
    check(abs(ground.cast(ball(4 * ONE, q16(1.6)), (9 * ONE, q16(1.6)))[1].rest_b.x - q16(6.5)) <= 2, "a tile fewer")
    raises(ValueError, plane.tiles, b"###", 2, ONE, FORMS)
    raises(gjk.Error, plane.tiles, b"##", 2, 5, FORMS, status=Status.SIZE)
    raises(gjk.Error, plane.tiles, b"", 1, ONE, FORMS, status=Status.EMPTY)
    raises(gjk.Error, plane.Collider, ground.shape, status=Status.UNSUPPORTED)


def scenes():
    ground, disc = level(), plane.circle(q16(0.5))
    scene = plane.Scene([ground.shape, disc], bodies=2, detail=Detail.CONTACTS)
    floor = scene.add(0, user=5)
    coin = scene.add(disc, Pose((q16(2.5), q16(1.4))), BodyKind.DYNAMIC)
    (begin,) = scene.update()
    check((begin.event, begin.user_a, len(begin.manifold)) == (Event.BEGIN, 5, 1), "a coin on tiles")
    hit, result = scene.cast_ray((0, 3 * ONE), (0, 0))
    check(hit.user == 5 and result.point_a.y == ONE, "a ray in a scene")
    ground.cells[2] = ord(" ")
    check(scene.update() == [], "the scene is not told yet")
    scene.refilter(floor)
    (end,) = scene.update()
    check(end.event == Event.END and end.b == coin, "a tile gone")


def lifetimes():
    shapes = [plane.chain([(9 * ONE, 0), (0, 0)]).shape, plane.heights([0, 0], ONE).shape, level().shape]
    gc.collect()
    rays = []
    for shape in shapes:
        scene = plane.Scene([shape], bodies=1)
        scene.add(0)
        gc.collect()
        rays.append(scene.cast_ray((q16(0.5), 3 * ONE), (q16(0.5), -ONE))[1].point_a.y)
    check(rays == [0, 0, ONE], "a shape keeps its ground")


sys.exit(run(chain, profile, grid, scenes, lifetimes))
