//! Stacks: blocks of stone on each other.

mod attached;
mod attached_part;
mod bed;
mod block;
mod body;
mod build;
mod doubts;
mod fault;
mod file;
mod lean;
mod loose;
mod loose_material;
mod loosened;
mod made;
mod made_part;
mod made_towers;
mod made_vaults;
mod pagoda;
mod part;
mod read;
mod shape;
mod slips;
mod slips_beside;
mod slips_held;
mod surveyed_lean;
mod top;
mod vectors;

pub use attached_part::{CornicePart, MastPart};
pub(crate) use doubts::doubt_stack;
pub use fault::StackFault;
pub(crate) use file::{
    ArchRaw, BedRaw, BlockRaw, ContactRaw, DomeRaw, PagodaRaw, SideSupportRaw, StoneWallRaw,
    SupportMovementRaw, TieRaw, TowerRaw, TrilithonRaw, VaultRaw,
};
pub(crate) use lean::lean;
pub use made_part::{
    ArchPart, BondPart, DomePart, DomePiecePart, MadePart, StoneWallPart, TowerPart, TowerPlanPart,
    TrilithonPart, VaultPart, WallOpeningPart,
};
pub use part::{
    BedPart, BlockPart, ContactPart, JointDefaults, LoosenedBedPart, LostBedPart, MeshPart, OpeningPart,
    PagodaPart, PagodaSlendernessPart, PointsFrame, ShapePart, SideSupportPart, StackPart,
    SupportMovementPart, TiePart, TopPart,
};
pub(crate) use read::stack;
pub(crate) use slips::judge_stack;
pub use surveyed_lean::SurveyedLean;
