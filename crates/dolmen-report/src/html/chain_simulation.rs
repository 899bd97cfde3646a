//! Simulated motions of a chain in the report: what went in, how they ended, link by link, in time; variants side by side.

use super::finding::{Finding, Tone};
use super::frame_simulation::variant_words;
use super::simulation::motion_table;
use super::table::{Cell, figure, table};
use crate::figures::chain_histories;
use crate::text::chain_outcome_text;
use dolmen::dynamics::{ChainOutcome, JointFriction};
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen_words::Language;
use dolmen_words::number::{self, significant};
use dolmen_work::chain::ChainSimulation;
use maud::{Markup, html};

/// Digits of peaks and residuals.
const DIGITS: usize = 3;

/// How each ended, as findings.
pub(super) fn findings(simulations: &[&ChainSimulation], language: Language) -> Vec<Finding> {
    let each = simulations.iter().map(|simulation| {
        let tone = match simulation.history.outcome {
            ChainOutcome::Stood if simulation.held_joints().is_empty() => Tone::Plain,
            ChainOutcome::Stood => Tone::Warn,
            ChainOutcome::Uplifted { .. } => Tone::Warn,
            ChainOutcome::Fell { .. } => Tone::Bad,
            ChainOutcome::StillLeaning { .. } | ChainOutcome::Stopped { .. } => Tone::Unknown,
        };
        let of = title(simulation, language);
        let lead = match &simulation.motion {
            None => format!("{of}: "),
            Some((motion, _)) => {
                let motion = motion.motion.name();
                let peak = simulation.peak_acceleration_m_s2() / STANDARD_GRAVITY_M_S2;
                let peak = significant(peak, DIGITS);
                language.pick(
                    format!("{of}, under {motion} with a peak of {peak}\u{202f}g: "),
                    format!("{of}, {motion}(최대 {peak}\u{202f}g) 작용 시: "),
                )
            }
        };
        Finding::new(tone, lead + &ending(simulation, language))
    });
    each.collect()
}

/// The variant, or that it is the structure as it is.
fn title(simulation: &ChainSimulation, language: Language) -> String {
    variant_words(&simulation.variant, &simulation.variant_title, language)
        .unwrap_or(language.pick("as it is", "현재 상태"))
        .to_owned()
}

/// How it ended, in a sentence.
fn ending(simulation: &ChainSimulation, language: Language) -> String {
    let history = &simulation.history;
    let lean = history.rotation_peaks.iter().map(|peak| peak.rotation_rad.abs());
    let lean = significant(1e3 * lean.fold(0.0, f64::max), DIGITS);
    let top = significant(1e3 * history.top_peak_m.abs(), DIGITS);
    let is_held = !simulation.held_joints().is_empty();
    match history.outcome {
        ChainOutcome::Stood => language.pick(
            format!(
                "it stands and {}; links lean by up to {lean}\u{202f}mrad, the top moves {top}\u{202f}mm.",
                match is_held {
                    true => "its joints were taken as unable to open, since no bed_width is given",
                    false => "no bed comes to its edge",
                }
            ),
            format!(
                "전도되지 않으며 {}. 최대 회전각 {lean}\u{202f}mrad, 최상단 변위 {top}\u{202f}mm.",
                match is_held {
                    true => "받침 너비가 주어지지 않아 접합면이 벌어지지 않는 것으로 가정하였다",
                    false => "합력이 받침 끝에 이르는 접합면은 없다",
                }
            ),
        ),
        ChainOutcome::Uplifted { joint, at_s } => {
            let name = simulation.link(joint);
            language.pick(
                format!("it stands, but beds come to their edge, the one below ‘{name}’ first, at {at_s:.2}\u{202f}s; links lean by up to {lean}\u{202f}mrad, the top moves {top}\u{202f}mm."),
                format!("전도되지 않으나 접합면이 벌어진다. ‘{name}’ 하부가 {at_s:.2}초에 처음 벌어지고, 최대 회전각 {lean}\u{202f}mrad, 최상단 변위 {top}\u{202f}mm."),
            )
        }
        ChainOutcome::Fell { link, at_s } => {
            let name = simulation.link(link);
            let angle = simulation.options.fall_rad.to_degrees();
            language.pick(
                format!(
                    "{}.",
                    chain_outcome_text(simulation).replacen("FELL: ", "it falls: ", 1)
                ),
                format!("전도된다. ‘{name}’의 회전각이 {at_s:.2}초에 {angle:.0}°를 넘는다."),
            )
        }
        ChainOutcome::StillLeaning { link, at_s } => {
            let name = simulation.link(link);
            language.pick(
                format!("no verdict: when the run ended, at {at_s:.2}\u{202f}s, ‘{name}’ leaned further out than in the time before and went on; it has to be followed for longer."),
                format!("판정 불가: 해석이 끝난 {at_s:.2}초에 ‘{name}’의 회전각이 계속 커지고 있었다. 더 오래 해석해야 한다."),
            )
        }
        ChainOutcome::Stopped { .. } => language.pick(
            "the run was stopped: no verdict.".to_owned(),
            "해석이 중단되어 판정하지 않는다.".to_owned(),
        ),
    }
}

/// One section a simulation, and a comparison of several.
pub(super) fn sections(simulations: &[&ChainSimulation], language: Language) -> Markup {
    html! {
        @for simulation in simulations { (section(simulation, language)) }
        @if simulations.len() > 1 { (compared(simulations, language)) }
    }
}

fn section(simulation: &ChainSimulation, language: Language) -> Markup {
    html! {
        h2 { (language.pick("Simulated earthquake: ", "지진응답 시뮬레이션: ")) (title(simulation, language)) }
        p { b { (first_upper(&ending(simulation, language))) } }
        @if let Some((motion, _)) = &simulation.motion { (motion_table(motion, language)) }
        (joints_table(simulation, language))
        (links_table(simulation, language))
        @for found in chain_histories(simulation, language).iter().filter(|found| tells(&found.name, simulation)) {
            (figure(&found.svg, &caption(&found.name, simulation, language)))
        }
        (run(simulation, language))
    }
}

/// Whether a figure tells something: the loop of a joint that only springs is a straight line.
fn tells(name: &str, simulation: &ChainSimulation) -> bool {
    let Some(joint) = name.strip_prefix("loop-").and_then(|n| n.parse::<usize>().ok()) else {
        return true;
    };
    let history = &simulation.history;
    let is_joint = |at: usize| at + 1 == joint;
    history.uplifts.iter().any(|uplift| is_joint(uplift.joint))
        || history.slips.iter().any(|slip| is_joint(slip.joint))
}

fn first_upper(sentence: &str) -> String {
    let mut characters = sentence.chars();
    let first = characters.next().into_iter().flat_map(char::to_uppercase);
    first.chain(characters).collect()
}

fn caption(name: &str, simulation: &ChainSimulation, language: Language) -> String {
    let text = match name {
        "ground" => language.pick(
            "Acceleration of the ground. As it acted.",
            "지반 가속도. 해석에 적용한 값.",
        ),
        "rotations" => language.pick(
            "Rotation of each link from the vertical. Large rotations, up to the fall if there is one.",
            "각 부재의 연직 기준 회전각. 대회전을 고려하여 전도 시점까지 계산하였다.",
        ),
        "openings" => language.pick(
            "When the joint below each link was open. Its moment is then half the width of its bed times the weight above it.",
            "부재 아래 접합면이 벌어진 시각. 이때 접합면 모멘트는 상부 하중과 밑면 폭 절반의 곱이다.",
        ),
        "slips" => language.pick(
            "When the joint below each link turned against its friction. Between the bands it sticks.",
            "부재 아래 접합면이 마찰을 이기고 회전한 시각. 띠 사이에서는 고착 상태이다.",
        ),
        "energy" => language.pick(
            "Where the energy went. Relative to the ground, all from the start.",
            "에너지 수지. 지반에 대한 상대 운동 기준이며 시작부터 누적한 값이다.",
        ),
        _ => {
            let joint = name.trim_start_matches("loop-").parse::<usize>().unwrap_or(1);
            let name = simulation.link(joint.saturating_sub(1));
            return language.pick(
                format!(
                    "Moment of the joint below ‘{name}’ against its rotation. Spring and friction; dashpots are not in it."
                ),
                format!("‘{name}’ 하부 접합면의 모멘트-회전각 이력곡선. 스프링과 마찰만 나타내며 점성감쇠는 제외하였다."),
            );
        }
    };
    text.to_owned()
}

fn kn_m(moment_n_m: f64) -> String {
    significant(1e-3 * moment_n_m, DIGITS)
}

/// The moment of friction, or the static and the kinetic one.
fn friction(static_moment_n_m: f64, kinetic_moment_n_m: f64, language: Language) -> String {
    let (holds, turns) = (kn_m(static_moment_n_m), kn_m(kinetic_moment_n_m));
    if static_moment_n_m == kinetic_moment_n_m {
        return turns;
    }
    match language {
        Language::English => format!("{holds} then {turns}"),
        Language::Korean => format!("정지 {holds}, 운동 {turns}"),
    }
}

fn joints_table(simulation: &ChainSimulation, language: Language) -> Markup {
    let head: Vec<String> = [
        language.pick("Joint below", "접합면 (부재 하부)"),
        language.pick("spring (kN·m/rad)", "스프링 (kN·m/rad)"),
        language.pick("dashpot (kN·m·s/rad)", "점성감쇠 (kN·m·s/rad)"),
        language.pick("on its edge at (kN·m)", "전도 모멘트 (kN·m)"),
        language.pick("friction (kN·m)", "마찰 모멘트 (kN·m)"),
    ]
    .map(String::from)
    .to_vec();
    let model = &simulation.model;
    let rows: Vec<Vec<Cell>> = model
        .joints()
        .iter()
        .enumerate()
        .map(|(i, joint)| {
            let most = model.moment_most_n_m()[i];
            vec![
                simulation.link(i).into(),
                kn_m(joint.stiffness_n_m_rad).into(),
                kn_m(joint.damping_n_m_s_rad).into(),
                if most.is_finite() {
                    kn_m(most).into()
                } else {
                    language.pick("held", "벌어지지 않음").into()
                },
                match joint.friction {
                    JointFriction::None => language.pick("none", "없음").into(),
                    JointFriction::Coulomb {
                        static_moment_n_m,
                        kinetic_moment_n_m,
                    } => friction(static_moment_n_m, kinetic_moment_n_m, language).into(),
                },
            ]
        })
        .collect();
    table(
        language.pick("What the joints are.", "접합면의 모델."),
        1,
        &head,
        &rows,
    )
}

fn links_table(simulation: &ChainSimulation, language: Language) -> Markup {
    let history = &simulation.history;
    let head: Vec<String> = [
        language.pick("Link", "부재"),
        language.pick("leaned (mrad)", "최대 회전각 (mrad)"),
        language.pick("joint turned (mrad)", "접합면 회전각 (mrad)"),
        language.pick("moment (kN·m)", "모멘트 (kN·m)"),
        language.pick("open (s)", "벌어진 시간 (s)"),
        language.pick("slipped (mrad)", "누적 마찰 회전 (mrad)"),
        language.pick("at the end (mrad)", "종료 시 (mrad)"),
    ]
    .map(String::from)
    .to_vec();
    let rows: Vec<Vec<Cell>> = (0..simulation.links.len())
        .map(|link| {
            let last = history.rotation_rad[link].last().copied().unwrap_or_default();
            vec![
                simulation.link(link).into(),
                significant(1e3 * history.rotation_peaks[link].rotation_rad.abs(), DIGITS).into(),
                significant(1e3 * history.joint_peaks[link].rotation_rad.abs(), DIGITS).into(),
                kn_m(simulation.joint_moment_peak_n_m(link)).into(),
                number::fixed(simulation.history.open_s(link), 2).into(),
                significant(1e3 * simulation.history.slipped_rad(link), DIGITS).into(),
                significant(1e3 * last, DIGITS).into(),
            ]
        })
        .collect();
    table(
        language.pick(
            "What each link did, and the joint below it. Peaks of rotation between the samples too.",
            "부재별 응답과 하부 접합면. 회전각은 표본 사이까지 포함한 최댓값.",
        ),
        1,
        &head,
        &rows,
    )
}

/// Versions of the chain under their motions, one row each.
fn compared(simulations: &[&ChainSimulation], language: Language) -> Markup {
    let head: Vec<String> = [
        language.pick("Version", "구분"),
        language.pick("ended", "결과"),
        language.pick("lowest frequency (Hz)", "1차 진동수 (Hz)"),
        language.pick("leaned (mrad)", "최대 회전각 (mrad)"),
        language.pick("top moved (mm)", "최상단 변위 (mm)"),
    ]
    .map(String::from)
    .to_vec();
    let rows: Vec<Vec<Cell>> = simulations
        .iter()
        .map(|simulation| {
            let history = &simulation.history;
            let ended = match history.outcome {
                ChainOutcome::Stood => language.pick("stood", "안정 유지"),
                ChainOutcome::Uplifted { .. } => language.pick("joints opened", "접합면 벌어짐"),
                ChainOutcome::Fell { .. } => language.pick("fell", "전도"),
                ChainOutcome::StillLeaning { .. } => language.pick("still leaning", "판정 불가"),
                ChainOutcome::Stopped { .. } => language.pick("stopped", "중단"),
            };
            let lean = history.rotation_peaks.iter().map(|peak| peak.rotation_rad.abs());
            vec![
                title(simulation, language).into(),
                ended.into(),
                simulation
                    .first_frequency_hz
                    .map_or("–".to_owned(), |hz| significant(hz, DIGITS))
                    .into(),
                significant(1e3 * lean.fold(0.0, f64::max), DIGITS).into(),
                significant(1e3 * history.top_peak_m.abs(), DIGITS).into(),
            ]
        })
        .collect();
    html! {
        h2 { (language.pick("Simulated versions side by side", "시뮬레이션 결과 비교")) }
        (table(
            language.pick(
                "The same motion, each version of the structure. Of one that fell, up to the fall.",
                "동일 지진동에 대한 비교. 전도된 경우는 전도 시점까지의 값이다.",
            ),
            2,
            &head,
            &rows,
        ))
    }
}

/// The run itself: what a second engineer needs to repeat and to doubt it.
fn run(simulation: &ChainSimulation, language: Language) -> Markup {
    let history = &simulation.history;
    let left = significant(history.energy_left_over_ratio, 2);
    let (steps, events) = (history.steps, history.friction_events);
    html! {
        div.note {
            p { (language.pick(
                format!("Rigid links with large rotations; {steps} steps of Taylor series, openings and {events} changes of friction located between them. The balance of energy leaves {left} of the largest energy of motion."),
                format!("강체 부재의 대회전 운동방정식을 테일러 급수로 {steps}단계 적분하였으며, 벌어짐과 마찰 상태 변화({events}회) 시각을 단계 사이에서 찾았다. 에너지 수지 오차는 최대 운동에너지의 {left}배이다."),
            )) }
            p { (language.pick(
                "A joint that opens is elastic and loses nothing as it closes; no stone slides; the axial forces are those at rest. What a fall does to the ground is not followed.",
                "벌어진 접합면은 탄성으로 닫히며 충돌 손실이 없고, 부재의 미끄러짐은 없으며, 축력은 정적 상태의 값이다. 전도 이후는 추적하지 않는다.",
            )) }
        }
    }
}
