//! The fragility of one combination of inputs: the curve of each damage state, by each measure of the shaking.

use super::shaking_measure::ShakingMeasure;
use dolmen::assess::{
    AnnualRisk, AssessError, Crossing, FragilityBand, FragilityFit, Observation, ScatterSplit,
    bootstrap_fragility_of_motions, crossing, motions_needed,
};

/// Years of the probability that the answer gives.
pub const YEARS: f64 = 50.0;
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
/// Resamples of a band, and their seed. Chosen here.
const RESAMPLES: usize = 200;
const SEED: u64 = 1;

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
    /// Scans beside them whose structure falls under its own weight: the state is reached without shaking.
    pub fell_alone: usize,
    /// The record of each, from 0: turned, in its other directions, or with other samples, it is the same one.
    pub motions: Vec<usize>,
    /// The curve over peak acceleration, m/s², or why there is none; of structures that stand by themselves.
    pub by_acceleration: Result<FragilityFit, AssessError>,
    /// The curves over other measures of the shaking, those of [`StudyAnswer::measures`](super::StudyAnswer::measures) that are known of this combination.
    pub by_measure: Vec<MeasureFit>,
    /// What β is made of, where inputs are drawn.
    pub scatter: Option<ScatterSplit>,
    /// How often structures that stand by themselves reach it, if the site has a hazard.
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

    /// How many scans say something of the state.
    pub fn scans(&self) -> usize {
        self.fell_alone + self.observations.len()
    }

    /// How many scans reached the state, those that fall by themselves among them.
    pub fn reached(&self) -> usize {
        let seen = self.observations.iter();
        let reached = seen.filter(|seen| !matches!(seen, Observation::Above(_)));
        self.fell_alone + reached.count()
    }

    /// p₀, the share of scans whose structure falls under its own weight.
    pub fn share_alone(&self) -> f64 {
        match self.scans() {
            0 => 0.0,
            scans => self.fell_alone as f64 / scans as f64,
        }
    }

    /// The probability that the state is reached, of that of the structures that stand by themselves.
    ///
    /// ```text
    /// P = p₀ + (1 − p₀) Φ(ln(x/θ)/β)
    /// ```
    pub fn with_those_alone(&self, of_standing: f64) -> f64 {
        let share = self.share_alone();
        share + (1.0 - share) * of_standing
    }

    /// The probability that the state is reached within [`YEARS`], if the site has a hazard.
    pub fn probability_in_years(&self) -> Option<f64> {
        self.risk
            .map(|risk| self.with_those_alone(risk.probability_in(YEARS)))
    }

    /// The rate of all scans, 1/year; `None` without a hazard, and where some fall by themselves: these have no finite rate.
    pub fn annual_rate(&self) -> Option<f64> {
        self.risk
            .filter(|_| self.fell_alone == 0)
            .map(|risk| risk.annual_rate)
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
    /// Scans that say something: those of which only a bracket is known, and those that fall by themselves, among them.
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
                let of_all = |at: Crossing| Crossing {
                    probability: severe.with_those_alone(at.probability),
                    ..at
                };
                found.extend(at.map(|at| (mild.state, severe.state, of_all(at), is_below)));
            }
        }
        found
    }
}
