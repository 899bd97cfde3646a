//! A study as files: tables, figures, results.

use super::named::NamedFile;
use super::nrml::nrml_files;
use crate::figures::study_figures;
use crate::json::study_json;
#[cfg(feature = "parquet")]
use crate::tables::{TableError, parquet};
use dolmen::assess::AssessError;
use dolmen_words::{Language, keeping_names};
use dolmen_work::study::{
    Column, StudyAnswer, capacity_columns, fragility_columns, harmonic_columns, joint_columns,
    release_columns, run_columns, table_csv,
};

/// Why a study cannot be written.
#[derive(Debug, thiserror::Error)]
pub enum StudyFilesError {
    /// A table cannot be made.
    #[cfg(feature = "parquet")]
    #[error(transparent)]
    Table(#[from] TableError),
    /// A trend cannot be computed.
    #[error(transparent)]
    Assess(#[from] AssessError),
}

/// Tables (CSV, and Parquet if built in), figures and JSON of a study.
///
/// # Errors
/// [`StudyFilesError`].
pub fn study_files(answer: &StudyAnswer, language: Language) -> Result<Vec<NamedFile>, StudyFilesError> {
    let mut files = Vec::new();
    let mut table = |name: &str, columns: Vec<Column>| -> Result<(), StudyFilesError> {
        files.push(NamedFile::new(&format!("{name}.csv"), table_csv(&columns)));
        #[cfg(feature = "parquet")]
        files.push(NamedFile::new(&format!("{name}.parquet"), parquet(&columns)?));
        Ok(())
    };
    if answer.study.scan.is_some() {
        table("runs", run_columns(answer))?;
        table("capacities", capacity_columns(answer))?;
        table("fragility", fragility_columns(answer))?;
        if !answer.joint_fragilities().is_empty() {
            table("joints", joint_columns(answer))?;
        }
    }
    if answer.study.harmonic.is_some() {
        table("harmonic", harmonic_columns(&answer.maps, answer.kind))?;
    }
    if answer.study.release_m.is_some() {
        table("release", release_columns(&answer.maps))?;
    }
    if answer.study.scan.is_some() {
        files.extend(nrml_files(answer));
    }
    files.extend(study_figures(answer, language).into_iter().map(NamedFile::figure));
    files.push(NamedFile::json(
        "study.json",
        &keeping_names(|| study_json(answer))?,
    ));
    Ok(files)
}
