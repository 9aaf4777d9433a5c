// What the crate gjk does around the calls: errors with what is proven, saves, queries of scenes.
use gjk::*;

fn pairs() -> Result<(), Status> {
    assert_eq!(Shape::sphere(-1).err(), Some(Status::NEGATIVE));
    assert_eq!(Shape::hull(&[], 0).err(), Some(Status::EMPTY));
    assert_eq!(Shape::hull(&vec![vec3(0, 0, 0); 65536], 0).err(), Some(Status::RANGE));
    assert_eq!(format!("{}", Status::NEGATIVE), "GJK_ERROR_NEGATIVE");
    assert!(Faces::new(&[0, 1, 2], &[4]).is_err() && Faces::new(&[0, 1, 2], &[3, 2]).is_err());
    assert_eq!((q16(0.5), q16(-0.5), q16(1e9), units(q16(-1.25))), (32768, -32768, i32::MAX, -1.25));

    let cube = Shape::cuboid(vec3(65536, 65536, 65536), 0)?;
    let mut a = Collider::new(&cube, &ORIGIN)?;
    let bad = Pose { rotation: Quat { x: 0, y: 0, z: 0, w: 5 }, ..ORIGIN };
    assert_eq!(a.set_pose(&bad), Err(Status::ROTATION));
    assert_eq!(Collider::new(&cube, &bad).err(), Some(Status::ROTATION));
    let b = Collider::new(&cube, &pose(131072, 0, 0))?;
    assert!(intersect(&a, &b, None)?.yes);
    assert_eq!(contacts(&a, &b, 0, 4, None, &mut [])?.count, 4);
    assert_eq!(a.aabb()?.upper, vec3(65536, 65536, 65536));
    let mut gap = distance(&a, &b, None)?;
    check_distance(&a, &b, &gap)?;
    gap.intersecting = false;
    assert_eq!(check_distance(&a, &b, &gap), Err(Status::UNPROVEN));

    // A depth without room for it: the depth is enough, if not the least.
    let (corners, mut cells) = (corners(), vec![CELL; cells_for(16)]);
    let stone = Shape::hull(&corners, 0)?;
    let (c, d) = (Collider::new(&stone, &ORIGIN)?, Collider::new(&stone, &pose(1000, 0, 0))?);
    let error = penetration(&c, &d, None, &mut []).unwrap_err();
    let deep = penetration(&c, &d, None, &mut cells)?;
    assert!(error.status == Status::CAPACITY && error.partial.intersecting && error.partial.depth >= deep.depth);
    check_penetration(&c, &d, &deep)?;

    let way = cast(&a, &b, Some(&vec3(0, 0, 65536)), Some(&vec3(131072, 0, 400000)), 0)?;
    check_cast(&a, &b, Some(&vec3(0, 0, 65536)), Some(&vec3(131072, 0, 400000)), 0, &way)?;
    let motion = |x: i32, to: i32| Motion { from: pose(x, 0, 0), to: pose(to, 0, 0), spin: vec3(0, 0, 0) };
    let hit = time_of_impact(&a, &motion(0, 0), &b, &motion(400000, 0), 0, 16, 0)?;
    assert!(hit.hit && hit.lower > Q30_ONE / 2);
    Ok(())
}

fn corners() -> [Vec3; 8] {
    let mut corners = [vec3(0, 0, 0); 8];
    for (i, v) in corners.iter_mut().enumerate() {
        let sign = |bit: usize| if i >> bit & 1 != 0 { 30000 + 100 * i as i32 } else { -30000 };
        *v = vec3(sign(0), sign(1), sign(2));
    }
    corners
}

fn scenes() -> Result<(), Status> {
    let (cube, ball) = (Shape::cuboid(vec3(65536, 65536, 65536), 0)?, Shape::sphere(32768)?);
    let shapes = [&cube, &ball];
    let mut config = scene_config(4, Detail::Distance);
    assert!(scene_words(&config) > 100 && scene_words(&config) < 1500);
    assert_eq!(Scene::<50>::new(&config, &shapes).err(), Some(Status::CAPACITY));
    config.own_poses = 1;
    config.motions = 4;
    let mut scene = Scene::<1500>::new(&config, &shapes)?;
    let first = scene.add(&Body::new(&[part(0)], ORIGIN, BodyKind::Static))?;
    let second = scene.add(&Body::new(&[part(1), part_at(0, pose(0, 0, 65536))], pose(300000, 0, 0), BodyKind::Dynamic))?;
    assert_eq!(scene.add_at(1, &Body::new(&[part(1)], ORIGIN, BodyKind::Static)).err(), Some(Status::BODY_ID));
    assert_eq!(scene.add(&Body::new(&[], ORIGIN, BodyKind::Static)).err(), Some(Status::EMPTY));
    assert_eq!(scene.sleep(first), Err(Status::RANGE));
    scene.set_motion(second, BodyMotion::Fast)?;
    scene.set_user(second, 77)?;
    scene.set_filter(second, 3, u32::MAX)?;
    scene.update(&mut [], |_| panic!("nothing is near"))?;

    // A clone is a save, and so are sealed words; all go on alike.
    let mut copy = scene.clone();
    let mut words = *scene.seal()?;
    let mut opened = Scene::<1500>::open(words, &shapes)?;
    words[20] ^= 1;
    assert_eq!(Scene::<1500>::open(words, &shapes).err(), Some(Status::CORRUPT));
    assert_eq!(Scene::<1500>::open([0; 1500], &shapes).err(), Some(Status::CORRUPT));
    let mut events = Vec::new();
    for one in [&mut scene, &mut copy, &mut opened] {
        one.set_pose(second, &pose(-300000, 0, 0))?;
        let mut seen = Vec::new();
        one.update(&mut [], |report| seen.push((report.event, report.a, report.user_a, report.part_a, report.fraction)))?;
        events.push(seen);
    }
    assert!(events[0].len() == 1 && events[0][0].0 == Event::Impact && events[0][0].1 == second && events[0][0].2 == 77);
    assert!(events[0] == events[1] && events[1] == events[2]);
    assert_eq!((scene.hash()?, copy.hash()?), (copy.hash()?, opened.hash()?));
    assert_eq!((scene.get(second)?.user, scene.stats()?.bodies), (77, 2));

    let (hit, result) = scene.cast_ray(&vec3(0, 0, 900000), &ORIGIN.position, &Filter::ALL)?.unwrap();
    assert!(hit.body == first && result.hit && result.point_a.z == 65536);
    let others = Filter { ignore: Some(first), ..Filter::ALL };
    assert!(scene.cast_ray(&vec3(0, 0, 900000), &ORIGIN.position, &others)?.is_none());
    let probe = Collider::new(&ball, &pose(0, 0, 400000))?;
    let (near, gap) = scene.nearest(&probe, 1 << 24, None)?.unwrap();
    assert!(near.body == first && gap == 400000 - 65536 - 32768);
    assert!(scene.cast(&probe, &ORIGIN.position, 0, &Filter::ALL)?.unwrap().0.body == first);
    let mut hits = [NO_HIT; 2];
    assert!(scene.within(&probe, 1 << 22, &Filter::ALL, None, &mut hits)? == 3 && hits[0].body == first);
    let last = hits[1];
    assert!(scene.within(&probe, 1 << 22, &Filter::ALL, Some(&last), &mut hits)? == 1 && hits[0].body == second);
    assert_eq!(hits[0].user, 77);
    scene.remove(first)?;
    assert_eq!(scene.get(first).err(), Some(Status::BODY_ID));
    Ok(())
}

fn main() -> Result<(), Status> {
    pairs()?;
    scenes()
}
