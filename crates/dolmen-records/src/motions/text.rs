//! Text in columns: time and acceleration, or acceleration alone with a step that the options give.

use super::spike::{Codes, refuse_spikes};
use super::{MotionError, MotionFormat, MotionOptions, Orientation};
use crate::records::{
    Column, CsvLayout, FileUnit, Header, Layout, LostSamples, Pick, Reading, RecordError, RecordOptions,
    TimeColumn, bracketed_unit, read_csv,
};
use crate::seismic::Raw;
use crate::unit::Unit;
use dolmen::signal::{Channel, Quantity};

/// Names that the reader of records gives to unnamed columns.
const UNNAMED: [&str; 2] = ["ch1", "ch2"];

/// The samples as printed in the file: of the column in the options, otherwise of every column except the time.
pub(super) fn read(bytes: &[u8], options: &MotionOptions) -> Result<Vec<Raw>, MotionError> {
    let (reading, column) = read_wanted(bytes, options)?;
    let Layout::Csv(layout) = &reading.layout else {
        return Err(RecordError::Empty.into()); // the reader of CSV gives no other layout
    };
    let channels = reading.record.channels();
    let are_several = channels.len() > 1;
    let given = options.time_step_s;
    let step_s = given.unwrap_or(1.0 / reading.record.sampling_rate_hz());
    let line_of = |sample: usize| line_of_sample(bytes, layout, sample);
    for (at, channel) in channels.iter().enumerate() {
        let checked = refuse_spikes(reading.record.samples(at), step_s, Codes::Possible, &line_of);
        checked.map_err(|fault| match are_several {
            true => MotionError::Channel {
                channel: channel.name.clone(),
                fault: Box::new(fault),
            },
            false => fault,
        })?;
    }
    let each = channels.iter().enumerate().map(|(at, channel)| {
        let of_number = |number: usize| layout.columns.get(number.saturating_sub(1)).cloned();
        let header = match &column {
            Some(Column::Number(number)) => of_number(*number).unwrap_or_default(),
            _ => channel.name.clone(),
        };
        Raw {
            name: match are_several {
                true => header.clone(),
                false => options.channel.clone().unwrap_or_default(),
            },
            samples: reading.record.samples(at).to_vec(),
            unit: unit_in_name(&header),
            orientation: direction_in_name(&header),
            quantity: quantity_in_name(&header),
            ..Raw::new(MotionFormat::Text, step_s)
        }
    });
    Ok(each.collect())
}

/// The line of a sample, counted from 1: of the lines below the header, those that begin with a number.
fn line_of_sample(bytes: &[u8], layout: &CsvLayout, sample: usize) -> Option<usize> {
    let above = layout
        .header_line
        .or(layout.passed_over.map(|[_, last]| last))
        .unwrap_or(0);
    let is_number = |line: &[u8]| {
        let first = line.iter().find(|byte| !byte.is_ascii_whitespace());
        first.is_some_and(|byte| byte.is_ascii_digit() || matches!(byte, b'+' | b'-' | b'.' | b'"'))
    };
    let lines = bytes.split(|byte| *byte == b'\n').enumerate().skip(above);
    let mut of_samples = lines.filter(|(_, line)| is_number(line));
    of_samples.nth(sample).map(|(at, _)| at + 1)
}

/// The column to read: by its name, or by its number in the file, counted with the time as in a spreadsheet.
fn wanted(options: &MotionOptions) -> Option<Column> {
    let of_channel = || {
        let given = options.channel.as_ref()?;
        Some(match given.parse() {
            Ok(number) => Column::Number(number),
            Err(_) => Column::Named(given.clone()),
        })
    };
    options.column.clone().or_else(of_channel)
}

/// The columns read, and the one in the options: "EW" also means the single column "EW (gal)".
fn read_wanted(bytes: &[u8], options: &MotionOptions) -> Result<(Reading, Option<Column>), MotionError> {
    let column = wanted(options);
    let refused = match read_columns(bytes, options, column.clone()) {
        Err(refused) => refused,
        Ok(reading) => return Ok((reading, column)),
    };
    let (given, names) = match &refused {
        RecordError::UnknownColumn { given, names, .. } => (given, names),
        RecordError::NoRate { names } => {
            let names = names.clone();
            return Err(MotionError::NoStep { names });
        }
        RecordError::CoarseStamps { .. }
        | RecordError::Jitter { .. }
        | RecordError::RateDisagrees { .. }
        | RecordError::StampsStand { .. }
        | RecordError::TimeText { .. }
        | RecordError::TimeUnit { .. }
        | RecordError::SlowStamps { .. }
        | RecordError::DatesDisagree { .. } => return Err(of_step(refused)),
        RecordError::ColumnUnitsDiffer {
            column,
            found,
            other,
            unit,
            ..
        } => {
            return Err(MotionError::ColumnsDiffer {
                column: column.clone(),
                found,
                other: other.clone(),
                unit,
            });
        }
        _ => return Err(refused.into()),
    };
    let meant: Vec<usize> = (0..names.len())
        .filter(|at| is_meant(given, &names[*at]))
        .collect();
    match meant.as_slice() {
        [] => Err(refused.into()),
        [one] => {
            let column = Some(Column::Number(one + 1));
            Ok((read_columns(bytes, options, column.clone())?, column))
        }
        several => Err(MotionError::Channels {
            given: Some(given.clone()),
            names: several.iter().map(|at| names[*at].clone()).collect(),
        }),
    }
}

/// The error of time stamps of a motion, whose key is its step and not its rate.
fn of_step(refused: RecordError) -> MotionError {
    match refused {
        RecordError::CoarseStamps {
            line,
            step_s,
            step_before_s,
            resolution_s,
        } => MotionError::CoarseStamps {
            line,
            step_s,
            step_before_s,
            resolution_s,
        },
        RecordError::Jitter {
            line,
            stamp_s,
            step_s,
            even_step_s,
        } => MotionError::Jitter {
            line,
            stamp_s,
            step_s,
            even_step_s,
        },
        RecordError::RateDisagrees { given, stamps_hz } => MotionError::StepDisagrees {
            given: 1.0 / given,
            found: 1.0 / stamps_hz,
        },
        fault => MotionError::OfRate {
            fault: Box::new(fault),
        },
    }
}

/// Whether a given name, in any case, is that of a column without its unit.
fn is_meant(given: &str, column: &str) -> bool {
    let plain = |name: &str| without_unit(name).to_lowercase();
    !given.trim().is_empty() && given.trim().to_lowercase() == plain(column)
}

fn read_columns(
    bytes: &[u8],
    options: &MotionOptions,
    column: Option<Column>,
) -> Result<Reading, RecordError> {
    let pick = column.map(|column| Pick {
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
    let refused = match unnamed_stamps {
        true => {
            told.time = TimeColumn::At(Column::Number(1));
            match read_csv(bytes, &told) {
                Err(refused) => refused,
                reading => return reading,
            }
        }
        false => refused,
    };
    let scatter = matches!(
        refused,
        RecordError::CoarseStamps { .. } | RecordError::Jitter { .. } | RecordError::StampsStand { .. }
    );
    // whoever gives the step says that no sample is lost
    if scatter && options.time_step_s.is_some() {
        told.lost_samples = LostSamples::NoneLost;
        return read_csv(bytes, &told);
    }
    Err(refused)
}

/// Units at the end of column names without brackets: "acceleration_m_s2".
const ENDINGS: [(&str, Unit); 6] = [
    ("_mm_s2", Unit::MillimetrePerSecondSquared),
    ("_cm_s2", Unit::Gal),
    ("_m_s2", Unit::MetrePerSecondSquared),
    ("_gal", Unit::Gal),
    ("_mg", Unit::MilliGravity),
    ("_g", Unit::Gravity),
];

/// The unit at the end of a column name: "acceleration_m_s2", "acc (g)", "동서 [cm/s^2]".
fn unit_in_name(name: &str) -> Option<Unit> {
    match bracketed_unit(name) {
        FileUnit::Known(unit) => Some(unit),
        FileUnit::Other(_) => None,
        FileUnit::Silent => {
            let lower = name.to_lowercase();
            let ending = ENDINGS.iter().find(|(ending, _)| lower.ends_with(ending));
            ending.map(|(_, unit)| *unit)
        }
    }
}

/// The name of a column without its unit.
fn without_unit(name: &str) -> &str {
    let name = name.trim();
    if let Some(inside) = name.strip_suffix([']', ')', '）'])
        && let Some((before, _)) = inside.rsplit_once(['[', '(', '（'])
    {
        return before.trim_end();
    }
    let before = ENDINGS.iter().find_map(|(ending, _)| {
        let cut = name.len().checked_sub(ending.len())?;
        let is_it = name.get(cut..)?.eq_ignore_ascii_case(ending);
        is_it.then(|| &name[..cut])
    });
    before.unwrap_or(name)
}

/// Words other than the direction in column names: "동서방향 가속도", "EW component".
const BESIDE: [&str; 9] = [
    "가속도",
    "방향",
    "성분",
    "ACCELERATION",
    "ACCEL",
    "ACC",
    "COMPONENT",
    "COMP",
    "DIRECTION",
];

/// Words for velocities and displacements in column names.
const VELOCITY: [&str; 5] = ["VEL", "VELO", "VELOC", "VELOCITY", "속도"];
const DISPLACEMENT: [&str; 6] = ["DIS", "DISP", "DISPL", "DISPLACEMENT", "DISPLACEMENTS", "변위"];

/// The quantity that a column name states, if it is not acceleration.
fn quantity_in_name(name: &str) -> Option<Quantity> {
    let whole = without_unit(name).to_uppercase();
    let has = |known: &[&str]| {
        let mut words = whole.split([' ', '_', ':', '.', '-', '(', ')', ',']);
        words.any(|word| known.contains(&word))
    };
    if has(&["ACC", "ACCEL", "ACCELERATION", "가속도"]) {
        None
    } else if has(&VELOCITY) {
        Some(Quantity::Velocity)
    } else if has(&DISPLACEMENT) {
        Some(Quantity::Displacement)
    } else {
        None
    }
}

/// The direction of a column from its name: "EW (gal)", "N-S", "UD", "HNE", "동서(gal)", "동서방향 가속도". `None` for a number, and for x, y or a bare
/// N.
fn direction_in_name(name: &str) -> Option<Orientation> {
    let whole = without_unit(name).to_uppercase();
    let words = whole.split([' ', '_', ':']).map(|word| {
        let direction = word.strip_suffix("방향").or_else(|| word.strip_suffix("성분"));
        direction.unwrap_or(word)
    });
    let mut words = words.filter(|word| !word.is_empty() && !BESIDE.contains(word));
    let (word, more) = (words.next()?, words.next());
    if more.is_some() {
        return None;
    }
    match word {
        "동서" | "동-서" => Some(Orientation::EAST),
        "남북" | "남-북" => Some(Orientation::NORTH),
        "상하" | "상-하" | "연직" | "수직" => Some(Orientation::Up),
        word if word.chars().count() < 2 || word.parse::<f64>().is_ok() => None,
        word => Orientation::of_word(word).or_else(|| {
            let code: Vec<char> = word.chars().collect();
            let is_code = matches!(code.as_slice(), [band, 'H' | 'L' | 'N' | 'G', 'E' | 'N' | 'Z'] if "BHSECDL".contains(*band));
            is_code.then(|| Orientation::of_channel_code(word)).flatten()
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_names_of_columns_say_unit_and_direction() {
        let east = Some(Orientation::EAST);
        for (name, unit, direction) in [
            ("EW(gal)", Some(Unit::Gal), east),
            ("NS (cm/s^2)", Some(Unit::Gal), Some(Orientation::NORTH)),
            ("UD", None, Some(Orientation::Up)),
            ("HNE", None, east),
            ("동서 [cm/s²]", Some(Unit::Gal), east),
            ("남북（g）", Some(Unit::Gravity), Some(Orientation::NORTH)),
            ("EW (%g)", Some(Unit::PercentGravity), Some(Orientation::EAST)),
            (
                "상하_m_s2",
                Some(Unit::MetrePerSecondSquared),
                Some(Orientation::Up),
            ),
            ("x_m_s2", Some(Unit::MetrePerSecondSquared), None),
            ("동서방향 가속도 (cm/s2)", Some(Unit::Gal), east),
            ("가속도_연직", None, Some(Orientation::Up)),
            ("EW component [g]", Some(Unit::Gravity), east),
            ("동서 남북", None, None),
            ("180", None, None),
            ("N", None, None),
            ("roof (north)", None, None),
        ] {
            assert_eq!(
                (unit_in_name(name), direction_in_name(name)),
                (unit, direction),
                "{name}"
            );
        }
        assert!(is_meant("ew", "EW(gal)") && is_meant("동서", "동서 [cm/s²]") && is_meant("X", "x_m_s2"));
        assert!(!is_meant("E", "EW(gal)") && !is_meant("", "(gal)"));
    }
}
