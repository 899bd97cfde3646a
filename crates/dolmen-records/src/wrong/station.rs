//! Errors in the file of a seismic station, with their place in the file.

use dolmen_words::messages;

messages! {
    /// What the file should have at a place, or why the content there is wrong.
    pub(crate) enum OfStation in "seismic.place" {
        Velocities => { en: "velocities", ko: "속도" },
        Displacements => { en: "displacements", ko: "변위" },
        CosmosTitle => { en: "the first line of a COSMOS channel, \"… acceleration (Format v01.20 with 13 text lines)\"", ko: "COSMOS 채널의 첫 행, \"… acceleration (Format v01.20 with 13 text lines)\"" },
        CosmosFirst => { en: "the first line of a COSMOS channel", ko: "COSMOS 채널의 첫 행" },
        CosmosData => { en: "the line before the samples, \"42000 acceleration pts, approx 210 secs, units=cm/sec2(04),Format=(8F10.5)\"", ko: "자료 앞의 행, \"42000 acceleration pts, approx 210 secs, units=cm/sec2(04),Format=(8F10.5)\"" },
        CosmosText => { en: "a line of the text header", ko: "텍스트 머리글의 행" },
        CosmosIntegers => { en: "\"100 Integer-header values follow on  10 lines, Format= (10I8)\"", ko: "\"100 Integer-header values follow on  10 lines, Format= (10I8)\"와 같은 행" },
        CosmosReals => { en: "\"100 Real-header values follow on  20 lines, Format= (5F15.6)\"", ko: "\"100 Real-header values follow on  20 lines, Format= (5F15.6)\"와 같은 행" },
        CosmosComments => { en: "\"6 Comment line(s) follow\"", ko: "\"6 Comment line(s) follow\"와 같은 행" },
        CosmosComment => { en: "a comment", ko: "주석" },
        ResponseStation => { en: "\"B050F03 Station: …\", with which a response begins (RESP)", ko: "계기응답(RESP)이 시작되는 \"B050F03 Station: …\" 행" },
        ResponseChannel => { en: "the beginning of a response with its channel, B052F04", ko: "채널(B052F04)이 있는 계기응답" },
        ResponseTime => { en: "a time, \"2015,001,00:00:00\": year, day of year, time", ko: "\"2015,001,00:00:00\"와 같은 시각(연, 연중 일수, 시각)" },
        ResponseUnit => { en: "a response whose first stage measures M, M/S or M/S**2 (B053F05)", ko: "첫 단의 입력 단위가 M, M/S, M/S**2인 계기응답(B053F05)" },
        ResponseGain => { en: "a response with its sensitivity, B058F04, a number other than 0", ko: "0이 아닌 감도(B058F04)가 있는 계기응답" },
        NoAccelerations => { en: "no accelerations", ko: "가속도가 아닌 자료" },
        CosmosEnd => { en: "\"End-of-data\" after the samples", ko: "자료 뒤의 \"End-of-data\"" },
        CosmosOther => { en: "the line before velocities or displacements", ko: "속도나 변위 앞의 행" },
        CosmosOtherEnd => { en: "\"End-of-data\" after velocities or displacements", ko: "속도나 변위 뒤의 \"End-of-data\"" },
        CsmipData => { en: "a count, a time step, a unit and a format before the samples", ko: "자료 앞의 개수, 시간 간격, 단위, 형식" },
        EsmStep => { en: "a time step in seconds", ko: "초 단위의 시간 간격" },
        EsmCount => { en: "a number of samples", ko: "자료의 수" },
        EsmType => { en: "\"ACCELERATION\" as the data type", ko: "자료 종류 \"ACCELERATION\"" },
        KnetHeader => { en: "one of the 17 lines of a K-NET header", ko: "K-NET 머리글 17행 중 하나" },
        KnetRate => { en: "a sampling rate such as 100Hz", ko: "100Hz와 같은 샘플링 주파수" },
        KnetDuration => { en: "a duration in seconds", ko: "초 단위의 길이" },
        KnetScale => { en: "a scale such as 3920(gal)/6182761", ko: "3920(gal)/6182761과 같은 배율" },
        KnetPeak => { en: "the peak in gal", ko: "gal 단위의 최대값" },
        NumbersInColumns => { en: "a line of numbers in the columns that the header tells", ko: "머리글의 열에 맞는 수의 행" },
        FieldOutside => { en: "a field lies outside of the record", ko: "필드가 레코드 밖에 있다" },
        NoDataRecord => { en: "no header of a data record begins here", ko: "여기서 시작하는 자료 레코드의 머리글이 없다" },
        NoRecordHolds => { en: "no record holds samples", ko: "자료가 있는 레코드가 없다" },
        YearAndDay => { en: "the year and day of the header are none in either byte order", ko: "머리글의 연도와 날짜가 어느 바이트 순서로도 올바르지 않다" },
        Year => { en: "the year is none", ko: "연도가 올바르지 않다" },
        Blockettes => { en: "the blockettes of the record go round in a circle", ko: "레코드의 블로켓이 서로 맞물려 끝나지 않는다" },
        NoBlockette1000 => { en: "blockette 1000, which says how samples are coded, is missing", ko: "자료의 부호화를 나타내는 블로켓 1000이 없다" },
        RecordLength => { en: "the length of the record is none that SEED allows", ko: "레코드의 길이가 SEED에서 쓸 수 있는 길이가 아니다" },
        RateNotPositive => { en: "the sampling rate is not positive", ko: "샘플링 주파수가 양수가 아니다" },
        SamplesOutside => { en: "the samples begin outside of the record", ko: "자료가 레코드 밖에서 시작한다" },
        RecordTooShort => { en: "the record is too short for its samples", ko: "레코드가 자료보다 짧다" },
        SacType => { en: "IFTYPE must be 1, a time series", ko: "IFTYPE은 시계열을 뜻하는 1이어야 한다" },
        SacEven => { en: "LEVEN must be 1, even steps: resample it before", ko: "LEVEN은 일정한 간격을 뜻하는 1이어야 한다. 먼저 재표본화한다" },
        SacStep => { en: "DELTA must be a positive time step, s", ko: "DELTA는 양의 시간 간격(s)이어야 한다" },
        SacCount => { en: "NPTS must be the number of samples", ko: "NPTS는 자료의 수이어야 한다" },
        SacNumbers => { en: "a line of 5 numbers of a SAC header", ko: "SAC 머리글의 수 5개인 행" },
        SacTexts => { en: "a line of texts of a SAC header", ko: "SAC 머리글의 텍스트 행" },
        SteimCode => { en: "a word of its frames has a code that Steim packing does not know", ko: "프레임의 워드에 Steim 압축에 없는 코드가 있다" },
        SteimFewer => { en: "its frames hold fewer samples than the header says", ko: "프레임의 자료가 머리글의 수보다 적다" },
        SteimLast => { en: "the last sample unpacked is not the one that the first frame tells: the record is damaged", ko: "푼 마지막 자료가 첫 프레임의 값과 다르다. 손상된 레코드이다" },
    }
}

messages! {
    /// Why channels cannot be rotated to x, y and z.
    pub(crate) enum Turned in "motions.turned" {
        Azimuth(azimuth_deg: f64) => {
            en: "the azimuth of x is {azimuth_deg}, but must be a number of degrees",
            ko: "x의 방위각이 {azimuth_deg}인데 도 단위의 수이어야 한다",
        },
        NoDirection(channel: String) => {
            en: "channel \"{channel}\" does not say which way it points",
            ko: "채널 \"{channel}\"의 방향을 알 수 없다",
        },
        ChannelsOfDirections { horizontal: usize, vertical: usize } => {
            en: "there are {horizontal} horizontal and {vertical} vertical channels, but must be two and at most one",
            ko: "수평 채널이 {horizontal}개, 연직 채널이 {vertical}개인데 수평 2개, 연직 1개 이하이어야 한다",
        },
        VerticalAs { channel: String, component: String } => {
            en: "channel \"{channel}\" is vertical by its name, but is given as {component}",
            ko: "채널 \"{channel}\"은(는) 이름으로 보아 연직인데 {component}(으)로 지정되었다",
        },
        HorizontalAs { channel: String, component: String } => {
            en: "channel \"{channel}\" is horizontal by its name, but is given as {component}",
            ko: "채널 \"{channel}\"은(는) 이름으로 보아 수평인데 {component}(으)로 지정되었다",
        },
        TakenTwice { channel: String, first: String, second: String } => {
            en: "channel \"{channel}\" is given as {first} and as {second}",
            ko: "채널 \"{channel}\"이(가) {first}와(과) {second}에 모두 지정되었다",
        },
        NearlyParallel { first_deg: f64, second_deg: f64 } => {
            en: "the horizontal channels point to {first_deg}° and {second_deg}°, less than 30° apart",
            ko: "수평 채널의 방위각이 {first_deg}°와 {second_deg}°로 30°보다 가깝다",
        },
    }
}
