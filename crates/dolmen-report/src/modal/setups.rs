//! Joined setups of one survey.

use super::joint;
use super::setup_remarks::setup_remarks;
use super::shapes::{ShapeFigures, shape_figures};
use super::tables::{first_columns, frequency_and_damping, nth, shapes_table};
use super::values::fixed;
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen::modal::{MergedMode, Mode};
use dolmen_words::{Quantity, Unit, messages};
use dolmen_work::surveyed::SetupsAnswer;

messages! {
    /// Setups put together.
    pub(crate) enum Setups in "modal.setups" {
        Head { survey: String } => { en: "Setups put together: {survey}", ko: "측정 배치의 합성: {survey}" },
        Rests { setups: usize, sensors: usize, references: Vec<String> } => {
            en: "{setups} setups, {sensors} sensors; in more than one setup: {references}.",
            ko: "측정 배치 {setups}개, 센서 {sensors}개; 둘 이상의 배치에 있는 센서: {references}.",
        },
        NoMode => {
            en: "No mode is shown by every setup.",
            ko: "모든 배치에서 공통으로 확인된 모드가 없다.",
        },
        Caption => {
            en: "Modes of all setups, ± standard deviation.",
            ko: "모든 배치의 모드, ± 표준편차.",
        },
        Meaning => {
            en: "Means by inverse variance; p is the probability that setups which agree differ so much (χ²), and where they differ the deviations are widened.",
            ko: "역분산 가중 평균이며, p는 배치가 서로 일치할 때 이만한 차이가 나타날 확률(χ²)이다. 차이가 유의하면 표준편차를 넓혔다.",
        },
        OfSetup { number: usize } => { en: "setup {number}", ko: "배치 {number}" },
        FrequencyChance => { en: "p, frequency", ko: "진동수 차이의 p" },
        DampingChance => { en: "p, damping", ko: "감쇠비 차이의 p" },
        LeastAssurance => { en: "least MAC of the references", ko: "기준 센서 MAC 최소" },
    }
}

/// The joined result of all setups; the results of single setups come before it.
pub(super) fn section<'a>(document: &mut Document<'a>, survey: &str, setups: &'a SetupsAnswer) {
    let modes = &setups.merged.modes;
    document.heading(Setups::Head {
        survey: survey.to_owned(),
    });
    let references = setups.merged.references.iter();
    let references = references.filter_map(|&at| modes.channels.get(at));
    document.paragraph(Setups::Rests {
        setups: setups.records.len(),
        sensors: modes.channels.len(),
        references: references.map(|channel| channel.name.clone()).collect(),
    });
    if modes.modes.is_empty() {
        document.paragraph(Setups::NoMode);
    } else {
        document.put(Block::Table(modes_table(setups)));
        if setups.joint.is_none() {
            document.put(Block::Table(shapes_table(modes)));
        }
        shape_figures(document, modes, ShapeFigures::Setups);
    }
    if let Some(of) = &setups.joint {
        joint::section(document, survey, of);
    }
    for remark in setup_remarks(setups) {
        document.note(remark);
    }
}

fn modes_table(setups: &SetupsAnswer) -> Table {
    let merged = &setups.merged;
    let mut columns = first_columns();
    let each = 1..=setups.records.len();
    columns.extend(each.map(|number| Column::numbers(Setups::OfSetup { number }, Unit::si("Hz"))));
    columns.extend([
        Column::numbers(Setups::FrequencyChance, Unit::ratio()),
        Column::numbers(Setups::DampingChance, Unit::ratio()),
        Column::numbers(Setups::LeastAssurance, Unit::ratio()),
    ]);
    let both = merged.modes.modes.iter().zip(&merged.merged).enumerate();
    Table {
        caption: vec![Setups::Caption.into(), Setups::Meaning.into()],
        columns,
        rows: both.map(|(at, (mode, of))| row(at, mode, of)).collect(),
    }
}

fn row(at: usize, mode: &Mode, of: &MergedMode) -> Vec<Cell> {
    let mut row = vec![nth(at)];
    row.extend(frequency_and_damping(mode));
    row.extend(of.frequency_hz.iter().map(|hz| Cell::number(fixed(*hz, 4))));
    let chance = |p: Option<f64>, differs: bool| match p.map(|p| fixed(p, 3)) {
        Some(p) if differs => Cell::Bad(p),
        p => Cell::Number(p),
    };
    row.push(chance(of.frequency.p, of.frequency.differs()));
    let damping = of.damping.as_ref();
    let differs = damping.is_some_and(|damping| damping.differs());
    row.push(chance(damping.and_then(|damping| damping.p), differs));
    let all = of.reference_assurance.iter().flatten().copied();
    let least: Option<Quantity> = all.min_by(f64::total_cmp).map(|mac| fixed(mac, 3));
    row.push(Cell::Number(least));
    row
}
