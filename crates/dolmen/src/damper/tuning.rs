//! Closed-form tunings of a mass damper to one mode, each with its author and its normalisation.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | μ | `mass_ratio` | damper mass / modal mass, with the mode shape scaled to 1 at the damper |
//! | f | `frequency_ratio` | frequency of the damper alone / frequency of the mode |
//! | ζ | `damping_ratio` | c / (2 m ω), with mass m and frequency ω of the **damper alone** |
//! | β | `structure_damping_ratio` | damping ratio of the mode without damper |

use super::DamperError;

/// Largest mass ratio: above it 1 − μ/2 approaches zero, and no real damper is that heavy.
pub(super) const MASS_RATIO_MOST: f64 = 1.0;
/// Largest damping ratio of a mode: above it the mode hardly oscillates, and a damper is of no use.
pub(super) const STRUCTURE_DAMPING_MOST: f64 = 0.3;

/// A tuned damper, relative to the mode it is tuned to. All dimensionless.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tuning {
    /// f, frequency of the damper alone over the frequency of the mode.
    pub frequency_ratio: f64,
    /// ζ = c / (2 m ω), with mass and frequency of the damper alone.
    pub damping_ratio: f64,
}

impl Tuning {
    /// f ζ = c / (2 m Ω), with Ω the frequency of the **structure**: the normalisation of Den Hartog's book and of Hwang, Min & Hong.
    pub fn damping_ratio_on_structure(&self) -> f64 {
        self.frequency_ratio * self.damping_ratio
    }

    /// Converts a ratio c / (2 m Ω) relative to the frequency of the structure.
    pub fn from_damping_on_structure(frequency_ratio: f64, damping_ratio_on_structure: f64) -> Self {
        Tuning {
            frequency_ratio,
            damping_ratio: damping_ratio_on_structure / frequency_ratio,
        }
    }
}

/// A liquid column as its equivalent tuned mass: the fraction α² of the liquid oscillates, the rest moves with the structure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColumnAsMass {
    /// α² μ / (1 + (1 − α²) μ): the oscillating mass over the modal mass that includes the rest of the liquid.
    pub mass_ratio: f64,
    /// 1/√(1 + (1 − α²) μ): frequency of the mode with the rest of the liquid over its frequency without; its damping ratio changes by the same
    /// factor.
    pub frequency_factor: f64,
}

impl ColumnAsMass {
    /// From the ratio of liquid mass to modal mass, and α = `length_ratio`; α = 1 is a mass on a spring.
    ///
    /// Exact for one mode. Warburton's tuning under a force then gives the optimum of Yalla & Kareem (2000),
    /// [`known::liquid_column::least_variance_under_force`](crate::known::liquid_column::least_variance_under_force).
    pub fn new(mass_ratio: f64, length_ratio: f64) -> Self {
        let swings = length_ratio * length_ratio;
        let heavier = 1.0 + (1.0 - swings) * mass_ratio;
        ColumnAsMass {
            mass_ratio: swings * mass_ratio / heavier,
            frequency_factor: 1.0 / heavier.sqrt(),
        }
    }

    /// A closed form for the column. Its frequency is relative to that of the mode without the column.
    ///
    /// # Errors
    /// As in [`rule_tuning`].
    pub fn rule(&self, rule: TuningRule, structure_damping_ratio: f64) -> Result<Tuning, DamperError> {
        let tuning = rule_tuning(
            rule,
            self.mass_ratio,
            self.frequency_factor * structure_damping_ratio,
        )?;
        Ok(self.of_mode(tuning))
    }

    /// Converts a tuning relative to the mode with the rest of the liquid into a tuning relative to the mode without it.
    pub(super) fn of_mode(&self, tuning: Tuning) -> Tuning {
        Tuning {
            frequency_ratio: self.frequency_factor * tuning.frequency_ratio,
            ..tuning
        }
    }
}

/// A published closed form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TuningRule {
    /// Den Hartog (1956): equal fixed points of the displacement under a harmonic force.
    DenHartog,
    /// Warburton (1982): least variance of displacement under a white-noise force (wind).
    WarburtonForce,
    /// Warburton (1982): least variance of relative displacement under a white-noise base acceleration (earthquake).
    WarburtonBase,
    /// Warburton (1982): equal fixed points of the relative displacement under a harmonic base acceleration.
    WarburtonBaseHarmonic,
    /// Nishihara & Asami (2002): smallest peak displacement under a harmonic force, exact.
    NishiharaAsami,
    /// Sadek, Mohraz, Taylor & Chung (1997): equal damping of the two modes into which the damper splits the mode.
    Sadek,
    /// Villaverde (1985): resonance, with a damper ratio √μ above that of the structure.
    Villaverde,
    /// Hwang, Min & Hong as printed, with their "damping ratio" applied to the damper's own frequency: less damping than they intended.
    HwangMinHongLiteral,
}

impl TuningRule {
    /// All forms, in the order of the tables.
    pub const ALL: [TuningRule; 8] = [
        TuningRule::DenHartog,
        TuningRule::NishiharaAsami,
        TuningRule::WarburtonForce,
        TuningRule::WarburtonBase,
        TuningRule::WarburtonBaseHarmonic,
        TuningRule::Sadek,
        TuningRule::Villaverde,
        TuningRule::HwangMinHongLiteral,
    ];

    /// Name of the form in project files and JSON.
    pub fn name(self) -> &'static str {
        match self {
            TuningRule::DenHartog => "den_hartog",
            TuningRule::WarburtonForce => "warburton_force",
            TuningRule::WarburtonBase => "warburton_base",
            TuningRule::WarburtonBaseHarmonic => "warburton_base_harmonic",
            TuningRule::NishiharaAsami => "nishihara_asami",
            TuningRule::Sadek => "sadek",
            TuningRule::Villaverde => "villaverde",
            TuningRule::HwangMinHongLiteral => "hwang_min_hong",
        }
    }

    /// Author and year.
    pub fn source(self) -> &'static str {
        match self {
            TuningRule::DenHartog => "Den Hartog (1956)",
            TuningRule::WarburtonForce | TuningRule::WarburtonBase | TuningRule::WarburtonBaseHarmonic => {
                "Warburton (1982)"
            }
            TuningRule::NishiharaAsami => "Nishihara & Asami (2002)",
            TuningRule::Sadek => "Sadek et al. (1997)",
            TuningRule::Villaverde => "Villaverde (1985)",
            TuningRule::HwangMinHongLiteral => "Hwang, Min & Hong, taken literally",
        }
    }

    /// The minimised quantity.
    pub fn aim(self) -> &'static str {
        match self {
            TuningRule::DenHartog => "peak under a harmonic force, fixed points",
            TuningRule::WarburtonForce => "variance under a white-noise force",
            TuningRule::WarburtonBase => "variance under a white-noise base acceleration",
            TuningRule::WarburtonBaseHarmonic => "peak under a harmonic base acceleration, fixed points",
            TuningRule::NishiharaAsami => "peak under a harmonic force, exact",
            TuningRule::Sadek => "two modes equally damped",
            TuningRule::Villaverde => "mean damping of two modes",
            TuningRule::HwangMinHongLiteral => "as printed, on the damper's own frequency",
        }
    }
}

/// Frequency and damping of a damper by a published closed form.
///
/// ```text
///                        f                      ζ²
/// DenHartog              1 / (1+μ)              3μ / 8(1+μ)
/// WarburtonForce         √(1+μ/2) / (1+μ)       μ(1+3μ/4) / 4(1+μ)(1+μ/2)
/// WarburtonBase          √(1-μ/2) / (1+μ)       μ(1-μ/4) / 4(1+μ)(1-μ/2)
/// WarburtonBaseHarmonic  √(1-μ/2) / (1+μ)       3μ / 8(1+μ)(1-μ/2)
/// NishiharaAsami         known::tuned_mass::least_peak_under_force
/// Sadek                  (1 - β√(μ/(1+μ)))/(1+μ)   ζ = β/(1+μ) + √(μ/(1+μ))
/// Villaverde             1                      ζ = β + √μ
/// HwangMinHongLiteral    1 / (1+μ)              3μ / 8(1+μ)³
/// ```
///
/// # Input
/// * `structure_damping_ratio` -- β, in [0, 0.3]; only Sadek's and Villaverde's forms use it
///
/// # Errors
/// [`DamperError::MassRatio`] if μ is not in (0, 1]; [`DamperError::Argument`] if β is not in [0, 0.3].
///
/// # Limits
/// All forms except Sadek's and Villaverde's take the damping of the structure as 0. With 2 % structural damping and μ = 0.05, the best f of
/// `WarburtonForce` is 0.2 % lower, and its variance is 0.01 % above the minimum.
///
/// # Source
/// Den Hartog (1956) *Mechanical Vibrations*, 4th ed., sec. 3.3; Warburton (1982) Earthq. Eng. Struct. Dyn. 10(3):381-401,
/// doi:10.1002/eqe.4290100304; Nishihara & Asami (2002) J. Vib. Acoust. 124(4):576-582; Sadek, Mohraz, Taylor & Chung
/// (1997) Earthq. Eng. Struct. Dyn. 26(6):617-635; Villaverde (1985) Engineering Structures 7(1):33-40. Differs from Den
/// Hartog: he divides c by 2 m Ω with Ω the structure's frequency, so his ratio is ours times f
/// ([`Tuning::damping_ratio_on_structure`]); so do Hwang, Min & Hong, whose √(3μ / 8(1+μ)³) is Den Hartog's.
///
/// # Example
/// ```
/// use dolmen::damper::{rule_tuning, TuningRule};
/// let t = rule_tuning(TuningRule::DenHartog, 0.05, 0.0)?;
/// assert!((t.frequency_ratio - 0.952_381_0).abs() < 5e-8);
/// assert!((t.damping_ratio - 0.133_630_6).abs() < 5e-8);
/// assert!((t.damping_ratio_on_structure() - 0.127_267_3).abs() < 5e-8); // what Hwang, Min & Hong print
/// # Ok::<(), dolmen::damper::DamperError>(())
/// ```
pub fn rule_tuning(
    rule: TuningRule,
    mass_ratio: f64,
    structure_damping_ratio: f64,
) -> Result<Tuning, DamperError> {
    check(mass_ratio, structure_damping_ratio)?;
    let (mu, beta) = (mass_ratio, structure_damping_ratio);
    let (whole, plus, minus) = (1.0 + mu, 1.0 + 0.5 * mu, 1.0 - 0.5 * mu);
    let part = (mu / whole).sqrt();
    let (frequency_ratio, damping_ratio) = match rule {
        TuningRule::DenHartog => (1.0 / whole, (3.0 * mu / (8.0 * whole)).sqrt()),
        TuningRule::WarburtonForce => (
            plus.sqrt() / whole,
            (mu * (1.0 + 0.75 * mu) / (4.0 * whole * plus)).sqrt(),
        ),
        TuningRule::WarburtonBase => (
            minus.sqrt() / whole,
            (mu * (1.0 - 0.25 * mu) / (4.0 * whole * minus)).sqrt(),
        ),
        TuningRule::WarburtonBaseHarmonic => {
            (minus.sqrt() / whole, (3.0 * mu / (8.0 * whole * minus)).sqrt())
        }
        TuningRule::NishiharaAsami => {
            let [f, zeta, _] = crate::known::tuned_mass::least_peak_under_force(mu);
            (f, zeta)
        }
        TuningRule::Sadek => ((1.0 - beta * part) / whole, beta / whole + part),
        TuningRule::Villaverde => (1.0, beta + mu.sqrt()),
        TuningRule::HwangMinHongLiteral => (1.0 / whole, (3.0 * mu / (8.0 * whole.powi(3))).sqrt()),
    };
    Ok(Tuning {
        frequency_ratio,
        damping_ratio,
    })
}

pub(super) fn check(mass_ratio: f64, structure_damping_ratio: f64) -> Result<(), DamperError> {
    if !(mass_ratio > 0.0 && mass_ratio <= MASS_RATIO_MOST) {
        return Err(DamperError::MassRatio {
            given: mass_ratio,
            most: MASS_RATIO_MOST,
        });
    }
    if !(0.0..=STRUCTURE_DAMPING_MOST).contains(&structure_damping_ratio) {
        return Err(DamperError::Argument {
            argument: "structure_damping_ratio",
            given: structure_damping_ratio,
            allowed: "between 0 and 0.3",
        });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refuses_a_mass_ratio_out_of_range_and_says_which() {
        for given in [0.0, -0.1, 1.5, f64::NAN] {
            let fault = rule_tuning(TuningRule::WarburtonBase, given, 0.0).unwrap_err();
            assert!(
                fault.to_string().starts_with(&format!("mass_ratio is {given}")),
                "{fault}"
            );
        }
        let fault = rule_tuning(TuningRule::Sadek, 0.05, f64::NAN).unwrap_err();
        assert!(fault.to_string().starts_with("structure_damping_ratio is NaN"));
    }

    #[test]
    fn exact_a_column_is_a_mass_of_its_swinging_part() {
        for (mu, alpha) in [(0.01, 0.9), (0.05, 0.7), (0.1, 0.5), (0.05, 1.0)] {
            let found = ColumnAsMass::new(mu, alpha)
                .rule(TuningRule::WarburtonForce, 0.0)
                .unwrap();
            let [f, zeta] = crate::known::liquid_column::least_variance_under_force(mu, alpha);
            assert!((found.frequency_ratio - f).abs() < 1e-14 && (found.damping_ratio - zeta).abs() < 1e-14);
        }
    }
}
