//! Observations of a structure under shaking of a given size, and their bounds if no curve can be fitted.

use super::bound::{FragilityBound, LEFT_OUT};
use crate::assess::AssessError;

/// An observation. Intensities are positive, with one unit for all observations of a fit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Observation {
    /// At one intensity, `reached` of `motions` reached the state: a stripe.
    Stripe {
        /// The intensity.
        intensity: f64,
        /// Number of motions run at this intensity.
        motions: usize,
        /// Number of motions that reached the state.
        reached: usize,
    },
    /// A motion first reached the state at exactly this intensity.
    At(f64),
    /// A motion did not reach the state up to the largest tried intensity.
    Above(f64),
    /// A motion reached the state above the first and at or below the second intensity.
    Between(f64, f64),
    /// A motion reached the state at the smallest tried intensity.
    Below(f64),
}

impl Observation {
    pub(super) fn motions(&self) -> usize {
        match self {
            Observation::Stripe { motions, .. } => *motions,
            _ => 1,
        }
    }

    pub(super) fn reached(&self) -> usize {
        match self {
            Observation::Stripe { reached, .. } => *reached,
            Observation::Above(_) => 0,
            _ => 1,
        }
    }

    pub(super) fn intensities(&self) -> [f64; 2] {
        match *self {
            Observation::Stripe { intensity: x, .. }
            | Observation::At(x)
            | Observation::Above(x)
            | Observation::Below(x) => [x, x],
            Observation::Between(low, high) => [low, high],
        }
    }

    /// # Errors
    /// [`AssessError::Observation`].
    pub(super) fn check(&self, number: usize) -> Result<(), AssessError> {
        let refuse = |given: f64, allowed| {
            Err(AssessError::Observation {
                number,
                given,
                allowed,
            })
        };
        let [low, high] = self.intensities();
        for x in [low, high] {
            if !(x > 0.0 && x.is_finite()) {
                return refuse(x, "a positive intensity");
            }
        }
        if low > high {
            return refuse(low, "below the end of its interval");
        }
        match *self {
            Observation::Stripe { motions: 0, .. } => refuse(0.0, "of one motion or more"),
            Observation::Stripe { motions, reached, .. } if reached > motions => {
                refuse(reached as f64, "no more than its motions that reached the state")
            }
            _ => Ok(()),
        }
    }
}

/// Bound for observations of which none, or all, reached the state; otherwise `None`.
pub(super) fn bound(observations: &[Observation]) -> Option<FragilityBound> {
    let motions: usize = observations.iter().map(Observation::motions).sum();
    let reached: usize = observations.iter().map(Observation::reached).sum();
    let tail = |motions: usize| LEFT_OUT.powf(1.0 / motions as f64);
    let stripes = || {
        observations
            .iter()
            .filter(|o| matches!(o, Observation::Stripe { .. }))
    };
    let single = || {
        observations
            .iter()
            .filter(|o| !matches!(o, Observation::Stripe { .. }))
    };
    let intensity = |o: &Observation| o.intensities()[1];
    if reached == 0 {
        // single motions all went up to the smallest of their ends; for stripes, which share the motions, the strongest counts
        let ends = single().map(intensity).fold(f64::INFINITY, f64::min);
        let strongest = stripes().max_by(|a, b| intensity(a).total_cmp(&intensity(b)));
        let (intensity, motions) = match strongest {
            Some(stripe) => (intensity(stripe), stripe.motions()),
            None => (ends, motions),
        };
        return Some(FragilityBound::NoneReached {
            intensity,
            motions,
            probability_most: 1.0 - tail(motions),
        });
    }
    let only_below = |o: &Observation| matches!(o, Observation::Stripe { .. } | Observation::Below(_));
    if reached == motions && observations.iter().all(only_below) {
        let starts = single().map(intensity).fold(0.0, f64::max);
        let weakest = stripes().min_by(|a, b| intensity(a).total_cmp(&intensity(b)));
        let (intensity, motions) = match weakest {
            Some(stripe) => (intensity(stripe), stripe.motions()),
            None => (starts, motions),
        };
        return Some(FragilityBound::AllReached {
            intensity,
            motions,
            probability_least: tail(motions),
        });
    }
    separated(observations)
}

/// Relative difference up to which two intensities count as equal: peaks that are products of a record and a factor differ by rounding. Our
/// choice.
const SAME: f64 = 1e-9;

/// The largest survived intensity, and the smallest at which the state was reached.
pub(super) fn extent(observations: &[Observation]) -> (f64, f64) {
    let (mut survived, mut reached) = (0.0_f64, f64::INFINITY);
    for observation in observations {
        match *observation {
            Observation::Stripe {
                intensity,
                motions,
                reached: own,
            } => {
                if own < motions {
                    survived = survived.max(intensity);
                }
                if own > 0 {
                    reached = reached.min(intensity);
                }
            }
            Observation::Above(x) => survived = survived.max(x),
            Observation::Below(x) => reached = reached.min(x),
            Observation::Between(low, high) => {
                survived = survived.max(low);
                reached = reached.min(high);
            }
            Observation::At(x) => (survived, reached) = (survived.max(x), reached.min(x)),
        }
    }
    (survived, reached)
}

/// Interval of the median capacity: from the lower median of the lower ends of all brackets to the upper median of their upper ends.
pub(super) fn middle_capacity(observations: &[Observation]) -> FragilityBound {
    let (mut lower, mut upper) = (Vec::new(), Vec::new());
    let mut add = |count: usize, low: f64, high: f64| {
        lower.extend(std::iter::repeat_n(low, count));
        upper.extend(std::iter::repeat_n(high, count));
    };
    for observation in observations {
        match *observation {
            Observation::Stripe {
                intensity,
                motions,
                reached,
            } => {
                add(reached, 0.0, intensity);
                add(motions - reached, intensity, f64::INFINITY);
            }
            Observation::Above(x) => add(1, x, f64::INFINITY),
            Observation::Below(x) => add(1, 0.0, x),
            Observation::Between(low, high) => add(1, low, high),
            Observation::At(x) => add(1, x, x),
        }
    }
    lower.sort_by(f64::total_cmp);
    upper.sort_by(f64::total_cmp);
    let count = lower.len();
    FragilityBound::Middle {
        above: lower.get(count.saturating_sub(1) / 2).copied().unwrap_or(0.0),
        at_most: upper.get(count / 2).copied().unwrap_or(f64::INFINITY),
    }
}

/// Whether the intensity alone separates survivors from failures. Then the likelihood is largest for β → 0, and there is no curve.
fn separated(observations: &[Observation]) -> Option<FragilityBound> {
    let (survived, reached) = extent(observations);
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for observation in observations {
        if let Observation::At(x) = *observation {
            (least, most) = (least.min(x), most.max(x));
        }
    }
    // capacities at two or more intensities have a scatter; a single intensity has none
    let apart = survived <= reached * (1.0 + SAME) && least * (1.0 + SAME) >= most;
    let touch = survived * (1.0 + SAME) >= reached && most == 0.0;
    apart.then(|| match touch {
        true => middle_beside(observations, reached),
        false => FragilityBound::Separated {
            survived: survived.min(reached),
            reached,
        },
    })
}

/// Interval of the median capacity if some motions reach the state at one intensity and others do not, none below it and all above it.
fn middle_beside(observations: &[Observation], intensity: f64) -> FragilityBound {
    let (mut before, mut after) = (0.0_f64, f64::INFINITY);
    let (mut reached_there, mut not_there) = (0, 0);
    for observation in observations {
        let Observation::Stripe {
            intensity: at,
            motions,
            reached,
        } = *observation
        else {
            return middle_capacity(observations);
        };
        if (at / intensity - 1.0).abs() <= SAME {
            (reached_there, not_there) = (reached_there + reached, not_there + motions - reached);
        } else if at < intensity {
            before = before.max(at);
        } else {
            after = after.min(at);
        }
    }
    FragilityBound::Middle {
        above: if reached_there < not_there {
            intensity
        } else {
            before
        },
        at_most: if reached_there > not_there {
            intensity
        } else {
            after
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stripe(intensity: f64, motions: usize, reached: usize) -> Observation {
        Observation::Stripe {
            intensity,
            motions,
            reached,
        }
    }

    #[test]
    fn exact_the_middle_of_overlapping_brackets() {
        // sorted ends 0 .1 .2 .9 and .15 1 2 3: two of four lie above .1, two at or below 2
        let wide = [
            Observation::Between(0.1, 1.0),
            Observation::Between(0.2, 2.0),
            Observation::Between(0.9, 3.0),
            Observation::Below(0.15),
        ];
        let between = |above, at_most| FragilityBound::Middle { above, at_most };
        assert_eq!(middle_capacity(&wide), between(0.1, 2.0));
        assert_eq!(middle_capacity(&[stripe(0.3, 5, 1)]), between(0.3, f64::INFINITY));
        assert_eq!(middle_capacity(&[stripe(0.3, 4, 2)]), between(0.0, f64::INFINITY));
        assert_eq!(middle_capacity(&[Observation::At(0.4)]), between(0.4, 0.4));
    }

    #[test]
    fn exact_bounds_of_none_and_all() {
        // the rule of three: 1 − 0.05^(1/n), 3/n for many
        let none = bound(&[stripe(0.2, 22, 0), stripe(0.6, 22, 0)]).unwrap();
        let FragilityBound::NoneReached {
            intensity,
            motions,
            probability_most,
        } = none
        else {
            panic!("{none:?}");
        };
        assert_eq!((intensity, motions), (0.6, 22));
        assert!(
            (probability_most - 0.127_305_4).abs() < 1e-6,
            "{probability_most}"
        );
        assert!(matches!(
            bound(&[
                Observation::Above(1.0),
                Observation::Above(0.8),
                Observation::Above(2.0)
            ]),
            Some(FragilityBound::NoneReached {
                intensity: 0.8,
                motions: 3,
                ..
            })
        ));
        assert!(matches!(
            bound(&[stripe(0.2, 22, 22), stripe(0.6, 22, 22)]),
            Some(FragilityBound::AllReached { intensity: 0.2, motions: 22, probability_least }) if (probability_least - 0.872_694_6).abs() < 1e-6
        ));
    }

    #[test]
    fn holds_what_is_told_apart_by_size_alone_has_no_curve() {
        let separated = |survived, reached| FragilityBound::Separated { survived, reached };
        let middle = |above, at_most| FragilityBound::Middle { above, at_most };
        // one peak in two records, one ulp apart
        let next_up = 0.37_f64.next_up();
        for (told_apart, expected) in [
            (vec![stripe(0.2, 5, 0), stripe(0.4, 5, 5)], separated(0.2, 0.4)),
            (
                vec![
                    Observation::Above(0.3),
                    Observation::Below(0.5),
                    Observation::Above(0.4),
                ],
                separated(0.4, 0.5),
            ),
            (vec![Observation::At(0.3); 4], separated(0.3, 0.3)),
            (
                vec![Observation::Between(0.3, 0.4), Observation::Between(0.35, 0.45)],
                separated(0.35, 0.4),
            ),
            (
                vec![Observation::At(0.37), Observation::At(next_up)],
                separated(0.37, 0.37),
            ),
            // two, three or half of the motions reach it at 0.4: the median is above it, at most it, or on either side
            (
                vec![stripe(0.2, 5, 0), stripe(0.4, 5, 2), stripe(0.6, 5, 5)],
                middle(0.4, 0.6),
            ),
            (
                vec![stripe(0.2, 5, 0), stripe(0.4, 5, 3), stripe(0.6, 5, 5)],
                middle(0.2, 0.4),
            ),
            (
                vec![stripe(0.2, 4, 0), stripe(0.4, 4, 2), stripe(0.6, 4, 4)],
                middle(0.2, 0.6),
            ),
            (
                vec![
                    Observation::Between(0.2, 0.37),
                    Observation::Between(next_up, 0.9),
                    Observation::Above(0.37),
                ],
                middle(0.37, 0.9),
            ),
            // one of four motions reaches it at 0.5, the others at 0.8
            (
                [
                    vec![Observation::Between(0.2, 0.5)],
                    vec![Observation::Between(0.5, 0.8); 3],
                ]
                .concat(),
                middle(0.5, 0.8),
            ),
        ] {
            assert_eq!(bound(&told_apart), Some(expected), "{told_apart:?}");
        }
        for overlapping in [
            vec![stripe(0.2, 5, 1), stripe(0.4, 5, 4)],
            vec![Observation::At(0.3), Observation::At(0.31)],
            vec![Observation::Between(0.3, 0.4), Observation::Between(0.5, 0.6)],
            vec![Observation::At(0.3), Observation::Above(0.5)],
        ] {
            assert_eq!(bound(&overlapping), None, "{overlapping:?}");
        }
    }
}
