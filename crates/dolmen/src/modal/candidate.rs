//! What was refused, as the mode that the user may insist on.

use super::modes::Mode;
use super::refusal::Refusal;

/// What was refused, as the mode that it would be.
#[derive(Clone, Debug)]
pub(crate) struct Candidate {
    pub(crate) mode: Mode,
    pub(crate) refusal: Option<Refusal>,
}
