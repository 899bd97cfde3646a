//! Names as they are written.

use super::file_number::At;
use schemars::JsonSchema;
use std::collections::BTreeMap;

#[derive(Clone, Debug, Default, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct NamesTable {
    /// English.
    pub(super) en: Option<String>,
    /// Korean.
    pub(super) ko: Option<String>,
}

/// Names as they are printed in another language than that of the file: [names.ko] with "body 1" = "1층 탑신".
#[derive(Debug, Default, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct PrintedNamesRaw {
    /// English names of parts, surveys and motions, by their names in the file.
    pub(super) en: Option<BTreeMap<String, At<String>>>,
    /// Korean names of parts, surveys and motions, by their names in the file.
    pub(super) ko: Option<BTreeMap<String, At<String>>>,
}

/// A name in one or two languages.
#[derive(Clone, Debug, serde::Deserialize, JsonSchema)]
#[serde(untagged)]
pub(super) enum NamesRaw {
    One(String),
    Table(NamesTable),
}
