//! Data of a store of surveys: structures, their surveys over years, actions and faults.

mod done;
mod fault;
mod structure;
mod survey;

pub use done::{Added, AddedEarthquake, Fault, Imported, Unidentified, Verified};
pub use fault::StoreFault;
pub use structure::{KeptLog, KeptState, KeptStructure, ListedStructure, ListedSurvey};
pub use survey::{KeptAnalysis, KeptEarthquake, KeptInspection, KeptMode, KeptRecord, KeptSurvey, KeptTilt};
