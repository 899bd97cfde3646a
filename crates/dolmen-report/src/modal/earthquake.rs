//! Main findings of a record with earthquakes: when, how strong, and their effect.

use super::earthquake_words::{ChangeWords, Quake, acceleration, time, with_sd};
use crate::document::{Finding, Tone};
use crate::figures::lowest_of_parts;
use dolmen::modal::{AtLeast, During, Part, ShakingKind, StrongEvent, StrongMotion};
use dolmen_words::{Quantity, Sentence};
use dolmen_work::surveyed::{Earthquake, ModesOf};

/// Number of earthquakes of one record in a short answer; the full one has all.
const LISTED: usize = 4;

/// Main findings: the earthquake, the lowest frequency before and after, and lasting changes.
pub(super) fn findings(of: &Earthquake) -> Vec<Finding> {
    let found = &of.found;
    let mut all = vec![Finding::key(Tone::Warn, holds(found)).with_code("earthquake")];
    match &found.events[..] {
        [event] => all.push(Finding::key(Tone::Plain, three(found, event))),
        events => {
            all.extend(events.iter().enumerate().map(|(at, event)| each(at, event)));
            all.push(Finding::key(Tone::Plain, parts(found)));
        }
    }
    all.push(lasting(found));
    all.push(Finding::key(Tone::Plain, Quake::NotOne));
    all
}

fn holds(found: &StrongMotion) -> Quake {
    let peak = peak(found.largest()).into();
    let sure = found
        .events
        .iter()
        .filter(|of| of.shaking.kind == ShakingKind::Earthquake);
    let (count, sure) = (found.events.len(), sure.count());
    match &found.events[..] {
        [event] => {
            let of = &event.shaking;
            let [from, to] = [of.arrival_s, of.end_s].map(time);
            let strong = time(of.strong_to_s - of.strong_from_s);
            let over = Quantity::ratio(of.over_noise, 2);
            match of.kind {
                ShakingKind::Earthquake => Quake::Holds {
                    from,
                    to,
                    strong,
                    over,
                    peak,
                },
                ShakingKind::EarthquakeOrTraffic => Quake::HoldsUnsure {
                    from,
                    to,
                    strong,
                    over,
                    peak,
                },
            }
        }
        _ if sure == count => Quake::HoldSeveral { count, peak },
        _ if sure > 0 => Quake::HoldSome { count, sure, peak },
        _ => Quake::HoldSeveralUnsure { count, peak },
    }
}

/// The largest acceleration of one earthquake, and why the true value may be larger.
fn peak(event: &StrongEvent) -> Quake {
    let found = event
        .strongest()
        .and_then(|of| Some((of, of.peak_acceleration_m_s2?)));
    let Some((of, peak)) = found else {
        return Quake::NoPeak;
    };
    let (peak, channel, at) = (acceleration(peak), of.name.clone(), time(of.peak_at_s));
    let clipped = event
        .channels
        .iter()
        .filter(|of| of.at_least == Some(AtLeast::Clipped));
    let clipped: Vec<String> = clipped.map(|of| of.name.clone()).collect();
    let is = |why: AtLeast| event.channels.iter().any(|of| of.at_least == Some(why));
    let why = match (event.is_at_least(), clipped.is_empty()) {
        (false, _) => return Quake::Peak { peak, channel, at },
        (true, false) => Quake::WhyClipped { channels: clipped },
        (true, true) if is(AtLeast::Lost) => Quake::WhyLost,
        (true, true) => Quake::WhyEdge,
    };
    Quake::PeakAtLeast {
        peak,
        channel,
        at,
        why: why.into(),
    }
}

/// One of several.
fn each(at: usize, event: &StrongEvent) -> Finding {
    let of = &event.shaking;
    let told = event.changes.iter().find(|of| of.ratio_sd.is_some());
    let (tone, left) = match (event.lasting().map(ChangeWords::of), told.map(ChangeWords::of)) {
        (Some(ChangeWords { frequency, by, half }), _) => {
            (Tone::Bad, Quake::LeftChange { frequency, by, half })
        }
        (None, Some(ChangeWords { frequency, by, half })) => {
            (Tone::Plain, Quake::LeftNothing { frequency, by, half })
        }
        (None, None) => (Tone::Unknown, Quake::LeftUnknown),
    };
    let (number, [from, to]) = (at + 1, [of.arrival_s, of.end_s].map(time));
    let strong = time(of.strong_to_s - of.strong_from_s);
    let over = Quantity::ratio(of.over_noise, 2);
    let (peak, left) = (peak(event).into(), left.into());
    let said = match of.kind {
        ShakingKind::Earthquake => Quake::Each {
            number,
            from,
            to,
            strong,
            over,
            peak,
            left,
        },
        ShakingKind::EarthquakeOrTraffic => Quake::EachUnsure {
            number,
            from,
            to,
            strong,
            over,
            peak,
            left,
        },
    };
    match at < LISTED || tone == Tone::Bad {
        true => Finding::answer(tone, said),
        false => Finding::new(tone, said),
    }
}

fn short(part: &Part) -> Sentence {
    let time = time(part.span_s[1] - part.span_s[0]);
    Quake::TooShort { time }.into()
}

/// The lowest mode found before, during and after it: the lowest of those found both before and after.
fn three(found: &StrongMotion, event: &StrongEvent) -> Quake {
    let mut parts = found
        .quiet
        .iter()
        .zip(lowest_of_parts(found))
        .map(|(part, of)| match of {
            Some((hz, sd)) => with_sd(hz, sd),
            None => short(part),
        });
    let during = match &event.during {
        During::Driven(of) => {
            let lowest = of.analysis.modes.modes.first();
            lowest.map(|mode| with_sd(mode.frequency_hz, mode.frequency_sd_hz))
        }
        During::Tracked(of) => Some(with_sd(of.frequency_hz, Some(of.frequency_sd_hz))),
        During::Unknown => None,
    };
    let unknown = || Quake::NotKnown.into();
    Quake::Three {
        before: parts.next().unwrap_or_else(unknown),
        during: during.unwrap_or_else(unknown),
        after: parts.next().unwrap_or_else(unknown),
    }
}

/// The lowest mode in each part without an earthquake.
fn parts(found: &StrongMotion) -> Quake {
    let each = found.quiet.iter().zip(lowest_of_parts(found)).map(|(part, of)| {
        let [from, to] = part.span_s.map(time);
        let frequency = match of {
            Some((hz, sd)) => with_sd(hz, sd),
            None => Quake::NotKnown.into(),
        };
        Quake::PartOf { from, to, frequency }.into()
    });
    Quake::Parts { each: each.collect() }
}

fn lasting(found: &StrongMotion) -> Finding {
    let span = |at: usize| -> Sentence {
        let [from, to] = found.quiet[at].span_s.map(time);
        Quake::Span { from, to }.into()
    };
    let when: Sentence = match (found.compared, found.events.len()) {
        (_, 1) => Quake::BeforeToAfter,
        (Some([from, to]), _) => Quake::InAll {
            first: span(from),
            last: span(to),
        },
        (None, _) => Quake::OfLast,
    }
    .into();
    if let Some(lowest) = found.lasting() {
        let most = found.lasting_most().filter(|most| *most != lowest);
        let most = most.map_or(Quake::NoOther, |most| {
            let ChangeWords { frequency, by, half } = ChangeWords::of(most);
            Quake::Most { frequency, by, half }
        });
        let ChangeWords { frequency, by, half } = ChangeWords::of(lowest);
        let said = Quake::Lasts {
            frequency,
            by,
            half,
            most: most.into(),
            when,
        };
        return Finding::key(Tone::Bad, said);
    }
    let told = found.shown().iter().find(|of| of.ratio_sd.is_some());
    match told.map(ChangeWords::of) {
        Some(ChangeWords { frequency, by, half }) => {
            let said = Quake::NothingLasts {
                frequency,
                by,
                half,
                when,
            };
            Finding::key(Tone::Plain, said)
        }
        None => Finding::key(Tone::Unknown, Quake::CannotTell),
    }
}

/// The part that the modes come from.
pub(super) fn modes_of(of: &Earthquake) -> Finding {
    let span = |part: &Part| part.span_s.map(time);
    let found = &of.found;
    match of.modes_of {
        ModesOf::After => {
            let [from, to] = span(found.after());
            Finding::qualifies(Tone::Plain, Quake::OfAfter { from, to })
        }
        ModesOf::Between => {
            let [from, to] = span(found.between().unwrap_or_else(|| found.after()));
            Finding::qualifies(Tone::Warn, Quake::OfBetween { from, to })
        }
        ModesOf::Before => {
            let [from, to] = span(found.before());
            Finding::qualifies(Tone::Warn, Quake::OfBefore { from, to })
        }
        ModesOf::During => {
            let event = found.strongest();
            let [from, to] = match &event.during {
                During::Driven(part) => part.span_s,
                During::Tracked(_) | During::Unknown => [event.shaking.arrival_s, event.shaking.end_s],
            }
            .map(time);
            Finding::qualifies(Tone::Warn, Quake::OfDuring { from, to })
        }
        ModesOf::Whole => Finding::qualifies(Tone::Warn, Quake::OfWhole),
    }
}
