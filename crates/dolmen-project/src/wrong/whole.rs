//! Errors of the parts of a file as a whole.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// Errors of the parts of a file as a whole.
    pub(crate) enum WrongFile in "project.error.whole" {
        ThereIsNoVariant(name: String) => {
            en: "there is no variant \"{name}\"",
            ko: "대안 \"{name}\"이(가) 없다",
        },
        IsNoPathOf { path: String, text: String } => {
            en: "\"{path}\" is no path of a value, or {text} no value",
            ko: "\"{path}\"이(가) 값의 경로가 아니거나 {text}이(가) 값이 아니다",
        },
        WriteItAsJoint => {
            en: "write it as joint.friction or links[2].weight",
            ko: "joint.friction 또는 links[2].weight와 같이 쓴다",
        },
        MotionMovesStructureBut => {
            en: "\"motion\" moves a structure, but this file has kind = \"survey\"",
            ko: "\"motion\"은 구조물에 작용시키는 입력지진인데 이 파일은 kind = \"survey\"이다",
        },
        TakeItOutOr => {
            en: "take it out, or write the kind of the structure with its parts",
            ko: "삭제하거나 구조물의 kind와 부재를 입력한다",
        },
        BelongsToKindBut { name: String, owner: String, kind: String } => {
            en: "\"{name}\" belongs to kind = \"{owner}\", but this file has kind = \"{kind}\"",
            ko: "\"{name}\"은(는) kind = \"{owner}\"의 키인데 이 파일은 kind = \"{kind}\"이다",
        },
        DampingOfBuilding => {
            en: "the damping of a building is damping = {{ ratio = 0.02 }}",
            ko: "building의 감쇠비는 damping = {{ ratio = 0.02 }}와 같이 쓴다",
        },
        TakeItOutOrWrite(owner: String) => {
            en: "take it out, or write kind = \"{owner}\"",
            ko: "삭제하거나 kind를 바꾼다: kind = \"{owner}\"",
        },
        FramesAndChains => { en: "frames and chains", ko: "frame과 chain" },
        IsForButThis { name: String, words: Both, kind: String } => {
            en: "{name} is for {words}, but this file has a {kind}",
            ko: "{name}은(는) {words}에만 쓰는데 이 파일은 kind = \"{kind}\"이다",
        },
        TakeItOutDirections => {
            en: "take it out; directions = [\"0 deg\", …] turn the motion",
            ko: "삭제한다. 입력지진의 방향은 directions = [\"0 deg\", …]로 바꾼다",
        },
        HasNoElement { path: String, key: String } => {
            en: "{path} has no element \"{key}\"",
            ko: "{path}에 \"{key}\"번째 항목이 없다",
        },
        MustBeNumberFrom(count: String) => {
            en: "must be a number from 1 to {count}",
            ko: "1~{count}의 번호이어야 한다",
        },
        ListIsChangedBy(path: String) => {
            en: "a list is changed by number, {path} = {{ 2 = {{ … }} }}, or replaced: {path} = [ … ]",
            ko: "목록은 번호로 일부를 바꾸거나({path} = {{ 2 = {{ … }} }}) 전체를 바꾼다({path} = [ … ])",
        },
        HasBothWeightAnd(path: String) => {
            en: "{path} has both weight and mass",
            ko: "{path}에 weight와 mass가 모두 있다",
        },
        EitherOne => { en: "must be one of them", ko: "둘 중 하나이어야 한다" },
        TakeOneOutWeight => {
            en: "take one out: weight = mass × gravity",
            ko: "하나를 삭제한다. weight = mass × 중력가속도",
        },
        HasNeitherWeightNor(path: String) => {
            en: "{path} has neither weight nor mass",
            ko: "{path}에 weight도 mass도 없다",
        },
        GiveWeightForceOr => {
            en: "give weight = … (a force) or mass = …",
            ko: "weight = …(무게) 또는 mass = …(질량)을 입력한다",
        },
        HasElements { path: String, count: String } => {
            en: "{path} has {count} elements",
            ko: "{path}의 항목이 {count}개이다",
        },
        MustBeTo(most: String) => { en: "must be 1 to {most}", ko: "1~{most}개이어야 한다" },
        HasElementsFor { path: String, count: String, needed: String, part: String } => {
            en: "{path} has {count} elements for {needed} {part}",
            ko: "{path}의 항목은 {count}개인데 {part}은(는) {needed}개이다",
        },
        MustBeOneFor { needed: String, part: String } => {
            en: "must be {needed}, one for each of the {part}, lowest first",
            ko: "{part}마다 하나씩 아래에서부터 {needed}개를 입력한다",
        },
        MustBe { n: String, as_written: Both } => {
            en: "must be {n}: {as_written}",
            ko: "{n}개이어야 한다: {as_written}",
        },
        VariantIsNotTable => { en: "variant is not a table", ko: "variant가 표가 아니다" },
        MustBeTable => { en: "must be a table", ko: "표이어야 한다" },
        WriteVariantNameAbove => {
            en: "write [variant.NAME] above what it changes",
            ko: "바꿀 내용 위에 [variant.이름]을 쓴다",
        },
        WriteVariantOrTake(name: String) => {
            en: "write [variant.{name}], or take it out",
            ko: "[variant.{name}]을(를) 쓰거나 삭제한다",
        },
        MustBeOneOf(known: String) => { en: "must be one of {known}", ko: "다음 중 하나이어야 한다: {known}" },
        NeedsText => { en: "needs text", ko: "문자열이 필요하다" },
        NamesNothing { path: String, name: String } => {
            en: "{path} has \"{name}\", which is no part, survey or motion of this file",
            ko: "{path}의 \"{name}\"은(는) 이 파일의 부재, 조사, 지반운동의 이름이 아니다",
        },
        NameAsFileDoes => {
            en: "write the name on the left as the file has it: [names.ko] with \"base\" = \"기단\"",
            ko: "왼쪽에는 파일에 있는 이름을 그대로 쓴다. 예: [names.ko]에 \"base\" = \"기단\"",
        },
        NameEnKoOr => {
            en: "name = {{ en = \"…\", ko = \"…\" }}, or one of them",
            ko: "name = {{ en = \"…\", ko = \"…\" }} 또는 둘 중 하나를 쓴다",
        },
        IsNotTable(path: String) => { en: "{path} is not a table", ko: "{path}이(가) 표가 아니다" },
        GiveVariantNameVariant => {
            en: "give the variant a name: [variant.NAME] above what it changes",
            ko: "대안에 이름을 붙인다. 바꿀 내용 위에 [variant.이름]을 쓴다",
        },
        VariantCannotChange { name: String, key: String } => {
            en: "variant \"{name}\" cannot change {key}",
            ko: "대안 \"{name}\"에서 {key}을(를) 바꿀 수 없다",
        },
        HoldsForWholeFile => { en: "holds for the whole file", ko: "파일 전체에 적용되는 값이다" },
        TakeItOutOrMake => { en: "take it out, or make another file", ko: "삭제하거나 파일을 따로 만든다" },
        IsNotName(path: String) => { en: "{path} is not a name", ko: "{path}이(가) 이름이 아니다" },
        MustBeTextOr => {
            en: "must be text, or {{ en = \"…\", ko = \"…\" }}",
            ko: "문자열 또는 {{ en = \"…\", ko = \"…\" }}이어야 한다",
        },
        IsNamedAsBut { table: String, name: String, twin: String } => {
            en: "{table} \"{name}\" is named as \"{twin}\" but for capitals or the way letters are composed",
            ko: "{table} \"{name}\"와(과) \"{twin}\"은(는) 대소문자나 글자 조합 방식만 다르다",
        },
        ResultsWouldBeOne => { en: "results would be one folder on Windows", ko: "Windows에서는 결과 폴더가 같아진다" },
        GiveItAnotherName => { en: "give it another name", ko: "다른 이름을 붙인다" },
        HoldsControlCharacterU { path: String, sign: String } => {
            en: "{path} holds the control character U+{sign}",
            ko: "{path}에 제어문자 U+{sign}이(가) 들어 있다",
        },
        OnlyLettersDigitsSigns => {
            en: "only letters, digits, signs and line ends",
            ko: "글자, 숫자, 기호, 줄바꿈만 쓸 수 있다",
        },
        TakeItOutCopied => {
            en: "take it out: copied text sometimes brings one along",
            ko: "삭제한다. 복사한 글에 딸려 온 것일 수 있다",
        },
        Stacks => { en: "stacks", ko: "stack 모델" },
        Frames => { en: "frames", ko: "frame 모델" },
        Buildings => { en: "buildings", ko: "building 모델" },
    }
}
