//! Completed changes of a store.

use crate::document::{Block, Document, TextStyle, document_text};
use dolmen::modal::LastingChange;
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::kept::{Added, AddedEarthquake, Fault, Imported, Verified};

messages! {
    /// Completed changes of a store.
    pub(crate) enum Done in "store.done" {
        Added { structure: String, surveys: usize, new: usize, files: usize, new_files: usize } => {
            en: "{structure} is stored: {surveys} surveys, {new} of them new; {files} files, {new_files} of them new.",
            ko: "{structure} 저장 완료: 계측 조사 {surveys}건(신규 {new}건), 파일 {files}개(신규 {new_files}개).",
        },
        AsBefore { structure: String, surveys: usize } => {
            en: "{structure} is stored already as it is: {surveys} surveys, nothing new.",
            ko: "{structure}은(는) 같은 내용으로 이미 저장되어 있다: 계측 조사 {surveys}건, 신규 없음.",
        },
        ChangedSurveys { structure: String, count: usize, names: String } => {
            en: "{count} surveys that {structure} had already have other content now under the same name: {names}. Is it the same structure, and are these corrections? What was there stays in the store; list, show and watch take the new.",
            ko: "{structure}에 이미 있던 계측 조사 {count}건의 내용이 같은 이름으로 바뀌었다: {names}. 같은 구조물이며 바로잡은 것인가? 이전 내용은 저장소에 남으나 list, show, watch는 새 내용을 쓴다.",
        },
        GoneSurveys { structure: String, count: usize, names: String } => {
            en: "{count} surveys that {structure} had are not in this file, and are watched no more: {names}. Is it the same structure? What was there stays in the store; to take it back, add the file that has them.",
            ko: "{structure}에 있던 계측 조사 {count}건이 이 파일에 없어 더 이상 검토되지 않는다: {names}. 같은 구조물인가? 이전 내용은 저장소에 남으며, 해당 조사가 있는 파일을 다시 저장하면 되돌아온다.",
        },
        NamedLike { structure: String, other: String } => {
            en: "{structure} is new to the store, where {other} has the same name but for case or spaces. Are they one structure? Then add this file with --name \"{other}\" and take {structure} out of use (`dolmen survey remove`).",
            ko: "{structure}은(는) 저장소에 처음이나 대소문자나 빈칸만 다른 {other}이(가) 있다. 같은 구조물인가? 그렇다면 이 파일을 --name \"{other}\"(으)로 저장하고 {structure}의 사용을 중지한다(`dolmen survey remove`).",
        },
        Analyses(count: usize) => {
            en: "Modes were identified from the records: {count} new analyses.",
            ko: "기록에서 모드를 식별하였다: 신규 식별 {count}건.",
        },
        Unidentified { survey: String, why: Both } => {
            en: "Survey {survey} is stored, but its records give no modes: {why}.",
            ko: "{survey} 조사는 저장하였으나 기록에서 모드를 찾지 못하였다: {why}.",
        },
        Shaken { survey: String, peak: Sentence, changed: Sentence } => {
            en: "EARTHQUAKE: the record of survey {survey} holds one, or the file states it{peak}{changed}, and no repair or inspection followed. It is an open alarm. Look at the structure; then enter it into works of [watch].",
            ko: "지진: {survey} 조사의 기록 또는 기재 내용에 지진이 있다{peak}{changed}. 이후 보수나 점검이 없어 조치되지 않은 경보로 남는다. 구조물을 점검하고 [watch]의 works에 기록한다.",
        },
        PeakOf(peak: Quantity) => { en: ", peak acceleration {peak}", ko: ", 최대가속도 {peak}" },
        Lasting(by: Quantity) => { en: ", LASTING CHANGE of a frequency by {by}", ko: ", 고유진동수 잔류 변화 {by}" },
        NotBeyond(by: Quantity) => {
            en: ", no lasting change beyond chance ({by})",
            ko: ", 유의한 잔류 변화 없음({by})",
        },
        Unsaid => { en: "", ko: "" },
        Exported { structure: String, folder: String, files: usize } => {
            en: "{structure} is in {folder}: project.toml and {files} files, as they were stored.",
            ko: "{structure}을(를) {folder}에 내보냈다: project.toml과 파일 {files}개, 저장 당시 그대로이다.",
        },
        Imported { structures: usize, rows: usize, files: usize } => {
            en: "{structures} structures were read: {rows} rows and {files} raw files are new.",
            ko: "구조물 {structures}기를 읽었다: 신규 행 {rows}개, 신규 원본 파일 {files}개.",
        },
        Removed(structure: String) => {
            en: "{structure} is out of use; nothing was deleted, and --undo takes it back.",
            ko: "{structure}의 사용을 중지하였다. 삭제된 자료는 없으며 --undo로 되돌린다.",
        },
        Restored(structure: String) => {
            en: "{structure} is in use again.",
            ko: "{structure}을(를) 다시 사용한다.",
        },
        Sound { structures: usize, surveys: usize, analyses: usize, files: usize, size: Quantity } => {
            en: "Everything is as it was stored: {structures} structures, {surveys} surveys, {analyses} analyses, {files} raw files of {size}, each compared with its hash.",
            ko: "모든 자료가 저장 당시와 같다: 구조물 {structures}기, 계측 조사 {surveys}건, 식별 {analyses}건, 원본 파일 {files}개({size})를 해시와 대조하였다.",
        },
        Unsound(count: usize) => {
            en: "{count} things are not as they were stored:",
            ko: "저장 당시와 다른 곳이 {count}건 있다:",
        },
        Missing(hash: String) => { en: "raw file {hash} is missing", ko: "원본 파일 {hash}이(가) 없음" },
        Changed(hash: String) => { en: "raw file {hash} was changed", ko: "원본 파일 {hash}이(가) 변경됨" },
        Row { table: String, name: String } => {
            en: "the row {name} of {table} does not say what its name stands for",
            ko: "{table} 테이블의 행 {name}의 내용이 이름과 다름",
        },
        Database(why: String) => { en: "the database: {why}", ko: "데이터베이스: {why}" },
        Unnamed(count: usize) => {
            en: "{count} raw files belong to nothing: a process was stopped before it could store what they belong to. They do no harm.",
            ko: "어디에도 속하지 않는 원본 파일이 {count}개 있다. 저장이 끝나기 전에 프로세스가 중단된 흔적이며 해가 없다.",
        },
        Content(hash: String) => {
            en: "Sum over the content: {hash}. Stores with the same sum hold the same.",
            ko: "내용 합계: {hash}. 합계가 같은 저장소는 내용이 같다.",
        },
    }
}

fn sentences(all: impl IntoIterator<Item = Sentence>, style: TextStyle) -> String {
    let mut document = Document::default();
    all.into_iter().for_each(|sentence| document.paragraph(sentence));
    document_text(&document, style)
}

fn count(value: i64) -> usize {
    usize::try_from(value).unwrap_or(0)
}

/// The result of `add`.
pub fn added_text(added: &Added, style: TextStyle) -> String {
    let structure = added.structure.clone();
    let surveys = added.surveys;
    let head = match added.is_new_state || added.new_analyses > 0 {
        true => Done::Added {
            structure,
            surveys,
            new: added.new_surveys,
            files: added.files,
            new_files: added.new_files,
        },
        false => Done::AsBefore { structure, surveys },
    };
    let mut document = Document::default();
    document.paragraph(head);
    if added.new_analyses > 0 {
        document.paragraph(Done::Analyses(added.new_analyses));
    }
    if let Some(other) = added.named_like.clone() {
        let structure = added.structure.clone();
        document.put(Block::Warning(Done::NamedLike { structure, other }.into()));
    }
    if !added.changed_surveys.is_empty() {
        let said = Done::ChangedSurveys {
            structure: added.structure.clone(),
            count: added.changed_surveys.len(),
            names: some(&added.changed_surveys),
        };
        document.put(Block::Warning(said.into()));
    }
    if !added.gone_surveys.is_empty() {
        let said = Done::GoneSurveys {
            structure: added.structure.clone(),
            count: added.gone_surveys.len(),
            names: some(&added.gone_surveys),
        };
        document.put(Block::Warning(said.into()));
    }
    for one in &added.unidentified {
        document.put(Block::Warning(
            Done::Unidentified {
                survey: one.survey.clone(),
                why: one.why.clone(),
            }
            .into(),
        ));
    }
    for one in added.earthquakes.iter().filter(|one| !one.is_answered) {
        document.put(Block::Warning(shaken(one).into()));
    }
    document_text(&document, style)
}

/// An earthquake without a later inspection.
fn shaken(one: &AddedEarthquake) -> Done {
    let of = &one.of;
    let percent = |by: f64| Quantity::new(by, Unit::percent(), Digits::Significant(2));
    let peak = of.peak_m_s2.map_or(Done::Unsaid, |peak| {
        Done::PeakOf(Quantity::new(peak, Unit::si("m/s²"), Digits::Significant(3)))
    });
    let changed = match (of.changed, of.changed_sd) {
        (Some(by), Some(sd)) if by.abs() > LastingChange::BEYOND * sd => Done::Lasting(percent(by)),
        (Some(by), Some(_)) => Done::NotBeyond(percent(by)),
        _ => Done::Unsaid,
    };
    Done::Shaken {
        survey: one.survey.clone(),
        peak: peak.into(),
        changed: changed.into(),
    }
}

/// Names in a sentence; only the first ones of many.
fn some(names: &[String]) -> String {
    const MOST: usize = 6;
    let more = if names.len() > MOST { " …" } else { "" };
    names[..names.len().min(MOST)].join(", ") + more
}

/// The result of exporting one structure.
pub fn exported_text(structure: &str, folder: &str, files: usize, style: TextStyle) -> String {
    let done = Done::Exported {
        structure: structure.to_owned(),
        folder: folder.to_owned(),
        files,
    };
    sentences([done.into()], style)
}

/// The result of `import`.
pub fn imported_text(imported: &Imported, style: TextStyle) -> String {
    let done = Done::Imported {
        structures: imported.structures,
        rows: imported.new_rows,
        files: imported.new_files,
    };
    sentences([done.into()], style)
}

/// The result of `remove`.
pub fn marked_text(structure: &str, is_removed: bool, style: TextStyle) -> String {
    let structure = structure.to_owned();
    let done = match is_removed {
        true => Done::Removed(structure),
        false => Done::Restored(structure),
    };
    sentences([done.into()], style)
}

/// The result of `verify`.
pub fn verified_text(verified: &Verified, style: TextStyle) -> String {
    let mut document = Document::default();
    if verified.faults.is_empty() {
        document.paragraph(Done::Sound {
            structures: count(verified.structures),
            surveys: count(verified.surveys),
            analyses: count(verified.analyses),
            files: count(verified.raw_files),
            size: Quantity::engineering(verified.raw_bytes as f64, "B", 3),
        });
    } else {
        document.put(Block::Warning(Done::Unsound(verified.faults.len()).into()));
        let said = verified.faults.iter().map(|fault| {
            match fault.clone() {
                Fault::Missing { hash } => Done::Missing(hash),
                Fault::Changed { hash } => Done::Changed(hash),
                Fault::Row { table, name } => Done::Row { table, name },
                Fault::Database { why } => Done::Database(why),
            }
            .into()
        });
        document.put(Block::List(said.collect()));
    }
    if verified.unnamed_files > 0 {
        document.note(Done::Unnamed(count(verified.unnamed_files)));
    }
    if style.is_full {
        document.paragraph(Done::Content(verified.content.clone()));
    }
    document_text(&document, style)
}
