// SOURCE     Housner (1963) Bull. Seism. Soc. Am. 53(2):403-417; Newmark (1965) Géotechnique 15(2):139-160; Farkas et al.
//            (2003) Phys. Rev. Lett. 90:248302.
// GOAL       Motion of a rigid block that rocks, slides or spins, and the cases in which the source is not conservative.
// PARAMETERS block 0.4 × 2.0 m; half sine of ω/p = 1 to 4; pulse 0.5 g, 0.2 s, μ 0.3, g 9.81; disc.
// PUBLISHED  r (of energies) 0.8879; half sine √(1 + (ω/p)²); slip V²/(2gN)(1 − N/A) = 65.40 mm; v/(ωR) → 0.653.
// TOLERANCE  rounding for formulas; half a unit of the last digit written; 0.001 mm for the flank of the pulse.

use super::published::of;

#[test]
fn published_housner_and_what_is_right() {
    let cases = of("Housner (1963)");
    let right = [0.942308, 1.3224, 1.8007, 2.2939, 2.7908];
    assert_eq!(cases.len(), right.len());
    for (case, right) in cases.iter().zip(right) {
        let corrected = case.corrected.unwrap();
        assert!(
            (corrected - right).abs() < 5e-5,
            "{}: {corrected} is not {right}",
            case.what
        );
    }
    // Not conservative: the printed amplitude is above the one that overturns.
    assert!(
        cases[1..]
            .iter()
            .all(|case| case.published > 1.06 * case.corrected.unwrap())
    );
}

#[test]
fn published_sliding_and_spinning() {
    let [pulse] = &of("Newmark (1965)")[..] else {
        panic!("one case expected")
    };
    assert!((pulse.published - 65.40).abs() < 0.005);
    assert_eq!(of("Farkas et al. (2003)").len(), 1);
}
