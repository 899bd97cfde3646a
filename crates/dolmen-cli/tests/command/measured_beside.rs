// SOURCE     docs/earthquakes.md, "Measured beside simulated".
// GOAL       A simulation under the ground motion of a survey is compared with the sensors above the ground: the right model agrees, one
//            whose stiffness is off by a fifth does not, as its frequency shows.
// PARAMETERS two storeys of 12 t and 10 t, 6 and 4 MN/m, 3 % in both modes; an earthquake of 1.5 m/s², noise of 2 mm/s²
// TOLERANCE  correlation 0.99 and peaks 3 %: noise and the line between samples at 100 Hz; frequency 3 %: a few lines of 0.03 Hz

use super::stores::{good, json, refused};
use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

const MASS_KG: [f64; 2] = [12e3, 10e3];
const STIFFNESS_N_M: [f64; 2] = [6e6, 4e6];
const HEIGHT_M: f64 = 3.0;
const DAMPING: f64 = 0.03;
const RATE_HZ: f64 = 100.0;

/// Frequency and mode shape.
type Mode = (f64, [f64; 2]);

/// Both modes in closed form: ω², and the shape with first component 1.
fn modes() -> [Mode; 2] {
    let g = 9.80665;
    let axial = [(MASS_KG[0] + MASS_KG[1]) * g, MASS_KG[1] * g];
    let k = [0, 1].map(|i| STIFFNESS_N_M[i] - axial[i] / HEIGHT_M);
    let [a, b, d] = [(k[0] + k[1]) / MASS_KG[0], k[1] / MASS_KG[0], k[1] / MASS_KG[1]];
    let (half, root) = (0.5 * (a + d), (0.25 * (a - d) * (a - d) + b * d).sqrt());
    [half - root, half + root].map(|square| (square.sqrt(), [1.0, (a - square) / b]))
}

/// Ground, floor and roof, m/s²: each mode by a Runge-Kutta method with ten steps per sample and linear interpolation of the ground.
fn record() -> Vec<[f64; 3]> {
    let mut state = 7u64;
    let mut random = move || {
        let mut sum = -6.0;
        for _ in 0..12 {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            sum += (state >> 11) as f64 / (1u64 << 53) as f64;
        }
        sum
    };
    let (mut ground, mut x, mut v) = (Vec::new(), 0.0, 0.0);
    for i in 0..13_000 {
        let t = f64::from(i) / RATE_HZ - 60.0;
        let envelope = match t {
            t if t < 0.0 => 0.0,
            t if t < 1.5 => t / 1.5,
            t if t < 12.0 => 1.0,
            t => (-(t - 12.0) / 4.0).exp(),
        };
        for _ in 0..10 {
            v += 1e-3 * (random() - 2.0 * 0.5 * 15.0 * v - 225.0 * x);
            x += 1e-3 * v;
        }
        ground.push(envelope * (225.0 * x + 15.0 * v));
    }
    let peak = ground.iter().fold(0.0_f64, |most, g| most.max(g.abs()));
    ground.iter_mut().for_each(|g| *g *= 1.5 / peak);
    let mut rows: Vec<[f64; 3]> = ground.iter().map(|g| [*g, 0.0, 0.0]).collect();
    for (w, shape) in modes() {
        let of = |power: i32| -> f64 { (0..2).map(|i| MASS_KG[i] * shape[i].powi(power)).sum() };
        let share = of(1) / of(2);
        let (mut q, mut p) = (0.0, 0.0);
        let rate = |q: f64, p: f64, g: f64| -2.0 * DAMPING * w * p - w * w * q - share * g;
        for i in 0..ground.len() - 1 {
            for floor in 0..2 {
                rows[i][1 + floor] += shape[floor] * (-2.0 * DAMPING * w * p - w * w * q);
            }
            let h = 0.1 / RATE_HZ;
            for part in 0..10 {
                let g = |share: f64| ground[i] + share * (ground[i + 1] - ground[i]);
                let [g1, g2, g3] = [0.0, 0.5, 1.0].map(|half| g((f64::from(part) + half) / 10.0));
                let (q1, p1) = (p, rate(q, p, g1));
                let (q2, p2) = (p + 0.5 * h * p1, rate(q + 0.5 * h * q1, p + 0.5 * h * p1, g2));
                let (q3, p3) = (p + 0.5 * h * p2, rate(q + 0.5 * h * q2, p + 0.5 * h * p2, g2));
                let (q4, p4) = (p + h * p3, rate(q + h * q3, p + h * p3, g3));
                q += h / 6.0 * (q1 + 2.0 * q2 + 2.0 * q3 + q4);
                p += h / 6.0 * (p1 + 2.0 * p2 + 2.0 * p3 + p4);
            }
        }
    }
    rows.iter_mut().flatten().for_each(|a| *a += 2e-3 * random());
    rows
}

fn frame(factor: f64) -> String {
    let k = STIFFNESS_N_M.map(|k| k * factor * 1e-6);
    format!(
        "schema = 1\nkind = \"frame\"\nname = {{ en = \"Two storeys\" }}\n\
         units = {{ length = \"m\", force = \"kN\", mass = \"t\", stiffness = \"kN/mm\" }}\n\
         storeys = [{{ mass = 12, height = 3 }}, {{ mass = 10, height = 3 }}]\n\
         [direction.x]\nstiffness = [{}, {}]\ndamping_ratio = 0.03\n\
         [survey.2026-09-12.records]\nfile = \"record.csv\"\nsampling_rate = \"100 Hz\"\nunit = \"m/s2\"\n\
         channels = [{{ column = \"G\", position = [0, 0, 0], direction = \"x\" }}, {{ column = \"F1\", position = [0, 0, 3], direction = \"x\" }}, \
         {{ column = \"RF\", position = [0, 0, 6], direction = \"-x\" }}]\n\
         [survey.2026-09-12.records.modal]\ninputs = [\"G\"]\n",
        k[0], k[1]
    )
}

/// The first value of a key, however deep.
fn first<'a>(value: &'a Value, key: &str) -> Option<&'a Value> {
    match value {
        Value::Object(table) => table
            .get(key)
            .or_else(|| table.values().find_map(|value| first(value, key))),
        Value::Array(list) => list.iter().find_map(|value| first(value, key)),
        _ => None,
    }
}

#[test]
fn agrees_a_model_under_its_measured_ground_and_one_a_fifth_too_stiff_does_not() {
    let scratch = Scratch::new("measured-beside");
    let rows = record().into_iter();
    // the roof sensor points along −x
    let rows = rows.map(|[g, f, r]| format!("{g:.5},{f:.5},{:.5}\n", -r));
    fs::write(
        scratch.path().join("record.csv"),
        "G,F1,RF\n".to_owned() + &rows.collect::<String>(),
    )
    .unwrap();
    let file = scratch.path().join("project.toml");
    let words = "simulate . --motion survey:2026-09-12";
    let number = |of: &Value, key: &str| of[key].as_f64().unwrap();
    fs::write(&file, frame(1.0)).unwrap();
    let right = json(&scratch, words);
    let measured = first(&right, "measured").unwrap();
    assert_eq!(
        (&measured["survey"], &measured["follows"]),
        (&"2026-09-12".into(), &true.into()),
        "{measured}"
    );
    for sensor in measured["sensors"].as_array().unwrap() {
        let peaks = number(sensor, "peak_simulated_m_s2") / number(sensor, "peak_measured_m_s2");
        assert!(
            number(sensor, "correlation") > 0.99 && (peaks - 1.0).abs() < 0.03,
            "{sensor}"
        );
        assert!(number(sensor, "residual_ratio") < 0.1, "{sensor}");
    }
    let roof = &measured["sensors"][1];
    assert_eq!(roof["channel"], "RF");
    let hz = modes()[0].0 / std::f64::consts::TAU;
    assert!(
        (number(roof, "frequency_measured_hz") / hz - 1.0).abs() < 0.03,
        "{roof} {hz}"
    );
    let said = good(scratch.briefly(words)).stdout;
    assert!(
        said.contains("the model moves as survey 2026-09-12 measured"),
        "{said}"
    );
    let said = good(scratch.briefly(&format!("{words} --full -o out"))).stdout;
    assert!(
        said.contains("Measured (survey 2026-09-12) beside simulated"),
        "{said}"
    );
    assert!(
        scratch
            .path()
            .join("out/x")
            .read_dir()
            .unwrap()
            .any(|file| { file.unwrap().file_name().to_string_lossy().contains("measured-2") })
    );
    fs::write(&file, frame(1.2)).unwrap();
    let wrong = json(&scratch, words);
    let measured = first(&wrong, "measured").unwrap();
    assert_eq!(measured["follows"], false, "{measured}");
    let roof = &measured["sensors"][1];
    let ratio = number(roof, "frequency_simulated_hz") / number(roof, "frequency_measured_hz");
    assert!((ratio - 1.2f64.sqrt()).abs() < 0.05, "{ratio}");
    let said = good(scratch.briefly(words)).stdout;
    assert!(said.contains("MODEL AND MEASUREMENT DIFFER"), "{said}");
    // a simulation that does not agree with the record does not show that the structure is safe
    assert!(said.contains("not decided"), "{said}");
    let with = |from: &str, to: &str| {
        fs::write(&file, frame(1.0).replace(from, to)).unwrap();
        good(scratch.briefly(words)).stdout
    };
    let said = with("[0, 0, 6]", "[0, 0, 9]");
    assert!(said.contains("Not compared") && said.contains("RF"), "{said}");
    let said = with("direction = \"-x\"", "direction = \"y\"");
    assert!(said.contains("Not compared") && said.contains("RF"), "{said}");
    let said = with("direction = \"-x\"", "direction = \"x\"");
    assert!(said.contains("opposite to RF"), "{said}");
    // a direction without a recorded ground motion
    let said = with(
        "[survey.2026-09-12.records]",
        "[direction.y]\nstiffness = [8, 8]\n[survey.2026-09-12.records]",
    );
    let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        said.contains("Direction y is moved by the ground that survey 2026-09-12 recorded along x"),
        "{said}"
    );
    // a scaled motion is not comparable with the record
    let changed = json(&scratch, &format!("{words} --scale 2"));
    assert!(first(&changed, "measured").unwrap().is_null());
}

/// Seventy seconds of noise, and an earthquake whose beginning is missing: the model is not blamed.
#[test]
fn holds_a_record_in_which_no_earthquake_stands_out_blames_no_model() {
    let scratch = Scratch::new("no-earthquake");
    fs::write(scratch.path().join("project.toml"), frame(1.0)).unwrap();
    let rows = record();
    for part in [&rows[..5900], &rows[7000..8000]] {
        let lines = part.iter().map(|[g, f, r]| format!("{g:.5},{f:.5},{:.5}\n", -r));
        fs::write(
            scratch.path().join("record.csv"),
            "G,F1,RF\n".to_owned() + &lines.collect::<String>(),
        )
        .unwrap();
        let said = good(scratch.briefly("simulate . --motion survey:2026-09-12")).stdout;
        let words = said.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(
            words.contains("no earthquake stands out of the record of survey 2026-09-12"),
            "{said}"
        );
        assert!(!words.contains("does not move as the structure did"), "{said}");
    }
}

#[test]
fn refuses_a_survey_without_a_measured_ground() {
    let scratch = Scratch::new("unmeasured-ground");
    let text = frame(1.0);
    let rows: String = (0..3000)
        .map(|i| format!("{},{},{}\n", i * i % 17, i * i % 13, i * i % 11))
        .collect();
    fs::write(scratch.path().join("record.csv"), "G,F1,RF\n".to_owned() + &rows).unwrap();
    let run = |text: &str, words: &str| {
        fs::write(scratch.path().join("project.toml"), text).unwrap();
        scratch.briefly(&format!("simulate . --motion {words}"))
    };
    let without = text.split("[survey.2026-09-12.records.modal]").next().unwrap();
    refused(
        &run(without, "survey:2026-09-12"),
        "records.modal.inputs = [\"G\"]",
    );
    refused(&run(&text, "survey:2027"), "2026-09-12");
    refused(&run(&text, "survey:2026-09-12 --unit g"), "leave --unit out");
    let without = text.replace("unit = \"m/s2\"\n", "");
    refused(
        &run(&without, "survey:2026-09-12"),
        "no acceleration along x, y or z",
    );
}
