//! A ranked portfolio as a page.

use super::page::{Imprint, whole};
use super::table::{Cell, figure, table};
use crate::figures::ranking;
use dolmen::assess::RankedBy;
use dolmen_words::Language;
use dolmen_words::number::{fixed, percent, significant};
use dolmen_work::portfolio::{
    PortfolioAnswer, basis_words, capacity_words, count_words, falls_first, hazards_replaced, misjudged,
    probability_in_years, reason_words, state_words, without_hazard,
};
use maud::{Markup, html};

/// Rows of the table; all of them are in ranking.csv.
const ROWS_MOST: usize = 200;

/// Structures that falls alone would put far further back, that are named.
const MISJUDGED_SHOWN: usize = 10;

/// The ranking as a page that needs nothing else.
pub fn ranking_html(answer: &PortfolioAnswer, language: Language, imprint: &Imprint) -> String {
    let title = language.pick("Which structure first", "우선순위 평가");
    let count = count_words(answer, language);
    let state = state_words(answer.state, language);
    let by = match answer.ranked.by {
        RankedBy::AnnualRate => language.pick("annual rate", "연간 발생률"),
        RankedBy::Capacity => language.pick(
            "capacity (not every structure has a hazard)",
            "저항능력(지진재해도가 없는 구조물 포함)",
        ),
    };
    let body = html! {
        article {
            header {
                p.kicker { (language.pick("Ranking of structures", "구조물 우선순위")) }
                h1 { (title) }
                p.sub { (answer.source) }
                p.sub { @if let Some(date) = &imprint.date { (date) " · " } (imprint.program) }
            }
            p { (language.pick(
                format!("{count} by the {by} of {state}, the worst first."),
                format!("{count}를 {state}의 {by} 기준으로 나쁜 순서대로 나열하였다."),
            )) }
            @if let Some(sentence) = without_hazard(answer, language) { p { b { (sentence) } } }
            @let said = misjudged(answer, language);
            @for sentence in said.iter().take(MISJUDGED_SHOWN) { p { b { (sentence) } } }
            @if said.len() > MISJUDGED_SHOWN {
                @let more = said.len() - MISJUDGED_SHOWN;
                p { b { (language.pick(
                    format!("and {more} more that falls alone would put far further back: place_by_falls in ranking.csv"),
                    format!("낙하·전도만 보면 크게 뒤로 밀리는 구조물 {more}기 더 있음: ranking.csv의 place_by_falls"),
                )) } }
            }
            @if let Some(sentence) = hazards_replaced(answer, language) { p { (sentence) } }
            @for sentence in falls_first(answer, language).iter().take(MISJUDGED_SHOWN) { p { b { (sentence) } } }
            @if !answer.left_out.is_empty() { (left_out(answer, language)) }
            (figure(&ranking(answer, language), language.pick(
                "Capacities with 90 % of what is not known, the worst on top",
                "저항능력과 90 % 불확실 구간, 위쪽이 가장 취약",
            )))
            (rows(answer, language))
            h2 { (language.pick("How", "방법")) }
            p { (method(answer, language)) }
        }
    };
    whole(title, language, &body)
}

fn left_out(answer: &PortfolioAnswer, language: Language) -> Markup {
    html! {
        h2 { (language.pick("Without a place: look at these yourself", "순위를 매기지 못한 구조물: 직접 검토 필요")) }
        ul { @for one in &answer.left_out { li { b { (one.name) } ": " (one.why) } } }
    }
}

fn rows(answer: &PortfolioAnswer, language: Language) -> Markup {
    let has_rate = answer.ranked.by == RankedBy::AnnualRate;
    let state = state_words(answer.state, language);
    let mut head = vec![
        language.pick("structure", "구조물").to_owned(),
        language.pick("rests on", "근거").to_owned(),
        language.pick("what lowers it", "주된 저하 요인").to_owned(),
        language.pick("place", "순위").to_owned(),
        "90 %".to_owned(),
        format!("{state} (g)"),
    ];
    if has_rate {
        head.push(language.pick("a year", "연간").to_owned());
        head.push(language.pick("in 50 years", "50년").to_owned());
    }
    head.push(language.pick("worst tenth", "하위 10 %").to_owned());
    head.push(language.pick("by falls alone", "낙하·전도 순위").to_owned());
    let mut all = Vec::new();
    for (place, entry, known) in answer.rows().take(ROWS_MOST) {
        let mut row: Vec<Cell> = vec![
            Cell::wrapping(entry.name.clone()),
            Cell::wrapping(basis_words(entry, language)),
            Cell::wrapping(reason_words(entry, language)),
            place.rank.to_string().into(),
            format!(
                "{} – {}",
                fixed(place.rank_interval.lower, 0),
                fixed(place.rank_interval.upper, 0)
            )
            .into(),
            capacity_words(known, answer.gravity_m_s2).into(),
        ];
        if let Some(rate) = place.annual_rate.filter(|_| has_rate) {
            row.push(significant(rate, 2).into());
            row.push(percent(probability_in_years(rate), 2).into());
        }
        row.push(percent(place.worst_tenth, 2).into());
        let falls = answer.by_falls.get(place.candidate).copied().flatten();
        row.push(falls.map_or("–".to_owned(), |rank| rank.to_string()).into());
        all.push(row);
    }
    let more = answer.ranked.places.len().saturating_sub(ROWS_MOST);
    let caption = language.pick("Ranking. The worst first", "우선순위. 나쁜 순서");
    html! {
        (table(caption, 3, &head, &all))
        @if more > 0 { p { (language.pick(format!("and {more} more in ranking.csv"), format!("나머지 {more}기는 ranking.csv 참조"))) } }
    }
}

fn method(answer: &PortfolioAnswer, language: Language) -> String {
    let (designs, draws) = (answer.designs, answer.draws);
    language.pick(
        format!(
            "A structure rests on its own study where it has one, else on the six-factor score, trained on {designs} simulated pagodas. Places have \
             intervals from {draws} draws of what is not known of each capacity, independent from structure to structure. Where a bound stands in \
             place of a capacity, the structure is ranked at the bound. The score puts pagodas into order; it is no proof that one stands."
        ),
        format!(
            "개별 해석이 있는 구조물은 그 결과를, 없는 구조물은 석탑 {designs}기의 해석으로 학습한 여섯 인자 점수를 근거로 한다. 순위 구간은 각 저항능력의 \
             불확실성을 서로 독립으로 {draws}회 추출하여 구하였다. 저항능력 대신 한계값만 아는 구조물은 그 값으로 순위를 매긴다. 점수는 석탑의 순서를 정할 \
             뿐이며 안전의 증명이 아니다."
        ),
    )
}
