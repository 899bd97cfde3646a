//! Structures as checked values: mass, damping and stiffness matrices; natural modes; stiffness from measured
//! modes.

pub mod building;
mod chain;
mod columns_together;
mod directional;
mod error;
mod frame;
mod identification;
mod inverse;
mod left_out;
mod natural;
mod one_stone;
mod plan_pairs;
mod real_shape;
mod shaft;
mod shape_doubt;
mod soil;
pub mod stack;
mod stiffness_note;
mod stiffness_words;
mod turning;
pub mod wind;

pub use building::Building;
pub use chain::{AddedMass, Chain, ChainStiffness, Inertia, Link, SideSupport, SingleMass, chain_stiffness};
pub use columns_together::{ColumnOrdinate, ColumnsMove, ColumnsOfLevel, ColumnsTogether, columns_together};
pub use directional::{DirectionalModes, ShapeMotion, directional_modes};
pub use error::StructureError;
pub use frame::{
    Convention, Frame, FrameStiffness, Storey, Tie, frame_stiffness, stiffness_from_frequencies,
    stiffness_from_shape, stiffness_range, storey_axial_forces_n,
};
pub use identification::{
    Choice, MeasuredMode, ShapePoint, StiffnessBounds, StiffnessRange, StiffnessSolution, StiffnessSolutions,
    Visibility,
};
pub use inverse::{FrequencyRoots, StiffnessSearch};
pub use left_out::LeftOut;
pub use natural::{NaturalMode, lowest_frequency_hz};
pub use one_stone::{BeamFrequencies, BeamTheory, Jointing, Pole, SHAFTS_MOST};
pub use shaft::{Section, Shaft, Stone};
pub use shape_doubt::{ChannelChange, ShapeDoubt, chain_shape_doubt, frame_shape_doubt};
pub use soil::{Footing, Soil};
pub use stiffness_note::StiffnessNote;
pub use stiffness_words::{Misfit, OfSpring, Proportion, Spring, Thoroughness};
