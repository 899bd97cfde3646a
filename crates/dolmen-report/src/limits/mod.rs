//! Parts of a structure compared with their limits: findings, tables, JSON.

mod findings;
mod json;
mod table;
mod words;

pub(crate) use findings::findings;
pub(crate) use json::parts_json;
pub(crate) use table::section;
pub(crate) use words::part_words;

use dolmen_words::Template;

/// Templates of the sentences on limits.
pub(crate) const TEMPLATES: [&[Template]; 3] = [
    words::Parts::TEMPLATES,
    findings::Found::TEMPLATES,
    table::Limits::TEMPLATES,
];
