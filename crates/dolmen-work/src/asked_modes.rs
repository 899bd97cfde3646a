//! Identification options from a project file.

use crate::error::{Within as _, WorkError};
use dolmen::modal::{Criteria, Identify};
use dolmen::signal::Channel;
use dolmen_project::RecordSource;

/// The identification options of the file.
pub(crate) fn options(source: &RecordSource, channels: &[Channel]) -> Result<Identify, WorkError> {
    let defaults = Identify::default();
    Ok(Identify {
        method: source.modal.method.unwrap_or(defaults.method),
        references: references(&source.modal.references, channels).within(|| source.file.clone())?,
        inputs: inputs(&source.modal.inputs, channels).within(|| source.file.clone())?,
        pick_hz: source.modal.pick_hz.clone(),
        accept_hz: source.modal.accept_hz.clone(),
        harmonics: source.modal.harmonics.unwrap_or(defaults.harmonics),
        frequency_low_hz: source.modal.frequency_low_hz,
        frequency_high_hz: source.modal.frequency_high_hz,
        block_rows: source.modal.block_rows,
        order_most: source.modal.order_most,
        criteria: Criteria {
            damping_ratio_least: source.modal.damping_least,
            damping_ratio_most: source
                .modal
                .damping_most
                .unwrap_or(defaults.criteria.damping_ratio_most),
            ..defaults.criteria
        },
        modes_wanted: source.modal.modes_wanted,
        ..defaults
    })
}

/// Indices of the reference channels.
fn references(names: &[String], channels: &[Channel]) -> Result<Vec<usize>, WorkError> {
    places(names, channels, |name, known| WorkError::NoSuchReference {
        name,
        known,
    })
}

/// Indices of the input channels.
fn inputs(names: &[String], channels: &[Channel]) -> Result<Vec<usize>, WorkError> {
    places(names, channels, |name, known| WorkError::NoSuchInput {
        name,
        known,
    })
}

/// Index of the channel of the spectrogram.
pub(crate) fn drawn(name: Option<&String>, channels: &[Channel]) -> Result<Option<usize>, WorkError> {
    let names = name.map_or(&[][..], std::slice::from_ref);
    let found = places(names, channels, |name, known| WorkError::NoSuchSpectrogram {
        name,
        known,
    })?;
    Ok(found.first().copied())
}

/// Indices of the channels with these names; `missing` makes the error from an unknown name and the list of names.
fn places(
    names: &[String],
    channels: &[Channel],
    missing: fn(String, String) -> WorkError,
) -> Result<Vec<usize>, WorkError> {
    let place = |name: &String| {
        let at = channels.iter().position(|channel| channel.name == *name);
        at.ok_or_else(|| {
            let known: Vec<&str> = channels.iter().map(|channel| channel.name.as_str()).collect();
            missing(name.clone(), known.join(", "))
        })
    };
    names.iter().map(place).collect()
}
