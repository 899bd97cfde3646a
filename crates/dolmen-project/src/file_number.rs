//! The forms of a number: bare, as text with a unit, or as a table with its scatter and source.

use super::sought::Sought;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserialize, Deserializer, MapAccess, Visitor, value::MapAccessDeserializer};
use std::borrow::Cow;
use std::fmt;
use std::ops::Range;

/// A value and its place in the text.
#[derive(Clone, Debug)]
pub(super) struct At<T> {
    pub(super) span: Range<usize>,
    pub(super) value: T,
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for At<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let spanned = toml::Spanned::<T>::deserialize(deserializer)?;
        Ok(At {
            span: spanned.span(),
            value: spanned.into_inner(),
        })
    }
}

impl<T: JsonSchema> JsonSchema for At<T> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        T::schema_name()
    }

    // Not that of T: schemars would take T inside At<T> for a recursion.
    fn schema_id() -> Cow<'static, str> {
        format!("At<{}>", T::schema_id()).into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        generator.subschema_for::<T>()
    }
}

/// Where a number comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum EvidenceRaw {
    /// Measured on this structure.
    Measured,
    /// A test on material or joints of this kind.
    Test,
    /// Published.
    Literature,
    /// Follows from a survey of this structure: `dolmen identify --write`.
    Identified,
    /// Nobody has measured it.
    Assumed,
}

/// A number, or text with a unit.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum NumberRaw {
    Number(f64),
    Text(String),
}

/// A quantity: a bare number, text with a unit, or a table.
#[derive(Debug)]
pub(super) enum QuantityRaw {
    Plain(NumberRaw),
    Table(Box<QuantityTable>),
}

/// A number with what is known of it.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct QuantityTable {
    /// The number, bare or as text with its unit.
    #[schemars(required)]
    pub(super) value: Option<At<NumberRaw>>,
    /// Unit of a bare value.
    pub(super) unit: Option<At<String>>,
    /// Coefficient of variation, standard deviation / mean, 0 to 1.
    pub(super) cov: Option<At<f64>>,
    /// Standard deviation instead of cov, in the unit of value.
    pub(super) sd: Option<At<f64>>,
    /// Where it comes from.
    pub(super) source: Option<EvidenceRaw>,
    /// source = "identified": the survey that it follows from.
    pub(super) survey: Option<At<String>>,
    /// Where cov or sd comes from, if not from the same source.
    pub(super) cov_source: Option<EvidenceRaw>,
    /// Anything to add.
    pub(super) note: Option<String>,
}

struct NumberVisitor;

impl Visitor<'_> for NumberVisitor {
    type Value = NumberRaw;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number or text with a unit")
    }

    fn visit_i64<E>(self, number: i64) -> Result<NumberRaw, E> {
        Ok(NumberRaw::Number(number as f64))
    }

    fn visit_f64<E>(self, number: f64) -> Result<NumberRaw, E> {
        Ok(NumberRaw::Number(number))
    }

    fn visit_str<E>(self, text: &str) -> Result<NumberRaw, E> {
        Ok(NumberRaw::Text(text.to_owned()))
    }
}

impl<'de> Deserialize<'de> for NumberRaw {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(NumberVisitor)
    }
}

impl JsonSchema for NumberRaw {
    fn schema_name() -> Cow<'static, str> {
        "Number".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "anyOf": [{ "type": "number" }, { "type": "string" }],
            "x-must-be": "a number, or text with its unit (\"38.95 kN\")",
        })
    }
}

struct QuantityVisitor;

impl<'de> Visitor<'de> for QuantityVisitor {
    type Value = QuantityRaw;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, text with a unit, or a table with value")
    }

    fn visit_i64<E>(self, number: i64) -> Result<QuantityRaw, E> {
        Ok(QuantityRaw::Plain(NumberRaw::Number(number as f64)))
    }

    fn visit_f64<E>(self, number: f64) -> Result<QuantityRaw, E> {
        Ok(QuantityRaw::Plain(NumberRaw::Number(number)))
    }

    fn visit_str<E>(self, text: &str) -> Result<QuantityRaw, E> {
        Ok(QuantityRaw::Plain(NumberRaw::Text(text.to_owned())))
    }

    fn visit_map<M: MapAccess<'de>>(self, map: M) -> Result<QuantityRaw, M::Error> {
        let table = QuantityTable::deserialize(MapAccessDeserializer::new(map))?;
        Ok(QuantityRaw::Table(Box::new(table)))
    }
}

impl<'de> Deserialize<'de> for QuantityRaw {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(QuantityVisitor)
    }
}

impl JsonSchema for QuantityRaw {
    fn schema_name() -> Cow<'static, str> {
        "Quantity".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let table = generator.subschema_for::<QuantityTable>();
        json_schema!({
            "anyOf": [{ "type": "number" }, { "type": "string" }, table],
            "x-must-be":
                "a number, text with its unit (\"38.95 kN\"), or a table { value = …, cov = …, source = … }",
        })
    }
}

/// A list, "unknown", or "identified": from the modes of a survey.
#[derive(Debug)]
pub(super) enum OrUnknown<T> {
    Unknown,
    Identified(Option<At<String>>),
    Known(Vec<At<T>>),
}

/// Stiffness from the modes of one survey.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct FromSurveyRaw {
    /// "identified".
    #[schemars(required)]
    #[allow(dead_code, reason = "its one word is all that it can be")]
    source: Option<IdentifiedRaw>,
    /// The survey; the latest that has records or frequencies without it.
    survey: Option<At<String>>,
}

#[derive(Clone, Copy, Debug, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum IdentifiedRaw {
    /// From the modes of a survey.
    Identified,
}

/// The survey that what is written is left to; `None` where it is not.
pub(super) fn sought<T>(raw: Option<&At<OrUnknown<T>>>) -> Option<Sought> {
    match &raw?.value {
        OrUnknown::Identified(survey) => Some(Sought {
            survey: survey.as_ref().map(|survey| survey.value.clone()),
        }),
        OrUnknown::Unknown | OrUnknown::Known(_) => None,
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for OrUnknown<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct ListVisitor<T>(std::marker::PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for ListVisitor<T> {
            type Value = OrUnknown<T>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a list, \"unknown\" or \"identified\"")
            }

            fn visit_str<E: serde::de::Error>(self, word: &str) -> Result<OrUnknown<T>, E> {
                match word {
                    "identified" => Ok(OrUnknown::Identified(None)),
                    "unknown" => Ok(OrUnknown::Unknown),
                    _ => Err(E::invalid_value(serde::de::Unexpected::Str(word), &self)),
                }
            }

            fn visit_map<M: MapAccess<'de>>(self, map: M) -> Result<OrUnknown<T>, M::Error> {
                let table = FromSurveyRaw::deserialize(MapAccessDeserializer::new(map))?;
                Ok(OrUnknown::Identified(table.survey))
            }

            fn visit_seq<A: serde::de::SeqAccess<'de>>(self, mut list: A) -> Result<OrUnknown<T>, A::Error> {
                let mut all = Vec::new();
                while let Some(one) = list.next_element()? {
                    all.push(one);
                }
                Ok(OrUnknown::Known(all))
            }
        }
        deserializer.deserialize_any(ListVisitor(std::marker::PhantomData))
    }
}

impl<T: JsonSchema> JsonSchema for OrUnknown<T> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        format!("{}OrUnknown", T::schema_name()).into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let items = generator.subschema_for::<T>();
        let table = generator.subschema_for::<FromSurveyRaw>();
        json_schema!({
            "anyOf": [
                { "const": "unknown" },
                { "const": "identified" },
                { "type": "array", "items": items },
                table,
            ],
            "x-must-be":
                "a list, lowest first, \"unknown\", \"identified\" or { source = \"identified\", survey = … }",
        })
    }
}
