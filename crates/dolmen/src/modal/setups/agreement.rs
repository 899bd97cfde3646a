//! Whether several setups agree on a value, and their mean.

use crate::modal::ModalError;
use crate::numeric::chi_squared_above;

/// Whether the setups agree on a value.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Agreement {
    /// Standard deviation of the setups about their mean, √(Σ (x - mean)²/(S - 1)).
    pub spread: f64,
    /// Σ (x - mean)²/σ²; `None` if a standard deviation is unknown.
    pub chi_squared: Option<f64>,
    /// Probability that chance gives at least this χ², with S - 1 degrees of freedom.
    pub p: Option<f64>,
}

impl Agreement {
    /// Whether the setups differ significantly. Chance does so in about 1 of 100 cases; in 2 if the standard deviations come from 30
    /// blocks of time, and in up to 6 for 10 blocks, because χ² assumes exact standard deviations.
    pub fn differs(&self) -> bool {
        const CHANCE: f64 = 0.01; // ours: ten modes and no change give a false alarm in one of ten surveys
        self.p.is_some_and(|p| p < CHANCE)
    }
}

/// A value of one setup and its standard deviation, if known.
pub(super) type Estimate = (f64, Option<f64>);

pub(super) struct Mean {
    pub(super) value: f64,
    pub(super) sd: Option<f64>,
    /// Degrees of freedom of the standard deviation, if it comes from the scatter of the setups.
    pub(super) degrees_of_freedom: Option<f64>,
    pub(super) agreement: Agreement,
}

/// Weighted by inverse variance if all standard deviations are known; otherwise the plain mean, with a standard deviation from the
/// scatter.
pub(super) fn mean(all: &[Estimate]) -> Result<Mean, ModalError> {
    let n = all.len() as f64;
    let known: Option<Vec<f64>> = all.iter().map(|(_, sd)| sd.filter(|sd| *sd > 0.0)).collect();
    let plain = all.iter().map(|(x, _)| x).sum::<f64>() / n;
    let squares = |about: f64| all.iter().map(move |(x, _)| (x - about).powi(2));
    let spread = (squares(plain).sum::<f64>() / (n - 1.0)).sqrt();
    let Some(sds) = known else {
        return Ok(Mean {
            value: plain,
            sd: Some(spread / n.sqrt()),
            degrees_of_freedom: Some(n - 1.0),
            agreement: Agreement {
                spread,
                chi_squared: None,
                p: None,
            },
        });
    };
    let weight: f64 = sds.iter().map(|sd| sd.powi(-2)).sum();
    let value = all
        .iter()
        .zip(&sds)
        .map(|((x, _), sd)| x / (sd * sd))
        .sum::<f64>()
        / weight;
    let chi_squared: f64 = squares(value)
        .zip(&sds)
        .map(|(square, sd)| square / (sd * sd))
        .sum();
    let widened = (chi_squared / (n - 1.0)).max(1.0).sqrt();
    Ok(Mean {
        value,
        sd: Some(widened / weight.sqrt()),
        degrees_of_freedom: (widened > 1.0).then_some(n - 1.0),
        agreement: Agreement {
            spread,
            chi_squared: Some(chi_squared),
            p: Some(chi_squared_above(chi_squared, (all.len() - 1) as f64)?),
        },
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_mean_by_inverse_variance_and_chi_squared_by_hand() {
        let found = mean(&[(1.0, Some(0.1)), (1.3, Some(0.2))]).unwrap();
        // weights 100 and 25: (100 + 32.5)/125 = 1.06; χ² = 0.06²·100 + 0.24²·25 = 1.8
        assert!((found.value - 1.06).abs() < 1e-14);
        assert!((found.agreement.chi_squared.unwrap() - 1.8).abs() < 1e-12);
        assert!((found.sd.unwrap() - (1.8_f64 / 125.0).sqrt()).abs() < 1e-14);
        assert_eq!(found.degrees_of_freedom, Some(1.0)); // two setups that differ say so once
        let agree = mean(&[(1.0, Some(0.1)), (1.05, Some(0.2))]).unwrap();
        assert_eq!(agree.degrees_of_freedom, None);
        let bare = mean(&[(1.0, None), (1.3, None), (1.1, None)]).unwrap();
        assert_eq!(bare.degrees_of_freedom, Some(2.0));
        assert!((found.agreement.p.unwrap() - libm::erfc(0.9_f64.sqrt())).abs() < 1e-14);
    }
}
