//! The skeleton of the paper's introduction: two hundred freedoms, and few motors.

use crate::mechanisms::precisions::{exhibited, mechanism};
use mech_runtime::Real;

mechanism! {
    /// The paper's skeleton: a figure in profile, whose bones have more than two hundred freedoms, and the eight motors that walk it.
    pub struct Skeleton;

    // A bone lies along the x axis of its place where `turn` is 0. Those of higher hues are painted farther back.
    part Bone(l = 1, w = 1, hue = 13) {
        port on { point socket = (0, 0); } joint turn = revolute(on.socket, bone.head);
        link bone { point head = (0, 0); point tip = (l, 0); polygon [(-w, 0), (-w / 2, -w), (w / 2, -w), (w, -w / 2), (l - w, -w / 2),
            (l - w / 2, -w), (l + w / 2, -w), (l + w, 0), (l + w / 2, w), (l - w / 2, w), (l - w, w / 2), (w, w / 2), (w / 2, w),
            (-w / 2, w)] on plane -hue color hue; }
    }
    // It turns on its place as its driver does there, but less.
    part Geared(l = 1, w = 1, hue = 13, tenths = 1, bend = 0 deg) {
        port on; port driver; use it: Bone(l = l, w = w, hue = hue) { on = on };
        joint mesh = gear(driver, it.bone, tenths : 10 on on); start { it.turn = bend; }
    }
    // Three of them, one on the other: a rib, if nothing else is said.
    part Three(a = 9, b = 10, c = 5, w = 0.8, hue = 13, tenths = 1, bend = 25 deg) {
        port on; port driver; use one: Geared(l = a, w = w, hue = hue, tenths = tenths, bend = bend) { on = on, driver = driver };
        use two: Geared(l = b, w = w, hue = hue, tenths = 6, bend = bend) { on = one.it.bone at (a, 0), driver = on };
        use end: Geared(l = c, w = w, hue = hue, tenths = 6, bend = bend) { on = two.it.bone at (b, 0), driver = one.it.bone };
    }
    part Digit(hue = 13) {
        port on; port driver; use palm: Three(a = 1, b = 1.5, w = 0.5, hue = hue, bend = 0 deg) { on = on, driver = driver };
        use tip: Three(a = 3, b = 2, c = 1.5, w = 0.5, hue = hue, bend = 8 deg) { on = palm.end.it.bone at (5, 0), driver = palm.two.it.bone };
    }
    part Arm(hue = 4) {
        port chest; use humerus: Bone(l = 30, w = 1.8, hue = hue) { on = chest turned -92 deg };
        use girdle[2]: Geared(l = 11 - 3 * k, w = 1.2, hue = hue) { on = chest at (2 * k - 3, 1) turned (100 * k - 115) * PI / 180, driver = humerus.bone };
        use forearm[2]: Geared(l = 25 - k, hue = hue, tenths = 6, bend = (32 + 3 * k) * PI / 180) { on = humerus.bone at (30, k), driver = chest };
        use digit[5]: Digit(hue = hue) { on = forearm[0].it.bone at (25.5, 1.4 - 0.6 * k) turned (6 - 4 * k) * PI / 180, driver = humerus.bone };
    }
    part Leg(hue = 4) {
        port hip; use femur: Bone(l = 43, w = 2.4, hue = hue) { on = hip turned -90 deg };
        use tibia: Bone(l = 40, w = 2, hue = hue) { on = femur.bone at (43, 0) };
        use talus: Bone(l = 5, w = 2.2, hue = hue) { on = tibia.bone at (41, 0) turned 60 deg };
        use heel: Geared(l = 6, w = 2, hue = hue) { on = talus.bone at (2, -1) turned -100 deg, driver = tibia.bone };
        use toe[5]: Digit(hue = hue) { on = talus.bone at (5, 1 - 0.5 * k) turned (10 - k) * PI / 180, driver = tibia.bone };
    }
    part Ribs {
        port on; port driver; use spine: Three(a = 2, b = 2, c = 2, w = 1.3, tenths = 6, bend = -3 deg) { on = on, driver = driver };
        use low[2]: Three(hue = 45 - 32 * k) { on = spine.one.it.bone at (1.2, -1) turned -150 deg, driver = on };
        use mid[2]: Three(hue = 45 - 32 * k) { on = spine.two.it.bone at (1.2, -1) turned -150 deg, driver = spine.one.it.bone };
        use top[2]: Three(hue = 45 - 32 * k) { on = spine.end.it.bone at (1.2, -1) turned -150 deg, driver = spine.two.it.bone };
    }

    look none; ground { line road = (0, 0) -> (1, 0); rail [(-60, 0), (260, 0)] width 6; }
    link carriage { line keel = (0, 0) -> (1, 0); line mast = (0, 0) -> (0, 1); }
    link pelvis { line mast = (0, 0) -> (0, 1); polygon [(-7, 11), (3, 9), (8, 2), (3, -4), (-2, -8), (-5, -3), (-9, 5)] on plane -12 color 13; }
    joint walk = prismatic(ground.road, carriage.keel); joint rise = prismatic(carriage.mast, pelvis.mast);
    joint bob = cam(walk, rise, 86.8 - 1.7 * cos(4 * PI * q / 100)); use leg[2]: Leg(hue = 36 - 32 * k) { hip = pelvis };
    use loin: Three(a = 6, b = 6, c = 6, w = 1.8, bend = 11 deg) { on = pelvis at (-5, 8) turned 70 deg, driver = leg[1].femur.bone };
    use low: Ribs { on = loin.end.it.bone at (6, 0), driver = loin.two.it.bone };
    use mid: Ribs { on = low.spine.end.it.bone at (2, 0), driver = low.spine.two.it.bone };
    use high: Ribs { on = mid.spine.end.it.bone at (2, 0), driver = mid.spine.two.it.bone };
    use top: Ribs scaled 0.8 { on = high.spine.end.it.bone at (2, 0), driver = high.spine.two.it.bone };
    use neck: Three(a = 4, b = 4, c = 4, w = 1.2, tenths = 6, bend = 8 deg) { on = top.spine.end.it.bone at (1.6, 0), driver = top.spine.two.it.bone };
    use arm[2]: Arm(hue = 36 - 32 * k) { chest = top.spine.end.it.bone at (0, -4 + k) turned -70 deg };
    joint swing = gear(arm[0].humerus.bone, arm[1].humerus.bone, 1 : 1 on top.spine.end.it.bone);
    link skull { point base = (0, 0); point hinge = (1, -1.5); circle (9, -6) radius 1.8 on plane 2 color paper; polygon [(0, 1), (3, 6), (9, 9),
        (16, 7), (19, 0), (17, -7), (12, -10), (7, -9), (4, -10.5), (1, -9), (1, -4)] on plane -12 color 13; }
    link jaw { point hinge = (0, 0); polygon [(1, 0.5), (-3, -1), (-5, -6), (-4, -8), (-1, -7.5), (-1.5, -2), (1, -1)] on plane -12 color 13; }
    joint nod = revolute(neck.end.it.bone.tip, skull.base); joint nods = gear(neck.two.it.bone, skull, 1 : 2 on neck.end.it.bone);
    joint bite = revolute(skull.hinge, jaw.hinge); joint bites = gear(neck.end.it.bone, jaw, 1 : 2 on skull);
    motor walk; motor arm[0].humerus.turn; motor leg[0].femur.turn; motor leg[0].tibia.turn; motor leg[0].talus.turn;
    motor leg[1].femur.turn; motor leg[1].tibia.turn; motor leg[1].talus.turn; start { arm[0].humerus.turn = 0.4; leg[0].femur.turn = 0.55;
        leg[0].tibia.turn = -0.39; leg[1].femur.turn = 0.06; leg[1].tibia.turn = -0.65; leg[1].talus.turn = 0.49; }
}

exhibited!(Skeleton, "skeleton", "skeleton.rs", motion);

/// Two steps of each leg forwards, and the same backwards.
fn motion<T: Real>(phase: T) -> [T; 8] {
    let (_, cos) = Real::sin_cos(phase * T::TURN);
    let strides = T::ONE - cos;
    let (_, swing) = Real::sin_cos(strides * T::TURN);
    let near = leg(strides);
    let far = leg(strides + T::from_f64(0.5));
    let walk = T::from_f64(100.0) * strides;
    let swing = T::from_f64(0.4) * swing;
    [walk, swing, near[0], near[1], near[2], far[0], far[1], far[2]]
}

/// Hip, knee and ankle after so many strides of 100: harmonics that keep the foot where it stands, to within 0.3.
fn leg<T: Real>(strides: T) -> [T; 3] {
    const HIP: [f64; 9] = [0.326, 0.3, 0.001, -0.012, -0.129, -0.056, 0.018, -0.009, 0.009];
    const KNEE: [f64; 9] = [-0.675, 0.043, 0.215, 0.14, 0.097, 0.086, -0.072, 0.013, -0.016];
    const ANKLE: [f64; 9] = [0.3, -0.177, -0.132, -0.093, -0.119, -0.072, 0.079, 0.033, 0.001];
    [HIP, KNEE, ANKLE].map(|[mean, waves @ ..]| {
        let mut angle = T::from_f64(mean);
        let mut times = T::ONE;
        for wave in waves.as_chunks::<2>().0 {
            let (sin, cos) = Real::sin_cos(strides * times * T::TURN);
            angle = angle + T::from_f64(wave[0]) * cos + T::from_f64(wave[1]) * sin;
            times = times + T::ONE;
        }
        angle
    })
}
