//! Records with lost samples: uses the longest span that is whole in all channels, or whole after short runs are filled; or all of it, with the
//! mean in place of lost samples.
//!
//! A step of one and a half steps or more is a gap; a smaller deviation is an uneven clock, which is refused, and so is a step back.

use super::date_text::after_in_hours;
use super::series::Series;
use super::stamps::Stamps;
use super::{LostSamples, RecordError};
use crate::breaks::Break;
use crate::number::Number;
use dolmen::signal::{LOST_RUN_MOST, LOST_SHARE_MOST, LostSpan, Processing, SignalError, fill_lost};
use std::ops::Range;

/// Shortest time between samples that is a gap, in steps. Our choice: less is not a whole lost sample.
const GAP_STEPS: f64 = 1.5;
/// Number of last digits by which a step must exceed the one before, for coarse stamps: more than the one of rounding.
const ROUNDED_DIGITS: f64 = 1.5;
/// Smallest share of all samples in the longest span. Our choice: below it the clock is uneven rather than the record broken.
const SHARE_LEAST: f64 = 0.1;
/// Deviation of a gap from a whole number of steps up to which it can be filled, in steps. Our choice: stamps of milliseconds at 250 Hz.
const WHOLE_STEPS: f64 = 0.25;
/// Largest ratio of bridged time to recorded time. Our choice: above it there are several records.
const BRIDGED_MOST: f64 = 1.0;
/// Difference, in steps, within which the ends of two channels are at the same time.
const SAME_TIME_STEPS: f64 = 1e-3;

/// Stamps line by line, in consecutive spans.
#[derive(Debug)]
pub(super) struct Spans {
    unit_s: f64,
    given_hz: Option<f64>,
    lost_samples: LostSamples,
    now: Stamps,
    now_from: usize,
    rows: usize,
    last: Option<(Number, usize)>,
    done: Vec<(Range<usize>, Stamps)>,
    gaps: Vec<LostSpan>,
    /// The error for the first gap, if it is refused.
    fault: Option<RecordError>,
    /// Whether stamps are minutes and seconds without the hour.
    is_of_hours: bool,
}

/// The rows of a text in use, and the results of their stamps.
#[derive(Debug)]
pub(super) struct UsableRows {
    pub(super) rows: Range<usize>,
    pub(super) stamps: Stamps,
    /// Lost samples to fill, by their indices among all rows.
    pub(super) filled: Vec<Range<usize>>,
    pub(super) steps: Vec<Processing>,
}

impl Spans {
    pub(super) fn new(unit_s: f64, given_hz: Option<f64>, lost_samples: LostSamples) -> Self {
        Spans {
            unit_s,
            given_hz,
            lost_samples,
            now: Stamps::new(unit_s, given_hz).in_the_mean(lost_samples == LostSamples::NoneLost),
            now_from: 0,
            rows: 0,
            last: None,
            done: Vec::new(),
            gaps: Vec::new(),
            fault: None,
            is_of_hours: false,
        }
    }

    /// For minutes and seconds, which restart every hour.
    pub(super) fn of_hours(self) -> Self {
        Spans {
            is_of_hours: true,
            ..self
        }
    }

    /// Reads the next stamp; refuses one that is neither even nor after a gap.
    #[inline]
    pub(super) fn push(&mut self, mut printed: Number, line: usize) -> Result<(), RecordError> {
        if let (true, Some((before, _))) = (self.is_of_hours, self.last) {
            printed.value = after_in_hours(before.value, printed.value);
        }
        if let Err(fault) = self.now.push(printed, line) {
            self.after_a_gap(printed, line, fault)?;
        }
        self.rows += 1;
        self.last = Some((printed, line));
        Ok(())
    }

    #[cold]
    fn after_a_gap(&mut self, printed: Number, line: usize, fault: RecordError) -> Result<(), RecordError> {
        let Some((before, before_line)) = self.last else {
            return Err(fault);
        };
        let expected_s = self.now.step_s();
        let step_s = match &fault {
            RecordError::Uneven { step_s, .. } => *step_s,
            // rounding changes the steps of an even clock by one last digit at most
            RecordError::CoarseStamps {
                step_s,
                step_before_s,
                resolution_s,
                ..
            } if step_s - step_before_s > ROUNDED_DIGITS * resolution_s => *step_s,
            _ => return Err(fault),
        };
        let alone = self.rows - self.now_from == 2 && step_s > 0.0 && expected_s >= GAP_STEPS * step_s;
        if self.lost_samples == LostSamples::Refuse || !(alone || step_s >= GAP_STEPS * expected_s) {
            return Err(fault);
        }
        let (from, lost_s) = if alone {
            (self.rows - 1, expected_s - step_s)
        } else {
            (self.rows, step_s - expected_s)
        };
        let ends_s = if alone {
            before.value * self.unit_s - expected_s
        } else {
            before.value * self.unit_s
        };
        self.gaps.push(LostSpan {
            channel: None,
            at_s: ends_s,
            lost_s,
        });
        self.fault.get_or_insert(fault);
        let stamps = std::mem::replace(&mut self.now, Stamps::new(self.unit_s, self.given_hz));
        self.done.push((self.now_from..from, stamps));
        self.now_from = from;
        if alone {
            self.now.push(before, before_line)?;
        }
        self.now.push(printed, line)
    }

    /// The longest span with its short gaps to fill; refuses it if it is only a small part.
    pub(super) fn longest(mut self) -> Result<UsableRows, RecordError> {
        let now = std::mem::replace(&mut self.now, Stamps::new(self.unit_s, self.given_hz));
        self.done.push((self.now_from..self.rows, now));
        if let Some(fault) = self.done.iter().find_map(|(_, stamps)| stamps.scattered()) {
            return Err(fault);
        }
        let first_s = self.done.first().map_or(0.0, |(_, stamps)| stamps.first_s());
        let to_s = self.last.map_or(0.0, |(number, _)| number.value * self.unit_s);
        // the first among equals
        let longest = self.done.iter().rev().max_by_key(|(rows, _)| rows.len());
        let Some((_, stamps)) = longest else {
            return Err(RecordError::NoRate { names: Vec::new() });
        };
        let (stamps, step_s) = (stamps.clone(), stamps.step_s());
        let is_filling = self.lost_samples == LostSamples::Fill;
        let missing: Vec<Option<usize>> = self
            .gaps
            .iter()
            .map(|gap| short(gap.lost_s / step_s).filter(|_| is_filling))
            .collect();
        if self.lost_samples == LostSamples::Bridged && !self.gaps.is_empty() {
            return self.bridged(stamps, first_s);
        }
        let lengths: Vec<usize> = self.done.iter().map(|(rows, _)| rows.len()).collect();
        let spans = longest_filled(&lengths, &missing);
        let rows = self.done[spans.start].0.start..self.done[spans.end - 1].0.end;
        if let Some(fault) = self.fault
            && (rows.len() as f64) < SHARE_LEAST * self.rows as f64
        {
            return Err(fault);
        }
        for gap in &mut self.gaps {
            gap.at_s -= first_s;
        }
        let mut filled = Vec::new();
        let mut lost = 0;
        for at in spans.start + 1..spans.end {
            let missing = missing[at - 1].unwrap_or(0);
            let from = self.done[at].0.start - rows.start + lost;
            filled.push(from..from + missing);
            lost += missing;
        }
        let mut steps = Vec::new();
        if spans.len() < self.done.len() {
            let from_s = self.done[spans.start].1.first_s() - first_s;
            let inside = spans.start..spans.end - 1;
            let outside = self
                .gaps
                .iter()
                .enumerate()
                .filter(|(at, _)| !inside.contains(at));
            steps.push(Processing::LongestSpan {
                from_s,
                to_s: from_s + ((rows.len() + lost) as f64 - 1.0) * step_s,
                whole_s: to_s - first_s,
                gaps: outside.map(|(_, gap)| gap.clone()).collect(),
            });
        }
        if lost > 0 {
            steps.push(Processing::FilledGaps {
                gaps: self.gaps[spans.start..spans.end - 1].to_vec(),
                samples: lost,
                share: lost as f64 / (rows.len() + lost) as f64,
            });
        }
        Ok(UsableRows {
            rows,
            stamps,
            filled,
            steps,
        })
    }
}

impl Spans {
    /// All rows, with the lost samples inserted between spans.
    fn bridged(mut self, stamps: Stamps, first_s: f64) -> Result<UsableRows, RecordError> {
        let step_s = stamps.step_s();
        let missing = |gap: &LostSpan| ((gap.lost_s / step_s).round() as usize).max(1);
        let mut filled = Vec::new();
        let mut lost = 0;
        for (gap, (rows, _)) in self.gaps.iter().zip(&self.done[1..]) {
            let from = rows.start + lost;
            filled.push(from..from + missing(gap));
            lost += missing(gap);
        }
        if let Some(fault) = self.fault
            && lost as f64 > BRIDGED_MOST * self.rows as f64
        {
            return Err(fault);
        }
        for gap in &mut self.gaps {
            gap.at_s -= first_s;
        }
        Ok(UsableRows {
            rows: 0..self.rows,
            stamps,
            steps: bridges(self.gaps, step_s, self.rows),
            filled,
        })
    }
}

/// Filled and bridged samples of channels with the lengths `there`.
fn bridges(gaps: Vec<LostSpan>, step_s: f64, there: usize) -> Vec<Processing> {
    let is_short = |gap: &LostSpan| (gap.lost_s / step_s).round() as usize <= LOST_RUN_MOST;
    let (short, long): (Vec<LostSpan>, Vec<LostSpan>) = gaps.into_iter().partition(is_short);
    let samples: usize = short
        .iter()
        .map(|gap| ((gap.lost_s / step_s).round() as usize).max(1))
        .sum();
    let mut steps = Vec::new();
    if !long.is_empty() {
        steps.push(Processing::Bridged { gaps: long });
    }
    if !short.is_empty() {
        steps.push(Processing::FilledGaps {
            gaps: short,
            samples,
            share: samples as f64 / (there + samples) as f64,
        });
    }
    steps
}

/// Fills lost samples, which hold zeros: short runs by linear prediction, longer ones with the mean of the others.
pub(super) fn fill(samples: &mut [f64], lost: &[Range<usize>]) -> Result<(), SignalError> {
    let (short, long): (Vec<Range<usize>>, Vec<Range<usize>>) =
        lost.iter().cloned().partition(|run| run.len() <= LOST_RUN_MOST);
    // lost samples still hold zeros
    let there = samples.len() - lost.iter().map(Range::len).sum::<usize>();
    let mean = samples.iter().sum::<f64>() / there.max(1) as f64;
    long.into_iter().for_each(|run| samples[run].fill(mean));
    match short.is_empty() {
        true => Ok(()),
        false => fill_lost(samples, &short),
    }
}

/// Number of samples lost in a gap of this many steps, if the gap is short enough to fill and a whole number of steps.
fn short(lost_steps: f64) -> Option<usize> {
    let missing = lost_steps.round();
    let is_whole = (lost_steps - missing).abs() <= WHOLE_STEPS;
    (is_whole && missing >= 1.0 && missing <= LOST_RUN_MOST as f64).then_some(missing as usize)
}

/// The longest of neighbouring spans with fillable gaps between them, the first among equals; `missing` samples follow each span except the
/// last.
fn longest_filled(lengths: &[usize], missing: &[Option<usize>]) -> Range<usize> {
    let mut best = (0, 0..0);
    let mut start = 0;
    while start < lengths.len() {
        let joined = missing[start..]
            .iter()
            .take_while(|missing| missing.is_some())
            .count();
        let together = start..start + joined + 1;
        let there: usize = lengths[together.clone()].iter().sum();
        let lost: usize = missing[start..start + joined].iter().flatten().sum();
        let few = lost as f64 <= LOST_SHARE_MOST * (there + lost) as f64;
        // too many: each span alone
        let candidates = match few {
            true => vec![(there, together.clone())],
            false => together.clone().map(|at| (lengths[at], at..at + 1)).collect(),
        };
        for candidate in candidates {
            if candidate.0 > best.0 {
                best = candidate;
            }
        }
        start = together.end;
    }
    best.1
}

/// A span of one channel.
#[derive(Clone, Copy)]
struct Span {
    first: usize,
    end: usize,
    /// Times of its first and last sample, s.
    from_s: f64,
    to_s: f64,
}

impl Series {
    fn spans(&self, origin_s: f64, step_s: f64) -> Vec<Span> {
        let mut starts = vec![Break { at: 0, begins_s: 0.0 }];
        starts.extend(&self.breaks);
        let ends = starts.iter().skip(1).map(|b| b.at).chain([self.samples.len()]);
        let spans = starts.iter().zip(ends).map(|(start, end)| {
            let from_s = origin_s + start.begins_s;
            Span {
                first: start.at,
                end,
                from_s,
                to_s: from_s + (end - start.at) as f64 * step_s - step_s,
            }
        });
        spans.collect()
    }
}

/// The intersections of two ascending lists of spans.
fn in_both(whole: &[[f64; 2]], spans: &[Span]) -> Vec<[f64; 2]> {
    let mut both = Vec::new();
    let (mut rest, mut others) = (whole.iter().peekable(), spans.iter().peekable());
    while let (Some([from_s, to_s]), Some(span)) = (rest.peek(), others.peek()) {
        let shared = [from_s.max(span.from_s), to_s.min(span.to_s)];
        if shared[1] > shared[0] {
            both.push(shared);
        }
        if *to_s < span.to_s {
            rest.next();
        } else {
            others.next();
        }
    }
    both
}

/// Keeps, for each channel, the samples within the longest time that is whole in all.
pub(super) fn keep_longest(
    series: &mut [&mut Series],
    clocked: bool,
    lost_samples: LostSamples,
) -> Result<Vec<Processing>, RecordError> {
    let Some(broken) = series.iter().find(|one| !one.breaks.is_empty()) else {
        return Ok(Vec::new());
    };
    let gap = broken.gap(0);
    if lost_samples == LostSamples::Refuse {
        return Err(gap);
    }
    let mut steps = Vec::new();
    if lost_samples == LostSamples::Bridged {
        return bridge(series, clocked, &gap);
    }
    if lost_samples == LostSamples::Fill {
        steps.extend(fill_short(series)?);
        if series.iter().all(|one| one.breaks.is_empty()) {
            return Ok(steps);
        }
    }
    let step_s = |one: &Series| one.sampling_rate_hz.map_or(0.0, |rate_hz| 1.0 / rate_hz);
    let begins_s = |one: &Series| one.begins_s.filter(|_| clocked).unwrap_or(0.0) + one.offset_s;
    let spans: Vec<Vec<Span>> = series
        .iter()
        .map(|one| one.spans(begins_s(one), step_s(one)))
        .collect();
    let mut whole: Vec<[f64; 2]> = vec![[f64::NEG_INFINITY, f64::INFINITY]];
    for of_channel in &spans {
        whole = in_both(&whole, of_channel);
    }
    let length_s = |[from_s, to_s]: &[f64; 2]| to_s - from_s;
    let first_s = spans
        .iter()
        .flatten()
        .map(|s| s.from_s)
        .fold(f64::INFINITY, f64::min);
    let last_s = spans
        .iter()
        .flatten()
        .map(|s| s.to_s)
        .fold(f64::NEG_INFINITY, f64::max);
    let longest = whole
        .iter()
        .rev()
        .max_by(|a, b| length_s(a).total_cmp(&length_s(b)));
    let Some(&[from_s, to_s]) = longest.filter(|span| length_s(span) >= SHARE_LEAST * (last_s - first_s))
    else {
        return Err(gap);
    };
    let mut gaps: Vec<LostSpan> = Vec::new();
    for (one, of_channel) in series.iter_mut().zip(&spans) {
        let step_s = step_s(one);
        gaps.extend(of_channel.windows(2).map(|pair| LostSpan {
            channel: Some(one.name.clone()),
            at_s: pair[0].to_s - first_s,
            lost_s: pair[1].from_s - pair[0].to_s - step_s,
        }));
        let middle_s = 0.5 * (from_s + to_s);
        let Some(span) = of_channel
            .iter()
            .find(|s| s.from_s <= middle_s && middle_s <= s.to_s)
        else {
            return Err(gap);
        };
        let steps = |to_s: f64| (to_s - span.from_s) / step_s;
        let before = (steps(from_s) - SAME_TIME_STEPS).ceil().max(0.0) as usize;
        let after = (steps(to_s) + SAME_TIME_STEPS).floor().max(0.0) as usize;
        let end = span.first.saturating_add(after).saturating_add(1).min(span.end);
        one.offset_s += span.from_s + before as f64 * step_s - begins_s(one);
        one.samples.truncate(end);
        one.samples.drain(..span.first.saturating_add(before).min(end));
        one.breaks.clear();
    }
    gaps.sort_by(|a, b| a.at_s.total_cmp(&b.at_s));
    steps.push(Processing::LongestSpan {
        from_s: from_s - first_s,
        to_s: to_s - first_s,
        whole_s: last_s - first_s,
        gaps,
    });
    Ok(steps)
}

/// Keeps all samples of each channel, and adds the lost ones; refuses with `fault` if more is lost than recorded.
fn bridge(
    series: &mut [&mut Series],
    clocked: bool,
    fault: &RecordError,
) -> Result<Vec<Processing>, RecordError> {
    let begins_s = |one: &Series| one.begins_s.filter(|_| clocked).unwrap_or(0.0) + one.offset_s;
    let first_s = series
        .iter()
        .map(|one| begins_s(one))
        .fold(f64::INFINITY, f64::min);
    let (mut gaps, mut there, mut least_s) = (Vec::new(), 0, f64::INFINITY);
    for one in series.iter_mut() {
        let step_s = one.sampling_rate_hz.map_or(f64::NAN, |rate_hz| 1.0 / rate_hz);
        let spans = one.spans(begins_s(one), step_s);
        let mut samples = Vec::with_capacity(one.samples.len());
        let mut lost = Vec::new();
        for (at, span) in spans.iter().enumerate() {
            if let Some(before) = at.checked_sub(1).map(|at| spans[at]) {
                let lost_s = span.from_s - before.to_s - step_s;
                let missing = (lost_s / step_s).round();
                let most = BRIDGED_MOST * one.samples.len() as f64;
                if !(1.0..=most).contains(&missing) {
                    return Err(fault.clone());
                }
                lost.push(samples.len()..samples.len() + missing as usize);
                samples.resize(samples.len() + missing as usize, 0.0);
                gaps.push(LostSpan {
                    channel: Some(one.name.clone()),
                    at_s: before.to_s - first_s,
                    lost_s,
                });
            }
            samples.extend_from_slice(&one.samples[span.first..span.end]);
        }
        fill(&mut samples, &lost)?;
        one.samples = samples;
        one.breaks.clear();
        there += one.samples.len();
        least_s = least_s.min(step_s);
    }
    gaps.sort_by(|a, b| a.at_s.total_cmp(&b.at_s));
    Ok(bridges(gaps, least_s, there))
}

/// Fills the short gaps of each channel, if they are few, and returns their positions.
fn fill_short(series: &mut [&mut Series]) -> Result<Option<Processing>, SignalError> {
    let (mut gaps, mut filled, mut whole) = (Vec::new(), 0, 0);
    for one in series.iter_mut() {
        let rate_hz = one.sampling_rate_hz.unwrap_or(f64::NAN);
        let mut before = Break { at: 0, begins_s: 0.0 };
        let (mut kept, mut lost) = (Vec::new(), Vec::new());
        let mut missing_so_far = 0;
        for next in &one.breaks {
            let ends_s = before.begins_s + (next.at - before.at) as f64 / rate_hz;
            match short((next.begins_s - ends_s) * rate_hz) {
                Some(missing) => {
                    let from = next.at + missing_so_far;
                    lost.push((next.at, from..from + missing, ends_s - 1.0 / rate_hz));
                    missing_so_far += missing;
                }
                None => kept.push(Break {
                    at: next.at + missing_so_far,
                    ..*next
                }),
            }
            before = *next;
        }
        if lost.is_empty()
            || missing_so_far as f64 > LOST_SHARE_MOST * (one.samples.len() + missing_so_far) as f64
        {
            continue;
        }
        let mut samples = Vec::with_capacity(one.samples.len() + missing_so_far);
        let mut taken = 0;
        for (at, run, at_s) in &lost {
            samples.extend_from_slice(&one.samples[taken..*at]);
            samples.resize(run.end, 0.0);
            taken = *at;
            gaps.push(LostSpan {
                channel: Some(one.name.clone()),
                at_s: *at_s,
                lost_s: run.len() as f64 / rate_hz,
            });
        }
        samples.extend_from_slice(&one.samples[taken..]);
        let runs: Vec<Range<usize>> = lost.into_iter().map(|(_, run, _)| run).collect();
        fill_lost(&mut samples, &runs)?;
        (one.samples, one.breaks) = (samples, kept);
        filled += missing_so_far;
        whole += one.samples.len();
    }
    gaps.sort_by(|a, b| a.at_s.total_cmp(&b.at_s));
    Ok((filled > 0).then(|| Processing::FilledGaps {
        gaps,
        samples: filled,
        share: filled as f64 / whole as f64,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn series(name: &str, begins_s: f64, length: usize, breaks: &[(usize, f64)]) -> Series {
        Series {
            sampling_rate_hz: Some(10.0),
            begins_s: Some(begins_s),
            breaks: breaks
                .iter()
                .map(|&(at, begins_s)| Break { at, begins_s })
                .collect(),
            ..Series::new(name, (0..length).map(|i| i as f64).collect())
        }
    }

    /// a: 0 to 9.9 s, 12 to 21.9 s; b, begun 1 s later: 1 to 15.9 s, 16.4 to 31.3 s. Whole in both: 1 to 9.9, 12 to 15.9, 16.4 to 21.9 s.
    #[test]
    fn exact_longest_span_that_two_channels_have_whole() {
        let mut a = series("a", 100.0, 200, &[(100, 12.0)]);
        let mut b = series("b", 101.0, 300, &[(150, 15.4)]);
        let step = keep_longest(&mut [&mut a, &mut b], true, LostSamples::Longest)
            .unwrap()
            .remove(0);
        assert_eq!((a.samples[0], a.samples.len()), (10.0, 90));
        assert_eq!((b.samples[0], b.samples.len()), (0.0, 90));
        assert!((a.offset_s - 1.0).abs() < 1e-9 && b.offset_s.abs() < 1e-9);
        let Processing::LongestSpan {
            from_s,
            to_s,
            whole_s,
            gaps,
        } = &step
        else {
            panic!("{step}")
        };
        let close = |found: f64, exact: f64| (found - exact).abs() < 1e-9;
        assert!(
            close(*from_s, 1.0) && close(*to_s, 9.9) && close(*whole_s, 31.3),
            "{step}"
        );
        let found: Vec<(&str, f64, f64)> = gaps
            .iter()
            .map(|gap| (gap.channel.as_deref().unwrap_or(""), gap.at_s, gap.lost_s))
            .collect();
        for ((name, at_s, lost_s), exact) in found.iter().zip([("a", 9.9, 2.0), ("b", 15.9, 0.4)]) {
            assert!(
                *name == exact.0 && close(*at_s, exact.1) && close(*lost_s, exact.2),
                "{found:?}"
            );
        }
    }

    #[test]
    fn refuses_a_gap_where_the_project_says_so_or_little_is_whole() {
        let mut a = series("a", 0.0, 200, &[(100, 12.0)]);
        let fault = keep_longest(&mut [&mut a], true, LostSamples::Refuse)
            .unwrap_err()
            .to_string();
        assert!(
            fault.starts_with(
                "channel a: a block begins 12 s after the first, but the samples before it end at 10 s"
            ),
            "{fault}"
        );
        let far: Vec<(usize, f64)> = (1..20).map(|i| (i * 10, 20.0 * i as f64)).collect();
        let mut broken = series("a", 0.0, 200, &far);
        assert!(keep_longest(&mut [&mut broken], true, LostSamples::Longest).is_err());
    }
}
