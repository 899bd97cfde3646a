// SOURCE     The shipped twisting floor and tower in the mean wind of EN 1991-1-4.
// GOAL       From the user's file to the answer: forces by hand, no torsion of a symmetric building, limits in headline and exit status,
//            refusals.
// TOLERANCE  1e-9 of forces by hand (one strip at one height); ratios and words as each test says.

use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

const WIND: &str =
    r#"speed = 27, means = "10 min", code = "EN 1991-1-4", terrain = "II", force_coefficient = 1.3"#;

/// The wind with these limits; limits more generous than any code's are allowed by name.
pub(crate) fn wind_line(limits: &str) -> String {
    let lenient = [
        ("acceleration_limit = \"9 ", "acceleration_limit"),
        ("drift_limit = 0.05", "drift_limit"),
    ];
    let given = lenient.iter().filter(|(text, _)| limits.contains(text));
    let paths: Vec<String> = given.map(|(_, key)| format!("\"wind.{key}\"")).collect();
    let allow = match paths.is_empty() {
        true => String::new(),
        false => format!("allow = [{}]\n", paths.join(", ")),
    };
    format!("{allow}wind = {{ {WIND}{limits} }}")
}

/// The shipped floor of 10 × 8 m at 30 m with an additional line.
fn floor_with(scratch: &Scratch, line: &str) {
    let file = scratch.path().join("examples/twisting_floor/project.toml");
    let text = fs::read_to_string(&file).unwrap();
    let text = text.replacen("\np_delta", &format!("\n{line}\np_delta"), 1);
    let to = scratch.path().join("floor");
    fs::create_dir_all(&to).unwrap();
    fs::write(to.join("project.toml"), text).unwrap();
}

fn wind_of(scratch: &Scratch, line: &str) -> Value {
    floor_with(scratch, line);
    let answer = scratch.dolmen("--json check floor");
    let json: Value = serde_json::from_str(&answer.stdout).unwrap();
    json["state"]["check"]["building"]["standing"]["wind"].clone()
}

fn number(value: &Value, path: &str) -> f64 {
    value.pointer(path).and_then(Value::as_f64).unwrap_or(f64::NAN)
}

#[test]
fn exact_mean_forces_by_hand_and_no_twist_without_eccentricity() {
    let scratch = Scratch::with_examples("wind_on_a_floor");
    let wind = wind_of(&scratch, &format!("wind = {{ {WIND}, eccentricity = 0 }}"));
    // the upper half of 30 m, at 22.5 m: v_m = 0.19 ln(22.5/0.05) 27, F = ½ ρ C_f b h v²
    let speed = 0.19 * (22.5_f64 / 0.05).ln() * 27.0;
    for (axis, breadth) in [("along_x", 8.0), ("along_y", 10.0)] {
        let force = 0.5 * 1.25 * 1.3 * breadth * 15.0 * speed * speed;
        let shear = number(&wind, &format!("/{axis}/without_dampers/base_shear_n/mean"));
        assert!((shear / force - 1.0).abs() < 1e-9, "{axis}: {shear} {force}");
        let met = number(&wind, &format!("/{axis}/met/0/mean_speed_m_s"));
        assert!((met / speed - 1.0).abs() < 1e-12);
    }
    // the walls are eccentric along x only: wind along x causes no torsion, wind along y does
    let of = |axis: &str, what: &str| number(&wind, &format!("/{axis}/without_dampers/floors/0/{what}"));
    assert!(of("along_x", "rotation_rad_s2/rms") < 1e-9 * of("along_y", "rotation_rad_s2/rms"));
    let (corner, centre) = (
        of("along_x", "corner_m_s2/rms"),
        of("along_x", "acceleration_m_s2/rms"),
    );
    assert!((corner / centre - 1.0).abs() < 1e-9, "{corner} {centre}");
    assert!(of("along_y", "corner_m_s2/rms") > 1.05 * of("along_y", "acceleration_m_s2/rms"));
    // a peak is the mean plus g σ
    let peak = of("along_y", "displacement_m/mean")
        + of("along_y", "displacement_m/peak_factor") * of("along_y", "displacement_m/rms");
    assert!((peak / of("along_y", "displacement_m/peak") - 1.0).abs() < 1e-12);
    // eccentric wind causes torsion
    let off = wind_of(&scratch, &format!("wind = {{ {WIND} }}"));
    assert!(number(&off, "/eccentricity") == 0.15);
    let twisted = number(&off, "/along_x/without_dampers/floors/0/corner_m_s2/rms");
    assert!(twisted > 1.01 * corner, "{twisted} {corner}");
}

#[test]
fn holds_limits_decide_headline_and_exit_and_without_them_nothing_is_judged() {
    let scratch = Scratch::with_examples("wind_limits");
    let limits = |limit: &str| {
        floor_with(&scratch, &wind_line(limit));
        let brief = scratch.briefly("check floor");
        (brief.status, brief.words().to_owned())
    };
    let (status, words) = limits("");
    assert_eq!(status, 0, "{words}");
    assert!(words.contains("Wind: not decided (no limit is known)"), "{words}");
    let whole = scratch.dolmen("check floor");
    assert!(
        whole.words().contains("no limit of a code is held here"),
        "{}",
        whole.stdout
    );
    let (status, words) = limits(r#", acceleration_limit = "0.001 m/s2""#);
    assert_eq!(status, 1, "{words}");
    assert!(
        words.contains("Wind: beyond its limits (limit/acceleration"),
        "{words}"
    );
    let (status, words) = limits(r#", acceleration_limit = "9 m/s2", drift_limit = 0.05"#);
    assert_eq!(status, 0, "{words}");
    assert!(words.contains("Wind: within its limits"), "{words}");
    let korean = scratch.briefly("check floor --language ko");
    assert!(korean.words().contains("풍응답: 한계 이내"), "{}", korean.stdout);
    let (status, words) = limits(", drift_limit = 0.00002");
    assert_eq!(status, 1, "{words}");
    assert!(words.contains("beyond its limit in the wind along"), "{words}");
    // a profile that ends below the roof
    floor_with(&scratch, &format!("wind = {{ {WIND}, drift_limit = 0.01 }}"));
    let path = scratch.path().join("floor/project.toml");
    let tall = fs::read_to_string(&path)
        .unwrap()
        .replace("height = 30", "height = \"300 m\"");
    fs::write(&path, format!("allow = [\"floors[1].height\"]\n{tall}")).unwrap();
    let answer = scratch.dolmen("check floor");
    assert!(
        answer
            .words()
            .contains("the profile of the code holds up to 200 m"),
        "{}{}",
        answer.stdout,
        answer.stderr
    );
    assert!(answer.words().contains("Wind: not decided"), "{}", answer.stdout);
}

#[test]
fn refuses_what_is_no_mean_wind_on_a_building() {
    let scratch = Scratch::with_examples("wind_refused");
    for (line, said) in [
        (
            r#"wind = { speed = 40, means = "gust", force_coefficient = 1.3 }"#,
            "a building swings about the mean wind",
        ),
        (
            r#"wind = { pressure = 900, means = "gust", force_coefficient = 1.3 }"#,
            "says nothing of how gusts come and go",
        ),
        (
            r#"wind = { speed = 27, means = "10 min", code = "EN 1991-1-4", force_coefficient = 1.3 }"#,
            "wind has a code, but no terrain",
        ),
        (
            r#"wind = { speed = 97, means = "10 min", code = "EN 1991-1-4", terrain = "II", force_coefficient = 1.3 }"#,
            "100 km/h is 28 m/s",
        ),
        (
            r#"wind = { speed = 27, means = "10 min", code = "KDS 41 12 00", terrain = "B", density = 1225, force_coefficient = 1.3 }"#,
            "air has 1.2 kg/m3",
        ),
        (
            r#"wind = { speed = 27, means = "10 min", code = "EN 1991-1-4", terrain = "II", force_coefficient = 1.3, areas = [{ part = "roof", area = 3 }] }"#,
            "the wind meets the breadth of the floors",
        ),
        (
            r#"wind = { speed = 27, means = "10 min", code = "EN 1991-1-4", terrain = "II", force_coefficient = 1.3, eccentricity = 5 }"#,
            "wind.eccentricity",
        ),
        (
            r#"loads = [{ name = "sign", at = "roof", force = "2 kN" }]"#,
            "is one number, but a floor is pushed in two directions",
        ),
    ] {
        floor_with(&scratch, line);
        let answer = scratch.dolmen("check floor");
        assert_eq!(answer.status, 2, "{line}: {}", answer.stdout);
        let stderr = answer.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(stderr.contains(said), "{line}: {stderr}");
    }
    // the same keys in the file of a pole
    let pole = scratch.path().join("examples/naju_flagpole/wind.toml");
    let text = fs::read_to_string(&pole).unwrap();
    fs::write(
        &pole,
        text.replace("means = \"gust\",", "means = \"gust\", drift_limit = 0.002,"),
    )
    .unwrap();
    let answer = scratch.dolmen("check examples/naju_flagpole/wind.toml");
    assert!(
        answer
            .stderr
            .contains("has no meaning without kind = \"building\""),
        "{}",
        answer.stderr
    );
}

#[test]
fn holds_a_damper_is_tuned_to_the_wind_of_the_file() {
    let scratch = Scratch::with_examples("wind_tuned");
    let without = scratch.dolmen("tune examples/far_from_the_centre --load gusts --map 4");
    assert_eq!(without.status, 2, "{}", without.stdout);
    assert!(
        without.stderr.contains("--load gusts is the wind of the file"),
        "{}",
        without.stderr
    );
    let file = scratch.path().join("examples/far_from_the_centre/project.toml");
    let text = fs::read_to_string(&file).unwrap();
    fs::write(
        &file,
        text.replacen(
            "\np_delta",
            &format!("\nwind = {{ {WIND}, eccentricity = 0 }}\np_delta"),
            1,
        ),
    )
    .unwrap();
    let answer = scratch.dolmen("--json tune examples/far_from_the_centre --load gusts --map 4");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let json: Value = serde_json::from_str(&answer.stdout).unwrap();
    let tuned = &json["dampers"][0];
    assert_eq!(tuned["load"]["kind"], "gusts");
    // tabulated frequencies and full integration agree
    assert!(
        number(tuned, "/prepared_frequencies_apart").abs() < 1e-3,
        "{tuned}"
    );
    // the check gives the same for the damper in the file, with centred wind
    let check = scratch.dolmen("--json check examples/far_from_the_centre");
    let check: Value = serde_json::from_str(&check.stdout).unwrap();
    let wind = &check["state"]["check"]["building"]["standing"]["wind"]["along_y"];
    let stroke = number(wind, "/with_dampers/strokes_m/0/rms");
    let given = number(tuned, "/choices/0/stroke_rms_m");
    assert!((given / stroke - 1.0).abs() < 1e-4, "{given} {stroke}");
    // the best position and tuning gives the smallest response
    let cost = |choice: usize| number(tuned, &format!("/choices/{choice}/cost"));
    let best = (0..5).map(cost).fold(f64::INFINITY, f64::min);
    assert!(best < 0.95 * cost(0), "{best} {}", cost(0));
}

#[test]
fn holds_the_shipped_tower_and_its_damper() {
    let scratch = Scratch::with_examples("wind_tower");
    let answer = scratch.dolmen("--json check examples/tower_in_wind");
    assert_eq!(answer.status, 1, "{}", answer.stderr);
    let json: Value = serde_json::from_str(&answer.stdout).unwrap();
    let top = |at: &str| {
        number(
            &json,
            &format!("{at}/check/building/standing/wind/top_peak_acceleration_m_s2"),
        )
    };
    let (without, with) = (top("/state"), top("/variants/0/state"));
    assert!((0.6..0.75).contains(&(with / without)), "{with} {without}");
    let room = json
        .pointer("/variants/0/state/check/building/standing/wind/beyond_room")
        .unwrap();
    assert_eq!(room.as_array().map(Vec::len), Some(0));
}
