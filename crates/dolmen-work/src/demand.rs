//! What an earthquake asks for at the site of a project.

use crate::error::WorkError;
use crate::judgement::first_sway;
use crate::part_limit::PartLimit;
use crate::state::{Check, DemandAnswer, SpectralAt};
use crate::told::told;
use crate::{building, chain, frame};
use dolmen::assess::StackCheckOptions;
use dolmen::assess::demand::stack_against_site;
use dolmen::stability::Verdict;
use dolmen::structure::lowest_frequency_hz;
use dolmen_project::{Project, Structure};

/// The demand of the project's site on its structure; `None` if the file has no site.
pub(crate) fn of(project: &Project, check: &Check) -> Result<Option<DemandAnswer>, WorkError> {
    let Some(part) = &project.site else {
        return Ok(None);
    };
    let mut answer = DemandAnswer {
        site: part.demand()?,
        stack: None,
        parts: Vec::new(),
        drift_limit: project.drift_limit.clone(),
        spectral: Vec::new(),
        refused: None,
    };
    for (direction, period_s) in periods(check) {
        // of a building the modes' own damping is known, and its response is read at that
        let own = match check {
            Check::Building(building) => {
                first_sway(building, &direction).map(|(_, damping_ratio)| damping_ratio)
            }
            _ => None,
        };
        let damping_ratio = own.unwrap_or(answer.site.damping_ratio);
        match answer.site.spectrum.acceleration_m_s2(period_s, damping_ratio) {
            Ok(acceleration_m_s2) => answer.spectral.push(SpectralAt {
                direction,
                period_s,
                damping_ratio,
                acceleration_m_s2,
            }),
            Err(why) => answer.refused = Some(told(&why)),
        }
    }
    match parts(project, check, &answer) {
        Ok(parts) => answer.parts = parts,
        Err(why) => answer.refused = Some(told(&why)),
    }
    if let Check::Stack(stack) = check {
        let modes = stack.frequencies.as_ref().and_then(|known| known.modes());
        if stack.check.verdict == Verdict::Unstable {
            answer.refused = Some("it does not stand without shaking".to_owned());
        } else {
            let options = StackCheckOptions::default();
            answer.stack = stack_against_site(&stack.stack, &options, &answer.site, modes)?;
            if answer.stack.is_none() {
                let why = "the table gives no acceleration of the ground: begin it at T = 0, or write peak_ground_acceleration";
                answer.refused = Some(why.to_owned());
            }
        }
    }
    Ok(Some(answer))
}

/// Storeys, joints and dampers against what limits them under the spectrum of the site.
fn parts(project: &Project, check: &Check, answer: &DemandAnswer) -> Result<Vec<PartLimit>, WorkError> {
    let limit = answer.drift_limit.as_ref();
    match (&project.structure, check) {
        (Structure::Chain(part), Check::Chain(_)) => chain::limits::by_spectrum(part, &answer.site),
        (Structure::Frame(part), Check::Frame(_)) => frame::limits::by_spectrum(part, &answer.site, limit),
        (_, Check::Building(building)) => Ok(building::limits::by_spectrum(building, limit)),
        _ => Ok(Vec::new()),
    }
}

/// First periods that are known, by direction, s.
fn periods(check: &Check) -> Vec<(String, f64)> {
    let of =
        |frequency_hz: f64| (frequency_hz > 0.0 && frequency_hz.is_finite()).then_some(1.0 / frequency_hz);
    match check {
        Check::Chain(chain) => {
            let period = lowest_frequency_hz(&chain.modes).and_then(of);
            period
                .into_iter()
                .map(|period_s| ("all".to_owned(), period_s))
                .collect()
        }
        Check::Frame(directions) => {
            let each = directions.iter().filter_map(|direction| {
                let period_s = of(lowest_frequency_hz(&direction.check.modes)?)?;
                Some((direction.direction.clone(), period_s))
            });
            each.collect()
        }
        Check::Building(answer) => {
            let each = ["x", "y"].into_iter().filter_map(|direction| {
                let (hz, _) = first_sway(answer, direction)?;
                Some((direction.to_owned(), of(hz)?))
            });
            each.collect()
        }
        Check::Stack(stack) => {
            let known = stack.frequencies.as_ref();
            let sway = |direction: &str| known.and_then(|known| known.sway(direction));
            let each = ["x", "y"].into_iter().filter_map(|direction| {
                let (_, hz) = sway(direction)?;
                Some((direction.to_owned(), of(hz)?))
            });
            each.collect()
        }
    }
}
