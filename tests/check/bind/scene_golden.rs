// The matches of tests/support/scene through the crate gjk, with saves and rollbacks: scene_golden TICKS HASH [plane]. Exits
// with 0 if the hash over so many ticks is HASH, in hexadecimal digits.
include!("common.rs");

const PRIME: u64 = 0x100_0000_01B3;

mod space {
    use super::{Random, PRIME};
    use gjk::{Vec3 as Vector, Quat as Turn, UPRIGHT as TURN, *};

    const WALL: u16 = 5;
    const REACH: i32 = 3 << 16;
    const AXES: u32 = 3;
    const WORDS: usize = 5000;
    const CELLS: usize = 400;

    const CORNERS: [Vec3; 8] = [
        vec3(30000, 2000, 1000), vec3(-28000, 9000, -3000), vec3(5000, 31000, 2000), vec3(-3000, -30000, 4000),
        vec3(1000, 2000, 33000), vec3(-2000, 900, -31000), vec3(20000, 20000, 12000), vec3(-19000, -18000, -9000),
    ];

    fn along(v: &mut Vec3, axis: u32) -> &mut i32 {
        match axis { 0 => &mut v.x, 1 => &mut v.y, _ => &mut v.z }
    }

    fn turn_of(slot: u32, tick: u32) -> Quat {
        let [x, y, z] = [4, 5, 6].map(|c| dice(slot, tick, c, 300));
        Quat { x, y, z, w: 30000 }
    }

    fn sum_of(m: &Manifold) -> i32 {
        let n = m.normal;
        let contact = |c: &Contact| {
            c.point_a.x % 5 + c.point_a.y % 7 + c.point_b.z % 11 + c.distance % 13 + i32::from(c.id)
        };
        n.x % 5 + n.y % 7 + n.z % 11 + i32::from(m.feature_a) + i32::from(m.feature_b)
            + m.contact[..m.count.into()].iter().map(contact).sum::<i32>()
    }

    fn config() -> SceneConfig {
        let (bodies, workspace_cells) = (BODIES as u32, CELLS as u32);
        SceneConfig {
            parts: 2 * bodies, own_poses: bodies, pairs: 160, box_margin: q16(0.1), persist: 1, workspace_cells,
            ..scene_config(bodies, Detail::Touch)
        }
    }

    fn update(scene: &mut Scene<WORDS>, each: impl FnMut(Report)) {
        scene.update(&mut [CELL; CELLS], each).unwrap();
    }

    pub fn run(ticks: u32) -> u64 {
        let shapes = [
            Shape::cuboid(vec3(q16(0.5), q16(0.5), q16(0.5)), 0), Shape::sphere(q16(0.5)),
            Shape::capsule(q16(0.25), q16(0.4)), Shape::hull(&CORNERS, 0), Shape::cylinder(q16(0.5), q16(0.375), 0),
            Shape::cuboid(vec3(q16(6.0), q16(6.0), q16(0.25)), 0),
        ]
        .map(Result::unwrap);
        let table: Vec<&Shape> = shapes.iter().collect();
        hash_of(ticks, Match::start(&table))
    }

    include!("match_rules.rs");
}

mod plane {
    use super::{Random, PRIME};
    use gjk::plane::{Rotation as Turn, Vec2 as Vector, UPRIGHT as TURN, *};
    use gjk::{q16, BodyId, BodyKind, Detail, Event};

    const WALL: u16 = 6;
    const REACH: i32 = 4 << 16;
    const AXES: u32 = 2;
    const WORDS: usize = 4000;

    const CORNERS: [Vec2; 6] = [
        vec2(30000, 2000), vec2(9000, 29000), vec2(-25000, 20000), vec2(-28000, -9000), vec2(-3000, -30000),
        vec2(19000, -18000),
    ];
    const SAIL: [Vec2; 3] = [vec2(-40000, -9000), vec2(41000, 0), vec2(3000, 52000)];

    fn along(v: &mut Vec2, axis: u32) -> &mut i32 {
        if axis == 0 { &mut v.x } else { &mut v.y }
    }

    fn turn_of(slot: u32, tick: u32) -> Rotation {
        Rotation { c: 30000, s: dice(slot, tick, 4, 500) }
    }

    fn sum_of(m: &Manifold) -> i32 {
        let contact = |c: &Contact| {
            c.point_a.x % 5 + c.point_a.y % 7 + c.point_b.x % 11 + c.distance % 13 + i32::from(c.id)
        };
        m.normal.x % 5 + m.normal.y % 7 + i32::from(m.feature_a) + i32::from(m.feature_b)
            + m.contact[..m.count.into()].iter().map(contact).sum::<i32>()
    }

    fn config() -> SceneConfig {
        let bodies = BODIES as u32;
        SceneConfig {
            parts: 2 * bodies, own_poses: bodies, pairs: 160, box_margin: q16(0.1), persist: 1,
            ..scene_config(bodies, Detail::Touch)
        }
    }

    fn update(scene: &mut Scene<WORDS>, each: impl FnMut(Report)) {
        scene.update(each).unwrap();
    }

    pub fn run(ticks: u32) -> u64 {
        let shapes = [
            Shape::rectangle(vec2(q16(0.5), q16(0.5)), 0), Shape::circle(q16(0.5)),
            Shape::capsule(q16(0.25), q16(0.4)), Shape::polygon(&CORNERS, 0),
            Shape::ellipse(vec2(q16(0.5), q16(0.375)), 0), Shape::triangle(&SAIL, 0),
            Shape::rectangle(vec2(q16(6.0), q16(0.25)), 0),
        ]
        .map(Result::unwrap);
        let table: Vec<&Shape> = shapes.iter().collect();
        hash_of(ticks, Match::start(&table))
    }

    include!("match_rules.rs");
}

fn main() {
    let of_plane = std::env::args().nth(3).is_some();
    std::process::exit(judge(if of_plane { plane::run } else { space::run }));
}
