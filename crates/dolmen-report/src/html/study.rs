//! Studies in the report: capacities by value of each input, trends, figures.

use super::fragility::fragility;
use super::table::{Cell, figure, table};
use crate::figures::study_figures;
use dolmen::assess::{Direction, Reached};
use dolmen_words::Language;
use dolmen_words::number::{counted, significant};
use dolmen_work::study::{
    CapacityOf, SCANS_OF_TAILS, ScanVerdict, StudyAnswer, StudyKind, TrendVerdict, input_words,
};
use maud::{Markup, html};

/// Figures of one study that a page takes; all of them lie in the folder of the study. Chosen here.
const FIGURES_MOST: usize = 8;

/// One section a study.
pub(super) fn sections(studies: &[&StudyAnswer], language: Language) -> Markup {
    html! {
        @for study in studies { (section(study, language)) }
    }
}

fn section(answer: &StudyAnswer, language: Language) -> Markup {
    let title = answer.study.title.as_ref();
    let title = title.map_or(answer.study.name.as_str(), |names| {
        language.pick(names.english(), names.korean())
    });
    let has_scan = answer.study.scan.is_some();
    html! {
        h2 { (language.pick("Study: ", "변수 연구: ")) (title) }
        @if has_scan {
            p { (what_was_run(answer, language)) }
            p { (answer.method(language)) "." }
            @if let Some((beyond, all, least)) = answer.beyond_room() {
                @let least = significant(least / answer.gravity_m_s2, 3);
                p { b { (language.pick(
                    format!("In {beyond} of {all} runs a damper needs more room than it has, from {least} g on: the runs do not have its stops, and are too good there."),
                    format!("{all}회 가운데 {beyond}회에서({least} g부터) 제진장치의 행정이 여유 공간을 넘는다. 해석에는 멈춤 장치가 없어 그 결과는 실제보다 유리하다."),
                )) } }
            }
            @if !answer.missing.is_empty() { p { b { (unfinished(answer, language)) } } }
            (capacities(answer, language))
            (left_out(answer, language))
            (trends(answer, language))
            (fragility(answer, language))
        }
        @for found in study_figures(answer, language).into_iter().take(FIGURES_MOST) {
            (figure(&found.svg, &caption(&found.name, language)))
        }
    }
}

fn what_was_run(answer: &StudyAnswer, language: Language) -> String {
    let (cases, motions, runs) = (answer.cases.len(), answer.motions.len(), answer.runs.len());
    let capacities = answer.capacities();
    let count = |wanted: fn(&&CapacityOf) -> bool| capacities.iter().filter(wanted).count();
    let scans = count(|scan| scan.verdict.is_usable());
    let refused = count(|scan| scan.verdict == ScanVerdict::Refused);
    let above = count(|scan| scan.verdict.is_usable() && !scan.survived_above_m_s2().is_empty());
    let run = language.pick(
        format!(
            "{} of {} under {}, each at growing shaking; the inputs of {} refused.",
            counted(runs, "simulation", "simulations"),
            counted(cases, "case", "cases"),
            counted(motions, "motion", "motions"),
            counted(refused, "scan were", "scans were")
        ),
        format!(
            "경우 {cases}개와 지진파 {motions}개에 대해 지진동을 키워 가며 모두 {runs}회 해석하였고, 입력이 허용되지 않은 해석은 {refused}조이다."
        ),
    );
    if above == 0 {
        return run;
    }
    let survived = language.pick(
        format!(
            "{above} of {scans} scans survived a size of shaking above their first failure: one critical acceleration says little."
        ),
        format!(
            "해석 {scans}조 가운데 {above}조는 처음 무너진 크기보다 더 큰 지진동을 견뎠으므로, 임계가속도 하나로는 판단할 수 없다."
        ),
    );
    format!("{run} {survived}")
}

/// Scans that are in no quantile and no trend; nothing if there are none.
fn left_out(answer: &StudyAnswer, language: Language) -> Markup {
    let (out, jobs) = (answer.left_out(), answer.jobs());
    let words = language.pick(
        format!(
            "{out} of {jobs} scans cannot be used and are in no quantile and no trend: runs below their first fall were refused, gave no \
             result or are missing. Their brackets are in capacities.csv."
        ),
        format!(
            "해석 {jobs}조 가운데 {out}조는 최초 낙하보다 작은 지진동에서 결과를 얻지 못하여 사용할 수 없으며, 분위수와 경향에서 제외하였다. 범위는 \
             capacities.csv에 있다."
        ),
    );
    html! { @if out > 0 { p { b { (words) } } } }
}

fn unfinished(answer: &StudyAnswer, language: Language) -> String {
    let (missing, jobs) = (answer.missing.len(), answer.jobs());
    language.pick(
        format!("Not finished: {missing} of {jobs} scans are missing."),
        format!("미완료: 해석 {jobs}조 가운데 {missing}조가 빠져 있다."),
    )
}

fn capacities(answer: &StudyAnswer, language: Language) -> Markup {
    let in_g = |value: Option<Reached>| match value {
        Some(Reached::At(value)) => format!("{:.3}", value / answer.gravity_m_s2),
        Some(Reached::Above(value)) => format!("> {:.3}", value / answer.gravity_m_s2),
        None => "–".to_owned(),
    };
    let head = [
        language.pick("input", "입력변수"),
        language.pick("value", "값"),
        language.pick("scans", "해석 조"),
        language.pick("fell", "낙하"),
        language.pick("least (g)", "최소 (g)"),
        "5 % (g)",
        language.pick("median (g)", "중앙값 (g)"),
        "95 % (g)",
        language.pick("survived above", "상위 생존"),
    ]
    .map(str::to_owned);
    let rows: Vec<Vec<Cell>> = answer
        .levels()
        .into_iter()
        .map(|row| {
            let quantile = |p| in_g(row.quantile_m_s2(3, p));
            let (usable, all) = (row.usable(), row.scans.len());
            let least = match usable {
                0 => language.pick("unusable", "사용 불가").to_owned(),
                _ => in_g(row.least_m_s2()),
            };
            let input = match row.input {
                Some(input) => input_words(&answer.inputs[input].path, language),
                None if answer.study.variants.len() > 1 => language.pick("variant", "대안").to_owned(),
                None => String::new(),
            };
            vec![
                input.into(),
                Cell::wrapping(row.shown(language).to_owned()),
                language
                    .pick(format!("{usable} of {all}"), format!("{usable}/{all}"))
                    .into(),
                row.fell().to_string().into(),
                least.into(),
                quantile(0.05).into(),
                quantile(0.5).into(),
                quantile(0.95).into(),
                row.survived_above().to_string().into(),
            ]
        })
        .collect();
    let what = match answer.kind {
        StudyKind::Stack => language.pick(
            "Peak acceleration of the ground at which a stone first falls.",
            "돌이 처음 떨어지는 최대지반가속도.",
        ),
        StudyKind::Chain => language.pick(
            "Peak acceleration of the ground at which the chain first falls.",
            "처음 전도되는 최대지반가속도.",
        ),
        StudyKind::Frame => language.pick(
            "Peak acceleration of the ground at which a storey first leans by more than 10 %.",
            "층간변위가 처음 층고의 10 %를 넘는 최대지반가속도.",
        ),
        StudyKind::Building => language.pick(
            "Peak acceleration of the ground at which a storey first drifts beyond the last limit.",
            "층간변위가 처음 마지막 한계를 넘는 최대지반가속도.",
        ),
    };
    let how = language.pick(
        format!("“>”: not up to the largest that was tried. 5 % and 95 % are said of {SCANS_OF_TAILS} scans and more."),
        format!("‘>’는 시도한 최대 크기까지 일어나지 않은 경우이다. 5 %와 95 %는 해석 {SCANS_OF_TAILS}조 이상에서만 제시한다."),
    );
    let caption = format!("{what} {how}");
    table(&caption, 2, &head, &rows)
}

fn trends(answer: &StudyAnswer, language: Language) -> Markup {
    let found = answer.trends().unwrap_or_default();
    let rows: Vec<Vec<Cell>> = found
        .iter()
        .filter(|trend| trend.of_medians.pairs > 0)
        .map(|trend| {
            let tau = &trend.of_medians;
            let (words, verdict) = match &trend.expected {
                Some((expected, verdict)) => {
                    let words = expected
                        .words
                        .as_ref()
                        .map(|names| language.pick(names.english(), names.korean()));
                    (words.unwrap_or_default(), verdict_word(*verdict, language))
                }
                None if tau.direction() == Some(Direction::Rising) => ("", language.pick("rises", "증가")),
                None if tau.direction() == Some(Direction::Falling) => ("", language.pick("falls", "감소")),
                None => ("", language.pick("no trend seen", "경향 없음")),
            };
            vec![
                input_words(&answer.inputs[trend.input].path, language).into(),
                Cell::wrapping(words),
                verdict.into(),
                format!("{:+.2}", tau.tau).into(),
                format!("± {:.2}", tau.tau_by_chance).into(),
                tau.pairs.to_string().into(),
            ]
        })
        .collect();
    let head = [
        language.pick("input", "입력변수"),
        language.pick("expected", "예상"),
        language.pick("verdict", "판정"),
        "τ",
        language.pick("by chance", "우연"),
        language.pick("pairs", "쌍"),
    ]
    .map(str::to_owned);
    html! {
        @if !rows.is_empty() {
            (table(language.pick(
                "Trends of the capacity, all else equal. Kendall's rank correlation of the medians, and what chance alone would give.",
                "다른 조건이 같을 때 내진성능의 경향. 중앙값의 켄달 순위상관계수와 우연에 의한 크기.",
            ), 3, &head, &rows))
        }
    }
}

fn verdict_word(verdict: TrendVerdict, language: Language) -> &'static str {
    match verdict {
        TrendVerdict::Holds => language.pick("holds", "성립"),
        TrendVerdict::NotSeen => language.pick("not seen", "확인 안 됨"),
        TrendVerdict::Contradicted => language.pick("contradicted", "반대"),
    }
}

fn caption(name: &str, language: Language) -> String {
    let text = match name.split('-').next().unwrap_or_default() {
        "capacity" => language.pick(
            "Capacity against an input. Every dot one scan; medians and the range of 5 to 95 %.",
            "입력변수에 따른 내진성능. 점은 해석 1조이며, 중앙값과 5–95 % 범위를 함께 표시하였다.",
        ),
        "survived" => language.pick(
            "What failed and what survived. Every dot one simulation; survived sizes can lie above ones that were not.",
            "무너진 경우와 견딘 경우. 점은 해석 1회이며, 무너진 크기보다 큰 지진동을 견디기도 한다.",
        ),
        "fragility" => language.pick(
            "Fragility. The probability that a state is reached, by the peak of the ground; bands of resampled motions.",
            "취약도. 최대지반가속도에 따른 손상 상태 도달 확률과 지진동 재표집에 따른 범위.",
        ),
        "growth" => language.pick("As the shaking grows. Largest over the storeys, or links and joints.", "지진동 증가에 따른 변화. 층(또는 부재·접합면) 중 최댓값."),
        "harmonic" => language.pick(
            "Rest and motion. Share of the time in which a storey slips, or a joint opens or slips, under a harmonic ground.",
            "고착과 움직임. 조화 지반운동에서 층이 미끄러지거나 접합면이 벌어지는 시간의 비율.",
        ),
        _ => language.pick(
            "Let go from a large displacement. Each dot one swing.",
            "큰 변위에서의 자유진동. 점은 반주기 1회.",
        ),
    };
    text.to_owned()
}
