//! Why sensors cannot be planned.

use dolmen_words::sentences;

/// Why sensors cannot be planned.
#[derive(Clone, Debug, PartialEq)]
pub enum SensorsError {
    /// The project has only surveys.
    NoModel,
    /// It falls under its own weight.
    Falls,
    /// No place is low enough.
    NoSites {
        /// Largest allowed height of a sensor, m.
        up_to_m: f64,
    },
    /// More sensors than places.
    TooMany {
        /// Sensors in all setups.
        sensors: usize,
        /// Places.
        sites: usize,
    },
    /// A count is 0.
    Zero {
        /// The flag.
        option: &'static str,
    },
    /// Other axes than there are.
    Axes {
        /// Asked for.
        given: usize,
    },
    /// More axes than the model moves along.
    AxesOfModel {
        /// Asked for.
        given: usize,
        /// Axes along which each place of the model moves.
        moves: usize,
    },
    /// Several setups without a reference sensor.
    NoReferences {
        /// Setups.
        setups: usize,
    },
    /// Every sensor stays.
    AllStay {
        /// Number of reference sensors.
        references: usize,
        /// All at once.
        count: usize,
    },
    /// Reference sensors with only one setup.
    OneSetup {
        /// Number of reference sensors.
        references: usize,
    },
}

sentences! {
    SensorsError in "sensors.error" {
        NoModel => {
            en: "the project has surveys alone: where sensors stand best follows from a model; give the structure (kind \"chain\", \"frame\", \"stack\" or \"building\")",
            ko: "프로젝트에 조사만 있다. 센서 위치는 모델의 모드에서 정한다. 구조물을 입력한다(kind \"chain\", \"frame\", \"stack\", \"building\")",
        },
        Falls => {
            en: "the model falls under its own weight, so it has no modes: see `dolmen check`",
            ko: "모델이 자중으로 붕괴하여 모드가 없다. `dolmen check`를 본다",
        },
        NoSites { up_to_m } => {
            en: "no place for a sensor is below {up_to_m} m: raise --up-to",
            ko: "{up_to_m} m보다 낮은 센서 자리가 없다. --up-to를 높인다",
        },
        TooMany { sensors, sites } => {
            en: "{sensors} sensors in all setups, but there are {sites} places: lower --count or --setups, or raise --up-to",
            ko: "모든 배치에 센서가 {sensors}개인데 자리는 {sites}곳이다. --count나 --setups를 줄이거나 --up-to를 높인다",
        },
        Zero { option } => { en: "{option} is 0, but must be 1 or more", ko: "{option}이(가) 0인데 1 이상이어야 한다" },
        Axes { given } => {
            en: "--axes is {given}, but must be 1, 2 (both horizontal) or 3",
            ko: "--axes가 {given}인데 1, 2(수평 두 방향), 3 가운데 하나여야 한다",
        },
        AxesOfModel { given, moves } => {
            en: "--axes is {given}, but this is more than the axes along which each place of the model moves, {moves}: give --axes {moves}; sensors with more axes stand at the same places",
            ko: "--axes가 {given}인데 모델의 각 자리가 움직이는 방향의 수 {moves}보다 많다. --axes {moves}을(를) 준다. 축이 더 많은 센서도 같은 자리에 둔다",
        },
        NoReferences { setups } => {
            en: "--setups is {setups}, but no sensor stays: at least one must, better two or three, or the setups cannot be put together; give --references",
            ko: "--setups가 {setups}인데 그대로 두는 센서가 없다. 하나 이상(되도록 둘이나 셋)은 그대로 있어야 배치를 합칠 수 있다. --references를 준다",
        },
        AllStay { references, count } => {
            en: "--references is {references}, but must be less than --count, {count}: the others are moved on",
            ko: "--references가 {references}인데 --count {count}보다 작아야 한다. 나머지 센서를 옮긴다",
        },
        OneSetup { references } => {
            en: "--references is {references}, but there is one setup: give --setups 2 or more",
            ko: "--references가 {references}인데 배치가 하나이다. --setups를 2 이상으로 준다",
        },
    }
}
