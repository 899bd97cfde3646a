//! Reads the geographic place.

use super::file::{CodeRaw, SiteRaw};
use super::part::Place;
use super::slips::judge_korean_place;
use crate::error::Fault;
use crate::file_number::At;
use crate::reader::Reader;
use crate::wrong::WrongSite;

/// The place, if the site has one: both numbers or none.
pub(crate) fn place(reader: &mut Reader, raw: Option<&At<SiteRaw>>, has_korean_name: bool) -> Option<Place> {
    let raw = &raw?.value;
    let (latitude, longitude) = (raw.latitude_deg.as_ref(), raw.longitude_deg.as_ref());
    if let (Some(one), None) | (None, Some(one)) = (latitude, longitude) {
        let (path, other) = match latitude {
            Some(_) => ("site.latitude_deg", "longitude_deg"),
            None => ("site.longitude_deg", "latitude_deg"),
        };
        let fault = Fault::new(one.span.clone(), path, WrongSite::StandsAlone(path.to_string()));
        reader.fault(fault.help(WrongSite::GiveAsWell(other.to_string())));
        return None;
    }
    let latitude_deg = reader.within(latitude, "site.latitude_deg", -90.0, 90.0)?;
    let longitude_deg = reader.within(longitude, "site.longitude_deg", -180.0, 180.0)?;
    let code = raw.code.as_ref().map(|code| code.value);
    let is_by_code = matches!(code, Some(CodeRaw::Kds17 | CodeRaw::Kds41));
    if is_by_code || has_korean_name {
        let paths = ["site.latitude_deg", "site.longitude_deg"];
        judge_korean_place(reader, paths, [latitude_deg, longitude_deg], is_by_code);
    }
    Some(Place {
        latitude_deg,
        longitude_deg,
    })
}

/// Whether a site has only a place.
pub(super) fn is_place_alone(raw: &SiteRaw) -> bool {
    let SiteRaw {
        latitude_deg,
        longitude_deg: _,
        code: None,
        zone: None,
        zone_factor: None,
        return_period_years: None,
        soil: None,
        spectrum_type: None,
        ground: None,
        ground_acceleration: None,
        importance_factor: None,
        periods_s: None,
        accelerations: None,
        file: None,
        unit: None,
        peak_ground_acceleration: None,
        source: None,
        damping_ratio: None,
        hazard: None,
        vertical_ratio: None,
    } = raw
    else {
        return false;
    };
    latitude_deg.is_some()
}
