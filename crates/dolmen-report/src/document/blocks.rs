//! Blocks of a document: values and sentences.

use super::formula::Equation;
use super::photos::{Answered, Photo, Signatory};
use super::series::Series;
use dolmen_words::{Language, Quantity, Sentence, Unit};

/// Blocks in reading order.
#[derive(Debug, Default)]
pub(crate) struct Document<'a> {
    pub(crate) blocks: Vec<Block<'a>>,
}

/// A piece of a document.
#[derive(Debug)]
pub(crate) enum Block<'a> {
    /// The head of a section.
    Heading(Sentence),
    /// The heading of a part of a section.
    Subheading(Sentence),
    /// Plain sentences.
    Paragraph(Vec<Sentence>),
    /// A warning.
    Warning(Sentence),
    /// A note on the blocks above.
    Note(Sentence),
    /// Points of a kind.
    List(Vec<Sentence>),
    /// A few values, one row each; the cells give their units.
    KeyValues(Vec<(Sentence, Cell)>),
    /// A table.
    Table(Table),
    /// A formula on a line of its own.
    Equation(Equation),
    /// Figures; several stand side by side.
    Figures(Vec<Figure<'a>>),
    /// Photographs; several stand side by side.
    Photos(Vec<Photo<'a>>),
    /// Rows to sign in.
    Signatures(Vec<Signatory>),
    /// The three questions with their answers.
    Answers(Vec<Answered>),
}

/// A table; each row has as many cells as `columns`.
#[derive(Clone, Debug)]
pub(crate) struct Table {
    /// Caption; its first sentence is emphasised.
    pub(crate) caption: Vec<Sentence>,
    /// The columns: words first, then numbers.
    pub(crate) columns: Vec<Column>,
    pub(crate) rows: Vec<Vec<Cell>>,
}

impl Table {
    /// Removes empty columns.
    pub(crate) fn without_empty_columns(self) -> Self {
        let is_empty = |row: &Vec<Cell>, column: usize| {
            let text = row.get(column).map(|cell| cell.text(Language::English));
            matches!(text.as_deref(), None | Some("" | "–"))
        };
        let kept: Vec<bool> = (0..self.columns.len())
            .map(|column| !self.rows.iter().all(|row| is_empty(row, column)))
            .collect();
        fn only<T>(all: Vec<T>, kept: &[bool]) -> Vec<T> {
            let each = all.into_iter().zip(kept);
            each.filter_map(|(one, kept)| kept.then_some(one)).collect()
        }
        Table {
            caption: self.caption,
            columns: only(self.columns, &kept),
            rows: self.rows.into_iter().map(|row| only(row, &kept)).collect(),
        }
    }
}

/// A number with a unit below this fraction of the largest in its column is rounding. Our choice: sums of many products keep ten digits.
const ROUNDING: f64 = 1e-9;

impl Table {
    /// Sets numbers with a unit to 0 if they are rounding. Shares and probabilities stay, because they may be that small.
    fn without_rounding(&mut self) {
        for (at, column) in self.columns.iter().enumerate() {
            if matches!(column.unit.symbol.as_str(), "" | "%") {
                continue;
            }
            let own = self.rows.iter().filter_map(|row| match row.get(at) {
                Some(Cell::Number(Some(of))) => Some(of.value_si.abs()),
                _ => None,
            });
            let largest = own.fold(0.0, f64::max);
            for row in &mut self.rows {
                if let Some(Cell::Number(Some(of))) = row.get_mut(at)
                    && of.sd_si.is_none()
                    && of.value_si.abs() < ROUNDING * largest
                {
                    of.value_si = 0.0;
                }
            }
        }
    }
}

/// A column: its content, and the unit of its numbers.
#[derive(Clone, Debug)]
pub(crate) struct Column {
    pub(crate) head: Sentence,
    /// The unit; empty if there is none, or if the caption gives it.
    pub(crate) unit: Unit,
    /// Whether it contains words.
    pub(crate) is_words: bool,
}

/// One cell.
#[derive(Clone, Debug)]
pub(crate) enum Cell {
    /// Words.
    Words(Sentence),
    /// A number in the unit of the column; `None` shows a dash.
    Number(Option<Quantity>),
    /// A number that indicates a fall or must not be used.
    Bad(Quantity),
    /// As [`Cell::Bad`], marked as rising.
    Rises(Quantity),
    /// Words that indicate a fall or that a value must not be used.
    BadWords(Sentence),
}

/// A figure: its caption, and how to draw it in a language.
pub(crate) struct Figure<'a> {
    /// Caption; its first sentence is emphasised.
    pub(crate) caption: Vec<Sentence>,
    /// Draws its SVG.
    pub(crate) draw: Box<dyn Fn(Language) -> String + 'a>,
    /// Its data.
    pub(crate) series: Box<dyn Fn() -> Vec<Series> + 'a>,
}

impl std::fmt::Debug for Figure<'_> {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter
            .debug_struct("Figure")
            .field("caption", &self.caption)
            .finish_non_exhaustive()
    }
}

impl<'a> Document<'a> {
    /// Adds a block; numbers of a table that are rounding become 0.
    pub(crate) fn put(&mut self, mut block: Block<'a>) {
        if let Block::Table(table) = &mut block {
            table.without_rounding();
        }
        self.blocks.push(block);
    }

    /// Appends the blocks of another document.
    pub(crate) fn append(&mut self, other: Document<'a>) {
        self.blocks.extend(other.blocks);
    }

    /// Adds the head of a section.
    pub(crate) fn heading(&mut self, head: impl Into<Sentence>) {
        self.put(Block::Heading(head.into()));
    }

    /// Adds the heading of a part of a section.
    pub(crate) fn subheading(&mut self, head: impl Into<Sentence>) {
        self.put(Block::Subheading(head.into()));
    }

    /// Adds a paragraph of one sentence.
    pub(crate) fn paragraph(&mut self, sentence: impl Into<Sentence>) {
        self.put(Block::Paragraph(vec![sentence.into()]));
    }

    /// Adds a remark.
    pub(crate) fn note(&mut self, sentence: impl Into<Sentence>) {
        self.put(Block::Note(sentence.into()));
    }

    /// Adds a figure.
    pub(crate) fn charted(&mut self, figure: Figure<'a>) {
        self.put(Block::Figures(vec![figure]));
    }
}

impl<'a> Figure<'a> {
    /// A figure with a caption; it becomes a [`Figure`] with its data.
    pub(crate) fn drawn(caption: Vec<Sentence>, draw: impl Fn(Language) -> String + 'a) -> Unnumbered<'a> {
        Unnumbered {
            caption,
            draw: Box::new(draw),
        }
    }
}

/// A figure without data yet, which cannot be put into a document.
pub(crate) struct Unnumbered<'a> {
    caption: Vec<Sentence>,
    draw: Box<dyn Fn(Language) -> String + 'a>,
}

impl<'a> Unnumbered<'a> {
    /// The figure with its data.
    pub(crate) fn with_series(self, series: impl Fn() -> Vec<Series> + 'a) -> Figure<'a> {
        Figure {
            caption: self.caption,
            draw: self.draw,
            series: Box::new(series),
        }
    }
}

impl Column {
    /// A column of words.
    pub(crate) fn words(head: impl Into<Sentence>) -> Self {
        Column {
            head: head.into(),
            unit: Unit::ratio(),
            is_words: true,
        }
    }

    /// A column of numbers in a unit.
    pub(crate) fn numbers(head: impl Into<Sentence>, unit: Unit) -> Self {
        Column {
            head: head.into(),
            unit,
            is_words: false,
        }
    }

    /// Its heading with the unit: "k (kN·m/rad)".
    pub(crate) fn text(&self, language: Language) -> String {
        match self.unit.symbol.as_str() {
            "" => self.head.text(language),
            symbol => format!("{} ({symbol})", self.head.text(language)),
        }
    }
}

impl Cell {
    pub(crate) fn words(words: impl Into<Sentence>) -> Self {
        Cell::Words(words.into())
    }

    pub(crate) fn number(quantity: Quantity) -> Self {
        Cell::Number(Some(quantity))
    }

    /// Its text without a unit, which the column gives.
    pub(crate) fn text(&self, language: Language) -> String {
        match self {
            Cell::Words(words) | Cell::BadWords(words) => words.text(language),
            Cell::Number(Some(quantity)) | Cell::Bad(quantity) => quantity.number(),
            Cell::Number(None) => "–".to_owned(),
            Cell::Rises(quantity) => format!("{} ↑", quantity.number()),
        }
    }

    /// Its text with a unit, for places without a column.
    pub(crate) fn whole(&self, language: Language) -> String {
        match self {
            Cell::Number(Some(quantity)) | Cell::Bad(quantity) => quantity.text(),
            Cell::Rises(quantity) => format!("{} ↑", quantity.text()),
            Cell::Number(None) | Cell::Words(_) | Cell::BadWords(_) => self.text(language),
        }
    }

    /// Its number.
    pub(crate) fn quantity(&self) -> Option<&Quantity> {
        match self {
            Cell::Number(quantity) => quantity.as_ref(),
            Cell::Bad(quantity) | Cell::Rises(quantity) => Some(quantity),
            Cell::Words(_) | Cell::BadWords(_) => None,
        }
    }

    /// Whether it indicates a fall, or a value that must not be used.
    pub(crate) fn is_bad(&self) -> bool {
        matches!(self, Cell::Bad(_) | Cell::Rises(_) | Cell::BadWords(_))
    }
}
