//! Storey drifts of a frame compared with their allowable drift.

use super::columns::{AloneStorey, alone_storeys};
use super::lean::leaning;
use super::loads::with_loads;
use super::simulate::storey_names;
use super::softening::{by_spectrum as softened_by_spectrum, unfollowed};
use super::tenons::bearing_n_m;
use super::{ColumnsOnBeds, FrameSimulation, UnfollowedStorey};
use crate::error::WorkError;
use crate::part_limit::{Compared, NotCompared, Part, PartLimit, SplitDrift, WhyNotCompared};
use dolmen::assess::demand::{DriftLimit, SiteDemand, frame_drifts_by_spectrum};
use dolmen::stability::stack::DemandVerdict;
use dolmen::structure::Frame;
use dolmen_project::{DirectionPart, FramePart, Quantity};

/// The elastic drifts under the spectrum of the site, in each direction that stands: with every joint stuck, every joint slipping, or every
/// tenon bearing, whichever is largest. The surveyed lean at rest reduces the allowable drift.
pub(crate) fn by_spectrum(
    part: &FramePart,
    site: &SiteDemand,
    limit: Option<&DriftLimit>,
) -> Result<Compared, WorkError> {
    let frame = part.build(&mut Quantity::nominal)?;
    let at_rest = leans_at_rest(part, &frame)?;
    let mut compared = Compared::default();
    for (place, direction) in part.directions.iter().enumerate() {
        let name = &direction.name;
        let own = direction.damping_ratio.as_ref().map(|own| own.value);
        let damping_ratio = site.damping_ratio_of(own);
        let drifts = match drifts(part, &frame, direction, (site, damping_ratio)) {
            Err(WorkError::Assess(_)) => Err(WhyNotCompared::NoSpectrum),
            drifts => drifts?,
        };
        let drifts = match drifts {
            Ok(drifts) => drifts,
            Err(why) => {
                let direction = Some(name.clone());
                compared.not_compared.push(NotCompared { direction, why });
                continue;
            }
        };
        let names = storey_names(part);
        let springs_alone = unfollowed(
            (part, &frame),
            direction,
            (&names, &drifts),
            &mut Quantity::nominal,
        )?;
        let springs_alone = springs_alone.into_iter().filter(UnfollowedStorey::lifts_off);
        compared
            .unfollowed
            .extend(springs_alone.map(|of| (name.clone(), of)));
        let storeys = names.into_iter().zip(frame.storeys());
        let Some(leans) = with_loads(part, &frame, direction, at_rest[place].clone())? else {
            let direction = Some(name.clone());
            let why = WhyNotCompared::Falls;
            compared.not_compared.push(NotCompared { direction, why });
            continue;
        };
        let alone = alone_storeys(part, name, &mut Quantity::nominal)?;
        let across = across(part, place, &at_rest);
        let each = storeys.zip(drifts).zip(leans.into_iter().zip(across)).zip(&alone);
        let mut lifts_off = false;
        for ((((storey, of), drift_m), (along, across)), alone) in each {
            let split = split_drift((part, &frame), direction, (site, damping_ratio), drift_m)?;
            let split = split.map(|(split, softer)| SplitDrift {
                in_beds: PartLimit::of_drift(Part::Storey(storey.clone()), name, softer, limit)
                    .taking([along, across]),
                ..split
            });
            // as the file shares the stiffness, there is one drift: the larger
            let followed = split.as_ref().filter(|of| of.beds.is_file());
            let softer = followed.map(|of| of.in_beds.demand);
            let linear = drift_m / of.height_m;
            compared.splits.extend(split);
            let pushed = along.abs() - part.tilt(name).abs();
            let of_drift = |drift: f64| {
                PartLimit::of_drift(Part::Storey(storey.clone()), name, drift, limit)
                    .taking([along, across])
                    .at_most(alone.as_ref().map(|alone| left_of_most(alone, pushed)))
            };
            let has_balance = softer.is_none_or(f64::is_finite);
            let compared_part = match softer.filter(|softer| softer.is_finite()) {
                Some(softer) => of_drift(softer.max(linear)),
                None => of_drift(linear),
            };
            let is_linear = alone
                .as_ref()
                .is_none_or(|alone| compared_part.demand + pushed <= alone.uplift);
            match compared_part.verdict() == DemandVerdict::Below {
                false if !has_balance => compared.not_compared.push(NotCompared {
                    direction: Some(name.clone()),
                    why: WhyNotCompared::NoBalance,
                }),
                false if !is_linear => lifts_off = true,
                _ => compared.parts.push(compared_part),
            }
        }
        if lifts_off {
            let direction = Some(name.clone());
            let why = WhyNotCompared::FeetLiftOff;
            compared.not_compared.push(NotCompared { direction, why });
        }
    }
    Ok(compared)
}

/// The drift by the spectrum where feet lift off, without its limit, and the drift ratio with the force of the columns; `None` where none lifts.
fn split_drift(
    (part, frame): (&FramePart, &Frame),
    direction: &DirectionPart,
    demand: (&SiteDemand, f64),
    linear_m: f64,
) -> Result<Option<(SplitDrift, f64)>, WorkError> {
    let softened = softened_by_spectrum((part, frame), direction, demand, linear_m, &mut Quantity::nominal)?;
    Ok(softened.map(|of| {
        let held = of.softening.held;
        let softer = of.drift.unwrap_or(f64::INFINITY);
        let beds_n_m = held.columns.bed_stiffness_n_m().unwrap_or(f64::INFINITY);
        let split = SplitDrift {
            direction: direction.name.clone(),
            beds: of.softening.beds,
            shares_n_m: [beds_n_m, held.joints_n_m],
            in_joints: linear_m / held.columns.height_m(),
            uplift: of.uplift,
            in_beds: PartLimit::of_drift(Part::Storey(String::new()), &direction.name, softer, None),
        };
        (split, softer)
    }))
}

/// The drift ratio left up to the largest force of columns after what tilt and static loads push them at rest.
fn left_of_most(alone: &AloneStorey, pushed: f64) -> f64 {
    (alone.most - pushed.abs()).max(0.0)
}

/// Lean of each storey at rest in each direction.
fn leans_at_rest(part: &FramePart, frame: &Frame) -> Result<Vec<Vec<f64>>, WorkError> {
    let each = part.directions.iter().map(|direction| {
        let leans = leaning(part, frame, direction, &mut Quantity::nominal)?;
        Ok(leans.unwrap_or_else(|| vec![part.tilt(&direction.name); frame.storeys().len()]))
    });
    each.collect()
}

/// Lean of each storey at rest across a direction: that along the others. It is 0 if the survey gives the tilt in a direction that the
/// frame does not have, because that counts along each.
fn across(part: &FramePart, place: usize, at_rest: &[Vec<f64>]) -> Vec<f64> {
    let tilt = part
        .directions
        .get(place)
        .map_or(0.0, |own| part.tilt_across(&own.name));
    let others = || at_rest.iter().enumerate().filter(|(other, _)| *other != place);
    (0..part.storeys.len())
        .map(|storey| match (tilt == 0.0, others().next()) {
            (true, _) => 0.0,
            (false, None) => tilt,
            (false, Some(_)) => others()
                .map(|(_, leans)| leans[storey].powi(2))
                .sum::<f64>()
                .sqrt(),
        })
        .collect()
}

/// The drift of each storey in one direction, m, or why there is none.
fn drifts(
    part: &FramePart,
    frame: &Frame,
    direction: &DirectionPart,
    (site, damping_ratio): (&SiteDemand, f64),
) -> Result<Result<Vec<f64>, WhyNotCompared>, WorkError> {
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
    /// The drift of a frame of one storey compared with its allowable drift, as [`FrameSimulation::parts`], where the beds of its columns have
    /// all of its stiffness, which the file does not say; empty without such a run.
    pub fn parts_all_in_beds(&self) -> Vec<PartLimit> {
        let ([storey], [name], Some(assumed)) = (
            self.frame.frame().storeys(),
            self.storeys.as_slice(),
            &self.all_in_beds,
        ) else {
            return Vec::new();
        };
        let limit = self.drift_limit.as_ref();
        let lean = self.lean.as_ref().map_or(0.0, |lean| lean.together);
        let across = (lean * lean - self.tilt * self.tilt).max(0.0).sqrt();
        let pushed = self.static_drifts.first().copied().unwrap_or(0.0);
        let part = |direction: &str, drift_m: f64| {
            PartLimit::of_drift(
                Part::Storey(name.clone()),
                direction,
                drift_m / storey.height_m,
                limit,
            )
        };
        let own = part(&self.direction, assumed.run.history.peak_drift_m);
        let mut all = vec![own.taking([self.tilt.abs() + pushed, across])];
        if let Some(both) = self.together_once()
            && let Some(drift_m) = both.all_in_beds_m
        {
            all.push(part(&both.direction(), drift_m).taking([lean, 0.0]));
        }
        all
    }

    /// The drift of each storey compared with its allowable drift, reduced by the surveyed lean; under two components also both directions
    /// together. Where columns lift off on beds that the file gives, the larger drift of springs and of their own curve counts.
    pub fn parts(&self) -> Vec<PartLimit> {
        let limit = self.drift_limit.as_ref();
        let together = self.lean.as_ref().map_or(0.0, |lean| lean.together);
        let across = (together * together - self.tilt * self.tilt).max(0.0).sqrt();
        let storeys = self.frame.frame().storeys();
        let heights_m: Vec<f64> = storeys.iter().map(|storey| storey.height_m).collect();
        let each = self.storeys.iter().zip(&heights_m).zip(&self.history.drift_peaks);
        let rocked = self.on_beds().filter(|run| ColumnsOnBeds::lifts_off(run));
        let mut all: Vec<PartLimit> = each
            .zip(self.static_drifts.iter().zip(&self.columns_alone))
            .map(|(((name, height_m), peak), (pushed, alone))| {
                let part = Part::Storey(name.clone());
                let lean = [self.tilt.abs() + pushed, across];
                let of_spring = peak.value_m.abs() / height_m;
                match (alone, rocked) {
                    // the columns follow their own curve: up to the fall, and up to the limit if there is one
                    (_, Some(rocked)) => {
                        let history = &rocked.history;
                        let drift = of_spring.max(history.peak_drift_m / height_m);
                        let falls = history.falls_drift_m / height_m;
                        let falls = limit.map(|_| (falls - self.tilt.abs() - pushed).max(0.0));
                        PartLimit::of_drift(part, &self.direction, drift, limit)
                            .taking(lean)
                            .at_most(falls)
                    }
                    (alone, _) => PartLimit::of_drift(part, &self.direction, of_spring, limit)
                        .taking(lean)
                        .at_most(alone.as_ref().map(|alone| left_of_most(alone, *pushed))),
                }
            })
            .collect();
        if let Some(both) = self.together_once() {
            all.extend(both.parts((&self.storeys, &heights_m), together, limit));
        }
        all
    }
}
