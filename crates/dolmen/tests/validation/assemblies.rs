// SOURCE     Least thickness of semicircular arches of flat-faced voussoirs: recomputed by a separate linear programme (hinges at the
//            corners, no sliding), close to Milankovitch's 0.107478; leaning slabs and corbels by hand; random arches by microlp 0.7 in
//            the plane, from the geometry instead of the joints that the crate finds.
// GOAL       Equilibrium decides whether an assembly is stable: arches with odd and even numbers of stones, leaning slabs, corbels.
// TOLERANCE  1e-4 of t/R by bisection of the verdict; 1e-6 of the acceleration; no difference in the verdict.

use dolmen::assess::{
    MARGINAL_BELOW_G, SettleRun, StackCheckOptions, StackNote, check_stack, with_settle_run,
};
use dolmen::numeric::Random;
use dolmen::stability::Verdict;
use dolmen::stability::stack::{JointMotion, LimitAnalysis, LimitAnalysisStatus, Shaking, limit_analysis};
use dolmen::structure::stack::{Block, JointMaterial, Solid, Stack};
use microlp::{ComparisonOp, LinearExpr, OptimizationDirection, Problem};
use std::f64::consts::PI;

const GRAVITY: f64 = 9.81;
const DENSITY: f64 = 2600.0;

/// Stones as convex polygons in the plane x, z, and their contacts: (stone below or ground, stone above, both ends).
struct Plane {
    stones: Vec<Vec<[f64; 2]>>,
    densities: Vec<f64>,
    meetings: Vec<(Option<usize>, usize, [[f64; 2]; 2])>,
    friction: f64,
}

fn area_and_centroid(corners: &[[f64; 2]]) -> (f64, [f64; 2]) {
    let (mut area, mut first) = (0.0, [0.0; 2]);
    for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        let cross = a[0] * b[1] - b[0] * a[1];
        area += 0.5 * cross;
        for axis in 0..2 {
            first[axis] += (a[axis] + b[axis]) * cross / 6.0;
        }
    }
    (area.abs(), first.map(|moment| moment / area))
}

impl Plane {
    /// An arch of `n` voussoirs about (0, height of the springings), from `start` to π − `start`, on the ground or on abutments.
    fn arch(n: usize, thickness: f64, start: f64, friction: f64) -> Self {
        let lift = if start > 0.0 { 0.6 } else { 0.0 };
        let at = |radius: f64, angle: f64| [-radius * angle.cos(), radius * angle.sin() + lift];
        let (inner, outer) = (1.0 - 0.5 * thickness, 1.0 + 0.5 * thickness);
        let angle = |j: usize| start + (PI - 2.0 * start) * j as f64 / n as f64;
        let ends = |j: usize| [at(inner, angle(j)), at(outer, angle(j))];
        let mut plane = Plane {
            stones: Vec::new(),
            densities: vec![DENSITY; n],
            meetings: Vec::new(),
            friction,
        };
        for j in 0..n {
            let ([a, b], [c, d]) = (ends(j), ends(j + 1));
            plane.stones.push(vec![a, b, d, c]);
            if j > 0 {
                plane.meetings.push((Some(j - 1), j, ends(j)));
            }
        }
        if start == 0.0 {
            plane.meetings.push((None, 0, ends(0)));
            plane.meetings.push((None, n - 1, ends(n)));
            return plane;
        }
        for (j, voussoir, side) in [(0, 0, -1.0), (n, n - 1, 1.0)] {
            let [inside, outside] = ends(j);
            let foot = [[inside[0], 0.0], [side * 2.0, 0.0]];
            plane
                .stones
                .push(vec![foot[0], foot[1], [side * 2.0, outside[1]], outside, inside]);
            plane.densities.push(DENSITY);
            plane
                .meetings
                .push((Some(plane.stones.len() - 1), voussoir, [inside, outside]));
            plane.meetings.push((None, plane.stones.len() - 1, foot));
        }
        plane
    }

    fn without(mut self, stone: usize) -> Self {
        self.stones.remove(stone);
        self.densities.remove(stone);
        let later = |other: usize| if other > stone { other - 1 } else { other };
        self.meetings
            .retain(|(lower, upper, _)| *lower != Some(stone) && *upper != stone);
        for (lower, upper, _) in &mut self.meetings {
            (*lower, *upper) = (lower.map(later), later(*upper));
        }
        self
    }

    fn stack(&self) -> Option<Stack> {
        let block = |(i, corners): (usize, &Vec<[f64; 2]>)| {
            let both = [-0.15, 0.15].map(|y| corners.iter().map(move |[x, z]| [*x, y, *z]));
            let points: Vec<[f64; 3]> = both.into_iter().flatten().collect();
            Block {
                name: format!("stone {}", i + 1),
                solid: Solid::convex(&points).unwrap(),
                density_kg_m3: self.densities[i],
            }
        };
        let blocks = self.stones.iter().enumerate().map(block).collect();
        // a stone without support is refused
        Stack::new(blocks, JointMaterial::with_friction(self.friction), GRAVITY).ok()
    }

    /// The largest acceleration over gravity balanced by forces at the ends of the contacts, from 0 up to `most`; `None` if not
    /// even 0.
    fn by_simplex(&self, most: f64) -> Option<f64> {
        let mut problem = Problem::new(OptimizationDirection::Maximize);
        let acceleration = problem.add_var(1.0, (0.0, most));
        let mut sums: Vec<LinearExpr> = (0..3 * self.stones.len()).map(|_| LinearExpr::empty()).collect();
        let bodies: Vec<(f64, [f64; 2])> = self.stones.iter().map(|of| area_and_centroid(of)).collect();
        for (lower, upper, ends) in &self.meetings {
            let along = [ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]];
            let length = along[0].hypot(along[1]);
            let along = along.map(|part| part / length);
            let mut normal = [-along[1], along[0]];
            let towards = |k: usize| bodies[*upper].1[k] - ends[0][k];
            if normal[0] * towards(0) + normal[1] * towards(1) < 0.0 {
                normal = normal.map(|part| -part);
            }
            for end in ends {
                let press = problem.add_var(0.0, (0.0, f64::INFINITY));
                let rub = problem.add_var(0.0, (f64::NEG_INFINITY, f64::INFINITY));
                for sign in [1.0, -1.0] {
                    let mut cone = LinearExpr::empty();
                    cone.add(rub, sign);
                    cone.add(press, -self.friction);
                    problem.add_constraint(cone, ComparisonOp::Le, 0.0);
                }
                let mut add = |stone: usize, sign: f64| {
                    let arm = [end[0] - bodies[stone].1[0], end[1] - bodies[stone].1[1]];
                    for (variable, way) in [(press, normal), (rub, along)] {
                        sums[3 * stone].add(variable, sign * way[0]);
                        sums[3 * stone + 1].add(variable, sign * way[1]);
                        sums[3 * stone + 2].add(variable, sign * (arm[0] * way[1] - arm[1] * way[0]));
                    }
                };
                add(*upper, 1.0);
                if let Some(lower) = lower {
                    add(*lower, -1.0);
                }
            }
        }
        let unit: f64 = bodies
            .iter()
            .zip(&self.densities)
            .map(|(of, density)| of.0 * density)
            .sum();
        for (stone, (area, _)) in bodies.iter().enumerate() {
            let own = area * self.densities[stone] / unit;
            sums[3 * stone].add(acceleration, own);
            for (k, right) in [0.0, own, 0.0].into_iter().enumerate() {
                let sum = std::mem::replace(&mut sums[3 * stone + k], LinearExpr::empty());
                problem.add_constraint(sum, ComparisonOp::Eq, right);
            }
        }
        let solution = problem.solve().ok()?.into_solution().ok()?;
        Some(solution.var_value(acceleration))
    }
}

fn verdict(plane: &Plane) -> Verdict {
    let stack = plane.stack();
    stack.map_or(Verdict::Unstable, |stack| {
        check_stack(&stack, &StackCheckOptions::default())
            .unwrap()
            .verdict
    })
}

/// Interval of t/R in which the verdict changes.
fn least_thickness(n: usize) -> f64 {
    let (mut falls, mut stands) = (0.08, 0.13);
    while stands - falls > 2e-5 {
        let middle = 0.5 * (falls + stands);
        match verdict(&Plane::arch(n, middle, 0.0, 5.0)) {
            Verdict::Unstable => falls = middle,
            Verdict::Stable | Verdict::Marginal | Verdict::Unknown => stands = middle,
        }
    }
    0.5 * (falls + stands)
}

#[test]
fn reproduces_the_least_thickness_of_arches() {
    let known = [
        (6, 0.104134),
        (8, 0.099972),
        (9, 0.101525),
        (10, 0.107011),
        (11, 0.104589),
        (15, 0.106068),
        (16, 0.107076),
        (17, 0.105463),
        (24, 0.107096),
        (33, 0.106628),
        (51, 0.107357),
    ];
    for (n, known) in known {
        let found = least_thickness(n);
        assert!((found - known).abs() < 1e-4, "{n} voussoirs: {found} for {known}");
    }
    // slightly above the least thickness an arch is marginally stable: below 0.02 g; at three times the thickness friction governs
    let check = |thickness| {
        let stack = Plane::arch(17, thickness, 0.0, 0.7).stack().unwrap();
        check_stack(&stack, &StackCheckOptions::default()).unwrap()
    };
    for (thickness, near) in [(0.109, true), (0.3, false)] {
        let check = check(thickness);
        assert_eq!(check.verdict, Verdict::Marginal);
        assert_eq!(check.capacity.unwrap().acceleration_g < MARGINAL_BELOW_G, near);
        assert!(check.notes.contains(&StackNote::FrictionCarries));
    }
}

#[test]
fn holds_friction_that_carries_is_stable_only_with_a_run_that_stood() {
    let checked = |plane: &Plane| {
        let stack = plane.stack().unwrap();
        let check = check_stack(&stack, &StackCheckOptions::default()).unwrap();
        assert!(check.notes.contains(&StackNote::FrictionCarries));
        assert_eq!(
            (check.verdict, check.settle_run.is_none()),
            (Verdict::Marginal, true)
        );
        with_settle_run(&stack, check)
    };
    for (n, thickness, friction) in [(17, 0.3, 0.7), (9, 0.2, 0.7), (16, 0.15, 0.7)] {
        let check = checked(&Plane::arch(n, thickness, 0.0, friction));
        assert_eq!(check.verdict, Verdict::Stable, "{n} {thickness}");
        assert!(check.notes.contains(&StackNote::FrictionStood));
        let Some(SettleRun::Stood { settlement_m, .. }) = check.settle_run else {
            panic!("{:?}", check.settle_run)
        };
        // on springs of 1e9 Pa/m; a fallen stone would have moved by half its thickness
        assert!((1e-8..0.02 * thickness).contains(&settlement_m), "{settlement_m}");
    }
    // slightly above the least thickness it is marginal, or unknown on elastic springs, but never stable
    let thin = checked(&Plane::arch(17, 0.109, 0.0, 0.7)).verdict;
    assert!(
        matches!(thin, Verdict::Marginal | Verdict::Unknown | Verdict::Unstable),
        "{thin:?}"
    );
    // too many stones to simulate in a test
    let many = checked(&Plane::arch(SettleRun::STONES_MOST + 1, 0.3, 0.0, 0.7));
    assert_eq!(many.verdict, Verdict::Unknown);
    let stones = SettleRun::STONES_MOST + 1;
    assert_eq!(many.settle_run, Some(SettleRun::TooMany { stones }));
}

/// Joints with their motion, and for closed joints the fixed point in the plane.
type Moving = Vec<(JointMotion, Option<[f64; 2]>)>;

/// The joints of a mechanism.
fn moving(plane: &Plane, options: &LimitAnalysis) -> (LimitAnalysisStatus, Moving) {
    let result = limit_analysis(&plane.stack().unwrap(), options).unwrap();
    let joints = result.mechanism.unwrap().joints.into_iter();
    let joints = joints.map(|joint| (joint.motion, joint.closed_at_m.map(|[x, _, z]| [x, z])));
    (result.status, joints.collect())
}

#[test]
fn exact_hinges_of_a_swaying_arch_give_its_limit_by_virtual_work() {
    for (n, thickness) in [(9, 0.15), (16, 0.2), (31, 0.3)] {
        let plane = Plane::arch(n, thickness, 0.0, 5.0);
        let way = LimitAnalysis {
            shaking: Shaking::Along([1.0, 0.0]),
            ..LimitAnalysis::default()
        };
        let (status, joints) = moving(&plane, &way);
        let LimitAnalysisStatus::Limited(found) = status else {
            panic!("{status:?}")
        };
        let mut hinges: Vec<[f64; 2]> = joints
            .iter()
            .map(|(motion, at)| {
                assert_eq!(*motion, JointMotion::Opens);
                at.unwrap()
            })
            .collect();
        let angle = |[x, z]: [f64; 2]| z.abs().atan2(-x);
        hinges.sort_by(|a, b| angle(*a).total_cmp(&angle(*b)));
        let [a, b, c, d] = hinges[..] else {
            panic!("{n}: {hinges:?}")
        };
        // the middle part rotates about the intersection of a–b and d–c
        let (ab, dc) = ([b[0] - a[0], b[1] - a[1]], [c[0] - d[0], c[1] - d[1]]);
        let reach = ((d[0] - a[0]) * dc[1] - (d[1] - a[1]) * dc[0]) / (ab[0] * dc[1] - ab[1] * dc[0]);
        let centre = [a[0] + reach * ab[0], a[1] + reach * ab[1]];
        let middle = 1.0 / (1.0 - reach);
        let last = middle * (c[0] - centre[0]) / (c[0] - d[0]);
        let (mut rises, mut sways) = (0.0, 0.0);
        for stone in &plane.stones {
            let (area, centroid) = area_and_centroid(stone);
            let (turn, about) = match angle(centroid) {
                at if at < angle(a) || at > angle(d) => continue,
                at if at < angle(b) => (1.0, a),
                at if at < angle(c) => (middle, centre),
                _ => (last, d),
            };
            rises += area * turn * (centroid[0] - about[0]);
            sways -= area * turn * (centroid[1] - about[1]);
        }
        let known = rises / sways;
        assert!(
            (found.acceleration_g - known).abs() < 1e-6,
            "{n}: {found:?} {known}"
        );
    }
}

#[test]
fn holds_what_does_not_stand_names_its_mechanism() {
    // an arch that is too thin opens at five joints, or at up to six with an even number of stones; with too little friction its feet
    // slide
    for (n, thickness) in [(9, 0.09), (10, 0.1), (17, 0.1), (33, 0.106)] {
        let (status, joints) = moving(&Plane::arch(n, thickness, 0.0, 5.0), &LimitAnalysis::default());
        assert_eq!(status, LimitAnalysisStatus::DoesNotStand);
        assert!((4..=6).contains(&joints.len()), "{n}: {joints:?}");
        assert!(
            joints
                .iter()
                .all(|(motion, at)| *motion == JointMotion::Opens && at.is_some()),
            "{n}: {joints:?}"
        );
    }
    let (status, joints) = moving(&Plane::arch(9, 0.3, 0.0, 0.1), &LimitAnalysis::default());
    assert_eq!(status, LimitAnalysisStatus::DoesNotStand);
    assert!(
        joints.iter().any(|(motion, _)| *motion == JointMotion::Slides),
        "{joints:?}"
    );
}

#[test]
fn exact_slabs_that_lean_on_each_other() {
    // friction at the foot of at least (x_G − x_inner) / z_top: for slopes of 60° and t/L of 0.05, 0.1, 0.2
    let (cos, sin) = (0.5, 0.75_f64.sqrt());
    for (ratio, known) in [(0.05, 0.2411), (0.1, 0.1979), (0.2, 0.1220)] {
        // L belongs to the middle line, 1 to the inner face
        let thickness = ratio / (1.0 - ratio / (2.0 * cos * sin));
        let slab = |friction: f64| {
            // length along the inner face from the foot at −cos; the feet are level, the joint at x = 0 is upright
            let across = thickness / sin;
            let left = vec![
                [-cos, 0.0],
                [0.0, sin],
                [0.0, sin + thickness / cos],
                [-cos - across, 0.0],
            ];
            let right = left.iter().map(|[x, z]| [-x, *z]).collect();
            Plane {
                stones: vec![left, right],
                densities: vec![DENSITY; 2],
                meetings: vec![
                    (None, 0, [[-cos - across, 0.0], [-cos, 0.0]]),
                    (None, 1, [[cos, 0.0], [cos + across, 0.0]]),
                    (Some(0), 1, [[0.0, sin], [0.0, sin + thickness / cos]]),
                ],
                friction,
            }
        };
        let least = {
            let (_, centroid) = area_and_centroid(&slab(1.0).stones[0]);
            // moments of one slab about its top: the thrust is largest for the highest contact
            ((-cos - centroid[0]).abs() / (sin + thickness / cos)).max(0.0)
        };
        let (falls, stands) = (slab(0.999 * least), slab(1.001 * least));
        assert_eq!(falls.by_simplex(0.0), None, "{thickness}");
        assert_eq!(verdict(&falls), Verdict::Unstable, "{thickness}");
        assert_ne!(verdict(&stands), Verdict::Unstable, "{thickness}");
        assert!((least - known).abs() < 1e-4, "{thickness}: {least} for {known}");
    }
}

#[test]
fn exact_corbels_of_one_side() {
    // overhangs of 1/2, 1/4, 1/6 … of the length, counted from the top, are just stable
    for (share, stands) in [(0.99, true), (1.01, false)] {
        let count = 8;
        let mut x = 0.0;
        let mut stones = Vec::new();
        let mut meetings = Vec::new();
        for i in 0..count {
            let z = 0.1 * i as f64;
            if i > 0 {
                let overhang = 0.5 / (count - i) as f64;
                meetings.push((Some(i - 1), i, [[x + share * overhang, z], [x + 1.0, z]]));
                x += share * overhang;
            }
            stones.push(vec![[x, z], [x + 1.0, z], [x + 1.0, z + 0.1], [x, z + 0.1]]);
        }
        meetings.push((None, 0, [[0.0, 0.0], [1.0, 0.0]]));
        let plane = Plane {
            stones,
            densities: vec![DENSITY; count],
            meetings,
            friction: 0.7,
        };
        assert_eq!(plane.by_simplex(0.0).is_some(), stands);
        assert_eq!(verdict(&plane) != Verdict::Unstable, stands);
    }
}

#[test]
fn agrees_with_microlp_0_7_on_random_arches() {
    let mut random = Random::new(32, 0);
    let mut counts = [0; 2];
    for case in 0..200 {
        let mut between = |low: f64, high: f64| low + (high - low) * random.uniform();
        let n = match case % 100 {
            0 => between(40.0, 60.0),
            _ => between(3.0, 18.0),
        } as usize;
        let start = if case % 3 == 0 { 0.0 } else { between(0.05, 0.9) };
        let mut plane = Plane::arch(n, between(0.07, 0.3), start, between(0.2, 0.9));
        let loaded = between(0.0, n as f64) as usize;
        plane.densities[loaded] *= between(1.0, 8.0);
        if case % 10 == 7 {
            let gone = between(0.3 * n as f64, 0.7 * n as f64) as usize;
            plane = plane.without(gone);
        }
        let stands = plane.by_simplex(0.0).is_some();
        counts[usize::from(stands)] += 1;
        assert_eq!(
            verdict(&plane) != Verdict::Unstable,
            stands,
            "case {case}, {n} voussoirs"
        );
        if stands && case % 4 == 1 {
            let known = plane.by_simplex(100.0).unwrap();
            let options = LimitAnalysis {
                shaking: Shaking::Along([1.0, 0.0]),
                ..LimitAnalysis::default()
            };
            let found = limit_analysis(&plane.stack().unwrap(), &options).unwrap();
            let LimitAnalysisStatus::Limited(found) = found.status else {
                panic!("case {case}: {:?}", found.status)
            };
            assert!(
                (found.acceleration_g - known).abs() < 1e-6,
                "case {case}: {found:?} {known}"
            );
        }
    }
    assert!(counts[0] > 30 && counts[1] > 60, "{counts:?}");
}
