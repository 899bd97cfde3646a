//! `dolmen report` and `dolmen demo`: several projects on one page.

use crate::cli::{Demo, Report};
use crate::manner::Manner;
use crate::note::note;
use crate::outcome::Outcome;
use crate::progress::Terminal;
use crate::request::keeping_motion;
use crate::say::say;
use crate::typed::Typed;
use crate::wrong::{CommandError, Noted};
use crate::{examples, request, tools};
use anyhow::Result;
use dolmen_folder::{Found, Outputs, free_folder, journals_beside};
use dolmen_picture::Painter;
#[cfg(feature = "pdf")]
use dolmen_print::{Sheets, pdf};
use dolmen_project::Project;
use dolmen_report::docx::docx;
use dolmen_report::files::figure_files;
use dolmen_report::html::{Imprint, NotReported, html};
use dolmen_report::hwpx::hwpx;
use dolmen_report::text::project_line;
#[cfg(feature = "pdf")]
use dolmen_report::typeset::{Typeset, typeset};
use dolmen_report::xlsx::workbook;
use dolmen_work::answer::ProjectReport;
use dolmen_work::judgement::{Verb, first_status, judge};
use dolmen_work::motion::MotionRequest;
use dolmen_work::{FlagVerb, ReportOptions, Sampling, report};
use std::cell::LazyCell;
use std::path::{Path, PathBuf};

/// Pixels per unit of a figure: some 270 per inch on paper.
pub(crate) const PIXELS: f32 = 2.5;
/// Samples of the demo: enough for a figure, and quick.
const DEMO_SAMPLES: usize = 2000;
const DEMO_SEED: u64 = 1;

pub(crate) fn imprint(date: Option<String>) -> Imprint {
    Imprint {
        program: concat!("dolmen ", env!("CARGO_PKG_VERSION")).to_owned(),
        date,
    }
}

/// Output format of a report.
#[derive(Clone, Copy)]
enum Format {
    Html,
    #[cfg(feature = "pdf")]
    Pdf,
    Docx,
    Hwpx,
    Xlsx,
}

impl Format {
    /// The format for the extension of a file; a page without one.
    fn of(file: &Path) -> Result<Self> {
        let extension = file.extension().map(|of| of.to_string_lossy().to_lowercase());
        match extension.as_deref() {
            None | Some("html" | "htm") => Ok(Format::Html),
            Some("docx") => Ok(Format::Docx),
            Some("hwpx") => Ok(Format::Hwpx),
            Some("xlsx") => Ok(Format::Xlsx),
            #[cfg(feature = "pdf")]
            Some("pdf") => Ok(Format::Pdf),
            #[cfg(not(feature = "pdf"))]
            Some("pdf") => Err(CommandError::NoPdf.into()),
            Some(other) => Err(CommandError::ReportFormat {
                ending: other.to_owned(),
            }
            .into()),
        }
    }
}

/// Adds .html to a page without an extension, except for a pipe or device.
fn with_ending(output: &Path) -> PathBuf {
    let is_special = output.exists() && !output.is_file();
    match output.extension().is_none() && !is_special {
        true => output.with_extension("html"),
        false => output.to_owned(),
    }
}

/// All answers for one project.
fn whole(
    found: &Found,
    sampling: Option<Sampling>,
    motion: &MotionRequest,
    manner: &Manner,
) -> Result<ProjectReport> {
    let options = ReportOptions {
        sampling,
        motion: motion.clone(),
        journals: journals_beside(found),
    };
    let answer = report(&found.opened, options, &found.files, &Terminal::new(manner.quiet))?;
    for study in answer.left_out.iter().filter(|_| !manner.quiet) {
        let said = Noted::StudyLeftOut {
            study: study.study.clone(),
            why: study.why.clone(),
        };
        note!("{}", said.text(manner));
    }
    Ok(answer)
}

pub(crate) fn run(options: &Report, typed: &Typed, manner: &Manner) -> Result<Outcome> {
    let sampling = (options.samples > 0).then_some(Sampling {
        samples: options.samples as usize,
        seed: options.seed,
    });
    let each = options.projects.iter().map(|path| (path, manner.open(path)));
    let each: Vec<(&PathBuf, Result<Found>)> = each.collect();
    let known = each.iter().filter_map(|(_, found)| found.as_ref().ok());
    let projects: Vec<&Project> = known.map(|found| &*found.opened.project).collect();
    typed.refuse_foreign(FlagVerb::Report, &projects)?;
    let motion = request::motion(&options.motion, &options.motion.motion_file, manner)?;
    if !motion.is_given() && (motion.is_changed() || motion.of_files().is_some()) {
        return Err(CommandError::NoMotionToChange.into());
    }
    let mut outputs = keeping_motion(Outputs::new(manner.access()), &options.motion.motion_file);
    for (path, found) in &each {
        // keeps even a file that cannot be read as a project
        outputs = match found {
            Ok(found) => outputs.keeping_project(found),
            Err(_) => outputs.keeping(path).keeping(&path.join("project.toml")),
        };
    }
    let mut formats = Vec::new();
    for output in options.output.iter().map(|output| with_ending(output.as_path())) {
        outputs.refuse(&output)?;
        let format = Format::of(&output)?;
        formats.push((output, format));
    }
    let (mut answers, mut others, mut faults) = (Vec::new(), Vec::new(), Vec::new());
    for (path, found) in each {
        let progress = Terminal::new(manner.quiet);
        let found = found.and_then(|found| found.with_stiffness_of_surveys(&progress));
        let answer = found.and_then(|found| whole(&found, sampling, &motion, manner));
        match answer {
            Ok(answer) => answers.push(answer),
            Err(fault) if options.projects.len() == 1 => return Err(fault),
            Err(fault) => {
                tools::complain(&fault, manner);
                others.push(NotReported {
                    file: path.display().to_string(),
                    why: tools::told(fault.as_ref(), manner.language()),
                });
                faults.push(fault);
            }
        }
    }
    if answers.is_empty() {
        return Err(CommandError::NothingReported {
            projects: others.len(),
        }
        .into());
    }
    let (language, imprint) = (manner.language(), imprint(options.date.clone()));
    let painter = LazyCell::new(Painter::new);
    let painted = |svg: &str| painter.png(svg, PIXELS).map_err(|fault| fault.to_string());
    for (output, format) in formats {
        let bytes = match format {
            Format::Html => html(&answers, &others, language, &imprint).into_bytes(),
            #[cfg(feature = "pdf")]
            Format::Pdf => printed(typeset(&answers, &others, language, &imprint), manner)?,
            Format::Docx => docx(&answers, &others, language, &imprint, &painted)?,
            Format::Hwpx => hwpx(&answers, &others, language, &imprint, &painted)?,
            Format::Xlsx => workbook(&answers, &others, language, &imprint)?,
        };
        let made = output
            .parent()
            .filter(|folder| !folder.as_os_str().is_empty() && !folder.exists());
        let made = made.map(|folder| folder.display().to_string());
        outputs.file(&output, &bytes)?;
        if !manner.quiet {
            if let Some(folder) = made {
                note!("{}", Noted::FolderMade(folder).text(manner));
            }
            say(&format!("{}\n", output.display()))?;
        }
    }
    if let Some(folder) = &options.figures {
        outputs.folder(folder, &figure_files(&answers, language, &painted)?)?;
        if !manner.quiet {
            say(&format!("{}\n", folder.display()))?;
        }
    }
    let statuses = answers
        .iter()
        .map(|answer| judge(&answer.answers).exit_status(Verb::Report));
    let status = first_status(statuses.chain(faults.iter().map(tools::exit_status)));
    if !faults.is_empty() {
        let left_out = Noted::LeftOutOfReport {
            count: faults.len(),
            all: options.projects.len(),
        };
        note!("{}", left_out.text(manner));
    }
    Ok(Outcome::Judged(status))
}

/// The bytes of a PDF; notes characters that could not be printed.
#[cfg(feature = "pdf")]
fn printed(source: Typeset, manner: &Manner) -> Result<Vec<u8>> {
    let Typeset { main, files } = source;
    let printed = pdf(Sheets { main, files })?;
    if !printed.without_glyph.is_empty() && !manner.quiet {
        let each: String = printed.without_glyph.iter().take(20).collect();
        let boxes = Noted::Boxes {
            count: printed.without_glyph.len(),
            each,
        };
        note!("{}", boxes.text(manner));
    }
    Ok(printed.bytes)
}

pub(crate) fn demo(options: &Demo, manner: &Manner) -> Result<Outcome> {
    let folder = free_folder(&options.directory)?;
    let mut answers = Vec::new();
    for shown in examples::DEMO {
        let directory = folder.join(shown.example);
        examples::copy_example(shown.example, &directory)?;
        let motion = shown.motion.map(MotionRequest::named).unwrap_or_default();
        let sampling = Some(Sampling {
            samples: DEMO_SAMPLES,
            seed: DEMO_SEED,
        });
        let answer = whole(
            &manner.open(&directory.join(shown.file))?,
            sampling,
            &motion,
            manner,
        )?;
        if !manner.quiet {
            let (name, language) = (&answer.project.name, manner.language());
            say(&format!(
                "{}: {}\n",
                language.pick(name.english(), name.korean()),
                project_line(&answer, language)
            ))?;
        }
        answers.push(answer);
    }
    let report = folder.join("report.html");
    Outputs::new(manner.access()).file(
        &report,
        html(&answers, &[], manner.language(), &imprint(None)).as_bytes(),
    )?;
    if !manner.quiet {
        say(&Noted::ReportOnAll.text(manner))?;
        say(" ")?;
    }
    say(&format!("{}\n", report.display()))?;
    Ok(Outcome::Done)
}
