//! `dolmen validate` and `dolmen doctor`: does this build compute correctly, and does the installation work.

use crate::at_work::AtWork;
use crate::examples::{self, Example};
use crate::outcome::Outcome;
use crate::progress::Terminal;
use crate::say::{say, say_json};
use crate::wrong::CommandError;
use anyhow::Result;
use dolmen::comparisons::Case;
use dolmen_project::parse_project;
use dolmen_report::as_json;
use dolmen_report::text::validation_text;
use dolmen_words::{Digits, Quantity, Unit};
use dolmen_work::validate;
use std::time::Instant;

pub(crate) fn run(as_json: bool) -> Result<Outcome> {
    let cases = all_cases()?;
    if as_json {
        let list: Vec<_> = cases.iter().map(case_json).collect();
        say_json(&as_json!(list))?;
    } else {
        say(&validation_text(&cases))?;
    }
    let wrong = cases.iter().filter(|case| !case.agrees()).count();
    if wrong > 0 {
        return Err(CommandError::NotReproduced { wrong }.into());
    }
    Ok(Outcome::Done)
}

/// Every published number, including those of the measured example.
fn all_cases() -> Result<Vec<Case>> {
    let text = examples::example_text("palisaden", "project.toml")?;
    Ok(validate(
        &parse_project(text, "palisaden")?,
        &Example("palisaden"),
    )?)
}

fn case_json(case: &Case) -> serde_json::Value {
    as_json!({
        "source": case.source, "what": case.what, "unit": case.unit, "published": case.published,
        "computed": case.computed, "difference": case.difference(), "tolerance": case.tolerance,
        "corrected": case.corrected, "agrees": case.agrees(), "note": case.note,
    })
}

/// Checks this installation, one line per check; the first failure is an error.
pub(crate) fn doctor() -> Result<Outcome> {
    let started = Instant::now();
    let said = |line: AtWork| say(&(line.text() + "\n"));
    said(AtWork::On {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        system: std::env::consts::OS.to_owned(),
        processor: std::env::consts::ARCH.to_owned(),
    })?;
    said(AtWork::Processors(
        std::thread::available_parallelism().map_or(1, std::num::NonZero::get),
    ))?;

    let cases = Terminal::new(false).waiting(AtWork::Reproducing, all_cases)?;
    let wrong: Vec<&Case> = cases.iter().filter(|case| !case.agrees()).collect();
    if let Some(case) = wrong.first() {
        return Err(CommandError::NotReproducedFirst {
            wrong: wrong.len(),
            all: cases.len(),
            first: case.what.to_string(),
        }
        .into());
    }
    said(AtWork::Numbers(cases.len()))?;

    for shown in examples::DEMO {
        let text = examples::example_text(shown.example, shown.file)?;
        parse_project(text, shown.example)?;
    }
    said(AtWork::Examples(examples::DEMO.len()))?;

    let folder = std::env::temp_dir().join(format!("dolmen-doctor-{}", std::process::id()));
    dolmen_folder::write(&folder.join("text"), "당간".as_bytes())?;
    let back = dolmen_folder::read_text(&folder.join("text"), 100)?;
    std::fs::remove_dir_all(&folder).map_err(|why| CommandError::CannotRemove {
        path: folder.display().to_string(),
        why,
    })?;
    if back != "당간" {
        return Err(CommandError::NotKept {
            path: folder.display().to_string(),
        }
        .into());
    }
    said(AtWork::Files(std::env::temp_dir().display().to_string()))?;

    let locale = ["LC_ALL", "LC_CTYPE", "LANG"]
        .iter()
        .find_map(|name| std::env::var(name).ok());
    let is_utf8 = |locale: &str| locale.to_ascii_uppercase().replace('-', "").contains("UTF8");
    said(match locale {
        Some(locale) if is_utf8(&locale) => AtWork::Utf8(locale),
        Some(locale) => AtWork::NotUtf8(locale),
        None => AtWork::NoLocale,
    })?;
    let took = Quantity::new(
        1e3 * started.elapsed().as_secs_f64(),
        Unit::si("ms"),
        Digits::Fixed(0),
    );
    said(AtWork::Well(took))?;
    Ok(Outcome::Done)
}
