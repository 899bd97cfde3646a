//! Trends of the capacity with each input, with all others equal.

use super::words::{Words, both, count, fixed, of_all, scans};
use crate::document::{Block, Cell, Column, Document, Finding, Table, Tone};
use dolmen::assess::{Direction, Reached, reached_quantile};
use dolmen_words::{Quantity, Sentence, Unit, messages};
use dolmen_work::study::{SCANS_OF_TAILS, StudyAnswer, TrendAnswer, TrendVerdict, input_words};

messages! {
    /// Trends.
    pub(crate) enum Trends in "study.trends" {
        Caption => { en: "Trends of the capacity, all else equal.", ko: "다른 조건이 같을 때 내진성능의 경향." },
        Meaning => {
            en: "Kendall's rank correlation τ of pairs under the same motion, direction and sample, and what chance alone would give; only motions count as independent, not the directions and samples of one.",
            ko: "입력지진·방향·표본이 같은 쌍의 켄달 순위상관계수 τ와 우연만으로 나타날 수 있는 크기. 입력지진만 서로 독립으로 보며, 한 입력지진의 방향과 표본은 독립으로 보지 않는다.",
        },
        EachMeaning { scans: usize } => {
            en: "Same way: in how many motions, directions and samples τ has this sign, and τ from the least to the largest of them (from {scans} on the 5 and 95 % of them).",
            ko: "같은 방향: 입력지진·방향·표본별 τ의 부호가 같은 개수와 그 최소–최대({scans}개 이상이면 5–95 %).",
        },
        Expected => { en: "expected", ko: "예상" },
        Verdict => { en: "verdict", ko: "판정" },
        Tau => { en: "τ", ko: "τ" },
        Chance => { en: "± by chance", ko: "± 우연" },
        Pairs => { en: "pairs", ko: "쌍" },
        Motions => { en: "motions", ko: "입력지진" },
        SameWay => { en: "same way", ko: "같은 방향" },
        Range => { en: "τ of each", ko: "개별 τ" },
        CapacityRises => { en: "the capacity rises with it", ko: "값이 클수록 내진성능 증가" },
        CapacityFalls => { en: "the capacity falls with it", ko: "값이 클수록 내진성능 감소" },
        Nothing => { en: "nothing", ko: "없음" },
        Rises => { en: "rises", ko: "증가" },
        Falls => { en: "falls", ko: "감소" },
        NoTrend => { en: "no trend seen", ko: "경향 없음" },
        CannotAct { input: Sentence } => {
            en: "{input} does not act in these runs: no value of it changes anything in them, and they say nothing about it.",
            ko: "{input}은(는) 이 해석에 작용하지 않는다. 값을 바꾸어도 결과가 같으므로 그 영향은 알 수 없다.",
        },
        NoneReached { input: Sentence } => {
            en: "How the capacity depends on {input} cannot be said: none of the scans reached the last state. `fragility.csv` has the milder states of each combination.",
            ko: "{input}에 따른 내진성능은 알 수 없다. 마지막 상태에 이른 증분해석이 없다. 조합별 더 가벼운 상태는 `fragility.csv`에 있다.",
        },
        DoesNotAct => { en: "does not act", ko: "작용하지 않음" },
        Holds => { en: "holds", ko: "성립" },
        NotSeen => { en: "not seen", ko: "확인 안 됨" },
        Contradicted => { en: "contradicted", ko: "반대" },
        OfPart { used: usize, all: Sentence } => {
            en: "Trends are of {used} of {all}.",
            ko: "경향은 {all} 중 {used}건으로 구하였다.",
        },
        Found { input: Sentence, expected: Sentence, verdict: Sentence, tau: Quantity, chance: Quantity, pairs: usize, motions: usize } => {
            en: "{input}: {expected}: {verdict} (τ = {tau}, ± {chance} by chance, pairs: {pairs}, motions: {motions}).",
            ko: "{input}: {expected}: {verdict}(τ = {tau}, 우연 ± {chance}, 쌍 {pairs}개, 입력지진 {motions}개).",
        },
        FoundAlone { input: Sentence, verdict: Sentence, tau: Quantity, chance: Quantity, pairs: usize, motions: usize } => {
            en: "Capacity against {input}: {verdict} (τ = {tau}, ± {chance} by chance, pairs: {pairs}, motions: {motions}).",
            ko: "{input}에 따른 내진성능: {verdict}(τ = {tau}, 우연 ± {chance}, 쌍 {pairs}개, 입력지진 {motions}개).",
        },
    }
}

/// Trends with pairs to compare; they cannot fail for runs as read.
fn known(answer: &StudyAnswer) -> Vec<TrendAnswer> {
    let mut found = answer.trends().unwrap_or_default();
    found.retain(|trend| trend.of_pairs.pairs > 0);
    found
}

/// The table; nothing without a trend.
pub(super) fn section(document: &mut Document<'_>, answer: &StudyAnswer) {
    let found = known(answer);
    if found.is_empty() {
        return;
    }
    let with_each = found.iter().any(|trend| trend.of_each.len() > 1);
    let mut columns = vec![
        Column::words(Words::Input),
        Column::words(Trends::Expected),
        Column::words(Trends::Verdict),
    ];
    let mut heads = vec![Trends::Tau, Trends::Chance, Trends::Pairs, Trends::Motions];
    let mut caption = vec![Trends::Caption.into(), Trends::Meaning.into()];
    if with_each {
        heads.extend([Trends::SameWay, Trends::Range]);
        let scans = SCANS_OF_TAILS;
        caption.push(Trends::EachMeaning { scans }.into());
    }
    columns.extend(heads.into_iter().map(|head| Column::numbers(head, Unit::ratio())));
    let row = |trend: &TrendAnswer| {
        let tau = &trend.of_pairs;
        let mut row = vec![
            Cell::words(input(answer, trend)),
            Cell::words(expected(trend).unwrap_or(Trends::Nothing.into())),
            match verdict(trend) {
                contradicted @ Trends::Contradicted => Cell::BadWords(contradicted.into()),
                other => Cell::words(other),
            },
            Cell::number(fixed(tau.tau, 2)),
            Cell::number(fixed(tau.tau_by_chance, 2)),
            count(tau.pairs),
            count(tau.units),
        ];
        if with_each {
            row.extend(each(trend));
        }
        row
    };
    document.put(Block::Table(Table {
        rows: found.iter().map(row).collect(),
        caption,
        columns,
    }));
    let (left_out, all) = (answer.left_out(), answer.jobs());
    if left_out > 0 {
        let used = all - left_out;
        document.note(Trends::OfPart {
            used,
            all: scans(all),
        });
    }
}

/// The state of the capacities whose trends are sought: the fall.
const LAST_STATE: usize = 3;

/// One sentence per trend.
pub(super) fn findings(answer: &StudyAnswer) -> Vec<Finding> {
    let last = answer.fragilities().iter().flat_map(|one| &one.states);
    let mut last = last.filter(|own| own.state == LAST_STATE).peekable();
    let is_none = last.peek().is_some() && last.all(|own| own.reached() == 0);
    let one = |trend: &TrendAnswer| {
        if is_none && trend.acts {
            let input = input(answer, trend);
            return Finding::key(Tone::Unknown, Trends::NoneReached { input });
        }
        if !trend.acts {
            let input = input(answer, trend);
            return Finding::key(Tone::Warn, Trends::CannotAct { input });
        }
        let tau = &trend.of_pairs;
        let input = input(answer, trend);
        let (pairs, motions) = (tau.pairs, tau.units);
        let (size, chance) = (fixed(tau.tau, 2), fixed(tau.tau_by_chance, 2));
        let said = verdict(trend);
        let tone = match said {
            Trends::Contradicted => Tone::Warn,
            _ => Tone::Plain,
        };
        let verdict = said.into();
        let said = match expected(trend) {
            Some(expected) => Trends::Found {
                input,
                expected,
                verdict,
                tau: size,
                chance,
                pairs,
                motions,
            },
            None => Trends::FoundAlone {
                input,
                verdict,
                tau: size,
                chance,
                pairs,
                motions,
            },
        };
        Finding::key(tone, said)
    };
    known(answer).iter().map(one).collect()
}

fn input(answer: &StudyAnswer, trend: &TrendAnswer) -> Sentence {
    both(|language| input_words(&answer.inputs[trend.input].path, language))
}

/// The expectation, in the words of the file if it has any.
fn expected(trend: &TrendAnswer) -> Option<Sentence> {
    let (expected, _) = trend.expected.as_ref()?;
    Some(match (&expected.words, expected.direction) {
        (Some(names), _) => both(|language| language.pick(names.english(), names.korean()).to_owned()),
        (None, Direction::Rising) => Trends::CapacityRises.into(),
        (None, Direction::Falling) => Trends::CapacityFalls.into(),
    })
}

fn verdict(trend: &TrendAnswer) -> Trends {
    match (&trend.expected, trend.of_pairs.direction()) {
        _ if !trend.acts => Trends::DoesNotAct,
        (Some((_, TrendVerdict::Holds)), _) => Trends::Holds,
        (Some((_, TrendVerdict::NotSeen)), _) => Trends::NotSeen,
        (Some((_, TrendVerdict::Contradicted)), _) => Trends::Contradicted,
        (None, Some(Direction::Rising)) => Trends::Rises,
        (None, Some(Direction::Falling)) => Trends::Falls,
        (None, None) => Trends::NoTrend,
    }
}

/// Number of motions, directions and samples with the same sign, and their range.
fn each(trend: &TrendAnswer) -> [Cell; 2] {
    if trend.of_each.len() < 2 {
        return [Cell::Number(None), Cell::Number(None)];
    }
    let way = match (&trend.expected, trend.of_pairs.tau > 0.0) {
        (Some((expected, _)), _) => expected.direction,
        (None, true) => Direction::Rising,
        (None, false) => Direction::Falling,
    };
    let values: Vec<Reached> = trend.of_each.iter().copied().map(Reached::At).collect();
    let ends = match values.len() < SCANS_OF_TAILS {
        true => [0.0, 1.0],
        false => [0.05, 0.95],
    };
    let [lower, upper] = ends.map(|p| {
        let end = reached_quantile(&values, p).map_or(f64::NAN, Reached::value);
        fixed(end, 2)
    });
    [
        of_all(trend.same_way(way), trend.of_each.len()),
        Cell::words(Words::Interval { lower, upper }),
    ]
}
