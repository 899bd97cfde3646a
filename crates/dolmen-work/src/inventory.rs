//! Histories of many structures, one line each, the worst first.

use crate::last_off::LastFarOff;
use crate::part_limit::Part;
use crate::watch_doubts::NotKnown;
use crate::watched::WatchAnswer;
use dolmen::assess::PartFit;
use dolmen::monitoring::TiltSlope;
use dolmen_project::LogKind;
use dolmen_words::message::Both;
use serde::{Serialize, Serializer};
use std::cmp::Reverse;

/// The strongest lasting change in a history.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StrongestChange {
    /// Frequency of the mode, Hz.
    pub frequency_hz: f64,
    /// Relative change.
    pub ratio: f64,
    /// Its standard deviation.
    pub sd: f64,
    /// The survey before the change.
    pub after: String,
    /// The survey after the change.
    pub before: String,
    /// The parts of the model that each alone explain it, the best first; several cannot be distinguished. Empty without a model, or if no
    /// single part explains it.
    pub explained_by: Vec<ExplainingPart>,
}

/// A part of the model that alone explains a change.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ExplainingPart {
    /// Name of the part in JSON.
    #[serde(serialize_with = "by_name")]
    pub part: Part,
    /// The direction; `None` if all are taken together.
    pub direction: Option<String>,
    /// Ratio of its stiffness after to before.
    pub stiffness_left: f64,
    /// Lower end of its interval at 95 %.
    pub stiffness_left_lower: f64,
    /// Upper end.
    pub stiffness_left_upper: f64,
}

fn by_name<S: Serializer>(part: &Part, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(part.name())
}

/// The parts that explain a change between two surveys; empty if none does.
fn explaining(answer: &WatchAnswer, [after, before]: [usize; 2]) -> Vec<ExplainingPart> {
    let found = answer
        .parts
        .iter()
        .find(|of| of.after <= before && after <= of.before);
    let directions = found.into_iter().flat_map(|of| &of.parts);
    let each = directions.flat_map(|of| {
        let named = move |fit: &PartFit| {
            Some(ExplainingPart {
                part: of.parts.get(fit.part?)?.clone(),
                direction: of.direction.clone(),
                stiffness_left: fit.factor,
                stiffness_left_lower: fit.factor_interval[0],
                stiffness_left_upper: fit.factor_interval[1],
            })
        };
        of.found.candidates().iter().filter_map(named)
    });
    each.collect()
}

/// The tilt nearest its limit, or the largest if there is no limit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NearestTilt {
    /// Its direction.
    pub direction: String,
    /// On the day of the last reading, the season removed: horizontal over vertical.
    pub now: f64,
    /// Its limit.
    pub limit: Option<f64>,
    /// Years until the limit, where the tilt grows significantly.
    pub years_to_limit: Option<f64>,
}

/// Summary of the history of a structure.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct History {
    /// Surveys that were watched.
    pub surveys: usize,
    /// The last one.
    pub last_survey: String,
    /// Modes that were followed.
    pub modes: usize,
    /// Number of open confirmed alarms.
    pub open_alarms: usize,
    /// Whether a tilt is beyond its limit.
    pub is_tilt_beyond: bool,
    /// Number of cracks, logged or inspected, and of other inspected damages beyond their limits.
    pub cracks_beyond: usize,
    /// Number of failing sensors in the newest record.
    pub open_sensor_alarms: usize,
    /// Tilt of all directions together, horizontal over vertical, if it is beyond its limit.
    pub lean_beyond: Option<f64>,
    /// The lasting change with the largest weight: falls of frequency before rises.
    pub change: Option<StrongestChange>,
    /// Whether a mode changed, or the last surveys or the newest days of a log are off, without a later repair or inspection.
    pub is_change_open: bool,
    /// The mode of the last survey that is farthest from its prediction.
    pub last_off: Option<LastFarOff>,
    /// The most important tilt.
    pub tilt: Option<NearestTilt>,
    /// Why it is not known to be sound though nothing was found; empty if it is.
    pub not_known: Vec<NotKnown>,
}

/// A structure of an inventory.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct InventoryLine {
    /// The structure.
    pub structure: String,
    /// Its summary; `None` without a history.
    pub history: Option<History>,
    /// Why there is no history.
    #[serde(serialize_with = "in_english")]
    pub not_watched: Option<Both>,
}

/// Serializes the English text: JSON is the same in every language.
fn in_english<S: Serializer>(why: &Option<Both>, to: S) -> Result<S::Ok, S::Error> {
    why.as_ref().map(|why| &why.english).serialize(to)
}

impl InventoryLine {
    /// A structure with a history.
    pub fn watched(structure: String, answer: &WatchAnswer) -> Self {
        InventoryLine {
            structure,
            history: Some(History::of(answer)),
            not_watched: None,
        }
    }

    /// A structure without a history.
    pub fn not_watched(structure: String, why: Both) -> Self {
        InventoryLine {
            structure,
            history: None,
            not_watched: Some(why),
        }
    }

    /// Whether it needs an inspection: an open alarm, or a tilt or crack beyond its limit.
    pub fn is_alarming(&self) -> bool {
        let history = self.history.as_ref();
        history.is_some_and(|history| {
            history.open_alarms > 0 || history.is_tilt_beyond || history.cracks_beyond > 0
        })
    }

    /// Whether it changed without an alarm and without a response: to be watched.
    pub fn is_to_watch(&self) -> bool {
        let is_open = self
            .history
            .as_ref()
            .is_some_and(|history| history.is_change_open);
        is_open && !self.is_alarming()
    }

    /// Whether nothing was found in it, but it is not known to be sound: no history, or one that shows little.
    pub fn is_not_known(&self) -> bool {
        let is_quiet = !self.is_alarming() && !self.is_to_watch();
        let history = self.history.as_ref();
        is_quiet && history.is_none_or(|history| !history.not_known.is_empty())
    }

    /// Open alarms and tilts beyond their limit first, then changes without a response, then other changes, then structures that are not known to be
    /// sound, then the others.
    fn rank(&self) -> u8 {
        match &self.history {
            Some(_) if self.is_alarming() => 0,
            Some(history) if history.is_change_open => 1,
            Some(history) if history.change.is_some() => 2,
            None => 3,
            Some(history) if !history.not_known.is_empty() => 3,
            Some(_) => 4,
        }
    }
}

impl History {
    fn of(answer: &WatchAnswer) -> Self {
        let watched = &answer.watched;
        let name = |survey: usize| {
            let found = answer.surveys.get(survey);
            found.map_or_else(String::new, |survey| survey.name.clone())
        };
        let changes = watched
            .modes
            .iter()
            .flat_map(|mode| mode.changes.iter().map(move |change| (mode, change)));
        let strongest =
            changes.max_by(|a, b| (a.1.ratio / a.1.sd).abs().total_cmp(&(b.1.ratio / b.1.sd).abs()));
        let surveyed = watched.tilts.iter().filter_map(|trend| {
            let of = &trend.series.direction;
            Some((of, trend.slope?, trend.is_beyond_chance()))
        });
        let logged = answer.logs.iter().filter_map(|log| match &log.part.kind {
            LogKind::Tilt { direction } if log.trend.limit.is_some() => {
                let slope = log.trend.slope.ok()?;
                let now = log.trend.last_off.map_or(slope.now, |_| log.trend.newest);
                Some((
                    direction,
                    TiltSlope { now, ..slope },
                    log.trend.is_beyond_chance(),
                ))
            }
            _ => None,
        });
        let share = |slope: &TiltSlope| slope.share_of_limit().unwrap_or(slope.now.abs());
        let tilts = surveyed.chain(logged);
        let nearest = tilts.max_by(|a, b| share(&a.1).total_cmp(&share(&b.1)));
        History {
            surveys: answer.surveys.len(),
            last_survey: name(answer.surveys.len().saturating_sub(1)),
            modes: watched.modes.len(),
            open_alarms: answer.open_alarms(),
            is_tilt_beyond: answer.is_tilt_beyond(),
            cracks_beyond: answer.cracks_beyond(),
            open_sensor_alarms: answer.open_sensor_alarms(),
            lean_beyond: answer.lean_beyond(),
            is_change_open: answer.has_unanswered_change() || answer.is_log_off(),
            last_off: answer.last_far_off().first().copied(),
            not_known: answer.not_known(),
            change: strongest.map(|(mode, change)| StrongestChange {
                frequency_hz: mode.track.frequency_hz,
                ratio: change.ratio,
                sd: change.sd,
                after: name(change.after),
                before: name(change.before),
                explained_by: explaining(answer, [change.after, change.before]),
            }),
            tilt: nearest.map(|(direction, slope, is_beyond_chance)| NearestTilt {
                direction: direction.clone(),
                now: slope.now,
                limit: slope.reach.map(|reach| reach.limit),
                years_to_limit: slope
                    .reach
                    .filter(|_| is_beyond_chance)
                    .and_then(|reach| reach.years),
            }),
        }
    }
}

/// Weight of a rise of a frequency relative to a fall. Our choice: a fall means loss of stiffness.
const OF_RISE: f64 = 0.5;

/// Weight of a change of a frequency.
fn weight(ratio: f64) -> f64 {
    if ratio < 0.0 { -ratio } else { OF_RISE * ratio }
}

/// The structures in order of priority: the worst first, then by name.
pub fn worst_first(mut lines: Vec<InventoryLine>) -> Vec<InventoryLine> {
    let size = |line: &InventoryLine| {
        let history = line.history.as_ref();
        let change = history.and_then(|history| Some(history.change.as_ref()?.ratio));
        let last = history.and_then(|history| Some(history.last_off?.ratio));
        change.into_iter().chain(last).map(weight).fold(0.0, f64::max)
    };
    lines.sort_by(|a, b| {
        let alarms =
            |line: &InventoryLine| Reverse(line.history.as_ref().map_or(0, |history| history.open_alarms));
        (a.rank(), alarms(a))
            .cmp(&(b.rank(), alarms(b)))
            .then(size(b).total_cmp(&size(a)))
            .then_with(|| a.structure.cmp(&b.structure))
    });
    lines
}
