//! What a store of surveys keeps and gives back: structures, their surveys over years, what was done and what is wrong.

mod done;
mod fault;
mod structure;
mod survey;

pub use done::{Added, AddedEarthquake, Fault, Imported, Unidentified, Verified};
pub use fault::StoreFault;
pub use structure::{KeptLog, KeptState, KeptStructure, ListedStructure, ListedSurvey};
pub use survey::{KeptAnalysis, KeptEarthquake, KeptInspection, KeptMode, KeptRecord, KeptSurvey, KeptTilt};
