//! Notes on the result of an identification.

use super::Sprung;
use super::options::Weighting;
use super::search::{Count, EXACT, Search, rank};
use crate::structure::{
    Choice, Misfit, OfSpring, Spring, StiffnessNote, StiffnessSolution, Thoroughness, Visibility,
};
use dolmen_linalg::Svd;

/// A note names a spring as not seen if the data determine its direction by less than this share.
const SEEN_LEAST: f64 = 0.5;
/// Smaller components of a free direction are left out of the note.
const COMPONENT_LEAST: f64 = 0.05;

pub(super) fn of_solutions<S: Sprung>(
    search: &Search<'_, S>,
    count: &Count,
    choice: Choice,
) -> Vec<StiffnessNote> {
    let spring = S::SPRING;
    let springs = search.parts();
    let modes = search.modes.len();
    let with_shapes = search.modes.iter().any(|mode| mode.shape.len() >= 2);
    let Count {
        starts,
        solutions,
        as_good,
        nearest,
        odd,
        ref roots,
    } = *count;
    let complete = roots.as_ref().is_some_and(|roots| roots.complete);
    let mut notes = Vec::new();
    if let Some(roots) = roots {
        notes.extend(roots.notes.iter().cloned());
    }
    match choice {
        Choice::Impossible if complete => {}
        Choice::Impossible => notes.push(match nearest {
            Some(nearest) => StiffnessNote::NoneExplains {
                spring,
                starts,
                modes,
                misfit: misfit(search.weighting, nearest),
            },
            None => StiffnessNote::NoneStands { spring },
        }),
        Choice::Underdetermined if search.independent >= springs => {
            notes.push(StiffnessNote::FitLeavesFree { spring });
        }
        Choice::Underdetermined => notes.push(StiffnessNote::TooFewData {
            spring,
            springs,
            frequencies: modes,
            with_shapes,
            independent: search.independent,
            proportion: search.structure.proportion_to(),
        }),
        Choice::Indistinguishable if as_good < 2 => {} // two that meet: said below
        Choice::Indistinguishable => notes.push(StiffnessNote::SeveralExplain {
            spring,
            sets: as_good,
            thoroughness: match roots {
                Some(roots) if roots.complete => Thoroughness::All {
                    solutions_complex: roots.solutions_complex,
                },
                _ => Thoroughness::Searched { starts },
            },
            with_shapes,
        }),
        Choice::One if !with_shapes && springs > 1 && !complete => {
            notes.push(StiffnessNote::OneWithoutProof { spring, starts });
        }
        Choice::One | Choice::Bounded => {}
    }
    if odd {
        notes.push(StiffnessNote::OddCount { spring });
    }
    let listed = search.options.solutions_most;
    if solutions > listed {
        notes.push(StiffnessNote::ListCut {
            found: solutions,
            listed,
        });
    }
    let points = search.modes.iter().map(|mode| mode.shape.len()).enumerate();
    notes.extend(
        points
            .filter(|(_, points)| *points == 1)
            .map(|(j, _)| StiffnessNote::OneShapePoint { mode: j + 1 }),
    );
    if matches!(search.weighting, Weighting::PartlyAssumed | Weighting::Assumed) {
        notes.push(StiffnessNote::DeviationsAssumed {
            frequency: search.options.frequency_sd_assumed,
            shape: search.options.shape_sd_assumed,
        });
    }
    let explained = matches!(choice, Choice::One | Choice::Indistinguishable);
    if let (Weighting::Relative | Weighting::Assumed, Some(nearest)) = (search.weighting, nearest)
        && explained
        && nearest >= EXACT
    {
        notes.push(StiffnessNote::NoInterval {
            misfit: misfit(search.weighting, nearest),
        });
    }
    notes.extend(search.structure.assumptions());
    notes
}

fn misfit(weighting: Weighting, misfit: f64) -> Misfit {
    match weighting {
        Weighting::Relative => Misfit::Relative(misfit),
        _ => Misfit::Deviations(misfit),
    }
}

/// Combinations of stiffness that can change without changing the data.
pub(super) fn of_free_directions(spring: Spring, jacobian: &Svd, choice: Choice) -> Vec<StiffnessNote> {
    if choice != Choice::Underdetermined {
        return Vec::new();
    }
    let n = jacobian.v.rows();
    (rank(&jacobian.s)..n)
        .map(|direction| StiffnessNote::FreeDirection {
            spring,
            components: (0..n)
                .map(|i| OfSpring {
                    number: i + 1,
                    value: jacobian.v[(i, direction)],
                })
                .filter(|component| component.value.abs() >= COMPONENT_LEAST)
                .collect(),
        })
        .collect()
}

/// Shapes without standard deviations, with their errors.
pub(super) fn of_shapes<S: Sprung>(search: &Search<'_, S>, x: &[f64]) -> Vec<StiffnessNote> {
    let modes = search.modes.iter().zip(search.fit.shapes_off(x)).enumerate();
    modes
        .filter_map(|(j, (mode, off))| {
            let given = mode.shape.iter().any(|point| point.displacement_sd > 0.0);
            let difference = off.filter(|&off| !given && off >= EXACT)?;
            Some(StiffnessNote::ShapeOff {
                mode: j + 1,
                difference,
            })
        })
        .collect()
}

pub(super) fn of_ranges(solutions: &[StiffnessSolution]) -> Option<StiffnessNote> {
    let each = solutions.iter().enumerate();
    let incomplete = each.filter(|(_, solution)| {
        let range = solution.stiffness_range.as_ref();
        range.is_some_and(|range| !range.exists_throughout)
    });
    let solutions: Vec<usize> = incomplete.map(|(i, _)| i + 1).collect();
    (!solutions.is_empty()).then_some(StiffnessNote::RangeIncomplete { solutions })
}

/// Undetermined springs whose own stiffness barely changes the data. If only the split between several springs is
/// undetermined, each of them is seen.
pub(super) fn of_unseen(
    spring: Spring,
    visibility: &Visibility,
    barely_felt: &[usize],
) -> Option<StiffnessNote> {
    let unseen = barely_felt.iter().filter(|i| visibility.seen[**i] < SEEN_LEAST);
    let numbers: Vec<usize> = unseen.map(|i| i + 1).collect();
    (!numbers.is_empty()).then_some(StiffnessNote::Unseen { spring, numbers })
}

/// Springs whose interval is too wide to be linear.
pub(super) fn of_wide_intervals(spring: Spring, solution: &StiffnessSolution) -> Option<StiffnessNote> {
    const LINEAR_MOST: f64 = 0.3; // beyond it ln k and k differ by more than a seventh
    let each = solution.stiffness_sd.iter().flatten().zip(&solution.stiffness);
    let each = each.enumerate().map(|(i, (sd, k))| OfSpring {
        number: i + 1,
        value: sd / k,
    });
    let relative_sd: Vec<OfSpring> = each.filter(|each| each.value > LINEAR_MOST).collect();
    (!relative_sd.is_empty()).then_some(StiffnessNote::WideIntervals { spring, relative_sd })
}
