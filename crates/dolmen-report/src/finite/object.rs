//! A JSON object that says which of its numbers are not finite.

use super::search::{NotFinite, Step, not_finite_in};
use serde::Serialize;
use serde_json::{Map, Value};

/// The key of the numbers of an object that are not finite, by name.
const NOT_FINITE: &str = "not_finite";

/// Builds a JSON value as `serde_json::json!` does; the object around a number that is not finite says so under `not_finite`.
#[macro_export]
macro_rules! as_json {
    ({ $($fields:tt)* }) => {{
        #[allow(unused_mut, reason = "an object may have no fields")]
        let mut object = $crate::JsonObject::default();
        $crate::as_json!(@fields object $($fields)*);
        object.done()
    }};
    (@fields $object:ident) => {};
    (@fields $object:ident $key:literal : null $(, $($rest:tt)*)?) => {
        $object.put($key, &());
        $crate::as_json!(@fields $object $($($rest)*)?);
    };
    (@fields $object:ident $key:literal : [] $(, $($rest:tt)*)?) => {
        $object.put($key, &[(); 0]);
        $crate::as_json!(@fields $object $($($rest)*)?);
    };
    (@fields $object:ident $key:literal : { $($inner:tt)* } $(, $($rest:tt)*)?) => {
        $object.put($key, &$crate::as_json!({ $($inner)* }));
        $crate::as_json!(@fields $object $($($rest)*)?);
    };
    (@fields $object:ident $key:literal : $value:expr $(, $($rest:tt)*)?) => {
        $object.put($key, &$value);
        $crate::as_json!(@fields $object $($($rest)*)?);
    };
    ($value:expr) => {
        $crate::json_value(&$value)
    };
}

/// The fields of an object, with the names of those that are not finite.
#[derive(Debug, Default)]
pub struct JsonObject {
    fields: Map<String, Value>,
    not_finite: Map<String, Value>,
}

impl JsonObject {
    /// Adds a field.
    pub fn put<T: Serialize + ?Sized>(&mut self, key: &str, value: &T) {
        let (value, loose) = marked(value);
        let named = loose
            .into_iter()
            .map(|(place, word)| (format!("{key}{place}"), word));
        self.not_finite.extend(named);
        self.fields.insert(key.to_owned(), value);
    }

    /// Adds the fields of another object.
    pub(crate) fn append(&mut self, other: Value) {
        let Value::Object(mut fields) = other else {
            return;
        };
        if let Some(Value::Object(named)) = fields.remove(NOT_FINITE) {
            self.not_finite.extend(named);
        }
        self.fields.extend(fields);
    }

    /// The object.
    pub fn done(mut self) -> Value {
        if !self.not_finite.is_empty() {
            self.fields.insert(NOT_FINITE.to_owned(), self.not_finite.into());
        }
        Value::Object(self.fields)
    }
}

impl<K: AsRef<str>, T: Serialize> FromIterator<(K, T)> for JsonObject {
    fn from_iter<I: IntoIterator<Item = (K, T)>>(fields: I) -> Self {
        let mut object = JsonObject::default();
        for (key, value) in fields {
            object.put(key.as_ref(), &value);
        }
        object
    }
}

/// A value as JSON. A bare number or list that is not finite becomes an object, which can name it.
pub fn json_value<T: Serialize + ?Sized>(value: &T) -> Value {
    let (value, loose) = marked(value);
    if loose.is_empty() {
        return value;
    }
    let mut object = JsonObject::default();
    object.fields.insert("value".to_owned(), value);
    let named = loose
        .into_iter()
        .map(|(place, word)| (format!("value{place}"), word));
    object.not_finite.extend(named);
    object.done()
}

/// The value, whose objects say what is not finite, and the places of such numbers outside every object: "", "[3]".
fn marked<T: Serialize + ?Sized>(value: &T) -> (Value, Vec<(String, Value)>) {
    // a value without a form in JSON shows the reason
    let mut made = serde_json::to_value(value).unwrap_or_else(|why| Value::String(why.to_string()));
    let found = not_finite_in(value);
    let loose = found.iter().filter_map(|one| marked_at(&mut made, one)).collect();
    (made, loose)
}

/// Names the number in the object nearest to it; its place if there is none.
fn marked_at(value: &mut Value, found: &NotFinite) -> Option<(String, Value)> {
    let word = Value::from(found.word());
    let key_at = found.path.iter().rposition(|step| matches!(step, Step::Key(_)));
    let (above, own) = found.path.split_at(key_at.unwrap_or(0));
    let name: String = own.iter().map(ToString::to_string).collect();
    let object = above.iter().try_fold(value, |value, step| match step {
        Step::Key(key) => value.get_mut(key.as_str()),
        Step::At(index) => value.get_mut(*index),
    });
    match (key_at, object) {
        (Some(_), Some(Value::Object(fields))) => {
            let named = fields.entry(NOT_FINITE).or_insert_with(|| Map::new().into());
            named[name] = word;
            None
        }
        _ => Some((name, word)),
    }
}

#[cfg(test)]
mod tests {
    use super::json_value;
    use serde::Serialize;
    use serde_json::Value;
    use std::collections::BTreeMap;

    #[derive(Serialize)]
    struct Mode {
        frequency_hz: f64,
        damping: Option<f64>,
        shape: Vec<f64>,
    }

    fn mode(frequency_hz: f64, end: f64) -> Mode {
        Mode {
            frequency_hz,
            damping: None,
            shape: vec![1.0, end],
        }
    }

    #[test]
    fn exact_what_is_finite_is_as_serde_json_has_it() {
        let modes = [mode(2.0, 0.5), mode(3.5, -1.0)];
        let ours = crate::as_json!({
            "modes": modes, "none": null, "inner": { "pair": [1.0, 2.0], "empty": {}, "list": [] }, "word": "a",
            "picked": match modes.len() { 2 => Some(0.1_f32), _ => None },
        });
        let theirs = serde_json::json!({
            "modes": modes, "none": null, "inner": { "pair": [1.0, 2.0], "empty": {}, "list": [] }, "word": "a",
            "picked": match modes.len() { 2 => Some(0.1_f32), _ => None },
        });
        assert_eq!(ours, theirs);
    }

    #[test]
    fn holds_a_number_that_is_not_finite_is_named_by_the_object_around_it() {
        let modes = [mode(2.0, 0.5), mode(f64::NAN, f64::NEG_INFINITY)];
        let by_name = BTreeMap::from([("low", f64::INFINITY), ("high", 1.0)]);
        let made = crate::as_json!({
            "modes": modes, "share": f32::NAN, "absent": None::<f64>, "by_name": by_name,
            "inner": { "pair": [1.0, f64::NAN] }, "rows": [[0.0], [f64::NAN]],
        });
        assert_eq!(
            made["not_finite"],
            serde_json::json!({ "share": "not_a_number", "rows[1][0]": "not_a_number" })
        );
        assert_eq!(made["share"], Value::Null);
        assert_eq!(made["modes"][0].get("not_finite"), None);
        let names = serde_json::json!({ "frequency_hz": "not_a_number", "shape[1]": "minus_infinite" });
        assert_eq!(made["modes"][1]["not_finite"], names);
        assert_eq!(made["modes"][1]["shape"], serde_json::json!([1.0, null]));
        assert_eq!(
            made["by_name"]["not_finite"],
            serde_json::json!({ "low": "infinite" })
        );
        assert_eq!(
            made["inner"]["not_finite"],
            serde_json::json!({ "pair[1]": "not_a_number" })
        );
    }

    #[test]
    fn holds_a_bare_number_that_is_not_finite_is_no_null() {
        assert_eq!(
            json_value(&f64::NAN)["not_finite"],
            serde_json::json!({ "value": "not_a_number" })
        );
        assert_eq!(json_value(&1.5), serde_json::json!(1.5));
        assert_eq!(json_value(&None::<f64>), Value::Null);
    }
}
