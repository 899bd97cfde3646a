//! Design spectrum of acceleration, from the formula of a code or from a table.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | A_0 | `ground_m_s2` | effective peak ground acceleration, including the site soil | m/s² |
//! | A_p | `plateau_m_s2` | plateau at ζ = 5 % | m/s² |
//! | T_0, T_s, T_L | `rise_s`, `plateau_s`, `displacement_s` | ends of rise, plateau and 1/T branch | s |
//! | η | `damping_factor` | plateau at ζ over that at 5 % | – |

use crate::assess::AssessError;
pub(super) use crate::known::STANDARD_GRAVITY_M_S2;
use crate::numeric::NumericError;
use std::fmt;

/// Range of damping ratios for which the damping factors of codes hold. Our choice.
const DAMPING_LEAST: f64 = 0.005;
const DAMPING_MOST: f64 = 0.3;

/// Peak of the vertical ground acceleration over that of the horizontal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VerticalRatio {
    /// The ratio.
    pub ratio: f64,
    /// Whether the ratio was compared with the text of the code. If not, results that use it must say so.
    pub verified: bool,
}

/// A value of a code that was not compared with the text of the code. Results that use it must say so. `Display` gives a short
/// English description.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unverified {
    /// The edition whose tables are used.
    Edition {
        /// The year.
        year: u16,
    },
    /// The risk factor of a return period.
    RiskFactor {
        /// The return period, years.
        return_period_years: u32,
        /// The factor.
        factor: f64,
    },
    /// Vertical over horizontal acceleration.
    VerticalRatio {
        /// The ratio.
        ratio: f64,
    },
    /// The factor that changes the plateau with damping; applies only if the damping ratio is not 5 %.
    DampingFactor,
    /// Variation of that factor from 1 at T = 0 to its value at T_0; applies only if the damping ratio is not 5 %.
    DampingAtShortPeriods,
    /// The period from which the spectrum falls as 1/T².
    LongPeriods {
        /// The period T_L, s.
        displacement_s: f64,
    },
    /// The shape of the branches between the tabulated values.
    Shape,
}

impl fmt::Display for Unverified {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Unverified::Edition { year } => write!(f, "the year {year} of the edition"),
            Unverified::RiskFactor {
                return_period_years,
                factor,
            } => write!(f, "the risk factor {factor} of {return_period_years} years"),
            Unverified::VerticalRatio { ratio } => {
                write!(f, "the vertical ratio {ratio}")
            }
            Unverified::DampingFactor => write!(f, "the factor of other damping than 5 %"),
            Unverified::DampingAtShortPeriods => {
                write!(f, "the factor of damping between T = 0 and T_0")
            }
            Unverified::LongPeriods { displacement_s } => {
                write!(f, "{displacement_s} s as the beginning of the 1/T² branch")
            }
            Unverified::Shape => write!(f, "the shape of the spectrum between its numbers"),
        }
    }
}

/// Ends of the branches of a code's spectrum, at a damping ratio of 5 %.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SpectrumBranches {
    /// Acceleration at T = 0, including the site soil, m/s².
    pub ground_m_s2: f64,
    /// Acceleration of the plateau, m/s².
    pub plateau_m_s2: f64,
    /// Period at which the plateau begins, T_0 or T_B, s.
    pub rise_s: f64,
    /// Period at which the plateau ends, T_s or T_C, s.
    pub plateau_s: f64,
    /// Period at which the branch 1/T ends and 1/T² begins, T_L or T_D, s.
    pub displacement_s: f64,
}

/// A design spectrum of acceleration.
#[derive(Clone, Debug, PartialEq)]
pub struct DesignSpectrum {
    /// Name and year of the code, or name of the table.
    pub source: String,
    /// Vertical over horizontal acceleration; `None` if the source gives none.
    pub vertical: Option<VerticalRatio>,
    /// Values that were not compared with the text of the code.
    pub unverified: Vec<Unverified>,
    pub(super) shape: Shape,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Shape {
    Branches(Branches),
    /// Ascending periods, s, and accelerations, m/s², at one damping ratio.
    Table {
        points: Vec<[f64; 2]>,
        damping_ratio: f64,
    },
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Branches {
    pub(super) ground_m_s2: f64,
    pub(super) plateau_m_s2: f64,
    pub(super) rise_s: f64,
    pub(super) plateau_s: f64,
    pub(super) displacement_s: f64,
    pub(super) damping: DampingFactor,
}

/// Effect of damping on the plateau in a code.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum DampingFactor {
    /// (6.42/(1.42 + ξ))^0.48. From T = 0 to T_0 the factor varies linearly from 1 to this value.
    Korea,
    /// √(10/(5 + ξ)) ≥ 0.55. From T = 0 to T_B the spectrum varies linearly.
    Eurocode,
}

impl DampingFactor {
    fn at(self, damping_ratio: f64) -> f64 {
        let percent = 100.0 * damping_ratio;
        match self {
            DampingFactor::Korea => (6.42 / (1.42 + percent)).powf(0.48),
            DampingFactor::Eurocode => (10.0 / (5.0 + percent)).sqrt().max(0.55),
        }
    }
}

/// Checks that a number is in a closed range.
pub(super) fn within(
    quantity: &'static str,
    given: f64,
    [least, most]: [f64; 2],
    allowed: &'static str,
) -> Result<f64, AssessError> {
    if given >= least && given <= most {
        Ok(given)
    } else {
        Err(NumericError::Range {
            quantity,
            given,
            allowed,
        }
        .into())
    }
}

impl DesignSpectrum {
    /// A spectrum from a table of periods, s, and accelerations, m/s², at one damping ratio. Interpolation is linear.
    ///
    /// # Errors
    /// [`AssessError::SpectrumTable`] for fewer than two points, periods that do not ascend, or a number that is negative or not
    /// finite; [`AssessError::Numeric`] for a damping ratio outside 0.005 … 0.3.
    pub fn table(
        source: impl Into<String>,
        points: Vec<[f64; 2]>,
        damping_ratio: f64,
    ) -> Result<Self, AssessError> {
        checked_damping(damping_ratio)?;
        let rises = |i: usize| i == 0 || points[i][0] > points[i - 1][0];
        let good = |i: usize| points[i].iter().all(|v| *v >= 0.0 && v.is_finite()) && rises(i);
        if let Some(odd) = (0..points.len().max(2)).find(|i| *i >= points.len() || !good(*i)) {
            return Err(AssessError::SpectrumTable { row: odd + 1 });
        }
        Ok(DesignSpectrum {
            source: source.into(),
            vertical: None,
            unverified: Vec::new(),
            shape: Shape::Table {
                points,
                damping_ratio,
            },
        })
    }

    /// Effective peak ground acceleration, m/s², including the site soil: the spectrum at T = 0. `None` for a table that does
    /// not begin at T = 0.
    pub fn ground_acceleration_m_s2(&self) -> Option<f64> {
        match &self.shape {
            Shape::Branches(branches) => Some(branches.ground_m_s2),
            Shape::Table { points, .. } => (points[0][0] == 0.0).then_some(points[0][1]),
        }
    }

    /// Ends of the branches; `None` for a table.
    pub fn branches(&self) -> Option<SpectrumBranches> {
        match &self.shape {
            Shape::Branches(branches) => Some(SpectrumBranches {
                ground_m_s2: branches.ground_m_s2,
                plateau_m_s2: branches.plateau_m_s2,
                rise_s: branches.rise_s,
                plateau_s: branches.plateau_s,
                displacement_s: branches.displacement_s,
            }),
            Shape::Table { .. } => None,
        }
    }

    /// Periods, s, and accelerations, m/s², of a table; empty for a code.
    pub fn points(&self) -> &[[f64; 2]] {
        match &self.shape {
            Shape::Branches(_) => &[],
            Shape::Table { points, .. } => points,
        }
    }

    /// The shortest period at which the spectrum has its largest value, s: it rises until there.
    pub(super) fn peaks_from_s(&self) -> f64 {
        match &self.shape {
            Shape::Branches(branches) => branches.rise_s,
            Shape::Table { points, .. } => {
                let higher =
                    |peak: [f64; 2], point: &[f64; 2]| if point[1] > peak[1] { *point } else { peak };
                points.iter().fold([0.0, f64::NEG_INFINITY], higher)[0]
            }
        }
    }

    /// The damping ratio of a table, the only one at which it can be read; `None` if the code has a rule for other damping
    /// ratios.
    pub(super) fn table_damping_ratio(&self) -> Option<f64> {
        match &self.shape {
            Shape::Branches(_) => None,
            Shape::Table { damping_ratio, .. } => Some(*damping_ratio),
        }
    }

    /// Spectral acceleration, m/s², at a period and a damping ratio.
    ///
    /// ```text
    /// T ≤ T_0    A_0 → η A_p        T_0 … T_s    η A_p        T_s … T_L    η A_p T_s/T        beyond    η A_p T_s T_L/T²
    /// ```
    ///
    /// # Errors
    /// [`AssessError::Numeric`] for a negative period or a damping ratio outside 0.005 … 0.3; for a table
    /// [`AssessError::OutsideTable`] and [`AssessError::TableDamping`].
    pub fn acceleration_m_s2(&self, period_s: f64, damping_ratio: f64) -> Result<f64, AssessError> {
        within("period_s", period_s, [0.0, f64::MAX], "0 or a positive number")?;
        checked_damping(damping_ratio)?;
        match &self.shape {
            Shape::Branches(branches) => Ok(branches.at(period_s, damping_ratio)),
            Shape::Table {
                points,
                damping_ratio: of_table,
            } => {
                if damping_ratio != *of_table {
                    return Err(AssessError::TableDamping {
                        given: damping_ratio,
                        of_table: *of_table,
                    });
                }
                interpolated(points, period_s)
            }
        }
    }
}

fn checked_damping(damping_ratio: f64) -> Result<f64, AssessError> {
    let range = [DAMPING_LEAST, DAMPING_MOST];
    within(
        "damping_ratio",
        damping_ratio,
        range,
        "0.005 to 0.3 (is it in percent?)",
    )
}

fn interpolated(points: &[[f64; 2]], period_s: f64) -> Result<f64, AssessError> {
    let found = points
        .windows(2)
        .find(|pair| (pair[0][0]..=pair[1][0]).contains(&period_s));
    match found {
        Some([[t0, a0], [t1, a1]]) => Ok(a0 + (a1 - a0) * (period_s - t0) / (t1 - t0)),
        _ => Err(AssessError::OutsideTable {
            period_s,
            least_s: points[0][0],
            most_s: points[points.len() - 1][0],
        }),
    }
}

impl Branches {
    fn at(&self, period_s: f64, damping_ratio: f64) -> f64 {
        let factor = self.damping.at(damping_ratio);
        let plateau = factor * self.plateau_m_s2;
        if period_s < self.rise_s {
            let part = period_s / self.rise_s;
            let line = |to: f64| self.ground_m_s2 + part * (to - self.ground_m_s2);
            match self.damping {
                DampingFactor::Korea => line(self.plateau_m_s2) * (1.0 + part * (factor - 1.0)),
                DampingFactor::Eurocode => line(plateau),
            }
        } else if period_s <= self.plateau_s {
            plateau
        } else {
            let beyond = (self.displacement_s / period_s).min(1.0);
            plateau * self.plateau_s / period_s * beyond
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_a_table_is_straight_between_its_points() {
        let points = vec![[0.0, 2.0], [0.1, 5.0], [1.0, 0.5]];
        let table = DesignSpectrum::table("site study", points, 0.05).unwrap();
        assert_eq!(table.ground_acceleration_m_s2(), Some(2.0));
        assert_eq!(table.acceleration_m_s2(0.05, 0.05).unwrap(), 3.5);
        assert!((table.acceleration_m_s2(0.55, 0.05).unwrap() - 2.75).abs() < 1e-14);
        assert_eq!(table.acceleration_m_s2(1.0, 0.05).unwrap(), 0.5);
        let say = |t, z| table.acceleration_m_s2(t, z).unwrap_err().to_string();
        assert_eq!(
            say(1.1, 0.05),
            "a period of 1.1 s is outside the table, 0 to 1 s: extend it"
        );
        assert!(say(0.5, 0.02).contains("damping_ratio is 0.02, but the table holds for 0.05"));
    }

    #[test]
    fn refuses_tables_and_numbers_that_make_no_sense() {
        let say = |points: Vec<[f64; 2]>| DesignSpectrum::table("t", points, 0.05).unwrap_err().to_string();
        let wanted = |row| {
            format!(
                "row {row} of the spectrum is missing or refused: give 2 or more rows of period_s, rising, and \
             acceleration_m_s2, none negative"
            )
        };
        assert_eq!(say(vec![]), wanted(1));
        assert_eq!(say(vec![[0.0, 1.0]]), wanted(2));
        assert_eq!(say(vec![[0.0, 1.0], [0.1, -1.0]]), wanted(2));
        assert_eq!(say(vec![[0.1, 1.0], [0.1, 1.0]]), wanted(2));
        assert_eq!(say(vec![[f64::NAN, 1.0], [0.1, 1.0]]), wanted(1));
        let table = DesignSpectrum::table("t", vec![[0.0, 1.0], [1.0, 1.0]], 0.05).unwrap();
        assert!(
            table.acceleration_m_s2(f64::NAN, 0.05).is_err() && table.acceleration_m_s2(-1.0, 0.05).is_err()
        );
        let percent = table.acceleration_m_s2(0.5, 5.0).unwrap_err().to_string();
        assert_eq!(
            percent,
            "damping_ratio is 5, but must be 0.005 to 0.3 (is it in percent?)"
        );
    }
}
