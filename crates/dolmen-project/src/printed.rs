//! Names of parts, surveys and motions as they are printed in the other language: `[names.en]` and `[names.ko]`.

use super::content::Structure;
use super::error::Fault;
use super::file::FileRaw;
use super::reader::Reader;
use super::site::MotionPart;
use super::survey::Survey;
use super::wrong::{Common, WrongFile};
use dolmen_words::message::Both;
use dolmen_words::{Language, PrintedName, nearest};

/// Every entry of the table; one that names nothing of the file is a fault.
pub(super) fn printed_names(
    reader: &mut Reader,
    file: &FileRaw,
    structure: Option<&Structure>,
    (surveys, motions): (&[Survey], &[MotionPart]),
) -> Vec<PrintedName> {
    let (Some(raw), Some(structure)) = (&file.names, structure) else {
        return Vec::new();
    };
    let mut known = structure.part_names();
    // a part without a name is called by its number
    known.retain(|name| name.parse::<usize>().is_err());
    known.extend(surveys.iter().map(|survey| survey.name.clone()));
    known.extend(motions.iter().map(|motion| motion.name.clone()));
    let mut all = Vec::new();
    let languages = [
        ("en", Language::English, &raw.value.en),
        ("ko", Language::Korean, &raw.value.ko),
    ];
    for (key, language, table) in languages {
        for (name, printed) in table.iter().flatten() {
            let path = format!("names.{key}");
            if !known.contains(name) {
                let help: Both = match nearest(name, known.iter().map(String::as_str)) {
                    Some(near) => Common::DidYouMean(near.to_owned()).into(),
                    None => WrongFile::NameAsFileDoes.into(),
                };
                let message = WrongFile::NamesNothing {
                    path: path.clone(),
                    name: name.clone(),
                };
                reader.fault(Fault::new(printed.span.clone(), &path, message).help(help));
            } else if printed.value.trim().is_empty() {
                let message = Common::IsEmpty(format!("{path}.\"{name}\""));
                let fault = Fault::new(printed.span.clone(), &path, message);
                reader.fault(fault.allowed(WrongFile::NeedsText));
            } else {
                all.push(PrintedName {
                    name: name.clone(),
                    language,
                    printed: printed.value.trim().to_owned(),
                });
            }
        }
    }
    all
}
