//! `dolmen watch` as JSON.

use super::change_form::form;
use super::changed_part::{changed_part, model_off};
use super::check::project;
use super::inspected::inspected;
use crate::as_json;
use dolmen::monitoring::{AlarmKind, NoSlope, NotJudged, ScaleMark, TiltTrend, WatchedMode, WeatherKnown};
use dolmen_project::LogKind;
use dolmen_work::date_text;
use dolmen_work::watched::WatchAnswer;
use dolmen_work::watched_log::WatchedLog;
use serde_json::Value;

/// The result of a history.
pub fn watch_json(answer: &WatchAnswer) -> Value {
    let watched = &answer.watched;
    let name = |survey: usize| answer.surveys.get(survey).map(|survey| survey.name.clone());
    let frequency = |mode: usize| watched.modes.get(mode).map(|mode| mode.track.frequency_hz);
    let lost = watched.lost.iter().map(|lost| {
        as_json!({
            "mode": lost.mode + 1,
            "frequency_hz": frequency(lost.mode),
            "since": name(lost.since),
            "surveys_missing": lost.missed,
            "found_before": lost.found,
            "surveys_before": lost.of,
            "p_value": lost.chance,
            "began_hz": lost.began_hz,
        })
    });
    let unseen = watched.unseen.iter().map(|of| {
        as_json!({ "mode": of.mode + 1, "frequency_hz": frequency(of.mode), "last_found": name(of.last) })
    });
    as_json!({
        "modes_lost": lost.collect::<Vec<_>>(),
        "modes_unseen": unseen.collect::<Vec<_>>(),
        "is_mode_lost": watched.is_mode_lost(),
        "project": project(&answer.project, &answer.file),
        "surveys": answer.surveys.iter().map(|survey| as_json!({
            "name": survey.name,
            "temperature_c": survey.temperature_c,
        })).collect::<Vec<_>>(),
        "left_out": answer.left_out,
        "sensors_left_out": answer.sensors_left_out.iter().map(|(survey, channels)| as_json!({ "survey": survey, "channels": channels })).collect::<Vec<_>>(),
        "without_modes": answer.without_modes.iter().map(|(survey, why)| as_json!({ "survey": survey, "why": why.english })).collect::<Vec<_>>(),
        "several_of_one_day": answer.several.iter().map(|(day, surveys)| as_json!({ "day": day, "surveys": surveys })).collect::<Vec<_>>(),
        "works": answer.works.iter().map(|(_, work)| as_json!({
            "date": work.date,
            "what": work.what,
            "kind": work.kind.word(),
        })).collect::<Vec<_>>(),
        "last_far_off": answer.last_far_off(),
        "earthquakes": answer.earthquakes.iter().map(|of| as_json!({
            "survey": of.survey,
            "peak_acceleration_m_s2": of.part.peak_m_s2,
            "peak_at_least": of.part.is_at_least,
            "change_ratio": of.part.changed,
            "sd": of.part.changed_sd,
            "answered": of.is_answered,
        })).collect::<Vec<_>>(),
        "open_alarms": answer.open_alarms(),
        "open_sensor_alarms": answer.open_sensor_alarms(),
        "significance": watched.significance,
        "interval_days": watched.interval_days,
        "average_limit": watched.average_limit,
        "false_alarm_probability": watched.false_alarm_probability,
        "changes": changes(answer),
        "alarms": alarms(answer),
        "modes": watched.modes.iter().map(|each| mode(each, answer)).collect::<Vec<_>>(),
        "leans": answer.leans().iter().map(|lean| as_json!({
            "datum": lean.datum, "directions": lean.directions, "now": lean.size, "limit": lean.limit, "is_beyond": lean.is_beyond(),
        })).collect::<Vec<_>>(),
        "latest_tilts": answer.latest_tilts().iter().map(|read| as_json!({
            "survey": name(read.survey), "datum": read.datum, "directions": read.directions, "tilt": read.ratio,
            "share_of_limit": read.share_of_limit(),
        })).collect::<Vec<_>>(),
        "tilts_were_beyond": answer.tilts_were_beyond().iter().map(|of| as_json!({
            "survey": name(of.largest.survey), "datum": of.largest.datum, "directions": of.largest.directions,
            "tilt": of.largest.ratio, "readings": of.count,
        })).collect::<Vec<_>>(),
        "temperatures_of_log": answer.temperatures_of_log,
        "logs": answer.logs.iter().map(|found| log(found, answer)).collect::<Vec<_>>(),
        "model_off": answer.model_off.as_ref().map(model_off),
        "changed_parts": answer.parts.iter().map(|of| as_json!({
            "form": form(of.form), "date_earliest": name(of.after), "date_latest": name(of.before),
            "parts": of.parts.iter().map(changed_part).collect::<Vec<_>>(),
        })).collect::<Vec<_>>(),
        "inspected": inspected(&answer.inspected),
        "tilts": watched.tilts.iter().map(|trend| tilt(trend, answer)).collect::<Vec<_>>(),
        "sensors": watched.tracked.sensors.iter().map(|change| as_json!({
            "date": name(change.survey),
            "channel": change.channel,
            "assurance": change.assurance,
        })).collect::<Vec<_>>(),
        "jumped": watched.tracked.jumped.iter().map(|jumped| as_json!({
            "from_hz": jumped.from_hz,
            "to_hz": jumped.to_hz,
            "date": name(jumped.at),
            "assurance": jumped.assurance,
        })).collect::<Vec<_>>(),
    })
}

/// Every change of every mode.
fn changes(answer: &WatchAnswer) -> Vec<Value> {
    let name = |survey: usize| answer.surveys.get(survey).map(|survey| survey.name.clone());
    let mut changes = Vec::new();
    for (number, mode) in answer.watched.modes.iter().enumerate() {
        for change in &mode.changes {
            changes.push(as_json!({
                "mode": number + 1,
                "frequency_hz": mode.track.frequency_hz,
                "form": form(change.form),
                "date": name(change.from),
                "date_earliest": name(change.after),
                "date_latest": name(change.before),
                "change_ratio": change.ratio,
                "sd": change.sd,
                "change_ratio_per_year": change.per_year,
                "p_value": change.p_value,
                "seen_from_ratio": mode.seen_from_ratio,
            }));
        }
    }
    changes
}

/// Alarms of the modes, single and combined, by survey, then those of sensors.
fn alarms(answer: &WatchAnswer) -> Vec<Value> {
    let watched = &answer.watched;
    let name = |survey: usize| answer.surveys.get(survey).map(|survey| survey.name.clone());
    let frequency = |mode: usize| watched.modes.get(mode).map(|mode| mode.track.frequency_hz);
    let mut alarms: Vec<(usize, Value)> = watched
        .alarms
        .iter()
        .map(|found| {
            let alarm = &found.alarm;
            let value = as_json!({
                "date": name(alarm.survey),
                "since": name(alarm.since),
                "mode": found.mode + 1,
                "frequency_hz": frequency(found.mode),
                "kind": match alarm.kind {
                    AlarmKind::Average => "average",
                    AlarmKind::ThreeOfFive => "three_of_five",
                },
                "confirmed": true,
                "answered": found.is_answered,
                "value": alarm.value,
                "limit": alarm.limit,
            });
            (alarm.survey, value)
        })
        .collect();
    for found in watched.t_squared.iter().filter(|found| found.value > found.limit) {
        let value = as_json!({
            "date": name(found.survey),
            "since": Value::Null,
            "mode": Value::Null,
            "frequency_hz": Value::Null,
            "kind": "t_squared",
            "confirmed": false,
            "answered": Value::Null,
            "value": found.value,
            "limit": found.limit,
        });
        alarms.push((found.survey, value));
    }
    alarms.sort_by_key(|(survey, _)| *survey);
    let sensors = answer.sensor_alarms.iter().map(|alarm| {
        as_json!({
            "date": alarm.last,
            "since": alarm.since,
            "mode": Value::Null,
            "frequency_hz": Value::Null,
            "kind": "sensor",
            "confirmed": true,
            "answered": !alarm.is_open,
            "value": Value::Null,
            "limit": Value::Null,
            "channel": alarm.channel,
            "fault": alarm.fault,
            "records": alarm.records,
        })
    });
    alarms
        .into_iter()
        .map(|(_, alarm)| alarm)
        .chain(sensors)
        .collect()
}

fn mode(mode: &WatchedMode, answer: &WatchAnswer) -> Value {
    let weather = mode.weather.as_ref();
    let name = |survey: usize| answer.surveys.get(survey).map(|survey| survey.name.clone());
    let names =
        |surveys: &[usize]| -> Vec<Value> { surveys.iter().map(|survey| as_json!(name(*survey))).collect() };
    as_json!({
        "frequency_hz": mode.track.frequency_hz,
        "direction": mode.track.direction,
        "found": mode.track.found() - answer.accepted_in(&mode.track),
        "accepted": answer.accepted_in(&mode.track),
        "weather": weather.map(|weather| match weather.known {
            WeatherKnown::Temperature => "temperature",
            WeatherKnown::TemperatureAndFrost => "temperature_and_frost",
            WeatherKnown::Season => "season",
            WeatherKnown::TwoSeasons(_) => "two_seasons",
            WeatherKnown::Nothing => "nothing",
        }),
        "per_c": weather.and_then(|weather| weather.per_c).map(|known| known.0),
        "per_c_sd": weather.and_then(|weather| weather.per_c).map(|known| known.1),
        "frost_per_c": weather.and_then(|weather| weather.frost_per_c).map(|known| known.0),
        "temperature_with_time": weather.and_then(|weather| weather.with_time),
        "disturbance_sd": weather.map(|weather| weather.disturbance.sd),
        "disturbance_correlation": weather.map(|weather| weather.disturbance.correlation),
        "seen_from_ratio": mode.seen_from_ratio,
        "last_off": mode.last_off.map(|off| as_json!({ "from": off.from, "surveys": off.surveys, "ratio": off.ratio, "sd": off.sd })),
        "outliers": names(&mode.outliers),
        "not_searched": names(&mode.strange),
        "temperature_of_season": names(&mode.guessed),
        "works": mode.works.iter().map(|effect| as_json!({
            "work": effect.work + 1,
            "change_ratio": effect.ratio,
            "sd": effect.sd,
        })).collect::<Vec<_>>(),
        "surveys": mode.judged.judged.iter().map(|judged| as_json!({
            "date": name(judged.survey),
            "frequency_hz": mode.track.modes.get(judged.survey).copied().flatten()
                .and_then(|j| answer.surveys[judged.survey].frequencies_hz.get(j)),
            "explained_hz": mode.explained_hz.get(judged.survey).copied().flatten(),
            "predicted_hz": judged.predicted.map(|(ratio, _)| mode.track.frequency_hz * (1.0 + ratio)),
            "score": judged.score.ok(),
            "not_judged": judged.score.err().map(|why| match why {
                NotJudged::Training => "training",
                NotJudged::NewLevel => "new_level",
                NotJudged::Temperature => "temperature",
                NotJudged::NoTemperature => "no_temperature",
            }),
            "average_over_limit": judged.average,
        })).collect::<Vec<_>>(),
    })
}

fn tilt(trend: &TiltTrend, answer: &WatchAnswer) -> Value {
    let date = |reading: usize| {
        let survey = answer.surveys.get(*trend.series.surveys.get(reading)?)?;
        Some(survey.name.clone())
    };
    let slope = trend.slope.as_ref();
    let reach = slope.and_then(|slope| slope.reach);
    let carried = trend.carried.and_then(|slope| slope.reach);
    as_json!({
        "direction": trend.series.direction,
        "datum": trend.series.datum,
        "readings": trend.series.ratios.len(),
        "per_year": slope.map(|slope| slope.per_year),
        "sd_per_year": slope.map(|slope| slope.sd_per_year),
        "p_value": slope.map(|slope| slope.p_value),
        "beyond_chance": trend.is_beyond_chance(),
        "changes": trend.changes.iter().map(|of| as_json!({
            "form": form(of.form), "date": date(of.from), "date_earliest": date(of.after), "date_latest": date(of.before),
            "size": of.size, "sd": of.sd,
        })).collect::<Vec<_>>(),
        "outliers": trend.outliers.iter().map(|of| as_json!({
            "date": date(of.at), "tilt": trend.series.ratios.get(of.at), "expected": of.expected,
        })).collect::<Vec<_>>(),
        "last_off": trend.last_off.map(|of| as_json!({ "date": date(of.from), "expected": of.expected, "sd": of.sd, "p_value": of.p_value })),
        "works": trend.works.iter().map(|of| as_json!({ "work": of.work + 1, "change": of.size, "sd": of.sd })).collect::<Vec<_>>(),
        "seen_from_per_year": slope.map(|slope| slope.seen_from_per_year),
        "now": slope.map(|slope| slope.now),
        "sign_in_question": trend.is_sign_in_question(),
        "unit_in_question": trend.is_unit_in_question(),
        "years_to_limit_as_mark_before": carried.and_then(|reach| reach.years),
        "limit": reach.map(|reach| reach.limit),
        "years_to_limit": reach.and_then(|reach| reach.years),
        "years_to_limit_earliest": reach.and_then(|reach| reach.years_earliest),
        "years_to_limit_latest": reach.and_then(|reach| reach.years_latest),
    })
}

/// A log; tilts are ratios, widths m.
fn log(log: &WatchedLog, answer: &WatchAnswer) -> Value {
    let (trend, rows) = (&log.trend, &log.rows);
    let slope = trend.slope.as_ref().ok();
    let reach = slope.and_then(|slope| slope.reach);
    let span = log.span();
    let direction = match &log.part.kind {
        LogKind::Tilt { direction } => Some(direction),
        LogKind::Crack | LogKind::Temperature => None,
    };
    as_json!({
        "name": log.part.name,
        "kind": if log.is_tilt() { "tilt" } else { "crack" },
        "direction": direction,
        "file": log.part.file,
        "column": log.part.column,
        "unit": if log.is_tilt() { "" } else { "m" },
        "zero": log.part.zero,
        "from": span.map(|span| date_text(span[0])),
        "to": span.map(|span| date_text(span[1])),
        "readings": trend.daily.readings,
        "days": trend.daily.days.len(),
        "median_days": slope.map(|_| trend.block_days),
        "per_year": slope.map(|slope| slope.per_year),
        "sd_per_year": slope.map(|slope| slope.sd_per_year),
        "p_value": slope.map(|slope| slope.p_value),
        "beyond_chance": trend.is_beyond_chance(),
        "seen_from_per_year": slope.map(|slope| slope.seen_from_per_year),
        "no_slope": trend.slope.as_ref().err().map(|why| match why {
            NoSlope::TooShort { .. } => "too_short",
            NoSlope::TooFew { .. } => "too_few",
            NoSlope::Wanders => "wanders",
            NoSlope::OtherScale(_) => "other_scale",
        }),
        "acceleration": trend.curve.map(|of| as_json!({
            "per_year2": of.per_year2, "sd_per_year2": of.sd_per_year2, "p_value": of.p_value, "first_per_year": of.first_per_year,
            "years_to_limit_at_rate": of.at_rate.and_then(|reach| reach.years),
            "years_to_limit_at_rate_earliest": of.at_rate.and_then(|reach| reach.years_earliest),
            "years_to_limit_at_rate_latest": of.at_rate.and_then(|reach| reach.years_latest),
        })),
        "scale_in_question": trend.scale.map(|of| as_json!({ "from": date_text(of.from), "mark": mark(of.mark), "factor": factor(of.mark) })),
        "season": trend.season,
        "per_c": trend.per_c.map(|known| known.0),
        "per_c_sd": trend.per_c.map(|known| known.1),
        "now": trend.now,
        "newest": trend.newest,
        "days_at_limit": trend.at_limit.len(),
        "limit": trend.limit.map(|limit| limit.size),
        "beyond_limit": trend.is_beyond_limit(),
        "years_to_limit": reach.and_then(|reach| reach.years),
        "years_to_limit_earliest": reach.and_then(|reach| reach.years_earliest),
        "years_to_limit_latest": reach.and_then(|reach| reach.years_latest),
        "shifts": trend.levels.iter().map(|level| as_json!({
            "work": level.work + 1,
            "date": answer.works.get(level.work).map(|(_, work)| work.date.clone()),
            "shift": level.shift,
            "sd": level.sd,
            "p_value": level.p_value,
        })).collect::<Vec<_>>(),
        "changes": trend.changes.iter().map(|of| as_json!({
            "form": form(of.form), "date": date_text(of.day), "date_earliest": date_text(of.after), "date_latest": date_text(of.before),
            "size": of.size, "sd": of.sd,
        })).collect::<Vec<_>>(),
        "last_off": trend.last_off.map(|of| as_json!({
            "days": of.days, "from": date_text(of.from), "off": of.off, "scatter": of.scatter,
        })),
        "stuck_since": trend.stuck_since.map(date_text),
        "silent_since": log.silent_since(answer.newest_day()).map(date_text),
        "jump": trend.jump.map(|jump| as_json!({
            "after": date_text(jump.after), "before": date_text(jump.before), "by": jump.by,
        })),
        "days_of_spikes": trend.spikes.iter().map(|day| date_text(*day)).collect::<Vec<_>>(),
        "days_of_works": trend.of_works,
        "days_without_temperature": trend.without_temperature,
        "rows_without_reading": rows.gaps,
        "rows_repeated": rows.repeated,
        "rows_set_back": rows.set_back,
        "readings_of_wrong_clock": rows.misdated + trend.daily.stray,
    })
}

/// What shows another scale.
fn mark(of: ScaleMark) -> &'static str {
    match of {
        ScaleMark::Scatter(_) => "scatter",
        ScaleMark::Readings(_) => "readings",
        ScaleMark::OtherSign => "sign",
        ScaleMark::Turned => "season_and_temperature",
    }
}

fn factor(of: ScaleMark) -> Option<f64> {
    match of {
        ScaleMark::Scatter(factor) | ScaleMark::Readings(factor) => Some(factor),
        ScaleMark::OtherSign | ScaleMark::Turned => None,
    }
}
