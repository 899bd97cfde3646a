//! Writes `examples/pagoda_over_the_years/project.toml`: a made pagoda of twelve years whose truth is known.
//!
//! ```text
//! cargo run --release -p dolmen --example pagoda_over_the_years > examples/pagoda_over_the_years/project.toml
//! ```

#![allow(clippy::print_stdout, reason = "it writes a project file")]

use dolmen::numeric::Random;
use std::f64::consts::TAU;

/// Frequencies at 12 °C, Hz, and shapes at four heights, of two modes along x and one along y.
const MODES: [(&str, f64, [f64; 4]); 3] = [
    ("x", 3.12, [0.18, 0.42, 0.71, 1.0]),
    ("x", 8.45, [0.55, 1.0, 0.36, -0.82]),
    ("y", 3.36, [0.17, 0.40, 0.70, 1.0]),
];
const HEIGHTS_M: [f64; 4] = [1.6, 3.1, 4.4, 5.6];
/// Relative change per °C, and relative deviation of a reading and of the disturbance.
const PER_C: f64 = -0.0009;
const READING: f64 = 0.0015;
const DISTURBANCE: f64 = 0.0012;
/// Surveys: four a year from 2014 on.
const SURVEYS: usize = 48;
const MONTHS: [u32; 4] = [2, 5, 8, 11];
/// First surveys after the repair of 2017-06, the exchange of a sensor in 2019-04, and the earthquake of 2021-09-13.
const REPAIRED: usize = 14;
const EXCHANGED: usize = 21;
const SHAKEN: usize = 31;

fn main() {
    let mut random = Random::new(2014, 0);
    println!(
        "# A pagoda measured four times a year for twelve years. MADE, not measured: written by crates/dolmen/examples/pagoda_over_the_years.rs."
    );
    println!(
        "# Truth: the repair of 2017-06 raised all frequencies by 6 %; the earthquake of 2021-09-13 lowered those along x by 2.4 %, that along"
    );
    println!(
        "# y by 1 %; from 2019-05 on the sensor along x at 4.4 m reads a third of what it should, with the wrong sign; the tilt along x grows by 0.05 mm/m a year."
    );
    println!("schema = 1\nkind = \"survey\"");
    println!(
        "name = {{ en = \"A pagoda over the years (made up)\", ko = \"여러 해 동안 계측한 석탑(가상)\" }}"
    );
    println!("source = \"Made up: see README.md\"\nevidence = \"assumed\"\n");
    println!("[watch]\ntilt_limit = \"1/200\"\nworks = [");
    println!(
        "  {{ date = \"2017-06-20\", kind = \"repair\", what = \"joints of storeys 2 and 3 repointed\" }},"
    );
    println!("  {{ date = \"2019-04-02\", kind = \"sensors\", what = \"sensor at 4.4 m replaced\" }},");
    println!(
        "  {{ date = \"2021-09-13\", kind = \"event\", what = \"earthquake, 0.08 g at the site\" }},\n]"
    );
    let mut states = [0.0; 3];
    for survey in 0..SURVEYS {
        let (year, month) = (2014 + survey / 4, MONTHS[survey % 4]);
        let season = -11.0 * (TAU * (f64::from(month) - 0.8) / 12.0).cos();
        let temperature_c = (13.0 + season + 3.0 * random.normal()).round();
        println!("\n[survey.{year}-{month:02}-{:02}]", 5 + (7 * survey) % 19);
        println!("temperature_c = {temperature_c}\ndatum = \"mark 1 of 2014\"");
        let tilt = 3.2 + 0.05 * survey as f64 / 4.0 + 0.03 * season / 11.0 + 0.06 * random.normal();
        println!("tilt.x = \"{tilt:.2} mm/m\"");
        let mut direction = "";
        for (i, (along, frequency_hz, shape)) in MODES.iter().enumerate() {
            let rho = 0.3;
            let fresh = f64::sqrt(1.0 - rho * rho) * DISTURBANCE * random.normal();
            states[i] = rho * states[i] + fresh;
            let repair = if survey >= REPAIRED { 0.06 } else { 0.0 };
            let shaken = if *along == "x" { -0.024 } else { -0.01 };
            let shaken = if survey >= SHAKEN { shaken } else { 0.0 };
            let off = PER_C * (temperature_c - 12.0) + states[i] + READING * random.normal();
            let found_hz = frequency_hz * (1.0 + repair) * (1.0 + shaken) * (1.0 + off);
            if direction != *along {
                if !direction.is_empty() {
                    println!("]");
                }
                println!("modes.{along} = [");
                direction = along;
            }
            // the second mode is not always found
            if i == 1 && random.uniform() < 0.2 {
                continue;
            }
            let points: Vec<String> = HEIGHTS_M
                .iter()
                .zip(shape)
                .enumerate()
                .map(|(place, (height, value))| {
                    let is_wrong = survey >= EXCHANGED && *along == "x" && place == 2;
                    let gain = if is_wrong { -0.33 } else { 1.0 };
                    let value = gain * value + 0.02 * random.normal();
                    format!("{{ height = {height}, displacement = {value:.3} }}")
                })
                .collect();
            println!(
                "  {{ frequency = {{ value = {found_hz:.4}, sd = {:.4} }}, shape = [{}] }},",
                READING * found_hz,
                points.join(", ")
            );
        }
        println!("]");
    }
}
