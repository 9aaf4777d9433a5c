//! Shapes and colliders, of space and of the plane: `raw` has the names of a dimension.
use super::{raw, Pose, Vector};
use crate::common::{answer, done, Status};
use core::marker::PhantomData;

/// Geometry in its own frame. It borrows its vertices.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub struct Shape<'a> {
    pub(super) raw: raw::shape,
    vertices: PhantomData<&'a [Vector]>,
}

// SAFETY: a shape is constant, and so is all that it points to.
unsafe impl Send for Shape<'_> {}
unsafe impl Sync for Shape<'_> {}

impl<'a> Shape<'a> {
    /// # Safety
    /// The call makes a shape that points to nothing which 'a does not borrow.
    pub(super) unsafe fn of(call: impl FnOnce(*mut raw::shape) -> i32) -> Result<Shape<'a>, Status> {
        Ok(Shape { raw: answer(call)?, vertices: PhantomData })
    }

    /// The C structure, for the functions of `gjk_sys`.
    pub fn as_raw(&self) -> &raw::shape {
        &self.raw
    }
}

/// A shape at a pose.
pub struct Collider<'a> {
    pub(super) raw: raw::collider,
    lent: PhantomData<(&'a Shape<'a>, &'a mut [Vector])>,
}

// SAFETY: only its owner writes to it and to its buffer.
unsafe impl Send for Collider<'_> {}
unsafe impl Sync for Collider<'_> {}

impl<'a> Collider<'a> {
    pub fn new(shape: &'a Shape<'a>, pose: &Pose) -> Result<Collider<'a>, Status> {
        // SAFETY: the collider borrows its shape.
        unsafe { Collider::make(shape, pose, core::ptr::null_mut(), 0) }
    }

    /// With room for all vertices of a hull or polygon, which are posed once instead of in each query.
    pub fn baked(shape: &'a Shape<'a>, pose: &Pose, room: &'a mut [Vector]) -> Result<Collider<'a>, Status> {
        let capacity = room.len().min(usize::from(u16::MAX)) as u16;
        // SAFETY: the collider borrows its shape, and its buffer alone.
        unsafe { Collider::make(shape, pose, room.as_mut_ptr(), capacity) }
    }

    unsafe fn make(shape: &Shape, pose: &Pose, room: *mut Vector, capacity: u16) -> Result<Collider<'a>, Status> {
        let mut collider = Collider {
            raw: answer(|out| raw::collider_init(out, &shape.raw, room, capacity))?,
            lent: PhantomData,
        };
        collider.set_pose(pose)?;
        Ok(collider)
    }

    /// After an error it stays where it was.
    pub fn set_pose(&mut self, pose: &Pose) -> Result<(), Status> {
        // SAFETY: its shape and buffer are borrowed.
        done(unsafe { raw::collider_pose(&mut self.raw, pose) })
    }

    /// Without turning: cheaper than a pose.
    pub fn set_position(&mut self, position: &Vector) -> Result<(), Status> {
        // SAFETY: as above.
        done(unsafe { raw::collider_move(&mut self.raw, position) })
    }

    pub fn position(&self) -> Vector {
        self.raw.position
    }

    /// The axis-aligned box around it.
    pub fn aabb(&self) -> Result<raw::aabb, Status> {
        // SAFETY: the collider is posed, and an aabb is plain.
        Ok(unsafe { answer(|out| raw::collider_aabb(&self.raw, out)) }?)
    }

    /// The C structure, for the functions of `gjk_sys`.
    pub fn as_raw(&self) -> &raw::collider {
        &self.raw
    }
}
