"""Robots as URDF and SRDF describe them: what gjk-convert --urdf makes of them, for gjk.Arm.from_urdf."""

import math
import os
import re
import struct
import xml.etree.ElementTree

from ._library import Error, Q16_ONE, Q30_ONE
from .bodies import Collider, Pose, box, cylinder, sphere
from .queries import intersect
from .solids import hull_build, hull_simplify

__all__ = []

_LINKS_MAX, _FOLDERS_UP, _SAMPLES = 32, 4, 2000
_INT32 = (1 << 31) - 1
_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")
_HALF_TURN = 205887  # pi


class Robot:
    """links and parts: what an Arm is made of."""

    def __init__(self, path, scale, vertices, link_type, part_type):
        self.path, self.scale, self.vertices = os.fspath(path), Q16_ONE * scale, vertices
        root = _parse(self.path)
        elements = _named(self.path, root, "link")
        joints = _named(self.path, root, "joint")
        hangs = self._hang(elements, joints)
        order = self._order(elements, joints, hangs)
        self.links = [self._link(link_type, name, joints.get(hangs.get(name))) for name in order]
        self.parts = [
            part_type(name, *shaped)
            for name in order
            for i, element in enumerate(elements[name].findall("collision"))
            for shaped in [self._fit(element, f"{self.path}: collision {i} of link {name!r}")]
        ]
        self.known = set(elements)

    # The tree.

    def _hang(self, links, joints):
        """Which joint each link hangs on, by names."""
        hangs = {}
        for name, joint in joints.items():
            where = f"{self.path}: joint {name!r}"
            for end in ("parent", "child"):
                link = joint.find(end)
                if link is None or link.get("link") not in links:
                    found = "no link" if link is None else f"link {link.get('link')!r}, which is not there"
                    raise ValueError(f"{where} has as {end} {found}")
            child = joint.find("child").get("link")
            if child in hangs:
                raise ValueError(f"{self.path}: link {child!r} hangs on joint {hangs[child]!r} and on {name!r}")
            hangs[child] = name
        return hangs

    def _order(self, links, joints, hangs):
        """Parents first; of those whose parent is there the one whose joint is first in the file. As few as an arm
        has."""
        order = [name for name in links if name not in hangs]
        if len(order) > 1:
            raise ValueError(f"{self.path}: link {order[1]!r} hangs on no joint, as {order[0]!r}")
        left = dict(joints)
        while left:
            name = next((name for name, joint in left.items() if joint.find("parent").get("link") in order), None)
            if name is None:
                raise ValueError(f"{self.path}: joint {next(iter(left))!r} is one of joints in a circle")
            order.append(left.pop(name).find("child").get("link"))
        if not order:
            raise ValueError(f"{self.path}: no links")
        for name in order[:0:-1]:  # children before their parents
            bears = any(hangs.get(other) and joints[hangs[other]].find("parent").get("link") == name for other in order)
            if len(order) > _LINKS_MAX and not bears and joints[hangs[name]].get("type") == "fixed":
                if links[name].find("collision") is None:
                    order.remove(name)
        if len(order) > _LINKS_MAX:
            raise ValueError(f"{self.path}: {len(order)} links, and a machine has at most {_LINKS_MAX}")
        return order

    def _link(self, link_type, name, joint):
        if joint is None:
            return link_type(name)
        where = f"{self.path}: joint {joint.get('name')!r}"
        parent, kind = joint.find("parent").get("link"), joint.get("type")
        if kind not in ("fixed", "revolute", "continuous", "prismatic"):
            raise ValueError(f"{where} is of type {kind!r}: revolute, continuous, prismatic and fixed are known")
        pose = self._pose(*_origin(joint, where), where)[0]
        if kind == "fixed":
            return link_type(name, parent, kind, pose)
        axis = joint.find("axis")
        axis = (1.0, 0.0, 0.0) if axis is None else _numbers(axis, "xyz", 3, where)
        largest = max(map(abs, axis))
        if largest == 0:
            raise ValueError(f"{where} has an axis of length 0")
        axis = [a / largest for a in axis]
        length = math.sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2])
        axis = tuple(round(a / length * Q30_ONE) for a in axis)
        if kind == "continuous":
            return link_type(name, parent, "revolute", pose, axis)
        limit = joint.find("limit")
        if limit is None:
            raise ValueError(f"{where} has no limit")
        limits = [_numbers(limit, side, 1, where, (0.0,))[0] for side in ("lower", "upper")]
        if limits[0] > limits[1]:
            raise ValueError(f"{where} has a lower limit above the upper one")
        worth = self.scale if kind == "prismatic" else Q16_ONE
        limits = [min(_INT32, max(-_INT32 - 1, round(x * worth))) for x in limits]
        return link_type(name, parent, kind, pose, axis, *limits)

    # Shapes: enclosed, as tests/programs/convert/machine.h says.

    def _pose(self, xyz, rpy, where):
        """The rounded pose, and how far its position is from the real one, LSB."""
        exact = [x * self.scale for x in xyz]
        rounded = [_whole(x, where) for x in exact]
        sr, sp, sy = (math.sin(angle / 2) for angle in rpy)
        cr, cp, cy = (math.cos(angle / 2) for angle in rpy)
        turn = (
            sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
            cr * cp * sy - sr * sp * cy, cr * cp * cy + sr * sp * sy,
        )  # fmt: skip
        far = 0.0
        for x, r in zip(exact, rounded):
            far += (x - r) * (x - r)
        return Pose(rounded, [round(q * Q30_ONE) for q in turn]), math.sqrt(far)

    def _fit(self, collision, where):
        """As _shape, if the library takes it."""
        try:
            shape, pose = self._shape(collision, where)
            Collider(shape, pose, baked=False)
        except Error as error:
            raise ValueError(f"{where} is wider than 4095 units, or too far away: {error}") from error
        return shape, pose

    def _shape(self, collision, where):
        """A shape and its pose in the link's frame."""
        geometry = collision.findall("geometry")
        if len(geometry) != 1 or len(geometry[0]) != 1:
            raise ValueError(f"{where} has not one geometry of one shape")
        xyz, rpy = _origin(collision, where)
        element, kind = geometry[0][0], geometry[0][0].tag
        if kind == "mesh":
            return self._mesh(element, xyz, rpy, where), None
        pose, far = self._pose(xyz, rpy, where)
        sizes = {"box": (("size", 3),), "sphere": (("radius", 1),), "cylinder": (("radius", 1), ("length", 1))}
        if kind not in sizes:
            raise ValueError(f"{where} has a {kind!r}: box, sphere, cylinder and mesh are known")
        size = [x for name, count in sizes[kind] for x in _numbers(element, name, count, where)]
        if min(size) < 0:
            raise ValueError(f"{where} has a negative size")
        if kind == "sphere":
            return sphere(_up(size[0] * self.scale + far)), Pose(pose.position)
        half = [x / 2 * self.scale for x in size] if kind == "box" else [size[0] * self.scale, size[1] / 2 * self.scale]
        total = half[0] + half[1] + half[2] if kind == "box" else half[0] + half[1]
        more = far + (math.ldexp(total, -28) if any(rpy) else 0.0)
        return (box if kind == "box" else cylinder)(*(_up(x + more) for x in half)), pose

    def _mesh(self, element, xyz, rpy, where):
        name, size = element.get("filename"), _numbers(element, "scale", 3, where, (1.0, 1.0, 1.0))
        if not name:
            raise ValueError(f"{where} has a mesh without a filename")
        place = [[turned * s for turned, s in zip(row, size)] for row in _matrix(rpy)]
        points, whole = {}, True
        for point in _points(self._find(name, where), f"{where}: mesh {name!r}"):
            exact = [(r[0] * point[0] + r[1] * point[1] + r[2] * point[2] + o) * self.scale for r, o in zip(place, xyz)]
            rounded = tuple(_whole(x, f"{where}: mesh {name!r}") for x in exact)
            whole = whole and all(x == r for x, r in zip(exact, rounded))
            points[rounded] = True
        if not 0 < len(points) <= 65535:
            raise ValueError(f"{where}: mesh {name!r} has {len(points)} different points, and a hull takes 1 to 65535")
        try:
            points = list(points)
            if self.vertices is not None:
                points = hull_simplify(points, self.vertices)[0]
            return hull_build(points, 0 if whole else 1, faces=False)
        except Error as error:
            raise ValueError(f"{where}: mesh {name!r}: {error}") from error

    def _find(self, name, where):
        """The path of a mesh: beside the robot; of package://NAME/REST NAME/REST or REST, there or in folders above."""
        folder = os.path.dirname(self.path)
        if not name.startswith("package://"):
            tried = [os.path.join(folder, name[7:] if name.startswith("file://") else name)]
        else:
            rest = name[len("package://") :]
            places = [os.path.join(folder, *[".."] * up) for up in range(_FOLDERS_UP + 1)]
            tried = [os.path.join(place, r) for place in places for r in (rest, rest.partition("/")[2]) if r]
        found = next((path for path in tried if os.path.isfile(path)), None)
        if found is None:
            raise ValueError(f"{where}: mesh {name!r} cannot be read")
        return found

    # Pairs that are never tested.

    def read_pairs(self, path):
        """Those that an SRDF disables."""
        path, kept = os.fspath(path), {link.name for link in self.links}
        pairs = []
        for element in _parse(path).findall("disable_collisions"):
            pair = element.get("link1"), element.get("link2")
            for name in pair:
                if name not in self.known:
                    raise ValueError(f"{path}: disable_collisions of link {name!r}, which is not of the robot")
            if set(pair) <= kept:
                pairs.append(pair)
        return pairs

    def sample_pairs(self, arm):
        """Those that touch in each of many samples, the same ones that gjk-convert takes, and those beside links
        without shapes."""
        owners, number = {part.link for part in self.parts}, {link.name: i for i, link in enumerate(self.links)}
        above, pairs, asked = {None: ()}, [], []
        for link in self.links:
            above[link.name] = (*above[link.parent], link)
            chain = [other.name for other in above[link.parent][::-1] if other.name in owners]
            if link.name in owners and chain and chain[0] != link.parent:
                pairs.append((chain[0], link.name))
            for other in self.links[: number[link.name]]:
                if {link.name, other.name} <= owners and chain[:1] != [other.name] and _between(above, link, other):
                    asked.append((other.name, link.name))
        colliders = [(part, Collider(part.shape, baked=False)) for part in self.parts]
        parts = {name: [c for part, c in colliders if part.link == name] for name in owners}
        random = _splitmix(1)
        for _ in range(_SAMPLES if asked else 0):
            values = []
            for link in arm.moving:
                endless = link.lower == -_INT32 - 1 or link.upper == _INT32
                low, high = (-_HALF_TURN, _HALF_TURN) if endless else (link.lower, link.upper)
                values.append(low + (next(random) * (high - low + 1) >> 32))
            try:
                poses = arm.poses(values)
            except Error:
                return pairs
            for part, collider in colliders:
                collider.pose(poses[number[part.link]] * (part.pose or Pose()))
            asked = [pair for pair in asked if any(_touch(a, b) for a in parts[pair[1]] for b in parts[pair[0]])]
            if not asked:
                break
        return pairs + asked


def _between(above, one, other):
    """Does a joint move one link against the other?"""
    names = {link.name for link in above[one.name]} ^ {link.name for link in above[other.name]}
    return any(link.name in names and link.kind != "fixed" for link in (*above[one.name], *above[other.name]))


def _touch(a, b):
    try:
        return bool(intersect(a, b))
    except Error:  # not settled: it is tested
        return False


def _splitmix(word):
    """The upper halves of the numbers of tests/support/random.h."""
    mask = (1 << 64) - 1
    while True:
        word = (word + 0x9E3779B97F4A7C15) & mask
        z = (word ^ word >> 30) * 0xBF58476D1CE4E5B9 & mask
        z = (z ^ z >> 27) * 0x94D049BB133111EB & mask
        yield (z ^ z >> 31) >> 32


# Files.


def _parse(path):
    try:
        root = xml.etree.ElementTree.parse(path).getroot()
    except xml.etree.ElementTree.ParseError as error:
        raise ValueError(f"{path}:{error.position[0]}: {error}") from error
    if root.tag != "robot":
        raise ValueError(f"{path}: the document's element is not 'robot'")
    return root


def _named(path, root, tag):
    """Elements by their names, in the order of the file."""
    found = {}
    for element in root.findall(tag):
        name = element.get("name")
        if not name or name in found:
            raise ValueError(f"{path}: {tag} {name!r} is there twice" if name else f"{path}: a {tag} has no name")
        found[name] = element
    return found


def _numbers(element, attribute, count, where, default=None):
    text = element.get(attribute)
    if text is None and default is not None:
        return default
    words = (text or "").split()
    if len(words) != count or not all(_NUMBER.fullmatch(word) and math.isfinite(float(word)) for word in words):
        raise ValueError(f"{where}: attribute {attribute!r} is not {count} number{'s' if count > 1 else ''}: {text!r}")
    return tuple(map(float, words))


def _origin(element, where):
    origin = element.find("origin")
    zero = (0.0, 0.0, 0.0)
    return (zero, zero) if origin is None else tuple(_numbers(origin, a, 3, where, zero) for a in ("xyz", "rpy"))


def _matrix(rpy):
    """Of turns about fixed x, y, z."""
    sr, sp, sy = map(math.sin, rpy)
    cr, cp, cy = map(math.cos, rpy)
    return (
        (cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr),
        (sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr),
        (-sp, cp * sr, cp * cr),
    )


def _whole(x, where):
    if not abs(x) <= _INT32:
        raise ValueError(f"{where} is beyond Q16.16")
    return round(x)


def _up(length):
    return math.ceil(length) if length < _INT32 else _INT32


def _points(path, where):
    """The corners of an STL or OBJ file."""
    with open(path, "rb") as file:
        data = file.read()
    kind = path[-4:].lower()
    if kind not in (".stl", ".obj"):
        raise ValueError(f"{where}: .stl and .obj are known")
    if kind == ".stl" and len(data) >= 84 and len(data) == 84 + 50 * struct.unpack_from("<I", data, 80)[0]:
        for numbers in struct.iter_unpack("<12x9fH", data[84:]):
            yield from (numbers[:3], numbers[3:6], numbers[6:9])
        return
    word = b"vertex" if kind == ".stl" else b"v"
    for number, line in enumerate(data.splitlines(), 1):
        words = line.split(b"#")[0].split()
        if words and words[0].lower() == word:
            try:
                x, y, z = map(float, words[1:4])
            except ValueError:
                raise ValueError(f"{where}, line {number}: a vertex has three coordinates") from None
            yield x, y, z
