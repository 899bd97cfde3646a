//! Results of `dolmen motion`.

use dolmen::signal::{
    Component, GroundMotion, IntensityMeasures, MatchedMotion, SpectralOrdinate, SpectrumMisfit,
};
use dolmen_records::motions::ComponentReading;

/// One series of accelerations and its properties.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionSeries {
    /// Its name: "x", or the name of the channel.
    pub name: String,
    /// The motion that contains it.
    pub motion: GroundMotion,
    /// Its direction in that motion.
    pub component: Component,
    /// Its measures.
    pub measures: IntensityMeasures,
    /// Its response spectrum, if requested.
    pub spectrum: Vec<SpectralOrdinate>,
}

/// A motion matched to a demand.
#[derive(Clone, Debug, PartialEq)]
pub struct MatchAnswer {
    /// Description of the demand: the code with its year and parameters.
    pub demand: String,
    /// The matched motion.
    pub matched: MatchedMotion,
    /// Difference between spectrum and demand below the shortest and above the longest matched period, where nothing was matched.
    pub outside: [SpectrumMisfit; 2],
    /// Damping ratio of the spectra.
    pub damping_ratio: f64,
    /// The component that was matched.
    pub component: Component,
}

impl MatchAnswer {
    /// Largest allowed root mean square misfit of a matched motion.
    pub const MISFIT_MOST: f64 = 0.025;
    /// Largest allowed relative shortfall of an ordinate.
    pub const SHORT_MOST: f64 = 0.1;

    /// Whether the motion meets both limits.
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
    /// The match, if requested; the first series is then the matched motion.
    pub matched: Option<MatchAnswer>,
}
