//! A refused pole or peak as a mode that the user may request.

use super::modes::Mode;
use super::refusal::Refusal;

/// A refused pole or peak as a mode.
#[derive(Clone, Debug)]
pub(crate) struct Candidate {
    pub(crate) mode: Mode,
    pub(crate) refusal: Option<Refusal>,
}
