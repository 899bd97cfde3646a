//! Warnings about a ranking.

use super::answer::PortfolioAnswer;

/// Difference of ranks by falls alone that is reported: a third of all. Our choice.
const PART_APART: f64 = 1.0 / 3.0;

/// A structure whose rank by falls alone is far from its rank by the state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FallsApart<'a> {
    /// Its name.
    pub name: &'a str,
    /// Its rank by the state.
    pub rank: usize,
    /// Its rank by falls alone.
    pub by_falls: usize,
}

impl FallsApart<'_> {
    /// Number of ranks by which falls alone put it lower; negative if higher.
    fn behind(&self) -> f64 {
        self.by_falls as f64 - self.rank as f64
    }
}

/// Structures without a hazard, by name, if others have one, so that rates do not order them. Empty if all have one, or none.
pub fn without_hazard(answer: &PortfolioAnswer) -> Vec<&str> {
    let lacking = answer.entries.iter().filter(|entry| entry.hazard.is_none());
    let lacking: Vec<&str> = lacking.map(|entry| entry.name.as_str()).collect();
    match lacking.len() == answer.entries.len() {
        true => Vec::new(),
        false => lacking,
    }
}

/// Structures, by name, whose hazard comes from the table although their project has its own.
pub fn hazards_replaced(answer: &PortfolioAnswer) -> Vec<&str> {
    let replaced = answer.entries.iter().filter(|entry| entry.hazard_replaced);
    replaced.map(|entry| entry.name.as_str()).collect()
}

/// Structures ranked much higher by falls alone than by the state, the first to fall first.
pub fn falls_first(answer: &PortfolioAnswer) -> Vec<FallsApart<'_>> {
    let mut found = apart(answer, |behind, least| -behind >= least);
    found.sort_by_key(|one| one.by_falls);
    found
}

/// Structures ranked much lower by falls alone than by the state, the worst first.
pub fn misjudged(answer: &PortfolioAnswer) -> Vec<FallsApart<'_>> {
    match answer.state {
        3 => Vec::new(),
        _ => apart(answer, |behind, least| behind >= least),
    }
}

fn apart(answer: &PortfolioAnswer, is_far: impl Fn(f64, f64) -> bool) -> Vec<FallsApart<'_>> {
    let least = (PART_APART * answer.entries.len() as f64).max(1.0);
    let each = answer.rows().filter_map(|(place, entry, _)| {
        Some(FallsApart {
            name: &entry.name,
            rank: place.rank,
            by_falls: answer.by_falls.get(place.candidate).copied().flatten()?,
        })
    });
    each.filter(|one| is_far(one.behind(), least)).collect()
}
