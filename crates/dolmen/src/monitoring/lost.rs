//! Modes that surveys showed regularly and the last ones do not: what falls further than a mode is looked for leaves nothing to be judged.

use super::history::{History, HistorySurvey};
use super::tracking::{Jumped, Track};

/// Surveys that could have shown a mode before it can be missed. Chosen here.
const SURVEYS_LEAST: usize = 5;
/// Probability of missing so many surveys by chance below which it is an alarm. Chosen here: two surveys running of a mode that twenty showed.
const CHANCE_MOST: f64 = 0.005;
/// Modes missed more often than this say nothing together with others: one poor record misses them all. Chosen here.
const REGULAR_FROM: f64 = 0.15;

/// A mode that the last surveys do not show.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LostMode {
    /// Index of the mode.
    pub mode: usize,
    /// The first of the surveys that miss it.
    pub since: usize,
    /// How many surveys miss it that could show it.
    pub missed: usize,
    /// In how many it was found before,
    pub found: usize,
    /// of how many that could show it.
    pub of: usize,
    /// Probability of missing it so often by chance.
    pub chance: f64,
    /// Frequency of a mode of like shape that began since, Hz.
    pub began_hz: Option<f64>,
}

impl LostMode {
    /// Whether it was found in nearly every survey.
    fn is_regular(&self) -> bool {
        let missed = (self.of - self.found + 1) as f64;
        missed / (self.of + 2) as f64 <= REGULAR_FROM
    }
}

/// Whether what is lost is beyond chance: one mode alone, or regular ones together.
pub(super) fn is_beyond_chance(lost: &[LostMode]) -> bool {
    let together: f64 = lost
        .iter()
        .filter(|of| of.is_regular())
        .map(|of| of.chance)
        .product();
    lost.iter().any(|of| of.chance <= CHANCE_MOST) || together <= CHANCE_MOST
}

/// The modes that the last surveys miss.
///
/// ```text
/// p = ((n − f + 1)/(n + 2))^k        f of n surveys showed it, then k did not: each misses it as often as before (Laplace's rule)
/// ```
///
/// A survey counts if it has a mode in the direction of the one that is missed, or of none: who measured along y alone misses nothing along x. Directions that
/// no survey had while the mode was found count as well: they may be the same under new names.
/// `answered`: whether somebody looked at the structure since a survey.
pub(super) fn lost(
    history: &History,
    tracks: &[Track],
    jumped: &[Jumped],
    answered: impl Fn(usize) -> bool,
) -> Vec<LostMode> {
    let each = tracks.iter().enumerate().filter_map(|(mode, track)| {
        let last = track.modes.iter().rposition(Option::is_some)?;
        let surveys = &history.surveys;
        let is_known = |direction: &str| {
            let mut before = surveys[..=last].iter().flat_map(|survey| &survey.modes);
            before.any(|mode| mode.direction.as_deref() == Some(direction))
        };
        let could = |survey: &HistorySurvey| {
            survey
                .modes
                .iter()
                .any(|other| match (&track.direction, &other.direction) {
                    // of another name than any before: the directions were named anew, or others measured
                    (Some(own), Some(other)) => own == other || !is_known(other),
                    _ => true,
                })
        };
        let of = surveys[..=last].iter().filter(|survey| could(survey)).count();
        let after = || (last + 1..surveys.len()).filter(|i| could(&surveys[*i]));
        let (since, missed, found) = (after().next()?, after().count(), track.found());
        if of < SURVEYS_LEAST || answered(since) {
            return None;
        }
        let each_misses = (of.saturating_sub(found) + 1) as f64 / (of + 2) as f64;
        let began = jumped
            .iter()
            .filter(|of| of.at >= since && of.from_hz == track.frequency_hz);
        Some(LostMode {
            mode,
            since,
            missed,
            found: found.min(of),
            of,
            chance: each_misses.powi(missed.min(1000) as i32),
            began_hz: began.map(|of| of.to_hz).next(),
        })
    });
    each.collect()
}
