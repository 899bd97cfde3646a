//! A request for a motion, with its changes.

use dolmen::signal::Component;
use dolmen_project::MotionSize;

/// A requested motion: of the project file, a built-in one, or files. Settings here override those of the project file, and a scale multiplies
/// its size. The default requests none.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionRequest {
    /// A motion of the project file, or a built-in one.
    pub name: Option<String>,
    /// Files instead of a name, at most one for each component.
    pub files: Vec<GivenFile>,
    /// Unit of the numbers, if the files do not give it.
    pub unit: Option<String>,
    /// Time between samples, if the files do not give it, s.
    pub sample_step_s: Option<f64>,
    /// The channel to read from a file with several, by name or number.
    pub channel: Option<String>,
    /// The column or channel of each component, by name or number, for files with several.
    pub columns: Vec<(Component, String)>,
    /// Factor from the numbers to the unit.
    pub factor: f64,
    /// Instrument responses from networks (RESP): the value of a count for each channel.
    pub responses: Vec<GivenFile>,
    /// Cut components that begin at the same time to the shortest.
    pub shortest: bool,
    /// Ignore the peak in a header if it differs from that of the samples.
    pub ignore_stated_peak: bool,
    /// Azimuth for x, degrees clockwise from north, for channels with a stated direction.
    pub x_azimuth_deg: Option<f64>,
    /// Degree of the polynomial to subtract.
    pub baseline_degree: Option<usize>,
    /// Corner of the high-pass filter, Hz.
    pub high_pass_hz: Option<f64>,
    /// Length to keep from the start, s.
    pub keep_first_s: Option<f64>,
    /// Length of the tapers at both ends, s.
    pub taper_s: Option<f64>,
    /// Rotation from x towards y, degrees.
    pub turn_deg: Option<f64>,
    /// Factor on all components.
    pub scale: Option<f64>,
    /// Largest horizontal peak, to which all components are scaled: "0.3 g".
    pub peak: Option<String>,
}

/// An input file with its bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GivenFile {
    /// Its component; `None` means the one for its position among the files.
    pub component: Option<Component>,
    /// The file as the user named it.
    pub name: String,
    /// Its bytes.
    pub bytes: Vec<u8>,
}

impl Default for MotionRequest {
    fn default() -> Self {
        MotionRequest {
            name: None,
            files: Vec::new(),
            unit: None,
            sample_step_s: None,
            channel: None,
            columns: Vec::new(),
            factor: 1.0,
            responses: Vec::new(),
            shortest: false,
            ignore_stated_peak: false,
            x_azimuth_deg: None,
            baseline_degree: None,
            high_pass_hz: None,
            keep_first_s: None,
            taper_s: None,
            turn_deg: None,
            scale: None,
            peak: None,
        }
    }
}

impl MotionRequest {
    /// A motion by its name, without changes.
    pub fn named(name: &str) -> Self {
        MotionRequest {
            name: Some(name.to_owned()),
            ..MotionRequest::default()
        }
    }

    /// Whether a motion was requested.
    pub fn is_given(&self) -> bool {
        self.name.is_some() || !self.files.is_empty()
    }

    /// The first given flag for reading files, without its dashes; it has no effect on a motion from another source.
    pub fn of_files(&self) -> Option<&'static str> {
        [
            (self.unit.is_some(), "unit"),
            (self.sample_step_s.is_some(), "sample-step"),
            (self.channel.is_some(), "channel"),
            (!self.columns.is_empty(), "columns"),
            (self.factor != 1.0, "factor"),
            (!self.responses.is_empty(), "response"),
            (self.shortest, "shortest"),
            (self.ignore_stated_peak, "ignore-stated-peak"),
            (self.x_azimuth_deg.is_some(), "x-azimuth"),
        ]
        .into_iter()
        .find_map(|(is_given, flag)| is_given.then_some(flag))
    }

    /// Whether there are changes.
    pub fn is_changed(&self) -> bool {
        let numbers = [self.keep_first_s, self.taper_s, self.turn_deg, self.scale];
        let base_line = self.baseline_degree.is_some() || self.high_pass_hz.is_some();
        numbers.iter().any(Option::is_some) || self.peak.is_some() || base_line
    }
}

/// The size of the motion: a scale of the request multiplies the scale or the peak of the project file, as the levels of a study do; a peak
/// replaces them.
pub(super) fn acting_size(typed: Option<MotionSize>, given: Option<MotionSize>) -> Option<MotionSize> {
    match (typed, given) {
        (Some(MotionSize::Scale(typed)), Some(MotionSize::Scale(given))) => {
            Some(MotionSize::Scale(typed * given))
        }
        (Some(MotionSize::Scale(typed)), Some(MotionSize::Peak(given_m_s2))) => {
            Some(MotionSize::Peak(typed * given_m_s2))
        }
        (typed, given) => typed.or(given),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_a_typed_scale_multiplies_what_the_file_gives_and_a_typed_peak_replaces_it() {
        use MotionSize::{Peak, Scale};
        for (typed, given, acts) in [
            (Some(Scale(2.0)), Some(Scale(-1.5)), Some(Scale(-3.0))),
            (Some(Scale(2.0)), Some(Peak(0.75)), Some(Peak(1.5))),
            (Some(Scale(2.0)), None, Some(Scale(2.0))),
            (Some(Peak(2.0)), Some(Scale(3.0)), Some(Peak(2.0))),
            (None, Some(Scale(3.0)), Some(Scale(3.0))),
        ] {
            assert_eq!(acting_size(typed, given), acts, "{typed:?} {given:?}");
        }
    }
}
