//! A simulation as files: histories, figures, animations, and formats of other programs.

use super::named::NamedFile;
use super::paraview::paraview;
use crate::after_first::after_first_json;
use crate::as_json;
use crate::figures::{self, building_histories, chain_histories, frame_histories, wind_histories};
use crate::film::{settled_films, stack_film, supports_film};
use crate::json::{
    building_simulation_json, chain_simulation_json, frame_simulation_json, judgement, settled_json,
    simulation_json, stack_runs_json, supports_json, wind_simulation_json,
};
use crate::tables::{
    building_histories_csv, building_peaks_csv, chain_energy_csv, chain_histories_csv, chain_slips_csv,
    chain_uplifts_csv, energy_csv, frame_energy_csv, frame_histories_csv, frame_slips_csv, joints_csv,
    poses_csv, supports_csv, wind_histories_csv, wind_peaks_csv,
};
use dolmen_records::meshes::{PoseError, stack_3dec, stack_json, stack_obj};
use dolmen_words::{Language, keeping_names};
use dolmen_work::judgement::{judge_run, judge_simulation};
use dolmen_work::simulation::{SimulateAnswer, Simulation};
use dolmen_work::stack::{SettledSimulation, StackRuns, StackSimulation, SupportsSimulation};
use serde_json::Value;

/// The result of `dolmen simulate` as JSON: each direction of a frame, and one judgement of all.
pub fn simulate_answer_value(answer: &SimulateAnswer) -> Value {
    if let Some(why) = &answer.does_not_stand {
        let outcome = as_json!({ "kind": "does_not_stand", "why": why.to_string() });
        return as_json!({ "file": answer.file, "outcome": outcome });
    }
    match answer.simulations.as_slice() {
        [] => as_json!({ "simulations": [] }),
        [Simulation::Frame(_), ..]
        | [Simulation::Chain(_), Simulation::Chain(_), ..]
        | [Simulation::Settled(_), Simulation::Settled(_), ..] => {
            let each = answer.simulations.iter();
            let all: Vec<Value> = each.map(|run| simulation_value(run, answer)).collect();
            let after = after_first_json(answer);
            as_json!({ "judgement": judgement(&judge_simulation(answer)), "after": after, "simulations": all })
        }
        [one, ..] => simulation_value(one, answer),
    }
}

/// A simulation of any kind as JSON, judged with the answer's evidence for the model.
pub(crate) fn simulation_value(simulation: &Simulation, of: &SimulateAnswer) -> Value {
    let mut value = match simulation {
        Simulation::Chain(run) => chain_simulation_json(run),
        Simulation::Frame(run) => frame_simulation_json(run),
        Simulation::Stack(runs) => stack_runs_json(runs),
        Simulation::Supports(run) => supports_json(run),
        Simulation::Settled(run) => settled_json(run),
        Simulation::Building(run) => building_simulation_json(run),
        Simulation::Wind(run) => wind_simulation_json(run),
    };
    value["judgement"] = judgement(&judge_run(simulation, of));
    value["after"] = after_first_json(of);
    value
}

/// All files of a simulation; each direction of a frame has its own folder.
///
/// # Errors
/// [`PoseError`] if a history lacks the pose of a block.
pub fn simulation_files(
    simulation: &Simulation,
    of: &SimulateAnswer,
    language: Language,
) -> Result<Vec<NamedFile>, PoseError> {
    let value = keeping_names(|| simulation_value(simulation, of));
    let mut files = vec![NamedFile::json("simulation.json", &value)];
    let mut put = |name: &str, text: String| files.push(NamedFile::new(name, text));
    let figures = match simulation {
        Simulation::Chain(run) => {
            put("histories.csv", chain_histories_csv(run));
            put("slips.csv", chain_slips_csv(run));
            put("openings.csv", chain_uplifts_csv(run));
            put("energy.csv", chain_energy_csv(run));
            chain_histories(run, language)
        }
        Simulation::Frame(run) => {
            put("histories.csv", frame_histories_csv(run));
            put("slips.csv", frame_slips_csv(run));
            put("energy.csv", frame_energy_csv(run));
            frame_histories(run, language)
        }
        Simulation::Stack(runs) => {
            files.extend(stack(&runs.deciding, language)?);
            files.extend(other_law(runs, language)?);
            figures::stack_histories(&runs.deciding, language)
        }
        Simulation::Supports(of) => {
            files.extend(supports(of, language));
            Vec::new()
        }
        Simulation::Settled(of) => {
            files.extend(settled(of));
            Vec::new()
        }
        Simulation::Building(run) => {
            put("histories.csv", building_histories_csv(run));
            put("peaks.csv", building_peaks_csv(run));
            building_histories(run, language)
        }
        Simulation::Wind(run) => {
            put("histories.csv", wind_histories_csv(run));
            put("peaks.csv", wind_peaks_csv(run));
            wind_histories(run, language)
        }
    };
    files.extend(figures.into_iter().map(NamedFile::figure));
    Ok(match simulation {
        Simulation::Frame(run) => {
            let within = |file: NamedFile| file.within(&run.direction);
            files.into_iter().map(within).collect()
        }
        Simulation::Chain(run) => match run.direction {
            None => files,
            Some(axis) => files.into_iter().map(|file| file.within(axis.name())).collect(),
        },
        Simulation::Stack(_)
        | Simulation::Supports(_)
        | Simulation::Settled(_)
        | Simulation::Building(_)
        | Simulation::Wind(_) => files,
    })
}

/// Moving supports: the figure, and each run in a folder of its law.
fn supports(of: &SupportsSimulation, language: Language) -> Vec<NamedFile> {
    let mut files = vec![NamedFile::svg(
        "supports",
        &figures::supports_in_time(of, language),
    )];
    for run in &of.runs {
        let own = [
            NamedFile::new("poses.csv", supports_csv(of, run)),
            NamedFile::new("film.glb", supports_film(of, run)),
        ];
        files.extend(own.map(|file| file.within(run.law.name())));
    }
    files
}

/// Loose stones: for each law, in a folder of its name, the stones at rest and the film of how they settle and move.
fn settled(of: &SettledSimulation) -> Vec<NamedFile> {
    let mut files = Vec::new();
    for run in &of.runs {
        files.push(NamedFile::new("stack.obj", stack_obj(&run.settled.stack)).within(run.law.name()));
        for (name, film) in settled_films(of, run) {
            files.push(NamedFile::new(name, film).within(run.law.name()));
        }
    }
    files
}

/// The run of the law that does not decide, in a folder of its name.
fn other_law(runs: &StackRuns, language: Language) -> Result<Vec<NamedFile>, PoseError> {
    let Some(run) = &runs.other else {
        return Ok(Vec::new());
    };
    let mut files = vec![NamedFile::json(
        "simulation.json",
        &keeping_names(|| simulation_json(run)),
    )];
    files.extend(stack(run, language)?);
    let figures = figures::stack_histories(run, language);
    files.extend(figures.into_iter().map(NamedFile::figure));
    let within = |file: NamedFile| file.within(run.law.name());
    Ok(files.into_iter().map(within).collect())
}

fn stack(simulation: &StackSimulation, language: Language) -> Result<Vec<NamedFile>, PoseError> {
    let stack = &simulation.stack;
    let limits = &simulation.limits;
    let shaking = figures::Shaking {
        motion: Some(simulation.peak_horizontal_g()),
        ..Default::default()
    };
    let mut files = vec![
        NamedFile::new("joints.csv", joints_csv(simulation)),
        NamedFile::new("poses.csv", poses_csv(simulation)),
        NamedFile::new("energy.csv", energy_csv(simulation)),
        NamedFile::new("film.glb", stack_film(simulation)),
        NamedFile::new("stack.obj", stack_obj(stack)),
        NamedFile::new("stack.json", stack_json(stack)),
        NamedFile::new("stack.3ddat", stack_3dec(stack)),
        NamedFile::svg("after", &figures::stack_after(simulation, language)),
        NamedFile::svg("governing", &figures::stack_governing(limits, &shaking, language)),
        NamedFile::svg("capacity", &figures::stack_capacity(limits, &shaking, language)),
    ];
    files.extend(paraview(simulation)?);
    Ok(files)
}
