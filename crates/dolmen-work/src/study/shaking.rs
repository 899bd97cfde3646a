//! Measures of shaking other than the peak of the ground, and the most informative of them.

use super::answer::StudyAnswer;
use super::combination_fragility::{CombinationFragility, StateFragility};
use super::scans::STATES;
use super::shaking_measure::{MeasureComparison, ShakingMeasure};
use dolmen::assess::{Observation, fit_fragility_of_motions};

impl StudyAnswer {
    /// The measures other than the peak acceleration that are known for this study.
    pub fn measures(&self) -> Vec<ShakingMeasure> {
        let mut found = vec![ShakingMeasure::PeakVelocity];
        if !self.shaking.spectral_over_peak.is_empty() {
            let periods = self.study.spectral_periods_s.iter().enumerate();
            found.extend(periods.map(|(index, &period_s)| ShakingMeasure::Spectral { index, period_s }));
        }
        if self.shaking.rocking.iter().any(Option::is_some) {
            found.extend([ShakingMeasure::UpliftRatio, ShakingMeasure::VelocityRatio]);
        }
        found
    }

    /// A measure of the shaking of a job at a peak acceleration, m/s², and a peak velocity, m/s; `None` where unknown.
    pub fn intensity(&self, job: usize, measure: ShakingMeasure, [peak, velocity]: [f64; 2]) -> Option<f64> {
        let rocking = || {
            let of = self.shaking.rocking.get(self.combination_of(job));
            of.copied().flatten()
        };
        match measure {
            ShakingMeasure::PeakVelocity => Some(velocity),
            ShakingMeasure::Spectral { index, .. } => {
                let turns = self.study.turns_rad.len();
                let place = self.motion_index(job) * turns + job % turns;
                let row = self.shaking.spectral_over_peak.get(place)?;
                Some(peak * row.get(index)?)
            }
            ShakingMeasure::UpliftRatio => Some(rocking()?.uplift_ratio(peak, self.gravity_m_s2)),
            ShakingMeasure::VelocityRatio => Some(rocking()?.velocity_ratio(velocity, self.gravity_m_s2)),
        }
    }

    pub(super) fn fit_measures(&self, found: &[CombinationFragility]) -> Vec<MeasureComparison> {
        let measures = self.measures();
        let mut all = Vec::new();
        for state in 0..STATES {
            let own = found.iter().filter_map(|one| {
                let own = one.states.iter().find(|own| own.state == state)?;
                (own.by_measure.len() == measures.len()).then_some(own)
            });
            let own: Vec<&StateFragility> = own.collect();
            let betas = |state: &&StateFragility| -> Vec<Option<f64>> {
                let fits = std::iter::once(&state.by_acceleration);
                let fits = fits.chain(state.by_measure.iter().map(|by| &by.fit));
                fits.map(|fit| Some(fit.as_ref().ok()?.curve.beta())).collect()
            };
            let of_each: Vec<Vec<Option<f64>>> = own.iter().map(betas).collect();
            let whole: Vec<&Vec<Option<f64>>> = match of_each.as_slice() {
                [only] => vec![only],
                several => several
                    .iter()
                    .filter(|betas| betas.iter().all(Option::is_some))
                    .collect(),
            };
            let mean_square = |place: usize| {
                let squares = whole.iter().map(|betas| betas[place].map(|beta| beta * beta));
                let squares: Vec<f64> = squares.collect::<Option<_>>()?;
                let count = squares.len() as f64;
                (count > 0.0).then(|| (squares.iter().sum::<f64>() / count).sqrt())
            };
            let together = |place: usize| {
                let (mut seen, mut motions) = (Vec::new(), Vec::new());
                for state in &own {
                    for (i, observation) in state.observations.iter().enumerate() {
                        let factor = match place {
                            0 => 1.0,
                            place => state.by_measure[place - 1].over_peak[i],
                        };
                        seen.push(scaled(*observation, factor));
                    }
                    motions.extend(&state.motions);
                }
                let fit = fit_fragility_of_motions(&seen, &motions).ok();
                fit.map(|fit| fit.curve.beta())
            };
            let places = 0..=measures.len();
            let compared = MeasureComparison {
                state,
                combinations: whole.len(),
                within: places.clone().map(mean_square).collect(),
                together: places.map(together).collect(),
            };
            let has_any = compared
                .within
                .iter()
                .chain(&compared.together)
                .any(Option::is_some);
            all.extend(has_any.then_some(compared));
        }
        all
    }
}

/// An observation in another measure of the same motion.
pub(super) fn scaled(observation: Observation, factor: f64) -> Observation {
    match observation {
        Observation::Stripe {
            intensity,
            motions,
            reached,
        } => Observation::Stripe {
            intensity: factor * intensity,
            motions,
            reached,
        },
        Observation::At(x) => Observation::At(factor * x),
        Observation::Above(x) => Observation::Above(factor * x),
        Observation::Below(x) => Observation::Below(factor * x),
        Observation::Between(low, high) => Observation::Between(factor * low, factor * high),
    }
}
