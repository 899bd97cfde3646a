//! Several setups of one survey: pairing of their sensors and modes, and the merged result.

mod agreement;
mod common_excitation;
mod joint;
mod merge_setups;
mod merged_mode;
mod pairing;
mod reference_gains;
mod sensor_places;

pub use agreement::Agreement;
pub use joint::{JointSetups, joint_setups};
pub use merge_setups::{MergeSetups, MergedSetups, PartialMode, merge_setups};
pub use merged_mode::MergedMode;
pub(crate) use pairing::shared;
pub use pairing::{ModePair, MovedFurther, ObservedMode, ObservedPoint, PairedModes, Pairing, pair_modes};
pub use reference_gains::{ReferenceFault, SuspectReference};
