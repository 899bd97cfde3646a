//! Errors of a number.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// Errors of a number.
    pub(crate) enum WrongNumber in "project.error.numbers" {
        WriteAsOr => { en: "write 2 % as 0.02 or \"2 %\"", ko: "2 %는 0.02 또는 \"2 %\"로 쓴다" },
        ZeroTo(most: String) => { en: "must be 0 to {most}", ko: "0~{most}이어야 한다" },
        ProbablySlip => { en: "probably a slip", ko: "입력 오류로 의심된다" },
        NeedsButIs { of: String, needed: Both, text: String, dimension: Both } => {
            en: "{of} needs {needed}, but \"{text}\" is {dimension}",
            ko: "{of}에는 {needed}의 단위가 필요한데 \"{text}\"은(는) {dimension}의 단위이다",
        },
        WriteMassInsteadOf(part: String) => {
            en: "write mass instead of weight in {part}",
            ko: "{part}에 weight 대신 mass를 쓴다",
        },
        WriteWeightInsteadOf(part: String) => {
            en: "write weight instead of mass in {part}",
            ko: "{part}에 mass 대신 weight를 쓴다",
        },
        AngleForRatio { of: String, text: String } => {
            en: "{of} is a ratio, but \"{text}\" is an angle",
            ko: "{of}은(는) 비율인데 \"{text}\"은(는) 각도이다",
        },
        GramsAreNone => {
            en: "g is the acceleration of gravity here: 1 g/cm3 is \"1 t/m3\"",
            ko: "g는 여기서 중력가속도이다. 1 g/cm3은 \"1 t/m3\"로 쓴다",
        },
        TangentOfAngle => {
            en: "give the number itself: a coefficient of friction is the tangent of the angle of friction (0.601 for 31°)",
            ko: "비율을 그대로 준다. 마찰계수는 마찰각의 탄젠트이다(31°이면 0.601)",
        },
        WrongKindOfUnit => { en: "wrong kind of unit", ko: "단위의 종류가 다르다" },
        HasNoUnit { path: String, given: String } => {
            en: "{path} = {given} has no unit",
            ko: "{path} = {given}에 단위가 없다",
        },
        MustBeWithIts(what: Both) => { en: "must be {what} with its unit", ko: "{what}을(를) 단위와 함께 입력한다" },
        WriteOr { one: String, other: String } => {
            en: "write {one} or {other}",
            ko: "{one} 또는 {other}(으)로 쓴다",
        },
        IsNotTilt { path: String, text: String } => {
            en: "{path} = \"{text}\" is not a tilt",
            ko: "{path} = \"{text}\"은(는) 기울기가 아니다",
        },
        MustBeNumberOr(example: Both) => {
            en: "must be a number, or text with a unit such as {example}",
            ko: "수 또는 {example}와(과) 같은 단위를 붙인 문자열이어야 한다",
        },
        IsTextNotNumber { path: String, text: String } => {
            en: "{path} = \"{text}\" is text, not a number",
            ko: "{path} = \"{text}\"은(는) 수가 아니라 문자열이다",
        },
        IsTextWithoutUnit { path: String, text: String } => {
            en: "{path} = \"{text}\" is text without a unit",
            ko: "{path} = \"{text}\"은(는) 단위가 없는 문자열이다",
        },
        WriteWithoutQuotesOr { text: String, bare: String } => {
            en: "write {text} without quotes, or with its unit: \"{text} {bare}\"",
            ko: "따옴표 없이 {text}(으)로 쓰거나 단위를 붙인다: \"{text} {bare}\"",
        },
        HoldsComma { path: String, text: String } => {
            en: "{path} = \"{text}\" holds a comma",
            ko: "{path} = \"{text}\"에 쉼표가 있다",
        },
        UnclearNumber => { en: "unclear number", ko: "수를 읽을 수 없다" },
        WriteDecimalsWithPoint => {
            en: "write decimals with a point and no thousands separator",
            ko: "소수점은 마침표로 쓰고 천 단위 구분 기호는 쓰지 않는다",
        },
        HasItsUnitTwice { path: String, text: String, unit: String } => {
            en: "{path} has its unit twice: in \"{text}\" and unit = \"{unit}\"",
            ko: "{path}의 단위가 두 번 있다. \"{text}\"와 unit = \"{unit}\"",
        },
        HasBothCovAnd(path: String) => { en: "{path} has both cov and sd", ko: "{path}에 cov와 sd가 모두 있다" },
        IdentifiedFromWhat(path: String) => {
            en: "{path} is identified, but from which survey is not said",
            ko: "{path}의 출처가 identified인데 어느 조사에서 추정했는지 없다",
        },
        SurveyBeside => {
            en: "write survey = \"NAME\" beside it; `dolmen identify --write` does",
            ko: "survey = \"이름\"을 함께 쓴다. `dolmen identify --write`가 써 준다",
        },
        SurveyWithoutSource(path: String) => {
            en: "{path} names a survey, but is not said to be identified from it",
            ko: "{path}에 survey가 있는데 출처가 identified가 아니다",
        },
        SourceIdentified => { en: "write source = \"identified\", or take survey out", ko: "source = \"identified\"를 쓰거나 survey를 삭제한다" },
        IdentifiedFromNone { path: String, survey: String } => {
            en: "{path} is identified from survey \"{survey}\", which the file does not have",
            ko: "{path}을(를) 추정한 조사 \"{survey}\"이(가) 파일에 없다",
        },
        IdentifiedInVariant { name: String, path: String } => {
            en: "variant \"{name}\" leaves {path} to a survey, but surveys are of the structure as it is",
            ko: "대안 \"{name}\"이(가) {path}을(를) 조사에서 구하게 하는데, 조사는 현 상태의 것이다",
        },
        IdentifiedAsItIs => {
            en: "write \"identified\" above the variants, and numbers in the variant",
            ko: "\"identified\"는 대안 밖에 쓰고, 대안에는 수를 쓴다",
        },
        SurveysOfFile(known: String) => { en: "it has: {known}", ko: "파일에 있는 조사: {known}" },
        LeaveScatterOut => {
            en: "samples do not draw it: leave cov or sd out",
            ko: "이 값은 표본으로 추출하지 않는다. cov나 sd를 삭제한다",
        },
        CovOrSd => { en: "keep one of them: cov = sd / value", ko: "둘 중 하나만 남긴다. cov = sd / value" },
        HasScatter { path: String, written: String } => {
            en: "{path} = {written} has a scatter",
            ko: "{path} = {written}에 변동성(cov, sd)을 줄 수 없다",
        },
        ScatterAboveZero => { en: "must be above 0 to have one", ko: "변동성을 주려면 0보다 커야 한다" },
        NumberWithCovOr => {
            en: "a number with a cov or sd stands for a lognormal variable, which is positive",
            ko: "cov나 sd가 있는 값은 양수인 대수정규 확률변수로 다룬다",
        },
        CovOutsideRange { path: String, given: String } => {
            en: "{path} = {given} is outside its range",
            ko: "{path} = {given}이(가) 범위를 벗어난다",
        },
        SdRange => { en: "must be 0 to the value itself", ko: "0에서 그 값 자체까지이어야 한다" },
        SdUnit => { en: "sd is in the unit of value", ko: "sd의 단위는 value의 단위와 같다" },
        CovIsStandardDeviation => {
            en: "cov is standard deviation / mean: 5 % is 0.05",
            ko: "cov는 표준편차 / 평균이다. 5 %는 0.05이다",
        },
        AboveZero => { en: "must be above 0", ko: "0보다 커야 한다" },
        Finite => { en: "must be a finite number", ko: "유한한 수이어야 한다" },
        IsNotNumber(path: String) => { en: "{path} is not a number", ko: "{path}이(가) 수가 아니다(NaN)" },
        CannotBe { path: String, written: String } => {
            en: "{path} = {written} cannot be",
            ko: "{path} = {written}은(는) 있을 수 없는 값이다",
        },
        OutsideRange { path: String, number: String } => {
            en: "{path} = {number} is outside its range",
            ko: "{path} = {number}이(가) 범위를 벗어난다",
        },
        MustBeWithin { least: String, most: String } => {
            en: "must be {least} to {most}",
            ko: "{least}~{most}이어야 한다",
        },
        Angle => { en: "an angle", ko: "각도" },
        IsNotDirection(path: String) => { en: "{path} is not a direction", ko: "{path}이(가) 방향이 아니다" },
        MustBeXX => {
            en: "must be \"x\", \"-x\", \"y\", \"-y\", \"z\", \"-z\", or three numbers not all 0",
            ko: "\"x\", \"-x\", \"y\", \"-y\", \"z\", \"-z\" 또는 모두 0은 아닌 세 수이어야 한다",
        },
        IfRight { help: Both, path: String } => {
            en: "{help}. If it is right, write allow = [\"{path}\"]",
            ko: "{help}. 맞는 값이면 allow = [\"{path}\"]을(를) 쓴다",
        },
        IfRightThen { help: Both, path: String } => {
            en: "{help} If it is right, write allow = [\"{path}\"]",
            ko: "{help} 맞는 값이면 allow = [\"{path}\"]을(를) 쓴다",
        },
    }
}
