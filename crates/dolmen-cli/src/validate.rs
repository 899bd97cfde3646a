//! `dolmen validate` and `dolmen doctor`: is what this build computes right, and does it work here.

use crate::{Outcome, files, new, open};
use anyhow::{Context as _, Result, bail};
use dolmen::modal::{Identify, Mode, identify};
use dolmen::validation::{Case, cases};
use dolmen_project::parse_project;
use dolmen_report::text::validation_text;
use dolmen_words::number::TWO_SIDED_95;
use serde_json::json;
use std::time::Instant;

/// Frequencies of Palisaden that its publication gives, Hz (Aloisio et al. 2020; the peer pyOMA-2 finds the same).
const PALISADEN_HZ: [f64; 3] = [1.882, 2.421, 2.687];
/// The record that the command carries, identified, beside what was published for the whole of it.
fn palisaden() -> Result<Vec<Case>> {
    let project = parse_project(new::example_text("palisaden", "project.toml")?, "palisaden")?;
    let source = project
        .surveys
        .iter()
        .find_map(|survey| survey.records.as_ref())
        .context("palisaden has no record")?;
    let opened = open::record_of(new::example_bytes("palisaden", &source.file)?, source)?;
    let found = identify(&opened.record, &Identify::default())?;
    let nearest = |published: f64| {
        let distance = |mode: &&Mode| (mode.frequency_hz - published).abs();
        found
            .modes
            .modes
            .iter()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
    };
    let case = |(i, published): (usize, f64)| {
        let mode = nearest(published).context("no mode was found")?;
        Ok(Case {
            source: "Aloisio et al. (2020)",
            what: format!(
                "Palisaden: frequency {} of ten minutes beside that of the whole record",
                i + 1
            ),
            unit: "Hz",
            published,
            computed: mode.frequency_hz,
            tolerance: TWO_SIDED_95 * mode.frequency_sd_hz.unwrap_or(0.0),
            corrected: None,
            note: "Palisaden: the tolerance is the 95 % interval that Dolmen states for ten minutes of record.",
        })
    };
    PALISADEN_HZ.into_iter().enumerate().map(case).collect()
}

pub(crate) fn run(as_json: bool) -> Result<Outcome> {
    let mut cases = cases()?;
    cases.extend(palisaden()?);
    if as_json {
        let list: Vec<_> = cases.iter().map(case_json).collect();
        files::say(&format!("{:#}\n", json!(list)))?;
    } else {
        files::say(&validation_text(&cases))?;
    }
    let wrong = cases.iter().filter(|case| !case.agrees()).count();
    if wrong > 0 {
        bail!("{wrong} published numbers are not reproduced: this build must not be used");
    }
    Ok(Outcome::Stands)
}

fn case_json(case: &Case) -> serde_json::Value {
    json!({
        "source": case.source, "what": case.what, "unit": case.unit, "published": case.published,
        "computed": case.computed, "difference": case.difference(), "tolerance": case.tolerance,
        "corrected": case.corrected, "agrees": case.agrees(), "note": case.note,
    })
}

/// Checks of this installation, a line each; the first that fails ends it with an error.
pub(crate) fn doctor() -> Result<Outcome> {
    let started = Instant::now();
    println!(
        "dolmen {} on {} {}",
        env!("CARGO_PKG_VERSION"),
        std::env::consts::OS,
        std::env::consts::ARCH
    );
    let threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    println!("processors    {threads}");

    let cases = cases()?;
    let wrong: Vec<&Case> = cases.iter().filter(|case| !case.agrees()).collect();
    if let Some(case) = wrong.first() {
        bail!(
            "{} of {} published numbers are not reproduced, {} first",
            wrong.len(),
            cases.len(),
            case.what
        );
    }
    println!("numbers       {} published numbers reproduced", cases.len());

    for example in new::DEMO {
        let text = new::example_text(example, "project.toml")?;
        parse_project(text, example)?;
    }
    println!("examples      {} carried, all readable", new::DEMO.len());

    let folder = std::env::temp_dir().join(format!("dolmen-doctor-{}", std::process::id()));
    files::write(&folder.join("text"), "당간".as_bytes())?;
    let back = files::read_text(&folder.join("text"))?;
    std::fs::remove_dir_all(&folder).with_context(|| format!("cannot remove {}", folder.display()))?;
    if back != "당간" {
        bail!("{} does not keep what is written to it", folder.display());
    }
    println!(
        "files         written and read back in {}",
        std::env::temp_dir().display()
    );

    let locale = ["LC_ALL", "LC_CTYPE", "LANG"]
        .iter()
        .find_map(|name| std::env::var(name).ok());
    match locale {
        Some(locale) if locale.to_ascii_uppercase().replace('-', "").contains("UTF8") => {
            println!("terminal      {locale}");
        }
        Some(locale) => {
            println!("terminal      {locale}: not UTF-8, so 한글 and λ may be garbled (reports are not)")
        }
        None => println!("terminal      no locale set: if 한글 and λ are garbled here, set LANG=C.UTF-8"),
    }
    println!("all is well   ({:.0} ms)", 1e3 * started.elapsed().as_secs_f64());
    Ok(Outcome::Stands)
}
