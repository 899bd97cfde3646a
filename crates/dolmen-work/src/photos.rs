//! The photographs and drawings that a project names.

use crate::error::{Within as _, WorkError};
use crate::opened::Opened;
use dolmen_project::{PhotoPart, Project};
use dolmen_records::{Files, PHOTO_BYTES_MOST, Photo, read_photo};
use std::collections::BTreeMap;

/// Largest size of all photographs of one report, in bytes. Our choice: a larger page is slow to open and too large to send.
const ALL_BYTES_MOST: u64 = 256 << 20;

/// Each photograph by its name in the project.
pub type Photos = BTreeMap<String, Photo>;

/// Reads the header of every photograph; empty for a project without photographs.
pub(crate) fn photos(opened: &Opened, files: &dyn Files) -> Result<Photos, WorkError> {
    let mut all = Photos::new();
    let mut total = 0;
    for part in named(&opened.project) {
        if all.contains_key(&part.file) {
            continue;
        }
        let place = || place(opened, part, files);
        let bytes = files.read(&part.file, PHOTO_BYTES_MOST).within(place)?;
        total += bytes.len() as u64;
        if total > ALL_BYTES_MOST {
            let too_many = WorkError::TooManyPhotos {
                most: ALL_BYTES_MOST >> 20,
            };
            return Err(too_many).within(place);
        }
        let photo = read_photo(bytes).within(place)?;
        all.insert(part.file.clone(), photo);
    }
    Ok(all)
}

fn named(project: &Project) -> impl Iterator<Item = &PhotoPart> {
    let inspected = project.surveys.iter().flat_map(|survey| &survey.inspections);
    let given = project.report.iter().flat_map(|report| report.images());
    given.chain(inspected.filter_map(|found| found.photo.as_ref()))
}

/// "photos/a.jpg (report.photos[1].file, line 12)".
fn place(opened: &Opened, part: &PhotoPart, files: &dyn Files) -> String {
    let span = opened.project.spans.get(&part.path);
    let before = span.and_then(|span| opened.text.get(..span.start));
    let line = before.map_or(0, |before| before.matches('\n').count() + 1);
    format!("{} ({}, line {line})", files.shown(&part.file), part.path)
}
