//! The acceleration at which a stack begins to move, by its joints and by limit analysis.

use super::AssessError;
use super::stack_on_soil::on_soil;
use crate::stability::stack::{
    Holding, LimitAnalysis, LimitAnalysisStatus, OnSoil, Shaking, StackLimitStates, StackLimits, Threshold,
    Undilated, limit_analysis_undilated, stack_limits,
};
use crate::structure::stack::Stack;

/// Relative distance from which two bounds of an acceleration count as different: the answer prints three digits. Our choice.
pub(super) const BETWEEN: f64 = 1e-3;

/// The limit analysis of a stack, and the acceleration at which it begins to move.
pub(super) struct FirstMotion {
    pub(super) found: Undilated,
    pub(super) soil: OnSoil,
    /// The smallest acceleration of single joints.
    pub(super) governing: Option<Threshold>,
    /// The smaller of that and the limit of the analysis.
    pub(super) least: Option<Threshold>,
    /// Acceleration up to which the analysis found balanced forces, over gravity.
    pub(super) at_least_g: f64,
}

impl FirstMotion {
    pub(super) fn of(
        stack: &Stack,
        asked: &StackLimits,
        limits: &StackLimitStates,
    ) -> Result<Self, AssessError> {
        let governing = governing_joint(limits);
        let shaking = match governing {
            Some(threshold) if limits.statically_determinate => Shaking::Along(threshold.direction),
            _ => Shaking::AnyWay,
        };
        let soil = OnSoil::of(stack, &asked.loads)?;
        let analysis = LimitAnalysis {
            loads: asked.loads.clone(),
            shaking,
            holding: Holding::Cohesion,
            ..LimitAnalysis::default()
        };
        let found = limit_analysis_undilated(stack, &analysis)?;
        let mut at_least_g = found.analysis.at_least_g;
        let overturns = limits.footing.map(|footing| footing.overturns);
        let mut least = sooner(governing, overturns);
        if let LimitAnalysisStatus::Limited(threshold) = found.analysis.status {
            let turned = on_soil(stack, &soil, &analysis, &threshold)?;
            at_least_g = soil
                .over_gravity(at_least_g, &threshold)
                .min(turned.acceleration_g);
            if least.is_none_or(|least| turned.acceleration_m_s2 < least.acceleration_m_s2) {
                least = Some(turned);
            }
        }
        Ok(FirstMotion {
            found,
            soil,
            governing,
            least,
            at_least_g,
        })
    }

    /// The acceleration at which it begins to move; `None` if it does not stand, or if nothing moves it.
    pub(super) fn capacity(&self) -> Option<Threshold> {
        if self.found.analysis.status == LimitAnalysisStatus::DoesNotStand {
            return None;
        }
        // otherwise what the soil turns at rest is more than a joint bears
        let least = self.least.filter(|least| least.acceleration_m_s2 > 0.0)?;
        if !self.is_between() {
            return Some(least);
        }
        let share = self.at_least_g / least.acceleration_g;
        Some(Threshold {
            acceleration_g: self.at_least_g,
            acceleration_m_s2: share * least.acceleration_m_s2,
            ..least
        })
    }

    /// Whether the analysis knows the acceleration only between two bounds; the lower one counts.
    pub(super) fn is_between(&self) -> bool {
        let least = self.least.as_ref();
        least.is_some_and(|least| self.at_least_g < (1.0 - BETWEEN) * least.acceleration_g)
    }
}

/// The capacity of [`super::check_stack`] alone: without its verdict, its notes and moving supports.
pub(super) fn first_motion(stack: &Stack, asked: &StackLimits) -> Result<Option<Threshold>, AssessError> {
    let limits = stack_limits(stack, asked)?;
    match limits.standing.stands() {
        true => Ok(FirstMotion::of(stack, asked, &limits)?.capacity()),
        false => Ok(None),
    }
}

/// The smallest acceleration at which a single joint opens or slides.
pub(super) fn governing_joint(limits: &StackLimitStates) -> Option<Threshold> {
    let both = [limits.uplift, limits.sliding].into_iter().flatten();
    both.map(|governing| governing.threshold)
        .min_by(|a, b| a.acceleration_m_s2.total_cmp(&b.acceleration_m_s2))
}

/// The smaller of two thresholds.
pub(super) fn sooner(one: Option<Threshold>, other: Option<Threshold>) -> Option<Threshold> {
    let both = [one, other].into_iter().flatten();
    both.min_by(|a, b| a.acceleration_m_s2.total_cmp(&b.acceleration_m_s2))
}
