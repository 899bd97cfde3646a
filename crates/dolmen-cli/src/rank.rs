//! `dolmen rank`: ranks structures by how urgently they need attention.

use crate::cli_portfolio::{Rank as Options, State};
use crate::manner::Manner;
use crate::note::note;
use crate::outcome::Outcome;
use crate::report::imprint;
use crate::say::{say, say_json};
use crate::score;
use crate::wrong::Noted;
use anyhow::Result;
use dolmen_folder::{Outputs, ProjectsBelow, portfolio};
use dolmen_report::files::ranking_files;
use dolmen_report::json::rank_json;
use dolmen_report::rank_text;
use dolmen_work::portfolio::{RankOptions, rank};

pub(crate) fn run(options: &Options, manner: &Manner) -> Result<Outcome> {
    let table = portfolio(&options.source, options.sheet.as_deref(), manner.access())?;
    let designs = score::designs(options.designs.as_deref(), manner)?;
    let how = RankOptions {
        state: match options.state {
            State::Ds1 => 0,
            State::Ds2 => 1,
            State::Ds3 => 2,
            State::Falls => 3,
        },
        extrapolate: options.extrapolate,
        draws: usize::from(options.draws),
    };
    let below = ProjectsBelow::of(&options.source, manner.access());
    let source = options.source.display().to_string();
    let answer = rank(source, table, &designs, &how, &below)?;
    if manner.json {
        say_json(&rank_json(&answer))?;
    } else {
        say(&rank_text(&answer, manner.style()))?;
    }
    if let Some(folder) = &options.output {
        let files = ranking_files(&answer, manner.language(), &imprint(None));
        let designs = options.designs.iter();
        let outputs = designs.fold(
            Outputs::new(manner.access()).keeping(&options.source),
            |all, file| all.keeping(file),
        );
        outputs.folder(folder, &files)?;
        if !manner.quiet {
            note!("{}", Noted::Ranking(folder.display().to_string()).text(manner));
        }
    }
    Ok(Outcome::Done)
}
