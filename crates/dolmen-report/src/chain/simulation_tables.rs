//! Tables of simulated chains: the joints, the response of each link, versions side by side.

use super::simulation_ending::{Ending, ending_word, lean, title};
use crate::document::{Cell, Column, Table};
use crate::simulated::{kilo, left, milli, millimetres, milliradians, seconds};
use dolmen::dynamics::{ChainJoint, JointFriction};
use dolmen_words::{Digits, Quantity, Unit, messages};
use dolmen_work::chain::ChainSimulation;

messages! {
    /// Tables of simulated chains.
    pub(crate) enum Tables in "chain.simulation.tables" {
        Name { name: String } => { en: "{name}", ko: "{name}" },
        Joints => { en: "What the joints are.", ko: "접합면의 모델." },
        JointsMeaning => {
            en: "A bed comes to its edge at N·b/2, half its width times the weight above; a joint that is held never opens.",
            ko: "전도 모멘트는 상부 하중과 접합면 폭 절반의 곱 N·b/2이며, ‘벌어지지 않음’은 벌어지지 않는 것으로 가정한 접합면이다.",
        },
        Joint => { en: "Joint below", ko: "접합면 (부재 하부)" },
        Spring => { en: "spring", ko: "스프링" },
        Dashpot => { en: "dashpot", ko: "점성감쇠" },
        Edge => { en: "on its edge at", ko: "전도 모멘트" },
        Held => { en: "held", ko: "벌어지지 않음" },
        Friction => { en: "friction", ko: "마찰 모멘트" },
        NoFriction => { en: "none", ko: "없음" },
        TwoFrictions { holds: Quantity, turns: Quantity } => {
            en: "{holds} then {turns}",
            ko: "정지 {holds}, 운동 {turns}",
        },
        Links => {
            en: "What each link did, and the joint below it.",
            ko: "부재별 응답과 하부 접합면.",
        },
        LinksMeaning => {
            en: "Peaks of rotation between the samples too; moments at the samples.",
            ko: "회전각은 표본 사이까지 포함한 최댓값이고 모멘트는 표본에서의 최댓값이다.",
        },
        Link => { en: "Link", ko: "부재" },
        Leaned => { en: "leaned", ko: "최대 회전각" },
        At => { en: "at", ko: "발생 시각" },
        JointTurned => { en: "joint turned", ko: "접합면 회전각" },
        Moment => { en: "moment", ko: "모멘트" },
        Open => { en: "open", ko: "벌어진 시간" },
        Slipped => { en: "slipped", ko: "누적 마찰 회전" },
        AtTheEnd => { en: "at the end", ko: "종료 시" },
        Versions => { en: "The same motion, each version of the structure.", ko: "동일 지반운동에 대한 비교." },
        VersionsMeaning => {
            en: "Of one that fell, up to the fall.",
            ko: "전도된 경우는 전도 시점까지의 값이다.",
        },
        Version => { en: "Version", ko: "구분" },
        Ended => { en: "ended", ko: "결과" },
        Lowest => { en: "lowest frequency", ko: "1차 진동수" },
        TopMoved => { en: "top moved", ko: "최상단 변위" },
    }
}

/// A given value, without its unit.
fn given(value_si: f64, unit: &Unit) -> Cell {
    Cell::number(Quantity::new(value_si, unit.clone(), Digits::Trimmed(6)))
}

fn found(value_si: f64, unit: &Unit) -> Cell {
    Cell::number(Quantity::new(value_si, unit.clone(), Digits::Significant(4)))
}

fn name(simulation: &ChainSimulation, link: usize) -> Cell {
    let name = simulation.link(link).to_owned();
    Cell::words(Tables::Name { name })
}

/// Springs, dashpots, edges and friction of the joints.
pub(super) fn joints(simulation: &ChainSimulation) -> Table {
    let model = &simulation.model;
    let [spring, dashpot, moment] = ["N·m/rad", "N·m·s/rad", "N·m"].map(kilo);
    let row = |(i, joint): (usize, &ChainJoint)| {
        let most = model.moment_most_n_m()[i];
        vec![
            name(simulation, i),
            given(joint.stiffness_n_m_rad, &spring),
            found(joint.damping_n_m_s_rad, &dashpot),
            match most.is_finite() {
                true => found(most, &moment),
                false => Cell::words(Tables::Held),
            },
            friction(joint.friction, &moment),
        ]
    };
    Table {
        caption: vec![Tables::Joints.into(), Tables::JointsMeaning.into()],
        columns: vec![
            Column::words(Tables::Joint),
            Column::numbers(Tables::Spring, spring.clone()),
            Column::numbers(Tables::Dashpot, dashpot.clone()),
            Column::numbers(Tables::Edge, moment.clone()),
            Column::numbers(Tables::Friction, moment.clone()),
        ],
        rows: model.joints().iter().enumerate().map(row).collect(),
    }
}

/// The moment of friction, or the static and the kinetic one.
fn friction(of: JointFriction, unit: &Unit) -> Cell {
    let bare = |moment_n_m: f64| {
        let unit = Unit {
            symbol: String::new(),
            factor: unit.factor,
        };
        Quantity::new(moment_n_m, unit, Digits::Trimmed(6))
    };
    match of {
        JointFriction::None => Cell::words(Tables::NoFriction),
        JointFriction::Coulomb {
            static_moment_n_m,
            kinetic_moment_n_m,
        } if static_moment_n_m == kinetic_moment_n_m => Cell::number(bare(kinetic_moment_n_m)),
        JointFriction::Coulomb {
            static_moment_n_m,
            kinetic_moment_n_m,
        } => Cell::words(Tables::TwoFrictions {
            holds: bare(static_moment_n_m),
            turns: bare(kinetic_moment_n_m),
        }),
    }
}

/// Peaks and residuals, one row per link.
pub(super) fn links(simulation: &ChainSimulation) -> Table {
    let history = &simulation.history;
    let (angle, moment, time) = (milli("rad"), kilo("N·m"), Unit::si("s"));
    let row = |link: usize| {
        let peak = history.rotation_peaks[link];
        let last = history.rotation_rad[link].last().copied().unwrap_or_default();
        vec![
            name(simulation, link),
            Cell::number(milliradians(peak.rotation_rad)),
            Cell::number(seconds(peak.at_s)),
            Cell::number(milliradians(history.joint_peaks[link].rotation_rad)),
            found(simulation.joint_moment_peak_n_m(link), &moment),
            Cell::number(seconds(history.open_s(link))),
            Cell::number(milliradians(history.slipped_rad(link))),
            Cell::number(left(last, peak.rotation_rad, angle.clone())),
        ]
    };
    Table {
        caption: vec![Tables::Links.into(), Tables::LinksMeaning.into()],
        columns: vec![
            Column::words(Tables::Link),
            Column::numbers(Tables::Leaned, angle.clone()),
            Column::numbers(Tables::At, time.clone()),
            Column::numbers(Tables::JointTurned, angle.clone()),
            Column::numbers(Tables::Moment, moment.clone()),
            Column::numbers(Tables::Open, time),
            Column::numbers(Tables::Slipped, angle.clone()),
            Column::numbers(Tables::AtTheEnd, angle.clone()),
        ],
        rows: (0..simulation.links.len()).map(row).collect(),
    }
}

/// Versions of the chain under their motions, one row each.
pub(super) fn versions(simulations: &[&ChainSimulation]) -> Table {
    let row = |simulation: &&ChainSimulation| {
        let word = ending_word(simulation);
        let frequency = |hz: f64| Quantity::new(hz, Unit::si("Hz"), Digits::Significant(4));
        vec![
            Cell::words(title(simulation)),
            match word {
                Ending::WordFell => Cell::BadWords(word.into()),
                word => Cell::words(word),
            },
            Cell::Number(simulation.first_frequency_hz.map(frequency)),
            Cell::number(lean(simulation)),
            Cell::number(millimetres(simulation.history.top_peak_m)),
        ]
    };
    Table {
        caption: vec![Tables::Versions.into(), Tables::VersionsMeaning.into()],
        columns: vec![
            Column::words(Tables::Version),
            Column::words(Tables::Ended),
            Column::numbers(Tables::Lowest, Unit::si("Hz")),
            Column::numbers(Tables::Leaned, milli("rad")),
            Column::numbers(Tables::TopMoved, milli("m")),
        ],
        rows: simulations.iter().map(row).collect(),
    }
}
