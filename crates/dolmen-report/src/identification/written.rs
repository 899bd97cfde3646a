//! Text on values written into the project file.

use crate::document::{Block, Document, TextStyle, document_text};
use dolmen_project::IdentifiedNumber;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::WrittenBack;

messages! {
    /// What was written into the project file.
    pub(crate) enum Written in "identification.written" {
        Into { file: String, survey: String } => {
            en: "Written into {file} as identified from survey {survey}; comments and all else stay as they were:",
            ko: "{survey} 조사에서 추정한 값을 {file}에 썼다. 주석과 나머지는 그대로 두었다.",
        },
        Number { path: String, value: Quantity } => { en: "{path} = {value}", ko: "{path} = {value}" },
        NumberBefore { path: String, value: Quantity, before: String } => {
            en: "{path} = {value} (before: {before})",
            ko: "{path} = {value} (이전 값: {before})",
        },
        Next => {
            en: "«`dolmen check`, `simulate` and `report`|The check of stability, simulations and the report» rest on it now; that survey is no longer evidence for the model.",
            ko: "이제 «`dolmen check`, `simulate`, `report`가|안정성 검토, 지진응답 검토, 보고서가» 이 값을 쓴다. 이 조사는 더 이상 모델을 확인하는 근거가 되지 않는다.",
        },
        Unchecked => {
            en: "Nothing checks these values: they fit as many frequencies as there are unknown stiffnesses, whatever the structure is. «`dolmen check`|The check of stability» calls no answer green that rests on them alone. A measured mode shape would check them.",
            ko: "이 값은 검증되지 않았다. 미지 강성의 수만큼의 고유진동수에 맞춘 값이어서 구조물이 실제로 어떻든 맞는다. 이 값에만 근거한 결과를 «`dolmen check`|안정성 검토»는 양호로 판정하지 않는다. 모드형상을 계측하면 검증할 수 있다.",
        },
        CanBeUnchecked => {
            en: "One survey gives the stiffness, by construction: «`dolmen identify PROJECT --write`|the identification from vibration» puts it into the project file, and all answers that rest on it say that nothing checks it.",
            ko: "한 조사로 강성이 정해지나 검증되지 않는다.« `dolmen identify PROJECT --write`로 프로젝트 파일에 쓸 수 있으며, 이 값을 쓰는 모든 검토에 검증되지 않았다고 표시된다.»",
        },
        CanBe => {
            en: "One survey determines the stiffness: «`dolmen identify PROJECT --write`|the identification from vibration» puts it into the project file, with its standard deviation, and all answers rest on it then.",
            ko: "한 조사로 강성이 정해진다.« `dolmen identify PROJECT --write`로 표준편차와 함께 프로젝트 파일에 쓰면 이후의 모든 검토가 그 값을 쓴다.»",
        },
    }
}

/// The written values, for the terminal.
pub fn written_back_text(file: &str, written: &WrittenBack, style: TextStyle) -> String {
    let mut document = Document::default();
    document.paragraph(Written::Into {
        file: file.to_owned(),
        survey: written.survey.clone(),
    });
    let numbers: Vec<Sentence> = written.numbers.iter().map(number).collect();
    document.put(Block::List(numbers));
    if written.is_unchecked {
        document.paragraph(Written::Unchecked);
    }
    document.paragraph(Written::Next);
    "\n".to_owned() + &document_text(&document, style)
}

fn number((path, number): &(String, IdentifiedNumber)) -> Sentence {
    let unit = Unit::of(&[number.value], &number.unit.replace(' ', "·"));
    let value = Quantity {
        sd_si: number.sd,
        ..Quantity::new(number.value, unit, Digits::Significant(4))
    };
    let path = path.clone();
    match &number.before {
        Some(before) => Written::NumberBefore {
            path,
            value,
            before: before.clone(),
        }
        .into(),
        None => Written::Number { path, value }.into(),
    }
}
