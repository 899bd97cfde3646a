//! Answers on a plan for sensors.

mod lines;
mod words;

pub(crate) use lines::channel_lines;
pub(crate) use words::Planned;

use crate::brief_rows::BriefText;
use crate::document::{Block, Cell, Column, Document, Table, TextStyle, document_text, heading_text};
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Template, Unit};
use dolmen_work::sensors::{PlannedMode, SensorsAnswer, SensorsOf};
use words::{axes_words, side_words};

/// Templates of the sentences on sensors.
pub(crate) const TEMPLATES: [&[Template]; 1] = [Planned::TEMPLATES];

/// The plan: the sensors, then how well they measure each mode.
pub fn sensors_text(answer: &SensorsAnswer, style: TextStyle) -> String {
    let head = heading_text(&Sentence::from(head(answer)).text(style.language));
    match style.is_full {
        true => head + &document_text(&sections(answer), style),
        false => head + &brief(answer, style),
    }
}

fn head(answer: &SensorsAnswer) -> Planned {
    let name = &answer.project.name;
    Planned::Head(Both::of(|language| language.pick(name.english(), name.korean())))
}

fn sections(answer: &SensorsAnswer) -> Document<'static> {
    let mut document = Document::default();
    for block in findings(answer) {
        document.put(block);
    }
    document.put(Block::Table(sensors(answer)));
    document.put(Block::Table(modes(answer)));
    for block in remarks(answer) {
        document.put(block);
    }
    document
}

fn brief(answer: &SensorsAnswer, style: TextStyle) -> String {
    let mut brief = BriefText::new(style);
    brief.blocks(findings(answer));
    let table = sensors(answer);
    brief.table(&table, table.rows.len());
    brief.blocks(remarks(answer).into_iter().take(1));
    let table = modes(answer);
    brief.table(&table, table.rows.len());
    brief.finish()
}

/// Whether the modes are measured and distinguished.
fn findings(answer: &SensorsAnswer) -> Vec<Block<'static>> {
    let mut all = Vec::new();
    for (at, mode) in answer
        .modes
        .iter()
        .enumerate()
        .filter(|(_, mode)| mode.is_hardly_seen())
    {
        let (mode, share) = (at + 1, percent(mode.seen_ratio));
        all.push(Block::Warning(Planned::HardlySeen { mode, share }.into()));
    }
    for (at, mode) in answer.modes.iter().enumerate() {
        if let Some((other, alike)) = mode
            .taken_for()
            .filter(|(other, _)| *other > at || !takes_back(answer, *other, at))
        {
            let found = Planned::Alike {
                mode: at + 1,
                other: other + 1,
                mac: Quantity::ratio(alike, 2),
            };
            all.push(Block::Warning(found.into()));
        }
    }
    if all.is_empty() {
        let each = answer.modes.iter().filter_map(|mode| mode.most_alike);
        let most = each.map(|(_, alike)| alike).fold(0.0, f64::max);
        let least = answer
            .modes
            .iter()
            .map(|mode| mode.seen_ratio)
            .fold(1.0, f64::min);
        let found = match answer.modes.len() {
            1 => Planned::SeesOne(percent(least)),
            modes if most > ALIKE => Planned::TellsApartByFrequency {
                modes,
                mac: Quantity::ratio(most, 2),
                share: percent(least),
            },
            modes => Planned::TellsApart {
                modes,
                mac: Quantity::ratio(most, 2),
                share: percent(least),
            },
        };
        all.push(Block::Paragraph(vec![found.into()]));
    }
    if !answer.without_dampers.is_empty() {
        let dampers = answer.without_dampers.clone();
        all.push(Block::Warning(Planned::WithoutDampers(dampers).into()));
    }
    all
}

/// MAC of two modes above which records hardly distinguish their shapes, as in findings on modes.
const ALIKE: f64 = 0.5;

fn takes_back(answer: &SensorsAnswer, other: usize, at: usize) -> bool {
    let back = answer.modes.get(other).and_then(PlannedMode::taken_for);
    back.is_some_and(|(of, _)| of == at)
}

fn remarks(answer: &SensorsAnswer) -> Vec<Block<'static>> {
    let mut all: Vec<Planned> = Vec::new();
    match answer.of {
        SensorsOf::Given => {}
        SensorsOf::EqualJoints => all.push(Planned::EqualJoints),
        SensorsOf::EqualStoreys => all.push(Planned::EqualStoreys),
    }
    all.push(Planned::FromModel);
    if answer.setups > 1 {
        all.push(Planned::Setups);
    }
    all.push(Planned::Write);
    all.into_iter().map(|remark| Block::Note(remark.into())).collect()
}

fn percent(ratio: f64) -> Quantity {
    Quantity::new(ratio, Unit::percent(), Digits::Fixed(0))
}

fn sensors(answer: &SensorsAnswer) -> Table {
    let metres = || Unit::si("m");
    let mut columns = vec![
        Column::numbers(Planned::Number, Unit::ratio()),
        Column::words(Planned::Part),
        Column::words(Planned::Place),
        Column::numbers(Planned::X, metres()),
        Column::numbers(Planned::Y, metres()),
        Column::numbers(Planned::Z, metres()),
        Column::words(Planned::Axes),
    ];
    if answer.setups > 1 {
        columns.push(Column::words(Planned::Setup));
    }
    let rows = answer.sensors.iter().enumerate().map(|(at, sensor)| {
        let place = |axis: usize| Quantity::new(sensor.site.position_m[axis], metres(), Digits::Fixed(2));
        let mut cells = vec![
            Cell::number(Quantity::new((at + 1) as f64, Unit::ratio(), Digits::Fixed(0))),
            Cell::words(Planned::Name(sensor.site.part.clone())),
            Cell::words(side_words(sensor.site.side)),
            Cell::number(place(0)),
            Cell::number(place(1)),
            Cell::number(place(2)),
            Cell::words(axes_words(&sensor.site.axes)),
        ];
        if answer.setups > 1 {
            cells.push(Cell::words(match sensor.setup {
                None => Planned::Stays,
                Some(setup) => Planned::InSetup(setup + 1),
            }));
        }
        cells
    });
    Table {
        caption: vec![Planned::SensorsCaption(answer.sites).into()],
        columns,
        rows: rows.collect(),
    }
}

fn modes(answer: &SensorsAnswer) -> Table {
    let columns = vec![
        Column::numbers(Planned::Mode, Unit::ratio()),
        Column::numbers(Planned::Frequency, Unit::si("Hz")),
        Column::words(Planned::Moves),
        Column::numbers(Planned::Seen, Unit::percent()),
        Column::words(Planned::MostAlike),
    ];
    let rows = answer.modes.iter().enumerate().map(|(at, mode)| {
        vec![
            Cell::number(Quantity::new((at + 1) as f64, Unit::ratio(), Digits::Fixed(0))),
            mode.frequency_hz.map_or_else(
                || Cell::words(Planned::Unknown),
                |hz| Cell::number(Quantity::new(hz, Unit::si("Hz"), Digits::Significant(3))),
            ),
            Cell::words(words::moves(mode)),
            Cell::number(percent(mode.seen_ratio)),
            Cell::words(match mode.most_alike {
                None => Planned::None,
                Some((other, alike)) => Planned::Like {
                    mode: other + 1,
                    mac: Quantity::ratio(alike, 2),
                },
            }),
        ]
    });
    Table {
        caption: vec![Planned::ModesCaption.into()],
        columns,
        rows: rows.collect(),
    }
}
