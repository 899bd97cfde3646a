//! Wind, static loads and their combinations: the moments in each joint, and the worst combination.

mod answer;
mod on_building;
mod words;

pub use answer::{
    AcrossCombination, Carried, ChainCombination, CombinationAnswer, Combined, DirectionUnderLoads,
    FrameCombination, FrameWind, LoadedStorey, LoadsAnswer, SlippingWind, WindMet, WindOnLink,
};
pub use on_building::{BuildingCombination, LargestCombined, StoreyCombined, UnknownMotion};
pub use words::{Governed, Governing};
