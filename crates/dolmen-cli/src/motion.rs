//! `dolmen motion`: ground motions read, measured, matched, made and written.

use crate::cli_motion::{GroundMotionVerb as Options, Shape};
use crate::manner::Manner;
use crate::note::note;
use crate::outcome::Outcome;
use crate::request;
use crate::request::keeping_motion;
use crate::say::{say, say_json};
use crate::suite;
use crate::typed::Typed;
use crate::wrong::{CommandError, Noted};
use anyhow::Result;
use dolmen_folder::Outputs;
use dolmen_records::motions::{motion_at2, motion_csv};
use dolmen_report::files::motion_files;
use dolmen_report::json::motion_report_json;
use dolmen_report::motion_report_text;
use dolmen_work::motion::{
    Demand, MadeMotion, MatchAnswer, MotionOptions, MotionReport, MotionShape, RANGE_S, motion,
    range_of_structure,
};
use std::path::Path;

fn options_of(options: &Options, manner: &Manner) -> Result<MotionOptions> {
    let files = match options.make {
        Some(_) => &[][..],
        None => named_files(options),
    };
    Ok(MotionOptions {
        request: request::motion(&options.motion, files, manner)?,
        made: options.make.map(|shape| MadeMotion {
            shape: match shape {
                Shape::HalfSine => MotionShape::HalfSine,
                Shape::Sine => MotionShape::Sine,
                Shape::Cosine => MotionShape::Cosine,
                Shape::Ricker => MotionShape::Ricker,
                Shape::RickerOdd => MotionShape::RickerOdd,
                Shape::NearFault => MotionShape::NearFault,
                Shape::Noise => MotionShape::Noise,
            },
            period_s: options.period,
            gamma: options.gamma,
            phase_deg: options.phase,
            duration_s: options.duration,
            seed: options.seed,
        }),
        spectrum: options.spectrum,
        damping_ratio: options.damping,
        matched: options.matched.then(|| demand(options)),
        range_s: range(options),
    })
}

/// The demand spectrum.
fn demand(options: &Options) -> Demand {
    Demand {
        site: options.site.clone(),
        zone: options.zone,
        years: options.years,
        ground_acceleration_g: options.ground_acceleration,
        spectrum_type: options.spectrum_type,
    }
}

/// The periods of the demand.
fn range(options: &Options) -> [f64; 2] {
    let of_structure = options.t1.map(range_of_structure);
    options.range.or(of_structure).unwrap_or(RANGE_S)
}

/// The files, from either argument.
fn named_files(options: &Options) -> &[String] {
    match options.files.is_empty() {
        true => &options.motion.motion_file,
        false => &options.files,
    }
}

/// Refuses a typed flag that has no effect with the others.
fn refuse_idle(options: &Options, typed: &Typed) -> Result<()> {
    let is_noise = options.make == Some(Shape::Noise);
    let is_pulse = options.make.is_some() && !is_noise;
    let is_near_fault = options.make == Some(Shape::NearFault);
    let table = [
        ("period", is_pulse, Noted::ForPulses),
        ("gamma", is_near_fault, Noted::ForNearFault),
        ("phase", is_near_fault, Noted::ForNearFault),
        ("duration", is_noise, Noted::ForNoise),
        ("seed", is_noise, Noted::ForNoise),
        (
            "damping",
            options.spectrum || options.matched || options.suite.is_some(),
            Noted::ForSpectra,
        ),
    ];
    for (flag, is_used, is_for) in table {
        if !is_used && typed.has(flag) {
            let is_for = is_for.into();
            return Err(CommandError::NoEffect { flag, is_for }.into());
        }
    }
    Ok(())
}

pub(crate) fn run(options: &Options, typed: &Typed, manner: &Manner) -> Result<Outcome> {
    refuse_idle(options, typed)?;
    if let (Some(count), Some(from)) = (options.suite, &options.from) {
        return suite::run(
            options,
            (count.into(), from),
            (demand(options), range(options)),
            manner,
        );
    }
    let outputs = keeping_motion(Outputs::new(manner.access()), named_files(options));
    if let Some(file) = &options.convert {
        outputs.refuse(file)?;
    }
    let report = motion(&options_of(options, manner)?)?;
    if manner.json {
        say_json(&motion_report_json(&report))?;
    } else {
        say(&motion_report_text(&report, manner.style()))?;
    }
    written(options, &report, &outputs, manner)?;
    let is_close = report.matched.as_ref().is_none_or(MatchAnswer::is_close);
    Ok(Outcome::finished(is_close))
}

/// Writes the motion to --convert, and all results to --output.
fn written(options: &Options, report: &MotionReport, outputs: &Outputs, manner: &Manner) -> Result<()> {
    let mut said = Vec::new();
    if let Some(file) = &options.convert {
        outputs.file(file, &converted(report, file)?)?;
        said.push(file.display().to_string());
    }
    if let Some(folder) = &options.output {
        outputs.folder(folder, &motion_files(report, manner.language()))?;
        said.push(folder.display().to_string());
    }
    if !manner.quiet && !said.is_empty() {
        note!("{}", Noted::Wrote(said.join(", ")).text(manner));
    }
    Ok(())
}

/// The motion in the format for the ending of a file.
fn converted(report: &MotionReport, file: &Path) -> Result<Vec<u8>> {
    let Some(first) = report.series.first() else {
        return Err(CommandError::NoMotion.into());
    };
    if report.series.iter().any(|other| other.motion != first.motion) {
        return Err(CommandError::NoPlaneMotion.into());
    }
    let ending = file.extension().map(|e| e.to_string_lossy().to_lowercase());
    match (ending.unwrap_or_default().as_str(), report.series.len()) {
        ("csv", _) => Ok(motion_csv(&first.motion).into_bytes()),
        ("at2", 1) => Ok(motion_at2(&first.motion, first.component).into_bytes()),
        ("at2", count) => Err(CommandError::At2One { count }.into()),
        _ => Err(CommandError::MotionFormat {
            path: file.display().to_string(),
        }
        .into()),
    }
}
