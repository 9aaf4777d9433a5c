//! The plane: flat games and floor plans, down to the scenes.
use crate::common::{answer, pointer_of_mut, Answer, Status};
use gjk_sys as sys;

pub use sys::{
    gjk2_aabb as Aabb, gjk2_cache as Cache, gjk2_cast_result as CastResult, gjk2_contact as Contact,
    gjk2_decision as Decision, gjk2_distance_result as DistanceResult, gjk2_impact_result as ImpactResult,
    gjk2_manifold as Manifold, gjk2_motion as Motion, gjk2_penetration_result as PenetrationResult, gjk2_pose as Pose,
    gjk2_rotation as Rotation, gjk2_unit as Unit, gjk2_vec as Vec2, gjk2_within_result as WithinResult,
};
use Vec2 as Vector;

pub(crate) mod raw {
    #[rustfmt::skip]
    pub use gjk_sys::{
        gjk2_shape as shape, gjk2_collider as collider, gjk2_collider_init as collider_init, gjk2_collider_pose as
        collider_pose, gjk2_collider_move as collider_move, gjk2_collider_aabb as collider_aabb, gjk2_aabb as aabb,
        gjk2_intersect as intersect, gjk2_within as within, gjk2_within_until as within_until, gjk2_distance as
        distance, gjk2_distance_until as distance_until, gjk2_effort as effort, gjk2_cast_path as cast_path,
        gjk2_cast as cast, gjk2_cast_ray as cast_ray, gjk2_impact_setup as impact_setup, gjk2_time_of_impact as
        time_of_impact, gjk2_check_decision as check_decision, gjk2_check_distance as check_distance,
        gjk2_check_penetration as check_penetration, gjk2_check_cast as check_cast, gjk2_scene as scene,
        gjk2_scene_bindings as scene_bindings, gjk2_scene_bind_all as scene_bind_all, gjk2_scene_bytes as
        scene_bytes, gjk2_scene_init as scene_init, gjk2_scene_open as scene_open, gjk2_scene_attach as
        scene_attach, gjk2_scene_seal as scene_seal, gjk2_scene_add as scene_add, gjk2_scene_add_at as scene_add_at,
        gjk2_scene_remove as scene_remove, gjk2_scene_move as scene_move, gjk2_scene_teleport as scene_teleport,
        gjk2_scene_sleep as scene_sleep, gjk2_scene_wake as scene_wake, gjk2_scene_set_motion as scene_set_motion,
        gjk2_scene_set_shape as scene_set_shape, gjk2_scene_set_filter as scene_set_filter, gjk2_scene_set_user as
        scene_set_user, gjk2_scene_get as scene_get, gjk2_scene_get_stats as scene_get_stats, gjk2_scene_hash as
        scene_hash, gjk2_scene_update as scene_update, gjk2_scene_cast_ray as scene_cast_ray, gjk2_scene_cast as
        scene_cast, gjk2_scene_query_within as scene_query_within, gjk2_scene_query_nearest as scene_query_nearest,
        gjk2_body_setup as body_setup, gjk2_report as report, gjk2_body_state as body_state, gjk2_part as part,
        gjk2_scene_config as scene_config,
    };
}

#[path = "shared/collider.rs"]
mod collider;
#[path = "shared/query.rs"]
mod query;
#[path = "shared/scene.rs"]
mod scene;

pub use collider::{Collider, Shape};
pub use query::*;
pub use scene::{part, part_at, scene_config, scene_words, Body, BodyState, Part, Report, Scene, SceneConfig, NO_HIT};

pub const UPRIGHT: Rotation = Rotation { c: sys::GJK_Q30_ONE, s: 0 };
pub const ORIGIN: Pose = pose(0, 0);

pub const fn vec2(x: i32, y: i32) -> Vec2 {
    Vec2 { x, y }
}

/// Upright at a position.
pub const fn pose(x: i32, y: i32) -> Pose {
    Pose { position: vec2(x, y), rotation: UPRIGHT }
}

/// Rotation by an angle, Q16.16 radians.
pub fn rotation(angle: i32) -> Result<Rotation, Status> {
    // SAFETY: plain values.
    Ok(unsafe { answer(|out| sys::gjk2_rotation_from_angle(angle, out)) }?)
}

pub fn normalize(r: &Rotation) -> Result<Rotation, Status> {
    // SAFETY: plain values.
    Ok(unsafe { answer(|out| sys::gjk2_rotation_normalize(r, out)) }?)
}

/// First b, then a.
pub fn compose(a: &Rotation, b: &Rotation) -> Result<Rotation, Status> {
    // SAFETY: plain values.
    Ok(unsafe { answer(|out| sys::gjk2_rotation_compose(a, b, out)) }?)
}

// SAFETY of all: what a shape points to is borrowed for as long as it lives.
impl<'a> Shape<'a> {
    pub fn circle(radius: i32) -> Result<Shape<'static>, Status> {
        unsafe { Shape::of(|out| sys::gjk2_shape_point(radius, out)) }
    }

    /// Along x.
    pub fn capsule(radius: i32, half: i32) -> Result<Shape<'static>, Status> {
        unsafe { Shape::of(|out| sys::gjk2_shape_segment(half, radius, out)) }
    }

    pub fn rectangle(half: Vec2, radius: i32) -> Result<Shape<'static>, Status> {
        unsafe { Shape::of(|out| sys::gjk2_shape_box(half.x, half.y, radius, out)) }
    }

    pub fn ellipse(radii: Vec2, radius: i32) -> Result<Shape<'static>, Status> {
        unsafe { Shape::of(|out| sys::gjk2_shape_ellipse(radii.x, radii.y, radius, out)) }
    }

    pub fn triangle(vertices: &'a [Vec2; 3], radius: i32) -> Result<Shape<'a>, Status> {
        unsafe { Shape::of(|out| sys::gjk2_shape_triangle(vertices.as_ptr(), radius, out)) }
    }

    /// The convex polygon around vertices in any order.
    pub fn polygon(vertices: &'a [Vec2], radius: i32) -> Result<Shape<'a>, Status> {
        let count = u16::try_from(vertices.len()).map_err(|_| Status::RANGE)?;
        unsafe { Shape::of(|out| sys::gjk2_shape_polygon(vertices.as_ptr(), count, radius, out)) }
    }
}

/// How deep, which way out, where?
pub fn penetration(a: &Collider, b: &Collider, cache: Option<&mut Cache>) -> Answer<PenetrationResult> {
    // SAFETY: colliders are posed.
    unsafe { answer(|out| sys::gjk2_penetration(&a.raw, &b.raw, pointer_of_mut(cache), out)) }
}

/// The gap, or minus the depth.
pub fn signed_distance(a: &Collider, b: &Collider, cache: Option<&mut Cache>) -> Answer<DistanceResult> {
    // SAFETY: as above.
    unsafe { answer(|out| sys::gjk2_signed_distance(&a.raw, &b.raw, pointer_of_mut(cache), out)) }
}

/// Where do two shapes touch that are at most margin apart? At most so many points, 1 or 2.
pub fn contacts(
    a: &Collider, b: &Collider, margin: i32, most: u32, cache: Option<&mut Cache>,
) -> Answer<Manifold> {
    // SAFETY: as above.
    unsafe { answer(|out| sys::gjk2_contacts(&a.raw, &b.raw, margin, most, pointer_of_mut(cache), out)) }
}

impl<const WORDS: usize> Scene<'_, WORDS> {
    /// Finds which pairs are near, and what fast bodies touch. After CAPACITY the update has not begun: move or remove bodies
    /// whose pairs do not fit.
    pub fn update(&mut self, each: impl FnMut(Report)) -> Result<(), Status> {
        self.update_with(scene::bindings(), each)
    }
}
