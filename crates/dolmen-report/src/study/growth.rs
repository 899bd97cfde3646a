//! Response of a structure as the shaking increases, scan by scan, for some sizes of each.

use super::words::{g, same, scan, some, unit_g};
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::study::{Run, RunOutcome, StudyAnswer, StudyKind};

/// Number of scans above which only the figures and runs.csv contain them.
const SCANS_MOST: usize = 6;

messages! {
    /// Growing shaking.
    pub(crate) enum Growth in "study.growth" {
        OfFrame => { en: "As the shaking grows: largest over the storeys.", ko: "지반운동 증가에 따른 변화: 층 중 최댓값." },
        OfChain => { en: "As the shaking grows: largest over the links and joints.", ko: "지반운동 증가에 따른 변화: 부재와 접합면 중 최댓값." },
        Sizes => { en: "Some sizes of each scan; all are in runs.csv.", ko: "증분해석별 일부 크기이며 전체는 runs.csv에 있다." },
        Scan => { en: "scan", ko: "증분해석" },
        Peak => { en: "peak", ko: "최대지반가속도" },
        Drift => { en: "drift", ko: "층간변위" },
        DriftRatio => { en: "drift of height", ko: "층고 대비 층간변위" },
        SlippingShare => { en: "slips of the time", ko: "미끄러짐 시간 비율" },
        DriftLeft => { en: "drift left", ko: "잔류 층간변위" },
        Top => { en: "top moves", ko: "상단 변위" },
        Leans => { en: "leans", ko: "기울기" },
        JointTurns => { en: "joint turns", ko: "접합면 회전" },
        OpenShare => { en: "open of the time", ko: "벌어짐 시간 비율" },
        Slips => { en: "slips", ko: "미끄러짐 회전" },
        CornerDrift => { en: "drift at a corner", ko: "모서리 층간변위" },
        CornerRatio => { en: "of height", ko: "층고 대비" },
        ShearX => { en: "base shear x", ko: "밑면전단력 x" },
        ShearY => { en: "base shear y", ko: "밑면전단력 y" },
        Stroke => { en: "stroke", ko: "행정" },
        Fell => { en: "fell", ko: "전도" },
    }
}

/// A measure of a run: its heading, its name in the table of runs, and its unit.
type Measure = (Growth, &'static str, Unit);

/// The table of a few scans; empty for stacks, or for many scans.
pub(super) fn section(document: &mut Document<'_>, answer: &StudyAnswer) {
    let measures = measures(answer.kind);
    let mut scans: Vec<&[Run]> = answer.runs.chunk_by(|a, b| a.job == b.job).collect();
    scans.retain(|runs| runs.iter().any(|run| !run.measures.is_none()));
    if measures.is_empty() || scans.is_empty() || scans.len() > SCANS_MOST {
        return;
    }
    let mut columns = vec![
        Column::words(Growth::Scan),
        Column::numbers(Growth::Peak, unit_g(answer)),
    ];
    let heads = measures.iter().cloned();
    columns.extend(heads.map(|(head, _, unit)| Column::numbers(head, unit)));
    let mut rows = Vec::new();
    for runs in scans {
        for (i, run) in some(runs).into_iter().enumerate() {
            let mut row = vec![
                match i {
                    0 => Cell::words(scan(answer, run.job)),
                    _ => same(),
                },
                Cell::number(g(answer, run.peak_ground_acceleration_m_s2)),
            ];
            row.extend(numbers(answer.kind, run, &measures));
            rows.push(row);
        }
    }
    let what = match answer.kind {
        StudyKind::Chain => Growth::OfChain,
        StudyKind::Stack | StudyKind::Frame | StudyKind::Building => Growth::OfFrame,
    };
    let caption: Vec<Sentence> = vec![what.into(), Growth::Sizes.into()];
    document.put(Block::Table(Table {
        caption,
        columns,
        rows,
    }));
}

fn numbers(kind: StudyKind, run: &Run, measures: &[Measure]) -> Vec<Cell> {
    if kind == StudyKind::Chain && run.outcome == RunOutcome::Fell {
        let mut cells = vec![Cell::BadWords(Growth::Fell.into())];
        cells.resize(measures.len(), Cell::Number(None));
        return cells;
    }
    let one = |(_, name, unit): &Measure| {
        let value = run.measures.named(name);
        Cell::Number(value.map(|value| Quantity::new(value, unit.clone(), Digits::Significant(3))))
    };
    measures.iter().map(one).collect()
}

fn measures(kind: StudyKind) -> Vec<Measure> {
    let scaled = |symbol: &str, factor: f64| Unit {
        symbol: symbol.to_owned(),
        factor,
    };
    let [mm, mrad, kn] = [("mm", 1e3), ("mrad", 1e3), ("kN", 1e-3)].map(|(s, f)| scaled(s, f));
    let percent = Unit::percent;
    match kind {
        StudyKind::Stack => Vec::new(),
        StudyKind::Frame => vec![
            (Growth::Drift, "peak_drift_m", mm.clone()),
            (Growth::DriftRatio, "peak_drift_ratio", percent()),
            (Growth::SlippingShare, "slipping_share", percent()),
            (Growth::DriftLeft, "residual_drift_m", mm),
        ],
        StudyKind::Chain => vec![
            (Growth::Top, "peak_top_displacement_m", mm),
            (Growth::Leans, "peak_rotation_rad", mrad.clone()),
            (Growth::JointTurns, "peak_joint_rotation_rad", mrad.clone()),
            (Growth::OpenShare, "open_share", percent()),
            (Growth::Slips, "slipped_rad", mrad),
        ],
        StudyKind::Building => vec![
            (Growth::Top, "peak_top_displacement_m", mm.clone()),
            (Growth::CornerDrift, "peak_corner_drift_m", mm.clone()),
            (Growth::CornerRatio, "peak_corner_drift_ratio", percent()),
            (Growth::ShearX, "base_shear_x_n", kn.clone()),
            (Growth::ShearY, "base_shear_y_n", kn),
            (Growth::Stroke, "peak_stroke_m", mm),
        ],
    }
}
