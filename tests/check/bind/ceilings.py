"""With a library whose ceiling on iterations is low: ceilings.py SAVE. What the Python module says of balls around a
drum, against the distance by its formula. It does not load SAVE, of a scene with another ceiling. Prints what is wrong.

With the usual ceiling it writes SAVE."""

import math
import random
import sys

import gjk
from checks import check, raises, run
from gjk import Detail, Pose, Status, q16

SEED, ROUNDING = 9, 4
MAX = gjk.constant("GJK_ITERATIONS_MAX")
drum, ball = gjk.cylinder(q16(1), q16(1)), gjk.sphere(q16(0.5))


def places():
    """Positions of the ball around the drum at the origin, and the distances, in LSB; 0: they overlap."""
    numbers = random.Random(SEED)
    for _ in range(200):
        at = [numbers.randrange(q16(-3), q16(3)) for _ in range(3)]
        beside, above = max(math.hypot(at[0], at[1]) - q16(1), 0), max(abs(at[2]) - q16(1), 0)
        yield at, max(math.hypot(beside, above) - q16(0.5), 0)


def asked(query, *arguments):
    """The answer, and whether it is settled."""
    try:
        return query(*arguments), True
    except gjk.Error as error:
        check(error.status == Status.ITERATION_LIMIT, error)
        return error.result, False


def pairs():
    a, b = gjk.Collider(drum), gjk.Collider(ball)
    body = gjk.Compound([drum])
    unsettled = 0
    for at, exact in places():
        b.move(at)
        for query in (lambda: gjk.distance(a, b), lambda: body.distance(b)):
            gap, settled = asked(query)
            unsettled += not settled
            check(gap.lower <= exact + ROUNDING and gap.upper >= exact - ROUNDING, f"seed {SEED}: bounds at {at}")
            check(not settled or abs(gap.distance - exact) <= ROUNDING, f"seed {SEED}: the distance at {at}")
            check(gap.iterations <= MAX, "iterations")
        decision, settled = asked(gjk.intersect, a, b)
        sure = exact > ROUNDING
        check(not settled or decision.yes != sure or exact < 2 * ROUNDING, f"seed {SEED}: the decision at {at}")
        decision, settled = asked(body.intersect, b)
        check(settled or decision.part is None, "no part without an answer")
    check(10 < unsettled < 400, f"seed {SEED}: {unsettled} of 400 distances are open")


def make_scene():
    return gjk.Scene([drum, ball], bodies=2, detail=Detail.DISTANCE, persist=True)


def scenes():
    """Nothing that touches is missed, and what is not settled is counted."""
    scene = make_scene()
    scene.add(0)
    body, near, unsettled = scene.add(1, kind=gjk.BodyKind.DYNAMIC), 0, 0
    for at, exact in places():
        scene.move(body, Pose(at))
        touching = [report for report in scene.update() if report.event != gjk.Event.END]
        near += len(touching)
        unsettled += scene.stats().unsettled
        check(len(touching) == 1 or exact > 0, f"seed {SEED}: a pair that touches at {at}")
        check(all(report.distance <= exact + ROUNDING for report in touching), f"seed {SEED}: the bound at {at}")
        try:
            met = scene.cast_ray(at, (0, 0, 0), gjk.SceneFilter(ignore=body))
            check(met is not None, "a ray to the middle")
        except gjk.Error as error:
            check(error.status == Status.ITERATION_LIMIT and error.result.body.slot == 0, "a ray that is open")
    check(near > 10 and (unsettled > 0 or MAX > 2), f"seed {SEED}: {near} of 200 near, {unsettled} open")
    with open(sys.argv[1], "rb") as file:
        raises(gjk.Error, scene.load, file.read(), status=Status.CORRUPT)


def save():
    with open(sys.argv[1], "wb") as file:
        file.write(make_scene().save())


sys.exit(run(save) if MAX > 100 else run(pairs, scenes))
