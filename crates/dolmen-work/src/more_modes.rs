//! More modes along a direction than the model has: which of them are the direction's decides the stiffness.

use crate::error::WorkError;
use crate::kinds;
use crate::surveyed::{OtherChoice, StiffnessAnswer, StiffnessDoubt};
use dolmen::structure::{Choice, MeasuredMode};
use dolmen_project::Project;

/// Ratio to the highest mode in use up to which a further one may be the direction's, and a lower one torsion. Our choice: a floor on columns at
/// its corners, twice as stiff one way as the other, twists at up to √6 times its sway.
const RATIO_MOST: f64 = 3.0;
/// Largest number of further modes considered, and of other choices fitted. Our choice.
const FURTHER_MOST: usize = 2;
const CHOICES_MOST: usize = 6;

/// The modes beyond those of the model that may be the direction's.
pub(crate) fn near<'a>(used: &[MeasuredMode], beyond: &'a [MeasuredMode]) -> &'a [MeasuredMode] {
    let highest_hz = used.last().map_or(0.0, |mode| mode.frequency_hz);
    let count = beyond
        .iter()
        .take_while(|mode| mode.frequency_hz <= RATIO_MOST * highest_hz);
    &beyond[..count.count().min(FURTHER_MOST)]
}

/// Doubts each stiffness that another choice of the measured modes would change, and adds these choices. A choice whose shapes no stiffness
/// explains is none.
pub(crate) fn doubt_more_modes(
    project: &Project,
    direction: &str,
    (used, beyond): (&[MeasuredMode], &[MeasuredMode]),
    answers: &mut [StiffnessAnswer],
) -> Result<(), WorkError> {
    let near = near(used, beyond);
    if near.is_empty() {
        return Ok(());
    }
    let all: Vec<&MeasuredMode> = used.iter().chain(near).collect();
    for chosen in others(all.len(), used.len()).into_iter().take(CHOICES_MOST) {
        let modes: Vec<MeasuredMode> = chosen.iter().map(|at| all[*at].clone()).collect();
        for found in kinds::stiffness(project, direction, &modes, &[])? {
            let mut same = answers
                .iter_mut()
                .filter(|answer| answer.convention == found.convention);
            let Some(answer) = same
                .next()
                .filter(|_| found.solutions.choice != Choice::Impossible)
            else {
                continue;
            };
            answer.doubted = Some(StiffnessDoubt::MoreModes);
            answer
                .other_choices
                .extend(found.solutions.solutions.into_iter().map(|one| OtherChoice {
                    frequencies_hz: found.frequencies_hz.clone(),
                    stiffness: one.stiffness,
                    stiffness_sd: one.stiffness_sd,
                }));
        }
    }
    Ok(())
}

/// Every ascending choice of some out of all, without that of the lowest.
fn others(all: usize, some: usize) -> Vec<Vec<usize>> {
    let sets = (0..1_u32 << all).filter(|set| set.count_ones() as usize == some);
    let mut each: Vec<Vec<usize>> = sets
        .map(|set| (0..all).filter(|at| set >> at & 1 == 1).collect())
        .collect();
    each.sort();
    each.remove(0);
    each
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_other_choices_of_modes() {
        assert_eq!(others(3, 1), [[1], [2]]);
        assert_eq!(others(3, 2), [[0, 2], [1, 2]]);
        assert_eq!(others(4, 2).len(), 5);
    }
}
