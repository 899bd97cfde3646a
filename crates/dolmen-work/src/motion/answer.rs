//! What `dolmen motion` found.

use dolmen::signal::{
    Component, GroundMotion, IntensityMeasures, MatchedMotion, SpectralOrdinate, SpectrumMisfit,
};
use dolmen_records::motions::ComponentReading;

/// One series of accelerations with all that is known of it.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionSeries {
    /// What it is called: "x", or the name of the channel.
    pub name: String,
    /// The motion that it is part of.
    pub motion: GroundMotion,
    /// Which direction of it.
    pub component: Component,
    /// Its measures.
    pub measures: IntensityMeasures,
    /// Its response spectrum, if one was asked for.
    pub spectrum: Vec<SpectralOrdinate>,
}

/// A motion matched to a demand.
#[derive(Clone, Debug, PartialEq)]
pub struct MatchAnswer {
    /// What the demand is: the code with its year and parameters.
    pub demand: String,
    /// What came out.
    pub matched: MatchedMotion,
    /// How far the spectrum is from the demand below the shortest and above the longest period that is matched: nothing is done to it
    /// there.
    pub outside: [SpectrumMisfit; 2],
    /// Damping ratio of the spectra.
    pub damping_ratio: f64,
    /// The component that was matched.
    pub component: Component,
}

impl MatchAnswer {
    /// Root mean square of the misfit up to which a motion is called matched.
    pub const MISFIT_MOST: f64 = 0.025;
    /// Share by which no ordinate may fall short.
    pub const SHORT_MOST: f64 = 0.1;

    /// Whether the motion is matched within both.
    pub fn is_close(&self) -> bool {
        let after = &self.matched.after;
        after.root_mean_square <= Self::MISFIT_MOST && after.lowest >= -Self::SHORT_MOST
    }
}

/// Files, motions and their measures.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionReport {
    /// Each file with its channels, as read.
    pub files: Vec<(String, Vec<ComponentReading>)>,
    /// Each series, changed as its history says.
    pub series: Vec<MotionSeries>,
    /// The match, if one was asked for; the first series is then the matched motion.
    pub matched: Option<MatchAnswer>,
}
