//! Answers on a scan cut into stones.

mod words;

use crate::brief_rows::BriefText;
use crate::document::{Block, Cell, Column, Document, Table, TextStyle, document_text, heading_text};
use dolmen_words::{Digits, Quantity, Sentence, Template, Unit};
use dolmen_work::scanned::{ScanAnswer, listed_steps};
use words::Scanned;

/// Templates of the sentences on scans.
pub(crate) const TEMPLATES: [&[Template]; 1] = [Scanned::TEMPLATES];

/// A bed within this distance of the given height is at that height, m: noise moves it by less.
const ONE_HEIGHT_M: f64 = 1e-3;

/// The beds and the stones.
pub fn scan_text(answer: &ScanAnswer, style: TextStyle) -> String {
    let head = Scanned::Head(answer.file.clone());
    let head = heading_text(&Sentence::from(head).text(style.language));
    let body = match style.is_full {
        true => {
            let mut document = Document::default();
            findings(answer).into_iter().for_each(|block| document.put(block));
            document.put(Block::Table(beds(answer)));
            document.put(Block::Table(stones(answer)));
            document_text(&document, style)
        }
        false => {
            let mut brief = BriefText::new(style);
            brief.blocks(findings(answer));
            let table = beds(answer);
            brief.table(&table, table.rows.len());
            brief.finish()
        }
    };
    head + &body
}

fn findings(answer: &ScanAnswer) -> Vec<Block<'static>> {
    let metres = |value: f64| Quantity::new(value, Unit::si("m"), Digits::Fixed(3));
    let sliced = &answer.sliced;
    let whole = Scanned::Whole {
        stones: answer.stones.len(),
        beds: sliced.beds.len(),
        share: Quantity::new(sliced.volume_ratio, Unit::percent(), Digits::Fixed(2)),
        volume: Quantity::new(sliced.volume_m3, Unit::si("m³"), Digits::Significant(4)),
    };
    let mut all = vec![Block::Paragraph(vec![whole.into()])];
    if answer.is_unit_recognised {
        let unit = Scanned::UnitRecognised {
            height: format!("{:.3}", answer.height_in_file),
            unit: answer.unit.symbol(),
            height_m: metres(sliced.span_m[1] - sliced.span_m[0]),
        };
        all.push(Block::Warning(unit.into()));
    }
    if answer.moved_m != [0.0; 3] {
        let [x, y, z] = answer.moved_m.map(metres);
        all.push(Block::Warning(Scanned::Moved { x, y, z }.into()));
    }
    let moved = sliced
        .beds
        .iter()
        .filter(|bed| (bed.at_m - bed.named_m).abs() > ONE_HEIGHT_M);
    let beds = moved.count();
    if beds > 0 {
        all.push(Block::Warning(Scanned::AtSteps(beds).into()));
    }
    if !sliced.steps_without_bed.is_empty() {
        let steps = listed_steps(&sliced.steps_without_bed);
        all.push(Block::Warning(Scanned::StepsAllowed(steps).into()));
    }
    let plain = sliced.beds.iter().enumerate().filter(|(_, bed)| !bed.is_at_step);
    let plain: Vec<String> = plain.map(|(at, _)| (at + 1).to_string()).collect();
    if !plain.is_empty() {
        let beds = plain.join(", ");
        all.push(Block::Warning(Scanned::NoStep(beds).into()));
    }
    // a stone alone between two beds has no letter
    let pieces = answer.stones.iter().map(|stone| stone.name.as_str());
    let pieces: Vec<&str> = pieces
        .filter(|name| name.ends_with(char::is_alphabetic))
        .collect();
    if !pieces.is_empty() {
        all.push(Block::Warning(Scanned::Pieces(pieces.join(", ")).into()));
    }
    all.push(Block::Warning(Scanned::Assumed.into()));
    all
}

fn count(number: usize) -> Cell {
    Cell::number(Quantity::new(number as f64, Unit::ratio(), Digits::Fixed(0)))
}

fn beds(answer: &ScanAnswer) -> Table {
    let (metres, square) = (|| Unit::si("m"), || Unit::si("m²"));
    let rows = answer.sliced.beds.iter().enumerate().map(|(at, bed)| {
        vec![
            count(at + 1),
            Cell::number(Quantity::new(bed.named_m, metres(), Digits::Fixed(4))),
            Cell::number(Quantity::new(bed.at_m, metres(), Digits::Fixed(4))),
            Cell::number(Quantity::new(bed.area_below_m2, square(), Digits::Significant(4))),
            Cell::number(Quantity::new(bed.area_above_m2, square(), Digits::Significant(4))),
        ]
    });
    Table {
        caption: vec![Scanned::Beds.into()],
        columns: vec![
            Column::numbers(Scanned::Number, Unit::ratio()),
            Column::numbers(Scanned::Named, metres()),
            Column::numbers(Scanned::Cut, metres()),
            Column::numbers(Scanned::Below, square()),
            Column::numbers(Scanned::Above, square()),
        ],
        rows: rows.collect(),
    }
}

fn stones(answer: &ScanAnswer) -> Table {
    let name = |name: &String| Cell::words(Scanned::Name(name.clone()));
    let rows = answer.stones.iter().map(|stone| {
        vec![
            name(&stone.name),
            name(&stone.file),
            Cell::number(Quantity::new(
                stone.volume_m3,
                Unit::si("m³"),
                Digits::Significant(4),
            )),
            count(stone.triangles),
        ]
    });
    Table {
        caption: vec![Scanned::Stones.into()],
        columns: vec![
            Column::words(Scanned::Stone),
            Column::words(Scanned::File),
            Column::numbers(Scanned::Volume, Unit::si("m³")),
            Column::numbers(Scanned::Triangles, Unit::ratio()),
        ],
        rows: rows.collect(),
    }
}
