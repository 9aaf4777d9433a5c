//! Space: what `lib.rs` has at its top.
use crate::common::{answer, pointer_of_mut, Answer, Status};
use gjk_sys as sys;

pub use sys::{
    gjk_aabb as Aabb, gjk_cache as Cache, gjk_cast_result as CastResult, gjk_contact as Contact, gjk_decision as Decision,
    gjk_distance_result as DistanceResult, gjk_epa_cell as Cell, gjk_impact_result as ImpactResult,
    gjk_manifold as Manifold, gjk_motion as Motion, gjk_penetration_result as PenetrationResult, gjk_pose as Pose,
    gjk_quat as Quat, gjk_unit3 as Unit3, gjk_vec3 as Vec3, gjk_within_result as WithinResult,
};
use Vec3 as Vector;

pub(crate) mod raw {
    #[rustfmt::skip]
    pub use gjk_sys::{
        gjk_shape as shape, gjk_collider as collider, gjk_collider_init as collider_init, gjk_collider_pose as
        collider_pose, gjk_collider_move as collider_move, gjk_collider_aabb as collider_aabb, gjk_aabb as aabb,
        gjk_intersect as intersect, gjk_within as within, gjk_within_until as within_until, gjk_distance as
        distance, gjk_distance_until as distance_until, gjk_effort as effort, gjk_cast_path as cast_path, gjk_cast
        as cast, gjk_cast_ray as cast_ray, gjk_impact_setup as impact_setup, gjk_time_of_impact as time_of_impact,
        gjk_check_decision as check_decision, gjk_check_distance as check_distance, gjk_check_penetration as
        check_penetration, gjk_check_cast as check_cast, gjk_scene as scene, gjk_scene_bindings as scene_bindings,
        gjk_scene_bind_all as scene_bind_all, gjk_scene_bytes as scene_bytes, gjk_scene_init as scene_init,
        gjk_scene_open as scene_open, gjk_scene_attach as scene_attach, gjk_scene_seal as scene_seal, gjk_scene_add
        as scene_add, gjk_scene_add_at as scene_add_at, gjk_scene_remove as scene_remove, gjk_scene_move as
        scene_move, gjk_scene_teleport as scene_teleport, gjk_scene_sleep as scene_sleep, gjk_scene_wake as
        scene_wake, gjk_scene_set_motion as scene_set_motion, gjk_scene_set_shape as scene_set_shape,
        gjk_scene_set_filter as scene_set_filter, gjk_scene_set_user as scene_set_user, gjk_scene_get as scene_get,
        gjk_scene_get_stats as scene_get_stats, gjk_scene_hash as scene_hash, gjk_scene_update as scene_update,
        gjk_scene_cast_ray as scene_cast_ray, gjk_scene_cast as scene_cast, gjk_scene_query_within as
        scene_query_within, gjk_scene_query_nearest as scene_query_nearest, gjk_body_setup as body_setup, gjk_report
        as report, gjk_body_state as body_state, gjk_part as part, gjk_scene_config as scene_config,
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

pub const UPRIGHT: Quat = Quat { x: 0, y: 0, z: 0, w: sys::GJK_Q30_ONE };
pub const ORIGIN: Pose = pose(0, 0, 0);

pub const fn vec3(x: i32, y: i32, z: i32) -> Vec3 {
    Vec3 { x, y, z }
}

/// Upright at a position.
pub const fn pose(x: i32, y: i32, z: i32) -> Pose {
    Pose { position: vec3(x, y, z), rotation: UPRIGHT }
}

/// Rotation by an angle, Q16.16 radians, about an axis of any length.
pub fn axis_angle(axis: &Vec3, angle: i32) -> Result<Quat, Status> {
    // SAFETY: plain values.
    Ok(unsafe { answer(|out| sys::gjk_quat_from_axis_angle(axis, angle, out)) }?)
}

pub fn normalize(q: &Quat) -> Result<Quat, Status> {
    // SAFETY: plain values.
    Ok(unsafe { answer(|out| sys::gjk_quat_normalize(q, out)) }?)
}

/// First b, then a.
pub fn compose(a: &Quat, b: &Quat) -> Result<Quat, Status> {
    // SAFETY: plain values.
    Ok(unsafe { answer(|out| sys::gjk_quat_compose(a, b, out)) }?)
}

/// The faces of a hull, as `gjk_hull_faces`.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub struct Faces<'a>(sys::gjk_hull_faces, core::marker::PhantomData<&'a [u16]>);

// SAFETY: constant, and so is what it points to.
unsafe impl Send for Faces<'_> {}
unsafe impl Sync for Faces<'_> {}

impl<'a> Faces<'a> {
    /// corner: the vertex numbers of all faces, face after face; end: where in it each face ends.
    pub fn new(corner: &'a [u16], end: &'a [u16]) -> Result<Faces<'a>, Status> {
        let rises = end.windows(2).all(|two| two[0] <= two[1]);
        let count = u16::try_from(end.len()).map_err(|_| Status::RANGE)?;
        if !rises || end.last().map_or(0, |&last| usize::from(last)) > corner.len() {
            return Err(Status::RANGE);
        }
        let raw = sys::gjk_hull_faces { corner: corner.as_ptr(), end: end.as_ptr(), count };
        Ok(Faces(raw, core::marker::PhantomData))
    }
}

fn count_of(vertices: &[Vec3]) -> Result<u16, Status> {
    u16::try_from(vertices.len()).map_err(|_| Status::RANGE)
}

// SAFETY of all: what a shape points to is borrowed for as long as it lives.
impl<'a> Shape<'a> {
    pub fn sphere(radius: i32) -> Result<Shape<'static>, Status> {
        unsafe { Shape::of(|out| sys::gjk_shape_point(radius, out)) }
    }

    /// Along z.
    pub fn capsule(radius: i32, half: i32) -> Result<Shape<'static>, Status> {
        unsafe { Shape::of(|out| sys::gjk_shape_segment(half, radius, out)) }
    }

    pub fn cuboid(half: Vec3, radius: i32) -> Result<Shape<'static>, Status> {
        unsafe { Shape::of(|out| sys::gjk_shape_box(half.x, half.y, half.z, radius, out)) }
    }

    pub fn cylinder(base_radius: i32, half: i32, radius: i32) -> Result<Shape<'static>, Status> {
        unsafe { Shape::of(|out| sys::gjk_shape_cylinder(base_radius, half, radius, out)) }
    }

    pub fn cone(base_radius: i32, half: i32, radius: i32) -> Result<Shape<'static>, Status> {
        unsafe { Shape::of(|out| sys::gjk_shape_cone(base_radius, half, radius, out)) }
    }

    pub fn ellipsoid(radii: Vec3, radius: i32) -> Result<Shape<'static>, Status> {
        unsafe { Shape::of(|out| sys::gjk_shape_ellipsoid(radii.x, radii.y, radii.z, radius, out)) }
    }

    pub fn triangle(vertices: &'a [Vec3; 3], radius: i32) -> Result<Shape<'a>, Status> {
        unsafe { Shape::of(|out| sys::gjk_shape_triangle(vertices.as_ptr(), radius, out)) }
    }

    /// The convex hull of vertices in any order.
    pub fn hull(vertices: &'a [Vec3], radius: i32) -> Result<Shape<'a>, Status> {
        let count = count_of(vertices)?;
        unsafe { Shape::of(|out| sys::gjk_shape_hull(vertices.as_ptr(), count, core::ptr::null(), radius, out)) }
    }

    /// With faces, which contacts of hulls need.
    pub fn hull_with_faces(vertices: &'a [Vec3], faces: &'a Faces<'a>, radius: i32) -> Result<Shape<'a>, Status> {
        let count = count_of(vertices)?;
        unsafe { Shape::of(|out| sys::gjk_shape_hull(vertices.as_ptr(), count, &faces.0, radius, out)) }
    }
}

/// Room for depths; see [`cells_for`].
pub const CELL: Cell = Cell { horizon: sys::gjk_epa_horizon { corner: [0; 4], face: [0; 4] } };

/// How many cells the depth of hulls of so many vertices together needs.
pub fn cells_for(vertices: u16) -> usize {
    // SAFETY: plain values.
    unsafe { sys::gjk_workspace_bytes(vertices) / core::mem::size_of::<Cell>() }
}

fn workspace(cells: &mut [Cell]) -> sys::gjk_workspace {
    sys::gjk_workspace { cells: cells.as_mut_ptr(), count: cells.len().min(u32::MAX as usize) as u32 }
}

/// How deep, which way out, where?
pub fn penetration(
    a: &Collider, b: &Collider, cache: Option<&mut Cache>, cells: &mut [Cell],
) -> Answer<PenetrationResult> {
    let room = workspace(cells);
    // SAFETY: colliders are posed, and the room is borrowed.
    unsafe { answer(|out| sys::gjk_penetration(&a.raw, &b.raw, pointer_of_mut(cache), &room, out)) }
}

/// The gap, or minus the depth.
pub fn signed_distance(
    a: &Collider, b: &Collider, cache: Option<&mut Cache>, cells: &mut [Cell],
) -> Answer<DistanceResult> {
    let room = workspace(cells);
    // SAFETY: as above.
    unsafe { answer(|out| sys::gjk_signed_distance(&a.raw, &b.raw, pointer_of_mut(cache), &room, out)) }
}

/// Where do two shapes touch that are at most margin apart? At most so many points, 1 to 8.
pub fn contacts(
    a: &Collider, b: &Collider, margin: i32, most: u32, cache: Option<&mut Cache>, cells: &mut [Cell],
) -> Answer<Manifold> {
    let room = workspace(cells);
    // SAFETY: as above.
    unsafe { answer(|out| sys::gjk_contacts(&a.raw, &b.raw, margin, most, pointer_of_mut(cache), &room, out)) }
}

impl<const WORDS: usize> Scene<'_, WORDS> {
    /// Finds which pairs are near, and what fast bodies touch. cells: at least `SceneConfig::workspace_cells`. After CAPACITY
    /// the update has not begun: move or remove bodies whose pairs do not fit.
    pub fn update(&mut self, cells: &mut [Cell], each: impl FnMut(Report)) -> Result<(), Status> {
        let (room, mut bindings) = (workspace(cells), scene::bindings());
        bindings.workspace = &room;
        self.update_with(bindings, each)
    }
}
