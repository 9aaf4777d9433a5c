//! Queries that space and the plane have alike: `raw` has the names of a dimension.
//!
//! SAFETY of all: a `Collider` is initialised and posed, and borrows what it points to; results are plain, and may be zeros.
use super::{
    raw, Cache, CastResult, Collider, Decision, DistanceResult, ImpactResult, Motion, PenetrationResult, Vector,
    WithinResult,
};
use crate::common::{answer, done, pointer_of, pointer_of_mut, Answer, Status};

/// Nothing is known of the pair yet.
pub fn cache() -> Cache {
    // SAFETY: zeros are a cold cache.
    unsafe { core::mem::zeroed() }
}

/// Do two shapes share a point?
pub fn intersect(a: &Collider, b: &Collider, cache: Option<&mut Cache>) -> Answer<Decision> {
    unsafe { answer(|out| raw::intersect(&a.raw, &b.raw, pointer_of_mut(cache), out)) }
}

/// Are two shapes at most so far apart?
pub fn within(a: &Collider, b: &Collider, most: i32, cache: Option<&mut Cache>) -> Answer<Decision> {
    unsafe { answer(|out| raw::within(&a.raw, &b.raw, most, pointer_of_mut(cache), out)) }
}

/// The same, which gives up after so many iterations.
pub fn within_until(
    a: &Collider, b: &Collider, most: i32, iterations: u8, cache: Option<&mut Cache>,
) -> Answer<WithinResult> {
    unsafe { answer(|out| raw::within_until(&a.raw, &b.raw, most, iterations, pointer_of_mut(cache), out)) }
}

/// How far apart, and where?
pub fn distance(a: &Collider, b: &Collider, cache: Option<&mut Cache>) -> Answer<DistanceResult> {
    unsafe { answer(|out| raw::distance(&a.raw, &b.raw, pointer_of_mut(cache), out)) }
}

/// The same, until so many iterations are spent or the bounds are so near; 0: no such limit.
pub fn distance_until(
    a: &Collider, b: &Collider, iterations: u8, error: i32, cache: Option<&mut Cache>,
) -> Answer<DistanceResult> {
    let effort = raw::effort { iterations, error };
    unsafe { answer(|out| raw::distance_until(&a.raw, &b.raw, &effort, pointer_of_mut(cache), out)) }
}

fn path(to_a: Option<&Vector>, to_b: Option<&Vector>, margin: i32) -> raw::cast_path {
    raw::cast_path { to_a: pointer_of(to_a), to_b: pointer_of(to_b), margin }
}

/// Where do two shapes first touch, or come within the margin, on straight ways to these positions? None: it stands.
pub fn cast(
    a: &Collider, b: &Collider, to_a: Option<&Vector>, to_b: Option<&Vector>, margin: i32,
) -> Answer<CastResult> {
    unsafe { answer(|out| raw::cast(&a.raw, &b.raw, &path(to_a, to_b, margin), out)) }
}

/// Where does a ray first enter a shape?
pub fn cast_ray(a: &Collider, from: &Vector, to: &Vector) -> Answer<CastResult> {
    unsafe { answer(|out| raw::cast_ray(&a.raw, from, to, out)) }
}

/// When do two shapes that move and turn first come within the margin? iterations: 0 for the most there are.
pub fn time_of_impact(
    a: &Collider, motion_a: &Motion, b: &Collider, motion_b: &Motion, margin: i32, tolerance: i32, iterations: u8,
) -> Answer<ImpactResult> {
    let setup = raw::impact_setup { margin, tolerance, iterations };
    unsafe { answer(|out| raw::time_of_impact(&a.raw, motion_a, &b.raw, motion_b, &setup, out)) }
}

/// Proves a decision of [`intersect`], or of [`within`] with its distance, in integers. UNPROVEN: it is not true.
pub fn check_decision(a: &Collider, b: &Collider, most: i32, decision: &Decision) -> Result<(), Status> {
    done(unsafe { raw::check_decision(&a.raw, &b.raw, most, decision) })
}

pub fn check_distance(a: &Collider, b: &Collider, result: &DistanceResult) -> Result<(), Status> {
    done(unsafe { raw::check_distance(&a.raw, &b.raw, result) })
}

pub fn check_penetration(a: &Collider, b: &Collider, result: &PenetrationResult) -> Result<(), Status> {
    done(unsafe { raw::check_penetration(&a.raw, &b.raw, result) })
}

pub fn check_cast(
    a: &Collider, b: &Collider, to_a: Option<&Vector>, to_b: Option<&Vector>, margin: i32, result: &CastResult,
) -> Result<(), Status> {
    done(unsafe { raw::check_cast(&a.raw, &b.raw, &path(to_a, to_b, margin), result) })
}
