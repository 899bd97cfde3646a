//! The history of a structure: works on it, readings of loggers, and settings for watching its surveys.

use crate::names::Names;
use crate::units::parse_unit;

/// Settings for watching many surveys: `[watch]`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WatchPart {
    /// Mean time between false alarms, years; `None` leaves the choice to the method.
    pub years_between_false_alarms: Option<f64>,
    /// Limit of the tilt.
    pub tilt_limit: Option<f64>,
    /// Works, in the order of the file.
    pub works: Vec<WorkPart>,
    /// Logs, by name.
    pub logs: Vec<LogPart>,
}

/// A column of a logger's file.
#[derive(Clone, Debug, PartialEq)]
pub struct LogPart {
    /// Its name in the project.
    pub name: String,
    /// Its label in tables and figures; `None`: its name.
    pub label: Option<Names>,
    /// Path of the file, relative to the project.
    pub file: String,
    /// The column; `None` where the file has only one.
    pub column: Option<String>,
    /// Its quantity.
    pub kind: LogKind,
    /// Unit of the readings as written.
    pub unit: String,
    /// SI units per reading: rad of an angle, the ratio of another tilt, m, °C.
    pub factor: f64,
    /// Whether readings are angles, whose tangent is the tilt.
    pub is_angle: bool,
    /// The value at a reading of 0, SI; `None` where it is unknown.
    pub zero: Option<f64>,
    /// The limit, SI.
    pub limit: Option<f64>,
}

impl LogPart {
    /// A reading in SI units, by the zero of the sensor.
    pub fn si(&self, reading: f64) -> f64 {
        match self.is_angle {
            true => (reading * self.factor).tan(),
            false => reading * self.factor,
        }
    }

    /// Whether the file states a known unit that differs from that of the project.
    pub fn contradicts(&self, stated: &str) -> bool {
        const OTHER_SCALES: [&str; 6] = ["f", "degf", "deg f", "°f", "k", "kelvin"];
        const CELSIUS: [&str; 8] = ["°c", "℃", "degc", "deg c", "deg_c", "celsius", "c", "도c"];
        const FAHRENHEIT: [&str; 4] = ["°f", "℉", "degf", "deg f"];
        let stated = stated.trim().to_lowercase();
        if self.kind == LogKind::Temperature {
            let is_degree = matches!(stated.as_str(), "deg" | "degree" | "degrees" | "°");
            return OTHER_SCALES.contains(&stated.as_str())
                || stated == "%"
                || !is_degree && !CELSIUS.contains(&stated.as_str()) && parse_unit(&stated).is_ok();
        }
        if CELSIUS[..6].contains(&stated.as_str()) || FAHRENHEIT.contains(&stated.as_str()) {
            return true;
        }
        let stated = match stated.as_str() {
            "degree" | "degrees" | "°" | "도" => "deg",
            "라디안" => "rad",
            "밀리라디안" => "mrad",
            "퍼센트" => "%",
            "미터" => "m",
            "센티미터" => "cm",
            "밀리미터" => "mm",
            // units that no key of a project has
            "µm/m" | "μm/m" | "um/m" | "µm" | "μm" | "um" | "㎛" | "arcsec" | "arcmin" | "분" | "초"
            | "\"" | "″" | "′" | "mv" | "v" | "volt" | "volts" | "볼트" | "밀리볼트" | "counts"
            | "카운트" => {
                return true;
            }
            other => other,
        };
        let (Ok(stated), Ok(own)) = (parse_unit(stated), parse_unit(&self.unit)) else {
            return false; // no unit that we know
        };
        stated.dimension != own.dimension || (stated.factor / own.factor - 1.0).abs() > 1e-6
    }
}

/// The quantity that a logger measures.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LogKind {
    /// A tilt, horizontal over vertical, in a direction.
    Tilt {
        /// The direction.
        direction: String,
    },
    /// The width of a crack or joint, m, growing as it opens.
    Crack,
    /// Temperature of the air or the stone, °C.
    Temperature,
}

/// A work on the structure, or an event.
#[derive(Clone, Debug, PartialEq)]
pub struct WorkPart {
    /// Date: "2018", "2018-05" or "2018-05-10".
    pub date: String,
    /// Description.
    pub what: Option<String>,
    /// Its kind.
    pub kind: WorkKind,
}

/// The kind of a work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WorkKind {
    /// The structure was changed on purpose: its reference levels are determined anew.
    Repair,
    /// Somebody looked at it.
    Inspection,
    /// Sensors were exchanged or moved.
    Sensors,
    /// An earthquake, a storm, a collision.
    Event,
}

impl WorkKind {
    /// The word in project files.
    pub fn word(self) -> &'static str {
        match self {
            WorkKind::Repair => "repair",
            WorkKind::Inspection => "inspection",
            WorkKind::Sensors => "sensors",
            WorkKind::Event => "event",
        }
    }
}

/// The year, month and day at the start of a text, 0 for missing ones: "2019", "2019-04", "2019-04-02", "2019.04.02", "2019. 4. 2.",
/// "2019/4/2", "20190402", "2019년 4월 2일".
pub fn date_of(text: &str) -> Option<[u32; 3]> {
    let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
    let number = |text: &str| text.parse::<u32>().ok();
    let within = |most: u32| move |n: &u32| (1..=most).contains(n);
    if digits(text) == 8 {
        let month = number(&text[4..6]).filter(within(12))?;
        let day = number(&text[6..8]).filter(within(31))?;
        return Some([number(&text[..4])?, month, day]);
    }
    if digits(text) != 4 {
        return None;
    }
    let year = number(&text[..4])?;
    // separators between two numbers, and the least number of digits of the next: "2019-1" may be the first survey of a year
    let next = |rest: &str, marks: &[(char, usize)], most: u32| -> Option<(u32, usize)> {
        let rest_at = |at: usize| rest.get(at..);
        let (mark, least) = *marks.iter().find(|(mark, _)| rest.starts_with(*mark))?;
        let at = mark.len_utf8();
        let spaces = rest_at(at)?.bytes().take_while(|byte| *byte == b' ').count();
        let digits_at = at + spaces;
        let count = digits(rest_at(digits_at)?);
        let value = number(&rest[digits_at..digits_at + count]).filter(within(most))?;
        (least..=2).contains(&count).then_some((value, digits_at + count))
    };
    let rest = &text[4..];
    let Some((month, used)) = next(rest, &[('-', 2), ('.', 1), ('/', 1), ('년', 1)], 12) else {
        return Some([year, 0, 0]);
    };
    let day = next(&rest[used..], &[('-', 2), ('.', 1), ('/', 1), ('월', 1)], 31);
    match (day, rest.starts_with(['.', '/'])) {
        (Some((day, _)), _) => Some([year, month, day]),
        // "2019.1" may be the first survey of a year, "2019.04" is a month
        (None, true) if used < 3 => Some([year, 0, 0]),
        (None, _) => Some([year, month, 0]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_units_of_a_file_are_held_against_those_of_the_project() {
        let log = |kind: LogKind, unit: &str| LogPart {
            name: "a".to_owned(),
            label: None,
            file: "a.dat".to_owned(),
            column: None,
            kind,
            unit: unit.to_owned(),
            factor: 1.0,
            is_angle: false,
            zero: None,
            limit: None,
        };
        let tilt = LogKind::Tilt {
            direction: "x".to_owned(),
        };
        for (kind, own, stated, contradicts) in [
            (tilt.clone(), "deg", "Deg", false),
            (tilt.clone(), "deg", "degrees", false),
            (tilt.clone(), "deg", "mrad", true),
            (tilt.clone(), "mm/m", "Volts", true),
            (tilt.clone(), "mm/m", "µm/m", true),
            (tilt.clone(), "mm/m", "도", true),
            (tilt.clone(), "deg", "도", false),
            (tilt.clone(), "deg", "분", true),
            (tilt.clone(), "deg", "초", true),
            (tilt.clone(), "deg", "밀리라디안", true),
            (tilt.clone(), "mm/m", "밀리라디안", false), // one number in both
            (tilt.clone(), "mrad", "밀리라디안", false),
            (tilt.clone(), "mm/m", "북", false),
            (tilt.clone(), "mm/m", "볼트", true),
            (LogKind::Crack, "mm", "밀리미터", false),
            (LogKind::Crack, "mm", "μm", true),
            (LogKind::Temperature, "°C", "도", false),
            (tilt, "mm/m", "mm", true),
            (LogKind::Crack, "mm", "MM", false),
            (LogKind::Crack, "mm", "cm", true),
            (LogKind::Temperature, "°C", "Deg C", false),
            (LogKind::Temperature, "°C", "Deg F", true),
            (LogKind::Temperature, "°C", "mm/m", true),
            (LogKind::Temperature, "°C", "℃", false),
            (LogKind::Temperature, "°C", "north", false),
            (LogKind::Crack, "mm", "°C", true),
            (LogKind::Crack, "mm", "N", false),
        ] {
            assert_eq!(log(kind, own).contradicts(stated), contradicts, "{own} {stated}");
        }
    }

    #[test]
    fn holds_dates_as_people_write_them() {
        for name in [
            "2026-03-09",
            "2026.03.09",
            "2026. 3. 9.",
            "2026.3.9",
            "2026/3/9",
            "20260309",
            "2026년 3월 9일",
            "2026년3월9일",
            "2026-03-09T10:30",
            "2026-03-09 before",
        ] {
            assert_eq!(date_of(name), Some([2026, 3, 9]), "{name}");
        }
        for name in ["2026-03", "2026.03", "2026년 3월", "2026년 3월 정기점검"] {
            assert_eq!(date_of(name), Some([2026, 3, 0]), "{name}");
        }
        for name in [
            "2026",
            "2026년",
            "2026-1",
            "2026.1",
            "2026-restored",
            "2026 (2)",
            "2026-13-01",
        ] {
            assert_eq!(date_of(name), Some([2026, 0, 0]), "{name}");
        }
        for name in ["정기점검 2026", "first", "", "202603", "20261301", "202603091"] {
            assert_eq!(date_of(name), None, "{name}");
        }
    }
}
