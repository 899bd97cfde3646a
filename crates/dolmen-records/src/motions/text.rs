//! Text in columns: time and acceleration, or acceleration alone with a step that is told.

use super::{MotionError, MotionFormat, MotionOptions};
use crate::records::{
    Column, Header, Layout, LostSamples, Pick, Reading, RecordError, RecordOptions, TimeColumn, read_csv,
};
use crate::seismic::Raw;
use crate::unit::Unit;
use dolmen::signal::Channel;

/// Names that the reader of records gives to columns without any.
const UNNAMED: [&str; 2] = ["ch1", "ch2"];

/// The samples as the file prints them.
pub(super) fn read(bytes: &[u8], options: &MotionOptions) -> Result<Vec<Raw>, MotionError> {
    let reading = read_columns(bytes, options)?;
    let Layout::Csv(layout) = &reading.layout else {
        return Err(RecordError::Empty.into()); // the reader of CSV gives no other layout
    };
    let channels = reading.record.channels();
    if channels.len() != 1 {
        let names = channels.iter().map(|channel| channel.name.clone()).collect();
        return Err(MotionError::Columns { names });
    }
    let column = match wanted(options) {
        Some(Column::Number(number)) => layout
            .columns
            .get(number.saturating_sub(1))
            .cloned()
            .unwrap_or_default(),
        _ => channels[0].name.clone(),
    };
    let given = options.time_step_s;
    Ok(vec![Raw {
        name: options.channel.clone().unwrap_or_default(),
        samples: reading.record.samples(0).to_vec(),
        unit: unit_in_name(&column)?,
        ..Raw::new(
            MotionFormat::Text,
            given.unwrap_or(1.0 / reading.record.sampling_rate_hz()),
        )
    }])
}

/// The column to read: the one that is told, or the channel where that is a name. A number counts channels, of which there is one.
fn wanted(options: &MotionOptions) -> Option<Column> {
    let named = |name: &&String| name.parse::<usize>().is_err();
    let channel = options.channel.as_ref().filter(named);
    options
        .column
        .clone()
        .or_else(|| channel.map(|name| Column::Named(name.clone())))
}

fn read_columns(bytes: &[u8], options: &MotionOptions) -> Result<Reading, RecordError> {
    let pick = wanted(options).map(|column| Pick {
        scale: None,
        channel: Channel::named(match &column {
            Column::Named(name) => name.clone(),
            Column::Number(number) => format!("column {number}"),
        }),
        column,
    });
    let mut told = RecordOptions {
        lost_samples: LostSamples::Refuse,
        sampling_rate_hz: options.time_step_s.map(|step| 1.0 / step),
        picks: pick.into_iter().collect(),
        header: Header::Detect,
        ..Default::default()
    };
    let refused = match read_csv(bytes, &told) {
        Err(refused) => refused,
        reading => return reading,
    };
    let unnamed_stamps = match &refused {
        RecordError::NoRate { names } => *names == UNNAMED,
        RecordError::LooksLikeTime { column, .. } => column == UNNAMED[0],
        _ => false,
    };
    if unnamed_stamps {
        told.time = TimeColumn::At(Column::Number(1));
        read_csv(bytes, &told)
    } else {
        Err(refused)
    }
}

/// The unit that the name of a column ends in: "acceleration_m_s2", "acc (g)", "a [cm/s2]".
fn unit_in_name(name: &str) -> Result<Option<Unit>, MotionError> {
    let bracketed = name
        .trim_end()
        .strip_suffix([')', ']'])
        .and_then(|rest| rest.rsplit_once(['(', '[']));
    let found = match bracketed {
        Some((_, unit)) => Unit::parse(unit).ok(),
        None => {
            let lower = name.to_lowercase();
            let endings = [
                ("_mm_s2", Unit::MillimetrePerSecondSquared),
                ("_cm_s2", Unit::Gal),
                ("_m_s2", Unit::MetrePerSecondSquared),
                ("_gal", Unit::Gal),
                ("_mg", Unit::MilliGravity),
                ("_g", Unit::Gravity),
            ];
            let ending = endings.iter().find(|(ending, _)| lower.ends_with(ending));
            ending.map(|(_, unit)| *unit)
        }
    };
    Ok(found.filter(|unit| *unit != Unit::Unknown))
}
