//! Files of seismic stations, also used for ground motions: miniSEED, SAC, K-NET, ESM, COSMOS, CSMIP.

use super::series::{FileSeries, Series, rate_of_step};
use super::{FileUnit, RecordError, RecordFormat};
use crate::seismic::{MotionFormat, Orientation, Raw, raw_channels};
use crate::unit::Unit;
use crate::wrong::Remark;
use dolmen_words::message::Both;

/// The channels of such a file; `None` for other files.
pub(super) fn read(bytes: &[u8]) -> Option<Result<FileSeries, RecordError>> {
    let read = raw_channels(bytes)?;
    Some(
        read.map_err(|fault| RecordError::Seismic(Box::new(fault)))
            .map(found),
    )
}

fn found(channels: Vec<Raw>) -> FileSeries {
    let format = match channels.first().map(|channel| channel.format) {
        Some(MotionFormat::MiniSeed) | None => RecordFormat::MiniSeed,
        Some(MotionFormat::Sac | MotionFormat::SacText) => RecordFormat::Sac,
        Some(MotionFormat::KNet) => RecordFormat::KNet,
        Some(MotionFormat::Esm) => RecordFormat::Esm,
        Some(_) => RecordFormat::Cosmos,
    };
    let mut notes: Vec<Both> = Vec::new();
    for channel in &channels {
        if let Some(orientation) = channel.orientation {
            let channel = channel.name.clone();
            notes.push(match orientation {
                Orientation::Horizontal { azimuth_deg } => {
                    Remark::PointsFromNorth { channel, azimuth_deg }.into()
                }
                Orientation::Up => Remark::PointsUp(channel).into(),
                Orientation::Down => Remark::PointsDown(channel).into(),
            });
        }
    }
    let series = channels
        .into_iter()
        .map(|channel| series(channel, format))
        .collect();
    FileSeries {
        format,
        series,
        notes,
    }
}

fn series(channel: Raw, format: RecordFormat) -> Series {
    let mut samples = channel.samples;
    if channel.subtract_mean {
        let mean = samples.iter().sum::<f64>() / samples.len().max(1) as f64;
        samples.iter_mut().for_each(|x| *x -= mean);
    }
    let unit = match channel.unit {
        Some(unit) if unit != Unit::Unknown => FileUnit::Known(unit),
        // integers of a recorder: a unit without a scale would be a guess
        _ if format == RecordFormat::MiniSeed && samples.iter().all(|x| x.fract() == 0.0) => {
            FileUnit::Other("counts".to_owned())
        }
        _ => FileUnit::Silent,
    };
    let name = if channel.name.is_empty() {
        "ch1".to_owned()
    } else {
        channel.name
    };
    Series {
        sampling_rate_hz: Some(rate_of_step(channel.time_step_s, 1e-12)),
        unit,
        quantity: channel.quantity,
        begins_s: channel.begins_s,
        breaks: channel.breaks,
        ..Series::new(name, samples)
    }
}
