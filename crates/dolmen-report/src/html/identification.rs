//! What was found from measured vibration: stiffness with all its solutions, and what the sensors cannot see.

use super::finding::{Finding, Tone};
use super::notes::stiffness_note_words;
use super::record_words::sentence;
use super::table::{Cell, figure, table};
use super::words::{convention_word, listed};
use crate::figures::{letter, measured_modes, solution_shapes};
use crate::text::bounds_words;
use dolmen::structure::{Choice, MeasuredMode, StiffnessSolution, Visibility};
use dolmen_project::{Project, Structure};
use dolmen_words::Language;
use dolmen_words::number::{self, beside_one, counted, prefix, significant, significant_beside};
use dolmen_work::surveyed::{StiffnessAnswer, SurveyAnswer, WithoutStiffness};
use maud::{Markup, html};

/// Solutions drawn and listed; the rest are counted.
const SOLUTIONS_SHOWN: usize = 8;

/// A stiffness of which the data determine less than this share is called unseen.
const SEEN_LEAST: f64 = 0.5;

pub(super) fn findings(all: &[SurveyAnswer], language: Language) -> Vec<Finding> {
    let unsought = all.iter().filter_map(|i| i.without_stiffness.as_ref());
    let unsought = unsought.map(|why| Finding::new(Tone::Warn, without_words(why, language)));
    all.iter()
        .flat_map(|i| &i.stiffness)
        .map(|answer| choice(answer, language))
        .chain(unsought)
        .collect()
}

/// Why no stiffness is sought.
fn without_words(why: &WithoutStiffness, language: Language) -> String {
    let korean = match why {
        WithoutStiffness::NoPlace => {
            "위치와 방향이 모두 주어진 채널이 없어 강성을 추정하지 않았다. 구조물 위의 채널에 둘 다 주어야 한다."
                .to_owned()
        }
        WithoutStiffness::OffTheAxes { channels } => format!(
            "x 또는 y축에서 15° 이내를 향하는 센서가 없어({}) 강성을 추정하지 않았다. 프로젝트의 축을 센서에 맞추어 돌리거나 각 센서의 계측 방향을 주어야 한다.",
            channels.join(", ")
        ),
    };
    language.pick(sentence(&why.to_string()), korean)
}

/// Direction and convention, for a head or the start of a sentence.
fn place(answer: &StiffnessAnswer, language: Language) -> String {
    let direction = language.pick(
        format!("direction {}", answer.direction),
        format!("{} 방향", answer.direction),
    );
    match answer.convention {
        None => direction,
        Some(convention) => format!("{direction}, {}", convention_word(convention, language)),
    }
}

fn choice(answer: &StiffnessAnswer, language: Language) -> Finding {
    let place = place(answer, language);
    let count = answer.solutions.solutions.len();
    let modes = answer.frequencies_hz.len();
    let with_shapes = if answer.with_shapes {
        language.pick(" and the measured shapes", "와 계측 모드형상")
    } else {
        ""
    };
    let head = language.pick(
        format!("Stiffness from vibration ({place}): "),
        format!("진동으로 추정한 강성({place}): "),
    );
    if !answer.peaks_below_hz.is_empty() {
        let peaks: Vec<String> = answer
            .peaks_below_hz
            .iter()
            .map(|hz| format!("{hz:.3}"))
            .collect();
        let peaks = peaks.join(", ");
        return Finding::new(
            Tone::Warn,
            head + &language.pick(
                format!("not chosen: the record has a peak at {peaks}\u{202f}Hz below the modes used that is none of them. If it is a mode of this direction, every stiffness is wrong."),
                format!("판정하지 않는다. 사용한 모드 아래 {peaks}\u{202f}Hz에 모드로 찾지 않은 봉우리가 있으며, 이것이 이 방향의 모드이면 모든 강성이 틀리게 된다."),
            ),
        );
    }
    match answer.solutions.choice {
        Choice::One => Finding::new(
            Tone::Good,
            head + &language.pick(
                format!("one solution explains the {modes} frequencies{with_shapes}."),
                format!("고유진동수 {modes}개{with_shapes}를 설명하는 해는 하나이다."),
            ),
        ),
        Choice::Bounded => Finding::new(
            Tone::Warn,
            head + &language.pick(
                format!("one solution explains the {modes} frequencies{with_shapes}, but some of its stiffness is known only between bounds or from one side: no single answer."),
                format!("고유진동수 {modes}개{with_shapes}를 설명하는 해는 하나이나, 일부 강성은 한쪽 한계나 넓은 범위로만 정해지므로 단일한 답이 아니다."),
            ),
        ),
        Choice::Indistinguishable if answer.solutions.solutions.len() == 1 => Finding::new(
            Tone::Warn,
            head + language.pick(
                "two solutions meet here and cannot be told apart without a measured shape; none is preferred here.",
                "두 해가 여기서 만나므로 계측 모드형상 없이는 구별할 수 없으며, 여기서는 어느 것도 택하지 않는다.",
            ),
        ),
        Choice::Indistinguishable => Finding::new(
            Tone::Warn,
            head + &language.pick(
                format!("{count} different solutions explain the {modes} measured frequencies equally well. They cannot be told apart without a measured shape; none is preferred here."),
                format!("서로 다른 해 {count}개가 계측 고유진동수 {modes}개를 똑같이 잘 설명한다. 계측 모드형상 없이는 구별할 수 없으며, 여기서는 어느 것도 택하지 않는다."),
            ),
        ),
        Choice::Underdetermined => {
            let free = answer.solutions.visibility.as_ref().map(|v| v.free_directions);
            let free = free.map_or(language.pick("some", "일부").to_string(), |f| f.to_string());
            Finding::new(
                Tone::Warn,
                head + &language.pick(
                    format!("not determined. Measured modes: {modes}; directions of the stiffness that stay free: {free}; any solution shown is one point of a continuous family."),
                    format!("정해지지 않는다. 계측 모드 {modes}개로는 강성의 방향 {free}개가 자유로우며, 제시된 해는 연속적인 해집합의 일부이다."),
                ),
            )
        }
        Choice::Impossible => {
            let why: Vec<String> = answer.solutions.notes.iter().map(|note| stiffness_note_words(note, language)).collect();
            let why = why.join(" ");
            Finding::new(
                Tone::Bad,
                head + &language.pick(
                    format!("no real stiffness explains the {modes} measured modes. {why}"),
                    format!("계측 모드 {modes}개를 설명하는 실수 강성이 없다. {why}"),
                ),
            )
        }
    }
}

/// The section on stiffness from vibration.
pub(super) fn section(project: &Project, all: &[SurveyAnswer], language: Language) -> Markup {
    if all.iter().all(|i| i.stiffness.is_empty()) {
        return html! {};
    }
    html! {
        h2 { (language.pick("Stiffness from measured vibration", "계측 진동으로부터 추정한 강성")) }
        @for identification in all {
            @for answer in &identification.stiffness {
                h3 { (language.pick("Survey", "조사")) " " (identification.name) ", " (place(answer, language)) }
                @let measured = measured_modes(project, &identification.name, answer);
                (measured_words(answer, &measured, language))
                @if answer.solutions.solutions.is_empty() {
                    p { (language.pick("No stiffness explains these modes.", "이 모드를 설명하는 강성이 없다.")) }
                } @else {
                    (solutions(project, answer, &measured, language))
                }
                @if let Some(visibility) = &answer.solutions.visibility { (seen(visibility, language)) }
                @for note in &answer.solutions.notes { p.note { (stiffness_note_words(note, language)) } }
            }
        }
    }
}

fn measured_words(answer: &StiffnessAnswer, measured: &[MeasuredMode], language: Language) -> Markup {
    let texts: Vec<String> = measured
        .iter()
        .map(|mode| {
            let shape = if mode.shape.is_empty() && answer.with_shapes {
                String::new()
            } else if mode.shape.is_empty() {
                language.pick(" (no shape)", " (모드형상 없음)").into()
            } else {
                let points = mode.shape.len();
                language.pick(
                    format!(" ({} of its shape)", counted(points, "point", "points")),
                    format!(" (측점 {points}개의 모드형상)"),
                )
            };
            let frequency = number::with_sd(mode.frequency_hz, mode.frequency_sd_hz);
            format!("{frequency}\u{202f}Hz{shape}")
        })
        .collect();
    html! { p { (language.pick("Measured: ", "계측값: ")) (listed(&texts, language)) "." } }
}

fn solutions(
    project: &Project,
    answer: &StiffnessAnswer,
    measured: &[MeasuredMode],
    language: Language,
) -> Markup {
    let shown = &answer.solutions.solutions[..answer.solutions.solutions.len().min(SOLUTIONS_SHOWN)];
    let (unit_si, part) = match project.structure {
        Structure::Chain(_) => ("N·m/rad", language.pick("joint", "접합면")),
        _ => ("N/m", language.pick("storey", "층")),
    };
    let all: Vec<f64> = shown
        .iter()
        .flat_map(|s| s.stiffness_least().unwrap_or_else(|| s.stiffness.clone()))
        .collect();
    // One prefix for stiffnesses that may lie decades apart: that of their geometric mean.
    let logarithms = all.iter().filter(|k| **k > 0.0).map(|k| k.ln());
    let (count, sum) = logarithms.fold((0.0, 0.0), |(n, s), l| (n + 1.0, s + l));
    let unit = prefix(&[if count > 0.0 { f64::exp(sum / count) } else { 0.0 }], unit_si);
    let count = shown.iter().map(|s| s.stiffness.len()).max().unwrap_or(0);
    let mut head = vec![language.pick("Solution", "해").to_string(), "λ".to_string()];
    head.extend((1..=count).map(|i| format!("k{} {part} {i} ({})", number::subscript(i), unit.unit)));
    head.push(language.pick("misfit", "오차").into());
    head.push(language.pick("frequencies (Hz)", "고유진동수 (Hz)").into());
    let rows: Vec<Vec<Cell>> = shown
        .iter()
        .enumerate()
        .map(|(i, s)| solution_row(i, s, answer, &unit, language))
        .collect();
    let total = answer.solutions.solutions.len();
    let starts = answer.solutions.starts;
    let caption = language.pick(
        format!("Solutions, {} of {total} found. Starting points tried: {starts}; misfit is the root mean square deviation in units of the standard deviation, relative where none is given; in brackets the range while every frequency moves by √3 of its standard deviation; above, below, to: what the data allow (95 %), with λ of the lowest that they allow.", shown.len()),
        format!("해 {total}개 중 {}개. 시작점 {starts}개; 오차는 표준편차 단위의 평균제곱근이며, 표준편차가 없으면 상대값이다; 대괄호는 각 진동수가 표준편차의 √3배만큼 변할 때의 범위; 이상, 이하, ~는 자료가 허용하는 한계(95 %)이며 λ는 그 최소 강성의 값이다.", shown.len()),
    );
    html! {
        (table(&caption, 2, &head, &rows))
        @if let Some(svg) = solution_shapes(&project.structure, answer, measured, language) {
            (figure(&svg, &shapes_caption(answer, language)))
        }
    }
}

/// Digits of a stiffness without a deviation: fewer where it is one of a family.
fn digits_of(choice: Choice) -> usize {
    if choice == Choice::Underdetermined { 3 } else { 4 }
}

fn solution_row(
    index: usize,
    solution: &StiffnessSolution,
    answer: &StiffnessAnswer,
    unit: &number::Prefixed,
    language: Language,
) -> Vec<Cell> {
    let digits = digits_of(answer.solutions.choice);
    let stands = match answer.load_factors.get(index).copied().flatten() {
        Some(factor) if factor <= 1.0 && solution.stiffness_bounds.is_none() => {
            Cell::bad(beside_one(factor, 4))
        }
        Some(factor) => beside_one(factor, 4).into(),
        None => "–".into(),
    };
    let mut row: Vec<Cell> = vec![letter(index).into(), stands];
    for (i, k) in solution.stiffness.iter().enumerate() {
        if let Some(bound) = solution
            .stiffness_bounds
            .as_ref()
            .and_then(|bounds| bounds.get(i))
        {
            row.push(bounds_words(bound, unit, language).into());
            continue;
        }
        let sd = solution.stiffness_sd.as_ref().and_then(|sd| sd.get(i));
        let mut text = match sd {
            Some(sd) => unit.number_with_sd(*k, *sd),
            None => unit.number(*k, digits),
        };
        let range = solution
            .stiffness_range
            .as_ref()
            .and_then(|r| Some((*r.lower.get(i)?, *r.upper.get(i)?)));
        if let Some((lower, upper)) = range {
            text.push_str(&format!(
                " [{}; {}]",
                unit.number(lower, 3),
                unit.number(upper, 3)
            ));
        }
        row.push(text.into());
    }
    row.push(significant_beside(solution.misfit, 1.0, 2).into());
    let shown = match solution.stiffness_bounds {
        Some(_) => answer.frequencies_hz.len(), // the others hang on stiffness that is not known
        None => solution.modes.len(),
    };
    let frequencies: Vec<String> = solution
        .modes
        .iter()
        .take(shown)
        .map(|m| significant(m.frequency_hz, 4))
        .collect();
    row.push(Cell::wrapping(frequencies.join(", ")));
    row
}

/// What the shapes of the solutions show: only where the frequencies are the same does a shape choose.
fn shapes_caption(answer: &StiffnessAnswer, language: Language) -> String {
    let mut caption = language
        .pick("Mode shapes of the solutions.", "해별 모드형상.")
        .to_string();
    if answer.solutions.choice == Choice::Indistinguishable {
        caption.push_str(language.pick(
            " The same frequencies, other shapes: a measured shape can tell which is the true one.",
            " 고유진동수는 같으나 형상이 다르므로 모드형상을 계측하면 참값을 가릴 수 있다.",
        ));
    }
    if answer.with_shapes {
        caption.push_str(language.pick(" Rings are measured points.", " 고리는 계측점이다."));
    }
    caption
}

fn seen(visibility: &Visibility, language: Language) -> Markup {
    let shares: Vec<String> = visibility
        .seen
        .iter()
        .enumerate()
        .map(|(i, s)| format!("k{}: {}", number::subscript(i + 1), number::fixed(*s, 2)))
        .collect();
    let shares = shares.join(", ");
    let unseen: Vec<String> = visibility
        .seen
        .iter()
        .enumerate()
        .filter(|(_, s)| **s < SEEN_LEAST)
        .map(|(i, _)| format!("k{}", number::subscript(i + 1)))
        .collect();
    let free = visibility.free_directions;
    let verdict = if unseen.is_empty() {
        String::new()
    } else {
        let unseen = listed(&unseen, language);
        language.pick(
            format!(" The data say little of {unseen}."),
            format!(" {unseen}에 대해서는 자료가 알려 주는 것이 거의 없다."),
        )
    };
    html! { p {
        (language.pick(
            format!("Share of each that the data see (at 1 all of it, at 0 nothing): {shares}; directions that stay free: {free}."),
            format!("자료로 정해지는 정도(1 완전, 0 전혀 없음): {shares}; 자유로운 방향 {free}개."),
        )) (verdict)
    } }
}
