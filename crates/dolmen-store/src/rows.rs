//! The stored rows, one type for each table. The files in `sql` explain the tables.

use crate::database::{Database, Field as _, Kind, Value};
use crate::error::StoreError;

/// A table, as its row type defines it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Table {
    pub(crate) name: &'static str,
    pub(crate) columns: &'static [(&'static str, Kind)],
    /// The columns of its key.
    pub(crate) key: &'static str,
}

/// A row of a table.
pub(crate) trait Row: Sized {
    const TABLE: Table;
    /// Its values, in the order of the columns.
    fn values(&self) -> Vec<Value>;
    /// The row with these values.
    fn of(values: Vec<Value>) -> Result<Self, StoreError>;
}

macro_rules! rows {
    ($($(#[$about:meta])* $name:ident in $table:literal by $key:literal { $($field:ident: $kind:ty),* $(,)? })*) => {
        $(
            $(#[$about])*
            #[derive(Clone, Debug, PartialEq)]
            pub(crate) struct $name { $(pub(crate) $field: $kind),* }

            impl Row for $name {
                const TABLE: Table = Table {
                    name: $table,
                    columns: &[$((stringify!($field), <$kind as crate::database::Field>::KIND)),*],
                    key: $key,
                };
                fn values(&self) -> Vec<Value> {
                    vec![$(self.$field.value()),*]
                }
                fn of(values: Vec<Value>) -> Result<Self, StoreError> {
                    let mut values = values.into_iter();
                    $(let $field = take::<$kind>(&mut values, $table, stringify!($field))?;)*
                    Ok($name { $($field),* })
                }
            }
        )*

        /// All tables, each after those that it refers to.
        pub(crate) const TABLES: &[Table] = &[$($name::TABLE),*];
    };
}

fn take<T: crate::database::Field>(
    values: &mut impl Iterator<Item = Value>,
    table: &'static str,
    column: &'static str,
) -> Result<T, StoreError> {
    values
        .next()
        .and_then(T::of)
        .ok_or(StoreError::WrongValue { table, column })
}

rows! {
    RawRow in "raw" by "hash" { hash: String, bytes: i64, at_us: i64 }
    StructureRow in "structure" by "name" { name: String, at_us: i64, who: String }
    ProjectRow in "project" by "hash" {
        hash: String, structure: String, text_hash: String, kind: String, english: String, korean: String,
        latitude_deg: Option<f64>, longitude_deg: Option<f64>, dolmen: String,
    }
    ProjectFileRow in "project_file" by "project, path" { project: String, path: String, hash: String }
    AdoptionRow in "adoption" by "structure, at_us, project" { structure: String, at_us: i64, project: String, who: String }
    SurveyRow in "survey" by "hash" {
        hash: String, structure: String, name: String, taken_on: Option<String>, datum: Option<String>, note: Option<String>,
        source: Option<String>,
    }
    ProjectSurveyRow in "project_survey" by "project, position" { project: String, position: i64, survey: String }
    ArrivalRow in "arrival" by "survey" {
        survey: String, structure: String, name: String, path: String, raw: String, came_as: String, text: String, units: String,
        at_us: i64, who: String,
    }
    ChannelFaultRow in "channel_fault" by "survey, channel, fault" { survey: String, channel: String, fault: String }
    EnvironmentRow in "environment" by "survey, quantity" { survey: String, quantity: String, value: f64, unit: String }
    TiltRow in "tilt" by "survey, direction" { survey: String, direction: String, ratio: f64, written: String, datum: Option<String> }
    StatedModeRow in "stated_mode" by "survey, direction, position" {
        survey: String, direction: String, position: i64, frequency_hz: f64, frequency_sd_hz: Option<f64>,
        damping_ratio: Option<f64>, damping_ratio_sd: Option<f64>, kind: String,
    }
    StatedShapeRow in "stated_shape" by "survey, direction, mode, position" {
        survey: String, direction: String, mode: i64, position: i64, height_m: f64, displacement: f64, displacement_sd: f64,
    }
    RecordRow in "record" by "survey, setup, station" {
        survey: String, setup: i64, station: i64, path: String, hash: String, format: Option<String>,
        sampling_rate_hz: Option<f64>, unit: Option<String>, scale: Option<f64>,
    }
    ChannelRow in "channel" by "survey, setup, station, position" {
        survey: String, setup: i64, station: i64, position: i64, source_column: String, name: Option<String>, x_m: Option<f64>,
        y_m: Option<f64>, z_m: Option<f64>, direction_x: Option<f64>, direction_y: Option<f64>, direction_z: Option<f64>,
        scale: Option<f64>, is_left_out: bool,
    }
    SettingsRow in "settings" by "hash" { hash: String, text: String }
    AnalysisRow in "analysis" by "hash" {
        hash: String, records: String, settings: String, version: String, method: String, duration_s: f64, at_us: i64, who: String,
    }
    SurveyAnalysisRow in "survey_analysis" by "survey, analysis" { survey: String, analysis: String }
    ModeRow in "mode" by "analysis, position" {
        analysis: String, position: i64, frequency_hz: f64, frequency_sd_hz: Option<f64>, damping_ratio: Option<f64>,
        damping_ratio_sd: Option<f64>, phase_collinearity: Option<f64>, is_accepted: bool,
    }
    ModePointRow in "mode_point" by "analysis, mode, position" {
        analysis: String, mode: i64, position: i64, channel: String, real_part: f64, imaginary_part: f64, sd: Option<f64>,
    }
    EarthquakeRow in "earthquake" by "analysis" {
        analysis: String, peak_m_s2: Option<f64>, changed: Option<f64>, changed_sd: Option<f64>,
    }
    StatedEarthquakeRow in "stated_earthquake" by "survey" {
        survey: String, peak_m_s2: Option<f64>, changed: Option<f64>, changed_sd: Option<f64>,
    }
    InspectionRow in "inspection_item" by "survey, position" {
        survey: String, position: i64, part: String, what: String, what_korean: Option<String>, name: Option<String>,
        size_m: Option<f64>, size_sd_m: Option<f64>, limit_m: Option<f64>, severity: Option<String>, x_m: Option<f64>,
        y_m: Option<f64>, z_m: Option<f64>, photo: Option<String>, note: Option<String>,
    }
    MadeUpRow in "made_up" by "survey" { survey: String }
    MarkRow in "mark" by "structure, at_us" { structure: String, at_us: i64, is_removed: bool, who: String, why: String }
    LogRow in "log" by "at_us, who, verb, subject, detail" { at_us: i64, who: String, verb: String, subject: String, detail: String }
}

impl Table {
    /// Its columns, for a query.
    pub(crate) fn names(&self) -> String {
        let names: Vec<&str> = self.columns.iter().map(|(name, _)| *name).collect();
        names.join(", ")
    }

    /// Adds a row unless one with its key exists; returns whether it was added.
    pub(crate) fn insert(&self, database: &mut dyn Database, values: &[Value]) -> Result<bool, StoreError> {
        let places: Vec<String> = (1..=self.columns.len()).map(|at| format!("${at}")).collect();
        let sql = format!(
            "insert into {} ({}) values ({}) on conflict do nothing",
            self.name,
            self.names(),
            places.join(", ")
        );
        Ok(database.execute(&sql, values)? > 0)
    }
}

/// Adds a row unless one with its key exists; returns whether it was added.
pub(crate) fn insert<R: Row>(database: &mut dyn Database, row: &R) -> Result<bool, StoreError> {
    R::TABLE.insert(database, &row.values())
}

/// Rows of a table for which a condition holds, in an order.
pub(crate) fn select<R: Row>(
    database: &mut dyn Database,
    condition: &str,
    values: &[Value],
) -> Result<Vec<R>, StoreError> {
    let sql = format!("select {} from {} {condition}", R::TABLE.names(), R::TABLE.name);
    let mut rows = Vec::new();
    database.query(&sql, values, &mut |row| {
        rows.push(R::of(row)?);
        Ok(())
    })?;
    Ok(rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::database::Access;
    use crate::raw_folder::no_files;
    use crate::schema::migrate;
    use crate::sqlite::Sqlite;
    use std::time::Duration;

    #[test]
    fn holds_row_types_have_the_columns_of_the_schema_and_every_table_has_one() {
        let file = std::env::temp_dir().join(format!("dolmen-rows-{}.db", std::process::id()));
        let mut database = Sqlite::open(&file, Access::Write, Duration::ZERO).unwrap();
        migrate(&mut database, 0, &no_files()).unwrap();
        for table in TABLES {
            let own: Vec<(String, Kind)> = table
                .columns
                .iter()
                .map(|(name, kind)| ((*name).to_owned(), *kind))
                .collect();
            assert_eq!(database.columns(table.name).unwrap(), own, "{}", table.name);
        }
        let sql = "select count(*) from sqlite_schema where type = 'table' and name <> 'store'";
        let tables = crate::database::all(&mut database, sql, &[]).unwrap();
        assert_eq!(tables, [[Value::Whole(TABLES.len() as i64)]]);
        drop(database);
        let _ = std::fs::remove_file(&file);
    }
}
