//! Refuses the same record under two dates: its survey would be compared with itself.

use crate::change_fault::ChangeFault;
use crate::fingerprint::fingerprint;
use crate::survey_dates::date;
use dolmen_project::{Column, Cut, RecordSource, Survey};
use dolmen_records::{Files, RECORD_BYTES_MOST};
use std::collections::BTreeMap;

/// A file of a survey, and the part of it in use.
struct Part<'p> {
    survey: &'p Survey,
    source: &'p RecordSource,
    cut: Option<Cut>,
}

impl Part<'_> {
    /// Whether two parts of one file share samples.
    fn meets(&self, other: &Part<'_>) -> bool {
        let is_apart = match (self.cut, other.cut) {
            (Some(own), Some(other)) => own.to_s <= other.from_s || other.to_s <= own.from_s,
            _ => false,
        };
        let columns = |of: &Part<'_>| -> Vec<Column> {
            let used = of.source.channels.iter().filter(|channel| !channel.leave_out);
            used.map(|channel| channel.column.clone()).collect()
        };
        let (own, others) = (columns(self), columns(other));
        let are_all = own.is_empty() || others.is_empty();
        !is_apart && (are_all || own.iter().any(|column| others.contains(column)))
    }
}

/// Refuses surveys of two dates with the same record: files with equal bytes, from which both surveys use the same
/// samples.
///
/// # Errors
/// [`ChangeFault::SameRecord`].
pub(crate) fn refuse_same_records<'p>(
    surveys: impl Iterator<Item = &'p Survey>,
    files: &dyn Files,
) -> Result<(), ChangeFault> {
    let parts: Vec<Part<'_>> = surveys
        .filter(|survey| date(&survey.name).is_some())
        .flat_map(parts)
        .collect();
    let mut days: Vec<Option<[u32; 3]>> = parts.iter().map(|part| date(&part.survey.name)).collect();
    days.dedup();
    if days.len() < 2 {
        return Ok(());
    }
    let mut contents: BTreeMap<String, Vec<&Part<'_>>> = BTreeMap::new();
    let mut known: BTreeMap<&str, Option<String>> = BTreeMap::new();
    for part in &parts {
        // the verb that uses a file reports that it cannot be read
        let content = known.entry(&part.source.file).or_insert_with(|| {
            let bytes = files.read(&part.source.file, RECORD_BYTES_MOST).ok()?;
            Some(format!("{} {}", bytes.len(), fingerprint(&bytes)))
        });
        let Some(content) = content else { continue };
        let same = contents.entry(content.clone()).or_default();
        let is_same =
            |other: &&&Part<'_>| date(&other.survey.name) != date(&part.survey.name) && other.meets(part);
        if let Some(other) = same.iter().find(is_same) {
            return Err(ChangeFault::SameRecord {
                surveys: [other, part].map(|of| of.survey.name.clone()),
                files: [other, part].map(|of| files.shown(&of.source.file)),
            });
        }
        same.push(part);
    }
    Ok(())
}

fn parts(survey: &Survey) -> impl Iterator<Item = Part<'_>> {
    let sources = survey.records.iter().chain(&survey.setups);
    sources.flat_map(move |whole| {
        let cut = whole.conditioning.cut;
        let own = match whole.stations.is_empty() {
            true => std::slice::from_ref(whole),
            false => whole.stations.as_slice(),
        };
        own.iter().map(move |source| Part { survey, source, cut })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen_project::parse_project;
    use dolmen_records::FileError;

    /// Files where "b.csv" is a copy of "a.csv".
    #[derive(Debug)]
    struct Copies;

    impl Files for Copies {
        fn read(&self, path: &str, _most: u64) -> Result<Vec<u8>, FileError> {
            Ok(match path {
                "a.csv" | "b.csv" => b"1,2".to_vec(),
                other => other.as_bytes().to_vec(),
            })
        }
    }

    fn refused(records: &[(&str, &str)]) -> Option<String> {
        let each = records
            .iter()
            .map(|(name, keys)| format!("[survey.\"{name}\".records]\n{keys}\n"));
        let text = format!(
            "schema = 1\nkind = \"survey\"\nname = \"P\"\n{}",
            each.collect::<String>()
        );
        let project = parse_project(&text, "p.toml").unwrap();
        let why = refuse_same_records(project.surveys.iter(), &Copies).err()?;
        Some(why.to_string())
    }

    #[test]
    fn refuses_one_record_under_two_dates_whatever_its_name() {
        let (a, b) = ("file = \"a.csv\"", "file = \"b.csv\"");
        let said = refused(&[("2024-05-01", a), ("2025-05-01", b)]).unwrap();
        for word in ["2024-05-01", "2025-05-01", "a.csv", "b.csv"] {
            assert!(said.contains(word), "{said}");
        }
        assert!(refused(&[("2024-05-01", a), ("2025-05-01", a)]).is_some());
        assert_eq!(
            refused(&[("2024-05-01", a), ("2025-05-01", "file = \"c.csv\"")]),
            None
        );
        // the same day twice: two uses of one record
        assert_eq!(refused(&[("2024-05-01", a), ("2024-05-01 filtered", a)]), None);
    }

    #[test]
    fn holds_parts_of_one_file_may_have_dates_of_their_own() {
        let columns = |column: &str| format!("file = \"a.csv\"\nchannels = [{{ column = \"{column}\" }}]");
        let cut = |from: u32, to: u32| {
            format!("file = \"a.csv\"\nconditioning.cut = {{ from_s = {from}, to_s = {to} }}")
        };
        let of = |first: String, second: String| {
            refused(&[("2024-05-01", first.as_str()), ("2025-05-01", second.as_str())])
        };
        assert_eq!(of(columns("x 2024"), columns("x 2025")), None);
        assert!(of(columns("x"), columns("x")).is_some());
        assert_eq!(of(cut(0, 300), cut(300, 600)), None);
        assert!(of(cut(0, 400), cut(300, 600)).is_some());
    }
}
