//! Sufficiency of measures of shaking: whether capacities also depend on the earthquake.

use super::answer::StudyAnswer;
use super::earthquake_of::EarthquakeOf;
use super::scans::STATES;
use dolmen::assess::{AssessError, Observation, Sufficiency, sufficiency};

/// Largest share of scans without a bracket for the state: these are the strongest and the weakest. Our choice.
const WITHOUT_BRACKET_MOST: f64 = 0.1;

/// The variable of a regression of residuals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Predictor {
    /// The magnitude.
    Magnitude,
    /// ln of the distance, km.
    Distance,
    /// ln of the duration, s.
    Duration,
}

impl Predictor {
    fn of(self, earthquake: &EarthquakeOf) -> Option<f64> {
        match self {
            Predictor::Magnitude => earthquake.magnitude,
            Predictor::Distance => earthquake.distance_km.map(f64::ln),
            Predictor::Duration => earthquake
                .duration_s
                .filter(|duration| *duration > 0.0)
                .map(f64::ln),
        }
    }

    /// Its name in JSON.
    pub fn key(self) -> &'static str {
        match self {
            Predictor::Magnitude => "magnitude",
            Predictor::Distance => "ln_distance_km",
            Predictor::Duration => "ln_duration_s",
        }
    }
}

/// Dependence of the capacities of a state on the earthquake, for each measure of shaking.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasureSufficiency {
    /// The state, 0 to 3.
    pub state: usize,
    /// The variable.
    pub predictor: Predictor,
    /// By peak acceleration first, then by each of [`StudyAnswer::measures`]; or the reason for its absence.
    pub by_measure: Result<Vec<Sufficiency>, AssessError>,
}

impl StudyAnswer {
    /// Whether capacities also depend on magnitude and distance, each if the file of some motion states it; on duration if none does. Empty for
    /// a study with varied motions.
    pub fn sufficiencies(&self) -> Vec<MeasureSufficiency> {
        let has = |predictor: Predictor| self.earthquakes.iter().any(|of| predictor.of(of).is_some());
        let mut predictors: Vec<Predictor> = [Predictor::Magnitude, Predictor::Distance]
            .into_iter()
            .filter(|predictor| has(*predictor))
            .collect();
        if predictors.is_empty() && has(Predictor::Duration) {
            predictors.push(Predictor::Duration);
        }
        let states = 0..STATES;
        let each = states.flat_map(|state| predictors.iter().map(move |predictor| (state, *predictor)));
        let is_known = |state: usize| {
            let mut all = self.fragilities().iter().flat_map(|one| &one.states);
            all.any(|own| own.state == state && own.reached() > 0)
        };
        each.filter(|(state, _)| is_known(*state))
            .map(|(state, predictor)| MeasureSufficiency {
                state,
                predictor,
                by_measure: self.sufficiency_of(state, predictor),
            })
            .collect()
    }

    fn sufficiency_of(&self, state: usize, predictor: Predictor) -> Result<Vec<Sufficiency>, AssessError> {
        let places = 0..=self.measures().len();
        places
            .map(|place| {
                let of_records = self.residuals(state, place)?;
                let known = of_records.into_iter().filter_map(|(record, residual)| {
                    Some((residual, predictor.of(self.earthquakes.get(record)?)?))
                });
                let (residuals, values): (Vec<f64>, Vec<f64>) = known.unzip();
                sufficiency(&residuals, &values)
            })
            .collect()
    }

    /// ln of the capacities by a measure, the peak acceleration first, minus their mean in their combination: the mean of each record, by its
    /// first motion.
    fn residuals(&self, state: usize, place: usize) -> Result<Vec<(usize, f64)>, AssessError> {
        let mut sums = vec![(0.0, 0_usize); self.motions.len()];
        let (mut scans, mut without) = (0, 0);
        for one in self.fragilities() {
            let Some(own) = one.states.iter().find(|own| own.state == state) else {
                continue;
            };
            let mut found: Vec<(usize, f64)> = Vec::new();
            for (i, seen) in own.observations.iter().enumerate() {
                scans += 1;
                let factor = match place {
                    0 => Some(1.0),
                    place => own
                        .by_measure
                        .get(place - 1)
                        .and_then(|by| by.over_peak.get(i).copied()),
                };
                match (middle(seen), factor) {
                    (Some(capacity), Some(factor)) => found.push((own.motions[i], (capacity * factor).ln())),
                    _ => without += 1,
                }
            }
            let mean = found.iter().map(|(_, value)| value).sum::<f64>() / found.len().max(1) as f64;
            for (record, value) in found {
                let (sum, count) = &mut sums[record];
                (*sum, *count) = (*sum + value - mean, *count + 1);
            }
        }
        if without as f64 > WITHOUT_BRACKET_MOST * scans as f64 {
            return Err(AssessError::CapacitiesOpen { without, scans });
        }
        let each = sums.into_iter().enumerate();
        Ok(each
            .filter(|(_, (_, count))| *count > 0)
            .map(|(record, (sum, count))| (record, sum / count as f64))
            .collect())
    }
}

/// The capacity at the middle of its bracket; `None` for an open bracket.
fn middle(seen: &Observation) -> Option<f64> {
    match *seen {
        Observation::At(x) => Some(x),
        Observation::Between(low, high) if low > 0.0 => Some((low * high).sqrt()),
        _ => None,
    }
}
