//! Demand spectra for motions, and the periods of a match.

use super::error::MotionRequestError;
use crate::error::WorkError;
use dolmen::assess::demand::{
    DesignSpectrum, EurocodeGround, EurocodeType, KoreanSite, KoreanZone, eurocode_8, kds_17,
    kds_17_effective_acceleration_g,
};

/// A demand spectrum: of Eurocode 8 if it has a ground acceleration, otherwise of KDS 17 10 00.
#[derive(Clone, Debug, PartialEq)]
pub struct Demand {
    /// S1 to S5 (KDS), A to E (Eurocode 8), upper or lower case.
    pub site: String,
    /// Seismic zone of KDS 17 10 00, 1 or 2.
    pub zone: u8,
    /// Return period of KDS 17 10 00, years.
    pub years: u32,
    /// Design ground acceleration on rock of Eurocode 8, g.
    pub ground_acceleration_g: Option<f64>,
    /// Type of the spectrum of Eurocode 8, 1 or 2.
    pub spectrum_type: u8,
}

/// Default periods of a match, s. Our choice.
pub const RANGE_S: [f64; 2] = [0.1, 3.0];
/// Shortest and longest allowed period, s. Our choice: records of earthquakes do not resolve others.
const RANGE_ALLOWED_S: [f64; 2] = [0.02, 10.0];
/// Periods of a match for a structure, relative to its own period: 0.2 T1 to 2 T1. Our choice.
const OF_STRUCTURE: [f64; 2] = [0.2, 2.0];

/// Periods of a match for a structure with the period `t1_s`.
pub fn range_of_structure(t1_s: f64) -> [f64; 2] {
    OF_STRUCTURE.map(|share| share * t1_s)
}

/// Checks a range of periods.
pub(super) fn range(given_s: [f64; 2]) -> Result<[f64; 2], WorkError> {
    let [least_s, most_s] = given_s;
    let [allowed_least_s, allowed_most_s] = RANGE_ALLOWED_S;
    match allowed_least_s <= least_s && 1.2 * least_s <= most_s && most_s <= allowed_most_s {
        true => Ok(given_s),
        false => Err(MotionRequestError::Range {
            least_s,
            most_s,
            allowed_least_s,
            allowed_most_s,
        }
        .into()),
    }
}

/// The spectrum of a demand.
pub(super) fn demand(options: &Demand) -> Result<DesignSpectrum, WorkError> {
    let site = options.site.to_uppercase();
    if let Some(acceleration_g) = options.ground_acceleration_g {
        let grounds = [
            EurocodeGround::A,
            EurocodeGround::B,
            EurocodeGround::C,
            EurocodeGround::D,
            EurocodeGround::E,
        ];
        let Some(ground) = grounds.into_iter().find(|ground| format!("{ground:?}") == site) else {
            return Err(MotionRequestError::NoEurocodeGround {
                given: options.site.clone(),
            }
            .into());
        };
        let kind = if options.spectrum_type == 2 {
            EurocodeType::Two
        } else {
            EurocodeType::One
        };
        return Ok(eurocode_8(acceleration_g, kind, ground)?);
    }
    let sites = [
        KoreanSite::S1,
        KoreanSite::S2,
        KoreanSite::S3,
        KoreanSite::S4,
        KoreanSite::S5,
        KoreanSite::S6,
    ];
    let Some(site) = sites.into_iter().find(|known| format!("{known:?}") == site) else {
        return Err(MotionRequestError::NoKoreanSite {
            given: options.site.clone(),
        }
        .into());
    };
    let zone = if options.zone == 2 {
        KoreanZone::II
    } else {
        KoreanZone::I
    };
    Ok(kds_17(
        kds_17_effective_acceleration_g(zone, options.years)?,
        site,
    )?)
}
