//! `dolmen score --given`: the score with a measured frequency, which gives the stiffness of the joints.

use super::answer::ScoreAnswer;
use super::designs::ScoreDesigns;
use super::softer::{DESIGNS_K_N_PA_M, softer_and_stiffer};
use super::verb::{allowed, factors_or_error, scored, unlike_but_frequency};
use crate::error::WorkError;
use crate::judgement::lowest_measured;
use crate::opened::Opened;
use crate::stack::frequency_by_height::first_frequency_hz;
use dolmen::assess::{CapacityGiven, SixFactors, StiffnessDraws};
use dolmen::blocks::ContactRule;
use dolmen::numeric::Interval;
use dolmen_project::{Quantity, StackPart, Structure, Survey};

/// Number of random stiffnesses, and their seed. Our choice.
const DRAWS: usize = 20_000;
const SEED: u64 = 1;
/// Fewest effective draws: they give an interval to a tenth of its width. Our choice.
const EFFECTIVE_LEAST: usize = 200;
/// Standard deviation of ln of the model's frequency from one measured without error. Our choice.
pub const MODEL_LN_SD: f64 = 0.05;
/// Least distance, in deviations, of a measured frequency from the ends of the range that the joints of the designs can give. Our choice.
const WITHIN: f64 = 2.0;
/// Peak accelerations of the ground for which probabilities are given, g. Our choice.
pub const GIVEN_PEAKS_G: [f64; 4] = [0.1, 0.2, 0.4, 0.8];

/// The frequency that a survey measured.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenFrequency {
    /// The survey.
    pub survey: String,
    /// Direction.
    pub direction: String,
    /// Measured frequency, Hz.
    pub measured_hz: f64,
    /// Deviation of its logarithm: that of the measurement together with [`MODEL_LN_SD`].
    pub ln_sd: f64,
    /// Frequency of the pagoda with the joints of the designs, Hz.
    pub computed_hz: f64,
}

/// Capacity in a state with the stiffness of the joints unknown, and with the frequency given.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenState {
    /// The state, 0 to 3.
    pub state: usize,
    /// Median and 90 % interval of θ, m/s², stiffness unknown.
    pub unknown_m_s2: [f64; 3],
    /// The same, frequency given.
    pub given_m_s2: [f64; 3],
    /// Probability that a motion with each of [`GIVEN_PEAKS_G`] brings the pagoda to the state, stiffness unknown.
    pub probability_unknown: [f64; 4],
    /// The same, frequency given.
    pub probability_given: [f64; 4],
}

/// The score with a measured frequency.
#[derive(Clone, Debug)]
pub struct GivenAnswer {
    /// The score on the designs' joints.
    pub score: ScoreAnswer,
    /// The frequency.
    pub frequency: GivenFrequency,
    /// Number of random stiffnesses.
    pub draws: usize,
    /// Their effective number, given the frequency.
    pub effective_draws: f64,
    /// Stiffness of the joints over that of the designs: median and 90 % interval, from 5 to 95 %.
    pub stiffness_ratio: [f64; 3],
    /// Range of that ratio before the frequency is used.
    pub prior_ratio: Interval,
    /// DS2, DS3 and falls.
    pub states: Vec<GivenState>,
}

/// The score of a pagoda, given the lowest frequency that a survey measured along x or y.
///
/// # Errors
/// Those of [`super::score`]; no such survey, one without a frequency, a frequency beyond the joints of the designs, too few draws near it.
pub fn score_given(opened: &Opened, survey: &str, extrapolate: bool) -> Result<GivenAnswer, WorkError> {
    let project = &opened.project;
    let own = factors_or_error(opened)?;
    let unlike = allowed(unlike_but_frequency(project)?, extrapolate)?;
    let Some(found) = project.surveys.iter().find(|one| one.name == survey) else {
        let known: Vec<&str> = project.surveys.iter().map(|one| one.name.as_str()).collect();
        return Err(WorkError::NoSuchSurvey {
            name: survey.to_owned(),
            known: known.join(", "),
        });
    };
    let frequency = frequency(opened, found)?;
    let score = scored(opened, &ScoreDesigns::shipped()?, unlike, extrapolate)?;
    given(score, frequency, &own)
}

/// The lowest frequency along x or y, and that of the pagoda on the designs' joints.
fn frequency(opened: &Opened, survey: &Survey) -> Result<GivenFrequency, WorkError> {
    let none = || WorkError::SurveyTellsNoFrequency {
        survey: survey.name.clone(),
    };
    let Structure::Stack(part) = &opened.project.structure else {
        return Err(none());
    };
    let lowest = ["x", "y"].into_iter().filter_map(|direction| {
        let mode = lowest_measured(survey.modes.get(direction)?)?;
        Some((direction, &mode.frequency))
    });
    let (direction, measured) = lowest
        .min_by(|a, b| a.1.value.total_cmp(&b.1.value))
        .ok_or_else(none)?;
    // undamaged: a damage that explains a low frequency would otherwise make the joints stiffer, and the pagoda safer
    let undamaged = StackPart {
        lost_beds: Vec::new(),
        loosened_beds: Vec::new(),
        ..*part.clone()
    };
    let stack = undamaged.build(&mut Quantity::nominal)?;
    let computed_hz = first_frequency_hz(&stack, ContactRule::Four).ok_or_else(none)?;
    let own_ratio = stack.joints().first().map_or(1.0, |joint| {
        joint.material.normal_stiffness_pa_m / DESIGNS_K_N_PA_M
    });
    Ok(GivenFrequency {
        survey: survey.name.clone(),
        direction: direction.to_owned(),
        measured_hz: measured.value,
        ln_sd: MODEL_LN_SD.hypot(measured.standard_deviation() / measured.value),
        computed_hz: computed_hz / own_ratio.sqrt(),
    })
}

fn given(score: ScoreAnswer, frequency: GivenFrequency, own: &SixFactors) -> Result<GivenAnswer, WorkError> {
    let effects = softer_and_stiffer()?;
    let prior_ratio = effects[0].trained;
    let edge = WITHIN * frequency.ln_sd;
    let [least_hz, most_hz] = [(prior_ratio.lower, edge), (prior_ratio.upper, -edge)]
        .map(|(ratio, edge)| frequency.computed_hz * (0.5 * ratio.ln() + edge).exp());
    if !(least_hz..=most_hz).contains(&frequency.measured_hz) {
        return Err(WorkError::FrequencyBeyondDesigns {
            measured_hz: frequency.measured_hz,
            least_hz,
            most_hz,
        });
    }
    let prior = StiffnessDraws::prior(&prior_ratio, DRAWS, SEED);
    let after = prior.given(frequency.measured_hz / frequency.computed_hz, frequency.ln_sd)?;
    let effective_draws = after.effective();
    if effective_draws < EFFECTIVE_LEAST as f64 {
        return Err(WorkError::TooFewDrawsNear {
            effective: effective_draws,
            least: EFFECTIVE_LEAST,
        });
    }
    let mut states = Vec::new();
    for (one, effect) in score.states.iter().filter(|one| one.state > 0).zip(&effects) {
        let of = |draws: &StiffnessDraws| CapacityGiven::of(own, &one.score, effect, draws);
        let [unknown, known] = [of(&prior)?, of(&after)?];
        let theta = |of: &CapacityGiven| [0.5, 0.05, 0.95].map(|p| of.quantile_m_s2(p));
        let reached =
            |of: &CapacityGiven| GIVEN_PEAKS_G.map(|peak| of.probability(peak * score.gravity_m_s2));
        states.push(GivenState {
            state: one.state,
            unknown_m_s2: theta(&unknown),
            given_m_s2: theta(&known),
            probability_unknown: reached(&unknown),
            probability_given: reached(&known),
        });
    }
    Ok(GivenAnswer {
        score,
        frequency,
        draws: DRAWS,
        effective_draws,
        stiffness_ratio: [0.5, 0.05, 0.95].map(|p| after.quantile(p)),
        prior_ratio,
        states,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen::numeric::clopper_pearson;
    use dolmen::structure::stack::{PagodaFactors, PagodaSlenderness};

    /// Simulated pagodas other than the designs; data/pagoda_score/README.md describes them.
    const MADE: &str = include_str!("../../../../data/pagoda_score/made.csv");

    struct Made {
        state: usize,
        unknown: f64,
        given: f64,
        reached: bool,
    }

    fn made() -> Vec<Made> {
        let designs = ScoreDesigns::shipped().unwrap();
        let models: Vec<_> = (1..4).map(|state| designs.model(state).unwrap()).collect();
        let effects = softer_and_stiffer().unwrap();
        let prior = StiffnessDraws::prior(&effects[0].trained, 600, SEED);
        let mut all = Vec::new();
        for row in MADE.lines().skip(1) {
            let cells: Vec<&str> = row.split(',').collect();
            let number = |column: usize| cells[column].parse::<f64>().unwrap();
            let factors = SixFactors::of_pagoda(&PagodaFactors {
                storeys: number(0) as u32,
                body_height_m: number(1),
                slenderness: PagodaSlenderness::Body(number(2)),
                taper_rad: number(3).to_radians(),
                body_base_height_ratio: number(4),
                ..PagodaFactors::default()
            })
            .unwrap();
            let measured = number(5).sqrt() * (MODEL_LN_SD * number(8)).exp();
            let after = prior.given(measured, MODEL_LN_SD).unwrap();
            let peak_m_s2 = number(7) * 9.80665;
            for (at, (model, effect)) in models.iter().zip(&effects).enumerate() {
                let score = model.score(&factors, true).unwrap();
                let p = |draws: &StiffnessDraws| {
                    CapacityGiven::of(&factors, &score, effect, draws)
                        .unwrap()
                        .probability(peak_m_s2)
                };
                all.push(Made {
                    state: at + 1,
                    unknown: p(&prior),
                    given: p(&after),
                    reached: number(9) as usize > at + 1,
                });
            }
        }
        all
    }

    /// Among simulated pagodas with a computed probability, that share reaches the state, by exact 99 % binomial bounds in five bins for each
    /// state. Brier score and log loss are better than without the frequency.
    #[test]
    fn holds_probabilities_of_made_pagodas_are_their_shares() {
        let all = made();
        for state in 1..4 {
            let own: Vec<&Made> = all.iter().filter(|one| one.state == state).collect();
            assert_eq!(own.len(), 600);
            for bin in 0..5 {
                let in_bin: Vec<&&Made> = own
                    .iter()
                    .filter(|one| (5.0 * one.given).min(4.999) as usize == bin)
                    .collect();
                let mean = in_bin.iter().map(|one| one.given).sum::<f64>() / in_bin.len() as f64;
                let reached = in_bin.iter().filter(|one| one.reached).count();
                let bounds = clopper_pearson(reached, in_bin.len(), 0.99).unwrap();
                assert!(
                    bounds.lower <= mean && mean <= bounds.upper,
                    "{state} {bin} {mean} {bounds:?}"
                );
            }
            let count = own.len() as f64;
            let y = |one: &Made| f64::from(u8::from(one.reached));
            let brier =
                |p: fn(&Made) -> f64| own.iter().map(|one| (p(one) - y(one)).powi(2)).sum::<f64>() / count;
            let loss = |p: fn(&Made) -> f64| {
                let each = own
                    .iter()
                    .map(|one| if one.reached { p(one) } else { 1.0 - p(one) });
                -each.map(f64::ln).sum::<f64>() / count
            };
            let found = [
                brier(|m| m.unknown),
                brier(|m| m.given),
                loss(|m| m.unknown),
                loss(|m| m.given),
            ];
            assert!(
                found[1] < 0.92 * found[0] && found[3] < 0.92 * found[2],
                "{state} {found:?}"
            );
        }
    }
}
