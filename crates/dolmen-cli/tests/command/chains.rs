// SOURCE     The shipped flagpole (Choi 2021) and El Centro 1940 north-south.
// GOAL       The text on a simulated chain, its output files and the exit status follow from the simulation.
// TOLERANCE  none: printed words. Growth 1 %. Histories against the peaks printed beside them: their sampling.

use super::studies::rows;
use super::verbs::Scratch;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;

fn json(scratch: &Scratch, command: &str, status: i32) -> Value {
    let answer = scratch.dolmen(&format!("--json {command}"));
    assert_eq!(
        answer.status, status,
        "{command}: {}{}",
        answer.stdout, answer.stderr
    );
    serde_json::from_str(&answer.stdout).unwrap()
}

#[test]
fn published_criterion_falls_from_a_push_and_weight_times_height_stands() {
    let scratch = Scratch::with_examples("chain_push");
    let pole = "simulate examples/naju_flagpole/published_criterion.toml";
    let answer = scratch.dolmen(&format!("{pole} --push 1e-4rad"));
    assert_eq!(answer.status, 1, "{}", answer.stderr);
    for said in [
        "At the start the whole chain leans by 0.0001 rad",
        "Upright it does not stand by itself: small leans",
        "It falls: ‘shaft",
        "The shape that falls fastest grew",
    ] {
        assert!(answer.words().contains(said), "{said}: {}", answer.stdout);
    }
    let fell = json(&scratch, &format!("{pole} --push 1e-4rad"), 1);
    assert_eq!(fell["outcome"]["kind"], "fell");
    let growth = |key: &str| fell["growth"][key].as_f64().unwrap();
    let ratio = growth("rate_per_s") / growth("linear_rate_per_s");
    assert!((ratio - 1.0).abs() < 0.01, "{ratio}");
    // 1.03 P·H for 100 s
    let stood = json(
        &scratch,
        &format!("{pole} --variant weight_height --push 1e-4rad --duration 100"),
        0,
    );
    assert_eq!(stood["outcome"]["kind"], "stood");
    assert_eq!(stood["growth"], Value::Null);
    assert!((stood["duration_s"].as_f64().unwrap() - 100.0).abs() < 1e-9);
    let drift = stood["energy"]["left_over_ratio"].as_f64().unwrap();
    assert!(drift < 1e-8, "{drift:e}");
    let leans = |link: &Value| link["peak_rotation_rad"].as_f64().unwrap().abs();
    assert!(
        stood["links"]
            .as_array()
            .unwrap()
            .iter()
            .all(|link| leans(link) < 5e-3)
    );
    // the linear equations never let a stable chain fall, and exceed any angle with an unstable one
    let linear = json(&scratch, &format!("{pole} --push 1e-4rad --rotations small"), 1);
    assert_eq!(linear["rotations"], "small");
}

#[test]
fn holds_a_pole_is_shaken_before_and_after_repair_and_every_file_says_the_same() {
    let scratch = Scratch::with_examples("chain_shaken");
    let pole = "simulate examples/naju_flagpole --motion el-centro";
    let loose = json(&scratch, &format!("{pole} --variant loose"), 0);
    let wedged = json(&scratch, &format!("{pole} --variant wedged -o out"), 0);
    assert_eq!(loose["outcome"]["kind"], "opened");
    assert_eq!(wedged["outcome"]["kind"], "opened");
    let out = scratch.path().join("out");
    let text = |name: &str| fs::read_to_string(out.join(name)).unwrap();
    let own: Value = serde_json::from_str(&text("simulation.json")).unwrap();
    assert_eq!(own, wedged);
    let rows: Vec<Vec<f64>> = text("histories.csv")
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
        .collect();
    let peak = wedged["links"][4]["peak_rotation_rad"].as_f64().unwrap().abs();
    let most = rows.iter().map(|row| row[9].abs()).fold(0.0, f64::max);
    assert!(most <= peak && most > 0.99 * peak, "{most} {peak}");
    // moment of joint 5 after time, five links of two and four joints of three columns
    let moment = rows.iter().map(|row| row[24].abs()).fold(0.0, f64::max);
    let said = wedged["links"][4]["peak_moment_at_samples_n_m"].as_f64().unwrap();
    assert_eq!(moment, said);
    let openings: Vec<Vec<f64>> = text("openings.csv")
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
        .collect();
    assert!(!openings.is_empty());
    for (joint, link) in wedged["links"].as_array().unwrap().iter().enumerate() {
        let own = openings.iter().filter(|cells| cells[0] == (joint + 1) as f64);
        let open: f64 = own.map(|cells| cells[2] - cells[1]).sum();
        assert!((open - link["open_s"].as_f64().unwrap()).abs() < 1e-9, "{joint}");
    }
    assert!(wedged["energy"]["left_over_ratio"].as_f64().unwrap() < 1e-9);
    for figure in ["ground", "rotations", "loop-1", "loop-5", "openings", "energy"] {
        assert!(text(&format!("{figure}.svg")).starts_with("<svg"), "{figure}");
    }
}

#[test]
fn holds_friction_of_the_file_sticks_and_slips() {
    let scratch = Scratch::with_examples("chain_friction");
    let path = scratch.path().join("examples/naju_flagpole/project.toml");
    let rubbing = fs::read_to_string(&path).unwrap().replace(
        "bed_width = { value = 0.65, source = \"assumed\" }",
        "opening = \"held\", friction_moment = \"4 kN*m\", static_friction_moment = \"5 kN*m\"",
    );
    fs::write(&path, rubbing).unwrap();
    let pole = "simulate examples/naju_flagpole --motion el-centro --variant wedged";
    let answer = scratch.dolmen(&format!("{pole} -o out"));
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    assert!(answer.stdout.contains("5 then 4"), "{}", answer.stdout);
    assert!(answer.stdout.contains("changes of friction"), "{}", answer.stdout);
    let found = json(&scratch, pole, 0);
    let base = &found["links"][0];
    assert_eq!(base["friction"]["kinetic_moment_n_m"], 4000.0);
    let slipped = base["slipped_rad"].as_f64().unwrap();
    assert!(slipped > 0.0 && found["energy"]["friction_j"].as_f64().unwrap() > 0.0);
    let way: f64 = fs::read_to_string(scratch.path().join("out/slips.csv"))
        .unwrap()
        .lines()
        .skip(1)
        .map(|line| line.rsplit(',').next().unwrap().parse::<f64>().unwrap().abs())
        .sum();
    assert!((way - slipped).abs() < 1e-12, "{way} {slipped}");
    // friction dissipates its moment times the rotation
    let taken = found["energy"]["friction_j"].as_f64().unwrap();
    assert!((taken / (4000.0 * way) - 1.0).abs() < 1e-12, "{taken} {way}");
    // the page gives both moments
    for (language, said) in [("en", "5 then 4"), ("ko", "정지 5, 운동 4")] {
        let report = format!(
            "report examples/naju_flagpole --samples 0 --motion el-centro -o page.html --language {language}"
        );
        let answer = scratch.dolmen(&report);
        assert_eq!(answer.status, 0, "{}", answer.stderr);
        let page = fs::read_to_string(scratch.path().join("page.html")).unwrap();
        assert!(page.contains(said), "{language}: {said}");
    }
}

#[test]
fn holds_a_report_shows_versions_side_by_side_in_both_languages() {
    let scratch = Scratch::with_examples("chain_report");
    for (language, said) in [
        (
            "en",
            [
                "Simulated earthquake",
                "Simulated versions side by side",
                "Joints wedged, 3 P·H",
            ],
        ),
        (
            "ko",
            [
                "지진응답 시뮬레이션",
                "시뮬레이션 결과 비교",
                "접합부 쐐기 보강, 3 P·H",
            ],
        ),
    ] {
        let answer = scratch.dolmen(&format!(
            "report examples/naju_flagpole --samples 0 --motion el-centro -o page.html --language {language}"
        ));
        assert_eq!(answer.status, 0, "{}", answer.stderr);
        let page = fs::read_to_string(scratch.path().join("page.html")).unwrap();
        for said in said {
            assert!(page.contains(said), "{language}: {said}");
        }
    }
}

#[test]
fn refuses_what_moves_no_chain() {
    let scratch = Scratch::with_examples("chain_refused");
    for (words, said) in [
        ("--variant wedged", "nothing moves the chain: give --motion"),
        ("--motion el-centro", "the joints are unknown: `dolmen identify`"),
        (
            "--variant wedged --push 0.1",
            "\"0.1\" is no angle: it has no unit",
        ),
        ("--variant wedged --push 40deg", "must be at most 0.5 rad"),
        (
            "--variant wedged --push 1deg --direction x",
            "--direction names a direction of a frame",
        ),
    ] {
        let answer = scratch.dolmen(&format!("simulate examples/naju_flagpole {words}"));
        assert_eq!(answer.status, 2, "{words}: {}", answer.stdout);
        assert!(answer.stderr.contains(said), "{words}: {}", answer.stderr);
    }
    let stack = scratch.dolmen("simulate examples/p10 --push 1deg");
    assert_eq!(stack.status, 2);
    assert!(
        stack.stderr.contains("--push lets a chain lean"),
        "{}",
        stack.stderr
    );
}

#[test]
fn holds_a_study_of_a_chain_says_what_single_runs_say() {
    let scratch = Scratch::with_examples("chain_study");
    let pole = "examples/naju_flagpole";
    let answer = scratch.dolmen(&format!("study {pole} --study growth -o out"));
    assert_eq!(answer.status, 0, "{}{}", answer.stdout, answer.stderr);
    for said in [
        "at which the chain first falls",
        "As the shaking grows: largest over the links and joints",
    ] {
        assert!(answer.words().contains(said), "{said}: {}", answer.stdout);
    }
    let folder = scratch.path().join("out/growth");
    for scan in rows(&folder.join("capacities.csv")) {
        let variant = &scan["variant"];
        for (key, status) in [("first_fall_m_s2", 1), ("survived_below_m_s2", 0)] {
            let peak: f64 = scan[key].parse().unwrap();
            let words =
                format!("simulate {pole} --variant {variant} --motion el-centro-1940-ns --peak {peak}m/s2");
            let single = json(&scratch, &words, status);
            let peaks = single["links"].as_array().unwrap().iter();
            let across = peaks.map(|link| link["peak_joint_rotation_rad"].as_f64().unwrap().abs());
            let runs = rows(&folder.join("runs.csv"));
            let at =
                |run: &BTreeMap<String, String>| run["peak_ground_acceleration_m_s2"].parse::<f64>().unwrap();
            let run = runs
                .iter()
                .find(|run| run["variant"] == *variant && (at(run) / peak - 1.0).abs() < 1e-9)
                .unwrap();
            let of_study: f64 = run["peak_joint_rotation_rad"].parse().unwrap();
            let off = (across.fold(0.0, f64::max) / of_study - 1.0).abs();
            assert!(off < 1e-9, "{variant} {key}: {off:e}");
        }
    }
    assert!(
        fs::read_to_string(folder.join("growth-open_share.svg"))
            .unwrap()
            .starts_with("<svg")
    );
    let mapped = scratch.dolmen(&format!("study {pole} --study map -o out"));
    assert_eq!(mapped.status, 0, "{}", mapped.stderr);
    let map = rows(&scratch.path().join("out/map/harmonic.csv"));
    for state in ["steady", "fell"] {
        assert!(map.iter().any(|row| row["state"] == state), "{state}");
    }
}

#[test]
fn refuses_studies_that_a_chain_cannot_have() {
    let scratch = Scratch::with_examples("chain_study_refused");
    let file = scratch.path().join("examples/naju_flagpole/project.toml");
    let whole = fs::read_to_string(&file).unwrap();
    for (from, to, said) in [
        ("variants = [\"loose\", \"wedged\"]", "", "the joints are unknown"),
        (
            "variants = [\"loose\", \"wedged\"]",
            "release = 0.1",
            "release is for frames, but this file has a chain",
        ),
        (
            "variants = [\"loose\", \"wedged\"]",
            "direction = \"x\"",
            "direction is for frames, but this file has a chain",
        ),
    ] {
        fs::write(&file, whole.replacen(from, to, 1)).unwrap();
        let answer = scratch.dolmen("study examples/naju_flagpole --study growth -o out");
        assert_eq!(answer.status, 2, "{said}: {}", answer.stdout);
        assert!(answer.stderr.contains(said), "{said}: {}", answer.stderr);
    }
}

#[test]
fn holds_a_run_cut_short_on_the_way_down_is_no_verdict() {
    let scratch = Scratch::with_examples("chain_cut");
    let words = "simulate examples/naju_flagpole/published_criterion.toml --push 1e-4rad --duration 2";
    let answer = scratch.dolmen(words);
    assert_eq!(answer.status, 1, "{}", answer.stdout); // it falls without any push
    assert!(
        answer
            .stdout
            .contains("No verdict: when the run ended, at 2.00 s"),
        "{}",
        answer.stdout
    );
    assert_eq!(json(&scratch, words, 1)["outcome"]["kind"], "still leaning");
}

#[test]
fn holds_a_simulated_chain_says_how_it_leans() {
    let scratch = Scratch::with_examples("chain_tilt");
    let run = "simulate examples/naju_flagpole --variant wedged --motion el-centro --keep-first 1";
    let said = "It leans as survey 2011-restored found it, tilt x 1/177, y 1/540, in the plane of the motion by all directions together: 5.945 mrad";
    assert!(scratch.briefly(run).words().contains(said));
    assert!(scratch.dolmen(run).words().contains(said));
}

/// The shipped flagpole with other wind.
fn flagpole_in(scratch: &Scratch, name: &str, change: &dyn Fn(String) -> String) -> String {
    let file = scratch.path().join("examples/naju_flagpole/wind.toml");
    let text = change(fs::read_to_string(file).unwrap());
    let path = format!("examples/naju_flagpole/{name}.toml");
    fs::write(scratch.path().join(&path), text).unwrap();
    path
}

#[test]
fn exact_the_flagpole_in_a_gust_is_unstable_and_the_headline_says_so() {
    let scratch = Scratch::with_examples("chain_wind");
    let answer = scratch.briefly("check examples/naju_flagpole/wind.toml");
    assert_eq!(answer.status, 1, "{}", answer.stderr);
    assert!(answer.words().contains("unstable in wind"), "{}", answer.stdout);
    // ½ 1.25 30² C_f 2.0 on a pole of 10.83 × 0.4 m: 26.39 kN m against 68.30 · 0.65/2 = 22.20 kN m, by hand
    let areas = [3.68, 2.61, 1.63, 1.54, 1.37];
    let areas: Vec<String> = areas
        .iter()
        .enumerate()
        .map(|(i, length)| format!("{{ part = \"links[{}]\", area = {} }}", i + 1, 0.4 * length))
        .collect();
    let even = flagpole_in(&scratch, "even", &|text: String| {
        let head = text.split("[survey").next().unwrap();
        head.replace(
            "means = \"gust\",",
            &format!("means = \"gust\", areas = [{}],", areas.join(", ")),
        )
    });
    let found = json(&scratch, &format!("check {even}"), 1);
    let joint = &found["state"]["loads"]["combinations"][0]["under"]["joints"][0];
    let number = |key: &str| joint[key].as_f64().unwrap();
    let by_hand = 562.5 * 2.0 * 0.4 * 10.83 * 10.83 / 2.0;
    assert!((number("rigid_moment_n_m") / by_hand - 1.0).abs() < 1e-12);
    assert!((number("limit_n_m") / (68.30e3 * 0.325) - 1.0).abs() < 1e-12);
    let ratio = number("rigid_moment_n_m") / number("limit_n_m");
    assert!((ratio - 1.19).abs() < 0.005, "{ratio}");
    assert!(number("moment_n_m") > number("rigid_moment_n_m"));
    assert_eq!(found["judgement"]["versions"][0]["governed_by"], "wind");
}

#[test]
fn holds_combinations_strength_and_codes_have_their_words() {
    let scratch = Scratch::with_examples("chain_combinations");
    let gale = |text: String| text.replace("value = 30,", "value = 12,");
    let combined = flagpole_in(&scratch, "combined", &|text| {
        let (head, rest) = gale(text)
            .split_once("[survey")
            .map(|(a, b)| (a.to_owned(), b.to_owned()))
            .unwrap();
        format!(
            "{head}loads = [{{ name = \"lamp\", at = \"shaft 2\", force = 0.05 }}]\n[combination.calm]\nwind = 0.5\n[combination.storm]\nweight = 0.9\nwind = 4.0\nloads = 1.0\n[survey{rest}"
        )
    });
    let found = json(&scratch, &format!("check {combined}"), 1);
    let versions = &found["judgement"]["versions"][0];
    assert_eq!(versions["governed_by"], "storm", "{versions}");
    let of = |name: &str| {
        let all = found["state"]["loads"]["combinations"].as_array().unwrap();
        let own = all.iter().find(|of| of["name"] == name).unwrap();
        own["load_factor"].as_f64().unwrap()
    };
    assert!(
        of("calm") > 1.0 && of("storm") < 1.0,
        "{} {}",
        of("calm"),
        of("storm")
    );
    // a strength of four times the pressure leaves three quarters of the moment
    let strong = flagpole_in(&scratch, "strong", &|text| {
        let strength_pa = 4.0 * 68.30e3 / (0.65 * 0.65);
        gale(text).replace(
            "{ stiffness = { value = 2219.1, source = \"assumed\" } }",
            &format!("{{ stiffness = 2219.1, strength = {strength_pa} }}"),
        )
    });
    let found = scratch.dolmen(&format!("--json check {strong}"));
    let found: Value = serde_json::from_str(&found.stdout).unwrap();
    let limit = found["state"]["loads"]["combinations"][0]["under"]["joints"][0]["limit_n_m"].as_f64();
    let uplift = found["state"]["check"]["chain"]["stability"]["joints"][0]["uplift_moment_n_m"].as_f64();
    for moment in [limit.unwrap(), uplift.unwrap()] {
        assert!(
            (moment / (0.75 * 68.30e3 * 0.325) - 1.0).abs() < 1e-12,
            "{moment}"
        );
    }
    // at 0.32 Hz the factor of KDS has no resonance, and the word is not "stable"
    let soft = flagpole_in(&scratch, "soft", &|text| {
        gale(text).replace(
            "means = \"gust\",",
            "means = \"10 min\", code = \"KDS 41 12 00\", terrain = \"C\",",
        )
    });
    let answer = scratch.briefly(&format!("check {soft}"));
    let reason = "unknown in wind (its resonance at 0.319 Hz is not in the wind)";
    assert!(answer.words().contains(reason), "{}", answer.stdout);
    let korean = scratch.briefly(&format!("check {soft} --language ko"));
    assert!(
        korean
            .words()
            .contains("고유진동수 0.319 Hz의 공진이 풍하중에 없음"),
        "{}",
        korean.stdout
    );
    let answer = scratch.dolmen(&format!("check {soft}"));
    assert!(answer.words().contains("Annex B"), "{}", answer.stdout);
    // a pole without wind in its file gets a finding
    let silent = scratch.briefly("check examples/naju_flagpole");
    assert!(
        silent.words().contains("Wind is not in the file"),
        "{}",
        silent.stdout
    );
}

#[test]
fn holds_variants_have_the_verdict_of_their_wind() {
    let scratch = Scratch::with_examples("chain_wind_variants");
    let answer = scratch.dolmen("check examples/naju_flagpole/wind.toml");
    let found = json(&scratch, "check examples/naju_flagpole/wind.toml", 1);
    let own = &found["variants"][1]["state"]["loads"]["combinations"][0]["load_factor"];
    assert!(own.as_f64().unwrap() < 1.0, "{own}");
    let said = format!(
        "Variant “EN 1991-1-4, 25 m/s, town” bears {:.3} times its wind and static loads, the structure as it is 0.429 times: unstable.",
        own.as_f64().unwrap()
    );
    assert!(answer.words().contains(&said), "{said}: {}", answer.stdout);
    assert!(
        !answer.words().contains("leaves the load factor"),
        "{}",
        answer.stdout
    );
}

#[test]
fn refuses_factors_on_nothing_and_says_what_no_combination_counts() {
    let scratch = Scratch::with_examples("chain_uncounted");
    let with = |lines: &str| {
        let path = flagpole_in(&scratch, "uncounted", &|text| {
            let (head, rest) = text.split_once("[survey").unwrap();
            format!("{head}{lines}\n[survey{rest}")
        });
        scratch.briefly(&format!("check {path}"))
    };
    let forgotten = with("[combination.storm]\nweight = 0.9");
    assert!(
        forgotten.words().contains("no combination has a factor on it"),
        "{}",
        forgotten.stdout
    );
    assert!(!forgotten.stdout.contains('∞'), "{}", forgotten.stdout);
    let nothing = with("[combination.storm]\nwind = 1.5\nloads = 1.0");
    assert_eq!(nothing.status, 2, "{}", nothing.stdout);
    assert!(
        nothing
            .stderr
            .contains("combination.storm.loads = 1, but the file has no loads"),
        "{}",
        nothing.stderr
    );
}

#[test]
fn holds_what_loads_weigh_counts_in_the_verdict_and_the_frequency() {
    let scratch = Scratch::with_examples("chain_heavy");
    let with = |weight: f64| {
        let path = flagpole_in(&scratch, "heavy", &|text| {
            let (head, rest) = text.split_once("[survey").unwrap();
            let head = head.replace("value = 30,", "value = 9,");
            format!(
                "{head}loads = [{{ name = \"lamp\", at = \"shaft 5\", weight = {weight} }}]\n[survey{rest}"
            )
        });
        let answer = scratch.dolmen(&format!("--json check {path}"));
        serde_json::from_str::<Value>(&answer.stdout).unwrap()["state"]["loads"].clone()
    };
    let [light, heavy] = [0.001, 2.5].map(with);
    let of = |loads: &Value| loads["combinations"][0]["weight_factor"].as_f64().unwrap();
    // 2.923 of its own weight; a lamp of 2.5 kN at the top of 68 kN of stone leaves half of it
    assert!((of(&light) - 2.923).abs() < 5e-3, "{light}");
    assert!(of(&heavy) < 1.5, "{}", of(&heavy));
    let hz = |loads: &Value| loads["wind"]["frequency_hz"].as_f64().unwrap();
    assert!(hz(&heavy) < 0.8 * hz(&light), "{} {}", hz(&heavy), hz(&light));
    let verdict = &heavy["combinations"][0]["verdict"];
    assert_eq!(verdict, "marginal");
}

#[test]
fn holds_samples_of_a_model_that_takes_no_tilt_do_not_lean_to_their_fall() {
    let scratch = Scratch::with_examples("no-tilt");
    // 1/12 is beyond 1/16.9, at which the lowest bed stands on its edge
    let share = |name: &str, as_surveyed: &str| {
        let file = flagpole_in(&scratch, name, &|text| {
            text.replace("x = \"1/177\", y = \"1/540\"", "x = \"1/12\"")
                .replace("value = 2219.1,", "value = 2219.1, cov = 0.1,")
                .replacen("\nlinks", &format!("\nas_surveyed = \"{as_surveyed}\"\nlinks"), 1)
        });
        let found = json(&scratch, &format!("check {file} --samples 20"), 1);
        found["state"]["sampled"]["unstable"]["estimate"]
            .as_f64()
            .unwrap()
    };
    assert_eq!(share("tilted", "latest"), 1.0);
    assert_eq!(share("plumb", "none"), 0.0);
}
