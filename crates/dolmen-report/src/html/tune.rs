//! Dampers in the report: what each choice of place and tuning does, the map, tunings with their names, robustness.

use super::finding::{Finding, Tone};
use super::table::{Cell, figure, table};
use crate::figures::tune_figures;
use crate::text::{choice_words, findings as sentences, room_words, together_words};
use dolmen::damper::{Aim, Choice, DesignEnd, TuningRule};
use dolmen_words::Language;
use dolmen_words::number::significant;
use dolmen_work::building::{RoomCheck, TogetherAnswer, TogetherChoice, TuneAnswer, direction_words};
use maud::{Markup, html};

/// What is worse than no damper, and what the best brings.
pub(super) fn findings(answers: &[&TuneAnswer], language: Language) -> Vec<Finding> {
    let mut all = Vec::new();
    for answer in answers {
        let worse = answer.comparison.row(Choice::Given).map(|row| answer.worse(row));
        if let Some(points) = worse.filter(|points| !points.is_empty()) {
            let words: Vec<String> = points
                .iter()
                .map(|(point, ratio)| format!("{} {ratio:.3}", point.name))
                .collect();
            let list = words.join(", ");
            all.push(Finding::new(
                Tone::Bad,
                language.pick(
                    format!(
                        "Damper {} makes points worse than no damper: {list} of the motion without it.",
                        answer.damper
                    ),
                    format!(
                        "제진장치 {}는 비제어보다 응답을 키운다: 비제어 대비 {list}.",
                        answer.damper
                    ),
                ),
            ));
        }
        all.extend(beyond_room(&answer.room, language, |row| {
            let row = answer.comparison.rows.get(row);
            row.is_some_and(|row| row.choice == Choice::Given)
        }));
        let ratio = |choice| {
            answer
                .comparison
                .row(choice)
                .map(|row| row.cost / answer.comparison.cost_without)
        };
        if let (Some(given), Some(best), Some(rule)) =
            (ratio(Choice::Given), ratio(Choice::Best), ratio(Choice::Rule))
        {
            all.push(Finding::new(
                Tone::Plain,
                language.pick(
                    format!(
                        "Damper {}: {given:.3} of the motion without it as in the file, {rule:.3} at the place of the rule, {best:.3} placed and tuned best.",
                        answer.damper
                    ),
                    format!(
                        "제진장치 {}: 비제어 대비 입력 상태 {given:.3}, 논문의 규칙에 따른 위치 {rule:.3}, 최적 위치와 동조 {best:.3}.",
                        answer.damper
                    ),
                ),
            ));
        }
    }
    all
}

/// Dampers as in the file that need more room than they have.
fn beyond_room(room: &RoomCheck, language: Language, is_given: impl Fn(usize) -> bool) -> Vec<Finding> {
    let beyond = room.beyond().filter(|of| is_given(of.row));
    let mut all: Vec<Finding> = beyond
        .map(|of| {
            let (needed, has) = (
                significant(1e3 * of.stroke_m, 4),
                significant(1e3 * of.room_m, 4),
            );
            Finding::new(
                Tone::Bad,
                language.pick(
                    format!("Damper {} is beyond its room under {}: it needs {needed}\u{202f}mm each way and has {has}\u{202f}mm.", of.damper, of.under(language)),
                    format!("제진장치 {}의 행정 {needed}\u{202f}mm가 여유 {has}\u{202f}mm를 넘는다({}).", of.damper, of.under(language)),
                ),
            )
        })
        .collect();
    if room.is_unjudged() {
        all.push(Finding::new(
            Tone::Unknown,
            language.pick(
                "The room of a damper is given, and the file has no motion or site to hold it against.",
                "제진장치의 여유 공간은 주어졌으나 비교할 지진동이나 부지 스펙트럼이 없다.",
            ),
        ));
    }
    all
}

/// What all dampers together need beyond their room.
pub(super) fn findings_together(answers: &[&TogetherAnswer], language: Language) -> Vec<Finding> {
    let each = answers.iter().map(|answer| {
        beyond_room(&answer.room, language, |row| {
            let row = answer.rows.get(row);
            row.is_some_and(|row| row.choice == TogetherChoice::Given)
        })
    });
    each.flatten().collect()
}

/// One section a damper.
pub(super) fn sections(answers: &[&TuneAnswer], language: Language) -> Markup {
    html! { @for answer in answers { (section(answer, language)) } }
}

fn section(answer: &TuneAnswer, language: Language) -> Markup {
    html! {
        h2 { (language.pick("Damper: ", "제진장치: ")) (answer.damper) }
        p { (lead(answer, language)) }
        (choices(answer, language))
        @for found in tune_figures(answer, language) {
            (figure(&found.svg, caption(&found.name, language)))
        }
        (tunings(answer, language))
        div.note {
            @if language == Language::English {
                @for sentence in sentences(answer) { p { (sentence) "." } }
                @for sentence in room_words(&answer.room, |row| row_words(answer, row, language)) { p { (sentence) "." } }
            } @else {
                @for sentence in korean_sentences(answer) { p { (sentence) } }
                @for of in answer.room.beyond() {
                    p { "여유 초과: " (row_words(answer, of.row, language)) "의 경우 " (of.under(language)) "에서 행정 "
                        (significant(1e3 * of.stroke_m, 4)) " mm, 여유 " (significant(1e3 * of.room_m, 4)) " mm." }
                }
            }
            p { (language.pick(
                "The rule of Hwang, Min & Hong puts a damper as far from the centre of the mode as the floor allows. It makes the damper work more on that mode, not the points move less. Their eq. 5a gives a damper along x the sign +Y; by their own eq. 12 it is −Y, which is used here.",
                "황재승·민경원·홍성목의 규칙은 제진장치를 모드 중심에서 가장 먼 곳에 둔다. 이는 해당 모드에 대한 제어 효과를 키울 뿐이며 관측점의 응답을 최소로 하지는 않는다. 논문의 식 (5a)는 X방향 제진장치에 +Y를 쓰지만 식 (12)와 맞추면 −Y가 옳으며 여기서는 −Y를 쓴다.",
            )) }
        }
    }
}

/// A row of the comparison in words.
fn row_words(answer: &TuneAnswer, row: usize, language: Language) -> String {
    let row = answer.comparison.rows.get(row);
    row.map_or(String::new(), |row| choice(row.choice, answer.mode, language))
}

fn lead(answer: &TuneAnswer, language: Language) -> String {
    let comparison = &answer.comparison;
    let direction = direction_words(answer.direction_degrees);
    language.pick(
        format!(
            "Mode {} at {:.4} Hz; modal mass {:.1} kg at the damper, mass ratio {:.4}. Load: {}. Motion along {direction}.",
            answer.mode,
            answer.mode_frequency_hz,
            comparison.modal_mass_kg,
            comparison.mass_ratio,
            answer.load.english()
        ),
        format!(
            "{}차 모드 {:.4} Hz, 제진장치 위치의 모드질량 {:.1} kg, 질량비 {:.4}. 하중: {}. 응답 방향 {direction}.",
            answer.mode,
            answer.mode_frequency_hz,
            comparison.modal_mass_kg,
            comparison.mass_ratio,
            answer.load.korean()
        ),
    )
}

fn choice(choice: Choice, mode: usize, language: Language) -> String {
    let korean = match choice {
        Choice::Given => "입력 상태".to_owned(),
        Choice::Rule => format!("규칙: {mode}차 모드 중심에서 가장 먼 곳"),
        Choice::TunedBest => "입력 위치, 최적 동조".to_owned(),
        Choice::PlacedBest => "최적 위치, 입력한 동조".to_owned(),
        Choice::Best => "최적 위치와 동조".to_owned(),
    };
    language.pick(choice_words(choice, mode), korean)
}

fn choices(answer: &TuneAnswer, language: Language) -> Markup {
    let mut head = vec![
        language.pick("Damper", "제진장치").to_owned(),
        "x (m)".to_owned(),
        "y (m)".to_owned(),
        language.pick("frequency (Hz)", "진동수 (Hz)").to_owned(),
        language.pick("damping ratio", "감쇠비").to_owned(),
    ];
    head.extend(answer.points.iter().map(|point| point.name.clone()));
    head.push(language.pick("goal", "목표값").to_owned());
    head.push(language.pick("stroke", "행정").to_owned());
    let given_stroke = answer
        .comparison
        .row(Choice::Given)
        .map_or(f64::NAN, |row| row.judged.stroke_rms_m[0]);
    let rows: Vec<Vec<Cell>> = answer
        .comparison
        .rows
        .iter()
        .map(|row| {
            let mut cells: Vec<Cell> = vec![
                choice(row.choice, answer.mode, language).into(),
                format!("{:.3}", row.damper.place_m[0] + 0.0).into(),
                format!("{:.3}", row.damper.place_m[1] + 0.0).into(),
                format!("{:.5}", row.damper.frequency_hz).into(),
                format!("{:.5}", row.damper.damping_ratio).into(),
            ];
            cells.extend(answer.ratios(row).into_iter().map(|ratio| match ratio > 1.0 {
                true => Cell::bad(format!("{ratio:.4}")),
                false => format!("{ratio:.4}").into(),
            }));
            cells.push(format!("{:.4}", row.cost / answer.comparison.cost_without).into());
            cells.push(format!("{:.3}", row.judged.stroke_rms_m[0] / given_stroke).into());
            cells
        })
        .collect();
    table(
        language.pick(
            "What each choice of place and tuning does. Standard deviations over those without a damper; the stroke over that of the damper as in the file.",
            "위치와 동조에 따른 제어 효과. 비제어 대비 표준편차의 비이며 행정은 입력한 제진장치에 대한 비이다.",
        ),
        1,
        &head,
        &rows,
    )
}

fn korean_sentences(answer: &TuneAnswer) -> Vec<String> {
    let mut all = Vec::new();
    for row in &answer.comparison.rows {
        for (point, ratio) in answer.worse(row) {
            all.push(format!(
                "비제어보다 나쁨: {}의 경우 {}의 응답이 비제어의 {ratio:.4}배이다.",
                choice(row.choice, answer.mode, Language::Korean),
                point.name
            ));
        }
        if row.end == Some(DesignEnd::Limit) {
            all.push(format!(
                "‘{}’은 제진장치 감쇠 또는 진동수의 한계값에 있다.",
                choice(row.choice, answer.mode, Language::Korean)
            ));
        }
    }
    let of = |choice| answer.costs(choice, Choice::Best).unwrap_or(f64::NAN) * 100.0;
    all.push(format!(
        "규칙에 따른 위치의 목표값은 최적보다 {:.1} %, 입력 상태는 {:.1} % 크다.",
        of(Choice::Rule),
        of(Choice::Given)
    ));
    all
}

fn aim(rule: Option<TuningRule>, exact: Option<Aim>, language: Language) -> String {
    let korean = match (rule, exact) {
        (Some(TuningRule::DenHartog), _) => "조화하중 변위의 고정점",
        (Some(TuningRule::NishiharaAsami), _) => "조화하중 최대 변위, 엄밀해",
        (Some(TuningRule::WarburtonForce), _) => "백색잡음 하중의 변위 분산",
        (Some(TuningRule::WarburtonBase), _) => "백색잡음 지반가속도의 변위 분산",
        (Some(TuningRule::WarburtonBaseHarmonic), _) => "조화 지반가속도 변위의 고정점",
        (Some(TuningRule::Sadek), _) => "두 모드의 감쇠를 같게",
        (Some(TuningRule::Villaverde), _) => "두 모드의 평균 감쇠",
        (Some(TuningRule::HwangMinHongLiteral), _) => "논문의 값을 제진장치 진동수 기준으로",
        (None, Some(Aim::ForceRandom)) => "모드 감쇠 포함 엄밀해: 하중, 분산",
        (None, Some(Aim::ForceHarmonic)) => "모드 감쇠 포함 엄밀해: 하중, 최대",
        (None, Some(Aim::BaseRandom)) => "모드 감쇠 포함 엄밀해: 지반, 분산",
        (None, Some(Aim::BaseHarmonic)) => "모드 감쇠 포함 엄밀해: 지반, 최대",
        (None, None) => "",
    };
    let english = match (rule, exact) {
        (Some(rule), _) => rule.aim().to_owned(),
        (None, Some(exact)) => format!("{}, with the mode's damping", exact.name().replace('_', ", ")),
        (None, None) => String::new(),
    };
    language.pick(english, korean.to_owned())
}

fn tunings(answer: &TuneAnswer, language: Language) -> Markup {
    let head: Vec<String> = [
        language.pick("Tuning", "동조식"),
        language.pick("made for", "목적"),
        language.pick("f / f of the mode", "진동수비"),
        "c/(2mω)",
        "c/(2mΩ)",
        language.pick("goal", "목표값"),
    ]
    .map(String::from)
    .to_vec();
    let rows: Vec<Vec<Cell>> = answer
        .comparison
        .tunings
        .iter()
        .map(|row| {
            let source = row
                .rule
                .map_or(language.pick("exact", "엄밀해"), TuningRule::source);
            vec![
                source.into(),
                Cell::wrapping(aim(row.rule, row.aim, language)),
                format!("{:.6}", row.tuning.frequency_ratio).into(),
                format!("{:.6}", row.tuning.damping_ratio).into(),
                format!("{:.6}", row.tuning.damping_ratio_on_structure()).into(),
                format!("{:.4}", row.cost / answer.comparison.cost_without).into(),
            ]
        })
        .collect();
    table(
        language.pick(
            "Tunings of the mode, the damper where it is. ω is the damper's own frequency, Ω that of the mode: authors divide by one or the other.",
            "제진장치 위치를 유지한 동조식 비교. ω는 제진장치, Ω는 모드의 진동수이며 저자마다 나누는 값이 다르다.",
        ),
        2,
        &head,
        &rows,
    )
}

fn caption(name: &str, language: Language) -> &'static str {
    match name {
        "position" => language.pick(
            "Motion of the points against the place of the damper. As Figure 5 of Hwang, Min & Hong, tuned as in the file and tuned anew at each place.",
            "제진장치 위치에 따른 관측점의 RMS. 논문의 그림 5에 해당하며 입력한 동조와 위치마다 새로 동조한 경우이다.",
        ),
        "plan" => language.pick(
            "The goal for each place of the damper, tuned best there. Lighter is better; crosses are the points.",
            "위치마다 최적 동조한 경우의 목표값. 밝을수록 좋으며 ×는 관측점이다.",
        ),
        _ => language.pick(
            "What being out of tune costs. Frequency and damping of the damper off by so much.",
            "동조 오차의 영향. 제진장치의 진동수와 감쇠가 어긋난 경우이다.",
        ),
    }
}

/// All dampers of a version at once.
pub(super) fn together(answers: &[&TogetherAnswer], language: Language) -> Markup {
    html! { @for answer in answers { (all_of(answer, language)) } }
}

fn all_of(answer: &TogetherAnswer, language: Language) -> Markup {
    let mut head = vec![language.pick("Dampers", "제진장치").to_owned()];
    for (point, degrees) in &answer.points {
        head.push(format!("{} ({})", point.name, direction_words(*degrees)));
    }
    head.push(language.pick("goal", "목표값").to_owned());
    let rows: Vec<Vec<Cell>> = answer
        .rows
        .iter()
        .map(|row| {
            let mut cells: Vec<Cell> = vec![together_cell(&row.choice, language).into()];
            cells.extend(answer.ratios(row).into_iter().map(|ratio| {
                let text = format!("{ratio:.3}");
                if ratio > 1.0 + 1e-12 {
                    Cell::bad(text)
                } else {
                    text.into()
                }
            }));
            cells.push(format!("{:.3}", answer.cost_ratio(row)).into());
            cells
        })
        .collect();
    let caption = language.pick(
        "Motion of the points over that without dampers, with all of them at once, with each alone, and designed together.",
        "제진장치 전체, 개별, 동시 설계에 대한 관측점 응답의 비제어 대비 비.",
    );
    html! {
        h2 {
            (language.pick("All dampers together", "제진장치 전체"))
            @if let Some(variant) = &answer.variant { ": " (variant) }
        }
        (table(caption, 1, &head, &rows))
    }
}

fn together_cell(choice: &TogetherChoice, language: Language) -> String {
    let korean = match choice {
        TogetherChoice::Without => "없음".to_owned(),
        TogetherChoice::Given => "입력한 전체".to_owned(),
        TogetherChoice::Only(name) => format!("{name}만"),
        TogetherChoice::AllBut(name) => format!("{name} 제외"),
        TogetherChoice::TunedBest => "위치 유지, 동시 최적 동조".to_owned(),
        TogetherChoice::Best => "위치와 동조 동시 최적".to_owned(),
        TogetherChoice::BestShared => "위치, 동조와 질량 배분 최적".to_owned(),
    };
    language.pick(together_words(choice), korean)
}
