//! Translates the schema from SQLite to PostgreSQL: only the types of columns differ.

use crate::schema_files::FILES;
use std::borrow::Cow;

/// Schema of the database for our tables, apart from those of other programs.
pub(crate) const SCHEMA: &str = "dolmen";
/// Schema files for servers only.
const OWN: &str = include_str!("../sql/0001_server.sql");

/// A column type of SQLite and its equivalent. Texts are compared byte by byte in any language of the database, so that lists, keys and hashes
/// equal those of a file.
const TYPES: [(&str, &str); 3] = [
    ("integer", "bigint"),
    ("real", "double precision"),
    ("text", "text collate \"C\""),
];

/// The files of the schema.
pub(crate) fn files() -> Vec<Cow<'static, str>> {
    let mut files: Vec<String> = FILES.iter().map(|file| translated(file)).collect();
    if let Some(first) = files.first_mut() {
        first.insert_str(0, OWN);
    }
    files.into_iter().map(Cow::Owned).collect()
}

/// A schema file with the types of PostgreSQL.
fn translated(file: &str) -> String {
    let lines = file.split_inclusive('\n').map(|line| {
        let is_column = line.starts_with("    ") || line.starts_with("alter table ");
        let comment = line.find("--").unwrap_or(line.len());
        match is_column {
            true => column(&line[..comment]) + &line[comment..],
            false => line.to_owned(),
        }
    });
    lines.collect()
}

/// The definition of a column: the first word behind its name is its type.
fn column(line: &str) -> String {
    let named = match line.split_once(" column ") {
        Some((before, named)) => (before.len() + " column ".len(), named),
        None => (line.len() - line.trim_start().len(), line.trim_start()),
    };
    let (from, text) = named;
    let Some(space) = text.find(' ') else {
        return line.to_owned();
    };
    let (kind, rest) = text[space + 1..].split_at(
        text[space + 1..]
            .find(|sign: char| !sign.is_ascii_alphabetic())
            .unwrap_or(text.len() - space - 1),
    );
    match TYPES.iter().find(|(of, _)| *of == kind) {
        Some((_, other)) => format!("{}{} {other}{rest}", &line[..from], &text[..space]),
        None => line.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_types_of_columns_and_nothing_else_is_changed() {
        let file = "create table a ( -- a text real\n    text text not null,\n    real integer primary key check (real = 1), -- integer real\n    \
                    x real,\n    y text\n);\nalter table a add column is_it integer not null default 0;\ncreate index text on a (text, real);\n";
        let other = "create table a ( -- a text real\n    text text collate \"C\" not null,\n    real bigint primary key check (real = 1), -- integer real\n    \
                     x double precision,\n    y text collate \"C\"\n);\nalter table a add column is_it bigint not null default 0;\ncreate index text on a (text, real);\n";
        assert_eq!(translated(file), other);
    }
}
