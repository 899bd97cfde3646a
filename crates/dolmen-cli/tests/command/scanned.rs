// SOURCE     examples/scanned_tower/tower.ply, made by scripts/example-scan of boxes and frusta with noise of 0.5 mm; their first motion by hand
// GOAL       One scan becomes a project that can be checked at once; otherwise nothing is written and the answer gives the reason.
// TOLERANCE  2 % of the first motion by hand, the tolerance for joints of noisy stones; 0.5 % of the volume

use super::verbs::Scratch;
use std::fs;

const NEW: &str = "new pagoda tower --scan examples/scanned_tower/tower.ply --beds 0.30,0.93,1.20";

/// Half widths at base and top, height, centre along x, m, as in scripts/example-scan.
const STONES: [[f64; 4]; 4] = [
    [0.4, 0.4, 0.3, 0.0],
    [0.24, 0.24, 0.64, 0.0],
    [0.38, 0.26, 0.26, 0.025],
    [0.2, 0.18, 0.36, 0.025],
];

fn volume([a, b, h, _]: [f64; 4]) -> f64 {
    4.0 * h / 3.0 * (a * a + a * b + b * b)
}

/// Minimum over all beds, along ±x and ±y: distance of the edge from the centroid of the part above, divided by the height of that centroid.
fn tips_at() -> f64 {
    let mut least = f64::INFINITY;
    for from in 0..STONES.len() {
        let (mut volumes, mut up, mut along, mut z) = (0.0, 0.0, 0.0, 0.0);
        for stone in &STONES[from..] {
            let [a, b, h, off] = *stone;
            let own = volume(*stone);
            let centroid = 0.25 * h * (a * a + 2.0 * a * b + 3.0 * b * b) / (a * a + a * b + b * b);
            (volumes, up, along) = (volumes + own, up + own * (z + centroid), along + own * off);
            z += h;
        }
        let [base, _, _, off] = STONES[from];
        let [mut low, mut high, mut half] = [off - base, off + base, base];
        if let Some([_, top, _, off]) = from.checked_sub(1).map(|below| STONES[below]) {
            (low, high, half) = (low.max(off - top), high.min(off + top), half.min(top));
        }
        let (middle, height) = (along / volumes, up / volumes);
        least = least.min((high - middle).min(middle - low).min(half) / height);
    }
    least
}

#[test]
fn exact_project_from_one_scan_begins_to_move_as_its_solids() {
    let scratch = Scratch::with_examples("one-scan");
    let made = scratch.dolmen(NEW);
    assert_eq!(made.status, 0, "{}", made.stderr);
    for said in [
        "4 stones at 3 beds; together they hold",
        "was read in mm, which makes 1.56",
        "Beds put at the step of the section next to the height given: 1",
        "The beds are planes because they were cut",
    ] {
        assert!(made.words().contains(said), "{said}: {}", made.stdout);
    }
    for file in ["project.toml", "stone-1.ply", "stone-4.ply", "drawing.svg"] {
        assert!(scratch.path().join("tower").join(file).is_file(), "{file}");
    }
    let checked = scratch.briefly("check tower --json");
    assert_eq!(checked.status, 0, "{}", checked.stderr);
    let json: serde_json::Value = serde_json::from_str(&checked.stdout).unwrap();
    let found = json["state"]["check"]["stack"]["capacity"]["acceleration_g"]
        .as_f64()
        .unwrap();
    // friction of 0.6 is larger
    assert!(
        (found / tips_at() - 1.0).abs() < 0.02,
        "{found} for {}",
        tips_at()
    );
}

#[test]
fn exact_json_of_a_scan_has_its_cuts() {
    let scratch = Scratch::with_examples("scan-json");
    let made = scratch.briefly(&format!("{NEW} --json"));
    assert_eq!(made.status, 0, "{}", made.stderr);
    let json: serde_json::Value = serde_json::from_str(&made.stdout).unwrap();
    let whole: f64 = STONES.into_iter().map(volume).sum();
    assert!((json["volume_m3"].as_f64().unwrap() / whole - 1.0).abs() < 0.005);
    assert!((json["stones_over_scan_volume"].as_f64().unwrap() - 1.0).abs() < 0.005);
    assert_eq!(
        (&json["unit"], &json["unit_is_recognised"]),
        (&"mm".into(), &true.into())
    );
    let mut z = 0.0;
    for (number, stone) in STONES.iter().enumerate() {
        let found = json["stones"][number]["volume_m3"].as_f64().unwrap();
        assert!((found / volume(*stone) - 1.0).abs() < 0.01, "{number}: {found}");
        z += stone[2];
        if number < 3 {
            let cut = json["beds"][number]["cut_m"].as_f64().unwrap();
            assert!((cut - z).abs() < 5e-4, "{number}: {cut} for {z}");
        }
    }
}

#[test]
fn refuses_scans_with_what_to_do_and_writes_nothing() {
    let scratch = Scratch::with_examples("scan-refused");
    fs::write(scratch.path().join("cloud.las"), b"LASF and more").unwrap();
    fs::write(scratch.path().join("cloud.e57"), b"ASTM-E57 and more").unwrap();
    let cube = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 4 3 2 1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    fs::write(scratch.path().join("open.obj"), cube).unwrap();
    let closed = format!("{cube}f 5 6 7 8\n");
    fs::write(scratch.path().join("closed.obj"), &closed).unwrap();
    let high = closed.replace(
        "v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1",
        "v 0 0 80\nv 1 0 80\nv 1 1 80\nv 0 1 80",
    );
    fs::write(scratch.path().join("high.obj"), high).unwrap();
    for (words, english, korean) in [
        (
            "--scan cloud.las --beds 1",
            "cloud of points (LAS, LAZ)",
            "점군(LAS, LAZ)",
        ),
        (
            "--scan cloud.e57 --beds 1",
            "make a closed mesh of it first",
            "닫힌 메시를 먼저 만들어",
        ),
        ("--scan open.obj --beds 0.5", "the mesh has a hole", "구멍"),
        (
            "--scan closed.obj --beds 0.5,0.3",
            "give each once, lowest first",
            "낮은 것부터 한 번씩 쓴다",
        ),
        (
            "--scan closed.obj --beds 350",
            "reaches from 0.0000 to 1.0000 m",
            "0.0000~1.0000 m에 걸친",
        ),
        (
            "--scan closed.obj --beds 0.5 --unit mm",
            "correct --unit",
            "--unit을 고친다",
        ),
        ("--scan high.obj --beds 0.5", "say with --unit", "--unit으로"),
        (
            "--scan closed.obj --beds 0.5,0.51",
            "is 10.0 mm thick",
            "두께가 10.0 mm",
        ),
        ("--scan absent.obj --beds 0.5", "absent.obj", "absent.obj"),
    ] {
        for (language, said) in [("en", english), ("ko", korean)] {
            let answer = scratch.briefly(&format!("new pagoda made {words} --language {language}"));
            assert_eq!(answer.status, 2, "{words}: {}", answer.stdout);
            assert!(
                answer.stderr.contains(said),
                "{words} {language}: {}",
                answer.stderr
            );
            assert!(!scratch.path().join("made").exists(), "{words}");
        }
    }
    let answer = scratch.briefly("new arch made --scan closed.obj --beds 0.5");
    assert_eq!(answer.status, 2, "{}", answer.stdout);
    assert!(
        answer.stderr.contains("cuts a scan into the stones of a pagoda"),
        "{}",
        answer.stderr
    );
    let answer = scratch.briefly("new pagoda made --scan closed.obj");
    assert_eq!(answer.status, 2, "{}", answer.stdout);
    // a folder that is not empty does not change either
    fs::create_dir(scratch.path().join("full")).unwrap();
    fs::write(scratch.path().join("full/mine.txt"), "mine").unwrap();
    let answer = scratch.briefly("new pagoda full --scan closed.obj --beds 0.5");
    assert_eq!(answer.status, 2, "{}", answer.stdout);
    assert_eq!(fs::read_dir(scratch.path().join("full")).unwrap().count(), 1);
}

/// A tower of a box of 1 m, one of 0.6 m and one of 0.9 m as one closed mesh; its beds are at 0.5 and 1.7 m.
fn stepped_tower() -> String {
    let rings = [
        (0.5, 0.0),
        (0.5, 0.5),
        (0.3, 0.5),
        (0.3, 1.7),
        (0.45, 1.7),
        (0.45, 2.0),
    ];
    let mut text = String::new();
    for (half, z) in rings {
        for (x, y) in [(-half, -half), (half, -half), (half, half), (-half, half)] {
            text += &format!("v {x} {y} {z}\n");
        }
    }
    for ring in 0..rings.len() - 1 {
        for side in 0..4 {
            let (a, b) = (4 * ring + side + 1, 4 * ring + (side + 1) % 4 + 1);
            text += &format!("f {a} {b} {}\nf {a} {} {}\n", b + 4, b + 4, a + 4);
        }
    }
    text + "f 4 3 2 1\nf 21 22 23 24\n"
}

#[test]
fn refuses_beds_beside_a_step_and_forgotten_beds() {
    let scratch = Scratch::new("scan-steps");
    fs::write(scratch.path().join("tower.obj"), stepped_tower()).unwrap();
    let new = "new pagoda made --scan tower.obj --beds";
    for (beds, english, korean) in [
        (
            "0.45,1.7",
            "steps at 0.500 m (1.000 → 0.360 m²), and no bed is there; it does not step at bed 1 (0.450 m)",
            "접합면 1 (0.450 m)에서는 단면이 바뀌지 않는다",
        ),
        (
            "1.7",
            "steps at 0.500 m (1.000 → 0.360 m²), and no bed is there. A tower without",
            "0.500 m (1.000 → 0.360 m²)에서 단면이 바뀌는데",
        ),
        ("0.5", "1.700 m (0.360 → 0.810 m²)", "--allow 1.700"),
    ] {
        for (language, said) in [("en", english), ("ko", korean)] {
            let answer = scratch.briefly(&format!("{new} {beds} --language {language}"));
            assert_eq!(answer.status, 2, "{beds}: {}", answer.stdout);
            assert!(answer.stderr.contains(said), "{beds}: {}", answer.stderr);
            assert!(!scratch.path().join("made").exists(), "{beds}");
        }
    }
    let whole = scratch.dolmen(&format!("{new} 0.51,1.7"));
    assert_eq!(whole.status, 0, "{}", whole.stderr);
    assert!(!whole.stdout.contains("steps within"), "{}", whole.stdout);
    let allowed = scratch.dolmen("new pagoda allowed --scan tower.obj --beds 0.5,1.0 --allow 1.7");
    assert_eq!(allowed.status, 0, "{}", allowed.stderr);
    for said in [
        "! The section steps within a stone, as --allow states: at 1.700 m (0.360 → 0.810 m²)",
        "! Beds without a step of the section: 2.",
    ] {
        assert!(allowed.words().contains(said), "{}", allowed.stdout);
    }
}

/// Two posts and a lintel: 1 % more height of one post alone would lift the lintel off the other, so it is no sensitivity.
#[test]
fn holds_heights_of_stones_that_carry_one_together_are_no_sensitivity() {
    let scratch = Scratch::new("shared-course");
    let text = "schema = 1\nkind = \"stack\"\nname = \"Trilithon\"\ndensity = 2500\njoint = { friction = 0.6 }\nblocks = [\n\
                { name = \"post a\", width = 0.5, height = 2, at = [-1, 0] },\n\
                { name = \"post b\", width = 0.5, height = 2, at = [1, 0], on = \"ground\" },\n\
                { name = \"lintel\", width = 2.6, depth = 0.5, height = 0.4, at = [0, 0], on = [\"post a\", \"post b\"] },\n]\n";
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let answer = scratch.dolmen("check project.toml --sensitivity");
    assert_eq!(answer.status, 0, "{}{}", answer.stdout, answer.stderr);
    let table = answer.stdout.split("Sensitivity of acceleration").nth(1).unwrap();
    assert!(
        table.contains("post a width") && table.contains("lintel height"),
        "{table}"
    );
    assert!(
        !table.contains("post a height") && !table.contains("post b height"),
        "{table}"
    );
}

/// Stones in map coordinates: at 4,000 km, rounding left forces of 4e-5 of the weight, so that a run under its own weight found no rest.
#[test]
fn refuses_stones_in_the_grid_of_a_map_and_says_what_to_take_off() {
    let scratch = Scratch::new("grid");
    let stone = |x: f64, y: f64| {
        let corners: Vec<String> = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
            .iter()
            .flat_map(|at| [0.0, 1.0].map(|z| format!("[{}, {}, {z}]", x + at[0], y + at[1])))
            .collect();
        let points = corners.join(", ");
        format!(
            "schema = 1\nkind = \"stack\"\nname = \"x\"\ndensity = 2600\nblocks = [\n{{ name = \"a\", shape = \"points\", coordinates = \"site\", points = [{points}] }},\n]\n"
        )
    };
    std::fs::write(scratch.path().join("far.toml"), stone(512_345.6, 4_012_345.7)).unwrap();
    std::fs::write(scratch.path().join("near.toml"), stone(5000.0, 3000.0)).unwrap();
    assert!(scratch.dolmen("check near.toml").status < 2);
    let refused = scratch.dolmen("check far.toml");
    assert_eq!(refused.status, 2);
    for part in [
        "lies 4012 km from the origin",
        "take 512340 off every x and 4012340 off every y",
    ] {
        assert!(refused.stderr.contains(part), "{}", refused.stderr);
    }
    let korean = scratch.dolmen("check far.toml --language ko");
    assert!(korean.stderr.contains("원점에서 4012 km"), "{}", korean.stderr);
}
