// SOURCE     Kim, Koo & Hong (2018), eqs 9 and 16, section 3.4; Livesley (1978) for the limit analysis; P10 and P20 of this crate, made
//            for comparisons.
// GOAL       The smallest tan α of all joints gives the joint that opens first and its acceleration; the limit analysis agrees. Stones
//            with rounded corners have the joints of the exact ones.
// PARAMETERS P10 and P20, friction 0.6 and 0.3, g 9.80665 m/s².
// PUBLISHED  uplift of P10 at 0.324 g, of P20 at 0.251 g; P10 with μ = 0.3 slides at 0.300 g.
// TOLERANCE  half a unit of the last digit; 1e-8 between both methods, because the error of a solution of the limit analysis is 1e-9.

use dolmen::assess::{StackCheckOptions, check_stack};
use dolmen::comparisons::{p10, p20};
use dolmen::stability::stack::{LimitAnalysisStatus, LimitKind};
use dolmen::structure::stack::{Block, JointMaterial, Placement, Solid, Stack, StackError};

fn thresholds(stack: &Stack) -> (LimitKind, f64, f64) {
    let check = check_stack(stack, &StackCheckOptions::default()).unwrap();
    let governing = check.limits.governing.unwrap();
    let LimitAnalysisStatus::Limited(analysis) = check.analysis.unwrap().status else {
        panic!("no limit")
    };
    (
        governing.kind,
        governing.threshold.acceleration_g,
        analysis.acceleration_g,
    )
}

#[test]
fn published_thresholds_of_p10_and_p20() {
    let rough = JointMaterial::with_friction(0.6);
    let smooth = JointMaterial::with_friction(0.3);
    for (stack, kind, known) in [
        (p10(rough, 9.80665), LimitKind::Uplift, 0.324),
        (p20(rough, 9.80665), LimitKind::Uplift, 0.251),
        (p10(smooth, 9.80665), LimitKind::Sliding, 0.300),
    ] {
        let (found, joints, analysis) = thresholds(&stack.unwrap());
        assert_eq!(found, kind);
        assert!((joints - known).abs() < 5e-4, "{joints}");
        assert!((joints - analysis).abs() < 1e-8, "{joints} {analysis}");
    }
}

#[test]
fn exact_a_leaning_stone_slides_and_tips_down_its_own_bed() {
    // on the ground and on a level stone: the bed is inclined by β, so the stone tips at tan(α − β) and slides at tan(φ − β)
    let block = |name: &str, [width, height]: [f64; 2], tilt: f64, z: f64| Block {
        name: name.into(),
        solid: Solid::cuboid(width, 2.0 * width, height)
            .unwrap()
            .placed(&Placement {
                tilt: [tilt, 0.0],
                position_m: [0.0, 0.0, z],
                ..Placement::default()
            }),
        density_kg_m3: 2600.0,
    };
    for degrees in [1.0_f64, 3.0, 4.9] {
        let beta = degrees.to_radians();
        for (size, friction, kind) in [
            ([0.5_f64, 1.5], 0.6, LimitKind::Uplift),
            ([1.0, 0.5], 0.6, LimitKind::Sliding),
        ] {
            let alpha = match kind {
                LimitKind::Uplift => (size[0] / size[1]).atan(),
                _ => f64::atan(friction),
            };
            let known = (alpha - beta).tan();
            let material = JointMaterial::with_friction(friction);
            let alone = vec![block("leans", size, beta.tan(), 0.0)];
            let on_stone = vec![
                block("level", [3.0, 0.5], 0.0, 0.0),
                block("leans", size, beta.tan(), 0.5),
            ];
            for blocks in [alone, on_stone] {
                let (found, joints, analysis) = thresholds(&Stack::new(blocks, material, 9.80665).unwrap());
                assert_eq!(found, kind, "{degrees}");
                assert!((joints - known).abs() < 1e-9, "{degrees}: {joints} {known}");
                assert!((analysis - known).abs() < 1e-7, "{degrees}: {analysis} {known}");
            }
        }
    }
}

/// A block 0.6 × 0.8 × 1.1 m on a base 1.2 × 1.4 × 0.5 m, both rotated by the angle and given by their corners in whole units.
fn turned_pair(yaw_rad: f64, unit_m: f64, ridge_m: f64) -> Result<Stack, StackError> {
    let block = |name: &str, [width, depth, height]: [f64; 3], z: f64| {
        let solid = Solid::cuboid(width, depth, height).unwrap();
        let solid = solid.placed(&Placement {
            yaw_rad,
            tilt: [0.013, -0.008],
            position_m: [0.0, 0.0, z],
        });
        let mut corners = solid.vertices_m().to_vec();
        if ridge_m > 0.0 && name == "base" {
            let tops = corners.iter().filter(|corner| corner[2] > 0.25);
            let middle = tops.fold([0.0; 3], |sum, corner| {
                [0, 1, 2].map(|i| sum[i] + corner[i] / 4.0)
            });
            corners.push([middle[0], middle[1], middle[2] + ridge_m]);
        }
        let rounded = corners
            .iter()
            .map(|corner| corner.map(|x| (x / unit_m).round() * unit_m));
        Block {
            name: name.into(),
            solid: Solid::convex(&rounded.collect::<Vec<_>>()).unwrap(),
            density_kg_m3: 2600.0,
        }
    };
    let blocks = vec![
        block("base", [1.2, 1.4, 0.5], 0.0),
        block("stone", [0.6, 0.8, 1.1], 0.5),
    ];
    Stack::new(blocks, JointMaterial::with_friction(0.7), 9.80665)
}

#[test]
fn exact_stones_given_by_rounded_corners_move_first_as_those_known_exactly() {
    for case in 0..12 {
        let yaw_rad = 0.26 * f64::from(case);
        let (_, known, _) = thresholds(&turned_pair(yaw_rad, 1e-9, 0.0).unwrap());
        for unit_m in [1e-3, 1e-4, 1e-5] {
            let (_, found, _) = thresholds(&turned_pair(yaw_rad, unit_m, 0.0).unwrap());
            assert!(
                (found / known - 1.0).abs() < 6.0 * unit_m + 1e-6,
                "{case} {unit_m}: {found} {known}"
            );
        }
    }
}

#[test]
fn refuses_a_bed_of_several_facets() {
    // three millimetres higher in the middle than the plane of its corners, to a hundredth of a millimetre
    let fault = turned_pair(0.3, 1e-5, 3e-3).unwrap_err();
    let StackError::JointFacets {
        upper, lower, share, ..
    } = &fault
    else {
        panic!("{fault}")
    };
    assert_eq!((upper.as_str(), lower.as_str()), ("stone", "base"));
    assert!((0.2..0.6).contains(share), "{share}");
    assert!(fault.to_string().contains("largest is"), "{fault}");
}
