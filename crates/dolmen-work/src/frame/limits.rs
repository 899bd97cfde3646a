//! Storeys of a frame against their allowable drift.

use super::FrameSimulation;
use super::simulate::storey_names;
use crate::error::WorkError;
use crate::part_limit::{Part, PartLimit};
use dolmen::assess::demand::{DriftLimit, SiteDemand, frame_drifts_by_spectrum};
use dolmen_project::{FramePart, Quantity};

/// The elastic drifts by the spectrum of the site, in each direction that stands: with every joint stuck or every joint slipping, whichever
/// drifts further.
pub(crate) fn by_spectrum(
    part: &FramePart,
    site: &SiteDemand,
    limit: Option<&DriftLimit>,
) -> Result<Vec<PartLimit>, WorkError> {
    let frame = part.build(&mut Quantity::nominal)?;
    let mut all = Vec::new();
    for direction in &part.directions {
        let stuck = part.stiffness_n_m(&direction.name, &mut Quantity::nominal);
        let slipping = part.slipping_stiffness_n_m(&direction.name, &mut Quantity::nominal);
        let mut largest: Option<Vec<f64>> = None;
        for stiffness in stuck.iter().chain(&slipping) {
            let Some(drifts) = frame_drifts_by_spectrum(&frame, stiffness, site)? else {
                // one that falls has no drift to compare
                largest = None;
                break;
            };
            largest = Some(match largest {
                None => drifts,
                Some(other) => other.iter().zip(&drifts).map(|(a, b)| a.max(*b)).collect(),
            });
        }
        let storeys = storey_names(part).into_iter().zip(frame.storeys());
        let each = storeys.zip(largest.into_iter().flatten());
        all.extend(each.map(|((name, storey), drift_m)| {
            let ratio = drift_m / storey.height_m;
            PartLimit::of_drift(Part::Storey(name), &direction.name, ratio, limit)
        }));
    }
    Ok(all)
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
