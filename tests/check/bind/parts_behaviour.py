"""Bodies of many parts, hulls and masses through the Python module, against pairs and plain numbers. Prints what is
wrong."""

import gc
import itertools
import random
import sys

import gjk
from checks import check, raises, run
from gjk import Pose, Status, q16

ONE = q16(1)
CUBE = [(x * ONE, y * ONE, z * ONE) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
QUARTERS = [(0, 0, 0), (9, 0, 0), (9, 9, 0), (0, 9, 3)]
SEED = 5


def surface():
    return gjk.Mesh([[c * ONE for c in vertex] for vertex in QUARTERS], [(0, 1, 2), (0, 2, 3)])


def ground():
    rows = [[0, 16, 32, 16], [0, None, 32, 0], [16, 16, 16, 16]]
    return gjk.HeightField(rows, ONE, ONE, q16(1 / 32))


def chair():
    return gjk.Compound([gjk.box(ONE, ONE, ONE // 8), (gjk.box(ONE // 8, ONE, ONE), Pose((-ONE, 0, ONE)))])


def shown(answer):
    """What is valid of an answer about distances, for comparing."""
    points = () if answer.intersecting else (*answer.point_a, *answer.point_b, *answer.normal)
    return answer.intersecting, answer.distance, answer.certificate.pairs, points


def answers():
    """Every answer is the one of the pair with the part that is named, and no part has a better one."""
    numbers = random.Random(SEED)
    touching = hits = 0
    for body, _ in itertools.product((surface(), ground(), chair()), range(40)):
        body.pose = Pose([numbers.randrange(-ONE, ONE) for _ in range(3)])
        at, to = ([numbers.randrange(-2 * ONE, 3 * ONE) for _ in range(3)] for _ in range(2))
        ball = gjk.Collider(gjk.hull(CUBE, radius=q16(0.1)), Pose(at))
        parts = {}
        for number in range(len(body)):
            try:
                parts[number] = body.place(number)
            except gjk.Error as error:
                check(error.status == Status.RANGE, "a hole is no part")
        where = f"seed {SEED}, {type(body).__name__} at {body.pose}, B at {at}, to {to}"

        def ask(query, *more, parts=parts, ball=ball, **named):
            return {number: query(part, ball, *more, **named) for number, part in parts.items()}

        gap, gaps = body.distance(ball), ask(gjk.distance)
        least = min(gaps, key=lambda number: (gaps[number].distance, number))
        check(gap.part == least and shown(gap) == shown(gaps[least]), f"distance, {where}")
        gjk.check_distance(parts[gap.part], ball, gap)
        check(body.intersect(ball).yes == gap.intersecting, f"intersect, {where}")
        for most in (gap.distance, gap.distance + 1):
            nearer = [number for number, decision in ask(gjk.within, most).items() if decision]
            check(body.within(ball, most).part == min(nearer, default=None), f"within, {where}")
        depth = body.penetration(ball)
        check(depth.intersecting == gap.intersecting == (depth.part is not None), f"penetration, {where}")
        if gap.intersecting:
            touching += 1
            depths = {number: pair.depth for number, pair in ask(gjk.penetration).items() if pair.intersecting}
            check(depths[depth.part] == depth.depth == max(depths.values()), f"the deepest, {where}")
        touched = [number for number, manifold in ask(gjk.contacts, q16(0.1)).items() if len(manifold) > 0]
        found = [contact.part for contact in body.contacts(ball, q16(0.1))]
        # A surface has no contacts behind it.
        check(found == touched if isinstance(body, gjk.Compound) else set(found) <= set(touched), f"contacts, {where}")
        met = [(hit.fraction, not hit.inside, number) for number, hit in ask(gjk.cast, to_b=to).items() if hit]
        hit = body.cast(ball, to_b=to)
        check(hit.part == (min(met)[2] if met else None), f"cast, {where}")
        hits += hit.hit
        ray = body.cast_ray(at, to)
        check(ray.hit == any(gjk.cast_ray(part, at, to) for part in parts.values()), f"ray, {where}")
    check(30 < touching < 90 and 40 < hits < 110, f"seed {SEED}: {touching} of 120 touch, {hits} hit")


def surfaces():
    mesh = surface()
    corners = sorted(sorted(mesh.triangle(part)) for part in range(len(mesh)))
    check(corners == [[0, 1, 2], [0, 2, 3]], "the triangles")
    report = gjk.mesh_check(mesh)
    check(report.fault == gjk.MeshFault.SOUND and list(report.edges) == [2, 0, 0, 4], "a sound mesh")
    twice = gjk.Mesh([(0, 0, 0), (9, 0, 0), (0, 9, 0)], [(0, 1, 2), (0, 1, 2)])
    check(gjk.mesh_check(twice).fault == gjk.MeshFault.TURNED, "a triangle twice")
    flat = gjk.HeightField([[0] * 20 for _ in range(20)], ONE, ONE, 1)
    crate = gjk.Collider(gjk.box(4 * ONE, 4 * ONE, ONE), Pose((9 * ONE, 9 * ONE, q16(0.9))))
    (manifold,) = flat.manifolds(crate)
    check(tuple(manifold.normal) == (0, 0, gjk.Q30_ONE) and len(manifold) == 4, "no ghosts on flat ground")
    check(len(flat) == 722 and len(flat.contacts(crate)) > 16, "more manifolds than one call gives")
    check(ground().cast_ray((q16(2.2), q16(0.5), ONE), (q16(2.2), q16(0.5), -ONE)).hit, "a ray on ground")
    check(not ground().cast_ray((q16(1.1), q16(1.1), ONE), (q16(1.1), q16(1.1), -ONE)).hit, "a ray through a hole")
    scene = gjk.Scene([gjk.concave(surface()), gjk.concave(chair())], bodies=2, detail=gjk.Detail.CONTACTS)
    scene.add(0)
    scene.add(1, Pose((6 * ONE, 3 * ONE, 0)), gjk.BodyKind.DYNAMIC)
    (report,) = scene.update()
    check(len(scene.manifolds(report)) >= 1, "two concave bodies")


def refused():
    raises(gjk.Error, gjk.Mesh, [(0, 0, 0)], [], status=Status.EMPTY)
    raises(gjk.Error, gjk.Mesh, [(0, 0, 0)], [(0, 0, 1)], status=Status.RANGE)
    raises(OverflowError, gjk.Mesh, [(0, 0, 0)], [(0, 0, 1 << 28)])
    raises(ValueError, gjk.Mesh, [(0, 0, 0)], [(0, 0)])
    raises(IndexError, surface().triangle, 2)
    raises(gjk.Error, gjk.HeightField, [], ONE, ONE, 1, status=Status.RANGE)
    raises(gjk.Error, gjk.HeightField, [[0, None]] * 2, ONE, ONE, 1, status=Status.EMPTY)
    raises(gjk.Error, gjk.HeightField, [[0, 0]] * 2, ONE, ONE, 0, status=Status.RANGE)
    raises(ValueError, gjk.HeightField, [[0, 0], [0]], ONE, ONE, 1)
    raises(OverflowError, gjk.HeightField, [[0, -32768]] * 2, ONE, ONE, 1)
    raises(gjk.Error, gjk.Compound, [], status=Status.EMPTY)
    raises(gjk.Error, gjk.Compound, [(gjk.point(), Pose(rotation=(0, 0, 0, 5)))], status=Status.ROTATION)
    raises(gjk.Error, gjk.Compound, [gjk.point()] * 32768, status=Status.SIZE)
    raises(gjk.Error, gjk.concave, gjk.Mesh([(0, 0, 0), (1 << 30, 0, 0), (1 << 30, 9, 9)], [(0, 0, 0)] + [(1, 1, 2)]),
           status=Status.SIZE)  # fmt: skip
    raises(gjk.Error, gjk.Collider, gjk.concave(surface()), status=Status.UNSUPPORTED)
    ball = gjk.Collider(gjk.sphere(ONE))
    body = surface()
    raises(gjk.Error, body.place, 2, status=Status.RANGE)
    raises(gjk.Error, body.within, ball, -1, status=Status.NEGATIVE)
    raises(gjk.Error, body.contacts, ball, most=9, status=Status.RANGE)
    body.pose.rotation.w = 5
    raises(gjk.Error, body.distance, ball, status=Status.ROTATION)
    # Too little memory for a depth: a bound, with its part.
    deep = gjk.Compound([gjk.hull(CUBE)])
    cube = gjk.Collider(gjk.hull(CUBE), Pose((ONE, ONE // 9, 0)))
    exact = deep.penetration(cube).depth
    for cells in (0, 1, 2, 8):
        memory = gjk.Workspace(cells=cells)
        error = raises(gjk.Error, deep.penetration, cube, memory, status=Status.CAPACITY)
        check(error.result.part == 0 and error.result.depth >= exact, f"a depth with {cells} cells")
        error = raises(gjk.Error, deep.contacts, cube, workspace=memory, status=Status.CAPACITY)
        check(len(error.result) == 1, f"contacts with {cells} cells")


def solids():
    shape = gjk.hull_build([(0, 0, 0)] + CUBE * 2, radius=5)
    vertices, faces = shape.polyhedron()
    check(sorted(vertices) == sorted(CUBE) and len(faces) == 6 and {len(f) for f in faces} == {4}, "the hull of a cube")
    check(gjk.hull_check(vertices, faces).fault == gjk.HullFault.SOUND and shape.convex_radius == 5, "its faces")
    check(gjk.hull_check(vertices, faces[1:]).fault == gjk.HullFault.OPEN, "a face is missing")
    turned = gjk.hull_check(vertices, [faces[0][::-1]] + faces[1:])
    check((turned.fault, turned.face) == (gjk.HullFault.BEYOND, 0), "a face is turned")
    check(gjk.hull_check(vertices, [[0, 1, 9]]).fault == gjk.HullFault.NUMBER, "a vertex that is none")
    check(gjk.hull_check(vertices, []).fault == gjk.HullFault.FEW, "no faces")
    crate = gjk.Collider(shape)
    check(len(gjk.contacts(crate, gjk.Collider(shape, Pose((0, 0, q16(1.9)))))) == 4, "contacts of a built hull")
    circle = [(i, i * i, 0) for i in range(-150, 150)]
    vertices, faces = gjk.hull_build(circle).polyhedron()
    check(len(vertices) == 300 and len(faces) > 2 and gjk.hull_check(vertices, faces).fault == 0, "a face that is cut")
    for flat, corners in (([(1, 2, 3)] * 4, 1), ([(i, i, 2 * i) for i in range(9)], 2)):
        shape = gjk.hull_build(flat)
        check(shape.count == corners and shape.polyhedron()[1] is None, "points in a line")
    check(gjk.hull_build(CUBE, faces=False).polyhedron()[1] is None, "no faces are wanted")
    raises(gjk.Error, gjk.hull_build, [], status=Status.EMPTY)
    raises(gjk.Error, gjk.hull_build, [(0, 0, 0), (1 << 30, 0, 0)], status=Status.SIZE)
    raises(Exception, gjk.hull_build, [(0, 0, 0)] * 65536)
    raises(OverflowError, gjk.hull_check, CUBE, [[0, 1, 65536]])
    raises(TypeError, gjk.hull_build, [(0.5, 0, 0)])
    vertices, excess = gjk.hull_simplify(circle + [(0, 0, 900)], 8)
    check(4 <= len(vertices) <= 8 and excess > 0, "a simpler hull")
    check(gjk.hull_simplify(CUBE, 8)[1] == 0, "a hull that is simple")
    raises(gjk.Error, gjk.hull_simplify, CUBE, 3, status=Status.RANGE)


def masses():
    cube = gjk.mass(gjk.hull_build(CUBE), density=q16(700))
    check(int(cube.volume) == 8 << 48 and cube.mass == q16(5600) and tuple(cube.centre) == (0, 0, 0), "a cube")
    # Of a cube with sides of 2 units: (2^2 + 2^2) / 12 square units.
    check(cube.inertia.xx == round(2 / 3 * (1 << 32)) and cube.inertia.xy == 0, "its inertia")
    check(cube == gjk.mass(gjk.box(ONE, ONE, ONE), q16(700)), "the same of a box")
    body = gjk.Mass()
    for at in (-ONE, ONE):
        body.add(cube, Pose((at, 0, 0)))
    check(int(body.volume) == 16 << 48 and body.mass == 2 * cube.mass and body.centre.x == 0, "two cubes")
    moments = body.principal().moment
    check(moments[0] < moments[1] and abs(moments[1] - moments[2]) <= 8, "principal axes")
    check(list(gjk.Mass().principal().moment) == [0, 0, 0], "axes of nothing")
    raises(gjk.Error, gjk.mass, gjk.hull(CUBE), status=Status.UNSUPPORTED)
    raises(gjk.Error, cube.set_density, (1 << 32) - 1, status=Status.RANGE)
    raises(gjk.Error, body.add, gjk.Mass(), status=Status.RANGE)
    raises(gjk.Error, body.add, body, status=Status.OVERLAP)


def lifetimes():
    """What a body is made of lives as long as it does, and as a collider of a part."""
    makers = (surface, ground, chair)
    ball = gjk.Collider(gjk.sphere(q16(0.5)), Pose((ONE // 3, ONE // 4, 3 * ONE)))
    before = {make: make().distance(ball).distance for make in makers}
    bodies = {make: make() for make in makers}
    places = {make: make().place(len(make()) - 1) for make in makers}
    one = {make: gjk.distance(make().place(len(make()) - 1), ball).distance for make in makers}
    gc.collect()
    junk = [bytearray(n) for n in range(20, 600) for _ in range(20)]
    for make in makers:
        check(bodies[make].distance(ball).distance == before[make], f"{make.__name__} lives")
        check(gjk.distance(places[make], ball).distance == one[make], f"a part of {make.__name__} lives")
    check(len(junk) > 0, "junk")


sys.exit(run(answers, surfaces, refused, solids, masses, lifetimes))
