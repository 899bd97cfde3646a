//! The lowest joint in series with the soil.

use crate::document::{Finding, Tone};
use dolmen::assess::JointOnSoil;
use dolmen::structure::Soil;
use dolmen_words::{Quantity, messages};

/// Share of the rotation from which the soil governs. Our choice.
const SOIL_GOVERNS: f64 = 0.5;
/// Digits of stiffness and shares.
const DIGITS: usize = 3;

messages! {
    /// Joint and soil.
    pub(crate) enum OnSoil in "chain.soil" {
        Share { soil: Quantity, joint: Quantity, together: Quantity, share: Quantity } => {
            en: "The foot turns on its bed ({joint}) and the soil ({soil}) in series: {together}. The soil takes {share} of the rotation; a frequency sees only the two together.",
            ko: "하단은 접합면({joint})과 지반({soil})이 직렬로 회전하며 합성 강성은 {together}이다. 회전의 {share}이(가) 지반에서 일어나며, 진동수로는 둘의 합만 알 수 있다.",
        },
        SoilAlone { soil: Quantity } => {
            en: "The soil under the footing has a rocking stiffness of {soil}: no measured joint 1 can be stiffer, for it holds both.",
            ko: "기초 아래 지반의 회전강성은 {soil}이다. 실측으로 구한 접합면 1의 강성은 둘을 합한 것이므로 이보다 클 수 없다.",
        },
        BedAlone { survey: String, together: Quantity, soil: Quantity, joint: Quantity } => {
            en: "Survey {survey}: joint 1 as identified, {together}, holds bed and soil. With the soil of the file ({soil}) the bed alone has {joint}; how far the soil is wrong is not in that.",
            ko: "{survey} 조사: 추정한 접합면 1의 강성 {together}에는 지반이 포함되어 있다. 파일의 지반({soil})을 빼면 접합면만의 강성은 {joint}이며, 지반 값의 오차는 포함하지 않았다.",
        },
        TooSoft { survey: String, together: Quantity, soil: Quantity } => {
            en: "Survey {survey}: joint 1 as identified, {together}, is no softer than the soil of the file alone ({soil}). In series with it no bed can be so stiff: is the shear modulus or the footing wrong?",
            ko: "{survey} 조사: 추정한 접합면 1의 강성 {together}이(가) 파일의 지반({soil})만의 강성보다 작지 않다. 직렬로는 불가능하므로 전단탄성계수나 기초 크기를 확인해야 한다.",
        },
    }
}

fn spring(n_m_rad: f64) -> Quantity {
    Quantity::engineering(n_m_rad, "N·m/rad", DIGITS)
}

/// The share of the soil.
pub(super) fn finding(of: &JointOnSoil) -> Finding {
    let soil = spring(of.soil_n_m_rad);
    match (of.joint_n_m_rad, of.together_n_m_rad, of.soil_share()) {
        (Some(joint), Some(together), Some(share)) => {
            let said = OnSoil::Share {
                soil,
                joint: spring(joint),
                together: spring(together),
                share: Quantity::percent(share, DIGITS),
            };
            match share >= SOIL_GOVERNS {
                true => Finding::key(Tone::Plain, said),
                false => Finding::new(Tone::Plain, said),
            }
        }
        _ => Finding::new(Tone::Plain, OnSoil::SoilAlone { soil }),
    }
}

/// The bed alone of a lowest joint that a survey determines.
pub(crate) fn identified(soil: &Soil, survey: &str, together_n_m_rad: f64) -> Finding {
    let (survey, together) = (survey.to_owned(), spring(together_n_m_rad));
    match soil.joint_n_m_rad(together_n_m_rad) {
        Some(joint) => {
            let said = OnSoil::BedAlone {
                survey,
                together,
                soil: spring(soil.rocking_n_m_rad()),
                joint: spring(joint),
            };
            Finding::key(Tone::Plain, said)
        }
        None => {
            let said = OnSoil::TooSoft {
                survey,
                together,
                soil: spring(soil.rocking_n_m_rad()),
            };
            Finding::key(Tone::Bad, said)
        }
    }
}
