//! Runs and capacities as columns, for CSV and Parquet: inputs first, units in the names.

use super::answer::StudyAnswer;
use super::column::{Column, ColumnValues};
use super::journal::joint_words;
use super::kind::StudyKind;
use super::measures::RunMeasures;
use super::method::direction_deg;
use super::run::Run;
use super::scans::{ALLOWED_DRIFT, CapacityOf};
use super::shaking_measure::ShakingMeasure;

fn number(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

/// Adds columns one by one, with one value for each row.
struct Columns<'r, R> {
    rows: &'r [R],
    found: Vec<Column>,
}

impl<R> Columns<'_, R> {
    fn numbers(&mut self, name: &str, of: impl Fn(&R) -> Option<f64>) {
        let values = ColumnValues::Numbers(self.rows.iter().map(of).collect());
        self.found.push(Column {
            name: name.to_owned(),
            values,
        });
    }

    fn counts(&mut self, name: &str, of: impl Fn(&R) -> usize) {
        let values = ColumnValues::Counts(self.rows.iter().map(|row| of(row) as i64).collect());
        self.found.push(Column {
            name: name.to_owned(),
            values,
        });
    }

    fn words(&mut self, name: &str, of: impl Fn(&R) -> String) {
        let values = ColumnValues::Words(self.rows.iter().map(of).collect());
        self.found.push(Column {
            name: name.to_owned(),
            values,
        });
    }
}

/// The inputs of the job of each row.
fn inputs<R>(answer: &StudyAnswer, columns: &mut Columns<'_, R>, job: impl Fn(&R) -> usize + Copy) {
    columns.counts("case", |row| answer.case_of(job(row)) + 1);
    if !answer.study.variants.is_empty() {
        columns.words("variant", |row| {
            answer.case(job(row)).variant.clone().unwrap_or_default()
        });
    }
    for (index, input) in answer.inputs.iter().enumerate() {
        let value = |row: &R| answer.case(job(row)).values.get(index).copied().flatten();
        if input.is_number {
            columns.numbers(&input.column, value);
        } else {
            columns.words(&input.column, |row| {
                let texts = &answer.case(job(row)).texts;
                texts.get(index).cloned().unwrap_or_default()
            });
        }
    }
    if let Some(after) = &answer.study.after {
        columns.words("after", |_| after.motion.clone());
        columns.numbers("peak_before_m_s2", |row| {
            let before = answer.before.get(answer.case_of(job(row)))?;
            number(before.peak_m_s2)
        });
        columns.counts("damage_state_before", |row| {
            let before = answer.before.get(answer.case_of(job(row)));
            before.map_or(0, |before| usize::from(before.damage_state))
        });
    }
    if answer.study.samples.is_some() {
        columns.counts("sample", |row| answer.sample_of(job(row)));
    }
    columns.words("motion", |row| answer.motion_of(job(row)).to_owned());
    columns.numbers("direction_deg", |row| {
        Some(direction_deg(answer.turn_rad(job(row))))
    });
}

/// Every run with its inputs.
pub fn run_columns(answer: &StudyAnswer) -> Vec<Column> {
    let mut columns = Columns {
        rows: &answer.runs,
        found: Vec::new(),
    };
    inputs(answer, &mut columns, |run: &Run| run.job);
    columns.numbers("scale", |run| (run.scale > 0.0).then_some(run.scale));
    columns.numbers("peak_ground_acceleration_m_s2", |run| {
        number(run.peak_ground_acceleration_m_s2)
    });
    columns.numbers("peak_ground_velocity_m_s", |run| {
        number(run.peak_ground_velocity_m_s)
    });
    let other = |measure: &ShakingMeasure| *measure != ShakingMeasure::PeakVelocity;
    for measure in answer.measures().into_iter().filter(other) {
        columns.numbers(&measure.column(), |run| {
            let size = [run.peak_ground_acceleration_m_s2, run.peak_ground_velocity_m_s];
            answer.intensity(run.job, measure, size).and_then(number)
        });
    }
    columns.words("outcome", |run| run.outcome.word().to_owned());
    columns.counts("damage_state", |run| usize::from(run.damage_state));
    if answer.kind == StudyKind::Stack {
        columns.words("joint_states", |run| joint_words(&run.joint_states));
    }
    columns.numbers("at_s", |run| number(run.at_s));
    columns.words("part", |run| run.part.clone());
    columns.words("gave_way", |run| run.gave_way.clone());
    for name in RunMeasures::names(answer.kind) {
        columns.numbers(name, |run| run.measures.named(name).and_then(number));
    }
    columns.words("why", |run| run.why.english.clone());
    columns.found
}

/// Every scan with its inputs and results.
pub fn capacity_columns(answer: &StudyAnswer) -> Vec<Column> {
    let capacities = answer.capacities();
    let mut columns = Columns {
        rows: &capacities,
        found: Vec::new(),
    };
    inputs(answer, &mut columns, |row| row.job);
    let first = |row: &CapacityOf, state: usize| {
        let reached = row.first_m_s2?[state];
        reached.is_reached().then(|| reached.value())
    };
    columns.words("verdict", |row| row.verdict.word().to_owned());
    columns.numbers("first_fall_m_s2", |row| first(row, 3));
    columns.numbers("first_fall_scale", |row| {
        let scan = row.scan.as_ref().filter(|_| row.verdict.is_usable())?;
        scan.first_fall
    });
    columns.numbers("survived_below_m_s2", |row| Some(row.survived_m_s2()));
    columns.numbers("least_fall_m_s2", CapacityOf::fell_m_s2);
    columns.numbers("largest_tried_m_s2", CapacityOf::largest_m_s2);
    columns.counts("survived_above", |row| row.survived_above_m_s2().len());
    columns.words("survived_above_m_s2", |row| {
        let each = row.survived_above_m_s2();
        let texts: Vec<String> = each.iter().map(f64::to_string).collect();
        texts.join(" ")
    });
    columns.counts("unusable", CapacityOf::unusable_runs);
    for state in 0..3 {
        columns.numbers(&format!("first_ds{}_m_s2", state + 1), |row| first(row, state));
    }
    if answer.has_state(ALLOWED_DRIFT) {
        columns.numbers("first_beyond_allowed_drift_m_s2", |row| first(row, ALLOWED_DRIFT));
    }
    columns.found
}

/// A table as CSV.
pub fn table_csv(columns: &[Column]) -> String {
    let rows = columns.first().map_or(0, |column| match &column.values {
        ColumnValues::Numbers(values) => values.len(),
        ColumnValues::Counts(values) => values.len(),
        ColumnValues::Words(values) => values.len(),
    });
    let mut out = String::new();
    let mut line = |cells: Vec<String>| {
        out.push_str(&cells.join(","));
        out.push('\n');
    };
    line(columns.iter().map(|column| field(&column.name)).collect());
    for row in 0..rows {
        let cell = |column: &Column| match &column.values {
            ColumnValues::Numbers(values) => values[row].map_or(String::new(), |value| value.to_string()),
            ColumnValues::Counts(values) => values[row].to_string(),
            ColumnValues::Words(values) => field(&values[row]),
        };
        line(columns.iter().map(cell).collect());
    }
    out
}

/// Any text as one field of CSV.
fn field(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}
