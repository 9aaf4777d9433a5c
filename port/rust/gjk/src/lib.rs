//! Exact collision queries on integers: the library gjk for Rust, without std and without allocation.
//!
//! Lengths are integers of 2^-16 unit, which [`q16`] makes; unit vectors and fractions are integers of 2^-30. So every answer
//! has the bits that it has in firmware, and in a game on any other machine.
//!
//! A shape borrows its vertices, a collider its shape, a scene its shapes. Results are plain values. What a call answers, how
//! exactly, and which errors it has, stands in the C header of its name: [`distance`] is `gjk_distance`. [`plane`] is the same
//! in the plane. Bodies of many parts, hulls of points and masses are in the crate `gjk_sys` alone.
#![no_std]

mod common;
pub mod plane;
mod space;

pub use common::*;
pub use space::*;
