//! The ground motion in a survey's record, and the response of the structure above it.

use super::acting::MotionAnswer;
use super::error::MotionRequestError;
use super::measured_response::{MeasuredChannel, MeasuredResponse};
use crate::error::{Within as _, WorkError};
use crate::record::record;
use dolmen::modal::{Shaking, earthquakes_in};
use dolmen::signal::{Channel, Component, GroundMotion, Quantity, Record, cut};
use dolmen_project::{Project, Survey};
use dolmen_records::Files;
use std::sync::Arc;

/// Prefix of the name of a survey in the name of a motion.
pub(crate) const SURVEY: &str = "survey:";
/// Seconds of the record before and after the earthquake that also act. Our choice.
const BEFORE_S: f64 = 2.0;
const BEHIND_S: f64 = 5.0;
/// Smallest cosine between a channel and its axis: 2.5°.
const ALONG: f64 = 0.999;

/// The ground motion measured in a survey's record.
///
/// # Errors
/// No such survey, no record in one file with inputs, or inputs that are not horizontal accelerations of known direction.
pub(super) fn of_survey(name: &str, project: &Project, files: &dyn Files) -> Result<MotionAnswer, WorkError> {
    let Some(survey) = project.surveys.iter().find(|survey| survey.name == name) else {
        let names: Vec<&str> = project.surveys.iter().map(|of| of.name.as_str()).collect();
        return Err(WorkError::NoSuchSurvey {
            name: name.to_owned(),
            known: names.join(", "),
        });
    };
    let inputs = |survey: &Survey| survey.records.as_ref().map(|source| source.modal.inputs.clone());
    let grounds = inputs(survey).unwrap_or_default();
    let source = survey.records.as_ref().filter(|_| !grounds.is_empty());
    let Some(source) = source else {
        let survey = name.to_owned();
        return Err(MotionRequestError::NoMeasuredGround { survey }.into());
    };
    let whole = record(source, files).within(|| source.file.clone())?.record;
    let at: Vec<usize> = (0..whole.channels().len())
        .filter(|c| grounds.contains(&whole.channels()[*c].name))
        .collect();
    let over = |a: &Shaking, b: &Shaking| a.over_noise.total_cmp(&b.over_noise);
    let shaking = earthquakes_in(&whole, &at, &[]).into_iter().max_by(over);
    let whole_s = whole.duration_s();
    let [from_s, to_s] = match &shaking {
        Some(of) => [
            (of.arrival_s - BEFORE_S).max(0.0),
            (of.end_s + BEHIND_S).min(whole_s),
        ],
        None => [0.0, whole_s],
    };
    let means: Vec<f64> = (0..whole.channels().len())
        .map(|c| mean(whole.samples(c)))
        .collect();
    let stands_out = shaking.is_some();
    let part = match shaking {
        Some(_) => cut(whole, from_s, to_s)?,
        None => whole,
    };
    let along = |c: usize, sign: f64| -> Vec<f64> {
        let samples = part.samples(c).iter();
        samples.map(|x| sign * (x - means[c])).collect()
    };
    let mut components: Vec<(Component, Vec<f64>)> = Vec::new();
    for c in &at {
        let channel = &part.channels()[*c];
        let refused = || MotionRequestError::NoGroundAcceleration {
            survey: name.to_owned(),
            channel: channel.name.clone(),
        };
        let (component, sign) = axis_of(channel).ok_or_else(refused)?;
        if components.iter().any(|(other, _)| *other == component) {
            return Err(MotionRequestError::ComponentTwice { component }.into());
        }
        components.push((component, along(*c, sign)));
    }
    let step_s = 1.0 / part.sampling_rate_hz();
    let (channels, left_out) = above(&part, &at, &along);
    let of_each = components
        .iter()
        .map(|(component, _)| (*component, source.file.clone()));
    let files = of_each.collect();
    let motion = GroundMotion::new(format!("{SURVEY}{name}"), step_s, components)?;
    let peaks = Component::ALL.into_iter().filter(|of| motion.has(*of));
    Ok(MotionAnswer {
        peaks_read_m_s2: peaks.map(|of| (of, motion.component_peak_m_s2(of))).collect(),
        turned_rad: None,
        taken_off: None,
        files,
        measured: Some(Arc::new(MeasuredResponse {
            survey: name.to_owned(),
            from_s,
            stands_out,
            step_s,
            channels,
            left_out,
        })),
        motion,
    })
}

fn mean(x: &[f64]) -> f64 {
    x.iter().sum::<f64>() / x.len().max(1) as f64
}

/// The channels that are not inputs: those comparable with a model, and the names of the others.
fn above(
    part: &Record,
    inputs: &[usize],
    along: &dyn Fn(usize, f64) -> Vec<f64>,
) -> (Vec<MeasuredChannel>, Vec<String>) {
    let (mut channels, mut left_out) = (Vec::new(), Vec::new());
    for (c, channel) in part.channels().iter().enumerate() {
        if inputs.contains(&c) {
            continue;
        }
        match (axis_of(channel), channel.position_m) {
            (Some((component, sign)), Some([_, _, height_m])) => channels.push(MeasuredChannel {
                name: channel.name.clone(),
                height_m,
                component,
                acceleration_m_s2: along(c, sign),
            }),
            _ => left_out.push(channel.name.clone()),
        }
    }
    (channels, left_out)
}

/// The axis of an accelerometer, and whether it is reversed.
fn axis_of(channel: &Channel) -> Option<(Component, f64)> {
    let direction = channel
        .direction
        .filter(|_| channel.quantity == Quantity::Acceleration)?;
    let size = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
    let each = Component::ALL.into_iter().zip(direction);
    each.map(|(component, x)| (component, x / size))
        .find(|(_, x)| x.abs() > ALONG)
        .map(|(component, x)| (component, x.signum()))
}
