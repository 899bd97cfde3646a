// SOURCE     Virtual work by hand. Trilithon along x: both posts rotate about their feet, the lintel rises with the rising corners, λ = b/h; across,
//            all three rotate as one body. Towers: sums of moments of the part above each course, computed here.
// GOAL       First motion of trilithons and towers generated from their dimensions.
//
//        ┌──────────────┐        λ (2 w h/2 + W h) = 2 w b/2 + W b,  so λ = b/h whatever W
//        └─┬──┬────┬──┬─┘
//          │  │    │  │ h        across: λ (2 w h/2 + W (h + c/2)) = (2 w + W) d/2
//          └──┘    └──┘ b
//
// PARAMETERS four trilithons, six towers; friction 2, so that nothing slides, and 0.4.
// TOLERANCE  1e-7 by the limit analysis; hollow towers are between a wall that falls alone and the tower as one body.

use crate::stack_loads::{GRAVITY_M_S2, near};
use dolmen::assess::{StackCheckOptions, check_stack};
use dolmen::stability::Verdict;
use dolmen::stability::stack::{LimitAnalysis, LimitAnalysisStatus, Shaking, limit_analysis};
use dolmen::structure::stack::{
    Block, JointMaterial, Stack, TowerFactors, TowerPlan, TrilithonFactors, tower, trilithon,
};

fn moves_at_g(blocks: Vec<Block>, friction: f64, way: [f64; 2]) -> f64 {
    let stack = Stack::new(blocks, JointMaterial::with_friction(friction), GRAVITY_M_S2).unwrap();
    let options = LimitAnalysis {
        shaking: Shaking::Along(way),
        ..LimitAnalysis::default()
    };
    match limit_analysis(&stack, &options).unwrap().status {
        LimitAnalysisStatus::Limited(found) => found.acceleration_g,
        other => panic!("{other:?}"),
    }
}

#[test]
fn exact_a_trilithon_sways_at_the_slope_of_its_posts_whatever_it_carries() {
    for (width, height, lintel, overhang) in [
        (0.8, 3.2, 0.7, 0.1),
        (0.5, 4.0, 2.5, 0.0),
        (0.6, 1.8, 0.2, 0.5),
        (1.0, 4.0, 0.5, -0.3),
    ] {
        let factors = TrilithonFactors {
            span_m: 1.2,
            post_width_m: width,
            post_height_m: height,
            depth_m: 1.1,
            lintel_height_m: lintel,
            overhang_m: overhang,
            density_kg_m3: 2600.0,
        };
        let made = || trilithon(&factors).unwrap();
        // if its end is on a post, the lintel bears nearer to the span, on the rising corner or at its end
        let (post, beam) = (width * height, lintel * (1.2 + 2.0 * (width + overhang)));
        // the left post carries it at its left corner or at the end of the lintel, the right post at its left corner, when both lean to the right
        let left = width + overhang.min(0.0);
        let lifts = 2.0 * post * 0.5 * width + beam * 0.5 * (left + width);
        let sway = lifts / (2.0 * post * 0.5 * height + beam * height);
        if overhang >= 0.0 {
            near(moves_at_g(made(), 2.0, [1.0, 0.0]), sway, 1e-7);
            near(sway, width / height, 1e-12);
        } else {
            // the lintel rotates too: there is no closed form, but λ is smaller than with its ends on the corners
            let found = moves_at_g(made(), 2.0, [1.0, 0.0]);
            assert!(found < width / height && found > 0.5 * width / height, "{found}");
        }
        let across =
            (2.0 * post + beam) * 0.55 / (2.0 * post * 0.5 * height + beam * (height + 0.5 * lintel));
        near(
            moves_at_g(made(), 2.0, [0.0, 1.0]),
            across.min(0.55 / (0.5 * lintel)),
            1e-7,
        );
    }
}

const SOLID: TowerFactors = TowerFactors {
    plan: TowerPlan::Square,
    width_m: 1.5,
    top_width_m: 1.5,
    courses: 12,
    course_height_m: 0.5,
    thickness_m: None,
    density_kg_m3: 2600.0,
};

#[test]
fn exact_a_solid_tower_tips_where_what_stands_above_does() {
    near(
        moves_at_g(tower(&SOLID).unwrap(), 2.0, [1.0, 0.0]),
        1.5 / 6.0,
        1e-7,
    );
    for (width, top) in [(2.0, 1.0), (2.4, 0.6), (1.2, 1.1)] {
        let factors = TowerFactors {
            width_m: width,
            top_width_m: top,
            ..SOLID
        };
        let side = |course: usize| width + (top - width) * course as f64 / 11.0;
        let tips = (0..12).map(|from| {
            let (mut weight, mut moment) = (0.0, 0.0);
            for course in from..12 {
                let own = side(course) * side(course);
                weight += own;
                moment += own * 0.5 * ((course - from) as f64 + 0.5);
            }
            0.5 * side(from) * weight / moment
        });
        let known = tips.fold(f64::INFINITY, f64::min);
        near(moves_at_g(tower(&factors).unwrap(), 2.0, [1.0, 0.0]), known, 1e-7);
        // a drum is a polygon of 32 sides, whose edges are up to 0.48 % nearer to the centre
        let round = TowerFactors {
            plan: TowerPlan::Round { stones: 12 },
            ..factors
        };
        let found = moves_at_g(tower(&round).unwrap(), 2.0, [1.0, 0.0]);
        assert!((0.995..1.0 + 1e-7).contains(&(found / known)), "{found} {known}");
    }
}

#[test]
fn holds_a_hollow_tower_lies_between_its_wall_alone_and_the_tower_as_one() {
    for plan in [TowerPlan::Square, TowerPlan::Round { stones: 8 }] {
        let factors = TowerFactors {
            plan,
            courses: 8,
            thickness_m: Some(0.3),
            ..SOLID
        };
        let stack = Stack::new(
            tower(&factors).unwrap(),
            JointMaterial::with_friction(0.6),
            GRAVITY_M_S2,
        )
        .unwrap();
        let check = check_stack(&stack, &StackCheckOptions::default()).unwrap();
        assert_ne!(check.verdict, Verdict::Unstable, "{plan:?}");
        let found = check.capacity.unwrap().acceleration_g;
        let (wall, whole) = (0.3 / 4.0, 1.5 / 4.0);
        assert!(found > wall && found < whole * 1.0001, "{plan:?}: {found}");
    }
}
