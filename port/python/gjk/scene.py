"""Scenes in space: many bodies, asked every tick which of them touch. `import gjk` has all of these names."""

import ctypes
import enum
import types
import typing
from ctypes import POINTER, c_bool, c_int32, c_uint8, c_uint16, c_uint32, c_uint64, c_void_p

from ._library import Error, Int32, Record, Status, Uint8, Uint16, Uint32, Unsigned
from ._library import answer, check_sizes, constant, declare, do, library
from .bodies import Aabb, Collider, Pose, Shape, Vec3
from .queries import CastResult, Manifold, Workspace

__all__ = [
    "BodyId", "BodyKind", "BodyMotion", "BodyState", "Detail", "Event", "Report", "Scene", "SceneFilter", "SceneHit",
    "SceneStats",
]  # fmt: skip


# Bodies and what is asked about them: gjk/body.h.


class BodyKind(enum.IntEnum):
    STATIC = 0
    KINEMATIC = 1
    DYNAMIC = 2


class Detail(enum.IntEnum):
    """What is wanted of a pair."""

    TOUCH = 0
    DISTANCE = 1
    DEPTH = 2
    CONTACTS = 3
    SENSOR = 4


class Event(enum.IntEnum):
    """What a report tells of a pair."""

    BEGIN = 1
    PERSIST = 2
    END = 3
    IMPACT = 4


class BodyMotion(enum.IntEnum):
    """FAST: swept along its way, and what it touches first is reported."""

    NOT_KEPT = 0
    KEPT = 1
    FAST = 2


class BodyId(Record):
    """Names a body of a scene; fit for the key of a dict. That of a removed body never names another one."""

    C_NAME = "gjk_body_id"
    _fields_ = [("slot", c_uint32), ("generation", c_uint32)]

    def __hash__(self):
        return hash((self.slot, self.generation))


class SceneHit(Record):
    """A part that a query found. fraction: of the way, Q2.30, where it is met. user: its body's word."""

    C_NAME = "gjk_scene_hit"
    _fields_ = [("body", BodyId), ("part", c_uint16), ("fraction", c_uint32), ("user", c_uint32)]


class SceneFilter(Record):
    """Which bodies a query looks at. ignore: a body to leave out."""

    C_NAME = "gjk_scene_filter"
    _fields_ = [
        ("category", c_uint32),
        ("mask", c_uint32),
        ("ignore", BodyId),
        ("accept", c_void_p),
        ("user", c_void_p),
    ]

    def __init__(self, category=0xFFFFFFFF, mask=0xFFFFFFFF, ignore=BodyId()):
        super().__init__(category, mask, ignore)


class SceneStats(Record):
    """What the last update did."""

    C_NAME = "gjk_scene_stats"
    _fields_ = [
        (name, c_uint32)
        for name in (
            "bodies parts pairs refused resting filtered motion boxes direction warm cold begun persisting ended "
            "unsettled updates measured manifolds"
        ).split()
    ]


class Report(typing.NamedTuple):
    """What an update tells of a pair of parts.

    user_a, user_b: the bodies' words; 0 of one that was removed.
    still: since the pair's last report nothing moved or changed it, so all is as it was reported then.
    words: Scene(pair_words=...) numbers of the scene, which may be written; None without them. They belong to the pair
    until the update that ends it.
    """

    a: BodyId
    b: BodyId
    user_a: int
    user_b: int
    part_a: int
    part_b: int
    event: Event
    detail: Detail
    still: bool
    distance: int
    fraction: int
    manifold: typing.Optional[Manifold]
    words: typing.Optional[ctypes.Array]


class _Progress(Record):
    C_NAME = "gjk_progress"
    _fields_ = [("reports", c_uint32), ("pairs_left", c_uint32), ("reports_left", c_uint32)]


# Scenes: gjk/scene.h, gjk/probe.h, gjk/concave.h.

_ROOM = 64  # reports, or hits, of one call of the library


def _address(name):
    return ctypes.addressof(ctypes.c_char.in_dll(library, name))


def dimension(prefix, vector, pose, shape, aabb, collider_of, manifold, cast_result, has_workspace=False):
    """Structures and functions of the scenes of space or of the plane, with the names that the class Scene knows."""

    class BodyState(Record):
        """What a scene holds about a body."""

        C_NAME = prefix + "body_state"
        _fields_ = [
            ("pose", pose),
            ("category", c_uint32),
            ("mask", c_uint32),
            ("user", c_uint32),
            ("margin", c_int32),
            ("part_count", c_uint16),
            ("kind", c_uint8),
            ("detail", c_uint8),
            ("asleep", c_bool),
            ("motion", c_uint8),
        ]

    class Part(Record):
        C_NAME = prefix + "part"
        _fields_ = [("shape", c_uint16), ("own_pose", c_bool), ("pose", pose)]

    class Setup(Record):
        C_NAME = prefix + "body_setup"
        _fields_ = [
            ("pose", pose),
            ("parts", POINTER(Part)),
            ("part_count", c_uint16),
            ("kind", c_uint8),
            ("detail", c_uint8),
            ("category", c_uint32),
            ("mask", c_uint32),
            ("user", c_uint32),
            ("margin", c_int32),
        ]

    class Config(Record):
        C_NAME = prefix + "scene_config"
        _fields_ = [
            ("bodies", c_uint32),
            ("parts", c_uint32),
            ("own_poses", c_uint32),
            ("pairs", c_uint32),
            ("box_margin", c_int32),
            ("detail", c_uint8),
            ("persist", c_uint8),
            ("retest_all", c_uint8),
            ("pair_words", c_uint8),
            *([("workspace_cells", c_uint32)] if has_workspace else []),
            ("motions", c_uint32),
        ]

    class Bindings(Record):
        C_NAME = prefix + "scene_bindings"
        _fields_ = [
            ("predicate", c_void_p),
            ("user", c_void_p),
            ("details", c_void_p),
            *([("workspace", POINTER(Workspace))] if has_workspace else []),
            ("manifolds", POINTER(manifold)),
            ("motion", c_void_p),
            ("keeps_manifolds", c_bool),
        ]

    class Handle(Record):
        C_NAME = prefix + "scene"
        _fields_ = [
            ("block", c_void_p),
            ("shapes", POINTER(POINTER(shape))),
            ("shape_count", c_uint16),
            ("bindings", Bindings),
        ]

    class Report(Record):
        C_NAME = prefix + "report"
        _fields_ = [
            ("a", BodyId),
            ("b", BodyId),
            ("user_a", c_uint32),
            ("user_b", c_uint32),
            ("part_a", c_uint16),
            ("part_b", c_uint16),
            ("event", c_uint8),
            ("detail", c_uint8),
            ("still", c_bool),
            ("distance", c_int32),
            ("manifold", POINTER(manifold)),
            ("words", POINTER(c_uint32)),
            ("fraction", c_int32),
        ]

    to_scene = POINTER(Handle)
    body = to_scene, BodyId
    to_reports = POINTER(Report), c_uint32, POINTER(_Progress)
    shapes = POINTER(POINTER(shape)), Uint16, POINTER(Bindings)
    filter = POINTER(SceneFilter)
    to_hits = POINTER(SceneHit), POINTER(SceneHit), c_uint32, POINTER(c_uint32)
    to_hit = POINTER(SceneHit), POINTER(cast_result), POINTER(c_bool)

    scene_bytes = library[prefix + "scene_bytes"]
    scene_bytes.restype, scene_bytes.argtypes = ctypes.c_size_t, [POINTER(Config)]
    init = declare(prefix + "scene_init", to_scene, POINTER(Config), c_void_p, ctypes.c_size_t, *shapes)
    open = declare(prefix + "scene_open", to_scene, c_void_p, ctypes.c_size_t, *shapes)
    add = declare(prefix + "scene_add", to_scene, POINTER(Setup), POINTER(BodyId))
    add_at = declare(prefix + "scene_add_at", to_scene, Uint32, POINTER(Setup), POINTER(BodyId))
    remove = declare(prefix + "scene_remove", *body)
    move = declare(prefix + "scene_move", *body, POINTER(pose))
    teleport = declare(prefix + "scene_teleport", *body, POINTER(pose))
    sleep = declare(prefix + "scene_sleep", *body)
    wake = declare(prefix + "scene_wake", *body)
    set_motion = declare(prefix + "scene_set_motion", *body, Uint8)
    set_shape = declare(prefix + "scene_set_shape", *body, Uint16, Uint16)
    set_filter = declare(prefix + "scene_set_filter", *body, Uint32, Uint32)
    set_user = declare(prefix + "scene_set_user", *body, Uint32)
    refilter = declare(prefix + "scene_refilter", *body)
    get = declare(prefix + "scene_get", *body, POINTER(BodyState))
    body_at = declare(prefix + "scene_body_at", to_scene, Uint32, POINTER(BodyId))
    collider = declare(prefix + "scene_collider", *body, Uint16, POINTER(collider_of))
    update = declare(prefix + "scene_update", to_scene, *to_reports)
    next_near = declare(prefix + "scene_next_near", to_scene, POINTER(c_uint32), POINTER(Report), POINTER(c_bool))
    get_stats = declare(prefix + "scene_get_stats", to_scene, POINTER(SceneStats))
    cast_ray = declare(prefix + "scene_cast_ray", to_scene, vector, vector, filter, *to_hit)
    cast_ray_all = declare(prefix + "scene_cast_ray_all", to_scene, vector, vector, filter, *to_hits)
    cast = declare(prefix + "scene_cast", to_scene, POINTER(collider_of), vector, Int32, filter, *to_hit)
    query_within = declare(prefix + "scene_query_within", to_scene, POINTER(collider_of), Int32, filter, *to_hits)
    query_box = declare(prefix + "scene_query_box", to_scene, POINTER(aabb), *to_hits)
    query_nearest = declare(
        prefix + "scene_query_nearest", to_scene, POINTER(collider_of), Int32, POINTER(BodyId), POINTER(SceneHit),
        POINTER(c_int32), POINTER(c_bool),
    )  # fmt: skip
    hash = declare(prefix + "scene_hash", to_scene, POINTER(c_uint64))
    seal = declare(prefix + "scene_seal", to_scene)

    names = dict(locals())
    check_sizes(names)
    return types.SimpleNamespace(**names)


_SPACE = dimension("gjk_", Vec3, Pose, Shape, Aabb, Collider, Manifold, CastResult, has_workspace=True)
BodyState = _SPACE.BodyState
_MANIFOLDS = declare(
    "gjk_scene_manifolds", POINTER(_SPACE.Handle), POINTER(_SPACE.Report), Unsigned, POINTER(Manifold), Unsigned,
    POINTER(ctypes.c_uint),
)  # fmt: skip


class SceneBase:
    """Many bodies. Depths, contacts and fast bodies may be asked for.

    shapes: all that its bodies may have; in space those of gjk.concave() too. A body names one by its number here, or
    as it is.
    The other arguments are the fields of gjk_scene_config. Capacities that are not given follow from bodies.
    """

    def __init__(self, shapes, bodies, parts=None, own_poses=None, pairs=None, box_margin=0, detail=Detail.TOUCH,
                 persist=False, retest_all=False, pair_words=0, workspace_cells=None, motions=None):  # fmt: skip
        parts = bodies if parts is None else parts
        self._config = self._of.Config(
            bodies, parts, parts if own_poses is None else own_poses, 16 * bodies if pairs is None else pairs,
            box_margin, detail, persist, retest_all, pair_words, motions=bodies if motions is None else motions,
        )  # fmt: skip
        if self._of.has_workspace:
            self._config.workspace_cells = Workspace().count if workspace_cells is None else workspace_cells
        elif workspace_cells is not None:
            raise TypeError("scenes of the plane have no workspace")
        self._shapes = list(shapes)
        self._table = (POINTER(self._of.shape) * len(self._shapes))(*map(ctypes.pointer, self._shapes))
        self._reports, self._manifolds = (self._of.Report * _ROOM)(), (self._of.manifold * _ROOM)()
        self._bindings = self._of.Bindings(
            details=_address(self._of.prefix + "scene_contacts"),
            manifolds=self._manifolds,
            motion=_address(self._of.prefix + "scene_motion"),
        )
        if self._of.has_workspace:
            self._workspace = Workspace(cells=self._config.workspace_cells)
            self._bindings.workspace = ctypes.pointer(self._workspace)
        self._block = (c_uint32 * (self._of.scene_bytes(self._config) // 4))()
        self._handle = self._of.Handle()
        do(self._of.init, self._handle, self._config, self._block, ctypes.sizeof(self._block), *self._bound())

    def _bound(self):
        return self._table, len(self._table), self._bindings

    def _number(self, shape):
        if isinstance(shape, int):
            return shape
        for number, known in enumerate(self._shapes):
            if known is shape:
                return number
        raise ValueError("the scene was not made with this shape")

    def _part(self, part):
        if not isinstance(part, tuple):
            return self._of.Part(self._number(part), False, self._of.pose())
        shape, pose = part
        return self._of.Part(self._number(shape), True, pose)

    # Bodies.

    def add(self, parts, pose=None, kind=BodyKind.STATIC, detail=Detail.TOUCH, category=1, mask=0xFFFFFFFF, user=0,
            margin=0, slot=None):  # fmt: skip
        """Adds a body to the lowest free slot, or to a stated one: its BodyId.

        parts: a shape, or a list of shapes and of tuples of a shape and its pose in the body's frame.
        """
        parts = [self._part(part) for part in (parts if isinstance(parts, list) else [parts])]
        array = (self._of.Part * len(parts))(*parts)
        pose = pose if pose is not None else self._of.pose()
        setup = self._of.Setup(pose, array, len(parts), kind, detail, category, mask, user, margin)
        if slot is None:
            return answer(self._of.add, BodyId, self._handle, setup)
        return answer(self._of.add_at, BodyId, self._handle, slot, setup)

    def remove(self, body):
        """The next update reports the end of its pairs."""
        do(self._of.remove, self._handle, body)

    def move(self, body, pose):
        """Moves a body to its next pose, and wakes it."""
        do(self._of.move, self._handle, body, pose)

    def teleport(self, body, pose):
        """As move, for a body that does not go on the same way."""
        do(self._of.teleport, self._handle, body, pose)

    def sleep(self, body):
        do(self._of.sleep, self._handle, body)

    def wake(self, body):
        do(self._of.wake, self._handle, body)

    def set_motion(self, body, motion):
        """Makes a body fast: a BodyMotion."""
        do(self._of.set_motion, self._handle, body, motion)

    def set_shape(self, body, part, shape):
        do(self._of.set_shape, self._handle, body, part, self._number(shape))

    def set_filter(self, body, category, mask):
        do(self._of.set_filter, self._handle, body, category, mask)

    def set_user(self, body, user):
        do(self._of.set_user, self._handle, body, user)

    def refilter(self, body):
        """The next update tests all pairs of the body again: after a write to the cells of ground."""
        do(self._of.refilter, self._handle, body)

    def get(self, body):
        """What the scene holds about a body: a BodyState."""
        return answer(self._of.get, self._of.BodyState, self._handle, body)

    def body_at(self, slot):
        """The BodyId in a slot; None: it is free."""
        body = answer(self._of.body_at, BodyId, self._handle, slot)
        return body if body.generation != 0 else None

    def collider(self, body, part=0):
        """A part that is not concave, as a Collider where it is now."""
        of = self._of.collider_of
        collider = answer(self._of.collider, lambda: of.__new__(of), self._handle, body, part)
        collider.shape = self._shapes
        return collider

    # Updates.

    def update(self):
        """Finds which pairs are near, and what fast bodies touch: a list of Report.

        After Error(CAPACITY) the update has not begun: move or remove bodies whose pairs do not fit.
        """
        reports, progress = [], _Progress(0, 0, 1)
        while progress.pairs_left != 0 or progress.reports_left != 0:
            do(self._of.update, self._handle, self._reports, _ROOM, progress)
            reports.extend(map(self._report, self._reports[: progress.reports]))
        return reports

    def _report(self, c):
        words = None
        if c.words:
            offset = ctypes.addressof(c.words.contents) - ctypes.addressof(self._block)
            words = (c_uint32 * self._config.pair_words).from_buffer(self._block, offset)
        return Report(
            a=BodyId(c.a.slot, c.a.generation),
            b=BodyId(c.b.slot, c.b.generation),
            user_a=c.user_a,
            user_b=c.user_b,
            part_a=c.part_a,
            part_b=c.part_b,
            event=Event(c.event),
            detail=Detail(c.detail),
            still=c.still,
            distance=c.distance,
            fraction=c.fraction,
            manifold=self._of.manifold.from_buffer_copy(c.manifold.contents) if c.manifold else None,
            words=words,
        )

    def near(self):
        """The pairs that were near at the last update, as a list of Report in no stated order."""
        reports, cursor, found = [], c_uint32(), c_bool()
        while True:
            pair = self._of.Report()
            do(self._of.next_near, self._handle, cursor, pair, found)
            if not found:
                return reports
            reports.append(self._report(pair))

    def stats(self):
        """A SceneStats."""
        return answer(self._of.get_stats, SceneStats, self._handle)

    # Queries of the current poses. filter: a SceneFilter, or None.

    def cast_ray(self, start, end, filter=None):
        """What a ray enters first: a SceneHit and its CastResult; None: nothing."""
        return self._first(self._of.cast_ray, start, end, filter)

    def cast_ray_all(self, start, end, filter=None):
        """All that a ray enters, in this order: a list of SceneHit."""
        return self._hits(self._of.cast_ray_all, start, end, filter)

    def cast(self, collider, to, margin=0, filter=None):
        """What a collider meets first on a straight way: a SceneHit and its CastResult; None: nothing."""
        return self._first(self._of.cast, collider, to, margin, filter)

    def within(self, collider, reach=0, filter=None):
        """All parts that are at most reach away from a collider: a list of SceneHit."""
        return self._hits(self._of.query_within, collider, reach, filter)

    def box(self, box):
        """All parts whose boxes share a point with an Aabb: a list of SceneHit."""
        return self._hits(self._of.query_box, box)

    def nearest(self, collider, reach, ignore=None):
        """The part that is nearest to a collider, at most reach away: a SceneHit and the distance; None: nothing."""
        hit, distance, found = SceneHit(), c_int32(), c_bool()
        do(self._of.query_nearest, self._handle, collider, reach, ignore, hit, distance, found)
        return (hit, distance.value) if found else None

    def _first(self, function, *arguments):
        hit, result, found = SceneHit(), self._of.cast_result(), c_bool()
        status = function(self._handle, *arguments, hit, result, found)
        if status != Status.OK:
            raise Error(status, hit)
        return (hit, result) if found else None

    def _hits(self, function, *arguments):
        hits, count = [], c_uint32(_ROOM + 1)
        while count.value > _ROOM:
            room = (SceneHit * _ROOM)()
            do(function, self._handle, *arguments, hits[-1] if hits else None, room, _ROOM, count)
            hits.extend(room[: count.value])
        return hits

    # Lockstep and saving.

    def hash(self):
        """64 bits over all that decides further answers."""
        return answer(self._of.hash, c_uint64, self._handle).value

    def save(self):
        """The scene as bytes, sealed by a checksum: what C opens with gjk_scene_open."""
        do(self._of.seal, self._handle)
        return bytes(self._block)

    def load(self, save):
        """Takes what a scene of the same shapes and the same configuration has saved, on any machine.

        The bytes are checked, so they may come from anywhere. After an Error the scene is as it was.
        """
        if len(save) != ctypes.sizeof(self._block):
            raise Error(Status.CAPACITY)
        block, handle = type(self._block).from_buffer_copy(save), self._of.Handle()
        do(self._of.open, handle, block, len(save), *self._bound())
        self._block, self._handle = block, handle


class Scene(SceneBase):
    __doc__ = SceneBase.__doc__
    _of = _SPACE

    def manifolds(self, report, most=4):
        """All contacts of a reported pair where its bodies are now, by their normals: a list of Manifold."""
        room, count = (Manifold * constant("GJK_PARTS_MANIFOLDS_MAX"))(), ctypes.c_uint()
        pair = self._of.Report(a=report.a, b=report.b, part_a=report.part_a, part_b=report.part_b)
        do(_MANIFOLDS, self._handle, pair, most, room, len(room), count)
        return room[: count.value]


check_sizes(globals())
