//! Words around blocks.

use dolmen_words::messages;

messages! {
    /// Heads of rows.
    pub(crate) enum Framed in "document" {
        Role => { en: "Role", ko: "직책" },
        Name => { en: "Name", ko: "성명" },
        Licence => { en: "Licence", ko: "자격·면허" },
        Signature => { en: "Signature", ko: "서명·날인" },
        Question => { en: "Question", ko: "검토 항목" },
        Answer => { en: "Answer", ko: "판정" },
        Photo => { en: "Photograph", ko: "사진" },
        File => { en: "File", ko: "파일" },
    }
}
