// The rules of the match of tests/support/scene/match_rules.h, for space and for the plane. Before them comes what a dimension
// has of its own: Vector, Turn, TURN, WALL, REACH, AXES, along, turn_of, sum_of, config, update.

const BODIES: usize = 24;
const DETAILS: [Detail; 6] =
    [Detail::Distance, Detail::Touch, Detail::Touch, Detail::Distance, Detail::Depth, Detail::Contacts];

#[derive(Clone, Copy)]
struct Mover {
    id: BodyId,
    step: Vector,
    turn: Turn,
}

#[derive(Clone)]
pub struct Match<'a> {
    tick: u32,
    movers: [Mover; BODIES],
    scene: Scene<'a, WORDS>,
}

fn scramble(mut x: u32) -> u32 {
    x = (x ^ x >> 16).wrapping_mul(0x7FEB_352D);
    x = (x ^ x >> 15).wrapping_mul(0x846C_A68B);
    x ^ x >> 16
}

fn dice(a: u32, b: u32, c: u32, limit: i32) -> i32 {
    (scramble(scramble(scramble(a) ^ b) ^ c) % (2 * limit as u32 + 1)) as i32 - limit
}

fn bounce(at: i32, step: i32) -> i32 {
    if (at > REACH && step > 0) || (at < -REACH && step < 0) { -step } else { step }
}

impl<'a> Match<'a> {
    pub fn start(shapes: &'a [&'a Shape<'a>]) -> Match<'a> {
        let none = Mover { id: BodyId { slot: 0, generation: 0 }, step: ORIGIN.position, turn: TURN };
        let scene = Scene::new(&config(), shapes).unwrap();
        let mut made = Match { tick: 0, movers: [none; BODIES], scene };
        for slot in 0..BODIES as u32 {
            made.add(slot);
        }
        made
    }

    fn add(&mut self, slot: u32) {
        let fixed = slot as usize == BODIES - 1;
        let (tick, mut step, mut pose, mut up) = (self.tick, ORIGIN.position, ORIGIN, ORIGIN);
        *along(&mut up.position, AXES - 1) = q16(0.75);
        for axis in 0..AXES {
            *along(&mut pose.position, axis) = match (fixed, axis == AXES - 1) {
                (false, _) => dice(slot, tick, 1 + axis, REACH),
                (true, last) => if last { -REACH } else { 0 },
            };
            *along(&mut step, axis) = if slot < 2 { 0 } else { dice(slot, tick, 7 + axis, 3000) };
        }
        let parts = [part(if fixed { WALL } else { slot as u16 % WALL }), part_at(1, up)];
        let count = if slot % 6 == 5 && !fixed { 2 } else { 1 };
        let kind = if fixed { BodyKind::Static } else if slot < 2 { BodyKind::Kinematic } else { BodyKind::Dynamic };
        let mut body = Body::new(&parts[..count], pose, kind);
        body.detail = DETAILS[slot as usize % 6];
        body.user = slot;
        body.margin = if slot % 4 == 0 { q16(0.125) } else { 0 };
        let turn = normalize(&turn_of(slot, tick)).unwrap();
        self.movers[slot as usize] = Mover { id: self.scene.add_at(slot, &body).unwrap(), step, turn };
    }

    fn set_off(&mut self, slot: usize, input: u32) {
        let mover = &mut self.movers[slot];
        let state = self.scene.get(mover.id).unwrap();
        if state.kind == BodyKind::Static as u8 || state.asleep {
            return;
        }
        let (push, mut pose) = (if input & 8 != 0 { -2000 } else { 2000 }, state.pose);
        for axis in 0..AXES {
            let (at, step) = (along(&mut pose.position, axis), along(&mut mover.step, axis));
            *step = bounce(*at, if input & 1 << axis != 0 { push } else { *step });
            *at += *step;
        }
        if slot >= 2 || input & 16 != 0 {
            pose.rotation = compose(&mover.turn, &pose.rotation).unwrap();
        }
        self.scene.set_pose(mover.id, &pose).unwrap();
    }

    fn act(&mut self, input: u32) {
        let slot = 2 + self.tick % (BODIES as u32 - 3);
        let id = self.movers[slot as usize].id;
        if input & 32 != 0 && self.tick % 5 == 0 {
            self.scene.set_shape(id, 0, self.tick as u16 % WALL).unwrap();
        }
        if input & 64 != 0 && self.tick % 7 == 0 {
            self.scene.remove(id).unwrap();
            self.add(slot);
        }
        if input & 128 != 0 && self.tick % 3 == 0 {
            let id = self.movers[slot as usize].id;
            let asleep = self.scene.get(id).unwrap().asleep;
            if asleep { self.scene.wake(id) } else { self.scene.sleep(id) }.unwrap();
        }
    }

    fn react(movers: &mut [Mover; BODIES], report: Report) {
        let (a, b) = (report.a.slot as usize, report.b.slot as usize);
        if movers[a].id != report.a || movers[b].id != report.b {
            return;
        }
        if report.event == Event::Begin {
            let step = movers[a].step;
            movers[a].step = movers[b].step;
            movers[b].step = step;
        }
        let step = &mut movers[b].step;
        match report.event {
            Event::Begin => {}
            Event::Persist => step.x += report.manifold.map_or(report.distance, sum_of) % 7 - 3,
            _ => step.y += i32::from(report.part_b) + 1,
        }
        step.x = if step.x > 4000 { 3000 } else if step.x < -4000 { -3000 } else { step.x };
        step.y = if step.y > 4000 { -3000 } else { step.y };
    }

    fn play(&mut self, inputs: [u32; 2]) {
        for slot in 0..BODIES {
            self.set_off(slot, if slot < 2 { inputs[slot] } else { 0 });
        }
        inputs.iter().for_each(|&input| self.act(input));
        let movers = &mut self.movers;
        update(&mut self.scene, |report| Match::react(movers, report));
        self.tick += 1;
    }

    fn hash(&self) -> u64 {
        let mut value = self.scene.hash().unwrap();
        for mover in &self.movers {
            let mut step = mover.step;
            let words = (0..AXES).map(|axis| *along(&mut step, axis) as u32).chain([mover.id.generation]);
            value = words.fold(value, |value, word| (value ^ u64::from(word)).wrapping_mul(PRIME));
        }
        value
    }
}

fn input_of(tick: u32, player: u64) -> u32 {
    let any = Random::new(u64::from(tick) * 2 + player).u32();
    any & any >> 8 & 0xFF
}

/// The hash over so many ticks, with rollbacks.
pub fn hash_of(ticks: u32, start: Match) -> u64 {
    let (mut sum, mut random, mut i) = (0xCBF2_9CE4_8422_2325_u64, Random::new(3), 0);
    let (mut playing, mut rollbacks) = (start, 0);
    let mut saved = (playing.clone(), sum);
    while i < ticks {
        let what = random.below(100);
        if what < 3 || i.wrapping_sub(saved.0.tick) > 30 {
            saved = (playing.clone(), sum);
        } else if what < 5 {
            (playing, sum) = saved.clone();
            i = playing.tick;
            rollbacks += 1;
        }
        playing.play([input_of(i, 0), input_of(i, 1)]);
        sum = (sum ^ playing.hash()).wrapping_mul(PRIME);
        i += 1;
    }
    assert!(rollbacks > 0);
    sum
}
