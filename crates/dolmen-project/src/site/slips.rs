//! Probable slips in what a site asks for.

use super::part::SitePart;
use crate::reader::Reader;
use crate::units::STANDARD_GRAVITY_M_S2;
use crate::usual_numbers::ratio;
use crate::wrong::WrongSite;
use dolmen::assess::demand::Site;

/// Reference acceleration of the ground, g: the national annexes of EN 1998-1 map 0.02 to 0.5.
const GROUND_G: (f64, f64) = (0.02, 1.0);
/// Importance factor: EN 1998-1 has 0.8 to 1.4.
const IMPORTANCE: (f64, f64) = (0.5, 2.0);
/// Largest acceleration of a design spectrum, g: rare in a quiet country to maximum beside a fault.
const PLATEAU_G: (f64, f64) = (0.05, 5.0);

pub(super) fn judge_site(reader: &mut Reader, part: &SitePart) {
    let outside = |value: f64, (least, most): (f64, f64)| !(least..=most).contains(&value);
    match &part.site {
        Site::Eurocode8 {
            ground_acceleration_g,
            importance_factor,
            ..
        } => {
            if outside(*ground_acceleration_g, GROUND_G) {
                let message = WrongSite::GroundUnlikely {
                    given: ratio(*ground_acceleration_g),
                };
                reader.slip("site.ground_acceleration", message, WrongSite::GroundOfMaps);
            }
            if outside(*importance_factor, IMPORTANCE) {
                let message = WrongSite::ImportanceUnlikely {
                    given: ratio(*importance_factor),
                };
                reader.slip("site.importance_factor", message, WrongSite::ImportanceOfCode);
            }
        }
        Site::Table { points, .. } => {
            let plateau = points.iter().map(|[_, a]| *a).fold(0.0, f64::max) / STANDARD_GRAVITY_M_S2;
            if outside(plateau, PLATEAU_G) {
                let message = WrongSite::PlateauUnlikely {
                    given: ratio(plateau),
                };
                reader.slip("site.unit", message, WrongSite::UnitOfSpectrum);
            }
        }
        Site::Kds17 { .. } | Site::Kds41 { .. } => {} // the zone and the return period bound it
    }
}
