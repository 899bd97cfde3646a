//! The project as given compared with its variants, before and after a repair.

use super::variant_responses::{
    Response, Responses, SAME_SHARE, asked, is_beyond, limited_in, red_word, responses,
};
use super::variant_rows::{Row, rows};
use super::variant_stacks;
use crate::document::{Block, Cell, Column, Document, Figure, Finding, Table, Tone, table_series};
use crate::figures::{VariantDot, variants_compared};
use crate::html::words::verdict_word;
use dolmen::assess::Probability;
use dolmen::stability::Verdict;
use dolmen_project::Project;
use dolmen_words::message::Both;
use dolmen_words::{Digits, Language, Quantity, Sentence, Unit, messages};
use dolmen_work::answer::CheckAnswer;
use dolmen_work::judgement::{Earthquake, VersionJudgement, WindFinding, WindWord, judge_check};
use dolmen_work::state::{Check, State, VariantAnswer};

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
            ko: "대안 ‘{variant}’: 풍하중·정하중의 {to}배에서 한계에 이른다(현 상태 {from}배): {verdict}.",
        },
        LoadedAlone { variant: Both, to: Quantity, verdict: Both } => {
            en: "Variant “{variant}” bears {to} times its wind and static loads: {verdict}.",
            ko: "대안 ‘{variant}’: 풍하중·정하중의 {to}배에서 한계에 이른다: {verdict}.",
        },
        Borne => { en: "loads borne ×", ko: "하중 저항 배수" },
        Head => { en: "Variants compared", ko: "대안 비교" },
        Drawn => { en: "Load factor and margins of each variant.", ko: "대안별 하중배율과 여유도." },
        DrawnMeaning => { en: "Left of 1 it falls.", ko: "1의 왼쪽은 불안정이다." },
        Caption => { en: "Variants.", ko: "대안별 결과." },
        CaptionMeaning => { en: "The same check on each.", ko: "모두 같은 방법으로 검토하였다." },
        Variant => { en: "Variant", ko: "대안" },
        VerdictHead => { en: "verdict", ko: "판정" },
        LoadFactor => { en: "λ", ko: "λ" },
        LeastMargin => { en: "least margin", ko: "최소 여유도" },
        Lowest => { en: "lowest frequency", ko: "최저 고유진동수" },
        LimitedIn => { en: "limit of", ko: "허용값 항목" },
        OverResponse => { en: "limit/response", ko: "허용값/응답" },
        OverDemand => { en: "earthquake: capacity/demand", ko: "지진: 저항/요구" },
        Worse { variant: Both, from: Quantity, to: Quantity, before: Quantity, after: Quantity } => {
            en: "Variant “{variant}” is better under weight (λ {from} → {to}), worse under the earthquake of the site (capacity over demand {before} → {after}).",
            ko: "대안 ‘{variant}’은(는) 자중에서는 유리하나(λ {from} → {to}) 부지의 지진에서는 불리하다(저항/요구 {before} → {after}).",
        },
        FallsShare => { en: "P(falls by its weight)", ko: "자중 불안정 확률" },
        FallsMeaning { samples: usize, seed: u64, none: Quantity } => {
            en: "Probabilities are shares of {samples} samples (seed {seed}); 0 means less than {none} (95 %).",
            ko: "확률은 표본 {samples}개에 대한 비율이며(난수 초깃값 {seed}), 0은 {none} 미만이라는 뜻이다(95 %).",
        },
        OverloadedShare => { en: "P(loads at a limit)", ko: "하중 한계 도달 확률" },
        Named(name: Both) => { en: "{name}", ko: "{name}" },
        Unknown => { en: "unknown", ko: "미상" },
        Falls => { en: "falls", ko: "불안정" },
    }
}

/// The name of a variant: its title, otherwise that of its table.
pub(crate) fn title(variant: &VariantAnswer) -> Both {
    match &variant.title {
        Some(names) => Both::of(|language| language.pick(names.english(), names.korean())),
        None => Both::of(|_| variant.name.clone()),
    }
}

/// The project of a variant; the structure as it is where the file has none.
pub(crate) fn version<'a>(project: &'a Project, variant: &VariantAnswer) -> &'a Project {
    let own = project.variants.iter().find(|own| own.name == variant.name);
    own.map_or(project, |own| &own.project)
}

/// The effect of each variant on the load factor and on its responses.
pub(super) fn findings(answer: &CheckAnswer) -> Vec<Finding> {
    let Some(state) = &answer.state else {
        return Vec::new();
    };
    let basis = rows(state, &Both::of(|_| ""));
    let judged = judge_check(answer);
    let worse = worse_in_earthquakes(answer);
    let mut all = Vec::new();
    for (at, variant) in answer.variants.iter().enumerate() {
        let name = title(variant);
        let after = rows(&variant.state, &name);
        let versions = judged.versions.first().zip(judged.versions.get(at + 1));
        let Some((before, own)) = versions else {
            continue;
        };
        // its sentences say themselves that the verdict is of the weight
        let verdict = after.first().map(|row| own_verdict(row, false));
        all.extend(
            verdict.and_then(|verdict| variant_stacks::first_motion(&name, (state, &variant.state), verdict)),
        );
        let is_told = worse.iter().any(|(of, _)| *of == at);
        let mut changed = responses(before, own);
        changed.retain(|of| !(is_told && of.is_earthquake));
        all.extend(of_variant((&name, own), (after, &basis), &changed));
    }
    all.extend(worse.into_iter().map(|(_, finding)| finding));
    all
}

/// The findings on one variant.
fn of_variant(
    (name, own): (&Both, &VersionJudgement),
    (after, basis): (Vec<Row>, &[Row]),
    responses: &[Response],
) -> Vec<Finding> {
    let is_beyond = is_beyond(own);
    if let [row] = after.as_slice()
        && let Some(said) = same_but(row, basis, responses, is_beyond)
    {
        return said;
    }
    let is_same = after.iter().zip(basis).all(|(new, old)| new.is_same(old));
    let mut all: Vec<Finding> = after
        .into_iter()
        .zip(basis)
        .flat_map(|(new, old)| [loaded(&new, old, is_beyond), changed(new, old, is_beyond)])
        .flatten()
        .collect();
    let told = responses.iter().filter(|of| of.is_red || is_same);
    all.extend(told.map(|of| {
        let (variant, said) = (name.clone(), of.said());
        Finding::key(tone(of), Responses::OfVariant { variant, said })
    }));
    all
}

fn tone(of: &Response) -> Tone {
    match (of.is_red, of.is_worse()) {
        (true, _) => Tone::Bad,
        (false, true) => Tone::Warn,
        (false, false) => Tone::Plain,
    }
}

/// A message as words within another.
fn spoken(said: Responses) -> Both {
    let said = Sentence::from(said);
    Both::of(|language| said.text(language))
}

/// The verdict on the weight of a row; not alone where the variant is beyond something else.
fn own_verdict(row: &Row, is_beyond: bool) -> Both {
    let word = Both::of(|language| verdict_word(row.own_verdict, language));
    match is_beyond && row.own_verdict != Verdict::Unstable {
        true => spoken(Responses::UnderWeight { word }),
        false => word,
    }
}

/// Changes due to a variant that does not change the load factor, such as a damper.
fn same_but(row: &Row, basis: &[Row], responses: &[Response], is_beyond: bool) -> Option<Vec<Finding>> {
    let old = basis.first()?;
    let factor = old.load_factor?;
    let changing: Vec<&Response> = responses.iter().filter(|of| of.changes()).collect();
    if changing.is_empty() || row.is_told_with_loads() || !row.is_same(old) {
        return None;
    }
    let each = changing.into_iter().map(|of| {
        let said = Responses::SameFactor {
            variant: row.name.clone(),
            said: of.said(),
            factor: Quantity::beside_one(factor, 4),
            verdict: own_verdict(row, is_beyond),
        };
        Finding::key(tone(of), said)
    });
    Some(each.collect())
}

/// Variants that improve the stability under weight but not the response to the earthquake of the site, by their index.
fn worse_in_earthquakes(answer: &CheckAnswer) -> Vec<(usize, Finding)> {
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
        is_told.then(|| (at, Finding::key(Tone::Warn, said)))
    });
    each.collect()
}

/// The effect on wind and static loads.
fn loaded(after: &Row, before: &Row, is_beyond: bool) -> Option<Finding> {
    let new = after.borne.filter(|_| after.is_told_with_loads())?;
    let factor = |factor: f64| Quantity::beside_one(factor, 3);
    let word = Both::of(|language| verdict_word(after.verdict, language));
    let verdict = match is_beyond && after.verdict != Verdict::Unstable {
        true => spoken(Responses::UnderWeightAndLoads { word }),
        false => word,
    };
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

fn changed(after: Row, before: &Row, is_beyond: bool) -> Option<Finding> {
    let (new, old) = (after.load_factor?, before.load_factor?);
    let [from, to] = [old, new].map(|factor| Quantity::beside_one(factor, 4));
    let verdict = own_verdict(&after, is_beyond);
    let is_told_with_loads = after.is_told_with_loads();
    let variant = after.name;
    let tone = match new < old {
        true => Tone::Warn,
        false => Tone::Plain,
    };
    // a separate finding gives the wind factor, so this word is about weight
    let is_same = (new / old - 1.0).abs() < SAME_SHARE;
    if is_same && is_told_with_loads {
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
    let given = Both::of(|language| language.pick("as given", "현 상태"));
    let versions = answer.variants.iter();
    let versions = versions.map(|variant| (title(variant), &variant.state));
    let judged = judge_check(answer);
    let mut basis = rows(state, &given);
    let put = |rows: &mut Vec<Row>, version: usize| {
        let Some(own) = judged.versions.get(version) else {
            return;
        };
        for row in rows.iter_mut() {
            row.earthquake = asked(own);
            row.limited = WindFinding::deciding(&own.wind).cloned();
            row.red_word = red_word(own, row.verdict);
        }
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
        // λ and the margins are those of the weight alone; what a survey contradicts is unknown
        verdict: match row.verdict {
            Verdict::Unknown => Verdict::Unknown,
            _ => row.own_verdict,
        },
        margins: row.margins.clone(),
    }
}

/// Limit over response; bad where it is beyond.
fn over_response(row: &Row) -> Cell {
    let limited = row.limited.as_ref();
    let ratio = limited.and_then(|of| of.ratio);
    let ratio = ratio.map(|ratio| Quantity::beside_one(ratio, 3));
    match (limited.is_some_and(|of| of.word == WindWord::Beyond), ratio) {
        (true, Some(ratio)) => Cell::Bad(ratio),
        (_, ratio) => Cell::Number(ratio),
    }
}

fn table(all: &[Row]) -> Table {
    let with_falls = all.iter().any(|row| row.falls.is_some());
    let with_loads = all.iter().any(|row| row.borne.is_some());
    let with_limits = all
        .iter()
        .any(|row| row.limited.as_ref().is_some_and(|of| of.ratio.is_some()));
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
            match &row.red_word {
                Some(name) => Cell::BadWords(Variants::Named(name.clone()).into()),
                None => Cell::words(Variants::Named(Both::of(|language| {
                    verdict_word(row.verdict, language)
                }))),
            },
        ];
        if with_limits {
            let decides = row.limited.as_ref().and_then(limited_in);
            cells.push(Cell::Words(
                decides.map_or_else(|| Sentence::of_symbol("–"), Sentence::from),
            ));
        }
        cells.extend([
            row.load_factor
                .map_or_else(unknown, |factor| Cell::number(Quantity::beside_one(factor, 4))),
            margin,
            frequency.map_or_else(unknown, Cell::number),
        ]);
        if with_loads {
            let factor = row.borne.map(|factor| Quantity::beside_one(factor, 4));
            cells.push(match row.borne.is_some_and(|factor| factor <= 1.0) {
                true => factor.map_or(Cell::Number(None), Cell::Bad),
                false => Cell::Number(factor),
            });
        }
        if with_limits {
            cells.push(over_response(row));
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
            cells.push(Cell::Number(row.falls.map(|of| share(of.estimate))));
        }
        if with_overloaded {
            cells.push(Cell::Number(row.overloaded.map(share)));
        }
        cells
    };
    let mut columns = vec![
        Column::words(Variants::Variant),
        Column::words(Variants::VerdictHead),
    ];
    if with_limits {
        columns.push(Column::words(Variants::LimitedIn));
    }
    columns.extend([
        Column::numbers(Variants::LoadFactor, Unit::ratio()),
        Column::numbers(Variants::LeastMargin, Unit::ratio()),
        Column::numbers(Variants::Lowest, Unit::si("Hz")),
    ]);
    if with_loads {
        columns.push(Column::numbers(Variants::Borne, Unit::ratio()));
    }
    if with_limits {
        columns.push(Column::numbers(Variants::OverResponse, Unit::ratio()));
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
    let mut caption: Vec<Sentence> = vec![Variants::Caption.into(), Variants::CaptionMeaning.into()];
    caption.extend(all.iter().find_map(|row| shares(row.falls?)));
    Table {
        caption,
        columns,
        rows: all.iter().map(row).collect(),
    }
}

/// How many samples the probabilities are from, and what 0 of them means.
fn shares(of: Probability) -> Option<Sentence> {
    let none = Probability::of_count(0, of.samples, of.confidence, of.seed).ok()?;
    let said = Variants::FallsMeaning {
        samples: of.samples,
        seed: of.seed,
        none: Quantity::percent(none.upper, 2),
    };
    Some(said.into())
}
