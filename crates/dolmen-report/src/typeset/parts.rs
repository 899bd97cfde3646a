//! The parts of a report: cover, what the answers come to, findings, sections, what was given, method, sources.

use super::literal::{array, literal};
use crate::document::{Block, Cell, Finding, Table, Tone};
use crate::html::front::{banner, closing, kind_words, sources};
use crate::html::given::{survey_head, survey_lines};
use crate::html::method::method;
use crate::html::{Imprint, NotReported, project_name};
use crate::whole::{all_findings, whole_document};
use crate::xlsx::inputs_tables;
use dolmen_project::Structure;
use dolmen_words::Language;
use dolmen_work::answer::ProjectReport;
use dolmen_work::judgement::Colour;

/// What stands in the line over each page.
pub(super) fn running_head(answers: &[ProjectReport], language: Language) -> &'static str {
    match answers {
        [one] => kind_words(&one.project.structure, language),
        _ => "",
    }
}

/// The source as it is written.
pub(super) struct Parts {
    pub(super) language: Language,
    main: String,
    figures: Vec<(String, Vec<u8>)>,
    /// By how much heads stand below those of a report on one project.
    deeper: usize,
}

impl Parts {
    pub(super) fn new(language: Language) -> Self {
        Parts {
            language,
            main: String::new(),
            figures: Vec::new(),
            deeper: 0,
        }
    }

    pub(super) fn finish(self) -> (String, Vec<(String, Vec<u8>)>) {
        (self.main, self.figures)
    }

    pub(super) fn line(&mut self, line: &str) {
        self.main.push_str(line);
        self.main.push('\n');
    }

    /// A function of the prelude on words.
    pub(super) fn call(&mut self, function: &str, words: &str) {
        self.line(&format!("#{function}({})", literal(words)));
    }

    pub(super) fn heading(&mut self, level: usize, words: &str) {
        self.line(&format!(
            "#heading(level: {}, {})",
            level + self.deeper,
            literal(words)
        ));
    }

    pub(super) fn list(&mut self, points: impl IntoIterator<Item = String>) {
        let each = array(points.into_iter().map(|point| literal(&point)));
        self.line(&format!("#list(..{each})"));
    }

    /// Keeps a figure, and gives the name of its file; a mark that the fonts do not have is spelt.
    pub(super) fn figure_file(&mut self, svg: &str) -> String {
        let svg = svg.replace('⊕', "(+)");
        let name = format!("figure-{}.svg", self.figures.len() + 1);
        self.figures.push((name.clone(), svg.into_bytes()));
        name
    }

    /// All that is said of one project.
    pub(super) fn project(&mut self, answer: &ProjectReport, imprint: &Imprint, alone: bool) {
        let language = self.language;
        self.cover(answer, imprint);
        self.deeper = usize::from(!alone);
        if !alone {
            self.line(&format!(
                "#heading(level: 1, {})",
                literal(project_name(answer, language))
            ));
        }
        if let Some(state) = answer.state() {
            let banner = banner(answer, state, language);
            let sentence: Vec<String> = [Some(banner.sentence), banner.assumed]
                .into_iter()
                .flatten()
                .collect();
            self.line(&format!(
                "#banner({}, {}, {}, {}, {})",
                literal(colour(banner.colour)),
                literal(&banner.words),
                array(banner.first.iter().map(|line| literal(line))),
                literal(&sentence.join(" ")),
                literal(&banner.scale),
            ));
        }
        self.findings(&all_findings(answer));
        if alone {
            self.call("contents", language.code());
            self.line("#pagebreak(weak: true)");
        }
        self.document(&whole_document(answer));
        self.given(answer);
        self.heading(1, language.pick("Method and limits", "방법과 한계"));
        let lines = method(&answer.project.structure, language);
        self.list(lines.into_iter().map(str::to_owned));
        self.heading(1, language.pick("Evidence and sources", "근거와 출처"));
        self.list(sources(answer, language, imprint));
        self.call("note", closing(language));
    }

    fn cover(&mut self, answer: &ProjectReport, imprint: &Imprint) {
        let language = self.language;
        let project = &answer.project;
        let name = project_name(answer, language);
        let other = Some(language.pick(project.name.korean(), project.name.english()));
        let other = other.filter(|other| *other != name);
        let date = imprint.date.iter();
        let rows = date
            .map(|date| (language.pick("Date", "보고일"), date.as_str()))
            .chain([(
                language.pick("Computed by", "계산 프로그램"),
                imprint.program.as_str(),
            )]);
        let rows = array(rows.map(|(key, value)| format!("({}, {})", literal(key), literal(value))));
        let picture = self.picture(answer);
        self.line(&format!(
            "#cover(kind: {}, title: {}, other: {}, rows: {rows}, picture: {picture})",
            literal(kind_words(&project.structure, language)),
            literal(name),
            other.map_or("none".to_owned(), literal),
        ));
    }

    /// A stack as it stands, for the cover; none of other kinds, which begin with graphs.
    fn picture(&mut self, answer: &ProjectReport) -> String {
        if !matches!(answer.project.structure, Structure::Stack(_)) {
            return "none".to_owned();
        }
        let document = whole_document(answer);
        let first = document.blocks.iter().find_map(|block| match block {
            Block::Figures(figures) => figures.first(),
            _ => None,
        });
        let Some(first) = first else {
            return "none".to_owned();
        };
        let file = self.figure_file(&(first.draw)(self.language));
        let said = first.caption.first();
        let said = said.map_or(String::new(), |said| said.text(self.language));
        format!("({}, {})", literal(&file), literal(&said))
    }

    fn findings(&mut self, findings: &[Finding]) {
        let head = self.language.pick("Findings", "검토 결과 요약");
        self.line(&format!(
            "#heading(level: {}, numbering: none, outlined: false, {})",
            1 + self.deeper,
            literal(head)
        ));
        for finding in findings {
            let words = finding.sentence.text(self.language);
            self.line(&format!(
                "#finding({}, {})",
                literal(tone(finding.tone)),
                literal(&words)
            ));
        }
    }

    fn given(&mut self, answer: &ProjectReport) {
        let language = self.language;
        let project = &answer.project;
        self.heading(1, language.pick("What was given", "입력 자료"));
        if let Some(description) = &project.description {
            self.call("par", description);
        }
        for headed in inputs_tables(answer) {
            self.table(&without_empty_columns(headed.table, language));
        }
        for survey in &project.surveys {
            self.heading(2, &survey_head(survey, language));
            self.list(survey_lines(survey, language));
        }
        if !project.warnings.is_empty() {
            let head = language.pick("Warnings on reading the file", "입력 파일에 대한 경고");
            self.heading(2, head);
            let warnings = project.warnings.iter();
            self.list(warnings.map(|warning| warning.message.text(language)));
        }
    }

    /// Projects that could not be reported on, and why.
    pub(super) fn not_reported(&mut self, others: &[NotReported]) {
        if others.is_empty() {
            return;
        }
        let language = self.language;
        self.deeper = 0;
        self.heading(1, language.pick("Not reported on", "보고서에서 제외됨"));
        let said = others.iter().map(|other| {
            let mark = language.pick("", "[영문] ");
            format!("{}: {mark}{}", other.file, other.why)
        });
        self.list(said);
    }
}

/// The table without the columns in which nothing stands.
fn without_empty_columns(table: Table, language: Language) -> Table {
    let is_empty = |row: &Vec<Cell>, column: usize| {
        let text = row.get(column).map(|cell| cell.text(language));
        matches!(text.as_deref(), None | Some("" | "–"))
    };
    let kept: Vec<bool> = (0..table.columns.len())
        .map(|column| !table.rows.iter().all(|row| is_empty(row, column)))
        .collect();
    fn only<T>(all: Vec<T>, kept: &[bool]) -> Vec<T> {
        let each = all.into_iter().zip(kept);
        each.filter_map(|(one, kept)| kept.then_some(one)).collect()
    }
    Table {
        caption: table.caption,
        columns: only(table.columns, &kept),
        rows: table.rows.into_iter().map(|row| only(row, &kept)).collect(),
    }
}

fn colour(colour: Colour) -> &'static str {
    match colour {
        Colour::Green => "good",
        Colour::Amber => "warn",
        Colour::Red => "bad",
    }
}

fn tone(tone: Tone) -> &'static str {
    match tone {
        Tone::Good => "good",
        Tone::Warn => "warn",
        Tone::Bad => "bad",
        Tone::Plain => "plain",
        Tone::Unknown => "unknown",
    }
}
