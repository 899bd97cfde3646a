//! Finds faults without mistaking an earthquake or lost samples for a fault.

use super::Record;
use super::faults::{ChannelFault, inspect};
use std::borrow::Cow;

/// All faults that [`inspect`] finds, with allowance for two lists of time spans (from, to, s). The spans `lost_s` are left out. In the
/// spans `shaken_s` the ground motion explains single large samples and changes of strength.
///
/// Stuck, dead, clipped, drifting and duplicated channels are detected in the whole record. Faint channels, changes of strength, spikes
/// and similar channels are detected only outside `shaken_s`.
pub fn inspect_apart(record: &Record, lost_s: &[[f64; 2]], shaken_s: &[[f64; 2]]) -> Vec<ChannelFault> {
    let there = without(record, lost_s);
    if shaken_s.is_empty() {
        return there.map_or_else(Vec::new, |of| of.faults());
    }
    let is_of_quiet = |fault: &ChannelFault| {
        matches!(
            fault,
            ChannelFault::Faint { .. }
                | ChannelFault::Faded { .. }
                | ChannelFault::Loose { .. }
                | ChannelFault::Spikes { .. }
                | ChannelFault::Alike { .. }
        )
    };
    let all = [lost_s, shaken_s].concat();
    let mut faults = there.map_or_else(Vec::new, |of| of.faults());
    faults.retain(|fault| !is_of_quiet(fault));
    let quiet = without(record, &all).map_or_else(Vec::new, |of| of.faults());
    faults.extend(quiet.into_iter().filter(is_of_quiet));
    let place = |fault: &ChannelFault| {
        let own = record.channels().iter().position(|of| of.name == fault.channel());
        own.unwrap_or(usize::MAX)
    };
    faults.sort_by_key(place);
    faults
}

/// A record from which given time spans are removed.
struct RemainingRecord<'a> {
    record: Cow<'a, Record>,
    /// The remaining spans, s.
    spans_s: Vec<[f64; 2]>,
}

/// `None` if nothing remains.
fn without<'a>(record: &'a Record, apart_s: &[[f64; 2]]) -> Option<RemainingRecord<'a>> {
    if apart_s.is_empty() {
        return Some(RemainingRecord {
            spans_s: vec![[0.0, record.duration_s()]],
            record: Cow::Borrowed(record),
        });
    }
    let rate_hz = record.sampling_rate_hz();
    let end_s = record.duration_s();
    let mut apart = apart_s.to_vec();
    apart.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let (mut spans_s, mut from_s) = (Vec::new(), 0.0_f64);
    for [begins_s, ends_s] in apart {
        if begins_s > from_s {
            spans_s.push([from_s, begins_s]);
        }
        from_s = from_s.max(ends_s);
    }
    if from_s < end_s {
        spans_s.push([from_s, end_s]);
    }
    let place = |at_s: f64| ((at_s * rate_hz).round() as usize).min(record.length());
    let samples = (0..record.channels().len()).map(|c| {
        let each = spans_s
            .iter()
            .map(|[from_s, to_s]| &record.samples(c)[place(*from_s)..place(*to_s)]);
        each.flatten().copied().collect()
    });
    let record = Record::new(record.channels().to_vec(), samples.collect(), rate_hz).ok()?;
    Some(RemainingRecord {
        record: Cow::Owned(record),
        spans_s,
    })
}

impl RemainingRecord<'_> {
    /// Faults of the remaining record, at the times of the original record.
    fn faults(&self) -> Vec<ChannelFault> {
        let mut faults = inspect(&self.record);
        for at_s in faults.iter_mut().flat_map(ChannelFault::times_s_mut) {
            *at_s = self.time_s(*at_s);
        }
        faults
    }

    fn time_s(&self, at_s: f64) -> f64 {
        let mut left_s = at_s;
        for [from_s, to_s] in &self.spans_s {
            if left_s <= to_s - from_s {
                return from_s + left_s;
            }
            left_s -= to_s - from_s;
        }
        self.spans_s.last().map_or(at_s, |[_, to_s]| *to_s)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;
    use crate::signal::Channel;

    /// Three channels of noise; only the first one shakes from 40 to 60 s, and it has a spike at 80 s.
    fn record() -> Record {
        let mut random = Random::new(5, 1);
        let samples = (0..3).map(|c| {
            let each = (0..10_000).map(|t| {
                let strong = if c == 0 && (4000..6000).contains(&t) {
                    60.0
                } else {
                    1.0
                };
                let spike = if c == 0 && t == 8000 { 900.0 } else { 0.0 };
                strong * random.normal() + spike
            });
            each.collect()
        });
        let channels = ["a", "b", "c"].map(Channel::named).to_vec();
        Record::new(channels, samples.collect(), 100.0).unwrap()
    }

    #[test]
    fn holds_a_shaking_is_no_loose_contact_and_a_spike_beside_it_keeps_its_time() {
        let record = record();
        let faded =
            |faults: &[ChannelFault]| faults.iter().any(|of| matches!(of, ChannelFault::Faded { .. }));
        assert!(faded(&inspect(&record)));
        let apart = inspect_apart(&record, &[], &[[39.0, 61.0]]);
        assert!(!faded(&apart), "{apart:?}");
        let [
            ChannelFault::Spikes {
                count: 1, first_s, ..
            },
        ] = &apart[..]
        else {
            panic!("{apart:?}")
        };
        assert!((first_s - 80.0).abs() < 1e-9, "{first_s}");
    }

    #[test]
    fn holds_lost_samples_are_not_stuck() {
        let record = record();
        let mut samples: Vec<Vec<f64>> = (0..3).map(|c| record.samples(c).to_vec()).collect();
        samples.iter_mut().for_each(|own| own[2000..2800].fill(0.0));
        let bridged = Record::new(record.channels().to_vec(), samples, 100.0).unwrap();
        let stuck = |faults: Vec<ChannelFault>| {
            faults
                .iter()
                .filter(|of| matches!(of, ChannelFault::Stuck { .. }))
                .count()
        };
        assert_eq!(stuck(inspect(&bridged)), 3);
        assert_eq!(
            stuck(inspect_apart(&bridged, &[[19.99, 28.0]], &[[39.0, 61.0]])),
            0
        );
    }
}
