//! What a run does after a stone has fallen.

/// What a run does after a stone has fallen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AfterFall {
    /// End there: what a study needs.
    Stop,
    /// Go on to the end: what a film needs.
    Continue,
}
