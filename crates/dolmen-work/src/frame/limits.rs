//! Storeys of a frame against their allowable drift.

use super::FrameSimulation;
use super::simulate::storey_names;
use crate::error::WorkError;
use crate::part_limit::{Compared, NotCompared, Part, PartLimit, WhyNotCompared};
use dolmen::assess::demand::{DriftLimit, SiteDemand, frame_drifts_by_spectrum};
use dolmen::structure::Frame;
use dolmen_project::{DirectionPart, FramePart, Quantity};

/// The elastic drifts by the spectrum of the site, in each direction that stands: with every joint stuck or every joint slipping, whichever
/// drifts further.
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
            Ok(drifts_m) => drifts_m,
            Err(why) => {
                let direction = Some(name.clone());
                compared.not_compared.push(NotCompared { direction, why });
                continue;
            }
        };
        let storeys = storey_names(part).into_iter().zip(frame.storeys());
        compared
            .parts
            .extend(storeys.zip(drifts).map(|((storey, of), drift_m)| {
                PartLimit::of_drift(Part::Storey(storey), name, drift_m / of.height_m, limit)
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
    /// Each storey against its allowable drift.
    pub fn parts(&self) -> Vec<PartLimit> {
        let storeys = self.storeys.iter().zip(self.frame.frame().storeys());
        let each = storeys.zip(&self.history.drift_peaks);
        each.map(|((name, storey), peak)| {
            let ratio = peak.value_m / storey.height_m;
            let part = Part::Storey(name.clone());
            PartLimit::of_drift(part, &self.direction, ratio, self.drift_limit.as_ref())
        })
        .collect()
    }
}
