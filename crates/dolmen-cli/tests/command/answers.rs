// SOURCE     The shipped examples; Choi (2021); Park & Min (2010).
// GOAL       Printed values are those of the library, to the digit, and the exit status follows the verdict.
// TOLERANCE  none: printed digits.

use super::verbs::Scratch;
use std::fs;

#[test]
fn published_numbers_of_naju_are_printed_to_the_last_digit() {
    let scratch = Scratch::with_examples("naju");
    let answer = scratch.dolmen("check examples/naju_flagpole");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let words: Vec<&str> = answer.stdout.split_whitespace().collect();
    let printed = |row: &[&str]| words.windows(row.len()).any(|window| window == row);
    // joint, k_cr (Table 1), P·H and its ratio (Table 2), exact limit and its ratio, G
    for row in [
        ["1", "128.64", "739.69", "5.75", "253.83", "1.97", "171.89"],
        ["2", "43.24", "209.85", "4.85", "81.94", "1.89", "54.97"],
        ["3", "11.73", "64.56", "5.51", "26.97", "2.30", "17.42"],
        ["4", "5.69", "21.65", "3.80", "9.56", "1.68", "7.62"],
        ["5", "1.93", "4.01", "2.08", "1.93", "1.00", "1.93"],
    ] {
        assert!(printed(&row), "{row:?} is missing in\n{}", answer.stdout);
    }
    for factor in ["4.736", "1.027", "2.477", "292.0"] {
        assert!(printed(&[factor]), "{factor} is missing");
    }
    // Table 3
    assert!(printed(&["127.59", "44.30", "↑", "10.67", "5.69", "1.93"]));
    assert!(printed(&["128.26", "43.63", "↑", "11.34", "6.08", "↑", "1.55"]));
    assert!(
        answer
            .stdout
            .contains("published critical stiffness k_cr is unsafe")
    );
}

#[test]
fn holds_a_pole_with_the_published_stiffness_falls_and_ends_with_status_1() {
    let scratch = Scratch::with_examples("falls");
    let project = scratch.path().join("examples/naju_flagpole/project.toml");
    let mut text = fs::read_to_string(&project).unwrap();
    text += "\n[variant.published]\njoints = [{ stiffness = 128.64 }, { stiffness = 43.24 }, { stiffness = 11.73 }, \
             { stiffness = 5.69 }, { stiffness = 1.93 }]\n";
    fs::write(&project, text).unwrap();
    let answer = scratch.dolmen("check examples/naju_flagpole");
    assert_eq!(answer.status, 1, "{}", answer.stdout);
    let said = "Variant “published”: Own weight: unstable";
    assert!(answer.stdout.contains(said), "{}", answer.stdout);
    let json = scratch.dolmen("check examples/naju_flagpole --json");
    assert_eq!(json.status, 1);
    let value: serde_json::Value = serde_json::from_str(&json.stdout).unwrap();
    let variants = value["variants"].as_array().unwrap();
    let published = variants.iter().find(|v| v["name"] == "published").unwrap();
    assert_eq!(published["state"]["verdict"], "unstable");
    assert!(
        published["state"]["check"]["chain"]["stability"]["load_factor"]
            .as_f64()
            .unwrap()
            < 0.22
    );
}

#[test]
fn holds_the_same_seed_gives_the_same_text_and_another_seed_another() {
    let scratch = Scratch::with_examples("seed");
    let run = |seed: u32| {
        scratch
            .dolmen(&format!(
                "check examples/naju_flagpole --samples 500 --seed {seed}"
            ))
            .stdout
    };
    assert_eq!(run(7), run(7));
    assert_ne!(run(7), run(8));
}

#[test]
fn holds_the_report_is_one_page_in_either_language_and_the_same_twice() {
    let scratch = Scratch::with_examples("report");
    for language in ["en", "ko"] {
        let run = |name: &str| {
            let answer = scratch.dolmen(&format!(
                "report examples/naju_flagpole --language {language} -o {name}"
            ));
            assert_eq!(answer.status, 0, "{}", answer.stderr);
            fs::read_to_string(scratch.path().join(name)).unwrap()
        };
        let page = run("one.html");
        assert_eq!(page, run("two.html"));
        let outside = page.replace("http://www.w3.org/", "");
        assert!(
            !outside.contains("http://") && !outside.contains("https://") && !outside.contains("<script")
        );
        assert!(page.contains("석당간") && page.contains("4.736"), "{language}");
    }
}

/// The page of a simulated variant lists the variant's own inputs, marks assumed ones, and names them in a finding.
#[test]
fn holds_the_report_of_a_variant_says_what_it_assumes() {
    let scratch = Scratch::with_examples("variant_report");
    let answer = scratch.dolmen("report examples/heunginjimun_gate --motion el-centro -o gate.html");
    assert!(answer.status < 2, "{}", answer.stderr);
    let page = fs::read_to_string(scratch.path().join("gate.html")).unwrap();
    for said in [
        "Inputs that the variant “Soft lower storey” changes",
        "rests on what is assumed, not measured: direction weak: damping ratio 0.02 and direction weak: friction coefficient 0.1",
        "Dashpots: 2.00 % of critical in the first mode while every joint sticks; the same ones are 2.87 % while every joint slips",
    ] {
        let narrow = page.replace('\u{202f}', " ");
        assert!(narrow.contains(said), "{said}");
    }
}

#[test]
fn holds_one_bad_project_of_several_is_named_and_the_others_are_reported_on() {
    let scratch = Scratch::with_examples("one_bad");
    fs::write(
        scratch.path().join("bad.toml"),
        "schema = 1\nkind = \"chain\"\nlinks = 3\n",
    )
    .unwrap();
    let answer = scratch
        .dolmen("report examples/naju_flagpole bad.toml examples/twisting_floor --samples 0 -o all.html");
    assert_eq!(answer.status, 2, "{}", answer.stderr);
    assert!(
        answer.stderr.contains("bad.toml") && answer.stderr.contains("1 of 3 projects left out"),
        "{}",
        answer.stderr
    );
    let page = fs::read_to_string(scratch.path().join("all.html")).unwrap();
    assert!(page.contains("Not reported on: <code>bad.toml</code>: ") && page.contains("id=\"report-2\""));
    let alone = scratch.dolmen("report bad.toml -o bad.html");
    assert_eq!(alone.status, 2);
    assert!(!scratch.path().join("bad.html").exists());
    // a floor shaken along y alone does not move along x
    let page = page.replace('\u{202f}', " ");
    assert!(!page.contains("×10⁻¹"), "rounding is shown as a number");
}

#[test]
fn agrees_validation_page_is_what_the_command_prints() {
    let printed = Scratch::new("validate").dolmen("validate");
    assert_eq!(printed.status, 0, "{}", printed.stderr);
    let kept = fs::read_to_string(super::verbs::root().join("VALIDATION.md")).unwrap();
    assert!(
        printed.stdout == kept,
        "VALIDATION.md is out of date: `dolmen validate > VALIDATION.md`"
    );
}

/// A survey project with one CSV record.
fn survey(scratch: &Scratch, csv: &str, more: &str) -> super::verbs::Answer {
    let folder = scratch.path().join("tower");
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("record.csv"), csv).unwrap();
    let project = format!(
        "schema = 1\nkind = \"survey\"\nname = {{ en = \"Tower\" }}\n\n[survey.first.records]\nfile = \"record.csv\"\n{more}\n"
    );
    fs::write(folder.join("project.toml"), project).unwrap();
    scratch.dolmen("identify tower")
}

/// Two channels of a tower at 50 Hz; `change` rewrites a line.
fn swinging(change: impl Fn(usize, String) -> String) -> String {
    let mut csv = String::from("t,north,east\n");
    for i in 0..30_000 {
        let t = i as f64 / 50.0;
        let noise = (i as f64 * 12.9898).sin() * 43758.547;
        let a = (9.0 * t).sin() + 0.3 * (noise - noise.floor());
        let b = (14.0 * t).cos() + 0.3 * (noise * 7.0 - (noise * 7.0).floor());
        csv += &change(i, format!("{t:.2},{a:.5},{b:.5}\n"));
    }
    csv
}

#[test]
fn refuses_bad_records_with_the_file_the_place_and_the_remedy() {
    let scratch = Scratch::new("records");
    let ok = survey(&scratch, &swinging(|_, line| line), "");
    assert_eq!(ok.status, 0, "{}", ok.stderr);
    let cases: [(&str, String, &str, &[&str]); 8] = [
        ("empty file", String::new(), "", &["record.csv", "empty"]),
        (
            "text in a number column",
            swinging(|i, line| {
                if i == 10 {
                    line.replace(',', ",oops,").replacen(",oops", "", 1)
                } else {
                    line
                }
            }),
            "",
            &["record.csv", "oops"],
        ),
        (
            "NaN",
            swinging(|i, line| if i == 10 { "0.20,NaN,0.1\n".into() } else { line }),
            "",
            &["record.csv", "north"],
        ),
        (
            "lost samples, where the project refuses them",
            swinging(|i, line| if i == 40 { String::new() } else { line }),
            "lost_samples = \"refuse\"",
            &["record.csv", "time stamp"],
        ),
        (
            "uneven time stamps",
            swinging(|i, line| {
                if i == 40 {
                    line.replacen("0.80", "0.81", 1)
                } else {
                    line
                }
            }),
            "",
            &["record.csv", "time stamp"],
        ),
        (
            "dead channel",
            swinging(|_, line| format!("{},0\n", line.rsplit_once(',').unwrap().0)),
            "",
            &["east", "dead"],
        ),
        (
            "missing column",
            swinging(|_, line| line),
            "channels = [{ column = \"nord\" }]",
            &["record.csv", "nord", "north"],
        ),
        (
            "more modes than the order allows",
            swinging(|_, line| line),
            "modal = { order_most = 8, modes_wanted = 9 }",
            &["9", "4"],
        ),
    ];
    for (what, csv, more, said) in cases {
        let answer = survey(&scratch, &csv, more);
        assert_eq!(answer.status, 2, "{what}: {}{}", answer.stdout, answer.stderr);
        for word in said {
            assert!(
                answer.stderr.contains(word),
                "{what}: \"{word}\" is missing in: {}",
                answer.stderr
            );
        }
        assert!(!answer.stderr.contains("panicked"), "{what}: {}", answer.stderr);
    }
}

/// Two gaps: 40 samples within the first minute, and one sample four minutes later, which is filled in. The longest span begins after the first.
#[test]
fn holds_lost_samples_leave_the_longest_whole_span_and_are_said() {
    let scratch = Scratch::new("lost-samples");
    let csv = swinging(|i, line| match i {
        3000..3040 | 15_000 => String::new(),
        _ => line,
    });
    let answer = survey(&scratch, &csv, "");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let text: Vec<&str> = answer.stdout.split_whitespace().collect();
    let text = text.join(" ");
    for said in [
        "samples are lost, 0.8 s (after 59.98 s): only the longest whole span is used, 60.8 s to 599.98 s, 539.18 s of 599.98 s. [lost-samples]",
        "ost samples filled in by linear prediction: 1 (0.0037 %), 0.02 s (after 299.98 s)",
    ] {
        assert!(text.contains(said), "{said} is missing in {text}");
    }
    for (language, said) in [
        ("en", "only the longest whole span is used"),
        ("ko", "누락이 없는 가장 긴 구간"),
    ] {
        let made = scratch.dolmen(&format!("report tower --language {language} -o {language}.html"));
        assert_eq!(made.status, 0, "{}", made.stderr);
        let page = fs::read_to_string(scratch.path().join(format!("{language}.html"))).unwrap();
        assert!(page.contains(said), "{language}");
    }
}

#[test]
fn holds_a_channel_left_out_may_hold_anything() {
    let scratch = Scratch::new("left_out");
    let csv = swinging(|i, line| format!("{},{}\n", line.trim_end(), if i == 10 { "NaN" } else { "0.5" }));
    let csv = csv.replacen("east", "east,loose", 1);
    let channels = |leave_out: &str| {
        let sound = ["north", "east"]
            .map(|c| format!("{{ column = \"{c}\"{leave_out} }}"))
            .join(", ");
        format!("channels = [{sound}, {{ column = \"loose\", leave_out = true }}]")
    };
    let answer = survey(&scratch, &csv, &channels(""));
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    assert!(
        answer.stdout.contains("loose"),
        "what was left out is said: {}",
        answer.stdout
    );
    let answer = survey(&scratch, &csv, &channels(", leave_out = true"));
    assert_eq!(answer.status, 2);
    assert!(
        answer.stderr.contains("all 3 channels were to be left out"),
        "{}",
        answer.stderr
    );
}

#[test]
fn refuses_a_survey_that_is_not_there_and_a_folder_without_a_project() {
    let scratch = Scratch::with_examples("wrong");
    let answer = scratch.dolmen("identify examples/palisaden --survey spring");
    assert_eq!(answer.status, 2);
    assert!(
        answer
            .stderr
            .contains("no survey \"spring\": the file has ambient"),
        "{}",
        answer.stderr
    );
    let answer = scratch.dolmen("check examples");
    assert_eq!(answer.status, 2);
    assert!(
        answer.stderr.contains("holds no project.toml"),
        "{}",
        answer.stderr
    );
}

#[test]
fn holds_a_record_of_a_frame_gives_back_the_stiffness_it_was_made_with() {
    use dolmen::modal::{MadeMode, MadeRecord};
    use dolmen::structure::{Convention, Frame, Storey};
    let storey = |mass_kg, height_m, axial_n| Storey {
        mass_kg,
        height_m,
        axial_n,
    };
    let storeys = vec![storey(290e3, 5.84, 5919e3), storey(314e3, 7.69, 3077e3)];
    let truth = [185.18e6, 16.85e6]; // the other pair of stiffness for its frequencies: 32.65 and 96.14 MN/m
    let modes = Frame::new(storeys, Convention::Drift)
        .unwrap()
        .natural_modes(&truth)
        .unwrap();
    let made = MadeRecord {
        modes: modes
            .iter()
            .map(|mode| MadeMode {
                frequency_hz: mode.frequency_hz,
                damping_ratio: 0.02,
                shape: mode.displacement.clone(),
            })
            .collect(),
        seed: 1,
        ..Default::default()
    };
    let record = made.make().unwrap();
    let mut csv = String::from("low,high\n");
    for (low, high) in record.samples(0).iter().zip(record.samples(1)) {
        csv += &format!("{low:e},{high:e}\n");
    }
    let scratch = Scratch::new("inverse");
    fs::write(scratch.path().join("record.csv"), csv).unwrap();
    let project = format!(
        "schema = 1\nkind = \"frame\"\nname = {{ en = \"Gate\" }}\nunits = {{ force = \"kN\", mass = \"t\" }}\naxial = \"storey\"\n\
         storeys = [{{ mass = 290, height = 5.84, axial_force = 5919 }}, {{ mass = 314, height = 7.69, axial_force = 3077 }}]\n\
         [survey.s.records]\nfile = \"record.csv\"\nsampling_rate = \"{} Hz\"\nchannels = [\n\
         {{ column = \"low\", position = [0, 0, 5.84], direction = \"x\" }},\n\
         {{ column = \"high\", position = [0, 0, 13.53], direction = \"x\" }},\n]\n",
        record.sampling_rate_hz()
    );
    fs::write(scratch.path().join("project.toml"), project).unwrap();
    let answer = scratch.dolmen("identify project.toml --json");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let value: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    let drift = &value["surveys"][0]["stiffness"][0];
    assert_eq!(
        (drift["convention"].as_str(), drift["choice"].as_str()),
        (Some("drift"), Some("one")),
        "{drift:#}"
    );
    let solution = &drift["solutions"][0];
    for i in 0..2 {
        let (k, sd) = (
            solution["stiffness"][i].as_f64().unwrap(),
            solution["stiffness_sd"][i].as_f64().unwrap(),
        );
        assert!(
            (k - truth[i]).abs() < 3.0 * sd && sd < 0.2 * truth[i],
            "k{} = {k} ± {sd}, made with {}",
            i + 1,
            truth[i]
        );
    }
}
