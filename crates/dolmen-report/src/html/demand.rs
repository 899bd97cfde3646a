//! What an earthquake asks for, in the report: the site's numbers, the spectrum, the comparison.

use super::finding::{Finding, Tone};
use super::stack_notes::capitalised;
use super::table::{Cell, figure, table};
use crate::figures::design_spectrum;
use crate::text::{STANDARD_GRAVITY_M_S2, ground_word, type_word};
use dolmen::assess::demand::{
    ModalRatio, ShakenDirection, SiteDemand, SiteParameters, StackDemandRow, Unverified,
};
use dolmen::stability::stack::{Comparison, DemandVerdict, LimitKind, Threshold};
use dolmen_words::Language;
use dolmen_words::number::{NARROW_SPACE, significant, trimmed};
use dolmen_work::state::DemandAnswer;
use maud::{Markup, html};

/// Digits of accelerations and ratios.
const DIGITS: usize = 3;
/// Digits of a code's own numbers.
const CODE_DIGITS: usize = 6;

fn in_g(acceleration_m_s2: f64) -> String {
    let g = acceleration_m_s2 / STANDARD_GRAVITY_M_S2;
    format!("{}{NARROW_SPACE}g", significant(g, DIGITS))
}

pub(super) fn verdict_word(verdict: DemandVerdict, language: Language) -> &'static str {
    match verdict {
        DemandVerdict::Above => language.pick("above demand", "기준 만족"),
        DemandVerdict::Near => language.pick("near demand", "기준에 근접"),
        DemandVerdict::Below => language.pick("below demand", "기준 불만족"),
        DemandVerdict::Unknown => language.pick("unknown", "판정 불가"),
    }
}

/// The comparison, and what of the code is not verified.
pub(super) fn findings(answer: Option<&DemandAnswer>, language: Language) -> Vec<Finding> {
    let Some(answer) = answer else {
        return Vec::new();
    };
    let mut all = Vec::new();
    if let Some(stack) = &answer.stack {
        let tone = match stack.verdict {
            DemandVerdict::Above => Tone::Good,
            DemandVerdict::Near => Tone::Warn,
            DemandVerdict::Below => Tone::Bad,
            DemandVerdict::Unknown => Tone::Unknown,
        };
        if let Some(row) = stack.rows.last() {
            all.push(Finding::new(tone, sentence(row, stack.verdict, answer, language)));
        }
    }
    if let Some(why) = &answer.refused {
        all.push(Finding::new(
            Tone::Unknown,
            language.pick(
                format!("The demand of the site is not compared: {why}."),
                format!("부지의 요구 수준과 비교하지 못하였다 [{why}]."),
            ),
        ));
    }
    if !answer.site.spectrum.unverified.is_empty() {
        let each = answer.site.spectrum.unverified.iter();
        let words: Vec<String> = each.map(|what| unverified_words(what, language)).collect();
        all.push(Finding::new(
            Tone::Warn,
            language.pick(
                format!(
                    "Of the code these are not held against its text: {}.",
                    words.join("; ")
                ),
                format!("기준 원문과 대조하지 않은 값: {}.", words.join("; ")),
            ),
        ));
    }
    all
}

fn sentence(
    row: &StackDemandRow,
    verdict: DemandVerdict,
    answer: &DemandAnswer,
    language: Language,
) -> String {
    let word = verdict_word(verdict, language);
    let left = row.comparison.rigid.capacity_m_s2.map_or("–".to_owned(), in_g);
    let ground = in_g(row.comparison.rigid.demand_m_s2);
    let source = &answer.site.spectrum.source;
    let (english, korean) = match &row.by_modes {
        Some(by_modes) => {
            let ratio = significant(by_modes.ratio, DIGITS);
            let first = first_words(by_modes, language);
            (
                format!(". On elastic joints, which amplify it, {ratio} of the spectrum is borne: {first}"),
                format!(". 탄성 접합면의 증폭을 고려하면 스펙트럼의 {ratio}배까지 견딘다({first})"),
            )
        }
        None => (
            "; what elastic joints add to it is not known".to_owned(),
            ". 탄성 접합면의 증폭은 알 수 없음".to_owned(),
        ),
    };
    language.pick(
        format!(
            "{}: it begins to move at {left} with the vertical acceleration of the site; {source} asks for {ground} of the ground{english}. \
             Below demand means that something tips or slides, not that it falls.",
            capitalised(word)
        ),
        format!(
            "{word}: 수직 가속도를 고려한 최초 거동 가속도 {left}; {source}의 지반 가속도 {ground}{korean}. 불만족은 돌이 들리거나 \
             미끄러지기 시작한다는 뜻이며 붕괴를 뜻하지 않는다."
        ),
    )
}

pub(super) fn unverified_words(what: &Unverified, language: Language) -> String {
    let korean = match what {
        Unverified::Edition { year } => format!("제정 연도 {year}"),
        Unverified::RiskFactor {
            return_period_years,
            factor,
        } => format!("재현주기 {return_period_years}년의 위험도계수 {factor}"),
        Unverified::VerticalRatio { ratio } => format!("수직/수평 가속도비 {ratio}"),
        Unverified::DampingFactor => "감쇠비 5 % 이외의 감쇠보정계수".to_owned(),
        Unverified::DampingAtShortPeriods => "T = 0과 T_0 사이의 감쇠보정계수".to_owned(),
        Unverified::LongPeriods { displacement_s } => {
            format!("1/T² 구간이 시작되는 주기 {displacement_s} s")
        }
        Unverified::Shape => "스펙트럼의 구간별 형상".to_owned(),
    };
    language.pick(what.to_string(), korean)
}

/// The section.
pub(super) fn section(answer: Option<&DemandAnswer>, language: Language) -> Markup {
    let Some(answer) = answer else {
        return html! {};
    };
    html! {
        h2 { (language.pick("Earthquake demand at the site", "부지의 지진 요구 수준")) }
        p { (answer.site.spectrum.source) }
        (site_table(&answer.site, language))
        @if let Some(stack) = &answer.stack { (comparison_table(&stack.rows, language)) }
        (figure(&design_spectrum(answer, language), language.pick(
            "Design spectrum. Dots: the first periods, each at the damping of the table; level line, of a stack: the acceleration at which it begins to move, less the vertical acceleration.",
            "설계 응답 스펙트럼. 점은 1차 주기(표의 감쇠비), 수평선(적층 구조물)은 수직 가속도를 고려한 최초 거동 가속도이다.",
        )))
    }
}

fn site_table(site: &SiteDemand, language: Language) -> Markup {
    let short = |value: f64| trimmed(value, CODE_DIGITS);
    let g = |m_s2: f64| trimmed(m_s2 / STANDARD_GRAVITY_M_S2, CODE_DIGITS);
    let mut rows: Vec<(&str, String)> = match &site.parameters {
        SiteParameters::Korea {
            zone_factor_g,
            return_period_years,
            risk_factor,
            effective_acceleration_g,
            soil,
            amplification,
            design,
            branches,
        } => vec![
            (
                language.pick("zone factor Z (g)", "지진구역계수 Z (g)"),
                short(*zone_factor_g),
            ),
            (
                language.pick("return period (years)", "재현주기 (년)"),
                return_period_years.to_string(),
            ),
            (
                language.pick("risk factor I (–)", "위험도계수 I (–)"),
                short(*risk_factor),
            ),
            (
                language.pick(
                    "effective acceleration S = Z I (g)",
                    "유효수평지반가속도 S = Z I (g)",
                ),
                short(*effective_acceleration_g),
            ),
            (language.pick("site class", "지반 종류"), format!("{soil:?}")),
            ("Fa (–)", short(amplification.short_periods)),
            ("Fv (–)", short(amplification.one_second)),
            ("T0 (s)", short(branches.rise_s)),
            ("Ts (s)", short(branches.plateau_s)),
            ("TL (s)", short(branches.displacement_s)),
            (
                "S_DS, KDS 41 17 00 (g)",
                design.map_or("–".to_owned(), |design| short(design.short_period_g)),
            ),
            (
                "S_D1, KDS 41 17 00 (g)",
                design.map_or("–".to_owned(), |design| short(design.one_second_g)),
            ),
            (
                language.pick("plateau (g)", "최대 응답 가속도 (g)"),
                g(branches.plateau_m_s2),
            ),
        ],
        SiteParameters::Eurocode {
            ground_acceleration_g,
            importance_factor,
            spectrum,
            ground,
            soil_factor,
            branches,
        } => vec![
            ("a_gR (g)", short(*ground_acceleration_g)),
            (
                language.pick("importance factor (–)", "중요도계수 (–)"),
                short(*importance_factor),
            ),
            (
                language.pick("type", "스펙트럼 유형"),
                type_word(*spectrum).to_owned(),
            ),
            (
                language.pick("ground", "지반 종류"),
                ground_word(*ground).to_owned(),
            ),
            ("S (–)", short(*soil_factor)),
            ("TB (s)", short(branches.rise_s)),
            ("TC (s)", short(branches.plateau_s)),
            ("TD (s)", short(branches.displacement_s)),
            (
                language.pick("plateau (g)", "최대 응답 가속도 (g)"),
                g(branches.plateau_m_s2),
            ),
        ],
        SiteParameters::Table {
            rows,
            least_s,
            most_s,
        } => vec![
            (language.pick("rows of the table", "표의 행 수"), rows.to_string()),
            (
                language.pick("periods (s)", "주기 범위 (s)"),
                format!("{} – {}", short(*least_s), short(*most_s)),
            ),
        ],
    };
    rows.push((
        language.pick("peak of the ground (g)", "지반 최대 가속도 (g)"),
        site.peak_ground_acceleration_m_s2.map_or("–".to_owned(), g),
    ));
    let vertical = match &site.vertical {
        Some(vertical) if vertical.verified => short(vertical.ratio),
        Some(vertical) => format!(
            "{} ({})",
            short(vertical.ratio),
            language.pick("unverified", "미확인")
        ),
        None => language
            .pick("not given: none counted", "주어지지 않음(고려하지 않음)")
            .to_owned(),
    };
    rows.push((
        language.pick("vertical / horizontal (–)", "수직/수평 가속도비 (–)"),
        vertical,
    ));
    rows.push((
        language.pick("damping (%)", "감쇠비 (%)"),
        trimmed(100.0 * site.damping_ratio, 4),
    ));
    let head = [language.pick("Quantity", "항목"), language.pick("value", "값")].map(String::from);
    let cells: Vec<Vec<Cell>> = rows
        .into_iter()
        .map(|(name, value)| vec![name.into(), value.into()])
        .collect();
    table(
        language.pick(
            "The site. Every number between it and the spectrum.",
            "부지. 스펙트럼을 정하는 모든 값.",
        ),
        1,
        &head,
        &cells,
    )
}

/// What gives way first.
fn first_words(by_modes: &ModalRatio, language: Language) -> String {
    let Some((kind, above)) = &by_modes.first else {
        return language.pick(
            "stones that share their load move first".to_owned(),
            "하중을 나누어 받는 돌이 먼저 움직인다".to_owned(),
        );
    };
    let below = match above.as_str() {
        "the ground" => language.pick("the ground", "지반").to_owned(),
        named => named.to_owned(),
    };
    match kind {
        LimitKind::Uplift => language.pick(
            format!("what stands on {below} tips first"),
            format!("{below} 위의 부분이 먼저 들린다"),
        ),
        LimitKind::Sliding => language.pick(
            format!("what stands on {below} slides first"),
            format!("{below} 위의 부분이 먼저 미끄러진다"),
        ),
    }
}

fn comparison_table(rows: &[StackDemandRow], language: Language) -> Markup {
    let head: Vec<String> = [
        language.pick("Shaken along", "방향"),
        language.pick("moves at (g)", "최초 거동 (g)"),
        language.pick("less vertical (g)", "수직 고려 (g)"),
        language.pick("ground (g)", "지반 (g)"),
        language.pick("ratio", "비"),
        language.pick("rigid blocks", "강체 블록"),
        "T1 (s)",
        "S_a (g)",
        language.pick("S_a alike", "S_a 균일"),
        language.pick("by modes", "모드별"),
        language.pick("elastic joints", "탄성 접합면"),
    ]
    .map(String::from)
    .to_vec();
    let cells: Vec<Vec<Cell>> = rows.iter().map(|row| line(row, language)).collect();
    let near = DemandVerdict::NEAR_BELOW;
    table(
        &language.pick(
            format!("Capacity against demand. Ratio: what is left with the vertical acceleration, over the demand; above demand at least {near}, near 1 to {near}, below less than 1. By modes: the forces of all modes on what is above each joint against what weight and friction bear there. S_a alike, as published, lets all stones feel S_a: not on the safe side, and it decides nothing."),
            format!("저항 가속도와 요구 수준. 비: 수직 가속도를 고려한 저항 가속도 / 요구 가속도. {near} 이상이면 기준 만족, 1–{near}이면 근접, 1 미만이면 불만족. 모드별: 모든 모드의 관성력이 각 접합면 위쪽에 작용할 때 자중과 마찰이 견디는 비. S_a 균일(논문의 방법): 모든 돌에 S_a를 같게 적용한 비로, 안전측이 아니며 판정에 쓰지 않는다."),
        ),
        1,
        &head,
        &cells,
    )
}

fn line(row: &StackDemandRow, language: Language) -> Vec<Cell> {
    let g = |m_s2: f64| significant(m_s2 / STANDARD_GRAVITY_M_S2, DIGITS);
    let at = |threshold: &Option<Threshold>| {
        threshold
            .as_ref()
            .map_or("–".to_owned(), |t| g(t.acceleration_m_s2))
    };
    let ratio = |comparison: &Comparison| -> Cell {
        let text = comparison
            .ratio
            .map_or("–".to_owned(), |ratio| significant(ratio, DIGITS));
        if comparison.verdict == DemandVerdict::Below {
            Cell::bad(text)
        } else {
            text.into()
        }
    };
    let rigid = &row.comparison.rigid;
    let mut cells: Vec<Cell> = vec![
        match row.direction {
            ShakenDirection::X => "x",
            ShakenDirection::Y => "y",
            ShakenDirection::Any => language.pick("any", "모든 방향"),
        }
        .into(),
        at(&row.capacity).into(),
        at(&row.capacity_with_vertical).into(),
        g(rigid.demand_m_s2).into(),
        ratio(rigid),
        verdict_word(rigid.verdict, language).into(),
    ];
    match (&row.comparison.elastic, row.period_s) {
        (Some(elastic), Some(period_s)) => cells.extend([
            significant(period_s, DIGITS).into(),
            g(elastic.demand_m_s2).into(),
            ratio(elastic),
        ]),
        _ => cells.extend(["–", "–", "–"].map(Cell::from)),
    }
    let (text, verdict) = match &row.by_modes {
        Some(by_modes) => (significant(by_modes.ratio, DIGITS), by_modes.verdict),
        None => ("–".to_owned(), DemandVerdict::Unknown),
    };
    cells.push(match verdict {
        DemandVerdict::Below => Cell::bad(text),
        _ => text.into(),
    });
    cells.push(verdict_word(verdict, language).into());
    cells
}
