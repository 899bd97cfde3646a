// SOURCE     simulated cases; geometry by hand in each test.
// GOAL       A stone falls relative to the stone below: its centroid drops by more than half its least thickness, its bed rotates by more than
//            45°, contact is lost for good, or it lies on another face. A criterion relative to the ground, with a quarter of the thickness,
//            gave wrong results in both directions.
// PARAMETERS given in each test; 2600 kg/m³, g 9.81.
// TOLERANCE  none: kinds of outcome. Times to the sampling of 5 ms.

use dolmen::blocks::{Outcome, Springs, StackHistory, Start, simulate_springs};
use dolmen::structure::stack::{Block, JointMaterial, Placement, Solid, Stack};

fn block(name: &str, solid: Solid, position_m: [f64; 3]) -> Block {
    Block {
        name: name.into(),
        solid: solid.placed(&Placement {
            position_m,
            ..Placement::default()
        }),
        density_kg_m3: 2600.0,
    }
}

fn cuboid(name: &str, size: [f64; 3], position_m: [f64; 3]) -> Block {
    block(
        name,
        Solid::cuboid(size[0], size[1], size[2]).unwrap(),
        position_m,
    )
}

fn pushed(blocks: Vec<Block>, friction: f64, starts: Vec<Start>) -> StackHistory {
    let stack = Stack::new(blocks, JointMaterial::with_friction(friction), 9.81).unwrap();
    let options = Springs {
        starts,
        ..Springs::default()
    };
    simulate_springs(&stack, None, &options, &mut |_| true).unwrap()
}

/// Largest drop of the centroid of a block below its start, m.
fn deepest_m(history: &StackHistory, block: usize) -> f64 {
    let height = |sample: usize| history.pose(sample, block).centroid_m[2];
    let rest = history.poses[block].centroid_m[2];
    let each = (0..history.time_s.len()).map(|sample| rest - height(sample));
    each.fold(0.0, f64::max)
}

#[test]
fn holds_a_slab_that_rides_on_a_rocking_stone_has_not_fallen() {
    // a stone wider at its top, rotated by 0.1 rad about its edge at x = 0.15. On it is a slab of 40 mm with its centroid beyond that edge, at x
    // = 0.25: the slab drops by 0.10 sin 0.1 + 2 (1 − cos 0.1) = 20 mm, half its thickness, and stays in place
    let stone = Solid::frustum([0.3, 0.6], [0.7, 0.6], 2.0).unwrap();
    let blocks = vec![
        block("stone", stone, [0.0; 3]),
        cuboid("slab", [0.15, 0.5, 0.04], [0.26, 0.0, 2.0]),
    ];
    let turned = |block: usize| Start {
        pivot_m: [0.15, 0.0, 0.0],
        turn_rad: [0.0, 0.1, 0.0],
        ..Start::of(block)
    };
    let history = pushed(blocks, 0.8, vec![turned(0), turned(1)]);
    let rest_m = 2.02;
    let start_m = history.pose(0, 1).centroid_m[2];
    assert!(rest_m - start_m > 0.02, "{start_m}");
    assert!(
        matches!(history.outcome, Outcome::Uplifted { .. }),
        "{:?}",
        history.outcome
    );
}

#[test]
fn holds_a_cube_that_slid_off_its_slab_has_fallen() {
    // it drops by 50 mm, an eighth of its thickness, and is upright again, next to its slab
    let blocks = vec![
        cuboid("slab", [0.4, 0.4, 0.05], [0.0; 3]),
        cuboid("cube", [0.4, 0.4, 0.4], [0.0, 0.0, 0.05]),
    ];
    let push = Start {
        velocity_m_s: [2.2, 0.0, 0.0],
        ..Start::of(1)
    };
    let history = pushed(blocks, 0.2, vec![push]);
    let last = history.pose(history.time_s.len() - 1, 1);
    let upright = 1.0 - 2.0 * (last.rotation[1].powi(2) + last.rotation[2].powi(2));
    assert!(upright > 0.99, "{last:?}");
    assert!(deepest_m(&history, 1) < 0.1, "{}", deepest_m(&history, 1));
    assert!(
        matches!(history.outcome, Outcome::Fell { block: 1, .. }),
        "{:?} {last:?}",
        history.outcome
    );
}

#[test]
fn holds_a_prism_that_rolled_to_its_next_face_has_fallen() {
    // twelve sides, 1 m across: it is as low on the next face as on the first, rotated by 30°
    let radius = 0.5 / (std::f64::consts::PI / 12.0).cos();
    let ring = |y: f64| {
        (0..12).map(move |corner| {
            let angle = std::f64::consts::PI * (2.0 * f64::from(corner) + 1.0) / 12.0;
            [radius * angle.sin(), y, 0.5 - radius * angle.cos()]
        })
    };
    let points: Vec<[f64; 3]> = ring(-0.5).chain(ring(0.5)).collect();
    let blocks = vec![Block {
        name: "prism".into(),
        solid: Solid::convex(&points).unwrap(),
        density_kg_m3: 2600.0,
    }];
    // to pass the edge it must rise by 17.6 mm, with I = 0.398 m about it: ω > 0.93 rad/s; with 0.94 the impact dissipates enough for it to stay
    // on the next face
    let roll = Start {
        pivot_m: [radius * (std::f64::consts::PI / 12.0).sin(), 0.0, 0.0],
        velocity_m_s: [0.47, 0.0, 0.1259],
        spin_rad_s: [0.0, 0.94, 0.0],
        ..Start::of(0)
    };
    let history = pushed(blocks, 0.8, vec![roll]);
    let last = history.pose(history.time_s.len() - 1, 0);
    let turned = 2.0 * last.rotation[2].atan2(last.rotation[0]).to_degrees();
    assert!((turned.abs() - 30.0).abs() < 1.0, "{turned}");
    assert!(
        matches!(history.outcome, Outcome::Fell { block: 0, .. }),
        "{:?}",
        history.outcome
    );
}
