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
use dolmen_report::files::{simulate_answer_value, simulation_files};
use dolmen_report::simulation_headline_text;
use dolmen_report::text::{
    TextStyle, building_simulation_text, chain_simulation_text, frame_simulation_text,
    simulation_inputs_text, simulation_text,
};
use dolmen_work::judgement::{Verb, judge_simulation};
use dolmen_work::simulation::Simulation;
use dolmen_work::{FlagVerb, prepare};

pub(crate) fn run(options: &Options, typed: &Typed, manner: &Manner) -> Result<Outcome> {
    let found = Found::open(&options.project, manner.access())?;
    typed.refuse_foreign(FlagVerb::Simulate, &[&found.opened.project])?;
    let how = request::simulation(options, manner)?;
    // a push needs no motion, and then nothing is there to be changed
    let motion = &how.motion;
    if how.push.is_some() && !motion.is_given() && (motion.is_changed() || motion.of_files().is_some()) {
        return Err(CommandError::NoMotionToChange.into());
    }
    let prepared = prepare(&found.opened, &how, &found.files)?;
    if !manner.json {
        let variant = options.variant.as_deref();
        let file = &found.opened.file;
        say(&simulation_inputs_text(
            prepared.project(),
            file,
            variant,
            prepared.motion(),
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
                Some(Simulation::Stack(_)) => Noted::HistoriesAndFilm { folder },
                _ => Noted::Histories { folder },
            };
            note!("{}", written.text(manner));
        }
    }
    Ok(Outcome::Judged(
        judge_simulation(&answer).exit_status(Verb::Simulate),
    ))
}

fn text_of(simulation: &Simulation, style: TextStyle) -> String {
    match simulation {
        Simulation::Chain(run) => chain_simulation_text(run, style),
        Simulation::Frame(run) => frame_simulation_text(run, style),
        Simulation::Stack(run) => simulation_text(run, style),
        Simulation::Building(run) => building_simulation_text(run, style),
    }
}
