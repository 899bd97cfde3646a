//! The forms of a force: horizontal, or in three components.

use crate::file_number::{At, NumberRaw, QuantityRaw, QuantityTable};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserialize, Deserializer, MapAccess, SeqAccess, Visitor, value::MapAccessDeserializer};
use std::borrow::Cow;
use std::fmt;

/// A force.
#[derive(Debug)]
pub(super) enum ForceRaw {
    /// From the side.
    Along(QuantityRaw),
    /// Along x, y and upwards.
    Components(Vec<At<QuantityRaw>>),
}

struct ForceVisitor;

impl<'de> Visitor<'de> for ForceVisitor {
    type Value = ForceRaw;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a force, or [x, y, z]")
    }

    fn visit_i64<E>(self, number: i64) -> Result<ForceRaw, E> {
        Ok(ForceRaw::Along(QuantityRaw::Plain(NumberRaw::Number(
            number as f64,
        ))))
    }

    fn visit_f64<E>(self, number: f64) -> Result<ForceRaw, E> {
        Ok(ForceRaw::Along(QuantityRaw::Plain(NumberRaw::Number(number))))
    }

    fn visit_str<E>(self, text: &str) -> Result<ForceRaw, E> {
        Ok(ForceRaw::Along(QuantityRaw::Plain(NumberRaw::Text(
            text.to_owned(),
        ))))
    }

    fn visit_map<M: MapAccess<'de>>(self, map: M) -> Result<ForceRaw, M::Error> {
        let table = QuantityTable::deserialize(MapAccessDeserializer::new(map))?;
        Ok(ForceRaw::Along(QuantityRaw::Table(Box::new(table))))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<ForceRaw, A::Error> {
        let mut all = Vec::new();
        while let Some(one) = list.next_element()? {
            all.push(one);
        }
        Ok(ForceRaw::Components(all))
    }
}

impl<'de> Deserialize<'de> for ForceRaw {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ForceVisitor)
    }
}

impl JsonSchema for ForceRaw {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Force".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let table = generator.subschema_for::<QuantityTable>();
        let items = generator.subschema_for::<QuantityRaw>();
        json_schema!({
            "anyOf": [{ "type": "number" }, { "type": "string" }, table, { "type": "array", "items": items }],
            "x-must-be":
                "a number, text with its unit (\"0.4 kN\"), a table { value = …, cov = …, source = … }, or of a stack [x, y, z]",
        })
    }
}
