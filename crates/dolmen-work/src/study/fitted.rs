//! Curves fitted to a study, each only once, so that tables, text, figures and the report agree.

use super::combination_fragility::CombinationFragility;
use super::joint_fragility::JointFragility;
use super::shaking_measure::MeasureComparison;
use std::sync::OnceLock;

/// Curves fitted to the runs of a study so far.
#[derive(Clone, Debug, Default)]
pub struct Fitted {
    pub(super) combinations: OnceLock<Vec<CombinationFragility>>,
    pub(super) joints: OnceLock<Vec<JointFragility>>,
    pub(super) measures: OnceLock<Vec<MeasureComparison>>,
}
