//! Whether a stack stands without shaking, and otherwise the reason.

use super::words::{DIGITS, megapascals, place};
use dolmen::stability::stack::Standing;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// Whether a stack stands; no full stop.
    pub(crate) enum Reason in "stack.standing" {
        Stands => { en: "it stands under its own weight", ko: "자중에 대하여 서 있다" },
        Leaves { above: Sentence, distance: Quantity } => {
            en: "above {above} the resultant leaves the joint by {distance}",
            ko: "{above} 위에서 합력이 접합면을 {distance} 벗어난다",
        },
        Slides { above: Sentence, shear: Quantity, resistance: Quantity } => {
            en: "above {above} a shear of {shear} slides the joint, which bears {resistance}",
            ko: "{above} 위에서 전단력 {shear}이(가) 마찰과 점착력 {resistance}을(를) 넘는다",
        },
        Lifts { above: Sentence, pull: Quantity } => {
            en: "above {above} static loads lift the blocks with {pull}",
            ko: "{above} 위의 접합면을 누르는 힘이 없다(인장력 {pull})",
        },
        Crushes { above: Sentence, distance: Quantity } => {
            en: "above {above} the stone crushes: the resultant lies {distance} beyond where its strength can bear it",
            ko: "{above} 위에서 합력이 석재 강도가 허용하는 선을 {distance} 벗어난다",
        },
        Overloaded { above: Sentence, pressure: Quantity, strength: Quantity } => {
            en: "above {above} the stone crushes: {pressure} over the whole joint, and its strength is {strength}",
            ko: "{above} 위의 평균 압력 {pressure}이(가) 압축강도 {strength}을(를) 넘는다",
        },
        CrushesTogether { strength: Quantity } => {
            en: "edges of stones that share their load crush: with a compressive strength of {strength} no forces in the joints balance the weight",
            ko: "하중을 나누어 지지하는 석재의 모서리가 압괴한다: 압축강도 {strength}에서는 자중과 평형을 이루는 접합력이 없다",
        },
        SoilTurns { stiffness: Quantity, least: Quantity } => {
            en: "the soil turns away under the stack: its rocking stiffness is {stiffness}, and weights and loads times their heights are {least}",
            ko: "지반의 회전 강성 {stiffness}이(가) 필요한 값(자중과 하중에 각각의 높이를 곱한 합) {least}보다 작다",
        },
        SoilOverturns { moment: Quantity, bears: Quantity } => {
            en: "static loads overturn the footing on its soil: their moment is {moment}, and it bears {bears}",
            ko: "정하중이 지반 위의 기초를 전도시킨다: 모멘트 {moment}이(가) 기초가 견디는 {bears}을(를) 넘는다",
        },
    }
}

/// Whether it stands without shaking, without a full stop.
pub(super) fn standing(of: &Standing) -> Sentence {
    let metres = |value| Quantity::new(value, Unit::si("m"), Digits::Significant(DIGITS));
    let engineering = |value, symbol| Quantity::engineering(value, symbol, DIGITS);
    let said = match of {
        Standing::Stands => Reason::Stands,
        Standing::Leaves { above, distance_m } => Reason::Leaves {
            above: place(above),
            distance: metres(*distance_m),
        },
        Standing::Slides {
            above,
            shear_n,
            resistance_n,
        } => Reason::Slides {
            above: place(above),
            shear: engineering(*shear_n, "N"),
            resistance: engineering(*resistance_n, "N"),
        },
        Standing::Lifts { above, pull_n } => Reason::Lifts {
            above: place(above),
            pull: engineering(*pull_n, "N"),
        },
        Standing::Crushes { above, distance_m } => Reason::Crushes {
            above: place(above),
            distance: metres(*distance_m),
        },
        Standing::Overloaded {
            above,
            pressure_pa,
            strength_pa,
        } => Reason::Overloaded {
            above: place(above),
            pressure: megapascals(*pressure_pa),
            strength: megapascals(*strength_pa),
        },
        Standing::CrushesTogether { strength_pa } => Reason::CrushesTogether {
            strength: megapascals(*strength_pa),
        },
        Standing::SoilTurns {
            stiffness_n_m_rad,
            least_n_m_rad,
        } => Reason::SoilTurns {
            stiffness: engineering(*stiffness_n_m_rad, "N·m/rad"),
            least: engineering(*least_n_m_rad, "N·m/rad"),
        },
        Standing::SoilOverturns {
            moment_n_m,
            bears_n_m,
        } => Reason::SoilOverturns {
            moment: engineering(*moment_n_m, "N·m"),
            bears: engineering(*bears_n_m, "N·m"),
        },
    };
    said.into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen_words::Language;

    #[test]
    fn exact_a_resultant_outside_its_joint_is_said_in_both_languages() {
        let leaves = standing(&Standing::Leaves {
            above: "'body 1'".into(),
            distance_m: 0.12,
        });
        assert_eq!(
            leaves.text(Language::Korean),
            "body 1 위에서 합력이 접합면을 0.120\u{202f}m 벗어난다"
        );
        assert_eq!(
            leaves.text(Language::English),
            "above body 1 the resultant leaves the joint by 0.120\u{202f}m"
        );
    }
}
