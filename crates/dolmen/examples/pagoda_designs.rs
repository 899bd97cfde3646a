//! The training study of the six-factor score, as a project file: `pagoda_designs > examples/pagoda_score/project.toml`.
//!
//! Designs fill the space of five independent factors evenly (an additive sequence of the plastic numbers, which has no seed);
//! those whose last storey would be thinner or wider than real ones are passed over. Our choice, and said in its README.
#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    clippy::disallowed_methods,
    reason = "a maker of a file that fails loudly"
)]

use dolmen::structure::stack::{PagodaFactors, PagodaSlenderness, pagoda};

const DESIGNS: usize = 150;
const STOREYS: [u32; 3] = [3, 5, 7];
const BODY_HEIGHT_M: [f64; 2] = [2.0, 9.0];
const BODY_SLENDERNESS: [f64; 2] = [2.5, 5.0];
const TAPER_DEG: [f64; 2] = [3.0, 10.0];
const BODY_BASE_HEIGHT_RATIO: [f64; 2] = [1.1, 4.0];
/// Width at the top of the body over that at its foot.
const TOP_WIDTH: [f64; 2] = [0.3, 0.8];
/// First seconds of each record that are kept: to 95 % of its Arias intensity and past its peak velocity, and 1 s more.
const KEEP_FIRST_S: [u32; 22] = [
    14, 12, 19, 18, 61, 16, 17, 24, 21, 22, 32, 23, 17, 12, 37, 24, 20, 21, 60, 51, 14, 9,
];

fn main() {
    println!(
        r#"# {DESIGNS} pagodas under {} measured motions, scaled until they fall: what the six-factor score was trained on. README.md says why so.
# Written by `cargo run --release -p dolmen --example pagoda_designs`; the motions come with `scripts/data --far-field`.
schema = 1
kind = "stack"
name = {{ en = "Training pagodas of the six-factor score", ko = "여섯 인자 점수의 학습용 석탑" }}
description = "A pagoda from six factors; the study varies them together."
source = "Factors: Kim, Koo and Hong (2018), Assessment factors for seismic performance of multi-block stone pagodas, Fig. 13. Designs: made up for this study"
evidence = "assumed"
density = 2600
joint = {{ friction = 0.6, normal_stiffness = 1e9, shear_stiffness = 4e8 }}
pagoda = {{ storeys = 5, body_height = 6.0, body_slenderness = 3.74, taper = "8 deg", body_base_height_ratio = 3 }}

[study.training]
title = {{ en = "Training of the six-factor score", ko = "여섯 인자 점수의 학습" }}
motions = [{}]
peak = {{ from = "0.01 g", to = "4 g", steps = 15, spacing = "logarithmic" }}
refine = 0
points = 16
vary.pagoda = ["#,
        KEEP_FIRST_S.len(),
        names()
            .map(|name| format!("\"{name}\""))
            .collect::<Vec<_>>()
            .join(", ")
    );
    // the root of x⁵ = x + 1: fractional parts of its powers fill four dimensions evenly
    let mut root = 1.2_f64;
    for _ in 0..100 {
        root = (1.0 + root).powf(0.2);
    }
    let mut made = 0;
    for n in 1_i32.. {
        let part = |axis: i32, [low, high]: [f64; 2], digits: f64| {
            let place = (0.5 + f64::from(n) * root.powi(-axis)).fract();
            ((low + place * (high - low)) * digits).round() / digits
        };
        let body_height_m = part(1, BODY_HEIGHT_M, 100.0);
        let body_slenderness = part(2, BODY_SLENDERNESS, 100.0);
        let taper_deg = part(3, TAPER_DEG, 10.0);
        let body_base_height_ratio = part(4, BODY_BASE_HEIGHT_RATIO, 100.0);
        let top_width = 1.0 - body_slenderness * taper_deg.to_radians().tan();
        if !(TOP_WIDTH[0]..=TOP_WIDTH[1]).contains(&top_width) {
            continue;
        }
        let storeys = STOREYS[made % STOREYS.len()];
        pagoda(&PagodaFactors {
            storeys,
            body_height_m,
            slenderness: PagodaSlenderness::Body(body_slenderness),
            taper_rad: taper_deg.to_radians(),
            body_base_height_ratio,
            ..PagodaFactors::default()
        })
        .unwrap();
        println!(
            "  {{ storeys = {storeys}, body_height = {body_height_m}, body_slenderness = {body_slenderness}, taper = \"{taper_deg} deg\", \
             body_base_height_ratio = {body_base_height_ratio} }},"
        );
        made += 1;
        if made == DESIGNS {
            break;
        }
    }
    println!("]\n");
    for (name, seconds) in names().zip(KEEP_FIRST_S) {
        println!("[motion.{name}]\nfiles = {{ x = \"../../data/cache/far-field/{name}.csv\" }}");
        println!("keep_first_s = {seconds}\ntaper_s = 0.5");
    }
}

/// The first components of the far-field set.
fn names() -> impl Iterator<Item = String> {
    (1..=KEEP_FIRST_S.len()).map(|record| format!("{record:02}a"))
}
