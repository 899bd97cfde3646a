//! Korea: KDS 17 10 00 (2018), general seismic design, and S_DS and S_D1 of KDS 41 17 00 (2019), buildings.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | Z, I | `zone`, `return_period_years` | zone factor, risk factor of the return period | g, – |
//! | S | `effective_acceleration_g` | Z I, on rock | g |
//! | F_a, F_v | `amplification` | soil amplification at short periods and at 1 s | – |

use super::spectrum::{Branches, DampingFactor, STANDARD_GRAVITY_M_S2, Shape, within};
use super::{DesignSpectrum, Unverified, VerticalRatio};
use crate::assess::AssessError;

/// Year of the edition of KDS 17 10 00, quoted from memory and not compared with its text.
const YEAR_17: u16 = 2018;
/// Year of the edition of KDS 41 17 00, quoted from memory and not compared with its text.
const YEAR_41: u16 = 2019;
/// The return period whose risk factor is quoted from memory and not compared with the text of the code.
const UNVERIFIED_YEARS: u32 = 4800;
/// T_L of KDS 41 17 00, s, quoted from memory and not compared with the text of the code.
const DISPLACEMENT_41_S: f64 = 5.0;
/// Ratio of the design spectrum of KDS 41 17 00 to the spectrum of 2400 years.
const DESIGN_SHARE: f64 = 2.0 / 3.0;
/// Return periods, years, with their risk factor I. That of 4800 years is not verified, see [`kds_17_effective_acceleration_g`].
const RISK_FACTORS: [(u32, f64); 7] = [
    (50, 0.40),
    (100, 0.57),
    (200, 0.73),
    (500, 1.0),
    (1000, 1.4),
    (2400, 2.0),
    (4800, 2.6),
];
/// S, g, of the three columns of the soil table.
const COLUMNS_G: [f64; 3] = [0.1, 0.2, 0.3];
/// F_a and F_v of S1 to S5.
const AMPLIFICATION: [[[f64; 3]; 2]; 5] = [
    [[1.12, 1.12, 1.12], [0.84, 0.84, 0.84]],
    [[1.4, 1.4, 1.3], [1.5, 1.4, 1.3]],
    [[1.7, 1.5, 1.3], [1.7, 1.6, 1.5]],
    [[1.6, 1.4, 1.2], [2.2, 2.0, 1.8]],
    [[1.8, 1.3, 1.3], [3.0, 2.7, 2.4]],
];
/// Plateau over S F_a.
const PLATEAU: f64 = 2.5;
/// T_0 over T_s, and T_L, s.
const RISE: f64 = 0.2;
const DISPLACEMENT_S: f64 = 3.0;
/// Vertical over horizontal peak, quoted from memory and not compared with the text of the code.
const VERTICAL: VerticalRatio = VerticalRatio {
    ratio: 0.77,
    verified: false,
};

/// Seismic zone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KoreanZone {
    /// Z = 0.11 g.
    I,
    /// Z = 0.07 g.
    II,
}

/// Site class by soil.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KoreanSite {
    /// Rock.
    S1,
    /// Shallow and stiff.
    S2,
    /// Shallow and soft.
    S3,
    /// Deep and stiff.
    S4,
    /// Deep and soft.
    S5,
    /// Needs a study of the site: refused.
    S6,
}

/// The two design accelerations for buildings of KDS 41 17 00.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kds41 {
    /// S_DS, g, at short periods.
    pub short_period_g: f64,
    /// S_D1, g, at 1 s.
    pub one_second_g: f64,
}

/// Effective ground acceleration on rock, S = Z I, in g.
///
/// # Errors
/// [`AssessError::ReturnPeriod`] unless 50, 100, 200, 500, 1000, 2400 or 4800 years.
///
/// # Limits
/// The factor 2.6 of 4800 years was not compared with the text of the code.
///
/// # Source
/// KDS 17 10 00:2018, zone and risk factors.
///
/// # Example
/// ```
/// use dolmen::assess::demand::{KoreanZone, kds_17_effective_acceleration_g};
/// assert_eq!(kds_17_effective_acceleration_g(KoreanZone::I, 2400)?, 0.22);
/// # Ok::<(), dolmen::assess::AssessError>(())
/// ```
pub fn kds_17_effective_acceleration_g(
    zone: KoreanZone,
    return_period_years: u32,
) -> Result<f64, AssessError> {
    Ok(zone.factor_g() * kds_17_risk_factor(return_period_years)?.factor)
}

/// Risk factor of a return period.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RiskFactor {
    /// I.
    pub factor: f64,
    /// Whether the factor was compared with the text of the code.
    pub verified: bool,
}

/// Risk factor I of a return period.
///
/// # Errors
/// [`AssessError::ReturnPeriod`] unless 50, 100, 200, 500, 1000, 2400 or 4800 years.
///
/// # Source
/// KDS 17 10 00:2018, risk factors; that of 4800 years is unverified.
pub fn kds_17_risk_factor(return_period_years: u32) -> Result<RiskFactor, AssessError> {
    let found = RISK_FACTORS
        .iter()
        .find(|(years, _)| *years == return_period_years);
    let (years, factor) = found.ok_or(AssessError::ReturnPeriod {
        given: return_period_years,
    })?;
    Ok(RiskFactor {
        factor: *factor,
        verified: *years != UNVERIFIED_YEARS,
    })
}

impl KoreanZone {
    /// Z, g.
    pub fn factor_g(self) -> f64 {
        match self {
            KoreanZone::I => 0.11,
            KoreanZone::II => 0.07,
        }
    }
}

/// Amplification by the soil, at short periods and at 1 s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoilAmplification {
    /// F_a.
    pub short_periods: f64,
    /// F_v.
    pub one_second: f64,
}

/// F_a and F_v of a site class at an effective ground acceleration S, in g, by linear interpolation in S.
///
/// # Errors
/// As [`kds_17`].
///
/// # Source
/// KDS 17 10 00:2018.
pub fn kds_17_amplification(
    effective_acceleration_g: f64,
    site: KoreanSite,
) -> Result<SoilAmplification, AssessError> {
    let [short_periods, one_second] = amplification(site, effective_acceleration_g)?;
    Ok(SoilAmplification {
        short_periods,
        one_second,
    })
}

/// F_a and F_v by linear interpolation in S; constant below the first column.
fn amplification(site: KoreanSite, effective_acceleration_g: f64) -> Result<[f64; 2], AssessError> {
    let row = AMPLIFICATION
        .get(site as usize)
        .ok_or(AssessError::SiteSpecific)?;
    let s = within(
        "effective_acceleration_g",
        effective_acceleration_g,
        [f64::MIN_POSITIVE, COLUMNS_G[2]],
        "above 0 and at most 0.3, where the table of soils ends: is it in g?",
    )?;
    let column = usize::from(s > COLUMNS_G[1]);
    let part = ((s - COLUMNS_G[column]) / (COLUMNS_G[column + 1] - COLUMNS_G[column])).max(0.0);
    Ok(row.map(|f| f[column] + part * (f[column + 1] - f[column])))
}

/// Design spectrum of KDS 17 10 00 for an effective ground acceleration S, in g, and a site class.
///
/// ```text
/// S1          A_0 = S        A_p = 2.8 S          T_s = 0.3 s
/// S2 … S5     A_0 = F_a S    A_p = 2.5 F_a S      T_s = F_v/(2.5 F_a)        T_0 = 0.2 T_s    T_L = 3 s
/// η = (6.42/(1.42 + ξ))^0.48, ξ in percent
/// ```
/// F_a and F_v are interpolated in S, not in Z.
///
/// # Errors
/// [`AssessError::SiteSpecific`] for S6; [`AssessError::Numeric`] for S outside 0 … 0.3 g.
///
/// # Limits
/// The vertical ratio 0.77, and the linear variation of η from 1 at T = 0 to its value at T_0, were not compared with the text
/// of the code.
///
/// # Source
/// KDS 17 10 00:2018.
///
/// # Example
/// ```
/// use dolmen::assess::demand::{KoreanSite, kds_17};
/// let spectrum = kds_17(0.22, KoreanSite::S4)?;
/// assert!((spectrum.acceleration_m_s2(0.3, 0.05)? / 9.80665 - 2.5 * 1.36 * 0.22).abs() < 1e-12);
/// # Ok::<(), dolmen::assess::AssessError>(())
/// ```
pub fn kds_17(effective_acceleration_g: f64, site: KoreanSite) -> Result<DesignSpectrum, AssessError> {
    let [fa, fv] = amplification(site, effective_acceleration_g)?;
    let s = STANDARD_GRAVITY_M_S2 * effective_acceleration_g;
    let plateau_s = fv / (PLATEAU * fa);
    Ok(DesignSpectrum {
        source: format!(
            "KDS 17 10 00:{YEAR_17}, S = {} g, {site:?}",
            in_words(effective_acceleration_g)
        ),
        vertical: Some(VERTICAL),
        unverified: vec![
            Unverified::Edition { year: YEAR_17 },
            Unverified::VerticalRatio {
                ratio: VERTICAL.ratio,
            },
            Unverified::DampingAtShortPeriods,
        ],
        shape: Shape::Branches(Branches {
            ground_m_s2: if site == KoreanSite::S1 { s } else { fa * s },
            plateau_m_s2: PLATEAU * fa * s,
            rise_s: RISE * plateau_s,
            plateau_s,
            displacement_s: DISPLACEMENT_S,
            damping: DampingFactor::Korea,
        }),
    })
}

/// S rounded to nine decimals, so that a product prints as 0.077 and not as 0.07700000000000001.
fn in_words(acceleration_g: f64) -> f64 {
    (acceleration_g * 1e9).round() / 1e9
}

/// Design spectrum of KDS 41 17 00, buildings: two thirds of [`kds_17`] with S of 2400 years, except that T_L = 5 s.
///
/// ```text
/// A_0 = 0.4 S_DS        A_p = S_DS        T_s = S_D1/S_DS        T_0 = 0.2 T_s        T_L = 5 s
/// ```
///
/// # Errors
/// As [`kds_17`].
///
/// # Limits
/// Only S_DS and S_D1 were compared with the text of the code; the shape, T_L and the damping factor are quoted from memory.
///
/// # Source
/// KDS 41 17 00:2019.
pub fn kds_41_spectrum(
    effective_acceleration_g: f64,
    site: KoreanSite,
) -> Result<DesignSpectrum, AssessError> {
    let design = kds_41(effective_acceleration_g, site)?;
    let plateau_s = design.one_second_g / design.short_period_g;
    let plateau_m_s2 = STANDARD_GRAVITY_M_S2 * design.short_period_g;
    Ok(DesignSpectrum {
        source: format!(
            "KDS 41 17 00:{YEAR_41}, S = {} g, {site:?}",
            in_words(effective_acceleration_g)
        ),
        vertical: Some(VERTICAL),
        unverified: vec![
            Unverified::Edition { year: YEAR_41 },
            Unverified::Shape,
            Unverified::LongPeriods {
                displacement_s: DISPLACEMENT_41_S,
            },
            Unverified::VerticalRatio {
                ratio: VERTICAL.ratio,
            },
            Unverified::DampingFactor,
        ],
        shape: Shape::Branches(Branches {
            ground_m_s2: plateau_m_s2 / PLATEAU,
            plateau_m_s2,
            rise_s: RISE * plateau_s,
            plateau_s,
            displacement_s: DISPLACEMENT_41_S,
            damping: DampingFactor::Korea,
        }),
    })
}

/// S_DS = ⅔ · 2.5 S F_a and S_D1 = ⅔ S F_v, in g, with S of 2400 years.
///
/// # Errors
/// As [`kds_17`].
///
/// # Source
/// KDS 41 17 00:2019.
pub fn kds_41(effective_acceleration_g: f64, site: KoreanSite) -> Result<Kds41, AssessError> {
    let [fa, fv] = amplification(site, effective_acceleration_g)?;
    Ok(Kds41 {
        short_period_g: DESIGN_SHARE * PLATEAU * effective_acceleration_g * fa,
        one_second_g: DESIGN_SHARE * effective_acceleration_g * fv,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const G: f64 = STANDARD_GRAVITY_M_S2;

    #[test]
    fn published_s4_of_zone_one_in_2400_years() {
        let s = kds_17_effective_acceleration_g(KoreanZone::I, 2400).unwrap();
        let [fa, fv] = amplification(KoreanSite::S4, s).unwrap();
        assert!(
            (fa - 1.36).abs() < 1e-12 && (fv - 1.96).abs() < 1e-12,
            "{fa} {fv}"
        );
        let design = kds_41(s, KoreanSite::S4).unwrap();
        assert!((design.short_period_g - 0.498667).abs() < 0.5e-6);
        assert!((design.one_second_g - 0.287467).abs() < 0.5e-6);
        let spectrum = kds_17(s, KoreanSite::S4).unwrap();
        let at = |t| spectrum.acceleration_m_s2(t, 0.05).unwrap() / G;
        let (plateau, ts) = (2.5 * 1.36 * 0.22, 0.57647);
        assert!((spectrum.ground_acceleration_m_s2().unwrap() / G - 1.36 * 0.22).abs() < 1e-12);
        assert!((at(ts) - plateau).abs() < 1e-12 && at(ts + 1e-4) < plateau);
        assert!((at(0.2 * ts) / plateau - 1.0).abs() < 1e-4);
        assert!((at(1.0) - 1.96 * 0.22).abs() < 1e-12);
        assert!((at(6.0) - 1.96 * 0.22 * 3.0 / 36.0).abs() < 1e-12);
    }

    #[test]
    fn exact_the_spectrum_of_buildings_is_two_thirds_of_the_general_one() {
        for site in [KoreanSite::S2, KoreanSite::S3, KoreanSite::S4, KoreanSite::S5] {
            let (general, buildings) = (kds_17(0.22, site).unwrap(), kds_41_spectrum(0.22, site).unwrap());
            for t in [0.0, 0.05, 0.3, 0.6, 1.0, 2.9] {
                let of = |spectrum: &DesignSpectrum| spectrum.acceleration_m_s2(t, 0.05).unwrap();
                let ratio = of(&buildings) / of(&general);
                assert!((ratio - 2.0 / 3.0).abs() < 1e-12, "{site:?} {t}: {ratio}");
            }
        }
        // rock: the same plateau of 2.8 S to 0.3 s; at T = 0 the general code has S, the building code 0.4 S_DS
        let rock = kds_41_spectrum(0.22, KoreanSite::S1).unwrap();
        let at = |t| rock.acceleration_m_s2(t, 0.05).unwrap() / (0.22 * G);
        for (t, wanted) in [(0.0, 1.12), (0.06, 2.8), (0.3, 2.8), (0.6, 1.4)] {
            assert!((at(t) * 1.5 - wanted).abs() < 1e-12, "{t}: {}", at(t));
        }
    }

    #[test]
    fn holds_what_is_not_verified_is_marked() {
        let risk = |years| kds_17_risk_factor(years).unwrap();
        assert!(risk(2400).verified && risk(2400).factor == 2.0);
        assert!(!risk(4800).verified && risk(4800).factor == 2.6);
        let spectrum = kds_17(0.11, KoreanSite::S2).unwrap();
        assert!(!spectrum.vertical.unwrap().verified);
        let said: Vec<String> = spectrum.unverified.iter().map(ToString::to_string).collect();
        let wanted = [
            "the year 2018 of the edition",
            "the vertical ratio 0.77",
            "the factor of damping between T = 0 and T_0",
        ];
        assert_eq!(said, wanted);
        let buildings = kds_41_spectrum(0.07 * 1.1, KoreanSite::S2).unwrap();
        assert_eq!(buildings.source, "KDS 41 17 00:2019, S = 0.077 g, S2");
        let long = kds_17(0.11 * 2.6, KoreanSite::S5).unwrap();
        assert_eq!(long.source, "KDS 17 10 00:2018, S = 0.286 g, S5");
        assert!(buildings.unverified.contains(&Unverified::Shape));
    }

    #[test]
    fn published_rock_and_damping() {
        let rock = kds_17(0.11, KoreanSite::S1).unwrap();
        let at = |t, zeta| rock.acceleration_m_s2(t, zeta).unwrap() / (0.11 * G);
        for (t, wanted) in [
            (0.0, 1.0),
            (0.03, 1.9),
            (0.06, 2.8),
            (0.3, 2.8),
            (0.6, 1.4),
            (3.0, 0.28),
            (6.0, 0.07),
        ] {
            assert!((at(t, 0.05) - wanted).abs() < 1e-12, "{t}: {}", at(t, 0.05));
        }
        assert!((at(0.2, 0.02) / 2.8 - (6.42_f64 / 3.42).powf(0.48)).abs() < 1e-12);
        assert_eq!(at(0.0, 0.02), 1.0);
    }

    #[test]
    fn published_factors_below_and_between_the_columns() {
        let of = |site, s| amplification(site, s).unwrap();
        assert_eq!(of(KoreanSite::S5, 0.028), [1.8, 3.0]);
        assert_eq!(of(KoreanSite::S3, 0.2), [1.5, 1.6]);
        let [fa, fv] = of(KoreanSite::S5, 0.154);
        assert!((fa - 1.53).abs() < 1e-12 && (fv - 2.838).abs() < 1e-12);
        assert_eq!(of(KoreanSite::S2, 0.3), [1.3, 1.3]);
    }

    #[test]
    fn published_every_factor_of_soil_risk_and_zone() {
        use KoreanSite::{S1, S2, S3, S4, S5};
        // F_a at S ≤ .1, .2, .3, then F_v, in the order of the code
        let table = "1.12 1.12 1.12 .84 .84 .84; 1.4 1.4 1.3 1.5 1.4 1.3; 1.7 1.5 1.3 1.7 1.6 1.5; \
                     1.6 1.4 1.2 2.2 2.0 1.8; 1.8 1.3 1.3 3.0 2.7 2.4";
        for (site, row) in [S1, S2, S3, S4, S5].into_iter().zip(table.split(';')) {
            let cells: Vec<f64> = row.split_whitespace().map(|cell| cell.parse().unwrap()).collect();
            for (column, s) in [0.1, 0.2, 0.3].into_iter().enumerate() {
                let found = kds_17_amplification(s, site).unwrap();
                let off = [
                    found.short_periods - cells[column],
                    found.one_second - cells[column + 3],
                ];
                assert!(off.iter().all(|off| off.abs() < 1e-12), "{site:?} {s}: {found:?}");
            }
        }
        let factors = [
            (50, 0.40),
            (100, 0.57),
            (200, 0.73),
            (500, 1.0),
            (1000, 1.4),
            (2400, 2.0),
            (4800, 2.6),
        ];
        for (years, factor) in factors {
            for (zone, z) in [(KoreanZone::I, 0.11), (KoreanZone::II, 0.07)] {
                let s = kds_17_effective_acceleration_g(zone, years).unwrap();
                assert!((s - z * factor).abs() < 1e-15, "{zone:?} {years}: {s}");
            }
        }
        // ends of the branches: on soil by its factors, for buildings T_L = 5 s; vertical peak .77
        let soil = kds_17(0.2, S2).unwrap();
        let ends = soil.branches().unwrap();
        let plateau_s = 1.4 / (2.5 * 1.4);
        assert!((ends.plateau_s - plateau_s).abs() < 1e-15 && (ends.rise_s - 0.2 * plateau_s).abs() < 1e-15);
        assert_eq!(ends.displacement_s, 3.0);
        assert_eq!(
            kds_41_spectrum(0.2, S2)
                .unwrap()
                .branches()
                .unwrap()
                .displacement_s,
            5.0
        );
        assert_eq!(soil.vertical.unwrap().ratio, 0.77);
    }

    #[test]
    fn refuses_s6_percent_and_other_return_periods() {
        let say = |refused: Result<DesignSpectrum, AssessError>| refused.unwrap_err().to_string();
        assert!(say(kds_17(0.11, KoreanSite::S6)).contains("site-specific"));
        for s in [0.0, -0.1, 0.31, 11.0, f64::NAN] {
            assert!(say(kds_17(s, KoreanSite::S2)).contains("at most 0.3"));
        }
        let years = kds_17_effective_acceleration_g(KoreanZone::II, 475)
            .unwrap_err()
            .to_string();
        assert_eq!(
            years,
            "return_period_years is 475, but the code has 50, 100, 200, 500, 1000, 2400 and 4800: take the next longer, for 2475 years 2400"
        );
    }
}
