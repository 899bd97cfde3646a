//! Descriptions of faults of a path, in both languages.

use dolmen_words::message::{Argument, Both};
use dolmen_words::{Template, messages, sayable, sentences};
use std::error::Error;

/// Why a path cannot be read from or written to.
#[derive(Debug)]
#[allow(missing_docs, reason = "the sentence says what it is")]
pub enum PathError {
    NoProject {
        path: String,
    },
    NotThere {
        path: String,
    },
    /// A missing path of a project, and a similar one that exists.
    NotThereNear {
        path: String,
        near: String,
    },
    OneProject {
        path: String,
    },
    NoProjects {
        path: String,
    },
    SheetOfFolder {
        path: String,
        sheet: String,
    },
    IsRecord {
        path: String,
        name: String,
    },
    /// A folder without project.toml, and a file in it that may be meant.
    OtherName {
        path: String,
        near: String,
    },
    NotUtf8 {
        path: String,
        at: usize,
    },
    Utf16 {
        path: String,
    },
    TooLargeToWrite {
        path: String,
        bytes: usize,
        why: std::io::Error,
    },
    CannotWrite {
        path: String,
        why: std::io::Error,
    },
    CannotMake {
        path: String,
        why: std::io::Error,
    },
    CannotOpen {
        path: String,
        why: std::io::Error,
    },
    LinkToNothing {
        path: String,
        why: std::io::Error,
    },
    NoFolder {
        path: String,
    },
    NoFolderOfMotions {
        path: String,
    },
    CannotMove {
        path: String,
        folder: String,
        why: std::io::Error,
    },
    IsFile {
        path: String,
    },
    NotEmpty {
        path: String,
    },
    IsInput {
        path: String,
    },
    IsForeign {
        path: String,
    },
    LieBeside {
        beside: Vec<[String; 2]>,
    },
    Shard {
        given: String,
    },
    InUse {
        path: String,
    },
    NoJournalOfStudy {
        path: String,
    },
    NoJournalFrom {
        path: String,
        study: String,
    },
    NoJournalIn {
        path: String,
    },
}

sentences! {
    PathError in "folder.error" {
        NoProject { path } => {
            en: "{path} holds no project.toml: name the project file, or start one with `dolmen new flagpole DIR`",
            ko: "{path}에 project.toml이 없다. 프로젝트 파일을 지정하거나 `dolmen new flagpole DIR`로 시작한다",
        },
        NotThere { path } => {
            en: "{path} does not exist: name a project file or its folder, or start one with `dolmen new flagpole DIR`",
            ko: "{path}이(가) 없다. 프로젝트 파일이나 그 폴더를 지정하거나 `dolmen new flagpole DIR`로 시작한다",
        },
        NotThereNear { path, near } => {
            en: "{path} does not exist: did you mean {near}?",
            ko: "{path}이(가) 없다. {near}을(를) 쓰려던 것인가?",
        },
        OneProject { path } => {
            en: "{path} is one project: give the folder that holds it beside others, or a table (CSV)",
            ko: "{path}은(는) 프로젝트 하나이다. 여러 프로젝트가 든 폴더나 표(CSV)를 준다",
        },
        NoProjects { path } => {
            en: "{path} holds no folder with a project.toml: give a folder of project folders, or a table (CSV)",
            ko: "{path}에 project.toml이 든 폴더가 없다. 프로젝트 폴더들이 든 폴더나 표(CSV)를 준다",
        },
        SheetOfFolder { path, sheet } => {
            en: "--sheet {sheet} is for a workbook (XLSX, ODS); {path} is a folder: leave it out",
            ko: "--sheet {sheet}은(는) 통합 문서(XLSX, ODS)에 쓴다. {path}은(는) 폴더이므로 뺀다",
        },
        IsRecord { path, name } => {
            en: "{path} is a record, not a project file: write a file project.toml beside it that names it, and give that\n\nschema = 1\nkind = \"survey\"\nname = {{ en = \"My survey\" }}\n[survey.\"YYYY-MM-DD\".records]   # the day of the measurement\nfile = \"{name}\"\nsampling_rate = \"? Hz\"   # that of the recorder; delete the line where the file says it",
            ko: "{path}은(는) 프로젝트 파일이 아니라 기록이다. 이 기록을 읽는 project.toml을 그 옆에 만들어 지정한다\n\nschema = 1\nkind = \"survey\"\nname = {{ ko = \"나의 조사\" }}\n[survey.\"YYYY-MM-DD\".records]   # 계측한 날짜\nfile = \"{name}\"\nsampling_rate = \"? Hz\"   # 기록계의 값. 파일에 있으면 이 줄을 지운다",
        },
        OtherName { path, near } => {
            en: "{path} holds no project.toml, but \"{near}\": rename it to project.toml, or name it",
            ko: "{path}에 project.toml은 없고 \"{near}\"이(가) 있다. project.toml로 이름을 바꾸거나 그 파일을 지정한다",
        },
        Utf16 { path } => {
            en: "{path} is saved as Unicode (UTF-16): save it as UTF-8",
            ko: "{path}이(가) 유니코드(UTF-16)로 저장되어 있다. 메모장의 ‘다른 이름으로 저장’에서 인코딩을 UTF-8로 하여 저장한다",
        },
        NotUtf8 { path, at } => {
            en: "{path} is not UTF-8 text (byte {at}): save it as UTF-8; Korean text saved as EUC-KR or CP949 must be converted",
            ko: "{path}이(가) UTF-8 텍스트가 아니다({at}바이트). UTF-8로 저장한다. EUC-KR이나 CP949로 저장한 한글은 변환해야 한다",
        },
        TooLargeToWrite { path, bytes } => {
            en: "cannot write the {bytes} bytes of {path}: the system allows no file as large (`ulimit -f` tells how large); raise that limit, or write elsewhere",
            ko: "{path}에 {bytes}바이트를 쓸 수 없다. 시스템이 그렇게 큰 파일을 허용하지 않는다(한계는 `ulimit -f`). 한계를 높이거나 다른 곳에 쓴다",
        },
        CannotWrite { path } => { en: "cannot write {path}", ko: "{path}을(를) 쓸 수 없다" },
        CannotMake { path } => { en: "cannot make the folder {path}", ko: "폴더 {path}을(를) 만들 수 없다" },
        CannotOpen { path } => { en: "cannot open {path}", ko: "{path}을(를) 열 수 없다" },
        LinkToNothing { path } => {
            en: "{path} is a link to nothing: remove it, or write elsewhere",
            ko: "{path}은(는) 없는 곳을 가리키는 링크이다. 지우거나 다른 곳에 쓴다",
        },
        IsFile { path } => {
            en: "{path} is a file: name a folder that does not exist yet",
            ko: "{path}은(는) 파일이다. 아직 없는 폴더를 지정한다",
        },
        NotEmpty { path } => {
            en: "{path} is not empty: name a folder that does not exist yet, so that nothing is lost",
            ko: "{path}이(가) 비어 있지 않다. 잃는 것이 없도록 아직 없는 폴더를 지정한다",
        },
        IsInput { path } => {
            en: "{path} is read by this command or named by its project: it is never replaced; write elsewhere",
            ko: "{path}은(는) 이 명령이 읽거나 프로젝트에서 쓰는 파일이라 바꾸지 않는다. 다른 곳에 쓴다",
        },
        IsForeign { path } => {
            en: "{path} is there already, and Dolmen did not write it, or it was changed since: write elsewhere, or give --force to replace it",
            ko: "{path}이(가) 이미 있는데 Dolmen이 쓴 것이 아니거나 그 뒤에 바뀌었다. 다른 곳에 쓰거나 --force로 바꾼다",
        },
        LieBeside { beside } as { beside: pairs(beside) } => {
            en: "files are there that Dolmen did not write, or that were changed since; they stay, and what was to replace them lies beside: {beside}; move yours away, write elsewhere, or give --force to replace them",
            ko: "Dolmen이 쓰지 않았거나 그 뒤에 바뀐 파일이 있어 그대로 두고 새 결과를 그 옆에 썼다: {beside}. 그 파일을 옮기거나, 다른 곳에 쓰거나, --force로 바꾼다",
        },
        NoFolder { path } => {
            en: "{path} is no folder: name the folder that records come into",
            ko: "{path}은(는) 폴더가 아니다. 기록이 들어오는 폴더를 지정한다",
        },
        NoFolderOfMotions { path } => {
            en: "{path} is no folder: name the folder that holds the files of motions with --from",
            ko: "{path}은(는) 폴더가 아니다. 지반운동 파일이 든 폴더를 --from으로 지정한다",
        },
        CannotMove { path, folder } => {
            en: "cannot move {path} into {folder}; both must lie on one file system, and you need the right to write to both",
            ko: "{path}을(를) {folder}(으)로 옮길 수 없다. 둘은 한 파일 시스템에 있어야 하고 쓰기 권한이 필요하다",
        },
        Shard { given } => {
            en: "--shard is \"{given}\", but must be k/N with k from 1 to N: 1/4 is the first of four",
            ko: "--shard가 \"{given}\"인데 k/N(k는 1~N)이어야 한다. 1/4은 넷 중 첫째이다",
        },
        InUse { path } => {
            en: "{path} is in use: another `dolmen study` is running this study",
            ko: "{path}이(가) 쓰이고 있다. 다른 `dolmen study`가 이 study를 실행하고 있다",
        },
        NoJournalOfStudy { path } => {
            en: "{path} is no journal of a study, and stays: move it away, or name another folder (--output)",
            ko: "{path}은(는) study 기록이 아니므로 그대로 둔다. 옮기거나 다른 폴더를 지정한다(--output)",
        },
        NoJournalFrom { path, study } => {
            en: "--from {path} has no journal of a study, and neither has {study} in it",
            ko: "--from {path}에도 그 안의 {study}에도 study 기록이 없다",
        },
        NoJournalIn { path } => {
            en: "there is no journal in {path}: run `dolmen study` first, or name the folders of the shards",
            ko: "{path}에 study 기록이 없다. 먼저 `dolmen study`를 실행하거나 나눈 폴더들을 지정한다",
        },
    }
    caused by { TooLargeToWrite: why, CannotWrite: why, CannotMake: why, CannotOpen: why, LinkToNothing: why, CannotMove: why }
}

messages! {
    /// The kind of file at a path.
    pub(crate) enum Lying in "folder.lying" {
        Pipe => { en: "a pipe", ko: "파이프" },
        Device => { en: "a device", ko: "장치" },
        Folder => { en: "a folder", ko: "폴더" },
        NoRegularFile => { en: "no regular file", ko: "일반 파일이 아닌 것" },
        IsNow { wanted: String, free: String } => { en: "{wanted} is now {free}", ko: "{wanted} → {free}" },
        CannotWrite { path: String, why: Both } => {
            en: "cannot write {path}: {why}",
            ko: "{path}을(를) 쓸 수 없다: {why}",
        },
    }
}

fn pairs(beside: &[[String; 2]]) -> Both {
    let each = beside.iter().map(|[wanted, free]| {
        Both::from(Lying::IsNow {
            wanted: wanted.clone(),
            free: free.clone(),
        })
    });
    let (english, korean): (Vec<String>, Vec<String>) = each.map(|one| (one.english, one.korean)).unzip();
    Both {
        english: english.join(", "),
        korean: korean.join(", "),
    }
}

/// Templates of all sentences of this crate's errors.
pub const ERRORS: [&[Template]; 2] = [PathError::TEMPLATES, Lying::TEMPLATES];

/// The text of an error of this crate in both languages; `None` for any other error.
pub fn of_folders<'e>(error: &'e (dyn Error + 'static)) -> Option<&'e dyn Argument> {
    sayable!(error, PathError)
}
