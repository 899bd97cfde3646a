//! How often unchanged histories are called changed, how often alarms come, and what share of true steps is found: the tables of docs/watch.md.
//!
//! ```text
//! cargo run --release -p dolmen --example watch_power [HISTORIES]
//! ```

#![allow(clippy::print_stdout, reason = "it writes a table")]

use dolmen::monitoring::{ChangeForm, MadeHistory, WatchOptions, made_history, watch};
use dolmen::numeric::{Random, clopper_pearson};
use rayon::prelude::*;

struct Met {
    changed: bool,
    /// Of the strongest step of the first mode near the true one: date off, surveys; size off.
    off: Option<(f64, f64)>,
    /// Confirmed alarms, and the delay of the first one after the step.
    alarms: usize,
    delay: Option<usize>,
    judged: usize,
}

fn one(of: &MadeHistory, replicates: usize) -> Met {
    let options = WatchOptions {
        replicates,
        ..WatchOptions::default()
    };
    let Ok(found) = watch(&made_history(of), &options) else {
        return Met {
            changed: false,
            off: None,
            alarms: 0,
            delay: None,
            judged: 0,
        };
    };
    let step = of.step.unwrap_or((usize::MAX, 0.0));
    let changes = found.modes.iter().flat_map(|mode| &mode.changes);
    let near = found.modes[0]
        .changes
        .iter()
        .filter(|change| change.form == ChangeForm::Step && change.from.abs_diff(step.0) <= of.surveys / 5)
        .max_by(|a, b| (a.ratio / a.sd).abs().total_cmp(&(b.ratio / b.sd).abs()));
    let after = found
        .alarms
        .iter()
        .map(|alarm| alarm.alarm.survey)
        .find(|survey| *survey >= step.0);
    Met {
        changed: changes.count() > 0,
        off: near.map(|change| (change.from as f64 - step.0 as f64, change.ratio - step.1)),
        alarms: found.alarms.len(),
        delay: after.map(|survey| survey - step.0),
        judged: found.modes[0]
            .judged
            .judged
            .iter()
            .filter(|judged| judged.score.is_ok())
            .count(),
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let histories: u64 = std::env::args().nth(1).map_or(Ok(300), |text| text.parse())?;
    println!("unchanged, three modes, correlation 0.3, {histories} histories each");
    println!("surveys  days apart  called changed (95 % interval)   alarms in judged years: each 10 years");
    for (surveys, interval_days) in [(60, 30.4), (365, 1.0), (365, 10.0)] {
        let all: Vec<Met> = (0..histories)
            .into_par_iter()
            .map(|seed| {
                one(
                    &MadeHistory {
                        surveys,
                        interval_days,
                        seed,
                        ..MadeHistory::default()
                    },
                    999,
                )
            })
            .collect();
        let changed = all.iter().filter(|met| met.changed).count();
        let interval = clopper_pearson(changed, all.len(), 0.95)?;
        let alarms: usize = all.iter().map(|met| met.alarms).sum();
        let years = all.iter().map(|met| met.judged as f64).sum::<f64>() * interval_days / 365.25;
        println!(
            "{surveys:>7}  {interval_days:>10}  {:.1} % ({:.1} to {:.1} %)   {alarms} in {years:.0}: {:.2}",
            100.0 * changed as f64 / all.len() as f64,
            100.0 * interval.lower,
            100.0 * interval.upper,
            10.0 * alarms as f64 / years
        );
    }
    println!("\nsteps of all three modes at random dates, {histories} histories each");
    println!(
        "surveys  noise  step     found  date off (median, surveys)  size off (sd)  alarm within 10 surveys  median delay"
    );
    for (surveys, interval_days) in [(60, 30.4), (365, 1.0)] {
        for noise in [0.001, 0.0012, 0.003] {
            for step in [-0.005, -0.01, -0.012, -0.015, -0.02] {
                let all: Vec<Met> = (0..histories)
                    .into_par_iter()
                    .map(|seed| {
                        let from =
                            surveys / 4 + (Random::new(seed, 7).uniform() * surveys as f64 / 2.0) as usize;
                        let of = MadeHistory {
                            surveys,
                            interval_days,
                            noise,
                            step: Some((from, step)),
                            seed: 10_000 + seed,
                            ..MadeHistory::default()
                        };
                        one(&of, 0)
                    })
                    .collect();
                let found: Vec<(f64, f64)> = all.iter().filter_map(|met| met.off).collect();
                let mut dates: Vec<f64> = found.iter().map(|(date, _)| date.abs()).collect();
                dates.sort_by(f64::total_cmp);
                let size =
                    (found.iter().map(|(_, off)| off * off).sum::<f64>() / found.len().max(1) as f64).sqrt();
                let mut delays: Vec<usize> = all.iter().filter_map(|met| met.delay).collect();
                delays.sort_unstable();
                let soon = delays.iter().filter(|delay| **delay < 10).count();
                println!(
                    "{surveys:>7}  {:.2} %  {:>5.1} %  {:>4.0} %  {:>10.0}  {:>20.2} %  {:>20.0} %  {:>15}",
                    100.0 * noise,
                    100.0 * step,
                    100.0 * found.len() as f64 / all.len() as f64,
                    dates.get(dates.len() / 2).copied().unwrap_or(f64::NAN),
                    100.0 * size,
                    100.0 * soon as f64 / all.len() as f64,
                    delays
                        .get(delays.len() / 2)
                        .map_or("–".to_owned(), ToString::to_string),
                );
            }
        }
    }
    seen(histories);
    Ok(())
}

/// How often a step halfway of the size that an unchanged history of this length states is found in the first mode, and smaller ones.
fn seen(histories: u64) {
    println!(
        "\nsteps halfway over what unchanged histories state to be seen with 80 %, {histories} histories each"
    );
    println!("surveys  stated  found at 0.5, 0.7 and 1 times that");
    let options = WatchOptions::default();
    for surveys in [15, 25, 40, 80, 200, 365] {
        let made = |seed: u64, step: Option<(usize, f64)>| {
            let of = MadeHistory {
                surveys,
                seed,
                step,
                ..MadeHistory::default()
            };
            watch(&made_history(&of), &options).ok()
        };
        let stated = (0..20).filter_map(|seed| made(900_000 + seed, None)?.modes[0].seen_from_ratio);
        let mut stated: Vec<f64> = stated.collect();
        stated.sort_by(f64::total_cmp);
        let size = stated[stated.len() / 2];
        let found = [0.5, 0.7, 1.0].map(|factor| {
            let finds = |seed: &u64| {
                let found = made(*seed, Some((surveys / 2, -size * factor)));
                found.is_some_and(|found| !found.modes[0].changes.is_empty())
            };
            100.0 * (0..histories).into_par_iter().filter(finds).count() as f64 / histories as f64
        });
        println!(
            "{surveys:>7}  {:.2} %  {:>3.0} %  {:>3.0} %  {:>3.0} %",
            100.0 * size,
            found[0],
            found[1],
            found[2]
        );
    }
}
