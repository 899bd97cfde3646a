//! Parts of messages, in English and Korean.

use crate::quoted::shown;
use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// Parts of several messages.
    pub(crate) enum Piece in "records.piece" {
        DidYouMean(near: String) => { en: " (did you mean \"{near}\"?)", ko: "(\"{near}\"을(를) 쓰려던 것인가?)" },
        LastLine => { en: "; it is the last line: the file was cut short", ko: ". 마지막 행이므로 파일이 잘린 것이다" },
        CheckUnit(unit: String) => {
            en: "check the unit {unit} and the numbers",
            ko: "단위 {unit}와(과) 수를 확인한다",
        },
        IsUnit { meant: Both, unit: String } => {
            en: "is the unit {meant} instead of {unit}?",
            ko: "단위가 {unit}이(가) 아니라 {meant}인가?",
        },
        Either { first: String, second: Both } => { en: "{first} or {second}", ko: "{first} 또는 {second}" },
        NoChannel(name: String) => { en: "there is no channel \"{name}\": ", ko: "채널 \"{name}\"이(가) 없다. " },
        GiveScale(scale: f64) => {
            en: "give its channel «scale = {scale}|the scale {scale}»",
            ko: "그 채널에 «scale = {scale}을(를)|배율 {scale}을(를)» 입력한다",
        },
        LeaveOut => {
            en: "leave it out: it measures something else",
            ko: "다른 물리량이므로 뺀다",
        },
        AtLine(line: usize) => { en: "line {line}: ", ko: "{line}행: " },
    }
}

messages! {
    /// Why a text is not a table of numbers.
    pub(crate) enum DiffersFromATable in "records.not-a-table" {
        NotATable { lines: usize, numbers: usize, cells: usize } => {
            en: "the file does not look like a table of numbers (its first {lines} lines hold {numbers} numbers in {cells} cells): is it the right file?",
            ko: "파일이 수의 표로 보이지 않는다(처음 {lines}행의 {cells}칸 중 수는 {numbers}칸). 맞는 파일인가?",
        },
    }
}

fn nothing() -> Both {
    Both::from("")
}

/// Suggests the nearest known name.
pub(super) fn did_you_mean(nearest: Option<&str>) -> Both {
    nearest.map_or_else(nothing, |near| Piece::DidYouMean(shown(near)).into())
}

/// Possible causes of a last line whose length differs.
pub(super) fn last_line(is_last: bool) -> Both {
    match is_last {
        true => Piece::LastLine.into(),
        false => nothing(),
    }
}

/// Possible units of the numbers.
pub(super) fn unit_meant(unit: &str, suggested: &[&str]) -> Both {
    let unit = unit.to_owned();
    let Some((last, others)) = suggested.split_last() else {
        return Piece::CheckUnit(unit).into();
    };
    let meant = others.iter().rev().fold(Both::from(*last), |second, first| {
        let first = (*first).to_owned();
        Piece::Either { first, second }.into()
    });
    Piece::IsUnit { meant, unit }.into()
}

/// A requested channel does not exist.
pub(super) fn no_channel(given: Option<&str>) -> Both {
    given.map_or_else(nothing, |name| Piece::NoChannel(shown(name)).into())
}

/// The remedy for a column in another unit: the scale to the unit of the record, with ten digits.
pub(super) fn scale_or_leave_out(scale: Option<f64>) -> Both {
    let rounded = |scale: f64| format!("{scale:.9e}").parse().unwrap_or(scale);
    scale.map_or_else(
        || Piece::LeaveOut.into(),
        |scale| Piece::GiveScale(rounded(scale)).into(),
    )
}

/// The line number, for files that have lines.
pub(super) fn at_line(line: usize) -> Both {
    match line {
        0 => nothing(),
        line => Piece::AtLine(line).into(),
    }
}
