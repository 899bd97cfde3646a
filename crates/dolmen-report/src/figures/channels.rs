//! The channels of a record over time, each as the envelope of its samples, with the unused parts of the file.

use super::axis::{Axis, Scale, Tick};
use super::ink::{Anchor, BLUE, GREY, Label, Line, ORANGE, VERMILLION};
use super::modal::WIDTH_PX;
use super::plot::{Key, Plot};
use super::words::{Axes, Modal, Titles, say};
use dolmen::signal::{LostSpan, Quantity};
use dolmen_words::Language;
use dolmen_words::number::prefix;
use dolmen_work::record_seen::{ChannelSeen, RecordSeen, RecordTime};

/// Number of channels drawn; the CSV file of the figure has all.
pub(crate) const CHANNELS_DRAWN: usize = 8;
/// Height of a panel, px, and the gap between two as a fraction of it.
const PANEL_PX: f64 = 74.0;
const GAP: f64 = 0.3;
/// Width of the drawn unused parts on either side, relative to the time used.
const MARGIN: f64 = 0.25;
/// Parts shorter than this fraction of the axis are drawn as a line.
const SEEN_SHARE: f64 = 0.003;

/// The symbol of the unit of a quantity; empty if unknown.
pub(crate) fn unit_of(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Acceleration => "m/s²",
        Quantity::Velocity => "m/s",
        Quantity::Displacement => "m",
        Quantity::Unknown => "",
    }
}

/// Panels of the first channels, one above the other.
pub(crate) fn channels_over_time(seen: &RecordSeen, language: Language) -> String {
    let shown = &seen.channels[..seen.channels.len().min(CHANNELS_DRAWN)];
    let [from_s, to_s] = drawn_s(&seen.time);
    let count = shown.len() as f64;
    let (mut ticks, mut panels) = (Vec::new(), Vec::new());
    for (at, channel) in shown.iter().enumerate() {
        let base = (count - 1.0 - at as f64) * (1.0 + GAP);
        let panel = Panel::of(channel, base);
        ticks.extend(panel.ticks());
        panels.push(panel);
    }
    let y = Axis {
        name: String::new(),
        from: 0.0,
        to: count * (1.0 + GAP),
        scale: Scale::Linear,
        ticks,
        grid: true,
    };
    let x = Axis::linear(say(Axes::TimeOfTheFile, language), from_s, to_s, 8);
    let mut plot = Plot::new([WIDTH_PX, 64.0 + (1.0 + GAP) * PANEL_PX * count], x, y);
    for panel in &panels {
        shade(&mut plot, &seen.time, panel);
    }
    for panel in panels {
        plot.line(panel.outline(&seen.time), Line::new(BLUE, 0.7));
        let label = Label::new(panel.name, Anchor::Start).small().bold();
        plot.text([from_s, panel.base + 1.0 + 0.5 * GAP], [4.0, 0.0], label);
    }
    keys(&mut plot, &seen.time, language);
    plot.svg(say(Titles::ChannelsOverTime, language))
}

/// The drawn time of the file: the part used, and a quarter of it on either side.
fn drawn_s(time: &RecordTime) -> [f64; 2] {
    let margin = MARGIN * (time.to_s - time.from_s);
    [
        (time.from_s - margin).max(0.0),
        (time.to_s + margin).min(time.whole_s),
    ]
}

/// A channel between `base` and `base + 1` of the plot.
struct Panel<'a> {
    channel: &'a ChannelSeen,
    name: String,
    base: f64,
    axis: Axis,
    factor: f64,
}

impl<'a> Panel<'a> {
    fn of(channel: &'a ChannelSeen, base: f64) -> Self {
        let envelope = &channel.envelope;
        let unit = prefix(&[channel.largest], unit_of(channel.quantity));
        let (symbol, factor) = match channel.quantity {
            Quantity::Unknown => (String::new(), 1.0),
            _ => (unit.unit, unit.factor),
        };
        let ends = envelope.least.iter().chain(&envelope.most);
        let values: Vec<f64> = ends.map(|value| value * factor).collect();
        let name = match symbol.as_str() {
            "" => channel.name.clone(),
            symbol => format!("{} ({symbol})", channel.name),
        };
        Panel {
            channel,
            name,
            base,
            axis: Axis::around("", &values, 3),
            factor,
        }
    }

    fn up(&self, value: f64) -> f64 {
        self.base + (value - self.axis.from) / (self.axis.to - self.axis.from)
    }

    fn ticks(&self) -> Vec<Tick> {
        let each = self.axis.ticks.iter().map(|tick| Tick {
            at: self.up(tick.at),
            text: tick.text.clone(),
        });
        each.collect()
    }

    /// The outline: from the smallest to the largest of a part, then from the largest to the smallest of the next.
    fn outline(&self, time: &RecordTime) -> Vec<[f64; 2]> {
        let envelope = &self.channel.envelope;
        let parts = envelope
            .starts
            .windows(2)
            .zip(envelope.least.iter().zip(&envelope.most));
        let mut points = Vec::with_capacity(2 * envelope.least.len());
        for (part, (ends, (least, most))) in parts.enumerate() {
            let middle = 0.5 * (ends[0] + ends[1] - 1) as f64;
            let at = time.from_s + middle * time.step_s;
            let both = if part % 2 == 0 {
                [least, most]
            } else {
                [most, least]
            };
            points.extend(both.map(|value| [at, self.up(value * self.factor)]));
        }
        points
    }
}

/// Unused, lost and filled times, over one panel.
fn shade(plot: &mut Plot, time: &RecordTime, panel: &Panel<'_>) {
    let top = panel.base + 1.0;
    let ends = [plot.x.from, plot.x.to];
    let mut block = |from: f64, to: f64, colour: &'static str, opacity: f64| {
        let (from, to) = (from.max(ends[0]), to.min(ends[1]));
        if to <= from {
            return;
        }
        if to - from < SEEN_SHARE * (ends[1] - ends[0]) {
            let middle = 0.5 * (from + to);
            plot.line(
                vec![[middle, panel.base], [middle, top]],
                Line::new(colour, 1.6).faint(0.8),
            );
        } else {
            plot.block([from, panel.base], [to, top], colour, opacity);
        }
    };
    block(0.0, time.from_s, GREY, 0.28);
    block(time.to_s, time.whole_s, GREY, 0.28);
    let own = |span: &&LostSpan| {
        span.channel
            .as_ref()
            .is_none_or(|name| *name == panel.channel.name)
    };
    for (spans, colour) in [(&time.lost, VERMILLION), (&time.filled, ORANGE)] {
        for span in spans.iter().filter(own) {
            block(span.at_s, span.at_s + span.lost_s, colour, 0.5);
        }
    }
}

fn keys(plot: &mut Plot, time: &RecordTime, language: Language) {
    let beyond = time.from_s > 0.5 * time.step_s || time.whole_s - time.to_s > 0.5 * time.step_s;
    if beyond {
        plot.key(Key::Block(GREY, 0.28), say(Modal::NotUsed, language));
    }
    if !time.lost.is_empty() {
        plot.key(Key::Block(VERMILLION, 0.5), say(Modal::Lost, language));
    }
    if !time.filled.is_empty() {
        plot.key(Key::Block(ORANGE, 0.5), say(Modal::FilledIn, language));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen::signal::envelope;

    fn seen(lost: Vec<LostSpan>) -> RecordSeen {
        let mut x = vec![0.0; 5000];
        x[1234] = 7.0;
        let channel = |name: &str| ChannelSeen {
            name: name.to_owned(),
            quantity: Quantity::Acceleration,
            mean: 0.0,
            deviation: 0.1,
            largest: 7.0,
            largest_at_s: 32.34,
            envelope: envelope(&x, 600),
        };
        RecordSeen {
            part_s: None,
            channels: (0..10).map(|at| channel(&format!("c{at}"))).collect(),
            time: RecordTime {
                from_s: 20.0,
                to_s: 70.0,
                whole_s: 400.0,
                step_s: 0.01,
                lost,
                filled: Vec::new(),
                lost_elsewhere: false,
            },
            spectrogram: None,
        }
    }

    #[test]
    fn exact_a_spike_reaches_its_height_at_its_time() {
        let seen = seen(Vec::new());
        let panel = Panel::of(&seen.channels[0], 0.0);
        let points = panel.outline(&seen.time);
        let top = points.iter().max_by(|a, b| a[1].total_cmp(&b[1])).unwrap();
        assert_eq!(top[1], panel.up(7.0));
        assert!((top[0] - 32.34).abs() < 0.1, "{top:?}");
        assert_eq!(points.iter().filter(|at| at[1] == panel.up(7.0)).count(), 1);
    }

    #[test]
    fn holds_the_first_channels_are_drawn_and_what_was_not_used_is_shaded() {
        let plain = channels_over_time(&seen(Vec::new()), Language::English);
        assert!(plain.contains("c7 (m/s²)") && !plain.contains("c8"));
        assert!(plain.contains("not used") && !plain.contains("samples lost"));
        let gap = |channel: Option<&str>| LostSpan {
            channel: channel.map(str::to_owned),
            at_s: 10.0,
            lost_s: 5.0,
        };
        let blocks = |svg: &str| svg.matches("<rect").count();
        let all = channels_over_time(&seen(vec![gap(None)]), Language::Korean);
        let one = channels_over_time(&seen(vec![gap(Some("c2"))]), Language::Korean);
        assert!(all.contains("표본 누락"));
        // one block per panel, and one in the legend
        assert_eq!(blocks(&all) - blocks(&plain), CHANNELS_DRAWN + 1);
        assert_eq!(blocks(&one) - blocks(&plain), 2);
        // a quarter of the time used is drawn on either side
        assert_eq!(drawn_s(&seen(Vec::new()).time), [7.5, 82.5]);
    }
}
