//! The files of a motion and their channels, as read.

use crate::document::{Block, Cell, Column, Document, Table};
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen_records::motions::{ComponentReading, Orientation};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// Files and channels.
    pub(crate) enum Files in "motion.files" {
        One { file: String, format: String } => {
            en: "File {file}: {format}, 1 channel.",
            ko: "파일 {file}: {format} 형식, 채널 1개.",
        },
        Several { file: String, format: String, count: usize } => {
            en: "File {file}: {format}, {count} channels.",
            ko: "파일 {file}: {format} 형식, 채널 {count}개.",
        },
        Channel => { en: "channel", ko: "채널" },
        Name(name: String) => { en: "{name}", ko: "{name}" },
        Title => { en: "title", ko: "제목" },
        Direction => { en: "direction", ko: "방향" },
        NotGiven => { en: "not given", ko: "미기재" },
        Azimuth(azimuth: Quantity) => { en: "{azimuth}° from north", ko: "북에서 시계 방향 {azimuth}°" },
        Up => { en: "up", ko: "연직 상향" },
        Down => { en: "down", ko: "연직 하향" },
        InFile => { en: "unit", ko: "단위" },
        Samples => { en: "samples", ko: "표본 수" },
        Step => { en: "step", ko: "표본 간격" },
        Rate => { en: "rate", ko: "샘플링 주파수" },
        Peak => { en: "peak", ko: "최대 가속도" },
        MeanTakenOff { channel: String, mean: Quantity } => {
            en: "{channel}: its mean, {mean}, is taken off, as the format defines it.",
            ko: "채널 {channel}: 형식의 정의에 따라 평균값 {mean}을(를) 제거하였다.",
        },
    }
}

/// Digits of values stated in files.
const DIGITS: Digits = Digits::Trimmed(6);

/// Description of a file.
pub(super) fn file_words(file: &str, channels: &[ComponentReading]) -> Sentence {
    let (file, format) = (file.to_owned(), channels.first().map(|first| first.format.name()));
    let format = format.unwrap_or_default().to_owned();
    match channels.len() {
        1 => Files::One { file, format },
        count => Files::Several { file, format, count },
    }
    .into()
}

/// A file with its channels.
pub(super) fn section(document: &mut Document<'_>, file: &str, channels: &[ComponentReading]) {
    let has_titles = channels.iter().any(|channel| !channel.title.is_empty());
    let mut columns = vec![Column::words(Files::Channel)];
    columns.extend(has_titles.then(|| Column::words(Files::Title)));
    columns.extend([
        Column::words(Files::Direction),
        Column::words(Files::InFile),
        Column::numbers(Files::Samples, Unit::ratio()),
        Column::numbers(Files::Step, Unit::si("s")),
        Column::numbers(Files::Rate, Unit::si("Hz")),
        Column::numbers(Files::Peak, Unit::si("g")),
    ]);
    document.put(Block::Table(Table {
        caption: vec![file_words(file, channels)],
        columns,
        rows: channels.iter().map(|channel| row(channel, has_titles)).collect(),
    }));
    for channel in channels {
        if let Some(mean_m_s2) = channel.mean_subtracted_m_s2 {
            document.note(Files::MeanTakenOff {
                channel: name(channel),
                mean: Quantity::new(mean_m_s2, Unit::si("m/s²"), Digits::Fixed(6)),
            });
        }
    }
}

fn row(channel: &ComponentReading, has_titles: bool) -> Vec<Cell> {
    let peaks_m_s2 = channel.acceleration_m_s2.iter().map(|a| a.abs());
    let peak_g = peaks_m_s2.fold(0.0, f64::max) / STANDARD_GRAVITY_M_S2;
    let number = |value, digits| Cell::number(Quantity::new(value, Unit::ratio(), digits));
    let mut cells = vec![named(name(channel))];
    cells.extend(has_titles.then(|| named(channel.title.clone())));
    cells.extend([
        Cell::words(direction(channel.orientation)),
        Cell::words(Sentence::of_symbol(channel.unit.symbol())),
        number(channel.acceleration_m_s2.len() as f64, Digits::Fixed(0)),
        number(channel.time_step_s, DIGITS),
        number(1.0 / channel.time_step_s, DIGITS),
        number(peak_g, Digits::Fixed(4)),
    ]);
    cells
}

fn name(channel: &ComponentReading) -> String {
    match channel.name.as_str() {
        "" => "–".to_owned(),
        name => name.to_owned(),
    }
}

fn named(name: String) -> Cell {
    Cell::words(Files::Name(name))
}

fn direction(orientation: Option<Orientation>) -> Files {
    match orientation {
        None => Files::NotGiven,
        Some(Orientation::Up) => Files::Up,
        Some(Orientation::Down) => Files::Down,
        Some(Orientation::Horizontal { azimuth_deg }) => {
            Files::Azimuth(Quantity::new(azimuth_deg, Unit::ratio(), DIGITS))
        }
    }
}
