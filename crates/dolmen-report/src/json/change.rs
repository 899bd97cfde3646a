//! `dolmen compare` as JSON.

use super::check::project;
use dolmen::assess::{Difference, FittedTemperature, ModeChange, SurveyChange, TemperatureKnowledge};
use dolmen::modal::ObservedMode;
use dolmen_project::Project;
use dolmen_words::advice::Advice;
use serde_json::{Value, json};

/// What changed from one survey to another.
pub fn change_json(of: &Project, file: &str, change: &SurveyChange) -> Value {
    let (temperature, step_c) = match &change.temperature {
        TemperatureKnowledge::NotMeasured => ("not measured", None),
        TemperatureKnowledge::Same => ("same", Some(0.0)),
        TemperatureKnowledge::Unexplained { step_c } => ("unexplained", Some(*step_c)),
        TemperatureKnowledge::Corrected { step_c } => ("corrected", Some(*step_c)),
    };
    json!({
        "project": project(of, file),
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
        "lost": change.lost.iter().map(observed).collect::<Vec<_>>(),
        "new": change.new.iter().map(observed).collect::<Vec<_>>(),
        "not_compared": change.not_compared.iter().map(|lost| json!({
            "from": observed(&lost.from),
            "is_lowest": lost.is_lowest,
            "may_be": lost.may_be.as_ref().map(observed),
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
        "from": observed(&mode.from),
        "to": observed(&mode.to),
        "assurance": mode.pair.assurance,
        "places": mode.pair.places,
        "doubtful": mode.pair.doubtful(),
        "frequency": difference(&mode.frequency),
        "damping_ratio": mode.damping.as_ref().map(difference),
        "explained_by_temperature": mode.explained_by_temperature,
        "temperature_coefficient": mode.fitted.as_ref().map(fitted),
        "explaining_per_c": mode.explaining_per_c,
        "uniform_stiffness": mode.uniform_stiffness,
        "uniform_stiffness_sd": mode.uniform_stiffness_sd,
    })
}

fn observed(mode: &ObservedMode) -> Value {
    json!({
        "frequency_hz": mode.frequency_hz,
        "frequency_sd_hz": mode.frequency_sd_hz,
        "damping_ratio": mode.damping_ratio,
        "damping_ratio_sd": mode.damping_ratio_sd,
        "direction": mode.direction,
    })
}

fn difference(d: &Difference) -> Value {
    let finite = |x: f64| x.is_finite().then_some(x);
    json!({
        "relative": d.relative,
        "evidence": d.evidence.as_ref().map(|e| json!({
            "sd": e.sd,
            "half_width_95": e.half_width_95,
            "degrees_of_freedom": finite(e.degrees_of_freedom),
            "statistic": e.statistic,
            "p": e.p,
            "p_holm": e.p_holm,
            "significant": e.significant,
            "detectable": e.detectable,
        })),
    })
}

fn fitted(line: &FittedTemperature) -> Value {
    json!({
        "per_c": line.per_c,
        "sd_per_c": line.sd_per_c,
        "scatter_hz": line.scatter_hz,
        "surveys": line.surveys,
        "range_c": line.range_c,
    })
}
