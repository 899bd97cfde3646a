//! SOURCE: ranges of dimensions of Korean stone and timber heritage and of buildings, each drawn uniformly, or uniformly in its logarithm,
//! from a seeded generator. GOAL: plausible structures are accepted: of 1,000 of each kind at most 5 are refused or doubted, when read or
//! when checked. RANGES: flagpoles of 3 to 7 stone links, 4 to 16 m high, sides of 1/30 to 1/12 of the height, tapering to 0.4 to 0.9,
//! joints of 0.3 to 100 times weight × height; gates of 1 to 3 storeys of 20 to 500 t and 2.5 to 9 m, swaying at 0.7 to 4 Hz; pagodas of 3
//! to 7 storeys, 2 to 12 m, stones of 1,900 to 2,900 kg/m³, friction 0.4 to 0.8, beds of 1e8 to 1e11 Pa/m; buildings of 1 to 25 floors of 6
//! to 60 m and 0.4 to 2 t/m² that sway at 20 to 90 Hz over their height in m; damping 0.5 to 10 %. Only one threshold was changed after the
//! first draw: load factors above 500 were doubted in 28 of 1,000 gates and 9 of 100 buildings. The bound is now 2,000, above all drawn
//! gates, and buildings are judged only by their lowest frequency.

use dolmen_project::{NoFiles, WarningKind};
use dolmen_words::Language;
use dolmen_work::{CheckOptions, Opened, check, told};
use std::fmt::Write as _;

/// Differs from the seed of the draws that set the bound on load factors.
const SEED: u64 = 20_261_127;
const DRAWN: usize = 1000;
/// Of 1,000: half a per cent.
const ALARMS_MOST: usize = 5;

/// Knuth's MMIX sequence.
struct Draw(u64);

impl Draw {
    fn share(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn even(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * self.share()
    }

    fn log(&mut self, least: f64, most: f64) -> f64 {
        least * (most / least).powf(self.share())
    }

    fn count(&mut self, least: usize, most: usize) -> usize {
        least + (self.share() * (most - least + 1) as f64) as usize
    }
}

fn head(kind: &str) -> String {
    format!("schema = 1\nkind = \"{kind}\"\nname = \"drawn\"\n")
}

fn flagpole(draw: &mut Draw) -> String {
    let (count, height_m) = (draw.count(3, 7), draw.even(4.0, 16.0));
    let (side_m, top, density) = (
        height_m / draw.log(12.0, 30.0),
        draw.even(0.4, 0.9),
        draw.even(2300.0, 2800.0),
    );
    let shares: Vec<f64> = (0..count).map(|_| draw.even(0.6, 1.4)).collect();
    let lengths: Vec<f64> = shares
        .iter()
        .map(|share| height_m * share / shares.iter().sum::<f64>())
        .collect();
    let mut text =
        head("chain") + "units = { mass = \"kg\", stiffness = \"kN*m/rad\" }\ncap = \"included\"\n";
    let _ = writeln!(text, "damping_ratio = {:.4}\nlinks = [", draw.log(0.005, 0.1));
    let mut masses = Vec::new();
    for (i, length_m) in lengths.iter().enumerate() {
        let own_m = side_m * (1.0 - (1.0 - top) * i as f64 / count as f64);
        masses.push(density * own_m * own_m * length_m * draw.even(0.8, 1.1));
        let centroid_m = length_m * draw.even(0.43, 0.51);
        let bed_m = own_m * draw.even(0.7, 1.1);
        let _ = writeln!(
            text,
            "  {{ mass = {:.1}, length = {length_m:.3}, centroid = {centroid_m:.3}, bed_width = {bed_m:.3} }},",
            masses[i]
        );
    }
    text += "]\njoints = [\n";
    let stiffer = draw.log(0.3, 100.0);
    for i in 0..count {
        let product = 9.81 * masses[i..].iter().sum::<f64>() * lengths[i..].iter().sum::<f64>();
        let _ = writeln!(
            text,
            "  {{ stiffness = {:.4} }},",
            1e-3 * product * stiffer * draw.log(0.4, 2.5)
        );
    }
    text + "]\n"
}

fn gate(draw: &mut Draw) -> String {
    let (count, ground_t) = (draw.count(1, 3), draw.log(20.0, 500.0));
    let masses: Vec<f64> = (0..count)
        .map(|i| ground_t * draw.even(0.7, 1.2) * 0.9_f64.powi(i as i32))
        .collect();
    let mut text = head("frame")
        + "units = { mass = \"t\", force = \"kN\", stiffness = \"kN/mm\" }\naxial = \"storey\"\nstoreys = [\n";
    for i in 0..count {
        let force = 9.81 * masses[i..].iter().sum::<f64>() * draw.even(0.98, 1.02);
        let _ = writeln!(
            text,
            "  {{ mass = {:.2}, height = {:.2}, axial_force = {force:.1} }},",
            masses[i],
            draw.even(2.5, 9.0)
        );
    }
    text += "]\n";
    for direction in ["weak", "strong"] {
        let hz = draw.log(0.7, 4.0) * 1.6; // for a storey alone: lower with others above
        let stiffness: Vec<String> = (0..count)
            .map(|i| {
                let above: f64 = masses[i..].iter().sum();
                format!(
                    "{:.4}",
                    1e-3 * above * (std::f64::consts::TAU * hz).powi(2) * draw.even(0.8, 1.25)
                )
            })
            .collect();
        let damping = draw.log(0.01, 0.1);
        let _ = writeln!(
            text,
            "[direction.{direction}]\nstiffness = [{}]\ndamping_ratio = {damping:.4}",
            stiffness.join(", ")
        );
    }
    text
}

fn pagoda(draw: &mut Draw) -> String {
    let (storeys, height_m) = (draw.count(3, 7), draw.log(2.0, 12.0));
    let base_m = height_m * draw.even(0.35, 0.6);
    let normal = draw.log(1e8, 1e11);
    let mut text = head("stack");
    let _ = writeln!(
        text,
        "density = {:.0}\njoint = {{ friction = {:.3}, normal_stiffness = \"{normal:.4e} Pa/m\", shear_stiffness = \"{:.4e} Pa/m\", damping_ratio = {:.2} }}\nblocks = [",
        draw.even(1900.0, 2900.0),
        draw.even(0.4, 0.8),
        normal * draw.even(0.3, 0.9),
        draw.even(0.05, 0.5)
    );
    let mut block = |width: f64, height: f64| {
        let _ = writeln!(
            text,
            "  {{ name = \"s{}\", width = {width:.3}, height = {height:.3} }},",
            text.lines().count()
        );
    };
    block(base_m * draw.even(1.0, 1.3), 0.1 * height_m * draw.even(0.7, 1.3));
    block(
        base_m * draw.even(0.8, 1.0),
        0.08 * height_m * draw.even(0.7, 1.3),
    );
    let narrows = draw.even(0.8, 0.97);
    let (mut body_m, eaves) = (base_m * draw.even(0.45, 0.7), draw.even(1.3, 1.8));
    for _ in 0..storeys {
        block(
            body_m * draw.even(0.97, 1.03),
            0.5 * height_m / storeys as f64 * draw.even(0.6, 1.4),
        );
        block(
            body_m * eaves,
            0.3 * height_m / storeys as f64 * draw.even(0.7, 1.3),
        );
        body_m *= narrows;
    }
    block(body_m * draw.even(0.3, 0.6), 0.05 * height_m);
    text + "]\n"
}

fn building(draw: &mut Draw) -> String {
    let floors = draw.count(1, 25);
    let (a, b, storey_m) = (draw.log(6.0, 60.0), draw.log(6.0, 60.0), draw.even(2.6, 5.0));
    let mass_t = a * b * draw.log(0.4, 2.0);
    let hz = draw.log(20.0, 90.0) / (storey_m * floors as f64);
    let mut text = head("building") + "units = { mass = \"t\", stiffness = \"kN/mm\" }\nfloors = [\n";
    let radius2 = (a * a + b * b) / 12.0;
    for i in 0..floors {
        // ω² of a chain of equal floors whose storeys soften upwards as the masses that they carry: about k m π²/4 / n² at the bottom
        let softer = 1.0 - 0.5 * (i as f64 / floors as f64).powi(2);
        let n = floors as f64 + 0.5;
        let k =
            1e-3 * mass_t * (std::f64::consts::TAU * hz * n * 2.0 / std::f64::consts::PI).powi(2) * softer;
        let y = draw.even(0.7, 1.4);
        let _ = writeln!(
            text,
            "  {{ mass = {:.2}, sides = [{a:.2}, {b:.2}], height = {storey_m:.2}, stiffness = {{ x = {k:.5}, y = {:.5}, rotation = \"{:.4e} kN*m/rad\", centre = [{:.2}, {:.2}] }} }},",
            mass_t * draw.even(0.9, 1.1),
            k * y,
            1e3 * k * radius2 * draw.even(0.8, 2.5),
            0.1 * a * draw.even(-1.0, 1.0),
            0.1 * b * draw.even(-1.0, 1.0)
        );
    }
    let _ = writeln!(text, "]\ndamping = {{ ratio = {:.4} }}", draw.log(0.005, 0.1));
    text
}

/// What Dolmen reports about a drawn file and its check; it should report nothing.
fn alarm(text: &str) -> Option<String> {
    let opened = match Opened::read(text.to_owned(), "drawn.toml".to_owned(), &NoFiles) {
        Ok(opened) => opened,
        Err(why) => return Some(told(&why)),
    };
    let mut warnings = opened.project.warnings.iter();
    if let Some(doubt) = warnings.find(|warning| warning.kind == WarningKind::Doubtful) {
        return Some(doubt.message.text(Language::English));
    }
    match check(&opened, &CheckOptions::default()) {
        Ok(answer) => {
            let factor = answer.state?.unusual_load_factor()?;
            Some(format!("load factor {factor}"))
        }
        Err(why) => Some(told(&why)),
    }
}

fn alarms(kind: fn(&mut Draw) -> String) -> Vec<String> {
    let mut draw = Draw(SEED);
    (0..DRAWN).filter_map(|_| alarm(&kind(&mut draw))).collect()
}

fn lets_pass(kind: fn(&mut Draw) -> String) {
    let alarms = alarms(kind);
    assert!(
        alarms.len() <= ALARMS_MOST,
        "{} of {DRAWN}:\n{}",
        alarms.len(),
        alarms[..8.min(alarms.len())].join("\n")
    );
}

#[test]
fn holds_plausible_flagpoles_pass() {
    lets_pass(flagpole);
}

#[test]
fn holds_plausible_gates_pass() {
    lets_pass(gate);
}

#[test]
fn holds_plausible_pagodas_pass() {
    lets_pass(pagoda);
}

#[test]
fn holds_plausible_buildings_pass() {
    lets_pass(building);
}
