//! Capacity of a structure from runs at increasing scales of one motion.
//!
//! A rocking stack can survive a motion at a larger scale than one that overturns it. Therefore all scales of a grid are run, because
//! bisection alone could miss the first fall. The first fall is the capacity; survived scales above it are reported too.

use super::AssessError;

/// Outcome of a run at one scale.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trial {
    /// No block fell.
    Survived,
    /// A block fell.
    Fell,
    /// The run is unusable: it was refused, diverged, found no solution, or ended without a verdict.
    Unknown,
}

/// One scale of a scan and its outcome.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScaleTrial {
    /// Factor on the motion, –.
    pub scale: f64,
    /// Outcome of the run.
    pub trial: Trial,
}

/// Result of a scan.
#[derive(Clone, Debug, PartialEq)]
pub struct Capacity {
    /// Smallest scale with a fall; `None` if there was no fall.
    pub first_fall: Option<f64>,
    /// Largest scale up to which all scales were survived; 0 (rest) if there is none.
    pub survived_below: f64,
    /// Survived scales above the first fall, ascending: if there are any, the scan is not monotone.
    pub survived_above: Vec<f64>,
    /// Largest scale of the scan: without a fall, the capacity is larger.
    pub largest_tried: f64,
    /// Scales of unusable runs, ascending.
    pub unknown: Vec<f64>,
}

/// Capacity as known from a scan. An unusable run counts neither as survival nor as a fall: below the first fall it makes the capacity an
/// interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reading {
    /// The first fall is at this scale; all smaller scales were survived.
    Fell(f64),
    /// All scales were survived: the capacity is above the largest.
    Beyond(f64),
    /// The capacity is in an interval, from the largest survived scale below the first unusable run up to the first fall.
    Open {
        /// Largest scale up to which all scales were survived; 0 if there is none.
        survived: f64,
        /// Smallest scale with a fall.
        fell: Option<f64>,
    },
}

impl Capacity {
    /// The capacity as known from the scan.
    pub fn reading(&self) -> Reading {
        let limit = self.first_fall.unwrap_or(f64::INFINITY);
        match self.first_fall {
            _ if self.unknown.iter().any(|scale| *scale < limit) => Reading::Open {
                survived: self.survived_below,
                fell: self.first_fall,
            },
            Some(scale) => Reading::Fell(scale),
            None => Reading::Beyond(self.largest_tried),
        }
    }
}

/// The size of shaking at which a state is first reached, or a lower bound of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reached {
    /// The state is first reached at this size.
    At(f64),
    /// The state is not reached up to this size, the largest of the scan.
    Above(f64),
}

impl Reached {
    /// The size or the lower bound.
    pub fn value(self) -> f64 {
        match self {
            Reached::At(value) | Reached::Above(value) => value,
        }
    }

    /// Whether the state was reached.
    pub fn is_reached(self) -> bool {
        matches!(self, Reached::At(_))
    }
}

/// A quantile of sizes of shaking, some of which may be lower bounds; `None` without values.
///
/// ```text
/// x_(1) ≤ … ≤ x_(n)      h = (n − 1) p          definition 7 of Hyndman and Fan: linear between two values
/// lower end: each lower bound as it is; upper end: each lower bound at infinity
/// ```
///
/// The result is `At` if both ends are equal, otherwise `Above` the lower end: a size that is only a lower bound may be any larger value,
/// so the quantile is an interval without an upper end.
///
/// # Source
/// Hyndman, R. J. and Fan, Y. (1996) Sample quantiles in statistical packages. Am. Stat. 50(4):361–365, applied to both ends of the
/// intervals.
///
/// # Example
/// ```
/// use dolmen::assess::{Reached::{Above, At}, reached_quantile};
/// assert_eq!(reached_quantile(&[At(0.5), At(0.9)], 0.5), Some(At(0.7)));
/// // the second size is only known to be above 0.9
/// assert_eq!(reached_quantile(&[At(0.5), Above(0.9)], 0.5), Some(Above(0.7)));
/// assert_eq!(reached_quantile(&[At(0.5), At(0.9), Above(1.0)], 0.5), Some(At(0.9)));
/// ```
pub fn reached_quantile(values: &[Reached], probability: f64) -> Option<Reached> {
    let last = values.len().checked_sub(1)?;
    let h = last as f64 * probability.clamp(0.0, 1.0);
    let below = (h.floor() as usize).min(last);
    let part = h - below as f64;
    let of = |end: fn(Reached) -> f64| {
        let mut ends: Vec<f64> = values.iter().copied().map(end).collect();
        ends.sort_by(f64::total_cmp);
        match ends.get(below + 1) {
            Some(high) if part > 0.0 => ends[below] + part * (high - ends[below]),
            _ => ends[below],
        }
    };
    let lower = of(Reached::value);
    let upper = of(|value| match value {
        Reached::At(value) => value,
        Reached::Above(_) => f64::INFINITY,
    });
    Some(match upper == lower {
        true => Reached::At(lower),
        false => Reached::Above(lower),
    })
}

/// The capacity from the runs of a scan.
///
/// # Errors
/// [`AssessError::Scale`] for a scale that is not positive, or if there is no scale.
///
/// # Example
/// ```
/// use dolmen::assess::{ScaleTrial, Trial, capacity};
/// let ends = [Trial::Survived, Trial::Fell, Trial::Survived, Trial::Fell];
/// let tried: Vec<ScaleTrial> = ends.into_iter().zip(1..).map(|(trial, n)| ScaleTrial { scale: f64::from(n), trial }).collect();
/// let found = capacity(&tried)?;
/// assert_eq!((found.first_fall, found.survived_below, found.survived_above), (Some(2.0), 1.0, vec![3.0]));
/// # Ok::<(), dolmen::assess::AssessError>(())
/// ```
pub fn capacity(tried: &[ScaleTrial]) -> Result<Capacity, AssessError> {
    let sorted = sorted(tried)?;
    let of = |wanted: Trial| {
        sorted
            .iter()
            .filter(move |point| point.trial == wanted)
            .map(|point| point.scale)
    };
    let first_fall = of(Trial::Fell).next();
    let limit = first_fall.unwrap_or(f64::INFINITY);
    Ok(Capacity {
        first_fall,
        survived_below: sorted
            .iter()
            .take_while(|point| point.trial == Trial::Survived)
            .last()
            .map_or(0.0, |point| point.scale),
        survived_above: of(Trial::Survived).filter(|scale| *scale > limit).collect(),
        largest_tried: sorted.last().map_or(0.0, |point| point.scale),
        unknown: of(Trial::Unknown).collect(),
    })
}

/// The next scale that refines the first fall of a grid: the middle of its bracket. `None` after `halvings` refinements, if nothing fell,
/// or if a run in the bracket is unusable.
///
/// The bracket lies between two neighbours of the grid. It is assumed to contain one fall; below the first scale of the grid no fall is
/// assumed.
///
/// # Errors
/// As [`capacity`].
pub fn next_in_bracket(
    grid: &[f64],
    tried: &[ScaleTrial],
    halvings: u32,
) -> Result<Option<f64>, AssessError> {
    let sorted = sorted(tried)?;
    let trial_at = |scale: f64| {
        let at = sorted.iter().find(|point| point.scale == scale);
        at.map(|point| point.trial)
    };
    let mut low = 0.0;
    let mut high = None;
    for &scale in grid {
        match trial_at(scale) {
            Some(Trial::Survived) => low = scale,
            Some(Trial::Fell) => {
                high = Some(scale);
                break;
            }
            Some(Trial::Unknown) | None => return Ok(None),
        }
    }
    let Some(mut high) = high else {
        return Ok(None);
    };
    for _ in 0..halvings {
        let middle = 0.5 * (low + high);
        match trial_at(middle) {
            None => return Ok(Some(middle)),
            Some(Trial::Survived) => low = middle,
            Some(Trial::Fell) => high = middle,
            Some(Trial::Unknown) => return Ok(None),
        }
    }
    Ok(None)
}

fn sorted(tried: &[ScaleTrial]) -> Result<Vec<ScaleTrial>, AssessError> {
    if let Some(bad) = tried
        .iter()
        .find(|point| !(point.scale > 0.0 && point.scale.is_finite()))
    {
        return Err(AssessError::Scale { given: bad.scale });
    }
    let mut sorted = tried.to_vec();
    sorted.sort_by(|a, b| a.scale.total_cmp(&b.scale));
    Ok(sorted)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A response that is not monotone: falls in (1.3, 1.7) and above 2.4.
    fn falls(scale: f64) -> Trial {
        if (1.3..1.7).contains(&scale) || scale > 2.4 {
            Trial::Fell
        } else {
            Trial::Survived
        }
    }

    #[test]
    fn exact_first_fall_of_a_scan_that_is_not_monotone() {
        let grid: Vec<f64> = (1..=6).map(|n| 0.5 * f64::from(n)).collect();
        let mut tried: Vec<ScaleTrial> = grid
            .iter()
            .map(|&scale| ScaleTrial {
                scale,
                trial: falls(scale),
            })
            .collect();
        let coarse = capacity(&tried).unwrap();
        assert_eq!(coarse.first_fall, Some(1.5));
        assert_eq!(coarse.survived_above, [2.0]);
        for _ in 0..10 {
            if let Some(scale) = next_in_bracket(&grid, &tried, 10).unwrap() {
                tried.push(ScaleTrial {
                    scale,
                    trial: falls(scale),
                });
            }
        }
        assert_eq!(next_in_bracket(&grid, &tried, 10).unwrap(), None);
        let fine = capacity(&tried).unwrap();
        let first = fine.first_fall.unwrap();
        assert!(
            (first - 1.3).abs() < 0.5 / 1024.0 && fine.survived_below < first,
            "{fine:?}"
        );
        assert_eq!(tried.len(), 16);
    }

    #[test]
    fn refuses_scales_that_are_not_positive_and_stops_at_unusable_runs() {
        let at = |scale, trial| ScaleTrial { scale, trial };
        assert!(capacity(&[at(0.0, Trial::Fell)]).is_err());
        assert!(capacity(&[at(f64::NAN, Trial::Fell)]).is_err());
        let tried = [at(1.0, Trial::Unknown), at(2.0, Trial::Fell)];
        assert_eq!(next_in_bracket(&[1.0, 2.0], &tried, 4).unwrap(), None);
        let found = capacity(&tried).unwrap();
        assert_eq!((found.survived_below, found.unknown), (0.0, vec![1.0]));
    }

    #[test]
    fn holds_a_run_that_cannot_be_used_is_never_survived() {
        let read = |ends: &[Trial]| {
            let scales = (1..).map(f64::from);
            let tried: Vec<ScaleTrial> = ends
                .iter()
                .zip(scales)
                .map(|(&trial, scale)| ScaleTrial { scale, trial })
                .collect();
            capacity(&tried).unwrap().reading()
        };
        use Trial::{Fell, Survived, Unknown};
        let open = |survived, fell| Reading::Open { survived, fell };
        assert_eq!(
            read(&[Survived, Survived, Fell, Unknown, Survived]),
            Reading::Fell(3.0)
        );
        assert_eq!(read(&[Survived, Survived]), Reading::Beyond(2.0));
        assert_eq!(read(&[Unknown, Unknown]), open(0.0, None));
        assert_eq!(read(&[Survived, Unknown, Survived]), open(1.0, None));
        assert_eq!(read(&[Survived, Unknown, Survived, Fell]), open(1.0, Some(4.0)));
        assert_eq!(read(&[Survived, Survived, Unknown]), open(2.0, None));
    }

    #[test]
    fn exact_quantiles_where_some_did_not_fall() {
        use Reached::{Above, At};
        let of = |values: &[Reached], p| reached_quantile(values, p).unwrap();
        assert_eq!(of(&[At(3.0), At(1.0), At(2.0)], 0.5), At(2.0));
        assert_eq!(of(&[At(1.0), At(2.0)], 0.25), At(1.25));
        // one of four fell: the smallest value is known, the median is not
        let four = [Above(2.0), At(0.712), Above(2.0), Above(2.0)];
        // the 5 % quantile lies 0.15 of the way from 0.712 to the lower bound 2
        assert_eq!(of(&four, 0.05), Above(0.712 + 0.15 * (2.0 - 0.712)));
        assert_eq!(of(&four, 0.0), At(0.712));
        // the structure with the larger values for both motions has the larger median
        let [weak, strong] = [[At(0.5), At(0.9)], [At(0.625), Above(0.9)]].map(|all| of(&all, 0.5));
        assert_eq!((weak, strong.is_reached()), (At(0.7), false));
        assert!(strong.value() > weak.value());
        assert_eq!(of(&four, 0.5), Above(2.0));
        assert_eq!(of(&[At(1.0), At(1.2), Above(2.0)], 0.5), At(1.2));
        // the structure that survived up to 0.3 may fall before 0.5
        assert_eq!(of(&[At(0.5), Above(0.3)], 0.0), Above(0.3));
        assert_eq!(of(&[At(0.5), Above(0.3)], 1.0), Above(0.5));
        assert_eq!(of(&[Above(1.0), At(1.0)], 0.0), At(1.0));
        assert_eq!(reached_quantile(&[], 0.5), None);
    }
}
