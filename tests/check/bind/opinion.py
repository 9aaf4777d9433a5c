"""Second opinions against brute force in rational numbers: opinion.py [SEED]. With numpy, batches, too."""

import itertools
import math
import os
import random
import sys
import tempfile
from fractions import Fraction as F

import gjk
from checks import check, raises, run

SEED = int(sys.argv[1]) if len(sys.argv) > 1 else int.from_bytes(os.urandom(3), "big")
dice = random.Random(SEED)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def nearest(points):
    """The point of the affine hull of up to three points that is nearest to 0, if it lies between them."""
    p = points[0]
    edges = [minus(q, p) for q in points[1:]]
    if not edges:
        return p
    if len(edges) == 1:
        n = dot(edges[0], edges[0])
        weights = [-dot(p, edges[0]) / n] if n else [F(2)]
    else:
        a, b, c = dot(edges[0], edges[0]), dot(edges[0], edges[1]), dot(edges[1], edges[1])
        n = a * c - b * b
        d, e = -dot(p, edges[0]), -dot(p, edges[1])
        weights = [(d * c - e * b) / n, (e * a - d * b) / n] if n else [F(2)]
    if min(weights) < 0 or sum(weights) > 1:
        return None
    return [x + sum(w * e[i] for w, e in zip(weights, edges)) for i, x in enumerate(p)]


def signed_square(a, b):
    """The square of the gap of two tetrahedra, or minus the square of the depth: exact."""
    difference = [minus(q, p) for p in a for q in b]
    found = (nearest(s) for k in (1, 2, 3) for s in itertools.combinations(difference, k))
    best = min((p for p in found if p is not None), key=lambda p: dot(p, p))
    square = dot(best, best)
    if square > 0 and all(dot(best, w) >= square for w in difference):
        return square
    depth = None
    for s in itertools.combinations(difference, 3):
        n = cross(minus(s[1], s[0]), minus(s[2], s[0]))
        h = dot(n, s[0])
        if h < 0:
            n, h = [-x for x in n], -h
        if any(n) and all(dot(n, w) <= h for w in difference):
            depth = min(x for x in (depth, h * h / dot(n, n)) if x is not None)
    return -depth


def exactly(shape, pose):
    """The vertices in the world as rational numbers, by a way of their own: p + v + 2 u x (u x v + w v) / |q|^2."""
    x, y, z, w = (F(c) for c in pose[3:])
    u, n = [x, y, z], x * x + y * y + z * z + w * w
    out = []
    for v in ([F(c) for c in v] for v in shape):
        t = [s + w * c for s, c in zip(cross(u, v), v)]
        out.append([F(p) + c + 2 * s / n for p, c, s in zip(pose, v, cross(u, t))])
    return out


def holds(lower, upper, square):
    """Is a signed square that of a number between two floats?"""
    if math.isinf(lower):
        return square <= 0 <= upper
    low, high = F(lower), F(upper)
    signed = lambda x: x * abs(x)
    return signed(low) <= square <= signed(high)


def tetrahedron(size):
    return [[dice.uniform(-size, size) for _ in range(3)] for _ in range(4)]


def pose_of(reach):
    return [dice.uniform(-reach, reach) for _ in range(3)] + [dice.uniform(-1, 1) for _ in range(4)]


def single():
    told = {True: 0, False: 0, None: 0}
    for i in range(36):
        size = 10.0 ** dice.choice([-6, 0, 6])
        a, b = tetrahedron(size), tetrahedron(size)
        pose_a, pose_b = pose_of(size / 10), pose_of(size / 10 if i % 2 else 3 * size)
        if i % 3:  # all but touching
            answer = gjk.second_opinion(a, b, pose_a, pose_b)
            by = (answer.lower + answer.upper) / 2 + dice.uniform(-3, 3) * answer.resolution
            pose_b[:3] = [p - by * n for p, n in zip(pose_b, answer.normal)]
        answer = gjk.second_opinion(a, b, pose_a, pose_b)
        square = signed_square(exactly(a, pose_a), exactly(b, pose_b))
        check(holds(answer.lower, answer.upper, square), f"case {i}: {answer}, but {float(square)} squared")
        check(answer.touching in (None, square <= 0), f"case {i}: touching")
        check(answer.upper - answer.lower < 10 * answer.resolution, f"case {i}: wide bounds")
        check(answer.resolution < 1e-7 * size, f"case {i}: resolution")
        for point, shape, pose in ((answer.point_a, a, pose_a), (answer.point_b, b, pose_b)):
            off = signed_square(exactly(shape, pose), [[F(x) for x in point]])
            check(off <= F(answer.within) ** 2, f"case {i}: a point is {float(off)} squared from its shape")
        check(answer.within < 4 * answer.resolution, f"case {i}: points")
        told[answer.touching] += 1
    check(min(told.values()) > 2, f"the mix of cases: {told}")


def exact():
    """What Q16.16 can hold is not rounded."""
    answer = gjk.second_opinion((1, 1, 1), (1, 1, 1), None, (2.25, 0, 0))
    check(answer.touching is False and abs(answer.lower - 0.25) < 2 * answer.resolution, f"{answer}")
    check(answer.upper - answer.lower <= answer.resolution, f"{answer}")
    check(str(gjk.second_opinion((1, 1, 1), (1, 1, 1), None, (2, 0, 0))) == "touching", "touching")
    answer = gjk.second_opinion([(0, 0, 0)], [(3, 4, 0)], radius_a=1, radius_b=1.5)
    check(answer.lower <= 2.5 <= answer.upper and abs(answer.normal[0] - 0.6) < 1e-8, f"{answer}")
    matrix = [[0, -1, 0, 5], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    answer = gjk.second_opinion((1, 2, 3), (1, 1, 1), None, matrix)
    check(answer.lower <= 3 <= answer.upper, f"{answer}")
    huge = gjk.second_opinion((1e200, 1e200, 1e200), (1e200, 1e200, 1e200), None, (3e200, 0, 0))
    check(not huge.touching, f"{huge}")


class Mesh:
    vertices, is_convex = [(0, 0, 0), (1, 0, 0), (0, 1, 0)], True


def errors():
    check(gjk.second_opinion(Mesh(), [(0, 0, 2)]).upper >= 2, "a mesh")
    bent = Mesh()
    bent.is_convex = False
    box = (1, 1, 1)

    def refused(*arguments, **named):
        try:
            gjk.second_opinion(*arguments, **named)
        except ValueError as error:
            return str(error)
        return ""

    for said, arguments in (
        ("not convex", (bent, box)), ("0 vertices", ([], box)), ("nan", ([(0, 0, math.nan)], box)),
        ("three numbers", ([(0, 0)], box)), ("quaternion is 0", (box, box, (0, 0, 0, 0, 0, 0, 0))),
        ("4 x 4", (box, box, (0, 0))), ("inf", (box, box, None, (math.inf, 0, 0))),
    ):  # fmt: skip
        check(said in refused(*arguments), f"{said}: {refused(*arguments)}")
    check("negative" in refused(box, box, radius_a=-1), "a negative radius")


def batches():
    numpy_random = numpy.random.default_rng(SEED)
    a, b = tetrahedron(1.0), tetrahedron(1.0)
    poses_a, poses_b = (numpy.array([pose_of(1.0) for _ in range(30)]) for _ in range(2))
    answers = gjk.second_opinions(a, b, poses_a, poses_b)
    for i in range(30):
        square = signed_square(exactly(a, poses_a[i]), exactly(b, poses_b[i]))
        check(holds(answers.lower[i], answers.upper[i], square), f"pair {i} of a batch")
    check(0 < (answers.touching == 1).sum() < 30, f"the mix of pairs: {answers.touching}")
    without = gjk.second_opinions(a, b, poses_a, poses_b, depths=False)
    apart = answers.touching == 0
    check((without.lower[apart] == answers.lower[apart]).all(), "without depths: apart")
    check(numpy.isinf(without.lower[~apart]).all(), "without depths: touching")

    # Boxes, one standing; many poses at once agree with single ones.
    half = (1.0, 0.5, 0.1)
    poses = numpy.hstack([numpy_random.uniform(-2, 2, (2000, 3)), numpy_random.normal(size=(2000, 4))])
    answers = gjk.second_opinions(half, half, None, poses)
    for i in range(0, 2000, 40):
        one = gjk.second_opinion(half, half, None, poses[i])
        check(answers.lower[i] <= one.lower and one.upper <= answers.upper[i], f"box {i}")
    matrices = numpy.zeros((3, 4, 4))
    matrices[:, 3, 3] = 1
    matrices[:, :3, :3] = [numpy.eye(3), [[0, -1, 0], [1, 0, 0], [0, 0, 1]], [[-1, 0, 0], [0, -1, 0], [0, 0, 1]]]
    matrices[:, 0, 3] = 5
    turned = gjk.second_opinions((1, 1, 1), (1, 2, 3), None, matrices)
    gaps = zip(turned.lower, (3, 2, 3), turned.upper)
    check(all(low <= gap <= high for low, gap, high in gaps), f"matrices: {turned}")
    scaled = poses.copy()
    scaled[:, 3:] *= 10.0 ** numpy_random.integers(-200, 200, (2000, 1))
    again = gjk.second_opinions(half, half, None, scaled)
    check((again.lower <= answers.upper).all() and (answers.lower <= again.upper).all(), "quaternions of any length")
    scaled[7, 3:] = 0
    raises(ValueError, gjk.second_opinions, half, half, None, scaled)
    raises(ValueError, gjk.second_opinions, half, half, poses, poses[:3])
    raises(ValueError, gjk.second_opinions, half, half, None, 2 * matrices)
    raises(ValueError, gjk.second_opinions, half, half, None, poses * numpy.nan)

    # What another library says.
    said = numpy.maximum((answers.lower + answers.upper) / 2, 0)
    check(len(gjk.compare(answers, said).wrong) == 0, "right answers")
    apart, together = (numpy.flatnonzero(answers.touching == t)[0] for t in (0, 1))
    said[apart], said[together] = 0, 0.5
    said[apart + 1 :][answers.touching[apart + 1 :] == 0] += 1e-3
    result = gjk.compare(answers, said)
    check(set(result.touching_wrong) == {apart, together} and len(result.wrong) > 100, f"{result}")
    check(set(gjk.compare(answers, said, 2e-3).wrong) >= {apart, together}, "a tolerance")
    with tempfile.TemporaryDirectory() as folder:
        result.draw(f"{folder}/wrong.svg", poses[:, 0], poses[:, 1])
        text = open(f"{folder}/wrong.svg", encoding="utf-8").read()
    check(text.count("<circle") == 2000 and text.count("#c00") == 2, "a picture")


print(f"seed {SEED}")
try:
    import numpy
except ImportError:
    raises(ImportError, gjk.second_opinions, (1, 1, 1), (1, 1, 1), None, None)
    sys.exit(run(single, exact, errors))
sys.exit(run(single, exact, errors, batches))
