//! `dolmen rank`: many structures in the order in which they should be looked at.

use crate::cli_portfolio::{Rank as Options, State};
use crate::simulate::language;
use crate::{Outcome, files, open, score, study};
use anyhow::{Context as _, Result, bail};
use dolmen::assess::{Hazard, ScoreModel, Unlike};
use dolmen_report::figures::ranking;
use dolmen_report::html::{Imprint, ranking_html};
use dolmen_report::json::rank_json;
use dolmen_report::text::rank_text;
use dolmen_work::portfolio::{
    LeftOut, PortfolioAnswer, PortfolioEntry, PortfolioRow, PortfolioTable, RowSource, of_score, of_study,
    ranking_columns, read_portfolio,
};
use dolmen_work::study::table_csv;
use rayon::prelude::*;
use std::path::Path;

/// Reasons that are printed where nothing can be ranked.
const REASONS_MOST: usize = 10;

/// The models of the four states, and by which to rank.
struct Scores {
    models: [Option<ScoreModel>; 4],
    state: usize,
    outside_too: bool,
}

pub(crate) fn run(options: &Options, as_json: bool, quiet: bool) -> Result<Outcome> {
    let PortfolioTable { rows, refused } = rows(&options.source)?;
    let designs = score::designs(options.designs.as_deref())?;
    let scores = Scores {
        models: std::array::from_fn(|state| designs.model(state).ok()),
        state: match options.state {
            State::Ds1 => 0,
            State::Ds2 => 1,
            State::Ds3 => 2,
            State::Falls => 3,
        },
        outside_too: options.extrapolate,
    };
    let folder = match options.source.is_dir() {
        true => options.source.as_path(),
        false => options.source.parent().unwrap_or(Path::new(".")),
    };
    let found: Vec<Result<PortfolioEntry, LeftOut>> = rows
        .par_iter()
        .map(|row| {
            entry(row, folder, &scores).map_err(|why| LeftOut {
                name: row.name.clone(),
                why: format!("{why:#}"),
            })
        })
        .collect();
    let bad = refused.into_iter().map(|(name, why)| LeftOut {
        name,
        why: why.to_string(),
    });
    let (mut entries, mut left_out) = (Vec::new(), bad.collect::<Vec<_>>());
    for one in found {
        match one {
            Ok(entry) => entries.push(entry),
            Err(why) => left_out.push(why),
        }
    }
    let without_place = PortfolioAnswer::without_place(&entries, scores.state);
    if without_place.len() == entries.len() {
        left_out.extend(without_place);
        let all = left_out
            .iter()
            .map(|one| format!("\n  {}: {}", one.name, one.why));
        let shown: String = all.take(REASONS_MOST).collect();
        bail!("none of {} structures can be ranked:{shown}", left_out.len());
    }
    let source = options.source.display().to_string();
    let draws = usize::from(options.draws);
    let mut answer = PortfolioAnswer::of(source, scores.state, entries, left_out, draws)?;
    answer.designs = designs.designs.len();
    if as_json {
        files::say(&format!("{:#}\n", rank_json(&answer)))?;
    } else {
        files::say(&rank_text(&answer))?;
    }
    if let Some(folder) = &options.output {
        write(&answer, folder, options)?;
        if !quiet {
            note!("ranking, figure and page are in {}", folder.display());
        }
    }
    Ok(Outcome::Stands)
}

/// The structures of a table, or of the projects in a folder.
fn rows(source: &Path) -> Result<PortfolioTable> {
    if !source.is_dir() {
        return read_portfolio(&files::read(source)?).with_context(|| source.display().to_string());
    }
    if source.join("project.toml").is_file() {
        bail!(
            "{} is one project: give the folder that holds it beside others, or a table (CSV)",
            source.display()
        );
    }
    let mut rows = Vec::new();
    let entries = std::fs::read_dir(source).with_context(|| source.display().to_string())?;
    for entry in entries {
        let path = entry?.path();
        if path.join("project.toml").is_file() {
            let name = path.file_name().map(|name| name.to_string_lossy().into_owned());
            let name = name.unwrap_or_default();
            rows.push(PortfolioRow {
                line: 0,
                source: RowSource::Project {
                    path: name.clone(),
                    study: None,
                },
                name,
                hazard: None,
            });
        }
    }
    rows.sort_by(|a, b| a.name.cmp(&b.name));
    if rows.is_empty() {
        bail!(
            "{} holds no folder with a project.toml: give a folder of project folders, or a table (CSV)",
            source.display()
        );
    }
    Ok(PortfolioTable {
        rows,
        refused: Vec::new(),
    })
}

fn entry(row: &PortfolioRow, folder: &Path, scores: &Scores) -> Result<PortfolioEntry> {
    let name = row.name.clone();
    let scored = |factors, unlike: &[Unlike], hazard| {
        if scores.models[scores.state].is_none() {
            bail!("the score has too few designs of this state");
        }
        let (state, outside_too) = (scores.state, scores.outside_too);
        Ok(of_score(
            name.clone(),
            (factors, unlike),
            &scores.models,
            state,
            outside_too,
            hazard,
        )?)
    };
    match &row.source {
        RowSource::Factors(factors) => scored(factors, &[], row.hazard.clone()),
        RowSource::Project { path, study } => {
            let path = folder.join(path);
            let open::Opened { project, file } = open::project(&path)?;
            let own = project.site.as_ref().and_then(|site| site.hazard.as_ref());
            let own: Option<Hazard> = own.map(|hazard| hazard.curve.clone());
            let replaced = row.hazard.is_some() && own.is_some() && row.hazard != own;
            let hazard = row.hazard.clone().or(own);
            let mut found = study::of_report(&file, true)?;
            if let Some(wanted) = study {
                found.retain(|one| one.study.name == *wanted);
                if found.is_empty() {
                    bail!(
                        "study \"{wanted}\" of {} has no results beside the project file, or they are of another state of it: run dolmen study",
                        file.display()
                    );
                }
            }
            found.retain(|one| one.study.scan.is_some());
            let mut entry = match found.as_slice() {
                [one] => of_study(name.clone(), one, hazard).map_err(anyhow::Error::msg),
                [] => match score::factors(&project)? {
                    Some(factors) => {
                        let unlike = score::check_alike(&project, scores.outside_too)?;
                        scored(&factors, &unlike, hazard)
                    }
                    None => bail!(
                        "it has neither results of a study nor a pagoda of six factors: run dolmen study {} first",
                        file.display()
                    ),
                },
                several => {
                    let names: Vec<&str> = several.iter().map(|one| one.study.name.as_str()).collect();
                    bail!(
                        "it has results of several studies ({}): name one in the column study",
                        names.join(", ")
                    )
                }
            }?;
            entry.hazard_replaced = replaced;
            Ok(entry)
        }
    }
}

fn write(answer: &PortfolioAnswer, folder: &Path, options: &Options) -> Result<()> {
    let language = language(options.language);
    let imprint = Imprint {
        program: format!("dolmen {}", env!("CARGO_PKG_VERSION")),
        date: None,
    };
    let json = format!("{:#}\n", rank_json(answer));
    files::write(
        &folder.join("ranking.csv"),
        table_csv(&ranking_columns(answer)).as_bytes(),
    )?;
    files::write(&folder.join("ranking.json"), json.as_bytes())?;
    files::write(&folder.join("ranking.svg"), ranking(answer, language).as_bytes())?;
    let page = ranking_html(answer, language, &imprint);
    files::write(&folder.join("ranking.html"), page.as_bytes())
}
