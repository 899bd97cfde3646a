//! The seismic demand, as JSON.

use super::local_mechanisms::local_mechanisms_demand;
use crate::as_json;
use crate::demand::{ground_word, type_word};
use crate::limits::parts_json;
use dolmen::assess::demand::{ShakenDirection, SiteParameters, StackDemandCheck};
use dolmen::stability::stack::{DemandVerdict, LimitKind, Threshold};
use dolmen_work::part_limit::{NotCompared, WhyNotCompared};
use dolmen_work::state::DemandAnswer;
use serde_json::Value;

/// The site, its numbers, and the demand on the structure.
pub(super) fn demand(answer: &DemandAnswer) -> Value {
    let site = &answer.site;
    let spectrum = &site.spectrum;
    as_json!({
        "source": spectrum.source,
        "parameters": parameters(&site.parameters),
        "damping_ratio": site.damping_ratio,
        "peak_ground_acceleration_m_s2": site.peak_ground_acceleration_m_s2,
        "vertical": site.vertical.map(|v| as_json!({ "ratio": v.ratio, "verified": v.verified })),
        "unverified": spectrum.unverified.iter().map(ToString::to_string).collect::<Vec<_>>(),
        "limits": parts_json(&answer.compared.parts, answer.drift_limit.as_ref()),
        "not_compared": answer.compared.not_compared.iter().map(not_compared).collect::<Vec<_>>(),
        "stiffness_shared": answer.compared.splits.iter().map(|of| as_json!({
            "direction": of.direction,
            "storey": of.in_beds.part.name(),
            "is_bed_stiffness_given": of.beds.is_file(),
            "bed_stiffness_n_m": of.shares_n_m[0],
            "joint_stiffness_n_m": of.shares_n_m[1],
            "drift_linear": of.in_joints,
            "drift_with_lift_off": Some(of.in_beds.demand).filter(|drift| drift.is_finite()),
            "lift_off_drift": of.uplift,
        })).collect::<Vec<_>>(),
        "softening_not_followed": answer.compared.unfollowed.iter().map(|(direction, of)| as_json!({
            "direction": direction,
            "storey": of.name,
            "is_bed_stiffness_given": of.beds.is_file(),
            "drift_linear": of.drift,
            "lift_off_drift": of.uplift,
        })).collect::<Vec<_>>(),
        "spectral": answer.spectral,
        "refused": answer.refused.as_ref().map(|why| &why.english),
        "stack": answer.stack.as_ref().map(stack),
        "by_velocity": answer.by_velocity.as_ref().map(|of| as_json!({
            "spectral_velocity_m_s": of.velocity.velocity_m_s,
            "period_s": of.velocity.period_s,
            "slenderness_rad": of.block.slenderness_rad,
            "frequency_parameter_rad_s": of.block.frequency_parameter_rad_s,
            "radius_m": of.block.radius_m,
            "critical_slenderness_rad": of.critical_slenderness_rad,
            "ratio": of.ratio(),
            "published_3_rad": of.published_3_rad,
            "published_2a_m_s2": of.published_2a_m_s2,
        })),
        "local_mechanisms": local_mechanisms_demand(&answer.local_mechanisms),
        "near_below": DemandVerdict::NEAR_BELOW,
    })
}

fn not_compared(of: &NotCompared) -> Value {
    as_json!({
        "direction": of.direction,
        "why": match of.why {
            WhyNotCompared::StiffnessUnknown => "stiffness unknown",
            WhyNotCompared::Falls => "falls",
            WhyNotCompared::LoosePost => "a side post with a gap may close",
            WhyNotCompared::FeetLiftOff => "columns without ties lift off",
            WhyNotCompared::NoBalance => "columns and joints have less than the spectrum asks for",
            WhyNotCompared::FallsSlipping => "falls while its joints slip",
            WhyNotCompared::NoSpectrum => "the spectrum has no value at its damping or periods",
        },
    })
}

fn parameters(parameters: &SiteParameters) -> Value {
    match parameters {
        SiteParameters::Korea {
            zone_factor_g,
            return_period_years,
            risk_factor,
            effective_acceleration_g,
            soil,
            amplification,
            design,
            branches,
        } => as_json!({ "korea": {
            "zone_factor_g": zone_factor_g,
            "return_period_years": return_period_years,
            "risk_factor": risk_factor,
            "effective_acceleration_g": effective_acceleration_g,
            "soil": format!("{soil:?}"),
            "amplification_short_periods": amplification.short_periods,
            "amplification_one_second": amplification.one_second,
            "design_short_period_g": design.map(|design| design.short_period_g),
            "design_one_second_g": design.map(|design| design.one_second_g),
            "branches": branches,
        } }),
        SiteParameters::Eurocode {
            ground_acceleration_g,
            importance_factor,
            spectrum,
            ground,
            soil_factor,
            branches,
        } => as_json!({ "eurocode": {
            "ground_acceleration_g": ground_acceleration_g,
            "importance_factor": importance_factor,
            "spectrum_type": type_word(*spectrum),
            "ground": ground_word(*ground),
            "soil_factor": soil_factor,
            "branches": branches,
        } }),
        SiteParameters::Table {
            rows,
            least_s,
            most_s,
        } => as_json!({ "table": { "rows": rows, "least_s": least_s, "most_s": most_s } }),
    }
}

fn stack(stack: &StackDemandCheck) -> Value {
    let at = |threshold: &Option<Threshold>| threshold.as_ref().map(|t| t.acceleration_m_s2);
    as_json!({
        "verdict": stack.verdict,
        "vertical_acceleration_m_s2": stack.vertical_acceleration_m_s2,
        "rows": stack.rows.iter().map(|row| as_json!({
            "direction": match row.direction {
                ShakenDirection::X => "x",
                ShakenDirection::Y => "y",
                ShakenDirection::Any => "any",
            },
            "capacity_m_s2": at(&row.capacity),
            "capacity_with_vertical_m_s2": at(&row.capacity_with_vertical),
            "period_s": row.period_s,
            "amplification": row.amplification,
            "rigid": row.comparison.rigid,
            "elastic_published": row.comparison.elastic,
            "elastic_by_modes": row.by_modes.as_ref().map(|by_modes| as_json!({
                "ratio": by_modes.ratio,
                "verdict": by_modes.verdict,
                "first": by_modes.first.as_ref().map(|(kind, above)| as_json!({
                    "kind": match kind {
                        LimitKind::Uplift => "tipping",
                        LimitKind::Sliding => "sliding",
                    },
                    "above": above,
                })),
            })),
            "verdict": row.verdict,
        })).collect::<Vec<_>>(),
    })
}
