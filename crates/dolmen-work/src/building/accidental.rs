//! Accidental torsion: the building under the spectrum of its site with its centres of mass displaced.

use super::site_spectrum::spectrum_of;
use crate::error::WorkError;
use crate::told::told_both;
use dolmen::assess::demand::{ACCIDENTAL_ECCENTRICITY, DriftLimit, SiteDemand, TorsionCode};
use dolmen::damper::{DisplacedBuilding, DisplacedCase, displaced_responses};
use dolmen_words::message::Both;

/// Accidental torsion in the response to the spectrum of the site.
#[derive(Clone, Debug, PartialEq)]
pub enum AccidentalTorsion {
    /// No code requires it and the file gives no eccentricity, or there is no response to include it in.
    NotAsked,
    /// The file gives an eccentricity of 0.
    LeftOut {
        /// The code that requires it, if one does.
        code: Option<TorsionCode>,
    },
    /// The response with the centres of mass displaced.
    Included(DisplacedCentres),
    /// A floor has no outline, so that its side is unknown.
    NoOutline {
        /// The code that requires it, if one does.
        code: Option<TorsionCode>,
    },
    /// The displaced building has no response.
    Refused {
        /// The code that requires it, if one does.
        code: Option<TorsionCode>,
        /// Why.
        why: Both,
    },
}

/// The response with the centres of mass displaced.
#[derive(Clone, Debug, PartialEq)]
pub struct DisplacedCentres {
    /// Eccentricity over the side of the floor.
    pub fraction: f64,
    /// The code that requires it; `None` if only the file does.
    pub code: Option<TorsionCode>,
    /// Displacement of the centre of mass of each floor along x and along y, m.
    pub by_m: Vec<[f64; 2]>,
    /// Each combination of signs.
    pub cases: Vec<DisplacedCase>,
}

/// The response with accidental torsion, if a code requires it or the file gives its eccentricity.
pub(super) fn accidental_torsion(
    of: &DisplacedBuilding<'_>,
    (site, limit): (&SiteDemand, Option<&DriftLimit>),
    given: Option<f64>,
) -> AccidentalTorsion {
    let code = TorsionCode::of(site, limit);
    let fraction = match given {
        Some(fraction) => fraction,
        None if code.is_some() => ACCIDENTAL_ECCENTRICITY,
        None => return AccidentalTorsion::NotAsked,
    };
    if fraction == 0.0 {
        return AccidentalTorsion::LeftOut { code };
    }
    let building = of.vibrating.building();
    let (Some(along_x), Some(along_y)) = (building.sides_m(0), building.sides_m(1)) else {
        return AccidentalTorsion::NoOutline { code };
    };
    let sides = along_x.into_iter().zip(along_y);
    let by_m: Vec<[f64; 2]> = sides.map(|(x, y)| [fraction * x, fraction * y]).collect();
    let responses: Result<_, WorkError> = displaced_responses(of, &by_m, spectrum_of(site));
    match responses {
        Ok(cases) => AccidentalTorsion::Included(DisplacedCentres {
            fraction,
            code,
            by_m,
            cases,
        }),
        Err(why) => AccidentalTorsion::Refused {
            code,
            why: told_both(&why),
        },
    }
}

impl AccidentalTorsion {
    /// The response, if it is included.
    pub fn included(&self) -> Option<&DisplacedCentres> {
        match self {
            AccidentalTorsion::Included(of) => Some(of),
            AccidentalTorsion::NotAsked
            | AccidentalTorsion::LeftOut { .. }
            | AccidentalTorsion::NoOutline { .. }
            | AccidentalTorsion::Refused { .. } => None,
        }
    }

    /// Whether it is asked for and missing, so that capacity without it does not show that the demand is met.
    pub fn is_missing(&self) -> bool {
        match self {
            AccidentalTorsion::NoOutline { .. } | AccidentalTorsion::Refused { .. } => true,
            AccidentalTorsion::NotAsked
            | AccidentalTorsion::LeftOut { .. }
            | AccidentalTorsion::Included(_) => false,
        }
    }
}
