//! SOURCE: closed forms, and the modes of `stack_modes` on stacks with other springs, which settle on their own and ignore families of motions.
//! GOAL: factors on the springs of joints from measured modes, with their bounds and ranges.
//! PARAMETERS: towers of boxes of 2600 kg/m³ on K_n 1e9, K_s 4e8 Pa/m; gravity 0.005 m/s² where the rest position must not move (settlement under the
//! earth's gravity changes ω²/k by 1e-4).
//! TOLERANCE: stated at each; 1e-6 if the only differences are rounding and settlement.

use dolmen::blocks::{
    ContactRule, JointFactors, JointFactorsError, JointFactorsOptions, MeasuredStackMode, PairedBy,
    StackMode, StackMotion, StiffnessOf, WhyUnused, joint_factors, stack_modes,
};
use dolmen::structure::stack::{Block, JointMaterial, Placement, Solid, Stack};
use dolmen::structure::{MeasuredMode, ShapePoint};
use std::f64::consts::TAU;

/// So small that springs with any factor settle equally.
pub(super) const LIGHT: f64 = 0.005;
pub(super) const EARTH: f64 = 9.81;
const DENSITY: f64 = 2600.0;

/// Boxes on each other: width along x, depth along y, height.
pub(super) fn tower(sizes: &[[f64; 3]], gravity: f64) -> Stack {
    let mut z = 0.0;
    let blocks = sizes.iter().enumerate().map(|(i, [width, depth, height])| {
        let place = Placement {
            position_m: [0.0, 0.0, z],
            ..Placement::default()
        };
        z += height;
        Block {
            name: format!("stone {i}"),
            solid: Solid::cuboid(*width, *depth, *height).unwrap().placed(&place),
            density_kg_m3: DENSITY,
        }
    });
    Stack::new(blocks.collect(), JointMaterial::default(), gravity).unwrap()
}

pub(super) const SIX: [[f64; 3]; 6] = [
    [1.4, 1.7, 0.5],
    [1.0, 1.25, 0.9],
    [1.2, 1.5, 0.3],
    [0.8, 1.0, 0.7],
    [1.0, 1.2, 0.3],
    [0.6, 0.75, 0.5],
];

pub(super) fn with_factors(stack: &Stack, factors: &[f64]) -> Stack {
    let mut made = stack.clone();
    for (joint, factor) in factors.iter().enumerate() {
        let mut material = made.joints()[joint].material;
        material.normal_stiffness_pa_m *= factor;
        material.shear_stiffness_pa_m *= factor;
        made = made.with_material(joint, material).unwrap();
    }
    made
}

/// The modes that sway along an axis, ascending.
pub(super) fn sways(stack: &Stack, axis: usize) -> Vec<StackMode> {
    let modes = stack_modes(stack, ContactRule::Four).unwrap();
    modes
        .into_iter()
        .filter(|mode| mode.kinetic_energy_ratio[axis] >= 0.25)
        .collect()
}

/// A measured mode, exact except for its stated standard deviation, with a shape at the middle and near the top of every stone.
pub(super) fn measured(
    stack: &Stack,
    axis: usize,
    mode: &StackMode,
    relative_sd: f64,
    shape_sd: Option<f64>,
) -> MeasuredStackMode {
    let mut shape = Vec::new();
    for (block, moved) in stack
        .blocks()
        .iter()
        .zip(&mode.shape)
        .filter(|_| shape_sd.is_some())
    {
        let [low, high] = block.solid.bounds_m().map(|corner| corner[2]);
        let middle = block.solid.centroid_m()[2];
        for height_m in [middle, 0.9 * high + 0.1 * low] {
            let turned = match axis {
                0 => moved[4] * (height_m - middle),
                _ => -moved[3] * (height_m - middle),
            };
            shape.push(ShapePoint {
                height_m,
                displacement: moved[axis] + turned,
                displacement_sd: shape_sd.unwrap_or(0.0),
            });
        }
    }
    MeasuredStackMode {
        motion: [StackMotion::X, StackMotion::Y][axis],
        mode: MeasuredMode {
            frequency_hz: mode.frequency_hz,
            frequency_sd_hz: relative_sd * mode.frequency_hz,
            frequency_changes_hz: vec![],
            shape,
        },
    }
}

fn frequency(motion: StackMotion, frequency_hz: f64, relative_sd: f64) -> MeasuredStackMode {
    MeasuredStackMode {
        motion,
        mode: MeasuredMode {
            frequency_hz,
            frequency_sd_hz: relative_sd * frequency_hz,
            frequency_changes_hz: vec![],
            shape: vec![],
        },
    }
}

pub(super) fn found(stack: &Stack, measured: &[MeasuredStackMode]) -> JointFactors {
    joint_factors(stack, measured, &JointFactorsOptions::default()).unwrap()
}

#[test]
fn exact_modes_with_full_shapes_give_every_factor_back() {
    let stack = tower(&SIX, LIGHT);
    let truth = [0.5, 2.0, 0.7, 1.0, 3.0, 0.4];
    let made = with_factors(&stack, &truth);
    let all: Vec<MeasuredStackMode> = sways(&made, 0)
        .iter()
        .take(4)
        .map(|mode| measured(&stack, 0, mode, 1e-5, Some(1e-5)))
        .collect();
    let found = found(&stack, &all);
    assert_eq!(found.of, StiffnessOf::Joint);
    assert_eq!(found.modes.len(), 4, "{:?}", found.unused);
    assert!(found.modes.iter().all(|mode| mode.paired_by == PairedBy::Shape));
    assert_eq!(found.fixed_combinations, 6);
    for (factor, truth) in found.factors.iter().zip(truth) {
        let best = factor.best.unwrap_or_else(|| panic!("{factor:?}"));
        assert!((best / truth - 1.0).abs() < 1e-6, "{best} for {truth}");
        let range = factor.range.unwrap();
        assert!(range.lower < truth && truth < range.upper && range.upper < 1.01 * range.lower);
        assert!(factor.least.is_none_or(|least| least <= truth));
    }
    assert!(found.resettled.unwrap() < 1e-6);
}

#[test]
fn exact_common_factor_of_any_modes() {
    let stack = tower(&SIX, LIGHT);
    let made = with_factors(&stack, &[0.37; 6]);
    let all = [
        measured(&stack, 0, &sways(&made, 0)[0], 0.01, None),
        measured(&stack, 1, &sways(&made, 1)[0], 0.02, None),
    ];
    let found = found(&stack, &all);
    assert!(
        (found.common.factor / 0.37 - 1.0).abs() < 1e-6,
        "{:?}",
        found.common
    );
    // σ(ln c) = 2/√(1/.01² + 1/.02²)
    let exact = 2.0 / (1.0 / 0.01_f64.powi(2) + 1.0 / 0.02_f64.powi(2)).sqrt();
    assert!((found.common.relative_sd / exact - 1.0).abs() < 1e-9);
    // two frequencies determine at most two combinations, and none of six factors
    assert!(found.fixed_combinations <= 2);
    assert!(found.factors.iter().all(|factor| factor.best.is_none()));
}

/// A box on a bed of springs: u of its middle and its rotation θ; the lower of both frequencies.
///
/// ```text
/// K = [k_s A, k_s A h/2; k_s A h/2, k_n b d³/12 + k_s A h²/4],   M = diag(m, m (d² + h²)/12)
/// ```
fn box_on_springs_hz([d, b, h]: [f64; 3], k_n: f64, k_s: f64) -> f64 {
    let (area, mass) = (b * d, DENSITY * b * d * h);
    let inertia = mass * (d * d + h * h) / 12.0;
    let (kuu, kut) = (k_s * area, k_s * area * h / 2.0);
    let ktt = k_n * b * d.powi(3) / 12.0 + k_s * area * h * h / 4.0;
    let (a, c) = (kuu / mass, ktt / inertia);
    let half = (a + c) / 2.0;
    let square = half - (half * half - (a * c - kut * kut / (mass * inertia))).sqrt();
    square.sqrt() / TAU
}

#[test]
fn exact_least_factor_of_a_box_whose_neighbours_are_rigid() {
    let top = [0.9, 1.3, 1.6];
    let stack = tower(&[[2.0, 2.4, 0.6], top], LIGHT);
    let unit_hz = box_on_springs_hz(top, 1e9, 4e8);
    // c = (f/f_unit)² for any lower joint
    let measured_hz = 0.6 * unit_hz;
    let found = found(&stack, &[frequency(StackMotion::X, measured_hz, 1e-7)]);
    let least = found.factors[1].least.unwrap();
    assert!((least / 0.36 - 1.0).abs() < 1e-5, "{least}");
    // with a rigid lower joint both stones rock on it as one body, whose bound is far below
    assert!(found.factors[0].least.unwrap() < least);
}

#[test]
fn exact_strain_energy_is_the_derivative_of_the_frequency() {
    let stack = tower(&SIX, LIGHT);
    let first = &sways(&stack, 0)[0];
    let found = found(&stack, &[measured(&stack, 0, first, 0.01, None)]);
    let shares = &found.modes[0].energy_shares;
    assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-9);
    let step = 1e-3_f64;
    for (joint, share) in shares.iter().enumerate() {
        let [less, more] = [-step, step].map(|x| {
            let mut factors = [1.0; 6];
            factors[joint] = x.exp();
            2.0 * sways(&with_factors(&stack, &factors), 0)[0].frequency_hz.ln()
        });
        let slope = (more - less) / (2.0 * step);
        assert!((slope - share).abs() < 1e-5, "joint {joint}: {slope} and {share}");
    }
}

#[test]
fn agrees_ranges_of_two_joints_with_a_grid_of_all_factors() {
    let stack = tower(&[[1.0, 1.3, 0.8], [0.8, 1.0, 0.9]], LIGHT);
    let made = with_factors(&stack, &[0.6, 1.8]);
    let of_truth = sways(&made, 0);
    for count in [1, 2] {
        let relative_sd = [0.01, 0.03][count - 1];
        let all: Vec<MeasuredStackMode> = of_truth[..count]
            .iter()
            .map(|mode| measured(&stack, 0, mode, relative_sd, None))
            .collect();
        let found = found(&stack, &all);
        assert_eq!(found.modes.len(), count, "{:?}", found.unused);
        // every pair on a grid over the band, with the modes of the engine
        let steps = 80;
        let ln = |at: usize| {
            (found.band[0]).ln() + (found.band[1] / found.band[0]).ln() * at as f64 / steps as f64
        };
        let mut squares = vec![vec![0.0; steps + 1]; steps + 1];
        for (i, row) in squares.iter_mut().enumerate() {
            for (k, value) in row.iter_mut().enumerate() {
                let modes = sways(&with_factors(&stack, &[ln(i).exp(), ln(k).exp()]), 0);
                let off = |(one, mode): (&MeasuredStackMode, &StackMode)| {
                    ((mode.frequency_hz / one.mode.frequency_hz).ln() / relative_sd).powi(2)
                };
                *value = all.iter().zip(&modes).map(off).sum::<f64>();
            }
        }
        let step = ln(1) - ln(0);
        for (joint, factor) in found.factors.iter().enumerate() {
            let range = factor.range.unwrap();
            // the least over the other factor; between grid nodes χ² may be smaller, because a node half a step away changes a frequency by a quarter
            // of a step
            let slack = (0.25 * step / relative_sd + 1.96).powi(2) * count as f64;
            let least = |at: usize| {
                let each = (0..=steps).map(|other| match joint {
                    0 => squares[at][other],
                    _ => squares[other][at],
                });
                each.fold(f64::INFINITY, f64::min)
            };
            let inside: Vec<usize> = (0..=steps).filter(|&at| least(at) <= 3.8415).collect();
            let near: Vec<usize> = (0..=steps).filter(|&at| least(at) <= slack).collect();
            let (first, last) = (ln(inside[0]), ln(inside[inside.len() - 1]));
            assert!(
                range.lower.ln() <= first + 1e-6 && range.upper.ln() >= last - 1e-6,
                "{joint} {count}: {range:?} {first} {last}"
            );
            let (first, last) = (ln(near[0]) - step, ln(near[near.len() - 1]) + step);
            assert!(
                range.lower.ln() >= first && range.upper.ln() <= last,
                "{joint} {count}: {range:?} {first} {last}"
            );
        }
    }
}

#[test]
fn holds_a_stiffer_measurement_raises_every_bound() {
    let stack = tower(&SIX, EARTH);
    let first = sways(&stack, 0)[0].frequency_hz;
    let [soft, stiff] =
        [1.0, 1.3].map(|ratio| found(&stack, &[frequency(StackMotion::X, ratio * first, 0.01)]));
    assert!((stiff.common.factor / soft.common.factor / 1.69 - 1.0).abs() < 1e-6);
    for (a, b) in soft.factors.iter().zip(&stiff.factors) {
        assert!((b.least.unwrap() / a.least.unwrap() / 1.69 - 1.0).abs() < 1e-4);
    }
}

#[test]
fn refuses_modes_that_cannot_be_told() {
    let stack = tower(&SIX, EARTH);
    let x = sways(&stack, 0);
    let options = JointFactorsOptions::default();
    assert_eq!(
        joint_factors(&stack, &[], &options),
        Err(JointFactorsError::NoModes)
    );
    // the second measured mode is the third computed mode, and is not paired with the second
    let given = [
        frequency(StackMotion::X, x[0].frequency_hz, 0.01),
        frequency(StackMotion::X, x[2].frequency_hz, 0.01),
        frequency(StackMotion::X, x[3].frequency_hz, 0.01),
    ];
    let of_three = found(&stack, &given);
    assert_eq!(of_three.modes.len(), 1);
    assert!(matches!(of_three.unused[0].why, WhyUnused::BetweenModes { .. }));
    assert!(matches!(of_three.unused[1].why, WhyUnused::AfterUnused));
    // a shape shows that it is the third
    let given = [
        frequency(StackMotion::X, x[0].frequency_hz, 0.01),
        measured(&stack, 0, &x[2], 0.01, Some(0.02)),
    ];
    assert_eq!(found(&stack, &given).modes[1].number, 3);
    let high = MeasuredStackMode {
        mode: MeasuredMode {
            shape: vec![ShapePoint {
                height_m: 99.0,
                displacement: 1.0,
                displacement_sd: 0.0,
            }],
            ..given[0].mode.clone()
        },
        ..given[0].clone()
    };
    let why = joint_factors(&stack, &[high], &options).unwrap_err();
    assert!(why.to_string().contains("height_m of the mode"), "{why}");
    let band = JointFactorsOptions { band: 1.0, ..options };
    assert!(matches!(
        joint_factors(&stack, &given, &band),
        Err(JointFactorsError::Option { option: "band", .. })
    ));
}

#[test]
fn exact_factors_of_beds_where_posts_stand_side_by_side() {
    // the order of the posts changes which shapes rounding chooses for their modes of one frequency, and nothing else
    let found = [[0, 1, 2, 3], [2, 0, 3, 1], [3, 2, 1, 0]].map(factors_of_four_posts);
    let paired = |of: &JointFactors| -> Vec<(StackMotion, usize)> {
        of.modes.iter().map(|mode| (mode.motion, mode.number)).collect()
    };
    for other in &found[1..] {
        assert_eq!(paired(other), paired(&found[0]));
        for (a, b) in other.factors.iter().zip(&found[0].factors) {
            assert!(
                (a.best.unwrap() / b.best.unwrap() - 1.0).abs() < 1e-6,
                "{a:?} {b:?}"
            );
        }
    }
}

/// The factors of a base, four separate posts in some order, a roof on all of them, and a body, of three sways along x and along y.
fn factors_of_four_posts(order: [usize; 4]) -> JointFactors {
    let stone = |name: &str, [x, y, z]: [f64; 3], [width, depth, height]: [f64; 3]| Block {
        name: name.to_owned(),
        solid: Solid::cuboid(width, depth, height).unwrap().placed(&Placement {
            position_m: [x, y, z],
            ..Placement::default()
        }),
        density_kg_m3: DENSITY,
    };
    let mut blocks = vec![stone("base", [0.0; 3], [2.4, 2.8, 0.5])];
    let posts = [
        ("a", 0.8, 1.0),
        ("b", -0.8, 1.0),
        ("c", -0.8, -1.0),
        ("d", 0.8, -1.0),
    ];
    for (name, x, y) in order.map(|at| posts[at]) {
        blocks.push(stone(name, [x, y, 0.5], [0.4, 0.4, 1.2]));
    }
    blocks.push(stone("roof", [0.0, 0.0, 1.7], [2.2, 2.6, 0.4]));
    blocks.push(stone("body", [0.0, 0.0, 2.1], [0.9, 1.1, 0.8]));
    let stack = Stack::new(blocks, JointMaterial::default(), LIGHT).unwrap();
    assert_eq!(stack.joints().len(), 10);
    let truth = [0.6, 1.6, 0.8, 1.3]; // ground, feet, heads, body
    let of_joint = |joint: usize| match stack.joints()[joint].origin_m[2] {
        z if z < 0.1 => truth[0],
        z if z < 0.6 => truth[1],
        z if z < 1.8 => truth[2],
        _ => truth[3],
    };
    let factors: Vec<f64> = (0..10).map(of_joint).collect();
    let made = with_factors(&stack, &factors);
    let all: Vec<MeasuredStackMode> = [0, 1]
        .into_iter()
        .flat_map(|axis| {
            let three: Vec<StackMode> = sways(&made, axis).into_iter().take(3).collect();
            three.into_iter().map(move |mode| (axis, mode))
        })
        .map(|(axis, mode)| of_levels(&stack, measured(&stack, axis, &mode, 1e-5, Some(1e-5))))
        .collect();
    let options = JointFactorsOptions {
        joints_most: 9,
        ..JointFactorsOptions::default()
    };
    let found = joint_factors(&stack, &all, &options).unwrap();
    assert_eq!(found.of, StiffnessOf::Bed);
    assert_eq!(found.factors.len(), 4);
    assert_eq!(found.factors[1].joints.len(), 4);
    // all three along x: as drawn the third is most like the fourth (MAC 0.60), and at the springs of the first two it is the third
    let along_x = found.modes.iter().filter(|mode| mode.motion == StackMotion::X);
    let numbers: Vec<usize> = along_x.map(|mode| mode.number).collect();
    assert_eq!(numbers, [1, 2, 3], "{:?} {:?}", found.modes, found.unused);
    for (factor, truth) in found.factors.iter().zip(truth) {
        let best = factor.best.unwrap_or_else(|| panic!("{factor:?}"));
        assert!((best / truth - 1.0).abs() < 1e-5, "{best} for {truth}");
    }
    for mode in &found.modes {
        assert!((mode.energy_shares.iter().sum::<f64>() - 1.0).abs() < 1e-9);
    }
    found
}

/// The same after merging all points of one height: posts that sway equally.
fn of_levels(stack: &Stack, mut one: MeasuredStackMode) -> MeasuredStackMode {
    let mut levels: Vec<ShapePoint> = Vec::new();
    let mut counts: Vec<f64> = Vec::new();
    for point in &one.mode.shape {
        match levels
            .iter()
            .position(|of| (of.height_m - point.height_m).abs() < 1e-9)
        {
            Some(at) => {
                levels[at].displacement += point.displacement;
                counts[at] += 1.0;
            }
            None => {
                levels.push(*point);
                counts.push(1.0);
            }
        }
    }
    assert!(levels.len() < 2 * stack.blocks().len());
    for (level, count) in levels.iter_mut().zip(counts) {
        level.displacement /= count;
    }
    one.mode.shape = levels;
    one
}

#[test]
fn holds_a_sensor_on_top_alone_is_counted_from_the_lowest() {
    let stack = tower(&SIX, EARTH);
    let x = sways(&stack, 0);
    let two = x.iter().take(2);
    let mut all: Vec<MeasuredStackMode> = two
        .map(|mode| measured(&stack, 0, mode, 0.01, Some(0.02)))
        .collect();
    for one in &mut all {
        let top = one.mode.shape[11];
        let ground = ShapePoint {
            height_m: 0.0,
            displacement: 0.001,
            ..top
        };
        one.mode.shape = vec![ground, top];
    }
    let found = found(&stack, &all);
    let numbers: Vec<usize> = found.modes.iter().map(|mode| mode.number).collect();
    assert_eq!(numbers, [1, 2], "{:?}", found.unused);
    assert!(found.modes.iter().all(|mode| mode.paired_by == PairedBy::Order));
}
