//! The structure as entered.

use crate::document::{Document, Figure};
use crate::figures::{drawing, drawing_series};
use dolmen_project::Project;
use dolmen_words::{Language, messages};

messages! {
    /// The structure as it is entered.
    pub(crate) enum Structure in "engineer.structure" {
        Head => { en: "Structure", ko: "구조물 현황" },
        Drawing => { en: "The structure as entered.", ko: "입력한 구조." },
        DrawingMeaning => {
            en: "Names and dimensions of the project file, before anything is computed.",
            ko: "프로젝트 파일에 적은 부재 이름과 치수이며, 계산 결과가 아니다.",
        },
    }
}

/// The section; empty for a survey alone, and if the structure cannot be built.
pub(crate) fn structure(project: &Project) -> Document<'_> {
    let mut document = Document::default();
    if drawing(project, Language::English).is_some() {
        document.heading(Structure::Head);
        let caption = vec![Structure::Drawing.into(), Structure::DrawingMeaning.into()];
        let drawn = Figure::drawn(caption, move |language| {
            drawing(project, language).unwrap_or_default()
        });
        document.charted(drawn.with_series(move || drawing_series(project)));
    }
    document
}
