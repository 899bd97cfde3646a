//! The natural modes of a chain.

use crate::document::{Block, Cell, Column, Document, Figure, Table, table_series};
use crate::figures::{ShapePanel, mode_shapes};
use dolmen::assess::ChainCheck;
use dolmen::structure::{Chain, Inertia, NaturalMode};
use dolmen_words::{Digits, Language, Quantity, Unit, messages};

messages! {
    /// Natural modes.
    pub(crate) enum Modes in "chain.modes" {
        Head => { en: "Natural modes", ko: "고유진동수와 모드형상" },
        Caption => { en: "Natural modes.", ko: "고유모드." },
        CaptionMeaning => {
            en: "Lateral displacement of each link's top, the largest drawn alike; undamped.",
            ko: "각 부재 상단의 횡변위이며 최댓값을 같게 그렸다(비감쇠).",
        },
        ThinRods => {
            en: "Links without a given moment of inertia or breadth are taken as thin rods; this changes frequencies, not stability.",
            ko: "관성모멘트나 폭이 주어지지 않은 부재는 가는 봉으로 보았다. 이는 진동수에만 영향을 주고 안정성에는 영향이 없다.",
        },
        Table => { en: "Natural frequencies and shapes.", ko: "고유진동수와 모드형상." },
        TableMeaning => {
            en: "Displacement of each link's top, the largest 1.",
            ko: "각 부재 상단의 변위이며 최댓값을 1로 하였다.",
        },
        Number => { en: "Mode", ko: "모드" },
        Nth { number: usize } => { en: "{number}", ko: "{number}" },
        Frequency => { en: "f", ko: "f" },
        Falls => { en: "falls", ko: "불안정" },
        Link { number: usize } => { en: "link {number}", ko: "부재 {number}" },
        Mode { number: usize } => { en: "mode {number}", ko: "모드 {number}" },
    }
}

/// Shapes of the modes, if there are any.
pub(super) fn section<'a>(document: &mut Document<'a>, chain: Option<Chain>, check: &'a ChainCheck) {
    if check.modes.is_empty() {
        return;
    }
    document.heading(Modes::Head);
    let Some(chain) = chain else { return };
    let thin = chain.links().iter().any(|link| link.inertia == Inertia::ThinRod);
    // the shape of a single link is trivial
    if chain.links().len() > 1 {
        let caption = vec![Modes::Caption.into(), Modes::CaptionMeaning.into()];
        let shapes = Figure::drawn(caption, move |language| drawn(&chain, check, language));
        document.charted(shapes.with_series(|| table_series(&table(&check.modes))));
    }
    document.put(Block::Table(table(&check.modes)));
    if thin {
        document.note(Modes::ThinRods);
    }
}

/// The table without drawn shapes.
pub(super) fn table_alone(document: &mut Document<'_>, modes: &[NaturalMode]) {
    if !modes.is_empty() {
        document.put(Block::Table(table(modes)));
    }
}

fn table(modes: &[NaturalMode]) -> Table {
    let links = modes.first().map_or(0, |mode| mode.displacement.len());
    let mut columns = vec![
        Column::words(Modes::Number),
        Column::numbers(Modes::Frequency, Unit::si("Hz")),
    ];
    columns.extend((1..=links).map(|number| Column::numbers(Modes::Link { number }, Unit::ratio())));
    let row = |(at, mode): (usize, &NaturalMode)| {
        let frequency = match mode.omega_squared > 0.0 {
            true => Cell::number(Quantity::ratio(mode.frequency_hz, 4)),
            false => Cell::BadWords(Modes::Falls.into()),
        };
        let shape = mode.displacement.iter();
        let shape = shape.map(|u| Cell::number(Quantity::new(*u, Unit::ratio(), Digits::Fixed(4))));
        let mut row = vec![Cell::words(Modes::Nth { number: at + 1 }), frequency];
        row.extend(shape);
        row
    };
    Table {
        caption: vec![Modes::Table.into(), Modes::TableMeaning.into()],
        columns,
        rows: modes.iter().enumerate().map(row).collect(),
    }
}

fn drawn(chain: &Chain, check: &ChainCheck, language: Language) -> String {
    let tops = chain.links().iter().scan(0.0, |height, link| {
        *height += link.length_m;
        Some(*height)
    });
    let heights: Vec<f64> = tops.collect();
    let panel = |(i, mode)| ShapePanel {
        title: dolmen_words::Sentence::from(Modes::Mode { number: i + 1 }).text(language),
        mode,
        measured: &[],
    };
    let panels: Vec<ShapePanel<'_>> = check.modes.iter().enumerate().map(panel).collect();
    mode_shapes(&heights, &panels, language)
}
