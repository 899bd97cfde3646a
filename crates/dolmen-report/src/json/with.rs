//! Adds derived fields to those of a result.

use serde::Serialize;
use serde_json::Value;

/// The fields of `of`, then those of `more`, which must be an object.
pub(super) fn with<T: Serialize>(of: &T, more: Value) -> Value {
    let mut value = serde_json::json!(of);
    if let (Some(fields), Value::Object(more)) = (value.as_object_mut(), more) {
        fields.extend(more);
    }
    value
}
