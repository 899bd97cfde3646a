//! A suite of motions as files: lines for a project file, the motions, a table and a figure.

use super::named::NamedFile;
use crate::figures::suite_figure;
use crate::json::suite_json;
use dolmen_records::motions::motion_csv;
use dolmen_words::{Language, keeping_names};
use dolmen_work::motion::{SuiteAnswer, SuiteMember};

/// Lines for a project (`suite.toml`), which name the motions in `folder` relative to the project file; the motions, the spectra
/// (`suite.csv`), the figure and the JSON.
pub fn suite_files(answer: &SuiteAnswer, folder: &str, language: Language) -> Vec<NamedFile> {
    let mut files: Vec<NamedFile> = answer
        .members
        .iter()
        .map(|member| NamedFile::new(&format!("{}.csv", member.name), motion_csv(&member.motion)))
        .collect();
    files.push(NamedFile::new("suite.toml", suite_toml(answer, folder)));
    files.push(NamedFile::new("suite-spectra.csv", spectra_csv(answer)));
    files.push(NamedFile::json(
        "suite.json",
        &keeping_names(|| suite_json(answer)),
    ));
    files.push(NamedFile::figure(suite_figure(answer, language)));
    files
}

/// A text in TOML notation.
fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

fn source(member: &SuiteMember) -> String {
    let origin = &member.origin;
    let mut said: Vec<&str> = [&origin.event, &origin.station]
        .into_iter()
        .flatten()
        .map(String::as_str)
        .collect();
    said.push(&member.file);
    said.extend((!member.channel.is_empty()).then_some(member.channel.as_str()));
    said.join(", ")
}

fn suite_toml(answer: &SuiteAnswer, folder: &str) -> String {
    let percent = |share: f64| format!("{:.1} %", 100.0 * share);
    let ends = [answer.periods_s.first(), answer.periods_s.last()];
    let [from_s, to_s] = ends.map(|end| end.copied().unwrap_or(0.0));
    let mut out = format!(
        "# {} of {} records for {}, {from_s:.3} to {to_s:.3} s, damping {}.\n\
         # Mean spectrum {} off (root mean square), {} at {:.3} s to {}. Dolmen's own rule.\n\
         # Lines for a project file that stands beside the folder {folder}.\n\n",
        answer.members.len(),
        answer.candidates,
        answer.demand.replace(char::is_control, " "),
        percent(answer.damping_ratio),
        percent(answer.misfit.root_mean_square),
        percent(answer.misfit.lowest),
        answer.worst_s,
        percent(answer.misfit.highest),
    );
    for member in &answer.members {
        let file = format!("{folder}/{}.csv", member.name);
        out += &format!(
            "[motion.{}]\nfiles = {{ x = {} }}\n",
            member.name,
            quoted(file.trim_start_matches('/'))
        );
        if member.matched.is_none() {
            out += &format!("scale = {}\n", member.factor);
        }
        out += &format!("source = {}\n\n", quoted(&source(member)));
    }
    let names: Vec<String> = answer.members.iter().map(|member| quoted(&member.name)).collect();
    out += &format!(
        "[study.suite]\nmotions = [{}]\nscale = {{ from = 0.5, to = 2, steps = 4 }} # 1 is the demand\n",
        names.join(", ")
    );
    out
}

fn spectra_csv(answer: &SuiteAnswer) -> String {
    let mut out = "period_s,target_m_s2,mean_m_s2".to_owned();
    for member in &answer.members {
        out += &format!(",{}_m_s2", member.name);
    }
    out.push('\n');
    for (k, period_s) in answer.periods_s.iter().enumerate() {
        out += &format!("{period_s},{},{}", answer.target_m_s2[k], answer.mean_m_s2[k]);
        for member in &answer.members {
            out += &format!(",{}", member.acceleration_m_s2[k]);
        }
        out.push('\n');
    }
    out
}
