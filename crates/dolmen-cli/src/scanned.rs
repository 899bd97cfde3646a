//! `dolmen new pagoda DIR --scan FILE --beds …`: a project from one scan.

use crate::cli::{Kind, New, OfScan, ScanUnit as Typed};
use crate::manner::Manner;
use crate::outcome::Outcome;
use crate::say::{say, say_json};
use crate::typed_path::for_a_shell;
use crate::wrong::{CommandError, Noted};
use anyhow::{Context as _, Result};
use dolmen_records::MESH_BYTES_MOST;
use dolmen_report::files::drawing_file;
use dolmen_report::json::scan_json;
use dolmen_report::scan_text;
use dolmen_work::scanned::{ScanRequest, ScanUnit, stones_of_scan};
use std::path::Path;

/// Writes a project of the stones of a scan into the folder of `options`.
pub(crate) fn run(options: &New, of: &OfScan, scan: &Path, manner: &Manner) -> Result<Outcome> {
    if options.kind != Kind::Pagoda {
        return Err(CommandError::NoEffect {
            flag: "scan",
            is_for: Noted::ForPagodas.into(),
        }
        .into());
    }
    let bytes = dolmen_folder::read(scan, manner.access().most(MESH_BYTES_MOST))?;
    let request = ScanRequest {
        file: scan
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned(),
        bytes: &bytes,
        beds_m: of.beds.clone(),
        allowed_steps_m: of.allow.clone(),
        unit: of.unit.map(|unit| match unit {
            Typed::M => ScanUnit::Metres,
            Typed::Cm => ScanUnit::Centimetres,
            Typed::Mm => ScanUnit::Millimetres,
        }),
    };
    let answer = stones_of_scan(&request).with_context(|| scan.display().to_string())?;
    let drawing = drawing_file(&answer.opened.project, manner.language());
    let files = answer
        .files
        .iter()
        .map(|(name, bytes)| (name.as_str(), bytes.as_slice()));
    let drawn = drawing.iter().map(|of| (of.name.as_str(), of.bytes.as_slice()));
    dolmen_folder::fill_fresh(&options.directory, &files.chain(drawn).collect::<Vec<_>>())?;
    if manner.json {
        say_json(&scan_json(&answer))?;
        return Ok(Outcome::Done);
    }
    say(&scan_text(&answer, manner.style()))?;
    if !manner.quiet {
        let folder = options.directory.display().to_string();
        let typed = for_a_shell(&folder);
        let next = Noted::NextOfScan(folder).text(manner);
        say(&format!("\n{next}\n    dolmen check {typed}\n"))?;
    }
    Ok(Outcome::Done)
}
