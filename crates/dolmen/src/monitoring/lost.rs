//! Modes that were found regularly in earlier surveys but not in the last ones. A mode that changes beyond the search range leaves no frequency
//! to judge.

use super::history::{History, HistorySurvey};
use super::tracking::{Jumped, Track};

/// Fewest surveys that could have shown a mode before it can count as missing. Our choice.
const SURVEYS_LEAST: usize = 5;
/// Probability of so many surveys without the mode by chance, below which there is an alarm, however rare surveys are. Our choice.
const CHANCE_MOST: f64 = 0.005;
/// Fraction of surveys without a mode above which it is not tested together with other modes. Our choice.
const REGULAR_FROM: f64 = 0.15;

/// A mode missing in the last surveys.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LostMode {
    /// Index of the mode.
    pub mode: usize,
    /// The first of the surveys without it.
    pub since: usize,
    /// Number of surveys that could show it but do not.
    pub missed: usize,
    /// Number of earlier surveys with the mode,
    pub found: usize,
    /// out of this number that could show it.
    pub of: usize,
    /// The largest number of successive earlier surveys without it.
    pub gap: usize,
    /// Probability of so many surveys without it by chance.
    pub chance: f64,
    /// Whether each survey without it has a mode that no earlier survey had, which shows that the record was not poor.
    pub is_replaced: bool,
    /// Frequency of a mode with a similar shape that began later, Hz.
    pub began_hz: Option<f64>,
}

impl LostMode {
    /// Whether it was found in nearly every survey.
    fn is_regular(&self) -> bool {
        let missed = (self.of - self.found + 1) as f64;
        missed / (self.of + 2) as f64 <= REGULAR_FROM
    }
}

/// A mode that the last surveys cannot show, as they have no mode along its direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnseenMode {
    /// Index of the mode.
    pub mode: usize,
    /// The last survey with the mode.
    pub last: usize,
}

/// Modes along directions in which the last surveys have no mode at all, for more surveys in a row than ever before. Of such a mode nothing is known
/// since; that it is absent is no evidence, as nothing shows that the direction was measured.
pub(super) fn unseen(history: &History, tracks: &[Track]) -> Vec<UnseenMode> {
    let surveys = &history.surveys;
    let each = tracks.iter().enumerate().filter_map(|(mode, track)| {
        let last = track.modes.iter().rposition(Option::is_some)?;
        let with_modes: Vec<usize> = (0..surveys.len())
            .filter(|i| !surveys[*i].modes.is_empty())
            .collect();
        let since = with_modes.iter().filter(|i| **i > last).count();
        let runs = with_modes.split(|i| *i > last || track.modes[*i].is_some());
        let gap = runs.map(<[usize]>::len).max().unwrap_or(0);
        let mut after = surveys[last + 1..].iter();
        let is_unseen = since > gap && !after.any(|survey| could_show(surveys, (track, last), survey));
        is_unseen.then_some(UnseenMode { mode, last })
    });
    each.collect()
}

/// Whether a survey could show a mode that was last found in survey `last`: it has a mode along its direction, along no or a new one.
fn could_show(surveys: &[HistorySurvey], (track, last): (&Track, usize), survey: &HistorySurvey) -> bool {
    survey
        .modes
        .iter()
        .any(|mode| fits(surveys, (track, last), mode.direction.as_deref()))
}

fn fits(surveys: &[HistorySurvey], (track, last): (&Track, usize), other: Option<&str>) -> bool {
    let is_known = |direction: &str| {
        let mut before = surveys[..=last].iter().flat_map(|survey| &survey.modes);
        before.any(|mode| mode.direction.as_deref() == Some(direction))
    };
    match (track.direction.as_deref(), other) {
        // a new name: the directions were renamed, or others were measured
        (Some(own), Some(other)) => own == other || !is_known(other),
        _ => true,
    }
}

/// Whether the missing modes are significant: one mode is missing for longer than ever before, or several regular modes are missing together
/// while the surveys show other modes. `surveys_between`: number of surveys times modes per allowed false alarm.
pub(super) fn is_beyond_chance(lost: &[LostMode], surveys_between: f64) -> bool {
    let most = CHANCE_MOST.min(1.0 / surveys_between);
    let regular = lost.iter().filter(|of| of.is_regular() && of.is_replaced);
    let together: f64 = regular.map(|of| of.chance).product();
    lost.iter().any(|of| of.chance <= most && of.missed > of.gap) || together <= most
}

/// The modes that are missing in the last surveys.
///
/// ```text
/// p = ((n − f + 1)/(n + 2))^k        f of n surveys had the mode, then k did not; each misses it as often as before (Laplace's rule)
/// ```
///
/// A survey is included if it has a mode in the direction of the missing mode, or a mode without a direction: a survey along y alone cannot show
/// a mode along x. A new direction that no survey had while the mode was found is also included, because it may be the same direction with a new
/// name. `answered`: whether an inspection followed a survey.
pub(super) fn lost(
    history: &History,
    tracks: &[Track],
    jumped: &[Jumped],
    answered: impl Fn(usize) -> bool,
) -> Vec<LostMode> {
    let surveys = &history.surveys;
    let each = tracks.iter().enumerate().filter_map(|(mode, track)| {
        let last = track.modes.iter().rposition(Option::is_some)?;
        let fits = |other: Option<&str>| fits(surveys, (track, last), other);
        let could = |survey: &HistorySurvey| could_show(surveys, (track, last), survey);
        let before: Vec<usize> = (0..=last).filter(|i| could(&surveys[*i])).collect();
        let after: Vec<usize> = (last + 1..surveys.len())
            .filter(|i| could(&surveys[*i]))
            .collect();
        let (since, missed, of) = (*after.first()?, after.len(), before.len());
        if of < SURVEYS_LEAST || answered(since) {
            return None;
        }
        let found = track.found().min(of);
        let is_new = |survey: usize| {
            let old = tracks
                .iter()
                .filter(|other| other.modes[..since].iter().any(Option::is_some));
            let taken: Vec<usize> = old.filter_map(|other| other.modes[survey]).collect();
            let modes = surveys[survey].modes.iter().enumerate();
            let mut own = modes.filter(|(_, mode)| fits(mode.direction.as_deref()));
            own.any(|(i, _)| !taken.contains(&i))
        };
        let runs = before.split(|i| track.modes[*i].is_some());
        let each_misses = (of - found + 1) as f64 / (of + 2) as f64;
        let mut began = jumped
            .iter()
            .filter(|of| of.at >= since && of.from_hz == track.frequency_hz);
        Some(LostMode {
            mode,
            since,
            missed,
            found,
            of,
            gap: runs.map(<[usize]>::len).max().unwrap_or(0),
            chance: each_misses.powi(missed.min(1000) as i32),
            is_replaced: after.iter().all(|survey| is_new(*survey)),
            began_hz: began.next().map(|of| of.to_hz),
        })
    });
    each.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::ObservedMode;
    use crate::numeric::Random;

    fn observed(frequency_hz: f64) -> ObservedMode {
        ObservedMode {
            frequency_hz,
            frequency_sd_hz: None,
            damping_ratio: None,
            damping_ratio_sd: None,
            degrees_of_freedom: f64::INFINITY,
            direction: None,
            accepted: false,
            shape: Vec::new(),
        }
    }

    /// Daily surveys that miss each of three modes with a probability, and always miss the first mode in the last `gone` surveys.
    fn missed(seed: u64, probability: f64, gone: usize) -> Vec<LostMode> {
        const SURVEYS: usize = 200;
        let mut random = Random::new(seed, 0);
        let mut tracks: Vec<Track> = [2.0, 3.0, 5.0]
            .map(|frequency_hz| Track {
                frequency_hz,
                direction: None,
                modes: Vec::new(),
                assurances: Vec::new(),
            })
            .to_vec();
        let mut surveys = Vec::new();
        for survey in 0..SURVEYS {
            let mut modes = vec![observed(1.0)];
            for (m, track) in tracks.iter_mut().enumerate() {
                let is_gone = m == 0 && survey >= SURVEYS - gone;
                let found = random.uniform() >= probability && !is_gone;
                track.modes.push(found.then_some(modes.len()));
                if found {
                    modes.push(observed(track.frequency_hz));
                }
            }
            surveys.push(HistorySurvey {
                name: survey.to_string(),
                day: survey as f64,
                temperature_c: None,
                modes,
                tilts: Vec::new(),
            });
        }
        // the mode of 1 Hz is also tracked
        tracks.push(Track {
            frequency_hz: 1.0,
            direction: None,
            modes: vec![Some(0); SURVEYS],
            assurances: Vec::new(),
        });
        let history = History {
            surveys,
            works: Vec::new(),
        };
        lost(&history, &tracks, &[], |_| false)
    }

    /// Surveys of a mode along x in each, and of one along y in those of `y`.
    fn along(count: usize, y: impl Fn(usize) -> bool) -> (History, Vec<Track>) {
        let track = |frequency_hz, direction: &str, found: &dyn Fn(usize) -> bool, at| Track {
            frequency_hz,
            direction: Some(direction.to_owned()),
            modes: (0..count).map(|survey| found(survey).then_some(at)).collect(),
            assurances: Vec::new(),
        };
        let tracks = vec![track(2.0, "x", &|_| true, 0), track(2.6, "y", &y, 1)];
        let surveys = (0..count).map(|survey| {
            let own = tracks.iter().filter(|track| track.modes[survey].is_some());
            let modes = own.map(|track| ObservedMode {
                direction: track.direction.clone(),
                ..observed(track.frequency_hz)
            });
            HistorySurvey {
                name: survey.to_string(),
                day: survey as f64,
                temperature_c: None,
                modes: modes.collect(),
                tilts: Vec::new(),
            }
        });
        let surveys = surveys.collect();
        let works = Vec::new();
        (History { surveys, works }, tracks)
    }

    #[test]
    fn exact_a_mode_that_goes_with_its_direction_is_unseen() {
        let last = |y: fn(usize) -> bool| -> Vec<(usize, usize)> {
            let (history, tracks) = along(30, y);
            assert_eq!(lost(&history, &tracks, &[], |_| false), []);
            let found = unseen(&history, &tracks);
            found.iter().map(|of| (of.mode, of.last)).collect()
        };
        assert_eq!(last(|survey| survey < 20), [(1, 19)]);
        assert_eq!(last(|survey| survey < 29), [(1, 28)]);
        // measured along y each third time, and once more than usual not
        assert_eq!(last(|survey| survey % 3 == 0), []);
        assert_eq!(last(|survey| survey % 3 == 0 && survey < 27), [(1, 24)]);
        // a mode along x that goes alone could have been shown
        let (history, mut tracks) = along(30, |_| true);
        tracks.push(Track {
            modes: (0..30).map(|survey| (survey < 20).then_some(0)).collect(),
            ..tracks[0].clone()
        });
        assert_eq!(unseen(&history, &tracks), []);
    }

    /// Daily surveys of four modes, one false alarm in ten years.
    const BETWEEN: f64 = 3652.5 * 4.0;

    #[test]
    fn holds_chance_misses_are_no_alarm_and_lasting_ones_are() {
        let alarms = |probability: f64, gone: usize| {
            (0..300)
                .filter(|seed| is_beyond_chance(&missed(*seed, probability, gone), BETWEEN))
                .count()
        };
        // 300 days, of which one in 3,650 may have a false alarm
        assert!(alarms(0.1, 0) <= 1 && alarms(0.3, 0) <= 1);
        assert_eq!(alarms(0.0, 3), 300);
        assert!(alarms(0.1, 8) >= 290, "{}", alarms(0.1, 8));
    }
}
