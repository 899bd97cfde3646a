//! Converts flags to options of the verbs.

use crate::cli::{Points, Rotations, Simulate};
use crate::cli_motion::Motion;
use crate::manner::Manner;
use crate::wrong::CommandError;
use anyhow::Result;
use dolmen::blocks::ContactRule;
use dolmen::dynamics::ChainRotations;
use dolmen::signal::Component;
use dolmen_folder::Outputs;
use dolmen_records::MOTION_BYTES_MOST;
use dolmen_work::motion::{GivenFile, MotionRequest, is_built_in_motion};
use dolmen_work::stack::{Law, Repeating};
use dolmen_work::{SimulateOptions, WindAsked};
use std::path::Path;

/// The requested motion, with its files read.
pub(crate) fn motion(options: &Motion, named: &[String], manner: &Manner) -> Result<MotionRequest> {
    let mut files = Vec::new();
    for text in named {
        let (component, name) = named_file(text);
        if is_built_in_motion(name) && !Path::new(name).exists() {
            let name = name.to_owned();
            return Err(CommandError::BuiltInAsFile { name }.into());
        }
        files.push(GivenFile {
            component,
            name: name.to_owned(),
            bytes: dolmen_folder::read(Path::new(name), manner.access().most(MOTION_BYTES_MOST))?,
        });
    }
    let mut responses = Vec::new();
    for name in &options.response {
        responses.push(GivenFile {
            component: None,
            name: name.clone(),
            bytes: dolmen_folder::read(Path::new(name), manner.access().most(MOTION_BYTES_MOST))?,
        });
    }
    Ok(MotionRequest {
        name: options.motion.clone(),
        files,
        unit: options.unit.clone(),
        sample_step_s: options.sample_step,
        channel: options.channel.clone(),
        columns: options.columns.clone(),
        factor: options.factor,
        responses,
        shortest: options.shortest,
        ignore_stated_peak: options.ignore_stated_peak,
        x_azimuth_deg: options.x_azimuth,
        baseline_degree: options.baseline,
        high_pass_hz: options.high_pass,
        keep_first_s: options.keep_first,
        taper_s: options.taper,
        turn_deg: options.turn,
        scale: options.scale,
        peak: options.peak.clone(),
    })
}

/// "y" and "FILE" of "y=FILE"; a text without a component is a file.
fn named_file(text: &str) -> (Option<Component>, &str) {
    let split = text.split_once('=').and_then(|(before, file)| {
        let component = Component::ALL.into_iter().find(|c| c.name() == before)?;
        Some((Some(component), file))
    });
    split.unwrap_or((None, text))
}

/// Keeps the files of a motion that the command line names.
pub(crate) fn keeping_motion(outputs: Outputs, named: &[String]) -> Outputs {
    let files = named.iter().map(|text| named_file(text).1);
    files.fold(outputs, |all, file| all.keeping(Path::new(file)))
}

/// The requested simulation.
pub(crate) fn simulation(options: &Simulate, manner: &Manner) -> Result<SimulateOptions> {
    Ok(SimulateOptions {
        motion: motion(&options.motion, &options.motion.motion_file, manner)?,
        then: options.then.clone(),
        variant: options.variant.clone(),
        direction: options.direction.clone(),
        push: options.push.clone(),
        rotations: match options.rotations {
            Rotations::Large => ChainRotations::Large,
            Rotations::Small => ChainRotations::Small,
        },
        law: match options.law {
            None => Law::AsKnown,
            Some(crate::cli::Law::Springs) => Law::Springs,
            Some(crate::cli::Law::Rigid) => Law::Rigid,
            Some(crate::cli::Law::Both) => Law::Both,
            Some(crate::cli::Law::Sliding) => Law::Sliding,
        },
        contact_rule: match options.points {
            Points::P4 => ContactRule::Corners,
            Points::P9 => ContactRule::Three,
            Points::P16 => ContactRule::Four,
            Points::P36 => ContactRule::Six,
        },
        step_s: options.step,
        duration_s: options.duration,
        output_step_s: options.output_step,
        to_the_end: options.to_the_end,
        however_long: manner.yes,
        repeats: options
            .repeats
            .map_or(Repeating::QUICK, |times| Repeating::Times(times.into())),
        wind: options.wind.then(|| WindAsked {
            seed: options.seed.unwrap_or(1),
            repeats: options.repeats.map(usize::from),
        }),
        // JSON alone describes one run
        compare: options.output.is_some() || !manner.json,
        keep: options.output.is_some(),
    })
}
