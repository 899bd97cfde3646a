//! Errors of a damper, or the damping of a building.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// Errors of a damper, or the damping of a building.
    pub(crate) enum WrongDamper in "project.error.damper" {
        DampingNeedsOneOf => {
            en: "damping needs one of ratio, ratios, rayleigh and caughey",
            ko: "damping에는 ratio, ratios, rayleigh, caughey 중 하나가 필요하다",
        },
        WriteDampingRatioFor => {
            en: "write damping = {{ ratio = 0.05 }} for 5 % in every mode",
            ko: "모든 모드에 5 %이면 damping = {{ ratio = 0.05 }}로 쓴다",
        },
        DampingRayleighHasFrequencies { found: String } => {
            en: "damping.rayleigh has {found} frequencies",
            ko: "damping.rayleigh의 진동수가 {found}개이다",
        },
        MustBeMassAnd => {
            en: "must be 2: mass and stiffness are two numbers",
            ko: "2개이어야 한다. 질량 비례와 강성 비례의 두 계수를 정한다",
        },
        NeedsDampingRatio => { en: "needs a damping ratio", ko: "감쇠비가 필요하다" },
        ButAboveNothingSwings { path: String, written: String } => {
            en: "{path} = {written}, but above 1 nothing swings any more",
            ko: "{path} = {written}인데, 1을 넘으면 진동하지 않는다",
        },
        WriteAsOr => { en: "write 12 % as 0.12 or \"12 %\"", ko: "12 %는 0.12 또는 \"12 %\"로 쓴다" },
        BelongsToKindBut { path: String, words: Both, kind: String } => {
            en: "{path} belongs to kind = {words}, but this is a \"{kind}\"",
            ko: "{path}은(는) kind = {words}의 키인데 이것은 \"{kind}\"이다",
        },
        TakeItOutOr => { en: "take it out, or change kind", ko: "삭제하거나 kind를 바꾼다" },
        HasNoCoefficient { path: String } => {
            en: "{path} has no coefficient",
            ko: "{path}에 coefficient가 없다",
        },
        GiveForcePerVelocity => {
            en: "give force per velocity: coefficient = \"500 kN*s/m\"",
            ko: "속도당 힘을 입력한다: coefficient = \"500 kN*s/m\"",
        },
        TiesFloorToItself { path: String, to_floor: String } => {
            en: "{path} ties floor {to_floor} to itself",
            ko: "{path}이(가) {to_floor}층을 자기 자신과 잇는다",
        },
        FloorIsRigidName => {
            en: "a floor is rigid: name another in to_floor, 0 for the ground",
            ko: "바닥은 강체이다. to_floor에 다른 층을 쓴다. 지반은 0이다",
        },
        ToPlaceIsOf { path: String } => {
            en: "{path}.to_place is of the ground",
            ko: "{path}.to_place가 지반의 위치를 가리킨다",
        },
        GroundMovesAlikeEverywhere => {
            en: "the ground moves alike everywhere: take to_place out",
            ko: "지반은 어디서나 똑같이 움직이므로 to_place를 삭제한다",
        },
        IsNotBelow { path: String, written: String } => {
            en: "{path} = {written} is not below 1",
            ko: "{path} = {written}이(가) 1보다 작지 않다",
        },
        ItIsPartOf => {
            en: "it is a part of the whole: the vertical arms, the container, have the rest",
            ko: "전체의 일부이다. 나머지는 수직관이나 용기가 차지한다",
        },
        ButDamperIsLighter { path: String, written: String } => {
            en: "{path} = {written}, but a damper is lighter than what it damps",
            ko: "{path} = {written}인데, 감쇠기는 제진 대상보다 가볍다",
        },
        MustBeAboveAt => { en: "must be above 0, at most 1", ko: "0보다 크고 1 이하이어야 한다" },
        MassRatioIsTo => {
            en: "a mass ratio is 0.01 to 0.1, as a rule: write 5 % as 0.05 or \"5 %\"",
            ko: "질량비는 보통 0.01~0.1이다. 5 %는 0.05 또는 \"5 %\"로 쓴다",
        },
        HasBothMassAnd { path: String } => {
            en: "{path} has both mass and mass_ratio",
            ko: "{path}에 mass와 mass_ratio가 모두 있다",
        },
        HasNeitherMassNor { path: String } => {
            en: "{path} has neither mass nor mass_ratio",
            ko: "{path}에 mass도 mass_ratio도 없다",
        },
        GiveMassOrMass => {
            en: "give mass = …, or mass_ratio = … of the modal mass of its mode",
            ko: "mass = … 또는 대상 모드의 모드질량에 대한 mass_ratio = …을 입력한다",
        },
        HasItsFrequencyTwice { path: String } => {
            en: "{path} has its frequency twice: frequency, frequency_ratio and length are one number",
            ko: "{path}의 진동수가 두 번 주어졌다. frequency, frequency_ratio, length는 같은 값을 정한다",
        },
        HasNoFrequency { path: String } => { en: "{path} has no frequency", ko: "{path}에 frequency가 없다" },
        GiveFrequencyFrequencyRatio => {
            en: "give frequency = …, frequency_ratio = … of its mode's, or tuning = \"den_hartog\"",
            ko: "frequency = …, 대상 모드에 대한 frequency_ratio = … 또는 tuning = \"den_hartog\"를 입력한다",
        },
        HasNoDampingRatio { path: String } => {
            en: "{path} has no damping_ratio",
            ko: "{path}에 damping_ratio가 없다",
        },
        GiveDampingRatioOn => {
            en: "give damping_ratio = … on its own frequency, or tuning = \"den_hartog\"",
            ko: "자체 진동수에 대한 damping_ratio = … 또는 tuning = \"den_hartog\"를 입력한다",
        },
        NamesTuningButGives { path: String } => {
            en: "{path} names a tuning, but gives its frequency and damping_ratio",
            ko: "{path}에 tuning이 있는데 frequency와 damping_ratio도 있다",
        },
        TakeTuningOutOr => {
            en: "take tuning out, or what it is to give",
            ko: "tuning을 삭제하거나, tuning이 정할 값을 삭제한다",
        },
        HasNoLengthRatio { path: String } => {
            en: "{path} has no length_ratio",
            ko: "{path}에 length_ratio가 없다",
        },
        GiveHorizontalLengthOf => {
            en: "give the horizontal length of the column over its total length: length_ratio = 0.7",
            ko: "액체 기둥의 전체 길이에 대한 수평 길이의 비를 입력한다: length_ratio = 0.7",
        },
        NeedsOneOfLiquid { path: String } => {
            en: "{path} needs one of liquid_frequency and length",
            ko: "{path}에 liquid_frequency와 length 중 하나가 필요하다",
        },
        GiveLiquidSFrequency => {
            en: "give the liquid's frequency, or the total length of its column",
            ko: "액체의 진동수 또는 액체 기둥의 전체 길이를 입력한다",
        },
        NeedsLiquidShareAnd { path: String } => {
            en: "{path} needs liquid_share and liquid_damping_ratio",
            ko: "{path}에 liquid_share와 liquid_damping_ratio가 필요하다",
        },
        GiveLiquidSPart => {
            en: "give the liquid's part of the mass, and its damping ratio",
            ko: "질량 중 액체의 비율과 액체의 감쇠비를 입력한다",
        },
        HasBothFrequencyAnd { path: String } => {
            en: "{path} has both frequency and frequency_ratio",
            ko: "{path}에 frequency와 frequency_ratio가 모두 있다",
        },
        SharesOfAddUp { key: String, sum: String } => {
            en: "the shares of {key} add up to {sum}",
            ko: "{key}의 비율을 더하면 {sum}이다",
        },
        MustAddUpTo => {
            en: "must add up to 1: they are parts of the damper's mass",
            ko: "합이 1이어야 한다. 감쇠기 질량을 나눈 비율이다",
        },
        IsNoDirection { path: String, given: String } => {
            en: "{path} = \"{given}\" is no direction",
            ko: "{path} = \"{given}\"은(는) 방향이 아니다",
        },
        MustBeXY => {
            en: "must be \"x\", \"y\", or an angle from x, counterclockwise (\"30 deg\")",
            ko: "\"x\", \"y\" 또는 x축에서 반시계방향으로 잰 각도(\"30 deg\")이어야 한다",
        },
        WeighsTOfBuilding { path: String, mass_t: String, percent: String } => {
            en: "{path} weighs {mass_t} t, {percent} % of the building",
            ko: "{path}의 질량이 {mass_t} t으로 건물의 {percent} %이다",
        },
        DoesItsModeHardly => {
            en: "does its mode hardly move at its place?",
            ko: "대상 모드가 그 위치에서 거의 움직이지 않는 것인가?",
        },
        ItsFrequencyIsHz { path: String, hz: String, ratio: String, frequency_hz: String } => {
            en: "{path}: its frequency is {hz} Hz, {ratio} of that of its mode, {frequency_hz} Hz",
            ko: "{path}: 감쇠기의 진동수가 {hz} Hz로 대상 모드 {frequency_hz} Hz의 {ratio}배이다",
        },
        IsItsFrequencyIn => {
            en: "is its frequency in Hz, not rad/s, its length (of a column) in m, and its mode the one meant?",
            ko: "진동수가 rad/s가 아닌 Hz, 액체 기둥의 길이가 m 단위이며 대상 모드가 맞는가?",
        },
        ItsLiquidSwingsAt { path: String, liquid_frequency_hz: String, ratio: String, frequency_hz: String } => {
            en: "{path}: its liquid swings at {liquid_frequency_hz} Hz, {ratio} of the frequency of its mode, {frequency_hz} Hz",
            ko: "{path}: 액체의 진동수가 {liquid_frequency_hz} Hz로 대상 모드 {frequency_hz} Hz의 {ratio}배이다",
        },
        IsLiquidFrequencyIn => {
            en: "is liquid_frequency in Hz, or length the whole length of the column?",
            ko: "liquid_frequency가 Hz 단위이거나 length가 액체 기둥의 전체 길이인가?",
        },
        ItsCoefficientWouldGive { path: String, mode: String, ratio: String } => {
            en: "{path}: its coefficient would give mode {mode} a damping ratio of {ratio} by itself: it is a strut, and no damper",
            ko: "{path}: 이 coefficient만으로 {mode}차 모드의 감쇠비가 {ratio}이(가) 된다. 감쇠기가 아니라 버팀대와 같다",
        },
        IsItInN => { en: "is it in N*s/m, kN*s/m or MN*s/m?", ko: "단위가 N*s/m, kN*s/m, MN*s/m 중 어느 것인가?" },
        ButDampersHaveMm { path: String, written: String, least: String, most_m: String } => {
            en: "{path} = {written}, but dampers have {least} mm to {most_m} m of room each way here",
            ko: "{path} = {written}인데, 이곳 감쇠기의 여유 공간은 한쪽으로 {least} mm~{most_m} m이다",
        },
        IsItInM => { en: "is it in m or mm?", ko: "단위가 m인가 mm인가?" },
    }
}
