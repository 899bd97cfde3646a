//! Remarks on a file, in both languages.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// Remarks on a file.
    pub(crate) enum Remark in "records.remark" {
        Begins(time: String) => {
            en: "begins {time} by its clock (time zone not said)",
            ko: "기록 장치의 시계로 {time}에 시작한다(시간대 표시 없음)",
        },
        BeginsUtc(time: String) => { en: "begins {time} UTC", ko: "{time} UTC에 시작한다" },
        BeginsOfTwoZones(time: String) => {
            en: "begins {time}: some of its files say times in UTC, others without a time zone, and they are taken for one clock: if theirs is another, the files do not belong together as they are joined",
            ko: "{time}에 시작한다. 일부 파일의 시각은 UTC이고 나머지는 시간대 표시가 없어 같은 시계로 보았다. 시계가 다르면 이렇게 이은 파일은 서로 맞지 않는다",
        },
        BeginsOfClock(seconds: String) => {
            en: "begins at {seconds} s of the clock given",
            ko: "입력한 시계의 {seconds} s에 시작한다",
        },
        Joined(files: usize) => {
            en: "{files} files joined, their clocks taken as right: a clock that is late or drifts turns shapes across files, and their signs",
            ko: "파일 {files}개를 시계가 맞는 것으로 보고 이었다. 늦거나 빨라지는 시계가 있으면 파일 사이의 모드형상과 부호가 바뀐다",
        },
        Cp949 => {
            en: "the text is in CP949 (EUC-KR) and was read as that",
            ko: "텍스트가 CP949(EUC-KR)이므로 그에 맞게 읽었다",
        },
        NamesUnread => {
            en: "names of columns are neither UTF-8 nor CP949: those columns are called ch1, ch2, … by their number; save the file as UTF-8 to have their names",
            ko: "열 이름이 UTF-8도 CP949도 아니므로 그 열을 번호에 따라 ch1, ch2, …로 부른다. 이름을 쓰려면 파일을 UTF-8로 저장한다",
        },
        LinePassedOver(line: usize) => {
            en: "line {line} stands above the names of the columns and is passed over",
            ko: "열 이름 위의 {line}행은 읽지 않았다",
        },
        PassedOver { first: usize, last: usize } => {
            en: "lines {first} to {last} stand above the names of the columns and are passed over",
            ko: "열 이름 위의 {first}~{last}행은 읽지 않았다",
        },
        NoUnitGiven { column: String, unit: String } => {
            en: "column \"{column}\" says {unit}, and no unit is given: numbers are kept as they are«; unit = \"{unit}\" takes them as that»",
            ko: "\"{column}\" 열의 이름에는 단위가 {unit}인데 unit을 입력하지 않아 수를 그대로 두었다«. unit = \"{unit}\"(으)로 하면 그 단위로 읽는다»",
        },
        UnreadStamps(column: String) => {
            en: "column \"{column}\" is not read as times: nothing in the file confirms the sampling rate given",
            ko: "\"{column}\" 열을 시각으로 읽지 못하였다. 입력한 샘플링 주파수를 확인할 자료가 파일에 없다",
        },
        Milliseconds(column: String) => {
            en: "the time stamps of column \"{column}\" are read as milliseconds: their steps say so",
            ko: "\"{column}\" 열의 시각은 간격으로 보아 밀리초로 읽었다",
        },
        Microseconds(column: String) => {
            en: "the time stamps of column \"{column}\" are read as microseconds: their steps say so",
            ko: "\"{column}\" 열의 시각은 간격으로 보아 마이크로초로 읽었다",
        },
        Seconds(column: String) => {
            en: "the time stamps of column \"{column}\" are read as seconds: «sampling_rate|the sampling rate» says so",
            ko: "\"{column}\" 열의 시각은 «sampling_rate에|샘플링 주파수에» 따라 초로 읽었다",
        },
        Minutes(column: String) => {
            en: "the time stamps of column \"{column}\" are read as minutes: «sampling_rate|the sampling rate» says so",
            ko: "\"{column}\" 열의 시각은 «sampling_rate에|샘플링 주파수에» 따라 분으로 읽었다",
        },
        Hours(column: String) => {
            en: "the time stamps of column \"{column}\" are read as hours: «sampling_rate|the sampling rate» says so",
            ko: "\"{column}\" 열의 시각은 «sampling_rate에|샘플링 주파수에» 따라 시간(h)으로 읽었다",
        },
        VariablesUnread(names: Both) => { en: "variables not read: {names}", ko: "읽지 않은 변수: {names}" },
        DatasetsUnread(numbers: Both) => { en: "datasets not read: {numbers}", ko: "읽지 않은 데이터셋: {numbers}" },
        TextBlocks(count: usize) => {
            en: "blocks of text of the recorder, not read: {count}",
            ko: "기록 장치의 텍스트 블록 {count}개는 읽지 않았다",
        },
        Title(title: String) => { en: "title \"{title}\"", ko: "제목 \"{title}\"" },
        StationName(station: String) => { en: "station {station}", ko: "관측점 {station}" },
        TurnedAxes => {
            en: "the file turns axes of nodes (dataset 18 or 2420): places and directions were not taken from it",
            ko: "파일이 절점의 좌표축을 회전하므로(데이터셋 18 또는 2420) 위치와 방향은 읽지 않았다",
        },
        PointsFromNorth { channel: String, azimuth_deg: f64 } => {
            en: "{channel} points {azimuth_deg}° from north",
            ko: "{channel}의 방향은 북에서 시계 방향으로 {azimuth_deg}°이다",
        },
        PointsUp(channel: String) => { en: "{channel} points up", ko: "{channel}의 방향은 위쪽이다" },
        PointsDown(channel: String) => { en: "{channel} points down", ko: "{channel}의 방향은 아래쪽이다" },
        Days(column: String) => {
            en: "the time stamps of column \"{column}\" are read as days, as tables keep dates: their steps say so",
            ko: "\"{column}\" 열의 시각은 간격으로 보아 표가 날짜를 적는 일수로 읽었다",
        },
    }
}
