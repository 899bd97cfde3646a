//! Content of a record file that is not supported, and what to do about it.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// Unsupported contents, and the remedy.
    pub(crate) enum Unread in "records.unread" {
        OnlyIndex => { en: "only the index of a file (.tdms_index)", ko: "파일의 색인(.tdms_index)뿐이다" },
        NameTdms => { en: "name the .tdms file beside it", ko: "그 옆의 .tdms 파일을 지정한다" },
        Daqmx => { en: "raw data of DAQmx with its scaling", ko: "환산계수가 붙은 DAQmx 원시 자료" },
        ExportScaled => { en: "export scaled values from LabVIEW", ko: "LabVIEW에서 환산한 값으로 내보낸다" },
        WriteNumbers => { en: "write integers or floats of up to 64 bits", ko: "64비트 이하의 정수나 실수로 저장한다" },
        Riff => { en: "the variant RF64 or RIFX", ko: "RF64 또는 RIFX 형식" },
        PlainWav => { en: "write files below 4 GiB, as plain WAV", ko: "4 GiB 미만의 일반 WAV로 저장한다" },
        WavNumbers => { en: "write it as integers of 16, 24 or 32 bits or as floats, without compression", ko: "16, 24, 32비트 정수나 실수로 압축 없이 저장한다" },
        SaveV7 => { en: "save it again with save(\"file.mat\", \"-v7\")", ko: "save(\"file.mat\", \"-v7\")로 다시 저장한다" },
        OtherFilter => { en: "an HDF5 filter other than shuffle, deflate and checksum", ko: "shuffle, deflate, 체크섬이 아닌 HDF5 필터" },
        OtherLayout => { en: "an HDF5 layout that MATLAB does not write", ko: "MATLAB이 쓰지 않는 HDF5 배치" },
        SharedMessages => { en: "HDF5 messages that objects share", ko: "객체가 공유하는 HDF5 메시지" },
        LargeGroup => { en: "an HDF5 group with so many members that they stand apart", ko: "구성원이 너무 많아 따로 저장된 HDF5 그룹" },
        SaveAlone => { en: "save the record alone, or with save(\"file.mat\", \"-v7\")", ko: "기록만 저장하거나 save(\"file.mat\", \"-v7\")로 저장한다" },
        SaveMatrix => { en: "save the samples as a matrix of its own, not within a struct or cell", ko: "자료를 struct나 cell이 아닌 별도의 행렬로 저장한다" },
        TimesAlone => { en: "time stamps without samples", ko: "자료 없이 시각만 있다" },
        SaveBeside => { en: "save the samples beside them", ko: "자료를 함께 저장한다" },
        UnevenStamps => { en: "holds time stamps that are not even: samples are missing or the clock jumped", ko: "시각의 간격이 일정하지 않다. 자료가 빠졌거나 시계가 튀었다" },
        Dataset58 => { en: "export the time series as dataset 58, function type 1", ko: "시계열을 데이터셋 58(기능 유형 1)로 내보낸다" },
        Ieee754 => { en: "write IEEE 754 (kind 2), or text", ko: "IEEE 754(종류 2)나 텍스트로 저장한다" },
        Resample => { en: "resample it to even steps of real numbers", ko: "간격이 일정한 실수로 재표본화한다" },
        SaveV6 => { en: "save it with save(\"file.mat\", \"-v6\"), which packs nothing", ko: "압축하지 않는 save(\"file.mat\", \"-v6\")로 저장한다" },
        Channels => { en: "channels", ko: "채널" },
        Variables => { en: "variables", ko: "변수" },
        GroupsAndChannels => { en: "groups and channels", ko: "그룹과 채널" },
        ComplexNumbers => { en: "complex numbers", ko: "복소수" },
        UnevenSteps => { en: "uneven steps", ko: "일정하지 않은 간격" },
        WithoutAny => { en: "without any", ko: "없음" },
        Nothing => { en: "nothing", ko: "없음" },
        FileOf(format: String) => { en: "a {format} file", ko: "{format} 파일" },
        NpyFile => { en: "an npy file", ko: "npy 파일" },
        WorkbookFile => { en: "a workbook or a ZIP", ko: "통합 문서나 ZIP 파일" },
        Text => { en: "text", ko: "텍스트" },
        BinaryFile => { en: "a binary file", ko: "이진 파일" },
        SamplesOfType { code: String, path: String } => {
            en: "samples of type {code} in {path}",
            ko: "{path}의 종류 {code} 자료",
        },
        ScalingsOfChannel { path: String, scales: String } => {
            en: "channel {path} with {scales} scalings of its own",
            ko: "환산계수가 {scales}개 붙은 채널 {path}",
        },
        CodedSamples { bits: String, sort: String } => {
            en: "samples of {bits} bits coded as {sort}",
            ko: "부호화 {sort}인 {bits}비트 자료",
        },
        NoMatrix(held: Both) => {
            en: "no numeric matrix of samples (it holds {held})",
            ko: "자료의 수 행렬이 없다(들어 있는 것: {held})",
        },
        Rate(rate: f64) => {
            en: "gives a sampling rate of {rate} Hz",
            ko: "샘플링 주파수가 {rate} Hz이다",
        },
        TwoRates { rate: f64, other: f64 } => {
            en: "gives a sampling rate of {rate} Hz, but another {other} Hz",
            ko: "샘플링 주파수가 {rate} Hz인데 다른 곳에서는 {other} Hz이다",
        },
        NoSeries(held: Both) => {
            en: "no time series (it holds datasets {held})",
            ko: "시계열이 없다(들어 있는 데이터셋: {held})",
        },
        NoModes(held: Both) => {
            en: "no modes (it holds datasets {held})",
            ko: "모드가 없다(들어 있는 데이터셋: {held})",
        },
        Dataset55 => {
            en: "export the modes as dataset 55, normal modes or complex eigenvalues",
            ko: "모드를 데이터셋 55(고유모드 또는 복소고유값)로 내보낸다",
        },
        TurnedAxes => {
            en: "axes that turn from node to node (dataset 18 or 2420)",
            ko: "절점마다 방향이 다른 좌표축(데이터셋 18 또는 2420)",
        },
        GlobalAxes => {
            en: "export the modes in global axes, without dataset 18 and 2420",
            ko: "데이터셋 18과 2420 없이 전체 좌표계로 모드를 내보낸다",
        },
        BinaryNumbers(floats: String) => {
            en: "binary numbers of kind {floats} (VAX, IBM)",
            ko: "종류 {floats}의 이진수(VAX, IBM)",
        },
        SeriesOf { numbers: Both, line: usize } => {
            en: "a time series of {numbers} (line {line})",
            ko: "{numbers}의 시계열({line}행)",
        },
    }
}

messages! {
    /// The expected form of a line in a text file.
    pub(crate) enum Expected in "records.expected" {
        DatasetBegins => { en: "the −1 that begins a dataset", ko: "데이터셋을 시작하는 −1" },
        Title151 => { en: "the title of a dataset 151", ko: "데이터셋 151의 제목" },
        DatasetNumber => { en: "the number of a dataset", ko: "데이터셋의 번호" },
        DatasetEnds => { en: "the −1 that ends a dataset", ko: "데이터셋을 끝내는 −1" },
        Header58b => { en: "\"58b\", order of bytes, of floats, 11 lines, bytes", ko: "\"58b\", 바이트 순서, 실수 순서, 11행, 바이트 수" },
        ByteOrder58b => { en: "a 58b with order of bytes 1 or 2", ko: "바이트 순서가 1이나 2인 58b" },
        Lines58 => { en: "one of the 11 lines of a dataset 58", ko: "데이터셋 58의 11행 중 하나" },
        Codes58 => { en: "the codes of a dataset 58 in their columns", ko: "제자리 열에 있는 데이터셋 58의 코드" },
        CountOfSamples => { en: "a count of samples", ko: "자료의 수" },
        NumberKind => { en: "numbers of kind 2, 4, 5 or 6", ko: "종류 2, 4, 5, 6의 수" },
        FirstTimeAndStep => { en: "a first time and a positive step, s", ko: "첫 시각과 양의 시간 간격(s)" },
        Samples58 => { en: "the samples of a dataset 58", ko: "데이터셋 58의 자료" },
        LineOfSamples => { en: "a line of samples", ko: "자료의 행" },
        Lines55 => { en: "one of the five lines of text of a dataset 55", ko: "데이터셋 55의 문자 다섯 행 중 하나" },
        Codes55 => { en: "the six codes of a dataset 55 in their columns", ko: "제자리 열에 있는 데이터셋 55의 코드 여섯 개" },
        Vectors55 => {
            en: "a mode shape of real (2) or complex (5) vectors with three or six values a node",
            ko: "절점마다 값이 3개나 6개인 실수(2) 또는 복소수(5) 벡터의 모드형상",
        },
        Integers55 => { en: "the load case and the number of the mode", ko: "하중조건과 모드의 번호" },
        Frequency55 => {
            en: "the frequency (Hz) or the complex eigenvalue (rad/s) of a mode",
            ko: "모드의 고유진동수(Hz) 또는 복소고유값(rad/s)",
        },
        FrequencyAndDamping55 => {
            en: "a frequency above 0 with a damping ratio of at least 0 and below 1",
            ko: "0보다 큰 고유진동수와 0 이상 1 미만인 감쇠비",
        },
        Values55 => { en: "the values of a node", ko: "절점의 값" },
        Node => { en: "a node: label, three codes, x, y, z", ko: "절점: 번호, 코드 3개, x, y, z" },
        NodeLabel => { en: "the label of a node", ko: "절점의 번호" },
        NodeCoordinates => { en: "the coordinates of a node", ko: "절점의 좌표" },
        NodePlace => { en: "x, y, z of a node", ko: "절점의 x, y, z" },
        UnitsCode => { en: "the code of a system of units", ko: "단위계의 코드" },
        UnitFactors => { en: "the factors of length, force and temperature", ko: "길이, 힘, 온도의 계수" },
        SafChannels => { en: "CH0_ID, CH1_ID, … (the channels)", ko: "CH0_ID, CH1_ID, …(채널)" },
        SafRate => { en: "a sampling rate, Hz", ko: "샘플링 주파수(Hz)" },
        NumberOfSamples => { en: "a number of samples", ko: "자료의 수" },
        SafTime => { en: "year month day hour minute second", ko: "년 월 일 시 분 초" },
        SafNextChannel => { en: "the next channel: CH0_ID, CH1_ID, … in order", ko: "순서대로 다음 채널(CH0_ID, CH1_ID, …)" },
        SafEnd => { en: "the line #### that ends it", ko: "머리글을 끝내는 #### 행" },
    }
}
