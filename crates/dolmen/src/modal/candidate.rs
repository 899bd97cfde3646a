//! A refused pole or peak, as the mode that the user may request.

use super::modes::Mode;
use super::refusal::Refusal;

/// A refused pole or peak, as the mode that it would be.
#[derive(Clone, Debug)]
pub(crate) struct Candidate {
    pub(crate) mode: Mode,
    pub(crate) refusal: Option<Refusal>,
}
