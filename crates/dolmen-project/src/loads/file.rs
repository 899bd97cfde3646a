//! The keys of wind, static loads and combinations.

use super::file_force::ForceRaw;
use crate::file_number::{At, NumberRaw, QuantityRaw};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserialize, Deserializer, MapAccess, Visitor, value::MapAccessDeserializer};
use std::borrow::Cow;
use std::fmt;

/// What a speed or pressure of wind is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
pub(super) enum MeansRaw {
    /// The gust itself, over some three seconds.
    #[serde(rename = "gust")]
    Gust,
    /// The mean of ten minutes, from which a code makes the gust.
    #[serde(rename = "10 min")]
    TenMinutes,
}

/// By which code a mean wind becomes a pressure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
pub(super) enum WindCodeRaw {
    /// Eurocode 1.
    #[serde(rename = "EN 1991-1-4")]
    Eurocode,
    /// Korea.
    #[serde(rename = "KDS 41 12 00")]
    Kds41,
}

/// Terrain of EN 1991-1-4 (0 to IV), exposure of KDS 41 12 00 (A to D).
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
pub(super) enum TerrainRaw {
    /// EN: sea.
    #[serde(rename = "0")]
    Zero,
    /// EN: flat land without obstacles.
    I,
    /// EN: grass, isolated obstacles.
    #[serde(rename = "II")]
    Ii,
    /// EN: villages, suburbs, forest.
    #[serde(rename = "III")]
    Iii,
    /// EN: towns.
    #[serde(rename = "IV")]
    Iv,
    /// KDS: centre of a large town.
    A,
    /// KDS: town, suburb, forest.
    B,
    /// KDS: open country.
    C,
    /// KDS: open sea, coast.
    D,
}

/// How the power of gusts is spread over frequency.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
pub(super) enum SpectrumRaw {
    /// That of EN 1991-1-4, Annex B.
    #[serde(rename = "kaimal")]
    Kaimal,
    /// Von Kármán.
    #[serde(rename = "von karman")]
    VonKarman,
}

/// An area that the wind meets.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct WindAreaRaw {
    /// The part, by its name or as "links[2]", "storeys[1]".
    #[schemars(required)]
    pub(super) part: Option<At<String>>,
    /// Area across the wind, m2 where it is a bare number. Without height it takes the place of the part's own area, spread along it.
    #[schemars(required)]
    pub(super) area: Option<At<QuantityRaw>>,
    /// Height of its middle above the ground: an area more, such as a banner or a sign.
    pub(super) height: Option<At<QuantityRaw>>,
    /// Its force coefficient; that of the wind if not given.
    pub(super) force_coefficient: Option<At<QuantityRaw>>,
    /// Of a frame: the direction along which the wind blows that it meets; every direction if not given.
    pub(super) direction: Option<At<String>>,
}

/// Wind, of the gust that is given or by a code.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct WindRaw {
    /// Speed, m/s where it is a bare number; or pressure.
    pub(super) speed: Option<At<QuantityRaw>>,
    /// Peak velocity pressure of a gust; or speed.
    pub(super) pressure: Option<At<QuantityRaw>>,
    /// What the speed or pressure is: "gust", or "10 min" for the mean that a code takes.
    pub(super) means: Option<At<MeansRaw>>,
    /// With means = "10 min": the code that makes the pressure of it.
    pub(super) code: Option<At<WindCodeRaw>>,
    /// With a code: its terrain ("0", "I", "II", "III", "IV") or exposure ("A", "B", "C", "D").
    pub(super) terrain: Option<At<TerrainRaw>>,
    /// With a code: factor on the speed for hills, c_o or K_zt, at least 1; 1 if not given.
    pub(super) topography: Option<At<f64>>,
    /// KDS 41 12 00: importance factor I_w; 1 if not given.
    pub(super) importance_factor: Option<At<f64>>,
    /// Density of air; 1.25 kg/m3, with KDS 41 12 00 1.225, if not given.
    pub(super) density: Option<At<QuantityRaw>>,
    /// Force coefficient of the parts: square prism 2.0, octagon 1.3 to 1.45, circle 0.7 to 1.2.
    #[schemars(required)]
    pub(super) force_coefficient: Option<At<QuantityRaw>>,
    /// Areas other than those of the parts' own widths.
    pub(super) areas: Option<Vec<At<WindAreaRaw>>>,
    /// Of a building: "kaimal" or "von karman"; that of the code if not given.
    pub(super) spectrum: Option<At<SpectrumRaw>>,
    /// Of a building: how far off the middle of the breadth the wind acts, over the breadth, either side; 0.15 if not given.
    pub(super) eccentricity: Option<At<f64>>,
    /// Of a building: largest peak acceleration that is allowed on the top floor.
    pub(super) acceleration_limit: Option<At<QuantityRaw>>,
    /// Of a building: largest drift of a storey that is allowed, over its height, "0.25 %" or "1/400".
    pub(super) drift_limit: Option<At<NumberRaw>>,
    /// Where it comes from.
    pub(super) source: Option<String>,
}

/// Wind, or that the structure stands out of it.
#[derive(Debug)]
pub(crate) enum WindOrShelteredRaw {
    Sheltered,
    Wind(Box<WindRaw>),
}

struct WindVisitor;

impl<'de> Visitor<'de> for WindVisitor {
    type Value = WindOrShelteredRaw;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a table, or \"sheltered\"")
    }

    fn visit_str<E>(self, _: &str) -> Result<WindOrShelteredRaw, E> {
        Ok(WindOrShelteredRaw::Sheltered)
    }

    fn visit_map<M: MapAccess<'de>>(self, map: M) -> Result<WindOrShelteredRaw, M::Error> {
        let table = WindRaw::deserialize(MapAccessDeserializer::new(map))?;
        Ok(WindOrShelteredRaw::Wind(Box::new(table)))
    }
}

impl<'de> Deserialize<'de> for WindOrShelteredRaw {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(WindVisitor)
    }
}

impl JsonSchema for WindOrShelteredRaw {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "WindOrSheltered".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let table = generator.subschema_for::<WindRaw>();
        json_schema!({
            "anyOf": [{ "const": "sheltered" }, table],
            "x-must-be": "a table { speed = …, means = \"gust\", force_coefficient = … }, or \"sheltered\"",
        })
    }
}

/// A static load beside the weight of the parts.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct LoadRaw {
    /// What it is.
    #[schemars(required)]
    pub(super) name: Option<At<String>>,
    /// The part that it acts on, by its name or as "links[2]", "storeys[1]".
    #[schemars(required)]
    pub(super) at: Option<At<String>>,
    /// Height above the ground at which it acts; the top of the part if not given.
    pub(super) height: Option<At<QuantityRaw>>,
    /// The point at which it acts. Of a stack [x, y, z], z up from the ground; the middle of the stone at height if not given. Of a building [x, y] in plan; the centre of mass of the floor if not given.
    pub(super) position: Option<At<Vec<At<QuantityRaw>>>>,
    /// Force from the side; its sign is a direction. Of a chain of two directions [x, y], along and across; of a frame of several directions and of a building [x, y]; of a stack [x, y, z], z upwards.
    pub(super) force: Option<At<ForceRaw>>,
    /// Weight that it adds.
    pub(super) weight: Option<At<QuantityRaw>>,
    /// Overturning moment, in the direction of force.
    pub(super) moment: Option<At<QuantityRaw>>,
    /// Of a building: torque about the vertical, from x towards y.
    pub(super) torque: Option<At<QuantityRaw>>,
}

/// Factors of a combination of loads: [combination.NAME].
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct CombinationRaw {
    /// On the weight of the structure; 1 if not given.
    pub(super) weight: Option<At<f64>>,
    /// On the wind; 0 if not given.
    pub(super) wind: Option<At<f64>>,
    /// On the static loads; 0 if not given.
    pub(super) loads: Option<At<f64>>,
    /// Of a building: on its drifts under the spectrum of the site; 0 if not given.
    pub(super) earthquake: Option<At<f64>>,
}
