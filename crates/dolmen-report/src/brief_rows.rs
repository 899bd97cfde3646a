//! A short answer with tables: the decisive part, as many table rows as fit, and how to see all.

use crate::document::{Block, Document, Table, TextStyle, document_text, wrapped};
use dolmen_words::{Sentence, messages};

/// Lines of a short answer below its headline.
const LINES_MOST: usize = 15;

messages! {
    /// The end of a brief answer.
    pub(crate) enum BriefRows in "brief.rows" {
        MoreRows { count: usize } => { en: "further rows: {count}", ko: "나머지 {count}행" },
        MoreRemarks { count: usize } => { en: "further remarks: {count}", ko: "그 밖의 사항 {count}건" },
        Full => { en: "all of it with --full", ko: "전체 내용은 --full" },
    }
}

/// Lines below a headline, and how much did not fit.
pub(crate) struct BriefText {
    style: TextStyle,
    text: String,
    remarks: usize,
    rows: usize,
}

impl BriefText {
    /// An empty text.
    pub(crate) fn new(style: TextStyle) -> Self {
        BriefText {
            style,
            text: String::new(),
            remarks: 0,
            rows: 0,
        }
    }

    fn lines_with(&self, piece: &str) -> usize {
        self.text.lines().count() + piece.lines().count()
    }

    /// Adds a block if it fits.
    pub(crate) fn block(&mut self, block: Block<'_>) {
        self.block_within(block, LINES_MOST - 1);
    }

    /// Adds each block that fits.
    pub(crate) fn blocks<'a>(&mut self, blocks: impl IntoIterator<Item = Block<'a>>) {
        blocks.into_iter().for_each(|block| self.block(block));
    }

    /// Adds a block if the total then has at most `most` lines.
    pub(crate) fn block_within(&mut self, block: Block<'_>, most: usize) {
        let piece = document_text(&Document { blocks: vec![block] }, self.style);
        match self.lines_with(&piece) <= most {
            true => self.text += &piece,
            false => self.remarks += 1,
        }
    }

    /// Adds the first rows of a table, as many as fit and at most `most`.
    pub(crate) fn table(&mut self, table: &Table, most: usize) {
        let piece = |rows: usize| {
            let mut cut = table.clone();
            cut.rows.truncate(rows);
            let blocks = vec![Block::Table(cut)];
            document_text(&Document { blocks }, self.style)
        };
        let most = most.min(table.rows.len());
        // the last line says how to list all
        let has_room = |rows: &usize| self.lines_with(&piece(*rows)) < LINES_MOST;
        let fitting = (1..=most).rev().find(has_room);
        let shown = fitting.map_or_else(String::new, piece);
        self.text += &shown;
        self.rows += table.rows.len() - fitting.unwrap_or(0);
    }

    /// The lines, and how to see all.
    pub(crate) fn finish(self) -> String {
        let (rows, remarks) = (self.rows, self.remarks);
        let parts = [
            (rows, BriefRows::MoreRows { count: rows }),
            (remarks, BriefRows::MoreRemarks { count: remarks }),
            (1, BriefRows::Full),
        ];
        let each = parts.into_iter().filter(|(count, _)| *count > 0);
        let each: Vec<String> = each
            .map(|(_, part)| Sentence::from(part).text(self.style.language))
            .collect();
        self.text + &wrapped(&each.join(" · "), "  ", "  ", self.style.columns())
    }
}
