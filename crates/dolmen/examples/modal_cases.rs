//! Accuracy of `identify` on simulated records with known poles, over many seeds.
//!
//! ```text
//! cargo run --release -p dolmen --example modal_cases -- \
//!     chain|pairs|twisting|tower FIRST_SEED LAST_SEED [METHOD] [block_rows=N] [decimation=N] [order_most=N] [tones]
//! ```
//! METHOD as in a project file; tones adds machines at 7 and 50 Hz; what is not given is chosen from the data. Prints for each mode: bias of the frequency and of the
//! damping ratio with their standard errors, scatter over its floor (Au 2014), stated over true scatter; then the root
//! mean squares of these over all modes, modes missed and false ones.
#![allow(clippy::print_stdout, reason = "an example: its output is what it is for")]

use dolmen::modal::{Identify, MadeMode, Method, Mode, ReferenceCase, assurance, identify};
use dolmen::signal::Record;
use dolmen_linalg::Complex64;
use std::error::Error;
use std::f64::consts::PI;

/// The listing names estimates further off than this many stated deviations: one in 16 000 by chance.
const OFF_MOST: f64 = 4.0;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let [case, first, last, ref wishes @ ..] = words[..] else {
        return Err(
            "modal_cases chain|pairs|twisting|tower FIRST_SEED LAST_SEED [METHOD] [KEY=NUMBER …]".into(),
        );
    };
    let case = match case {
        "chain" => ReferenceCase::ShearChain,
        "pairs" => ReferenceCase::ClosePairs,
        "twisting" => ReferenceCase::Twisting,
        "tower" => ReferenceCase::Tower,
        _ => return Err("the case must be chain, pairs, twisting or tower".into()),
    };
    let mut options = Identify::default();
    let mut tones = false;
    for wish in wishes {
        match wish.split_once('=') {
            Some(("block_rows", rows)) => options.block_rows = Some(rows.parse()?),
            Some(("decimation", factor)) => options.decimation = Some(factor.parse()?),
            Some(("order_most", order)) => options.order_most = Some(order.parse()?),
            Some((key, _)) => return Err(format!("{key} is not block_rows, decimation or order_most").into()),
            None if *wish == "tones" => tones = true,
            None => options.method = Method::named(wish).ok_or("there is no such method")?,
        }
    }
    let truth = case.made(0)?;
    let mut found: Vec<Vec<Mode>> = vec![Vec::new(); truth.modes.len()];
    let (mut missed, mut false_ones) = (0, 0);
    for seed in first.parse::<u64>()?..=last.parse()? {
        let mut record = case.made(seed)?.make()?;
        if tones {
            record = with_machines(&record)?;
        }
        let analysis = identify(&record, &options)?;
        if seed == first.parse()? {
            println!("{:?}", analysis.settings);
        }
        if tones {
            analysis
                .notes
                .iter()
                .for_each(|note| println!("seed {seed}: {note}"));
        }
        let mut modes = analysis.modes.modes;
        for (truth, found) in truth.modes.iter().zip(&mut found) {
            match nearest(truth, &modes) {
                Some(at) => {
                    let mode = modes.remove(at);
                    let sd_hz = mode.frequency_sd_hz.unwrap_or(f64::INFINITY);
                    let off = (mode.frequency_hz - truth.frequency_hz) / sd_hz;
                    if off.abs() > OFF_MOST {
                        println!(
                            "seed {seed}: mode at {:.4} Hz off by {off:.1} deviations",
                            truth.frequency_hz
                        );
                    }
                    found.push(mode);
                }
                None => {
                    missed += 1;
                    println!("seed {seed}: no mode at {:.4} Hz", truth.frequency_hz);
                }
            }
        }
        for mode in &modes {
            false_ones += 1;
            println!("seed {seed}: false mode at {:.4} Hz", mode.frequency_hz);
        }
    }
    println!("  f (Hz)    bias f (%)         bias ζ (%)   scatter/floor f, ζ   stated/true f, ζ");
    let rows: Vec<Row> = truth
        .modes
        .iter()
        .zip(&found)
        .filter(|(_, found)| found.len() > 1)
        .map(|(mode, found)| Row::of(mode, found, truth.duration_s))
        .collect();
    rows.iter().for_each(Row::print);
    let square = |of: &dyn Fn(&Row) -> f64| {
        (rows.iter().map(|r| of(r).powi(2)).sum::<f64>() / rows.len() as f64).sqrt()
    };
    println!(
        "root mean square over modes: bias f {:.3} %, ζ {:.1} %; scatter/floor {:.2}  {:.2}; stated/true {:.2}  {:.2}",
        square(&|r| r.bias[0]),
        square(&|r| r.bias[1]),
        square(&|r| r.over_floor[0]),
        square(&|r| r.over_floor[1]),
        square(&|r| r.stated[0]),
        square(&|r| r.stated[1]),
    );
    println!("missed {missed}, false {false_ones}");
    Ok(())
}

/// The record with the hum of the mains, as strong as all motion, and of an engine at 7 Hz, half as strong.
fn with_machines(record: &Record) -> Result<Record, Box<dyn Error>> {
    let rate_hz = record.sampling_rate_hz();
    let hum = |c: usize| -> Vec<f64> {
        let y = record.samples(c);
        let spread = (y.iter().map(|y| y * y).sum::<f64>() / y.len() as f64).sqrt();
        let wave = |hz: f64, t: usize| (2.0 * PI * hz * t as f64 / rate_hz + c as f64).sin();
        let at = |t: usize| spread * 2.0_f64.sqrt() * (wave(50.0, t) + 0.5 * wave(7.0, t));
        y.iter().enumerate().map(|(t, y)| y + at(t)).collect()
    };
    let samples = (0..record.channels().len()).map(hum).collect();
    Ok(Record::new(record.channels().to_vec(), samples, rate_hz)?)
}

/// Index of the mode within 2 % of the frequency whose shape is most alike, if it is alike at all.
fn nearest(truth: &MadeMode, modes: &[Mode]) -> Option<usize> {
    let shape: Vec<Complex64> = truth.shape.iter().map(|x| Complex64::new(*x, 0.0)).collect();
    let alike = |i: &usize| assurance(&shape, &modes[*i].shape);
    (0..modes.len())
        .filter(|&i| (modes[i].frequency_hz / truth.frequency_hz - 1.0).abs() < 0.02 && alike(&i) > 0.5)
        .max_by(|a, b| alike(a).total_cmp(&alike(b)))
}

/// Results of the seeds for one mode; each pair is of the frequency and of the damping ratio.
struct Row {
    frequency_hz: f64,
    /// Mean error and its standard error, %.
    bias: [f64; 2],
    error: [f64; 2],
    over_floor: [f64; 2],
    stated: [f64; 2],
}

impl Row {
    fn of(truth: &MadeMode, found: &[Mode], duration_s: f64) -> Self {
        let (f, zeta) = (truth.frequency_hz, truth.damping_ratio);
        let turns = 2.0 * PI * f * duration_s;
        let frequency = Sample::of(found, |m| m.frequency_hz / f - 1.0);
        let damping = Sample::of(found, |m| m.damping_ratio.unwrap_or(f64::NAN) / zeta - 1.0);
        let stated_f = Sample::of(found, |m| m.frequency_sd_hz.unwrap_or(f64::NAN) / f).mean;
        let stated_zeta = Sample::of(found, |m| m.damping_ratio_sd.unwrap_or(f64::NAN) / zeta).mean;
        let error = |s: &Sample| 100.0 * s.sd / s.count.sqrt();
        Row {
            frequency_hz: f,
            bias: [100.0 * frequency.mean, 100.0 * damping.mean],
            error: [error(&frequency), error(&damping)],
            over_floor: [
                frequency.sd / (zeta / turns).sqrt(),
                damping.sd * (zeta * turns).sqrt(),
            ],
            stated: [stated_f / frequency.sd, stated_zeta / damping.sd],
        }
    }

    fn print(&self) {
        println!(
            "{:8.4}    {:+.3} ± {:.3}     {:+5.1} ± {:.1}     {:.2}  {:.2}            {:.2}  {:.2}",
            self.frequency_hz,
            self.bias[0],
            self.error[0],
            self.bias[1],
            self.error[1],
            self.over_floor[0],
            self.over_floor[1],
            self.stated[0],
            self.stated[1],
        );
    }
}

struct Sample {
    count: f64,
    mean: f64,
    sd: f64,
}

impl Sample {
    fn of(modes: &[Mode], value: impl Fn(&Mode) -> f64) -> Self {
        let count = modes.len() as f64;
        let mean = modes.iter().map(&value).sum::<f64>() / count;
        let square = modes.iter().map(|m| (value(m) - mean).powi(2)).sum::<f64>();
        Sample {
            count,
            mean,
            sd: (square / (count - 1.0)).sqrt(),
        }
    }
}
