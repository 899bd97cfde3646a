//! `dolmen identify`: records → modes → stiffness.

use crate::cli::Identify as Options;
use crate::{Outcome, files, open};
use anyhow::{Context as _, Result, bail};
use dolmen::modal::{Identify, MergeSetups, Modes, identify, joint_setups, merge_setups};
use dolmen::signal::{Channel, Record};
use dolmen::stability::{chain_stability, frame_stability};
use dolmen::structure::{
    Chain, ChainStiffness, Convention, Frame, FrameStiffness, MeasuredMode, StiffnessNote, StiffnessSolution,
    StiffnessSolutions, chain_stiffness, directional_modes, frame_stiffness,
};
use dolmen_project::{Merge, ModeKind, Project, Quantity, RecordSource, Structure, Survey};
use dolmen_report::figures;
use dolmen_report::json::identification_json;
use dolmen_report::text::identification_text;
use dolmen_words::Language;
use dolmen_work::answer::{
    Answer, RecordAnswer, SensitivityOf, SetupsAnswer, StiffnessAnswer, SurveyAnswer, WithoutStiffness,
};
use indicatif::{ProgressBar, ProgressStyle};
use std::path::Path;
use std::time::Duration;

/// How often the progress line turns.
const TICK: Duration = Duration::from_millis(120);

pub(crate) fn run(options: &Options, as_json: bool, quiet: bool) -> Result<Outcome> {
    let open::Opened { project, file } = open::project(&options.project)?;
    let surveys = surveys(&project, &file, options.survey.as_deref(), quiet)?;
    let file = file.display().to_string();
    let answer = Answer {
        file,
        project,
        state: None,
        variants: Vec::new(),
        sensitivities: Vec::new(),
        sensitivity_of: SensitivityOf::default(),
        surveys,
        simulation: None,
        frame_simulations: Vec::new(),
        chain_simulations: Vec::new(),
        tunings: Vec::new(),
        together: Vec::new(),
        building_simulations: Vec::new(),
        studies: Vec::new(),
        change: None,
    };
    let json = identification_json(&answer);
    if as_json {
        files::say(&format!("{json:#}\n"))?;
    } else {
        files::say(&identification_text(&answer))?;
    }
    if let Some(folder) = &options.output {
        files::write(
            &folder.join("identification.json"),
            format!("{json:#}\n").as_bytes(),
        )?;
        for figure in figures::identification(&answer, Language::English) {
            files::write(
                &folder.join(format!("{}.svg", figure.name)),
                figure.svg.as_bytes(),
            )?;
        }
        if !quiet {
            note!("figures and identification.json are in {}", folder.display());
        }
    }
    Ok(Outcome::Stands)
}

/// What the surveys of a project give, all of them or the one that is named.
pub(crate) fn surveys(
    project: &Project,
    file: &Path,
    only: Option<&str>,
    quiet: bool,
) -> Result<Vec<SurveyAnswer>> {
    if let Some(name) = only
        && !project.surveys.iter().any(|survey| survey.name == name)
    {
        let names: Vec<&str> = project
            .surveys
            .iter()
            .map(|survey| survey.name.as_str())
            .collect();
        bail!("there is no survey \"{name}\": the file has {}", names.join(", "));
    }
    let chosen = project
        .surveys
        .iter()
        .filter(|survey| only.is_none_or(|name| survey.name == name));
    chosen
        .map(|survey| of_survey(project, survey, file, quiet))
        .collect()
}

/// Modes of a survey's records, without the stiffness that explains them.
pub(crate) fn found_in(survey: &Survey, file: &Path, quiet: bool) -> Result<SurveyAnswer> {
    let context = || format!("survey {}", survey.name);
    let records = match &survey.records {
        Some(source) => Some(of_record(source, file, quiet).with_context(context)?.0),
        None => None,
    };
    let setups = if survey.setups.is_empty() {
        None
    } else {
        Some(of_setups(survey, file, quiet).with_context(context)?)
    };
    Ok(SurveyAnswer {
        name: survey.name.clone(),
        records,
        setups,
        stiffness: Vec::new(),
        without_stiffness: None,
    })
}

/// Each setup by itself, then all together, and as one where the file asks for it.
fn of_setups(survey: &Survey, file: &Path, quiet: bool) -> Result<SetupsAnswer> {
    let (mut records, mut measured) = (Vec::new(), Vec::new());
    for source in &survey.setups {
        let (answer, record) = of_record(source, file, quiet)?;
        records.push(answer);
        measured.push(record);
    }
    let modes: Vec<Modes> = records
        .iter()
        .map(|record| record.analysis.modes.clone())
        .collect();
    let merge = MergeSetups::default();
    let merged = merge_setups(&modes, &merge)?;
    let joint = match (survey.merge, survey.setups.first()) {
        (Merge::Preger, Some(first)) => {
            let spinner = spinner(quiet, "all setups as one".to_owned());
            let options = Identify {
                references: Vec::new(),
                ..options(first, measured[0].channels())?
            };
            let joint = joint_setups(&measured, &options, merge.pairing.place_within_m)
                .context("all setups as one")?;
            spinner.finish_and_clear();
            Some(joint)
        }
        _ => None,
    };
    Ok(SetupsAnswer {
        records,
        merged,
        joint,
    })
}

fn of_survey(project: &Project, survey: &Survey, file: &Path, quiet: bool) -> Result<SurveyAnswer> {
    let context = || format!("survey {}", survey.name);
    let mut answer = found_in(survey, file, quiet)?;
    let mut stiffness = Vec::new();
    for direction in survey.modes.keys() {
        let modes = survey.measured_modes(direction, &mut Quantity::nominal);
        if !modes.is_empty() {
            stiffness.extend(
                stiffness_of(project, direction, &modes, &twisting(survey, direction))
                    .with_context(context)?,
            );
        }
    }
    if let Some((found, _)) = answer.modes() {
        let doubtful = answer
            .setups
            .as_ref()
            .map_or_else(Vec::new, SetupsAnswer::doubtful_hz);
        let unexplained_hz = answer.unexplained_hz();
        for (direction, vector) in [("x", [1.0, 0.0, 0.0]), ("y", [0.0, 1.0, 0.0])] {
            if !survey.modes.contains_key(direction) {
                let answers = from_record(project, found, &doubtful, (direction, vector));
                stiffness.extend(answers.with_context(context)?.into_iter().map(|answer| {
                    let highest_hz = answer.frequencies_hz.last().copied().unwrap_or(0.0);
                    let below = unexplained_hz.iter().copied().filter(|hz| *hz < highest_hz);
                    StiffnessAnswer {
                        peaks_below_hz: below.collect(),
                        ..answer
                    }
                }));
            }
        }
    }
    let is_sought = matches!(project.structure, Structure::Chain(_) | Structure::Frame(_));
    if is_sought
        && stiffness.is_empty()
        && survey.modes.is_empty()
        && let Some((found, _)) = answer.modes()
    {
        answer.without_stiffness = why_no_stiffness(found);
    }
    answer.stiffness = stiffness;
    Ok(answer)
}

/// What the sensors lack, where none measures along x or y; `None` where one does.
fn why_no_stiffness(found: &Modes) -> Option<WithoutStiffness> {
    let along =
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|vector| directional_modes(found, vector).channels_along);
    if along != [0, 0] {
        return None;
    }
    let placed = found
        .channels
        .iter()
        .filter(|c| c.position_m.is_some() && c.direction.is_some());
    let channels: Vec<String> = placed.map(|c| c.name.clone()).collect();
    Some(match channels.is_empty() {
        true => WithoutStiffness::NoPlace,
        false => WithoutStiffness::OffTheAxes { channels },
    })
}

/// The modes of a direction that twist: reported, but kept out of the fit.
fn twisting(survey: &Survey, direction: &str) -> Vec<StiffnessNote> {
    let modes = survey.modes.get(direction).into_iter().flatten();
    let twisting = modes.filter(|mode| mode.kind == ModeKind::Torsion);
    twisting
        .map(|mode| StiffnessNote::Twists {
            frequency_hz: mode.frequency.value,
        })
        .collect()
}

fn of_record(source: &RecordSource, project_file: &Path, quiet: bool) -> Result<(RecordAnswer, Record)> {
    let spinner = spinner(quiet, format!("reading {}", source.file));
    let opened = open::record(source, project_file)?;
    spinner.set_message(format!("modes of {}", source.file));
    let options = options(source, opened.record.channels())?;
    let analysis = identify(&opened.record, &options).with_context(|| source.file.clone())?;
    spinner.finish_and_clear();
    let answer = RecordAnswer {
        file: source.file.clone(),
        channels: opened.channels,
        samples: opened.samples,
        sampling_rate_hz: opened.sampling_rate_hz,
        unit: opened.unit,
        remarks: opened.remarks,
        faults: opened.faults,
        analysis,
    };
    Ok((answer, opened.record))
}

/// How modes are sought, as the file says.
fn options(source: &RecordSource, channels: &[Channel]) -> Result<Identify> {
    let defaults = Identify::default();
    Ok(Identify {
        method: source.modal.method.unwrap_or(defaults.method),
        references: references(&source.modal.references, channels).with_context(|| source.file.clone())?,
        pick_hz: source.modal.pick_hz.clone(),
        harmonics: source.modal.harmonics.unwrap_or(defaults.harmonics),
        frequency_low_hz: source.modal.frequency_low_hz,
        frequency_high_hz: source.modal.frequency_high_hz,
        block_rows: source.modal.block_rows,
        order_most: source.modal.order_most,
        modes_wanted: source.modal.modes_wanted,
        ..defaults
    })
}

/// Indices of the channels of these names.
fn references(names: &[String], channels: &[Channel]) -> Result<Vec<usize>> {
    let place = |name: &String| {
        let at = channels.iter().position(|channel| channel.name == *name);
        at.with_context(|| {
            let known: Vec<&str> = channels.iter().map(|channel| channel.name.as_str()).collect();
            format!(
                "modal.references names {name:?}, but the channels used are {}",
                known.join(", ")
            )
        })
    };
    names.iter().map(place).collect()
}

/// A turning line on standard error, on a terminal only.
fn spinner(quiet: bool, message: String) -> ProgressBar {
    let bar = if quiet {
        ProgressBar::hidden()
    } else {
        ProgressBar::new_spinner()
    };
    if let Ok(style) = ProgressStyle::with_template("{spinner} {msg} {elapsed}") {
        bar.set_style(style);
    }
    bar.set_message(message);
    bar.enable_steady_tick(TICK);
    bar
}

/// Stiffness from the modes of a record that move in one direction; none if no sensor measures it.
fn from_record(
    project: &Project,
    modes: &Modes,
    doubtful_hz: &[f64],
    (direction, vector): (&str, [f64; 3]),
) -> Result<Vec<StiffnessAnswer>> {
    let mut found = directional_modes(modes, vector);
    found.end_before(doubtful_hz);
    let parts = match &project.structure {
        Structure::Chain(part) => part.links.len(),
        Structure::Frame(part) => part.storeys.len(),
        Structure::Stack(_) | Structure::Building(_) | Structure::Survey => return Ok(Vec::new()),
    };
    found.modes.truncate(parts); // a model of n parts has n modes: the lowest ones
    if found.modes.is_empty() {
        return Ok(Vec::new());
    }
    let mut notes: Vec<StiffnessNote> = found.left_out.into_iter().map(StiffnessNote::LeftOut).collect();
    notes.push(StiffnessNote::TakenAsLowest {
        modes: found.modes.len(),
        direction: direction.to_owned(),
    });
    stiffness_of(project, direction, &found.modes, &notes)
}

/// Load factor of each solution with the least stiffness that the data allow.
fn least_load_factors(
    found: &StiffnessSolutions,
    load_factor: impl Fn(&[f64]) -> Result<f64>,
) -> Result<Vec<Option<f64>>> {
    let each = found.solutions.iter().map(StiffnessSolution::stiffness_least);
    each.map(|least| least.map(|k| load_factor(&k)).transpose())
        .collect()
}

/// Every stiffness that explains `modes`: one answer for a chain, one a convention for a frame.
fn stiffness_of(
    project: &Project,
    direction: &str,
    modes: &[MeasuredMode],
    notes: &[StiffnessNote],
) -> Result<Vec<StiffnessAnswer>> {
    let pick = &mut Quantity::nominal;
    let answer = |convention, mut solutions: StiffnessSolutions, load_factors| {
        solutions.notes.extend(notes.iter().cloned());
        StiffnessAnswer {
            direction: direction.to_owned(),
            convention,
            frequencies_hz: modes.iter().map(|mode| mode.frequency_hz).collect(),
            with_shapes: modes.iter().any(|mode| !mode.shape.is_empty()),
            solutions,
            load_factors,
            peaks_below_hz: Vec::new(),
        }
    };
    match &project.structure {
        Structure::Stack(_) | Structure::Building(_) | Structure::Survey => Ok(Vec::new()),
        Structure::Chain(part) => {
            let chain: Chain = part.build(pick)?;
            let found = chain_stiffness(&chain, modes, &ChainStiffness::default())?;
            let load_factors = least_load_factors(&found, |k| Ok(chain_stability(&chain, k)?.load_factor))?;
            Ok(vec![answer(None, found, load_factors)])
        }
        Structure::Frame(part) => {
            let built = part.build(pick)?;
            let mut answers = Vec::new();
            for convention in [Convention::Drift, Convention::Grounded] {
                let frame = Frame::new(built.storeys().to_vec(), convention)?;
                let found = frame_stiffness(&frame, modes, &FrameStiffness::default())?;
                let load_factors =
                    least_load_factors(&found, |k| Ok(frame_stability(&frame, k)?.load_factor))?;
                answers.push(answer(Some(convention), found, load_factors));
            }
            Ok(answers)
        }
    }
}
