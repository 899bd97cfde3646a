//! `dolmen compare` as JSON.

use super::changed_part::{changed_part, model_off};
use super::check::project;
use super::earthquake::modes_of;
use crate::as_json;
use crate::engineer::damage_words;
use dolmen::assess::{ModeChange, SurveyChange, TemperatureKnowledge};
use dolmen_words::Language;
use dolmen_words::advice::Advice;
use dolmen_work::answer::CompareAnswer;
use dolmen_work::compared_history::{ComparedHistory, Course, LastingChange};
use dolmen_work::compared_readings::{ComparedItem, ComparedReadings, ItemCourse};
use dolmen_work::events_between::EventBetween;
use serde_json::Value;

/// The change between two surveys; without modes in one of them, it contains no frequencies.
pub fn change_json(answer: &CompareAnswer) -> Value {
    let mut all = as_json!({
        "project": project(&answer.project, &answer.file),
        "from": answer.from,
        "to": answer.to,
        "modes_from": answer.change.as_ref().map(|change| &change.from),
        "modes_to": answer.change.as_ref().map(|change| &change.to),
        "earthquakes": answer.shaken.iter().map(|(survey, of)| as_json!({ "survey": survey, "modes_of": modes_of(*of) })).collect::<Vec<_>>(),
        "between": answer.between().iter().map(|of| match of {
            EventBetween::Work(work) => as_json!({ "date": work.date, "kind": work.kind.word(), "what": work.what }),
            EventBetween::Earthquake(survey) => as_json!({ "date": survey, "kind": "earthquake", "what": Value::Null }),
        }).collect::<Vec<_>>(),
        "history": answer.history.as_ref().map(history),
        "tilts": tilts(&answer.readings),
        "inspections": answer.readings.items.iter().map(item).collect::<Vec<_>>(),
        "unread": answer.unread.iter().map(|(survey, why)| as_json!({ "survey": survey, "why": why.english })).collect::<Vec<_>>(),
        "without_modes": answer.readings.without_modes,
        "parts": answer.parts.iter().map(changed_part).collect::<Vec<_>>(),
        "model_off": answer.model_off.as_ref().map(model_off),
    });
    if let (Some(all), Some(Value::Object(of_modes))) =
        (all.as_object_mut(), answer.change.as_ref().map(modes))
    {
        all.extend(of_modes);
    }
    all
}

fn modes(change: &SurveyChange) -> Value {
    let (temperature, step_c) = match &change.temperature {
        TemperatureKnowledge::NotMeasured => ("not measured", None),
        TemperatureKnowledge::Same => ("same", Some(0.0)),
        TemperatureKnowledge::Unexplained { step_c } => ("unexplained", Some(*step_c)),
        TemperatureKnowledge::Corrected { step_c } => ("corrected", Some(*step_c)),
    };
    as_json!({
        "temperature": temperature,
        "temperature_step_c": step_c,
        "may_be_the_weather": change.temperature.leaves_doubt(),
        "significance": change.significance,
        "power": change.power,
        "tested": change.tested(),
        "changed": change.changed().count(),
        "damping_tested": change.damping_tested(),
        "damping_changed": change.damping_changed().count(),
        "detectable": change.detectable(),
        "modes": change.modes.iter().map(mode).collect::<Vec<_>>(),
        "lost": change.lost,
        "new": change.new,
        "not_compared": change.not_compared.iter().map(|lost| as_json!({
            "from": lost.from,
            "is_lowest": lost.is_lowest,
            "may_be": lost.may_be,
            "assurance": lost.assurance,
            "relative_change": lost.change().map(|[r, _]| r),
            "uniform_stiffness": lost.change().map(|[_, stiffness]| stiffness),
        })).collect::<Vec<_>>(),
        "other_pairing_hz": change.other_pairing_hz,
        "notes": change.notes.iter().map(Advice::advised).collect::<Vec<_>>(),
    })
}

fn mode(mode: &ModeChange) -> Value {
    as_json!({
        "from": mode.from,
        "to": mode.to,
        "assurance": mode.pair.assurance,
        "places": mode.pair.places,
        "doubtful": mode.pair.doubtful(),
        "frequency": mode.frequency,
        "damping_ratio": mode.damping,
        "explained_by_temperature": mode.explained_by_temperature,
        "temperature_coefficient": mode.fitted,
        "history": mode.history,
        "undecided": mode.is_undecided,
        "explaining_per_c": mode.explaining_per_c,
        "uniform_stiffness": mode.uniform_stiffness,
        "uniform_stiffness_sd": mode.uniform_stiffness_sd,
    })
}

fn history(of: &ComparedHistory) -> Value {
    as_json!({
        "surveys": of.surveys,
        "first": of.span[0],
        "last": of.span[1],
        "passed_over": of.passed_over,
        "lasting": of.lasting.iter().map(lasting).collect::<Vec<_>>(),
    })
}

fn lasting(of: &LastingChange) -> Value {
    let (form, after, before) = match &of.course {
        Course::Step { after, before } => ("step", after, Some(before)),
        Course::Drift { since } => ("slope", since, None),
        Course::Repair(work) => ("repair", &work.date, Some(&work.date)),
    };
    as_json!({
        "frequency_hz": of.frequency_hz,
        "form": form,
        "after": after,
        "before": before,
        "change_ratio": of.ratio,
        "sd": of.sd,
    })
}

fn tilts(readings: &ComparedReadings) -> Value {
    let each = readings.tilts.iter().map(|tilt| {
        as_json!({
            "direction": tilt.direction,
            "from": tilt.from.ratio,
            "to": tilt.to.ratio,
            "change": tilt.change(),
            "same_datum": !readings.other_datum,
        })
    });
    each.collect()
}

fn item(item: &ComparedItem) -> Value {
    let (course, from, to) = match &item.course {
        ItemCourse::New { size } => ("new", None, size.as_ref()),
        ItemCourse::NotFoundAgain => ("not found again", None, None),
        ItemCourse::Sized { from, to } => ("sized", Some(from), Some(to)),
        ItemCourse::NoSize => ("no size", None, None),
        ItemCourse::Several { .. } => ("several", None, None),
    };
    as_json!({
        "part": item.part,
        "what": damage_words(&item.what).text(Language::English),
        "name": item.name,
        "course": course,
        "worse": item.course.is_worse(),
        "from_m": from.map(|size| size.value),
        "to_m": to.map(|size| size.value),
    })
}
