//! Fragility from a study: one curve for each combination of inputs and state, over motions, directions and samples.

use super::answer::StudyAnswer;
use super::column::{Column, ColumnValues};
use super::combination_fragility::{CombinationFragility, MeasureFit, StateFragility};
use super::crushed_tenons::crushes;
use super::input_columns::CaseInputs;
use super::kind::StudyKind;
use super::measures::RunMeasures;
use super::run::{Run, RunOutcome};
use super::scans::{ALLOWED_DRIFT, CapacityOf, STATES, ScanVerdict};
use super::shaking::scaled;
use dolmen::assess::{
    AnnualRisk, AssessError, Fragility, FragilityBound, FragilityFit, Observation, annual_risk,
    fit_fragility_of_motions, scatter_split,
};
use dolmen_words::Language;
use dolmen_words::number::trimmed;
use std::collections::BTreeSet;

impl StudyAnswer {
    /// Whether a state applies: slipping does not for a frame in which nothing ever slipped, the allowable drift only if the file sets one.
    pub fn has_state(&self, state: usize) -> bool {
        if state == ALLOWED_DRIFT {
            return self.drift_limit.is_some() && matches!(self.kind, StudyKind::Frame | StudyKind::Building);
        }
        let is_named = self.kind.states().get(state).is_some_and(|name| *name != "–");
        if self.kind != StudyKind::Frame || state != 0 || !is_named {
            return is_named;
        }
        let slipped = |run: &Run| matches!(run.measures, RunMeasures::Frame(of) if of.slipped_way_m > 0.0);
        let is_damaged = |run: &Run| slipped(run) || crushes(run);
        self.runs.iter().any(is_damaged) || !self.runs.iter().any(|run| run.outcome == RunOutcome::Fell)
    }

    pub(super) fn fit_combinations(&self) -> Vec<CombinationFragility> {
        if self.study.scan.is_none() {
            return Vec::new();
        }
        let scans = self.capacities();
        let mut found: Vec<CombinationFragility> = Vec::new();
        for combination in 0..self.study.combinations() {
            let is_known = |scan: &&CapacityOf| {
                scan.verdict == ScanVerdict::FellAlone
                    || scan.is_beyond_at_rest
                    || scan.seen_m_s2.iter().any(Option::is_some)
            };
            let own = scans
                .iter()
                .filter(|scan| is_known(scan) && self.combination_of(scan.job) == combination);
            let own: Vec<&CapacityOf> = own.collect();
            let Some(first) = own.first() else { continue };
            let states = (0..STATES)
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

    /// Bounds of θ in g if there is no curve.
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

    /// Name of a state.
    pub fn state_words(&self, state: usize, language: Language) -> String {
        let percent = |ratio: f64| trimmed(100.0 * ratio, 4);
        if state == ALLOWED_DRIFT {
            let limit = percent(self.drift_limit.unwrap_or(f64::NAN));
            return language.pick(
                format!("allowed drift {limit} %"),
                format!("허용 층간변위 {limit} %"),
            );
        }
        if let (StudyKind::Building, Some(limit)) = (self.kind, self.study.drift_limits.get(state)) {
            let limit = percent(*limit);
            return language.pick(format!("drift {limit} %"), format!("층간변위 {limit} %"));
        }
        let word = match (self.kind.state(state), language) {
            ("slips", _) if self.crushed_tenons().is_some() => {
                language.pick("slips or crushes", "미끄러짐·압괴")
            }
            ("drift limit", _) if self.on_columns => language.pick("falls", "전도"),
            // differs from the allowable drift of the file
            ("drift limit", Language::English) => "leans by 10 %",
            (word, Language::English) => word,
            ("falls", _) => "낙하·전도",
            ("slips", _) => "미끄러짐",
            ("opens", _) => "벌어짐",
            ("drift limit", _) => "10 % 기울어짐",
            (word, _) => word,
        };
        word.to_owned()
    }

    fn state_fragility(&self, state: usize, scans: &[&CapacityOf]) -> StateFragility {
        let seen = scans
            .iter()
            .filter_map(|scan| Some((*scan, scan.seen_m_s2[state]?)))
            .collect::<Vec<(&CapacityOf, Observation)>>();
        let observations: Vec<Observation> = seen.iter().map(|(_, seen)| *seen).collect();
        let motions: Vec<usize> = seen.iter().map(|(scan, _)| self.record_index(scan.job)).collect();
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
        let of_motions = fit_fragility_of_motions(&observations, &motions);
        let scatter = scatter.and_then(|_| scatter_split(&observations, &motions, &samples).ok().flatten());
        // both parts together must give the scatter of the curve, whose most likely square holds (S − 1)/S of that between S samples
        let scatter = scatter.filter(|split| {
            let share = (split.samples as f64 - 1.0) / split.samples as f64;
            let both = split.of_motions.hypot(share.sqrt() * split.of_inputs);
            let interval = of_motions
                .as_ref()
                .ok()
                .and_then(|fit| fit.beta_interval(0.95).ok());
            interval.is_none_or(|of| (of.lower..=of.upper).contains(&both))
        });
        let by_acceleration = of_motions.map(|fit| match &scatter {
            Some(split) => fit.with_samples(split),
            None => fit,
        });
        let risk = self.hazard.as_ref().zip(by_acceleration.as_ref().ok());
        let rate_interval = risk.and_then(|(hazard, fit)| {
            let (theta, beta) = (fit.theta_interval(0.95).ok()?, fit.beta_interval(0.95).ok()?);
            let rate = |theta, beta| {
                let curve = Fragility::new(theta, beta).ok()?;
                Some(annual_risk(&hazard.curve, &curve))
            };
            let (least, most) = (rate(theta.upper, beta.lower)?, rate(theta.lower, beta.upper)?);
            Some([least.annual_rate, known_most(&most)])
        });
        let alone = scans.iter().filter(|scan| scan.verdict == ScanVerdict::FellAlone);
        let leaning = scans
            .iter()
            .filter(|scan| state == ALLOWED_DRIFT && scan.is_beyond_at_rest);
        StateFragility {
            state,
            fell_alone: alone.count(),
            leans_beyond: leaning.count(),
            rate_interval,
            risk: risk.map(|(hazard, fit)| annual_risk(&hazard.curve, &fit.curve)),
            scatter,
            by_measure,
            by_acceleration,
            observations,
            motions,
        }
    }
}

/// Share of a rate that may come from shaking weaker than the hazard table. Our choice: beyond it more than half of the number comes from
/// an extrapolated slope.
const BELOW_HAZARD_MOST: f64 = 0.5;
/// Largest annual rate at which a standing structure reaches a state. Our choice: it has stood longer than a year.
const RATE_MOST: f64 = 1.0;

/// The upper end of a rate; infinite if the hazard does not determine it.
fn known_most(risk: &AnnualRisk) -> f64 {
    match risk.share_below_points > BELOW_HAZARD_MOST || risk.annual_rate > RATE_MOST {
        true => f64::INFINITY,
        false => risk.annual_rate,
    }
}

/// Key of each row: combination, variant, varied inputs. `rows` are combinations with one of their jobs.
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
    if let Some(after) = &answer.study.after {
        columns.push(words("after", &|_| after.motion.clone()));
    }
    columns
}

/// Every curve, one row for each combination and state: inputs, data, median, dispersion, errors, risk; or the reason for its absence.
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
    let of_rows: Vec<(usize, usize)> = rows.iter().map(|(one, _)| (one.combination, one.job)).collect();
    let mut columns = combination_columns(answer, &of_rows);
    columns.extend([
        words("state", &|(_, state)| answer.kind.state(state.state).to_owned()),
        counts("scans", &|(_, state)| state.scans()),
        counts("fell_by_itself", &|(_, state)| state.fell_alone),
    ]);
    if rows.iter().any(|(_, state)| state.leans_beyond > 0) {
        columns.push(counts("leans_beyond_at_rest", &|(_, state)| state.leans_beyond));
    }
    columns.extend([
        counts("motions", &|(_, state)| {
            let different: BTreeSet<&usize> = state.motions.iter().collect();
            different.len()
        }),
        counts("reached", &|(_, state)| state.reached()),
        numbers("probability_without_shaking", &|state| Some(state.share_alone())),
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
        numbers("annual_rate", &StateFragility::annual_rate),
        numbers("annual_rate_of_standing", &|state| {
            state.risk.map(|risk| risk.annual_rate)
        }),
        numbers("annual_rate_least", &|state| {
            state.rate_interval.map(|ends| ends[0])
        }),
        numbers("annual_rate_most", &|state| {
            state
                .rate_interval
                .map(|ends| ends[1])
                .filter(|most| most.is_finite())
        }),
        numbers("probability_in_50_years", &StateFragility::probability_in_years),
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
