//! Names as they are written.

use schemars::JsonSchema;

#[derive(Clone, Debug, Default, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct NamesTable {
    /// English.
    pub(super) en: Option<String>,
    /// Korean.
    pub(super) ko: Option<String>,
}

/// A name in one or two languages.
#[derive(Clone, Debug, serde::Deserialize, JsonSchema)]
#[serde(untagged)]
pub(super) enum NamesRaw {
    One(String),
    Table(NamesTable),
}
