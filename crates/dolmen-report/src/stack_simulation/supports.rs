//! A stack with slowly moving supports, over time: the movement at which it falls, by each law and by limit analysis.

use super::crushing;
use super::run::made_in;
use crate::document::{
    Block, Cell, Column, Document, Figure, Finding, Table, TextStyle, Tone, document_text, findings_text,
};
use crate::figures::{supports_in_time, supports_series};
use crate::simulated::{milli, millimetres, seconds};
use crate::stack::movements;
use dolmen::blocks::{ContactLaw, Outcome, StackHistory};
use dolmen::stability::stack::MovedSupports;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::stack::{SupportsRun, SupportsSimulation};

/// Relative difference between runs and limit analysis from which it is a finding. Our choice: twice the effect of springs and inertia in
/// arches.
const APART: f64 = 0.05;

messages! {
    /// Supports that move, in time.
    pub(crate) enum InTime in "stack-simulation.supports" {
        Head => { en: "Supports that move slowly", ko: "서서히 움직이는 지점" },
        Moves { movements: Sentence, ending: Sentence } => {
            en: "Supports that move slowly: {movements}. {ending}",
            ko: "서서히 움직이는 지점: {movements}. {ending}",
        },
        Springs { ending: Sentence } => { en: "With springs in the joints {ending}", ko: "접촉 스프링 해석: {ending}" },
        Rigid { ending: Sentence } => { en: "With rigid joints {ending}", ko: "강체 접촉 해석: {ending}" },
        Both { first: Sentence, next: Sentence } => { en: "{first} {next}", ko: "{first} {next}" },
        Fell { factor: Quantity, length: Quantity, block: String } => {
            en: "it gave way at {factor} times that ({length}), and '{block}' came down first.",
            ko: "그 {factor}배({length})에서 무너지기 시작하여 ‘{block}’이(가) 가장 먼저 쓰러지거나 떨어졌다.",
        },
        StoodTo { factor: Quantity, length: Quantity } => {
            en: "it stood up to the end, {factor} times that ({length}).",
            ko: "끝인 그 {factor}배({length})까지 서 있었다.",
        },
        OnTheBrink { factor: Quantity, length: Quantity, block: String } => {
            en: "it stood up to the end, {factor} times that ({length}), but '{block}' lies on the brink there.",
            ko: "끝인 그 {factor}배({length})까지 서 있었으나 그때 ‘{block}’이(가) 떨어지기 직전이다.",
        },
        Open { factor: Quantity, length: Quantity, at: Quantity } => {
            en: "the run ended at {at}, {factor} times that ({length}), without a verdict; until then nothing had fallen.",
            ko: "해석이 {at}, 곧 그 {factor}배({length})에서 끝나 판정하지 않는다. 그때까지 떨어진 부재는 없다.",
        },
        Lost { at: Quantity } => {
            en: "the run could not be used from {at} on: take half the step.",
            ko: "{at} 이후의 해석 결과는 쓸 수 없다. 시간 간격을 반으로 줄인다.",
        },
        NoRun => { en: "No run was made.", ko: "해석하지 않았다." },
        Limit { factor: Quantity, length: Quantity } => {
            en: "Limit analysis of the shape as it moves finds no balance beyond {factor} times that ({length}).",
            ko: "움직이는 형상의 한계해석에서는 그 {factor}배({length})를 넘으면 평형이 없다.",
        },
        LimitStands { factor: Quantity, length: Quantity } => {
            en: "Limit analysis of the shape as it moves still finds balance at {factor} times that ({length}).",
            ko: "움직이는 형상의 한계해석에서는 그 {factor}배({length})에서도 평형이 있다.",
        },
        Apart { share: Quantity, law: Sentence } => {
            en: "That differs by {share} from the run with {law}: stones slide or come to touch anew, or soft joints let hinges move inwards. Take the least.",
            ko: "{law}의 해석과 {share} 차이가 난다. 부재가 미끄러지거나 새로 맞닿거나, 무른 접합면에서 힌지가 안쪽으로 옮겨진 것이다. 가장 작은 값을 쓴다.",
        },
        SpringsLaw => { en: "springs", ko: "접촉 스프링" },
        RigidLaw => { en: "rigid joints", ko: "강체 접촉" },
        LeftOut { law: Sentence, why: String } => {
            en: "No run could be made with {law}: {why}",
            ko: "{law} 해석을 할 수 없었다: {why}",
        },
        Speed { speed: Quantity, times: Quantity, own: Quantity } => {
            en: "The support that moves farthest goes {speed} a second: the whole takes {times} times {own}, in which the stack itself falls or sways, so that inertia hardly counts. A settlement or a spreading that takes years is slower still.",
            ko: "가장 크게 움직이는 지점의 속도는 초당 {speed}이다. 전체 이동에 구조물이 스스로 떨어지거나 흔들리는 시간 {own}의 {times}배가 걸리므로 관성의 영향은 거의 없다. 여러 해에 걸친 침하나 벌어짐은 이보다 더 느리다.",
        },
        Caption => { en: "The movement at which it falls, three ways.", ko: "붕괴 변위의 세 가지 산정." },
        Meaning => {
            en: "Gave way: from then on a stone moved more than 10 times as fast as the supports. Down: a stone had come down; the supports moved on meanwhile.",
            ko: "무너지기 시작: 이때부터 어느 부재가 지점보다 10배 넘게 빨리 움직였다. 떨어짐: 부재 하나가 떨어졌으며 그동안 지점은 계속 움직였다.",
        },
        Way => { en: "by", ko: "방법" },
        GaveWay => { en: "gave way at", ko: "무너지기 시작" },
        Down => { en: "down at", ko: "떨어짐" },
        OverGiven => { en: "of the movement given", ko: "주어진 변위에 대한 배율" },
        Took => { en: "time", ko: "시간" },
        LimitAnalysis => { en: "limit analysis", ko: "한계해석" },
        Figure => { en: "The stone that moves most, while the supports move.", ko: "지점이 움직이는 동안 가장 크게 움직이는 부재." },
        FigureMeaning => {
            en: "It follows the supports until no forces balance the weight, and then moves by itself.",
            ko: "자중과 평형을 이루는 힘이 있는 동안 지점을 따라 움직이다가, 평형을 잃으면 스스로 움직인다.",
        },
    }
}

/// The outcome; in full with all methods side by side.
pub fn supports_text(of: &SupportsSimulation, style: TextStyle) -> String {
    let found = findings(of);
    if !style.is_full {
        return findings_text(found.iter().filter(|of| of.is_key), style);
    }
    let mut document = Document::default();
    details(&mut document, of);
    findings_text(&found, style) + &document_text(&document, style)
}

pub(crate) fn sections(of: &SupportsSimulation) -> Document<'_> {
    let mut document = Document::default();
    details(&mut document, of);
    document
}

pub(crate) fn findings(of: &SupportsSimulation) -> Vec<Finding> {
    let endings = of.runs.iter().map(|run| {
        let ending = ending(of, run);
        match run.law {
            ContactLaw::Springs(_) => Sentence::from(InTime::Springs { ending }),
            ContactLaw::Rigid(_) => InTime::Rigid { ending }.into(),
        }
    });
    let both = endings.reduce(|first, next| InTime::Both { first, next }.into());
    let said = InTime::Moves {
        movements: movements(&of.stack),
        ending: both.unwrap_or_else(|| InTime::NoRun.into()),
    };
    let mut all = vec![Finding::key(tone(of), said)];
    let (factor, length) = factor_and_length(of, of.followed.last.factor);
    let limit = match of.followed_falls() {
        true => InTime::Limit { factor, length },
        false => InTime::LimitStands { factor, length },
    };
    let apart = of.runs.iter().find_map(|run| apart(of, run));
    all.push(Finding::key(Tone::Plain, limit));
    all.extend(apart.map(|apart| Finding::key(Tone::Warn, apart)));
    let histories: Vec<&StackHistory> = of.runs.iter().map(|run| &run.moved.history).collect();
    all.extend(crushing::findings(&of.stack, &histories));
    let made = of
        .runs
        .iter()
        .find_map(|run| made_in(&of.stack, &run.moved.history));
    all.extend(made.map(|made| Finding::key(Tone::Warn, made)));
    all.extend(of.left_out.iter().map(|refused| {
        let (law, why) = (law_words(&refused.law), refused.why.clone());
        Finding::key(Tone::Warn, InTime::LeftOut { law, why })
    }));
    all.extend(of.runs.first().map(|run| Finding::new(Tone::Plain, speed(run))));
    all
}

/// The difference between a run and limit analysis, if there is one.
fn apart(of: &SupportsSimulation, run: &SupportsRun) -> Option<InTime> {
    let at = match run.falls_at() {
        Some(factor) => factor,
        // it stood beyond the limit of the limit analysis
        None if run.is_whole() => of.factor_most,
        None => return None,
    };
    let limit = of.followed_falls().then_some(of.followed.last.factor);
    let share = match limit {
        Some(limit) => (at / limit - 1.0).abs(),
        None => run.falls_at().map(|at| (1.0 - at / of.factor_most).abs())?,
    };
    (share > APART).then(|| InTime::Apart {
        share: Quantity::percent(share, 1),
        law: law_words(&run.law),
    })
}

fn law_words(law: &ContactLaw) -> Sentence {
    match law {
        ContactLaw::Springs(_) => InTime::SpringsLaw.into(),
        ContactLaw::Rigid(_) => InTime::RigidLaw.into(),
    }
}

fn tone(of: &SupportsSimulation) -> Tone {
    match of.falls_at() {
        Some(factor) if factor < 1.0 => Tone::Bad,
        _ if !of.is_whole() || of.runs.is_empty() => Tone::Unknown,
        Some(factor) if factor < MovedSupports::MARGINAL_BELOW => Tone::Warn,
        _ if of.runs.iter().any(|run| run.on_the_brink().is_some()) => Tone::Warn,
        _ => Tone::Good,
    }
}

/// How a run ended, in a sentence that begins with a small letter.
fn ending(of: &SupportsSimulation, run: &SupportsRun) -> Sentence {
    let history = &run.moved.history;
    let (factor, length) = factor_and_length(of, run.falls_at().unwrap_or_else(|| run.moved.reached()));
    let at = seconds(history.time_s.last().copied().unwrap_or_default());
    let name = |block: usize| {
        let block = of.stack.blocks().get(block);
        block.map_or_else(String::new, |block| block.name.clone())
    };
    let ending = match history.outcome {
        Outcome::Fell { block, .. } => {
            let block = name(block);
            InTime::Fell {
                factor,
                length,
                block,
            }
        }
        Outcome::Diverged { .. } | Outcome::NotConverged { .. } => InTime::Lost { at },
        Outcome::Slid { block, .. } if run.is_whole() => {
            let block = name(block);
            InTime::OnTheBrink {
                factor,
                length,
                block,
            }
        }
        _ if run.is_whole() => InTime::StoodTo { factor, length },
        _ => InTime::Open { factor, length, at },
    };
    ending.into()
}

/// A factor on the movement, and the displacement of the support that moves farthest.
fn factor_and_length(of: &SupportsSimulation, factor: f64) -> (Quantity, Quantity) {
    (Quantity::ratio(factor, 4), millimetres(of.length_m(factor)))
}

fn speed(run: &SupportsRun) -> InTime {
    let slow = &run.moved.slow;
    let times = slow.ground.factor_most / slow.ground.factor_per_s / slow.own_time_s;
    InTime::Speed {
        speed: Quantity::new(slow.ground.speed_m_s(), milli("m"), Digits::Significant(3)),
        times: Quantity::ratio(times, 3),
        own: seconds(slow.own_time_s),
    }
}

fn details<'a>(document: &mut Document<'a>, of: &'a SupportsSimulation) {
    document.heading(InTime::Head);
    document.put(Block::Table(ways(of)));
    let caption = vec![InTime::Figure.into(), InTime::FigureMeaning.into()];
    let drawn = Figure::drawn(caption, move |language| supports_in_time(of, language));
    document.charted(drawn.with_series(move || supports_series(of)));
    document.note(InTime::Meaning);
}

/// The movements by every method, side by side.
fn ways(of: &SupportsSimulation) -> Table {
    let mm = |factor: f64| Cell::number(millimetres(of.length_m(factor)));
    let ratio = |factor: f64| Cell::number(Quantity::ratio(factor, 4));
    let or_none = |cell: Option<Cell>| cell.unwrap_or(Cell::Number(None));
    let mut rows: Vec<Vec<Cell>> = of
        .runs
        .iter()
        .map(|run| {
            let moved = &run.moved;
            vec![
                Cell::words(law_words(&run.law)),
                or_none(run.falls_at().map(mm)),
                or_none(run.falls_at().map(ratio)),
                or_none(moved.fell_at().map(mm)),
                Cell::number(seconds(moved.history.time_s.last().copied().unwrap_or_default())),
            ]
        })
        .collect();
    let limit = of.followed_falls().then_some(of.followed.last.factor);
    rows.push(vec![
        Cell::words(InTime::LimitAnalysis),
        or_none(limit.map(mm)),
        or_none(limit.map(ratio)),
        Cell::Number(None),
        Cell::Number(None),
    ]);
    Table {
        caption: vec![InTime::Caption.into()],
        columns: vec![
            Column::words(InTime::Way),
            Column::numbers(InTime::GaveWay, milli("m")),
            Column::numbers(InTime::OverGiven, Unit::ratio()),
            Column::numbers(InTime::Down, milli("m")),
            Column::numbers(InTime::Took, Unit::si("s")),
        ],
        rows,
    }
}
