//! Formats of letters and paragraphs in a document: those of the styles, and further ones that pieces need. Lengths are hundredths of a
//! point.

use crate::paper::{HAIR, INK, QUIET, Role, Shade};

/// Format of letters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Letters {
    pub(super) size: u32,
    pub(super) colour: &'static str,
    pub(super) bold: bool,
    pub(super) low: bool,
}

/// Alignment of a paragraph.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Align {
    Left,
    Right,
    Center,
}

impl Align {
    pub(super) fn word(self) -> &'static str {
        match self {
            Align::Left => "LEFT",
            Align::Right => "RIGHT",
            Align::Center => "CENTER",
        }
    }
}

/// Kind of a tab stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Tab {
    Usual,
    /// The indent of lines after the first.
    Hanging,
    /// At the right end of the line.
    Right,
}

impl Tab {
    pub(super) const ALL: [Tab; 3] = [Tab::Usual, Tab::Hanging, Tab::Right];
}

/// Numbering of a paragraph.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Count {
    None,
    /// A head of this level, from 0.
    Outline(usize),
    Bullet,
}

/// Layout of a paragraph.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Lie {
    pub(super) align: Align,
    pub(super) left: u32,
    /// Hanging indent of the first line.
    pub(super) hanging: u32,
    pub(super) above: u32,
    pub(super) below: u32,
    /// Percent of the size of the letters.
    pub(super) line: u32,
    pub(super) keep_next: bool,
    pub(super) tab: Tab,
    pub(super) count: Count,
    pub(super) ground: Ground,
}

/// Background and borders of a paragraph or a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ground {
    None,
    /// A fill with a bar at its left.
    Shade(Shade),
    /// A hairline below.
    Row,
    /// A line below.
    RowEnd,
}

/// A line: its width in the notation of the format, and its colour.
pub(super) type Rule = (&'static str, &'static str);

impl Ground {
    /// The line at the left.
    pub(super) fn left(self) -> Option<Rule> {
        match self {
            Ground::Shade([colour, _]) => Some(("1.5 mm", colour)),
            Ground::None | Ground::Row | Ground::RowEnd => None,
        }
    }

    /// The line below.
    pub(super) fn below(self) -> Option<Rule> {
        match self {
            Ground::Row => Some(("0.12 mm", HAIR)),
            Ground::RowEnd => Some(("0.4 mm", INK)),
            Ground::None | Ground::Shade(_) => None,
        }
    }

    /// The colour of the whole.
    pub(super) fn wash(self) -> Option<&'static str> {
        match self {
            Ground::Shade([_, wash]) => Some(wash),
            Ground::None | Ground::Row | Ground::RowEnd => None,
        }
    }
}

/// The styles, in the order of their numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Style {
    Normal,
    Body,
    Outline1,
    Outline2,
    Outline3,
    Running,
    Caption,
    ContentsHeading,
    Contents1,
    Contents2,
    FrontHeading,
    Title,
    Subtitle,
    Figure,
    Judgement,
    Finding,
    Warning,
    Remark,
    Bullet,
    TableText,
}

impl Style {
    pub(super) const ALL: [Style; 20] = [
        Style::Normal,
        Style::Body,
        Style::Outline1,
        Style::Outline2,
        Style::Outline3,
        Style::Running,
        Style::Caption,
        Style::ContentsHeading,
        Style::Contents1,
        Style::Contents2,
        Style::FrontHeading,
        Style::Title,
        Style::Subtitle,
        Style::Figure,
        Style::Judgement,
        Style::Finding,
        Style::Warning,
        Style::Remark,
        Style::Bullet,
        Style::TableText,
    ];

    pub(super) fn of(role: Role) -> Self {
        match role {
            Role::Body => Style::Body,
            Role::Remark => Style::Remark,
            Role::Bullet => Style::Bullet,
            Role::Judgement => Style::Judgement,
            Role::Finding => Style::Finding,
            Role::Warning => Style::Warning,
            Role::FrontHeading => Style::FrontHeading,
            Role::Title => Style::Title,
            Role::Subtitle => Style::Subtitle,
        }
    }

    /// The style of a heading of this level, from 1.
    pub(super) fn heading(level: usize) -> Self {
        match level {
            1 => Style::Outline1,
            2 => Style::Outline2,
            _ => Style::Outline3,
        }
    }

    /// Korean and English names; Hangul recognises its own styles by these.
    pub(super) fn names(self) -> [&'static str; 2] {
        match self {
            Style::Normal => ["바탕글", "Normal"],
            Style::Body => ["본문", "Body"],
            Style::Outline1 => ["개요 1", "Outline 1"],
            Style::Outline2 => ["개요 2", "Outline 2"],
            Style::Outline3 => ["개요 3", "Outline 3"],
            Style::Running => ["머리말", "Header"],
            Style::Caption => ["캡션", "Caption"],
            Style::ContentsHeading => ["차례 제목", "TOC Heading"],
            Style::Contents1 => ["차례 1", "TOC 1"],
            Style::Contents2 => ["차례 2", "TOC 2"],
            Style::FrontHeading => ["번호 없는 제목", "Front Heading"],
            Style::Title => ["표지 제목", "Title"],
            Style::Subtitle => ["표지 부제목", "Subtitle"],
            Style::Figure => ["그림", "Figure"],
            Style::Judgement => ["판정", "Judgement"],
            Style::Finding => ["검토 결과", "Finding"],
            Style::Warning => ["주의", "Warning"],
            Style::Remark => ["참고", "Remark"],
            Style::Bullet => ["글머리표", "List Bullet"],
            Style::TableText => ["표 내용", "Table Text"],
        }
    }

    pub(super) fn letters(self) -> Letters {
        let (size, colour, bold) = match self {
            Style::Title => (2600, INK, true),
            Style::Outline1 => (1500, INK, true),
            Style::FrontHeading | Style::ContentsHeading => (1300, INK, true),
            Style::Outline2 => (1200, INK, true),
            Style::Outline3 => (1050, INK, true),
            Style::Subtitle => (1100, QUIET, false),
            Style::Caption => (900, INK, false),
            Style::Remark => (850, QUIET, false),
            Style::TableText => (850, INK, false),
            Style::Running => (800, QUIET, false),
            _ => (1000, INK, false),
        };
        Letters {
            size,
            colour,
            bold,
            low: false,
        }
    }

    pub(super) fn lie(self) -> Lie {
        let lie = Lie {
            align: Align::Left,
            left: 0,
            hanging: 0,
            above: 0,
            below: 700,
            line: 150,
            keep_next: false,
            tab: Tab::Usual,
            count: Count::None,
            ground: Ground::None,
        };
        let head = |level, above, below| Lie {
            above,
            below,
            keep_next: true,
            count: Count::Outline(level),
            ..lie
        };
        match self {
            Style::Normal => Lie { below: 0, ..lie },
            Style::Body | Style::Remark => lie,
            Style::Outline1 => head(0, 2400, 1000),
            Style::Outline2 => head(1, 1600, 700),
            Style::Outline3 => head(2, 1300, 600),
            Style::Running => Lie {
                below: 0,
                tab: Tab::Right,
                ..lie
            },
            Style::Caption => Lie {
                above: 600,
                below: 600,
                ..lie
            },
            Style::FrontHeading | Style::ContentsHeading => Lie {
                above: 1800,
                below: 800,
                keep_next: true,
                ..lie
            },
            Style::Contents1 => Lie { below: 300, ..lie },
            Style::Contents2 => Lie {
                left: 1400,
                below: 300,
                ..lie
            },
            Style::Title => Lie { below: 400, ..lie },
            Style::Subtitle => Lie { below: 600, ..lie },
            Style::Figure => Lie {
                align: Align::Center,
                above: 1000,
                below: 0,
                keep_next: true,
                ..lie
            },
            Style::Judgement => Lie {
                left: 850,
                below: 0,
                ..lie
            },
            Style::Warning => Lie {
                left: 850,
                above: 400,
                ..lie
            },
            Style::Finding => Lie {
                left: 1700,
                hanging: 1700,
                below: 500,
                tab: Tab::Hanging,
                ..lie
            },
            Style::Bullet => Lie {
                left: 1700,
                hanging: 1100,
                below: 400,
                count: Count::Bullet,
                ..lie
            },
            Style::TableText => Lie {
                below: 0,
                line: 130,
                ..lie
            },
        }
    }

    pub(super) fn number(self) -> usize {
        Style::ALL.iter().position(|style| *style == self).unwrap_or(0)
    }
}

/// Every format in the document, in the order of their numbers.
#[derive(Debug)]
pub(super) struct Looks {
    pub(super) letters: Vec<Letters>,
    pub(super) lies: Vec<Lie>,
    pub(super) grounds: Vec<Ground>,
}

impl Looks {
    /// The formats of the styles.
    pub(super) fn new() -> Self {
        let mut looks = Looks {
            letters: Vec::new(),
            lies: Vec::new(),
            grounds: vec![Ground::None],
        };
        for style in Style::ALL {
            looks.letters(style.letters());
            looks.lie(style.lie());
        }
        looks
    }

    pub(super) fn letters(&mut self, of: Letters) -> usize {
        number(&mut self.letters, of)
    }

    pub(super) fn lie(&mut self, of: Lie) -> usize {
        self.ground(of.ground);
        number(&mut self.lies, of)
    }

    /// Backgrounds are numbered from 1.
    pub(super) fn ground(&mut self, of: Ground) -> usize {
        number(&mut self.grounds, of) + 1
    }
}

fn number<T: PartialEq>(all: &mut Vec<T>, of: T) -> usize {
    all.iter().position(|one| *one == of).unwrap_or_else(|| {
        all.push(of);
        all.len() - 1
    })
}
