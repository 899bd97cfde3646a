//! Solutions of a stiffness from vibration: their values and differences.

use super::words::spring_word;
use crate::document::{Block, Cell, Column, Document, Figure, Table, table_series};
use crate::figures::{letter, solution_shapes};
use crate::html::words::verdict_word;
use dolmen::stability::Verdict;
use dolmen::structure::{
    Choice, MeasuredMode, NaturalMode, Spring, StiffnessBounds, StiffnessRange, StiffnessSolution,
};
use dolmen_project::{Project, Structure};
use dolmen_words::message::Both;
use dolmen_words::number::subscript;
use dolmen_words::{Digits, Quantity, Sentence, Unit, Values, messages};
use dolmen_work::surveyed::{OtherChoice, StiffnessAnswer};

/// Number of solutions listed; the rest are counted.
const SOLUTIONS_SHOWN: usize = 24;
/// A misfit below this is rounding. Our choice: sums of some thousand products keep 12 digits.
const ROUNDING: f64 = 1e-9;

messages! {
    /// Solutions.
    pub(crate) enum Solutions in "identification.solutions" {
        None => { en: "No stiffness explains these modes.", ko: "이 모드를 설명하는 강성이 없다." },
        Caption { shown: usize, total: usize } => {
            en: "Solutions, {shown} of {total} found.",
            ko: "구한 해 {total}개(표에는 {shown}개).",
        },
        Meaning { starts: usize, spring: Sentence } => {
            en: "k₁ is of the lowest {spring}, ± standard deviation. Starting points tried: {starts}; misfit is the root mean square deviation in units of the standard deviation, relative where none is given.",
            ko: "k₁은 맨 아래 {spring}의 강성이며 ±는 표준편차이다. 탐색 시작점 {starts}개. 오차는 표준편차 단위의 제곱평균제곱근이며, 표준편차가 없으면 상대값이다.",
        },
        RangeMeaning(widths: Values) => {
            en: "Least, most: the range while every frequency moves by √3 of its standard deviation, {widths}.",
            ko: "최소, 최대는 각 진동수가 표준편차의 √3배({widths})만큼 변할 때의 범위이다.",
        },
        BoundsMeaning => {
            en: "Above, below, to: what the data allow (95 %, the others free), with λ of the lowest that they allow.",
            ko: "이상, 이하, ~는 자료가 허용하는 한계(95 %, 다른 강성은 자유)이며 λ는 그 최소 강성의 값이다.",
        },
        Solution => { en: "Solution", ko: "해" },
        Verdict => { en: "verdict", ko: "판정" },
        VerdictWord(word: Both) => { en: "{word}", ko: "{word}" },
        LoadFactor => { en: "λ", ko: "λ" },
        Misfit => { en: "misfit", ko: "오차" },
        Least(solution: Sentence) => { en: "{solution}, least", ko: "{solution} 최소" },
        Most(solution: Sentence) => { en: "{solution}, most", ko: "{solution} 최대" },
        Between { lower: Quantity, upper: Quantity } => { en: "{lower} to {upper}", ko: "{lower} ~ {upper}" },
        Above(lower: Quantity) => { en: "above {lower}", ko: "{lower} 이상" },
        Below(upper: Quantity) => { en: "below {upper}", ko: "{upper} 이하" },
        Any => { en: "any", ko: "임의" },
        Shapes => { en: "Mode shapes of the solutions.", ko: "해별 모드형상." },
        SameFrequencies => {
            en: "The same frequencies, other shapes: a measured shape can tell which is the true one.",
            ko: "고유진동수는 같으나 형상이 다르므로 모드형상을 계측하면 참값을 가릴 수 있다.",
        },
        Rings => { en: "Rings are measured points.", ko: "고리는 계측점이다." },
        ModesCaption => { en: "Modes of the solutions.", ko: "해별 모드." },
        ModesMeaning => {
            en: "u: lateral displacement, the lowest first, the largest 1.",
            ko: "u는 횡변위이며 아래부터이고 최댓값을 1로 하였다.",
        },
        Mode => { en: "mode", ko: "모드" },
        Nth(number: usize) => { en: "{number}", ko: "{number}" },
        Frequency => { en: "f", ko: "f" },
    }
}

/// Tables and shapes of all solutions.
pub(super) fn section<'a>(
    document: &mut Document<'a>,
    project: &'a Project,
    answer: &'a StiffnessAnswer,
    measured: Vec<MeasuredMode>,
) {
    if answer.solutions.solutions.is_empty() {
        document.paragraph(Solutions::None);
        return;
    }
    document.put(Block::Table(table(answer)));
    let has_shapes = match &project.structure {
        // the shape of a single link or storey is trivial
        Structure::Chain(chain) => chain.links.len() > 1,
        Structure::Frame(frame) => frame.storeys.len() > 1,
        Structure::Stack(_) | Structure::Building(_) | Structure::Survey => false,
    };
    if has_shapes {
        let drawn = Figure::drawn(shapes_caption(answer), move |language| {
            solution_shapes(&project.structure, answer, &measured, language).unwrap_or_default()
        });
        document.charted(drawn.with_series(move || table_series(&modes_table(answer))));
    }
    document.put(Block::Table(modes_table(answer)));
}

/// The values of a solution, under a suitable prefix.
pub(super) fn stiffness_quantities(answer: &StiffnessAnswer, solution: &StiffnessSolution) -> Vec<Quantity> {
    let unit = Unit::of(&solution.stiffness, unit_si(answer));
    (0..solution.stiffness.len())
        .map(|at| value(answer, solution, at, &unit))
        .collect()
}

/// The same for another choice of modes.
pub(super) fn other_quantities(answer: &StiffnessAnswer, other: &OtherChoice) -> Vec<Quantity> {
    let unit = Unit::of(&other.stiffness, unit_si(answer));
    let sd = |at: usize| other.stiffness_sd.as_ref().and_then(|sd| sd.get(at)).copied();
    let each = other.stiffness.iter().enumerate();
    each.map(|(at, k)| Quantity {
        sd_si: sd(at),
        ..Quantity::new(*k, unit.clone(), Digits::Significant(4))
    })
    .collect()
}

/// The spring of the stiffness: only frames have conventions.
fn spring(answer: &StiffnessAnswer) -> Spring {
    match answer.convention {
        None => Spring::Joint,
        Some(_) => Spring::Storey,
    }
}

fn unit_si(answer: &StiffnessAnswer) -> &'static str {
    match spring(answer) {
        Spring::Joint => "N·m/rad",
        Spring::Storey => "N/m",
    }
}

fn shown(answer: &StiffnessAnswer) -> &[StiffnessSolution] {
    let all = &answer.solutions.solutions;
    &all[..all.len().min(SOLUTIONS_SHOWN)]
}

/// One prefix for stiffnesses that may differ by decades: that of their geometric mean.
fn unit(answer: &StiffnessAnswer) -> Unit {
    let least = |one: &StiffnessSolution| one.stiffness_least().unwrap_or_else(|| one.stiffness.clone());
    let all = shown(answer).iter().flat_map(least).filter(|k| *k > 0.0);
    let logarithms: Vec<f64> = all.map(f64::ln).collect();
    let mean = match logarithms.len() {
        0 => 0.0,
        count => f64::exp(logarithms.iter().sum::<f64>() / count as f64),
    };
    Unit::of(&[mean], unit_si(answer))
}

fn table(answer: &StiffnessAnswer) -> Table {
    let (shown, unit) = (shown(answer), unit(answer));
    let springs = shown.iter().map(|one| one.stiffness.len()).max().unwrap_or(0);
    let mut columns = vec![
        Column::words(Solutions::Solution),
        Column::words(Solutions::Verdict),
        Column::numbers(Solutions::LoadFactor, Unit::ratio()),
    ];
    columns.extend((1..=springs).map(|at| {
        let head = Sentence::of_symbol(&format!("k{}", subscript(at)));
        Column::numbers(head, unit.clone())
    }));
    columns.push(Column::numbers(Solutions::Misfit, Unit::ratio()));
    let rows = shown.iter().enumerate();
    Table {
        caption: caption(answer),
        columns,
        rows: rows
            .flat_map(|(at, one)| rows_of(at, one, answer, &unit))
            .collect(),
    }
}

fn caption(answer: &StiffnessAnswer) -> Vec<Sentence> {
    let shown = shown(answer);
    let mut caption = vec![
        Solutions::Caption {
            shown: shown.len(),
            total: answer.solutions.solutions.len(),
        }
        .into(),
        Solutions::Meaning {
            starts: answer.solutions.starts,
            spring: spring_word(spring(answer)),
        }
        .into(),
    ];
    if let Some(range) = shown.iter().find_map(|one| one.stiffness_range.as_ref()) {
        let width = |hz: &f64| Quantity::new(*hz, Unit::si("Hz"), Digits::Fixed(3));
        let widths = Values(range.half_width_hz.iter().map(width).collect());
        caption.push(Solutions::RangeMeaning(widths).into());
    }
    if shown.iter().any(|one| one.stiffness_bounds.is_some()) {
        caption.push(Solutions::BoundsMeaning.into());
    }
    caption
}

/// A solution, and its range if it has one.
fn rows_of(at: usize, solution: &StiffnessSolution, answer: &StiffnessAnswer, unit: &Unit) -> Vec<Vec<Cell>> {
    let name = Sentence::of_symbol(&letter(at));
    let factor = answer.load_factors.get(at).copied().flatten();
    let verdict = match answer.is_undoubted() {
        true => verdict(answer.solutions.choice, solution, factor),
        false => Verdict::Unknown,
    };
    let mut row = vec![
        Cell::words(name.clone()),
        Cell::words(Solutions::VerdictWord(Both::of(|language| {
            verdict_word(verdict, language)
        }))),
        load_factor(solution, factor),
    ];
    row.extend((0..solution.stiffness.len()).map(|spring| stiffness(answer, solution, spring, unit)));
    // a misfit below rounding is shown as none
    let misfit = Some(solution.misfit).filter(|misfit| *misfit > ROUNDING);
    row.push(Cell::number(
        misfit.map_or(Quantity::new(0.0, Unit::ratio(), Digits::Fixed(0)), |of| {
            Quantity::ratio(of, 2)
        }),
    ));
    let mut rows = vec![row];
    if let Some(StiffnessRange { lower, upper, .. }) = &solution.stiffness_range {
        let least = Solutions::Least(name.clone());
        rows.push(range_row(least, lower, unit));
        rows.push(range_row(Solutions::Most(name), upper, unit));
    }
    rows
}

fn load_factor(solution: &StiffnessSolution, factor: Option<f64>) -> Cell {
    let quantity = |factor| Quantity::beside_one(factor, 4);
    match factor {
        Some(factor) if factor <= 1.0 && solution.stiffness_bounds.is_none() => Cell::Bad(quantity(factor)),
        factor => Cell::Number(factor.map(quantity)),
    }
}

fn range_row(name: Solutions, ends: &[f64], unit: &Unit) -> Vec<Cell> {
    let end = |k: &f64| Cell::number(Quantity::new(*k, unit.clone(), Digits::Significant(4)));
    let mut row = vec![
        Cell::words(name),
        Cell::words(Sentence::of_symbol("")),
        Cell::Number(None),
    ];
    row.extend(ends.iter().map(end));
    row.push(Cell::Number(None));
    row
}

fn stiffness(answer: &StiffnessAnswer, solution: &StiffnessSolution, at: usize, unit: &Unit) -> Cell {
    let bounds = solution.stiffness_bounds.as_ref();
    match bounds.and_then(|bounds| bounds.get(at)) {
        Some(bound) => Cell::words(bounds_words(bound, unit)),
        None => Cell::number(value(answer, solution, at, unit)),
    }
}

fn value(answer: &StiffnessAnswer, solution: &StiffnessSolution, at: usize, unit: &Unit) -> Quantity {
    // a member of a family has fewer significant digits
    let digits = match answer.solutions.choice {
        Choice::Underdetermined => 3,
        Choice::One | Choice::Bounded | Choice::Indistinguishable | Choice::Impossible => 4,
    };
    Quantity {
        sd_si: solution.stiffness_sd.as_ref().and_then(|sd| sd.get(at)).copied(),
        ..Quantity::new(solution.stiffness[at], unit.clone(), Digits::Significant(digits))
    }
}

/// A stiffness that the data only bound; the column gives the unit.
fn bounds_words(bound: &StiffnessBounds, unit: &Unit) -> Solutions {
    let bare = Unit {
        symbol: String::new(),
        factor: unit.factor,
    };
    let number = |k: f64| Quantity::new(k, bare.clone(), Digits::Significant(3));
    match (bound.lower, bound.upper) {
        (Some(lower), Some(upper)) => Solutions::Between {
            lower: number(lower),
            upper: number(upper),
        },
        (Some(lower), None) => Solutions::Above(number(lower)),
        (None, Some(upper)) => Solutions::Below(number(upper)),
        (None, None) => Solutions::Any,
    }
}

/// Stability from the solutions. One member of a family is not sufficient for a verdict, and bounds are sufficient only if
/// the structure stands at the lowest.
fn verdict(choice: Choice, solution: &StiffnessSolution, factor: Option<f64>) -> Verdict {
    match (factor, &solution.stiffness_bounds) {
        (Some(factor), None) if choice != Choice::Underdetermined => Verdict::of_load_factor(factor),
        (Some(factor), Some(_)) if Verdict::of_load_factor(factor) == Verdict::Stable => Verdict::Stable,
        _ => Verdict::Unknown,
    }
}

/// The effect of shapes: a shape chooses between solutions only if their frequencies are equal.
fn shapes_caption(answer: &StiffnessAnswer) -> Vec<Sentence> {
    let mut caption = vec![Solutions::Shapes.into()];
    if answer.solutions.choice == Choice::Indistinguishable {
        caption.push(Solutions::SameFrequencies.into());
    }
    if answer.with_shapes {
        caption.push(Solutions::Rings.into());
    }
    caption
}

/// Modes that were not measured depend on every stiffness: they are shown if the data determine each.
fn modes_shown(solution: &StiffnessSolution, measured: usize) -> &[NaturalMode] {
    let most = match solution.stiffness_bounds {
        Some(_) => measured.min(solution.modes.len()),
        None => solution.modes.len(),
    };
    &solution.modes[..most]
}

fn modes_table(answer: &StiffnessAnswer) -> Table {
    let measured = answer.frequencies_hz.len();
    let places = shown(answer).iter().flat_map(|one| &one.modes);
    let places = places.map(|mode| mode.displacement.len()).max().unwrap_or(0);
    let mut columns = vec![
        Column::words(Solutions::Solution),
        Column::words(Solutions::Mode),
        Column::numbers(Solutions::Frequency, Unit::si("Hz")),
    ];
    columns.extend((1..=places).map(|at| {
        let head = Sentence::of_symbol(&format!("u{}", subscript(at)));
        Column::numbers(head, Unit::ratio())
    }));
    let mut rows = Vec::new();
    for (at, solution) in shown(answer).iter().enumerate() {
        for (number, mode) in modes_shown(solution, measured).iter().enumerate() {
            let mut row = vec![
                Cell::words(Sentence::of_symbol(&letter(at))),
                Cell::words(Solutions::Nth(number + 1)),
                Cell::number(Quantity::ratio(mode.frequency_hz, 5)),
            ];
            let shape = mode.displacement.iter();
            row.extend(shape.map(|u| Cell::number(Quantity::new(*u, Unit::ratio(), Digits::Fixed(3)))));
            rows.push(row);
        }
    }
    Table {
        caption: vec![Solutions::ModesCaption.into(), Solutions::ModesMeaning.into()],
        columns,
        rows,
    }
}
