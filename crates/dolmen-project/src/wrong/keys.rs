//! Errors of a key or the type of its value.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// Errors of a key or the type of its value.
    pub(crate) enum WrongKey in "project.error.keys" {
        TopLevel => { en: "the top level", ko: "최상위" },
        HasNoKey { place: Both, name: String } => {
            en: "{place} has no key \"{name}\"",
            ko: "{place}에 \"{name}\" 키는 없다",
        },
        AboveFirstTable => { en: "above the first [table]", ko: "첫 [표] 위로" },
        AboveLineBelow { header_line: String, path: String } => {
            en: "above line {header_line}, below [{path}]",
            ko: "{header_line}행 위, [{path}] 아래로",
        },
        BelongsToButStands { name: String, belongs: Both, header: String, header_line: String } => {
            en: "\"{name}\" belongs to {belongs} but stands below {header} (line {header_line})",
            ko: "\"{name}\"은(는) {belongs}에 속하는 키인데 {header}({header_line}행) 아래에 있다",
        },
        SwallowedByTableAbove => { en: "swallowed by the table above it", ko: "위의 표에 딸린 키로 읽힌다" },
        MoveItInToml(remedy: Both) => {
            en: "move it {remedy}: in TOML a key belongs to the last [table] before it",
            ko: "{remedy} 옮긴다. TOML에서 키는 바로 앞의 [표]에 속한다",
        },
        KnownKeysAre(known: String) => { en: "known keys are {known}", ko: "쓸 수 있는 키: {known}" },
        UnknownKey => { en: "unknown key", ko: "알 수 없는 키" },
        File => { en: "the file", ko: "파일" },
        HasNoButNeeds { subject: Both, name: String } => {
            en: "{subject} has no \"{name}\", but needs it",
            ko: "{subject}에 필요한 \"{name}\"이(가) 없다",
        },
        Write { name: String, meaning: Both } => {
            en: "write {name} = …: {meaning}",
            ko: "{name} = …을(를) 쓴다: {meaning}",
        },
        WriteSchemaAsFirst => {
            en: "write schema = 1 as the first line: it is the version of the file format",
            ko: "첫 줄에 schema = 1을 쓴다. 파일 형식의 버전이다",
        },
        WriteKind(kinds: Both) => {
            en: "write kind = {kinds} near the top",
            ko: "파일 위쪽에 kind = {kinds}을(를) 쓴다",
        },
        IsNotKnown { path: String, word: String } => {
            en: "{path} = \"{word}\" is not known",
            ko: "{path} = \"{word}\"은(는) 쓸 수 없는 값이다",
        },
        MustBe(allowed: Both) => { en: "must be {allowed}", ko: "{allowed}이어야 한다" },
        Is { path: String, echo: String, given: Both } => {
            en: "{path}{echo} is {given}",
            ko: "{path}{echo}은(는) {given}이다",
        },
        MustBeOfType(needed: Both) => { en: "must be {needed}", ko: "{needed}이어야 한다" },
        Number => { en: "a number", ko: "수" },
        WriteNumberWithoutQuotes => { en: "write a number without quotes", ko: "따옴표 없이 수로 쓴다" },
        PutItInQuotes(written: String) => {
            en: "put it in quotes: \"{written}\"",
            ko: "따옴표로 묶는다: \"{written}\"",
        },
        List => { en: "a list", ko: "목록" },
        ListEachWithIts(path: String) => {
            en: "list each with its values: {path} = [ {{ … }}, {{ … }} ]",
            ko: "값을 목록으로 나열한다: {path} = [ {{ … }}, {{ … }} ]",
        },
        DampingRatio(written: String) => {
            en: "write damping = {{ ratio = {written} }}",
            ko: "damping = {{ ratio = {written} }}와 같이 쓴다",
        },
        PutItInBrackets(written: String) => {
            en: "put it in brackets: [{written}]",
            ko: "대괄호로 묶는다: [{written}]",
        },
        Table => { en: "a table", ko: "표" },
        GiveByDirection { key: String, written: String } => {
            en: "say in which direction: {key} = {{ x = {written} }}",
            ko: "방향을 적는다: {key} = {{ x = {written} }}",
        },
        SayWhichComponentIt(written: String) => {
            en: "say which component it is: {{ x = {written} }}",
            ko: "어느 성분인지 쓴다: {{ x = {written} }}",
        },
        BelongsOneLevelDeeper { key: String, table: String } => {
            en: "{key} belongs one level deeper: give the {table} a name, [{table}.NAME], and put it there",
            ko: "{key}은(는) 한 단계 아래에 속한다. {table}에 이름을 붙여 [{table}.이름] 아래에 쓴다",
        },
        WholeNumber => { en: "a whole number", ko: "정수" },
        TrueOrFalse => { en: "true or false", ko: "논리값(true 또는 false)" },
        Date => { en: "a date", ko: "날짜" },
        Or { others: String, last: String } => { en: "{others} or {last}", ko: "{others} 또는 {last}" },
        Text => { en: "text", ko: "문자열" },
    }
}
