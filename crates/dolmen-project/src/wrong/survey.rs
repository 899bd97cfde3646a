//! Errors of a survey, its modes or its watch.

use dolmen_words::messages;

messages! {
    /// Errors of a survey, its modes or its watch.
    pub(crate) enum WrongSurvey in "project.error.survey" {
        AndFrequenciesAreBoth { path: String, direction: String } => {
            en: "{path} and frequencies.{direction} are both given",
            ko: "{path}와(과) frequencies.{direction}이(가) 모두 있다",
        },
        KeepModesEachMode => {
            en: "keep modes: each mode there has its own frequency",
            ko: "modes만 남긴다. 각 모드에 진동수가 있다",
        },
        NameOfEntry { path: String, count: usize } => {
            en: "{path} has {count} characters",
            ko: "{path}의 글자 수가 {count}이다",
        },
        NameOfEntryMustBe(most: usize) => {
            en: "must have 1 to {most}: it tells this damage from others of its kind at the part, \"C1\"; put more into note",
            ko: "1~{most}자여야 한다. 같은 부재의 같은 손상을 구별하는 이름(\"C1\")이며 긴 설명은 note에 쓴다",
        },
        LooksLikeADate(name: String) => {
            en: "survey \"{name}\": the name looks like a date, but no day is read from it, so that compare and watch would leave the survey out or put it in a wrong place",
            ko: "조사 \"{name}\": 이름이 날짜처럼 보이나 날짜로 읽을 수 없다. compare와 watch에서 빠지거나 순서가 틀어진다",
        },
        NoSuchDirection { path: String, name: String, known: String } => {
            en: "{path}: the structure has no direction \"{name}\"; it has {known}",
            ko: "{path}: 구조물에 \"{name}\" 방향이 없다. 있는 방향: {known}",
        },
        SixDigits(name: String) => {
            en: "survey \"{name}\": six digits look like a date, but no day is read from them, so that the survey would count for nothing beside those with a date",
            ko: "조사 \"{name}\": 여섯 자리 숫자는 날짜처럼 보이나 날짜로 읽을 수 없다. 날짜가 있는 조사와 함께 있으면 판정에서 빠진다",
        },
        WriteTheDay(readings: Vec<String>) => {
            en: "which of these is meant: {readings}? Write it so",
            ko: "다음 중 어느 것인가: {readings}? 그대로 쓴다",
        },
        WriteTheYearFirst => {
            en: "write year, month and day, 2024-06-05, with a month to 12, a day that the month has and a year from 1900 to 2100",
            ko: "2024-06-05처럼 연-월-일로 쓴다. 월은 12까지, 일은 그 달에 있는 날, 연도는 1900~2100이어야 한다",
        },
        HasNoSetupsTo(path: String) => {
            en: "{path} has no setups to put together",
            ko: "{path}에 합칠 측정 배치(setups)가 없다",
        },
        LeaveMergeOutOr => {
            en: "leave merge out, or list the records as setups",
            ko: "merge를 삭제하거나 기록을 setups로 나열한다",
        },
        AndRecordsAreBoth(path: String) => {
            en: "{path} and records are both given",
            ko: "{path}와(과) records가 모두 있다",
        },
        KeepSetupsForSeveral => {
            en: "keep setups for several records, records for one",
            ko: "기록이 여럿이면 setups, 하나이면 records만 남긴다",
        },
        HoldsOneRecord(path: String) => { en: "{path} holds one record", ko: "{path}에 기록이 하나뿐이다" },
        NeedsTwoOrMore => { en: "needs two or more", ko: "둘 이상이어야 한다" },
        WriteOneRecordAs => { en: "write one record as records", ko: "기록이 하나이면 records로 쓴다" },
        DoNotTellWhich(path: String) => {
            en: "{path} do not tell which sensors stayed",
            ko: "{path}만으로는 어느 센서를 그대로 두었는지 알 수 없다",
        },
        EachNeedsNameOr => {
            en: "each needs a name, or position and direction",
            ko: "각 채널에 이름 또는 위치와 방향이 필요하다",
        },
        SensorThatStayedHas => {
            en: "a sensor that stayed has the same name (or place and direction) in every setup, one that moved another",
            ko: "그대로 둔 센서는 모든 측정 배치에서 이름(또는 위치와 방향)이 같고, 옮긴 센서는 다르다",
        },
        ChangeTemperatureFittedAnd => {
            en: "change.temperature = \"fitted\" and a coefficient are both given",
            ko: "change.temperature = \"fitted\"와 온도계수가 모두 있다",
        },
        StandsWithout { has: String, lacks: String } => {
            en: "{has} stands without {lacks}",
            ko: "{has}이(가) {lacks} 없이 주어졌다",
        },
        GiveTwistToo => {
            en: "sideways is used beside twist: give both, 0 for a floor that does not turn",
            ko: "sideways는 twist와 함께 쓴다. 둘 다 입력하고, 바닥이 회전하지 않으면 twist를 0으로 한다",
        },
        NeedsBoth => { en: "needs both", ko: "둘 다 필요하다" },
        CoefficientOfTemperatureIs => {
            en: "a coefficient of temperature is never exact: give its standard deviation, 0 if you must",
            ko: "온도계수에는 항상 오차가 있다. 표준편차를 입력한다. 없으면 0으로 한다",
        },
        DoesNotLieAbove { path: String, written: String } => {
            en: "{path} = {written} does not lie above the mode before it",
            ko: "{path} = {written}이(가) 앞 모드보다 크지 않다",
        },
        MustBeAbove(written: String) => { en: "must be above {written}", ko: "{written}보다 커야 한다" },
        ListModesOfDirection => {
            en: "list the modes of a direction in ascending order, each once",
            ko: "한 방향의 모드를 낮은 것부터 한 번씩 쓴다",
        },
        DoesNotMoveAt(path: String) => {
            en: "{path} does not move at any point",
            ko: "{path}에 움직이는 점이 없다",
        },
        AtLeastOneDisplacement => {
            en: "at least one displacement must differ from 0",
            ko: "0이 아닌 변위가 하나 이상 있어야 한다",
        },
        WouldHaveFallen { path: String, written: String } => {
            en: "{path} = {written} would have fallen",
            ko: "{path} = {written}이면 이미 넘어졌을 기울기이다",
        },
        MustBeWithin(most: String) => { en: "must be within ±{most}", ko: "±{most} 이내이어야 한다" },
        TiltIsHorizontalVertical => {
            en: "tilt is horizontal / vertical: \"1/177\", 0.00565, \"0.32 deg\" or \"5.65 mm/m\"",
            ko: "기울기는 수평/수직의 비이다: \"1/177\", 0.00565, \"0.32 deg\" 또는 \"5.65 mm/m\"",
        },
        IsNotTilt { path: String, written: String } => {
            en: "{path} = \"{written}\" is not a tilt",
            ko: "{path} = \"{written}\"은(는) 기울기가 아니다",
        },
        HasLengths { path: String, count: String } => {
            en: "{path} has {count} lengths",
            ko: "{path}에 길이가 {count}개 있다",
        },
        MustBeThreeX => { en: "must be three: x right, y away, z up", ko: "3개이어야 한다. x 오른쪽, y 안쪽, z 위쪽" },
        LimitIsLarge { path: String, inverse: String } => {
            en: "{path} is 1/{inverse}, more than limits of a tilt are: no alarm would come before that",
            ko: "{path}이(가) 1/{inverse}로 기울기 한계로는 너무 크다. 그 전에는 경보가 나오지 않는다",
        },
        LimitsAre => {
            en: "limits of a tilt are 1/600 to 1/100: is a digit missing, 1/150 for 1/15?",
            ko: "기울기 한계는 1/600~1/100이다. 1/150을 1/15로 쓴 것처럼 숫자 하나를 빠뜨렸는가?",
        },
        IsNotTiltThat(path: String) => {
            en: "{path} is not a tilt that can be a limit",
            ko: "{path}은(는) 한계로 쓸 수 있는 기울기가 아니다",
        },
        MustBeRatioOf => {
            en: "must be a ratio of 0.0001 to 0.25, or text such as \"1/150\", \"0.4 deg\", \"7 mm/m\"",
            ko: "0.0001~0.25의 비율 또는 \"1/150\", \"0.4 deg\", \"7 mm/m\"와 같은 문자열이어야 한다",
        },
        IsMissing(path: String) => { en: "{path} is missing", ko: "{path}이(가) 없다" },
        NeedsDate => { en: "needs the date: \"2018-05-10\"", ko: "날짜가 필요하다: \"2018-05-10\"" },
        NeedsRepairInspectionSensors => {
            en: "needs \"repair\", \"inspection\", \"sensors\" or \"event\"",
            ko: "\"repair\", \"inspection\", \"sensors\" 또는 \"event\"가 필요하다",
        },
        IsNotDate { path: String, date: String } => {
            en: "{path} = \"{date}\" is not a date",
            ko: "{path} = \"{date}\"은(는) 날짜가 아니다",
        },
        MustBeSuchAs => {
            en: "must be such as \"2018\", \"2018-05\" or \"2018-05-10\"",
            ko: "\"2018\", \"2018-05\" 또는 \"2018-05-10\"과 같이 써야 한다",
        },
    }
}
