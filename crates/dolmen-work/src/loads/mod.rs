//! Wind, static loads and their combinations: what they ask of each joint, and which combination is the worst.

mod answer;
mod words;

pub use answer::{
    AcrossCombination, Carried, ChainCombination, CombinationAnswer, Combined, DirectionUnderLoads,
    FrameCombination, FrameWind, LoadedStorey, LoadsAnswer, WindMet, WindOnLink,
};
pub use words::{Governed, Governing};
