"""Arms through the Python module: the machine that gjk-convert makes, the edges that gjk-query answers, static queries
against pairs of colliders, errors, lifetimes. Prints what is wrong. arm_behaviour.py GJK-CONVERT"""

import gc
import pathlib
import random
import subprocess
import sys
import tempfile

import gjk
from checks import check, raises, run
from gjk import ArmAnswer, ArmLink, ArmPart, Pose, Status, q16

DATA = pathlib.Path("tests/data/robot")
SIX, PAIRS = DATA / "six.urdf", DATA / "six.srdf"
SEED = 7

try:
    import numpy
except ImportError:
    numpy = None


def converted(*options):
    """What gjk-convert writes: links and parts as tuples, pairs that are never tested as numbers."""
    words = subprocess.run(
        [sys.argv[1], "--urdf", "--case", *options, SIX], capture_output=True, text=True, check=True
    ).stdout.splitlines()  # fmt: skip
    blocks, never, names = [], [], {"base": None}
    for line in (line.split() for line in words if not line.startswith("#")):
        if line[0] == "never":
            never.append((names[line[1]], names[line[2]]))
        elif line[0] in ("link", "part"):
            if line[0] == "link":
                names[line[1]] = len(names) - 1
            blocks.append({"of": [line[0], names[line[1 if line[0] == "part" else 2]], *line[3:]], "points": set()})
        elif line[0] in ("L", "P"):
            blocks[-1][line[1]] = [int(n) for n in line[2:]]
        else:
            blocks[-1]["points"].add(tuple(map(int, line)))
    return blocks, never


def described(arm):
    """The same of an arm."""
    number, blocks = {link.name: i for i, link in enumerate(arm.links)}, []

    def at(pose, block):
        pose = pose or Pose()
        if any(pose.position):
            block["at"] = list(pose.position)
        if tuple(pose.rotation) != gjk.Quat.IDENTITY:
            block["turn"] = list(pose.rotation)

    for link in arm.links:
        block = {"of": ["link", number.get(link.parent), link.kind], "points": set()}
        at(link.pose, block)
        if link.kind != "fixed":
            block["axis"] = list(link.axis)
        if (link.lower, link.upper) != (-(1 << 31), (1 << 31) - 1):
            block["limits"] = [link.lower, link.upper]
        blocks.append(block)
    for part in arm.parts:
        shape, block = part.shape, {"of": ["part", number[part.link]], "points": set()}
        if shape.count:
            block["points"] = set(shape.polyhedron()[0])
            block["hull"] = [shape.count]
            block.update({"round": [shape.convex_radius]} if shape.convex_radius else {})
        elif not any(shape.size):
            block["sphere"] = [shape.convex_radius]
        else:
            name = "box" if shape.type == gjk.box(1, 1, 1).type else "cylinder"
            block[name] = list(shape.size)[1 if name == "cylinder" else 0 :]
        at(part.pose, block)
        blocks.append(block)
    return blocks, [(i, k) for i in range(len(arm.links)) for k in range(len(arm.links)) if arm._never[i] >> k & 1]


def same_machine():
    """from_urdf and gjk-convert make one machine."""
    for scale in (1, 16, 0.5):
        for srdf, most, options in (
            (PAIRS, None, ("--srdf", PAIRS)), (None, None, ()), (PAIRS, 8, ("--srdf", PAIRS, "--vertices", "8")),
        ):  # fmt: skip
            arm = gjk.Arm.from_urdf(SIX, srdf, scale, None, most)
            blocks, never = converted("--scale", str(scale), *options)
            mine, pairs = described(arm)
            check(mine == blocks, f"the machine at scale {scale}: {[p for p in zip(mine, blocks) if p[0] != p[1]][:1]}")
            check({frozenset(p) for p in pairs} == {frozenset(p) for p in never}, f"its pairs: {pairs} and {never}")


def surrounded():
    """The arm and obstacles of edges.txt."""
    arm = gjk.Arm.from_urdf(SIX, PAIRS)
    arm.obstacles([
        (gjk.cylinder(q16(0.05), q16(0.6)), Pose((q16(0.5), q16(0.35), q16(0.6)))),
        (gjk.box(q16(0.2), q16(0.3), q16(0.02)), Pose((q16(0.55), q16(-0.5), q16(0.5)))),
        (gjk.box(q16(2), q16(2), q16(0.1)), Pose((0, 0, q16(-0.101)))),
    ])  # fmt: skip
    gc.collect()
    return arm


def edges_of_file():
    """A line an edge: its ID, start, end, margin and tolerance."""
    edges = []
    for line in (DATA / "edges.txt").read_text().splitlines():
        words = line.split("#")[0].split()
        if words[:1] == ["edge"]:
            edges.append([words[1], None, None, {}])
        elif words[:1] == ["E"] and words[1] in ("from", "to"):
            edges[-1][1 if words[1] == "from" else 2] = [q16(float(n)) for n in words[2:]]
        elif words[:1] == ["E"]:
            edges[-1][3][words[1]] = q16(float(words[2]))
    return edges


def told(arm, name, edge):
    """An answer as gjk-query prints it."""
    outside = " outside" if edge["outside"] else ""
    if edge["answer"] == ArmAnswer.FREE:
        return f"{name} free gap={edge['gap']} tests={edge['tests']}{outside}"
    one, other = arm.names(edge["pair"])
    other = ("post", "shelf", "ground")[other] if isinstance(other, int) else other
    pair = f"a={one} b={other}".replace(" finger", "_finger")
    return f"{name} touch lower={edge['lower']} upper={edge['upper']} {pair} tests={edge['tests']}{outside}"


def same_edges():
    arm, expected = surrounded(), (DATA / "edges.expected").read_text().splitlines()
    for (name, start, end, options), line in zip(edges_of_file(), expected):
        edge = arm.edge(start, end, resolution=0, **options)
        check(told(arm, name, dict(edge.values())) == line, f"{told(arm, name, dict(edge.values()))} instead of {line}")
        if numpy is not None:
            edge = arm.edges([start], [end], resolution=0, certify=True, **options)[0]
            check(told(arm, name, edge) == line, f"{told(arm, name, edge)} instead of {line}, in numpy")
    check(len(expected) == 7, "the edges of the file")


def static():
    """near and distance against all pairs; gradients against differences."""
    arm, numbers = surrounded(), random.Random(SEED)
    near = far = 0
    number = {link.name: i for i, link in enumerate(arm.links)}
    things = [(gjk.cylinder(q16(0.05), q16(0.6)), Pose((q16(0.5), q16(0.35), q16(0.6)))),
              (gjk.box(q16(0.2), q16(0.3), q16(0.02)), Pose((q16(0.55), q16(-0.5), q16(0.5)))),
              (gjk.box(q16(2), q16(2), q16(0.1)), Pose((0, 0, q16(-0.101))))]  # fmt: skip
    for trial in range(100):
        values = [numbers.randrange(-90000, 90000) for _ in arm.moving[:6]]
        values += [numbers.randrange(400, 3900) for _ in arm.moving[6:]]
        where, poses, nearest = f"trial {trial} of seed {SEED}", arm.poses(values), arm.distance(values)
        colliders = [gjk.Collider(p.shape, poses[number[p.link]] * (p.pose or Pose())) for p in arm.parts]
        others = colliders if not nearest.pair.obstacle else [gjk.Collider(*thing) for thing in things]
        pair = colliders[nearest.pair.part], others[nearest.pair.other]
        check(gjk.distance(pair[1], pair[0]).distance == nearest.distance.distance, f"{where}: the pair's distance")
        most = nearest.distance.distance
        check(arm.near(values, most + (most > 0)) is not None, f"{where}: near")  # the distance is rounded
        check(most == 0 or arm.near(values, most - 1) is None, f"{where}: not near")
        if most > 0:
            check(arm.distance(values, most - 1) is None, f"{where}: none within less")
        for i, collider in enumerate(colliders):
            for k, thing in enumerate(things if arm.parts[i].link not in ("base", "column") else ()):
                check(gjk.distance(gjk.Collider(*thing), collider).distance >= most, f"{where}: part {i}, obstacle {k}")
        if most > 3000:
            far += 1
            gradient = arm.gradient(values, nearest)
            for i in range(len(values)):
                moved = arm.distance([v + 64 * (k == i) for k, v in enumerate(values)])
                if moved.pair == nearest.pair:
                    change = 64 * gradient[i] / gjk.Q16_ONE
                    check(abs(moved.distance.distance - most - change) < 4, f"{where}: gradient {i}")
        near += most == 0
    check(near > 5 and far > 5, f"the mix: {near} near, {far} far")


def by_hand():
    """A door on a post, by links and joints."""
    door = [ArmLink("post"), ArmLink("door", "post", "revolute", Pose((q16(1), 0, 0)), (0, 0, 1), 0, q16(2))]
    arm = gjk.Arm(door, [ArmPart("door", gjk.box(q16(0.5), q16(0.02), q16(1)), Pose((q16(0.5), 0, 0)))])
    free = arm.edge([0], [q16(1)])
    check(free.answer == ArmAnswer.FREE and not free.outside and free.gap > q16(1000), "a door alone")
    arm.obstacles([(gjk.sphere(q16(0.1)), Pose((q16(1.3), q16(0.5), 0)))])
    touch = arm.edge([0], [q16(3)], resolution=0)
    check(touch.answer == ArmAnswer.TOUCH and touch.outside, "a ball in its way")
    check(arm.names(touch.pair) == ("door", 0), "which pair")
    check(0 < touch.lower <= touch.upper < gjk.Q30_ONE // 2, "where it is met")
    check(arm.edge([0], [q16(3)], tests=1).answer == ArmAnswer.UNSETTLED, "not settled by one test")
    check(arm.near([q16(1)]) is not None and arm.near([0]) is None, "near")
    never = gjk.Arm([*door, ArmLink("latch", "door", "prismatic")], [
        ArmPart(name, gjk.sphere(q16(1))) for name in ("post", "latch")
    ], [("latch", "post")])  # fmt: skip
    check(never.edge([0, 0], [0, q16(1)]).answer == ArmAnswer.FREE, "a pair that is never tested")


def refusals():
    one = ArmLink("a")
    check("comes before its parent" in str(raises(ValueError, gjk.Arm, [ArmLink("a", "b"), ArmLink("b")], [])), "order")
    check("not there" in str(raises(ValueError, gjk.Arm, [one], [ArmPart("b", gjk.point())])), "a part of no link")
    check("'ball'" in str(raises(ValueError, gjk.Arm, [ArmLink("a", None, "ball")], [])), "a kind")
    raises(ValueError, gjk.Arm, [one, one], [])
    raises(gjk.Error, gjk.Arm, [], [], status=Status.EMPTY)
    raises(gjk.Error, gjk.Arm, [ArmLink("a", None, "revolute", None, (0, 0, 0))], [], status=Status.ROTATION)
    arm = gjk.Arm([ArmLink("a", None, "revolute")], [])
    raises(ValueError, arm.edge, [0, 0], [0, 0])
    raises(TypeError, arm.edge, [0.5], [1.0])
    raises(OverflowError, arm.edge, [1 << 31], [0])
    raises(gjk.Error, arm.edge, [0], [1], -1, status=Status.NEGATIVE)
    raises(gjk.Error, arm.edge, [0], [1], 0, 1, status=Status.RANGE)
    check(arm.distance([0]) is None and arm.near([0]) is None, "nothing to be near")
    if numpy is not None:
        raises(TypeError, arm.edges, [[0.5]], [[0.5]])
        raises(ValueError, arm.edges, [[0, 0]], [[0, 0]])
        raises(ValueError, arm.edges, [[0], [0]], [[0]])
        raises(OverflowError, arm.edges, [[1 << 40]], [[0]])
        error = raises(gjk.Error, arm.edges, [[0], [1 << 30]], [[0], [-(1 << 30)]], status=Status.RANGE)
        check("of edge 1" in str(error), "which edge")


def robots():
    """What is wrong with a robot is said."""
    meshes = f"file://{DATA.resolve()}/meshes/"
    text = SIX.read_text().replace("package://robot/", "").replace("meshes/", meshes)
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "bad.urdf"
        for old, new, message in (
            ("</robot>", "", "bad.urdf:"),
            ('size="0.3 0.3 0.1"', 'size="0.3 0.3"', "'size' is not 3 numbers"),
            ('size="0.3 0.3 0.1"', 'size="0.3 0.3 nan"', "'size' is not 3 numbers"),
            ("<box", "<cone", "'cone'"),
            ("upper.obj", "upper.stl", "cannot be read"),
            ('child link="column"', 'child link="bose"', "link 'bose', which is not there"),
            ('parent link="column"', 'parent link="fore"', "in a circle"),
            ('type="continuous"', 'type="floating"', "'floating'"),
            ('name="column"', 'name="base"', "there twice"),
            ('axis xyz="0 0 1"', 'axis xyz="0 0 0"', "axis of length 0"),
            ('size="0.3 0.3 0.1"', 'size="30000 1 1"', "wider than 4095 units"),
            ('size="0.3 0.3 0.1"', 'size="1e9 1 1"', "wider than 4095 units"),
            ('origin xyz="0 0 0.3"', 'origin xyz="0 0 3000"', "farther than 2048 units"),
            ('lower="-1.9"', 'lower="2"', "above the upper one"),
        ):
            path.write_text(text.replace(old, new))
            error = raises(ValueError, gjk.Arm.from_urdf, path)
            check(message in str(error) and str(path) in str(error), f"{message}: {error}")
        path.write_text(PAIRS.read_text().replace('"base"', '"bose"'))
        check("'bose'" in str(raises(ValueError, gjk.Arm.from_urdf, SIX, path)), "a pair of no link")


def arrays():
    """Many edges in one call answer as each by itself; each answer is certified."""
    if numpy is None:
        return
    arm, numbers = surrounded(), numpy.random.default_rng(SEED)
    most = numpy.array([3, 1.5, 2, 2, 1.5, 3, 0.06, 0.06])
    start = arm.configurations(numbers.uniform(-most * [1, 1, 1, 1, 1, 1, 0, 0], most, (600, 8)))
    end = start + numbers.integers(-20000, 20000, start.shape)
    answers = arm.edges(start, end, certify=True)
    for i in range(0, 600, 5):
        one = arm.edge(start[i], end[i])
        check(all(one_value == answers[i][name] for name, one_value in one.values() if name != "pair"), f"edge {i}")
    counts = numpy.bincount(answers["answer"], minlength=3)
    check(counts[1] > 100 and counts[2] > 50, f"the mix of edges: {counts}")
    check(len(arm.edges(start[:0], end[:0])) == 0, "no edges")
    few = arm.edges(start, end, tests=3)
    open_ones = few["answer"] == ArmAnswer.UNSETTLED
    check(open_ones.any() and (few["lower"] <= answers["upper"]).all(), "edges of few tests")


if __name__ == "__main__":
    sys.exit(run(same_machine, same_edges, static, by_hand, refusals, robots, arrays))
