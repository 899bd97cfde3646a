// SOURCE     Closed forms of falling by own weight: k/(W z) of one link, k/P·h of a storey, friction against tan of the lean. A likelihood of our own.
// GOAL       A sample that falls under its own weight has a capacity of 0 in every kind of study, and the curve begins at the share of
//            such samples.
// PARAMETERS 40, 30 and 20 samples of one uncertain input.
// PUBLISHED  none: the share, θ and β from a separate maximisation over the likelihood of all scans, (p₀, θ, β) together.
// TOLERANCE  1e-4 of θ and β: the search stops at 1e-9 of the logarithm; counts exactly.

use super::studies::rows;
use super::verbs::{Answer, Scratch};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;

const CHAIN: &str = r#"
schema = 1
kind = "chain"
name = { en = "Pole of uncertain foot" }
units = { length = "m", force = "kN", stiffness = "kN*m/rad" }
evidence = "measured"
links = [ { weight = { value = 30, cov = 0.1 }, length = 3, centroid = 1.5, breadth = 0.6, bed_width = 0.6 } ]
joints = [ { stiffness = { value = 70, cov = 0.35 } } ]
damping_ratio = 0.03
[site]
code = "KDS 17 10 00"
zone = "I"
return_period_years = 1000
soil = "S2"
[study.samples]
samples = 40
motions = ["el-centro"]
artificial = { count = 3, duration_s = 10 }
peak = { from = "0.05 g", to = "0.6 g", steps = 6, spacing = "logarithmic" }
[motion.el-centro]
built_in = "el-centro-1940-ns"
"#;

const FRAME: &str = r#"
schema = 1
kind = "frame"
name = { en = "Gate of uncertain stiffness" }
units = { length = "m", force = "kN", mass = "t", stiffness = "kN/mm" }
evidence = "measured"
axial = "storey"
storeys = [ { mass = 60, height = 4.0, axial_force = 600 } ]
direction.x.stiffness = [ { value = 0.25, cov = 0.4 } ]
direction.x.damping_ratio = 0.03
[study.samples]
samples = 30
artificial = { count = 3, duration_s = 10 }
peak = { from = "0.05 g", to = "0.6 g", steps = 4, spacing = "logarithmic" }
"#;

const BUILDING: &str = r#"
schema = 1
kind = "building"
name = { en = "Hall of uncertain stiffness" }
evidence = "measured"
units = { length = "m", mass = "t", stiffness = "kN/mm" }
floors = [ { mass = 60, sides = [8, 6], height = 4.0, stiffness = { x = { value = 0.25, cov = 0.4 }, y = 3, rotation = "40 MN*m/rad", centre = [0, 0] } } ]
damping.ratio = 0.03
[study.samples]
samples = 30
artificial = { count = 3, duration_s = 10 }
peak = { from = "0.05 g", to = "0.6 g", steps = 4, spacing = "logarithmic" }
"#;

const STACK: &str = r#"
schema = 1
kind = "stack"
name = { en = "Leaning pillar of uncertain friction" }
evidence = "measured"
density = 2650
joint = { friction = { value = 0.15, cov = 0.5 }, normal_stiffness = "1e9 Pa/m", shear_stiffness = "4e8 Pa/m", damping_ratio = 0.3 }
blocks = [ { name = "base", width = 1.0, height = 0.4 }, { name = "pillar", width = 0.4, height = 1.2 } ]
[survey.2025-01-01]
tilt.x = "1/14"
[study.samples]
samples = 20
artificial = { count = 3, duration_s = 5 }
peak = { from = "0.1 g", to = "0.6 g", steps = 3, spacing = "logarithmic" }
"#;

type Row = BTreeMap<String, String>;

fn number(row: &Row, key: &str) -> f64 {
    let text = row.get(key).unwrap_or_else(|| panic!("{key} is no column"));
    text.parse().unwrap_or(f64::NAN)
}

/// Result of a project's study: its answer, its scans and its curves.
struct Studied {
    scratch: Scratch,
    answer: Answer,
    scans: Vec<Row>,
    curves: Vec<Row>,
}

fn studied(name: &str, project: &str) -> Studied {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), project).unwrap();
    let answer = scratch.dolmen("study . --study samples -o out");
    let of = |file: &str| rows(&scratch.path().join("out/samples").join(file));
    let (scans, curves) = (of("capacities.csv"), of("fragility.csv"));
    Studied {
        scratch,
        answer,
        scans,
        curves,
    }
}

/// Samples that fall by themselves by a rule, and those that the study reports.
fn alone(of: &Studied, falls: impl Fn(&Row) -> bool) -> [BTreeSet<String>; 2] {
    let samples = |of_it: &dyn Fn(&&Row) -> bool, scans: &[Row]| -> BTreeSet<String> {
        let own = scans.iter().filter(of_it);
        own.map(|row| row["sample"].clone()).collect()
    };
    [
        samples(&|row| falls(row), &of.scans),
        samples(&|row| row["verdict"] == "fell by itself", &of.scans),
    ]
}

/// A drawn column, wherever its part is in the project.
fn drawn(row: &Row, part: &str) -> f64 {
    let found = row
        .iter()
        .find(|(key, _)| key.starts_with("drawn_") && key.contains(part));
    let (_, text) = found.unwrap_or_else(|| panic!("nothing drawn of {part}: {row:?}"));
    text.parse().unwrap()
}

/// Φ(z) by its series, Marsaglia (2004) J. Stat. Softw. 11(4): to the last digits for |z| < 7.
fn normal(z: f64) -> f64 {
    if z.abs() > 7.0 {
        return if z > 0.0 { 1.0 } else { 0.0 };
    }
    let (mut term, mut sum, mut odd) = (z, z, 1.0);
    while term.abs() > 1e-18 {
        odd += 2.0;
        term *= z * z / odd;
        sum += term;
    }
    0.5 + sum * (-0.5 * z * z).exp() / std::f64::consts::TAU.sqrt()
}

/// ln of the likelihood of all scans: those that fall by themselves, and for the others the interval of their capacity.
fn likelihood(scans: &[Row], share: f64, ln_theta: f64, ln_beta: f64) -> f64 {
    let below = |x: f64| match x {
        x if x <= 0.0 => 0.0,
        x => normal((x.ln() - ln_theta) / ln_beta.exp()),
    };
    let of = |row: &Row| match row["verdict"].as_str() {
        "fell by itself" => share.ln(),
        "fell" => {
            let [low, high] = ["survived_below_m_s2", "first_fall_m_s2"].map(|key| number(row, key));
            ((1.0 - share) * (below(high) - below(low)).max(1e-300)).ln()
        }
        "beyond" => ((1.0 - share) * (1.0 - below(number(row, "largest_tried_m_s2"))).max(1e-300)).ln(),
        other => panic!("{other}: {row:?}"),
    };
    scans.iter().map(of).sum()
}

/// The maximum of a function of one variable, by golden section.
fn largest(mut from: f64, mut to: f64, of: impl Fn(f64) -> f64) -> f64 {
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    while to - from > 1e-11 {
        let (a, b) = (to - golden * (to - from), from + golden * (to - from));
        if of(a) > of(b) {
            to = b;
        } else {
            from = a;
        }
    }
    0.5 * (from + to)
}

#[test]
fn agrees_a_chain_that_may_fall_by_itself_with_the_likelihood_of_all_scans() {
    let study = studied("fallen_chain", CHAIN);
    let words = study.answer.words();
    assert_eq!(study.answer.status, 0, "{words}{}", study.answer.stderr);
    // W z = 30 · 1.5
    let [right, said] = alone(&study, |row| {
        drawn(row, "stiffness") <= drawn(row, "weight") * 1.5
    });
    assert_eq!(said, right);
    assert!((2..20).contains(&right.len()), "{right:?}");
    // one coordinate at a time, until none moves: the likelihood of interval-censored capacities is concave
    let (mut share, mut ln_theta, mut ln_beta) = (0.5, 0.0, -0.5);
    for _ in 0..300 {
        share = largest(1e-6, 1.0 - 1e-6, |p| {
            likelihood(&study.scans, p, ln_theta, ln_beta)
        });
        ln_theta = largest(-6.0, 4.0, |t| likelihood(&study.scans, share, t, ln_beta));
        ln_beta = largest(-3.0, 2.0, |b| likelihood(&study.scans, share, ln_theta, b));
    }
    let falls = study.curves.iter().find(|row| row["state"] == "falls").unwrap();
    let [p0, theta, beta] =
        ["probability_without_shaking", "theta_pga_m_s2", "beta_pga"].map(|key| number(falls, key));
    assert!((p0 - share).abs() < 1e-6, "{p0} {share}");
    assert!((p0 - right.len() as f64 / 40.0).abs() < 1e-12);
    assert!(
        (theta / ln_theta.exp() - 1.0).abs() < 1e-4,
        "{theta} {}",
        ln_theta.exp()
    );
    assert!(
        (beta / ln_beta.exp() - 1.0).abs() < 1e-4,
        "{beta} {}",
        ln_beta.exp()
    );
    // the curve never lies below the share, so the total rate is not finite
    assert_eq!(falls["annual_rate"], "");
    let (standing, in_50) = (
        number(falls, "annual_rate_of_standing"),
        number(falls, "probability_in_50_years"),
    );
    assert!((in_50 - (p0 + (1.0 - p0) * -(-50.0 * standing).exp_m1())).abs() < 1e-12);
    for part in [
        "fall under their own weight, without any shaking",
        "The fragility of “falls” begins at",
        "no annual rate is finite",
    ] {
        assert!(words.contains(part), "{part}: {words}");
    }
    let folder = study.scratch.path().join("out/samples");
    assert!(!folder.join("fragility_PGA.xml").exists());
    let json: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(folder.join("study.json")).unwrap()).unwrap();
    let states = json["fragility"][0]["states"].as_array().unwrap();
    let falls = states.iter().find(|state| state["state"] == "falls").unwrap();
    assert_eq!(falls["scans_fell_by_themselves"], 4 * right.len());
    assert_eq!(falls["probability_without_shaking"].as_f64(), Some(p0));
    // the same in the short answer, and in Korean
    let brief = study
        .scratch
        .briefly("study . --study samples -o out --language ko");
    assert!(
        brief.words().contains("지진 없이 자중으로 붕괴한다"),
        "{}",
        brief.stdout
    );
}

#[test]
fn agrees_a_ranking_counts_what_falls_by_itself() {
    let study = studied("fallen_ranked", CHAIN);
    let table = "name,zone_factor_g,soil,project,study\npole,0.11,S2,.,samples\n";
    fs::write(study.scratch.path().join("portfolio.csv"), table).unwrap();
    fs::create_dir_all(study.scratch.path().join("studies")).unwrap();
    let again = study.scratch.dolmen("study . --study samples");
    assert_eq!(again.status, 0, "{}", again.stderr);
    let ranked = study
        .scratch
        .briefly("rank portfolio.csv --state falls -o ranked");
    assert_eq!(ranked.status, 0, "{}{}", ranked.stdout, ranked.stderr);
    assert!(
        ranked.words().contains("fall under their own weight"),
        "{}",
        ranked.stdout
    );
    let json: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(study.scratch.path().join("ranked/ranking.json")).unwrap())
            .unwrap();
    let own = &json["structures"][0];
    let p0 = own["states"]["falls"]["falls_by_itself"].as_f64().unwrap();
    let falls = study.curves.iter().find(|row| row["state"] == "falls").unwrap();
    assert_eq!(p0, number(falls, "probability_without_shaking"));
    assert!(own["probability_in_50_years"].as_f64().unwrap() > p0);
}

#[test]
fn exact_which_samples_fall_by_themselves_in_frames_buildings_and_stacks() {
    let g = 9.80665;
    let frame = studied("fallen_frame", FRAME);
    // k h = P
    let [right, said] = alone(&frame, |row| drawn(row, "stiffness") * 4.0 <= 600e3);
    assert_eq!(said, right);
    assert!(
        !right.is_empty() && frame.answer.status == 0,
        "{}",
        frame.answer.stdout
    );
    let building = studied("fallen_building", BUILDING);
    let [right, said] = alone(&building, |row| drawn(row, "stiffness") * 4.0 <= 60e3 * g);
    assert_eq!(said, right);
    assert!(
        !right.is_empty() && building.answer.status == 0,
        "{}",
        building.answer.stdout
    );
    let stack = studied("fallen_stack", STACK);
    let [right, said] = alone(&stack, |row| drawn(row, "friction") < 1.0 / 14.0);
    assert_eq!(said, right);
    assert!(
        !right.is_empty() && stack.answer.status == 0,
        "{}",
        stack.answer.stdout
    );
    // the last state of each: samples that fall by themselves reached it
    for of in [&frame, &building, &stack] {
        let last = of.curves.last().unwrap();
        assert!(number(last, "fell_by_itself") > 0.0, "{last:?}");
        assert!(number(last, "reached") >= number(last, "fell_by_itself"));
    }
    // samples that fell at the end of the halving have only an upper bound of the capacity
    let words = frame.answer.words();
    assert!(!words.contains("the weakest at 0.00"), "{words}");
}

const LEANING: &str = r#"
schema = 1
kind = "frame"
name = { en = "Gate that leans" }
units = { length = "m", mass = "t", stiffness = "kN/mm" }
evidence = "measured"
storeys = [ { mass = 30, height = 4 } ]
direction.x.stiffness = [ { value = 0.11, cov = 0.3 } ]
direction.x.damping_ratio = 0.05
[limits]
storey_drift = "3 %"
[survey.2024-03-01]
tilt = { x = "1/100" }
[study.samples]
samples = 40
artificial = { count = 4, duration_s = 8, seed = 3 }
peak = { from = "0.02 g", to = "0.6 g", steps = 6, spacing = "logarithmic" }
"#;

/// The lean of one storey at rest is that of the survey, times λ/(λ − 1).
#[test]
fn exact_which_samples_lean_beyond_the_allowed_drift_at_rest() {
    let study = studied("leaning_beyond", LEANING);
    let (mut at_rest, mut fallen, mut within) = (0, 0, Vec::new());
    for row in &study.scans {
        let factor = drawn(row, "stiffness") * 4.0 / (30e3 * 9.80665);
        let lean = 0.01 * factor / (factor - 1.0);
        let first = row["first_beyond_allowed_drift_m_s2"].parse::<f64>().ok();
        let is_at_rest = factor <= 1.0 || lean > 0.03;
        assert_eq!(first == Some(0.0), is_at_rest, "{factor} {lean} {row:?}");
        at_rest += usize::from(is_at_rest);
        fallen += usize::from(factor <= 1.0 || lean > 0.1);
        if !is_at_rest {
            within.push(first);
        }
    }
    let own = study.curves.last().unwrap();
    assert_eq!(own["state"], "allowed drift");
    let scans = at_rest + within.len();
    assert_eq!(number(own, "scans"), scans as f64);
    assert_eq!(number(own, "fell_by_itself"), fallen as f64);
    assert_eq!(number(own, "leans_beyond_at_rest"), (at_rest - fallen) as f64);
    let p0 = at_rest as f64 / scans as f64;
    assert!((number(own, "probability_without_shaking") - p0).abs() < 1e-12);
    // the curve is that of the others: its median lies between their smallest and largest capacity
    let seen: Vec<f64> = within.into_iter().flatten().collect();
    let theta = number(own, "theta_pga_m_s2");
    assert!(
        at_rest > fallen && fallen > 0 && !seen.is_empty(),
        "{at_rest} {fallen}"
    );
    let least = seen.iter().copied().fold(f64::INFINITY, f64::min);
    assert!(
        theta >= 0.5 * least && theta < seen.iter().copied().fold(0.0, f64::max),
        "{theta} {seen:?}"
    );
    let words = study.answer.words();
    let said = format!("{at_rest} of {scans} scans are beyond the allowable 3.00 % of a storey");
    assert!(words.contains(&said), "{said}: {words}");
}

/// A structure without scatter that leans beyond the drift from the start; and the ranking of a study with an allowed drift.
#[test]
fn exact_a_lean_at_rest_beyond_the_allowed_drift_needs_no_shaking() {
    let file = LEANING
        .replace("{ value = 0.11, cov = 0.3 }", "0.2")
        .replace("1/100", "1/50")
        .replace("samples = 40\n", "");
    let study = studied("leaning_one", &file);
    let words = study.answer.words();
    // λ = 2.719: 2 % × 2.719/1.719
    assert!(
        words.contains("4 of 4 scans lean beyond the allowable 3.00 %") && words.contains("by up to 3.16 %"),
        "{words}"
    );
    assert!(!words.contains("drifted beyond"), "{words}");
    fs::create_dir_all(study.scratch.path().join("all/gate")).unwrap();
    fs::write(study.scratch.path().join("all/gate/project.toml"), &file).unwrap();
    let again = study.scratch.dolmen("study all/gate --study samples");
    assert_eq!(again.status, 0, "{}", again.stderr);
    let table = "name,zone_factor_g,soil,project,study\ngate,0.11,S2,all/gate,samples\n";
    fs::write(study.scratch.path().join("portfolio.csv"), table).unwrap();
    let ranked = study.scratch.dolmen("rank portfolio.csv --state falls");
    assert_eq!(ranked.status, 0, "{}{}", ranked.stdout, ranked.stderr);
}

/// The limits that a study sets or that its variant has are those that it compares with.
#[test]
fn holds_a_study_compares_with_its_own_limits() {
    let file = LEANING.replace("{ value = 0.11, cov = 0.3 }", "2.2").replace(
        "samples = 40\n",
        "set = { \"limits.storey_drift\" = \"0.5 %\" }\n",
    );
    let study = studied("own_limits", &file);
    let words = study.answer.words();
    assert!(words.contains("the allowable 0.500 %"), "{words}");
    let both = file.replace(
        "set = { \"limits.storey_drift\" = \"0.5 %\" }",
        "vary = { \"limits.storey_drift\" = [\"0.5 %\", \"3 %\"] }",
    );
    let study = studied("two_limits", &both);
    let words = study.answer.words();
    assert!(
        words.contains("the allowable drift of [limits] differs between the combinations"),
        "{words}"
    );
}

/// A map starts from the lean of the survey: its largest drift is that of a plumb frame and the drift at rest, h τ/(λ − 1).
#[test]
fn exact_a_map_of_a_leaning_frame_holds_the_drift_at_rest() {
    let scratch = Scratch::new("leaning_map");
    let (before, _) = LEANING.split_once("[study.samples]").unwrap();
    let map = "[study.samples]\nharmonic = { frequency = [\"0.9 Hz\"], acceleration = [\"0.2 m/s2\"] }\n";
    let file = format!("{before}{map}").replace("{ value = 0.11, cov = 0.3 }", "0.2");
    let drift = |tilt: &str| -> f64 {
        fs::write(scratch.path().join("project.toml"), file.replace("1/100", tilt)).unwrap();
        let answer = scratch.dolmen("study . --study samples -o out --restart");
        assert_eq!(answer.status, 0, "{}{}", answer.stdout, answer.stderr);
        let row = rows(&scratch.path().join("out/samples/harmonic.csv")).remove(0);
        assert_eq!(row["state"], "steady", "{row:?}");
        number(&row, "drift_m")
    };
    let factor = 0.2e6 * 4.0 / (30e3 * 9.80665);
    let at_rest = 4.0 * 0.01 / (factor - 1.0);
    let (plumb, leaning) = (drift("0"), drift("1/100"));
    assert!(
        (leaning - plumb - at_rest).abs() < 1e-3 * at_rest,
        "{plumb} {leaning} {at_rest}"
    );
}

/// A bed whose drawn strength is below the pressure of the weight, N/b², crushes without shaking: it is no error, and not left out.
#[test]
fn exact_which_samples_crush_their_bed() {
    let joint = "joints = [ { stiffness = 900, strength = { value = \"0.2 MPa\", cov = 0.2 } } ]";
    let (before, after) = CHAIN.split_once("joints = ").unwrap();
    let (_, after) = after.split_once('\n').unwrap();
    let file = format!("{before}{joint}\n{after}")
        .replace("weight = { value = 30, cov = 0.1 }", "weight = 58")
        .replace("samples = 40", "samples = 30");
    let study = studied("crushed", &file);
    assert_eq!(
        study.answer.status, 0,
        "{}{}",
        study.answer.stdout, study.answer.stderr
    );
    let [right, said] = alone(&study, |row| drawn(row, "strength") <= 58e3 / 0.36);
    assert_eq!(said, right);
    assert!((1..15).contains(&right.len()), "{right:?}");
    let checked = study.scratch.dolmen("check . --samples 200");
    assert!(
        checked.words().contains("of 200 samples"),
        "{}{}",
        checked.stdout,
        checked.stderr
    );
}
