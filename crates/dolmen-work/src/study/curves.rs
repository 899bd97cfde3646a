//! The curves of a study, fitted when they are first asked for.

use super::answer::StudyAnswer;
use super::combination_fragility::CombinationFragility;
use super::joint_fragility::JointFragility;
use super::shaking_measure::MeasureComparison;

impl StudyAnswer {
    /// Fragility of each combination of inputs that has a scan which can be used; nothing for a study without a scan. Fitted when it is first asked
    /// for: runs that are changed afterwards do not change it.
    pub fn fragilities(&self) -> &[CombinationFragility] {
        self.fitted.combinations.get_or_init(|| self.fit_combinations())
    }

    /// Every joint of every combination that has a scan which can be used; nothing for what is not a stack.
    pub fn joint_fragilities(&self) -> &[JointFragility] {
        self.fitted
            .joints
            .get_or_init(|| self.fit_joints(self.fragilities()))
    }

    /// Which measure of shaking tells most of each state: the one by which capacities scatter least. States that have a curve by no measure are left
    /// out. `within` is of the combinations that have a curve by every measure; of a single combination each measure stands for itself.
    pub fn compare_measures(&self) -> &[MeasureComparison] {
        self.fitted
            .measures
            .get_or_init(|| self.fit_measures(self.fragilities()))
    }
}
