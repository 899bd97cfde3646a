//! Tables of modes: their values, and their shapes at the sensors.

use super::values::{damping, fixed, frequency, hertz, percent};
use crate::document::{Cell, Column, Table};
use dolmen::modal::{Method, Mode, Modes};
use dolmen::signal::Channel;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// Heads and captions of modes.
    pub(crate) enum Tables in "modal.tables" {
        Caption { method: Sentence } => {
            en: "Modes by {method}, ± standard deviation.",
            ko: "{method}에 의한 모드, ± 표준편차.",
        },
        Meaning => {
            en: "The floor is the least deviation of a damping ratio that a record of this length allows (Au 2014); a modal phase collinearity (MPC) of 1 is a real shape; a kurtosis of 3 is random motion, of 1.5 a machine's.",
            ko: "하한은 이 길이의 기록에서 감쇠비가 가질 수 있는 최소 표준편차(Au 2014)이며, 모드 위상 공선성(MPC) 1은 실수 모드형상을, 첨도 3은 불규칙 운동을, 1.5는 기계 진동을 뜻한다.",
        },
        DecayMeaning => {
            en: "A collinearity of 1 is a real shape.",
            ko: "공선성 1은 실수 모드형상을 뜻한다.",
        },
        Efdd => {
            en: "enhanced frequency domain decomposition (EFDD)",
            ko: "향상된 주파수 영역 분해법(EFDD)",
        },
        Fsdd => {
            en: "frequency-spatial domain decomposition (FSDD)",
            ko: "주파수·공간 영역 분해법(FSDD)",
        },
        Fdd => { en: "frequency domain decomposition (FDD)", ko: "주파수 영역 분해법(FDD)" },
        SsiCov => {
            en: "covariance-driven stochastic subspace identification (SSI-cov)",
            ko: "공분산 기반 확률적 부분공간법(SSI-cov)",
        },
        SsiData => {
            en: "data-driven stochastic subspace identification (SSI-data)",
            ko: "데이터 기반 확률적 부분공간법(SSI-data)",
        },
        Bayoma => {
            en: "Bayesian operational modal analysis (BAYOMA: subspace method, then the Fourier lines about each mode)",
            ko: "베이지안 운용 모드해석(BAYOMA: 부분공간법으로 찾은 모드를 주변 푸리에 선에 적합)",
        },
        Plscf => {
            en: "poly-reference least squares in the frequency domain (pLSCF)",
            ko: "다기준 최소자승 복소주파수법(pLSCF)",
        },
        Era => {
            en: "eigensystem realization of a free decay (ERA)",
            ko: "자유감쇠의 고유계 실현법(ERA)",
        },
        Okid => {
            en: "observer/Kalman filter identification with measured inputs (OKID)",
            ko: "입력을 계측한 관측기/칼만필터 동정법(OKID)",
        },
        Mode => { en: "Mode", ko: "모드" },
        NthAccepted { number: usize } => { en: "{number} (accepted)", ko: "{number}(채택)" },
        AcceptedMeaning => {
            en: "“Accepted” is a mode that the user insists on and the tests refused.",
            ko: "‘채택’은 판정 기준에서 제외되었으나 사용자가 채택한 모드이다.",
        },
        Nth { number: usize } => { en: "{number}", ko: "{number}" },
        Frequency => { en: "frequency", ko: "고유진동수" },
        Damping => { en: "damping ratio", ko: "감쇠비" },
        Floor => { en: "floor of its sd", ko: "표준편차 하한" },
        Collinearity => { en: "collinearity (MPC)", ko: "공선성 (MPC)" },
        Cycles => { en: "cycles", ko: "관측 주기 수" },
        Kurtosis => { en: "kurtosis", ko: "첨도" },
        WindowBias => { en: "window bias", ko: "창 함수 편의" },
        Orders => { en: "model orders", ko: "모델 차수 수" },
        Unknown => { en: "unknown", ko: "미상" },
        Shapes => { en: "Shapes at the sensors.", ko: "센서 위치의 모드형상." },
        ShapesMeaning => {
            en: "Modulus with the sign of the phase, the largest 1.",
            ko: "위상의 부호를 붙인 크기이며 최댓값을 1로 하였다.",
        },
        Channel => { en: "Channel", ko: "채널" },
        Place => { en: "place (m)", ko: "위치 (m)" },
        Direction => { en: "direction", ko: "방향" },
        Name { name: String } => { en: "{name}", ko: "{name}" },
        Vector { x: Quantity, y: Quantity, z: Quantity } => { en: "{x} {y} {z}", ko: "{x} {y} {z}" },
        At { frequency: Quantity } => { en: "{frequency}", ko: "{frequency}" },
    }
}

/// Whether the modes are peaks of a spectrum.
pub(super) fn of_peaks(method: Method) -> bool {
    match method {
        Method::Fdd | Method::Efdd | Method::Fsdd => true,
        Method::SsiCov | Method::SsiData | Method::Bayoma | Method::Plscf | Method::Era | Method::Okid => {
            false
        }
    }
}

/// The name of a method.
fn method_words(method: Method) -> Sentence {
    match method {
        Method::Efdd => Tables::Efdd,
        Method::Fsdd => Tables::Fsdd,
        Method::Fdd => Tables::Fdd,
        Method::SsiCov => Tables::SsiCov,
        Method::SsiData => Tables::SsiData,
        Method::Bayoma => Tables::Bayoma,
        Method::Plscf => Tables::Plscf,
        Method::Era => Tables::Era,
        Method::Okid => Tables::Okid,
    }
    .into()
}

/// "3".
pub(super) fn nth(index: usize) -> Cell {
    Cell::words(Tables::Nth { number: index + 1 })
}

/// "3", or "3 (accepted)" for a mode that the user accepted.
pub(super) fn nth_of(index: usize, mode: &Mode) -> Cell {
    match mode.is_found() {
        true => nth(index),
        false => Cell::words(Tables::NthAccepted { number: index + 1 }),
    }
}

/// Frequency and damping ratio of a mode; an unknown damping ratio has no number.
pub(super) fn frequency_and_damping(mode: &Mode) -> [Cell; 2] {
    let unknown = || Cell::words(Tables::Unknown);
    let ratio = damping(mode).map_or_else(unknown, Cell::number);
    [Cell::number(frequency(mode)), ratio]
}

/// Columns of the mode's number, frequency and damping ratio.
pub(super) fn first_columns() -> Vec<Column> {
    vec![
        Column::words(Tables::Mode),
        Column::numbers(Tables::Frequency, Unit::si("Hz")),
        Column::numbers(Tables::Damping, Unit::percent()),
    ]
}

/// The modes of one identification under its own caption.
pub(super) fn modes_table(modes: &Modes, mut caption: Vec<Sentence>) -> Table {
    if modes.modes.iter().any(|mode| !mode.is_found()) {
        caption.push(Tables::AcceptedMeaning.into());
    }
    let mut columns = first_columns();
    let mut rows: Vec<Vec<Cell>> = modes.modes.iter().enumerate().map(first_cells).collect();
    for (head, unit, cell) in own_columns(modes.method) {
        let cells: Vec<Cell> = modes.modes.iter().map(cell).collect();
        // a free decay and a measured input have neither noise floor nor kurtosis
        if cells.iter().all(|cell| matches!(cell, Cell::Number(None))) {
            continue;
        }
        columns.push(Column::numbers(head, unit));
        for (row, cell) in rows.iter_mut().zip(cells) {
            row.push(cell);
        }
    }
    Table {
        caption,
        columns,
        rows,
    }
}

fn first_cells((at, mode): (usize, &Mode)) -> Vec<Cell> {
    let [frequency, damping] = frequency_and_damping(mode);
    vec![nth_of(at, mode), frequency, damping]
}

/// A column: its heading, its unit, and its cell for each mode.
type ModeColumn = (Tables, Unit, fn(&Mode) -> Cell);

fn own_columns(method: Method) -> Vec<ModeColumn> {
    let floor: fn(&Mode) -> Cell = match method {
        // the noise floor is that of ambient vibration
        Method::Era | Method::Okid => |_| Cell::Number(None),
        Method::Fdd
        | Method::Efdd
        | Method::Fsdd
        | Method::SsiCov
        | Method::SsiData
        | Method::Bayoma
        | Method::Plscf => |mode| {
            let floor = mode.damping_ratio.map(|zeta| zeta * mode.damping_floor());
            Cell::Number(
                floor
                    .filter(|of| of.is_finite())
                    .map(|of| Quantity::percent(of, 2)),
            )
        },
    };
    let last: ModeColumn = match of_peaks(method) {
        true => (Tables::WindowBias, Unit::percent(), |mode| {
            Cell::Number(mode.window_bias.map(|bias| percent(bias, 1)))
        }),
        false => (Tables::Orders, Unit::ratio(), |mode| {
            Cell::number(fixed(mode.orders.len() as f64, 0))
        }),
    };
    vec![
        (Tables::Floor, Unit::percent(), floor),
        (Tables::Collinearity, Unit::ratio(), |mode| {
            Cell::number(fixed(mode.phase_collinearity, 3))
        }),
        (Tables::Cycles, Unit::ratio(), |mode| {
            Cell::number(fixed(mode.cycles, 0))
        }),
        (Tables::Kurtosis, Unit::ratio(), |mode| {
            Cell::Number(mode.kurtosis.map(|of| fixed(of.kurtosis, 2)))
        }),
        last,
    ]
}

/// The caption of the modes of a record.
pub(super) fn caption(method: Method) -> Vec<Sentence> {
    let caption = Tables::Caption {
        method: method_words(method),
    };
    let meaning = match method {
        Method::Era | Method::Okid => Tables::DecayMeaning,
        Method::Fdd
        | Method::Efdd
        | Method::Fsdd
        | Method::SsiCov
        | Method::SsiData
        | Method::Bayoma
        | Method::Plscf => Tables::Meaning,
    };
    vec![caption.into(), meaning.into()]
}

/// The shapes, one row per channel.
pub(super) fn shapes_table(modes: &Modes) -> Table {
    let mut columns = vec![
        Column::words(Tables::Channel),
        Column::words(Tables::Place),
        Column::words(Tables::Direction),
    ];
    columns.extend(modes.modes.iter().map(|mode| {
        let head = Tables::At {
            frequency: hertz(mode.frequency_hz),
        };
        Column::numbers(head, Unit::ratio())
    }));
    let row = |(at, channel): (usize, &Channel)| {
        let mut row = vec![
            Cell::words(Tables::Name {
                name: channel.name.clone(),
            }),
            vector(channel.position_m),
            vector(channel.direction),
        ];
        let shape = modes.modes.iter().map(|mode| mode.shape[at]);
        row.extend(shape.map(|of| Cell::number(fixed(of.norm().copysign(of.re), 3))));
        row
    };
    Table {
        caption: vec![Tables::Shapes.into(), Tables::ShapesMeaning.into()],
        columns,
        rows: modes.channels.iter().enumerate().map(row).collect(),
    }
}

fn vector(of: Option<[f64; 3]>) -> Cell {
    let number = |value: f64| Quantity::new(value, Unit::ratio(), Digits::Trimmed(6));
    match of.map(|of| of.map(number)) {
        None => Cell::Number(None),
        Some([x, y, z]) => Cell::words(Tables::Vector { x, y, z }),
    }
}
