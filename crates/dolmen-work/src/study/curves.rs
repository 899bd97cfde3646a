//! The curves of a study, fitted on first use.

use super::answer::StudyAnswer;
use super::combination_fragility::CombinationFragility;
use super::joint_fragility::JointFragility;
use super::shaking_measure::MeasureComparison;

impl StudyAnswer {
    /// Fragility of each combination of inputs with a usable scan; empty for a study without scans. Fitted on first use: later changes of the
    /// runs have no effect.
    pub fn fragilities(&self) -> &[CombinationFragility] {
        self.fitted.combinations.get_or_init(|| self.fit_combinations())
    }

    /// Every joint of every combination with a usable scan; empty for structures other than stacks.
    pub fn joint_fragilities(&self) -> &[JointFragility] {
        self.fitted
            .joints
            .get_or_init(|| self.fit_joints(self.fragilities()))
    }

    /// The most informative measure of shaking for each state, with the smallest scatter of capacities. States without a curve for any measure
    /// are left out. `within` covers the combinations with a curve for every measure; with a single combination each measure stands alone.
    pub fn compare_measures(&self) -> &[MeasureComparison] {
        self.fitted
            .measures
            .get_or_init(|| self.fit_measures(self.fragilities()))
    }
}
