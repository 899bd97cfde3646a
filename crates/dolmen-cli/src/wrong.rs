//! Errors about the command line, and notes in addition to an answer, in both languages.

use crate::manner::Manner;
use dolmen_words::message::{Argument, Both};
use dolmen_words::{messages, sayable, sentences};
use std::error::Error;

/// Why a command cannot be run.
#[derive(Debug)]
pub(crate) enum CommandError {
    Store {
        fault: Both,
    },
    NoCode {
        code: String,
        near: Option<String>,
    },
    OneName,
    CheckOfVariant {
        name: String,
    },
    StoreThere {
        path: String,
    },
    StoreIsServer,
    NoMotion,
    BuiltInAsFile {
        name: String,
    },
    NoPlaneMotion,
    At2One {
        count: usize,
    },
    MotionFormat {
        path: String,
    },
    NotReproduced {
        wrong: usize,
    },
    NotReproducedFirst {
        wrong: usize,
        all: usize,
        first: String,
    },
    NotKept {
        path: String,
    },
    DrawingFormat {
        ending: String,
    },
    RecordFormat {
        path: String,
    },
    BinaryCsv,
    NoJsonOfRecord,
    NothingToDraw {
        path: String,
    },
    NoExample {
        name: String,
    },
    NameProject,
    FormFormat,
    ReportFormat {
        ending: String,
    },
    #[cfg_attr(
        feature = "pdf",
        allow(dead_code, reason = "only a build without PDF says it")
    )]
    NoPdf,
    NoJsonOfDrawing,
    NoMotionToChange,
    NoEffect {
        flag: &'static str,
        is_for: Both,
    },
    NothingReported {
        projects: usize,
    },
    CannotPrint {
        why: std::io::Error,
    },
    CannotRemove {
        path: String,
        why: std::io::Error,
    },
}

sentences! {
    CommandError in "command.error" {
        Store { fault } => { en: "{fault}", ko: "{fault}" },
        NoCode { code, near } as { code, near: meant(near.as_deref()) } => {
            en: "there is no code \"{code}\".{near} `dolmen explain` lists all codes",
            ko: "코드 \"{code}\"이(가) 없다.{near} 모든 코드는 `dolmen explain`으로 본다",
        },
        OneName => {
            en: "--name names one structure, but several projects are given: add them one by one",
            ko: "--name은 구조물 하나의 이름인데 프로젝트가 여럿이다. 하나씩 넣는다",
        },
        CheckOfVariant { name } => {
            en: "check has no --variant: it answers the structure as it is and every variant, and `dolmen check PROJECT --full` prints them all, {name} among them",
            ko: "check에는 --variant가 없다. 현 상태와 모든 대안을 함께 검토하며 `dolmen check PROJECT --full`이 {name}을(를) 포함한 모든 대안을 보여 준다",
        },
        BuiltInAsFile { name } => {
            en: "there is no file {name}; the motion of that name is built in: give --motion {name}, or the file of a record",
            ko: "{name} 파일이 없다. 그 이름의 지반운동은 내장되어 있으므로 --motion {name}으로 쓰거나 기록 파일을 지정한다",
        },
        StoreThere { path } => {
            en: "{path} is there already: a whole store is written to a new file, so that nothing is lost",
            ko: "{path}이(가) 이미 있다. 잃는 것이 없도록 저장소 전체는 새 파일에 쓴다",
        },
        StoreIsServer => {
            en: "-o takes a new file for a whole store: `dolmen survey import STORE --store postgresql://…` takes a store over into a database",
            ko: "저장소 전체를 내보내는 -o에는 새 파일을 지정한다. 데이터베이스로 옮기려면 `dolmen survey import STORE --store postgresql://…`을 쓴다",
        },
        NoJsonOfDrawing => {
            en: "a drawing is an SVG and has no JSON: leave --json out; `dolmen check --json` has the structure's numbers",
            ko: "도면은 SVG이며 JSON이 없다. --json을 뺀다. 구조물의 수치는 `dolmen check --json`에 있다",
        },
        NoMotion => { en: "no motion is given to write", ko: "쓸 지반운동이 없다" },
        NoPlaneMotion => {
            en: "the channels are no motion of x, y and z: name one with --channel, or turn them with --x-azimuth",
            ko: "채널이 x, y, z의 지반운동이 아니다. --channel로 하나를 지정하거나 --x-azimuth로 돌린다",
        },
        At2One { count } => {
            en: "AT2 holds one component, but the motion has {count}: write .csv, or give one file",
            ko: "AT2에는 성분이 하나인데 지반운동의 성분은 {count}개이다. .csv로 쓰거나 파일 하나만 준다",
        },
        MotionFormat { path } => {
            en: "{path} ends in neither .csv nor .at2, the formats that are written",
            ko: "{path}이(가) 쓸 수 있는 형식인 .csv나 .at2로 끝나지 않는다",
        },
        NotReproduced { wrong } => {
            en: "{wrong} published numbers are not reproduced: this build must not be used",
            ko: "문헌값 {wrong}개가 재현되지 않는다. 이 빌드를 쓰면 안 된다",
        },
        NotReproducedFirst { wrong, all, first } => {
            en: "{wrong} of {all} published numbers are not reproduced, {first} first",
            ko: "문헌값 {all}개 중 {wrong}개가 재현되지 않는다. 첫째: {first}",
        },
        NotKept { path } => {
            en: "{path} does not keep what is written to it",
            ko: "{path}에 쓴 내용이 그대로 남지 않는다",
        },
        DrawingFormat { ending } => {
            en: "a drawing is not written as .{ending}: -o takes an SVG (.svg), which every browser shows, or a PNG (.png)",
            ko: "도면을 .{ending} 형식으로 저장할 수 없다. -o에 지정할 수 있는 형식: 모든 브라우저에서 볼 수 있는 SVG(.svg), PNG(.png)",
        },
        RecordFormat { path } => {
            en: "{path} ends in none of .uff, .unv and .csv, the formats that a record is written in",
            ko: "{path}이(가) 기록을 쓸 수 있는 형식인 .uff, .unv, .csv로 끝나지 않는다",
        },
        BinaryCsv => {
            en: "a CSV file is text: leave --binary out, or write .uff",
            ko: "CSV 파일은 텍스트이다. --binary를 빼거나 .uff로 쓴다",
        },
        NoJsonOfRecord => {
            en: "a record is written as .uff, .unv or .csv and has no JSON: leave --json out",
            ko: "기록은 .uff, .unv, .csv로 쓰며 JSON이 없다. --json을 뺀다",
        },
        NothingToDraw { path } => {
            en: "{path} has kind = \"survey\": there is no structure to draw",
            ko: "{path}은(는) kind = \"survey\"라 그릴 구조물이 없다",
        },
        NoExample { name } => {
            en: "the example {name} is not in this build",
            ko: "이 빌드에 예제 {name}이(가) 없다",
        },
        NameProject => {
            en: "name a project file, or a folder that holds project.toml",
            ko: "프로젝트 파일이나 project.toml이 든 폴더를 지정한다",
        },
        FormFormat => {
            en: "the form is written as a workbook (.xlsx) or a page (.html)",
            ko: "양식은 통합문서(.xlsx)나 웹 페이지(.html)로 쓴다",
        },
        ReportFormat { ending } => {
            en: "a report is not written as .{ending}: -o takes a page (.html), a document to print (.pdf) or to edit (.docx, .hwpx), or a workbook (.xlsx)",
            ko: "보고서를 .{ending} 형식으로 저장할 수 없다. -o에 지정할 수 있는 형식: 웹 페이지(.html), 인쇄할 문서(.pdf), 편집할 문서(.docx, .hwpx), 통합문서(.xlsx)",
        },
        NoPdf => {
            en: "this dolmen was built without PDF: build it with `--features pdf`, or write a page (.html) and print it from a browser",
            ko: "이 dolmen에는 PDF 기능이 없다. `--features pdf`로 빌드하거나 웹 페이지(.html)로 써서 브라우저에서 인쇄한다",
        },
        NoMotionToChange => {
            en: "--unit, --scale, --peak and the like say how a motion is read and changed, but none is given: add --motion or --motion-file",
            ko: "--unit, --scale, --peak 등은 지반운동을 읽고 바꾸는 방법인데 지반운동이 없다. --motion이나 --motion-file을 준다",
        },
        NoEffect { flag, is_for } => {
            en: "--{flag} would have no effect: it {is_for}. Leave it out, or add what it is for",
            ko: "--{flag}이(가) 쓰이지 않는다. {is_for}. 빼거나 필요한 것을 함께 준다",
        },
        NothingReported { projects } => {
            en: "no report is written: none of the {projects} projects can be reported on",
            ko: "보고서를 쓰지 않았다. 프로젝트 {projects}개 모두 보고서에 넣을 수 없다",
        },
        CannotPrint {} => { en: "cannot write to standard output", ko: "표준 출력에 쓸 수 없다" },
        CannotRemove { path } => { en: "cannot remove {path}", ko: "{path}을(를) 지울 수 없다" },
    }
    caused by { CannotPrint: why, CannotRemove: why }
}

messages! {
    /// Notes in addition to an answer, on standard error.
    #[cfg_attr(not(feature = "pdf"), allow(dead_code, reason = "only a build with PDF says what it cannot print"))]
    pub(crate) enum Noted in "command.note" {
        Ranking(folder: String) => {
            en: "ranking, figure and page are in {folder}",
            ko: "순위, 그림, 웹 페이지를 {folder}에 썼다",
        },
        NothingToSample => {
            en: "--samples had nothing to draw: no input carries a cov (coefficient of variation), or the stiffness that a load factor rests on is not known; give cov = 0.1 beside the value of an input",
            ko: "--samples로 추출할 것이 없다. cov(변동계수)가 있는 입력이 없거나 하중배율에 필요한 강성을 모른다. 입력의 값 옆에 cov = 0.1처럼 준다",
        },
        Wrote(files: String) => { en: "wrote {files}", ko: "쓴 파일: {files}" },
        RunsKept { journal: String, runs: usize } => {
            en: "{journal}: {runs} runs are kept from before",
            ko: "{journal}: 앞서 실행한 해석 {runs}개를 그대로 쓴다",
        },
        Tables(folder: String) => {
            en: "tables and figures are in {folder}",
            ko: "표와 그림을 {folder}에 썼다",
        },
        Designs { designs: usize, path: String, left_out: usize } => {
            en: "{designs} designs are in {path}; {left_out} were left out: scans are missing or cannot be used",
            ko: "설계 {designs}개를 {path}에 썼다. 조합이 없거나 쓸 수 없어 뺀 설계는 {left_out}개이다",
        },
        Identified(folder: String) => {
            en: "figures and identification.json are in {folder}",
            ko: "그림과 identification.json을 {folder}에 썼다",
        },
        Sensors(folder: String) => {
            en: "sensors.svg, sensors.json and sensors.toml are in {folder}",
            ko: "sensors.svg, sensors.json, sensors.toml을 {folder}에 썼다",
        },
        Compared(folder: String) => {
            en: "change.svg and change.json are in {folder}",
            ko: "change.svg와 change.json을 {folder}에 썼다",
        },
        Results(folder: String) => {
            en: "results and figures are in {folder}",
            ko: "결과와 그림을 {folder}에 썼다",
        },
        Watched(folder: String) => {
            en: "years.svg and watch.json are in {folder}",
            ko: "years.svg와 watch.json을 {folder}에 썼다",
        },
        Following { folder: String, structure: String, survey: String } => {
            en: "records that come into {folder} are taken for {structure}, with the settings of its survey {survey}",
            ko: "{folder}에 들어오는 기록을 {structure}의 {survey} 조사 설정으로 처리한다",
        },
        CameAgain { file: String, known_as: String } => {
            en: "{file} holds the same bytes as {known_as}, which is stored already: it is no new record, and is passed over",
            ko: "{file}은(는) 이미 저장된 {known_as}와(과) 내용이 같다. 새 기록이 아니므로 처리하지 않았다",
        },
        StillWritten(files: usize) => {
            en: "files that were still being written or too new: {files}; what rests by now was taken, the others are left for the next time",
            ko: "아직 쓰는 중이거나 너무 새로운 파일이 {files}개 있었다. 그사이 완료된 것은 처리하였고 나머지는 다음에 처리한다",
        },
        FolderMade(folder: String) => {
            en: "the folder {folder} was not there and is new",
            ko: "폴더 {folder}이(가) 없어 새로 만들었다",
        },
        Histories(folder: String) => {
            en: "histories and figures are in {folder}",
            ko: "시간이력과 그림을 {folder}에 썼다",
        },
        HistoriesAndFilm(folder: String) => {
            en: "histories, figures, film and exports are in {folder}",
            ko: "시간이력, 그림, 동영상(glTF), 내보낸 파일을 {folder}에 썼다",
        },
        DoesNotStand(why: String) => {
            en: "DOES NOT STAND without any shaking, so that nothing was simulated: {why}",
            ko: "지반운동이 없어도 서 있지 못하므로 해석하지 않았다: {why}",
        },
        LeftOutOfReport { count: usize, all: usize } => {
            en: "{count} of {all} projects left out of the report",
            ko: "프로젝트 {all}개 중 {count}개를 보고서에서 뺐다",
        },
        Boxes { count: usize, each: String } => {
            en: "the PDF shows {count} characters as boxes, its fonts do not have them: {each}",
            ko: "PDF의 글꼴에 없어 네모로 나오는 글자가 {count}개 있다: {each}",
        },
        ReportOnAll => { en: "The report on all of them:", ko: "모두를 담은 보고서:" },
        CopyOfExample { file: String, example: String } => {
            en: "{file} is a copy of the example {example}.",
            ko: "{file}은(는) 예제 {example}의 사본이다.",
        },
        Placeholders(file: String) => {
            en: "{file} holds placeholders alone: no survey, variant or source of another structure.",
            ko: "{file}에는 임시 값만 있으며 다른 구조물의 조사, 대안, 출처는 없다.",
        },
        NextOwnNumbers => {
            en: "Next: put your own numbers in it, then",
            ko: "다음: 자신의 값을 넣고 실행한다.",
        },
        NextNumbers => {
            en: "Next: put your own numbers in it (its README.md says what each means) and take out the example's surveys and variants (--bare makes a file without them), then",
            ko: "다음: 자신의 값을 넣고(각 값의 뜻은 README.md 참조) 예제의 조사와 대안을 지운 뒤(--bare는 이를 뺀 파일을 만든다) 실행한다.",
        },
        NextOfScan(folder: String) => {
            en: "{folder} holds the stones, project.toml and drawing.svg. Next: look at the drawing, put your own density and friction into the file, then",
            ko: "{folder}에 석재 메시, project.toml, drawing.svg를 썼다. 다음: 도면을 확인하고 밀도와 마찰계수를 실제 값으로 고친 뒤 실행한다.",
        },
        ForPagodas => { en: "cuts a scan into the stones of a pagoda (dolmen new pagoda)", ko: "스캔을 탑의 석재로 자를 때(dolmen new pagoda) 쓴다" },
        ForPulses => { en: "gives the period of a pulse (--make, but for noise)", ko: "--make로 만드는 펄스의 주기이다" },
        ForNearFault => { en: "shapes a near-fault pulse (--make near-fault)", ko: "근단층 펄스(--make near-fault)의 형상이다" },
        ForNoise => { en: "is for noise (--make noise)", ko: "잡음(--make noise)에 쓴다" },
        ForSpectra => { en: "is the damping ratio of spectra (--spectrum or --match)", ko: "응답스펙트럼(--spectrum이나 --match)의 감쇠비이다" },
        StudyLeftOut { study: String, why: Both } => {
            en: "study \"{study}\" is left out of the report: {why}",
            ko: "study \"{study}\"을(를) 보고서에서 뺐다: {why}",
        },
        Meant(near: String) => { en: " Did you mean {near}?", ko: " {near}을(를) 쓰려던 것인가?" },
    }
}

impl Noted {
    /// The note in the user's language.
    pub(crate) fn text(self, manner: &Manner) -> String {
        Both::from(self).text(manner.language()).to_owned()
    }
}

fn meant(near: Option<&str>) -> Both {
    near.map_or_else(|| Both::from(""), |near| Noted::Meant(near.to_owned()).into())
}

/// The text of an error of the command or of folders in both languages; `None` for any other.
pub(crate) fn of_command<'e>(error: &'e (dyn Error + 'static)) -> Option<&'e dyn Argument> {
    sayable!(error, CommandError).or_else(|| dolmen_follow::of_following(error))
}
