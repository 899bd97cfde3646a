//! Errors of a table beside the file.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// Errors of a table beside the file.
    pub(crate) enum WrongTable in "project.error.tables" {
        HasKeyBesideFile { key: String, name: String } => {
            en: "{key} has the key \"{name}\" beside file",
            ko: "{key}에 file과 함께 \"{name}\" 키가 있다",
        },
        MustBeFileAnd => { en: "must be file and sheet alone", ko: "file과 sheet만 쓸 수 있다" },
        File { key: String, file: String, why: Both } => {
            en: "{key}.file = \"{file}\": {why}",
            ko: "{key}.file = \"{file}\"을(를) 읽을 수 없다: {why}",
        },
        CellColumnIsThere { file: String, place: String, of: String } => {
            en: "{file}, cell {place}: the column \"{of}\" is there twice",
            ko: "{file}, {place} 셀: \"{of}\" 열이 두 번 있다",
        },
        Cell { file: String, place: String, said: Both } => {
            en: "{file}, cell {place}: {said}",
            ko: "{file}, {place} 셀: {said}",
        },
        CellIsNoColumn { file: String, place: String, head: String, key: String } => {
            en: "{file}, cell {place}: \"{head}\" is no column of {key}",
            ko: "{file}, {place} 셀: \"{head}\"은(는) {key}의 열이 아니다",
        },
        NameItOneOf { known: String } => {
            en: "name it one of {known}, in English or Korean, or take it out",
            ko: "{known} 중 하나(한글 이름도 가능)로 고치거나 삭제한다",
        },
        WriteItInProject { known: String } => {
            en: "the table holds {known}: write the list in the project file, where each part can have more, and several parts alike as one row each; or take the column out if it has no bearing on the answer",
            ko: "표에서 읽는 열은 {known}이다. 부재마다 다른 값도 줄 수 있는 프로젝트 파일에 목록을 적고, 같은 부재가 여러 개이면 한 행에 하나씩 적는다. 결과와 무관한 열이면 삭제한다",
        },
        CellStandsUnderNo { file: String, place: String } => {
            en: "{file}, cell {place}: stands under no head",
            ko: "{file}, {place} 셀: 열 이름이 없는 값이다",
        },
        NameColumnInFirst => {
            en: "name the column in the first row, or clear the cell",
            ko: "첫 행에 열 이름을 쓰거나 셀을 비운다",
        },
        Sheet { file: String, why: Both } => { en: "{file} {why}", ko: "{file}: {why}" },
        CellRowIsEmpty { file: String, place: String } => {
            en: "{file}, cell {place}: the row is empty",
            ko: "{file}, {place} 셀: 빈 행이다",
        },
        RowIsTotal { file: String, place: String, name: String } => {
            en: "{file}, cell {place}: \"{name}\" names a total, but every row is a part",
            ko: "{file}, {place} 셀: \"{name}\"은(는) 합계로 보이나 표의 모든 행은 부재이다",
        },
        RowIsSum { file: String, place: String } => {
            en: "{file}, cell {place}: the numbers of the last row are the sums of those above, but every row is a part",
            ko: "{file}, {place} 셀: 마지막 행의 수가 위 행들의 합이다. 표의 모든 행은 부재이다",
        },
        DeleteTotal => {
            en: "delete the row; if it is a part, give it a name of its own or write the parts into the project file",
            ko: "그 행을 삭제한다. 부재이면 다른 이름을 쓰거나 부재를 프로젝트 파일에 직접 쓴다",
        },
        DeleteRow => { en: "delete the row", ko: "행을 삭제한다" },
        ColumnHasNoUnit { name: String, unit: String } => {
            en: "the column \"{name}\" has no unit, but its head says \"{unit}\"",
            ko: "\"{name}\" 열에는 단위가 없는데 열 이름에 \"{unit}\"이(가) 있다",
        },
        ColumnNeedsButIts { name: String, needed: Both, unit: String } => {
            en: "the column \"{name}\" needs {needed}, but its head says \"{unit}\"",
            ko: "\"{name}\" 열에는 {needed}의 단위가 필요한데 열 이름에 \"{unit}\"이(가) 있다",
        },
        ColumnIsInBut { name: String, unit: String, key: String, of_file: String } => {
            en: "the column \"{name}\" is in {unit}, but units.{key} of the file is {of_file}",
            ko: "\"{name}\" 열의 단위는 {unit}인데 파일의 units.{key}은(는) {of_file}이다",
        },
        SayOneUnitIn => {
            en: "say the unit of the numbers in both; without a unit in the head they are read in the unit of the file",
            ko: "두 곳에 적힌 값의 단위를 쓴다. 열 이름에서 단위를 빼면 파일의 단위로 읽으므로 값이 달라진다",
        },
    }
}
