//! Numbers that replace others in the text of a project file; comments, order and everything else stay unchanged.

use crate::Project;
use std::ops::Range;
use toml::de::DeTable;

/// An identified number, written as `{ value, unit, sd, source = "identified", survey, note }`.
#[derive(Clone, Debug, PartialEq)]
pub struct IdentifiedNumber {
    /// The value, SI.
    pub value: f64,
    /// Its standard deviation, SI; `None` where it is not known.
    pub sd: Option<f64>,
    /// The SI unit of `value`: "N m/rad".
    pub unit: &'static str,
    /// The survey.
    pub survey: String,
    /// The replaced text; `None` where it was also an identified number.
    pub before: Option<String>,
    /// Its note: the text before any identification.
    pub note: Option<String>,
}

/// The replacement of a value of the file.
#[derive(Clone, Debug, PartialEq)]
pub enum NewValue {
    /// A number.
    Number(IdentifiedNumber),
    /// A list of numbers.
    Numbers(Vec<IdentifiedNumber>),
    /// A list of tables with one key, a number each.
    Each(&'static str, Vec<IdentifiedNumber>),
    /// Lengths, m, in a list.
    Lengths(Vec<f64>),
}

/// The text of a project file with values replaced at their paths (`joints`, `floors[1].stiffness.x`), parts counted from 1. A key of a table
/// `[direction.NAME]` that the file does not have is added at the end of the table.
///
/// # Errors
/// A path that the text does not contain: its value is in a table beside the file.
pub fn with_values(text: &str, project: &Project, values: &[(String, NewValue)]) -> Result<String, String> {
    put(text, project, values, &NewValue::toml)
}

/// [`with_values`] without a new line, so that later text keeps its line numbers.
///
/// # Errors
/// As [`with_values`].
pub fn with_values_on_their_lines(
    text: &str,
    project: &Project,
    values: &[(String, NewValue)],
) -> Result<String, String> {
    put(text, project, values, &|value| value.toml().replace('\n', " "))
}

fn put(
    text: &str,
    project: &Project,
    values: &[(String, NewValue)],
    toml: &dyn Fn(&NewValue) -> String,
) -> Result<String, String> {
    let mut edits: Vec<(Range<usize>, String)> = Vec::new();
    for (path, value) in values {
        let added = path.strip_prefix("direction.").and_then(|of| of.rsplit_once('.'));
        let edit = match (project.spans.get(path), added) {
            (Some(span), _) if !span.is_empty() => (span.clone(), toml(value)),
            (_, Some((direction, key))) => {
                let head = format!("\n[direction.{}]\n{key} = ", quoted(direction));
                (text.len()..text.len(), head + &toml(value) + "\n")
            }
            _ => return Err(path.clone()),
        };
        if text.get(edit.0.clone()).is_none() {
            return Err(path.clone());
        }
        edits.push(edit);
    }
    edits.sort_by_key(|(span, _)| span.start);
    let mut made = text.to_owned();
    for (at, (span, new)) in edits.iter().enumerate().rev() {
        if at > 0 && edits[at - 1].0.end > span.start {
            return Err(values[at].0.clone()); // both stand in one table beside the file
        }
        made.replace_range(span.clone(), new);
    }
    let (_, syntax) = DeTable::parse_recoverable(&made);
    match (syntax.first(), values.first()) {
        (Some(_), Some((path, _))) => Err(path.clone()), // its keys are written in a way that holds no table
        _ => Ok(made),
    }
}

impl NewValue {
    fn toml(&self) -> String {
        match self {
            NewValue::Number(number) => number.toml(),
            NewValue::Numbers(all) => listed(all.iter().map(IdentifiedNumber::toml)),
            NewValue::Each(key, all) => {
                let each = all
                    .iter()
                    .map(|number| format!("{{ {key} = {} }}", number.toml()));
                listed(each)
            }
            NewValue::Lengths(all) => {
                let all: Vec<String> = all
                    .iter()
                    .map(|metres| format!("\"{} m\"", shortest(*metres, 6)))
                    .collect();
                format!("[{}]", all.join(", "))
            }
        }
    }
}

/// A list with a line for each.
fn listed(each: impl Iterator<Item = String>) -> String {
    let lines: String = each.map(|one| format!("  {one},\n")).collect();
    format!("[\n{lines}]")
}

impl IdentifiedNumber {
    fn toml(&self) -> String {
        let (unit, factor) = self.unit();
        let mut said = format!("{{ value = {}", shortest(self.value / factor, self.digits()));
        if !unit.is_empty() {
            said += &format!(", unit = \"{unit}\"");
        }
        if let Some(sd) = self.sd.filter(|sd| *sd > 0.0) {
            said += &format!(", sd = {}", shortest(sd / factor, 3));
        }
        said += &format!(", source = \"identified\", survey = {}", quoted(&self.survey));
        if let Some(note) = &self.note {
            said += &format!(", note = {}", quoted(note));
        }
        said + " }"
    }

    /// The unit in the syntax of project files, with a prefix that leaves few digits before the decimal point.
    fn unit(&self) -> (String, f64) {
        let (prefix, factor) = match self.value.abs() {
            value if value >= 1e9 => ("G", 1e9),
            value if value >= 1e6 => ("M", 1e6),
            value if value >= 1e3 => ("k", 1e3),
            _ => ("", 1.0),
        };
        let unit = self.unit.replace(' ', "*");
        match unit.starts_with(['N', 'P']) {
            true => (prefix.to_owned() + &unit, factor),
            false => (unit, 1.0),
        }
    }

    /// Significant digits: three more than the first digit that the standard deviation affects.
    fn digits(&self) -> usize {
        const WITHOUT_SD: f64 = 1e-3;
        let ratio = self.sd.map_or(WITHOUT_SD, |sd| sd / self.value.abs());
        (3.0 - ratio.log10()).ceil().clamp(4.0, 9.0) as usize
    }
}

/// The number with this many significant digits.
fn shortest(number: f64, digits: usize) -> f64 {
    let text = format!("{number:.*e}", digits.saturating_sub(1));
    text.parse().unwrap_or(number)
}

fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse_project;

    fn number(value: f64, sd: f64, unit: &'static str) -> IdentifiedNumber {
        IdentifiedNumber {
            value,
            sd: Some(sd),
            unit,
            survey: "2026-04-02".into(),
            before: None,
            note: None,
        }
    }

    const GATE: &str = "# the gate\nschema = 1\nkind = \"frame\"\nname = \"Gate\"\nunits = { stiffness = \"kN/mm\", length = \"m\", mass = \"t\" } # as drawn\n\
                        storeys = [{ mass = 290, height = 5.84 }, { mass = 314, height = 7.69 }]\n\n[direction.weak] # along the front\n\
                        # lowest first\nstiffness = [ # from the tender\n  32, # below\n  96, # above\n]\n\n[survey.2026-04-02]\nfrequencies = { weak = [1.1], strong = [1.5] }\n";

    #[test]
    fn exact_comments_and_order_stay() {
        let project = parse_project(GATE, "project.toml").unwrap();
        let values = [
            (
                "direction.weak.stiffness[1]".to_owned(),
                NewValue::Number(number(54.7123e6, 2.1e6, "N/m")),
            ),
            (
                "direction.weak.stiffness[2]".to_owned(),
                NewValue::Number(number(96.14e6, 1.0e6, "N/m")),
            ),
        ];
        let of = |value: &str, sd: &str| {
            format!(
                "{{ value = {value}, unit = \"MN/m\", sd = {sd}, source = \"identified\", survey = \"2026-04-02\" }}"
            )
        };
        let made = with_values(GATE, &project, &values).unwrap();
        let wanted = GATE
            .replace("  32,", &format!("  {},", of("54.712", "2.1")))
            .replace("  96,", &format!("  {},", of("96.14", "1")));
        assert_eq!(made, wanted);
        let read = parse_project(&made, "project.toml").unwrap();
        let below = read.input("direction.weak.stiffness[1]").unwrap();
        assert_eq!(
            (below.value, below.survey.as_deref()),
            (54.712e6, Some("2026-04-02"))
        );
        assert!((below.standard_deviation() / 2.1e6 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn exact_a_direction_that_only_a_survey_names_is_added() {
        let project = parse_project(GATE, "project.toml").unwrap();
        let both = vec![number(40e6, 1e6, "N/m"), number(30e6, 1e6, "N/m")];
        let values = [("direction.strong.stiffness".to_owned(), NewValue::Numbers(both))];
        let made = with_values(GATE, &project, &values).unwrap();
        assert!(made.starts_with(GATE));
        assert!(
            made[GATE.len()..].starts_with("\n[direction.\"strong\"]\nstiffness = [\n  { value = 40, "),
            "{made}"
        );
        parse_project(&made, "project.toml").unwrap();
    }

    #[test]
    fn refuses_a_place_that_the_text_does_not_hold() {
        let project = parse_project(GATE, "project.toml").unwrap();
        let values = [(
            "storeys[3].mass".to_owned(),
            NewValue::Number(number(1.0, 0.1, "kg")),
        )];
        assert_eq!(
            with_values(GATE, &project, &values).unwrap_err(),
            "storeys[3].mass"
        );
    }
}
