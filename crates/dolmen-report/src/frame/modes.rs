//! The natural modes of a frame.

use crate::document::{Block, Cell, Column, Document, Figure, Table, table_series};
use crate::figures::{ShapePanel, mode_shapes};
use dolmen::assess::FrameCheck;
use dolmen::structure::{Frame, NaturalMode};
use dolmen_words::{Digits, Language, Quantity, Sentence, Unit, messages};

messages! {
    /// Natural modes.
    pub(crate) enum Modes in "frame.modes" {
        Caption => { en: "Natural modes on the given stiffness.", ko: "주어진 강성에 대한 고유모드." },
        Drawn => {
            en: "Displacement of each level, the largest drawn alike; undamped.",
            ko: "각 층의 변위이며 최댓값을 같게 그렸다(비감쇠).",
        },
        TableCaption => {
            en: "Natural frequencies and mode shapes on the given stiffness.",
            ko: "주어진 강성에 대한 고유진동수와 모드형상.",
        },
        Largest => {
            en: "Displacement of each level, the largest 1; undamped.",
            ko: "각 층의 변위이며 최댓값을 1로 하였다(비감쇠).",
        },
        Mode { number: usize } => { en: "mode {number}", ko: "모드 {number}" },
        Head => { en: "Mode", ko: "모드" },
        Number { number: usize } => { en: "{number}", ko: "{number}" },
        Frequency => { en: "natural frequency", ko: "고유진동수" },
        Level { level: usize } => { en: "level {level}", ko: "{level}층" },
        Falls => { en: "falls", ko: "불안정" },
    }
}

/// Shapes of the modes and their numbers, if there are any.
pub(super) fn section<'a>(document: &mut Document<'a>, frame: Option<Frame>, check: &'a FrameCheck) {
    if check.modes.is_empty() {
        return;
    }
    // the shape of a single storey is trivial
    if let Some(frame) = frame.filter(|frame| frame.storeys().len() > 1) {
        let caption = vec![Modes::Caption.into(), Modes::Drawn.into()];
        let shapes = Figure::drawn(caption, move |language| drawn(&frame, &check.modes, language));
        document.charted(shapes.with_series(|| table_series(&table(&check.modes))));
    }
    document.put(Block::Table(table(&check.modes)));
}

fn table(modes: &[NaturalMode]) -> Table {
    let levels = modes.first().map_or(0, |mode| mode.displacement.len());
    let mut columns = vec![
        Column::words(Modes::Head),
        Column::numbers(Modes::Frequency, Unit::si("Hz")),
    ];
    let level = |level| Column::numbers(Modes::Level { level }, Unit::ratio());
    columns.extend((1..=levels).map(level));
    Table {
        caption: vec![Modes::TableCaption.into(), Modes::Largest.into()],
        columns,
        rows: modes.iter().enumerate().map(row).collect(),
    }
}

fn row((i, mode): (usize, &NaturalMode)) -> Vec<Cell> {
    let frequency = match mode.omega_squared > 0.0 {
        true => Cell::number(Quantity::new(
            mode.frequency_hz,
            Unit::si("Hz"),
            Digits::Significant(4),
        )),
        false => Cell::BadWords(Modes::Falls.into()),
    };
    let mut row = vec![Cell::words(Modes::Number { number: i + 1 }), frequency];
    let displacement = |u: &f64| Cell::number(Quantity::new(*u, Unit::ratio(), Digits::Fixed(4)));
    row.extend(mode.displacement.iter().map(displacement));
    row
}

fn drawn(frame: &Frame, modes: &[NaturalMode], language: Language) -> String {
    let panel = |(i, mode)| ShapePanel {
        title: Sentence::from(Modes::Mode { number: i + 1 }).text(language),
        mode,
        measured: &[],
    };
    let panels: Vec<ShapePanel<'_>> = modes.iter().enumerate().map(panel).collect();
    mode_shapes(&frame.level_heights_m(), &panels, language)
}
