//! K-NET and KiK-net ASCII: one component of a Japanese station, integers with one scale.
//!
//! ```text
//! Origin Time       2018/01/24 19:51:00        17 lines of header, then 8 numbers of 9 characters a line
//! Sampling Freq(Hz) 100Hz
//! Duration Time(s)  97
//! Dir.              E-W                        or 1 … 6 for KiK-net: 1-3 in the borehole, 4-6 at the surface
//! Scale Factor      3920(gal)/6182761          acceleration = integer × 3920 / 6182761 gal − its mean
//! Max. Acc. (gal)   11.971
//! ```

use super::lines::{Lines, all_numbers, refused, text};
use super::raw::{MotionFormat, Raw};
use super::{Orientation, SeismicError};
use crate::start;
use crate::unit::Unit;
use crate::wrong::OfStation;

const FIRST: &[u8] = b"Origin Time";
const HEADER_LINES: usize = 17;
/// Delay that the recorders add to the time of the first sample, s.
///
/// # Source
/// National Research Institute for Earth Science and Disaster Resilience, *K-NET ASCII format*: the record time is late by 15 s; ObsPy 1.5.1
/// subtracts this too.
const RECORDED_LATE_S: f64 = 15.0;
/// Japan standard time, used in headers, minus UTC, s.
const JAPAN_S: f64 = 9.0 * 3600.0;
const BOREHOLE: &str = "borehole";
/// Directions of KiK-net: in the borehole, then at the surface.
const KIK_NET: [(&str, &str, &str); 6] = [
    ("1", "N-S", BOREHOLE),
    ("2", "E-W", BOREHOLE),
    ("3", "U-D", BOREHOLE),
    ("4", "N-S", "surface"),
    ("5", "E-W", "surface"),
    ("6", "U-D", "surface"),
];

pub(super) fn is_knet(bytes: &[u8]) -> bool {
    let mut lines = Lines::new(bytes);
    lines.next().is_some_and(|(_, line)| line.starts_with(FIRST))
}

/// The header: text after each label, with its line number.
struct Header<'a>(Vec<(usize, &'a [u8])>);

impl Header<'_> {
    fn after(&self, label: &'static str) -> Result<(usize, String), SeismicError> {
        let found = self.0.iter().find(|(_, line)| line.starts_with(label.as_bytes()));
        let line = found.ok_or(SeismicError::Missing {
            label,
            lines: HEADER_LINES,
        })?;
        let rest = String::from_utf8_lossy(&line.1[label.len()..]);
        Ok((line.0, rest.trim().to_owned()))
    }

    fn number(&self, label: &'static str, suffix: &str, wanted: OfStation) -> Result<f64, SeismicError> {
        let (line, text) = self.after(label)?;
        let number = text.trim_end_matches(suffix).trim().parse::<f64>().ok();
        number
            .filter(|value| value.is_finite() && *value > 0.0)
            .ok_or(SeismicError::Line {
                line,
                text,
                wanted: wanted.into(),
            })
    }
}

pub(super) fn read(bytes: &[u8]) -> Result<Vec<Raw>, SeismicError> {
    let mut lines = Lines::new(bytes);
    let mut header = Header(Vec::new());
    for _ in 0..HEADER_LINES {
        let line = lines.want(OfStation::KnetHeader)?;
        header.0.push(line);
        if line.1.starts_with(b"Memo.") {
            break;
        }
    }
    let rate_hz = header.number("Sampling Freq(Hz)", "Hz", OfStation::KnetRate)?;
    let duration_s = header.number("Duration Time(s)", "", OfStation::KnetDuration)?;
    let (line, scale) = header.after("Scale Factor")?;
    let wanted = || OfStation::KnetScale;
    let bad_scale = || refused((line, scale.as_bytes()), wanted());
    let (of, divisor) = scale.split_once('/').ok_or_else(bad_scale)?;
    let of = of.trim().strip_suffix("(gal)").ok_or_else(bad_scale)?;
    let positive = |text: &str| {
        text.trim()
            .parse::<f64>()
            .ok()
            .filter(|v| v.is_finite() && *v > 0.0)
    };
    let (of, divisor) = (
        positive(of).ok_or_else(bad_scale)?,
        positive(divisor).ok_or_else(bad_scale)?,
    );
    let (_, direction) = header.after("Dir.")?;
    let kik_net = KIK_NET.iter().find(|(number, ..)| *number == direction);
    let (word, place) = kik_net.map_or((direction.as_str(), ""), |(_, word, place)| (*word, *place));
    let peak = header.number("Max. Acc. (gal)", "", OfStation::KnetPeak).ok();
    let (_, station) = header.after("Station Code")?;
    let begins = header
        .after("Record Time")
        .ok()
        .and_then(|(_, time)| start::start_of_text(&time))
        .map(|at| at - RECORDED_LATE_S - JAPAN_S);
    let title = text((1, header.0[0].1));
    let counts = all_numbers(lines)?;
    let stated = (rate_hz * duration_s).round();
    if stated != counts.len() as f64 {
        return Err(SeismicError::Count {
            stated: stated as u64,
            found: counts.len(),
        });
    }
    let name = format!("{station} {word} {place}");
    Ok(vec![Raw {
        name: name.trim().to_owned(),
        title: format!(
            "{station}, {}",
            title
                .replace("Origin Time", "earthquake of")
                .split_whitespace()
                .collect::<Vec<_>>()
                .join(" ")
        ),
        samples: counts.into_iter().map(|count| count * of / divisor).collect(),
        unit: Some(Unit::Gal),
        orientation: Orientation::of_word(word),
        begins_s: begins,
        subtract_mean: true,
        stated_peak: peak,
        is_borehole: place == BOREHOLE,
        ..Raw::new(MotionFormat::KNet, 1.0 / rate_hz)
    }])
}
