//! A stack in the report: the view, the limits of each joint, what moves first, variants.

use super::finding::{Finding, Tone};
use super::stack_notes::{stack_note_words, standing_words};
use super::table::{Cell, figure, table};
use super::words::verdict_word;
use crate::figures::{above_words, stack_capacity, stack_directions, stack_governing, stack_view};
use dolmen::assess::{StackCheck, StackNote};
use dolmen::stability::Verdict;
use dolmen::stability::stack::{CutLimits, Governing, LimitKind, Standing, Threshold};
use dolmen_words::Language;
use dolmen_words::number::{self, significant};
use dolmen_work::answer::ProjectReport;
use dolmen_work::state::{Check, StackAnswer};
use maud::{Markup, html};

/// Digits of an acceleration or a margin.
const DIGITS: usize = 3;

fn in_g(acceleration_g: f64) -> String {
    if acceleration_g.is_finite() {
        format!("{}{}g", significant(acceleration_g, DIGITS), number::NARROW_SPACE)
    } else {
        "∞".to_owned()
    }
}

/// The sentence of the banner.
pub(super) fn banner(answer: &StackAnswer, language: Language) -> String {
    let limits = &answer.check.limits;
    let margin = limits
        .gravity_margin
        .map_or("–".to_owned(), |m| significant(m, DIGITS));
    match (&limits.standing, &answer.check.capacity) {
        (Standing::Stands, Some(capacity)) => {
            let at = in_g(capacity.acceleration_g);
            language.pick(
                format!("Margin without shaking {margin}; it begins to move at {at} horizontal."),
                format!("지진이 없을 때의 여유도 {margin}; 수평 가속도 {at}에서 움직이기 시작한다."),
            )
        }
        (Standing::Stands, None) => language.pick(
            format!("Margin without shaking {margin}; what moves it first is not known."),
            format!("지진이 없을 때의 여유도 {margin}; 최초 거동은 알 수 없다."),
        ),
        (standing, _) => language.pick(
            format!("It does not stand without shaking: {standing}."),
            format!(
                "지진이 없어도 서 있지 못한다: {}.",
                standing_words(standing, language)
            ),
        ),
    }
}

/// What the verdicts on a stack mean.
pub(super) fn thresholds(language: Language) -> String {
    let limit = significant(Verdict::MARGINAL_BELOW_MARGIN, DIGITS);
    language.pick(
        format!(
            "stable: margin ≥ {limit} · marginal: below {limit} · unstable: it does not stand. The margin is what is left, without \
             shaking, of the way from the middle of a joint to its edge, or of friction. An earthquake is not in this verdict."
        ),
        format!(
            "안정: 여유도 ≥ {limit} · 여유 부족: {limit} 미만 · 불안정: 서 있지 못함. 여유도는 지진이 없을 때 접합면 중심에서 모서리까지의 \
             거리(또는 마찰) 중 남은 비율이다. 이 판정에 지진은 포함되지 않는다."
        ),
    )
}

pub(super) fn findings(answer: &StackAnswer, language: Language) -> Vec<Finding> {
    let check = &answer.check;
    let mut all = vec![Finding::of(check.verdict, banner(answer, language))];
    match (&check.limits.governing, moves_together(check)) {
        (Some(first), None) => {
            all.push(Finding::new(Tone::Plain, first_words(answer, first, language)));
        }
        (_, Some(_)) => all.push(Finding::new(
            Tone::Plain,
            language.pick(
                "Several stones move together first; a limit analysis finds it.",
                "여러 부재가 함께 먼저 움직인다(한계해석 결과).",
            ),
        )),
        _ => {}
    }
    for note in &check.notes {
        all.push(Finding::new(Tone::Warn, stack_note_words(note, language)));
    }
    all
}

fn first_words(answer: &StackAnswer, first: &Governing, language: Language) -> String {
    let above = answer
        .check
        .limits
        .cuts
        .get(first.cut)
        .map_or("", |cut| &cut.above);
    let (name, at) = (above_words(above, language), in_g(first.threshold.acceleration_g));
    let (english, korean) = match first.kind {
        LimitKind::Uplift => ("rocks", "로킹"),
        LimitKind::Sliding => ("slides", "미끄러짐"),
    };
    language.pick(
        format!("First what stands on {name} {english}, at {at}. That is the first motion, not collapse: how far it goes needs a time history."),
        format!("가장 먼저 움직이는 것은 {name} 위의 부분이며({korean}), 그 가속도는 {at}이다. 이는 최초 거동이지 붕괴가 아니며, 그 이후는 시간이력 해석이 필요하다."),
    )
}

/// The sections of a stack.
pub(super) fn sections(whole: &ProjectReport, answer: &StackAnswer, language: Language) -> Markup {
    let limits = &answer.check.limits;
    let simulated_g = whole.stack_simulation().map(|s| s.peak_horizontal_g());
    let site = whole.state().and_then(|state| state.demand.as_ref());
    let site_g = site.and_then(|demand| demand.site.peak_ground_acceleration_m_s2);
    let peak_g = simulated_g.or(site_g.map(|peak| peak / answer.stack.gravity_m_s2()));
    html! {
        h2 { (language.pick("The stack and the limits of its joints", "적층 구조와 접합면의 한계")) }
        (figure(
            &stack_view(&answer.stack, language),
            &language.pick(
                format!("The stack as modelled. {} blocks, {} joints; to scale, seen from the front right.", answer.stack.blocks().len(), answer.stack.joints().len()),
                format!("해석 모델. 블록 {}개, 접합면 {}개; 축척에 맞게 오른쪽 앞에서 본 모습.", answer.stack.blocks().len(), answer.stack.joints().len()),
            ),
        ))
        (limits_table(&answer.check, language))
        (figure(
            &stack_governing(limits, peak_g, language),
            language.pick(
                "What governs each joint. Points on the slope rock first, points on the level slide first. B/H is the slope from the centroid of what stands on the joint to its nearer edge.",
                "접합면별 지배 거동. 경사선 위의 점은 로킹이, 수평선 위의 점은 미끄러짐이 먼저 일어난다. B/H는 접합면 상부의 무게 중심에서 가까운 모서리까지의 기울기이다.",
            ),
        ))
        (figure(
            &stack_capacity(limits, peak_g, language),
            language.pick(
                "Capacity of each joint alone, lowest at the bottom; several stones may move together before (table above). In the tinted part the ground alone moves it; elastic joints amplify what the ground does.",
                "접합면별 저항 가속도(아래가 최하단). 여러 부재가 함께 더 일찍 움직일 수 있다(위의 표). 바탕색 범위에서는 지반 가속도만으로 움직이며, 탄성 접합면은 지반 가속도를 증폭시킨다.",
            ),
        ))
        @if let Some(drawn) = stack_directions(limits, peak_g, answer.stack.gravity_m_s2(), language) {
            (figure(&drawn, language.pick(
                "Limits by direction. Acceleration of the stones at which some joint opens, in each direction of the plan; the ground accelerates the other way. The circle of sliding is its least value.",
                "방향별 한계. 평면의 각 방향에서 접합면이 벌어지기 시작하는 부재의 가속도(지반 가속도는 반대 방향). 미끄러짐의 원은 최솟값이다.",
            )))
        }
        (variants(whole, answer, language))
    }
}

fn limits_table(check: &StackCheck, language: Language) -> Markup {
    let head: Vec<String> = [
        language.pick("What stands on", "접합면 (아래 부재)"),
        language.pick("weight (kN)", "상부 무게 (kN)"),
        language.pick("area (m²)", "면적 (m²)"),
        language.pick("margin", "여유도"),
        language.pick("rocks at (g)", "로킹 (g)"),
        language.pick("slides at (g)", "미끄러짐 (g)"),
    ]
    .map(String::from)
    .to_vec();
    let cuts = check.limits.cuts.iter();
    let mut rows: Vec<Vec<Cell>> = cuts.map(|cut| row(cut, language)).collect();
    if let Some(together) = moves_together(check) {
        let name = language.pick(
            "several stones together (limit analysis)",
            "여러 부재가 함께 (한계해석)",
        );
        let mut cells: Vec<Cell> = vec![Cell::bad(name)];
        cells.extend(["–", "–", "–"].map(Cell::from));
        cells.push(Cell::bad(significant(together.acceleration_g, DIGITS)));
        cells.push("–".into());
        rows.push(cells);
    }
    table(
        language.pick(
            "Limits of each joint. Horizontal acceleration at which what stands on it begins to rock or slide, in the worst direction.",
            "접합면별 한계. 접합면 상부가 로킹 또는 미끄러지기 시작하는 수평 가속도(가장 불리한 방향).",
        ),
        1,
        &head,
        &rows,
    )
}

/// The acceleration at which several stones move together, where that is before any joint alone.
fn moves_together(check: &StackCheck) -> Option<Threshold> {
    let lower = |note: &StackNote| matches!(note, StackNote::AnalysisLower { .. });
    check.capacity.filter(|_| check.notes.iter().any(lower))
}

fn row(cut: &CutLimits, language: Language) -> Vec<Cell> {
    let at = |threshold: &Option<Threshold>| match threshold {
        Some(t) if t.acceleration_g.is_finite() => significant(t.acceleration_g, DIGITS),
        Some(_) => "∞".to_owned(),
        None => "–".to_owned(),
    };
    let margin = significant(cut.gravity_margin, DIGITS);
    vec![
        above_words(&cut.above, language).into(),
        significant(cut.weight_n / 1e3, 4).into(),
        significant(cut.contact.moments().area_m2, DIGITS).into(),
        if cut.standing.stands() {
            margin.into()
        } else {
            Cell::bad(margin)
        },
        at(&cut.uplift).into(),
        at(&cut.sliding).into(),
    ]
}

/// The stack as given beside its variants.
fn variants(whole: &ProjectReport, own: &StackAnswer, language: Language) -> Markup {
    if whole.variants().is_empty() {
        return html! {};
    }
    let line = |name: String, answer: &StackAnswer| -> Vec<Cell> {
        let limits = &answer.check.limits;
        let at = |first: &Option<Governing>| {
            first.as_ref().map_or("–".to_owned(), |f| {
                significant(f.threshold.acceleration_g, DIGITS)
            })
        };
        let capacity = answer.check.capacity.as_ref();
        vec![
            name.into(),
            verdict_word(answer.check.verdict, language).into(),
            capacity
                .map_or("–".to_owned(), |c| significant(c.acceleration_g, DIGITS))
                .into(),
            limits
                .gravity_margin
                .map_or("–".to_owned(), |m| significant(m, DIGITS))
                .into(),
            at(&limits.uplift).into(),
            at(&limits.sliding).into(),
        ]
    };
    let mut rows = vec![line(language.pick("as given", "현재").to_owned(), own)];
    for variant in whole.variants() {
        if let Check::Stack(answer) = &variant.state.check {
            let title = match &variant.title {
                Some(names) => language.pick(names.english(), names.korean()),
                None => &variant.name,
            };
            rows.push(line(title.to_owned(), answer));
        }
    }
    let head: Vec<String> = [
        language.pick("Variant", "대안"),
        language.pick("verdict", "판정"),
        language.pick("moves first at (g)", "최초 거동 (g)"),
        language.pick("margin", "여유도"),
        language.pick("rocks at (g)", "로킹 (g)"),
        language.pick("slides at (g)", "미끄러짐 (g)"),
    ]
    .map(String::from)
    .to_vec();
    html! {
        h2 { (language.pick("Variants compared", "대안 비교")) }
        (table(language.pick("Variants. The same check on each.", "대안별 결과. 모두 같은 방법으로 검토하였다."), 2, &head, &rows))
    }
}
