//! `dolmen validate`: compares published numbers with computed ones.

use crate::error::WorkError;
use crate::record::record;
use dolmen::comparisons::{Case, cases};
use dolmen::modal::{Identify, Mode, identify};
use dolmen_project::Project;
use dolmen_records::Files;
use dolmen_words::number::TWO_SIDED_95;

/// Published frequencies of Palisaden, Hz (Aloisio et al. 2020; the peer pyOMA-2 finds the same).
const PALISADEN_HZ: [f64; 3] = [1.882, 2.421, 2.687];

/// The cases of the library, and the identified record of the project `palisaden` compared with its published frequencies.
///
/// # Errors
/// If a case cannot be computed, or the record cannot be read.
pub fn validate(palisaden: &Project, files: &dyn Files) -> Result<Vec<Case>, WorkError> {
    let mut all = cases()?;
    let mut sources = palisaden
        .surveys
        .iter()
        .filter_map(|survey| survey.records.as_ref());
    let source = sources.next().ok_or(WorkError::PalisadenWithoutRecord)?;
    let opened = record(source, files)?;
    let found = identify(&opened.record, &Identify::default())?;
    let nearest = |published: f64| {
        let distance = |mode: &&Mode| (mode.frequency_hz - published).abs();
        found
            .modes
            .modes
            .iter()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
    };
    for (i, published) in PALISADEN_HZ.into_iter().enumerate() {
        let mode = nearest(published).ok_or(WorkError::PalisadenWithoutRecord)?;
        all.push(Case {
            source: "Aloisio et al. (2020)",
            what: format!(
                "Palisaden: frequency {} of ten minutes beside that of the whole record",
                i + 1
            ),
            unit: "Hz",
            published,
            computed: mode.frequency_hz,
            tolerance: TWO_SIDED_95 * mode.frequency_sd_hz.unwrap_or(0.0),
            corrected: None,
            note: "Palisaden: the tolerance is the 95 % interval that Dolmen states for ten minutes of record.",
        });
    }
    Ok(all)
}
