// SOURCE     Made records: decaying oscillations of many periods, scaled and distorted; a station in the format of a Korean network.
// GOAL       A folder of records becomes a suite whose mean spectrum follows a demand, by a separate integration of the files; its lines work
//            in a project file; columns of one file are x, y and z alike in a project, on the command line and in a study.
// TOLERANCE  1e-3 of the spectra (steps of a hundredth of the period against exact peaks); motions to their last digit.

use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

/// A record of five decaying oscillations with random weights from a seed.
fn record(seed: u64, size: f64) -> Vec<f64> {
    let mut state = seed;
    let mut draw = || {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let swings: Vec<[f64; 3]> = [0.12, 0.25, 0.5, 1.0, 2.0]
        .map(|period_s| [period_s * (0.7 + 0.6 * draw()), 0.3 + draw(), 6.3 * draw()])
        .to_vec();
    let at = |k: usize| {
        let t = 0.01 * k as f64;
        let envelope = (t / 2.0).min(1.0) * (-(t - 2.0).max(0.0) / 3.0).exp();
        let sum: f64 = swings
            .iter()
            .map(|[period_s, weight, phase]| weight * (std::f64::consts::TAU * t / period_s + phase).sin())
            .sum();
        size * envelope * sum
    };
    (0..1500).map(at).collect()
}

fn pool(scratch: &Scratch) {
    let folder = scratch.path().join("records");
    fs::create_dir_all(&folder).unwrap();
    for seed in 1..=8 {
        let samples = record(seed, 0.4 + 0.3 * seed as f64);
        let mut text = "time_s,acceleration_m_s2\n".to_owned();
        for (k, a) in samples.iter().enumerate() {
            text += &format!("{:.2},{a}\n", 0.01 * k as f64);
        }
        fs::write(folder.join(format!("Made {seed}.csv")), text).unwrap();
    }
    let mut station = "UD(gal),time,NS (cm/s^2),EW[gal]\n".to_owned();
    let [up, north, east] = [31, 32, 33].map(|seed| record(seed, 40.0));
    for k in 0..1500 {
        station += &format!("{},{:.2},{},{}\n", up[k], 0.01 * k as f64, north[k], east[k]);
    }
    fs::write(scratch.path().join("station.csv"), &station).unwrap();
    fs::write(folder.join("station.csv"), station).unwrap();
    fs::write(folder.join("readme.txt"), "Records made for a test.\n").unwrap();
}

/// Largest pseudo-acceleration of an oscillator by the average acceleration method, with steps of 1/200 of the shorter of period and sample.
fn pseudo_acceleration(samples: &[f64], step_s: f64, period_s: f64) -> f64 {
    let (omega, zeta) = (2.0 * std::f64::consts::PI / period_s, 0.05);
    let parts = (step_s / (period_s / 400.0)).ceil().max(4.0) as usize;
    let h = step_s / parts as f64;
    let (mut u, mut v, mut most) = (0.0_f64, 0.0_f64, 0.0_f64);
    let mut acceleration = -samples[0];
    let after = (2.0 * period_s / h) as usize;
    let ground = |n: usize| {
        let (k, part) = (n / parts, n % parts);
        match (samples.get(k), samples.get(k + 1)) {
            (Some(a), Some(b)) => a + (b - a) * part as f64 / parts as f64,
            (Some(a), None) if part == 0 => *a,
            _ => 0.0,
        }
    };
    let last = (samples.len() - 1) * parts;
    for n in 1..=last + after {
        let p = -ground(n)
            + omega * omega * (-u - h * v - h * h / 4.0 * acceleration)
            + 2.0 * zeta * omega * (-v - h / 2.0 * acceleration);
        let new = p / (1.0 + zeta * omega * h + omega * omega * h * h / 4.0);
        u += h * v + h * h / 4.0 * (acceleration + new);
        v += h / 2.0 * (acceleration + new);
        acceleration = new;
        most = most.max(u.abs());
    }
    omega * omega * most
}

fn column(text: &str, column: usize) -> Vec<f64> {
    let rows = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    rows.map(|line| line.split(',').nth(column).unwrap().parse().unwrap())
        .collect()
}

#[test]
fn agrees_with_the_mean_spectrum_of_the_files_by_another_integration() {
    let scratch = Scratch::new("suite");
    pool(&scratch);
    let answer = scratch.dolmen("motion --suite 3 --from records --site S2 --t1 0.5 -o suite --json");
    assert_eq!(answer.status, 0, "{} {}", answer.stdout, answer.stderr);
    let json: Value = serde_json::from_str(&answer.stdout).unwrap();
    let members = json["members"].as_array().unwrap();
    assert_eq!(members.len(), 3);
    let kinds: Vec<&str> = json["not_taken"]
        .as_array()
        .unwrap()
        .iter()
        .map(|one| one["kind"].as_str().unwrap())
        .collect();
    assert_eq!(kinds, ["refused", "vertical"], "{json}");
    assert_eq!(json["candidates"], 10);
    let list = |key: &str| -> Vec<f64> {
        let values = json[key].as_array().unwrap();
        values.iter().map(|value| value.as_f64().unwrap()).collect()
    };
    let (periods, means, targets) = (
        list("period_s"),
        list("mean_acceleration_m_s2"),
        list("target_acceleration_m_s2"),
    );
    assert!((periods[0] - 0.1).abs() < 1e-12 && (periods[149] - 1.0).abs() < 1e-12);
    for k in (0..150).step_by(37) {
        let mut mean = 0.0;
        for member in members {
            let name = member["name"].as_str().unwrap();
            let text = fs::read_to_string(scratch.path().join("suite").join(format!("{name}.csv"))).unwrap();
            let samples: Vec<f64> = column(&text, 1)
                .iter()
                .map(|a| a * member["factor"].as_f64().unwrap())
                .collect();
            mean += pseudo_acceleration(&samples, 0.01, periods[k]) / 3.0;
        }
        assert!(
            (mean / means[k] - 1.0).abs() < 1e-3,
            "{} {mean} {}",
            periods[k],
            means[k]
        );
        // KDS 17 10 00, zone I, 2400 years, S2: S = 0.22 g, plateau 2.5 Fa S from 0.06 to 0.3 s, Fa = 1.38
        if periods[k] < 0.3 {
            assert!(
                (targets[k] / (2.5 * 1.38 * 0.22 * 9.80665) - 1.0).abs() < 1e-9,
                "{}",
                targets[k]
            );
        }
    }
    let ratio = |k: usize| means[k] / targets[k];
    let lowest = (0..150).map(ratio).fold(f64::MAX, f64::min);
    let average = (0..150).map(ratio).sum::<f64>() / 150.0;
    assert!((json["misfit"]["lowest"].as_f64().unwrap() - (lowest - 1.0)).abs() < 1e-12);
    assert!(lowest > 0.9 - 1e-9 && average > 1.0 - 1e-9 && (lowest < 0.9 + 1e-9 || average < 1.0 + 1e-9));
}

const STONE: &str = "schema = 1\nkind = \"stack\"\nname = \"A stone\"\ndensity = 2600\njoint = { friction = 0.7 }\n\
                     blocks = [{ name = \"foot\", width = 1.0, height = 0.3 }, { name = \"stone\", width = 0.6, height = 0.9 }]\n";

#[test]
fn exact_the_lines_of_a_suite_stand_in_a_project() {
    let scratch = Scratch::new("suite-project");
    pool(&scratch);
    let answer = scratch.dolmen("motion --suite 2 --from records --site S2 --range 0.1,1 -o suite");
    assert_eq!(answer.status, 0, "{} {}", answer.stdout, answer.stderr);
    for said in [
        "Suite of 2 motions",
        "2 of 10 records",
        "Dolmen's own rule",
        "readme.txt",
    ] {
        assert!(answer.words().contains(said), "{said}: {}", answer.stdout);
    }
    for file in ["suite.svg", "suite.json", "suite-spectra.csv"] {
        assert!(scratch.path().join("suite").join(file).is_file(), "{file}");
    }
    let lines = fs::read_to_string(scratch.path().join("suite/suite.toml")).unwrap();
    let quick = lines.replace("from = 0.5, to = 2, steps = 4", "from = 0.1, to = 0.2, steps = 2");
    fs::write(scratch.path().join("project.toml"), format!("{STONE}{quick}")).unwrap();
    let json: Value =
        serde_json::from_str(&fs::read_to_string(scratch.path().join("suite/suite.json")).unwrap()).unwrap();
    let first = &json["members"][0];
    let name = first["name"].as_str().unwrap();
    let simulated = scratch.dolmen(&format!(
        "simulate . --motion {name} --law springs --repeats 1 --json"
    ));
    let simulated: Value = serde_json::from_str(&simulated.stdout).unwrap();
    let component = &simulated["motion"]["components"][0];
    assert_eq!(
        component["peak_acceleration_m_s2"],
        first["peak_acceleration_m_s2"]
    );
    let studied = scratch.dolmen("study . -o out");
    assert_eq!(studied.status, 0, "{}", studied.stderr);
    let capacities = fs::read_to_string(scratch.path().join("out/suite/runs.csv")).unwrap();
    assert!(capacities.contains(name), "{capacities}");
}

#[test]
fn exact_columns_of_one_file_are_components_everywhere() {
    let scratch = Scratch::new("columns-of-a-station");
    pool(&scratch);
    let of = |arguments: &str| -> Value {
        let answer = scratch.dolmen(&format!("motion {arguments} --json"));
        assert_eq!(answer.status, 0, "{arguments}: {}", answer.stderr);
        serde_json::from_str(&answer.stdout).unwrap()
    };
    let [up, north, east] = [31, 32, 33].map(|seed| record(seed, 40.0));
    let peak = |samples: &[f64]| samples.iter().fold(0.0_f64, |most, a| most.max((a * 0.01).abs()));
    let alone = of("station.csv");
    let peaks = |json: &Value| -> Vec<f64> {
        let series = json["series"].as_array().unwrap();
        series
            .iter()
            .map(|one| one["peak_acceleration_m_s2"].as_f64().unwrap())
            .collect()
    };
    assert_eq!(peaks(&alone), [&up, &north, &east].map(|samples| peak(samples)));
    let components = [&east, &north, &up].map(|samples| peak(samples));
    assert_eq!(peaks(&of("station.csv --columns x=EW,y=ns,z=UD")), components);
    // numbers count the columns of the file, as in a spreadsheet: the second is the time
    assert_eq!(peaks(&of("station.csv --columns x=4,y=3,z=1")), components);
    let time = scratch.dolmen("motion station.csv --columns x=2,y=3");
    assert_eq!(time.status, 2, "{}", time.stdout);
    assert_eq!(peaks(&of("station.csv --x-azimuth 90")), components);
    let project = |lines: &str| {
        fs::write(
            scratch.path().join("project.toml"),
            format!("{STONE}[motion.station]\n{lines}\n"),
        )
        .unwrap();
        scratch.dolmen("simulate . --motion station --law springs --repeats 1 --json")
    };
    let by_columns = project("file = \"station.csv\"\ncolumns = { x = \"EW\", y = \"NS\", z = \"UD\" }");
    let by_azimuth = project("file = \"station.csv\"\nx_azimuth_deg = 90");
    let typed = scratch.dolmen(
        "simulate . --motion-file station.csv --columns x=EW,y=NS,z=UD --law springs --repeats 1 --json",
    );
    let ground = |answer: &super::verbs::Answer| -> Value {
        let json: Value =
            serde_json::from_str(&answer.stdout).unwrap_or_else(|_| panic!("{}", answer.stderr));
        json["joints"].clone()
    };
    assert!(!ground(&typed).is_null());
    assert_eq!(ground(&by_columns), ground(&typed));
    assert_eq!(ground(&by_azimuth), ground(&typed));
    let wrong = project("file = \"station.csv\"");
    assert_eq!(wrong.status, 2);
    for said in [
        "3 channels (UD(gal), NS (cm/s^2), EW[gal])",
        "columns = {",
        "[motion.NAME]",
    ] {
        assert!(wrong.stderr.contains(said), "{said}: {}", wrong.stderr);
    }
    let wrong = project("file = \"station.csv\"\ncolumns = { x = \"EW\" }\nunit = \"g\"");
    assert!(
        wrong
            .stderr
            .contains("unit is \"g\", but the file says \"cm/s2\""),
        "{}",
        wrong.stderr
    );
}

#[test]
fn refuses_one_record_in_two_directions() {
    let scratch = Scratch::new("motion-twice");
    let samples: String = (0..100)
        .map(|i| format!("{:.2},{:.4}\n", 0.01 * f64::from(i), (0.3 * f64::from(i)).sin()))
        .collect();
    let file = |name: &str, samples: &str| {
        let text = format!("time (s),acceleration (m/s2)\n{samples}");
        fs::write(scratch.path().join(name), text).unwrap();
    };
    file("a.csv", &samples);
    file("copy.csv", &samples);
    file("b.csv", &samples.replace("0.00,", "0.00,-"));
    for files in ["a.csv a.csv", "a.csv copy.csv", "x=a.csv z=a.csv"] {
        let (english, korean) = (
            scratch.dolmen(&format!("motion {files}")),
            scratch.dolmen(&format!("motion {files} --language ko")),
        );
        assert_eq!((english.status, korean.status), (2, 2), "{}", english.stdout);
        assert!(
            english.stderr.contains("have the same record"),
            "{}",
            english.stderr
        );
        assert!(korean.stderr.contains("기록이 같다"), "{}", korean.stderr);
    }
    let other = scratch.dolmen("motion a.csv b.csv");
    assert_eq!(other.status, 0, "{}", other.stderr);
}

#[test]
fn exact_a_quarter_turn_moves_a_record_to_y() {
    let scratch = Scratch::new("motion-turned");
    let peaks = |words: &str| -> Vec<(String, f64)> {
        let answer = scratch.dolmen(&format!("motion {words} --json"));
        assert_eq!(answer.status, 0, "{words}: {}", answer.stderr);
        let json: Value = serde_json::from_str(&answer.stdout).unwrap();
        let series = json["series"].as_array().unwrap().iter();
        let of = |one: &Value| {
            let peak = one["peak_acceleration_m_s2"].as_f64().unwrap();
            (one["name"].as_str().unwrap().to_owned(), peak)
        };
        series.map(of).collect()
    };
    let pulse = "--make sine --peak 0.2g";
    let [(_, peak)] = peaks(pulse).try_into().unwrap();
    for (degrees, expected) in [
        (90, vec![("y", 1.0)]),
        (180, vec![("x", 1.0)]),
        (30, vec![("x", 0.75_f64.sqrt()), ("y", 0.5)]),
    ] {
        let found = peaks(&format!("{pulse} --turn {degrees}"));
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for ((name, turned), (axis, share)) in found.iter().zip(expected) {
            assert_eq!(name, axis);
            assert!((turned / peak - share).abs() < 1e-12, "{degrees}: {found:?}");
        }
    }
    fs::write(
        scratch.path().join("two.csv"),
        "time (s),EW (m/s2),NS (m/s2)\n0,0,0\n0.01,1,2\n0.02,0,1\n",
    )
    .unwrap();
    let refused = scratch.dolmen("motion two.csv --turn 30");
    assert_eq!(refused.status, 2, "{}", refused.stdout);
    assert!(
        refused
            .stderr
            .contains("the directions of the 2 channels are not given"),
        "{}",
        refused.stderr
    );
}
