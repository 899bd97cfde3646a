//! Simulated motions of a frame in the report: what went in, how they ended, storey by storey, in time.

use super::finding::{Finding, Tone};
use super::simulation::motion_table;
use super::table::{Cell, figure, table};
use crate::figures::frame_histories;
use crate::text::{damping_words, frame_outcome_text, friction_words};
use dolmen::dynamics::{FrameOutcome, FrictionActsOn, StoreyFriction};
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen_project::Names;
use dolmen_words::Language;
use dolmen_words::number::{self, significant};
use dolmen_work::frame::FrameSimulation;
use maud::{Markup, html};

/// Digits of peaks and residuals.
const DIGITS: usize = 3;

/// How each ended, as findings.
pub(super) fn findings(simulations: &[&FrameSimulation], language: Language) -> Vec<Finding> {
    let each = simulations.iter().map(|simulation| {
        let tone = match simulation.history.outcome {
            FrameOutcome::Finished => Tone::Plain,
            FrameOutcome::DriftLimit { .. } => Tone::Bad,
            FrameOutcome::Stopped { .. } => Tone::Unknown,
        };
        let peak = significant(
            simulation.peak_acceleration_m_s2() / STANDARD_GRAVITY_M_S2,
            DIGITS,
        );
        let motion = simulation.motion.motion.name();
        let of = title(simulation, language);
        let lead = language.pick(
            format!("{of}, under {motion} with a peak of {peak}\u{202f}g: "),
            format!("{of}, {motion}(최대 {peak}\u{202f}g) 작용 시: "),
        );
        Finding::new(tone, lead + &ending(simulation, language))
    });
    each.collect()
}

/// The variant by its title, or by its name in the file.
pub(super) fn variant_words<'a>(
    variant: &'a Option<String>,
    title: &'a Option<Names>,
    language: Language,
) -> Option<&'a str> {
    let title = title.as_ref();
    title
        .map(|names| language.pick(names.english(), names.korean()))
        .or(variant.as_deref())
}

/// Direction and variant.
fn title(simulation: &FrameSimulation, language: Language) -> String {
    let direction = language.pick(
        format!("Direction {}", simulation.direction),
        format!("{} 방향", simulation.direction),
    );
    match variant_words(&simulation.variant, &simulation.variant_title, language) {
        None => direction,
        Some(variant) => format!("{direction}, {variant}"),
    }
}

/// How it ended, in a sentence.
fn ending(simulation: &FrameSimulation, language: Language) -> String {
    let history = &simulation.history;
    let worst = (0..simulation.storeys.len()).max_by(|a, b| {
        let size = |i: &usize| history.drift_peaks[*i].value_m.abs();
        size(a).total_cmp(&size(b))
    });
    let (name, drift_mm) = worst.map_or(("", 0.0), |i| {
        (
            simulation.storeys[i].as_str(),
            1e3 * history.drift_peaks[i].value_m.abs(),
        )
    });
    let residual_mm = 1e3 * history.rest_m.last().copied().unwrap_or(0.0).abs();
    match history.outcome {
        FrameOutcome::Finished => {
            let (drift, residual) = (significant(drift_mm, DIGITS), significant(residual_mm, DIGITS));
            language.pick(
                format!("the largest drift is {drift}\u{202f}mm, in ‘{name}’; the top comes to rest {residual}\u{202f}mm off."),
                format!("최대 층간변위는 ‘{name}’의 {drift}\u{202f}mm이고, 최상층의 잔류 변위는 {residual}\u{202f}mm이다."),
            )
        }
        FrameOutcome::DriftLimit { storey, at_s } => {
            let name = simulation.storeys.get(storey).map_or("", String::as_str);
            let most = number::trimmed(100.0 * simulation.options.drift_ratio_most, 2);
            language.pick(
                format!("{}.", frame_outcome_text(simulation).trim_start_matches("DRIFT LIMIT: ")),
                format!("‘{name}’의 층간변위가 {at_s:.2}초에 층고의 {most} %를 넘었다. 미소변형 모델의 범위를 벗어났으므로 붕괴로 본다."),
            )
        }
        FrameOutcome::Stopped { .. } => language.pick(
            "the run was stopped: no verdict.".to_owned(),
            "해석이 중단되어 판정하지 않는다.".to_owned(),
        ),
    }
}

/// One section a simulation.
pub(super) fn sections(simulations: &[&FrameSimulation], language: Language) -> Markup {
    html! {
        @for simulation in simulations { (section(simulation, language)) }
    }
}

fn section(simulation: &FrameSimulation, language: Language) -> Markup {
    html! {
        h2 { (language.pick("Simulated earthquake: ", "지진응답 시뮬레이션: ")) (title(simulation, language)) }
        p { b { (ending(simulation, language)) } }
        (motion_table(&simulation.motion, language))
        (storeys_table(simulation, language))
        @for found in frame_histories(simulation, language) {
            (figure(&found.svg, &caption(&found.name, simulation, language)))
        }
        (run(simulation, language))
    }
}

fn caption(name: &str, simulation: &FrameSimulation, language: Language) -> String {
    let text = match name {
        "ground" => language.pick(
            "Acceleration of the ground. As it acted.",
            "지반 가속도. 해석에 적용한 값.",
        ),
        "levels" => language.pick(
            "Displacement at the top of each storey. Against the ground.",
            "각 층 상단의 변위. 지반에 대한 상대 변위.",
        ),
        "slips" => language.pick(
            "When the joints of each storey slipped. Between the bands they stick.",
            "층별 미끄러짐 시각. 띠 사이에서는 고착 상태이다.",
        ),
        "energy" => language.pick(
            "Where the energy went. Relative to the ground, all from the start.",
            "에너지 수지. 지반에 대한 상대 운동 기준이며 시작부터 누적한 값이다.",
        ),
        _ => {
            let storey = name.trim_start_matches("loop-").parse::<usize>().unwrap_or(1);
            let name = simulation
                .storeys
                .get(storey.saturating_sub(1))
                .map_or("", String::as_str);
            return language.pick(
                format!(
                    "Force of ‘{name}’ against its drift. The area within is what friction and damping take."
                ),
                format!(
                    "‘{name}’의 층 전단력-층간변위 이력곡선. 둘러싸인 면적이 마찰과 감쇠로 소산된 에너지이다."
                ),
            );
        }
    };
    text.to_owned()
}

fn korean_friction(friction: &StoreyFriction) -> String {
    let kn = |force: f64| significant(1e-3 * force, DIGITS);
    let (law, static_force_n, kinetic_force_n) = match *friction {
        StoreyFriction::None => return "없음".to_owned(),
        StoreyFriction::Coulomb {
            static_force_n,
            kinetic_force_n,
        } => ("쿨롱", static_force_n, kinetic_force_n),
        StoreyFriction::Jenkins {
            static_force_n,
            kinetic_force_n,
            ..
        } => ("젠킨스", static_force_n, kinetic_force_n),
    };
    let on = match *friction {
        StoreyFriction::Jenkins {
            stuck_stiffness_n_m, ..
        } => format!(", 고착 강성 {} kN/mm", significant(1e-6 * stuck_stiffness_n_m, 6)),
        _ => String::new(),
    };
    if static_force_n == kinetic_force_n {
        format!("{law}, {} kN{on}", kn(kinetic_force_n))
    } else {
        format!(
            "{law}, 정지 {} kN, 운동 {} kN{on}",
            kn(static_force_n),
            kn(kinetic_force_n)
        )
    }
}

fn storeys_table(simulation: &FrameSimulation, language: Language) -> Markup {
    let history = &simulation.history;
    let head: Vec<String> = [
        language.pick("Storey", "층"),
        language.pick("friction", "마찰"),
        language.pick("spring (kN/mm)", "스프링 (kN/mm)"),
        language.pick("drift (mm)", "층간변위 (mm)"),
        language.pick("of height (%)", "층고 대비 (%)"),
        language.pick("slipped (mm)", "누적 미끄러짐 (mm)"),
        language.pick("of the time (%)", "미끄러진 시간 (%)"),
        language.pick("drift left (mm)", "잔류 층간변위 (mm)"),
    ]
    .map(String::from)
    .to_vec();
    let heights = simulation.frame.frame().storeys();
    let rows: Vec<Vec<Cell>> = simulation
        .storeys
        .iter()
        .enumerate()
        .map(|(i, name)| {
            let drift = history.drift_peaks[i].value_m.abs();
            let below = i.checked_sub(1).map_or(0.0, |j| history.rest_m[j]);
            let friction = &simulation.frame.friction()[i];
            vec![
                name.as_str().into(),
                language
                    .pick(friction_words(friction), korean_friction(friction))
                    .into(),
                significant(1e-6 * simulation.frame.stiffness_n_m()[i], DIGITS).into(),
                significant(1e3 * drift, DIGITS).into(),
                significant(100.0 * drift / heights[i].height_m, DIGITS).into(),
                significant(1e3 * history.slipped_way_m(i), DIGITS).into(),
                number::fixed(100.0 * history.slipping_share(i), 1).into(),
                significant(1e3 * (history.rest_m[i] - below), DIGITS).into(),
            ]
        })
        .collect();
    table(
        language.pick(
            "What each storey did. Peaks between the samples too, and where it comes to rest if nothing slips any more.",
            "층별 응답. 표본 사이까지 포함한 최댓값과 더 미끄러지지 않을 때의 잔류값.",
        ),
        2,
        &head,
        &rows,
    )
}

/// The run itself: what a second engineer needs to repeat and to doubt it.
fn run(simulation: &FrameSimulation, language: Language) -> Markup {
    let history = &simulation.history;
    let end = history.energy.last().copied().unwrap_or_default();
    let input = number::engineering(end.input_j, "J", DIGITS);
    let friction = number::engineering(end.friction_j, "J", DIGITS);
    let left = significant(history.energy_left_over_ratio(), 2);
    let printed = simulation.frame.acts_on() == FrictionActsOn::Displacement;
    html! {
        div.note {
            p { (language.pick(
                format!("Exact between {} changes from sticking to slipping or back, each located. The ground put in {input}; friction took {friction}; the balance leaves {left} of it.", history.events),
                format!("고착·미끄러짐이 바뀌는 {}개 시각을 찾아 그 사이를 엄밀해로 계산하였다. 지반이 한 일 {input}, 마찰 소산 {friction}, 에너지 수지 오차 {left}.", history.events),
            )) }
            @if let Some(words) = damping_words(&simulation.frame, language) { p { (words) "." } }
            @if printed {
                p { (language.pick(
                    "Friction acts on the displacement against the ground, as eq. 11 of Park and Min (2010) is printed: for reproduction, not for judgement.",
                    "마찰이 박성아·민경원(2010)의 식 (11)대로 지반에 대한 변위에 작용한다. 재현용이며 판단에 쓰지 않는다.",
                )) }
            }
            p { (language.pick(
                "Springs are linear, drifts small, axial forces those at rest. Coefficients of friction are rarely measured: look at several.",
                "강성은 선형, 변형은 미소, 축력은 정적 상태의 값이다. 마찰계수는 대개 측정되지 않으므로 여러 값을 검토한다.",
            )) }
        }
    }
}
