//! Adds derived fields to those of a result.

use crate::finite::{JsonObject, json_value};
use serde::Serialize;
use serde_json::Value;

/// The fields of `of`, then those of `more`, which must be an object.
pub(super) fn with<T: Serialize>(of: &T, more: Value) -> Value {
    let mut all = JsonObject::default();
    all.append(json_value(of));
    all.append(more);
    all.done()
}
