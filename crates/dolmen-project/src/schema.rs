//! The JSON schema of a project file, from the types that read it.

use super::file::{FileRaw, KindRaw};
use super::wrong::korean;
use dolmen_words::Language;
use schemars::generate::SchemaSettings;
use serde_json::{Map, Value, json};

/// The JSON schema of project files (draft 2020-12), for editors, its descriptions in a language.
///
/// # Example
/// ```
/// use dolmen_project::json_schema;
/// use dolmen_words::Language;
/// let [schema, korean] = [Language::English, Language::Korean].map(json_schema);
/// assert_eq!(schema["properties"]["schema"]["const"], 1);
/// let of_links = |schema: &serde_json::Value| schema["properties"]["links"]["description"].to_string();
/// assert!(of_links(&schema).contains("lowest first"));
/// assert!(of_links(&korean).contains("아래"));
/// ```
pub fn json_schema(language: Language) -> Value {
    let mut schema = complete();
    if language == Language::Korean {
        described(&mut schema, &mut korean);
    }
    schema
}

/// Replaces descriptions by other words, where there are any.
fn described(schema: &mut Value, words: &mut impl FnMut(&str) -> Option<&'static str>) {
    match schema {
        Value::Object(object) => {
            for (key, value) in object {
                match value {
                    Value::String(text) if key == "description" => {
                        if let Some(other) = words(text) {
                            *text = other.to_owned();
                        }
                    }
                    value => described(value, words),
                }
            }
        }
        Value::Array(list) => list.iter_mut().for_each(|value| described(value, words)),
        _ => {}
    }
}

/// All descriptions of the schema.
#[cfg(test)]
pub(super) fn descriptions() -> std::collections::BTreeSet<String> {
    let mut seen = std::collections::BTreeSet::new();
    described(&mut complete(), &mut |text| {
        seen.insert(text.to_owned());
        None
    });
    seen
}

fn complete() -> Value {
    let mut schema = of_file();
    if let Some(object) = schema.as_object_mut() {
        let needs = |kind: &str, key: &str| {
            json!({
                "if": { "properties": { "kind": { "const": kind } }, "required": ["kind"] },
                "then": { "required": [key] },
            })
        };
        let all: Vec<Value> = KEYS_OF_KIND
            .iter()
            .map(|(kind, keys)| match *kind {
                "stack" => blocks_or_made(),
                kind => needs(kind, keys[0]),
            })
            .collect();
        object.insert("allOf".to_owned(), Value::Array(all));
        let properties = object.get_mut("properties").and_then(Value::as_object_mut);
        for list in properties
            .into_iter()
            .flat_map(|all| all.iter_mut())
            .filter(|(key, _)| LISTS_IN_TABLES.contains(&key.as_str()))
        {
            or_of_file(list.1, &["file", "sheet"]);
        }
    }
    if let Some(modes) = schema.pointer_mut("/$defs/SurveyRaw/properties/modes") {
        or_of_file(modes, &["file", "sheet", "length"]);
    }
    schema
}

/// The given schema, or a table that names a file.
fn or_of_file(given: &mut Value, keys: &[&str]) {
    let properties: serde_json::Map<String, Value> = keys
        .iter()
        .map(|key| ((*key).to_owned(), json!({ "type": "string" })))
        .collect();
    let table = json!({ "type": "object", "properties": properties, "required": ["file"], "additionalProperties": false });
    let inner = std::mem::take(given);
    let description = inner.get("description").cloned().unwrap_or_default();
    *given = json!({ "description": description, "anyOf": [inner, table] });
}

/// A stack has blocks, or a generator of blocks.
fn blocks_or_made() -> Value {
    json!({
        "if": { "properties": { "kind": { "const": "stack" } }, "required": ["kind"] },
        "then": { "oneOf": [{ "required": ["blocks"] }, { "required": ["pagoda"] }, { "required": ["arch"] }, { "required": ["wall"] }, { "required": ["tower"] }, { "required": ["trilithon"] }, { "required": ["vault"] }, { "required": ["dome"] }] },
    })
}

/// Keys that belong to one kind only; the first is required there (for a stack: it or a generator of blocks).
pub(super) const KEYS_OF_KIND: &[(&str, &[&str])] = &[
    (
        "chain",
        &[
            "links",
            "joints",
            "cap",
            "damping_ratio",
            "stone",
            "soil",
            "side_supports",
            "as_surveyed",
        ],
    ),
    (
        "frame",
        &["storeys", "axial", "convention", "direction", "as_surveyed"],
    ),
    (
        "stack",
        &[
            "blocks",
            "pagoda",
            "arch",
            "wall",
            "tower",
            "trilithon",
            "vault",
            "dome",
            "loose",
            "density",
            "joint",
            "contacts",
            "ties",
            "side_supports",
            "soil",
            "support_movement",
            "as_surveyed",
        ],
    ),
    (
        "building",
        &[
            "floors",
            "p_delta",
            "accidental_eccentricity",
            "damping",
            "damper",
            "points",
        ],
    ),
];

/// Lists that may be in a table beside the file.
pub(super) const LISTS_IN_TABLES: [&str; 3] = ["blocks", "links", "storeys"];

pub(super) fn kind_word(kind: KindRaw) -> &'static str {
    match kind {
        KindRaw::Chain => "chain",
        KindRaw::Frame => "frame",
        KindRaw::Stack => "stack",
        KindRaw::Building => "building",
        KindRaw::Survey => "survey",
    }
}

/// The schema version of this Dolmen.
pub(super) const SCHEMA_VERSION: i64 = 1;

pub(super) fn of_file() -> Value {
    let settings = SchemaSettings::draft2020_12();
    let mut schema = settings
        .into_generator()
        .into_root_schema_for::<FileRaw>()
        .to_value();
    without_null(&mut schema);
    if let Some(properties) = schema["properties"].as_object_mut() {
        properties.insert("variant".to_owned(), variant());
        if let Some(version) = properties.get_mut("schema").and_then(Value::as_object_mut) {
            version.insert("const".to_owned(), json!(SCHEMA_VERSION));
        }
    }
    schema
}

fn variant() -> Value {
    json!({
        "description": "The structure with parts of the file replaced, by name: [variant.repaired]. Tables are merged, \
            lists replaced; links = { 2 = { centroid = 1.0 } } changes one element of a list.",
        "type": "object",
        "additionalProperties": {
            "type": "object",
            "properties": {
                "title": { "description": "A longer name: text, or { en = \"…\", ko = \"…\" }." },
            },
        },
    })
}

/// TOML has no null: an optional key is simply not required.
fn without_null(schema: &mut Value) {
    match schema {
        Value::Object(object) => {
            for key in ["anyOf", "oneOf"] {
                drop_null_branch(object, key);
            }
            if let Some(Value::Array(types)) = object.get_mut("type") {
                types.retain(|name| name != "null");
                if let [one] = types.as_slice() {
                    let one = one.clone();
                    object.insert("type".to_owned(), one);
                }
            }
            object.values_mut().for_each(without_null);
        }
        Value::Array(list) => list.iter_mut().for_each(without_null),
        _ => {}
    }
}

/// Leaves the null branch out; a single branch that remains takes the place of the choice.
fn drop_null_branch(object: &mut Map<String, Value>, key: &str) {
    let Some(Value::Array(branches)) = object.get_mut(key) else {
        return;
    };
    let before = branches.len();
    branches.retain(|branch| branch["type"] != "null");
    if branches.len() == before || branches.len() != 1 {
        return;
    }
    let Some(Value::Object(only)) = branches.pop() else {
        return;
    };
    object.remove(key);
    for (name, value) in only {
        object.entry(name).or_insert(value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_the_schema_names_every_key_and_no_null() {
        let schema = json_schema(Language::English);
        let text = schema.to_string();
        assert!(!text.contains("null"), "{text}");
        assert_eq!(schema["required"], json!(["schema", "kind", "name"]));
        assert_eq!(schema["additionalProperties"], json!(false));
        for key in [
            "links", "joints", "storeys", "survey", "variant", "units", "allow",
        ] {
            assert!(schema["properties"][key]["description"].is_string(), "{key}");
        }
    }
}
