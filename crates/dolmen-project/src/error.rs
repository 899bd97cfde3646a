//! Errors of a project file: every problem with its place.

use super::written_at::written_at;
use super::wrong::Framed;
use dolmen_words::message::{Argument, Both, Run};
use dolmen_words::{Language, nearest};
use std::collections::HashSet;
use std::fmt;
use std::ops::Range;
use unicode_width::UnicodeWidthChar;

/// One problem of a project file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// Path in the file: `links[2].centroid`; "" for the whole file.
    pub path: String,
    /// The problem, with the value.
    pub message: Both,
    /// The allowed values.
    pub allowed: Option<Both>,
    /// The remedy.
    pub help: Option<Both>,
    /// The source line; of a long line the surroundings of the problem.
    pub(super) text: String,
    /// Characters of `text` before the problem.
    pub(super) before: usize,
    /// Characters underlined, at least 1.
    pub(super) marked: usize,
}

/// Why a project file cannot be read: all problems, by line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProjectError {
    /// Name of the file, as given by the caller.
    pub file: String,
    /// The problems, by line; at least one.
    pub problems: Vec<Problem>,
    /// Number of further problems, which are not listed.
    pub more: usize,
}

impl std::error::Error for ProjectError {}

impl ProjectError {
    /// The first faults of a file, each with its place.
    pub(super) fn of(mut faults: Vec<Fault>, file: &str, text: &str) -> Self {
        leave_out_what_follows(&mut faults);
        faults.sort_by_key(|fault| (fault.span.start, fault.path.clone()));
        faults.dedup();
        let more = faults.len().saturating_sub(PROBLEMS_MOST);
        let told = faults.into_iter().take(PROBLEMS_MOST);
        ProjectError {
            file: file.to_owned(),
            problems: told.map(|fault| fault.locate(text)).collect(),
            more,
        }
    }
}

impl fmt::Display for ProjectError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text(Language::English))
    }
}

impl Argument for ProjectError {
    fn said(&self, language: Language) -> Vec<Run> {
        vec![Run::Name(self.text(language))]
    }
}

impl ProjectError {
    /// All problems in a language, each with its line of the file.
    pub fn text(&self, language: Language) -> String {
        let each = self
            .problems
            .iter()
            .map(|problem| problem.text(&self.file, language));
        let mut text = each.collect::<Vec<_>>().join("\n");
        let more = match self.more {
            0 => return text,
            1 => Framed::OneMore,
            count => Framed::More(count),
        };
        text += &format!("\n{}\n", Both::from(more).text(language));
        text
    }
}

impl Problem {
    /// Columns are counted as a terminal shows them: Hangul takes two.
    fn text(&self, file: &str, language: Language) -> String {
        let number = self.line.to_string();
        // " 7 | text": the bars are in one column, the arrow's tail one column before them
        let arrow = " ".repeat(number.len() + 1);
        let gutter = " ".repeat(number.len() + 2);
        let columns = |characters: &mut dyn Iterator<Item = char>| {
            characters.filter_map(UnicodeWidthChar::width).sum::<usize>()
        };
        let before = columns(&mut self.text.chars().take(self.before));
        let marked = self.text.chars().skip(self.before).take(self.marked);
        let carets = columns(&mut marked.into_iter()).max(1);
        let error = Both::from(Framed::Error(self.message.clone()));
        let allowed = self.allowed.as_ref();
        let allowed = allowed.map_or_else(String::new, |allowed| format!(" {}", allowed.text(language)));
        let mut lines = vec![
            error.text(language).to_owned(),
            format!("{arrow}--> {file}:{}:{}", self.line, self.column),
            format!("{gutter}|"),
            format!(" {number} | {}", self.text),
            format!("{gutter}| {}{}{allowed}", " ".repeat(before), "^".repeat(carets)),
        ];
        if let Some(help) = &self.help {
            let help = Both::from(Framed::Help(help.clone()));
            lines.push(format!("{gutter}= {}", help.text(language)));
        }
        lines.join("\n") + "\n"
    }
}

/// A sentence as an error: "error: …", "오류: …".
pub fn headed(message: &str, language: Language) -> String {
    let error = Framed::Error(message.into());
    Both::from(error).text(language).to_owned()
}

/// A problem before its line is known, with a span of bytes of the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Fault {
    pub(super) span: Range<usize>,
    pub(super) path: String,
    message: Both,
    allowed: Option<Both>,
    help: Option<Both>,
    /// Whether its cause is an unknown key.
    is_of_key: bool,
}

/// A misspelt key is one fault: faults that it causes in its table (missing keys, other units) are dropped.
fn leave_out_what_follows(faults: &mut Vec<Fault>) {
    let keys = faults.iter().filter(|fault| fault.is_of_key);
    let keys: Vec<String> = keys.map(|fault| fault.path.clone()).collect();
    let units = keys.iter().any(|key| nearest(key, ["units"]).is_some());
    let tables: HashSet<&str> = keys
        .iter()
        .filter_map(|key| Some(key.rsplit_once('.')?.0))
        .collect();
    let of_file = keys.iter().any(|key| !key.contains('.'));
    let follows = |fault: &Fault| {
        units
            || tables.contains(fault.path.as_str())
            || of_file && fault.span.is_empty() && fault.span.start == 0
    };
    faults.retain(|fault| fault.is_of_key || !follows(fault));
}

impl Fault {
    /// Whether its value seems to be in another unit, or in one of two.
    pub(super) fn asks_for(&self, unit: &str) -> bool {
        let help = self.help.as_ref().map_or("", |help| help.english.as_str());
        let meant = help.strip_prefix("did you mean ");
        let meant = meant.and_then(|rest| Some(rest.split_once('?')?.0));
        meant.is_some_and(|meant| meant.split(" or ").any(|one| one == unit))
    }

    pub(super) fn new(span: Range<usize>, path: &str, message: impl Into<Both>) -> Self {
        Fault {
            span,
            path: path.to_owned(),
            message: message.into(),
            allowed: None,
            help: None,
            is_of_key: false,
        }
    }

    /// Marks its cause as an unknown key.
    pub(super) fn of_key(mut self) -> Self {
        self.is_of_key = true;
        self
    }

    pub(super) fn allowed(mut self, allowed: impl Into<Both>) -> Self {
        self.allowed = Some(allowed.into());
        self
    }

    pub(super) fn help(mut self, help: impl Into<Both>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// The remedy, in English.
    #[cfg(test)]
    pub(super) fn text_of_help(&self) -> String {
        self.help
            .as_ref()
            .map_or_else(String::new, |help| help.english.clone())
    }

    /// Places it at the start of the file.
    pub(super) fn at_top(mut self) -> Self {
        self.span = 0..0;
        self
    }

    /// Adds the cell of the table that contains it.
    pub(super) fn say_cell(&mut self, file: &str, cell: &str) {
        self.message = Both::from(Framed::InCell {
            message: self.message.clone(),
            file: file.to_owned(),
            cell: cell.to_owned(),
        });
    }

    /// Adds the name of its variant.
    pub(super) fn in_variant(mut self, name: &str) -> Self {
        self.path = format!("variant.{name}.{}", self.path);
        self.message = Both::from(Framed::InVariant {
            variant: name.to_owned(),
            message: self.message,
        });
        self
    }

    /// Whether it concerns the value at a path or a part of it.
    pub(super) fn is_at_or_below(&self, path: &str) -> bool {
        let rest = self.path.strip_prefix(path);
        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
    }

    /// Finds its line and column.
    pub(super) fn locate(mut self, text: &str) -> Problem {
        if self.span == (0..0) && !self.path.is_empty() {
            self.span = written_at(text, &self.path).unwrap_or(0..0);
        }
        let start = floor_char_boundary(text, self.span.start);
        let end = floor_char_boundary(text, self.span.end.max(start));
        let line_start = text[..start].rfind('\n').map_or(0, |at| at + 1);
        let line_end = text[start..].find('\n').map_or(text.len(), |at| start + at);
        let line = text[line_start..line_end].trim_end_matches('\r');
        let marked_end = end.clamp(start, line_start + line.len().max(start - line_start));
        let column = text[line_start..start].chars().count() + 1;
        let marked = text[start..marked_end].chars().count().max(1);
        let from = if line.chars().nth(QUOTED_MOST).is_none() {
            1
        } else {
            column.saturating_sub(QUOTED_BEFORE).max(1)
        };
        let quoted: String = line.chars().skip(from - 1).take(QUOTED_MOST).collect();
        let is_cut = |cut: bool| if cut { "…" } else { "" };
        let (begins, ends) = (from > 1, line.chars().nth(from - 1 + QUOTED_MOST).is_some());
        let quoted = format!("{}{quoted}{}", is_cut(begins), is_cut(ends));
        let before = column - from + usize::from(begins);
        Problem {
            line: text[..start].matches('\n').count() + 1,
            column,
            path: self.path,
            message: shortened(self.message),
            allowed: self.allowed.map(shortened),
            help: self.help.map(shortened),
            // a tab or a control character would misplace the carets, or control the terminal
            text: quoted.replace(char::is_control, " "),
            before,
            marked: marked.min(QUOTED_MOST + 1 - before.min(QUOTED_MOST)),
        }
    }
}

/// Most problems listed of a file, our choice: further ones are counted.
const PROBLEMS_MOST: usize = 20;
/// Most quoted characters of a line.
const QUOTED_MOST: usize = 200;
/// Quoted characters before a problem in a long line.
const QUOTED_BEFORE: usize = 60;
/// Most characters of a sentence, which may contain a long value.
const SENTENCE_MOST: usize = 1000;

/// A sentence of bounded length with its end kept, which states what is allowed.
fn shortened(sentence: Both) -> Both {
    Both {
        english: shortened_text(sentence.english),
        korean: shortened_text(sentence.korean),
    }
}

fn shortened_text(sentence: String) -> String {
    let length = sentence.chars().count();
    if length <= SENTENCE_MOST {
        return sentence;
    }
    let half = SENTENCE_MOST / 2;
    let (start, end): (String, String) = (
        sentence.chars().take(half).collect(),
        sentence.chars().skip(length - half).collect(),
    );
    format!("{start} … {end}")
}

/// The start of the character that a byte belongs to.
fn floor_char_boundary(text: &str, at: usize) -> usize {
    let at = at.min(text.len());
    (0..=at).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0)
}
