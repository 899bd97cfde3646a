//! Every solution of a stiffness that surveys do not determine, under one motion: the worst is the answer.

use crate::error::WorkError;
use crate::from_surveys::other_solutions;
use crate::judgement::{Judgement, judge_simulation};
use crate::opened::Opened;
use crate::progress::Progress;
use crate::simulate::{SimulateOptions, prepare};
use crate::simulation::SimulateAnswer;
use dolmen_records::Files;

/// Simulations of all solutions of a stiffness.
#[derive(Debug)]
pub struct SolvedSimulations {
    /// The worst; the only one if the stiffness is known, or a variant was asked for.
    pub worst: SimulateAnswer,
    /// The other solutions, by number.
    pub others: Vec<SimulateAnswer>,
    /// Number and judgement of every solution, by number; empty if there is only one.
    pub judged: Vec<(usize, Judgement)>,
    /// Number of the worst, if a check finds another solution to be the worst.
    pub differs_from_check: Option<usize>,
}

/// Simulates the other solutions of an undetermined stiffness like `first`, the simulation of the worst of a check, and finds the worst of all.
///
/// # Errors
/// [`WorkError`] if one of the runs is refused.
pub fn simulate_solutions(
    opened: &Opened,
    options: &SimulateOptions,
    first: SimulateAnswer,
    files: &dyn Files,
    progress: &dyn Progress,
) -> Result<SolvedSimulations, WorkError> {
    let project = &*opened.project;
    let several = project.from_surveys.as_ref().filter(|told| told.of > 1);
    let Some(told) = several.filter(|_| options.variant.is_none()) else {
        return Ok(SolvedSimulations {
            worst: first,
            others: Vec::new(),
            judged: Vec::new(),
            differs_from_check: None,
        });
    };
    let mut all = vec![(told.number, first)];
    for (number, name) in other_solutions(project) {
        let options = SimulateOptions {
            variant: Some(name.to_owned()),
            ..options.clone()
        };
        all.push((number, prepare(opened, &options, files)?.run(progress)?));
    }
    let rank = |(_, answer): &(usize, SimulateAnswer)| {
        let judgement = judge_simulation(answer);
        let headline = judgement.headline();
        let words = headline.map(|of| (of.weight.map(|word| word.colour()), of.earthquake_word()));
        (judgement.colour(), words)
    };
    // among equals, the worst of a check
    let worst = (0..all.len()).rev().max_by_key(|&at| rank(&all[at])).unwrap_or(0);
    let each = all.iter();
    let mut judged: Vec<_> = each.map(|(number, of)| (*number, judge_simulation(of))).collect();
    judged.sort_by_key(|(number, _)| *number);
    let (number, worst) = all.remove(worst);
    Ok(SolvedSimulations {
        worst,
        others: all.into_iter().map(|(_, of)| of).collect(),
        judged,
        differs_from_check: (number != told.number).then_some(number),
    })
}
