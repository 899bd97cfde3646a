//! A result's own fields with a few that follow from them.

use serde::Serialize;
use serde_json::Value;

/// The fields of `of`, then those of `more`; nothing is lost where `more` is no object.
pub(super) fn with<T: Serialize>(of: &T, more: Value) -> Value {
    let mut value = serde_json::json!(of);
    if let (Some(fields), Value::Object(more)) = (value.as_object_mut(), more) {
        fields.extend(more);
    }
    value
}
