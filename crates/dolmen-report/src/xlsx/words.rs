//! Words of a workbook in addition to those of the document.

use dolmen_words::Sentence;
use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// Heads and captions of a workbook.
    pub(crate) enum Workbook in "workbook" {
        Summary {} => { en: "Summary", ko: "요약" },
        Reports {} => { en: "Reports", ko: "보고서 모음" },
        Answers {} => { en: "Three answers", ko: "세 가지 판정" },
        Findings {} => { en: "Findings", ko: "검토 결과" },
        Tables {} => { en: "Tables in this workbook", ko: "표 목록" },
        Back {} => { en: "To the summary", ko: "요약으로" },
        NotReported { file: String, why: String } => { en: "Not reported on: {file}: {why}", ko: "보고서에서 제외됨: {file}: {why}" },
        Inputs {} => { en: "Inputs", ko: "입력값" },
        InputsCaption {} => {
            en: "What the project file gives. Values are in SI units.",
            ko: "프로젝트 파일의 입력값이다. 값은 SI 단위이다.",
        },
        InputsOf(variant: Both) => {
            en: "Inputs that the variant “{variant}” changes.",
            ko: "대안 ‘{variant}’에서 달라지는 입력값.",
        },
        Input {} => { en: "Input", ko: "입력" },
        AsItIs {} => { en: "As it is", ko: "현 상태" },
        Source {} => { en: "Source", ko: "출처" },
        AsWritten {} => { en: "As written", ko: "기재값" },
        Unit {} => { en: "Unit (SI)", ko: "단위(SI)" },
        Value {} => { en: "Value (SI)", ko: "값(SI)" },
        Scatter {} => { en: "Coefficient of variation", ko: "변동계수" },
        Note {} => { en: "Note", ko: "비고" },
        Quantity {} => { en: "Quantity", ko: "항목" },
        Deviation(head: Both) => { en: "{head}: standard deviation", ko: "{head}: 표준편차" },
        PartOf { variant: Sentence, part: Sentence } => { en: "{variant}: {part}", ko: "{variant}: {part}" },
        Verbatim(text: Both) => { en: "{text}", ko: "{text}" },
    }
}
