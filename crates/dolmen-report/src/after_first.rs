//! Two motions one after the other: the state after each, and whether the structure was at rest between them.

use crate::as_json;
use crate::document::{
    Block, Cell, Column, Document, Finding, Table, TextStyle, Tone, document_text, findings_text,
};
use crate::headline::headline;
use crate::json::judgement;
use crate::simulated::{milli, millimetres, milliradians, seconds};
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Template, Unit, messages};
use dolmen_work::judgement::judge_simulation;
use dolmen_work::simulation::{AfterFirst, SPEED_AT_REST_M_S, Second, SimulateAnswer, Simulation};
use serde_json::Value;

messages! {
    /// Two motions.
    pub(crate) enum TwoMotions in "simulated.after" {
        Head(first: String) => { en: "After {first}", ko: "{first} 이후" },
        First { first: String, said: Both } => { en: "{first} alone: {said}.", ko: "{first}만 작용할 때: {said}." },
        Rested { second: String, still: Quantity, speed: Quantity, bound: Quantity, from: Quantity } => {
            en: "The ground then stood still for {still}, at whose end no part moved faster than {speed} (at rest: {bound}); {second} began at {from}.",
            ko: "그 뒤 지반이 {still} 동안 정지하였고 그 끝에서 어느 부분도 {speed}보다 빠르지 않았다(정지 기준 {bound}). {second}은(는) {from}에 시작하였다.",
        },
        Moving { second: String, still: Quantity, speed: Quantity, bound: Quantity, from: Quantity } => {
            en: "NOT AT REST between the motions: after {still} of still ground a part still moved at {speed} (at rest: {bound}), and {second} began at {from} on what was moving. Give the structure its damping.",
            ko: "두 지반운동 사이에 멈추지 않았다: 지반이 {still} 동안 정지한 뒤에도 {speed}(으)로 움직이는 부분이 있으며(정지 기준 {bound}), {second}은(는) 움직이는 중에 {from}부터 작용하였다. 구조물의 감쇠를 준다.",
        },
        Both(first: String) => {
            en: "All that follows is of both motions together: peaks, slips and what is left count from the structure as it stood before {first}, times from the beginning of {first}.",
            ko: "이하의 값은 두 지반운동을 합한 것이다. 최댓값, 미끄러짐, 잔류값은 {first} 이전의 상태를, 시각은 {first}의 시작을 기준으로 한다.",
        },
        FellBefore { first: String, second: String } => {
            en: "{second} did not act: the structure fell in {first}, of which all of this is.",
            ko: "{second}은(는) 작용하지 않았다. 구조물이 {first}에서 붕괴하였으며 이하의 값은 모두 {first}의 것이다.",
        },
        NoVerdict { first: String, second: String } => {
            en: "{second} did not act: the run under {first}, of which all of this is, came to no verdict.",
            ko: "{second}은(는) 작용하지 않았다. {first}의 해석이 판정에 이르지 못하였으며 이하의 값은 모두 {first}의 것이다.",
        },
        Caption => { en: "The state after each motion.", ko: "지반운동별 종료 시 상태." },
        Motion => { en: "after", ko: "이후" },
        Direction => { en: "direction", ko: "방향" },
        State => { en: "state", ko: "손상상태" },
        Damage(state: usize) => { en: "DS{state}", ko: "DS{state}" },
        Undamaged => { en: "none", ko: "없음" },
        Fallen => { en: "fell", ko: "붕괴" },
        Stands => { en: "stands", ko: "안정" },
        Opened => { en: "opened or turned", ko: "벌어짐·회전" },
        Slipped => { en: "slipped", ko: "미끄러짐" },
        OffsetLeft => { en: "largest offset left", ko: "최대 잔류 어긋남" },
        OfWidth => { en: "over the joint's width", ko: "접합면 폭 대비" },
        Opening => { en: "largest opening", ko: "최대 벌어짐" },
        LeanLeft => { en: "largest lean left", ko: "최대 잔류 기울기" },
        Lean => { en: "largest lean", ko: "최대 기울기" },
        Turned => { en: "turned against friction", ko: "마찰에 대한 누적 회전" },
        TopLeft => { en: "top left aside", ko: "최상부 잔류 변위" },
        Drift => { en: "largest drift", ko: "최대 층간변위" },
        Way => { en: "way slipped", ko: "누적 미끄러짐" },
    }
}

/// Templates of the sentences on two motions.
pub(crate) const TEMPLATES: &[Template] = TwoMotions::TEMPLATES;

/// The result of the first of two motions; empty for one motion.
pub fn after_first_text(answer: &SimulateAnswer, style: TextStyle) -> String {
    let Some(after) = &answer.after else {
        return String::new();
    };
    let mut document = Document::default();
    document.put(Block::Table(table(answer, after)));
    let found = findings(after);
    let head = Sentence::from(TwoMotions::Head(after.first_motion.clone()));
    let head = head.text(style.language);
    format!("\n{head}\n") + &findings_text(&found, style) + &document_text(&document, style)
}

fn findings(after: &AfterFirst) -> Vec<Finding> {
    let (first, second) = (after.first_motion.clone(), after.second_motion.clone());
    let judged = judge_simulation(&after.first);
    let mut all: Vec<Finding> = Vec::new();
    if let Some(version) = judged.headline() {
        let said = Both::of(|language| headline(version, language));
        all.push(Finding::key(
            Tone::Plain,
            TwoMotions::First {
                first: first.clone(),
                said,
            },
        ));
    }
    match after.second {
        Second::Acted {
            still_s,
            speed_m_s,
            from_s,
        } => {
            let (still, from) = (seconds(still_s), seconds(from_s));
            let (speed, bound) = (speed_mm_s(speed_m_s), speed_mm_s(SPEED_AT_REST_M_S));
            let is_at_rest = after.second.began_at_rest() == Some(true);
            all.push(match is_at_rest {
                true => Finding::key(
                    Tone::Plain,
                    TwoMotions::Rested {
                        second,
                        still,
                        speed,
                        bound,
                        from,
                    },
                ),
                false => Finding::key(
                    Tone::Bad,
                    TwoMotions::Moving {
                        second,
                        still,
                        speed,
                        bound,
                        from,
                    },
                ),
            });
            all.push(Finding::key(Tone::Plain, TwoMotions::Both(first)));
        }
        Second::FellBefore => all.push(Finding::key(Tone::Bad, TwoMotions::FellBefore { first, second })),
        Second::NoVerdictBefore => {
            all.push(Finding::key(Tone::Bad, TwoMotions::NoVerdict { first, second }));
        }
    }
    all
}

fn speed_mm_s(speed_m_s: f64) -> Quantity {
    Quantity::new(speed_m_s, milli("m/s"), Digits::Significant(2))
}

fn table(answer: &SimulateAnswer, after: &AfterFirst) -> Table {
    let mut rows = Vec::new();
    let mut columns = vec![
        Column::words(TwoMotions::Motion),
        Column::words(TwoMotions::State),
    ];
    let mut each = vec![(after.first_motion.clone(), after.first.simulations.as_slice())];
    if after.second.began_at_rest().is_some() {
        let both = format!("{} → {}", after.first_motion, after.second_motion);
        each.push((both, answer.simulations.as_slice()));
    }
    let in_mm = |head: TwoMotions| Column::numbers(head, milli("m"));
    let in_mrad = |head: TwoMotions| Column::numbers(head, milli("rad"));
    columns.extend(match after.first.simulations.first() {
        Some(Simulation::Chain(_)) => vec![
            in_mrad(TwoMotions::LeanLeft),
            in_mrad(TwoMotions::Lean),
            in_mrad(TwoMotions::Turned),
        ],
        Some(Simulation::Frame(_)) => vec![
            in_mm(TwoMotions::TopLeft),
            in_mm(TwoMotions::Drift),
            in_mm(TwoMotions::Way),
        ],
        _ => vec![
            in_mm(TwoMotions::OffsetLeft),
            Column::numbers(TwoMotions::OfWidth, Unit::percent()),
            in_mm(TwoMotions::Opening),
        ],
    });
    for (motion, simulations) in each {
        for simulation in simulations {
            let state = StateLeft::of(simulation);
            let direction = direction(simulation).map(|name| format!("{motion}, {name}"));
            let mut row = vec![Cell::words(Sentence::of_argument(
                &direction.unwrap_or_else(|| motion.clone()),
            ))];
            row.push(Cell::words(state.words()));
            row.extend(state.cells());
            rows.push(row);
        }
    }
    Table {
        caption: vec![TwoMotions::Caption.into()],
        columns,
        rows,
    }
}

fn direction(simulation: &Simulation) -> Option<String> {
    match simulation {
        Simulation::Frame(run) => Some(run.direction.clone()),
        Simulation::Chain(run) => run.direction.map(|axis| axis.name().to_owned()),
        _ => None,
    }
}

/// The state of a structure after a motion.
enum StateLeft {
    /// For a stack: its state, the largest residual offset, m and relative to the width, the largest opening, m.
    Stack {
        state: u8,
        left_m: f64,
        left_ratio: f64,
        opening_m: f64,
    },
    /// For a chain: whether it fell, whether a joint opened or slipped, the largest residual lean, the peak, and the accumulated slip, rad.
    Chain {
        fell: bool,
        moved: bool,
        left_rad: f64,
        most_rad: f64,
        turned_rad: f64,
    },
    /// For a frame: whether it leaned too far, the residual displacement of the top, the largest drift and the accumulated slip, m.
    Frame {
        fell: bool,
        left_m: f64,
        drift_m: f64,
        slipped_m: f64,
    },
    /// For structures without a residual state.
    Other,
}

impl StateLeft {
    fn of(simulation: &Simulation) -> Self {
        match simulation {
            Simulation::Stack(runs) => {
                let run = &runs.deciding;
                StateLeft::Stack {
                    state: run.counted_damage().number(),
                    left_m: run.damage.largest(|joint| joint.residual_slip_m),
                    left_ratio: run.damage.largest(|joint| joint.residual_slip_ratio),
                    opening_m: run.damage.largest(|joint| joint.peak_uplift_m),
                }
            }
            Simulation::Chain(run) => {
                let history = &run.history;
                let links = 0..run.links.len();
                let most = |of: &dyn Fn(usize) -> f64| links.clone().map(of).fold(0.0, f64::max);
                StateLeft::Chain {
                    fell: run.falls(),
                    moved: !history.uplifts.is_empty() || !history.slips.is_empty(),
                    left_rad: most(&|i| history.rotation_rad[i].last().map_or(0.0, |end| end.abs())),
                    most_rad: most(&|i| history.rotation_peaks[i].rotation_rad.abs()),
                    turned_rad: most(&|i| history.slipped_rad(i)),
                }
            }
            Simulation::Frame(run) => {
                let history = &run.history;
                let storeys = 0..run.storeys.len();
                let most = |of: &dyn Fn(usize) -> f64| storeys.clone().map(of).fold(0.0, f64::max);
                StateLeft::Frame {
                    fell: run.falls(),
                    left_m: history.rest_m.last().map_or(0.0, |top| top.abs()),
                    drift_m: most(&|i| history.drift_peaks[i].value_m.abs()),
                    slipped_m: most(&|i| history.slipped_way_m(i)),
                }
            }
            Simulation::Supports(_)
            | Simulation::Settled(_)
            | Simulation::Building(_)
            | Simulation::Wind(_) => StateLeft::Other,
        }
    }

    fn words(&self) -> TwoMotions {
        match self {
            StateLeft::Stack { state: 0, .. } => TwoMotions::Undamaged,
            StateLeft::Stack { state: 4, .. } => TwoMotions::Fallen,
            StateLeft::Stack { state, .. } => TwoMotions::Damage(usize::from(*state)),
            StateLeft::Chain { fell: true, .. } | StateLeft::Frame { fell: true, .. } => TwoMotions::Fallen,
            StateLeft::Chain { moved: true, .. } => TwoMotions::Opened,
            StateLeft::Frame { slipped_m, .. } if *slipped_m > 0.0 => TwoMotions::Slipped,
            StateLeft::Chain { .. } | StateLeft::Frame { .. } | StateLeft::Other => TwoMotions::Stands,
        }
    }

    fn cells(&self) -> Vec<Cell> {
        match self {
            StateLeft::Stack {
                left_m,
                left_ratio,
                opening_m,
                ..
            } => vec![
                Cell::number(millimetres(*left_m)),
                Cell::number(Quantity::percent(*left_ratio, 3)),
                Cell::number(millimetres(*opening_m)),
            ],
            StateLeft::Chain {
                left_rad,
                most_rad,
                turned_rad,
                ..
            } => [left_rad, most_rad, turned_rad]
                .map(|angle| Cell::number(milliradians(*angle)))
                .to_vec(),
            StateLeft::Frame {
                left_m,
                drift_m,
                slipped_m,
                ..
            } => [left_m, drift_m, slipped_m]
                .map(|length| Cell::number(millimetres(*length)))
                .to_vec(),
            StateLeft::Other => Vec::new(),
        }
    }

    fn json(&self) -> Value {
        match self {
            StateLeft::Stack {
                state,
                left_m,
                left_ratio,
                opening_m,
            } => as_json!({
                "damage_state": state, "residual_slip_m": left_m, "residual_slip_ratio": left_ratio, "peak_opening_m": opening_m,
            }),
            StateLeft::Chain {
                fell,
                moved,
                left_rad,
                most_rad,
                turned_rad,
            } => as_json!({
                "fell": fell, "opened_or_turned": moved, "residual_rotation_rad": left_rad, "peak_rotation_rad": most_rad,
                "slipped_rad": turned_rad,
            }),
            StateLeft::Frame {
                fell,
                left_m,
                drift_m,
                slipped_m,
            } => as_json!({
                "fell": fell, "residual_displacement_m": left_m, "peak_drift_m": drift_m, "slipped_way_m": slipped_m,
            }),
            StateLeft::Other => Value::Null,
        }
    }
}

/// The same as JSON; `null` for one motion.
pub(crate) fn after_first_json(answer: &SimulateAnswer) -> Value {
    let Some(after) = &answer.after else {
        return Value::Null;
    };
    let states = |simulations: &[Simulation]| -> Vec<Value> {
        let each = simulations.iter();
        each.map(|one| as_json!({ "direction": direction(one), "left": StateLeft::of(one).json() }))
            .collect()
    };
    let (still_s, speed_m_s, from_s) = match after.second {
        Second::Acted {
            still_s,
            speed_m_s,
            from_s,
        } => (Some(still_s), Some(speed_m_s), Some(from_s)),
        Second::FellBefore | Second::NoVerdictBefore => (None, None, None),
    };
    as_json!({
        "first_motion": after.first_motion,
        "second_motion": after.second_motion,
        "second_acted": after.second.began_at_rest().is_some(),
        "began_at_rest": after.second.began_at_rest(),
        "still_s": still_s,
        "speed_at_rest_m_s": speed_m_s,
        "speed_at_rest_most_m_s": SPEED_AT_REST_M_S,
        "second_from_s": from_s,
        "after_first": states(&after.first.simulations),
        "after_second": after.second.began_at_rest().map(|_| states(&answer.simulations)),
        "judgement_of_first": judgement(&judge_simulation(&after.first)),
    })
}
