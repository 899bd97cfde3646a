//! The project file as serde reads it and as the JSON schema describes it. Every key is optional here, so that
//! one problem does not hide the next; the schema states the required keys, and the check against it finds
//! missing ones.

use super::building::{DamperRaw, DampingRaw, FloorRaw, WatchedRaw};
use super::chain::{CapRaw, JointRaw, LinkRaw, StoneRaw};
use super::file_names::{NamesRaw, PrintedNamesRaw};
use super::file_number::{At, EvidenceRaw, NumberRaw, OrUnknown, QuantityRaw};
use super::frame::{AxialRaw, ConventionRaw, DirectionRaw, StoreyRaw};
use super::limits::LimitsRaw;
use super::loads::{CombinationRaw, LoadRaw, WindOrShelteredRaw};
use super::report::ReportRaw;
use super::site::{MotionRaw, SiteRaw};
use super::soil::HalfSpaceRaw;
use super::stack::{
    ArchRaw, BedRaw, BlockRaw, ContactRaw, DomeRaw, PagodaRaw, SideSupportRaw, StoneWallRaw,
    SupportMovementRaw, TieRaw, TowerRaw, TrilithonRaw, VaultRaw,
};
use super::study::StudyRaw;
use super::survey::{ChangeRaw, SurveyRaw, WatchRaw};
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
    /// What it is, in a sentence or two: text, or { en = "…", ko = "…" }.
    pub(super) description: Option<At<NamesRaw>>,
    /// Names of parts, surveys and motions as they are printed in English or Korean: [names.en], [names.ko]. Keys, CSV heads, JSON and file names keep
    /// those of the file.
    pub(super) names: Option<At<PrintedNamesRaw>>,
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
    /// kind = "chain": the joint below each link, lowest first, "unknown", or "identified" from the modes of a survey.
    pub(super) joints: Option<At<OrUnknown<JointRaw>>>,
    /// kind = "chain": whether the part at the very top (cap stone, finial) is among the links; "included" if not
    /// given.
    pub(super) cap: Option<At<CapRaw>>,
    /// kind = "chain": viscous damping of the first mode, as a ratio, by dashpots in proportion to the stiffness of the joints; instead
    /// of their own damping. For `dolmen simulate`.
    pub(super) damping_ratio: Option<At<QuantityRaw>>,
    /// kind = "chain": the stone of the links, { elastic_modulus = "40 GPa", poisson_ratio = 0.2, density = "2600 kg/m3" }: `dolmen check` then
    /// sets the pole beside one without joints.
    pub(super) stone: Option<At<StoneRaw>>,
    /// kind = "chain", "stack": the soil below, { shear_modulus = "40 MPa", poisson_ratio = 0.35, along = 1.8, across = 2.4 }, or with a diameter; in
    /// series with the lowest joint, which is then the bed alone. Of a chain without it the lowest joint holds both. The footing of a stack is the bed
    /// of its lowest block if not given.
    pub(super) soil: Option<At<HalfSpaceRaw>>,
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
    /// kind = "stack": an arch of voussoirs, instead of blocks.
    pub(super) arch: Option<At<ArchRaw>>,
    /// kind = "stack": a wall in running bond, instead of blocks.
    pub(super) wall: Option<At<StoneWallRaw>>,
    /// kind = "stack": a tower of courses, square or round, instead of blocks.
    pub(super) tower: Option<At<TowerRaw>>,
    /// kind = "stack": two posts and a lintel, instead of blocks.
    pub(super) trilithon: Option<At<TrilithonRaw>>,
    /// kind = "stack": a barrel vault, instead of blocks.
    pub(super) vault: Option<At<VaultRaw>>,
    /// kind = "stack": a spherical dome or two slices of one, instead of blocks.
    pub(super) dome: Option<At<DomeRaw>>,
    /// kind = "stack": whether the blocks are rubble that nobody placed on beds: `dolmen check` and `dolmen simulate` let them settle under their
    /// own weight first; false if not given. Contact is between their convex hulls.
    pub(super) loose: Option<At<bool>>,
    /// kind = "stack": density of the blocks that have none of their own.
    pub(super) density: Option<At<QuantityRaw>>,
    /// kind = "stack": what acts in every joint that does not say it itself.
    pub(super) joint: Option<At<BedRaw>>,
    /// kind = "stack": joints that differ, by the names of the two blocks that meet in them.
    pub(super) contacts: Option<Vec<At<ContactRaw>>>,
    /// kind = "stack": dowels and clamps.
    pub(super) ties: Option<Vec<At<TieRaw>>>,
    /// kind = "stack": what stands beside blocks and holds them. kind = "chain": posts that hold it, { height, stiffness, gap }.
    pub(super) side_supports: Option<Vec<At<SideSupportRaw>>>,
    /// kind = "stack": how far the ground moves under single blocks: supports that spread or settle.
    pub(super) support_movement: Option<Vec<At<SupportMovementRaw>>>,
    /// kind = "building": the floors, each with the storey below it, lowest first.
    pub(super) floors: Option<At<Vec<At<FloorRaw>>>>,
    /// kind = "building": whether the weight takes part of the stiffness (P-delta); true if not given.
    pub(super) p_delta: Option<At<bool>>,
    /// kind = "building": accidental eccentricity over the side of a floor; if not given, 0.05 where KDS 41 17 00 or EN 1998-1 decides, else none.
    pub(super) accidental_eccentricity: Option<At<NumberRaw>>,
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
    /// Wind: { speed = "30 m/s", means = "gust", force_coefficient = 2.0 }, or "sheltered" for what stands out of it.
    pub(super) wind: Option<At<WindOrShelteredRaw>>,
    /// Static loads beside the weight of the parts.
    pub(super) loads: Option<At<Vec<At<LoadRaw>>>>,
    /// Combinations of weight, wind and loads by name, each with its factors: [combination.NAME]. Everything as it is if not given.
    pub(super) combination: Option<BTreeMap<String, At<CombinationRaw>>>,
    /// kind = "frame" or "building": how far its storeys may drift under the design earthquake.
    pub(super) limits: Option<At<LimitsRaw>>,
    /// Studies by name, for `dolmen study`: [study.NAME].
    pub(super) study: Option<BTreeMap<String, At<StudyRaw>>>,
    /// kind = "stack" or "chain": whose tilt the model leans by: "latest" (the latest survey with a date and a tilt; if not given), "none", or
    /// the name of a survey.
    pub(super) as_surveyed: Option<At<String>>,
    /// Up to which inspection the model has the damage that inspections give it: "latest" (if not given), "none", or the name of a survey.
    pub(super) as_inspected: Option<At<String>>,
    /// What was measured, by occasion: [survey.2010-05-12].
    pub(super) survey: Option<BTreeMap<String, At<SurveyRaw>>>,
    /// Surveys in a table beside the file, a row a date, beside those of [survey.DATE]: { file = "history.xlsx", sheet = "list" }.
    #[expect(dead_code, reason = "read before the file is")]
    pub(super) surveys: Option<At<SurveysTableRaw>>,
    /// How two surveys are compared, for `dolmen compare`.
    pub(super) change: Option<At<ChangeRaw>>,
    /// What the report says beside the computation: client, authors, photographs, opinion. Given by the engineer, never computed.
    pub(super) report: Option<At<ReportRaw>>,
    /// How many surveys are watched, for `dolmen watch`.
    pub(super) watch: Option<At<WatchRaw>>,
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

/// A table of surveys.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[expect(dead_code, reason = "read before the file is")]
pub(super) struct SurveysTableRaw {
    /// The table beside the project file: XLSX, ODS or CSV.
    #[schemars(required)]
    file: Option<At<String>>,
    /// The sheet of a workbook with several.
    sheet: Option<At<String>>,
    /// Heads of columns that hold nothing of surveys.
    ignore: Option<Vec<At<String>>>,
}
