// SOURCE     Mechanics of rigid bodies: two links connected by a joint that does not rotate are one link.
// GOAL       A run takes a joint as rigid exactly if its spring is so stiff that it changes no other natural frequency by 1e-4 of its value. The
//            results are then those of the pole without the joint.
//
//         o link 3                   o
//         | ~~~ k → ∞       =        |   one link: m = Σ m_i, J = Σ (J_i + m_i d_i²)
//         o link 2                   |
//
// PARAMETERS The stone flagpole of Naju (Choi 2021, Table 1) with joints at 3 P·H, the third with another stiffness, under a tenth of El Centro 1940
//            NS, 12 s, large rotations. 200 random chains of 3 to 6 links, one joint 3e2 to 3e4 times as stiff as drawn.
// TOLERANCE  The stated change of frequencies is of first order: 1 % of it. Against the pole of four links 1e-11 of the largest rotation: rounding.
//            With the spring included, the difference is proportional to 1/k; half the difference at half the compliance is the limit to second
//            order, a few parts in ten thousand.

use super::chain_motion::{el_centro, flagpole, weight_times_height};
use crate::draws::Draws;
use dolmen::dynamics::{
    ChainHistory, ChainJoint, ChainModel, ChainOutcome, ChainRotations, ChainRun, JointFriction,
    JointOpening, TimeFunction, lowest_turning_joint, simulate_chain,
};
use dolmen::signal::Component;
use dolmen::structure::{Chain, Inertia, Link};

const STIFF: usize = 2;

fn shaking() -> TimeFunction {
    let record = el_centro();
    let values = record.acceleration_m_s2(Component::X).iter();
    TimeFunction::Sampled {
        time_step_s: 0.02,
        values: values.map(|a| 0.1 * a).collect(),
    }
}

fn run(model: &ChainModel) -> ChainHistory {
    let options = ChainRun {
        duration_s: Some(12.0),
        output_step_s: 0.01,
        ..ChainRun::default()
    };
    simulate_chain(model, &shaking(), &options, &mut |_| true).unwrap()
}

fn joints() -> Vec<f64> {
    weight_times_height().iter().map(|k| 3.0 * k).collect()
}

fn with_spring(k: f64) -> ChainModel {
    let mut stiffness = joints();
    stiffness[STIFF] = k;
    let joints = stiffness.into_iter().map(ChainJoint::spring).collect();
    ChainModel::new(flagpole(), joints, ChainRotations::Large).unwrap()
}

/// The chain with the two links next to a joint merged.
fn joined(chain: &Chain, joint: usize) -> Chain {
    let mut links = chain.links().to_vec();
    let (upper, lower) = (links.remove(joint), links[joint - 1].clone());
    let mass_kg = lower.mass_kg + upper.mass_kg;
    let upper_centroid_m = lower.length_m + upper.centroid_m;
    let centroid_m = (lower.mass_kg * lower.centroid_m + upper.mass_kg * upper_centroid_m) / mass_kg;
    let about = |link: &Link, at_m: f64| link.inertia_kg_m2() + link.mass_kg * (at_m - centroid_m).powi(2);
    links[joint - 1] = Link {
        mass_kg,
        length_m: lower.length_m + upper.length_m,
        centroid_m,
        inertia: Inertia::Given(about(&lower, lower.centroid_m) + about(&upper, upper_centroid_m)),
        bed_width_m: lower.bed_width_m,
    };
    Chain::new(links, chain.gravity_m_s2()).unwrap()
}

/// The pole with the two links next to the joint merged.
fn without_joint() -> ChainModel {
    let mut stiffness = joints();
    stiffness.remove(STIFF);
    let joints = stiffness.into_iter().map(ChainJoint::spring).collect();
    ChainModel::new(joined(&flagpole(), STIFF), joints, ChainRotations::Large).unwrap()
}

/// Largest difference between rows, over the largest value of the second.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    let most = b.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let worst = a
        .iter()
        .zip(b)
        .fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()));
    worst / most
}

#[test]
fn exact_a_nearly_rigid_joint_moves_as_the_pole_without_it() {
    let (of_four, stiff) = (run(&without_joint()), run(&with_spring(1e10)));
    let [rigid] = stiff.rigid_joints.as_slice() else {
        panic!("{:?}", stiff.rigid_joints)
    };
    assert_eq!((rigid.joint, rigid.stiffness_n_m_rad), (STIFF, 1e10));
    assert!(rigid.frequency_change_ratio < 1e-5, "{rigid:?}");
    for (link, same) in [0, 1, 1, 2, 3].into_iter().enumerate() {
        let (a, b) = (&stiff.rotation_rad[link], &of_four.rotation_rad[same]);
        assert!(apart(a, b) < 1e-11, "link {link}: {:e}", apart(a, b));
    }
    // its cost: the steps of the pole without the joint, compared with tens of thousands
    assert!(
        stiff.steps < 2 * of_four.steps,
        "{} {}",
        stiff.steps,
        of_four.steps
    );
    assert!(
        stiff.energy_left_over_ratio < 1e-11,
        "{:e}",
        stiff.energy_left_over_ratio
    );
    let turned = stiff.joint_peaks[STIFF].rotation_rad.abs();
    assert!((turned * 1e10 / stiff.joint_moment_peaks_n_m[STIFF] - 1.0).abs() < 1e-12);
}

/// A push on a pole with a nearly rigid foot rotates the part above its lowest link: the four upper links, as a pole on the ground.
#[test]
fn exact_a_push_on_a_nearly_rigid_foot_is_that_of_the_pole_on_its_lowest_link() {
    let push_rad = 1e-3;
    let pushed = |chain: Chain, stiffness: Vec<f64>, rotation_rad: Vec<f64>| {
        let joints = stiffness.into_iter().map(ChainJoint::spring).collect();
        let model = ChainModel::new(chain, joints, ChainRotations::Large).unwrap();
        let options = ChainRun {
            duration_s: Some(5.0),
            output_step_s: 0.01,
            start_rotation_rad: rotation_rad,
            ..ChainRun::default()
        };
        simulate_chain(&model, &TimeFunction::Zero, &options, &mut |_| true).unwrap()
    };
    let mut stiffness = joints();
    stiffness[0] = 1e13;
    let springs = stiffness.iter().map(|k| ChainJoint::spring(*k)).collect();
    let model = ChainModel::new(flagpole(), springs, ChainRotations::Large).unwrap();
    let at_rest = ChainRun::default();
    assert_eq!(lowest_turning_joint(&model, &at_rest, push_rad), 1);
    let stiff = pushed(
        flagpole(),
        stiffness,
        vec![0.0, push_rad, push_rad, push_rad, push_rad],
    );
    assert_eq!(stiff.rigid_joints.len(), 1);
    let above = Chain::new(flagpole().links()[1..].to_vec(), flagpole().gravity_m_s2()).unwrap();
    let own = pushed(above, joints()[1..].to_vec(), vec![push_rad; 4]);
    for link in 0..4 {
        let (a, b) = (&stiff.rotation_rad[link + 1], &own.rotation_rad[link]);
        assert!(apart(a, b) < 1e-11, "link {link}: {:e}", apart(a, b));
    }
    // an ordinary foot rotates, and so does a stiff one if the push brings its bed to the edge
    let usual = joints().into_iter().map(ChainJoint::spring).collect();
    let usual = ChainModel::new(flagpole(), usual, ChainRotations::Large).unwrap();
    assert_eq!(lowest_turning_joint(&usual, &at_rest, push_rad), 0);
    let mut links = flagpole().links().to_vec();
    links[0].bed_width_m = Some(0.65);
    let wide = Chain::new(links, flagpole().gravity_m_s2()).unwrap();
    let mut springs: Vec<ChainJoint> = joints().into_iter().map(ChainJoint::spring).collect();
    springs[0] = ChainJoint {
        opening: JointOpening::AtBedEdge,
        ..ChainJoint::spring(1e13)
    };
    let opening = ChainModel::new(wide, springs, ChainRotations::Large).unwrap();
    assert_eq!(lowest_turning_joint(&opening, &at_rest, push_rad), 0);
}

#[test]
fn exact_a_push_that_opens_the_bed_of_a_stiff_foot_rocks_it_on_its_edges() {
    // small rotations, no loss at impact: θ = θ_e + (θ_0 − θ_e) cosh pt, θ_e = N b/2/(W z), p² = W z/J; through upright at odd quarters
    let (weight_n, z_m, bed_width_m, push_rad): (f64, f64, f64, f64) = (40e3, 2.0, 0.6, 0.02);
    let inertia = weight_n / 9.81 * (16.0 / 12.0 + z_m * z_m);
    let (edge_rad, p) = (0.5 * bed_width_m / z_m, (weight_n * z_m / inertia).sqrt());
    let quarter_s = (edge_rad / (edge_rad - push_rad)).acosh() / p;
    let mut steps = Vec::new();
    for stiffness in [1e10, 1e12] {
        let link = Link {
            mass_kg: weight_n / 9.81,
            length_m: 4.0,
            centroid_m: z_m,
            inertia: Inertia::ThinRod,
            bed_width_m: Some(bed_width_m),
        };
        let foot = ChainJoint {
            opening: JointOpening::AtBedEdge,
            ..ChainJoint::spring(stiffness)
        };
        let chain = Chain::new(vec![link], 9.81).unwrap();
        let model = ChainModel::new(chain, vec![foot], ChainRotations::Small).unwrap();
        let options = ChainRun {
            duration_s: Some(12.0),
            output_step_s: 1e-3,
            start_rotation_rad: vec![push_rad],
            ..ChainRun::default()
        };
        let history = simulate_chain(&model, &TimeFunction::Zero, &options, &mut |_| true).unwrap();
        let rotation = &history.rotation_rad[0];
        let crossed = rotation
            .windows(2)
            .enumerate()
            .filter(|(_, pair)| pair[0] * pair[1] < 0.0);
        let crossed: Vec<f64> = crossed
            .map(|(i, pair)| 1e-3 * (i as f64 + pair[0] / (pair[0] - pair[1])))
            .collect();
        assert!(crossed.len() > 15, "{crossed:?}");
        for (i, at_s) in crossed.iter().enumerate() {
            let wanted_s = (2 * i + 1) as f64 * quarter_s;
            assert!((at_s - wanted_s).abs() < 1e-5, "{stiffness:e}: {at_s} {wanted_s}");
        }
        steps.push(history.steps);
    }
    // the spring is followed at its contacts alone
    assert!(steps[1] < 2 * steps[0], "{steps:?}");
}

#[test]
fn agrees_with_springs_that_are_followed_as_their_compliance_goes_to_nothing() {
    let (soft, mid, stiff) = (
        run(&with_spring(1e8)),
        run(&with_spring(2e8)),
        run(&with_spring(1e10)),
    );
    assert!(soft.rigid_joints.is_empty() && mid.rigid_joints.is_empty());
    for link in 0..5 {
        let rows = [&soft, &mid, &stiff].map(|history| &history.rotation_rad[link]);
        let limit: Vec<f64> = rows[0]
            .iter()
            .zip(rows[1])
            .map(|(k, twice)| 2.0 * twice - k)
            .collect();
        let (first, second) = (apart(rows[1], rows[2]), apart(&limit, rows[2]));
        assert!(
            second < 0.1 * first && second < 5e-4,
            "link {link}: {first:e} {second:e}"
        );
    }
    // the moment too, which for a rigid joint follows only from the balance of the links
    let rows = [&mid, &stiff].map(|history| &history.joint_moment_n_m[STIFF]);
    assert!(apart(rows[0], rows[1]) < 0.02, "{:e}", apart(rows[0], rows[1]));
}

#[test]
fn exact_the_stated_change_of_frequencies_is_that_of_the_modes_in_200_random_chains() {
    let mut draw = Draws::new(33);
    let mut taken = 0;
    for case in 0..200 {
        let n = 3 + case % 4;
        let chain = draw.chain(n);
        let necessary = chain.necessary_n_m_rad();
        let stiff = 1 + draw.between(0.0, n as f64 - 1.0) as usize;
        let mut stiffness: Vec<f64> = necessary
            .iter()
            .map(|m| m * n as f64 * draw.between(2.0, 30.0))
            .collect();
        stiffness[stiff] *= 10_f64.powf(draw.between(2.5, 4.5));
        let omega_squared = |chain: &Chain, stiffness: &[f64]| -> Vec<f64> {
            let modes = chain.natural_modes(stiffness).unwrap();
            modes.iter().map(|mode| mode.omega_squared).collect()
        };
        let elastic = omega_squared(&chain, &stiffness);
        let mut others = stiffness.clone();
        others.remove(stiff);
        let limit = omega_squared(&joined(&chain, stiff), &others);
        let each = elastic.iter().zip(&limit);
        let most = each
            .map(|(elastic, rigid)| (rigid / elastic).sqrt() - 1.0)
            .fold(0.0, f64::max);
        let joints = stiffness.iter().map(|k| ChainJoint::spring(*k)).collect();
        let model = ChainModel::new(chain, joints, ChainRotations::Small).unwrap();
        let options = ChainRun {
            duration_s: Some(0.01),
            ..ChainRun::default()
        };
        let history = simulate_chain(&model, &TimeFunction::Zero, &options, &mut |_| true).unwrap();
        match history.rigid_joints.as_slice() {
            [] => assert!(most > 0.9e-4, "case {case}: {most:e} and not rigid"),
            [of] => {
                taken += 1;
                assert_eq!(of.joint, stiff);
                assert!(
                    (of.frequency_change_ratio / most - 1.0).abs() < 0.01,
                    "case {case}: {of:?} {most:e}"
                );
            }
            several => panic!("case {case}: {several:?}"),
        }
    }
    assert!(taken > 40, "{taken}");
}

#[test]
fn holds_a_bed_that_comes_to_its_edge_is_followed_with_its_spring() {
    let opening = |width_m: f64| {
        let pole = flagpole();
        let mut links = pole.links().to_vec();
        links[STIFF].bed_width_m = Some(width_m);
        let mut joints: Vec<ChainJoint> = joints().into_iter().map(ChainJoint::spring).collect();
        joints[STIFF] = ChainJoint {
            opening: JointOpening::AtBedEdge,
            ..ChainJoint::spring(1e10)
        };
        let chain = Chain::new(links, pole.gravity_m_s2()).unwrap();
        run(&ChainModel::new(chain, joints, ChainRotations::Large).unwrap())
    };
    let most = run(&with_spring(1e10)).joint_moment_peaks_n_m[STIFF];
    let weight_n: f64 = flagpole().links()[STIFF..].iter().map(|l| 9.81 * l.mass_kg).sum();
    let edge_m = 2.0 * most / weight_n;
    let wide = opening(1.01 * edge_m);
    assert_eq!((wide.rigid_joints.len(), wide.outcome), (1, ChainOutcome::Stood));
    let narrow = opening(0.5 * edge_m);
    assert!(narrow.rigid_joints.is_empty());
    assert!(
        matches!(narrow.outcome, ChainOutcome::Uplifted { joint: STIFF, .. }),
        "{:?}",
        narrow.outcome
    );
}

#[test]
fn holds_what_turns_at_the_start_or_rubs_is_not_rigid() {
    let start = |rotation: [f64; 5]| {
        let options = ChainRun {
            duration_s: Some(0.01),
            start_rotation_rad: rotation.to_vec(),
            ..ChainRun::default()
        };
        simulate_chain(&with_spring(1e10), &TimeFunction::Zero, &options, &mut |_| true).unwrap()
    };
    assert_eq!(start([1e-3; 5]).rigid_joints.len(), 1);
    assert!(start([1e-3, 1e-3, 2e-3, 2e-3, 2e-3]).rigid_joints.is_empty());
    let mut joints: Vec<ChainJoint> = joints().into_iter().map(ChainJoint::spring).collect();
    joints[STIFF] = ChainJoint {
        friction: JointFriction::coulomb(1e3),
        ..ChainJoint::spring(1e10)
    };
    let model = ChainModel::new(flagpole(), joints, ChainRotations::Large).unwrap();
    let options = ChainRun {
        duration_s: Some(0.01),
        ..ChainRun::default()
    };
    let rubbing = simulate_chain(&model, &shaking(), &options, &mut |_| true).unwrap();
    assert!(rubbing.rigid_joints.is_empty());
}
