//! What a run does after a stone has fallen.

/// Continuation of a run after a stone has fallen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AfterFall {
    /// Stop at the fall (studies).
    Stop,
    /// Run to the end (animations).
    Continue,
}
