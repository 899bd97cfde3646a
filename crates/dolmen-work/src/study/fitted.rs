//! What is fitted to a study, once: tables, text, figures and the report tell of the same curves.

use super::combination_fragility::CombinationFragility;
use super::joint_fragility::JointFragility;
use super::shaking_measure::MeasureComparison;
use std::sync::OnceLock;

/// What was fitted to the runs of a study so far.
#[derive(Clone, Debug, Default)]
pub struct Fitted {
    pub(super) combinations: OnceLock<Vec<CombinationFragility>>,
    pub(super) joints: OnceLock<Vec<JointFragility>>,
    pub(super) measures: OnceLock<Vec<MeasureComparison>>,
}
