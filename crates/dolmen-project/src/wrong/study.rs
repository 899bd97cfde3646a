//! Errors of a study.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// Errors of a study.
    pub(crate) enum WrongStudy in "project.error.study" {
        SetAndVary(path: String) => { en: "{path}: set and vary", ko: "{path}: set과 vary" },
        HasPeriods { path: String, count: String } => {
            en: "{path} has {count} periods",
            ko: "{path}의 주기가 {count}개이다",
        },
        MustHaveAtMost(most: String) => { en: "must have at most {most}", ko: "{most}개 이하이어야 한다" },
        SevereOffsetRatioIs { path: String, severe_offset_ratio: String, offset_ratio: String } => {
            en: "{path}: severe_offset_ratio is {severe_offset_ratio}, below offset_ratio, {offset_ratio}",
            ko: "{path}: severe_offset_ratio = {severe_offset_ratio}이(가) offset_ratio = {offset_ratio}보다 작다",
        },
        Ds3IsWorseThan => {
            en: "DS3 is worse than DS2: give both, the larger one for DS3",
            ko: "DS3은 DS2보다 심한 상태이다. 두 값을 모두 주되 DS3에 큰 값을 준다",
        },
        AreNoLimits { path: String, words: String } => {
            en: "{path} = [{words}] are no limits",
            ko: "{path} = [{words}]은(는) 한계값으로 쓸 수 없다",
        },
        MustBeRisingTo { least: String, most: String } => {
            en: "must be 4, rising, {least} to {most}",
            ko: "{least}~{most} 범위에서 커지는 4개의 값이어야 한다",
        },
        DriftsOverHeightOf => {
            en: "drifts over the height of the storey: 1 % is 0.01",
            ko: "층고에 대한 층간변위의 비이다. 1 %는 0.01이다",
        },
        HasTwice { path: Both, item: String } => {
            en: "{path} has {item} twice",
            ko: "{path}에 {item}이(가) 두 번 있다",
        },
        MustHaveEachOnce => { en: "must have each once", ko: "하나씩만 있어야 한다" },
        LeaveOneOfThem => {
            en: "leave one of them out: runs of the same count as more scans than there are",
            ko: "하나를 삭제한다. 같은 해석을 두 번 세면 해석 수가 실제보다 많아진다",
        },
        GoesUpToOnly { path: String, peak_g: String } => {
            en: "{path} goes up to {peak_g} g only: nothing falls by shaking that is hardly felt",
            ko: "{path}의 최댓값이 {peak_g} g에 불과하다. 거의 느껴지지 않는 지반운동에는 아무것도 쓰러지지 않는다",
        },
        AreTheseG => {
            en: "earthquakes have 0.05 to 2 g, 50 to 2000 gal: are these g, not gal?",
            ko: "지진은 0.05~2 g(50~2000 gal)이다. gal이 아니라 g 단위의 값인가?",
        },
        GoesUpToG { path: String, peak_g: String } => {
            en: "{path} goes up to {peak_g} g",
            ko: "{path}이(가) {peak_g} g까지 올라간다",
        },
        MustBeGOr => { en: "must be 10 g or below", ko: "10 g 이하이어야 한다" },
        NoGroundMovesLike => {
            en: "no ground moves like that: is the unit right?",
            ko: "그런 지반운동은 없다. 단위가 맞는가?",
        },
        CannotBe { path: String, given: String } => {
            en: "{path} = {given} cannot be",
            ko: "{path} = {given}은(는) 쓸 수 없는 값이다",
        },
        IsNotKnown { path: String, given: String } => {
            en: "{path} = {given} is not known",
            ko: "{path} = {given}은(는) 쓸 수 없는 값이다",
        },
        MustBeOr => { en: "must be 4, 9, 16 or 36", ko: "4, 9, 16 또는 36이어야 한다" },
        IsNotVaried { path: String, input: String } => {
            en: "{path} = \"{input}\" is not varied",
            ko: "{path} = \"{input}\"은(는) 변화시키는 입력이 아니다",
        },
        VariedAre(known: String) => { en: "varied are {known}", ko: "변화시키는 입력: {known}" },
        IsNoPath { place: String, path: String } => {
            en: "{place}: \"{path}\" is no path",
            ko: "{place}: \"{path}\"은(는) 값의 경로가 아니다",
        },
        WriteItAsJoint => {
            en: "write it as \"joint.friction\" or \"links[2].weight\"",
            ko: "\"joint.friction\" 또는 \"links[2].weight\"와 같이 쓴다",
        },
        IsOneValue(path: String) => { en: "{path} is one value", ko: "{path}이(가) 값 하나이다" },
        MustBeListOr => { en: "must be a list or a range", ko: "목록 또는 범위이어야 한다" },
        WriteOrFromTo => {
            en: "write [ … ] or {{ from = …, to = …, steps = … }}; what all runs share stands in set",
            ko: "[ … ] 또는 {{ from = …, to = …, steps = … }}로 쓴다. 모든 해석에 공통인 값은 set에 쓴다",
        },
        HasValues { path: String, count: String } => {
            en: "{path} has {count} values",
            ko: "{path}의 값이 {count}개이다",
        },
        MustHaveTo(most: String) => { en: "must have 1 to {most}", ko: "1~{most}개이어야 한다" },
        HasNoKey { path: String, other: String } => {
            en: "{path} has no key \"{other}\"",
            ko: "{path}에 \"{other}\" 키는 없다",
        },
        WriteFromToSteps => {
            en: "write {{ from = …, to = …, steps = … }} and, if wanted, spacing = \"logarithmic\"",
            ko: "{{ from = …, to = …, steps = … }}를 쓰고 필요하면 spacing = \"logarithmic\"을 더한다",
        },
        IsNoRange(path: String) => { en: "{path} is no range", ko: "{path}이(가) 범위가 아니다" },
        WriteFromToStepsWith => {
            en: "write {{ from = 3, to = 9, steps = 8 }}, with units in quotes: from = \"0.1 g\"; spacing is \"linear\" or \"logarithmic\"",
            ko: "{{ from = 3, to = 9, steps = 8 }}과 같이 쓴다. 단위는 따옴표로 묶는다(from = \"0.1 g\"). spacing은 \"linear\" 또는 \"logarithmic\"이다",
        },
        GoesFromTo { path: String, from: String, to: String } => {
            en: "{path} goes from {from} to {to}",
            ko: "{path}의 범위가 {from}에서 {to}까지이다",
        },
        WriteBothEndsIn => { en: "write both ends in the same unit", ko: "양끝을 같은 단위로 쓴다" },
        HasStepsFromTo { path: String, steps: String, from: String, to: String } => {
            en: "{path} has {steps} steps from {from} to {to}",
            ko: "{path}에 {from}에서 {to}까지 {steps}단계가 있다",
        },
        TakeToStepsBetween => {
            en: "take 2 to 10 000 steps between two different numbers, both above 0 if the spacing is logarithmic",
            ko: "서로 다른 두 수 사이를 2~10 000단계로 나눈다. spacing이 logarithmic이면 두 수 모두 0보다 커야 한다",
        },
        DoesNotRiseFrom(path: String) => {
            en: "{path} does not rise from value to value",
            ko: "{path}의 값이 차례로 커지지 않는다",
        },
        MustBeRising => { en: "must be rising", ko: "커지는 순서이어야 한다" },
        GiveEachValueOnce => {
            en: "give each value once, the least first; a range needs from below to, and 2 to 10 000 steps",
            ko: "작은 값부터 한 번씩 쓴다. 범위는 from이 to보다 작고 2~10 000단계이어야 한다",
        },
    }
}
