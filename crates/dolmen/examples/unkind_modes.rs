//! Accuracy of `identify` on records with the faults of the field and with known modes.
//!
//! ```text
//! cargo run --release -p dolmen --example unkind_modes -- FIRST_SEED LAST_SEED [METHOD] [least=DAMPING_RATIO] [scatter=FLOORS] [order=ORDER] [quiet]
//! ```
//! Prints what went wrong seed by seed, then: modes with enough energy (10 dB over all else in the best combination of the channels, and a
//! damping ratio that an unbiased estimator can know to 30 %: the bound of Cramér and Rao) that were found, within 2 % and of like shape; modes that are none; channels left out
//! though nothing is wrong with them; peaks that were refused, by the test that did, at modes with enough energy that were missed, at weaker ones and
//! elsewhere; tones on modes that the answer names, and of these the ones whose line exceeds the mode twentyfold; how often the 95 % intervals hold the truth, and how wide they are.
#![allow(clippy::print_stdout, reason = "an example: its output is what it is for")]

use dolmen::modal::{
    Identify, Method, ModalAnalysis, Mode, Note, Refusal, UnkindMode, UnkindPlan, UnkindRecord, UnkindTone,
    assurance, identify,
};
use dolmen::signal::{Record, cut, fill_lost};
use dolmen_linalg::Complex64;
use std::collections::BTreeMap;
use std::error::Error;
use std::f64::consts::PI;

/// Tones below this share of the mode that they stand on change nothing that is seen.
const STRONG_TONE: f64 = 0.5;
/// Power of the line of a tone over that of its mode, from which a test that knows the spectrum finds 95 % of tones with a false one in a thousand
/// modes of some hundred lines: ln 10⁵ and 1.65 deviations of the line under a sine.
const CLEAR_TONE: f64 = 20.0;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let [first, last, ref wishes @ ..] = words[..] else {
        return Err(
            "unkind_modes FIRST_SEED LAST_SEED [METHOD] [least=DAMPING_RATIO] [scatter=FLOORS] [order=ORDER] [quiet]"
                .into(),
        );
    };
    let quiet = wishes.contains(&"quiet");
    let mut options = Identify::default();
    for wish in wishes.iter().filter(|wish| **wish != "quiet") {
        if let Some(least) = wish.strip_prefix("least=") {
            options.criteria.damping_ratio_least = Some(least.parse()?);
            continue;
        }
        if let Some(most) = wish.strip_prefix("scatter=") {
            options.clustering.deviation_over_floor_most = most.parse()?;
            continue;
        }
        if let Some(order) = wish.strip_prefix("order=") {
            options.order_most = Some(order.parse()?);
            continue;
        }
        options.method = Method::named(wish).ok_or("there is no such method")?;
    }
    let mut total = Total::default();
    for seed in first.parse::<u64>()?..=last.parse()? {
        let made = UnkindPlan::drawn(seed).make()?;
        let record = whole(&made)?;
        total.records += 1;
        let analysis = identify(&record, &options);
        let said = match &analysis {
            Ok(analysis) => total.count(&made, analysis),
            Err(error) => {
                total.refused += 1;
                let wanted = made.modes.iter().filter(|m| m.has_enough_energy()).count();
                total.wanted += wanted;
                vec![format!("refused ({wanted} modes): {error}")]
            }
        };
        if !quiet && !said.is_empty() {
            let plan = &made.plan;
            println!(
                "seed {seed}: {} channels × {:.0} s × {} Hz, modes {}",
                plan.noise.len(),
                plan.duration_s,
                plan.sampling_rate_hz,
                made.modes.iter().map(shown).collect::<Vec<_>>().join(", ")
            );
            said.iter().for_each(|line| println!("    {line}"));
            if let Ok(analysis) = &analysis {
                analysis.notes.iter().for_each(|note| println!("    - {note}"));
            }
        }
    }
    total.print();
    Ok(())
}

fn shown(mode: &UnkindMode) -> String {
    let decibel = 10.0 * mode.signal_over_rest.max(1e-9).log10();
    format!(
        "{:.3} ({:.2} %, {decibel:.0} dB, to {:.0} %{})",
        mode.mode.frequency_hz,
        100.0 * mode.mode.damping_ratio,
        100.0 * mode.damping_bound,
        if mode.has_enough_energy() {
            ""
        } else {
            ", not asked"
        }
    )
}

/// The longest time that no lost samples interrupt, but for single ones, which are filled in as in records of files.
fn whole(made: &UnkindRecord) -> Result<Record, Box<dyn Error>> {
    let n = made.record.length();
    let rate_hz = made.record.sampling_rate_hz();
    let lost = &made.plan.lost;
    if !lost.is_empty() && lost.iter().all(|(_, length)| *length == 1) {
        let mut places: Vec<usize> = lost.iter().map(|(at, _)| *at).collect();
        places.dedup();
        let runs: Vec<_> = places.iter().map(|at| *at..at + 1).collect();
        let mut channels = Vec::new();
        for channel in 0..made.record.channels().len() {
            let mut samples = made.record.samples(channel).to_vec();
            places.iter().for_each(|at| samples[*at] = f64::NAN);
            fill_lost(&mut samples, &runs)?;
            channels.push(samples);
        }
        return Ok(Record::new(made.record.channels().to_vec(), channels, rate_hz)?);
    }
    let (mut from, mut longest) = (0, 0..0);
    for (at, length) in lost.iter().copied().chain([(n, 0)]) {
        if at > from && at - from > longest.len() {
            longest = from..at;
        }
        from = from.max(at + length);
    }
    if longest.len() == n {
        return Ok(made.record.clone());
    }
    Ok(cut(
        made.record.clone(),
        longest.start as f64 / rate_hz,
        longest.end as f64 / rate_hz,
    )?)
}

#[derive(Default)]
struct Total {
    records: usize,
    refused: usize,
    wanted: usize,
    found: usize,
    weak_found: usize,
    false_modes: usize,
    false_records: usize,
    good_channels: usize,
    tones_on_modes: [usize; 2],
    /// Of these, the tones that an ideal test sees.
    clear_tones: [usize; 2],
    /// Found and all modes with 10 dB and a damping ratio that the length of the record alone allows to know to 30 %.
    by_length: [usize; 2],
    other_tones: [usize; 2],
    false_tones: usize,
    held: [usize; 2],
    known: usize,
    /// Refused peaks by reason: at missed modes with enough energy, at weaker ones, elsewhere.
    refused_peaks: BTreeMap<&'static str, [usize; 3]>,
    errors: Vec<[f64; 2]>,
    widths: Vec<[f64; 2]>,
}

impl Total {
    /// Counts one record, and says what went wrong.
    fn count(&mut self, made: &UnkindRecord, analysis: &ModalAnalysis) -> Vec<String> {
        let mut said = Vec::new();
        let mut left: Vec<&Mode> = analysis.modes.modes.iter().collect();
        let kept: Vec<usize> = analysis
            .modes
            .channels
            .iter()
            .filter_map(|c| made.record.channels().iter().position(|own| own.name == c.name))
            .collect();
        let order = {
            let mut order: Vec<&UnkindMode> = made.modes.iter().collect();
            order.sort_by(|a, b| b.signal_over_rest.total_cmp(&a.signal_over_rest));
            order
        };
        for truth in order {
            let wanted = truth.has_enough_energy();
            self.wanted += usize::from(wanted);
            let is_long = truth.signal_over_rest >= 10.0 && truth.damping_floor <= 0.3;
            let place = nearest(truth, &left, (&kept, made));
            self.by_length[0] += usize::from(is_long && place.is_some());
            self.by_length[1] += usize::from(is_long);
            let Some(at) = place else {
                if wanted {
                    said.push(format!(
                        "missed {:.4} Hz{}",
                        truth.mode.frequency_hz,
                        groups_at(truth, analysis, &kept)
                    ));
                }
                continue;
            };
            let mode = left.remove(at);
            if wanted {
                self.found += 1;
                self.measure(truth, mode, &mut said);
            } else {
                self.weak_found += 1;
            }
        }
        self.count_refused(made, analysis);
        let tones = named_hz(&analysis.notes);
        let is_named = |hz: f64| tones.iter().any(|named| (named / hz - 1.0).abs() < 0.01);
        let doubted = doubted_hz(&analysis.notes);
        let is_doubted = |hz: f64| doubted.iter().any(|of| (of / hz - 1.0).abs() < 0.01);
        let mut false_here = 0;
        for mode in left {
            if !is_named(mode.frequency_hz) && !is_doubted(mode.frequency_hz) {
                false_here += 1;
                said.push(format!(
                    "FALSE mode {:.4} Hz, damping {:.2} %, orders {:?}{}",
                    mode.frequency_hz,
                    100.0 * mode.damping_ratio.unwrap_or(0.0),
                    mode.orders.len(),
                    beside(mode, made, analysis, &kept)
                ));
            }
        }
        self.false_modes += false_here;
        self.false_records += usize::from(false_here > 0);
        let plan = &made.plan;
        for (c, channel) in made.record.channels().iter().enumerate() {
            let is_bad = plan.loose == Some(c)
                || plan.spikes.is_some_and(|(own, _)| own == c)
                || plan.clock.is_some_and(|(own, _)| own == c);
            if !kept.contains(&c) && !is_bad {
                self.good_channels += 1;
                said.push(format!("left out {}", channel.name));
            }
        }
        for tone in plan.tones.iter().filter(|tone| tone.share > 0.5) {
            let counts = match tone.over_mode {
                Some(_) if tone.strength >= STRONG_TONE => &mut self.tones_on_modes,
                Some(_) => continue,
                None => &mut self.other_tones,
            };
            let is_here = is_named(tone.frequency_hz);
            counts[0] += usize::from(is_here);
            counts[1] += 1;
            if tone
                .over_mode
                .is_some_and(|mode| over_mode(plan, tone, mode) >= CLEAR_TONE)
            {
                self.clear_tones[0] += usize::from(is_here);
                self.clear_tones[1] += 1;
            }
            if tone.over_mode.is_some() && !is_here {
                said.push(format!(
                    "tone on the mode at {:.4} Hz, {:.2} as strong in {:.2} of the time, its line {:.0} times the mode, not named{}",
                    tone.frequency_hz,
                    tone.strength,
                    tone.share,
                    tone.over_mode.map_or(0.0, |mode| over_mode(plan, tone, mode)),
                    if is_doubted(tone.frequency_hz) { " (narrow)" } else { "" }
                ));
            }
        }
        for hz in tones {
            let is_tone = |at: f64| (hz / at - 1.0).abs() < 0.01;
            if !plan.tones.iter().any(|tone| is_tone(tone.frequency_hz)) {
                self.false_tones += 1;
                said.push(format!("named a tone at {hz:.4} Hz where none is"));
            }
        }
        said
    }

    /// Why peaks of the spectrum are no modes.
    fn count_refused(&mut self, made: &UnkindRecord, analysis: &ModalAnalysis) {
        let peaks = analysis.notes.iter().flat_map(|note| match note {
            Note::PeaksWithoutMode { peaks } => peaks.as_slice(),
            _ => &[],
        });
        for peak in peaks {
            let is_here = |of: &&UnkindMode| (of.mode.frequency_hz / peak.frequency_hz - 1.0).abs() < 0.03;
            let here: Vec<&UnkindMode> = made.modes.iter().filter(is_here).collect();
            let place = match here.iter().any(|of| of.has_enough_energy()) {
                true => 0,
                false if !here.is_empty() => 1,
                false => 2,
            };
            self.refused_peaks.entry(reason(peak.refusal)).or_default()[place] += 1;
        }
    }

    fn measure(&mut self, truth: &UnkindMode, mode: &Mode, said: &mut Vec<String>) {
        let (f, zeta) = (truth.mode.frequency_hz, truth.mode.damping_ratio);
        let (Some(found), Some(sd_hz), Some(sd)) =
            (mode.damping_ratio, mode.frequency_sd_hz, mode.damping_ratio_sd)
        else {
            return;
        };
        // floors of the standard deviations: f ζ and ζ times the floor of the damping ratio
        let floor = [f * zeta * truth.damping_floor, zeta * truth.damping_floor];
        let off = [(mode.frequency_hz - f) / sd_hz, (found - zeta) / sd];
        for (held, off) in self.held.iter_mut().zip(off) {
            *held += usize::from(off.abs() <= 1.96);
        }
        self.known += 1;
        if off.iter().any(|off| off.abs() > 4.0) {
            said.push(format!(
                "{f:.4} Hz off by {:.1} σ, damping {:.2} % by {:.1} σ ({:.3} ± {:.3} %)",
                off[0],
                100.0 * zeta,
                off[1],
                100.0 * found,
                100.0 * sd
            ));
        }
        self.errors
            .push([(mode.frequency_hz - f) / floor[0], (found - zeta) / floor[1]]);
        self.widths.push([sd_hz / floor[0], sd / floor[1]]);
    }

    fn print(&self) {
        let share = |part: usize, of: usize| 100.0 * part as f64 / of.max(1) as f64;
        println!("{} records, {} refused", self.records, self.refused);
        println!(
            "modes with enough energy found: {} of {} ({:.1} %), and {} weaker ones",
            self.found,
            self.wanted,
            share(self.found, self.wanted),
            self.weak_found
        );
        let [found, of] = self.by_length;
        println!("by the length of the record alone: {found} of {of}");
        println!(
            "false modes: {} in {} records",
            self.false_modes, self.false_records
        );
        for (reason, [missed, weak, elsewhere]) in &self.refused_peaks {
            println!(
                "peaks refused, {reason}: {missed} at modes with enough energy, {weak} at weaker ones, {elsewhere} elsewhere"
            );
        }
        println!("good channels left out: {}", self.good_channels);
        let [named, of] = self.tones_on_modes;
        println!(
            "tones on modes named: {named} of {of} ({:.0} %)",
            share(named, of)
        );
        let [named, of] = self.clear_tones;
        println!("of these with a line twenty times the mode: {named} of {of}");
        let [named, of] = self.other_tones;
        println!(
            "other tones named: {named} of {of}; tones named where none is: {}",
            self.false_tones
        );
        for (i, what) in ["frequency", "damping"].into_iter().enumerate() {
            let mut errors: Vec<f64> = self.errors.iter().map(|e| e[i].abs()).collect();
            let mut widths: Vec<f64> = self.widths.iter().map(|w| w[i]).collect();
            errors.sort_by(f64::total_cmp);
            widths.sort_by(f64::total_cmp);
            let at = |x: &[f64], q: f64| x.get((q * x.len() as f64) as usize).copied().unwrap_or(f64::NAN);
            println!(
                "{what}: 95 % intervals hold {:.1} %; over the floor: error (68 % of them) {:.2}, (95 %) {:.2}; stated deviation, mean {:.2}, median {:.2}",
                share(self.held[i], self.known),
                at(&errors, 0.683),
                at(&errors, 0.954) / 2.0,
                widths.iter().sum::<f64>() / widths.len().max(1) as f64,
                at(&widths, 0.5),
            );
        }
    }
}

/// Expected power of the line of a tone over that of its mode: r² s² π w (1 + δ²), with the ratio r of root mean squares, the share s of the time, the
/// half width w of the mode in lines, and the distance δ in half widths. A mode of less than four lines hides none and shows none.
fn over_mode(plan: &UnkindPlan, tone: &UnkindTone, mode: usize) -> f64 {
    let mode = &plan.modes[mode];
    let half_width_hz = mode.damping_ratio * mode.frequency_hz;
    let lines = half_width_hz * plan.duration_s;
    let off = (tone.frequency_hz - mode.frequency_hz) / half_width_hz;
    let over = (tone.strength * tone.share).powi(2) * PI * lines * (1.0 + off * off);
    if lines < 4.0 { 0.0 } else { over }
}

/// The groups of poles with a shape like that of a mode, near it.
fn groups_at(truth: &UnkindMode, analysis: &ModalAnalysis, kept: &[usize]) -> String {
    let duration_s = analysis.modes.duration_s;
    let shape: Vec<Complex64> = kept
        .iter()
        .map(|c| Complex64::new(truth.mode.shape[*c], 0.0))
        .collect();
    let within = 0.03_f64.max(truth.mode.damping_ratio);
    let near = analysis
        .clusters
        .iter()
        .filter(|of| (of.medoid.frequency_hz / truth.mode.frequency_hz - 1.0).abs() < within);
    let each = near.map(|of| {
        let over_floor = of
            .deviation
            .as_ref()
            .map_or(f64::NAN, |d| d.frequency_sd_hz / of.medoid.floor_hz(duration_s));
        format!(
            "; {:?} {:.4} Hz, {:.2} %, MAC {:.2}, MPC {:.2}, {} orders, {over_floor:.1} floors",
            of.fate,
            of.medoid.frequency_hz,
            100.0 * of.medoid.damping_ratio,
            if of.medoid.shape.len() == shape.len() {
                assurance(&shape, &of.medoid.shape)
            } else {
                f64::NAN
            },
            of.medoid.phase_collinearity,
            of.orders.len()
        )
    });
    each.collect()
}

/// What a mode that is none is like: the modes that were given near it, and the true ones.
fn beside(mode: &Mode, made: &UnkindRecord, analysis: &ModalAnalysis, kept: &[usize]) -> String {
    let is_near = |hz: f64| (hz / mode.frequency_hz - 1.0).abs() < 0.05;
    let given = analysis
        .modes
        .modes
        .iter()
        .filter(|of| is_near(of.frequency_hz) && !std::ptr::eq(*of, mode))
        .map(|of| {
            format!(
                "; given {:.4} Hz, {:.2} %, MAC {:.3}",
                of.frequency_hz,
                100.0 * of.damping_ratio.unwrap_or(0.0),
                assurance(&of.shape, &mode.shape)
            )
        });
    let true_ones = made
        .modes
        .iter()
        .filter(|of| is_near(of.mode.frequency_hz))
        .map(|of| {
            let shape: Vec<Complex64> = kept
                .iter()
                .map(|c| Complex64::new(of.mode.shape[*c], 0.0))
                .collect();
            format!(
                "; true {:.4} Hz, MAC {:.3}",
                of.mode.frequency_hz,
                assurance(&shape, &mode.shape)
            )
        });
    given.chain(true_ones).collect()
}

fn reason(refusal: Option<Refusal>) -> &'static str {
    match refusal {
        None => "unsaid",
        Some(Refusal::NoPole) => "no pole",
        Some(Refusal::OutOfRange { .. }) => "out of range",
        Some(Refusal::Damping { .. }) => "damping",
        Some(Refusal::Complex { .. }) => "complex shape",
        Some(Refusal::Scattered { .. }) => "scatter",
        Some(Refusal::FewOrders { .. }) => "few orders",
        Some(Refusal::SplitsOff) => "part of another mode",
        Some(Refusal::Blend { .. }) => "several in one",
        Some(Refusal::Machine) => "machine",
        Some(Refusal::Narrow { .. }) => "narrow",
        Some(Refusal::InSpells) => "in spells",
        Some(Refusal::Clipping) => "clipping",
    }
}

/// Frequencies of all that is called a machine.
fn named_hz(notes: &[Note]) -> Vec<f64> {
    notes
        .iter()
        .flat_map(|note| match note {
            Note::Tones { tones } => tones.iter().map(|t| t.frequency_hz).collect(),
            Note::TonesOnModes { tones } => tones.iter().map(|t| t.frequency_hz).collect(),
            Note::Harmonics { steady, .. } => steady.iter().map(|k| k.frequency_hz).collect(),
            Note::Wandering { machines, .. } => machines.iter().map(|of| of.frequency_hz).collect(),
            _ => Vec::new(),
        })
        .collect()
}

/// Frequencies of peaks that are called machines or light modes.
fn doubted_hz(notes: &[Note]) -> Vec<f64> {
    let each = notes.iter().filter_map(|note| match note {
        Note::Narrow { peaks, .. } => Some(peaks.iter().map(|peak| peak.frequency_hz)),
        _ => None,
    });
    each.flatten().collect()
}

/// Index of the mode within 2 % (four floors, if that is more) whose shape is most alike, if it is alike at all.
fn nearest(truth: &UnkindMode, modes: &[&Mode], (kept, made): (&[usize], &UnkindRecord)) -> Option<usize> {
    let is_bad = |c: usize| made.plan.loose == Some(c) || made.plan.clock.is_some_and(|(own, _)| own == c);
    let good: Vec<usize> = (0..kept.len()).filter(|i| !is_bad(kept[*i])).collect();
    let shape: Vec<Complex64> = good
        .iter()
        .map(|i| Complex64::new(truth.mode.shape[kept[*i]], 0.0))
        .collect();
    let within = 0.02_f64.max(4.0 * truth.mode.damping_ratio * truth.damping_floor);
    let alike = |i: usize| {
        let own: Vec<Complex64> = good.iter().map(|c| modes[i].shape[*c]).collect();
        assurance(&shape, &own)
    };
    (0..modes.len())
        .filter(|&i| (modes[i].frequency_hz / truth.mode.frequency_hz - 1.0).abs() < within)
        .filter(|&i| good.len() < 2 || alike(i) > 0.5)
        .max_by(|&a, &b| alike(a).total_cmp(&alike(b)))
}
