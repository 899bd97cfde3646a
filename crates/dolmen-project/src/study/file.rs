//! Studies as they are written.

use crate::file_names::NamesRaw;
use crate::file_number::{At, NumberRaw};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserialize, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt;

/// A study: runs over a grid of inputs, samples, motions and sizes of the shaking.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct StudyRaw {
    /// A longer name: text, or { en = "…", ko = "…" }.
    pub(super) title: Option<NamesRaw>,
    /// Paths of the file with the values that each takes: { "pagoda.storeys" = [3, 5, 7], "joint.friction" = { from = 0.4, to =
    /// 0.7, steps = 4 } }. Every value is run with every other.
    pub(super) vary: Option<At<TreeRaw>>,
    /// Paths of the file with the value that each has in every run.
    pub(super) set: Option<At<TreeRaw>>,
    /// Variants of the file to take in turn; the file as it is without it.
    pub(super) variants: Option<At<Vec<At<String>>>>,
    /// How often inputs with a cov are drawn in each combination; without it each is its mean.
    pub(super) samples: Option<At<i64>>,
    /// Seed of the samples; 1 if not given.
    pub(super) seed: Option<At<i64>>,
    /// Motions of the file, or carried by Dolmen, by name.
    pub(super) motions: Option<At<Vec<At<String>>>>,
    /// Motions made for the study: seeded noise of firm ground.
    pub(super) artificial: Option<At<ArtificialRaw>>,
    /// Directions of shaking: turns of the motion from x towards y, with their unit; ["0 deg"] if not given.
    pub(super) directions: Option<At<Vec<At<NumberRaw>>>>,
    /// kind = "frame": the direction that is shaken; the only one of known stiffness if not given.
    pub(super) direction: Option<At<String>>,
    /// Factors on the motions, a list or { from, to, steps }; or peak.
    pub(super) scale: Option<At<SeriesRaw>>,
    /// Largest horizontal peaks that the motions are scaled to, with their unit, a list or { from, to, steps }; or scale.
    pub(super) peak: Option<At<SeriesRaw>>,
    /// A motion that acts before each run, and after which the structure comes to rest: runs tell what is left of its capacity.
    pub(super) after: Option<At<AfterRaw>>,
    /// How often the bracket of the first fall is halved; 3 if not given.
    pub(super) refine: Option<At<i64>>,
    /// kind = "stack": contact law; "springs" if not given.
    pub(super) law: Option<At<LawRaw>>,
    /// kind = "stack": contact points of a joint, 4, 9, 16 or 36; 16 if not given.
    pub(super) points: Option<At<i64>>,
    /// kind = "stack": where damage states begin.
    pub(super) damage: Option<At<DamageRaw>>,
    /// kind = "building": four rising drifts over the height of the storey, where its states begin; [0.005, 0.01, 0.02, 0.04] if not given.
    pub(super) drift_limits: Option<At<Vec<At<f64>>>>,
    /// Time after the motion, s; 2 for a stack, 20 for a frame or a chain, 20 and at least ten periods for a building if not given.
    pub(super) rest_s: Option<At<f64>>,
    /// Periods of the spectral accelerations that capacities are fitted over beside the peak of the ground, s; [0.2, 0.5, 1, 2] if not given.
    pub(super) spectral_periods_s: Option<At<Vec<At<f64>>>>,
    /// Their damping ratio; 0.05 if not given.
    pub(super) spectral_damping_ratio: Option<At<f64>>,
    /// Trends to look for.
    pub(super) expect: Option<Vec<At<ExpectedRaw>>>,
    /// kind = "frame" or "chain": a map of sticking and slipping under harmonic motions of the ground.
    pub(super) harmonic: Option<At<HarmonicRaw>>,
    /// kind = "frame": displacement of the top from which the frame is let go, for apparent frequency and damping.
    pub(super) release: Option<At<NumberRaw>>,
}

/// A motion that acts before each run.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct AfterRaw {
    /// A motion of the file, or carried by Dolmen, by name.
    #[schemars(required)]
    pub(super) motion: Option<At<String>>,
    /// Factors on it, a list or { from, to, steps }, each varied with every other input, 0 for the structure that was not shaken before; or peak. Without
    /// either the motion is as the file has it.
    pub(super) scale: Option<At<SeriesRaw>>,
    /// Largest horizontal peaks that it is scaled to, with their unit, a list or { from, to, steps }; or scale.
    pub(super) peak: Option<At<SeriesRaw>>,
}

/// Where damage states of a stack begin.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct DamageRaw {
    /// DS1: slip that counts as begun; 0.5 mm if not given.
    pub(super) slip_begun: Option<At<NumberRaw>>,
    /// DS2: offset left over the width of its joint; 0.005 if not given.
    pub(super) offset_ratio: Option<At<f64>>,
    /// DS2: offset left; 10 mm if not given.
    pub(super) offset: Option<At<NumberRaw>>,
    /// DS3: offset left over the width of its joint; 0.02 if not given.
    pub(super) severe_offset_ratio: Option<At<f64>>,
    /// DS3: rocking of a joint over the slenderness angle of what stands on it; 0.35 if not given.
    pub(super) severe_rocking_ratio: Option<At<f64>>,
}

/// Motions made for a study.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct ArtificialRaw {
    /// How many, 1 to 1000.
    #[schemars(required)]
    pub(super) count: Option<At<i64>>,
    /// Seed of the first, the next has the next one; 1 if not given.
    pub(super) seed: Option<At<i64>>,
    /// Length; 20 s if not given.
    pub(super) duration_s: Option<At<f64>>,
    /// Time until it is strong; 2 s if not given.
    pub(super) rise_s: Option<At<f64>>,
    /// Time that it is strong; 8 s if not given.
    pub(super) strong_s: Option<At<f64>>,
}

/// Contact law of a stack.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum LawRaw {
    /// Springs between the stones, as distinct-element programs have it.
    Springs,
    /// Stones that touch rigidly.
    Rigid,
}

/// A trend to look for.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct ExpectedRaw {
    /// Path of a varied input.
    #[schemars(required)]
    pub(super) input: Option<At<String>>,
    /// Which way the capacity goes as it grows.
    #[schemars(required)]
    pub(super) trend: Option<At<TrendRaw>>,
    /// What that means: text, or { en = "…", ko = "…" }.
    pub(super) words: Option<NamesRaw>,
    /// Who says so.
    pub(super) source: Option<String>,
}

/// Which way a trend goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum TrendRaw {
    /// It grows as the input grows.
    Rising,
    /// It falls as the input grows.
    Falling,
}

/// Harmonic motions of the ground.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct HarmonicRaw {
    /// Frequencies, a list or { from, to, steps }.
    #[schemars(required)]
    pub(super) frequency: Option<At<SeriesRaw>>,
    /// Amplitudes of the acceleration, with their unit, a list or { from, to, steps }.
    #[schemars(required)]
    pub(super) acceleration: Option<At<SeriesRaw>>,
}

/// Numbers from one to another.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct RangeRaw {
    /// The first.
    #[schemars(required)]
    pub(super) from: Option<At<NumberRaw>>,
    /// The last.
    #[schemars(required)]
    pub(super) to: Option<At<NumberRaw>>,
    /// How many, both counted.
    #[schemars(required)]
    pub(super) steps: Option<At<i64>>,
    /// How they are spaced; "linear" if not given.
    pub(super) spacing: Option<SpacingRaw>,
}

/// How numbers are spaced.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum SpacingRaw {
    /// By equal differences.
    #[default]
    Linear,
    /// By equal ratios.
    Logarithmic,
}

/// A list of numbers, or a range.
#[derive(Debug)]
pub(super) enum SeriesRaw {
    List(Vec<At<NumberRaw>>),
    Range(RangeRaw),
}

impl<'de> Deserialize<'de> for SeriesRaw {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct SeriesVisitor;
        impl<'de> Visitor<'de> for SeriesVisitor {
            type Value = SeriesRaw;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a list of numbers, or a table with from, to, steps")
            }

            fn visit_seq<S: SeqAccess<'de>>(self, mut list: S) -> Result<SeriesRaw, S::Error> {
                let mut values = Vec::new();
                while let Some(value) = list.next_element()? {
                    values.push(value);
                }
                Ok(SeriesRaw::List(values))
            }

            fn visit_map<M: MapAccess<'de>>(self, map: M) -> Result<SeriesRaw, M::Error> {
                RangeRaw::deserialize(MapAccessDeserializer::new(map)).map(SeriesRaw::Range)
            }
        }
        deserializer.deserialize_any(SeriesVisitor)
    }
}

impl JsonSchema for SeriesRaw {
    fn schema_name() -> Cow<'static, str> {
        "Series".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let number = generator.subschema_for::<NumberRaw>();
        let range = generator.subschema_for::<RangeRaw>();
        json_schema!({
            "anyOf": [{ "type": "array", "items": number }, range],
            "x-must-be": "a list of numbers, or { from = …, to = …, steps = … }",
        })
    }
}

/// A tree of values whose leaves are read later: what lies at a path is only known there.
#[derive(Debug)]
pub(super) enum TreeRaw {
    Leaf,
    List(Vec<At<IgnoredAny>>),
    Table(BTreeMap<String, At<TreeRaw>>),
}

impl<'de> Deserialize<'de> for TreeRaw {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct TreeVisitor;
        impl<'de> Visitor<'de> for TreeVisitor {
            type Value = TreeRaw;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a value, a list or a table")
            }

            fn visit_bool<E>(self, _: bool) -> Result<TreeRaw, E> {
                Ok(TreeRaw::Leaf)
            }

            fn visit_i64<E>(self, _: i64) -> Result<TreeRaw, E> {
                Ok(TreeRaw::Leaf)
            }

            fn visit_f64<E>(self, _: f64) -> Result<TreeRaw, E> {
                Ok(TreeRaw::Leaf)
            }

            fn visit_str<E>(self, _: &str) -> Result<TreeRaw, E> {
                Ok(TreeRaw::Leaf)
            }

            fn visit_seq<S: SeqAccess<'de>>(self, mut list: S) -> Result<TreeRaw, S::Error> {
                let mut values = Vec::new();
                while let Some(value) = list.next_element()? {
                    values.push(value);
                }
                Ok(TreeRaw::List(values))
            }

            fn visit_map<M: MapAccess<'de>>(self, mut map: M) -> Result<TreeRaw, M::Error> {
                let mut table = BTreeMap::new();
                while let Some((key, value)) = map.next_entry()? {
                    table.insert(key, value);
                }
                Ok(TreeRaw::Table(table))
            }
        }
        deserializer.deserialize_any(TreeVisitor)
    }
}

impl JsonSchema for TreeRaw {
    fn schema_name() -> Cow<'static, str> {
        "Paths".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "object", "x-must-be": "a table of paths: { \"joint.friction\" = … }" })
    }
}
