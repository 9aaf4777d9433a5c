//! Scenes of space and of the plane: many bodies in a block that the scene owns. `raw` has the names of a dimension.
//!
//! SAFETY of all: a block is written by the library alone, or checked when it is opened; the shapes are borrowed for as long
//! as the scene lives; the handle that a call gets is made anew, because a scene may move in memory.
use super::{raw, CastResult, Collider, Manifold, Pose, Shape, Vector, ORIGIN};
use crate::common::{answer, done, pointer_of, BodyId, BodyKind, BodyMotion, Detail, Event, Filter, SceneHit, SceneStats, Status};
use core::ffi::c_void;
use core::mem::zeroed;

pub use raw::{body_state as BodyState, part as Part, scene_config as SceneConfig};

/// A part at the pose of its body. shape: its number in the scene's table.
pub const fn part(shape: u16) -> Part {
    Part { shape, own_pose: false, pose: ORIGIN }
}

/// A part at a pose in the frame of its body.
pub const fn part_at(shape: u16, pose: Pose) -> Part {
    Part { shape, own_pose: true, pose }
}

/// For so many bodies, of one part each; the other fields may be set, and are 0 so far.
pub fn scene_config(bodies: u32, detail: Detail) -> SceneConfig {
    // SAFETY: zeros are numbers.
    let none: SceneConfig = unsafe { zeroed() };
    SceneConfig { bodies, parts: bodies, pairs: 16 * bodies, detail: detail as u8, ..none }
}

/// How many words a scene's block has; 0: a field of the configuration is outside its range.
pub fn scene_words(config: &SceneConfig) -> usize {
    unsafe { raw::scene_bytes(config) / 4 }
}

/// What a body is made of. Fields as of `gjk_body_setup`.
#[derive(Clone, Copy)]
pub struct Body<'p> {
    pub pose: Pose,
    pub parts: &'p [Part],
    pub kind: BodyKind,
    pub detail: Detail,
    pub category: u32,
    pub mask: u32,
    pub user: u32,
    pub margin: i32,
}

impl<'p> Body<'p> {
    /// A body of category 1 that meets all others.
    pub const fn new(parts: &'p [Part], pose: Pose, kind: BodyKind) -> Body<'p> {
        Body { pose, parts, kind, detail: Detail::Touch, category: 1, mask: u32::MAX, user: 0, margin: 0 }
    }

    fn setup(&self) -> Result<raw::body_setup, Status> {
        Ok(raw::body_setup {
            pose: self.pose,
            parts: self.parts.as_ptr(),
            part_count: u16::try_from(self.parts.len()).map_err(|_| Status::CAPACITY)?,
            kind: self.kind as u8,
            detail: self.detail as u8,
            category: self.category,
            mask: self.mask,
            user: self.user,
            margin: self.margin,
        })
    }
}

/// What an update tells of a pair.
#[derive(Clone, Copy)]
pub struct Report<'r> {
    pub a: BodyId,
    pub b: BodyId,
    /// The bodies' words; 0 of one that was removed.
    pub user_a: u32,
    pub user_b: u32,
    pub part_a: u16,
    pub part_b: u16,
    pub event: Event,
    /// Since the pair's last report nothing moved or changed it.
    pub still: bool,
    pub distance: i32,
    /// Of an impact: of the way, Q2.30.
    pub fraction: i32,
    pub manifold: Option<&'r Manifold>,
}

/// Reports of one call of the library.
const ROOM: usize = 4;

/// Many bodies. A clone is a save: assigning it back is a rollback.
#[derive(Clone)]
pub struct Scene<'a, const WORDS: usize> {
    block: [u32; WORDS],
    shapes: &'a [&'a Shape<'a>],
}

impl<'a, const WORDS: usize> Scene<'a, WORDS> {
    /// shapes: all that bodies may have, which name them by their places here. CAPACITY: `scene_words` is more than WORDS.
    pub fn new(config: &SceneConfig, shapes: &'a [&'a Shape<'a>]) -> Result<Self, Status> {
        let mut scene = Scene { block: [0; WORDS], shapes };
        let (table, count) = scene.table()?;
        let (block, bindings) = (scene.block.as_mut_ptr().cast(), bindings());
        unsafe { answer(|out| raw::scene_init(out, config, block, 4 * WORDS, table, count, &bindings))? };
        Ok(scene)
    }

    /// Of the words of [`Scene::seal`], which may come from anywhere: they are checked. The shapes must be those of then.
    pub fn open(block: [u32; WORDS], shapes: &'a [&'a Shape<'a>]) -> Result<Self, Status> {
        let mut scene = Scene { block, shapes };
        let (table, count) = scene.table()?;
        let (block, bindings) = (scene.block.as_mut_ptr().cast(), bindings());
        unsafe { answer(|out| raw::scene_open(out, block, 4 * WORDS, table, count, &bindings))? };
        Ok(scene)
    }

    /// The scene as words with a checksum: what [`Scene::open`] takes, and `gjk_scene_open` on any machine.
    pub fn seal(&mut self) -> Result<&[u32; WORDS], Status> {
        let mut scene = self.handle()?;
        done(unsafe { raw::scene_seal(&mut scene) })?;
        Ok(&self.block)
    }

    // A Shape has the memory of a raw::shape, and a reference that of a pointer.
    fn table(&self) -> Result<(*const *const raw::shape, u16), Status> {
        let count = u16::try_from(self.shapes.len()).map_err(|_| Status::RANGE)?;
        Ok((self.shapes.as_ptr().cast(), count))
    }

    fn handle_with(&mut self, bindings: &raw::scene_bindings) -> Result<raw::scene, Status> {
        let (table, count) = self.table()?;
        let block = self.block.as_mut_ptr().cast();
        Ok(unsafe { answer(|out| raw::scene_attach(out, block, 4 * WORDS, table, count, bindings)) }?)
    }

    fn handle(&mut self) -> Result<raw::scene, Status> {
        self.handle_with(&bindings())
    }

    // For calls that take a constant scene, and so do not write to the block.
    fn constant(&self) -> Result<raw::scene, Status> {
        let (table, count) = self.table()?;
        let block = self.block.as_ptr() as *mut c_void;
        Ok(unsafe { answer(|out| raw::scene_attach(out, block, 4 * WORDS, table, count, &bindings())) }?)
    }

    pub fn add(&mut self, body: &Body) -> Result<BodyId, Status> {
        let (mut scene, setup) = (self.handle()?, body.setup()?);
        Ok(unsafe { answer(|out| raw::scene_add(&mut scene, &setup, out)) }?)
    }

    /// Adds a body to a stated slot.
    pub fn add_at(&mut self, slot: u32, body: &Body) -> Result<BodyId, Status> {
        let (mut scene, setup) = (self.handle()?, body.setup()?);
        Ok(unsafe { answer(|out| raw::scene_add_at(&mut scene, slot, &setup, out)) }?)
    }

    pub fn remove(&mut self, body: BodyId) -> Result<(), Status> {
        done(unsafe { raw::scene_remove(&mut self.handle()?, body) })
    }

    /// Moves a body to its next pose, and wakes it.
    pub fn set_pose(&mut self, body: BodyId, pose: &Pose) -> Result<(), Status> {
        done(unsafe { raw::scene_move(&mut self.handle()?, body, pose) })
    }

    /// As `set_pose`, for a body that does not go on the same way.
    pub fn teleport(&mut self, body: BodyId, pose: &Pose) -> Result<(), Status> {
        done(unsafe { raw::scene_teleport(&mut self.handle()?, body, pose) })
    }

    pub fn sleep(&mut self, body: BodyId) -> Result<(), Status> {
        done(unsafe { raw::scene_sleep(&mut self.handle()?, body) })
    }

    pub fn wake(&mut self, body: BodyId) -> Result<(), Status> {
        done(unsafe { raw::scene_wake(&mut self.handle()?, body) })
    }

    pub fn set_motion(&mut self, body: BodyId, motion: BodyMotion) -> Result<(), Status> {
        done(unsafe { raw::scene_set_motion(&mut self.handle()?, body, motion as u8) })
    }

    pub fn set_shape(&mut self, body: BodyId, part: u16, shape: u16) -> Result<(), Status> {
        done(unsafe { raw::scene_set_shape(&mut self.handle()?, body, part, shape) })
    }

    pub fn set_filter(&mut self, body: BodyId, category: u32, mask: u32) -> Result<(), Status> {
        done(unsafe { raw::scene_set_filter(&mut self.handle()?, body, category, mask) })
    }

    pub fn set_user(&mut self, body: BodyId, user: u32) -> Result<(), Status> {
        done(unsafe { raw::scene_set_user(&mut self.handle()?, body, user) })
    }

    pub fn get(&self, body: BodyId) -> Result<BodyState, Status> {
        let scene = self.constant()?;
        Ok(unsafe { answer(|out| raw::scene_get(&scene, body, out)) }?)
    }

    pub fn stats(&self) -> Result<SceneStats, Status> {
        let scene = self.constant()?;
        Ok(unsafe { answer(|out| raw::scene_get_stats(&scene, out)) }?)
    }

    /// 64 bits over all that decides further answers.
    pub fn hash(&self) -> Result<u64, Status> {
        let scene = self.constant()?;
        Ok(unsafe { answer(|out| raw::scene_hash(&scene, out)) }?)
    }

    pub(super) fn update_with(
        &mut self, mut bindings: raw::scene_bindings, mut each: impl FnMut(Report),
    ) -> Result<(), Status> {
        // SAFETY: zeros are reports and manifolds; each call writes those that are read after it.
        let mut reports: [raw::report; ROOM] = unsafe { zeroed() };
        let mut manifolds: [Manifold; ROOM] = unsafe { zeroed() };
        bindings.manifolds = manifolds.as_mut_ptr();
        let mut scene = self.handle_with(&bindings)?;
        loop {
            let room = reports.as_mut_ptr();
            let progress = unsafe { answer(|out| raw::scene_update(&mut scene, room, ROOM as u32, out))? };
            for report in &reports[..progress.reports as usize] {
                each(Report {
                    a: report.a,
                    b: report.b,
                    user_a: report.user_a,
                    user_b: report.user_b,
                    part_a: report.part_a,
                    part_b: report.part_b,
                    event: Event::of(report.event),
                    still: report.still,
                    distance: report.distance,
                    fraction: report.fraction,
                    // SAFETY: NULL, or one of the manifolds until the next call.
                    manifold: unsafe { report.manifold.as_ref() },
                });
            }
            if progress.pairs_left == 0 && progress.reports_left == 0 {
                return Ok(());
            }
        }
    }

    /// What a ray enters first.
    pub fn cast_ray(&self, from: &Vector, to: &Vector, filter: &Filter) -> Result<Option<(SceneHit, CastResult)>, Status> {
        let (scene, filter) = (self.constant()?, filter.raw());
        first(|hit, result, found| unsafe { raw::scene_cast_ray(&scene, from, to, &filter, hit, result, found) })
    }

    /// What a collider meets first on a straight way.
    pub fn cast(
        &self, collider: &Collider, to: &Vector, margin: i32, filter: &Filter,
    ) -> Result<Option<(SceneHit, CastResult)>, Status> {
        let (scene, filter) = (self.constant()?, filter.raw());
        first(|hit, result, found| unsafe {
            raw::scene_cast(&scene, &collider.raw, to, margin, &filter, hit, result, found)
        })
    }

    /// All parts that are at most reach away from a collider, in order, after a hit: how many there are, of which the first
    /// are written.
    pub fn within(
        &self, collider: &Collider, reach: i32, filter: &Filter, after: Option<&SceneHit>, hits: &mut [SceneHit],
    ) -> Result<u32, Status> {
        let (scene, filter) = (self.constant()?, filter.raw());
        let (room, capacity) = (hits.as_mut_ptr(), hits.len().min(u32::MAX as usize) as u32);
        Ok(unsafe {
            answer(|count| {
                let after = pointer_of(after);
                raw::scene_query_within(&scene, &collider.raw, reach, &filter, after, room, capacity, count)
            })
        }?)
    }

    /// The part that is nearest to a collider, at most reach away, and its distance.
    pub fn nearest(
        &self, collider: &Collider, reach: i32, ignore: Option<&BodyId>,
    ) -> Result<Option<(SceneHit, i32)>, Status> {
        let scene = self.constant()?;
        let (mut hit, mut distance, mut found) = (NO_HIT, 0, false);
        let ignore = pointer_of(ignore);
        done(unsafe {
            raw::scene_query_nearest(&scene, &collider.raw, reach, ignore, &mut hit, &mut distance, &mut found)
        })?;
        Ok(if found { Some((hit, distance)) } else { None })
    }
}

/// Room for hits.
pub const NO_HIT: SceneHit = SceneHit { body: BodyId { slot: 0, generation: 0 }, part: 0, fraction: 0, user: 0 };

fn first(
    call: impl FnOnce(*mut SceneHit, *mut CastResult, *mut bool) -> i32,
) -> Result<Option<(SceneHit, CastResult)>, Status> {
    // SAFETY: zeros are a result.
    let (mut hit, mut result, mut found) = (NO_HIT, unsafe { zeroed() }, false);
    done(call(&mut hit, &mut result, &mut found))?;
    Ok(if found { Some((hit, result)) } else { None })
}

pub(super) fn bindings() -> raw::scene_bindings {
    // SAFETY: the call writes all of it.
    unsafe {
        let mut bindings = zeroed();
        raw::scene_bind_all(&mut bindings);
        bindings
    }
}
