"""What the Python module does around scenes: reports, full tables, wrong ids, saves, lifetimes."""

import gc
import sys

import gjk
from checks import check, raises, run
from gjk import BodyKind, Detail, Event, Pose, Status, q16

ONE = q16(1)


def pile(**config):
    """A scene of a floor, number 0, and a ball and a crate that may fall on it."""
    shapes = [gjk.box(q16(9), q16(9), q16(0.5)), gjk.sphere(q16(0.5)), gjk.box(q16(0.5), q16(0.5), q16(0.5))]
    scene = gjk.Scene(shapes, **{"bodies": 8, "detail": Detail.CONTACTS, **config})
    return scene, shapes, scene.add(0)


def reports():
    scene, shapes, floor = pile(persist=True, pair_words=2)
    crate = scene.add(shapes[2], Pose((0, 0, q16(0.9))), BodyKind.DYNAMIC, user=7)
    (begin,) = scene.update()
    check((begin.a, begin.b, begin.event) == (floor, crate, Event.BEGIN), "begin")
    check((begin.user_a, begin.user_b) == (0, 7), "user words")
    check(len(begin.manifold) == 4 and begin.distance == begin.manifold.contact[0].distance < 0, "contacts")
    check(list(begin.words) == [0, 0], "words are 0")
    before = scene.hash()
    begin.words[1] = 5
    check(scene.hash() != before, "words count")
    (persist,) = scene.update()
    check(persist.event == Event.PERSIST and list(persist.words) == [0, 5], "words stay")
    check([list(pair.words) for pair in scene.near()] == [[0, 5]], "near")
    check(len(scene.manifolds(persist)) == 1 and len(scene.manifolds(persist)[0]) == 4, "manifolds")
    state = scene.get(crate)
    check((state.kind, state.user, state.part_count, state.asleep) == (BodyKind.DYNAMIC, 7, 1, False), "state")
    scene.sleep(crate)
    check(scene.get(crate).asleep and scene.update() == [], "asleep")
    scene.wake(crate)
    scene.remove(crate)
    (end,) = scene.update()
    check(end.event == Event.END and end.b == crate and end.user_b == 0 and end.manifold is None, "end")
    check(scene.body_at(0) == floor and scene.body_at(1) is None and scene.stats().bodies == 1, "bodies by slot")
    check({floor: 1}[scene.body_at(0)] == 1, "an id is a key")


def many():
    """More reports, and more hits, than one call of the library gives."""
    scene = gjk.Scene([gjk.sphere(ONE)], bodies=20, pairs=200)
    for _ in range(20):
        scene.add(0, kind=BodyKind.DYNAMIC)
    found = scene.update()
    pairs = [(report.a.slot, report.b.slot) for report in found]
    check(len(pairs) == 190 and pairs == sorted(set(pairs)), "190 reports in order")
    scene = gjk.Scene([gjk.sphere(q16(0.25))], bodies=150)
    for i in range(150):
        scene.add(0, Pose((i * ONE, 0, 0)))
    hits = scene.cast_ray_all((-ONE, 0, 0), (200 * ONE, 0, 0))
    check([hit.body.slot for hit in hits] == list(range(150)), "150 hits in order")
    everything = gjk.Collider(gjk.box(q16(200), ONE, ONE))
    check(len(scene.within(everything)) == 150 and len(scene.box(everything.aabb())) == 150, "150 near")
    check(gjk.Scene([], bodies=1).update() == [], "a scene of nothing")


def motion():
    wall, ball = gjk.box(q16(0.05), q16(2), q16(2)), gjk.sphere(q16(0.01))
    scene = gjk.Scene([wall, ball], bodies=2)
    scene.add(wall)
    bullet = scene.add(ball, Pose((q16(-8), 0, 0)), BodyKind.DYNAMIC)
    scene.set_motion(bullet, gjk.BodyMotion.FAST)
    check(scene.update() == [], "nothing yet")
    scene.move(bullet, Pose((q16(8), 0, 0)))
    (impact,) = scene.update()
    check(impact.event == Event.IMPACT and impact.a == bullet and 0 < impact.fraction < gjk.Q30_ONE // 2, "impact")
    check(impact.words is None, "an impact has no words")


def queries():
    scene, shapes, floor = pile()
    crate = scene.add([shapes[2], (shapes[1], Pose((0, 0, ONE)))], Pose((0, 0, q16(5))), BodyKind.DYNAMIC, user=3)
    start, end = (0, 0, q16(9)), (0, 0, q16(-9))
    hit, result = scene.cast_ray(start, end)
    check((hit.body, hit.part, hit.user, result.point_a.z) == (crate, 1, 3, q16(6.5)), "ray")
    hit, result = scene.cast_ray(start, end, gjk.SceneFilter(ignore=crate))
    check(hit.body == floor and result.point_a.z == q16(0.5), "a ray that ignores a body")
    check(scene.cast_ray(start, end, gjk.SceneFilter(category=2, mask=2)) is None, "a ray that sees nothing")
    check(scene.cast_ray(start, (0, 0, q16(8))) is None, "a ray that is too short")
    ball = gjk.Collider(shapes[1], Pose((q16(4), 0, q16(3))))
    hit, result = scene.cast(ball, (q16(4), 0, 0))
    check(hit.body == floor and abs(result.rest_b.z - ONE) <= 2, "cast")
    hit, distance = scene.nearest(ball, q16(9))
    check(hit.body == floor and distance == q16(2), "nearest")
    check(scene.nearest(ball, q16(9), ignore=floor)[0].body == crate and scene.nearest(ball, 1) is None, "else")
    check(gjk.distance(scene.collider(crate, 1), ball).distance > 0, "a part as a collider")
    scene.move(floor, Pose((0, 0, ONE)))
    check(scene.cast(ball, (q16(4), 0, 0))[1].rest_b.z >= q16(2), "queries see moves at once")


def full():
    """Every table of a scene is full once."""
    scene, shapes, floor = pile(bodies=2, pairs=1)
    scene.add(1, Pose((0, 0, q16(0.5))), BodyKind.DYNAMIC)
    before = scene.hash()
    raises(gjk.Error, scene.add, 1, status=Status.CAPACITY)
    raises(gjk.Error, scene.add, 1, slot=2, status=Status.CAPACITY)
    check(scene.hash() == before and len(scene.update()) == 1, "a full scene goes on")
    scene, shapes, floor = pile(parts=2, own_poses=1)
    raises(gjk.Error, scene.add, [1, 1], status=Status.CAPACITY)
    posed = (1, Pose((ONE, 0, 0)))
    scene.remove(floor)
    raises(gjk.Error, scene.add, [posed, posed], status=Status.CAPACITY)
    body = scene.add([1, posed])
    raises(gjk.Error, scene.set_motion, body, gjk.BodyMotion.FAST, status=Status.RANGE)
    scene, shapes, floor = pile(pairs=1, motions=0)
    bodies = [scene.add(1, kind=BodyKind.DYNAMIC) for _ in range(2)]
    raises(gjk.Error, scene.update, status=Status.CAPACITY)
    raises(gjk.Error, scene.set_motion, bodies[0], gjk.BodyMotion.FAST, status=Status.CAPACITY)
    scene.remove(bodies[0])
    check([report.b for report in scene.update()] == bodies[1:], "an update after one that did not fit")
    # Depths without memory are bounds, and are counted.
    cube = gjk.hull([(x, y, z) for x in (0, ONE) for y in (0, ONE) for z in (0, ONE)])
    for cells, unsettled in ((0, 1), (1, 1), (1000, 0)):
        scene = gjk.Scene([cube], bodies=2, detail=Detail.DEPTH, workspace_cells=cells)
        scene.add(0)
        scene.add(0, Pose((q16(0.5), q16(0.1), q16(0.1))), BodyKind.DYNAMIC)
        (report,) = scene.update()
        check(report.distance <= q16(-0.5) and scene.stats().unsettled == unsettled, f"a depth with {cells} cells")


def wrong():
    """Ids, shapes, numbers that are none: an error, and the scene as it was."""
    scene, shapes, floor = pile()
    crate = scene.add(2, Pose((0, 0, q16(0.9))), BodyKind.DYNAMIC)
    scene.update()
    stale = scene.add(1, Pose((0, 0, q16(9))))
    scene.remove(stale)
    before = scene.hash()
    for id in (stale, gjk.BodyId(), gjk.BodyId(1 << 20, 1), gjk.BodyId(0, 3)):
        for call in (scene.remove, scene.sleep, scene.wake, scene.get, scene.collider):
            raises(gjk.Error, call, id, status=Status.BODY_ID)
        raises(gjk.Error, scene.move, id, Pose(), status=Status.BODY_ID)
        raises(gjk.Error, scene.set_user, id, 1, status=Status.BODY_ID)
    raises(gjk.Error, scene.body_at, 8, status=Status.RANGE)
    raises(gjk.Error, scene.add, 3, status=Status.RANGE)
    raises(gjk.Error, scene.add, [], status=Status.EMPTY)
    raises(gjk.Error, scene.add, 1, slot=crate.slot, status=Status.BODY_ID)
    raises(gjk.Error, scene.add, 1, Pose(rotation=(0, 0, 0, 5)), status=Status.ROTATION)
    raises(gjk.Error, scene.move, crate, Pose(rotation=(0, 0, 0, 5)), status=Status.ROTATION)
    raises(gjk.Error, scene.set_shape, crate, 1, 0, status=Status.RANGE)
    raises(gjk.Error, scene.set_shape, crate, 0, 3, status=Status.RANGE)
    raises(gjk.Error, scene.collider, crate, 1, status=Status.RANGE)
    raises(gjk.Error, scene.nearest, gjk.Collider(shapes[1]), -1, status=Status.NEGATIVE)
    raises(ValueError, scene.add, gjk.sphere(ONE))
    raises(OverflowError, scene.add, 1 << 16)
    raises(OverflowError, scene.add, 1, mask=1 << 32)
    raises(Exception, scene.move, None, Pose())
    raises(Exception, scene.move, crate, None)
    check(scene.hash() == before, "what is refused changes nothing")
    for config in ({"bodies": 0}, {"bodies": 1 << 21}, {"bodies": 1, "pairs": 0}, {"bodies": 1, "pair_words": 33}):
        raises(gjk.Error, gjk.Scene, shapes, status=Status.RANGE, **config)
    raises(OverflowError, gjk.Scene, shapes, bodies=1 << 32)
    raises(OverflowError, gjk.Scene, shapes, bodies=-1)


def saves():
    scene, shapes, floor = pile(persist=True, pair_words=1)
    crate = scene.add(2, Pose((0, 0, q16(0.9))), BodyKind.DYNAMIC)
    (report,) = scene.update()
    save, hash = scene.save(), scene.hash()

    def play():
        for _ in range(3):
            scene.move(crate, Pose((0, 0, scene.get(crate).pose.position.z + 9000)))
            scene.update()
        return scene.hash()

    played = play()
    scene.load(save)
    check(scene.hash() == hash != played and play() == played, "back and on again")
    report.words[0] = 9  # of the block that is no longer the scene's
    check(scene.hash() == played, "an old report does not reach a loaded scene")
    other, _, _ = pile(persist=True, pair_words=1)
    other.load(save)
    check(other.hash() == hash and other.get(crate).kind == BodyKind.DYNAMIC, "a save in another scene")
    # Cut off, longer, or with a byte changed anywhere: refused, and the scene goes on.
    raises(gjk.Error, scene.load, save[:-4], status=Status.CAPACITY)
    raises(gjk.Error, scene.load, save + bytes(4), status=Status.CAPACITY)
    raises(gjk.Error, scene.load, b"", status=Status.CAPACITY)
    raises(gjk.Error, scene.load, bytes(len(save)), status=Status.CORRUPT)
    for at in range(0, len(save), 97):
        broken = save[:at] + bytes([save[at] ^ 1]) + save[at + 1 :]
        raises(gjk.Error, scene.load, broken)
    check(scene.hash() == played, "after saves that are none")
    fewer = gjk.Scene(shapes[:2], bodies=8, detail=Detail.CONTACTS, persist=True, pair_words=1)
    raises(gjk.Error, fewer.load, save, status=Status.RANGE)


def lifetimes():
    """Shapes live as long as a scene, and a scene's memory as long as a report, an id or a collider of it."""

    def make():
        cube = [(x, y, z) for x in (-ONE, ONE) for y in (-ONE, ONE) for z in (-ONE, ONE)]
        hill = gjk.Mesh([(-9 * ONE, -9 * ONE, 0), (9 * ONE, -9 * ONE, 0), (0, 9 * ONE, 0)], [(0, 1, 2)])
        scene = gjk.Scene(
            [gjk.hull_build(cube), gjk.concave(hill)], bodies=2, detail=Detail.CONTACTS, pair_words=1, persist=True
        )
        scene.add(1)
        return scene, scene.add(0, Pose((0, 0, q16(0.9))), BodyKind.DYNAMIC)

    def litter():
        gc.collect()
        return [bytearray(300) for _ in range(3000)]

    scene, cube = make()
    junk = [litter()]
    (report,) = scene.update()
    check(len(report.manifold) == 4 and report.distance == q16(-0.1), "shapes that only the scene has")
    manifold, words, collider, save = report.manifold, report.words, scene.collider(cube), scene.save()
    contacts = [tuple(contact.point_a) for contact in manifold]
    del scene, report
    junk.append(litter())
    words[0] = 3
    check([tuple(contact.point_a) for contact in manifold] == contacts and words[0] == 3, "a report without its scene")
    check(gjk.distance(collider, gjk.Collider(gjk.point(), Pose((5 * ONE, 0, ONE)))).distance == 4 * ONE, "a collider")
    scene, _ = make()
    scene.load(save)
    del save
    junk.append(litter())
    check(scene.update()[0].distance == q16(-0.1), "a scene without the save that it has loaded")


sys.exit(run(reports, many, motion, queries, full, wrong, saves, lifetimes))
