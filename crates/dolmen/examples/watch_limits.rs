//! Writes `src/monitoring/table.rs`: how strong the strongest change of a series without change is.
//!
//! ```text
//! cargo run --release -p dolmen --example watch_limits > table.rs
//! ```

#![allow(clippy::print_stdout, reason = "it writes a table")]

use dolmen::monitoring::{NullSeries, null_statistics};
use dolmen::numeric::quantile;
use rayon::prelude::*;

const PROBABILITIES: [f64; 7] = [0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.002];
const SURVEYS: [usize; 9] = [8, 10, 14, 20, 30, 60, 120, 365, 1000];
const CORRELATIONS: [f64; 5] = [0.0, 0.3, 0.6, 0.8, 0.95];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!(
        "//! Quantiles of the strongest change of a series without change, written by `examples/watch_limits.rs`.\n"
    );
    println!(
        "pub(super) const PROBABILITIES: [f64; {}] = {PROBABILITIES:?};",
        PROBABILITIES.len()
    );
    println!(
        "pub(super) const SURVEYS: [u32; {}] = {SURVEYS:?};",
        SURVEYS.len()
    );
    println!(
        "pub(super) const CORRELATIONS: [f64; {}] = {CORRELATIONS:?};",
        CORRELATIONS.len()
    );
    println!("/// By surveys, correlation, probability.\n#[rustfmt::skip]");
    println!(
        "pub(super) const QUANTILES: [[[f64; {}]; {}]; {}] = [",
        PROBABILITIES.len(),
        CORRELATIONS.len(),
        SURVEYS.len()
    );
    for surveys in SURVEYS {
        // enough for the 0.2 % quantile; long series need fewer, as their limits hardly scatter
        let replicates = (1_000_000 / surveys).clamp(2_000, 20_000);
        let rows: Vec<Vec<f64>> = CORRELATIONS
            .par_iter()
            .map(|correlation| {
                let of = NullSeries {
                    surveys,
                    correlation: *correlation,
                    replicates,
                    seed: 20_260_101,
                };
                let all = null_statistics(&of);
                PROBABILITIES
                    .iter()
                    .map(|p| quantile(&all, 1.0 - p).unwrap_or(f64::NAN))
                    .collect()
            })
            .collect();
        println!("    [ // {surveys} surveys, {replicates} series");
        for row in rows {
            let row: Vec<String> = row.iter().map(|q| format!("{q:.3}")).collect();
            println!("        [{}],", row.join(", "));
        }
        println!("    ],");
    }
    println!("];");
    Ok(())
}
