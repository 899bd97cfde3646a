//! Errors of a table of surveys beside the file.

use dolmen_words::messages;

messages! {
    /// Errors of a table of surveys.
    pub(crate) enum WrongSurveys in "project.error.surveys" {
        MustBeFileSheetIgnore => {
            en: "must be file, with sheet (of a workbook) and ignore (heads of columns to leave out)",
            ko: "file과, 필요하면 sheet(통합 문서의 시트), ignore(쓰지 않을 열의 이름 목록)만 쓸 수 있다",
        },
        Columns => {
            en: "columns are date, temperature (°C), frequency x 1 (Hz), frequency x 1 sd (Hz), tilt x (mm/m), crack C1 @ PART (mm), datum and note, with y, torsion and other numbers alike; name any other in ignore = [\"…\"]",
            ko: "열은 조사일, 기온(℃), X 진동수 1차(Hz), X 진동수 1차 표준편차(Hz), 기울기 X(mm/m), 균열 C1 @ 부재(mm), 기준점, 비고이다. y, 비틀림과 다른 차수도 같다. 그 밖의 열은 ignore = [\"…\"]에 적는다",
        },
        NoDates { file: String } => {
            en: "{file} has no column date",
            ko: "{file}에 날짜(조사일) 열이 없다",
        },
        NoDate { file: String, place: String, given: String } => {
            en: "{file}, cell {place}: \"{given}\" is no date",
            ko: "{file}, {place} 셀: \"{given}\"은(는) 날짜가 아니다",
        },
        WriteDate => {
            en: "write the year first: 2019-04-02, 2019. 4. 2., 2019-04 or 2019, or use a date of the spreadsheet",
            ko: "연도부터 쓴다: 2019-04-02, 2019. 4. 2., 2019년 4월 2일, 2019-04 또는 2019. 스프레드시트의 날짜 셀도 된다",
        },
        SameDate { file: String, place: String, date: String, other: String } => {
            en: "{file}, cell {place}: {date} is in row {other} already",
            ko: "{file}, {place} 셀: {date}은(는) 이미 {other}행에 있다",
        },
        KeepOneRow => {
            en: "one row is one survey: put the values of a date into one row, or correct the date",
            ko: "한 행이 조사 하나이다. 같은 날짜의 값을 한 행에 모으거나 날짜를 고친다",
        },
        AlsoInFile { file: String, place: String, date: String, survey: String } => {
            en: "{file}, cell {place}: {date} is also [survey.\"{survey}\"] of the project file",
            ko: "{file}, {place} 셀: {date}은(는) 프로젝트 파일의 [survey.\"{survey}\"]에도 있다",
        },
        KeepOnePlace => {
            en: "write a survey in one place: delete the row or the table of the project file",
            ko: "한 조사는 한 곳에만 쓴다. 행이나 프로젝트 파일의 표 중 하나를 삭제한다",
        },
        NotCelsius { file: String, place: String, unit: String } => {
            en: "{file}, cell {place}: temperatures are in °C, but the head says \"{unit}\"",
            ko: "{file}, {place} 셀: 기온의 단위는 ℃인데 열 이름에 \"{unit}\"이(가) 있다",
        },
        ConvertToCelsius => { en: "convert the column to °C", ko: "열의 값을 ℃로 바꾼다" },
        NoNumber { file: String, place: String, given: String } => {
            en: "{file}, cell {place}: \"{given}\" is no number",
            ko: "{file}, {place} 셀: \"{given}\"은(는) 수가 아니다",
        },
        WriteNumber => {
            en: "write a number alone with a decimal point, or leave the cell empty; decimal commas are read where semicolons or tabs separate the cells and no number of the table has a point",
            ko: "소수점을 쓴 수만 적거나 셀을 비운다. 소수 쉼표는 셀을 세미콜론이나 탭으로 나누고 표의 어떤 수에도 소수점이 없을 때에만 읽는다",
        },
        SdAlone { file: String, place: String, head: String } => {
            en: "{file}, cell {place}: \"{head}\" has no column of its frequency",
            ko: "{file}, {place} 셀: \"{head}\"에 해당하는 진동수 열이 없다",
        },
        NoUnit { file: String, place: String, head: String } => {
            en: "{file}, cell {place}: the head \"{head}\" has no unit",
            ko: "{file}, {place} 셀: 열 이름 \"{head}\"에 단위가 없다",
        },
        GiveUnit => { en: "write it behind the name, as (mm)", ko: "이름 뒤에 (mm)처럼 쓴다" },
    }
}
