// The golden set of queries of tests/check/target/golden.c through the crate gjk: golden PAIRS HASH. Exits with 0 if the hash
// over so many pairs is HASH, in hexadecimal digits.
include!("common.rs");

use gjk::*;

const VERTICES: usize = 16;

struct Run {
    random: Random,
    hash: u64,
    cells: Vec<Cell>,
}

/// What a random body is made of, before its shape borrows it.
struct Plan {
    kind: usize,
    size: Vec3,
    vertices: Vec<Vec3>,
    radius: i32,
    pose: Pose,
    baked: bool,
}

impl Run {
    fn mix(&mut self, words: &[i32]) {
        for byte in words.iter().flat_map(|word| word.to_le_bytes()) {
            self.hash = (self.hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01B3);
        }
    }

    fn mix_vectors(&mut self, vectors: &[Vec3], normal: Option<&Unit3>) {
        for v in vectors {
            self.mix(&[v.x, v.y, v.z]);
        }
        if let Some(n) = normal {
            self.mix(&[n.x, n.y, n.z]);
        }
    }

    fn vector(&mut self, size: i32) -> Vec3 {
        let (x, y) = (self.random.range(-size, size), self.random.range(-size, size));
        vec3(x, y, self.random.range(-size, size))
    }

    fn plan(&mut self, size: i32, reach: i32) -> Plan {
        // Boxes and hulls are chosen twice as often.
        let kind = [0, 1, 2, 3, 3, 4, 4, 4, 5, 6, 7][self.random.below(11) as usize];
        let lengths = [0; 3].map(|_| self.random.range(1, size));
        let count = if kind == 2 { 3 } else { 4 + self.random.below(VERTICES as u32 - 3) };
        let grid = if self.random.below(4) == 0 { size / 2 + 1 } else { 1 }; // coarse: ties, and parallel faces
        let vertices = (0..count)
            .map(|_| self.vector(size))
            .map(|v| vec3(v.x / grid * grid, v.y / grid * grid, v.z / grid * grid))
            .collect();
        let radius = if self.random.below(4) == 0 { self.random.range(0, size / 2) } else { 0 };
        let mut pose = ORIGIN;
        if self.random.below(4) != 0 {
            let q = [1000, 1000, 1000, 1001].map(|high| self.random.range(-1000, high));
            pose.rotation = normalize(&Quat { x: q[0], y: q[1], z: q[2], w: q[3] }).unwrap();
            self.mix(&[0]);
        }
        pose.position = self.vector(reach);
        let baked = self.random.below(2) == 0;
        self.mix(&[0, 0]); // of gjk_collider_init and gjk_collider_pose
        Plan { kind, size: vec3(lengths[0], lengths[1], lengths[2]), vertices, radius, pose, baked }
    }

    fn distance(&mut self, a: &Collider, b: &Collider, cache: Option<&mut Cache>) -> DistanceResult {
        let (status, out) = parts_of(distance(a, b, cache));
        self.mix(&[status, out.intersecting.into(), out.saturated.into(), out.distance]);
        if !out.intersecting {
            self.mix_vectors(&[out.point_a, out.point_b], Some(&out.normal));
        }
        out
    }

    fn decision(&mut self, decision: Answer<Decision>) {
        let (status, out) = parts_of(decision);
        self.mix(&[status, out.yes.into()]);
    }

    fn within_until(&mut self, a: &Collider, b: &Collider, most: i32, iterations: u8) {
        let (status, out) = parts_of(within_until(a, b, most, iterations, None));
        self.mix(&[status, out.answer]);
    }

    fn distance_until(&mut self, a: &Collider, b: &Collider, iterations: u8, error: i32) {
        let (status, out) = parts_of(distance_until(a, b, iterations, error, None));
        self.mix(&[status, out.intersecting.into(), out.distance, out.lower, out.upper]);
        if !out.intersecting {
            self.mix_vectors(&[out.point_a], None);
        }
    }

    fn penetration(&mut self, a: &Collider, b: &Collider, cache: Option<&mut Cache>) {
        let (status, out) = parts_of(penetration(a, b, cache, &mut self.cells));
        self.mix(&[status, out.intersecting.into()]);
        if out.intersecting {
            self.mix(&[out.depth, out.lower, out.upper]);
            self.mix_vectors(&[out.point_a, out.point_b], Some(&out.normal));
        }
    }

    fn contacts(&mut self, a: &Collider, b: &Collider, margin: i32) {
        let (status, out) = parts_of(contacts(a, b, margin, 4, None, &mut self.cells));
        self.mix(&[status, out.count.into()]);
        for c in &out.contact[..out.count.into()] {
            self.mix_vectors(&[c.point_a, c.point_b], None);
            self.mix(&[c.distance, c.id.into()]);
        }
    }

    fn pair(&mut self) {
        let size = 1 << (3 + self.random.below(23));
        let far = self.random.below(8) == 0;
        let reach = if far { i32::MAX } else { 2 * size };
        let (plan_a, plan_b) = (self.plan(size, reach), self.plan(size, reach));
        let (shape_a, shape_b) = (plan_a.shape(), plan_b.shape());
        let (mut room_a, mut room_b) = ([vec3(0, 0, 0); VERTICES], [vec3(0, 0, 0); VERTICES]);
        let a = plan_a.place(&shape_a, &mut room_a);
        let mut b = plan_b.place(&shape_b, &mut room_b);
        let mut warm = cache();
        let mut found = self.distance(&a, &b, None);
        self.decision(intersect(&a, &b, None));
        self.decision(within(&a, &b, found.distance, None));
        found = self.distance(&a, &b, Some(&mut warm));
        self.penetration(&a, &b, Some(&mut warm));
        self.contacts(&a, &b, 0);
        if !found.intersecting && !far {
            let by = found.distance + self.random.range(-2, 2);
            let part = |n: i32| (i64::from(n) * i64::from(by) / i64::from(Q30_ONE)) as i32;
            let (at, n) = (b.position(), found.normal);
            b.set_position(&vec3(at.x - part(n.x), at.y - part(n.y), at.z - part(n.z))).unwrap();
            self.mix(&[0]);
            found = self.distance(&a, &b, Some(&mut warm));
            self.decision(intersect(&a, &b, Some(&mut warm)));
            self.decision(within(&a, &b, 1, None));
            self.within_until(&a, &b, 1 + size / 32, 1);
            self.within_until(&a, &b, found.distance, 2);
            self.distance_until(&a, &b, 2, 0);
            self.distance_until(&a, &b, 0, 1 + size / 16);
            self.penetration(&a, &b, None);
            self.contacts(&a, &b, size / 8);
        }
    }
}

impl Plan {
    fn shape(&self) -> Shape<'_> {
        let (v, s, r) = (&self.vertices, self.size, self.radius);
        match self.kind {
            0 => Shape::sphere(r),
            1 => Shape::capsule(r, s.z),
            2 => Shape::triangle(v[..].try_into().unwrap(), r),
            3 => Shape::cuboid(s, r),
            4 => Shape::hull(v, r),
            5 => Shape::cylinder(s.x, s.z, r),
            6 => Shape::cone(s.x, s.z, r),
            _ => Shape::ellipsoid(s, r),
        }
        .unwrap()
    }

    fn place<'a>(&self, shape: &'a Shape<'a>, room: &'a mut [Vec3]) -> Collider<'a> {
        if self.baked {
            Collider::baked(shape, &self.pose, room).unwrap()
        } else {
            Collider::new(shape, &self.pose).unwrap()
        }
    }
}

fn parts_of<T>(answer: Answer<T>) -> (i32, T) {
    match answer {
        Ok(out) => (0, out),
        Err(error) => (error.status.0, error.partial),
    }
}

fn hash_of(pairs: u32) -> u64 {
    let cells = vec![CELL; cells_for(20)];
    let mut run = Run { random: Random::new(2026), hash: 0xCBF2_9CE4_8422_2325, cells };
    for _ in 0..pairs {
        run.pair();
    }
    run.hash
}

fn main() {
    std::process::exit(judge(hash_of));
}
