//! Probable slips in the demand of a site.

use super::part::SitePart;
use crate::reader::Reader;
use crate::units::STANDARD_GRAVITY_M_S2;
use crate::usual::within;
use crate::usual_numbers::ratio;
use crate::wrong::WrongSite;
use dolmen::assess::demand::Site;

/// Reference acceleration of the ground, g: the national annexes of EN 1998-1 map 0.02 to 0.5.
const GROUND_G: (f64, f64) = (0.02, 1.0);
/// Importance factor: EN 1998-1 has 0.8 to 1.4.
const IMPORTANCE: (f64, f64) = (0.5, 2.0);
/// Largest acceleration of a design spectrum, g: from a rare one in a quiet country to the maximum near a fault, 1.5 g of the ground times 2.5.
const PLATEAU_G: (f64, f64) = (0.05, 4.0);

/// Longest period of a design spectrum, s: codes and hazard models go to 10, seldom to 20.
const PERIOD_MOST_S: f64 = 100.0;
/// Largest usual period of the peak of a design spectrum, s: codes have 0.05 to 1.5, soft basins up to 4.
const LARGEST_FROM_S: f64 = 5.0;
/// A period from which a spectrum is below its start, the peak of the ground, s.
const LONG_S: f64 = 5.0;

/// Periods in ms, or frequencies instead of periods: both would give a stiff structure almost no shaking.
fn judge_periods(reader: &mut Reader, points: &[[f64; 2]]) {
    let (Some([_, first]), Some([longest, last])) = (points.first(), points.last()) else {
        return;
    };
    let largest = points.iter().map(|[_, a]| *a).fold(0.0, f64::max);
    let begins = points
        .iter()
        .find(|[_, a]| *a >= largest)
        .map_or(0.0, |[t, _]| *t);
    let begins_late = begins > LARGEST_FROM_S && largest > *first;
    let (message, help) = if *longest > PERIOD_MOST_S || begins_late {
        let message = WrongSite::PeriodsUnlikely {
            longest: ratio(*longest),
            largest: ratio(begins),
        };
        (message, WrongSite::PeriodsInSeconds)
    } else if *longest >= LONG_S && last > first {
        let message = WrongSite::SpectrumRises {
            longest: ratio(*longest),
            last_g: ratio(last / STANDARD_GRAVITY_M_S2),
            first_g: ratio(first / STANDARD_GRAVITY_M_S2),
        };
        (message, WrongSite::FrequenciesForPeriods)
    } else {
        return;
    };
    let path = match reader.place("site.periods_s").is_empty() {
        true => "site.file",
        false => "site.periods_s",
    };
    reader.slip(path, message, help);
}

/// Latitude and longitude of Korea, degrees, islands and the north included.
const KOREA_DEG: [(f64, f64); 2] = [(33.0, 43.1), (124.0, 132.0)];

/// A place outside Korea for a Korean structure: two numbers exchanged, or a lost digit. `is_by_code`: the code of the site is Korean; a
/// Korean name alone may belong to a structure abroad.
pub(crate) fn judge_korean_place(reader: &mut Reader, paths: [&str; 2], degrees: [f64; 2], is_by_code: bool) {
    let [latitude, longitude] = [0, 1].map(|of| within(degrees[of], KOREA_DEG[of]));
    let tenth = [0, 1].map(|of| within(10.0 * degrees[of], KOREA_DEG[of]));
    let exchanged = within(degrees[0], KOREA_DEG[1]) || within(10.0 * degrees[0], KOREA_DEG[1]);
    let looks_slipped = (latitude && tenth[1]) || (tenth[0] && longitude) || exchanged;
    if (latitude && longitude) || !(is_by_code || looks_slipped) {
        return;
    }
    let at = usize::from(latitude);
    let message = WrongSite::NotInKorea {
        path: paths[at].to_owned(),
        latitude: ratio(degrees[0]),
        longitude: ratio(degrees[1]),
    };
    reader.slip(paths[at], message, WrongSite::PlaceOfKorea);
}

pub(super) fn judge_site(reader: &mut Reader, part: &SitePart) {
    let outside = |value: f64, (least, most): (f64, f64)| !(least..=most).contains(&value);
    match &part.site {
        Site::Eurocode8 {
            ground_acceleration_g,
            importance_factor,
            ..
        } => {
            if outside(*ground_acceleration_g, GROUND_G) {
                let message = WrongSite::GroundUnlikely(ratio(*ground_acceleration_g));
                reader.slip("site.ground_acceleration", message, WrongSite::GroundOfMaps);
            }
            if outside(*importance_factor, IMPORTANCE) {
                let message = WrongSite::ImportanceUnlikely(ratio(*importance_factor));
                reader.slip("site.importance_factor", message, WrongSite::ImportanceOfCode);
            }
        }
        Site::Table { points, .. } => {
            let plateau = points.iter().map(|[_, a]| *a).fold(0.0, f64::max) / STANDARD_GRAVITY_M_S2;
            if outside(plateau, PLATEAU_G) {
                let message = WrongSite::PlateauUnlikely(ratio(plateau));
                reader.slip("site.unit", message, WrongSite::UnitOfSpectrum);
            }
            judge_periods(reader, points);
        }
        Site::Kds17 { .. } | Site::Kds41 { .. } => {} // the zone and the return period bound it
    }
}
