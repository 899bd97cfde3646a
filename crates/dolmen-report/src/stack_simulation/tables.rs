//! Response of each joint of a stack, and versions side by side.

use super::ending::{ending, lower_words, name_words};
use crate::document::{Cell, Column, Table};
use crate::simulated::{milli, version_name};
use dolmen::blocks::JointHistory;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::answer::ProjectReport;
use dolmen_work::stack::StackSimulation;

/// Smaller displacements are shown as "< 0.01", m or rad.
const LEAST: f64 = 1e-5;

messages! {
    /// Tables of simulated stacks.
    pub(crate) enum Tables in "stack-simulation.tables" {
        Joints => { en: "What each joint did.", ko: "접합면별 응답." },
        JointsMeaning => { en: "Peaks, and what is left when the run ended.", ko: "최댓값과 해석 종료 시의 잔류값." },
        Stone => { en: "Stone", ko: "부재" },
        On => { en: "on", ko: "아래 부재" },
        Opening => { en: "opening", ko: "벌어짐" },
        Slip => { en: "slip", ko: "미끄러짐" },
        Yaw => { en: "yaw", ko: "비틀림" },
        SlipLeft => { en: "slip left", ko: "잔류 미끄러짐" },
        YawLeft => { en: "yaw left", ko: "잔류 회전" },
        Bearing => { en: "load / bearable", ko: "하중/지지력" },
        Below { least: Quantity } => { en: "< {least}", ko: "< {least}" },
        Versions => { en: "Variants under the motion.", ko: "지반운동 작용 시 대안 비교." },
        VersionsMeaning => {
            en: "The largest value of all joints. One run each: a stack that rocks is sensitive to every input.",
            ko: "모든 접합면 중 최댓값. 각 1회 해석이며, 로킹하는 적층 구조는 모든 입력에 민감하다.",
        },
        Variant => { en: "Variant", ko: "대안" },
        AsGiven => { en: "as given", ko: "현 상태" },
        Ended => { en: "how it ended", ko: "결과" },
    }
}

/// Peaks and residuals, one row per joint.
pub(super) fn joints(simulation: &StackSimulation) -> Table {
    let crushes = simulation
        .history
        .joints
        .iter()
        .any(|joint| joint.bearing.is_some());
    let row = |(number, joint): (usize, &JointHistory)| {
        let [upper, lower] = simulation.joint_names(number);
        let mut cells = vec![Cell::words(name_words(upper)), Cell::words(lower_words(lower))];
        cells.extend(
            [
                (joint.peak_opening_m, "m"),
                (joint.peak_slip_m, "m"),
                (joint.peak_yaw_rad, "rad"),
                (joint.residual_slip_m(), "m"),
                (joint.residual_yaw_rad(), "rad"),
            ]
            .map(|(value, unit)| thousandths(value, unit)),
        );
        if crushes {
            let ratio = joint.bearing.map(|of| Quantity::beside_one(of.ratio, 3));
            cells.push(Cell::Number(ratio));
        }
        cells
    };
    let mut columns = vec![
        Column::words(Tables::Stone),
        Column::words(Tables::On),
        Column::numbers(Tables::Opening, milli("m")),
        Column::numbers(Tables::Slip, milli("m")),
        Column::numbers(Tables::Yaw, milli("rad")),
        Column::numbers(Tables::SlipLeft, milli("m")),
        Column::numbers(Tables::YawLeft, milli("rad")),
    ];
    columns.extend(crushes.then(|| Column::numbers(Tables::Bearing, Unit::ratio())));
    Table {
        caption: vec![Tables::Joints.into(), Tables::JointsMeaning.into()],
        columns,
        rows: simulation.history.joints.iter().enumerate().map(row).collect(),
    }
}

/// Versions under the motion side by side; `None` if no variant was simulated.
pub(super) fn versions(answer: &ProjectReport) -> Option<Table> {
    let own = answer
        .stack_simulation()
        .map(|simulation| (Tables::AsGiven.into(), simulation));
    let others = answer.variants().iter().filter_map(|variant| {
        let of_variant = |run: &&StackSimulation| run.variant.as_deref() == Some(variant.name.as_str());
        let name = version_name(Some(&variant.name), variant.title.as_ref())?;
        Some((name, answer.stack_simulations().find(of_variant)?))
    });
    let all: Vec<(Sentence, &StackSimulation)> = own.into_iter().chain(others).collect();
    if all.len() < 2 {
        return None;
    }
    let row = |(name, simulation): (Sentence, &StackSimulation)| {
        let joints = &simulation.history.joints;
        let most = |of: fn(&JointHistory) -> f64| thousandths(joints.iter().map(of).fold(0.0, f64::max), "m");
        vec![
            Cell::words(name),
            Cell::words(ending(simulation)),
            most(|joint| joint.peak_opening_m),
            most(|joint| joint.peak_slip_m),
            most(|joint| joint.residual_slip_m()),
        ]
    };
    Some(Table {
        caption: vec![Tables::Versions.into(), Tables::VersionsMeaning.into()],
        columns: vec![
            Column::words(Tables::Variant),
            Column::words(Tables::Ended),
            Column::numbers(Tables::Opening, milli("m")),
            Column::numbers(Tables::Slip, milli("m")),
            Column::numbers(Tables::SlipLeft, milli("m")),
        ],
        rows: all.into_iter().map(row).collect(),
    })
}

/// Thousandths of a metre or radian.
fn thousandths(value: f64, unit: &str) -> Cell {
    let shown = |value: f64, digits| Quantity::new(value, milli(unit), digits);
    if value.abs() >= LEAST {
        return Cell::number(shown(value, Digits::Significant(3)));
    }
    let mut least = shown(LEAST, Digits::Trimmed(1));
    least.unit.symbol.clear();
    Cell::words(Tables::Below { least })
}
