//! `dolmen simulate`: a structure under a ground motion, or pushed.

use crate::cli::Simulate as Options;
use crate::manner::Manner;
use crate::note::note;
use crate::outcome::Outcome;
use crate::progress::Terminal;
use crate::request;
use crate::request::keeping_motion;
use crate::say::{say, say_json};
use crate::typed::Typed;
use crate::wrong::{CommandError, Noted};
use anyhow::Result;
use dolmen_folder::{Found, Outputs};
use dolmen_project::Structure;
use dolmen_report::files::{simulate_answer_value, simulation_files};
use dolmen_report::text::{
    TextStyle, building_simulation_text, chain_simulation_text, frame_simulations_text, settled_text,
    simulation_inputs_text, simulation_text, supports_text, wind_simulation_text,
};
use dolmen_report::{after_first_text, simulation_headline_text, solution_headlines_text};
use dolmen_work::frame::FrameSimulation;
use dolmen_work::judgement::{Verb, first_status, judge_simulation};
use dolmen_work::simulation::Simulation;
use dolmen_work::{FlagVerb, WorkError, prepare, settle, simulate_solutions};

pub(crate) fn run(options: &Options, typed: &Typed, manner: &Manner) -> Result<Outcome> {
    let found = manner.open(&options.project)?;
    typed.refuse_foreign(FlagVerb::Simulate, &[&found.opened.project])?;
    refuse_without_wind(options, typed, &found)?;
    let found = found.with_stiffness_of_surveys(&Terminal::new(manner.quiet))?;
    let how = request::simulation(options, manner)?;
    let prepared = prepare(&found.opened, &how, &found.files)?;
    // pushed, or on moving supports: without a motion there is nothing to scale
    let motion = &how.motion;
    let is_moved = how.push.is_some() || prepared.moves_supports() || prepared.settles();
    if is_moved && prepared.motion().is_none() && (motion.is_changed() || motion.of_files().is_some()) {
        return Err(CommandError::NoMotionToChange.into());
    }
    if !manner.json {
        let variant = options.variant.as_deref();
        let file = &found.opened.file;
        let motions: Vec<_> = prepared.motion().into_iter().chain(prepared.then()).collect();
        say(&simulation_inputs_text(
            prepared.project(),
            file,
            variant,
            &motions,
            manner.style(),
        ))?;
    }
    let terminal = Terminal::new(manner.quiet);
    let first = prepared.run(&terminal)?;
    let solved = simulate_solutions(&found.opened, &how, first, &found.files, &terminal)?;
    let (answer, others) = (&solved.worst, &solved.others);
    if manner.json {
        let mut value = simulate_answer_value(answer);
        if !others.is_empty() {
            value["other_solutions"] = others.iter().map(simulate_answer_value).collect();
        }
        say_json(&value)?;
    } else {
        if answer.does_not_stand.is_none() {
            say(&simulation_headline_text(
                &judge_simulation(answer),
                manner.style(),
            ))?;
        }
        say(&solution_headlines_text(
            &solved.judged,
            solved.differs_from_check,
            manner.style(),
        ))?;
        say(&after_first_text(answer, manner.style()))?;
        // what the directions of a frame share is said once
        let frames: Vec<&FrameSimulation> = answer.simulations.iter().filter_map(Simulation::frame).collect();
        say(&frame_simulations_text(&frames, manner.style()))?;
        let others = answer.simulations.iter().filter(|of| of.frame().is_none());
        for simulation in others {
            say(&text_of(simulation, manner.style()))?;
        }
        if let Some(why) = &answer.does_not_stand {
            let why = why.to_string();
            say(&format!("\n{}\n", Noted::DoesNotStand(why).text(manner)))?;
        }
    }
    if let (Some(folder), true) = (&options.output, answer.does_not_stand.is_none()) {
        let language = manner.language();
        let outputs = keeping_motion(Outputs::of(manner.access(), &found), &options.motion.motion_file);
        for simulation in &answer.simulations {
            outputs.folder(folder, &simulation_files(simulation, answer, language)?)?;
        }
        if !manner.quiet {
            let folder = folder.display().to_string();
            let written = match answer.simulations.first() {
                Some(Simulation::Stack(_) | Simulation::Supports(_) | Simulation::Settled(_)) => {
                    Noted::HistoriesAndFilm(folder)
                }
                _ => Noted::Histories(folder),
            };
            note!("{}", written.text(manner));
        }
    }
    let all = [answer].into_iter().chain(others);
    let statuses = all.map(|answer| judge_simulation(answer).exit_status(Verb::Simulate));
    Ok(Outcome::Judged(first_status(statuses)))
}

/// The check of loose stones: where they come to rest under their own weight.
pub(crate) fn settled(found: &Found, manner: &Manner) -> Result<Outcome> {
    let answer = settle(&found.opened, &Terminal::new(manner.quiet))?;
    let judged = judge_simulation(&answer);
    if manner.json {
        say_json(&simulate_answer_value(&answer))?;
    } else {
        let (project, file, style) = (&found.opened.project, &found.opened.file, manner.style());
        say(&simulation_inputs_text(project, file, None, &[], style))?;
        say(&simulation_headline_text(&judged, style))?;
        for simulation in &answer.simulations {
            say(&text_of(simulation, style))?;
        }
    }
    Ok(Outcome::Judged(judged.exit_status(Verb::Check)))
}

/// Refuses flags of a building without effect in the wind, or without it.
fn refuse_without_wind(options: &Options, typed: &Typed, found: &Found) -> Result<()> {
    if !matches!(found.opened.project.structure, Structure::Building(_)) {
        return Ok(());
    }
    let without = ["seed", "repeats"].into_iter().find(|flag| typed.has(flag));
    match (options.wind, without) {
        (false, Some(flag)) => Err(WorkError::NoWindAsked { flag }.into()),
        (true, _) if typed.has("output-step") => Err(WorkError::OutputStepOfWind.into()),
        _ => Ok(()),
    }
}

fn text_of(simulation: &Simulation, style: TextStyle) -> String {
    match simulation {
        Simulation::Chain(run) => chain_simulation_text(run, style),
        Simulation::Frame(run) => frame_simulations_text(&[run], style),
        Simulation::Stack(run) => simulation_text(run, style),
        Simulation::Supports(run) => supports_text(run, style),
        Simulation::Settled(run) => settled_text(run, style),
        Simulation::Building(run) => building_simulation_text(run, style),
        Simulation::Wind(run) => wind_simulation_text(run, style),
    }
}
