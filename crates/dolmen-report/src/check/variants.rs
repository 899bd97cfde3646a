//! The project as given compared with its variants, before and after a repair.

use crate::document::{Block, Cell, Column, Document, Figure, Finding, Table, Tone, table_series};
use crate::figures::{VariantDot, variants_compared};
use crate::html::words::verdict_word;
use dolmen::stability::Verdict;
use dolmen::structure::lowest_frequency_hz;
use dolmen_words::message::Both;
use dolmen_words::{Digits, Language, Quantity, Unit, messages};
use dolmen_work::answer::CheckAnswer;
use dolmen_work::judgement::{Earthquake, VersionJudgement, WindFinding, judge_check};
use dolmen_work::state::{Check, State, VariantAnswer};

/// Relative difference below which values of λ are equal.
const SAME_SHARE: f64 = 1e-6;

messages! {
    /// Variants compared with the structure as it is.
    pub(crate) enum Variants in "check.variants" {
        Same { variant: Both, factor: Quantity, verdict: Both } => {
            en: "Variant “{variant}” leaves the load factor at {factor}: {verdict}.",
            ko: "대안 ‘{variant}’에서 하중배율은 {factor}(으)로 같다: {verdict}.",
        },
        SameIn { variant: Both, direction: String, factor: Quantity, verdict: Both } => {
            en: "Variant “{variant}” ({direction}) leaves the load factor at {factor}: {verdict}.",
            ko: "대안 ‘{variant}’({direction})에서 하중배율은 {factor}(으)로 같다: {verdict}.",
        },
        SameEarthquake { variant: Both, factor: Quantity, verdict: Both, before: Quantity, after: Quantity } => {
            en: "Variant “{variant}”: under the earthquake of the site capacity/demand goes from {before} to {after}; the load factor stays {factor}: {verdict}.",
            ko: "대안 ‘{variant}’: 부지의 지진에 대한 저항/요구가 {before}에서 {after}(으)로 바뀐다. 하중배율은 {factor}(으)로 같다: {verdict}.",
        },
        SameWind { variant: Both, factor: Quantity, verdict: Both, before: Quantity, after: Quantity } => {
            en: "Variant “{variant}”: in the wind limit/response goes from {before} to {after}; the load factor stays {factor}: {verdict}.",
            ko: "대안 ‘{variant}’: 바람에 대한 허용값/응답이 {before}에서 {after}(으)로 바뀐다. 하중배율은 {factor}(으)로 같다: {verdict}.",
        },
        Changes { variant: Both, from: Quantity, to: Quantity, verdict: Both } => {
            en: "Variant “{variant}” changes the load factor from {from} to {to}: {verdict}.",
            ko: "대안 ‘{variant}’에서 하중배율이 {from}에서 {to}(으)로 바뀐다: {verdict}.",
        },
        ChangesIn { variant: Both, direction: String, from: Quantity, to: Quantity, verdict: Both } => {
            en: "Variant “{variant}” ({direction}) changes the load factor from {from} to {to}: {verdict}.",
            ko: "대안 ‘{variant}’({direction})에서 하중배율이 {from}에서 {to}(으)로 바뀐다: {verdict}.",
        },
        Loaded { variant: Both, to: Quantity, from: Quantity, verdict: Both } => {
            en: "Variant “{variant}” bears {to} times its wind and static loads, the structure as it is {from} times: {verdict}.",
            ko: "대안 ‘{variant}’: 풍하중·정하중의 {to}배에서 한계에 이른다(현재 {from}배): {verdict}.",
        },
        LoadedAlone { variant: Both, to: Quantity, verdict: Both } => {
            en: "Variant “{variant}” bears {to} times its wind and static loads: {verdict}.",
            ko: "대안 ‘{variant}’: 풍하중·정하중의 {to}배에서 한계에 이른다: {verdict}.",
        },
        Borne => { en: "loads borne ×", ko: "하중 저항 배수" },
        Head => { en: "Variants compared", ko: "대안 비교" },
        Drawn => { en: "Load factor and margins of each variant.", ko: "대안별 하중배율과 여유도." },
        DrawnMeaning => { en: "Left of 1 it falls.", ko: "1의 왼쪽은 전도이다." },
        Caption => { en: "Variants.", ko: "대안별 결과." },
        CaptionMeaning => { en: "The same check on each.", ko: "모두 같은 방법으로 검토하였다." },
        Variant => { en: "Variant", ko: "대안" },
        VerdictHead => { en: "verdict", ko: "판정" },
        LoadFactor => { en: "λ", ko: "λ" },
        LeastMargin => { en: "least margin", ko: "최소 여유도" },
        Lowest => { en: "lowest frequency", ko: "최저 고유진동수" },
        OverDemand => { en: "earthquake: capacity/demand", ko: "지진: 저항/요구" },
        Worse { variant: Both, from: Quantity, to: Quantity, before: Quantity, after: Quantity } => {
            en: "Variant “{variant}” is better under weight (λ {from} → {to}), worse under the earthquake of the site (capacity over demand {before} → {after}).",
            ko: "대안 ‘{variant}’은(는) 자중에서는 유리하나(λ {from} → {to}) 부지의 지진에서는 불리하다(저항/요구 {before} → {after}).",
        },
        FallsShare => { en: "P(falls by its weight)", ko: "자중 전도 확률" },
        OverloadedShare => { en: "P(loads at a limit)", ko: "하중 한계 도달 확률" },
        Named(name: Both) => { en: "{name}", ko: "{name}" },
        Unknown => { en: "unknown", ko: "미상" },
        Falls => { en: "falls", ko: "전도" },
    }
}

/// One row: a variant, or one direction of it.
struct Row {
    name: Both,
    direction: Option<String>,
    load_factor: Option<f64>,
    /// Factor on wind and static loads at which a joint reaches its limit.
    borne: Option<f64>,
    /// The same with wind and static loads.
    verdict: Verdict,
    /// Verdict under its weight alone.
    own_verdict: Verdict,
    margins: Vec<Option<f64>>,
    frequency_hz: Option<f64>,
    /// Share of samples that fall under their own weight.
    falls: Option<f64>,
    /// Share of samples that wind and static loads bring to a limit.
    overloaded: Option<f64>,
    /// The demand of the site on the version, as a word and as capacity over demand; `None` without a demand.
    earthquake: Option<(Earthquake, Option<f64>)>,
}

/// The name of a variant: its title, otherwise that of its table.
pub(crate) fn title(variant: &VariantAnswer) -> Both {
    match &variant.title {
        Some(names) => Both::of(|language| language.pick(names.english(), names.korean())),
        None => Both::of(|_| variant.name.clone()),
    }
}

/// The effect of each variant on the load factor.
pub(super) fn findings(answer: &CheckAnswer) -> Vec<Finding> {
    let Some(state) = &answer.state else {
        return Vec::new();
    };
    let basis = rows(state, &Both::of(|_| ""));
    let judged = judge_check(answer);
    let mut all = Vec::new();
    for (at, variant) in answer.variants.iter().enumerate() {
        let after = rows(&variant.state, &title(variant));
        let versions = judged.versions.first().zip(judged.versions.get(at + 1));
        let besides = versions.map_or_else(Vec::new, |(before, after)| besides(before, after));
        if let ([row], false) = (after.as_slice(), besides.is_empty())
            && let Some(said) = same_but(row, &basis, besides)
        {
            all.extend(said);
            continue;
        }
        all.extend(
            after
                .into_iter()
                .zip(&basis)
                .flat_map(|(new, old)| [loaded(&new, old), changed(new, old)])
                .flatten(),
        );
    }
    all.extend(worse_in_earthquakes(answer));
    all
}

/// The demand of the site on a version, with the smallest capacity over demand of all parts.
fn asked(version: &VersionJudgement) -> Option<(Earthquake, Option<f64>)> {
    let found = &version.earthquake;
    let ratios = found.iter().filter_map(|finding| finding.ratio);
    (!found.is_empty()).then(|| (version.earthquake_word(), ratios.reduce(f64::min)))
}

/// A response that a variant changes.
enum Beside {
    Earthquake(f64, f64),
    Wind(f64, f64),
}

/// Capacity over demand of the earthquake and limit over response in the wind, before and after, where a variant changes them.
fn besides(before: &VersionJudgement, after: &VersionJudgement) -> Vec<Beside> {
    let changes = |(old, new): &(f64, f64)| (new / old - 1.0).abs() >= SAME_SHARE;
    let asked = |of: &VersionJudgement| asked(of).and_then(|(_, ratio)| ratio);
    let earthquake = asked(before).zip(asked(after)).filter(changes);
    let in_wind = |of: &VersionJudgement| WindFinding::deciding(&of.wind).and_then(|of| of.ratio);
    let wind = in_wind(before).zip(in_wind(after)).filter(changes);
    let earthquake = earthquake.map(|(old, new)| Beside::Earthquake(old, new));
    earthquake
        .into_iter()
        .chain(wind.map(|(old, new)| Beside::Wind(old, new)))
        .collect()
}

/// Changes due to a variant that does not change the load factor, such as a damper.
fn same_but(row: &Row, basis: &[Row], besides: Vec<Beside>) -> Option<Vec<Finding>> {
    let old = basis.first()?.load_factor?;
    let is_same = (row.load_factor? / old - 1.0).abs() < SAME_SHARE && row.borne.is_none();
    let each = besides.into_iter().map(|of| {
        let (variant, factor) = (row.name.clone(), Quantity::beside_one(old, 4));
        let verdict = Both::of(|language| verdict_word(row.own_verdict, language));
        let number = |number: f64| Quantity::beside_one(number, 3);
        let (said, is_worse) = match of {
            Beside::Earthquake(from, to) => {
                let (before, after) = (number(from), number(to));
                let said = Variants::SameEarthquake {
                    variant,
                    factor,
                    verdict,
                    before,
                    after,
                };
                (said, to < from)
            }
            Beside::Wind(from, to) => {
                let (before, after) = (number(from), number(to));
                (
                    Variants::SameWind {
                        variant,
                        factor,
                        verdict,
                        before,
                        after,
                    },
                    to < from,
                )
            }
        };
        Finding::key(if is_worse { Tone::Warn } else { Tone::Plain }, said)
    });
    is_same.then(|| each.collect())
}

/// Variants that improve the stability under weight but not the response to the earthquake of the site.
fn worse_in_earthquakes(answer: &CheckAnswer) -> Vec<Finding> {
    let judged = judge_check(answer);
    let ratio = |version: usize| judged.versions.get(version).and_then(asked)?.1;
    let factor = |state: &State| state.load_factor().filter(|factor| factor.is_finite());
    let (Some(before), Some(state)) = (ratio(0), &answer.state) else {
        return Vec::new();
    };
    let each = answer.variants.iter().enumerate().filter_map(|(at, variant)| {
        let (from, to) = (factor(state)?, factor(&variant.state)?);
        let after = ratio(at + 1)?;
        let of = |number: f64| Quantity::beside_one(number, 3);
        let said = Variants::Worse {
            variant: title(variant),
            from: of(from),
            to: of(to),
            before: of(before),
            after: of(after),
        };
        let is_told = to > from * (1.0 + SAME_SHARE) && after < before * (1.0 - SAME_SHARE);
        is_told.then(|| Finding::key(Tone::Warn, said))
    });
    each.collect()
}

/// The effect on wind and static loads.
fn loaded(after: &Row, before: &Row) -> Option<Finding> {
    let new = after.borne?;
    let factor = |factor: f64| Quantity::beside_one(factor, 3);
    let verdict = Both::of(|language| verdict_word(after.verdict, language));
    let variant = after.name.clone();
    let said = match before.borne {
        Some(old) => Variants::Loaded {
            variant,
            to: factor(new),
            from: factor(old),
            verdict,
        },
        None => Variants::LoadedAlone {
            variant,
            to: factor(new),
            verdict,
        },
    };
    let tone = match (after.verdict, before.borne.is_some_and(|old| new < old)) {
        (Verdict::Unstable, _) => Tone::Bad,
        (_, true) => Tone::Warn,
        _ => Tone::Plain,
    };
    Some(Finding::key(tone, said))
}

fn changed(after: Row, before: &Row) -> Option<Finding> {
    let (new, old) = (after.load_factor?, before.load_factor?);
    let [from, to] = [old, new].map(|factor| Quantity::beside_one(factor, 4));
    let verdict = Both::of(|language| verdict_word(after.own_verdict, language));
    let variant = after.name;
    let tone = match new < old {
        true => Tone::Warn,
        false => Tone::Plain,
    };
    // a separate finding gives the wind factor, so this word is about weight
    let is_same = (new / old - 1.0).abs() < SAME_SHARE;
    if is_same && after.borne.is_some() {
        return None; // reported with its loads
    }
    let said = match (is_same, after.direction) {
        (true, None) => Variants::Same {
            variant,
            factor: from,
            verdict,
        },
        (true, Some(direction)) => Variants::SameIn {
            variant,
            direction,
            factor: from,
            verdict,
        },
        (false, None) => Variants::Changes {
            variant,
            from,
            to,
            verdict,
        },
        (false, Some(direction)) => Variants::ChangesIn {
            variant,
            direction,
            from,
            to,
            verdict,
        },
    };
    Some(Finding::key(tone, said))
}

/// All versions side by side; stacks have their own comparison.
pub(crate) fn section(answer: &CheckAnswer) -> Document<'_> {
    let mut document = Document::default();
    let Some(state) = answer.state.as_ref().filter(|_| !answer.variants.is_empty()) else {
        return document;
    };
    if matches!(state.check, Check::Stack(_)) {
        return document;
    }
    document.heading(Variants::Head);
    let given = Both::of(|language| language.pick("as given", "현재"));
    let versions = answer.variants.iter();
    let versions = versions.map(|variant| (title(variant), &variant.state));
    let judged = judge_check(answer);
    let mut basis = rows(state, &given);
    let asked: Vec<_> = judged.versions.iter().map(asked).collect();
    let put = |rows: &mut Vec<Row>, version: usize| {
        let own = asked.get(version).copied().flatten();
        rows.iter_mut().for_each(|row| row.earthquake = own);
    };
    put(&mut basis, 0);
    // a version contradicted by a survey is not stable
    if judged.headline().is_some_and(|of| of.evidence.is_contradicted()) {
        let doubted = basis.iter_mut().filter(|row| row.verdict != Verdict::Unstable);
        doubted.for_each(|row| row.verdict = Verdict::Unknown);
    }
    let of_versions = versions.enumerate().flat_map(|(at, (name, state))| {
        let mut own = rows(state, &name);
        put(&mut own, at + 1);
        own
    });
    let all: Vec<Row> = basis.into_iter().chain(of_versions).collect();
    let table = table(&all);
    let caption = vec![Variants::Drawn.into(), Variants::DrawnMeaning.into()];
    let drawn = Figure::drawn(caption, move |language| {
        let dots: Vec<VariantDot> = all.iter().map(|row| dot(row, language)).collect();
        variants_compared(&dots, language)
    });
    let shown = table.clone();
    document.charted(drawn.with_series(move || table_series(&shown)));
    document.put(Block::Table(table));
    document
}

fn dot(row: &Row, language: Language) -> VariantDot {
    VariantDot {
        name: row.named(language),
        load_factor: row.load_factor,
        verdict: row.verdict,
        margins: row.margins.clone(),
    }
}

fn table(all: &[Row]) -> Table {
    let with_falls = all.iter().any(|row| row.falls.is_some());
    let with_loads = all.iter().any(|row| row.borne.is_some());
    let with_earthquake = all.iter().any(|row| row.earthquake.is_some());
    let with_overloaded = all.iter().any(|row| row.overloaded.is_some());
    let share = |share: f64| Quantity::new(share, Unit::percent(), Digits::Significant(3));
    let row = |row: &Row| {
        let unknown = || Cell::words(Variants::Unknown);
        let margin = match row.least_margin() {
            None => unknown(),
            Some(None) => Cell::BadWords(Variants::Falls.into()),
            Some(Some(margin)) => Cell::number(Quantity::beside_one(margin, 4)),
        };
        let frequency = row.frequency_hz.map(|f| Quantity::ratio(f, 4));
        let mut cells = vec![
            Cell::words(Variants::Named(Both::of(|language| row.named(language)))),
            Cell::words(Variants::Named(Both::of(|language| {
                verdict_word(row.verdict, language)
            }))),
            row.load_factor
                .map_or_else(unknown, |factor| Cell::number(Quantity::beside_one(factor, 4))),
            margin,
            frequency.map_or_else(unknown, Cell::number),
        ];
        if with_loads {
            let factor = row.borne.map(|factor| Quantity::beside_one(factor, 4));
            cells.push(match row.borne.is_some_and(|factor| factor <= 1.0) {
                true => factor.map_or(Cell::Number(None), Cell::Bad),
                false => Cell::Number(factor),
            });
        }
        if with_earthquake {
            let number = |ratio: f64| Quantity::beside_one(ratio, 3);
            cells.push(match row.earthquake {
                Some((Earthquake::BelowDemand, Some(ratio))) => Cell::Bad(number(ratio)),
                Some((_, Some(ratio))) => Cell::number(number(ratio)),
                Some((Earthquake::NotAsked, None)) | None => Cell::Number(None),
                Some((word, None)) => Cell::words(Variants::Named(Both::of(|language| word.word(language)))),
            });
        }
        if with_falls {
            cells.push(Cell::Number(row.falls.map(share)));
        }
        if with_overloaded {
            cells.push(Cell::Number(row.overloaded.map(share)));
        }
        cells
    };
    let mut columns = vec![
        Column::words(Variants::Variant),
        Column::words(Variants::VerdictHead),
        Column::numbers(Variants::LoadFactor, Unit::ratio()),
        Column::numbers(Variants::LeastMargin, Unit::ratio()),
        Column::numbers(Variants::Lowest, Unit::si("Hz")),
    ];
    if with_loads {
        columns.push(Column::numbers(Variants::Borne, Unit::ratio()));
    }
    if with_earthquake {
        columns.push(Column::numbers(Variants::OverDemand, Unit::ratio()));
    }
    if with_falls {
        columns.push(Column::numbers(Variants::FallsShare, Unit::percent()));
    }
    if with_overloaded {
        columns.push(Column::numbers(Variants::OverloadedShare, Unit::percent()));
    }
    Table {
        caption: vec![Variants::Caption.into(), Variants::CaptionMeaning.into()],
        columns,
        rows: all.iter().map(row).collect(),
    }
}

impl Row {
    fn named(&self, language: Language) -> String {
        let name = language.pick(&self.name.english, &self.name.korean);
        match &self.direction {
            Some(direction) => format!("{name} · {direction}"),
            None => name.clone(),
        }
    }

    /// `None` if no margin is known, `Some(None)` if a part falls for any stiffness.
    fn least_margin(&self) -> Option<Option<f64>> {
        match self.margins.is_empty() {
            true => None,
            false if self.margins.iter().any(Option::is_none) => Some(None),
            false => Some(self.margins.iter().flatten().copied().min_by(f64::total_cmp)),
        }
    }
}

fn rows(state: &State, name: &Both) -> Vec<Row> {
    let falls = state.sampled.as_ref().map(|sampled| sampled.unstable.estimate);
    let sampled = state.sampled.as_ref();
    let overloaded = sampled.and_then(|sampled| sampled.under_loads.as_ref().map(|of| of.estimate));
    match &state.check {
        Check::Chain(check) => {
            let across = check.across.as_ref();
            let stabilities = [
                check.stability.as_ref(),
                across.and_then(|of| of.stability.as_ref()),
            ];
            let joints = stabilities.iter().flatten().flat_map(|of| &of.joints);
            let modes = [Some(&check.modes), across.map(|of| &of.modes)];
            let lowest = modes
                .into_iter()
                .flatten()
                .filter_map(|of| lowest_frequency_hz(of));
            vec![Row {
                name: name.clone(),
                direction: None,
                load_factor: check.load_factor(),
                borne: state.loads.as_ref().and_then(|loads| loads.factor()),
                verdict: match &state.loads {
                    Some(_) => state.verdict(),
                    None => state.stability_verdict(),
                },
                own_verdict: state.stability_verdict(),
                margins: joints.map(|joint| joint.margin).collect(),
                frequency_hz: lowest.min_by(f64::total_cmp),
                falls,
                overloaded,
                earthquake: None,
            }]
        }
        Check::Frame(directions) => directions
            .iter()
            .map(|of| {
                let stability = of.check.stability.as_ref();
                let storeys = stability.iter().flat_map(|of| &of.storeys);
                Row {
                    name: name.clone(),
                    direction: Some(of.direction.clone()),
                    load_factor: stability.map(|of| of.load_factor),
                    borne: None,
                    verdict: stability.map_or(Verdict::Unknown, |of| of.verdict),
                    own_verdict: stability.map_or(Verdict::Unknown, |of| of.verdict),
                    margins: storeys.map(|storey| storey.margin).collect(),
                    frequency_hz: lowest_frequency_hz(&of.check.modes),
                    falls,
                    overloaded,
                    earthquake: None,
                }
            })
            .collect(),
        Check::Building(answer) => {
            let modes = answer.stands.as_ref().map(|standing| &standing.modes.modes);
            let mode = modes.and_then(|modes| modes.first());
            vec![Row {
                name: name.clone(),
                direction: None,
                load_factor: Some(answer.load_factor()),
                borne: None,
                verdict: Verdict::of_load_factor(answer.load_factor()),
                own_verdict: Verdict::of_load_factor(answer.load_factor()),
                margins: answer.falls.iter().map(|fall| Some(fall.load_factor)).collect(),
                frequency_hz: mode.map(|mode| mode.frequency_hz),
                falls,
                overloaded,
                earthquake: None,
            }]
        }
        Check::Stack(_) => Vec::new(),
    }
}
