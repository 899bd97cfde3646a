//! Notes on the result of an identification.

use super::LeftOut;
use super::stiffness_words::{Misfit, OfSpring, Proportion, Spring, Thoroughness, counted};
use std::fmt;

/// A note on the stiffnesses found. Its `Display` is an English sentence.
#[derive(Clone, Debug, PartialEq)]
pub enum StiffnessNote {
    /// Two storeys with springs between them cannot have such close frequencies.
    RatioBelowLeast {
        /// Measured f2/f1.
        ratio: f64,
        /// Smallest possible f2/f1, √(1 + m2/m1) + √(m2/m1).
        ratio_least: f64,
    },
    /// Two grounded storeys coupled by P-delta cannot have such close frequencies.
    DifferenceBelowLeast {
        /// Measured ω2² − ω1², rad²/s².
        difference_rad2_s2: f64,
        /// 2 (N2/l2)/√(m1 m2), rad²/s².
        difference_least_rad2_s2: f64,
    },
    /// No complex solution is real and positive.
    NoneReal {
        /// Frequencies given.
        frequencies: usize,
        /// Number of complex solutions.
        solutions_complex: usize,
    },
    /// Some complex solutions nearly coincide: a real solution may be missing.
    NotAllSeparated {
        /// Number of separate solutions.
        separated: usize,
        /// Expected number.
        expected: usize,
    },
    /// The search found no stiffness that explains the data.
    NoneExplains {
        /// Kind of element with the stiffness.
        spring: Spring,
        /// Starting points tried.
        starts: usize,
        /// Modes given.
        modes: usize,
        /// Misfit of the nearest set.
        misfit: Misfit,
    },
    /// The structure is unstable with every stiffness found.
    NoneStands {
        /// Kind of element with the stiffness.
        spring: Spring,
    },
    /// There are enough data, but some stiffness has no effect on them.
    FitLeavesFree {
        /// Kind of element with the stiffness.
        spring: Spring,
    },
    /// There are fewer independent data than stiffnesses.
    TooFewData {
        /// Kind of element with the stiffness.
        spring: Spring,
        /// Number of unknown stiffnesses.
        springs: usize,
        /// Frequencies given.
        frequencies: usize,
        /// Whether the data include points of shapes.
        with_shapes: bool,
        /// Number of independent data.
        independent: usize,
        /// Proportion that replaces the missing data.
        proportion: Proportion,
    },
    /// Several sets explain the data equally well.
    SeveralExplain {
        /// Kind of element with the stiffness.
        spring: Spring,
        /// Number of sets.
        sets: usize,
        /// Thoroughness of the search.
        thoroughness: Thoroughness,
        /// Whether the data include points of shapes.
        with_shapes: bool,
    },
    /// One set was found, but others were not ruled out.
    OneWithoutProof {
        /// Kind of element with the stiffness.
        spring: Spring,
        /// Starting points tried.
        starts: usize,
    },
    /// Solutions come in pairs, but one has no partner.
    OddCount {
        /// Kind of element with the stiffness.
        spring: Spring,
    },
    /// Not all solutions are listed.
    ListCut {
        /// Number found.
        found: usize,
        /// Number listed.
        listed: usize,
    },
    /// A shape with a single point has no information, because its scale is free.
    OneShapePoint {
        /// The mode, from 1.
        mode: usize,
    },
    /// Standard deviations were assumed for data without any.
    DeviationsAssumed {
        /// Standard deviation of a frequency, relative.
        frequency: f64,
        /// Standard deviation of a shape, relative to the largest displacement of the mode.
        shape: f64,
    },
    /// No interval can be given without standard deviations.
    NoInterval {
        /// Misfit of the best set.
        misfit: Misfit,
    },
    /// A change of the stiffnesses that does not change the data.
    FreeDirection {
        /// Kind of element with the stiffness.
        spring: Spring,
        /// Change of ln k of each spring that takes part.
        components: Vec<OfSpring>,
    },
    /// Some stiffnesses are determined only to an order of magnitude.
    WideIntervals {
        /// Kind of element with the stiffness.
        spring: Spring,
        /// Standard deviation of ln k of each spring.
        relative_sd: Vec<OfSpring>,
    },
    /// Some stiffnesses barely change the data.
    Unseen {
        /// Kind of element with the stiffness.
        spring: Spring,
        /// Numbers of these springs, from 1.
        numbers: Vec<usize>,
    },
    /// Two solutions coincide, or are so close that the scatter of the frequencies can turn one into the
    /// other.
    SolutionsMeet {
        /// Kind of element with the stiffness.
        spring: Spring,
    },
    /// A shape without standard deviations is not reproduced exactly.
    ShapeOff {
        /// The mode, from 1.
        mode: usize,
        /// Largest difference of a point, as a share of the largest displacement of the mode.
        difference: f64,
    },
    /// A solution disappears within its stated range of frequencies.
    RangeIncomplete {
        /// Numbers of these solutions in the list, from 1.
        solutions: Vec<usize>,
    },
    /// The moments of inertia of a chain are not given.
    ThinRods,
    /// A linear side support is part of the model.
    SideSupportTaken,
    /// A side support with a gap is left out.
    SideSupportWithGap,
    /// No axial force is given for a frame.
    NoAxialForce,
    /// Ties are part of the model of a frame.
    TiesTaken,
    /// A mode of the record is not a mode of the direction.
    LeftOut(LeftOut),
    /// A mode that the user declared torsional is left out.
    Twists {
        /// Its frequency, Hz.
        frequency_hz: f64,
    },
    /// The modes used are assumed to be the lowest of their direction.
    TakenAsLowest {
        /// Number of modes.
        modes: usize,
        /// Name of the direction.
        direction: String,
    },
}

impl fmt::Display for StiffnessNote {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::RatioBelowLeast { ratio, ratio_least } => write!(
                f,
                "No stiffness gives these two frequencies: their ratio r = f2/f1 is {ratio:.4}, so r + 1/r is {:.4}, but \
                 two storeys on springs between them need r + 1/r ≥ 2√(1 + m2/m1) = {:.4}, a ratio of {ratio_least:.4} at \
                 least. Check the masses, and whether both modes move in this direction without twisting.",
                ratio + 1.0 / ratio,
                ratio_least + 1.0 / ratio_least
            ),
            Self::DifferenceBelowLeast {
                difference_rad2_s2,
                difference_least_rad2_s2,
            } => write!(
                f,
                "No stiffness gives these two frequencies: ω2² − ω1² is {difference_rad2_s2:.4} (rad/s)², but two storeys \
                 on grounded springs whose P-delta joins them need 2 (N2/l2)/√(m1 m2) = {difference_least_rad2_s2:.4} at \
                 least."
            ),
            Self::NoneReal {
                frequencies,
                solutions_complex,
            } => write!(
                f,
                "No stiffness gives {}: none of the solutions in complex numbers ({solutions_complex}) is real and \
                 positive. Check the masses, and whether every mode moves in this direction without twisting.",
                match frequencies {
                    1 => "this frequency".to_string(),
                    n => format!("these {n} frequencies"),
                }
            ),
            Self::NotAllSeparated { separated, expected } => write!(
                f,
                "Only {separated} of {expected} solutions in complex numbers were separated: some nearly coincide. A real \
                 one may be missing beside those given."
            ),
            Self::NoneExplains {
                spring,
                starts,
                modes,
                misfit,
            } => none_explains(f, *spring, *starts, *modes, *misfit),
            Self::NoneStands { spring } => write!(
                f,
                "No {spring} stiffness was found at which the {} stands.",
                match spring {
                    Spring::Joint => "chain",
                    Spring::Storey => "frame",
                }
            ),
            Self::FitLeavesFree { spring } => write!(
                f,
                "The best fit leaves some {spring} stiffness free: beyond some value, more of it changes no datum. The \
                 set shown is one of many that fit as well."
            ),
            Self::TooFewData {
                spring,
                springs,
                frequencies,
                with_shapes,
                independent,
                proportion,
            } => write!(
                f,
                "{}{} {} {} for {}: they cannot be determined. The set shown fits the data and is the nearest to \
                 stiffness in proportion to {proportion}, an assumption and not a measurement. Measure more modes, or \
                 shapes at several heights.",
                counted(*frequencies, "frequency", "frequencies"),
                if *with_shapes { " with shape points" } else { "" },
                if *frequencies == 1 { "gives" } else { "give" },
                counted(*independent, "independent datum", "independent data"),
                format_args!("{springs} {spring} stiffnesses"),
            ),
            Self::SeveralExplain {
                spring,
                sets,
                thoroughness,
                with_shapes,
            } => {
                write!(
                    f,
                    "{sets} sets of {spring} stiffness explain the data equally well and all stand ({thoroughness}). "
                )?;
                if *with_shapes {
                    f.write_str(
                        "These data cannot tell them apart: measure the shapes at more heights or in more modes.",
                    )
                } else {
                    write!(
                        f,
                        "Frequencies alone cannot tell them apart: measure the shapes too, best with a sensor near each \
                         {spring}."
                    )
                }
            }
            Self::OneWithoutProof { spring, starts } => write!(
                f,
                "Only one set of {spring} stiffness was found from {}, but frequencies alone often have several: this is \
                 no proof.",
                counted(*starts, "start", "starts")
            ),
            Self::OddCount { spring } => write!(
                f,
                "Their number is odd, but as many frequencies as {spring}s have an even number of solutions: at least one \
                 more exists and was not found. Raise starts."
            ),
            Self::ListCut { found, listed: 1 } => {
                write!(f, "{found} solutions were found; the first is listed.")
            }
            Self::ListCut { found, listed } => {
                write!(f, "{found} solutions were found; the first {listed} are listed.")
            }
            Self::OneShapePoint { mode } => write!(
                f,
                "Mode {mode} has one shape point: its scale is free, so it says nothing and is left out."
            ),
            Self::DeviationsAssumed { frequency, shape } => write!(
                f,
                "Data without a standard deviation were given {} % of a frequency and {} % of the largest displacement of \
                 a mode, an assumption.",
                100.0 * frequency,
                100.0 * shape
            ),
            Self::NoInterval { misfit } => write!(
                f,
                "The best set is off by {misfit}; without standard deviations of the modes no interval can be given."
            ),
            Self::FreeDirection { spring, components } => {
                f.write_str("Free: changes of ln k in the proportions ")?;
                each(f, components, |f, c| write!(f, "{spring} {} {:+.2}", c.number, c.value))?;
                f.write_str(" leave all data unchanged (to first order).")
            }
            Self::WideIntervals { spring, relative_sd } => {
                f.write_str(
                    "The data determine some stiffnesses only to an order of magnitude (standard deviation of ",
                )?;
                each(f, relative_sd, |f, c| {
                    write!(f, "{spring} {} by {:.0} %", c.number, 100.0 * c.value)
                })?;
                f.write_str(").")
            }
            Self::Unseen { spring, numbers } => {
                let one = numbers.len() == 1;
                write!(f, "The sensors hardly see {spring}{} ", if one { "" } else { "s" })?;
                each(f, numbers, |f, number| write!(f, "{number}"))?;
                let whose = if one { "its" } else { "their" };
                write!(f, ": the data would barely change with {whose} stiffness.")
            }
            Self::SolutionsMeet { spring } => write!(
                f,
                "Next to a double root: two sets of {spring} stiffness meet here, or so nearly that the scatter of the \
                 frequencies moves one into the other. No linear interval exists. Measure a shape."
            ),
            Self::ShapeOff { mode, difference } => write!(
                f,
                "The shape of mode {mode}, given without standard deviations, is off by up to {:.1} % of its largest \
                 displacement.",
                100.0 * difference
            ),
            Self::RangeIncomplete { solutions } => {
                let one = solutions.len() == 1;
                write!(f, "The range of solution{} ", if one { "" } else { "s" })?;
                each(f, solutions, |f, number| write!(f, "{number}"))?;
                f.write_str(
                    " is incomplete: not everywhere within that range do these frequencies have a solution.",
                )
            }
            Self::ThinRods => f.write_str(
                "Moments of inertia that were not given are those of thin rods, which are low: stiffness comes out low \
                 too.",
            ),
            Self::SideSupportTaken => {
                f.write_str("Side supports without a gap are part of the model, their stiffness taken as given.")
            }
            Self::SideSupportWithGap => f.write_str(
                "Side supports with a gap are left out: the chain is taken not to touch them while it vibrates.",
            ),
            Self::NoAxialForce => {
                f.write_str("No axial force is given: P-delta is left out, so stiffness comes out low.")
            }
            Self::TiesTaken => f.write_str("The ties are part of the model, their stiffness taken as given."),
            Self::LeftOut(why) => write!(f, "{why}"),
            Self::Twists { frequency_hz } => write!(
                f,
                "The mode at {frequency_hz} Hz twists in plan and is kept out of the fit."
            ),
            Self::TakenAsLowest { modes: 1, direction } => write!(
                f,
                "The one mode used is taken as the lowest of direction {direction}: if one below it was missed, every \
                 stiffness is wrong."
            ),
            Self::TakenAsLowest { modes, direction } => write!(
                f,
                "The {modes} modes used are taken as the lowest of direction {direction}, none missed between them: if \
                 one was, every stiffness is wrong."
            ),
        }
    }
}

fn none_explains(
    f: &mut fmt::Formatter<'_>,
    spring: Spring,
    starts: usize,
    modes: usize,
    misfit: Misfit,
) -> fmt::Result {
    let from = counted(starts, "start", "starts");
    let (explained, check) = match modes {
        1 => ("mode".to_string(), "it is the lowest mode of its direction"),
        n => (
            format!("{n} modes"),
            "they are the lowest modes of one direction with none left out between them",
        ),
    };
    write!(
        f,
        "No {spring} stiffness was found, from {from}, that explains the {explained}: the nearest is off by {misfit}. \
         Check that {check}, and the masses."
    )
}

fn each<T>(
    f: &mut fmt::Formatter<'_>,
    items: &[T],
    write_one: impl Fn(&mut fmt::Formatter<'_>, &T) -> fmt::Result,
) -> fmt::Result {
    for (i, item) in items.iter().enumerate() {
        if i > 0 {
            f.write_str(", ")?;
        }
        write_one(f, item)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_one_is_said_in_the_singular() {
        let spring = Spring::Joint;
        let misfit = Misfit::Relative(0.01);
        for (note, sentence) in [
            (
                StiffnessNote::NoneReal {
                    frequencies: 1,
                    solutions_complex: 1,
                },
                "No stiffness gives this frequency: none of the solutions in complex numbers (1) is real",
            ),
            (
                StiffnessNote::NoneExplains {
                    spring,
                    starts: 1,
                    modes: 1,
                    misfit,
                },
                "No joint stiffness was found, from 1 start, that explains the mode: the nearest is off by 1.00 % (root \
                 mean square). Check that it is the lowest mode of its direction, and the masses.",
            ),
            (
                StiffnessNote::TooFewData {
                    spring,
                    springs: 5,
                    frequencies: 1,
                    with_shapes: false,
                    independent: 1,
                    proportion: Proportion::WeightMoment,
                },
                "1 frequency gives 1 independent datum for 5 joint stiffnesses: they cannot be determined.",
            ),
            (
                StiffnessNote::Unseen {
                    spring,
                    numbers: vec![3],
                },
                "The sensors hardly see joint 3: the data would barely change with its stiffness.",
            ),
            (
                StiffnessNote::TakenAsLowest {
                    modes: 1,
                    direction: "x".into(),
                },
                "The one mode used is taken as the lowest of direction x: ",
            ),
        ] {
            let said = note.to_string();
            assert!(said.starts_with(sentence), "{said}");
        }
    }
}
