//! Checks the tree of a file against the schema: unknown keys, keys swallowed by the table above them, missing
//! keys, wrong types, unknown words. A wrong value is reported and removed, so that the rest can be read and its
//! own problems reported too.

use super::error::Fault;
use super::schema_tree::Tree;
use super::type_words::{alternatives, is_by_direction, lower_first, type_word_of, type_words};
use super::wrong::{Common, WrongKey, either, of_schema};
use dolmen_words::message::Both;
use dolmen_words::{Language, nearest};
use std::borrow::Cow;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Longest value that a message repeats, in characters.
const ECHO_MOST: usize = 48;

pub(super) type Node<'i> = Spanned<DeValue<'i>>;

/// A key that stands below a table header but belongs to the top level.
struct Swallowed<'i> {
    key: Spanned<Cow<'i, str>>,
    value: Node<'i>,
}

pub(super) struct SchemaCheck<'t, 'i> {
    text: &'t str,
    schema: &'static Tree,
    swallowed: Vec<Swallowed<'i>>,
    /// Paths that a misspelt key was probably intended for: not reported as missing.
    pub(super) meant: Vec<String>,
    pub(super) faults: Vec<Fault>,
}

/// One table on the way from the root to the value.
#[derive(Clone, Copy)]
struct Table<'a> {
    path: &'a str,
    properties: Option<&'static [(&'static str, Tree)]>,
    header: Option<&'a Range<usize>>,
    parent: Option<&'a Table<'a>>,
}

impl<'t, 'i> SchemaCheck<'t, 'i> {
    pub(super) fn new(text: &'t str, schema: &'static Tree) -> Self {
        SchemaCheck {
            text,
            schema,
            swallowed: Vec::new(),
            meant: Vec::new(),
            faults: Vec::new(),
        }
    }

    /// Checks the whole tree and removes wrong values.
    pub(super) fn file(&mut self, root: &mut DeTable<'i>, root_span: &Range<usize>) {
        self.table(root, root_span, self.schema, "", None);
        for Swallowed { key, mut value } in std::mem::take(&mut self.swallowed) {
            let name = key.get_ref().to_string();
            if root.contains_key(name.as_str()) {
                continue;
            }
            if let Some(schema) = property(self.schema, &name)
                && self.value(&mut value, schema, &name, None)
            {
                root.insert(key, value);
            }
        }
        self.required(root, root_span, self.schema, "");
    }

    /// Checks one value; `false` if it must be removed.
    fn value(
        &mut self,
        node: &mut Node<'i>,
        schema: &'static Tree,
        path: &str,
        above: Option<&Table<'_>>,
    ) -> bool {
        let span = node.span();
        let schema = self.schema.resolved(schema);
        let branches = branches(self.schema, schema);
        let fitting: Vec<&'static Tree> = branches
            .iter()
            .copied()
            .filter(|branch| fits(node.get_ref(), branch))
            .collect();
        let Some(branch) = fitting.first().copied() else {
            self.wrong_type(node, schema, &branches, path);
            return false;
        };
        match node.get_mut() {
            DeValue::String(word) => {
                if let Some(meant) = meant_word(word, &fitting) {
                    *word = Cow::Borrowed(meant);
                }
                return self.word(word, &fitting, schema, path, &span);
            }
            DeValue::Table(table) => {
                self.table(table, &span, branch, path, above);
                let before = self.faults.len();
                self.required(table, &span, branch, path);
                // A quantity without its value is useless; a part without a key can still be read.
                return self.faults.len() == before || branches.len() == 1;
            }
            DeValue::Array(list) => {
                let Some(items) = branch.get("items") else {
                    return true;
                };
                let mut sound = true;
                for (i, item) in list.iter_mut().enumerate() {
                    sound &= self.value(item, items, &format!("{path}[{}]", i + 1), above);
                }
                return sound;
            }
            _ => {}
        }
        true
    }

    fn table(
        &mut self,
        table: &mut DeTable<'i>,
        span: &Range<usize>,
        schema: &'static Tree,
        path: &str,
        parent: Option<&Table<'_>>,
    ) {
        let known = properties(schema);
        let others = schema
            .get("additionalProperties")
            .filter(|others| others.entries().is_some());
        let header = self
            .text
            .get(span.clone())
            .filter(|written| written.starts_with('['));
        let above = Table {
            path,
            properties: known,
            header: header.map(|_| span),
            parent,
        };
        let mut out: Vec<String> = Vec::new();
        for (key, value) in table.iter_mut() {
            let name = key.get_ref().as_ref();
            let below = join(path, name);
            let sound = match (entry(known, name), others) {
                (Some(schema), _) | (None, Some(schema)) => self.value(value, schema, &below, Some(&above)),
                (None, None) if schema.get("additionalProperties") == Some(&Tree::Bool(false)) => {
                    self.unknown(key, value, &below, &above);
                    false
                }
                (None, None) => true,
            };
            if !sound {
                out.push(name.to_owned());
            }
        }
        for name in out {
            table.remove(name.as_str());
        }
    }

    /// Reports an unknown key: swallowed by the table above it, or misspelt.
    fn unknown(&mut self, key: &Spanned<Cow<'i, str>>, value: &Node<'i>, path: &str, above: &Table<'_>) {
        let name = key.get_ref().as_ref();
        let place = match path.len() - name.len() {
            0 => Both::from(WrongKey::TopLevel),
            end => path[..end - 1].into(),
        };
        let fault = Fault::new(
            key.span(),
            path,
            WrongKey::HasNoKey {
                place,
                name: name.to_string(),
            },
        );
        let mut owner = above.parent;
        while let Some(table) = owner {
            let owns = entry(table.properties, name).is_some();
            if let (true, Some(header)) = (owns, above.header) {
                let header_line = self.text[..header.start].matches('\n').count() + 1;
                let header = self.text[header.clone()].trim();
                let (belongs, remedy) = match table.path {
                    "" => (
                        Both::from(WrongKey::TopLevel),
                        Both::from(WrongKey::AboveFirstTable),
                    ),
                    path => (
                        Both::from(format!("[{path}]")),
                        Both::from(WrongKey::AboveLineBelow {
                            header_line: header_line.to_string(),
                            path: path.to_string(),
                        }),
                    ),
                };
                let message = WrongKey::BelongsToButStands {
                    name: name.to_string(),
                    belongs,
                    header: header.to_string(),
                    header_line: header_line.to_string(),
                };
                self.faults.push(
                    Fault::new(key.span(), path, message)
                        .allowed(WrongKey::SwallowedByTableAbove)
                        .help(WrongKey::MoveItInToml(remedy)),
                );
                if table.parent.is_none() {
                    self.swallowed.push(Swallowed {
                        key: key.clone(),
                        value: value.clone(),
                    });
                }
                return;
            }
            owner = table.parent;
        }
        let known: Vec<&str> = above
            .properties
            .into_iter()
            .flatten()
            .map(|(key, _)| *key)
            .collect();
        let help = match nearest(name, known.iter().copied()) {
            Some(near) => {
                self.meant
                    .push(join(path[..path.len() - name.len()].trim_end_matches('.'), near));
                Both::from(Common::DidYouMean(near.to_string()))
            }
            None => Both::from(WrongKey::KnownKeysAre(known.join(", "))),
        };
        self.faults
            .push(fault.allowed(WrongKey::UnknownKey).help(help).of_key());
    }

    fn required(&mut self, table: &DeTable<'i>, span: &Range<usize>, schema: &'static Tree, path: &str) {
        let required = schema.get("required").and_then(Tree::list);
        for name in required.into_iter().flatten().filter_map(Tree::text) {
            // A wrong key that was removed has been reported already.
            let below = join(path, name);
            let is_meant = || self.meant.contains(&below);
            if table.contains_key(name)
                || is_meant()
                || self.faults.iter().any(|fault| fault.is_at_or_below(&below))
            {
                continue;
            }
            let subject = match path {
                "" => WrongKey::File.into(),
                path => Both::from(path),
            };
            let mut fault = Fault::new(
                span.clone(),
                &below,
                WrongKey::HasNoButNeeds {
                    subject,
                    name: name.to_string(),
                },
            );
            let property = schema.get("properties").and_then(|all| all.get(name));
            if let Some(meaning) = property.and_then(description) {
                fault = fault.help(WrongKey::Write {
                    name: name.to_string(),
                    meaning: Both {
                        english: lower_first(&meaning),
                        korean: of_schema(&meaning).korean,
                    },
                });
            }
            if path.is_empty() {
                fault = fault.at_top();
                fault = match name {
                    "schema" => fault.help(WrongKey::WriteSchemaAsFirst),
                    "kind" => {
                        let kinds = property.iter().flat_map(|of| branches(self.schema, of));
                        let kinds: Vec<&str> = kinds.flat_map(words).collect();
                        fault.help(WrongKey::WriteKind(alternatives(&kinds)))
                    }
                    _ => fault,
                };
            }
            self.faults.push(fault);
        }
    }

    /// Checks text that must be one of some words.
    fn word(
        &mut self,
        word: &str,
        fitting: &[&'static Tree],
        schema: &'static Tree,
        path: &str,
        span: &Range<usize>,
    ) -> bool {
        let words: Vec<&str> = fitting.iter().flat_map(|branch| words(branch)).collect();
        if words.is_empty() || words.contains(&word) || fitting.iter().any(|branch| !is_word(branch)) {
            return true;
        }
        let allowed = match schema.get("x-must-be").and_then(Tree::text) {
            Some(must_be) => of_schema(must_be),
            None => alternatives(&words),
        };
        let mut fault = Fault::new(
            span.clone(),
            path,
            WrongKey::IsNotKnown {
                path: path.to_string(),
                word: word.to_string(),
            },
        );
        fault = fault.allowed(WrongKey::MustBe(allowed));
        if let Some(near) = nearest(word, words.iter().copied()) {
            fault = fault.help(Common::DidYouMean(near.to_string()));
        }
        self.faults.push(fault);
        false
    }

    /// Whether some branch is a list of tables.
    fn lists_tables(&self, branches: &[&'static Tree]) -> bool {
        let mut items = branches.iter().filter_map(|branch| branch.get("items"));
        items.any(|items| properties(self.schema.resolved(items)).is_some())
    }

    fn wrong_type(&mut self, node: &Node<'i>, schema: &'static Tree, branches: &[&'static Tree], path: &str) {
        let span = node.span();
        let needed = match schema.get("x-must-be").and_then(Tree::text) {
            Some(must_be) => of_schema(must_be),
            None => {
                let mut types: Vec<Both> = branches
                    .iter()
                    .filter_map(|branch| type_words(type_of(branch)?))
                    .collect();
                types.dedup();
                let types = |language| {
                    types
                        .iter()
                        .map(|one| one.text(language).to_owned())
                        .collect::<Vec<_>>()
                };
                Both {
                    english: either(&types(Language::English)).english,
                    korean: either(&types(Language::Korean)).korean,
                }
            }
        };
        let needed_word = needed.english.clone();
        let is = |word: &str| needed_word.starts_with(word);
        let written = self.text.get(span.clone()).unwrap_or_default().trim();
        let is_short = !written.contains('\n') && written.chars().count() <= ECHO_MOST;
        let echo = if is_short && !written.starts_with("[[") && matches!(node.get_ref(), DeValue::Table(_)) {
            String::new()
        } else if is_short {
            format!(" = {written}")
        } else {
            String::new()
        };
        let given = type_word_of(node.get_ref());
        let mut fault = Fault::new(
            span,
            path,
            WrongKey::Is {
                path: path.to_string(),
                echo: echo.to_string(),
                given,
            },
        );
        fault = fault.allowed(WrongKey::MustBeOfType(needed));
        let help = match node.get_ref() {
            DeValue::String(_) if is("a number") || is("a whole") => Some(WrongKey::WriteNumberWithoutQuotes),
            DeValue::Datetime(_) if is("text") => Some(WrongKey::PutItInQuotes(written.to_string())),
            DeValue::Integer(_) | DeValue::Float(_) | DeValue::String(_)
                if needed_word == "a list" && self.lists_tables(branches) =>
            {
                Some(WrongKey::ListEachWithIts(path.to_string()))
            }
            DeValue::Integer(_) | DeValue::Float(_) | DeValue::String(_) if needed_word == "a list" => {
                Some(WrongKey::PutItInBrackets(written.to_string()))
            }
            DeValue::Integer(_) | DeValue::Float(_) | DeValue::String(_) | DeValue::Array(_)
                if needed_word == "a table" && is_by_direction(path) && is_short =>
            {
                let (key, written) = (
                    path.rsplit('.').next().unwrap_or(path).to_owned(),
                    written.to_owned(),
                );
                Some(WrongKey::GiveByDirection { key, written })
            }
            DeValue::String(_) if needed_word == "a table" && path.ends_with(".files") => {
                Some(WrongKey::SayWhichComponentIt(written.to_string()))
            }
            DeValue::Integer(_) | DeValue::Float(_) | DeValue::String(_) if path == "damping" => {
                Some(WrongKey::DampingRatio(written.to_string()))
            }
            DeValue::Integer(_) | DeValue::Float(_) | DeValue::String(_) if needed_word == "a table" => {
                let (table, key) = path.rsplit_once('.').unwrap_or(("", path));
                let named = branches.iter().any(|branch| property(branch, key).is_some());
                (!table.is_empty() && named).then(|| WrongKey::BelongsOneLevelDeeper {
                    key: key.to_string(),
                    table: table.to_string(),
                })
            }
            _ => None,
        };
        if let Some(help) = help {
            fault = fault.help(help);
        }
        self.faults.push(fault);
    }
}

fn join(path: &str, key: &str) -> String {
    if path.is_empty() {
        key.to_owned()
    } else {
        format!("{path}.{key}")
    }
}

fn properties(schema: &Tree) -> Option<&'static [(&'static str, Tree)]> {
    schema.get("properties").and_then(Tree::entries)
}

fn property(schema: &Tree, name: &str) -> Option<&'static Tree> {
    entry(properties(schema), name)
}

fn entry(entries: Option<&'static [(&'static str, Tree)]>, name: &str) -> Option<&'static Tree> {
    let found = entries?.iter().find(|(key, _)| *key == name);
    found.map(|(_, value)| value)
}

fn description(schema: &Tree) -> Option<String> {
    let text = schema.get("description")?.text()?;
    Some(text.split_whitespace().collect::<Vec<_>>().join(" "))
}

/// The alternatives of a schema; itself without alternatives.
fn branches(whole: &'static Tree, schema: &'static Tree) -> Vec<&'static Tree> {
    let schema = whole.resolved(schema);
    let choice = schema
        .get("anyOf")
        .or_else(|| schema.get("oneOf"))
        .and_then(Tree::list);
    match choice {
        Some(alternatives) => alternatives.iter().flat_map(|one| branches(whole, one)).collect(),
        None => vec![schema],
    }
}

/// The known word for another spelling: in other capitals, with Roman numerals or their digits ("s2", "Ⅱ", "1").
fn meant_word(word: &str, fitting: &[&'static Tree]) -> Option<&'static str> {
    if !fitting.iter().all(|branch| is_word(branch)) {
        return None;
    }
    let known: Vec<&'static str> = fitting.iter().flat_map(|branch| words(branch)).collect();
    if known.contains(&word) {
        return None;
    }
    let plain = |text: &str| -> String {
        let text = text.trim();
        let roman = |c: char| match c {
            'Ⅰ' | 'ⅰ' => "i".to_owned(),
            'Ⅱ' | 'ⅱ' => "ii".to_owned(),
            'Ⅲ' | 'ⅲ' => "iii".to_owned(),
            'Ⅳ' | 'ⅳ' => "iv".to_owned(),
            other => other.to_lowercase().collect(),
        };
        text.chars().map(roman).collect()
    };
    let written = plain(word);
    // grades of KDS 41 17 00 in the words of the code: 특등급, Ⅰ등급
    let grade = written.strip_suffix("등급").unwrap_or(&written).trim();
    let numeral = match grade {
        "특" => "special",
        "1" => "i",
        "2" => "ii",
        "3" => "iii",
        "4" => "iv",
        other => other,
    };
    let mut same = known.into_iter().filter(|known| {
        let known = plain(known);
        known == written || known == numeral
    });
    let found = same.next()?;
    same.next().is_none().then_some(found)
}

fn is_word(schema: &Tree) -> bool {
    schema.get("const").is_some() || schema.get("enum").is_some()
}

fn words(schema: &'static Tree) -> Vec<&'static str> {
    let constant = schema.get("const").and_then(Tree::text);
    let list = schema.get("enum").and_then(Tree::list);
    constant
        .into_iter()
        .chain(list.into_iter().flatten().filter_map(Tree::text))
        .collect()
}

fn type_of(schema: &Tree) -> Option<&'static str> {
    let constant = || {
        schema
            .get("const")
            .or_else(|| schema.get("enum")?.list()?.first())
    };
    let named = schema.get("type").and_then(Tree::text);
    named.or_else(|| {
        constant()
            .filter(|value| value.text().is_some())
            .map(|_| "string")
    })
}

/// Whether a value has the type in a schema. A schema without a type accepts everything.
fn fits(value: &DeValue<'_>, schema: &Tree) -> bool {
    match type_of(schema) {
        Some("number") => matches!(value, DeValue::Integer(_) | DeValue::Float(_)),
        Some("integer") => matches!(value, DeValue::Integer(_)),
        Some("string") => matches!(value, DeValue::String(_)),
        Some("boolean") => matches!(value, DeValue::Boolean(_)),
        Some("array") => matches!(value, DeValue::Array(_)),
        Some("object") => matches!(value, DeValue::Table(_)),
        _ => true,
    }
}
