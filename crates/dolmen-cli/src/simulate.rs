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
    TextStyle, building_simulation_text, chain_simulation_text, frame_simulation_text,
    simulation_inputs_text, simulation_text, supports_text, wind_simulation_text,
};
use dolmen_report::{after_first_text, simulation_headline_text};
use dolmen_work::judgement::{Verb, judge_simulation};
use dolmen_work::simulation::Simulation;
use dolmen_work::{FlagVerb, WorkError, prepare};

pub(crate) fn run(options: &Options, typed: &Typed, manner: &Manner) -> Result<Outcome> {
    let found = Found::open(&options.project, manner.access())?;
    typed.refuse_foreign(FlagVerb::Simulate, &[&found.opened.project])?;
    refuse_without_wind(options, typed, &found)?;
    let how = request::simulation(options, manner)?;
    let prepared = prepare(&found.opened, &how, &found.files)?;
    // pushed, or on supports that move: without a motion nothing is there to be changed
    let motion = &how.motion;
    let is_moved = how.push.is_some() || prepared.moves_supports();
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
    let answer = prepared.run(&Terminal::new(manner.quiet))?;
    if manner.json {
        say_json(&simulate_answer_value(&answer))?;
    } else {
        if answer.does_not_stand.is_none() {
            say(&simulation_headline_text(
                &judge_simulation(&answer),
                manner.style(),
            ))?;
        }
        say(&after_first_text(&answer, manner.style()))?;
        for simulation in &answer.simulations {
            say(&text_of(simulation, manner.style()))?;
        }
        if let Some(why) = &answer.does_not_stand {
            let why = why.to_string();
            say(&format!("\n{}\n", Noted::DoesNotStand { why }.text(manner)))?;
        }
    }
    if let (Some(folder), true) = (&options.output, answer.does_not_stand.is_none()) {
        let language = manner.language();
        let outputs = keeping_motion(Outputs::of(manner.access(), &found), &options.motion.motion_file);
        for simulation in &answer.simulations {
            outputs.folder(folder, &simulation_files(simulation, &answer, language)?)?;
        }
        if !manner.quiet {
            let folder = folder.display().to_string();
            let written = match answer.simulations.first() {
                Some(Simulation::Stack(_) | Simulation::Supports(_)) => Noted::HistoriesAndFilm { folder },
                _ => Noted::Histories { folder },
            };
            note!("{}", written.text(manner));
        }
    }
    Ok(Outcome::Judged(
        judge_simulation(&answer).exit_status(Verb::Simulate),
    ))
}

/// Refuses flags of a building that have no effect with the wind, or without it.
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
        Simulation::Frame(run) => frame_simulation_text(run, style),
        Simulation::Stack(run) => simulation_text(run, style),
        Simulation::Supports(run) => supports_text(run, style),
        Simulation::Building(run) => building_simulation_text(run, style),
        Simulation::Wind(run) => wind_simulation_text(run, style),
    }
}
