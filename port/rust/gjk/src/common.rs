//! Statuses, numbers, and what scenes of space and of the plane share.
use core::fmt;
use gjk_sys as sys;

pub use sys::{gjk_body_id as BodyId, gjk_scene_hit as SceneHit, gjk_scene_stats as SceneStats};

/// A status that is not OK, as `gjk/status.h` has them.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Status(pub i32);

#[rustfmt::skip]
impl Status {
    pub const NULL: Status = Status(sys::GJK_ERROR_NULL);
    pub const SIZE: Status = Status(sys::GJK_ERROR_SIZE);
    pub const NEGATIVE: Status = Status(sys::GJK_ERROR_NEGATIVE);
    pub const EMPTY: Status = Status(sys::GJK_ERROR_EMPTY);
    pub const CAPACITY: Status = Status(sys::GJK_ERROR_CAPACITY);
    pub const OVERLAP: Status = Status(sys::GJK_ERROR_OVERLAP);
    pub const ROTATION: Status = Status(sys::GJK_ERROR_ROTATION);
    pub const RANGE: Status = Status(sys::GJK_ERROR_RANGE);
    pub const UNINITIALISED: Status = Status(sys::GJK_ERROR_UNINITIALISED);
    pub const ITERATION_LIMIT: Status = Status(sys::GJK_ERROR_ITERATION_LIMIT);
    pub const UNPROVEN: Status = Status(sys::GJK_ERROR_UNPROVEN);
    pub const UNSUPPORTED: Status = Status(sys::GJK_ERROR_UNSUPPORTED);
    pub const BODY_ID: Status = Status(sys::GJK_ERROR_BODY_ID);
    pub const BUSY: Status = Status(sys::GJK_ERROR_BUSY);
    pub const CORRUPT: Status = Status(sys::GJK_ERROR_CORRUPT);
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // SAFETY: the name of any status is text of ASCII with a zero at its end, and lives for ever.
        unsafe {
            let mut at = sys::gjk_status_name(self.0);
            while *at != 0 {
                fmt::Write::write_char(f, *at as char)?;
                at = at.add(1);
            }
        }
        Ok(())
    }
}

impl fmt::Debug for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// Why there is no answer, and what the call has written. After ITERATION_LIMIT and CAPACITY the fields that the header of
/// the query names are proven, and safe to act on; after anything else all of them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Error<T> {
    pub status: Status,
    pub partial: T,
}

impl<T> From<Error<T>> for Status {
    fn from(error: Error<T>) -> Status {
        error.status
    }
}

/// An answer. `?` turns its error into a [`Status`].
pub type Answer<T> = Result<T, Error<T>>;

/// Of a call without an answer.
pub(crate) fn done(status: i32) -> Result<(), Status> {
    if status == sys::GJK_OK {
        Ok(())
    } else {
        Err(Status(status))
    }
}

/// # Safety
/// T may be all zeros, and the call writes a T or leaves it.
pub(crate) unsafe fn answer<T: Copy>(call: impl FnOnce(*mut T) -> i32) -> Answer<T> {
    let mut out: T = core::mem::zeroed();
    match done(call(&mut out)) {
        Ok(()) => Ok(out),
        Err(status) => Err(Error { status, partial: out }),
    }
}

pub(crate) fn pointer_of<T>(option: Option<&T>) -> *const T {
    option.map_or(core::ptr::null(), |value| value as *const T)
}

pub(crate) fn pointer_of_mut<T>(option: Option<&mut T>) -> *mut T {
    option.map_or(core::ptr::null_mut(), |value| value as *mut T)
}

/// Lengths count 2^-16 unit.
pub const Q16_ONE: i32 = sys::GJK_Q16_ONE;
/// Unit vectors, rotations and fractions count 2^-30.
pub const Q30_ONE: i32 = sys::GJK_Q30_ONE;

/// A length in units as an integer, to the nearest, as GJK_Q16; beyond int32 the end of that range. For constants and tools: a
/// game that must have the same bits elsewhere computes in integers.
pub fn q16(units: f64) -> i32 {
    let scaled = units * 65536.0;
    (if scaled < 0.0 { scaled - 0.5 } else { scaled + 0.5 }) as i32
}

/// A length as a float, exactly.
pub fn units(length: i32) -> f64 {
    f64::from(length) / 65536.0
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum BodyKind {
    Static = sys::GJK_BODY_STATIC as u8,
    Kinematic = sys::GJK_BODY_KINEMATIC as u8,
    Dynamic = sys::GJK_BODY_DYNAMIC as u8,
}

/// What is wanted of a pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Detail {
    Touch = sys::GJK_DETAIL_TOUCH as u8,
    Distance = sys::GJK_DETAIL_DISTANCE as u8,
    Depth = sys::GJK_DETAIL_DEPTH as u8,
    Contacts = sys::GJK_DETAIL_CONTACTS as u8,
    Sensor = sys::GJK_DETAIL_SENSOR as u8,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum BodyMotion {
    NotKept = sys::GJK_MOTION_NOT_KEPT as u8,
    Kept = sys::GJK_MOTION_KEPT as u8,
    Fast = sys::GJK_MOTION_FAST as u8,
}

/// What a report tells of a pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Event {
    Begin,
    Persist,
    End,
    Impact,
}

impl Event {
    pub(crate) fn of(event: u8) -> Event {
        match i32::from(event) {
            sys::GJK_EVENT_BEGIN => Event::Begin,
            sys::GJK_EVENT_PERSIST => Event::Persist,
            sys::GJK_EVENT_END => Event::End,
            _ => Event::Impact,
        }
    }
}

/// Which bodies a query looks at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Filter {
    pub category: u32,
    pub mask: u32,
    /// A body to leave out.
    pub ignore: Option<BodyId>,
}

impl Filter {
    pub const ALL: Filter = Filter { category: u32::MAX, mask: u32::MAX, ignore: None };

    pub(crate) fn raw(&self) -> sys::gjk_scene_filter {
        sys::gjk_scene_filter {
            category: self.category,
            mask: self.mask,
            ignore: self.ignore.unwrap_or(BodyId { slot: 0, generation: 0 }),
            accept: None,
            user: core::ptr::null_mut(),
        }
    }
}
