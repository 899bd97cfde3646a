//! Combinations with the earthquake in the headline.

use dolmen_work::judgement::{MovedBy, WindFinding};

/// The combination with the earthquake that leaves less than the earthquake alone, unless it decides among all loads anyway.
pub(crate) fn with_earthquake(wind: &[WindFinding], alone: Option<f64>) -> Option<&WindFinding> {
    let shaken = wind.iter().filter(|of| of.by == MovedBy::WithEarthquake);
    let known = shaken.filter_map(|of| Some((of.ratio?, of)));
    let (ratio, of) = known.min_by(|a, b| a.0.total_cmp(&b.0))?;
    let is_said = WindFinding::deciding(wind).is_some_and(|of| of.by == MovedBy::WithEarthquake);
    (ratio < alone.unwrap_or(f64::INFINITY) && !is_said).then_some(of)
}
