//! The section of a record with earthquakes: measurements, and the structure before, during and after them.

use super::earthquake::findings;
use super::earthquake_words::{Quake, share, time};
use super::values::hertz;
use crate::document::{Block, Cell, Column, Document, Figure, Series, Table};
use crate::figures::{frequency_through, spectra_of_channels, through_series};
use dolmen::modal::{AtLeast, During, LastingChange, StrongChannel};
use dolmen_words::{Digits, Quantity, Sentence, Unit};
use dolmen_work::surveyed::RecordAnswer;

/// The section of a record with an earthquake.
pub(super) fn section<'a>(document: &mut Document<'a>, record: &'a RecordAnswer) {
    let Some(of) = &record.earthquake else { return };
    let found = &of.found;
    for finding in findings(of) {
        document.paragraph(finding.sentence);
    }
    let is_one = found.events.len() == 1;
    for (at, event) in found.events.iter().enumerate() {
        let caption = match is_one {
            true => Quake::Measured,
            false => Quake::MeasuredIn { number: at + 1 },
        };
        document.put(Block::Table(channels(caption, &event.channels)));
    }
    let largest = found.largest();
    if largest.channels.iter().any(|of| !of.spectrum.is_empty()) {
        let caption = vec![Quake::Spectra.into(), Quake::SpectraMeaning.into()];
        let figure = Figure::drawn(caption, move |language| {
            spectra_of_channels(&largest.channels, language)
        });
        document.charted(figure.with_series(move || spectra(&largest.channels)));
    }
    match &found.strongest().during {
        During::Driven(of) => document.paragraph(Quake::ByInputs {
            inputs: of.inputs.clone(),
        }),
        During::Tracked(track) => document.paragraph(Quake::ByTrack {
            windows: track.points.len(),
            lowest: hertz(track.lowest.frequency_hz),
            at: time(track.lowest.at_s),
        }),
        During::Unknown => {}
    }
    let caption = vec![Quake::Through.into(), Quake::ThroughMeaning.into()];
    let through = Figure::drawn(caption, move |language| frequency_through(found, language));
    document.charted(through.with_series(move || through_series(found)));
    if !found.changes.is_empty() {
        let caption = match is_one {
            true => Quake::Changes,
            false => Quake::ChangesInAll,
        };
        document.put(Block::Table(changes(caption, &found.changes)));
    }
    for (at, event) in found.events.iter().enumerate() {
        if !is_one && !event.changes.is_empty() {
            let caption = Quake::ChangesOf { number: at + 1 };
            document.put(Block::Table(changes(caption, &event.changes)));
        }
    }
    document.note(Quake::Softer);
    document.note(Quake::NoTilt);
}

fn channels(caption: Quake, of: &[StrongChannel]) -> Table {
    let band = of.iter().find_map(|of| of.velocity_band_hz);
    let band = band.map(|[low, high]| Quake::Band {
        low: hertz(low),
        high: hertz(high),
    });
    let is_any_larger = of.iter().any(|of| of.at_least.is_some());
    let row = |of: &StrongChannel| {
        let number = |value: Option<f64>, unit: &str| {
            Cell::Number(value.map(|value| Quantity::new(value, Unit::si(unit), Digits::Significant(3))))
        };
        let is_acceleration = of.peak_acceleration_m_s2.is_some();
        let mut row = vec![
            Cell::words(Quake::Named {
                name: of.name.clone(),
            }),
            number(of.peak_acceleration_m_s2, "m/s²"),
            Cell::Number(Some(time(of.peak_at_s))),
            number(of.peak_velocity_m_s, "m/s"),
            number(of.arias_intensity_m_s, "m/s"),
            number(is_acceleration.then_some(of.noise), "m/s²"),
        ];
        if is_any_larger {
            row.push(Cell::words(match of.at_least {
                Some(AtLeast::Clipped) => Quake::Clipped,
                Some(AtLeast::Lost) => Quake::Lost,
                Some(AtLeast::Edge) => Quake::Edge,
                None => Quake::Shown,
            }));
        }
        row
    };
    let mut table = Table {
        caption: std::iter::once(caption).chain(band).map(Sentence::from).collect(),
        columns: vec![
            Column::words(Quake::Channel),
            Column::numbers(Quake::PeakOf, Unit::si("m/s²")),
            Column::numbers(Quake::At, Unit::si("s")),
            Column::numbers(Quake::PeakVelocity, Unit::si("m/s")),
            Column::numbers(Quake::Arias, Unit::si("m/s")),
            Column::numbers(Quake::Noise, Unit::si("m/s²")),
        ],
        rows: of.iter().map(row).collect(),
    };
    if is_any_larger {
        table.columns.push(Column::words(Quake::MayBeLarger));
    }
    table
}

fn changes(caption: Quake, all: &[LastingChange]) -> Table {
    let frequency = |hz: f64, sd_si: Option<f64>| {
        Cell::Number(Some(Quantity {
            sd_si,
            ..Quantity::new(hz, Unit::si("Hz"), Digits::Significant(5))
        }))
    };
    let row = |of: &LastingChange| {
        vec![
            frequency(of.before_hz, of.before_sd_hz),
            frequency(of.after_hz, of.after_sd_hz),
            Cell::Number(Some(share(of.ratio))),
            Cell::Number(of.half_width_95().map(share)),
        ]
    };
    Table {
        caption: vec![caption.into()],
        columns: vec![
            Column::numbers(Quake::Before, Unit::si("Hz")),
            Column::numbers(Quake::After, Unit::si("Hz")),
            Column::numbers(Quake::Change, Unit::percent()),
            Column::numbers(Quake::Half, Unit::percent()),
        ],
        rows: all.iter().map(row).collect(),
    }
}

/// Response spectra over period, one column per channel.
fn spectra(channels: &[StrongChannel]) -> Vec<Series> {
    let with = || channels.iter().filter(|of| !of.spectrum.is_empty());
    let periods = with().next().map(|of| &of.spectrum);
    let periods = periods.into_iter().flatten().map(|of| of.period_s);
    let each = with().map(|of| {
        let name = Quake::AccelerationOf {
            channel: of.name.clone(),
        };
        let all = of.spectrum.iter().map(|of| of.pseudo_acceleration_m_s2());
        Series::numbers(name, "m/s²", all)
    });
    std::iter::once(Series::numbers(Quake::Period, "s", periods))
        .chain(each)
        .collect()
}
