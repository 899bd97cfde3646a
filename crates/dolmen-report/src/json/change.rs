//! `dolmen compare` as JSON.

use super::check::project;
use super::identify::modes_of;
use dolmen::assess::{ModeChange, TemperatureKnowledge};
use dolmen_words::advice::Advice;
use dolmen_work::answer::CompareAnswer;
use serde_json::{Value, json};

/// What changed from one survey to another.
pub fn change_json(answer: &CompareAnswer) -> Value {
    let change = &answer.change;
    let (temperature, step_c) = match &change.temperature {
        TemperatureKnowledge::NotMeasured => ("not measured", None),
        TemperatureKnowledge::Same => ("same", Some(0.0)),
        TemperatureKnowledge::Unexplained { step_c } => ("unexplained", Some(*step_c)),
        TemperatureKnowledge::Corrected { step_c } => ("corrected", Some(*step_c)),
    };
    json!({
        "project": project(&answer.project, &answer.file),
        "earthquakes": answer.shaken.iter().map(|(survey, of)| json!({ "survey": survey, "modes_of": modes_of(*of) })).collect::<Vec<_>>(),
        "from": change.from,
        "to": change.to,
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
        "not_compared": change.not_compared.iter().map(|lost| json!({
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
    json!({
        "from": mode.from,
        "to": mode.to,
        "assurance": mode.pair.assurance,
        "places": mode.pair.places,
        "doubtful": mode.pair.doubtful(),
        "frequency": mode.frequency,
        "damping_ratio": mode.damping,
        "explained_by_temperature": mode.explained_by_temperature,
        "temperature_coefficient": mode.fitted,
        "explaining_per_c": mode.explaining_per_c,
        "uniform_stiffness": mode.uniform_stiffness,
        "uniform_stiffness_sd": mode.uniform_stiffness_sd,
    })
}
