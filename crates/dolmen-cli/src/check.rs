//! `dolmen check`: is the file right, does the structure stand.

use crate::cli::Check as Options;
use crate::manner::Manner;
use crate::note::note;
use crate::outcome::Outcome;
use crate::progress::Terminal;
use crate::say::{say, say_json};
use crate::simulate::settled;
use crate::typed::Typed;
use crate::wrong::{CommandError, Noted};
use anyhow::Result;
use dolmen_report::check_text;
use dolmen_report::json::check_json;
use dolmen_work::judgement::{Verb, judge_check};
use dolmen_work::{CheckOptions, FlagVerb, Sampling, check, is_loose, unreadable_motions};

pub(crate) fn run(options: &Options, typed: &Typed, manner: &Manner) -> Result<Outcome> {
    if let Some(name) = options.variant.clone() {
        return Err(CommandError::CheckOfVariant { name }.into());
    }
    let found = manner.open(&options.project)?;
    typed.refuse_foreign(FlagVerb::Check, &[&found.opened.project])?;
    if is_loose(&found.opened.project) {
        return settled(&found, manner);
    }
    let found = found.with_stiffness_of_surveys(&Terminal::new(manner.quiet))?;
    let how = CheckOptions {
        sampling: options.samples.map(|samples| Sampling {
            samples: samples as usize,
            seed: options.seed,
        }),
        sensitivity: options.sensitivity,
        beside_the_verdict: manner.json || manner.full,
    };
    let mut answer = check(&found.opened, &how)?;
    answer.unreadable_motions = unreadable_motions(&found.opened.project, &found.files);
    let variants = answer.variants.iter().map(|variant| &variant.state);
    let mut states = answer.state.iter().chain(variants);
    if options.samples.is_some() && states.all(|state| state.sampled.is_none()) && !manner.quiet {
        note!("{}", Noted::NothingToSample.text(manner));
    }
    if manner.json {
        say_json(&check_json(&answer))?;
    } else {
        say(&check_text(&answer, manner.style()))?;
    }
    Ok(Outcome::Judged(judge_check(&answer).exit_status(Verb::Check)))
}
