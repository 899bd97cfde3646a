//! A simulated frame compared with measurements.

use crate::document::{Cell, Column, Finding, Table, Tone};
use dolmen::signal::Component;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::frame::{FrameBeside, FrameSimulation, SensorBeside};

messages! {
    /// A frame compared with its measured motion.
    pub(crate) enum Beside in "frame.simulation.beside" {
        Follows { of: Sentence, survey: String, channel: String, correlation: Quantity, measured: Quantity, simulated: Quantity, hz: Sentence } => {
            en: "{of}: the model moves as survey {survey} measured. At {channel} correlation {correlation}, peak {measured} measured and {simulated} simulated{hz}.",
            ko: "{of}: 모델의 응답이 {survey} 조사의 계측과 맞는다. {channel}에서 상관계수 {correlation}, 최대가속도 계측 {measured}·해석 {simulated}{hz}.",
        },
        DoesNot { of: Sentence, survey: String, channel: String, correlation: Quantity, measured: Quantity, simulated: Quantity, hz: Sentence } => {
            en: "MODEL AND MEASUREMENT DIFFER: {of}, under the ground that survey {survey} measured. At {channel} correlation {correlation}, peak {measured} measured and {simulated} simulated{hz}. This model does not move as the structure did.",
            ko: "모델과 계측이 다름: {of}, {survey} 조사의 지반운동. {channel}에서 상관계수 {correlation}, 최대가속도 계측 {measured}·해석 {simulated}{hz}. 이 모델은 실제 구조물처럼 움직이지 않는다.",
        },
        Answers { measured: Quantity, simulated: Quantity } => {
            en: "; it answers the ground most at {measured}, the model at {simulated}",
            ko: "; 지반에 가장 크게 응답하는 진동수는 계측 {measured}, 모델 {simulated}",
        },
        NoAnswer => { en: "", ko: "" },
        NoSensor(survey: String) => {
            en: "No sensor of survey {survey} can be set beside the model: each needs `position`, a `direction` along x or y, a unit of acceleration, and a place within the height of the frame.",
            ko: "{survey} 조사의 센서 가운데 모델과 비교할 것이 없다. `position`, x 또는 y 방향의 `direction`, 가속도 단위가 있고 골조 높이 안에 있어야 한다.",
        },
        Caption(survey: String) => {
            en: "Measured (survey {survey}) beside simulated, absolute acceleration.",
            ko: "계측({survey} 조사)과 해석의 절대가속도 비교.",
        },
        CaptionMeaning { correlation: Quantity, peak: Quantity } => {
            en: "The difference is its root mean square over that measured. A model is taken to move as the structure did where the correlation is at least {correlation} and the peak within {peak} at every sensor. In strong shaking a structure is softer than at rest: a model of the stiffness at rest then answers at too high a frequency.",
            ko: "차이는 계측값에 대한 제곱평균제곱근의 비이다. 모든 센서에서 상관계수가 {correlation} 이상이고 최댓값 차이가 {peak} 이내이면 모델이 실제처럼 움직인 것으로 본다. 강한 진동에서는 구조물이 평상시보다 유연하므로 평상시 강성의 모델은 더 높은 진동수로 응답한다.",
        },
        LeftOut(channels: Vec<String>) => {
            en: "Not compared, for want of a place within the height, a direction along the run or a unit of acceleration: {channels}.",
            ko: "골조 높이 안의 위치, 해석 방향의 성분 또는 가속도 단위가 없어 비교하지 않은 채널: {channels}.",
        },
        Turned(channels: Vec<String>) => {
            en: "The model moves opposite to {channels} and else alike: is the sensor turned by 180°? Then change the sign of its `direction`.",
            ko: "모델이 {channels}과(와) 반대로, 그 밖에는 같게 움직인다. 센서가 180° 돌아가 있는지 확인하고, 그렇다면 `direction`의 부호를 바꾼다.",
        },
        NoEarthquake { of: Sentence, survey: String } => {
            en: "{of}: no earthquake stands out of the record of survey {survey}, so all of it acted. Either nothing but ambient motion was recorded, or the record begins within the shaking, while the model begins at rest: that the two differ says nothing of the model then. Give a record that begins seconds before the shaking.",
            ko: "{of}: {survey} 조사의 기록에서 지진이 뚜렷하지 않아 기록 전체로 흔들었다. 상시진동만 기록되었거나 흔들리는 중에 기록이 시작된 것인데, 모델은 정지 상태에서 시작하므로 차이가 나도 모델의 잘못이라고 할 수 없다. 흔들리기 몇 초 전부터 시작하는 기록을 준다.",
        },
        GroundOfAnother { of: Sentence, survey: String, along: String } => {
            en: "{of} is moved by the ground that survey {survey} recorded along {along}, since the motion has no component of its own here. The structure did not feel that ground along this direction, so the answer is that of a made-up earthquake.",
            ko: "{of}: 이 방향의 지반 기록이 없어 {survey} 조사의 {along} 방향 지반운동으로 흔들었다. 구조물이 이 방향으로 겪은 지진이 아니므로 가상 지진의 결과로 본다.",
        },
        Sensor => { en: "Sensor", ko: "센서" },
        Name(name: String) => { en: "{name}", ko: "{name}" },
        Height => { en: "height", ko: "높이" },
        PeakMeasured => { en: "peak measured", ko: "최대 계측" },
        PeakSimulated => { en: "simulated", ko: "해석" },
        RmsMeasured => { en: "RMS measured", ko: "RMS 계측" },
        RmsSimulated => { en: "simulated", ko: "해석" },
        Correlation => { en: "correlation", ko: "상관계수" },
        Difference => { en: "difference", ko: "차이" },
        FrequencyMeasured => { en: "answers most at, measured", ko: "최대 응답 진동수 계측" },
        FrequencySimulated => { en: "simulated", ko: "해석" },
        Figure(channel: String) => {
            en: "Absolute acceleration at {channel}, measured and simulated.",
            ko: "{channel}의 절대가속도, 계측과 해석.",
        },
        FigureMeaning(from: Quantity) => {
            en: "Time 0 is {from} after the first sample of the record.",
            ko: "시각 0은 기록의 첫 표본에서 {from} 뒤이다.",
        },
    }
}

fn acceleration(value: f64) -> Quantity {
    Quantity::new(value, Unit::si("m/s²"), Digits::Significant(3))
}

fn hertz(value: f64) -> Quantity {
    Quantity::new(value, Unit::si("Hz"), Digits::Significant(3))
}

fn ratio(value: f64) -> Quantity {
    Quantity::new(value, Unit::ratio(), Digits::Fixed(2))
}

/// Whether the model moved as the structure did, and which sensors are not comparable or may be reversed; `title` is of the run.
pub(super) fn findings(simulation: &FrameSimulation, title: Sentence) -> Vec<Finding> {
    let Some(of) = simulation.beside.as_ref() else {
        return ground_of_another(simulation, title).into_iter().collect();
    };
    let mut all = vec![match of.stands_out || of.follows() {
        true => moves(of, title),
        false => Finding::key(
            Tone::Warn,
            Beside::NoEarthquake {
                of: title,
                survey: of.survey.clone(),
            },
        ),
    }];
    let turned: Vec<String> = of.turned().map(|sensor| sensor.channel.clone()).collect();
    if !turned.is_empty() {
        all.push(Finding::key(Tone::Warn, Beside::Turned(turned)));
    }
    if !of.left_out.is_empty() && !of.sensors.is_empty() {
        all.push(Finding::key(Tone::Warn, left_out(of)));
    }
    all
}

/// A direction excited by the recorded ground motion along the other axis.
fn ground_of_another(simulation: &FrameSimulation, of: Sentence) -> Option<Finding> {
    let survey = simulation.motion.measured.as_ref()?.survey.clone();
    let is_axis = [Component::X, Component::Y]
        .iter()
        .any(|axis| simulation.direction == axis.name());
    let along = simulation.component.name().to_owned();
    (is_axis && simulation.direction != along)
        .then(|| Finding::key(Tone::Warn, Beside::GroundOfAnother { of, survey, along }))
}

fn left_out(of: &FrameBeside) -> Beside {
    Beside::LeftOut(of.left_out.clone())
}

/// Whether the model moved as the structure did, at its highest sensor.
fn moves(of: &FrameBeside, title: Sentence) -> Finding {
    let survey = of.survey.clone();
    let Some(sensor) = worst(of) else {
        return Finding::new(Tone::Unknown, Beside::NoSensor(survey));
    };
    let beside = &sensor.beside;
    let hz = match (beside.frequency_measured_hz, beside.frequency_simulated_hz) {
        (Some(measured), Some(simulated)) => Beside::Answers {
            measured: hertz(measured),
            simulated: hertz(simulated),
        },
        _ => Beside::NoAnswer,
    };
    let (channel, hz) = (sensor.channel.clone(), hz.into());
    let correlation = ratio(beside.correlation);
    let (measured, simulated) = (
        acceleration(beside.peak_measured),
        acceleration(beside.peak_simulated),
    );
    match of.follows() {
        true => Finding::key(
            Tone::Good,
            Beside::Follows {
                of: title,
                survey,
                channel,
                correlation,
                measured,
                simulated,
                hz,
            },
        ),
        false => Finding::key(
            Tone::Warn,
            Beside::DoesNot {
                of: title,
                survey,
                channel,
                correlation,
                measured,
                simulated,
                hz,
            },
        ),
    }
}

/// The highest sensor; if the model does not agree there or elsewhere, the one with the smallest correlation among those.
fn worst(of: &FrameBeside) -> Option<&SensorBeside> {
    let off = of.sensors.iter().filter(|sensor| !sensor.follows());
    let least = off.min_by(|a, b| a.beside.correlation.total_cmp(&b.beside.correlation));
    least.or_else(|| of.highest())
}

/// Each sensor compared with the model.
pub(super) fn table(of: &FrameBeside) -> Table {
    let frequency = |hz: Option<f64>| Cell::Number(hz.map(hertz));
    let row = |sensor: &SensorBeside| {
        let beside = &sensor.beside;
        vec![
            Cell::words(Beside::Name(sensor.channel.clone())),
            Cell::number(Quantity::new(sensor.height_m, Unit::si("m"), Digits::Trimmed(4))),
            Cell::number(acceleration(beside.peak_measured)),
            Cell::number(acceleration(beside.peak_simulated)),
            Cell::number(acceleration(beside.rms_measured)),
            Cell::number(acceleration(beside.rms_simulated)),
            Cell::number(ratio(beside.correlation)),
            Cell::number(Quantity::percent(beside.residual_ratio, 2)),
            frequency(beside.frequency_measured_hz),
            frequency(beside.frequency_simulated_hz),
        ]
    };
    let acceleration = || Unit::si("m/s²");
    let meaning = Beside::CaptionMeaning {
        correlation: Quantity::new(SensorBeside::CORRELATION_LEAST, Unit::ratio(), Digits::Trimmed(2)),
        peak: Quantity::percent(SensorBeside::PEAK_WITHIN, 2),
    };
    let left_out = (!of.left_out.is_empty()).then(|| left_out(of));
    let survey = of.survey.clone();
    Table {
        caption: std::iter::once(Beside::Caption(survey))
            .chain([meaning])
            .chain(left_out)
            .map(Sentence::from)
            .collect(),
        columns: vec![
            Column::words(Beside::Sensor),
            Column::numbers(Beside::Height, Unit::si("m")),
            Column::numbers(Beside::PeakMeasured, acceleration()),
            Column::numbers(Beside::PeakSimulated, acceleration()),
            Column::numbers(Beside::RmsMeasured, acceleration()),
            Column::numbers(Beside::RmsSimulated, acceleration()),
            Column::numbers(Beside::Correlation, Unit::ratio()),
            Column::numbers(Beside::Difference, Unit::percent()),
            Column::numbers(Beside::FrequencyMeasured, Unit::si("Hz")),
            Column::numbers(Beside::FrequencySimulated, Unit::si("Hz")),
        ],
        rows: of.sensors.iter().map(row).collect(),
    }
}

/// Description of the figure of a sensor.
pub(super) fn caption(simulation: &FrameSimulation, sensor: usize) -> Vec<Sentence> {
    let of = simulation.beside.as_ref().and_then(|of| of.sensors.get(sensor));
    let channel = of.map(|of| of.channel.clone()).unwrap_or_default();
    let from_s = simulation.motion.measured.as_ref().map_or(0.0, |of| of.from_s);
    let from = Quantity::new(from_s, Unit::si("s"), Digits::Fixed(2));
    vec![Beside::Figure(channel).into(), Beside::FigureMeaning(from).into()]
}
