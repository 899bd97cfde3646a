//! Seismic demand at a site, by a code or from a table, with all intermediate values.

use super::spectrum::{STANDARD_GRAVITY_M_S2, within};
use super::{
    DesignSpectrum, EurocodeGround, EurocodeType, Kds41, KoreanSite, SoilAmplification, SpectrumBranches,
    Unverified, VerticalRatio, eurocode_8, kds_17, kds_17_amplification, kds_17_risk_factor, kds_41,
    kds_41_spectrum,
};
use crate::assess::AssessError;

/// Return period of KDS 41 17 00, years.
const BUILDINGS_YEARS: u32 = 2400;
/// Damping ratio of the plateaus of codes.
const CODE_DAMPING: f64 = 0.05;
/// Largest accepted importance factor. Our choice: codes have 0.8 to 1.4.
const IMPORTANCE_MOST: f64 = 3.0;

/// Location of a structure and code for its assessment.
#[derive(Clone, Debug, PartialEq)]
pub enum Site {
    /// KDS 17 10 00: S = Z I.
    Kds17 {
        /// Zone factor Z, g.
        zone_factor_g: f64,
        /// Return period, years.
        return_period_years: u32,
        /// Site class.
        soil: KoreanSite,
    },
    /// KDS 41 17 00, buildings: two thirds of the acceleration for 2400 years.
    Kds41 {
        /// Zone factor Z, g.
        zone_factor_g: f64,
        /// Site class.
        soil: KoreanSite,
    },
    /// EN 1998-1: a_g = γ_I a_gR.
    Eurocode8 {
        /// Reference ground acceleration on type A, a_gR, g.
        ground_acceleration_g: f64,
        /// Importance factor γ_I.
        importance_factor: f64,
        /// Type of the spectrum.
        spectrum: EurocodeType,
        /// Ground type.
        ground: EurocodeGround,
    },
    /// A spectrum given as a table.
    Table {
        /// Name and author of the spectrum.
        source: String,
        /// Ascending periods, s, and accelerations, m/s².
        points: Vec<[f64; 2]>,
        /// Damping ratio of the table.
        damping_ratio: f64,
        /// Peak ground acceleration, m/s²; `None`: that of the table at T = 0.
        peak_ground_acceleration_m_s2: Option<f64>,
    },
}

/// All intermediate values between a site and its spectrum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SiteParameters {
    /// By the Korean codes.
    Korea {
        /// Zone factor Z, g.
        zone_factor_g: f64,
        /// Return period, years.
        return_period_years: u32,
        /// Risk factor I.
        risk_factor: f64,
        /// S = Z I, g.
        effective_acceleration_g: f64,
        /// Site class.
        soil: KoreanSite,
        /// Amplification factors F_a and F_v.
        amplification: SoilAmplification,
        /// S_DS and S_D1 by KDS 41 17 00 for this S; `None` if the return period is not 2400 years.
        design: Option<Kds41>,
        /// T_0, T_s, T_L and the accelerations between these periods.
        branches: SpectrumBranches,
    },
    /// By Eurocode 8.
    Eurocode {
        /// Reference ground acceleration a_gR, g.
        ground_acceleration_g: f64,
        /// Importance factor γ_I.
        importance_factor: f64,
        /// Type of the spectrum.
        spectrum: EurocodeType,
        /// Ground type.
        ground: EurocodeGround,
        /// Soil factor S.
        soil_factor: f64,
        /// T_B, T_C, T_D and the accelerations between these periods.
        branches: SpectrumBranches,
    },
    /// From a table.
    Table {
        /// Number of rows.
        rows: usize,
        /// First period, s.
        least_s: f64,
        /// Last period, s.
        most_s: f64,
    },
}

/// Seismic demand at a site.
#[derive(Clone, Debug, PartialEq)]
pub struct SiteDemand {
    /// The intermediate values.
    pub parameters: SiteParameters,
    /// The design spectrum.
    pub spectrum: DesignSpectrum,
    /// Damping ratio ζ of the demand.
    pub damping_ratio: f64,
    /// Peak horizontal ground acceleration, including the site soil, m/s²; `None` for a table without it.
    pub peak_ground_acceleration_m_s2: Option<f64>,
    /// Vertical over horizontal acceleration. `None` if neither code nor user gives it: the demand then has no vertical shaking.
    pub vertical: Option<VerticalRatio>,
}

impl SiteDemand {
    /// Name of the code without its edition and numbers; for a table, its source.
    pub fn code(&self) -> &str {
        let source = &self.spectrum.source;
        match self.parameters {
            SiteParameters::Table { .. } => source,
            SiteParameters::Korea { .. } | SiteParameters::Eurocode { .. } => {
                source.split_once(':').map_or(source, |(code, _)| code)
            }
        }
    }

    /// Damping ratio at which the spectrum is read for a structure: its own damping ratio if it has one, otherwise that of the site. A table
    /// refuses any ratio but its own.
    pub fn damping_ratio_of(&self, own: Option<f64>) -> f64 {
        own.unwrap_or(self.damping_ratio)
    }

    /// The selected return period, years; `None` if the code has one or no return period.
    pub fn return_period_years(&self) -> Option<u32> {
        match self.parameters {
            SiteParameters::Korea {
                return_period_years,
                design: None,
                ..
            } => Some(return_period_years),
            SiteParameters::Korea {
                return_period_years, ..
            } if self.code().starts_with("KDS 17") => Some(return_period_years),
            _ => None,
        }
    }
}

/// Seismic demand at a site, with all intermediate values.
///
/// `vertical_ratio` replaces the value of the code. It counts as verified, because its author is responsible for it.
///
/// # Errors
/// [`AssessError`] for numbers out of their range; [`AssessError::SiteSpecific`] for soil S6.
///
/// # Example
/// ```
/// use dolmen::assess::demand::{site_demand, KoreanSite, Site, SiteParameters};
/// let site = Site::Kds17 { zone_factor_g: 0.11, return_period_years: 2400, soil: KoreanSite::S4 };
/// let demand = site_demand(&site, 0.05, None)?;
/// let SiteParameters::Korea { amplification, branches, .. } = demand.parameters else { unreachable!() };
/// assert!((amplification.short_periods - 1.36).abs() < 1e-12);
/// assert!((amplification.one_second - 1.96).abs() < 1e-12);
/// assert!((branches.plateau_s - 0.57647).abs() < 5e-6);
/// # Ok::<(), dolmen::assess::AssessError>(())
/// ```
pub fn site_demand(
    site: &Site,
    damping_ratio: f64,
    vertical_ratio: Option<f64>,
) -> Result<SiteDemand, AssessError> {
    let (parameters, mut spectrum) = match site {
        Site::Kds17 {
            zone_factor_g,
            return_period_years,
            soil,
        } => korea(*zone_factor_g, *return_period_years, *soil, kds_17)?,
        Site::Kds41 { zone_factor_g, soil } => {
            korea(*zone_factor_g, BUILDINGS_YEARS, *soil, kds_41_spectrum)?
        }
        Site::Eurocode8 {
            ground_acceleration_g,
            importance_factor,
            spectrum,
            ground,
        } => eurocode(*ground_acceleration_g, *importance_factor, *spectrum, *ground)?,
        Site::Table {
            source,
            points,
            damping_ratio,
            ..
        } => {
            let spectrum = DesignSpectrum::table(source.clone(), points.clone(), *damping_ratio)?;
            let [least_s, most_s] = [spectrum.points().first(), spectrum.points().last()]
                .map(|point| point.map_or(f64::NAN, |point| point[0]));
            let rows = points.len();
            let parameters = SiteParameters::Table {
                rows,
                least_s,
                most_s,
            };
            (parameters, spectrum)
        }
    };
    let peak_ground_acceleration_m_s2 = match site {
        Site::Table {
            peak_ground_acceleration_m_s2: Some(peak),
            ..
        } => Some(within(
            "peak_ground_acceleration_m_s2",
            *peak,
            [0.0, f64::MAX],
            "0 or a positive number",
        )?),
        _ => spectrum.ground_acceleration_m_s2(),
    };
    spectrum.acceleration_m_s2(spectrum.points().first().map_or(0.0, |p| p[0]), damping_ratio)?;
    if damping_ratio == CODE_DAMPING {
        spectrum.unverified.retain(|what| {
            !matches!(
                what,
                Unverified::DampingFactor | Unverified::DampingAtShortPeriods
            )
        });
    }
    let vertical = match vertical_ratio {
        Some(given) => {
            let allowed = "0 or a positive number, at most 3";
            let ratio = within("vertical_ratio", given, [0.0, 3.0], allowed)?;
            let is_vertical = |what: &Unverified| matches!(what, Unverified::VerticalRatio { .. });
            spectrum.unverified.retain(|what| !is_vertical(what));
            Some(VerticalRatio {
                ratio,
                verified: true,
            })
        }
        None => spectrum.vertical,
    };
    Ok(SiteDemand {
        parameters,
        spectrum,
        damping_ratio,
        peak_ground_acceleration_m_s2,
        vertical,
    })
}

/// Smallest accepted zone factor. The code permits 80 % of zone II on its map, 0.056 g; a smaller value is a mistake.
const ZONE_FACTOR_LEAST_G: f64 = 0.05;

fn korea(
    zone_factor_g: f64,
    return_period_years: u32,
    soil: KoreanSite,
    code: fn(f64, KoreanSite) -> Result<DesignSpectrum, AssessError>,
) -> Result<(SiteParameters, DesignSpectrum), AssessError> {
    let risk = kds_17_risk_factor(return_period_years)?;
    within(
        "zone_factor_g",
        zone_factor_g,
        [ZONE_FACTOR_LEAST_G, f64::MAX],
        "0.05 or more, in g: the code has 0.11 (zone I) and 0.07 (zone II), its map somewhat less",
    )?;
    let effective_acceleration_g = zone_factor_g * risk.factor;
    let mut spectrum = code(effective_acceleration_g, soil)?;
    if !risk.verified {
        spectrum.unverified.push(Unverified::RiskFactor {
            return_period_years,
            factor: risk.factor,
        });
    }
    let parameters = SiteParameters::Korea {
        zone_factor_g,
        return_period_years,
        risk_factor: risk.factor,
        effective_acceleration_g,
        soil,
        amplification: kds_17_amplification(effective_acceleration_g, soil)?,
        design: match return_period_years {
            BUILDINGS_YEARS => Some(kds_41(effective_acceleration_g, soil)?),
            _ => None,
        },
        branches: branches_of(&spectrum),
    };
    Ok((parameters, spectrum))
}

fn eurocode(
    ground_acceleration_g: f64,
    importance_factor: f64,
    kind: EurocodeType,
    ground: EurocodeGround,
) -> Result<(SiteParameters, DesignSpectrum), AssessError> {
    let importance_factor = within(
        "importance_factor",
        importance_factor,
        [f64::MIN_POSITIVE, IMPORTANCE_MOST],
        "above 0 and at most 3",
    )?;
    let spectrum = eurocode_8(importance_factor * ground_acceleration_g, kind, ground)?;
    let branches = branches_of(&spectrum);
    let on_rock_m_s2 = STANDARD_GRAVITY_M_S2 * importance_factor * ground_acceleration_g;
    let parameters = SiteParameters::Eurocode {
        ground_acceleration_g,
        importance_factor,
        spectrum: kind,
        ground,
        soil_factor: branches.ground_m_s2 / on_rock_m_s2,
        branches,
    };
    Ok((parameters, spectrum))
}

/// The branches of a code's spectrum. A table has no branches, and this function is not called for it.
fn branches_of(spectrum: &DesignSpectrum) -> SpectrumBranches {
    spectrum.branches().unwrap_or(SpectrumBranches {
        ground_m_s2: f64::NAN,
        plateau_m_s2: f64::NAN,
        rise_s: f64::NAN,
        plateau_s: f64::NAN,
        displacement_s: f64::NAN,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const KOREAN: Site = Site::Kds17 {
        zone_factor_g: 0.11,
        return_period_years: 2400,
        soil: KoreanSite::S4,
    };

    #[test]
    fn published_every_number_of_zone_one_2400_years_s4() {
        let demand = site_demand(&KOREAN, 0.05, None).unwrap();
        let SiteParameters::Korea {
            risk_factor,
            effective_acceleration_g,
            amplification,
            design,
            branches,
            ..
        } = demand.parameters
        else {
            panic!()
        };
        assert_eq!((risk_factor, effective_acceleration_g), (2.0, 0.22));
        let design = design.unwrap();
        let close = |value: f64, known: f64, within: f64| assert!((value - known).abs() < within, "{value}");
        close(amplification.short_periods, 1.36, 1e-12);
        close(amplification.one_second, 1.96, 1e-12);
        close(branches.plateau_s, 0.57647, 5e-6);
        close(branches.rise_s, 0.2 * 0.57647, 1e-6);
        close(design.short_period_g, 0.498667, 0.5e-6);
        close(design.one_second_g, 0.287467, 0.5e-6);
        close(
            demand.peak_ground_acceleration_m_s2.unwrap(),
            1.36 * 0.22 * 9.80665,
            1e-12,
        );
        assert_eq!(demand.vertical, demand.spectrum.vertical);
        // at 5 % no result depends on the damping factors
        assert_eq!(demand.spectrum.unverified.len(), 2);
        assert_eq!(
            site_demand(&KOREAN, 0.02, None)
                .unwrap()
                .spectrum
                .unverified
                .len(),
            3
        );
    }

    #[test]
    fn holds_a_given_vertical_ratio_takes_the_place_of_the_unverified_one() {
        let demand = site_demand(&KOREAN, 0.05, Some(0.6)).unwrap();
        assert_eq!(
            demand.vertical,
            Some(VerticalRatio {
                ratio: 0.6,
                verified: true
            })
        );
        let edition = Unverified::Edition { year: 2018 };
        assert_eq!(demand.spectrum.unverified, [edition]);
        assert!(site_demand(&KOREAN, 0.05, Some(-0.1)).is_err());
        assert!(
            site_demand(&KOREAN, 0.05, Some(3.0)).is_ok() && site_demand(&KOREAN, 0.05, Some(3.001)).is_err()
        );
    }

    #[test]
    fn holds_4800_years_say_that_they_are_unverified() {
        let site = Site::Kds17 {
            zone_factor_g: 0.11,
            return_period_years: 4800,
            soil: KoreanSite::S2,
        };
        let demand = site_demand(&site, 0.05, None).unwrap();
        let said: Vec<String> = demand
            .spectrum
            .unverified
            .iter()
            .map(ToString::to_string)
            .collect();
        let SiteParameters::Korea { design, .. } = demand.parameters else {
            panic!()
        };
        assert_eq!(design, None, "KDS 41 17 00 is for 2400 years");
        assert!(
            said.contains(&"the risk factor 2.6 of 4800 years".to_owned()),
            "{said:?}"
        );
    }

    #[test]
    fn exact_eurocode_counts_importance_and_soil() {
        let site = Site::Eurocode8 {
            ground_acceleration_g: 0.2,
            importance_factor: 1.4,
            spectrum: EurocodeType::One,
            ground: EurocodeGround::C,
        };
        let demand = site_demand(&site, 0.05, None).unwrap();
        let peak_g = demand.peak_ground_acceleration_m_s2.unwrap() / 9.80665;
        assert!((peak_g - 1.15 * 0.28).abs() < 1e-12);
        let SiteParameters::Eurocode { soil_factor, .. } = demand.parameters else {
            panic!()
        };
        assert!((soil_factor - 1.15).abs() < 1e-12);
        let of = |importance_factor| {
            let site = Site::Eurocode8 {
                ground_acceleration_g: 0.2,
                importance_factor,
                spectrum: EurocodeType::One,
                ground: EurocodeGround::C,
            };
            site_demand(&site, 0.05, None)
        };
        assert!(of(3.0).is_ok() && of(3.001).is_err() && of(0.0).is_err());
    }

    #[test]
    fn exact_a_table_takes_its_own_peak_or_that_at_zero() {
        let site = |first: f64, peak: Option<f64>| Site::Table {
            source: "study".into(),
            points: vec![[first, 2.0], [1.0, 1.0]],
            damping_ratio: 0.05,
            peak_ground_acceleration_m_s2: peak,
        };
        let peak = |site| {
            site_demand(&site, 0.05, None)
                .unwrap()
                .peak_ground_acceleration_m_s2
        };
        assert_eq!(peak(site(0.0, None)), Some(2.0));
        assert_eq!(peak(site(0.0, Some(2.2))), Some(2.2));
        assert_eq!(peak(site(0.1, None)), None);
        assert!(
            site_demand(&site(0.0, None), 0.02, None)
                .unwrap_err()
                .to_string()
                .contains("holds for 0.05")
        );
    }
}
