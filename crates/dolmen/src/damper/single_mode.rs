//! Optimal tuning of a mass damper to one mode with damping, by numerical search.
//!
//! The unknowns are ln f and ln ζ. The cost is ln σ², or ln |H|² at its two peaks.

use super::tuning::check;
use super::{DamperError, Tuning, TuningRule, rule_tuning};
use crate::known::tuned_mass::{Acts, TunedMass, response, variance};
use crate::numeric::{Minimax, Piece, Worst, by_differences, minimax};

/// The minimised response, and its load.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    /// Largest displacement under a harmonic force at any frequency (bells, machines).
    ForceHarmonic,
    /// Standard deviation of displacement under a white-noise force (wind).
    ForceRandom,
    /// Largest relative displacement under a harmonic base acceleration.
    BaseHarmonic,
    /// Standard deviation of relative displacement under a white-noise base acceleration (earthquake).
    BaseRandom,
}

impl Aim {
    /// All aims.
    pub const ALL: [Aim; 4] = [
        Aim::ForceHarmonic,
        Aim::ForceRandom,
        Aim::BaseHarmonic,
        Aim::BaseRandom,
    ];

    /// Name of the aim in project files and JSON.
    pub fn name(self) -> &'static str {
        match self {
            Aim::ForceHarmonic => "force_harmonic",
            Aim::ForceRandom => "force_random",
            Aim::BaseHarmonic => "base_harmonic",
            Aim::BaseRandom => "base_random",
        }
    }

    fn acts(self) -> Acts {
        match self {
            Aim::ForceHarmonic | Aim::ForceRandom => Acts::Force,
            Aim::BaseHarmonic | Aim::BaseRandom => Acts::Base,
        }
    }

    fn is_random(self) -> bool {
        matches!(self, Aim::ForceRandom | Aim::BaseRandom)
    }
}

/// One mode and the mass ratio of its damper, dimensionless: the mode has unit mass and frequency.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SingleMode {
    /// μ, damper mass over modal mass, the mode shape scaled to 1 at the damper; in (0, 1].
    pub mass_ratio: f64,
    /// β, damping ratio of the mode itself; in [0, 0.3].
    pub structure_damping_ratio: f64,
}

impl SingleMode {
    /// σ² = (1/2π) ∫ |H|² dr of the structure's displacement with this damper, or the largest |H| for a harmonic aim.
    ///
    /// # Errors
    /// [`DamperError`] if a ratio is out of range.
    pub fn cost(&self, tuning: &Tuning, aim: Aim) -> Result<f64, DamperError> {
        check(self.mass_ratio, self.structure_damping_ratio)?;
        for (argument, given) in [
            ("frequency_ratio", tuning.frequency_ratio),
            ("damping_ratio", tuning.damping_ratio),
        ] {
            if !(given > 0.0 && given.is_finite()) {
                return Err(DamperError::Argument {
                    argument,
                    given,
                    allowed: "positive",
                });
            }
        }
        let of = self.with(tuning);
        Ok(match aim.is_random() {
            true => variance(of, aim.acts()),
            false => peaks(of, aim.acts()).into_iter().fold(0.0, |most, peak| {
                let here = response(of, aim.acts(), peak).norm();
                here.max(most)
            }),
        })
    }

    fn with(&self, tuning: &Tuning) -> TunedMass {
        TunedMass {
            mass_ratio: self.mass_ratio,
            frequency_ratio: tuning.frequency_ratio,
            damping_ratio: tuning.damping_ratio,
            structure_damping_ratio: self.structure_damping_ratio,
        }
    }
}

/// The optimal tuning, and the accuracy of the search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OptimalTuning {
    /// Frequency ratio and damping ratio of the damper.
    pub tuning: Tuning,
    /// The minimised cost: σ² = (1/2π) ∫ |H|² dr, or the largest |H|.
    pub cost: f64,
    /// Number of steps of the search.
    pub iterations: usize,
    /// Length of the last step, in ln f and ln ζ: the accuracy of the optimum.
    pub last_step: f64,
}

const ITERATIONS_MOST: usize = 200;
/// Largest last step of a search that ended because no step improved the cost. Near the optimum the cost is so flat that steps of this
/// length change only its rounding.
const LAST_STEP_MOST: f64 = 1e-5;

/// Frequency and damping that minimise the response of `aim` for a mode with its own damping.
///
/// # Errors
/// [`DamperError`] if a ratio is out of range, or if the search ends without an optimum.
///
/// # Limits
/// Agrees within 1e-6 with the closed forms for an undamped structure, which are exact for random loads and for
/// [`TuningRule::NishiharaAsami`]. Tested by `tuned_mass`.
///
/// # Example
/// ```
/// use dolmen::damper::{optimal_tuning, Aim, SingleMode};
/// let mode = SingleMode { mass_ratio: 0.05, structure_damping_ratio: 0.02 };
/// let best = optimal_tuning(&mode, Aim::ForceRandom)?;
/// assert!((best.tuning.frequency_ratio - 0.962_178).abs() < 5e-7);
/// assert!((best.tuning.damping_ratio - 0.109_772).abs() < 5e-7);
/// assert!(((best.cost * 4.0 * 0.02).sqrt() - 0.528_351).abs() < 5e-7); // RMS over that without a damper
/// # Ok::<(), dolmen::damper::DamperError>(())
/// ```
pub fn optimal_tuning(mode: &SingleMode, aim: Aim) -> Result<OptimalTuning, DamperError> {
    let rule = match aim {
        Aim::ForceHarmonic => TuningRule::DenHartog,
        Aim::ForceRandom => TuningRule::WarburtonForce,
        Aim::BaseHarmonic => TuningRule::WarburtonBaseHarmonic,
        Aim::BaseRandom => TuningRule::WarburtonBase,
    };
    let start = rule_tuning(rule, mode.mass_ratio, mode.structure_damping_ratio)?;
    let mut problem = Search { mode: *mode, aim };
    let x = vec![start.frequency_ratio.ln(), start.damping_ratio.ln()];
    let least = minimax(x, &Minimax::steps(ITERATIONS_MOST), &mut problem);
    let failed = |iterations| DamperError::NoOptimum {
        what: aim.name(),
        iterations,
    };
    let least = least.ok_or(failed(0))?;
    if least.last_step.is_nan() || least.last_step > LAST_STEP_MOST {
        return Err(failed(least.iterations));
    }
    let tuning = tuning_of(&least.x);
    Ok(OptimalTuning {
        tuning,
        cost: mode.cost(&tuning, aim)?,
        iterations: least.iterations,
        last_step: least.last_step,
    })
}

fn tuning_of(x: &[f64]) -> Tuning {
    Tuning {
        frequency_ratio: x[0].exp(),
        damping_ratio: x[1].exp(),
    }
}

struct Search {
    mode: SingleMode,
    aim: Aim,
}

impl Worst for Search {
    fn worst(&mut self, x: &[f64]) -> Option<f64> {
        let cost = self.mode.cost(&tuning_of(x), self.aim).ok()?;
        Some(match self.aim.is_random() {
            true => cost.ln(),
            false => 2.0 * cost.ln(),
        })
    }

    fn pieces(&mut self, x: &[f64]) -> Option<Vec<Piece>> {
        if self.aim.is_random() {
            return Some(vec![by_differences(x, |x| self.worst(x))?]);
        }
        let (mode, acts) = (self.mode, self.aim.acts());
        let at = |x: &[f64], r: f64| 2.0 * response(mode.with(&tuning_of(x)), acts, r).norm().ln();
        // at a peak the derivative with respect to r is zero: the gradient equals that at fixed r
        let peaks = peaks(mode.with(&tuning_of(x)), acts);
        peaks
            .into_iter()
            .map(|r| by_differences(x, |x| Some(at(x, r))))
            .collect()
    }
}

/// Frequencies of all local maxima of |H|, ascending.
fn peaks(of: TunedMass, acts: Acts) -> Vec<f64> {
    // both peaks are within the frequency splitting of two coupled oscillators, which is less than this range
    const LOW: f64 = 0.05;
    const HIGH: f64 = 5.0;
    const SAMPLES: usize = 1200; // in ln r, 0.4 % apart
    let spread = of.frequency_ratio.max(1.0) * HIGH;
    let low = of.frequency_ratio.min(1.0) * LOW;
    let at = |i: usize| low * (spread / low).powf(i as f64 / SAMPLES as f64);
    let size = |r: f64| response(of, acts, r).norm_sqr();
    let samples: Vec<f64> = (0..=SAMPLES).map(|i| size(at(i))).collect();
    let tops = (1..SAMPLES).filter(|&i| samples[i] > samples[i - 1] && samples[i] >= samples[i + 1]);
    tops.map(|i| crate::numeric::maximum_between(&size, at(i - 1), at(i + 1)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refuses_what_is_no_tuning() {
        let mode = SingleMode {
            mass_ratio: 0.05,
            structure_damping_ratio: 0.0,
        };
        let tuning = Tuning {
            frequency_ratio: 0.0,
            damping_ratio: 0.1,
        };
        let fault = mode.cost(&tuning, Aim::ForceRandom).unwrap_err();
        assert_eq!(fault.to_string(), "frequency_ratio is 0, but must be positive");
    }
}
