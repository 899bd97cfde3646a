//! Fragility curves for OpenQuake: NRML 0.5, continuous, lognormal.
//!
//! ```text
//! mean = θ exp(β²/2)        stddev = mean √(exp(β²) − 1)        of the capacity, not of its logarithm
//! PGA and SA in g, PGV in cm/s
//! ```
//!
//! # Source
//! OpenQuake engine manual, "Fragility models": `fragilityFunction format="continuous" shape="logncdf"`.

use super::named::NamedFile;
use dolmen::assess::{Fragility, FragilityFit};
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen_work::study::{CombinationFragility, ShakingMeasure, StateFragility, StudyAnswer};
use std::fmt::Write as _;

/// Share of the capacities beyond the ends of a curve's range: of the weakest state below, and of the strongest above. OpenQuake extends a curve
/// with its end values; below the lower end NRML assumes no damage, otherwise frequent weak shaking would count with this share. Our choice.
const END: f64 = 1e-6;

/// OpenQuake's name of a measure, and its unit relative to SI; `None` for unknown measures.
fn imt(measure: Option<ShakingMeasure>) -> Option<(String, f64)> {
    match measure {
        None => Some(("PGA".to_owned(), 1.0 / STANDARD_GRAVITY_M_S2)),
        Some(ShakingMeasure::PeakVelocity) => Some(("PGV".to_owned(), 100.0)),
        Some(ShakingMeasure::Spectral { period_s, .. }) => {
            Some((format!("SA({period_s})"), 1.0 / STANDARD_GRAVITY_M_S2))
        }
        Some(ShakingMeasure::UpliftRatio | ShakingMeasure::VelocityRatio) => None,
    }
}

/// One model for each measure that OpenQuake knows and for which all combinations have a curve of a state: `fragility_PGA.xml` and similar.
pub(super) fn nrml_files(answer: &StudyAnswer) -> Vec<NamedFile> {
    let measures = std::iter::once(None).chain(answer.measures().into_iter().map(Some));
    let each = measures.filter_map(|measure| {
        let (name, per_si) = imt(measure)?;
        let text = model(answer, (measure, &name, per_si))?;
        let stem = name.replace(['(', ')'], "_");
        Some(NamedFile::new(
            &format!("fragility_{}.xml", stem.trim_end_matches('_')),
            text,
        ))
    });
    each.collect()
}

/// The curve of a state over a measure.
fn fit(state: &StateFragility, measure: Option<ShakingMeasure>) -> Option<&FragilityFit> {
    match measure {
        None => state.by_acceleration.as_ref().ok(),
        Some(measure) => {
            let own = state.by_measure.iter().find(|by| by.measure == measure)?;
            own.fit.as_ref().ok()
        }
    }
}

/// The states with a curve in every combination: OpenQuake requires the same limit states in all functions.
fn common_states(found: &[CombinationFragility], measure: Option<ShakingMeasure>) -> Vec<usize> {
    let has = |one: &CombinationFragility, state: usize| {
        let own = one.states.iter().find(|own| own.state == state);
        own.is_some_and(|own| fit(own, measure).is_some())
    };
    (0..4)
        .filter(|state| !found.is_empty() && found.iter().all(|one| has(one, *state)))
        .collect()
}

fn model(
    answer: &StudyAnswer,
    (measure, imt, per_si): (Option<ShakingMeasure>, &str, f64),
) -> Option<String> {
    let found = answer.fragilities();
    let states = common_states(found, measure);
    // OpenQuake's curves begin at 0; those of structures that may fall by themselves begin higher
    let mut own = found.iter().flat_map(|one| &one.states);
    if states.is_empty() || own.any(|own| own.fell_alone > 0) {
        return None;
    }
    let names = answer.kind.states().map(|name| name.replace(' ', "_"));
    let named: Vec<&str> = states.iter().map(|state| names[*state].as_str()).collect();
    let study = answer.study.name.as_str();
    let mut out = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<nrml xmlns=\"http://openquake.org/xmlns/nrml/0.5\">\n\
         <fragilityModel id=\"{}\" assetCategory=\"buildings\" lossCategory=\"structural\">\n\
         <description>{}</description>\n<limitStates>{}</limitStates>\n",
        escaped(study),
        escaped(&format!(
            "{}, study {study}{}, Dolmen {}: lognormal curves fitted to simulations",
            answer.name.english(),
            match &answer.study.after {
                Some(after) => format!(
                    ", AFTER {}: of the structure as that motion leaves it",
                    after.motion
                ),
                None => String::new(),
            },
            answer.version
        )),
        named.join(" "),
    );
    for one in found {
        out += &function(answer, one, &states, (measure, imt, per_si))?;
    }
    out += "</fragilityModel>\n</nrml>\n";
    Some(out)
}

/// The curves of one combination.
fn function(
    answer: &StudyAnswer,
    one: &CombinationFragility,
    states: &[usize],
    (measure, imt, per_si): (Option<ShakingMeasure>, &str, f64),
) -> Option<String> {
    let curves: Vec<(usize, Fragility)> = states
        .iter()
        .filter_map(|state| {
            let own = one.states.iter().find(|own| own.state == *state)?;
            Some((*state, fit(own, measure)?.curve))
        })
        .collect();
    let end = |probability: f64, pick: fn(f64, f64) -> f64, from: f64| -> Option<f64> {
        let mut ends = curves.iter().map(|(_, curve)| curve.intensity(probability).ok());
        ends.try_fold(from, |end, one| Some(pick(end, one?)))
    };
    let (least, most) = (end(END, f64::min, f64::INFINITY)?, end(1.0 - END, f64::max, 0.0)?);
    let words = answer.combination_words(one.job);
    let mut id = format!("{}-{}", answer.study.name, one.combination + 1);
    id.retain(|c| !c.is_whitespace());
    let mut out = String::new();
    if !words.is_empty() {
        // two hyphens would end a comment
        let _ = writeln!(out, "<!-- {} -->", escaped(&words).replace("--", "- -"));
    }
    let _ = writeln!(
        out,
        "<fragilityFunction id=\"{}\" format=\"continuous\" shape=\"logncdf\">\n\
         <imls imt=\"{imt}\" noDamageLimit=\"{least:e}\" minIML=\"{least:e}\" maxIML=\"{:e}\"/>",
        escaped(&id),
        most * per_si,
        least = least * per_si
    );
    let names = answer.kind.states().map(|name| name.replace(' ', "_"));
    for (state, curve) in curves {
        let square = curve.beta().powi(2);
        let mean = curve.theta() * per_si * (0.5 * square).exp();
        let _ = writeln!(
            out,
            "<params ls=\"{}\" mean=\"{mean}\" stddev=\"{}\"/>",
            escaped(&names[state]),
            mean * square.exp_m1().sqrt()
        );
    }
    out += "</fragilityFunction>\n";
    Some(out)
}

/// A text within XML.
fn escaped(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '&' => out += "&amp;",
            '<' => out += "&lt;",
            '>' => out += "&gt;",
            '"' => out += "&quot;",
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out
}
