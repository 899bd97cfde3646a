//! Storey drifts of a frame compared with their allowable drift.

use super::FrameSimulation;
use super::columns::alone_most;
use super::lean::leaning;
use super::loads::with_loads;
use super::simulate::storey_names;
use super::tenons::bearing_n_m;
use crate::error::WorkError;
use crate::part_limit::{Compared, NotCompared, Part, PartLimit, WhyNotCompared};
use dolmen::assess::demand::{DriftLimit, SiteDemand, frame_drifts_by_spectrum};
use dolmen::structure::Frame;
use dolmen_project::{DirectionPart, FramePart, Quantity};

/// The elastic drifts under the spectrum of the site, in each direction that stands: with every joint stuck, every joint slipping, or every
/// tenon bearing, whichever is largest. The surveyed lean at rest, of all directions together, reduces the allowable drift.
pub(crate) fn by_spectrum(
    part: &FramePart,
    site: &SiteDemand,
    limit: Option<&DriftLimit>,
) -> Result<Compared, WorkError> {
    let frame = part.build(&mut Quantity::nominal)?;
    let lean = resultant_lean(part, &frame)?;
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
        let Some(leans) = with_loads(part, &frame, direction, lean.clone())? else {
            let direction = Some(name.clone());
            let why = WhyNotCompared::Falls;
            compared.not_compared.push(NotCompared { direction, why });
            continue;
        };
        let alone = alone_most(part, name, &mut Quantity::nominal)?;
        let each = storeys.zip(drifts).zip(leans).zip(alone);
        compared
            .parts
            .extend(each.map(|((((storey, of), drift_m), lean), most)| {
                PartLimit::of_drift(Part::Storey(storey), name, drift_m / of.height_m, limit)
                    .at_most(most)
                    .taking(lean)
            }));
    }
    Ok(compared)
}

/// Lean of each storey at rest, all directions together, to which a drift in any direction is added.
fn resultant_lean(part: &FramePart, frame: &Frame) -> Result<Vec<f64>, WorkError> {
    let mut squares = vec![0.0; frame.storeys().len()];
    for direction in &part.directions {
        let tilt = part.tilt(&direction.name);
        let leans = leaning(part, frame, direction, &mut Quantity::nominal)?;
        let leans = leans.unwrap_or_else(|| vec![tilt; squares.len()]);
        for (square, lean) in squares.iter_mut().zip(leans) {
            *square += lean * lean;
        }
    }
    Ok(squares.into_iter().map(f64::sqrt).collect())
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
    if let Some(tenons) = part
        .tenons(&direction.name, &mut Quantity::nominal)
        .map_err(WorkError::from)?
    {
        let bearing = bearing_n_m(&tenons, &stuck);
        let drifts_m = frame_drifts_by_spectrum(frame, &bearing, site, damping_ratio)?;
        for (largest, drift_m) in largest.iter_mut().zip(drifts_m.into_iter().flatten()) {
            *largest = largest.max(drift_m);
        }
    }
    Ok(Ok(largest))
}

impl FrameSimulation {
    /// The drift of each storey compared with its allowable drift, reduced by the surveyed lean; under two components also both directions
    /// together.
    pub fn parts(&self) -> Vec<PartLimit> {
        let limit = self.drift_limit.as_ref();
        let tilt = self.lean.as_ref().map_or(0.0, |lean| lean.together);
        let storeys = self.frame.frame().storeys();
        let heights_m: Vec<f64> = storeys.iter().map(|storey| storey.height_m).collect();
        let each = self.storeys.iter().zip(&heights_m).zip(&self.history.drift_peaks);
        let mut all: Vec<PartLimit> = each
            .zip(self.static_drifts.iter().zip(&self.columns_most))
            .map(|(((name, height_m), peak), (pushed, most))| {
                let part = Part::Storey(name.clone());
                PartLimit::of_drift(part, &self.direction, peak.value_m / height_m, limit)
                    .at_most(*most)
                    .taking(tilt + pushed)
            })
            .collect();
        if let Some(together) = self.together_once() {
            all.extend(together.parts((&self.storeys, &heights_m), tilt, limit));
        }
        all
    }
}
