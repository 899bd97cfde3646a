//! The stones made from a pagoda's factors, as text to copy into the file.

use crate::document::{TextStyle, wrapped};
use dolmen_project::{Project, Quantity as Input, Structure};
use dolmen_words::{Quantity, Sentence, messages};
use std::fmt::Write as _;

messages! {
    /// Stones made from factors.
    pub(crate) enum Made in "check.made-stones" {
        Head { angle: Quantity, slenderness: Quantity } => {
            en: "Stones that the factors make (slenderness_angle {angle}, body_slenderness {slenderness}), to 0.1 mm, as blocks to copy in the place of pagoda",
            ko: "계수로 만들어진 부재(slenderness_angle {angle}, body_slenderness {slenderness}), 0.1 mm까지. 파일의 pagoda 자리에 blocks로 붙여 넣을 수 있다",
        },
    }
}

/// The stones made from a pagoda's factors, as blocks to copy; empty for other structures.
pub(super) fn made_stones_text(project: &Project, style: TextStyle) -> String {
    let Structure::Stack(part) = &project.structure else {
        return String::new();
    };
    let density = part.density.as_ref().map_or(f64::NAN, |density| density.value);
    let made = part
        .pagoda
        .as_ref()
        .map(|factors| factors.made(density, &mut Input::nominal));
    let Some(Ok(made)) = made else {
        return String::new();
    };
    let said = Made::Head {
        angle: Quantity::ratio(made.slenderness_angle, 4),
        slenderness: Quantity::ratio(made.body_slenderness, 4),
    };
    let said = Sentence::from(said).text(style.language);
    let mut out = "\n".to_owned() + &wrapped(&said, "", "", style.columns()) + "blocks = [\n";
    for block in &made.blocks {
        let [low, high] = block.solid.bounds_m();
        let _ = writeln!(
            out,
            "  {{ name = \"{}\", width = \"{:.4} m\", height = \"{:.4} m\" }},",
            block.name,
            high[0] - low[0],
            high[2] - low[2]
        );
    }
    out + "]\n"
}
