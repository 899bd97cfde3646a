//! The fragility of one combination of inputs: the curve of each damage state, over each measure of shaking.

use super::scans::ALLOWED_DRIFT;
use super::shaking_measure::ShakingMeasure;
use dolmen::assess::{
    AnnualRisk, AssessError, Crossing, FragilityBand, FragilityFit, Observation, ScatterSplit,
    bootstrap_fragility_of_motions, crossing, motions_needed,
};

/// Years of the probability in the answer.
pub const YEARS: f64 = 50.0;
/// Sufficient standard error of ln θ. Our choice: the median is then accurate to 10 %.
const ERROR_WANTED: f64 = 0.1;
/// Fewest motions that can be sufficient; fewer give no curve.
const ENOUGH_LEAST: usize = 3;
/// Number of motions from which β is accurate enough to estimate how many are needed: with 7 it is known to a factor of 1.8 (95 %). Our choice.
const ENOUGH_SAID_FROM: usize = 7;
/// Share of resamples without a curve above which no band is drawn, because the band would leave out the most uncertain part. Our choice.
const WITHOUT_CURVE_MOST: f64 = 0.1;
/// A crossing of two curves matters where both probabilities lie between this and 1 minus this. Our choice.
const CROSSING_LEAST: f64 = 0.01;
/// Number of resamples of a band, and their seed. Our choice.
const RESAMPLES: usize = 200;
const SEED: u64 = 1;

/// The curve of a state over another measure of shaking.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasureFit {
    /// The measure.
    pub measure: ShakingMeasure,
    /// The measure relative to the peak ground acceleration, for each observation.
    pub over_peak: Vec<f64>,
    /// The curve, or the reason for its absence.
    pub fit: Result<FragilityFit, AssessError>,
}

/// The curve of one state of one combination of inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct StateFragility {
    /// The state: 0 to 3 for DS1 to DS3 and a fall, [`ALLOWED_DRIFT`] for the allowable drift of the file.
    pub state: usize,
    /// The observations; intensities are peak accelerations of the ground, m/s².
    pub observations: Vec<Observation>,
    /// Number of further scans whose structure falls under its own weight, and reaches the state without shaking.
    pub fell_alone: usize,
    /// For the allowable drift of the file: number of further scans whose structure stands, but leans beyond it without any shaking.
    pub leans_beyond: usize,
    /// The record of each observation, from 0: other directions and samples belong to the same record.
    pub motions: Vec<usize>,
    /// The curve over peak acceleration, m/s², or the reason for its absence; for structures that are not in the state without shaking.
    pub by_acceleration: Result<FragilityFit, AssessError>,
    /// The curves over those other measures of [`StudyAnswer::measures`](super::StudyAnswer::measures) that are known for this combination.
    pub by_measure: Vec<MeasureFit>,
    /// The contributions to β, with random inputs.
    pub scatter: Option<ScatterSplit>,
    /// Annual rate of the state for structures that are not in it without shaking, if the site has a hazard.
    pub risk: Option<AnnualRisk>,
    /// The annual rate at the ends of both 95 % intervals: θ high and β low, θ low and β high.
    pub rate_interval: Option<[f64; 2]>,
}

impl StateFragility {
    /// Bands of the curve over peak acceleration by resampling of motions; `None` where more than a tenth of the resamples have no curve.
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

    /// Number of scans with information on the state.
    pub fn scans(&self) -> usize {
        self.without_shaking() + self.observations.len()
    }

    /// Number of scans whose structure is in the state without any shaking.
    pub fn without_shaking(&self) -> usize {
        self.fell_alone + self.leans_beyond
    }

    /// Number of scans that reached the state, including those that are in it without any shaking.
    pub fn reached(&self) -> usize {
        let seen = self.observations.iter();
        let reached = seen.filter(|seen| !matches!(seen, Observation::Above(_)));
        self.without_shaking() + reached.count()
    }

    /// p₀, the share of scans whose structure is in the state without any shaking.
    pub fn share_alone(&self) -> f64 {
        match self.scans() {
            0 => 0.0,
            scans => self.without_shaking() as f64 / scans as f64,
        }
    }

    /// The probability that the state is reached, from that of the structures that are not in it without shaking.
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

    /// The annual rate over all scans, 1/year; `None` without a hazard, or if some are in the state without shaking, which have no finite rate.
    pub fn annual_rate(&self) -> Option<f64> {
        self.risk
            .filter(|_| self.without_shaking() == 0)
            .map(|risk| risk.annual_rate)
    }

    /// Number of motions for a standard error of ln θ of a tenth; `None` without a curve, with so few motions that β is unknown, or with so few samples
    /// of the structure that no number of motions is enough.
    ///
    /// ```text
    /// n σ_m²/(0.1² − β_inputs²/S)        n motions, σ_m their standard error
    /// ```
    pub fn motions_enough(&self) -> Option<usize> {
        let fit = self.by_acceleration.as_ref().ok()?;
        if fit.motions < ENOUGH_SAID_FROM {
            return None;
        }
        // information of one motion, including censored ones: σ² falls as 1/n
        let of_motions = fit.ln_theta_error_of_motions();
        let of_one = of_motions * (fit.motions as f64).sqrt();
        let of_samples = fit.ln_theta_error.powi(2) - of_motions.powi(2);
        let left = ERROR_WANTED * ERROR_WANTED - of_samples;
        if left <= 0.0 {
            return None;
        }
        motions_needed(of_one, left.sqrt())
            .ok()
            .map(|count| count.max(ENOUGH_LEAST))
    }
}

/// The curves of one combination of inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct CombinationFragility {
    /// The combination, from 0.
    pub combination: usize,
    /// One of its jobs, from which its inputs are read.
    pub job: usize,
    /// Number of scans with information, including those with only a bracket, and those that fall by themselves.
    pub usable: usize,
    /// States with a name, the mildest first; the allowable drift of the file last.
    pub states: Vec<StateFragility>,
}

/// A side of a crossing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CrossingSide {
    /// At lower intensities.
    Below,
    /// At higher intensities.
    Above,
}

/// Two states whose curves cross.
#[derive(Clone, Debug, PartialEq)]
pub struct StatesCrossing {
    /// The milder state, from 0.
    pub milder: usize,
    /// The worse state, from 0.
    pub worse: usize,
    /// Their intersection.
    pub at: Crossing,
    /// The side on which the worse state is likelier.
    pub likelier_is_worse: CrossingSide,
}

impl CombinationFragility {
    /// Pairs of states whose curves cross in the relevant range: on one side the worse state is more likely than the milder one.
    pub fn crossings(&self) -> Vec<StatesCrossing> {
        let mut found = Vec::new();
        // the allowable drift of the file may lie anywhere among the states
        let states: Vec<_> = self
            .states
            .iter()
            .filter(|own| own.state != ALLOWED_DRIFT)
            .collect();
        for (i, mild) in states.iter().enumerate() {
            for severe in &states[i + 1..] {
                let (Ok(a), Ok(b)) = (&mild.by_acceleration, &severe.by_acceleration) else {
                    continue;
                };
                let at = crossing(&a.curve, &b.curve)
                    .filter(|at| (CROSSING_LEAST..=1.0 - CROSSING_LEAST).contains(&at.probability));
                let likelier_is_worse = match b.curve.beta() > a.curve.beta() {
                    true => CrossingSide::Below, // there, the flatter curve is the higher one
                    false => CrossingSide::Above,
                };
                let of_all = |at: Crossing| Crossing {
                    probability: severe.with_those_alone(at.probability),
                    ..at
                };
                found.extend(at.map(|at| StatesCrossing {
                    milder: mild.state,
                    worse: severe.state,
                    at: of_all(at),
                    likelier_is_worse,
                }));
            }
        }
        found
    }
}
