//! Numbers of sections, tables and figures: the same on the page, in documents and in print.

use dolmen_words::{Language, Sentence, messages};
use std::collections::BTreeSet;

messages! {
    /// Text before a caption.
    pub(crate) enum Label in "document.label" {
        Table { number: Sentence } => { en: "Table {number}", ko: "표 {number}" },
        Figure { number: Sentence } => { en: "Figure {number}", ko: "그림 {number}" },
    }
}

/// Numbers while a document is read: sections 1, 2 …, their parts 1.1, 1.2 …; tables and figures separately 1.1, 1.2 … by section.
///
/// In a report on several projects each project is a section, and everything is one level deeper; its tables and figures are numbered
/// through the whole project.
#[derive(Clone, Debug, Default)]
pub(crate) struct Numbers {
    project: Option<usize>,
    section: usize,
    part: usize,
    tables: usize,
    figures: usize,
    anchors: BTreeSet<String>,
}

impl Numbers {
    /// Numbers of a report on one project.
    pub(crate) fn alone() -> Self {
        Numbers::default()
    }

    /// Numbers of the project with this index, from 1, in a report on several.
    pub(crate) fn of_project(number: usize) -> Self {
        Numbers {
            project: Some(number),
            ..Numbers::default()
        }
    }

    /// The number of the next section.
    pub(crate) fn section(&mut self) -> String {
        self.section += 1;
        self.part = 0;
        if self.project.is_none() {
            (self.tables, self.figures) = (0, 0);
        }
        dotted(&[self.project, Some(self.section)])
    }

    /// The number of the next part of a section.
    pub(crate) fn part(&mut self) -> String {
        self.part += 1;
        dotted(&[self.project, Some(self.section), Some(self.part)])
    }

    /// The number of the next table.
    pub(crate) fn table(&mut self) -> String {
        self.tables += 1;
        dotted(&[self.chapter(), Some(self.tables)])
    }

    /// The number of the next figure.
    pub(crate) fn figure(&mut self) -> String {
        self.figures += 1;
        dotted(&[self.chapter(), Some(self.figures)])
    }

    /// The identifier of a block, from the message at its head, so that a link to it holds in each language and after the next run. A message
    /// that heads several blocks counts them.
    pub(crate) fn anchor(&mut self, head: &Sentence) -> String {
        let message = head.id.replace(['/', '.'], "-");
        let message = match self.project {
            Some(number) => format!("report-{number}-{message}"),
            None => message,
        };
        let mut anchor = message.clone();
        let mut count = 1;
        while !self.anchors.insert(anchor.clone()) {
            count += 1;
            anchor = format!("{message}-{count}");
        }
        anchor
    }

    /// Prefix of the numbers of tables and figures; `None` before the first section.
    fn chapter(&self) -> Option<usize> {
        self.project.or(Some(self.section).filter(|section| *section > 0))
    }
}

/// "Table 2.1".
pub(crate) fn table_label(number: &str, language: Language) -> String {
    let number = Sentence::of_symbol(number);
    Sentence::from(Label::Table { number }).text(language)
}

/// "Figure 2.1".
pub(crate) fn figure_label(number: &str, language: Language) -> String {
    let number = Sentence::of_symbol(number);
    Sentence::from(Label::Figure { number }).text(language)
}

fn dotted(numbers: &[Option<usize>]) -> String {
    let each: Vec<String> = numbers.iter().flatten().map(usize::to_string).collect();
    each.join(".")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_tables_and_figures_count_apart_and_anew_in_each_section() {
        let mut numbers = Numbers::alone();
        assert_eq!(numbers.table(), "1", "before the first section");
        assert_eq!(numbers.section(), "1");
        let counted = [numbers.table(), numbers.figure(), numbers.part(), numbers.table()];
        assert_eq!(counted, ["1.1", "1.1", "1.1", "1.2"]);
        assert_eq!(numbers.section(), "2");
        assert_eq!([numbers.part(), numbers.table()], ["2.1", "2.1"]);
    }

    #[test]
    fn exact_a_project_of_several_is_a_section() {
        let mut numbers = Numbers::of_project(3);
        let counted = [numbers.section(), numbers.table(), numbers.part()];
        assert_eq!(counted, ["3.1", "3.1", "3.1.1"]);
        let counted = [numbers.section(), numbers.table(), numbers.figure()];
        assert_eq!(counted, ["3.2", "3.2", "3.1"]);
    }

    #[test]
    fn exact_an_anchor_is_of_the_message_and_counts_its_blocks() {
        let head = |number: &str| {
            let number = Sentence::of_symbol(number);
            Sentence::from(Label::Table { number })
        };
        let mut numbers = Numbers::alone();
        let anchors = [numbers.anchor(&head("1")), numbers.anchor(&head("2"))];
        assert_eq!(anchors, ["document-label-table", "document-label-table-2"]);
        let of_second = Numbers::of_project(2).anchor(&head("1"));
        assert_eq!(of_second, "report-2-document-label-table");
    }

    #[test]
    fn exact_labels_in_both_languages() {
        assert_eq!(table_label("2.1", Language::Korean), "표 2.1");
        assert_eq!(figure_label("2.1", Language::English), "Figure 2.1");
    }
}
