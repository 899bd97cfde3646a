//! Errors of the records of a survey.

use dolmen_words::messages;

messages! {
    /// Errors of the records of a survey.
    pub(crate) enum WrongRecords in "project.error.records" {
        SensorsAtOrigin { path: String, away: String, height: String } => {
            en: "{path}: all sensors stand within {away} of the origin of a structure {height} high",
            ko: "{path}: 구조물의 높이는 {height}인데 모든 센서가 원점에서 {away} 안에 있다",
        },
        SensorsBeyond { path: String, away: String, height: String } => {
            en: "{path}: sensors stand {away} apart or away, but the structure is {height} high",
            ko: "{path}: 구조물의 높이는 {height}인데 센서 사이(또는 원점과)의 거리가 {away}이다",
        },
        PositionsAreIn { meant: String, unit: String } => {
            en: "positions without a unit are in {unit}, as units.length: is it {meant}?",
            ko: "단위 없는 위치는 units.length의 {unit} 단위이다. {meant}인가?",
        },
        PositionsFromFoot(unit: String) => {
            en: "positions are measured from the foot of the structure, without a unit in {unit}",
            ko: "위치는 구조물 바닥의 원점에서 재며 단위가 없으면 {unit} 단위이다",
        },
        IsHzButVibration { path: String, rate_hz: String, least: String, most: String } => {
            en: "{path} is {rate_hz} Hz, but vibration is recorded at {least} to {most} Hz",
            ko: "{path}이(가) {rate_hz} Hz인데, 진동은 {least}~{most} Hz로 기록한다",
        },
        IsItStepIn { step: String, rate_hz: String } => {
            en: "is it the step in s? A step of {step} s is a rate of \"{rate_hz} Hz\"",
            ko: "초 단위의 시간 간격인가? 간격 {step} s이면 샘플링 주파수는 \"{rate_hz} Hz\"이다",
        },
        IsItInHz => { en: "is it in Hz, not kHz?", ko: "kHz가 아니라 Hz 단위인가?" },
        IsNotBelow { path: String, lower: String, low: String, upper: String, high: String } => {
            en: "{path}: {lower} = {low} is not below {upper} = {high}",
            ko: "{path}: {lower} = {low}이(가) {upper} = {high}보다 작지 않다",
        },
        NothingWouldBeLeft => { en: "nothing would be left", ko: "남는 대역이 없다" },
        DampingLeastAndDamping(path: String) => {
            en: "{path}: damping_least and damping_most are not used by this method",
            ko: "{path}: 이 방법에서는 damping_least와 damping_most를 쓰지 않는다",
        },
        InputsOfAnotherMethod(path: String) => {
            en: "{path}: this method does not take measured inputs",
            ko: "{path}: 이 방법에서는 입력 채널을 쓰지 않는다",
        },
        LeaveOutTheMethod => {
            en: "leave out method, or write method = \"okid\"",
            ko: "method를 삭제하거나 method = \"okid\"로 한다",
        },
        LeaveThemOutOr => {
            en: "leave them out, or choose ssi-cov, ssi-data, plscf or bayoma",
            ko: "삭제하거나 ssi-cov, ssi-data, plscf, bayoma 중 하나를 고른다",
        },
        MustBeXRight => { en: "must be 3: x right, y away, z up", ko: "3개이어야 한다. x 오른쪽, y 안쪽, z 위쪽" },
        NamesNoFile(path: String) => { en: "{path} names no file", ko: "{path}에 파일 이름이 없다" },
        FileIsMissing => { en: "file is missing", ko: "file이 없다" },
        WriteFileRecordCsv => {
            en: "write file = \"record.csv\", or stations for several files",
            ko: "file = \"record.csv\"를 쓴다. 파일이 여럿이면 stations를 쓴다",
        },
        StandsWithoutStations(path: String) => {
            en: "{path} stands without stations",
            ko: "{path}이(가) stations 없이 주어졌다",
        },
        OneFileHasOne => { en: "one file has one start: leave it out", ko: "파일이 하나이면 시작 시각도 하나이므로 삭제한다" },
        StandsBesideStations { path: String, key: String } => {
            en: "{path}.{key} stands beside {path}.stations",
            ko: "{path}.{key}이(가) {path}.stations와 함께 있다",
        },
        WriteItWithEach => {
            en: "write it with each station: each file has its own",
            ko: "파일마다 값이 있으므로 각 station에 쓴다",
        },
        IsNoTime { path: String, written: String } => {
            en: "{path} = {written} is no time",
            ko: "{path} = {written}은(는) 시각이 아니다",
        },
        MustBeTimeSuch => {
            en: "must be a time such as \"2024-06-05T10:00:00.25\", or seconds",
            ko: "\"2024-06-05T10:00:00.25\"와 같은 시각 또는 초이어야 한다",
        },
        IsNoScale { path: String, given: String } => {
            en: "{path} = {given} is no scale",
            ko: "{path} = {given}은(는) 배율로 쓸 수 없다",
        },
        MustBeFiniteNumber => { en: "must be a finite number other than 0", ko: "0이 아닌 유한한 수이어야 한다" },
        HoldsNoTimeStamps(file: String) => {
            en: "{file} holds no time stamps",
            ko: "{file}에 시각이 기록되어 있지 않다",
        },
        SamplingRateIsMissing => { en: "sampling_rate is missing", ko: "sampling_rate가 없다" },
        WriteSamplingRateHz => {
            en: "write sampling_rate = \"200 Hz\" beside it",
            ko: "그 옆에 sampling_rate = \"200 Hz\"를 쓴다",
        },
        FormatOfIsNot(file: String) => {
            en: "the format of {file} is not clear",
            ko: "{file}의 형식을 알 수 없다",
        },
        WriteFormatOneOf(names: String) => {
            en: "write format = one of {names} beside it",
            ko: "그 옆에 format을 {names} 중 하나로 쓴다",
        },
        CopyItAndWriteFormat(names: String) => {
            en: "copy it into the folder of the project, outside which no file is read without --allow-outside, and write format = one of {names} beside it",
            ko: "프로젝트 폴더로 복사하고(폴더 밖의 파일은 --allow-outside 없이 읽지 않는다) 그 옆에 format을 {names} 중 하나로 쓴다",
        },
        SaveAsXlsx => {
            en: "of workbooks only .xlsx is read: save it so, or the sheet as CSV (in a spreadsheet: Save as, CSV UTF-8), and name that file",
            ko: "통합 문서는 .xlsx만 읽는다. .xlsx나 CSV로 저장하고(다른 이름으로 저장, CSV UTF-8) 그 파일을 쓴다",
        },
        IsNoUnitOf { path: String, unit: String } => {
            en: "{path} = \"{unit}\" is no unit of vibration",
            ko: "{path} = \"{unit}\"은(는) 진동의 단위가 아니다",
        },
        IsNotOneCharacter { path: String, given: String } => {
            en: "{path} = {given} is not one character",
            ko: "{path} = {given}은(는) 한 글자가 아니다",
        },
        MustBeOneCharacter => {
            en: "must be one character, such as \",\", \";\" or \"\\t\"",
            ko: "\",\", \";\" 또는 \"\\t\"와 같은 한 글자이어야 한다",
        },
        IsThatOfChannels { path: String, value: String, first: String } => {
            en: "{path} = {value} is that of channels[{first}] too",
            ko: "{path} = {value}이(가) channels[{first}]의 값과 같다",
        },
        MustDiffer => { en: "must differ", ko: "서로 달라야 한다" },
    }
}
