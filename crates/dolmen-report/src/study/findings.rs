//! What decides in a study: capacity, doubts about it, trends, the worst state.

use super::words::{Words, g, state};
use super::{doubts, hazard, run, scatter, trends, words};
use crate::document::{Finding, Tone};
use dolmen::assess::Reached;
use dolmen_words::{Quantity, Sentence, messages};
use dolmen_work::study::{LevelRow, StudyAnswer};

messages! {
    /// Findings on a study.
    pub(crate) enum Found in "study.findings" {
        NoneFell { scans: Sentence, state: Sentence, largest: Quantity } => {
            en: "None of {scans} reached “{state}”, up to {largest}.",
            ko: "{scans} 모두 {largest}까지 ‘{state}’ 상태에 이르지 않았다.",
        },
        Fell { fell: usize, scans: Sentence, state: Sentence, least: Quantity } => {
            en: "{fell} of {scans} reached “{state}”, the weakest at {least}.",
            ko: "{scans} 중 {fell}건이 ‘{state}’ 상태에 이르렀으며, 그 최소 가속도는 {least}이다.",
        },
        DriftBeyond { beyond: usize, scans: Sentence, limit: Quantity, least: Quantity } => {
            en: "{beyond} of {scans} drifted beyond the allowable {limit} of a storey that the file sets ([limits]), the weakest at {least}.",
            ko: "{scans} 중 {beyond}건이 파일에서 정한 허용 층간변위 {limit}([limits])을(를) 넘었으며, 그 최소 가속도는 {least}이다.",
        },
        DriftWithin { scans: Sentence, limit: Quantity, largest: Quantity } => {
            en: "None of {scans} drifted beyond the allowable {limit} of a storey that the file sets ([limits]), up to {largest}.",
            ko: "{scans} 모두 {largest}까지 파일에서 정한 허용 층간변위 {limit}([limits]) 이내이다.",
        },
        Median { state: Sentence, theta: Quantity, beta: Quantity } => {
            en: "The curve fitted to them (lognormal) has its median for “{state}” at {theta}, scatter of the logarithm β = {beta}.",
            ko: "적합한 대수정규 취약도 곡선에서 ‘{state}’ 상태의 중앙값은 {theta}, 대수 표준편차는 β = {beta}이다.",
        },
        MedianBeyond { state: Sentence, theta: Quantity, beta: Quantity } => {
            en: "Less than half of them reached “{state}”: the median of the curve fitted to them (lognormal), {theta} with a scatter of the logarithm of β = {beta}, is an extrapolation.",
            ko: "‘{state}’ 상태에 이른 것이 절반에 못 미친다. 적합한 대수정규 취약도 곡선의 중앙값 {theta}(대수 표준편차 β = {beta})은 외삽값이다.",
        },
    }
}

/// The findings, doubts first.
pub(crate) fn findings(answer: &StudyAnswer) -> Vec<Finding> {
    let mut all: Vec<Finding> = run::doubts(answer)
        .into_iter()
        .map(|doubt| Finding::key(Tone::Bad, doubt))
        .collect();
    let left_out = answer.left_out_of_runs.iter().map(|said| {
        let said = said.clone();
        Finding::key(Tone::Warn, run::Done::NotInRuns { said })
    });
    if answer.study.scan.is_none() {
        all.extend(left_out);
        return all;
    }
    all.extend(allowed_drift(answer));
    let found = capacity(answer);
    if found.is_none() {
        // nothing is left but why
        let why = run::refused_for(answer).into_iter();
        all.extend(why.map(|said| Finding::key(Tone::Bad, said)));
    }
    all.extend(found);
    all.extend(left_out);
    all.extend(run::copies(answer).map(|said| Finding::key(Tone::Warn, said)));
    all.extend(
        doubts::doubts(answer)
            .into_iter()
            .map(|said| Finding::key(Tone::Warn, said)),
    );
    all.extend(doubts::survived_larger(answer).map(|said| Finding::key(Tone::Plain, said)));
    all.extend(median(answer));
    let crossings = scatter::crossings(answer, answer.fragilities());
    all.extend(crossings.into_iter().map(|said| Finding::new(Tone::Warn, said)));
    all.extend(hazard::extrapolated(answer).map(|said| Finding::key(Tone::Warn, said)));
    all.extend(trends::findings(answer));
    all
}

/// The scans against the allowable drift of the file.
fn allowed_drift(answer: &StudyAnswer) -> Option<Finding> {
    let found = answer.allowed_drift()?;
    let scans = words::scans(found.scans);
    let limit = Quantity::percent(found.limit, 3);
    Some(match found.least_m_s2 {
        Some(least) => {
            let said = Found::DriftBeyond {
                beyond: found.beyond,
                scans,
                limit,
                least: g(answer, least),
            };
            Finding::key(Tone::Warn, said)
        }
        None => {
            let largest = g(answer, found.largest_m_s2);
            let said = Found::DriftWithin {
                scans,
                limit,
                largest,
            };
            Finding::key(Tone::Plain, said)
        }
    })
}

/// How many reached the last state, and the least peak that did it.
fn capacity(answer: &StudyAnswer) -> Option<Finding> {
    let capacities = answer.capacities();
    let usable = capacities.iter().filter(|scan| scan.verdict.is_usable());
    let all = LevelRow {
        input: None,
        text: String::new(),
        value: None,
        scans: usable.cloned().collect(),
    };
    let scans = match all.scans.len() {
        0 => return None,
        1 => Words::OneScan.into(),
        count => Words::Scans { count }.into(),
    };
    let state = state(answer, answer.kind.states().len() - 1);
    let said = match all.least_m_s2()? {
        Reached::Above(largest) => {
            let largest = g(answer, largest);
            Found::NoneFell {
                scans,
                state,
                largest,
            }
        }
        Reached::At(least) => {
            let (fell, least) = (all.fell(), g(answer, least));
            Found::Fell {
                fell,
                scans,
                state,
                least,
            }
        }
    };
    Some(Finding::key(Tone::Plain, said))
}

/// The median of the worst state that has a curve, of a single combination.
fn median(answer: &StudyAnswer) -> Option<Finding> {
    let [one] = answer.fragilities() else {
        return None;
    };
    let mut worst = one.states.iter().rev();
    let (of, fit) = worst.find_map(|own| Some((own.state, own.by_acceleration.as_ref().ok()?)))?;
    let (name, theta) = (state(answer, of), g(answer, fit.curve.theta()));
    let beta = Quantity::ratio(fit.curve.beta(), 2);
    let usable = answer.capacities();
    let usable: Vec<_> = usable.iter().filter(|scan| scan.verdict.is_usable()).collect();
    let reached = usable
        .iter()
        .filter(|scan| scan.first_m_s2.is_some_and(|first| first[of].is_reached()));
    Some(match 2 * reached.count() < usable.len() {
        true => Finding::key(
            Tone::Warn,
            Found::MedianBeyond {
                state: name,
                theta,
                beta,
            },
        ),
        false => Finding::key(
            Tone::Plain,
            Found::Median {
                state: name,
                theta,
                beta,
            },
        ),
    })
}
