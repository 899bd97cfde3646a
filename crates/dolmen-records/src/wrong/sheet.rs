//! Errors of a table, a photograph or the form of a score, in both languages.

use crate::photo::{PHOTO_PIXELS_MOST, PhotoError};
use crate::score_form::ScoreFormError;
use crate::sheet_error::{COLUMNS_MOST, SheetError};
use dolmen_words::sentences;

sentences! {
    SheetError in "sheet.error" {
        NotATable => {
            en: "is no table: its name must end in .xlsx, .ods or .csv",
            ko: "표가 아니다. 파일 이름이 .xlsx, .ods 또는 .csv로 끝나야 한다",
        },
        Unreadable { why } => {
            en: "cannot be read as a table: {why}",
            ko: "표로 읽을 수 없다: {why}",
        },
        TooLarge { most_mib } => {
            en: "unpacks to more than {most_mib} MiB, too much for a file of its size: save only the table of this structure, or as CSV",
            ko: "압축을 풀면 {most_mib} MiB를 넘어 파일 크기에 비해 너무 크다. 이 구조물의 표만 저장하거나 CSV로 저장한다",
        },
        TooMany { rows, columns, rows_most } as { rows, columns, rows_most, columns_most: COLUMNS_MOST } => {
            en: "has {rows} rows and {columns} columns, but at most {rows_most} and {columns_most} are read",
            ko: "{rows}행 {columns}열인데 {rows_most}행 {columns_most}열까지만 읽는다",
        },
        Sparse { rows, columns, cells } => {
            en: "reaches over {rows} rows and {columns} columns, of which {cells} cells hold something: delete what stands far from the table",
            ko: "{rows}행 {columns}열에 걸쳐 있는데 값이 있는 셀은 {cells}개이다. 표에서 멀리 떨어진 값을 지운다",
        },
        NoPlace { place } => {
            en: "has a cell at {place}…, where no sheet has one (the last is XFD1048576): it is damaged; save the table again",
            ko: "{place}… 위치의 셀이 있는데 시트에는 그런 위치가 없다(마지막은 XFD1048576). 파일이 손상되었으므로 표를 다시 저장한다",
        },
        Damaged => {
            en: "is damaged: a table or row in it does not end; save the table again",
            ko: "손상된 파일이다. 끝나지 않는 표나 행이 있으므로 표를 다시 저장한다",
        },
        NoSuchSheet { name, known } => {
            en: "has no sheet \"{name}\": it has {known}",
            ko: "시트 \"{name}\"이(가) 없다. 있는 시트: {known}",
        },
        SeveralSheets { known } => {
            en: "has several sheets ({known}): name one, sheet = \"…\"",
            ko: "시트가 여럿이다({known}). sheet = \"…\"로 하나를 지정한다",
        },
        SeveralTables { known } => {
            en: "has values in several sheets ({known}): save the one that is meant as a workbook of its own, or as CSV",
            ko: "시트 여럿에 값이 있다({known}). 해당하는 시트만 따로 저장하거나 CSV로 저장한다",
        },
        NoSheets => {
            en: "is text and has no sheets: take sheet = \"…\" out",
            ko: "텍스트에는 시트가 없다. sheet = \"…\"를 삭제한다",
        },
        NoRows => {
            en: "holds no rows below its header",
            ko: "머리글 아래에 행이 없다",
        },
        Formula { place } => {
            en: "cell {place} holds a formula: its value may be old; copy the table and paste values only",
            ko: "{place} 셀이 수식이다. 값이 예전 것일 수 있으므로 표를 복사해 값만 붙여 넣는다",
        },
        Merged { place } => {
            en: "cells {place} are merged: which row they belong to is not clear; split them",
            ko: "{place} 셀이 병합되어 있다. 어느 행의 값인지 알 수 없으므로 병합을 푼다",
        },
        Other { place, what } => {
            en: "cell {place} holds {what}, which is no number and no name",
            ko: "{place} 셀의 {what}은(는) 수도 이름도 아니다",
        },
    }
}

sentences! {
    PhotoError in "photo.error" {
        NotAnImage { start } => {
            en: "is no JPEG or PNG image: its first bytes are {start}; save it as JPEG or PNG",
            ko: "JPEG나 PNG 그림이 아니다. 첫 바이트: {start}. JPEG나 PNG로 저장한다",
        },
        Damaged => {
            en: "is a damaged image: its head does not say how large it is; save it again from its original",
            ko: "손상된 그림이다. 머리글에 크기가 없다. 원본에서 다시 저장한다",
        },
        CutShort => {
            en: "is cut short: the end of the image is missing; copy it again from its original",
            ko: "잘린 그림이다. 끝부분이 없다. 원본에서 다시 복사한다",
        },
        Empty { width, height } => {
            en: "is an image of {width} × {height} pixels, which shows nothing",
            ko: "{width} × {height} 픽셀의 그림이라 보이는 것이 없다",
        },
        TooManyPixels { width, height } as { width, height, most_million: PHOTO_PIXELS_MOST / 1_000_000 } => {
            en: "is an image of {width} × {height} pixels, but at most {most_million} million are used: save it smaller (3000 pixels across fill a page)",
            ko: "{width} × {height} 픽셀의 그림인데 {most_million}메가픽셀까지만 쓴다. 더 작게 저장한다(너비 3000픽셀이면 한 면에 충분하다)",
        },
    }
}

sentences! {
    ScoreFormError in "score-form.error" {
        NoWorkbook(why) => {
            en: "it is no workbook (.xlsx): {why}",
            ko: "통합문서(.xlsx)가 아니다: {why}",
        },
        NoForm => {
            en: "it is no form of the six-factor score: no sheet has the key storeys in its first column; `dolmen score --sheet form.xlsx` writes the form",
            ko: "여섯 인자 점수의 양식이 아니다. 첫 열에 storeys 키가 있는 시트가 없다. `dolmen score --sheet form.xlsx`로 양식을 만든다",
        },
        Missing { key } => {
            en: "{key} is not filled: write its value into column D of its row",
            ko: "{key}이(가) 비어 있다. 그 행의 D열에 값을 쓴다",
        },
        Both => {
            en: "body_slenderness and slenderness_angle are both filled: keep one, the other follows from it",
            ko: "body_slenderness와 slenderness_angle을 모두 썼다. 하나만 남긴다. 다른 하나는 그로부터 정해진다",
        },
        NoNumber { key, given } as { key, given: format!("{given:?}") } => {
            en: "{key} is {given}: write a number, in the unit of its row",
            ko: "{key}이(가) {given}이다. 그 행의 단위로 수를 쓴다",
        },
        NotWhole { given } => {
            en: "storeys is {given}: write a whole number",
            ko: "storeys가 {given}이다. 정수를 쓴다",
        },
    }
    handed on { Sheet(SheetError) }
}
