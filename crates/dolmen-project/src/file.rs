//! The file as it is written: what serde reads and what the JSON schema describes. Every key is optional here, so
//! that one problem does not hide the next; which keys are required stands in the schema, where the check against
//! the schema finds it.

use super::file_building::{DamperRaw, DampingRaw, FloorRaw, WatchedRaw};
use super::file_number::{At, EvidenceRaw, OrUnknown, QuantityRaw};
use super::file_site::{MotionRaw, SiteRaw};
use super::file_stack::{BedRaw, BlockRaw, ContactRaw, PagodaRaw, SideSupportRaw, TieRaw};
use super::file_study::StudyRaw;
use super::file_survey::{ChangeRaw, SurveyRaw};
use schemars::JsonSchema;
use std::collections::BTreeMap;

/// A Dolmen project file: one structure with its surveys and variants.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Dolmen project")]
pub(super) struct FileRaw {
    /// Version of the file format: 1.
    #[schemars(required)]
    pub(super) schema: Option<At<i64>>,
    /// What the file models.
    #[schemars(required)]
    pub(super) kind: Option<At<KindRaw>>,
    /// Name of the structure: text, or { en = "…", ko = "…" }.
    #[schemars(required)]
    pub(super) name: Option<At<NamesRaw>>,
    /// What it is, in a sentence or two.
    pub(super) description: Option<String>,
    /// Where the numbers come from.
    pub(super) source: Option<String>,
    /// Where every number of the file comes from that does not say it itself; numbers written in a variant are left out.
    pub(super) evidence: Option<EvidenceRaw>,
    /// Units of bare numbers; SI where none is given.
    pub(super) units: Option<UnitsRaw>,
    /// Acceleration of gravity that turns weights into masses, m/s² unless units.acceleration says otherwise;
    /// 9.80665 if not given.
    pub(super) gravity: Option<At<QuantityRaw>>,
    /// Paths of values that look like unit slips but are right, as `["links[5].weight"]`.
    pub(super) allow: Option<Vec<At<String>>>,
    /// kind = "chain": the links, lowest first.
    pub(super) links: Option<At<Vec<At<LinkRaw>>>>,
    /// kind = "chain": the joint below each link, lowest first, or "unknown".
    pub(super) joints: Option<At<OrUnknown<JointRaw>>>,
    /// kind = "chain": whether the part at the very top (cap stone, finial) is among the links; "included" if not
    /// given.
    pub(super) cap: Option<At<CapRaw>>,
    /// kind = "chain": viscous damping of the first mode, as a ratio, by dashpots in proportion to the stiffness of the joints; instead
    /// of their own damping. For `dolmen simulate`.
    pub(super) damping_ratio: Option<At<QuantityRaw>>,
    /// kind = "frame": the storeys, lowest first.
    pub(super) storeys: Option<At<Vec<At<StoreyRaw>>>>,
    /// kind = "frame": what axial_force of a storey is: "storey", the force in its columns (its own level and all
    /// above), or "level", the load added at its top.
    pub(super) axial: Option<At<AxialRaw>>,
    /// kind = "frame": what the stiffness acts on; "drift" if not given.
    pub(super) convention: Option<At<ConventionRaw>>,
    /// kind = "frame": directions by name; each is a frame of its own with the same storeys.
    pub(super) direction: Option<BTreeMap<String, At<DirectionRaw>>>,
    /// kind = "stack": the blocks, lowest first.
    pub(super) blocks: Option<At<Vec<At<BlockRaw>>>>,
    /// kind = "stack": a pagoda made from six factors, instead of blocks.
    pub(super) pagoda: Option<At<PagodaRaw>>,
    /// kind = "stack": density of the blocks that have none of their own.
    pub(super) density: Option<At<QuantityRaw>>,
    /// kind = "stack": what acts in every joint that does not say it itself.
    pub(super) joint: Option<At<BedRaw>>,
    /// kind = "stack": joints that differ, by the names of the two blocks that meet in them.
    pub(super) contacts: Option<Vec<At<ContactRaw>>>,
    /// kind = "stack": dowels and clamps.
    pub(super) ties: Option<Vec<At<TieRaw>>>,
    /// kind = "stack": what stands beside blocks and holds them.
    pub(super) side_supports: Option<Vec<At<SideSupportRaw>>>,
    /// kind = "building": the floors, each with the storey below it, lowest first.
    pub(super) floors: Option<At<Vec<At<FloorRaw>>>>,
    /// kind = "building": whether the weight takes part of the stiffness (P-delta); true if not given.
    pub(super) p_delta: Option<At<bool>>,
    /// kind = "building": damping of its modes; 5 % in every mode if not given.
    pub(super) damping: Option<At<DampingRaw>>,
    /// kind = "building": tuned mass dampers by name: [damper.NAME].
    pub(super) damper: Option<BTreeMap<String, At<DamperRaw>>>,
    /// kind = "building": points of floors whose motion is reported.
    pub(super) points: Option<At<Vec<At<WatchedRaw>>>>,
    /// Motions of the ground by name, for `dolmen simulate --motion NAME`: [motion.NAME]. Not for kind = "survey".
    pub(super) motion: Option<BTreeMap<String, At<MotionRaw>>>,
    /// Where it stands, and what an earthquake asks for there.
    pub(super) site: Option<At<SiteRaw>>,
    /// Studies by name, for `dolmen study`: [study.NAME].
    pub(super) study: Option<BTreeMap<String, At<StudyRaw>>>,
    /// What was measured, by occasion: [survey.2010-05-12].
    pub(super) survey: Option<BTreeMap<String, At<SurveyRaw>>>,
    /// How two surveys are compared, for `dolmen compare`.
    pub(super) change: Option<At<ChangeRaw>>,
}

/// What a file models.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum KindRaw {
    /// Rigid links on rotational springs: flagpole, column of drums.
    Chain,
    /// Rigid storeys on lateral springs with P-delta: gate, pavilion.
    Frame,
    /// Blocks of stone on each other: pagoda, cairn, wall, column of drums.
    Stack,
    /// Rigid floors on walls and columns that sway and twist: houses, halls, high buildings.
    Building,
    /// Measured but not modelled: records and modes only.
    Survey,
}

#[derive(Clone, Debug, Default, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct NamesTable {
    /// English.
    pub(super) en: Option<String>,
    /// Korean.
    pub(super) ko: Option<String>,
}

/// A name in one or two languages.
#[derive(Clone, Debug, serde::Deserialize, JsonSchema)]
#[serde(untagged)]
pub(super) enum NamesRaw {
    One(String),
    Table(NamesTable),
}

/// Units of bare numbers.
#[derive(Debug, Default, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct UnitsRaw {
    /// Every length, width, height and position; default "m".
    pub(super) length: Option<At<String>>,
    /// weight, axial_force; default "N".
    pub(super) force: Option<At<String>>,
    /// mass; default "kg".
    pub(super) mass: Option<At<String>>,
    /// stiffness of joints (default "N*m/rad"), of storeys (default "N/m") or per area of
    /// joints of a stack (default "Pa/m").
    pub(super) stiffness: Option<At<String>>,
    /// damping of joints; default "N*m*s/rad".
    pub(super) damping: Option<At<String>>,
    /// friction_moment of joints; default "N*m".
    pub(super) moment: Option<At<String>>,
    /// inertia; default "kg*m2".
    pub(super) inertia: Option<At<String>>,
    /// frequency, frequencies, sampling_rate; default "Hz".
    pub(super) frequency: Option<At<String>>,
    /// gravity; default "m/s2".
    pub(super) acceleration: Option<At<String>>,
    /// density; default "kg/m3".
    pub(super) density: Option<At<String>>,
    /// cohesion, tension; default "Pa".
    pub(super) stress: Option<At<String>>,
}

/// One rigid link.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct LinkRaw {
    /// What people call it.
    pub(super) name: Option<String>,
    /// Weight, a force; or mass.
    pub(super) weight: Option<At<QuantityRaw>>,
    /// Mass; or weight.
    pub(super) mass: Option<At<QuantityRaw>>,
    /// Length from joint to joint.
    #[schemars(required)]
    pub(super) length: Option<At<QuantityRaw>>,
    /// Height of the centre of mass above the link's lower joint.
    #[schemars(required)]
    pub(super) centroid: Option<At<QuantityRaw>>,
    /// Moment of inertia about the centre of mass; that of a thin rod if neither it nor breadth is given.
    pub(super) inertia: Option<At<QuantityRaw>>,
    /// Breadth in the direction of motion: the inertia is then that of a box.
    pub(super) breadth: Option<At<QuantityRaw>>,
    /// Width of the bed below it in the direction of motion: for the uplift limit of its lower joint.
    pub(super) bed_width: Option<At<QuantityRaw>>,
}

/// The joint below a link.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct JointRaw {
    /// Rotational stiffness.
    #[schemars(required)]
    pub(super) stiffness: Option<At<QuantityRaw>>,
    /// Rotational dashpot.
    pub(super) damping: Option<At<QuantityRaw>>,
    /// Width of the bed in the direction of motion; the same as bed_width of the link above it.
    pub(super) bed_width: Option<At<QuantityRaw>>,
    /// For `dolmen simulate`: "edge", at most half the width of its bed times the weight above it; "held", any moment. Without it "edge"
    /// where bed_width is known.
    pub(super) opening: Option<At<OpeningRaw>>,
    /// Moment of dry friction beside the spring, while the joint turns: for `dolmen simulate`.
    pub(super) friction_moment: Option<At<QuantityRaw>>,
    /// The same before it turns; that of friction_moment without it.
    pub(super) static_friction_moment: Option<At<QuantityRaw>>,
}

/// Whether a joint opens.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum OpeningRaw {
    /// At the edge of its bed.
    Edge,
    /// Never.
    Held,
}

/// Whether the part at the very top is among the links.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
pub(super) enum CapRaw {
    /// There is none, or it is among the links.
    #[serde(rename = "included")]
    Included,
    /// It is left out: unconservative, and every result says so.
    #[serde(rename = "left out")]
    LeftOut,
}

/// One storey.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct StoreyRaw {
    /// What people call it.
    pub(super) name: Option<String>,
    /// Mass at its top; or weight.
    pub(super) mass: Option<At<QuantityRaw>>,
    /// Weight at its top, a force; or mass.
    pub(super) weight: Option<At<QuantityRaw>>,
    /// Column height.
    #[schemars(required)]
    pub(super) height: Option<At<QuantityRaw>>,
    /// Axial force as axial says; from the masses if none is given; 0 leaves P-delta out.
    pub(super) axial_force: Option<At<QuantityRaw>>,
}

/// What axial_force is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum AxialRaw {
    /// The force in the columns of the storey: its own level and all above.
    Storey,
    /// The load added at its top.
    Level,
}

/// What the stiffness acts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum ConventionRaw {
    /// The storey drift.
    Drift,
    /// The displacement relative to the ground.
    Grounded,
}

/// One horizontal direction of a frame.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct DirectionRaw {
    /// Lateral stiffness of each storey, lowest first, or "unknown".
    #[schemars(required)]
    pub(super) stiffness: Option<At<OrUnknown<QuantityRaw>>>,
    /// Viscous damping, as a ratio, in every mode: for `dolmen simulate`.
    pub(super) damping_ratio: Option<At<QuantityRaw>>,
    /// Dry friction of the storeys: for `dolmen simulate`.
    pub(super) friction: Option<At<FrictionRaw>>,
}

/// Dry friction in a direction of a frame: a coefficient of the axial force, or a slip force for each storey.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct FrictionRaw {
    /// "coulomb" (a slider beside the spring; the default) or "jenkins" (a slider in series with part of the spring).
    pub(super) law: Option<At<FrictionLawRaw>>,
    /// Slip force over the axial force of the storey while it slips.
    pub(super) coefficient: Option<At<QuantityRaw>>,
    /// The same before it slips; that of coefficient without it.
    pub(super) static_coefficient: Option<At<QuantityRaw>>,
    /// Slip force of each storey, lowest first, in place of a coefficient.
    pub(super) force: Option<At<Vec<At<QuantityRaw>>>>,
    /// law = "jenkins": what is left of the stiffness of each storey while its slider slips, lowest first.
    pub(super) slipping_stiffness: Option<At<Vec<At<QuantityRaw>>>>,
    /// "drift" (the default), or "displacement" as eq. 11 of Park and Min (2010) is printed.
    pub(super) acts_on: Option<At<FrictionActsOnRaw>>,
}

/// The law of a slider.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum FrictionLawRaw {
    /// Beside the storey's spring.
    Coulomb,
    /// In series with a spring of its own, beside the storey's.
    Jenkins,
}

/// What a slider acts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum FrictionActsOnRaw {
    /// The storey drift.
    Drift,
    /// The displacement relative to the ground.
    Displacement,
}
