//! The criterion of a ranking, and its warnings.

use crate::document::{Block, Document};
use crate::score::state_name;
use dolmen::assess::{Known, RankedBy};
use dolmen_words::message::Both;
use dolmen_words::{Quantity, Sentence, messages};
use dolmen_work::portfolio::{
    Basis, FallsApart, LeftOut, PortfolioAnswer, PortfolioEntry, falls_first, hazards_replaced, misjudged,
    without_hazard,
};

/// Largest number of structures without a hazard that a remark names.
const NAMED: usize = 5;
/// Largest number of unranked structures that the heading names.
const LEFT_OUT_NAMED: usize = 12;
/// Largest number of structures with another rank by falls alone that a remark names.
const APART_SHOWN: usize = 10;

messages! {
    /// Remarks on a ranking.
    pub(crate) enum Remarks in "rank.remarks" {
        One => { en: "1 structure", ko: "구조물 1기" },
        Structures { count: usize } => { en: "{count} structures", ko: "구조물 {count}기" },
        OfStructures { count: usize, all: usize } => { en: "{count} of {all} structures", ko: "구조물 {all}기 중 {count}기" },
        ByRate { structures: Sentence, state: Both } => {
            en: "{structures} by the annual rate of {state}, the worst first.",
            ko: "{structures}을(를) {state}의 연간 초과율 기준으로 취약한 순서로 나열하였다.",
        },
        ByCapacity { structures: Sentence, state: Both } => {
            en: "{structures} by the capacity for {state}, the worst first: the peak of the ground that half of the motions need.",
            ko: "{structures}을(를) {state}의 저항능력(지반운동의 절반이 그 상태에 이르게 하는 최대지반가속도) 기준으로 취약한 순서로 나열하였다.",
        },
        NoHazard => { en: "The hazard of the sites is not given.", ko: "부지의 지진재해도가 주어지지 않았다." },
        NotByRate { why: Sentence } => { en: "NOT BY RATE: {why}", ko: "초과율 기준 아님: {why}" },
        OneWithoutHazard { all: usize, name: String } => {
            en: "1 of {all} has no hazard of its site ({name}): all are ordered by what they bear, not by how often it comes. Give zone_factor_g and soil for each, or site.hazard in its project.",
            ko: "{all}기 가운데 1기({name})는 부지의 지진재해도가 없어, 초과율이 아니라 저항능력만으로 순서를 매겼다. 모든 구조물에 zone_factor_g와 soil을, 또는 과제 파일에 site.hazard를 주어야 한다.",
        },
        WithoutHazard { lacking: usize, all: usize, names: Sentence } => {
            en: "{lacking} of {all} have no hazard of their site ({names}): all are ordered by what they bear, not by how often it comes. Give zone_factor_g and soil for each, or site.hazard in its project.",
            ko: "{all}기 가운데 {lacking}기({names})는 부지의 지진재해도가 없어, 초과율이 아니라 저항능력만으로 순서를 매겼다. 모든 구조물에 zone_factor_g와 soil을, 또는 과제 파일에 site.hazard를 주어야 한다.",
        },
        Names { names: Vec<String> } => { en: "{names}", ko: "{names}" },
        NamesAndMore { names: Vec<String>, more: usize } => { en: "{names}, and {more} more", ko: "{names} 외 {more}기" },
        HazardsReplaced { names: Vec<String> } => {
            en: "The zone and soil of the table (KDS 17 10 00) stand in place of the project's own [site] for {names}.",
            ko: "{names}: 과제 파일의 [site] 대신 표의 지진구역과 지반(KDS 17 10 00)을 적용하였다.",
        },
        FallAlone { name: String, share: Quantity } => {
            en: "{name}: {share} of its scans fall under their own weight, without shaking. Its place counts them: its capacity is the median of all scans, its rate the one that gives the same probability in 50 years",
            ko: "{name}: 증분해석의 {share}이(가) 지진 없이 자중으로 붕괴한다. 순위에는 이를 포함하였으며, 저항능력은 전체의 중앙값, 연간 초과율은 50년 확률이 같은 값이다",
        },
        OnlyAtMost { names: Sentence } => {
            en: "PLACE NOT KNOWN: every scan of {names} reached the state at the smallest size tried, so that its capacity is known from above alone. It may be the worst of all: scan smaller sizes.",
            ko: "순위를 알 수 없음: {names}의 모든 증분해석이 가장 작은 크기에서 이미 그 상태에 이르러 저항능력의 상한만 안다. 가장 취약할 수도 있으므로 더 작은 크기부터 해석해야 한다.",
        },
        SevereDamage { names: Sentence } => {
            en: "DAMAGE LEFT OUT: inspections found severe damage at {names}, and their places are those of undamaged structures. Look at these yourself first.",
            ko: "손상 미반영: {names}은(는) 점검에서 심한 손상이 확인되었으나 순위는 손상이 없는 상태의 것이다. 먼저 직접 검토해야 한다.",
        },
        OfVariant { name: String, study: String, variant: String } => {
            en: "{name}: study {study} is of the variant {variant}, not of the structure as it is",
            ko: "{name}: 해석 {study}은(는) 현 상태가 아니라 대안 {variant}의 것이다",
        },
        OfSet { name: String, study: String, set: Vec<String> } => {
            en: "{name}: study {study} is of values set in place of those of the file: {set}",
            ko: "{name}: 해석 {study}은(는) 파일의 값을 바꾼 것이다: {set}",
        },
        Misjudged { name: String, rank: usize, state: Both, falls: usize } => {
            en: "{name}: place {rank} by {state}, but {falls} by falls alone: it is damaged long before anything falls",
            ko: "{name}: {state} 기준 {rank}위이나 낙하·전도만 보면 {falls}위: 낙하·전도보다 훨씬 먼저 손상된다",
        },
        FallsFirst { name: String, rank: usize, state: Both, falls: usize } => {
            en: "{name}: place {rank} by {state}, but {falls} by falls alone: little is damaged before it falls",
            ko: "{name}: {state} 기준 {rank}위이나 낙하·전도만 보면 {falls}위: 손상상태를 거의 거치지 않고 낙하·전도에 이른다",
        },
        MoreMisjudged { more: usize } => {
            en: "and {more} more that falls alone would put far further back: place_by_falls in ranking.csv",
            ko: "낙하·전도만 보면 크게 뒤로 밀리는 구조물 {more}기 더 있음: ranking.csv의 place_by_falls",
        },
        MoreFallsFirst { more: usize } => {
            en: "and {more} more that fall far earlier than they are damaged: place_by_falls in ranking.csv",
            ko: "손상상태를 거의 거치지 않고 낙하·전도에 이르는 구조물 {more}기 더 있음: ranking.csv의 place_by_falls",
        },
        WithoutPlaceBelow { count: usize } => {
            en: "Without a place: {count}. They are named below the table and may be the worst.",
            ko: "순위를 매기지 못한 구조물: {count}기. 표 아래에 제시하였으며 가장 취약할 수도 있다.",
        },
        ColumnsLeftOut { columns: Vec<String> } => {
            en: "The ranking does not use the columns {columns}.",
            ko: "평가에 쓰지 않은 열은 {columns}이다.",
        },
        LeftOutHead { count: usize, names: Sentence } => {
            en: "Without a place, look at these yourself: {count} ({names})",
            ko: "순위를 매기지 못한 구조물 {count}기({names}): 직접 검토 필요",
        },
        LeftOut { name: String, why: Both } => { en: "{name}: {why}", ko: "{name}: {why}" },
    }
}

/// The criterion of the ranking, and its state.
pub(super) fn lead(answer: &PortfolioAnswer) -> Block<'static> {
    let (count, without) = (answer.ranked.places.len(), answer.left_out.len());
    let structures = match (count, without) {
        (1, 0) => Remarks::One,
        (_, 0) => Remarks::Structures { count },
        _ => Remarks::OfStructures {
            count,
            all: count + without,
        },
    };
    let (structures, state) = (structures.into(), state_name(answer.state));
    let said = match answer.ranked.by {
        RankedBy::AnnualRate => vec![Remarks::ByRate { structures, state }],
        RankedBy::Capacity if without_hazard(answer).is_empty() => {
            vec![Remarks::ByCapacity { structures, state }, Remarks::NoHazard]
        }
        RankedBy::Capacity => vec![Remarks::ByCapacity { structures, state }],
    };
    Block::Paragraph(said.into_iter().map(Sentence::from).collect())
}

/// Why structures are not ranked by rates although some have a hazard.
pub(crate) fn not_by_rate(answer: &PortfolioAnswer) -> Option<Sentence> {
    let (lacking, all) = (without_hazard(answer), answer.entries.len());
    let owned = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect();
    let said = match lacking.as_slice() {
        [] => return None,
        [one] => Remarks::OneWithoutHazard {
            all,
            name: (*one).to_owned(),
        },
        names if names.len() <= NAMED => Remarks::WithoutHazard {
            lacking: names.len(),
            all,
            names: Remarks::Names { names: owned(names) }.into(),
        },
        names => Remarks::WithoutHazard {
            lacking: names.len(),
            all,
            names: Remarks::NamesAndMore {
                names: owned(&names[..NAMED]),
                more: names.len() - NAMED,
            }
            .into(),
        },
    };
    Some(said.into())
}

/// The same as a warning.
pub(super) fn rate_warning(answer: &PortfolioAnswer) -> Option<Block<'static>> {
    let why = not_by_rate(answer)?;
    Some(Block::Warning(Remarks::NotByRate { why }.into()))
}

/// Structures that fall under their own weight in some samples.
pub(super) fn fall_alone(answer: &PortfolioAnswer) -> Vec<Sentence> {
    let alone = answer.rows().filter(|(.., known)| known.falls_alone > 0.0);
    let said = alone.map(|(_, entry, known)| Remarks::FallAlone {
        name: entry.name.clone(),
        share: Quantity::percent(known.falls_alone, 2),
    });
    said.map(Sentence::from).collect()
}

/// Structures whose capacity has an upper bound alone.
pub(super) fn only_at_most(answer: &PortfolioAnswer) -> Option<Block<'static>> {
    let open = answer.rows().filter(|(.., known)| known.known == Known::AtMost);
    let names = named(open.map(|(_, entry, _)| entry))?;
    Some(Block::Warning(Remarks::OnlyAtMost { names }.into()))
}

/// Structures with severe damage that their capacity leaves out.
pub(super) fn severe_damage(answer: &PortfolioAnswer) -> Option<Block<'static>> {
    let damaged = answer
        .rows()
        .filter(|(_, entry, _)| !entry.severe_damage.is_empty());
    let names = named(damaged.map(|(_, entry, _)| entry))?;
    Some(Block::Warning(Remarks::SevereDamage { names }.into()))
}

/// Names of structures, the first of many; `None` without any.
fn named<'a>(entries: impl Iterator<Item = &'a PortfolioEntry>) -> Option<Sentence> {
    let mut names: Vec<String> = entries.map(|entry| entry.name.clone()).collect();
    let more = names.len().saturating_sub(LEFT_OUT_NAMED);
    names.truncate(LEFT_OUT_NAMED);
    let names = match (names.len(), more) {
        (0, _) => return None,
        (_, 0) => Remarks::Names { names },
        _ => Remarks::NamesAndMore { names, more },
    };
    Some(names.into())
}

/// Structures whose studies are not of the structure as it is.
pub(super) fn other_versions(answer: &PortfolioAnswer) -> Vec<Sentence> {
    let mut all = Vec::new();
    for (_, entry, _) in answer.rows() {
        let Basis::Study {
            name: study,
            variant,
            set,
            ..
        } = &entry.basis
        else {
            continue;
        };
        let (name, study) = (entry.name.clone(), study.clone());
        if let Some(variant) = variant.clone() {
            let (name, study) = (name.clone(), study.clone());
            all.push(Remarks::OfVariant { name, study, variant }.into());
        }
        if !set.is_empty() {
            let set = set.clone();
            all.push(Remarks::OfSet { name, study, set }.into());
        }
    }
    all
}

/// Structures with another rank by falls alone, those far lower first.
pub(super) fn apart(answer: &PortfolioAnswer) -> Vec<Sentence> {
    let later = |of: &FallsApart<'_>| Remarks::Misjudged {
        name: of.name.to_owned(),
        rank: of.rank,
        state: state_name(answer.state),
        falls: of.by_falls,
    };
    let sooner = |of: &FallsApart<'_>| Remarks::FallsFirst {
        name: of.name.to_owned(),
        rank: of.rank,
        state: state_name(answer.state),
        falls: of.by_falls,
    };
    let mut all = first(&misjudged(answer), later, |more| Remarks::MoreMisjudged { more });
    all.extend(first(&falls_first(answer), sooner, |more| {
        Remarks::MoreFallsFirst { more }
    }));
    all
}

fn first(
    all: &[FallsApart<'_>],
    said: impl Fn(&FallsApart<'_>) -> Remarks,
    others: impl Fn(usize) -> Remarks,
) -> Vec<Sentence> {
    let shown = all.iter().take(APART_SHOWN).map(said);
    let more = all.len().saturating_sub(APART_SHOWN);
    let more = (more > 0).then(|| others(more));
    shown.chain(more).map(Sentence::from).collect()
}

/// The text before the table.
pub(super) fn before(document: &mut Document<'_>, answer: &PortfolioAnswer) {
    document.put(lead(answer));
    document.blocks.extend(rate_warning(answer));
    document.blocks.extend(severe_damage(answer));
    document.blocks.extend(only_at_most(answer));
    if !answer.left_out.is_empty() {
        let count = answer.left_out.len();
        document.put(Block::Warning(Remarks::WithoutPlaceBelow { count }.into()));
    }
    let others = other_versions(answer);
    if !others.is_empty() {
        document.put(Block::List(others));
    }
    let alone = fall_alone(answer);
    if !alone.is_empty() {
        document.put(Block::List(alone));
    }
    let apart = apart(answer);
    if !apart.is_empty() {
        document.put(Block::List(apart));
    }
    if let Some(said) = columns_left_out(answer) {
        document.paragraph(said);
    }
    let names = hazards_replaced(answer).into_iter().map(str::to_owned);
    let names: Vec<String> = names.collect();
    if !names.is_empty() {
        document.paragraph(Remarks::HazardsReplaced { names });
    }
}

/// Columns of the table that a ranking does not use.
pub(super) fn columns_left_out(answer: &PortfolioAnswer) -> Option<Sentence> {
    let columns = answer.columns_left_out.clone();
    (!columns.is_empty()).then(|| Remarks::ColumnsLeftOut { columns }.into())
}

/// Number of unranked structures.
pub(super) fn left_out_head(answer: &PortfolioAnswer) -> Sentence {
    let count = answer.left_out.len();
    let shown = answer.left_out.iter().take(LEFT_OUT_NAMED);
    let names: Vec<String> = shown.map(|one| one.name.clone()).collect();
    let names = match count.saturating_sub(LEFT_OUT_NAMED) {
        0 => Remarks::Names { names },
        more => Remarks::NamesAndMore { names, more },
    };
    Remarks::LeftOutHead {
        count,
        names: names.into(),
    }
    .into()
}

/// An unranked structure and the reason.
pub(super) fn left_out_words(one: &LeftOut) -> Sentence {
    Remarks::LeftOut {
        name: one.name.clone(),
        why: one.why.clone(),
    }
    .into()
}

/// Structures without a place.
pub(super) fn left_out(document: &mut Document<'_>, answer: &PortfolioAnswer) {
    if !answer.left_out.is_empty() {
        document.heading(left_out_head(answer));
        document.put(Block::List(answer.left_out.iter().map(left_out_words).collect()));
    }
}
