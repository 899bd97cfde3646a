//! Fragility of what was studied: one curve a combination of inputs and state, over motions, directions and samples.

use super::answer::{CaseInputs, StudyAnswer};
use super::run::{Run, RunOutcome, StudyKind};
use super::scans::CapacityOf;
use super::shaking::{ShakingMeasure, scaled};
use super::table::{Column, ColumnValues};
use dolmen::assess::{
    AnnualRisk, AssessError, Crossing, Fragility, FragilityBand, FragilityBound, FragilityFit, Observation,
    ScatterSplit, annual_risk, bootstrap_fragility_of_motions, crossing, fit_fragility_of_motions,
    motions_needed, scatter_split,
};
use dolmen_words::Language;
use std::collections::BTreeSet;

/// Resamples of a band, and their seed. Chosen here.
const RESAMPLES: usize = 200;
const SEED: u64 = 1;
/// Standard error of ln θ that counts as enough. Chosen here: a median that is known to a tenth.
const ERROR_WANTED: f64 = 0.1;
/// Fewest motions that can be enough: of fewer there is no curve.
const ENOUGH_LEAST: usize = 3;
/// Motions from which β is known well enough to say how many are needed: to a factor of 1.8 (95 %) from 7. Chosen here.
const ENOUGH_SAID_FROM: usize = 7;
/// Share of resamples without a curve from which a band is not drawn: it would leave out what is least sure. Chosen here.
const WITHOUT_CURVE_MOST: f64 = 0.1;
/// A crossing of two curves matters where both probabilities lie between this and what is left of 1. Chosen here.
const CROSSING_LEAST: f64 = 0.01;
/// Years of the probability that is said.
pub const YEARS: f64 = 50.0;

/// The curve of a state over another measure of the shaking.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasureFit {
    /// The measure.
    pub measure: ShakingMeasure,
    /// It over the peak acceleration of the ground, of each observation.
    pub over_peak: Vec<f64>,
    /// The curve, or why there is none.
    pub fit: Result<FragilityFit, AssessError>,
}

/// The curve of one state of one combination of inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct StateFragility {
    /// The state, 0 to 3: DS1 to DS3, fall.
    pub state: usize,
    /// What was seen, intensities as peak accelerations of the ground, m/s².
    pub observations: Vec<Observation>,
    /// The motion of each, from 0: turned, or with other samples, it is the same one.
    pub motions: Vec<usize>,
    /// The curve over peak acceleration, m/s², or why there is none.
    pub by_acceleration: Result<FragilityFit, AssessError>,
    /// The curves over other measures of the shaking, those of [`StudyAnswer::measures`] that are known of this combination.
    pub by_measure: Vec<MeasureFit>,
    /// What β is made of, where inputs are drawn.
    pub scatter: Option<ScatterSplit>,
    /// How often it is reached, if the site has a hazard.
    pub risk: Option<AnnualRisk>,
    /// The annual rate at the ends of both 95 % intervals: θ high and β low, θ low and β high.
    pub rate_interval: Option<[f64; 2]>,
}

impl StateFragility {
    /// Bands of the curve over peak acceleration, motions drawn anew; `None` where more than a tenth of the draws have no curve.
    ///
    /// # Errors
    /// Those of the curve.
    pub fn band(&self) -> Result<Option<FragilityBand>, AssessError> {
        let band = bootstrap_fragility_of_motions(&self.observations, &self.motions, RESAMPLES, SEED)?;
        let without = band.without_curve as f64;
        Ok((without <= WITHOUT_CURVE_MOST * RESAMPLES as f64).then_some(band))
    }

    /// The curve over peak velocity, m/s, if there is one.
    pub fn by_velocity(&self) -> Option<&FragilityFit> {
        let by = self.by_measure.iter();
        let mut by = by.filter(|by| by.measure == ShakingMeasure::PeakVelocity);
        by.next()?.fit.as_ref().ok()
    }

    /// How many scans reached the state.
    pub fn reached(&self) -> usize {
        let seen = self.observations.iter();
        seen.filter(|seen| !matches!(seen, Observation::Above(_))).count()
    }

    /// Motions that make the standard error of ln θ a tenth; `None` without a curve, or of so few motions that β is not known.
    pub fn motions_enough(&self) -> Option<usize> {
        let fit = self.by_acceleration.as_ref().ok()?;
        if fit.motions < ENOUGH_SAID_FROM {
            return None;
        }
        // what one motion tells, with those that are censored: σ² falls as 1/n
        let of_one = fit.ln_theta_error * (fit.motions as f64).sqrt();
        motions_needed(of_one, ERROR_WANTED)
            .ok()
            .map(|count| count.max(ENOUGH_LEAST))
    }
}

/// The curves of one combination of inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct CombinationFragility {
    /// The combination, from 0.
    pub combination: usize,
    /// One of its jobs, to read its inputs from.
    pub job: usize,
    /// Scans that say something: those of which only a bracket is known among them.
    pub usable: usize,
    /// States that have a name, the mildest first.
    pub states: Vec<StateFragility>,
}

impl CombinationFragility {
    /// Pairs of states whose curves cross where it matters: on one side the worse state is called likelier than the milder one; whether that is
    /// below the crossing comes last.
    pub fn crossings(&self) -> Vec<(usize, usize, Crossing, bool)> {
        let mut found = Vec::new();
        for (i, mild) in self.states.iter().enumerate() {
            for severe in &self.states[i + 1..] {
                let (Ok(a), Ok(b)) = (&mild.by_acceleration, &severe.by_acceleration) else {
                    continue;
                };
                let at = crossing(&a.curve, &b.curve)
                    .filter(|at| (CROSSING_LEAST..=1.0 - CROSSING_LEAST).contains(&at.probability));
                let is_below = b.curve.beta() > a.curve.beta(); // the flatter curve is the higher one there
                found.extend(at.map(|at| (mild.state, severe.state, at, is_below)));
            }
        }
        found
    }
}

impl StudyAnswer {
    /// Whether a state means anything here: of a frame in which nothing ever slipped, slipping does not.
    pub fn has_state(&self, state: usize) -> bool {
        const SLIPPED: &str = "slipped_way_m";
        let is_named = self.kind.states().get(state).is_some_and(|name| *name != "–");
        if self.kind != StudyKind::Frame || state != 0 || !is_named {
            return is_named;
        }
        let place = self.kind.measures().iter().position(|name| *name == SLIPPED);
        let slipped = |run: &Run| {
            let way_m = place.and_then(|place| run.measures.get(place));
            way_m.is_some_and(|way_m| *way_m > 0.0)
        };
        self.runs.iter().any(slipped) || !self.runs.iter().any(|run| run.outcome == RunOutcome::Fell)
    }

    pub(super) fn fit_combinations(&self) -> Vec<CombinationFragility> {
        if self.study.scan.is_none() {
            return Vec::new();
        }
        let scans = self.capacities();
        let mut found: Vec<CombinationFragility> = Vec::new();
        for combination in 0..self.study.combinations() {
            let is_known = |scan: &&CapacityOf| scan.seen_m_s2.iter().any(Option::is_some);
            let own = scans
                .iter()
                .filter(|scan| is_known(scan) && self.combination_of(scan.job) == combination);
            let own: Vec<&CapacityOf> = own.collect();
            let Some(first) = own.first() else { continue };
            let states = (0..4)
                .filter(|state| self.has_state(*state))
                .map(|state| self.state_fragility(state, &own));
            found.push(CombinationFragility {
                combination,
                job: first.job,
                usable: own.len(),
                states: states.collect(),
            });
        }
        found
    }

    /// What is known of θ where there is no curve, in g.
    pub fn bound_words(&self, why: &AssessError, language: Language) -> String {
        let g = |value: f64| format!("{:.3}", value / self.gravity_m_s2);
        match why {
            AssessError::NoFragility(FragilityBound::NoneReached {
                intensity,
                probability_most: p,
                ..
            }) => {
                let x = g(*intensity);
                language.pick(format!("at {x}: P < {p:.2}"), format!("{x}에서 P < {p:.2}"))
            }
            AssessError::NoFragility(FragilityBound::AllReached {
                intensity,
                probability_least: p,
                ..
            }) => {
                let x = g(*intensity);
                language.pick(format!("at {x}: P > {p:.2}"), format!("{x}에서 P > {p:.2}"))
            }
            AssessError::NoFragility(FragilityBound::Separated { survived, reached }) => {
                let (from, to) = (g(*survived), g(*reached));
                if from == to {
                    language.pick(format!("about {to}"), format!("약 {to}"))
                } else {
                    language.pick(format!("{from} to {to}"), format!("{from} – {to}"))
                }
            }
            AssessError::NoFragility(FragilityBound::Middle { above, at_most }) => {
                let (from, to) = (g(*above), g(*at_most));
                match (*above > 0.0, at_most.is_finite()) {
                    (true, true) => language.pick(format!("{from} to {to}"), format!("{from} – {to}")),
                    (true, false) => format!("> {from}"),
                    (false, true) => format!("< {to}"),
                    (false, false) => language.pick("no curve", "곡선 없음").to_owned(),
                }
            }
            AssessError::TooFewMotions { .. } => language.pick("too few", "자료 부족").to_owned(),
            _ => language.pick("no curve", "곡선 없음").to_owned(),
        }
    }

    /// What the damage states are called, the first state first.
    pub fn state_words(&self, language: Language) -> [&'static str; 4] {
        let words = self.kind.states();
        words.map(|word| match (word, language) {
            (_, Language::English) => word,
            ("falls", _) => "낙하·전도",
            ("slips", _) => "미끄러짐",
            ("opens", _) => "벌어짐",
            ("drift limit", _) => "층간변위 한계",
            (word, _) => word,
        })
    }

    fn state_fragility(&self, state: usize, scans: &[&CapacityOf]) -> StateFragility {
        let seen = scans
            .iter()
            .filter_map(|scan| Some((*scan, scan.seen_m_s2[state]?)))
            .collect::<Vec<(&CapacityOf, Observation)>>();
        let observations: Vec<Observation> = seen.iter().map(|(_, seen)| *seen).collect();
        let motions: Vec<usize> = seen.iter().map(|(scan, _)| self.motion_index(scan.job)).collect();
        let by_measure = self.measures().into_iter().filter_map(|measure| {
            let over_peak = seen.iter().map(|(scan, _)| {
                let size = [scan.peak_of_scale_1_m_s2, scan.velocity_of_scale_1_m_s];
                Some(self.intensity(scan.job, measure, size)? / scan.peak_of_scale_1_m_s2)
            });
            let over_peak: Vec<f64> = over_peak.collect::<Option<_>>()?;
            let each = observations.iter().zip(&over_peak);
            let in_measure: Vec<Observation> = each.map(|(seen, factor)| scaled(*seen, *factor)).collect();
            Some(MeasureFit {
                measure,
                fit: fit_fragility_of_motions(&in_measure, &motions),
                over_peak,
            })
        });
        let by_measure = by_measure.collect();
        let samples: Vec<usize> = seen.iter().map(|(scan, _)| self.sample_of(scan.job)).collect();
        let scatter = self.study.samples.filter(|samples| *samples > 1);
        let by_acceleration = fit_fragility_of_motions(&observations, &motions);
        let risk = self.hazard.as_ref().zip(by_acceleration.as_ref().ok());
        let rate_interval = risk.and_then(|(hazard, fit)| {
            let (theta, beta) = (fit.theta_interval(0.95).ok()?, fit.beta_interval(0.95).ok()?);
            let rate = |theta, beta| {
                let curve = Fragility::new(theta, beta).ok()?;
                Some(annual_risk(&hazard.curve, &curve).annual_rate)
            };
            Some([rate(theta.upper, beta.lower)?, rate(theta.lower, beta.upper)?])
        });
        StateFragility {
            state,
            rate_interval,
            risk: risk.map(|(hazard, fit)| annual_risk(&hazard.curve, &fit.curve)),
            scatter: scatter.and_then(|_| scatter_split(&observations, &motions, &samples).ok().flatten()),
            by_measure,
            by_acceleration,
            observations,
            motions,
        }
    }
}

/// What each row is of: combination, variant, varied inputs. `rows` are combinations with one of their jobs.
pub(super) fn combination_columns(answer: &StudyAnswer, rows: &[(usize, usize)]) -> Vec<Column> {
    let column = |name: &str, values| Column {
        name: name.to_owned(),
        values,
    };
    let combinations = rows.iter().map(|(combination, _)| *combination as i64 + 1);
    let mut columns = vec![column(
        "combination",
        ColumnValues::Counts(combinations.collect()),
    )];
    let words = |name: &str, of: &dyn Fn(&CaseInputs) -> String| {
        let values = rows.iter().map(|(_, job)| of(answer.case(*job)));
        column(name, ColumnValues::Words(values.collect()))
    };
    if !answer.study.variants.is_empty() {
        columns.push(words("variant", &|case| case.variant.clone().unwrap_or_default()));
    }
    let varied = answer.inputs.iter().enumerate();
    for (index, input) in varied.filter(|(_, input)| !input.is_drawn) {
        columns.push(words(&input.column, &|case| {
            case.texts.get(index).cloned().unwrap_or_default()
        }));
    }
    columns
}

/// Every curve, a row a combination and state: inputs, what it rests on, median, dispersion, errors, risk; why where there is none.
pub fn fragility_columns(answer: &StudyAnswer) -> Vec<Column> {
    let rows: Vec<(&CombinationFragility, &StateFragility)> = answer
        .fragilities()
        .iter()
        .flat_map(|one| one.states.iter().map(move |state| (one, state)))
        .collect();
    let words = |name: &str, of: &dyn Fn(&(&CombinationFragility, &StateFragility)) -> String| Column {
        name: name.to_owned(),
        values: ColumnValues::Words(rows.iter().map(of).collect()),
    };
    let counts = |name: &str, of: &dyn Fn(&(&CombinationFragility, &StateFragility)) -> usize| Column {
        name: name.to_owned(),
        values: ColumnValues::Counts(rows.iter().map(|row| of(row) as i64).collect()),
    };
    let numbers = |name: &str, of: &dyn Fn(&StateFragility) -> Option<f64>| Column {
        name: name.to_owned(),
        values: ColumnValues::Numbers(rows.iter().map(|(_, state)| of(state)).collect()),
    };
    let fit = |of: fn(&FragilityFit) -> f64| {
        move |state: &StateFragility| state.by_acceleration.as_ref().ok().map(of)
    };
    let states = answer.kind.states();
    let of_rows: Vec<(usize, usize)> = rows.iter().map(|(one, _)| (one.combination, one.job)).collect();
    let mut columns = combination_columns(answer, &of_rows);
    columns.extend([
        words("state", &|(_, state)| states[state.state].to_owned()),
        counts("scans", &|(_, state)| state.observations.len()),
        counts("motions", &|(_, state)| {
            let different: BTreeSet<&usize> = state.motions.iter().collect();
            different.len()
        }),
        counts("reached", &|(_, state)| state.reached()),
        numbers("theta_pga_m_s2", &fit(|fit| fit.curve.theta())),
        numbers("beta_pga", &fit(|fit| fit.curve.beta())),
        numbers("ln_theta_error", &fit(|fit| fit.ln_theta_error)),
        numbers("beta_error", &fit(|fit| fit.beta_error)),
    ]);
    for measure in answer.measures() {
        let fit = |state: &StateFragility, of: fn(&FragilityFit) -> f64| {
            let own = state.by_measure.iter().find(|by| by.measure == measure)?;
            own.fit.as_ref().ok().map(of)
        };
        columns.extend([
            numbers(&format!("theta_{}", measure.column()), &|state| {
                fit(state, |fit| fit.curve.theta())
            }),
            numbers(&format!("beta_{}", measure.key()), &|state| {
                fit(state, |fit| fit.curve.beta())
            }),
        ]);
    }
    if answer.study.samples.is_some() {
        columns.extend([
            numbers("beta_of_motions", &|state| Some(state.scatter?.of_motions)),
            numbers("beta_of_inputs", &|state| Some(state.scatter?.of_inputs)),
            numbers("samples_without_curve", &|state| {
                Some(state.scatter?.without_curve as f64)
            }),
        ]);
    }
    columns.extend([
        numbers("annual_rate", &|state| state.risk.map(|risk| risk.annual_rate)),
        numbers("annual_rate_least", &|state| {
            state.rate_interval.map(|ends| ends[0])
        }),
        numbers("annual_rate_most", &|state| {
            state.rate_interval.map(|ends| ends[1])
        }),
        numbers("probability_in_50_years", &|state| {
            state.risk.map(|risk| risk.probability_in(YEARS))
        }),
        numbers("rate_share_beyond_hazard", &|state| {
            state
                .risk
                .map(|risk| risk.share_below_points + risk.share_above_points)
        }),
        words("why_not", &|(_, state)| match &state.by_acceleration {
            Ok(_) => String::new(),
            Err(why) => why.to_string(),
        }),
    ]);
    columns
}
