//! The JSON schema as data of the program, because building it from the types took four million instructions at every start.
//!
//! A file without a fault by this tree is read at once. A file with a fault is checked again with the schema of the types, so that an
//! outdated tree costs only time.

use super::schema::of_file;
use serde_json::Value;
use std::sync::LazyLock;

/// A JSON value as a constant of the program.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Tree {
    /// Null and numbers, which no check needs.
    Other,
    Bool(bool),
    Text(&'static str),
    List(&'static [Tree]),
    Table(&'static [(&'static str, Tree)]),
}

impl Tree {
    pub(super) fn get(&self, key: &str) -> Option<&Tree> {
        let found = self.entries()?.iter().find(|(name, _)| *name == key);
        found.map(|(_, value)| value)
    }

    pub(super) fn text(&self) -> Option<&'static str> {
        match self {
            Tree::Text(text) => Some(text),
            _ => None,
        }
    }

    pub(super) fn list(&self) -> Option<&'static [Tree]> {
        match self {
            Tree::List(list) => Some(list),
            _ => None,
        }
    }

    pub(super) fn entries(&self) -> Option<&'static [(&'static str, Tree)]> {
        match self {
            Tree::Table(entries) => Some(entries),
            _ => None,
        }
    }

    /// The schema that this tree refers to; itself without a reference.
    pub(super) fn resolved(&'static self, schema: &'static Tree) -> &'static Tree {
        let reference = schema.get("$ref").and_then(Tree::text);
        let name = reference.and_then(|reference| reference.strip_prefix("#/$defs/"));
        let definition = name.and_then(|name| self.get("$defs")?.get(name));
        definition.unwrap_or(schema)
    }

    /// Lives as long as the program: it is built once.
    fn of(value: &Value) -> Tree {
        match value {
            Value::Bool(value) => Tree::Bool(*value),
            Value::String(text) => Tree::Text(Box::leak(text.clone().into_boxed_str())),
            Value::Array(list) => Tree::List(Box::leak(list.iter().map(Tree::of).collect())),
            Value::Object(entries) => {
                let each = entries.iter().map(|(name, value)| {
                    let name: &'static str = Box::leak(name.clone().into_boxed_str());
                    (name, Tree::of(value))
                });
                Tree::Table(Box::leak(each.collect()))
            }
            Value::Null | Value::Number(_) => Tree::Other,
        }
    }
}

/// The schema at the time when `schema_tree.in` was written.
pub(super) static TREE: Tree = {
    use Tree::*;
    include!("schema_tree.in")
};

/// The schema of the types themselves.
pub(super) static BUILT: LazyLock<Tree> = LazyLock::new(|| Tree::of(&of_file()));

#[cfg(test)]
mod tests {
    use super::*;

    /// The Rust source of a tree.
    fn written(tree: &Tree) -> String {
        let joined = |parts: Vec<String>| parts.join(",\n");
        match tree {
            Tree::Other => "Other".to_owned(),
            Tree::Bool(value) => format!("Bool({value})"),
            Tree::Text(text) => format!("Text({text:?})"),
            Tree::List(list) => format!("List(&[{}])", joined(list.iter().map(written).collect())),
            Tree::Table(entries) => {
                let each = entries
                    .iter()
                    .map(|(name, value)| format!("({name:?}, {})", written(value)));
                format!("Table(&[{}])", joined(each.collect()))
            }
        }
    }

    #[test]
    fn holds_the_tree_in_the_program_is_that_of_the_types() {
        let now = written(&BUILT) + "\n";
        if std::env::var_os("DOLMEN_WRITE_SCHEMA").is_some() {
            let file = concat!(env!("CARGO_MANIFEST_DIR"), "/src/schema_tree.in");
            std::fs::write(file, &now).unwrap();
            return;
        }
        assert!(
            TREE == *BUILT,
            "keys of the project file have changed: run `DOLMEN_WRITE_SCHEMA=1 cargo test --release -p dolmen-project --lib schema_tree` \
             and commit schema_tree.in"
        );
    }

    #[test]
    fn holds_every_reference_resolves() {
        fn references(tree: &'static Tree, all: &mut Vec<&'static Tree>) {
            if tree.get("$ref").is_some() {
                all.push(tree);
            }
            for (_, value) in tree.entries().unwrap_or_default() {
                references(value, all);
            }
            for value in tree.list().unwrap_or_default() {
                references(value, all);
            }
        }
        for tree in [&TREE, &*BUILT] {
            let mut all = Vec::new();
            references(tree, &mut all);
            assert!(all.len() > 20, "{}", all.len());
            for reference in all {
                assert!(
                    !std::ptr::eq(tree.resolved(reference), reference),
                    "{reference:?}"
                );
            }
        }
    }
}
