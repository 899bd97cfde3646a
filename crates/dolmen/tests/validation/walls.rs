// SOURCE     Rigid leaves that rotate about their outer edges: a/g = thickness over height; two posts under a lintel: a/g =
//            b/h.
// GOAL       Leaves without through stones act separately; through stones make them one wall; an opening makes two piers.
// PARAMETERS walls of 6 courses of 0.3 m, 0.6 m thick in one to three leaves; friction 5 (no sliding).
// TOLERANCE  1e-6 of the acceleration.

use dolmen::stability::stack::{LimitAnalysis, LimitAnalysisStatus, Shaking, limit_analysis};
use dolmen::structure::stack::{JointMaterial, Stack, WallFactors, WallOpening, wall};

const COURSES: u32 = 6;
const COURSE_M: f64 = 0.3;
const THICKNESS_M: f64 = 0.6;
const CORE_M: f64 = 0.06;

fn factors(leaves: u32, through_every: Option<u32>, openings: Vec<WallOpening>) -> WallFactors {
    WallFactors {
        length_m: 2.4,
        thickness_m: THICKNESS_M,
        courses: COURSES,
        course_height_m: COURSE_M,
        stone_length_m: 0.8,
        leaves,
        core_m: CORE_M,
        through_every,
        openings,
        density_kg_m3: 2600.0,
    }
}

fn moves_at_g(factors: &WallFactors, along: [f64; 2]) -> f64 {
    let stack = Stack::new(wall(factors).unwrap(), JointMaterial::with_friction(5.0), 9.81).unwrap();
    let options = LimitAnalysis {
        shaking: Shaking::Along(along),
        ..LimitAnalysis::default()
    };
    match limit_analysis(&stack, &options).unwrap().status {
        LimitAnalysisStatus::Limited(found) => found.acceleration_g,
        other => panic!("{other:?}"),
    }
}

#[test]
fn exact_leaves_fall_alone_and_through_stones_hold_them() {
    let height = f64::from(COURSES) * COURSE_M;
    let whole = THICKNESS_M / height;
    for leaves in [1, 2, 3] {
        let alone = moves_at_g(&factors(leaves, None, vec![]), [0.0, 1.0]);
        let count = f64::from(leaves);
        let leaf = (THICKNESS_M - (count - 1.0) * CORE_M) / count / height;
        assert!((alone - leaf).abs() < 1e-6, "{leaves} leaves: {alone} for {leaf}");
        let bonded = moves_at_g(&factors(leaves, Some(1), vec![]), [0.0, 1.0]);
        assert!(
            (bonded - whole).abs() < 1e-6,
            "{leaves} bonded: {bonded} for {whole}"
        );
    }
    // some through stones increase the capacity, but not beyond that of all
    let none = moves_at_g(&factors(2, None, vec![]), [0.0, 1.0]);
    let some = moves_at_g(&factors(2, Some(3), vec![]), [0.0, 1.0]);
    assert!(some > none + 0.01 && some <= whole + 1e-6, "{some}");
}

#[test]
fn exact_an_opening_under_its_lintel_sways_as_two_posts() {
    for (pier_m, leaves) in [(0.6, 1), (0.8, 1), (0.6, 2)] {
        let opening = WallOpening {
            from_m: pier_m,
            width_m: 2.4 - 2.0 * pier_m,
            first_course: 1,
            courses: COURSES - 1,
            bearing_m: pier_m,
        };
        let found = moves_at_g(&factors(leaves, None, vec![opening]), [1.0, 0.0]);
        let posts = pier_m / (f64::from(COURSES - 1) * COURSE_M);
        assert!((found - posts).abs() < 1e-6, "{pier_m}: {found} for {posts}");
    }
}
