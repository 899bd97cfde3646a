//! Words for a record with earthquakes.

use super::values::seconds;
use dolmen::modal::LastingChange;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// An earthquake in a record.
    pub(crate) enum Quake in "modal.earthquake" {
        Holds { from: Quantity, to: Quantity, strong: Quantity, over: Quantity, peak: Sentence } => {
            en: "EARTHQUAKE: the record holds one, {from} to {to} after its first sample, strong for {strong}, {over} times the noise{peak}.",
            ko: "지진: 기록 시작 후 {from}~{to}에 지진이 있다. 강진 지속시간 {strong}, 진폭(RMS)은 평상시 잡음의 {over}배{peak}.",
        },
        HoldsUnsure { from: Quantity, to: Quantity, strong: Quantity, over: Quantity, peak: Sentence } => {
            en: "STRONG SHAKING, {from} to {to} after the first sample, strong for {strong}, {over} times the noise{peak}: an earthquake, traffic close by, a gust or blows; the record does not tell which.",
            ko: "강한 진동: 기록 시작 후 {from}~{to}, 강한 진동의 지속시간 {strong}, 진폭(RMS)은 평상시 잡음의 {over}배{peak}. 지진, 가까운 교통, 돌풍 또는 타격일 수 있으며 이 기록으로는 구분할 수 없다.",
        },
        HoldSeveral { count: usize, peak: Sentence } => {
            en: "EARTHQUAKES: the record holds {count}{peak}.",
            ko: "지진: 기록에 지진이 {count}번 있다{peak}.",
        },
        HoldSome { count: usize, sure: usize, peak: Sentence } => {
            en: "EARTHQUAKE: the record holds strong shaking {count} times, of which {sure} can only be an earthquake{peak}.",
            ko: "지진: 기록에 강한 진동이 {count}번 있으며 이 중 {sure}번은 지진으로 볼 수밖에 없다{peak}.",
        },
        HoldSeveralUnsure { count: usize, peak: Sentence } => {
            en: "STRONG SHAKING, {count} times{peak}: earthquakes, traffic close by, gusts or blows; the record does not tell which.",
            ko: "강한 진동이 {count}번 있다{peak}. 지진, 가까운 교통, 돌풍 또는 타격일 수 있으며 이 기록으로는 구분할 수 없다.",
        },
        Peak { peak: Quantity, channel: String, at: Quantity } => {
            en: "; largest acceleration {peak} at {channel}, after {at}",
            ko: ". 최대가속도는 {channel}에서 {at}에 {peak}",
        },
        PeakAtLeast { peak: Quantity, channel: String, at: Quantity, why: Sentence } => {
            en: "; largest acceleration at least {peak} ({channel}, after {at}): {why}",
            ko: ". 최대가속도는 {peak} 이상이다({channel}, {at}): {why}",
        },
        NoPeak => { en: "", ko: "" },
        WhyClipped { channels: Vec<String> } => {
            en: "{channels} reached the end of the range",
            ko: "{channels}이(가) 계측 범위의 끝에 이르렀다",
        },
        WhyLost => { en: "samples were lost in it", ko: "그동안 표본이 누락되었다" },
        WhyEdge => { en: "the record begins or ends in it", ko: "기록이 그 중간에 시작하거나 끝난다" },
        Each { number: usize, from: Quantity, to: Quantity, strong: Quantity, over: Quantity, peak: Sentence, left: Sentence } => {
            en: "Earthquake {number}: {from} to {to}, strong for {strong}, {over} times the noise{peak}. {left}",
            ko: "지진 {number}: {from}~{to}, 강진 지속시간 {strong}, 진폭(RMS)은 평상시 잡음의 {over}배{peak}. {left}",
        },
        EachUnsure { number: usize, from: Quantity, to: Quantity, strong: Quantity, over: Quantity, peak: Sentence, left: Sentence } => {
            en: "Shaking {number} (an earthquake, traffic close by, a gust or blows): {from} to {to}, strong for {strong}, {over} times the noise{peak}. {left}",
            ko: "진동 {number}(지진, 가까운 교통, 돌풍 또는 타격): {from}~{to}, 강한 진동의 지속시간 {strong}, 진폭(RMS)은 평상시 잡음의 {over}배{peak}. {left}",
        },
        LeftChange { frequency: Quantity, by: Quantity, half: Quantity } => {
            en: "It CHANGED {frequency} by {by} ± {half} (95 %), beyond chance.",
            ko: "이 진동의 전후에 {frequency} 모드가 {by} ± {half}(95 %) 변하였으며 유의하다.",
        },
        LeftNothing { frequency: Quantity, by: Quantity, half: Quantity } => {
            en: "It left no change beyond chance: {frequency} by {by} ± {half} (95 %).",
            ko: "이 진동이 남긴 유의한 변화는 없다: {frequency} 모드 {by} ± {half}(95 %).",
        },
        LeftUnknown => {
            en: "What it left cannot be told: it takes modes that were found on both sides of it, in 40 s each at least.",
            ko: "이 진동이 남긴 변화는 알 수 없다. 각각 40 s 이상인 앞뒤 구간 모두에서 식별된 모드가 필요하다.",
        },
        Parts { each: Vec<Sentence> } => {
            en: "Lowest frequency in the parts without them: {each}.",
            ko: "그 밖의 구간의 최저차 고유진동수: {each}.",
        },
        PartOf { from: Quantity, to: Quantity, frequency: Sentence } => {
            en: "{from} to {to} {frequency}",
            ko: "{from}–{to} {frequency}",
        },
        Three { before: Sentence, during: Sentence, after: Sentence } => {
            en: "Lowest frequency before it: {before}; in it: {during}; after it: {after}.",
            ko: "최저차 고유진동수: 강한 진동 전 {before}, 진동 중 {during}, 진동 후 {after}.",
        },
        Hertz { frequency: Quantity } => { en: "{frequency}", ko: "{frequency}" },
        NotKnown => { en: "not known", ko: "알 수 없음" },
        TooShort { time: Quantity } => { en: "not known ({time} of the record, or no mode in it)", ko: "알 수 없음(해당 구간 {time}, 또는 모드 없음)" },
        Lasts { frequency: Quantity, by: Quantity, half: Quantity, most: Sentence, when: Sentence } => {
            en: "LASTING CHANGE: {frequency} changed by {by} ± {half} (95 %) {when}, beyond chance{most}. Unless it warmed or cooled meanwhile, look at the structure.",
            ko: "잔류 변화: {frequency} 모드가 {when} {by} ± {half}(95 %) 변하였으며 유의하다{most}. 그동안 온도가 변하지 않았으면 구조물을 점검한다.",
        },
        Most { frequency: Quantity, by: Quantity, half: Quantity } => {
            en: "; most of all {frequency}, by {by} ± {half}",
            ko: ". 변화가 가장 큰 것은 {frequency} 모드의 {by} ± {half}",
        },
        NoOther => { en: "", ko: "" },
        BeforeToAfter => { en: "from before to after", ko: "강한 진동 전후에" },
        InAll { first: Sentence, last: Sentence } => {
            en: "in all, from the part {first} to that of {last}",
            ko: "모두 합하여({first} 구간과 {last} 구간의 비교)",
        },
        OfLast => { en: "in the last of which that can be told", ko: "알 수 있는 마지막 진동의 전후에" },
        Span { from: Quantity, to: Quantity } => { en: "{from} to {to}", ko: "{from}–{to}" },
        NothingLasts { frequency: Quantity, by: Quantity, half: Quantity, when: Sentence } => {
            en: "No lasting change beyond chance: {frequency} by {by} ± {half} (95 %) {when}. That is no proof that nothing was damaged.",
            ko: "유의한 잔류 변화는 없다. {frequency} 모드의 변화는 {when} {by} ± {half}(95 %)이다. 손상이 없다는 증명은 아니다.",
        },
        CannotTell => {
            en: "Whether it changed the structure cannot be told from this record: that takes modes that were found both before and after it, in 40 s each at least.",
            ko: "이 기록으로는 강한 진동이 구조물을 변화시켰는지 알 수 없다. 각각 40 s 이상인 그 전후 구간 모두에서 식별된 모드가 필요하다.",
        },
        OfAfter { from: Quantity, to: Quantity } => {
            en: "These modes are those of the record after it, {from} to {to}.",
            ko: "이 모드는 강한 진동 이후 구간({from}–{to})의 것이다.",
        },
        OfBefore { from: Quantity, to: Quantity } => {
            en: "These modes are those of the record BEFORE it, {from} to {to}: what follows is too short.",
            ko: "이 모드는 강한 진동 이전 구간({from}–{to})의 것이다. 그 이후 구간이 너무 짧다.",
        },
        OfBetween { from: Quantity, to: Quantity } => {
            en: "These modes are those of the record between two of them, {from} to {to}: what follows the last is too short.",
            ko: "이 모드는 두 진동 사이 구간({from}–{to})의 것이다. 마지막 진동 이후 구간이 너무 짧다.",
        },
        OfDuring { from: Quantity, to: Quantity } => {
            en: "These modes are those of the structure IN it, {from} to {to}, above the measured ground: no ambient survey, and not to be compared with one.",
            ko: "이 모드는 계측한 지반운동을 입력으로 한 강한 진동 중({from}–{to})의 구조물의 것이다. 상시진동 조사가 아니므로 상시진동 조사와 비교할 수 없다.",
        },
        OfWhole => {
            en: "These modes are those of the whole record, most of all of the structure in strong motion: no ambient survey, and not to be compared with one.",
            ko: "이 모드는 기록 전체의 것으로 주로 강한 진동 중의 구조물을 나타낸다. 상시진동 조사가 아니므로 상시진동 조사와 비교할 수 없다.",
        },
        NoTilt => {
            en: "A lasting tilt or displacement is not given: integrating an accelerometer twice makes one of any offset. Read a tilt sensor, or survey the tilt again.",
            ko: "잔류 기울기나 변위는 제시하지 않는다. 가속도계를 두 번 적분하면 작은 영점 오차도 변위로 나타난다. 경사계를 읽거나 기울기를 다시 측량한다.",
        },
        NotOne => {
            en: "Where this is no earthquake (a blast, a crowd, a gust, blows of a hammer), «say earthquake = \"none\" in records.modal|the file can say so».",
            ko: "지진이 아니면(발파, 군중, 돌풍, 해머 타격) «records.modal에 earthquake = \"none\"을 적는다|파일에 그렇게 적을 수 있다».",
        },
        Softer => {
            en: "Frequencies fall with the strength of motion in stone and timber, and come back with it: the one in strong motion says nothing of damage. The part after it begins where the motion has sunk to twice the noise.",
            ko: "석조와 목조에서는 진동이 강할수록 고유진동수가 낮아졌다가 진동이 줄면 되돌아오므로, 강한 진동 중의 값은 손상을 뜻하지 않는다. 그 이후 구간은 진동이 잡음의 2배로 줄어든 때부터이다.",
        },
        ByInputs { inputs: Vec<String> } => {
            en: "In strong motion: with {inputs} taken as given, the linear structure that moves most alike.",
            ko: "강한 진동 중: {inputs}을(를) 주어진 입력으로 볼 때 가장 비슷하게 움직이는 선형 구조물.",
        },
        ByTrack { windows: usize, lowest: Quantity, at: Quantity } => {
            en: "In strong motion: the lowest mode followed along its shape in {windows} windows; lowest {lowest}, after {at}. The colour of the shaking moves it as well; a measured ground, marked in inputs, tells more.",
            ko: "강한 진동 중: 최저차 모드를 그 형상 방향으로 {windows}개 시간창에서 추적하였다. 최저 {lowest}({at}). 그 진동의 진동수 특성에도 영향을 받으며, 지반을 계측하여 inputs에 적으면 더 정확하다.",
        },
        Measured => { en: "What each channel measured in strong motion.", ko: "강한 진동 중 채널별 계측값." },
        Band { low: Quantity, high: Quantity } => {
            en: "Velocity: integrated once, between {low} and {high} alone.",
            ko: "속도: {low}–{high} 대역에서 한 번 적분한 값.",
        },
        Through => { en: "The lowest frequency before, in and after strong motion.", ko: "강한 진동 전·중·후의 최저차 고유진동수." },
        ThroughMeaning => { en: "Bars: 95 % intervals. Grey: the strong phase, 5 to 95 % of the energy.", ko: "막대: 95 % 신뢰구간. 회색: 강진 구간(에너지의 5–95 %)." },
        Spectra => { en: "Response spectra of the channels, 5 % of damping.", ko: "채널별 응답스펙트럼(감쇠비 5 %)." },
        SpectraMeaning => {
            en: "What an oscillator that stands where the sensor stands would feel: on the ground the motion of the ground, above it what the structure made of it.",
            ko: "센서 위치에 놓인 단자유도계의 응답이다. 지반의 센서는 지반운동을, 그 위의 센서는 구조물이 증폭한 운동을 나타낸다.",
        },
        Changes => { en: "Modes before and after strong motion.", ko: "강한 진동 전후의 모드." },
        ChangesInAll => { en: "Modes before and after, in all.", ko: "모두 합한 전후의 모드." },
        ChangesOf { number: usize } => { en: "Modes before and after motion {number}.", ko: "강한 진동 {number} 전후의 모드." },
        MeasuredIn { number: usize } => { en: "What each channel measured in motion {number}.", ko: "강한 진동 {number} 중 채널별 계측값." },
        MayBeLarger => { en: "may be larger", ko: "더 클 수 있음" },
        Clipped => { en: "end of range", ko: "계측 범위 초과" },
        Lost => { en: "lost samples", ko: "표본 누락" },
        Edge => { en: "edge of record", ko: "기록의 끝" },
        Shown => { en: "no", ko: "아니요" },
        Named { name: String } => { en: "{name}", ko: "{name}" },
        Channel => { en: "Channel", ko: "채널" },
        PeakOf => { en: "peak acceleration", ko: "최대가속도" },
        At => { en: "at", ko: "시각" },
        PeakVelocity => { en: "peak velocity", ko: "최대속도" },
        Arias => { en: "Arias intensity", ko: "아리아스 강도" },
        Noise => { en: "RMS at rest", ko: "평상시 RMS" },
        Before => { en: "before", ko: "진동 전" },
        After => { en: "after", ko: "진동 후" },
        Change => { en: "change", ko: "변화" },
        Half => { en: "± (95 %)", ko: "±(95 %)" },
        Period => { en: "period", ko: "주기" },
        AccelerationOf { channel: String } => { en: "pseudo-acceleration at {channel}", ko: "{channel} 의사 가속도" },
    }
}

/// A change in words: the frequency, its change and half of the interval.
pub(super) struct ChangeWords {
    pub(super) frequency: Quantity,
    pub(super) by: Quantity,
    pub(super) half: Quantity,
}

impl ChangeWords {
    pub(super) fn of(change: &LastingChange) -> Self {
        let half = change.half_width_95().unwrap_or(f64::NAN);
        // both to the first digit of the interval
        let decimals = (-(100.0 * half).abs().log10().floor()).clamp(1.0, 4.0);
        let digits = Digits::Fixed(if decimals.is_nan() { 1 } else { decimals as usize });
        let bare = Unit {
            symbol: String::new(),
            ..Unit::percent()
        };
        ChangeWords {
            frequency: Quantity::new(change.before_hz, Unit::si("Hz"), Digits::Significant(4)),
            by: Quantity::new(change.ratio, bare, digits),
            half: Quantity::new(half, Unit::percent(), digits),
        }
    }
}

pub(super) fn time(at_s: f64) -> Quantity {
    seconds((at_s * 10.0).round() / 10.0)
}

pub(super) fn share(of: f64) -> Quantity {
    Quantity::new(of, Unit::percent(), Digits::Significant(2))
}

pub(super) fn with_sd(frequency_hz: f64, sd_si: Option<f64>) -> Sentence {
    let frequency = Quantity {
        sd_si,
        ..Quantity::new(frequency_hz, Unit::si("Hz"), Digits::Significant(4))
    };
    Quake::Hertz { frequency }.into()
}

pub(super) fn acceleration(of: f64) -> Quantity {
    Quantity::new(of, Unit::si("m/s²"), Digits::Significant(3))
}
