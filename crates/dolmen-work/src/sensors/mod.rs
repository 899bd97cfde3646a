//! `dolmen sensors`: where a few sensors measure the modes of a structure best, and which modes they miss.

mod answer;
mod error;
mod model;
mod sites;

pub use answer::{PlannedMode, PlannedSensor, SensorsAnswer, SensorsOf};
pub use error::SensorsError;
pub use sites::{Axis, Side, Site};

use crate::error::{Within as _, WorkError};
use crate::model_modes::dampers_left_out;
use crate::opened::Opened;
use crate::wrong::Place;
use dolmen::modal::{PlacedSensors, SensorPlacement};
use model::{Model, model};

/// Options of the plan.
#[derive(Clone, Debug, PartialEq)]
pub struct SensorsOptions {
    /// Number of sensors recording together; by default a few, as places allow.
    pub count: Option<usize>,
    /// Number of axes of each: 1, 2 (both horizontal) or 3, at most those along which the model moves.
    pub axes: usize,
    /// Largest height of a sensor above the ground, m.
    pub up_to_m: Option<f64>,
    /// Number of modes to distinguish, from the lowest; by default a few.
    pub modes: Option<usize>,
    /// Number of setups.
    pub setups: usize,
    /// Number of reference sensors, which stay in all setups.
    pub references: usize,
}

impl Default for SensorsOptions {
    fn default() -> Self {
        SensorsOptions {
            count: None,
            axes: 1,
            up_to_m: None,
            modes: None,
            setups: 1,
            references: 0,
        }
    }
}

/// Default number of sensors.
const COUNT: usize = 4;
/// Default number of modes: as many as channels, within these limits.
const MODES_LEAST: usize = 3;
const MODES_MOST: usize = 6;

/// The best places of sensors on a structure, for the modes of its model.
///
/// # Errors
/// [`WorkError`] for a survey without a model, a structure that does not stand, and counts that do not fit together.
pub fn sensors(opened: &Opened, options: &SensorsOptions) -> Result<SensorsAnswer, WorkError> {
    check(options)?;
    let project = &opened.project;
    let wanted = options
        .modes
        .unwrap_or_else(|| (options.count.unwrap_or(COUNT) * options.axes).clamp(MODES_LEAST, MODES_MOST));
    let model = model(project, wanted, options.axes)?;
    let Model {
        modes,
        sites,
        rows,
        of,
    } = model;
    let ground = sites
        .iter()
        .map(|site| site.ground_m)
        .fold(f64::INFINITY, f64::min);
    let reach = options.up_to_m.map_or(f64::INFINITY, |most| ground + most + 1e-9);
    let (kept, kept_rows): (Vec<Site>, Vec<Vec<Vec<f64>>>) = sites
        .into_iter()
        .zip(rows)
        .filter(|(site, _)| site.position_m[2] <= reach)
        .unzip();
    if kept.is_empty() {
        let up_to_m = options.up_to_m.unwrap_or_default();
        return Err(SensorsError::NoSites { up_to_m }.into());
    }
    let places = options.references + kept.len().saturating_sub(options.references) / options.setups;
    let least = options.references + 1;
    let count = options.count.unwrap_or(COUNT.min(places).max(least));
    let moved = count - options.references;
    let total = options.references + options.setups * moved;
    if total > kept.len() {
        let sites = kept.len();
        return Err(SensorsError::TooMany {
            sensors: total,
            sites,
        }
        .into());
    }
    let place = |sensors: usize, given: Vec<usize>| {
        let how = SensorPlacement {
            sensors,
            given,
            ..SensorPlacement::default()
        };
        how.place(&kept_rows).within(|| Place::SensorsPlaced)
    };
    // reference sensors must measure every mode by themselves, because they bring the setups to one scale
    let references = match options.references {
        0 => Vec::new(),
        count => place(count, Vec::new())?.sites,
    };
    let placed: PlacedSensors = place(total, references)?;
    let sensors = in_setups(&placed, &kept, options, moved);
    let modes = modes.into_iter().enumerate().map(|(at, mode)| PlannedMode {
        seen_ratio: placed.seen_ratio[at],
        most_alike: placed.most_alike(at),
        ..mode
    });
    let likeness = (0..modes.len()).map(|i| (0..modes.len()).map(|j| placed.likeness[(i, j)]).collect());
    let likeness = likeness.collect();
    Ok(SensorsAnswer {
        file: opened.file.clone(),
        project: project.clone(),
        modes: modes.collect(),
        sites: kept.len(),
        axes: options.axes,
        up_to_m: options.up_to_m,
        setups: options.setups,
        sensors,
        of,
        likeness,
        without_dampers: dampers_left_out(&opened.project),
    })
}

/// Assigns the moving sensors from the top down, setup by setup, so that each setup is in one part of the structure.
fn in_setups(
    placed: &PlacedSensors,
    sites: &[Site],
    options: &SensorsOptions,
    each: usize,
) -> Vec<PlannedSensor> {
    let (stay, move_on) = placed.sites.split_at(options.references);
    let sensor = |site: usize, setup: Option<usize>| PlannedSensor {
        site: sites[site].clone(),
        setup,
    };
    if options.setups == 1 {
        return placed.sites.iter().map(|site| sensor(*site, None)).collect();
    }
    let mut moving = move_on.to_vec();
    let height = |site: &usize| sites[*site].position_m[2];
    moving.sort_by(|a, b| height(b).total_cmp(&height(a)).then(a.cmp(b)));
    let stay = stay.iter().map(|site| sensor(*site, None));
    let moved = moving
        .chunks(each)
        .enumerate()
        .flat_map(|(setup, sites)| sites.iter().map(move |site| (setup, *site)));
    stay.chain(moved.map(|(setup, site)| sensor(site, Some(setup))))
        .collect()
}

fn check(options: &SensorsOptions) -> Result<(), SensorsError> {
    let counts = [
        ("--count", options.count),
        ("--modes", options.modes),
        ("--setups", Some(options.setups)),
    ];
    if let Some((option, _)) = counts.into_iter().find(|(_, count)| *count == Some(0)) {
        return Err(SensorsError::Zero { option });
    }
    let SensorsOptions {
        count,
        axes,
        setups,
        references,
        ..
    } = *options;
    match (setups, references) {
        _ if !(1..=3).contains(&axes) => Err(SensorsError::Axes { given: axes }),
        (1, 0) => Ok(()),
        (1, _) => Err(SensorsError::OneSetup { references }),
        (_, 0) => Err(SensorsError::NoReferences { setups }),
        (_, _) if references >= count.unwrap_or(COUNT) => Err(SensorsError::AllStay {
            references,
            count: count.unwrap_or(COUNT),
        }),
        (_, _) => Ok(()),
    }
}

#[cfg(test)]
mod tests;
