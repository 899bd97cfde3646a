//! Which kinds of structure use which flags of the command: a flag without effect is refused.

use crate::wrong::FlagWords;
use Kind::{Building, Chain, Frame, Stack, Survey};
use dolmen_project::Structure;
use dolmen_words::message::{Argument, Both, Run};
use dolmen_words::{Language, Sentence};

/// The kind of a structure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// `kind = "chain"`
    Chain,
    /// `kind = "frame"`
    Frame,
    /// `kind = "stack"`
    Stack,
    /// `kind = "building"`
    Building,
    /// `kind = "survey"`
    Survey,
}

impl Kind {
    /// All of them.
    pub const ALL: [Kind; 5] = [Chain, Frame, Stack, Building, Survey];

    /// The kind of a structure.
    pub fn of(structure: &Structure) -> Kind {
        match structure {
            Structure::Chain(_) => Chain,
            Structure::Frame(_) => Frame,
            Structure::Stack(_) => Stack,
            Structure::Building(_) => Building,
            Structure::Survey => Survey,
        }
    }

    /// Its word in a project file.
    pub fn word(self) -> &'static str {
        match self {
            Chain => "chain",
            Frame => "frame",
            Stack => "stack",
            Building => "building",
            Survey => "survey",
        }
    }
}

/// A verb whose flags depend on the kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FlagVerb {
    /// `dolmen check`
    Check,
    /// `dolmen simulate`
    Simulate,
    /// `dolmen report`
    Report,
    /// `dolmen study`
    Study,
    /// `dolmen tune`
    Tune,
}

impl FlagVerb {
    /// All of them.
    pub const ALL: [FlagVerb; 5] = [
        FlagVerb::Check,
        FlagVerb::Simulate,
        FlagVerb::Report,
        FlagVerb::Study,
        FlagVerb::Tune,
    ];

    /// Its word in the command.
    pub fn word(self) -> &'static str {
        match self {
            FlagVerb::Check => "check",
            FlagVerb::Simulate => "simulate",
            FlagVerb::Report => "report",
            FlagVerb::Study => "study",
            FlagVerb::Tune => "tune",
        }
    }

    /// The kinds that it answers for; the verb refuses others itself, whatever the flags.
    pub fn kinds(self) -> &'static [Kind] {
        match self {
            FlagVerb::Check | FlagVerb::Report => &Kind::ALL,
            FlagVerb::Simulate | FlagVerb::Study => MOVING,
            FlagVerb::Tune => &[Building],
        }
    }
}

/// What to do instead of a flag, by kind.
type RemedyOfKind = (Kind, fn() -> FlagWords);

/// One flag of a verb.
#[derive(Clone, Copy, Debug)]
struct Flag {
    verb: FlagVerb,
    /// Without the dashes.
    name: &'static str,
    /// The kinds of structure for which it has an effect.
    kinds: &'static [Kind],
    /// Its purpose; `None`: "is for" and its kinds.
    is_for: Option<fn() -> FlagWords>,
    /// Kinds for which it has no effect, with what to do instead; for the others, "this file has a KIND".
    instead: &'static [RemedyOfKind],
}

const MOVING: &[Kind] = &[Chain, Frame, Stack, Building];

const fn flag(verb: FlagVerb, name: &'static str, kinds: &'static [Kind]) -> Flag {
    Flag {
        verb,
        name,
        kinds,
        is_for: None,
        instead: &[],
    }
}

/// Flags that choose or change the motion.
const MOTION: [&str; 18] = [
    "motion",
    "motion-file",
    "unit",
    "sample-step",
    "channel",
    "response",
    "columns",
    "factor",
    "shortest",
    "ignore-stated-peak",
    "x-azimuth",
    "baseline",
    "high-pass",
    "keep-first",
    "taper",
    "turn",
    "scale",
    "peak",
];

/// Purpose of samples; the verdict of a stack has no load factor to vary.
const SAMPLES: Option<fn() -> FlagWords> = Some(|| FlagWords::DrawsLoadFactor);
const NO_SAMPLES: &[RemedyOfKind] = &[(Stack, || FlagWords::NotForStackCheck)];
const NO_SAMPLES_REPORT: &[RemedyOfKind] = &[(Stack, || FlagWords::NotForStackReport)];

/// The flags of every verb, except those of [`MOTION`].
const FLAGS: &[Flag] = &[
    Flag {
        is_for: SAMPLES,
        instead: NO_SAMPLES,
        ..flag(FlagVerb::Check, "samples", &[Chain, Frame, Building])
    },
    Flag {
        is_for: SAMPLES,
        instead: NO_SAMPLES,
        ..flag(FlagVerb::Check, "seed", &[Chain, Frame, Building])
    },
    flag(FlagVerb::Check, "sensitivity", MOVING),
    flag(FlagVerb::Simulate, "variant", MOVING),
    Flag {
        is_for: Some(|| FlagWords::NamesDirection),
        instead: &[
            (Chain, || FlagWords::ChainInOnePlane),
            (Building, || FlagWords::BuildingInPlan),
        ],
        ..flag(FlagVerb::Simulate, "direction", &[Frame])
    },
    Flag {
        is_for: Some(|| FlagWords::LeansChain),
        ..flag(FlagVerb::Simulate, "push", &[Chain])
    },
    Flag {
        instead: &[(Building, || FlagWords::BuildingSmall)],
        ..flag(FlagVerb::Simulate, "rotations", &[Chain])
    },
    Flag {
        is_for: Some(|| FlagWords::ActsAfter),
        instead: &[(Building, || FlagWords::BuildingAsBefore)],
        ..flag(FlagVerb::Simulate, "then", &[Chain, Frame, Stack])
    },
    flag(FlagVerb::Simulate, "law", &[Stack]),
    flag(FlagVerb::Simulate, "repeats", &[Stack, Building]),
    Flag {
        is_for: Some(|| FlagWords::BlowsWind),
        ..flag(FlagVerb::Simulate, "wind", &[Building])
    },
    Flag {
        is_for: Some(|| FlagWords::DrawsWind),
        ..flag(FlagVerb::Simulate, "seed", &[Building])
    },
    flag(FlagVerb::Simulate, "points", &[Stack]),
    flag(FlagVerb::Simulate, "step", &[Stack, Building]),
    flag(FlagVerb::Simulate, "duration", MOVING),
    flag(FlagVerb::Simulate, "output-step", MOVING),
    flag(FlagVerb::Simulate, "to-the-end", &[Stack]),
    flag(FlagVerb::Simulate, "output", MOVING),
    flag(FlagVerb::Report, "output", &Kind::ALL),
    flag(FlagVerb::Report, "date", &Kind::ALL),
    flag(FlagVerb::Report, "figures", &Kind::ALL),
    Flag {
        is_for: SAMPLES,
        instead: NO_SAMPLES_REPORT,
        ..flag(FlagVerb::Report, "samples", &[Chain, Frame, Building])
    },
    Flag {
        is_for: SAMPLES,
        instead: NO_SAMPLES_REPORT,
        ..flag(FlagVerb::Report, "seed", &[Chain, Frame, Building])
    },
    flag(FlagVerb::Study, "study", MOVING),
    flag(FlagVerb::Study, "output", MOVING),
    flag(FlagVerb::Study, "shard", MOVING),
    flag(FlagVerb::Study, "threads", MOVING),
    flag(FlagVerb::Study, "restart", MOVING),
    flag(FlagVerb::Study, "from", MOVING),
    flag(FlagVerb::Tune, "damper", &[Building]),
    flag(FlagVerb::Tune, "floors", &[Building]),
    flag(FlagVerb::Tune, "variant", &[Building]),
    flag(FlagVerb::Tune, "load", &[Building]),
    flag(FlagVerb::Tune, "corner", &[Building]),
    flag(FlagVerb::Tune, "ground", &[Building]),
    flag(FlagVerb::Tune, "load-direction", &[Building]),
    flag(FlagVerb::Tune, "goal", &[Building]),
    flag(FlagVerb::Tune, "map", &[Building]),
    flag(FlagVerb::Tune, "stroke-most", &[Building]),
    flag(FlagVerb::Tune, "off", &[Building]),
    flag(FlagVerb::Tune, "share-mass", &[Building]),
    flag(FlagVerb::Tune, "output", &[Building]),
];

/// A typed flag without effect on any of the given kinds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ForeignFlag {
    /// The flag, without the dashes.
    pub flag: String,
    /// The kinds that use it, and the kind of the file.
    pub reason: Both,
}

impl ForeignFlag {
    fn sentence(&self) -> Sentence {
        FlagWords::Refused {
            flag: self.flag.clone(),
            reason: self.reason.clone(),
        }
        .into()
    }
}

impl std::fmt::Display for ForeignFlag {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.sentence().text(Language::English))
    }
}

impl std::error::Error for ForeignFlag {}

impl Argument for ForeignFlag {
    fn said(&self, language: Language) -> Vec<Run> {
        self.sentence().runs(language).to_vec()
    }
}

/// The flag of a verb; `None` if the table does not have it.
fn find(verb: FlagVerb, name: &str) -> Option<Flag> {
    let own = FLAGS.iter().find(|flag| flag.verb == verb && flag.name == name);
    let moves = matches!(verb, FlagVerb::Simulate | FlagVerb::Report) && MOTION.contains(&name);
    let of_motion = moves.then(|| Flag {
        name: "motion",
        ..flag(verb, "motion", MOVING)
    });
    own.copied().or(of_motion)
}

/// Whether the table has a flag of a verb.
pub fn is_known(verb: FlagVerb, name: &str) -> bool {
    find(verb, name).is_some()
}

/// Refuses the first given flag that none of the kinds of the files uses. Kinds that the verb does not support are ignored here; the verb
/// itself refuses them.
///
/// # Errors
/// [`ForeignFlag`].
pub fn refuse_foreign<'a>(
    verb: FlagVerb,
    kinds: &[Kind],
    typed: impl IntoIterator<Item = &'a str>,
) -> Result<(), ForeignFlag> {
    let taken = kinds.iter().filter(|kind| verb.kinds().contains(kind));
    let Some(first) = taken.clone().next() else {
        return Ok(());
    };
    for name in typed {
        let Some(flag) = find(verb, name) else { continue };
        if !taken.clone().any(|kind| flag.kinds.contains(kind)) {
            return Err(ForeignFlag {
                flag: name.to_owned(),
                reason: reason(&flag, *first),
            });
        }
    }
    Ok(())
}

fn reason(flag: &Flag, kind: Kind) -> Both {
    let is_for = match flag.is_for {
        Some(words) => words(),
        None => FlagWords::IsFor(listed(flag.kinds)),
    };
    let (is_for, kind_word) = (Both::from(is_for), kind.word().to_owned());
    match flag.instead.iter().find(|(of, _)| *of == kind) {
        Some((_, words)) => FlagWords::ThisFileAnd {
            is_for,
            kind: kind_word,
            instead: words().into(),
        },
        None => FlagWords::ThisFile {
            is_for,
            kind: kind_word,
        },
    }
    .into()
}

/// "chains, frames and buildings".
fn listed(kinds: &[Kind]) -> Both {
    let english: Vec<String> = kinds.iter().map(|kind| format!("{}s", kind.word())).collect();
    let korean: Vec<&str> = kinds.iter().map(|kind| kind.word()).collect();
    Both {
        english: match english.as_slice() {
            [first @ .., last] if !first.is_empty() => format!("{} and {last}", first.join(", ")),
            all => all.concat(),
        },
        korean: korean.join(", "),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(verb: FlagVerb) -> Vec<&'static str> {
        let own = FLAGS
            .iter()
            .filter(|flag| flag.verb == verb)
            .map(|flag| flag.name);
        let motion = MOTION.into_iter().filter(|name| is_known(verb, name));
        own.chain(motion).collect()
    }

    #[test]
    fn holds_every_flag_of_every_verb_and_kind_is_used_or_refused_by_name() {
        for verb in FlagVerb::ALL {
            for name in names(verb) {
                let flag = find(verb, name).unwrap();
                assert!(!flag.kinds.is_empty() && flag.kinds.iter().all(|k| verb.kinds().contains(k)));
                for &kind in verb.kinds() {
                    let answer = refuse_foreign(verb, &[kind], [name]);
                    if flag.kinds.contains(&kind) {
                        assert_eq!(answer, Ok(()), "{verb:?} {kind:?} {name}");
                        continue;
                    }
                    let said = answer.unwrap_err().to_string();
                    assert!(said.starts_with(&format!("--{name} ")), "{said}");
                    assert!(
                        said.contains(&format!("this file has a {}", kind.word())),
                        "{said}"
                    );
                    assert!(flag.kinds.iter().any(|k| said.contains(k.word())), "{said}");
                }
            }
        }
    }

    #[test]
    fn holds_a_flag_is_refused_only_if_no_project_of_the_list_uses_it() {
        let refused = |kinds: &[Kind]| refuse_foreign(FlagVerb::Report, kinds, ["date", "samples"]);
        assert_eq!(refused(&[Stack, Chain]), Ok(()));
        assert_eq!(refused(&[]), Ok(()));
        let said = refused(&[Stack, Survey]).unwrap_err().to_string();
        assert!(said.starts_with("--samples draws the load factor"), "{said}");
        let motion = refuse_foreign(FlagVerb::Report, &[Survey], ["peak"]);
        assert_eq!(
            motion.unwrap_err().to_string(),
            "--peak is for chains, frames, stacks and buildings: this file has a survey"
        );
    }

    #[test]
    fn holds_a_kind_that_the_verb_does_not_take_is_left_to_the_verb() {
        assert_eq!(refuse_foreign(FlagVerb::Tune, &[Chain], ["map"]), Ok(()));
        assert_eq!(refuse_foreign(FlagVerb::Simulate, &[Survey], ["law"]), Ok(()));
    }
}
