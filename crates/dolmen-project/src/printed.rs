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
    let Some(structure) = structure else {
        return Vec::new();
    };
    let mut all = generated(structure);
    let Some(raw) = &file.names else {
        return all;
    };
    let mut known = structure.part_names();
    // a part without a name is called by its number
    known.retain(|name| name.parse::<usize>().is_err());
    known.extend(surveys.iter().map(|survey| survey.name.clone()));
    known.extend(motions.iter().map(|motion| motion.name.clone()));
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
                all.retain(|of| of.name != *name || of.language != language);
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

/// Korean names of the blocks that Dolmen generates and names itself.
fn generated(structure: &Structure) -> Vec<PrintedName> {
    let Structure::Stack(part) = structure else {
        return Vec::new();
    };
    let names = part.generated_names().into_iter();
    names
        .filter_map(|name| {
            Some(PrintedName {
                language: Language::Korean,
                printed: in_korean(&name)?,
                name,
            })
        })
        .collect()
}

fn in_korean(name: &str) -> Option<String> {
    let words: Vec<&str> = name.split(' ').collect();
    Some(match words[..] {
        ["keystone"] => "이맛돌".to_owned(),
        ["voussoir", number] => format!("홍예석 {number}"),
        ["left", "abutment"] => "왼쪽 교대".to_owned(),
        ["right", "abutment"] => "오른쪽 교대".to_owned(),
        ["post", number] => format!("기둥돌 {number}"),
        ["lintel"] => "인방석".to_owned(),
        ["lintel", number] => format!("인방석 {number}"),
        ["course", course] => format!("{course}켜"),
        ["course", course, "stone", stone] => format!("{course}켜 돌 {stone}"),
        ["course", course, "through", "stone", stone] => format!("{course}켜 관통석 {stone}"),
        ["course", course, "leaf", leaf, "stone", stone] => format!("{course}켜 {leaf}겹 돌 {stone}"),
        ["ring", ring, "stone", stone] => format!("{ring}단 돌 {stone}"),
        ["drum", "stone", stone] => format!("드럼 돌 {stone}"),
        ["lower", "base"] => "하층기단".to_owned(),
        ["lower", "base", "cover"] => "하층기단 갑석".to_owned(),
        ["upper", "base"] => "상층기단".to_owned(),
        ["upper", "base", "cover"] => "상층기단 갑석".to_owned(),
        ["storey", storey, "body"] => format!("{storey}층 탑신"),
        ["storey", storey, "eave"] => format!("{storey}층 옥개석"),
        _ => return None,
    })
}
