//! A simulated motion in the report: what went in, how it ended, joint by joint, in time.

use super::finding::{Finding, Tone};
use super::stack_notes::{capitalised, processing_words};
use super::table::{Cell, figure, table};
use crate::figures::{stack_after, stack_histories};
use crate::text::{outcome_text, points_a_side};
use dolmen::blocks::{ContactLaw, JointHistory, Outcome, StackHistory};
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen::signal::Component;
use dolmen_words::Language;
use dolmen_words::number::{self, significant};
use dolmen_work::answer::ProjectReport;
use dolmen_work::motion::MotionAnswer;
use dolmen_work::stack::StackSimulation;
use maud::{Markup, html};

/// Digits of peaks and residuals.
const DIGITS: usize = 3;
/// Below this a displacement is printed as "< 0.01", mm, or mrad.
const LEAST: f64 = 0.01;

/// How it ended, as a finding.
pub(super) fn findings(simulation: &StackSimulation, language: Language) -> Vec<Finding> {
    let motion = simulation.motion.motion.name();
    let peak = significant(simulation.peak_horizontal_g(), DIGITS);
    let lead = language.pick(
        format!("Under {motion} with a horizontal peak of {peak}\u{202f}g (x and y together): "),
        format!("{motion}(수평 최대 {peak}\u{202f}g, x·y 합성) 작용 시: "),
    );
    let tone = match simulation.history.outcome {
        _ if simulation.ended_before_the_motion_s().is_some() => Tone::Unknown,
        _ if simulation.shifted().is_some() && !simulation.falls() => Tone::Warn,
        Outcome::Stood => Tone::Good,
        Outcome::Uplifted { .. } | Outcome::Slid { .. } => Tone::Warn,
        Outcome::Fell { .. } => Tone::Bad,
        Outcome::StillMoving { .. }
        | Outcome::Stopped { .. }
        | Outcome::NotConverged { .. }
        | Outcome::Diverged { .. } => Tone::Unknown,
    };
    vec![Finding::new(tone, lead + &ending(simulation, language))]
}

/// How it ended, in a sentence.
fn ending(simulation: &StackSimulation, language: Language) -> String {
    let korean = korean(simulation);
    let korean = match simulation.ended_before_the_motion_s() {
        Some(end_s) => {
            format!("지진동이 끝나기 전인 {end_s:.2}초에 해석을 마쳐 판정하지 않는다. 그때까지: {korean}")
        }
        None => korean,
    };
    language.pick(english(simulation), korean)
}

fn korean(simulation: &StackSimulation) -> String {
    let shifted = simulation.shifted().filter(|_| {
        matches!(
            simulation.history.outcome,
            Outcome::Stood | Outcome::Uplifted { .. }
        )
    });
    if let Some((joint, of)) = shifted {
        let [upper, lower] = simulation.joint_names(joint);
        let lower = if lower == "ground" { "지반" } else { lower };
        return format!(
            "붕괴 없음. 그러나 ‘{lower}’ 위의 ‘{upper}’이(가) 최대 {:.1} mm 미끄러졌고 {:.1} mm(접합면 폭의 {:.1}%)가 남았다(DS{}).",
            1e3 * of.peak_slip_m,
            1e3 * of.residual_slip_m,
            100.0 * of.residual_slip_ratio,
            simulation.damage.state.number()
        );
    }
    match simulation.history.outcome {
        Outcome::Stood => {
            let least = number::trimmed(1e3 * StackHistory::UPLIFT_LEAST_M, 2);
            format!("붕괴 없음. {least} mm 이상 벌어진 접합면이 없다.")
        }
        Outcome::Uplifted { joint, at_s } => {
            let [upper, lower] = simulation.joint_names(joint);
            let lower = if lower == "ground" { "지반" } else { lower };
            format!("붕괴 없음. 접합면이 벌어졌으며 {at_s:.2}초에 ‘{lower}’ 위의 ‘{upper}’에서 시작되었다.")
        }
        Outcome::Slid {
            block,
            slip_m,
            margin_ratio,
        } => {
            let name = simulation.stack.blocks().get(block).map_or("", |b| &b.name);
            let (slip_mm, left) = (1e3 * slip_m, 100.0 * margin_ratio);
            format!(
                "붕괴 없음. 그러나 ‘{name}’이(가) 제자리에서 {slip_mm:.1} mm 미끄러졌으며, 무게중심선에서 지지면 가장자리까지의 거리가 처음의 {left:.0}%만 남았다."
            )
        }
        Outcome::Fell { block, joint, at_s } => {
            let name = simulation.stack.blocks().get(block).map_or("", |b| &b.name);
            let [upper, lower] = simulation.joint_names(joint);
            let lower = if lower == "ground" { "지반" } else { lower };
            format!(
                "붕괴. ‘{name}’이(가) {at_s:.2}초에 가장 먼저 떨어졌다. 이때 ‘{lower}’ 위의 ‘{upper}’이(가) 가장 크게 벌어지거나 미끄러졌다."
            )
        }
        Outcome::StillMoving { block, at_s, .. } => {
            let name = simulation.stack.blocks().get(block).map_or("", |b| &b.name);
            format!("해석이 끝난 {at_s:.2}초에도 ‘{name}’이(가) 정지하지 않아 판정하지 않는다.")
        }
        Outcome::Stopped { at_s } => format!("{at_s:.2}초에 해석이 중단되어 판정하지 않는다."),
        Outcome::NotConverged { at_s, .. } => {
            format!("{at_s:.2}초에 접촉 조건의 해를 찾지 못하여 해석이 중단되었고 판정하지 않는다.")
        }
        Outcome::Diverged { .. } => "해석이 발산하여 결과를 사용할 수 없다.".to_owned(),
    }
}

/// The sentence of the text, without its fixed word in capitals.
fn english(simulation: &StackSimulation) -> String {
    let text = outcome_text(simulation);
    let rest = text.split_once(": ").map_or(text.as_str(), |(_, rest)| rest);
    let word = match simulation.history.outcome {
        _ if simulation.ended_before_the_motion_s().is_some() => "the run ended before the motion; ",
        _ if text.starts_with("SHIFTED") => "it shifted and stood; ",
        Outcome::Stood => "it stood; ",
        Outcome::Uplifted { .. } => "it rocked and stood; ",
        Outcome::Slid { .. } => "it slid and stood; ",
        Outcome::Fell { .. } => "it fell; ",
        Outcome::StillMoving { .. } => "it still moved; ",
        Outcome::Stopped { .. } => "the run was stopped; ",
        Outcome::NotConverged { .. } => "the run found no solution; ",
        Outcome::Diverged { .. } => "the run diverged; ",
    };
    format!("{word}{rest}.")
}

/// Versions under the motion side by side; nothing if no variant was simulated.
pub(super) fn compared(answer: &ProjectReport, language: Language) -> Markup {
    let own = answer
        .stack_simulation()
        .into_iter()
        .map(|s| (language.pick("as given", "현재"), s));
    let others = answer.variants().iter().filter_map(|variant| {
        let title = match &variant.title {
            Some(names) => language.pick(names.english(), names.korean()),
            None => &variant.name,
        };
        let of_variant = |run: &&StackSimulation| run.variant.as_deref() == Some(variant.name.as_str());
        Some((title, answer.stack_simulations().find(of_variant)?))
    });
    let all: Vec<_> = own.chain(others).collect();
    if all.len() < 2 {
        return html! {};
    }
    let head: Vec<String> = [
        language.pick("Variant", "대안"),
        language.pick("how it ended", "결과"),
        language.pick("opening (mm)", "벌어짐 (mm)"),
        language.pick("slip (mm)", "미끄러짐 (mm)"),
        language.pick("slip left (mm)", "잔류 미끄러짐 (mm)"),
    ]
    .map(String::from)
    .to_vec();
    let rows: Vec<Vec<Cell>> = all
        .into_iter()
        .map(|(name, simulation)| {
            let joints = &simulation.history.joints;
            let most = |of: fn(&JointHistory) -> f64| thousandths(joints.iter().map(of).fold(0.0, f64::max));
            vec![
                name.into(),
                Cell::wrapping(ending(simulation, language)),
                most(|joint| joint.peak_opening_m).into(),
                most(|joint| joint.peak_slip_m).into(),
                most(|joint| joint.residual_slip_m()).into(),
            ]
        })
        .collect();
    table(
        language.pick(
            "Variants under the motion. The largest value of all joints. One run each: a stack that rocks is sensitive to every input.",
            "지진동 작용 시 대안 비교. 모든 접합면 중 최댓값. 각 1회 해석이며, 로킹하는 적층 구조는 모든 입력에 민감하다.",
        ),
        2,
        &head,
        &rows,
    )
}

/// The section of a simulation.
pub(super) fn section(simulation: &StackSimulation, language: Language) -> Markup {
    html! {
        h2 { (language.pick("Simulated earthquake", "지진응답 시뮬레이션")) }
        p { b { (capitalised(&ending(simulation, language))) } }
        (motion_table(&simulation.motion, language))
        (figure(
            &stack_after(simulation, language),
            language.pick(
                "The stack at the end of the motion. Colours are the larger of peak opening and peak slip of each joint.",
                "지진동 종료 시의 적층 구조. 접합면의 색은 최대 벌어짐과 최대 미끄러짐 중 큰 값이다.",
            ),
        ))
        (joints_table(simulation, language))
        @for found in stack_histories(simulation, language) {
            (figure(&found.svg, caption(&found.name, language)))
        }
        (run(simulation, language))
    }
}

fn caption(name: &str, language: Language) -> &'static str {
    match name {
        "ground" => language.pick(
            "Acceleration of the ground. As it acted.",
            "지반 가속도. 해석에 적용한 값.",
        ),
        "top" => language.pick(
            "Displacement of the highest stone. Against the ground, from rest.",
            "최상부 부재의 변위. 지반에 대한 상대 변위.",
        ),
        "opening" => language.pick(
            "Opening of the joints. The largest gap at a corner, of the joints that opened most.",
            "접합면의 벌어짐. 모서리의 최대 틈이며, 가장 크게 벌어진 접합면들만 표시하였다.",
        ),
        "slip" => language.pick(
            "Slip of the joints. Shift at the middle of the joint, of the joints that slipped most.",
            "접합면의 미끄러짐. 접합면 중심의 이동량이며, 가장 크게 미끄러진 접합면들만 표시하였다.",
        ),
        _ => language.pick(
            "Yaw of the joints. Turn about the vertical, of the joints that turned most.",
            "접합면의 수평 회전. 연직축에 대한 회전각이며, 가장 크게 회전한 접합면들만 표시하였다.",
        ),
    }
}

pub(super) fn motion_table(answer: &MotionAnswer, language: Language) -> Markup {
    let motion = &answer.motion;
    let head: Vec<String> = [
        language.pick("Component", "성분"),
        language.pick("file", "파일"),
        language.pick("peak as read (g)", "원기록 최대 (g)"),
        language.pick("peak as it acts (g)", "적용 최대 (g)"),
    ]
    .map(String::from)
    .to_vec();
    let given = Component::ALL
        .into_iter()
        .filter(|component| motion.has(*component));
    let rows: Vec<Vec<Cell>> = given
        .map(|component| {
            let file = answer.files.iter().find(|(c, _)| *c == component);
            let read = answer.peaks_read_m_s2.iter().find(|(c, _)| *c == component);
            let in_g = |a: f64| significant(a / STANDARD_GRAVITY_M_S2, 4);
            vec![
                component.name().into(),
                file.map_or("–".to_owned(), |(_, file)| file.clone()).into(),
                read.map_or("–".to_owned(), |(_, peak)| in_g(*peak)).into(),
                in_g(motion.component_peak_m_s2(component)).into(),
            ]
        })
        .collect();
    let each = motion.history().iter();
    let steps: Vec<String> = each.map(|step| processing_words(step, language)).collect();
    let (rate, length) = (
        number::trimmed(1.0 / motion.time_step_s(), 6),
        number::fixed(motion.duration_s(), 2),
    );
    let caption = language.pick(
        format!(
            "Motion {}. {rate} Hz, {length} s; {}.",
            motion.name(),
            steps.join("; ")
        ),
        format!(
            "지진동 {}. {rate} Hz, {length} s; 처리: {}.",
            motion.name(),
            steps.join("; ")
        ),
    );
    table(&caption, 2, &head, &rows)
}

/// Thousandths of a metre or radian.
fn thousandths(value: f64) -> String {
    let value = 1e3 * value;
    if value.abs() < LEAST {
        format!("< {LEAST}")
    } else {
        significant(value, DIGITS)
    }
}

fn joints_table(simulation: &StackSimulation, language: Language) -> Markup {
    let head: Vec<String> = [
        language.pick("Stone", "부재"),
        language.pick("on", "아래 부재"),
        language.pick("opening (mm)", "벌어짐 (mm)"),
        language.pick("slip (mm)", "미끄러짐 (mm)"),
        language.pick("yaw (mrad)", "수평 회전 (mrad)"),
        language.pick("slip left (mm)", "잔류 미끄러짐 (mm)"),
        language.pick("yaw left (mrad)", "잔류 회전 (mrad)"),
    ]
    .map(String::from)
    .to_vec();
    let each = simulation.history.joints.iter().enumerate();
    let rows: Vec<Vec<Cell>> = each
        .map(|(number, joint)| {
            let [upper, lower] = simulation.joint_names(number);
            let lower = if lower == "ground" {
                language.pick("ground", "지반")
            } else {
                lower
            };
            let mut cells: Vec<Cell> = vec![upper.into(), lower.into()];
            let values = [
                joint.peak_opening_m,
                joint.peak_slip_m,
                joint.peak_yaw_rad,
                joint.residual_slip_m(),
                joint.residual_yaw_rad(),
            ];
            cells.extend(values.map(|value| Cell::from(thousandths(value))));
            cells
        })
        .collect();
    table(
        language.pick(
            "What each joint did. Peaks, and what is left at the end.",
            "접합면별 응답. 최댓값과 종료 시의 잔류값.",
        ),
        2,
        &head,
        &rows,
    )
}

/// The run itself: what a second engineer needs to repeat and to doubt it.
fn run(simulation: &StackSimulation, language: Language) -> Markup {
    let history = &simulation.history;
    let end = history.energy.last().copied().unwrap_or_default();
    let side = points_a_side(simulation.law.contact_rule());
    let (step, longest) = (
        significant(history.time_step_s, DIGITS),
        significant(history.longest_step_s, DIGITS),
    );
    let made = significant(100.0 * history.energy_made_ratio(), 2);
    let input = number::engineering(end.input_j, "J", DIGITS);
    let taken = number::engineering(end.friction_j + end.damping_j, "J", DIGITS);
    html! {
        div.note {
            p { (match &simulation.law {
                ContactLaw::Springs(_) => language.pick(
                    format!("Springs at {side} × {side} points of each joint, {} steps of {step}\u{202f}s (longest stable {longest}\u{202f}s). The ground put in {input}; friction and dashpots took {taken}; contacts made {made}\u{202f}% of the most put in.", history.steps),
                    format!("접합면마다 {side} × {side}점 스프링, 시간 간격 {step}\u{202f}초(안정 한계 {longest}\u{202f}초), {}단계. 지반이 한 일 {input}, 마찰과 감쇠로 소산 {taken}; 접촉에서 생겨난 에너지 {made}\u{202f}%.", history.steps),
                ),
                ContactLaw::Rigid(_) => language.pick(
                    format!("Rigid contact at {side} × {side} points of each joint, {} steps of {step}\u{202f}s. The ground put in {input}; friction and impacts took {taken}; contacts made {made}\u{202f}% of the most put in.", history.steps),
                    format!("접합면마다 {side} × {side}점 강체 접촉, 시간 간격 {step}\u{202f}초, {}단계. 지반이 한 일 {input}, 마찰과 충돌로 소산 {taken}; 접촉에서 생겨난 에너지 {made}\u{202f}%.", history.steps),
                ),
            }) }
            p { (language.pick(
                "A stack that rocks is sensitive to every input: one run is one case, not a probability.",
                "로킹하는 적층 구조는 모든 입력에 민감하다. 한 번의 해석은 하나의 사례일 뿐 확률이 아니다.",
            )) }
        }
    }
}
