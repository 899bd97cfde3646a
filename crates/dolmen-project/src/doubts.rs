//! Probable slips that the numbers alone cannot prove: patterns over all parts, damping, and measured frequencies against those of the
//! model. They are warnings, in the first lines of every answer; `allow` silences them.

use super::building::{DampingPart, doubt_building};
use super::chain::{ChainPart, doubt_chain};
use super::content::Structure;
use super::direction_slips::judge_directions;
use super::doubted::Doubted;
use super::frame::{FramePart, doubt_frame};
use super::loads::{CombinationPart, LoadsPart};
use super::quantity::Quantity;
use super::reader::Reader;
use super::sensor_slips::judge_sensors;
use super::site::MotionPart;
use super::stack::doubt_stack;
use super::survey::{ModeKind, Survey, doubt_surveys};
use super::usual_numbers::{hertz, ratio};
use dolmen::structure::NaturalMode;
use std::f64::consts::{PI, TAU};

/// Usual range of damping ratios, with a margin; masonry in strong shaking reaches 0.1.
const DAMPING: [f64; 2] = [0.001, 0.15];
/// Logarithmic distance within which the ratio of two frequencies counts as a factor. Our choice.
const NEAR: f64 = 0.15;
/// Relative difference of an angle in degrees from a round part of π, below which it looks like radians. Our choice: 1.57 has 5e-4.
const ROUND: f64 = 2e-3;

/// Doubts about a file that was read without fault.
pub(super) fn doubt(
    reader: &mut Reader,
    structure: Option<&Structure>,
    loads: &LoadsPart,
    surveys: &[Survey],
    motions: &[MotionPart],
) {
    match structure {
        Some(Structure::Chain(chain)) => {
            doubt_chain(reader, chain);
            damping(reader, chain.damping_ratio.iter());
            chain_frequencies(reader, (chain, loads), surveys);
        }
        Some(Structure::Frame(frame)) => {
            doubt_frame(reader, frame);
            damping(
                reader,
                frame.directions.iter().filter_map(|of| of.damping_ratio.as_ref()),
            );
            frame_frequencies(reader, frame, surveys);
        }
        Some(Structure::Stack(stack)) => {
            doubt_stack(reader, stack);
            heavier_than_it_is(reader, loads);
        }
        Some(Structure::Building(building)) => {
            doubt_building(reader, building);
            match &building.damping {
                Some(DampingPart::Modal(ratios)) => damping(reader, ratios.iter().take(1)),
                Some(DampingPart::Rayleigh(pairs)) => damping(reader, pairs.iter().map(|[_, ratio]| ratio)),
                Some(DampingPart::Caughey(_)) | None => {}
            }
        }
        Some(Structure::Survey) | None => {}
    }
    for survey in surveys {
        damping(
            reader,
            survey
                .modes
                .values()
                .flatten()
                .filter_map(|mode| mode.damping_ratio.as_ref()),
        );
    }
    doubt_surveys(reader, surveys);
    judge_sensors(reader, structure, surveys);
    judge_directions(reader, structure, surveys);
    for motion in motions {
        turn(reader, motion);
    }
}

/// Combinations that count only a weight that is larger than it is, although weight holds stones in their places.
fn heavier_than_it_is(reader: &mut Reader, loads: &LoadsPart) {
    let all = &loads.combinations;
    let heavy = all.iter().filter(|of| of.weight > 1.0);
    for of in heavy.filter(|of| of.wind != 0.0 || of.loads != 0.0) {
        let covers = |other: &&CombinationPart| {
            other.weight <= 1.0 && other.wind >= of.wind && other.loads >= of.loads
        };
        if let (Some(name), None) = (&of.name, all.iter().find(covers)) {
            let path = format!("combination.{name}.weight");
            let (name, weight) = (path.clone(), ratio(of.weight));
            reader.doubt(&path, Doubted::WeightHolds { path: name, weight });
        }
    }
}

fn damping<'a>(reader: &mut Reader, ratios: impl Iterator<Item = &'a Quantity>) {
    for given in ratios {
        let (path, value) = (given.path.clone(), ratio(given.value));
        if given.value >= DAMPING[1] {
            reader.doubt(&given.path, Doubted::DampingHigh { path, value });
        } else if given.value > 0.0 && given.value < DAMPING[0] {
            reader.doubt(&given.path, Doubted::DampingLow { path, value });
        }
    }
}

/// Whether an angle in degrees is π/6, π/4, π/3, π/2 or a whole multiple, as usual in radians.
pub fn looks_like_radians(degrees: f64) -> bool {
    let parts = [PI / 6.0, PI / 4.0];
    degrees != 0.0
        && degrees.abs() <= TAU * (1.0 + ROUND)
        && parts.iter().any(|part| {
            let whole = (degrees / part).round();
            whole != 0.0 && (degrees - whole * part).abs() < ROUND * part
        })
}

fn turn(reader: &mut Reader, motion: &MotionPart) {
    let Some(degrees) = motion.turn_rad.map(f64::to_degrees) else {
        return;
    };
    if looks_like_radians(degrees) {
        let path = format!("motion.{}.turn", motion.name);
        reader.doubt(
            &path,
            Doubted::TurnRadians {
                path: path.clone(),
                degrees: ratio(degrees),
            },
        );
    }
}

fn chain_frequencies(reader: &mut Reader, (part, loads): (&ChainPart, &LoadsPart), surveys: &[Survey]) {
    let pick = &mut Quantity::nominal;
    for direction in surveyed(surveys) {
        let axis = part.axis_of(&direction);
        let chain = part.build_loaded(axis, loads, pick).ok();
        let modes = chain.and_then(|chain| {
            let stiffness = part.stiffness_towards(axis, pick)?;
            chain.natural_modes(&stiffness).ok()
        });
        frequencies(reader, modes.as_deref().unwrap_or_default(), &direction, surveys);
    }
}

fn frame_frequencies(reader: &mut Reader, part: &FramePart, surveys: &[Survey]) {
    for direction in &part.directions {
        let modes = part.build(&mut Quantity::nominal).ok().and_then(|frame| {
            let stiffness: Vec<f64> = direction
                .stiffness
                .as_ref()?
                .iter()
                .map(Quantity::nominal)
                .collect();
            frame.natural_modes(&stiffness).ok()
        });
        frequencies(
            reader,
            modes.as_deref().unwrap_or_default(),
            &direction.name,
            surveys,
        );
    }
}

fn surveyed(surveys: &[Survey]) -> Vec<String> {
    let mut names: Vec<String> = surveys
        .iter()
        .flat_map(|survey| survey.modes.keys().cloned())
        .collect();
    names.sort();
    names.dedup();
    names
}

/// Compares every measured mode with the mode of the model that has the same number.
fn frequencies(reader: &mut Reader, modes: &[NaturalMode], direction: &str, surveys: &[Survey]) {
    for survey in surveys {
        let listed = survey.modes.get(direction).into_iter().flatten();
        let sways = listed.filter(|mode| mode.kind == ModeKind::Translation);
        for (measured, model) in sways.zip(modes) {
            let (measured_hz, model_hz) = (measured.frequency.value, model.frequency_hz);
            if let Some(likely) = likely(measured_hz, model_hz) {
                let path = measured.frequency.path.clone();
                let doubted = Doubted::Frequency {
                    path: path.clone(),
                    measured: hertz(measured_hz),
                    model: hertz(model_hz),
                    likely: likely.into(),
                };
                reader.doubt(&path, doubted);
            }
        }
    }
}

/// The likely slip behind a measured frequency that differs from that of the model; `None` where no slip gives their ratio, or they agree.
pub fn likely(measured_hz: f64, model_hz: f64) -> Option<Doubted> {
    if !(measured_hz > 0.0 && model_hz > 0.0) {
        return None;
    }
    let near = |value: f64, factor: f64| (value / factor).ln().abs() < NEAR;
    let ratio = measured_hz / model_hz;
    let either = |factor: f64| near(ratio, factor) || near(1.0 / ratio, factor);
    if near(ratio, TAU) {
        Some(Doubted::RadiansPerSecond)
    } else if near(measured_hz * model_hz, 1.0) && ratio.ln().abs() > 3.0 * NEAR {
        Some(Doubted::Period)
    } else if either(180.0_f64.sqrt() / PI.sqrt()) {
        Some(Doubted::PerDegree)
    } else if either(10.0_f64.sqrt()) {
        Some(Doubted::Tenfold)
    } else if either(1000.0_f64.sqrt()) {
        Some(Doubted::Thousandfold)
    } else {
        None
    }
}
