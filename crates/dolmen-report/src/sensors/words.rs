//! Sentences on a plan for sensors.

use dolmen_words::message::Both;
use dolmen_words::{Quantity, Sentence, messages};
use dolmen_work::sensors::{Axis, PlannedMode, Side};

messages! {
    /// Sensors, and the modes that they measure.
    pub(crate) enum Planned in "sensors" {
        Head(name: Both) => { en: "Sensors for {name}", ko: "{name}: 센서 배치" },
        TellsApart { modes: usize, mac: Quantity, share: Quantity } => {
            en: "These sensors tell all {modes} modes apart: MAC of two modes {mac} at most, and of each mode they read at least {share} of its largest motion.",
            ko: "이 센서로 모드 {modes}개를 모두 구별한다. 두 모드의 MAC은 {mac} 이하이고, 모드마다 최대 변위의 적어도 {share}을(를) 측정한다.",
        },
        SeesOne(share: Quantity) => {
            en: "These sensors read {share} of the mode's largest motion.",
            ko: "이 센서는 모드 최대 변위의 {share}을(를) 측정한다.",
        },
        TellsApartByFrequency { modes: usize, mac: Quantity, share: Quantity } => {
            en: "These sensors read at least {share} of the largest motion of each of {modes} modes, but two of the modes look much alike to them (MAC {mac}): only their frequencies tell those apart.",
            ko: "이 센서는 모드 {modes}개 각각의 최대 변위의 적어도 {share}을(를) 측정한다. 그러나 두 모드는 형상이 비슷하여(MAC {mac}) 고유진동수로만 구별할 수 있다.",
        },
        HardlySeen { mode: usize, share: Quantity } => {
            en: "Mode {mode} is hardly seen: the sensors read {share} of its largest motion. Give more sensors or axes, or raise --up-to.",
            ko: "{mode}차 모드는 거의 보이지 않는다. 최대 변위의 {share}만 읽는다. 센서나 축을 늘리거나 --up-to를 높인다.",
        },
        Alike { mode: usize, other: usize, mac: Quantity } => {
            en: "Modes {mode} and {other} look alike at these sensors (MAC {mac}): the shapes alone do not tell them apart. Give more sensors or axes, or raise --up-to.",
            ko: "{mode}차와 {other}차 모드가 이 센서에서는 비슷하다(MAC {mac}). 모드형상만으로 구별할 수 없다. 센서나 축을 늘리거나 --up-to를 높인다.",
        },
        EqualJoints => {
            en: "The file gives no stiffness: the shapes assume that all joints are equal, each with twice what stability needs.",
            ko: "강성이 입력되지 않아 모든 접합부의 강성을 안정에 필요한 값의 2배로 같게 보고 모드형상을 구하였다.",
        },
        EqualStoreys => {
            en: "The file lacks stiffness in some direction: there the shapes are those of equal storeys.",
            ko: "강성이 입력되지 않은 방향이 있다. 그 방향은 모든 층의 강성이 같다고 보고 모드형상을 구하였다.",
        },
        FromModel => {
            en: "The shapes are the model's. Once a first record is identified, compare them, mend the model and plan anew.",
            ko: "모드형상은 모델의 것이다. 첫 기록을 분석하면 비교하여 모델을 고치고 다시 배치한다.",
        },
        WithoutDampers(dampers: Vec<String>) => {
            en: "The shapes are those of the structure without its dampers ({dampers}): near the frequency of one that is tuned, two modes of like shape stand where the plan has one. Put a sensor on the damper, too, or block it.",
            ko: "모드형상은 감쇠기({dampers})를 뺀 구조물의 것이다. 동조한 감쇠기의 진동수 부근에서는 배치에 쓴 모드 하나가 형상이 비슷한 두 모드로 나뉜다. 감쇠기에도 센서를 두거나 감쇠기를 고정한다.",
        },
        Setups => {
            en: "The sensors that stay bring the setups to one scale: they were chosen first, to see every mode. The others go from the top down.",
            ko: "그대로 두는 센서가 여러 배치의 크기를 맞춘다. 모든 모드를 보도록 먼저 골랐다. 나머지는 위에서 아래로 옮긴다.",
        },
        Write => {
            en: "`-o DIR` writes a drawing, the plan as JSON, and the lines for `channels` of a survey's records.",
            ko: "`-o DIR`로 도면, JSON, 조사 기록의 `channels`에 넣을 줄을 저장한다.",
        },
        SensorsCaption(sites: usize) => {
            en: "Sensors, of {sites} places that were looked at.",
            ko: "센서 위치(후보 {sites}곳 가운데).",
        },
        ModesCaption => {
            en: "What they read of each mode: its largest motion at a sensor over its largest anywhere, and the mode most like it at the sensors (MAC).",
            ko: "모드마다 센서가 읽는 것: 센서에서의 최대 변위와 전체 최대 변위의 비, 센서에서 가장 비슷한 모드(MAC).",
        },
        Number => { en: "no.", ko: "번호" },
        Part => { en: "part", ko: "부재" },
        Place => { en: "place", ko: "자리" },
        X => { en: "x", ko: "x 좌표" },
        Y => { en: "y", ko: "y 좌표" },
        Z => { en: "z", ko: "z 좌표" },
        Axes => { en: "axes", ko: "축" },
        Setup => { en: "setup", ko: "배치" },
        Mode => { en: "mode", ko: "모드" },
        Frequency => { en: "frequency", ko: "진동수" },
        Moves => { en: "moves", ko: "움직임" },
        Seen => { en: "seen", ko: "읽는 비율" },
        MostAlike => { en: "most like", ko: "가장 비슷한 모드" },
        Like { mode: usize, mac: Quantity } => { en: "{mode} ({mac})", ko: "{mode}차 ({mac})" },
        Stays => { en: "stays", ko: "고정" },
        InSetup(setup: usize) => { en: "{setup}", ko: "{setup}" },
        Unknown => { en: "unknown", ko: "미상" },
        None => { en: "–", ko: "–" },
        Name(name: String) => { en: "{name}", ko: "{name}" },
        Top => { en: "top", ko: "윗면" },
        Right => { en: "side +x", ko: "+x 면" },
        Left => { en: "side −x", ko: "−x 면" },
        Back => { en: "side +y", ko: "+y 면" },
        Front => { en: "side −y", ko: "−y 면" },
        Corner(number: usize) => { en: "corner {number}", ko: "모서리 {number}" },
        InPlane => { en: "in the plane of the model", ko: "모델의 평면 방향" },
        Along(axis: String) => { en: "along {axis}", ko: "{axis} 방향" },
        Sways(axis: String) => { en: "mostly along {axis}", ko: "주로 {axis} 방향" },
        Turns => { en: "mostly turning", ko: "주로 회전" },
    }
}

/// Place on a part.
pub(super) fn side_words(side: Side) -> Planned {
    match side {
        Side::Top => Planned::Top,
        Side::Right => Planned::Right,
        Side::Left => Planned::Left,
        Side::Back => Planned::Back,
        Side::Front => Planned::Front,
        Side::Corner(at) => Planned::Corner(at + 1),
    }
}

/// The axes of a sensor.
pub(super) fn axes_words(axes: &[Axis]) -> Planned {
    let keys: Vec<&str> = axes.iter().filter_map(Axis::key).collect();
    match keys.is_empty() {
        true => Planned::InPlane,
        false => Planned::Name(keys.join(", ")),
    }
}

/// The motion of a mode: along the direction with at least half of its energy.
pub(super) fn moves(mode: &PlannedMode) -> Sentence {
    if let Some(direction) = &mode.direction {
        let axis = direction.clone();
        return Planned::Along(axis).into();
    }
    let Some(along) = mode.along else {
        return Planned::InPlane.into();
    };
    let names = ["x", "y", "z"].into_iter().zip(along);
    match names.max_by(|a, b| a.1.total_cmp(&b.1)) {
        Some((axis, share)) if share >= 0.5 => Planned::Sways(axis.to_owned()).into(),
        _ => Planned::Turns.into(),
    }
}
