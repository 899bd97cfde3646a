//! `dolmen simulate` of a chain: pushed, or on a moving ground, up to its fall.

use crate::cli::{Rotations, Simulate as Options};
use crate::simulate::{language, with_progress};
use crate::simulate_frame::horizontal;
use crate::{Outcome, files};
use anyhow::{Context as _, Result, bail};
use dolmen::dynamics::{ChainRotations, ChainRun, TimeFunction, chain_growth, simulate_chain};
use dolmen_project::{ChainPart, Names, Project, Quantity, parse_angle_rad};
use dolmen_report::figures::chain_histories;
use dolmen_report::json::chain_simulation_json;
use dolmen_report::text::chain_simulation_text;
use dolmen_words::Language;
use dolmen_work::simulation::{
    ChainSimulation, MotionAnswer, chain_energy_csv, chain_histories_csv, chain_slips_csv, chain_uplifts_csv,
};
use dolmen_work::study::SWING_REST_S;
use std::path::Path;

/// Length of a run that begins with a push alone, s: a pole of 0.3 Hz swings twenty times. Chosen here.
const PUSHED_S: f64 = 60.0;
/// Largest push, rad: a chain that leans more is set up wrongly.
const PUSH_MOST_RAD: f64 = 0.5;

/// The wish of a user, as far as it concerns chains.
pub(crate) struct Wish<'a> {
    pub(crate) variant: Option<(&'a str, Option<Names>)>,
    pub(crate) push_rad: f64,
    pub(crate) rotations: ChainRotations,
    pub(crate) duration_s: Option<f64>,
    pub(crate) output_step_s: f64,
}

pub(crate) fn run(
    options: &Options,
    (project, part): (&Project, &ChainPart),
    (file, title): (&str, Option<Names>),
    motion: Option<MotionAnswer>,
    (as_json, quiet): (bool, bool),
) -> Result<Outcome> {
    if options.direction.is_some() {
        bail!("--direction names a direction of a frame: a chain moves in one plane");
    }
    let push_rad = match &options.push {
        None => 0.0,
        Some(text) => parse_angle_rad(text).context("--push")?,
    };
    if push_rad.abs() > PUSH_MOST_RAD {
        bail!("--push is {push_rad} rad, but must be at most {PUSH_MOST_RAD} rad in size");
    }
    if motion.is_none() && push_rad == 0.0 {
        bail!(
            "nothing moves the chain: give --motion or --motion-file, or let it lean at the start with --push \"1e-4 rad\""
        );
    }
    let wish = Wish {
        variant: options.variant.as_deref().map(|name| (name, title)),
        push_rad,
        rotations: match options.rotations {
            Rotations::Large => ChainRotations::Large,
            Rotations::Small => ChainRotations::Small,
        },
        duration_s: options.duration,
        output_step_s: options.output_step,
    };
    let simulation = simulation((project, part), file, motion, &wish, quiet)?;
    if as_json {
        files::say(&format!("{:#}\n", chain_simulation_json(&simulation)))?;
    } else {
        files::say(&chain_simulation_text(&simulation))?;
    }
    if let Some(folder) = &options.output {
        write(&simulation, folder, language(options.language))?;
        if !quiet {
            note!("histories and figures are in {}", folder.display());
        }
    }
    Ok(match (simulation.falls(), simulation.is_whole()) {
        (true, _) => Outcome::Falls,
        (false, true) => Outcome::Stands,
        (false, false) => Outcome::Unfinished,
    })
}

/// The run itself.
pub(crate) fn simulation(
    (project, part): (&Project, &ChainPart),
    file: &str,
    motion: Option<MotionAnswer>,
    wish: &Wish<'_>,
    quiet: bool,
) -> Result<ChainSimulation> {
    let Some(model) = part.moving(wish.rotations, &mut Quantity::nominal)? else {
        bail!(
            "the joints are unknown: `dolmen identify` finds stiffness that measured modes allow; write it into joints or into a variant, \
             and simulate that with --variant"
        );
    };
    let motion = match motion {
        None => None,
        Some(motion) => {
            let component = horizontal(&motion, "a chain")?;
            Some((motion, component))
        }
    };
    let load = match &motion {
        None => TimeFunction::Zero,
        Some((motion, component)) => TimeFunction::of_motion(&motion.motion, *component),
    };
    let run_s = wish.duration_s.unwrap_or(match &motion {
        None => PUSHED_S,
        Some((motion, _)) => motion.motion.duration_s() + SWING_REST_S,
    });
    let options = ChainRun {
        duration_s: Some(run_s),
        output_step_s: wish.output_step_s,
        start_rotation_rad: vec![wish.push_rad; part.links.len()],
        ..ChainRun::default()
    };
    let history = with_progress(run_s, quiet, |progress| {
        simulate_chain(&model, &load, &options, progress)
    })?;
    let stiffness: Vec<f64> = model
        .joints()
        .iter()
        .map(|joint| joint.stiffness_n_m_rad)
        .collect();
    let modes = model.chain().natural_modes(&stiffness)?;
    let growth = chain_growth(&model, &history)?;
    let each = part.links.iter().enumerate();
    Ok(ChainSimulation {
        file: file.to_owned(),
        name: project.name.clone(),
        variant: wish.variant.as_ref().map(|(name, _)| (*name).to_owned()),
        variant_title: wish.variant.as_ref().and_then(|(_, title)| title.clone()),
        links: each
            .map(|(i, link)| link.name.clone().unwrap_or_else(|| format!("link {}", i + 1)))
            .collect(),
        first_frequency_hz: match &growth {
            Some(_) => None,
            None => modes.first().map(|mode| mode.frequency_hz),
        },
        model,
        motion,
        push_rad: wish.push_rad,
        options,
        growth,
        history,
    })
}

fn write(simulation: &ChainSimulation, folder: &Path, language: Language) -> Result<()> {
    let put = |name: &str, bytes: &[u8]| files::write(&folder.join(name), bytes);
    put(
        "simulation.json",
        format!("{:#}\n", chain_simulation_json(simulation)).as_bytes(),
    )?;
    put("histories.csv", chain_histories_csv(simulation).as_bytes())?;
    put("slips.csv", chain_slips_csv(simulation).as_bytes())?;
    put("openings.csv", chain_uplifts_csv(simulation).as_bytes())?;
    put("energy.csv", chain_energy_csv(simulation).as_bytes())?;
    for figure in chain_histories(simulation, language) {
        put(&format!("{}.svg", figure.name), figure.svg.as_bytes())?;
    }
    Ok(())
}
