//! Pieces of a page.

use super::grid::Grid;
use super::ink::Ink;
use super::media::Picture;
use crate::document::Math;

/// Role of a paragraph; each has its own style.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    Body,
    Remark,
    Bullet,
    /// The answers to the three questions.
    Judgement,
    Finding,
    Warning,
    /// A heading without a number, left out of the contents.
    FrontHeading,
    Title,
    Subtitle,
}

/// A stretch of a paragraph.
#[derive(Clone, Debug)]
pub(crate) enum Run {
    Words(String, Ink),
    Tab,
}

/// Background of a paragraph: the colour of the bar at its left, and its fill.
pub(crate) type Shade = [&'static str; 2];

#[derive(Clone, Debug)]
pub(crate) struct Paragraph {
    pub(crate) role: Role,
    pub(crate) runs: Vec<Run>,
    pub(crate) shade: Option<Shade>,
    /// Whether it stays on the page of the next piece.
    pub(crate) keeps_next: bool,
    /// Space above, if not that of its role, twentieths of a point.
    pub(crate) room_above: Option<u32>,
}

impl Paragraph {
    pub(crate) fn of(role: Role, text: &str) -> Self {
        Paragraph {
            role,
            runs: vec![Run::Words(text.to_owned(), Ink::PLAIN)],
            shade: None,
            keeps_next: false,
            room_above: None,
        }
    }
}

/// A numbered head.
#[derive(Clone, Debug)]
pub(crate) struct Heading {
    /// 1, 2 or 3.
    pub(crate) level: usize,
    /// "2.1"; the program that shows the document computes the same number.
    pub(crate) number: String,
    pub(crate) head: String,
    /// Number of the heading in the document, from 1.
    pub(crate) place: usize,
}

/// A caption: its label and number, an emphasised lead, and the rest.
#[derive(Clone, Debug)]
pub(crate) struct Caption {
    /// "Table ", "그림 ".
    pub(crate) word: String,
    /// "2.1".
    pub(crate) number: String,
    pub(crate) lead: Option<String>,
    pub(crate) rest: Option<String>,
    /// Whether it is above its object.
    pub(crate) is_above: bool,
}

/// Pieces of the pages, in order.
#[derive(Clone, Debug)]
pub(crate) enum Piece {
    Paragraph(Paragraph),
    Heading(Heading),
    Caption(Caption),
    /// A formula on a line of its own.
    Equation(Vec<Math>),
    Table(Grid),
    /// A picture, and whether it is on the cover, where its position is lower.
    Picture(Picture, bool),
    /// Pictures with their captions, two side by side.
    Beside(Vec<(Picture, Caption)>),
    /// Space between two pieces, twentieths of a point; by default that of a table.
    Gap(Option<u32>),
    PageBreak,
    /// Position of the contents.
    Contents,
    /// The next project begins, with a cover that has no running lines.
    NextProject,
}
