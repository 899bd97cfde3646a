/// Continuation of a run after a stone has fallen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AfterFall {
    /// End at the fall, as studies need.
    Stop,
    /// Continue to the end, as films need.
    Continue,
}
