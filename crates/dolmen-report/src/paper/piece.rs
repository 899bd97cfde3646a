//! What stands on the pages.

use super::grid::Grid;
use super::ink::Ink;
use super::media::Picture;
use crate::document::Math;

/// What a paragraph is for; each has a look of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    Body,
    Remark,
    Bullet,
    /// What the answers come to.
    Judgement,
    Finding,
    Warning,
    /// A head that is not numbered and stands in no contents.
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

/// The ground of a paragraph: the colour of its bar at the left, and its wash.
pub(crate) type Shade = [&'static str; 2];

#[derive(Clone, Debug)]
pub(crate) struct Paragraph {
    pub(crate) role: Role,
    pub(crate) runs: Vec<Run>,
    pub(crate) shade: Option<Shade>,
    /// It stands on the page of what follows.
    pub(crate) keeps_next: bool,
    /// Room above where it is not that of its role, twentieths of a point.
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
    /// "2.1": the program that shows the document counts to the same.
    pub(crate) number: String,
    pub(crate) head: String,
    /// Its place among the heads, from 1.
    pub(crate) place: usize,
}

/// A caption: its label and number, a lead that stands out, and the rest.
#[derive(Clone, Debug)]
pub(crate) struct Caption {
    /// "Table ", "그림 ".
    pub(crate) word: String,
    /// "2.1".
    pub(crate) number: String,
    pub(crate) lead: Option<String>,
    pub(crate) rest: Option<String>,
    /// It stands above what it is of.
    pub(crate) is_above: bool,
}

/// What stands on the pages, from the first to the last.
#[derive(Clone, Debug)]
pub(crate) enum Piece {
    Paragraph(Paragraph),
    Heading(Heading),
    Caption(Caption),
    /// A formula on a line of its own.
    Equation(Vec<Math>),
    Table(Grid),
    /// A picture; that of a cover stands farther down.
    Picture(Picture, bool),
    /// Pictures with their captions, two beside each other.
    Beside(Vec<(Picture, Caption)>),
    /// Room between what would touch, twentieths of a point; that of a table where nothing is stated.
    Gap(Option<u32>),
    PageBreak,
    /// The contents stand here.
    Contents,
    /// The next project begins on a cover, which has no running lines.
    NextProject,
}
