//! The exit status of the command, by verb.

use super::colour::Colour;

/// Exit status of bad input.
const BAD_INPUT: u8 = 2;
/// Exit status of a red judgement.
const RED: u8 = 1;
/// Exit status of a requested run that did not finish or converge.
const UNFINISHED: u8 = 3;

/// The verbs whose exit status follows from an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verb {
    /// `check`, by judgement.
    Check,
    /// `simulate`, by judgement.
    Simulate,
    /// `report`, by judgement.
    Report,
    /// `study`, by completion.
    Study,
    /// `tune`, by completion.
    Tune,
    /// `score`, by completion.
    Score,
    /// `rank`, by completion.
    Rank,
    /// `identify`, by completion.
    Identify,
    /// `compare`, by completion.
    Compare,
    /// `watch`, red with an open confirmed alarm.
    Watch,
}

/// The exit status of a verb: 1 for red if the verb judges, 3 if a run did not finish, otherwise 0.
pub fn exit_status(verb: Verb, colour: Colour, is_done: bool) -> u8 {
    let judges = matches!(verb, Verb::Check | Verb::Simulate | Verb::Report | Verb::Watch);
    match (judges && colour == Colour::Red, is_done) {
        (true, _) => RED,
        (false, false) => UNFINISHED,
        (false, true) => 0,
    }
}

/// The status of a run with several parts; 2 precedes 1, then 3, then 0.
pub fn first_status(statuses: impl IntoIterator<Item = u8>) -> u8 {
    let urgency = |status: &u8| match *status {
        BAD_INPUT => 3,
        RED => 2,
        UNFINISHED => 1,
        _ => 0,
    };
    statuses.into_iter().max_by_key(urgency).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_exit_statuses_follow_verb_colour_and_end() {
        use Colour::{Amber, Green, Red};
        let judging = [Verb::Check, Verb::Simulate, Verb::Report, Verb::Watch];
        let doing = [
            Verb::Study,
            Verb::Tune,
            Verb::Score,
            Verb::Rank,
            Verb::Identify,
            Verb::Compare,
        ];
        // colour, done, status of a verb that judges, of one that does not judge
        for (colour, is_done, judged, done) in [
            (Green, true, 0, 0),
            (Amber, true, 0, 0),
            (Red, true, 1, 0),
            (Green, false, 3, 3),
            (Amber, false, 3, 3),
            (Red, false, 1, 3),
        ] {
            for verb in judging {
                assert_eq!(exit_status(verb, colour, is_done), judged, "{verb:?} {colour:?}");
            }
            for verb in doing {
                assert_eq!(exit_status(verb, colour, is_done), done, "{verb:?} {colour:?}");
            }
        }
    }

    #[test]
    fn holds_bad_input_goes_before_red_before_unfinished() {
        for (statuses, first) in [
            (&[0, 3, 1, 2][..], 2),
            (&[3, 1, 0][..], 1),
            (&[0, 3][..], 3),
            (&[0][..], 0),
            (&[][..], 0),
        ] {
            assert_eq!(first_status(statuses.iter().copied()), first, "{statuses:?}");
        }
    }
}
