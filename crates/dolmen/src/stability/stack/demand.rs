//! A threshold of uplift or sliding compared with a seismic demand.

use crate::stability::StabilityError;

/// A seismic demand in numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StackDemand {
    /// Peak horizontal acceleration of the ground, m/s²: the demand of a stack on rigid joints.
    pub peak_ground_acceleration_m_s2: f64,
    /// The demand on elastic joints, if the first period is known.
    pub spectral: Option<SpectralDemand>,
}

/// The response spectrum at the first period of a stack.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpectralDemand {
    /// T₁, s.
    pub period_s: f64,
    /// ζ of the spectrum.
    pub damping_ratio: f64,
    /// S_a(T₁, ζ), m/s².
    pub acceleration_m_s2: f64,
}

/// Capacity against demand, in fixed words.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum DemandVerdict {
    /// Capacity is below the demand.
    #[cfg_attr(feature = "serde", serde(rename = "below demand"))]
    Below,
    /// Capacity is above the demand by a factor less than [`DemandVerdict::NEAR_BELOW`].
    #[cfg_attr(feature = "serde", serde(rename = "near demand"))]
    Near,
    /// Capacity is at least [`DemandVerdict::NEAR_BELOW`] times the demand.
    #[cfg_attr(feature = "serde", serde(rename = "above demand"))]
    Above,
    /// A necessary input is unknown.
    #[cfg_attr(feature = "serde", serde(rename = "unknown"))]
    Unknown,
}

impl DemandVerdict {
    /// Ratio of capacity to demand below which "above demand" becomes "near demand". Our choice: edges and surveyed sizes are uncertain by 10
    /// %, and so is a demand.
    pub const NEAR_BELOW: f64 = 1.25;

    /// Verdict for a ratio of capacity to demand; unknown if the ratio is not a number.
    pub fn of_ratio(ratio: f64) -> Self {
        if ratio.is_nan() {
            DemandVerdict::Unknown
        } else if ratio < 1.0 {
            DemandVerdict::Below
        } else if ratio < Self::NEAR_BELOW {
            DemandVerdict::Near
        } else {
            DemandVerdict::Above
        }
    }

    /// The words, in English: above demand, near demand, below demand, unknown.
    pub fn words(self) -> &'static str {
        match self {
            DemandVerdict::Below => "below demand",
            DemandVerdict::Near => "near demand",
            DemandVerdict::Above => "above demand",
            DemandVerdict::Unknown => "unknown",
        }
    }
}

/// One capacity compared with one demand.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Comparison {
    /// Acceleration at which the stack begins to rock or slide, m/s²; `None` if it does not stand.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub capacity_m_s2: Option<f64>,
    /// The demand, m/s².
    pub demand_m_s2: f64,
    /// Capacity over demand; `None` if the stack does not stand, infinite without a demand.
    pub ratio: Option<f64>,
    /// Above, near or below demand; below if the stack does not stand.
    pub verdict: DemandVerdict,
}

/// A stack's threshold compared with an earthquake.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DemandComparison {
    /// With rigid joints: compared with the peak ground acceleration.
    pub rigid: Comparison,
    /// With elastic joints, which amplify: compared with S_a(T₁, ζ). `None` if the first period is unknown.
    pub elastic: Option<Comparison>,
    /// The worse verdict of both. Without the elastic comparison it is unknown at best: a stack like P10 (first frequency 4.7 Hz) amplifies the
    /// ground motion.
    pub verdict: DemandVerdict,
}

/// Compares the acceleration at which a stack begins to move with a seismic demand.
///
/// # Errors
/// [`StabilityError::Option`] for a demand that is negative or not finite, a period that is not positive, or a capacity that
/// is not a number.
///
/// # Limits
/// "Below demand" means that a joint opens or slides, not that the stack falls; that needs a time history. S_a acts on all masses equally. In
/// the first mode the upper part has a larger acceleration (for a straight-line shape about 1.5 times), the lower part a smaller one;
/// `assess::demand::stack_against_site` combines all modes joint by joint.
///
/// # Example
/// ```
/// use dolmen::stability::stack::{compare_with_demand, DemandVerdict, SpectralDemand, StackDemand};
/// let spectral = SpectralDemand { period_s: 0.21, damping_ratio: 0.05, acceleration_m_s2: 4.0 };
/// let demand = StackDemand { peak_ground_acceleration_m_s2: 2.0, spectral: Some(spectral) };
/// let comparison = compare_with_demand(Some(3.18), &demand)?;
/// assert_eq!(comparison.rigid.verdict, DemandVerdict::Above);
/// assert_eq!(comparison.verdict, DemandVerdict::Below);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn compare_with_demand(
    capacity_m_s2: Option<f64>,
    demand: &StackDemand,
) -> Result<DemandComparison, StabilityError> {
    if let Some(given) = capacity_m_s2
        && (given.is_nan() || given < 0.0)
    {
        return Err(StabilityError::Option {
            option: "capacity_m_s2",
            given,
            allowed: "0 or a positive number",
        });
    }
    let rigid = compared(
        capacity_m_s2,
        "peak_ground_acceleration_m_s2",
        demand.peak_ground_acceleration_m_s2,
    )?;
    let mut elastic = None;
    if let Some(spectral) = &demand.spectral {
        for (option, given) in [
            ("period_s", spectral.period_s),
            ("damping_ratio", spectral.damping_ratio),
        ] {
            if !(given > 0.0 && given.is_finite()) {
                return Err(StabilityError::Option {
                    option,
                    given,
                    allowed: "a positive number",
                });
            }
        }
        elastic = Some(compared(
            capacity_m_s2,
            "acceleration_m_s2 of the spectrum",
            spectral.acceleration_m_s2,
        )?);
    }
    let verdict = match (&elastic, rigid.verdict) {
        (Some(elastic), rigid) => rigid.min(elastic.verdict),
        (None, DemandVerdict::Below) => DemandVerdict::Below,
        (None, _) => DemandVerdict::Unknown,
    };
    Ok(DemandComparison {
        rigid,
        elastic,
        verdict,
    })
}

fn compared(
    capacity_m_s2: Option<f64>,
    option: &'static str,
    demand: f64,
) -> Result<Comparison, StabilityError> {
    if !(demand >= 0.0 && demand.is_finite()) {
        return Err(StabilityError::Option {
            option,
            given: demand,
            allowed: "0 or a positive number",
        });
    }
    let ratio = capacity_m_s2.map(|capacity| {
        if demand > 0.0 {
            capacity / demand
        } else {
            f64::INFINITY
        }
    });
    Ok(Comparison {
        capacity_m_s2,
        demand_m_s2: demand,
        ratio,
        verdict: ratio.map_or(DemandVerdict::Below, DemandVerdict::of_ratio),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn demand(ground: f64, spectral: Option<f64>) -> StackDemand {
        StackDemand {
            peak_ground_acceleration_m_s2: ground,
            spectral: spectral.map(|acceleration_m_s2| SpectralDemand {
                period_s: 0.2,
                damping_ratio: 0.05,
                acceleration_m_s2,
            }),
        }
    }

    #[test]
    fn exact_words() {
        let verdict = |capacity, ground, spectral| {
            compare_with_demand(capacity, &demand(ground, spectral))
                .unwrap()
                .verdict
        };
        assert_eq!(verdict(Some(3.0), 2.0, Some(2.4)), DemandVerdict::Above);
        assert_eq!(verdict(Some(3.0), 2.0, Some(2.5)), DemandVerdict::Near);
        assert_eq!(verdict(Some(3.0), 2.0, Some(3.1)), DemandVerdict::Below);
        assert_eq!(verdict(Some(3.0), 2.0, None), DemandVerdict::Unknown);
        assert_eq!(verdict(Some(3.0), 3.1, None).words(), "below demand");
        assert_eq!(verdict(None, 0.0, Some(0.0)), DemandVerdict::Below);
    }

    #[test]
    fn refuses_a_negative_demand() {
        assert!(compare_with_demand(Some(1.0), &demand(-1.0, None)).is_err());
        assert!(compare_with_demand(Some(f64::NAN), &demand(1.0, None)).is_err());
    }
}
