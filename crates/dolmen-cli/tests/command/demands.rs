// SOURCE     The shipped stacks; KDS 17 10 00 with S = 0.22 g on S4: Fa 1.36, Fv 1.96, Ts 0.57647 s.
// GOAL       The seismic demand of a site is visible from the file to the printed answer, and decides the exit status.
// TOLERANCE  none: printed digits.

use super::verbs::Scratch;
use std::fs;

const KOREA: &str =
    "\n[site]\ncode = \"KDS 17 10 00\"\nzone = \"I\"\nreturn_period_years = 2400\nsoil = \"S4\"\n";

/// The text without line breaks.
fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Appends `text` to the project file of an example.
fn append(scratch: &Scratch, example: &str, text: &str) {
    let project = scratch.path().join(format!("examples/{example}/project.toml"));
    let before = fs::read_to_string(&project).unwrap();
    fs::write(&project, before + text).unwrap();
}

#[test]
fn published_the_korean_case_is_printed_with_every_number_on_the_way() {
    let scratch = Scratch::with_examples("korea");
    append(&scratch, "p10", KOREA);
    let answer = scratch.dolmen("check examples/p10");
    assert_eq!(answer.status, 1, "{}{}", answer.stdout, answer.stderr);
    for said in [
        "KDS 17 10 00:2018, S = 0.22 g, S4",
        "zone factor Z 0.11 g",
        "return period 2400 years",
        "risk factor I 2",
        "effective acceleration S = Z I 0.22 g",
        "amplification by the soil at short periods Fa 1.36",
        "amplification by the soil at 1 s Fv 1.96",
        "beginning of the plateau T0 0.115294 s",
        "end of the plateau Ts 0.576471 s",
        "beginning of the 1/T² branch TL 3 s",
        "S_DS of KDS 41 17 00 0.498667 g",
        "S_D1 of KDS 41 17 00 0.287467 g",
        "plateau 0.748 g",
        "peak of the ground 0.2992 g",
        "vertical / horizontal 0.77 (unverified)",
        "damping 5 %",
        "In the worst direction: below demand.",
        // 0.32402 (1 − 0.77 · 0.2992) = 0.24937, over 0.2992 and over 0.748
        "0.3240",
        "0.2494",
        "0.2992",
        "0.833",
        "0.2126",
        "0.7480",
        "0.333",
        "0.312",
        "what stands on block",
        "demand; above demand at least 1.25, near 1 to 1.25, below less than 1.",
        "the year 2018 of the edition and the vertical",
        "below demand",
    ] {
        assert!(
            answer.words().contains(said.trim_end()),
            "{said}: {}",
            answer.stdout
        );
    }
    let json = scratch.dolmen("check examples/p10 --json");
    assert_eq!(json.status, 1);
    let value: serde_json::Value = serde_json::from_str(&json.stdout).unwrap();
    let demand = &value["state"]["demand"];
    let korea = &demand["parameters"]["korea"];
    let close = |value: &serde_json::Value, known: f64, within: f64| {
        let value = value.as_f64().unwrap();
        assert!((value - known).abs() < within, "{value} {known}");
    };
    close(&korea["amplification_short_periods"], 1.36, 1e-12);
    close(&korea["amplification_one_second"], 1.96, 1e-12);
    close(&korea["branches"]["plateau_s"], 0.57647, 5e-6);
    close(&korea["design_short_period_g"], 0.498667, 0.5e-6);
    assert_eq!(demand["vertical"]["verified"], false);
    let rows = demand["stack"]["rows"].as_array().unwrap();
    let directions: Vec<_> = rows
        .iter()
        .map(|row| row["direction"].as_str().unwrap())
        .collect();
    assert_eq!(directions, ["x", "y", "any"]);
    assert_eq!(demand["stack"]["verdict"], "below demand");
}

#[test]
fn exact_local_mechanisms_of_a_code_stand_beside_the_verdict() {
    let scratch = Scratch::with_examples("local_mechanisms");
    let alone = scratch.dolmen("check examples/p10");
    assert!(alone.words().contains("Local mechanisms by Circolare 7/2019"));
    let verdict = |text: &str| {
        text.lines()
            .find(|line| line.starts_with("VERDICT"))
            .map(str::to_owned)
    };
    append(&scratch, "p10", KOREA);
    let full = scratch.dolmen("check examples/p10");
    // neither text nor exit status mentions it
    assert!(!verdict(&full.stdout).unwrap().contains("Circolare"));
    // blocks 5 to 10: 5.884125 m³ whose centroid is 1.697433 m above the joint, 1.1 m wide
    let (half, height, volume): (f64, f64, f64) = (0.55, 1.697_433, 5.884_125);
    let multiplier = half / height;
    let activation = multiplier * 9.806_65 / 1.35;
    let period_s = 1.68 * std::f64::consts::PI * (0.4 * half / (0.6 * activation)).sqrt();
    let json = scratch.dolmen("check examples/p10 --json");
    let value: serde_json::Value = serde_json::from_str(&json.stdout).unwrap();
    let own = &value["state"]["check"]["stack"]["local_mechanisms"];
    assert_eq!(own["verified"], false);
    let rows = own["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 4);
    for row in rows {
        let near = |key: &str, exact: f64| {
            let found = row[key].as_f64().unwrap();
            assert!(
                (found / exact - 1.0).abs() < 1e-5,
                "{key}: {found} against {exact}"
            );
        };
        near("multiplier", multiplier);
        near("participating_mass_kg", 2600.0 * volume);
        near("participating_ratio", 1.0);
        near("activation_m_s2", activation);
        near("ground_by_force_m_s2", 2.0 * activation);
        near("overturning_m", half);
        near("period_s", period_s);
        assert_eq!(row["parts"][0]["blocks"].as_array().unwrap().len(), 6);
    }
    let asked = &value["state"]["demand"]["local_mechanisms"]["rows"][0];
    let by_force = asked["ratio_by_force"].as_f64().unwrap();
    assert!((by_force - 2.0 * activation / (0.2992 * 9.806_65)).abs() < 1e-4);
    let korean = scratch.dolmen("check examples/p10 --language ko");
    assert!(
        korean
            .words()
            .contains("Circolare 7/2019의 국부 메커니즘은 부지 지진의 1.60배")
    );
    // a sliding block has no check, and no finding either
    let project = scratch.path().join("examples/p10/project.toml");
    let smooth = fs::read_to_string(&project)
        .unwrap()
        .replace("friction = 0.6", "friction = 0.3");
    fs::write(&project, smooth).unwrap();
    let sliding = scratch.dolmen("check examples/p10");
    assert!(sliding.words().contains("Local mechanisms by Circolare 7/2019"));
    assert!(
        !sliding.words().contains("Beside that, local mechanisms"),
        "{}",
        sliding.stdout
    );
}

#[test]
fn holds_weak_shaking_is_above_or_near_demand_with_status_0() {
    let scratch = Scratch::with_examples("weak");
    let eurocode = "\n[site]\ncode = \"EN 1998-1\"\nspectrum_type = 2\nground = \"A\"\nground_acceleration = \"0.05 g\"\n";
    append(&scratch, "p10", eurocode);
    let answer = scratch.dolmen("check examples/p10");
    assert_eq!(answer.status, 0, "{}{}", answer.stdout, answer.stderr);
    for said in [
        "  In the worst direction: above demand.\n",
        "  EN 1998-1:2004, a_g = 0.05 g, type 2, ground A\n",
        "  reference acceleration of the ground a_gR   0.05 g\n",
        "  soil factor S                               1\n",
    ] {
        assert!(answer.stdout.contains(said), "{said}: {}", answer.stdout);
    }
    let project = scratch.path().join("examples/p10/project.toml");
    let text = fs::read_to_string(&project)
        .unwrap()
        .replace("\"0.05 g\"", "\"0.06 g\"");
    fs::write(&project, text).unwrap();
    // the smooth variant: with S_a on all alike 0.3 (1 − 0.45 · 0.06)/(2.5 · 0.06) = 1.95, by modes its top stone slides at 1.06
    let near = scratch.dolmen("check examples/p10");
    assert_eq!(near.status, 0, "{}", near.stderr);
    assert!(
        near.stdout.contains("In the worst direction: near demand."),
        "{}",
        near.stdout
    );
}

#[test]
fn holds_other_structures_have_the_spectrum_at_their_period_and_no_verdict() {
    let scratch = Scratch::with_examples("chain_site");
    append(&scratch, "naju_flagpole", KOREA);
    let before = scratch.dolmen("check examples/heunginjimun_gate");
    let answer = scratch.dolmen("check examples/naju_flagpole");
    for said in [
        "Earthquake demand at the site\n",
        "  KDS 17 10 00:2018, S = 0.22 g, S4\n",
        "* The demand of the site is not compared: the stiffness is not known.",
    ] {
        assert!(answer.stdout.contains(said), "{said}: {}", answer.stdout);
    }
    assert!(!before.stdout.contains("Earthquake demand"), "{}", before.stdout);
}

#[test]
fn holds_a_table_without_the_ground_is_unknown_and_says_what_to_write() {
    let scratch = Scratch::with_examples("table");
    let table =
        "\n[site]\ncode = \"table\"\nfile = \"spectrum.csv\"\nunit = \"g\"\nsource = \"Site study\"\n";
    append(&scratch, "p10", table);
    let csv = scratch.path().join("examples/p10/spectrum.csv");
    fs::write(&csv, "period_s,sa_g\n0.01,0.1\n0.5,0.2\n2,0.05\n").unwrap();
    let answer = scratch.dolmen("check examples/p10");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    for said in [
        "Earthquake demand at the site\n-----------------------------\n  Site study\n",
        "not compared: the table gives no acceleration of the ground: begin it at T = 0, or write peak_ground_acceleration.",
    ] {
        assert!(
            one_line(&answer.stdout).contains(&one_line(said)),
            "{said}: {}",
            answer.stdout
        );
    }
    fs::write(&csv, "period_s,sa_g\n0,0.1\n0.1,0.15\n").unwrap();
    let short = scratch.dolmen("check examples/p10");
    let said = "not compared: a period of 0.2126 s is outside the table, 0 to 0.1 s: extend it";
    assert!(one_line(&short.stdout).contains(said), "{}", short.stdout);
    fs::remove_file(&csv).unwrap();
    let gone = scratch.dolmen("check examples/p10");
    assert_eq!(gone.status, 2, "{}", gone.stdout);
    assert!(
        gone.stderr.contains("site.file = \"spectrum.csv\": there is no"),
        "{}",
        gone.stderr
    );
}

#[test]
fn holds_a_motion_of_the_file_acts_and_what_is_typed_goes_before_it() {
    let scratch = Scratch::with_examples("motion");
    let motions = "\n[motion.design]\nbuilt_in = \"el-centro-1940-ns\"\npeak = \"0.2 g\"\nkeep_first_s = 3\ntaper_s = 0.1\n\n\
                   [motion.own]\nfiles = { y = \"record.csv\" }\nunit = \"g\"\n\n\
                   [motion.wrong]\nfiles = { x = \"record.csv\" }\nunit = \"m/s2\"\n";
    append(&scratch, "piled_blocks", motions);
    let folder = scratch.path().join("examples/piled_blocks");
    // a pulse of 0.338 g
    let rows: String = (0..200)
        .map(|i| {
            let t = 0.01 * f64::from(i);
            format!(
                "{t:.2},{:.6}\n",
                if t < 1.0 {
                    0.338 * (std::f64::consts::TAU * t).sin()
                } else {
                    0.0
                }
            )
        })
        .collect();
    fs::write(folder.join("record.csv"), format!("time_s,acceleration\n{rows}")).unwrap();
    let answer = scratch.dolmen("simulate examples/piled_blocks --motion design");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    for said in [
        "3.00 s",
        "0.3188 0.2000 1.961",
        "tapered by half a cosine, 0.1 s at each end",
    ] {
        assert!(answer.words().contains(said), "{said}: {}", answer.stdout);
    }
    let typed = scratch.dolmen("simulate examples/piled_blocks --motion design --peak 0.1g --keep-first 2");
    for said in ["2.00 s", "0.3188 0.1000 0.9807", "0.1 s at each end"] {
        assert!(typed.words().contains(said), "{said}: {}", typed.stdout);
    }
    let own = scratch.dolmen("simulate examples/piled_blocks --motion own");
    assert_eq!(own.status, 0, "{}", own.stderr);
    assert!(
        own.words().contains("y record.csv 0.3380 0.3380"),
        "{}",
        own.stdout
    );
    let nine = scratch.dolmen("simulate examples/piled_blocks --motion nine");
    assert_eq!(nine.status, 2);
    let said = "there is no motion \"nine\": known are design, own, wrong, el-centro-1940-ns";
    assert!(nine.stderr.contains(said), "{}", nine.stderr);
    fs::remove_file(folder.join("record.csv")).unwrap();
    let gone = scratch.dolmen("simulate examples/piled_blocks --motion own");
    assert_eq!(gone.status, 2);
    assert!(
        gone.stderr.contains("motion.own.files: record.csv"),
        "{}",
        gone.stderr
    );
}

#[test]
fn refuses_a_record_in_the_wrong_unit() {
    let scratch = Scratch::with_examples("wrong_unit");
    append(
        &scratch,
        "piled_blocks",
        "\n[motion.wrong]\nfiles = { x = \"record.csv\" }\nunit = \"g\"\n",
    );
    // a peak of 33.8, wrongly given in g
    let rows = |factor: f64| -> String {
        let each = (0..200).map(|i| {
            format!(
                "{:.2},{:.6}\n",
                0.01 * f64::from(i),
                factor * f64::from(i % 7 - 3) / 3.0
            )
        });
        each.collect()
    };
    let record = scratch.path().join("examples/piled_blocks/record.csv");
    fs::write(&record, format!("time_s,acceleration\n{}", rows(33.8))).unwrap();
    let answer = scratch.dolmen("simulate examples/piled_blocks --motion wrong");
    assert_eq!(answer.status, 2, "{}", answer.stdout);
    let said = "but must be 0.001 to 5 g: is the unit cm/s2 or mg instead of g?";
    assert!(answer.stderr.contains(said), "{}", answer.stderr);
    assert!(
        answer.stderr.contains("motion.wrong.files: record.csv"),
        "{}",
        answer.stderr
    );
}

#[test]
fn exact_a_pagoda_of_factors_prints_blocks_that_make_the_same_pagoda() {
    let scratch = Scratch::new("pagoda");
    let head = "schema = 1\nkind = \"stack\"\nname = \"Made\"\ndensity = 2600\n";
    let project = scratch.path().join("project.toml");
    fs::write(
        &project,
        format!("{head}pagoda = {{ storeys = 3, body_height = 3.0 }}\n"),
    )
    .unwrap();
    let made = scratch.dolmen("check project.toml");
    assert_eq!(made.status, 0, "{}", made.stderr);
    let from = made.stdout.find("blocks = [").unwrap();
    let length = made.stdout[from..].find("\n]\n").unwrap() + 3;
    fs::write(&project, format!("{head}{}", &made.stdout[from..from + length])).unwrap();
    let copied = scratch.dolmen("check project.toml");
    assert_eq!(copied.status, 0, "{}", copied.stderr);
    let limits = |text: &str| -> String {
        let lines = text.lines().filter(|line| line.contains("it begins to move at"));
        lines
            .map(|line| line.split("towards").next().unwrap_or_default().to_owned())
            .collect()
    };
    let first = |text: &str| limits(text).chars().take(40).collect::<String>();
    assert_eq!(first(&made.stdout), first(&copied.stdout));
    assert!(
        made.stdout
            .contains("slenderness_angle 0.3001, body_slenderness 3.740"),
        "{}",
        made.stdout
    );
}

#[test]
fn holds_a_stone_from_a_scan_beside_the_project_is_checked() {
    let scratch = Scratch::new("scan");
    let folder = scratch.path().join("tower");
    fs::create_dir_all(folder.join("scans")).unwrap();
    let text = "schema = 1\nkind = \"stack\"\nname = \"Scan\"\ndensity = 2600\nblocks = [\n  { name = \"stone\", shape = \"mesh\", \
                file = \"scans/stone.obj\", unit = \"mm\" },\n]\n";
    fs::write(folder.join("project.toml"), text).unwrap();
    // 0.4 × 0.4 × 2 m: rocks at 0.2 g
    let obj = "v 0 0 0\nv 400 0 0\nv 400 400 0\nv 0 400 0\nv 0 0 2000\nv 400 0 2000\nv 400 400 2000\nv 0 400 2000\n\
               f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    fs::write(folder.join("scans/stone.obj"), obj).unwrap();
    let answer = scratch.dolmen("check tower");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    assert!(
        answer.stdout.contains("it begins to move at 0.200 g"),
        "{}",
        answer.stdout
    );
    fs::write(folder.join("scans/stone.obj"), obj.replace("f 5 6 7 8\n", "")).unwrap();
    let open = scratch.dolmen("check tower");
    assert_eq!(open.status, 2);
    let said = "blocks[1].file = \"scans/stone.obj\", the mesh of 'stone': the mesh has a hole: the edge from vertex";
    assert!(open.stderr.contains(said), "{}", open.stderr);
}

#[test]
fn exact_figures_of_a_stack_show_what_the_site_demands_and_what_was_run() {
    let scratch = Scratch::with_examples("demand_lines");
    append(&scratch, "three_storey_pagoda", KOREA);
    assert!(
        scratch
            .dolmen("report examples/three_storey_pagoda -o page.html")
            .status
            < 2
    );
    let page = fs::read_to_string(scratch.path().join("page.html")).unwrap();
    let page = page.replace('\u{202f}', " ");
    // tipping and sliding of dry joints: capacity(a_z) / capacity(0) = 1 − a_z / g, KDS a_z = 0.77 a
    let peak = 0.22 * 1.36;
    let with_vertical = peak / (1.0 - 0.77 * peak);
    for words in [
        format!("peak that the site demands: {peak:.3} g"),
        format!("the same with its vertical shaking: {with_vertical:.3} g"),
    ] {
        assert_eq!(page.matches(&words).count(), 3, "{words}");
    }
    let run =
        "simulate examples/three_storey_pagoda --motion el-centro-1940-ns --peak 0.6g --duration 0.1 -o out";
    // cut off after 0.1 s: unfinished
    assert_eq!(scratch.dolmen(run).status, 3);
    let capacity = fs::read_to_string(scratch.path().join("out/capacity.svg")).unwrap();
    assert!(
        capacity
            .replace('\u{202f}', " ")
            .contains("peak of the motion that was run: 0.600 g")
    );
}

#[test]
fn holds_why_a_site_is_not_compared_stands_in_both_languages() {
    let scratch = Scratch::with_examples("table-korean");
    let table =
        "\n[site]\ncode = \"table\"\nfile = \"spectrum.csv\"\nunit = \"g\"\nsource = \"Site study\"\n";
    append(&scratch, "p10", table);
    let csv = scratch.path().join("examples/p10/spectrum.csv");
    fs::write(&csv, "period_s,sa_g\n0,0.1\n0.1,0.15\n").unwrap();
    let short = scratch.dolmen("--language ko check examples/p10");
    let said = "비교하지 못하였다(주기 0.2126 s가 표의 범위 0~0.1 s를 벗어난다. 표를 넓힌다)";
    assert!(one_line(&short.stdout).contains(said), "{}", short.stdout);
}
