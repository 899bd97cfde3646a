//! Messages during the work, and about the installation.

use dolmen_words::message::Both;
use dolmen_words::{Language, Quantity, messages};
use std::sync::OnceLock;
use std::time::Duration;

messages! {
    /// Progress, and the lines of `doctor`.
    pub(crate) enum AtWork in "command.at-work" {
        Computing => { en: "computing", ko: "계산 중" },
        Reading(file: String) => { en: "reading {file}", ko: "{file} 읽는 중" },
        Identifying(file: String) => { en: "modes of {file}", ko: "{file} 모드 식별 중" },
        Joining => { en: "all setups as one", ko: "모든 측정 배치를 하나로 식별 중" },
        Left => { en: "left; Ctrl-C keeps what is done", ko: "남음. Ctrl-C로 멈추면 그때까지의 결과를 남긴다" },
        Seconds(seconds: u64) => { en: "{seconds}s", ko: "{seconds}초" },
        Minutes(minutes: u64) => { en: "{minutes}m", ko: "{minutes}분" },
        Hours { hours: u64, minutes: u64 } => { en: "{hours}h {minutes}m", ko: "{hours}시간 {minutes}분" },
        RunsOf => { en: "of about", ko: "/ 약" },
        Runs => { en: "runs,", ko: "회," },
        On { version: String, system: String, processor: String } => {
            en: "dolmen {version} on {system} {processor}",
            ko: "dolmen {version}, {system} {processor}",
        },
        Processors(count: usize) => { en: "processors    {count}", ko: "프로세서      {count}개" },
        Reproducing => { en: "reproducing published numbers, some 20 s", ko: "문헌값 재현 중(약 20초)" },
        Numbers(count: usize) => {
            en: "numbers       {count} published numbers reproduced",
            ko: "문헌값        {count}개 모두 재현됨",
        },
        Examples(count: usize) => {
            en: "examples      {count} carried, all readable",
            ko: "예제          {count}개 들어 있고 모두 읽힘",
        },
        Files(folder: String) => {
            en: "files         written and read back in {folder}",
            ko: "파일          {folder}에 쓰고 다시 읽음",
        },
        Utf8(locale: String) => { en: "terminal      {locale}", ko: "터미널        {locale}" },
        NotUtf8(locale: String) => {
            en: "terminal      {locale}: not UTF-8, so 한글 and λ may be garbled (reports are not)",
            ko: "터미널        {locale}: UTF-8이 아니어서 한글과 λ가 깨질 수 있다(보고서는 괜찮다)",
        },
        NoLocale => {
            en: "terminal      no locale set: if 한글 and λ are garbled here, set LANG=C.UTF-8",
            ko: "터미널        로캘이 없다. 한글과 λ가 깨지면 LANG=C.UTF-8로 설정한다",
        },
        Well(took: Quantity) => { en: "all is well   ({took})", ko: "모두 정상     ({took})" },
    }
}

static LANGUAGE: OnceLock<Language> = OnceLock::new();

/// Sets the language of progress messages.
pub(crate) fn speak(language: Language) {
    let _ = LANGUAGE.set(language); // only the first call counts
}

/// The remaining time, in one or two units.
pub(crate) fn time_left(left: Duration) -> String {
    let seconds = left.as_secs();
    let minutes = seconds.div_ceil(60);
    match (seconds, minutes) {
        (..120, _) => AtWork::Seconds(seconds),
        (_, ..120) => AtWork::Minutes(minutes),
        (_, minutes) => AtWork::Hours {
            hours: minutes / 60,
            minutes: minutes % 60,
        },
    }
    .text()
}

impl AtWork {
    /// The message in the user's language.
    pub(crate) fn text(self) -> String {
        let language = LANGUAGE.get().copied().unwrap_or(Language::English);
        Both::from(self).text(language).to_owned()
    }
}
