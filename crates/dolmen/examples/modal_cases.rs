//! How well `identify` does on made records whose poles are known, over many seeds.
//!
//! ```text
//! cargo run --release -p dolmen --example modal_cases -- chain|pairs|twisting FIRST_SEED LAST_SEED
//! ```
//! Prints for each mode: bias of the frequency (with its standard error) and of the damping ratio, scatter over its
//! floor (Au 2014), stated over true scatter; then modes missed and false ones.
#![allow(clippy::print_stdout, reason = "an example: its output is what it is for")]

use dolmen::modal::{Identify, MadeMode, Mode, ReferenceCase, assurance, identify};
use dolmen_linalg::Complex64;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let [case, first, last] = words[..] else {
        return Err("modal_cases chain|pairs|twisting FIRST_SEED LAST_SEED".into());
    };
    let case = match case {
        "chain" => ReferenceCase::ShearChain,
        "pairs" => ReferenceCase::ClosePairs,
        "twisting" => ReferenceCase::Twisting,
        _ => return Err("the case must be chain, pairs or twisting".into()),
    };
    let truth = case.made(0)?;
    let mut found: Vec<Vec<Mode>> = vec![Vec::new(); truth.modes.len()];
    let (mut missed, mut false_ones) = (0, 0);
    for seed in first.parse::<u64>()?..=last.parse()? {
        let mut modes = identify(&case.made(seed)?.make()?, &Identify::default())?
            .modes
            .modes;
        for (truth, found) in truth.modes.iter().zip(&mut found) {
            match nearest(truth, &modes) {
                Some(at) => found.push(modes.remove(at)),
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
    for (mode, found) in truth.modes.iter().zip(&found) {
        print_mode(mode, found, truth.duration_s);
    }
    println!("missed {missed}, false {false_ones}");
    Ok(())
}

/// Index of the mode within 2 % of the frequency whose shape is most alike, if it is alike at all.
fn nearest(truth: &MadeMode, modes: &[Mode]) -> Option<usize> {
    let shape: Vec<Complex64> = truth.shape.iter().map(|x| Complex64::new(*x, 0.0)).collect();
    let alike = |i: &usize| assurance(&shape, &modes[*i].shape);
    (0..modes.len())
        .filter(|&i| (modes[i].frequency_hz / truth.frequency_hz - 1.0).abs() < 0.02 && alike(&i) > 0.5)
        .max_by(|a, b| alike(a).total_cmp(&alike(b)))
}

fn print_mode(truth: &MadeMode, found: &[Mode], duration_s: f64) {
    let (f, zeta) = (truth.frequency_hz, truth.damping_ratio);
    let turns = 2.0 * std::f64::consts::PI * f * duration_s;
    let frequency = Sample::of(found, |m| m.frequency_hz / f - 1.0);
    let damping = Sample::of(found, |m| m.damping_ratio.unwrap_or(f64::NAN) / zeta - 1.0);
    let stated_f = Sample::of(found, |m| m.frequency_sd_hz.unwrap_or(f64::NAN) / f).mean;
    let stated_zeta = Sample::of(found, |m| m.damping_ratio_sd.unwrap_or(f64::NAN) / zeta).mean;
    println!(
        "{f:8.4}    {:+.3} ± {:.3}     {:+5.1} ± {:.1}     {:.2}  {:.2}            {:.2}  {:.2}",
        100.0 * frequency.mean,
        100.0 * frequency.sd / frequency.count.sqrt(),
        100.0 * damping.mean,
        100.0 * damping.sd / damping.count.sqrt(),
        frequency.sd / (zeta / turns).sqrt(),
        damping.sd * (zeta * turns).sqrt(),
        stated_f / frequency.sd,
        stated_zeta / damping.sd,
    );
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
