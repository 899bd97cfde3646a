//! Data for the figures of a record: the envelope of each channel over the time of its file, the unused parts, and a spectrogram.

use dolmen::modal::ModalAnalysis;
use dolmen::signal::{
    Channel, Envelope, LostSpan, Processing, Quantity, Record, SignalError, Spectrogram, TimeFrequency,
    Welch, cross_spectra, envelope, spectrogram,
};

/// Number of parts of an envelope: one for each pixel of a figure.
const PARTS: usize = 600;
/// Number of frequency lines of a spectrogram up to the highest frequency of the search, and number of its columns. Chosen here for a figure.
const LINES: f64 = 96.0;
const COLUMNS: usize = 100;
/// Upper limit of the frequencies of a spectrogram, relative to the highest frequency of the search: as for the spectrum in the figure.
const BEYOND_RANGE: f64 = 1.08;
/// Upper limit relative to the highest mode found, if that is lower.
const BEYOND_MODES: f64 = 2.0;
/// Fewest samples of a segment.
const SEGMENT_LEAST: usize = 16;

/// Data for the figures of a record.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordSeen {
    /// Each channel.
    pub channels: Vec<ChannelSeen>,
    /// Its time.
    pub time: RecordTime,
    /// The part whose modes were identified, from and to, s from the first sample of the file; `None` for all that is drawn.
    pub part_s: Option<[f64; 2]>,
    /// The spectrogram; `None` for a record too short for one.
    pub spectrogram: Option<SpectrogramSeen>,
}

/// Data for the figure of a channel.
#[derive(Clone, Debug, PartialEq)]
pub struct ChannelSeen {
    /// Its name.
    pub name: String,
    /// Its quantity.
    pub quantity: Quantity,
    /// Mean of the samples used.
    pub mean: f64,
    /// Root mean square about the mean.
    pub deviation: f64,
    /// Largest deviation from the mean.
    pub largest: f64,
    /// Its time, s from the first sample of the file.
    pub largest_at_s: f64,
    /// Smallest and largest sample of each part of the time.
    pub envelope: Envelope,
}

/// The times of a record, s from the first sample of its file; for several files, from the first sample in use.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordTime {
    /// First sample in use.
    pub from_s: f64,
    /// End of the last sample in use.
    pub to_s: f64,
    /// End of the last sample of the file.
    pub whole_s: f64,
    /// Time between samples in use, s.
    pub step_s: f64,
    /// Lost samples.
    pub lost: Vec<LostSpan>,
    /// Lost samples that were filled.
    pub filled: Vec<LostSpan>,
    /// Whether several files lost samples, each with its own times; these are then not in `lost` and `filled`.
    pub lost_elsewhere: bool,
}

/// The spectrogram of one channel.
#[derive(Clone, Debug, PartialEq)]
pub struct SpectrogramSeen {
    /// The index of the channel.
    pub channel: usize,
    /// Whether the project names it; otherwise it has the largest share of motion in the range.
    pub is_asked: bool,
    /// Upper end of the frequencies shown, Hz.
    pub end_hz: f64,
    /// The densities.
    pub of: TimeFrequency,
}

impl RecordSeen {
    /// Data for the figures of a record that was `read_s` long when read; `asked` is the channel of the spectrogram in the project.
    ///
    /// # Errors
    /// None for a record with identified modes.
    pub fn of(
        record: &Record,
        read_s: f64,
        (analysis, asked): (&ModalAnalysis, Option<usize>),
        is_one_file: bool,
    ) -> Result<Self, SignalError> {
        let time = RecordTime::of(record, read_s, is_one_file);
        let channels = (0..record.channels().len()).map(|at| ChannelSeen::of(record, at, &time));
        Ok(RecordSeen {
            channels: channels.collect(),
            spectrogram: SpectrogramSeen::of(record, analysis, asked)?,
            part_s: None,
            time,
        })
    }
}

impl RecordSeen {
    /// The same with the part of the record whose modes were identified, if it was cut out of it.
    pub fn with_part(self, part: Option<&Record>) -> Self {
        let last = part.and_then(|part| {
            let mut cuts = part.history().iter().filter_map(|step| match step {
                Processing::Cut { from_s, to_s } => Some([*from_s, *to_s]),
                _ => None,
            });
            cuts.next_back()
        });
        let part_s = last.map(|span| span.map(|at_s| at_s + self.time.from_s));
        RecordSeen { part_s, ..self }
    }
}

impl ChannelSeen {
    fn of(record: &Record, at: usize, time: &RecordTime) -> Self {
        let (channel, samples): (&Channel, &[f64]) = (&record.channels()[at], record.samples(at));
        let (mean, envelope) = (record.mean(at), envelope(samples, PARTS));
        let ends = envelope.least.iter().chain(&envelope.most);
        let largest = ends.map(|x| (x - mean).abs()).fold(0.0, f64::max);
        let sample = samples.iter().position(|x| (x - mean).abs() == largest);
        ChannelSeen {
            name: channel.name.clone(),
            quantity: channel.quantity,
            mean,
            deviation: record.mean_square(at).sqrt(),
            largest,
            largest_at_s: time.from_s + sample.unwrap_or(0) as f64 * time.step_s,
            envelope,
        }
    }
}

impl RecordTime {
    /// From the history of the record; `read_s` is its length when read.
    fn of(record: &Record, read_s: f64, is_one_file: bool) -> Self {
        let step_s = 1.0 / record.sampling_rate_hz();
        let (mut from_s, mut whole_s) = (0.0, read_s);
        let (mut lost, mut filled, mut lost_elsewhere) = (Vec::new(), Vec::new(), false);
        for step in record.history() {
            match step {
                Processing::LongestSpan { .. }
                | Processing::FilledGaps { .. }
                | Processing::Bridged { .. }
                    if !is_one_file =>
                {
                    lost_elsewhere = true;
                }
                Processing::LongestSpan {
                    from_s: first_s,
                    whole_s: all_s,
                    gaps,
                    ..
                } => {
                    from_s += first_s;
                    whole_s = all_s + step_s;
                    lost.extend(gaps.iter().cloned());
                }
                Processing::Bridged { gaps } => lost.extend(gaps.iter().cloned()),
                Processing::FilledGaps { gaps, .. } => filled.extend(gaps.iter().cloned()),
                Processing::Cut { from_s: first_s, .. } => from_s += first_s,
                _ => {}
            }
        }
        let to_s = from_s + record.length() as f64 * step_s;
        RecordTime {
            from_s,
            to_s,
            whole_s: whole_s.max(to_s),
            step_s,
            lost,
            filled,
            lost_elsewhere,
        }
    }
}

impl SpectrogramSeen {
    fn of(
        record: &Record,
        analysis: &ModalAnalysis,
        asked: Option<usize>,
    ) -> Result<Option<Self>, SignalError> {
        let rate_hz = record.sampling_rate_hz();
        let nyquist_hz = 0.5 * rate_hz;
        let range_hz = analysis.settings.range_hz;
        let end_hz = match range_hz[1].is_finite() && range_hz[1] > 0.0 {
            true => (BEYOND_RANGE * range_hz[1]).min(nyquist_hz),
            false => nyquist_hz,
        };
        let highest = analysis.modes.modes.last();
        let end_hz = highest.map_or(end_hz, |mode| end_hz.min(BEYOND_MODES * mode.frequency_hz));
        // the frequency resolution of the figure, or for a short record as many lines as columns
        let resolution_hz = (end_hz / LINES).max((0.5 * end_hz / record.duration_s()).sqrt());
        let segment_length = 2 * ((0.5 * rate_hz / resolution_hz).round() as usize);
        if segment_length < SEGMENT_LEAST || 2 * segment_length > record.length() {
            return Ok(None);
        }
        let channel = match asked {
            Some(channel) => channel,
            None => strongest(record, segment_length, [range_hz[0], end_hz])?,
        };
        let options = Spectrogram {
            segment_length,
            columns_most: COLUMNS,
        };
        Ok(Some(SpectrogramSeen {
            channel,
            is_asked: asked.is_some(),
            end_hz,
            of: spectrogram(record, channel, &options)?,
        }))
    }
}

/// The channel with the largest share of motion in the range, among those that measure the most common quantity.
fn strongest(
    record: &Record,
    segment_length: usize,
    [low_hz, high_hz]: [f64; 2],
) -> Result<usize, SignalError> {
    let quantity = |at: usize| record.channels()[at].quantity;
    let all = 0..record.channels().len();
    let alike = |at: &usize| {
        all.clone()
            .filter(|other| quantity(*other) == quantity(*at))
            .count()
    };
    let most = all.clone().map(|at| alike(&at)).max().unwrap_or(0);
    let mut best = (0, f64::NEG_INFINITY);
    for at in all.clone().filter(|at| alike(at) == most) {
        let alone = Record::from_contiguous(
            vec![record.channels()[at].clone()],
            record.samples(at).to_vec(),
            record.sampling_rate_hz(),
        )?;
        let spectra = cross_spectra(&alone, &Welch { segment_length })?;
        let lines = spectra.frequency_hz.iter().zip(spectra.power(0));
        let within = lines.filter(|(hz, _)| (low_hz..=high_hz).contains(*hz));
        let power: f64 = within.map(|(_, power)| power).sum();
        if power > best.1 {
            best = (at, power);
        }
    }
    Ok(best.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen::modal::{Identify, ReferenceCase, identify};
    use dolmen::signal::cut;

    #[test]
    fn exact_times_of_a_cut_record_that_lost_samples() {
        let channels = vec![Channel::named("x")];
        let mut record = Record::new(channels, vec![vec![0.0; 1000]], 10.0).unwrap();
        let gap = LostSpan {
            channel: None,
            at_s: 49.9,
            lost_s: 20.0,
        };
        record.note(Processing::LongestSpan {
            from_s: 70.0,
            to_s: 169.9,
            whole_s: 199.9,
            gaps: vec![gap.clone()],
        });
        let record = cut(record, 5.0, 95.0).unwrap();
        let time = RecordTime::of(&record, 100.0, true);
        assert_eq!((time.from_s, time.to_s, time.whole_s), (75.0, 165.0, 200.0));
        assert_eq!((time.lost, time.lost_elsewhere), (vec![gap], false));
        let time = RecordTime::of(&record, 100.0, false);
        assert_eq!(
            (time.from_s, time.whole_s, time.lost_elsewhere),
            (5.0, 100.0, true)
        );
    }

    #[test]
    fn exact_the_part_of_the_modes_is_counted_from_the_first_sample_of_the_file() {
        let record = Record::new(vec![Channel::named("x")], vec![vec![0.0; 1000]], 10.0).unwrap();
        let record = cut(record, 5.0, 95.0).unwrap();
        let seen = RecordSeen {
            channels: Vec::new(),
            time: RecordTime::of(&record, 100.0, true),
            part_s: None,
            spectrogram: None,
        };
        assert_eq!(seen.clone().with_part(None).part_s, None);
        let part = cut(record, 40.0, 80.0).unwrap();
        assert_eq!(seen.with_part(Some(&part)).part_s, Some([45.0, 85.0]));
    }

    #[test]
    fn holds_the_spectrogram_is_of_the_strongest_channel_or_of_the_one_asked_for() {
        let record = ReferenceCase::ShearChain.made(1).unwrap().make().unwrap();
        let analysis = identify(&record, &Identify::default()).unwrap();
        let seen = RecordSeen::of(&record, record.duration_s(), (&analysis, None), true).unwrap();
        let of = seen.spectrogram.unwrap();
        // the upper floor moves more in the first mode, which contains most of the motion
        assert!(!of.is_asked);
        assert!(seen.channels[of.channel].deviation >= seen.channels[1 - of.channel].deviation);
        assert!(of.of.columns.len() <= COLUMNS && of.end_hz > 4.2);
        let shown = of.of.frequency_hz.iter().filter(|hz| **hz <= of.end_hz).count();
        assert!((40..=110).contains(&shown), "{shown}");
        let asked = 1 - of.channel;
        let seen = RecordSeen::of(&record, record.duration_s(), (&analysis, Some(asked)), true).unwrap();
        let of = seen.spectrogram.unwrap();
        assert_eq!((of.channel, of.is_asked), (asked, true));
    }

    #[test]
    fn exact_the_largest_sample_and_its_time() {
        let mut x = vec![1.0; 1000];
        x[300] = -5.0;
        let record = Record::new(vec![Channel::named("x")], vec![x], 10.0).unwrap();
        let time = RecordTime::of(&record, 100.0, true);
        let seen = ChannelSeen::of(&record, 0, &time);
        assert!((seen.mean - 0.994).abs() < 1e-12 && (seen.largest - 5.994).abs() < 1e-12);
        assert!((seen.largest_at_s - 30.0).abs() < 1e-9);
        assert!((seen.deviation - 6.0 * (0.001_f64 * 0.999).sqrt()).abs() < 1e-12);
    }
}
