//! The seismic demand at the site of a project.

use crate::chain::loads::AtRest;
use crate::error::WorkError;
use crate::judgement::first_sway;
use crate::part_limit::Compared;
use crate::stack::by_velocity::velocity_demand;
use crate::stack::frequencies::all_modes;
use crate::state::{
    Check, DemandAnswer, Leaning, LocalMechanismAgainstSite, SpectralAt, StackAnswer, TiltCheck,
};
use crate::told::told_both;
use crate::wrong::NotHeld;
use crate::{building, chain, frame};
use dolmen::assess::StackCheckOptions;
use dolmen::assess::demand::{SiteDemand, checked_stack_against_site, circolare_demand};
use dolmen::stability::Verdict;
use dolmen::structure::lowest_frequency_hz;
use dolmen_project::{Project, Quantity, Structure};

/// The demand of the project's site on its structure; `None` if the file has no site.
pub(crate) fn of(
    project: &Project,
    check: &Check,
    tilts: &[TiltCheck],
) -> Result<Option<DemandAnswer>, WorkError> {
    let Some(part) = &project.site else {
        return Ok(None);
    };
    let mut answer = DemandAnswer {
        site: part.demand()?,
        stack: None,
        by_velocity: None,
        local_mechanisms: Vec::new(),
        compared: Compared::default(),
        drift_limit: project.drift_limit.clone(),
        spectral: Vec::new(),
        refused: None,
    };
    let at_rest = at_rest(project, tilts)?;
    for (direction, period_s) in periods(project, check, &at_rest)? {
        let own = own_damping_ratio(project, check, &direction);
        let damping_ratio = answer.site.damping_ratio_of(own);
        match answer.site.spectrum.acceleration_m_s2(period_s, damping_ratio) {
            Ok(acceleration_m_s2) => answer.spectral.push(SpectralAt {
                direction,
                period_s,
                damping_ratio,
                acceleration_m_s2,
            }),
            Err(why) => answer.refused = Some(told_both(&why)),
        }
    }
    match compared(project, check, &at_rest, &answer) {
        Ok(compared) => answer.compared = compared,
        Err(why) => answer.refused = Some(told_both(&why)),
    }
    if let Check::Stack(stack) = check {
        let modes = all_modes(stack);
        if stack.check.verdict == Verdict::Unstable {
            answer.refused = Some(NotHeld::Falls.into());
        } else {
            let options = StackCheckOptions::default();
            let checked = (&stack.stack, &stack.check);
            answer.stack = checked_stack_against_site(checked, &options, &answer.site, modes.as_deref())?;
            answer.local_mechanisms = local_mechanisms(stack, &answer.site);
            let rocks = stack.check.rocking;
            // left out for a table at another damping ratio, or one that ends too early
            answer.by_velocity =
                rocks.and_then(|block| velocity_demand(block, stack.stack.gravity_m_s2(), &answer.site).ok());
            if answer.stack.is_none() {
                answer.refused = Some(NotHeld::NoGround.into());
            }
        }
    }
    Ok(Some(answer))
}

/// The local mechanisms of a stack that can be compared with the site.
fn local_mechanisms(stack: &StackAnswer, site: &SiteDemand) -> Vec<LocalMechanismAgainstSite> {
    let rows = stack.local_mechanisms.iter().flatten();
    let known = rows.filter_map(|row| row.capacity.clone());
    known
        .filter_map(|capacity| {
            let demand = circolare_demand(&capacity, site)?;
            Some(LocalMechanismAgainstSite { capacity, demand })
        })
        .collect()
}

/// A chain in its leaning shape before a motion.
fn at_rest(project: &Project, tilts: &[TiltCheck]) -> Result<Vec<AtRest>, WorkError> {
    let Structure::Chain(part) = &project.structure else {
        return Ok(Vec::new());
    };
    chain::loads::at_rest(
        part,
        &project.loads,
        Leaning::of_chain(part, tilts),
        &mut Quantity::nominal,
    )
}

/// The damping ratio in the file for a direction, or of a building's mode.
fn own_damping_ratio(project: &Project, check: &Check, direction: &str) -> Option<f64> {
    let given = match (&project.structure, check) {
        (Structure::Chain(part), _) => part.damping_ratio.as_ref(),
        (Structure::Frame(part), _) => {
            let own = part.directions.iter().find(|own| own.name == direction);
            own.and_then(|own| own.damping_ratio.as_ref())
        }
        (_, Check::Building(building)) => {
            return first_sway(building, direction).map(|(_, damping_ratio)| damping_ratio);
        }
        _ => None,
    };
    given.map(|given| given.value)
}

/// Storeys, joints and dampers compared with their limits under the spectrum of the site.
fn compared(
    project: &Project,
    check: &Check,
    at_rest: &[AtRest],
    answer: &DemandAnswer,
) -> Result<Compared, WorkError> {
    let limit = answer.drift_limit.as_ref();
    match (&project.structure, check) {
        (Structure::Chain(part), Check::Chain(_)) => {
            let damping_ratio = answer
                .site
                .damping_ratio_of(own_damping_ratio(project, check, "all"));
            chain::limits::by_spectrum(part, at_rest, &answer.site, damping_ratio)
        }
        (Structure::Frame(part), Check::Frame(_)) => frame::limits::by_spectrum(part, &answer.site, limit),
        (_, Check::Building(building)) => Ok(Compared {
            parts: building::limits::by_spectrum(building, limit),
            ..Compared::default()
        }),
        _ => Ok(Compared::default()),
    }
}

/// First periods that are known, by direction, s.
fn periods(project: &Project, check: &Check, at_rest: &[AtRest]) -> Result<Vec<(String, f64)>, WorkError> {
    let of =
        |frequency_hz: f64| (frequency_hz > 0.0 && frequency_hz.is_finite()).then_some(1.0 / frequency_hz);
    Ok(match check {
        Check::Chain(_) => {
            let mut all = Vec::new();
            for of_axis in at_rest {
                let stiffness = match &project.structure {
                    Structure::Chain(part) => part.stiffness_towards(of_axis.axis, &mut Quantity::nominal),
                    _ => None,
                };
                let Some(stiffness) = stiffness else { continue };
                let frequency_hz = lowest_frequency_hz(&of_axis.chain.natural_modes(&stiffness)?);
                let direction = match at_rest.len() {
                    1 => "all",
                    _ => of_axis.axis.name(),
                };
                all.extend(
                    frequency_hz
                        .and_then(of)
                        .map(|period_s| (direction.to_owned(), period_s)),
                );
            }
            all
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
            let known = stack.frequencies_of_demand();
            let sway = |direction: &str| known.and_then(|known| known.sway(direction));
            let each = ["x", "y"].into_iter().filter_map(|direction| {
                let (_, hz) = sway(direction)?;
                Some((direction.to_owned(), of(hz)?))
            });
            each.collect()
        }
    })
}
