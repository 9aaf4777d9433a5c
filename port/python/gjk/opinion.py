"""A second opinion on float geometry: distances with bounds that hold whatever was rounded. `import gjk` has all of
these names.

    print(gjk.second_opinion(hull_a, hull_b, pose_a, pose_b))     # apart by 0.01231 to 0.01233
    answers = gjk.second_opinions(hull_a, hull_b, poses_a, poses_b)  # numpy arrays, thousands of poses in one call
    print(gjk.compare(answers, what_the_library_said))

Shapes are float64 vertices, whose convex hull is meant, in any unit: rows of three numbers, an object with `vertices`,
as trimesh has, or three half extents of a box. Poses are None, a position, a position and a quaternion (x, y, z, w) of
any length, or a matrix of 4 x 4.

The vertices are scaled by a power of two, so that Q16.16 has as many bits of them as it can, and rounded. The library's
answer about the rounded shapes is exact; how far they are from the real ones is known, and widens the bounds.
"""

import ctypes
import math
import typing
from ctypes import POINTER, c_int32, c_uint32
from fractions import Fraction

from ._library import Error, Q30_ONE, Status, library
from .bodies import Collider, Vec3, box, hull
from .queries import Workspace, check_distance, check_penetration, distance, penetration

__all__ = ["Comparison", "Opinion", "Opinions", "compare", "second_opinion", "second_opinions"]

# A hull within this of its centre is within GJK_RADIUS_MAX of it along a diagonal, and centres are less than 2^29 LSB
# apart, where distances are rounded once.
_REACH = 154_000_000


class Opinion(typing.NamedTuple):
    """What is certain about two shapes, in the unit of their vertices.

    touching: None where the resolution cannot tell. lower, upper: bounds of the distance, negative for a depth; equal
    where nothing was rounded. normal: from A to B. proven: the library's own answer was checked in integers. point_a,
    point_b: the nearest points, or the deepest ones, each at most `within` from its shape as given.
    """

    touching: typing.Optional[bool]
    lower: float
    upper: float
    normal: typing.Optional[typing.Tuple[float, float, float]]
    resolution: float
    proven: bool
    point_a: typing.Tuple[float, float, float]
    point_b: typing.Tuple[float, float, float]
    within: float

    def __str__(self):
        if self.touching is None:
            return f"touching cannot be told at this resolution: between {self.lower:.9g} and {self.upper:.9g}"
        if self.lower == self.upper == 0:
            return "touching"
        low, high = (-self.upper, -self.lower) if self.touching else (self.lower, self.upper)
        return f"{'overlapping' if self.touching else 'apart'} by {low:.9g} to {high:.9g}"


def second_opinion(a, b, pose_a=None, pose_b=None, radius_a=0.0, radius_b=0.0) -> Opinion:
    """How far apart, or how deep, with bounds that hold for the floats as they are given. radius: around the hull.

    ValueError: no vertices, more than 65535, none or infinite numbers, a mesh that is not convex, a rotation of length
    0.
    """
    placed = [_placed(_vertices(shape, name), pose, name) for shape, pose, name in ((a, pose_a, "A"), (b, pose_b, "B"))]
    radii = [_fraction(radius, "a radius") for radius in (radius_a, radius_b)]
    if min(radii) < 0:
        raise ValueError("a radius is negative")
    middle = [(min(axis) + max(axis)) / 2 for axis in zip(*placed[0], *placed[1])]
    middle = [Fraction(float(m)) for m in middle]
    placed = [[[x - m for x, m in zip(v, middle)] for v in shape] for shape in placed]
    reach = max(abs(x) for shape in placed for v in shape for x in v) + max(radii)
    scale = _scale(reach)
    colliders, error, most = [], Fraction(0), Fraction(0)
    for shape, radius in zip(placed, radii):
        scaled = [[x * scale for x in v] for v in shape]
        rounded = [[round(x) for x in v] for v in scaled]
        moved = max(sum((x - r) ** 2 for x, r in zip(v, w)) for v, w in zip(scaled, rounded))
        around = round(radius * scale)
        off = _root_above(moved) + abs(radius * scale - around)
        error += off
        most = max(most, off)
        colliders.append(Collider(hull([Vec3(*v) for v in rounded], radius=around)))
    lower, upper, out, proven = _ask(*colliders, _workspace(*map(len, placed)))
    # The signed distance changes by no more than the shapes' points are moved together.
    lower, upper = (Fraction(lower) - error) / scale, (Fraction(upper) + error) / scale
    touching = False if lower > 0 else True if upper <= 0 else None
    normal = tuple(n / Q30_ONE for n in out.normal)
    points = [tuple(float(x / scale + m) for x, m in zip(point, middle)) for point in (out.point_a, out.point_b)]
    # A point is within an LSB of its shape, and a coordinate within 2^-53 of itself as a float.
    within = _above((most + 1) / scale + max(abs(Fraction(x)) for point in points for x in point) / 2**52)
    within = within if proven else math.inf
    return Opinion(touching, _below(lower), _above(upper), normal, float(1 / scale), proven, *points, within)


def _workspace(n, m):
    """As many vertices as a depth of hulls of n and m can take, or as a workspace can have."""
    return Workspace(max(4, min(n * m, 16000)))


def _ask(a, b, workspace):
    """Bounds of the signed distance in LSB, the library's result, and whether they are proven."""
    gap = distance(a, b)
    if not gap.intersecting:
        # The distance is the nearest integer, and the real one may be half an LSB away.
        low, high = Fraction(2 * gap.lower - 1, 2), Fraction(2 * gap.upper + 1, 2)
        check_distance(a, b, gap)
        return max(low, Fraction(0)), high, gap, True
    try:
        deep = penetration(a, b, None, workspace)
        check_penetration(a, b, deep)
        proven = True
    except Error as error:
        if error.status != Status.CAPACITY:
            raise
        deep, proven = error.result, False
    # Rounded up, and no depth is negative.
    return -deep.upper, -max(deep.lower - 1, 0), deep, proven


# Input, in rational numbers: what is given is exact, whatever it is.


def _fraction(x, what):
    x = float(x)
    if not math.isfinite(x):
        raise ValueError(f"{what} is {x}")
    return Fraction(x)


def _vertices(shape, name):
    if getattr(shape, "is_convex", True) is False:
        raise ValueError(f"{name} is a mesh that is not convex: ask about its convex parts")
    rows = list(getattr(shape, "vertices", shape))
    if len(rows) == 3 and not hasattr(rows[0], "__len__"):
        x, y, z = (_fraction(half, f"a half extent of {name}") for half in rows)
        return [[i * x, j * y, k * z] for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]
    if not 0 < len(rows) <= 65535:
        raise ValueError(f"{name} has {len(rows)} vertices")
    if any(len(row) != 3 for row in rows):
        raise ValueError(f"{name}: a vertex is three numbers")
    return [[_fraction(x, f"a coordinate of {name}") for x in row] for row in rows]


def _placed(vertices, pose, name):
    """The vertices in the world, exactly."""
    if pose is None:
        return vertices
    numbers = list(pose)
    if len(numbers) == 2 and hasattr(numbers[0], "__len__"):
        numbers = [*numbers[0], *numbers[1]]
    if len(numbers) == 4 and hasattr(numbers[0], "__len__"):
        rows = [[_fraction(x, f"a number of {name}'s pose") for x in row] for row in numbers]
        position, rotation = [row[3] for row in rows[:3]], [row[:3] for row in rows[:3]]
    else:
        numbers = [_fraction(x, f"a number of {name}'s pose") for x in numbers]
        if len(numbers) not in (3, 7):
            raise ValueError(f"{name}'s pose is no position, no position and quaternion, and no matrix of 4 x 4")
        position, rotation = numbers[:3], _rotation(numbers[3:], name)
    turned = vertices if rotation is None else [[_dot(row, v) for row in rotation] for v in vertices]
    return [[x + p for x, p in zip(v, position)] for v in turned]


def _rotation(q, name):
    """The matrix of a quaternion of any length: a quotient of polynomials, so no root is taken."""
    if not q:
        return None
    x, y, z, w = q
    n = sum(c * c for c in q)
    if n == 0:
        raise ValueError(f"{name}'s quaternion is 0")
    return [
        [(w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n],
        [2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n],
        [2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n],
    ]


def _dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def _scale(reach):
    """The largest power of two that keeps what reaches so far within range."""
    if reach == 0:
        return Fraction(1)
    ratio = Fraction(_REACH) / reach
    power = ratio.numerator.bit_length() - ratio.denominator.bit_length()
    power -= Fraction(2) ** power > ratio
    return Fraction(2) ** power


def _root_above(square):
    """A number not below the square root: within 2^-20 of it."""
    return Fraction(math.isqrt(math.ceil(square * 2**40)) + (square != 0), 2**20)


def _below(x):
    """The nearest float that is not above."""
    nearest = float(x)
    return nearest if Fraction(nearest) <= x else math.nextafter(nearest, -math.inf)


def _above(x):
    return -_below(-x)


# Many poses, in numpy.


class Opinions(typing.NamedTuple):
    """Arrays, an item for each pair: touching is 1, 0, or -1 where the resolution cannot tell."""

    touching: typing.Any
    lower: typing.Any
    upper: typing.Any
    resolution: float


def second_opinions(a, b, poses_a, poses_b, depths=True) -> Opinions:
    """As second_opinion, for two shapes at many poses, by one call of C. It needs numpy.

    poses: arrays of (n, 3), (n, 7) or (n, 4, 4), or one pose as of second_opinion where a shape stands. The bounds are
    some LSB wider, since the library rounds rotations and turned vertices. depths: False leaves out how deep, and is
    faster.
    """
    numpy = _numpy()
    local = [[[float(x) for x in v] for v in _vertices(shape, name)] for shape, name in ((a, "A"), (b, "B"))]
    is_box = [len(s) == 8 and not _is_rows(shape) for s, shape in zip(local, (a, b))]
    local = [numpy.array(s) for s in local]
    placed = [_poses(numpy, poses, name) for poses, name in ((poses_a, "A"), (poses_b, "B"))]
    pairs = max(len(position) for position, _ in placed)
    if any(len(position) not in (1, pairs) for position, _ in placed):
        raise ValueError(f"{len(placed[0][0])} poses of A and {len(placed[1][0])} of B")
    ends = numpy.concatenate([position for position, _ in placed])
    middle = (ends.min(axis=0) + ends.max(axis=0)) / 2 if len(ends) else numpy.zeros(3)
    lengths = [float(numpy.sqrt((s * s).sum(axis=1).max())) for s in local]
    reach = Fraction(float(numpy.abs(ends - middle).max(initial=0.0)) + max(lengths)) * (1 + Fraction(1, 2**40))
    scale = float(min(_scale(reach), Fraction(2) ** 1000))
    shapes, poses, error = [], [], 0.0
    for s, boxed, length, (position, rotation) in zip(local, is_box, lengths, placed):
        rounded = numpy.rint(s * scale).astype(numpy.int64)
        error += float(numpy.sqrt(((s * scale - rounded) ** 2).sum(axis=1).max()))
        # A turned vertex is off by 3/4 LSB along each axis, that of a box by three times as much; a rotation by 2^-29.
        error += math.sqrt(3) * (2.25 if boxed else 0.75) + 1.001 * 2.0**-29 * length * scale + math.sqrt(3) / 2
        corner = [int(c) for c in rounded[-1]]
        shapes.append(box(*corner) if boxed else hull([Vec3(*map(int, v)) for v in rounded]))
        made = numpy.empty((len(position), 7), numpy.int32)
        made[:, :3] = numpy.rint((position - middle) * scale)
        turned = rotation * Q30_ONE
        made[:, 3:] = numpy.rint(turned, out=turned)
        poses.append(made)
    lower, upper = _call(numpy, shapes, poses, pairs, _workspace(*map(len, local)) if depths else None)
    # Half an LSB by which distances are rounded, one of depths, and a bound of all roundings of floats here.
    error += 1.0 + 2.0**-10
    low, high = (lower - error) / scale, (upper + error) / scale
    low[lower == -(2**31)] = -math.inf
    touching = numpy.where(low > 0, 0, numpy.where(high <= 0, 1, -1)).astype(numpy.int8)
    return Opinions(touching, low, high, 1 / scale)


def _numpy():
    try:
        import numpy
    except ImportError as error:
        raise ImportError("second_opinions and compare need numpy; second_opinion does not") from error
    return numpy


def _is_rows(shape):
    return hasattr(shape, "vertices") or hasattr(list(shape)[0], "__len__")


def _poses(numpy, poses, name):
    """Positions, and unit quaternions (x, y, z, w)."""
    poses = numpy.zeros((1, 3)) if poses is None else numpy.asarray(poses, dtype=float)
    if poses.ndim == 1 or poses.shape == (4, 4):
        poses = poses[numpy.newaxis]
    if not numpy.isfinite(poses).all():
        raise ValueError(f"a number of {name}'s poses is not finite")
    if poses.shape[1:] == (4, 4):
        return poses[:, :3, 3], _quaternions(numpy, poses[:, :3, :3], name)
    if poses.shape[1:] not in ((3,), (7,)):
        raise ValueError(f"{name}'s poses are no arrays of (n, 3), (n, 7) or (n, 4, 4)")
    if poses.shape[1] == 3:
        return poses, numpy.broadcast_to([0.0, 0.0, 0.0, 1.0], (len(poses), 4))
    rotation = poses[:, 3:]
    square = numpy.einsum("ni,ni->n", rotation, rotation)
    if not ((square > 1e-200) & (square < 1e200)).all():
        largest = numpy.abs(rotation).max(axis=1, keepdims=True)
        if (largest == 0).any():
            raise ValueError(f"a quaternion of {name}'s is 0")
        rotation = rotation / largest
        square = numpy.einsum("ni,ni->n", rotation, rotation)
    return poses[:, :3], rotation / numpy.sqrt(square)[:, numpy.newaxis]


def _quaternions(numpy, m, name):
    """Of matrices of rotations, by the largest of the four components."""
    square = numpy.einsum("nij,nkj->nik", m, m)
    if numpy.abs(square - numpy.eye(3)).max(initial=0.0) > 2.0**-40:
        raise ValueError(f"a matrix of {name}'s is no rotation to 2^-40; second_opinion takes it as it is")
    trace = numpy.einsum("nii->n", m)
    q = numpy.empty((len(m), 4, 4))
    diagonal = numpy.einsum("nii->ni", m)
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        q[:, i, i] = 1 + 2 * diagonal[:, i] - trace
        q[:, i, j] = q[:, j, i] = m[:, i, j] + m[:, j, i]
        q[:, i, 3] = q[:, 3, i] = m[:, k, j] - m[:, j, k]
    q[:, 3, 3] = 1 + trace
    rows = q[numpy.arange(len(m)), numpy.einsum("nii->ni", q).argmax(axis=1)]
    return rows / numpy.sqrt((rows * rows).sum(axis=1, keepdims=True))


def _call(numpy, shapes, poses, pairs, room):
    lower, upper = numpy.empty(pairs, numpy.int32), numpy.empty(pairs, numpy.int32)
    failed = c_uint32()
    call = library.gjk_batch_signed_distance
    pointers = [array.ctypes.data_as(POINTER(c_int32)) for array in (*poses, lower, upper)]
    steps = [c_uint32(len(p) > 1) for p in poses]
    status = call(
        *map(ctypes.byref, shapes), pointers[0], steps[0], pointers[1], steps[1], c_uint32(pairs),
        ctypes.c_void_p(room.cells if room else None), c_uint32(room.count if room else 0), pointers[2], pointers[3],
        ctypes.byref(failed),
    )  # fmt: skip
    if status != Status.OK:
        raise ValueError(f"pair {failed.value}: {Status(status).name}")
    return lower, upper


# What another library says.


class Comparison(typing.NamedTuple):
    """A float library's answers beside the exact ones: which pairs are wrong, by how much at least, and which of these
    are wrong about touching."""

    wrong: typing.Any
    excess: typing.Any
    touching_wrong: typing.Any
    pairs: int

    def __str__(self):
        worst = f", by up to {self.excess.max():.3g}" if len(self.wrong) else ""
        return f"{len(self.wrong)} of {self.pairs} wrong{worst}; {len(self.touching_wrong)} about touching"

    def draw(self, path, x, y, size=480):
        """Writes a picture, SVG: a dot for each pair at its place in x and y, red where the library is wrong about
        touching, orange where it is wrong otherwise."""
        numpy = _numpy()
        places = []
        for values in (x, y):
            values = numpy.asarray(values, dtype=float)
            span = values.max() - values.min() or 1.0
            places.append(10 + (size - 20) * (values - values.min()) / span)
        colours = numpy.full(self.pairs, "#bbb", dtype=object)
        colours[self.wrong] = "#e80"
        colours[self.touching_wrong] = "#c00"
        with open(path, "w", encoding="utf-8") as out:
            out.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{size}" height="{size}">\n')
            for i in numpy.argsort(colours == "#bbb", kind="stable")[::-1]:  # wrong ones on top
                place = f'cx="{places[0][i]:.1f}" cy="{size - places[1][i]:.1f}"'
                out.write(f'<circle {place} r="2" fill="{colours[i]}"/>\n')
            out.write("</svg>\n")


def compare(opinions: Opinions, distances, tolerance=0.0) -> Comparison:
    """Compares distances of another library, 0 or negative where it sees shapes touch, with the bounds of
    second_opinions.

    tolerance: what the library grants itself. A pair counts as wrong only where no distance within the bounds is so
    near. Where the other library gives no depths, pairs that touch count as right if it says at most 0.
    """
    numpy = _numpy()
    said = numpy.asarray(distances, dtype=float)
    if said.shape != opinions.lower.shape:
        raise ValueError(f"{said.shape} distances for {opinions.lower.shape} pairs")
    high = numpy.maximum(opinions.upper, 0.0)
    excess = numpy.maximum(opinions.lower - said, numpy.where(said > 0, said - high, 0.0)) - tolerance
    excess = numpy.where((said <= 0) & (opinions.touching != 0), 0.0, excess)
    wrong = numpy.flatnonzero(~(excess <= 0))
    about = (said > 0) & (opinions.touching == 1) | (said <= 0) & (opinions.touching == 0)
    return Comparison(wrong, excess[wrong], wrong[about[wrong]], len(said))
