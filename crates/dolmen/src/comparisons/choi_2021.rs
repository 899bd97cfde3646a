//! Choi (2021): the stone flagpole of Naju.

use super::{Case, ValidationError};
use crate::assess::centroid_effect;
use crate::known::choi_2021 as paper;
use crate::stability::chain_limits;
use crate::structure::{Chain, Inertia, Link};

const SOURCE: &str = "Choi (2021)";
const KILO: f64 = 1e3;
/// Gravity for the masses. Critical stiffness does not depend on it, because weights are given.
const GRAVITY_M_S2: f64 = 9.81;
/// Half a unit of the last printed digit, two decimals.
const ROUNDED: f64 = 0.005;
/// One unit of the last digit: Table 3 truncates some numbers (127.586 as 127.58) and rounds others (10.6676 as
/// 10.67).
const CUT_OFF: f64 = 0.01;
/// Half a unit of one printed decimal.
const ROUNDED_1: f64 = 0.05;

const UNSAFE: &str = "A pole with the published k_cr falls: K has a zero diagonal and is indefinite. Corrected: what \
                      this joint needs with every other joint rigid; together the joints need 2.4765 times that.";
const ARTEFACT: &str = "Lowering a centre of mass never asks for more stiffness: ∂K/∂l_i = −w_i e_i e_iᵀ. A published \
                        k_cr that rises is an artefact of its criterion. Table 3 cuts some last digits off. \
                        Corrected: the joint's exact limit with every other joint rigid.";
const RATE: &str = "Corrected: the change of the joint's exact limit, which never rises.";

/// The stone flagpole of Naju, Table 1 of Choi (2021): five links as thin rods, without the cap stone, as in the
/// source (unsafe).
///
/// # Errors
/// [`ValidationError::Structure`] if `gravity_m_s2`, by which the weights are divided, is not positive.
pub fn naju_flagpole(gravity_m_s2: f64) -> Result<Chain, ValidationError> {
    let link = |i: usize| Link {
        mass_kg: paper::WEIGHT_KN[i] * KILO / gravity_m_s2,
        length_m: paper::LENGTH_M[i],
        centroid_m: paper::CENTROID_M[i],
        inertia: Inertia::ThinRod,
        bed_width_m: None,
    };
    Ok(Chain::new((0..5).map(link).collect(), gravity_m_s2)?)
}

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let chain = naju_flagpole(GRAVITY_M_S2)?;
    let limits = chain_limits(&chain)?;
    let mut cases = Vec::new();
    for i in 0..5 {
        cases.push(Case {
            source: SOURCE,
            what: format!("Table 1: critical stiffness of joint {}", i + 1),
            unit: "kN m/rad",
            published: paper::CRITICAL_KN_M_RAD[i],
            computed: limits.published_critical_n_m_rad[i] / KILO,
            tolerance: ROUNDED,
            corrected: Some(limits.necessary_n_m_rad[i] / KILO),
            note: UNSAFE,
        });
    }
    for (published, i) in paper::BUCKLING_RATIO_ENDS.into_iter().zip([0, 4]) {
        cases.push(Case {
            source: SOURCE,
            what: format!("Table 2: k_b,cr / k_cr of joint {}", i + 1),
            unit: "",
            published,
            computed: limits.published_ratio[i],
            tolerance: ROUNDED_1,
            corrected: None,
            note: "k_b,cr = P H is unsafe too, by 2.65 % on this pole: 1/λ = 1.026526.",
        });
    }
    for (link, published, change) in [
        (
            3,
            paper::CRITICAL_LOWERED_3_KN_M_RAD,
            paper::CHANGE_LOWERED_3_PERCENT,
        ),
        (
            5,
            paper::CRITICAL_LOWERED_5_KN_M_RAD,
            paper::CHANGE_LOWERED_5_PERCENT,
        ),
    ] {
        let effect = centroid_effect(&chain, link, -0.2, None)?;
        for i in 0..5 {
            cases.push(Case {
                source: SOURCE,
                what: format!(
                    "Table 3: critical stiffness of joint {}, centroid of #{link} 20 % lower",
                    i + 1
                ),
                unit: "kN m/rad",
                published: published[i],
                computed: effect.published_critical_n_m_rad[i] / KILO,
                tolerance: CUT_OFF,
                corrected: Some(effect.necessary_n_m_rad[i] / KILO),
                note: ARTEFACT,
            });
            let per_cent = |with: f64, without: f64| 100.0 * (with / without - 1.0);
            let before = limits.published_critical_n_m_rad[i];
            cases.push(Case {
                source: SOURCE,
                what: format!(
                    "Table 3: its change, joint {}, centroid of #{link} 20 % lower",
                    i + 1
                ),
                unit: "%",
                published: change[i],
                computed: per_cent(effect.published_critical_n_m_rad[i], before),
                tolerance: ROUNDED_1,
                corrected: Some(per_cent(effect.necessary_n_m_rad[i], limits.necessary_n_m_rad[i])),
                note: RATE,
            });
        }
    }
    Ok(cases)
}
