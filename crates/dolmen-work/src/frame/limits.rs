//! Storeys of a frame against their allowable drift.

use super::FrameSimulation;
use super::lean::leaning;
use super::simulate::storey_names;
use crate::error::WorkError;
use crate::part_limit::{Compared, NotCompared, Part, PartLimit, WhyNotCompared};
use dolmen::assess::demand::{DriftLimit, SiteDemand, frame_drifts_by_spectrum};
use dolmen::structure::Frame;
use dolmen_project::{DirectionPart, FramePart, Quantity};

/// The elastic drifts by the spectrum of the site, in each direction that stands: with every joint stuck or every joint slipping, whichever
/// drifts further; the lean as surveyed, at rest, takes its part of what is allowed.
pub(crate) fn by_spectrum(
    part: &FramePart,
    site: &SiteDemand,
    limit: Option<&DriftLimit>,
) -> Result<Compared, WorkError> {
    let frame = part.build(&mut Quantity::nominal)?;
    let mut compared = Compared::default();
    for direction in &part.directions {
        let name = &direction.name;
        let drifts = match drifts(part, &frame, direction, site)? {
            Ok(drifts) => drifts,
            Err(why) => {
                let direction = Some(name.clone());
                compared.not_compared.push(NotCompared { direction, why });
                continue;
            }
        };
        let storeys = storey_names(part).into_iter().zip(frame.storeys());
        let leans = leaning(part, &frame, direction)?;
        let leans = leans.unwrap_or_else(|| vec![0.0; frame.storeys().len()]);
        let each = storeys.zip(drifts).zip(leans);
        compared.parts.extend(each.map(|(((storey, of), drift_m), lean)| {
            PartLimit::of_drift(Part::Storey(storey), name, drift_m / of.height_m, limit).taking(lean)
        }));
    }
    Ok(compared)
}

/// The drift of each storey in one direction, m, or why there is none.
fn drifts(
    part: &FramePart,
    frame: &Frame,
    direction: &DirectionPart,
    site: &SiteDemand,
) -> Result<Result<Vec<f64>, WhyNotCompared>, WorkError> {
    let own = direction.damping_ratio.as_ref().map(|own| own.value);
    let damping_ratio = site.damping_ratio_of(own);
    let Some(stuck) = part.stiffness_n_m(&direction.name, &mut Quantity::nominal) else {
        return Ok(Err(WhyNotCompared::StiffnessUnknown));
    };
    let Some(mut largest) = frame_drifts_by_spectrum(frame, &stuck, site, damping_ratio)? else {
        return Ok(Err(WhyNotCompared::Falls));
    };
    if let Some(slipping) = part.slipping_stiffness_n_m(&direction.name, &mut Quantity::nominal) {
        let Some(drifts_m) = frame_drifts_by_spectrum(frame, &slipping, site, damping_ratio)? else {
            return Ok(Err(WhyNotCompared::FallsSlipping));
        };
        for (largest, drift_m) in largest.iter_mut().zip(drifts_m) {
            *largest = largest.max(drift_m);
        }
    }
    Ok(Ok(largest))
}

impl FrameSimulation {
    /// Each storey against its allowable drift, of which the lean as surveyed takes its part; under two components also both directions together.
    pub fn parts(&self) -> Vec<PartLimit> {
        let limit = self.drift_limit.as_ref();
        let storeys = self.frame.frame().storeys();
        let heights_m: Vec<f64> = storeys.iter().map(|storey| storey.height_m).collect();
        let each = self.storeys.iter().zip(&heights_m).zip(&self.history.drift_peaks);
        let mut all: Vec<PartLimit> = each
            .map(|((name, height_m), peak)| {
                let part = Part::Storey(name.clone());
                PartLimit::of_drift(part, &self.direction, peak.value_m / height_m, limit).taking(self.tilt)
            })
            .collect();
        if let Some(together) = self.together_once() {
            let tilt = self.lean.as_ref().map_or(0.0, |lean| lean.together);
            all.extend(together.parts((&self.storeys, &heights_m), tilt, limit));
        }
        all
    }
}
