//! Wind and static loads: is the motion within the limits of the file?

use super::colour::Colour;
use crate::building::{StandingBuilding, WindSimulation};
use crate::loads::{CombinationAnswer, LoadedStorey, LoadsAnswer};
use crate::state::{Check, State};
use dolmen::assess::demand::DriftLimit;
use dolmen_project::{BuiltDamper, FramePart, Project, Structure, strokes_of};
use dolmen_words::Language;

/// The fixed words, from the best to the worst.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum WindWord {
    /// The file gives no wind.
    NotAsked,
    /// Everything stays within its limit.
    Within,
    /// There is a limit, but the motion is unknown; or there is no limit.
    NotDecided,
    /// A quantity is beyond its limit.
    Beyond,
}

/// The limited quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WindLimit {
    /// Peak acceleration of the top floor.
    Acceleration,
    /// Peak drift of a storey.
    Drift,
    /// Room of a damper.
    Room,
    /// Nothing: the file gives no limit.
    NotGiven,
}

/// The load.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MovedBy {
    /// Wind.
    Wind,
    /// Static loads.
    Loads,
    /// Wind and static loads.
    Both,
    /// A combination with the earthquake of the site.
    WithEarthquake,
}

/// A word, the quantity that decided it, and the ratio.
#[derive(Clone, Debug, PartialEq)]
pub struct WindFinding {
    /// The word.
    pub word: WindWord,
    /// The load.
    pub by: MovedBy,
    /// The limited quantity; `None` without a comparison.
    pub limit: Option<WindLimit>,
    /// The floor above the storey, or the damper.
    pub part: Option<String>,
    /// Limit over peak.
    pub ratio: Option<f64>,
}

impl WindWord {
    /// Its colour.
    pub fn colour(self) -> Colour {
        match self {
            WindWord::NotAsked | WindWord::Within => Colour::Green,
            WindWord::NotDecided => Colour::Amber,
            WindWord::Beyond => Colour::Red,
        }
    }

    /// The fixed word.
    pub fn word(self, language: Language) -> &'static str {
        match self {
            WindWord::NotAsked => language.pick("not asked", "검토하지 않음"),
            WindWord::Within => language.pick("within its limits", "한계 이내"),
            WindWord::NotDecided => language.pick("not decided", "판정 보류"),
            WindWord::Beyond => language.pick("beyond its limits", "한계 초과"),
        }
    }
}

impl WindLimit {
    /// Its key in JSON.
    pub fn key(self) -> &'static str {
        match self {
            WindLimit::Acceleration => "acceleration",
            WindLimit::Drift => "drift",
            WindLimit::Room => "room",
            WindLimit::NotGiven => "no limit",
        }
    }
}

impl WindFinding {
    /// The finding that decides: among those with the worst word, the one with the smallest margin.
    pub fn deciding(all: &[WindFinding]) -> Option<&WindFinding> {
        let word = all.iter().map(|of| of.word).max()?;
        let in_hand = |of: &&WindFinding| of.ratio.unwrap_or(f64::INFINITY);
        let worst = all.iter().filter(|of| of.word == word);
        worst.min_by(|a, b| in_hand(a).total_cmp(&in_hand(b)))
    }

    /// A motion without limits: it is not judged.
    fn without_limit(by: MovedBy) -> Self {
        WindFinding {
            word: WindWord::NotDecided,
            by,
            limit: Some(WindLimit::NotGiven),
            part: None,
            ratio: None,
        }
    }

    /// There is a limit, but the motion is unknown.
    fn unknown(by: MovedBy) -> Self {
        WindFinding {
            word: WindWord::NotDecided,
            by,
            limit: None,
            part: None,
            ratio: None,
        }
    }

    fn of(limit: WindLimit, part: Option<String>, ratio: f64) -> Self {
        WindFinding {
            word: match ratio >= 1.0 {
                true => WindWord::Within,
                false => WindWord::Beyond, // also if it is not a number
            },
            by: MovedBy::Wind,
            limit: Some(limit),
            part,
            ratio: Some(ratio),
        }
    }
}

/// The motion of a building in its wind, and of a frame under wind and static loads, compared with the limits of the file; empty without limits,
/// and for other kinds.
pub(super) fn of_wind(project: &Project, state: &State, is_contradicted: bool) -> Vec<WindFinding> {
    if let (Structure::Frame(part), Some(loads)) = (&project.structure, &state.loads) {
        // a given gust does not include the resonance of a soft frame
        let is_in_doubt = is_contradicted || loads.lacks_resonance_at_hz().is_some();
        return if_model_is_right(of_frame(part, project, loads), is_in_doubt);
    }
    let Check::Building(answer) = &state.check else {
        return Vec::new();
    };
    let Some(standing) = &answer.stands else {
        return Vec::new();
    };
    let mut all = compared(standing, &answer.floors);
    if standing.wind_refused.is_some() {
        let given = project.loads.wind().map(|wind| &wind.in_time);
        let is_limited = given.is_some_and(|of| of.acceleration_limit.is_some() || of.drift_limit.is_some());
        all.extend(is_limited.then_some(WindFinding::unknown(MovedBy::Wind)));
    }
    let combinations = state.loads.iter().flat_map(|loads| &loads.combinations);
    let (mut moved_by, mut has_combination) = (MovedBy::Wind, false);
    for (by, found) in combinations.filter_map(of_building) {
        (moved_by, has_combination) = (by, true);
        all.extend(found);
    }
    if all.is_empty() && (standing.wind.is_some() || has_combination) {
        all.push(WindFinding::without_limit(moved_by));
    }
    if_model_is_right(all, is_contradicted)
}

/// A combination of a building: what moves it, and its largest drift compared with its limit, if it has one; `None` if nothing moves it, or
/// its weight alone makes it fall.
fn of_building(of: &CombinationAnswer) -> Option<(MovedBy, Option<WindFinding>)> {
    let building = of.building()?;
    let by = match (building.earthquake > 0.0, of.wind > 0.0, of.loads > 0.0) {
        (true, _, _) => MovedBy::WithEarthquake,
        (false, true, true) => MovedBy::Both,
        (false, true, false) => MovedBy::Wind,
        (false, false, true) => MovedBy::Loads,
        (false, false, false) => return None,
    };
    let largest = building.largest().filter(|of| of.ratio != 0.0)?;
    let found = building.drift_limit.map(|limit| {
        let judged = WindFinding {
            by,
            ..WindFinding::of(
                WindLimit::Drift,
                Some(largest.storey.floor.clone()),
                limit / largest.ratio,
            )
        };
        match building.unknown.is_some() && judged.word == WindWord::Within {
            true => WindFinding::unknown(by),
            false => judged,
        }
    });
    Some((by, found))
}

/// The lean of each storey of a frame under each combination, compared with a drift limit that the file gives as a number; the smallest
/// margin of each combination. Limits of codes are for earthquakes. Empty without such a limit.
fn of_frame(part: &FramePart, project: &Project, loads: &LoadsAnswer) -> Vec<WindFinding> {
    let Some(limit @ DriftLimit::Given { .. }) = &project.drift_limit else {
        return Vec::new();
    };
    let numbered = part.storeys.iter().enumerate();
    let names: Vec<String> = numbered
        .map(|(i, storey)| storey.name.clone().unwrap_or_else(|| format!("storey {}", i + 1)))
        .collect();
    let moved_by = |of: &CombinationAnswer| match (
        loads.has_wind && of.wind != 0.0,
        loads.has_loads && of.loads != 0.0,
    ) {
        (true, true) => Some(MovedBy::Both),
        (true, false) => Some(MovedBy::Wind),
        (false, true) => Some(MovedBy::Loads),
        (false, false) => None,
    };
    if matches!(loads.wind, Some(Err(_))) {
        return vec![WindFinding::unknown(MovedBy::Wind)];
    }
    let mut all = Vec::new();
    for combination in &loads.combinations {
        let (Some(by), Some(frame)) = (moved_by(combination), combination.frame()) else {
            continue;
        };
        let storeys = frame
            .directions
            .iter()
            .flat_map(|own| own.storeys.iter().zip(&names));
        let ratios = storeys.filter_map(|(storey, name)| Some((in_hand(storey, limit.ratio())?, name)));
        let least = ratios.min_by(|a, b| a.0.total_cmp(&b.0));
        all.extend(least.map(|(ratio, name)| WindFinding {
            by,
            ..WindFinding::of(WindLimit::Drift, Some(name.clone()), ratio)
        }));
        if !frame.unknown.is_empty() {
            all.push(WindFinding::unknown(by));
        }
    }
    all
}

/// The allowable drift minus the lean without the loads, divided by the additional lean under the loads; 0 if the storey cannot resist
/// them, `None` without loads.
fn in_hand(storey: &LoadedStorey, allowed: f64) -> Option<f64> {
    if storey.under.shear_n == 0.0 {
        return None;
    }
    let (Some(at_rest), Some(drift_m)) = (storey.under.lean_at_rest, storey.under.drift_m) else {
        return Some(0.0);
    };
    let left = (allowed - at_rest).max(0.0);
    Some(match drift_m == 0.0 {
        true if left > 0.0 => f64::INFINITY,
        _ => left / (drift_m / storey.height_m),
    })
}

/// Histories compared with the same limits: the mean of their peaks, or the mean square if that is larger, so that both verbs agree. No value is
/// within its limit if a damper meets its stops in a history (the model has none), or if the histories are shorter than the time for which the
/// limits hold.
pub(super) fn of_wind_histories(run: &WindSimulation, is_contradicted: bool) -> Vec<WindFinding> {
    let mut all = Vec::new();
    if let Some(limit) = run.acceleration_limit_m_s2 {
        let ratio = limit / run.judged_acceleration_m_s2();
        all.push(WindFinding::of(WindLimit::Acceleration, None, ratio));
    }
    if let (Some(limit), Some(drift)) = (run.drift_limit, run.judged_drift()) {
        let floor = run.floors[drift.storey].clone();
        all.push(WindFinding::of(
            WindLimit::Drift,
            Some(floor),
            limit / drift.of_height,
        ));
    }
    all.extend(rooms(&run.dampers, run.judged_strokes_m()));
    for struck in run.struck() {
        let mut own = all.iter_mut().filter(|of| of.part.as_ref() == Some(&struck.name));
        if let Some(of) = own.find(|of| of.limit == Some(WindLimit::Room) && of.word == WindWord::Within) {
            of.word = WindWord::NotDecided;
            of.ratio = Some(struck.room_m / struck.largest_m);
        }
    }
    if all.is_empty() {
        all.push(WindFinding::without_limit(MovedBy::Wind));
    }
    if_model_is_right(all, is_contradicted || !run.is_as_long_as_its_wind())
}

/// If the model or the wind is not that of the structure, no value is within its limit.
fn if_model_is_right(mut all: Vec<WindFinding>, is_in_doubt: bool) -> Vec<WindFinding> {
    if is_in_doubt {
        let within = all.iter_mut().filter(|of| of.word == WindWord::Within);
        within.for_each(|of| of.word = WindWord::NotDecided);
    }
    all
}

fn rooms(dampers: &[BuiltDamper], strokes_m: Vec<f64>) -> Vec<WindFinding> {
    let strokes = strokes_of(dampers).into_iter().zip(strokes_m);
    let all = strokes.filter_map(|(stroke, stroke_m)| {
        let ratio = stroke.room_m? / stroke_m;
        Some(WindFinding::of(WindLimit::Room, Some(stroke.name), ratio))
    });
    all.collect()
}

fn compared(standing: &StandingBuilding, floors: &[String]) -> Vec<WindFinding> {
    let Some(wind) = &standing.wind else {
        return Vec::new();
    };
    let mut all = Vec::new();
    if let (Some(limit), Some((_, top))) = (wind.acceleration_limit_m_s2, wind.top_acceleration()) {
        all.push(WindFinding::of(WindLimit::Acceleration, None, limit / top.peak()));
    }
    if let (Some(limit), Some((_, storey, drift))) =
        (wind.drift_limit, wind.largest_drift(&standing.building))
    {
        all.push(WindFinding::of(
            WindLimit::Drift,
            Some(floors[storey].clone()),
            limit / drift,
        ));
    }
    all.extend(rooms(&standing.dampers, wind.strokes_m()));
    all
}
