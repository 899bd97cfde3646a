//! Which flags the user typed, whatever their values.

use anyhow::Result;
use clap::parser::ValueSource;
use clap::{ArgMatches, Command};
use dolmen_project::Project;
use dolmen_work::flags::{FlagVerb, Kind, refuse_foreign};

/// Names of the typed flags of the verb, in the order of their definition.
pub(crate) struct Typed(Vec<String>);

impl Typed {
    /// The typed flags of the verb, without those that every verb has.
    pub(crate) fn of(command: &Command, matches: &ArgMatches) -> Self {
        let Some((verb, matches)) = matches.subcommand() else {
            return Typed(Vec::new());
        };
        let flags = command.find_subcommand(verb).map(Command::get_arguments);
        let typed = flags.into_iter().flatten().filter(|flag| {
            let source = matches.try_contains_id(flag.get_id().as_str()).unwrap_or(false);
            source && matches.value_source(flag.get_id().as_str()) == Some(ValueSource::CommandLine)
        });
        Typed(
            typed
                .filter_map(|flag| flag.get_long().map(str::to_owned))
                .collect(),
        )
    }

    /// Whether a flag of the verb was typed.
    pub(crate) fn has(&self, flag: &str) -> bool {
        self.0.iter().any(|typed| typed == flag)
    }

    /// Refuses the first typed flag that none of the projects uses.
    pub(crate) fn refuse_foreign(&self, verb: FlagVerb, projects: &[&Project]) -> Result<()> {
        let kinds: Vec<Kind> = projects.iter().map(|of| Kind::of(&of.structure)).collect();
        refuse_foreign(verb, &kinds, self.0.iter().map(String::as_str))?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::Cli;
    use clap::CommandFactory as _;
    use dolmen_work::flags::is_known;

    #[test]
    fn holds_no_flag_of_a_verb_is_missing_from_the_table_of_kinds() {
        let mut command = Cli::command();
        command.build();
        for verb in FlagVerb::ALL {
            let own = command.find_subcommand(verb.word()).unwrap();
            for of in std::iter::once(own).chain(own.get_subcommands()) {
                for flag in of
                    .get_arguments()
                    .filter(|flag| !flag.is_positional() && !flag.is_hide_set())
                {
                    let name = flag.get_long().unwrap_or_default();
                    let is_of_all = flag.is_global_set() || ["help", "version"].contains(&name);
                    assert!(is_of_all || is_known(verb, name), "{verb:?} --{name}");
                }
            }
        }
    }

    #[test]
    fn holds_a_flag_typed_with_its_default_counts_as_typed() {
        let command = Cli::command();
        let words = ["dolmen", "simulate", "p10", "--law", "springs", "--json"];
        let matches = command.clone().try_get_matches_from(words).unwrap();
        assert_eq!(Typed::of(&command, &matches).0, ["law"]);
    }
}
