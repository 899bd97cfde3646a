//! Rows of inspection entries, and of surveys that nobody measured.

use crate::database::{Database, Value, all};
use crate::error::StoreError;
use crate::raw::RawFiles;
use crate::rows::{InspectionRow, MadeUpRow, ProjectFileRow, ProjectRow, ProjectSurveyRow, insert, select};
use crate::stored_files::StoredFiles;
use dolmen_project::{DamageKind, Inspection, Severity, Survey};
use dolmen_work::Opened;
use dolmen_work::kept::KeptInspection;
use std::sync::Arc;

/// The key of a survey in a project file that holds the entries of an inspection.
const KEY: &str = "inspections";

/// The entries of a survey.
pub(crate) fn entries(survey: &Survey, hash: &str) -> Vec<InspectionRow> {
    let each = (1..).zip(&survey.inspections);
    each.map(|(position, of)| entry(of, hash, position)).collect()
}

/// The row of a survey that nobody measured.
pub(crate) fn made_up(survey: &Survey, hash: &str) -> Option<MadeUpRow> {
    survey.is_made_up.then(|| MadeUpRow {
        survey: hash.to_owned(),
    })
}

fn entry(of: &Inspection, survey: &str, position: i64) -> InspectionRow {
    let [x_m, y_m, z_m] = of.at.map_or([None; 3], |at| at.map(Some));
    let size = of.size.as_ref();
    InspectionRow {
        survey: survey.to_owned(),
        position,
        part: of.part.clone(),
        what: of.what.word().to_owned(),
        what_korean: match &of.what {
            DamageKind::Other(other) => Some(other.korean.clone()),
            _ => None,
        },
        name: of.name.clone(),
        size_m: size.map(|size| size.value),
        size_sd_m: size.map(|_| of.reading_sd_m()),
        limit_m: of.limit.as_ref().map(|limit| limit.value),
        severity: of.severity.map(Severity::word).map(str::to_owned),
        x_m,
        y_m,
        z_m,
        photo: of.photo.as_ref().map(|photo| photo.file.clone()),
        note: of.note.as_ref().map(|note| note.english().to_owned()),
    }
}

/// The entries of a survey, for display.
pub(crate) fn kept(database: &mut dyn Database, survey: &[Value]) -> Result<Vec<KeptInspection>, StoreError> {
    let rows: Vec<InspectionRow> = select(database, "where survey = $1 order by position", survey)?;
    let each = rows.into_iter().map(|row| KeptInspection {
        part: row.part,
        what: row.what,
        name: row.name,
        size_m: row.size_m,
        size_sd_m: row.size_sd_m,
        limit_m: row.limit_m,
        severity: row.severity,
        photo: row.photo,
        note: row.note,
    });
    Ok(each.collect())
}

/// Whether nobody measured a survey.
pub(crate) fn is_made_up(database: &mut dyn Database, survey: &[Value]) -> Result<bool, StoreError> {
    Ok(!select::<MadeUpRow>(database, "where survey = $1", survey)?.is_empty())
}

/// Fills the table of inspections in a store of an earlier version from the texts of its projects. A text that this version cannot read is left
/// as it is, and so are its rows.
pub(crate) fn fill(database: &mut dyn Database, raw: &Arc<dyn RawFiles>) -> Result<(), StoreError> {
    for row in all(database, "select hash from project order by hash", &[])? {
        for project in select::<ProjectRow>(database, "where hash = $1", &row)? {
            let Some(text) = text_of(database, raw, &project)? else {
                continue;
            };
            let files: Vec<ProjectFileRow> = select(database, "where project = $1", &row)?;
            let files = StoredFiles::of(database, raw, files)?;
            let Ok(opened) = Opened::read(text, project.hash.clone(), &files) else {
                continue;
            };
            let members: Vec<ProjectSurveyRow> =
                select(database, "where project = $1 order by position", &row)?;
            for (survey, member) in opened.project.surveys.iter().zip(&members) {
                for entry in entries(survey, &member.survey) {
                    insert(database, &entry)?;
                }
            }
        }
    }
    Ok(())
}

/// The text of a project with inspections; `None` for another one, or if the text cannot be read.
fn text_of(
    database: &mut dyn Database,
    raw: &Arc<dyn RawFiles>,
    project: &ProjectRow,
) -> Result<Option<String>, StoreError> {
    let of = [Value::Text(project.text_hash.clone())];
    let bytes = all(database, "select bytes from raw where hash = $1", &of)?;
    let Some([Value::Whole(bytes)]) = bytes.first().map(Vec::as_slice) else {
        return Ok(None);
    };
    let bytes = u64::try_from(*bytes).unwrap_or(0);
    let text = raw.read(&project.text_hash, bytes).ok();
    let text = text.and_then(|bytes| String::from_utf8(bytes).ok());
    Ok(text.filter(|text| text.contains(KEY)))
}
