"""Scenes in the plane: those of space, of other structures. `gjk.plane` has all of these names."""

from ..scene import BodyId, BodyKind, BodyMotion, Detail, Event, Report, SceneBase, SceneFilter, SceneHit, SceneStats
from ..scene import dimension
from .bodies import Aabb, Collider, Pose, Shape, Vec
from .queries import CastResult, Manifold

__all__ = [
    "BodyId", "BodyKind", "BodyMotion", "BodyState", "Detail", "Event", "Report", "Scene", "SceneFilter", "SceneHit",
    "SceneStats",
]  # fmt: skip


class Scene(SceneBase):
    """Many bodies of the plane. Arguments and methods are those of gjk.Scene, without what is of concave bodies."""

    _of = dimension("gjk2_", Vec, Pose, Shape, Aabb, Collider, Manifold, CastResult)


BodyState = Scene._of.BodyState
