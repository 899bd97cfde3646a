//! Why a motion that is asked for cannot be had.

use crate::known::known_beside;
use dolmen::signal::Component;
use thiserror::Error;

/// Why a motion that is asked for cannot be had.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum MotionRequestError {
    /// There is no such motion.
    #[error(
        "there is no motion \"{name}\": known are {}; other motions come from files with --motion-file, or stand in the project file as \
         [motion.{name}]",
        known_beside(name, known)
    )]
    NoSuchMotion {
        /// The name.
        name: String,
        /// Those there are.
        known: String,
    },
    /// There is no such motion among those that Dolmen carries.
    #[error(
        "there is no built-in motion \"{name}\": known are {}",
        known_beside(name, known)
    )]
    NoBuiltInMotion {
        /// The name.
        name: String,
        /// Those there are.
        known: String,
    },
    /// No motion is asked for.
    #[error(
        "no motion is given: name files (`dolmen simulate`: with --motion-file), or take --motion {known}"
    )]
    NoMotion {
        /// Those there are.
        known: String,
    },
    /// What is left after all changes is no ground motion.
    #[error(
        "the motion that would act has a peak of {peak_g:.3} g, but must have more than 0 and at most {most_g} g, twice what was ever recorded: \
         correct --scale, --peak, the unit or the factor"
    )]
    Acts {
        /// Its peak, g.
        peak_g: f64,
        /// The largest allowed, g.
        most_g: f64,
    },
    /// Two files are of one component.
    #[error("--motion-file: the {component} component is given twice; name each as in {component}=FILE")]
    ComponentTwice {
        /// The component.
        component: Component,
    },
    /// A text is no acceleration.
    #[error("\"{given}\" is no acceleration: write it as \"0.3 g\" or \"2.94 m/s2\"")]
    NoAcceleration {
        /// The text.
        given: String,
    },
    /// An acceleration has no unit.
    #[error("\"{given}\" has no unit: write \"{value} g\" or \"{value} m/s2\"")]
    AccelerationWithoutUnit {
        /// The text.
        given: String,
        /// Its number.
        value: f64,
    },
    /// A site is no ground of Eurocode 8.
    #[error("--site is \"{given}\", but a ground of Eurocode 8 is A, B, C, D or E")]
    NoEurocodeGround {
        /// The text.
        given: String,
    },
    /// A site is none of KDS 17 10 00.
    #[error(
        "--site is \"{given}\", but a site of KDS 17 10 00 is S1 to S5; for Eurocode 8 give --ground-acceleration too"
    )]
    NoKoreanSite {
        /// The text.
        given: String,
    },
    /// Nothing is there to be matched.
    #[error("no motion is given to match")]
    NothingToMatch,
    /// Several channels could be matched.
    #[error(
        "the file has several channels: name the one to match with --channel, or turn them to x and y with --x-azimuth"
    )]
    SeveralToMatch,
}
