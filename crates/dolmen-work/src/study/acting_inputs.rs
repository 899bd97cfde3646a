//! Inputs of a study that change nothing in its runs.

use super::answer::StudyAnswer;
use super::run::Run;
use dolmen_project::Scan;
use std::collections::BTreeMap;

impl StudyAnswer {
    /// Whether a varied input, an index, changes anything in the runs: no wind blows in them, a given peak replaces the size of each motion,
    /// and an input does not act if the runs with all its values are equal to the last bit.
    pub(super) fn input_acts(&self, index: usize) -> bool {
        let Some(input) = self.inputs.get(index) else {
            return true;
        };
        let path = input.path.as_str();
        let has_peaks = matches!(self.study.scan, Some(Scan::Peaks(_)));
        let is_size = path.starts_with("motion.") && (path.ends_with(".scale") || path.ends_with(".peak"));
        if path == "wind" || path.starts_with("wind.") || (has_peaks && is_size) {
            return false;
        }
        let mut alike: BTreeMap<(usize, Vec<&str>), Vec<Vec<Run>>> = BTreeMap::new();
        for runs in self.runs.chunk_by(|a, b| a.job == b.job) {
            let Some(job) = runs.first().map(|run| run.job) else {
                continue;
            };
            let case = self.case(job);
            let varied = case.texts.iter().take(self.study.vary.len()).enumerate();
            let others = varied
                .filter(|(at, _)| *at != index)
                .map(|(_, text)| text.as_str());
            let others = case.variant.as_deref().into_iter().chain(others).collect();
            let own = runs.iter().map(|run| Run {
                job: 0,
                ..run.clone()
            });
            let key = (self.replicate_of(job), others);
            alike.entry(key).or_default().push(own.collect());
        }
        let differ = |groups: &Vec<Vec<Run>>| {
            groups.windows(2).any(|pair| {
                let [one, other] = pair else {
                    return false;
                };
                let is_same = one.len() == other.len() && one.iter().zip(other).all(|(a, b)| a.is_same(b));
                !is_same
            })
        };
        let is_compared = alike.values().any(|groups| groups.len() > 1);
        !is_compared || alike.values().any(differ)
    }
}
