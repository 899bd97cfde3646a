// SOURCE     Typical office mistakes that an auditor made by hand: names of surveys, units of files, totals of tables, characters of a
//            Korean keyboard.
// GOAL       None is accepted silently, and the advice leads to the intended input.
// TOLERANCE  Sentences are compared by their parts, in both languages.

use super::verbs::{Answer, Scratch};
use std::fmt::Write as _;
use std::fs;
use std::process::Command;

/// Two stones of a pole, 5.5 m.
const POLE: &str = r#"schema = 1
kind = "chain"
name = "Pole"
evidence = "measured"
units = { length = "m", force = "kN", stiffness = "kN*m/rad" }
links = [
  { name = "low", weight = 30.2, length = 3.1, centroid = 1.48, breadth = 0.72, bed_width = 0.7 },
  { name = "high", weight = 14, length = 2.4, centroid = 1.13, breadth = 0.56, bed_width = 0.54 },
]
joints = [{ stiffness = 3000 }, { stiffness = 900 }]
wind = "sheltered"
damping_ratio = 0.02
"#;

const FRAME: &str = r#"schema = 1
kind = "frame"
name = "Gate"
units = { mass = "t", stiffness = "kN/mm" }
storeys = [{ mass = 180, height = 4.8 }, { mass = 120, height = 4.1 }]
direction.boo.stiffness = [9.0, 6.0]
direction.do.stiffness = [14.0, 9.0]
"#;

const BUILDING: &str = r#"schema = 1
kind = "building"
name = "Hall"
units = { mass = "t", stiffness = "kN/mm" }
floors = [{ mass = 150, sides = [16, 10], height = 4.5, stiffness = { x = 100, y = 100, rotation = "8000 MN*m/rad", centre = [0, 0] } }]
damping.ratio = 0.02
"#;

/// A check of a text, in English and in Korean.
struct Both {
    english: Answer,
    korean: Answer,
}

fn both(scratch: &Scratch, text: &str, verb: &str) -> Both {
    fs::write(scratch.path().join("p.toml"), text).unwrap();
    let run = |language: &str| scratch.briefly(&format!("{verb} p.toml --language {language}"));
    Both {
        english: run("en"),
        korean: run("ko"),
    }
}

/// Checks that the input is refused, and that the output contains all these parts, in either language.
fn refuses(scratch: &Scratch, text: &str, parts: &[&str]) {
    let Both { english, korean } = both(scratch, text, "check");
    let said = format!("{}\n{}", english.stderr, korean.stderr);
    assert_eq!(
        (english.status, korean.status),
        (2, 2),
        "{text}\n{}{said}",
        english.stdout
    );
    for part in parts {
        assert!(said.contains(part), "{part}: {said}");
    }
}

#[test]
fn refuses_names_that_may_be_dates_and_counts_surveys_without_one() {
    let scratch = Scratch::new("undated");
    let with = |name: &str, tilt: &str| {
        format!(
            "{POLE}[watch]\ntilt_limit = \"1/150\"\n[survey.2024-04-02]\ntilt = {{ x = \"1/190\" }}\nfrequencies.x = [1.33]\n\
             [survey.\"{name}\"]\ntilt = {{ x = \"{tilt}\" }}\n"
        )
    };
    for (name, parts) in [
        ("250402", &["2025-04-02", "2002-04-25"][..]),
        ("202504", &["2025-04"]),
        ("'25.4.2", &["2024-06-05"]),
        ("25년 4월 2일", &["2024-06-05"]),
        ("YYYY-MM-DD", &["2024-06-05"]),
    ] {
        refuses(&scratch, &with(name, "1/40"), parts);
    }
    // 1/40 is beyond the limit, and leans the pole more than the model does
    for name in ["1차", "Apr2025"] {
        let Both { english, korean } = both(&scratch, &with(name, "1/40"), "check --full");
        assert_eq!((english.status, korean.status), (1, 1), "{}", english.stdout);
        let words = english.words();
        assert!(
            words.contains(&format!(
                "The tilt that survey {name} measured, 1/40.0 by all directions together, is beyond the limit"
            )),
            "{words}"
        );
        assert!(
            words.contains(&format!("Surveys whose names say no date: {name}.")),
            "{words}"
        );
        assert!(
            words.contains(&format!("not in it: tilt x 1/40 of survey {name}")),
            "{words}"
        );
        assert!(
            korean
                .words()
                .contains(&format!("이름에 날짜가 없는 조사: {name}.")),
            "{}",
            korean.stdout
        );
    }
    // with a smaller one, the last dated survey decides the limit
    let english = both(&scratch, &with("1차", "1/400"), "check --full").english;
    assert!(
        english
            .words()
            .contains("survey 2024-04-02 measured, 1/190 by all directions together, is"),
        "{}",
        english.stdout
    );
}

#[test]
fn holds_positions_of_sensors_are_in_the_unit_of_the_file() {
    let scratch = Scratch::new("positions");
    let millimetres = POLE
        .replace("length = \"m\"", "length = \"mm\"")
        .replace("3.1,", "3100,")
        .replace("1.48,", "1480,")
        .replace("0.72,", "720,")
        .replace("0.7 }", "700 }")
        .replace("2.4,", "2400,")
        .replace("1.13,", "1130,")
        .replace("0.56,", "560,")
        .replace("0.54 }", "540 }");
    fs::write(scratch.path().join("p.toml"), &millimetres).unwrap();
    let planned = scratch.briefly("sensors p.toml --count 2 -o plan");
    assert_eq!(planned.status, 0, "{}", planned.stderr);
    let lines = fs::read_to_string(scratch.path().join("plan/sensors.toml")).unwrap();
    assert!(lines.contains("position = [0, 0, \"5.500 m\"]"), "{lines}");
    let pasted = |text: &str, lines: &str| format!("{text}{}", lines.replace("YYYY-MM-DD", "2025-04-02"));
    let answer = both(&scratch, &pasted(&millimetres, &lines), "check").english;
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let records = |position: &str| {
        format!(
            "[survey.2025-04-02.records]\nfile = \"r.csv\"\nchannels = [{{ column = 1, position = [0, 0, {position}], direction = \"x\" }}]\n"
        )
    };
    // metres in a file of millimetres, and the other way
    refuses(
        &scratch,
        &pasted(
            &millimetres,
            &lines
                .replace(" m\"", "")
                .replace('"', "")
                .replace("file = record.csv", "file = \"record.csv\"")
                .replace("name = s1x", "name = \"s1x\"")
                .replace("name = s2x", "name = \"s2x\"")
                .replace("direction = x", "direction = \"x\""),
        ),
        &["\"5.5 m\"", "units.length"],
    );
    refuses(
        &scratch,
        &format!("{millimetres}{}", records("5.5")),
        &["0.0055 m", "\"5.5 m\"인가?"],
    );
    refuses(&scratch, &format!("{POLE}{}", records("5500")), &["\"5500 mm\""]);
    for right in ["5.5", "0.9", "0", "12"] {
        let answer = both(&scratch, &format!("{POLE}{}", records(right)), "check").english;
        assert_eq!(answer.status, 0, "{right}: {}", answer.stderr);
    }
}

#[test]
fn refuses_rows_that_sum_up_a_table() {
    let scratch = Scratch::new("totals");
    let start = POLE.find("links = [").unwrap();
    let end = POLE.find("joints").unwrap();
    let text = format!(
        "{}links = {{ file = \"links.csv\" }}\njoints = \"unknown\"\n",
        &POLE[..start]
    );
    assert!(end > start);
    let rows = "이름,무게,길이,무게중심\na,30.2,3.1,1.48\nb,14,2.4,1.13\nc,8.1,1.9,0.9\n";
    let with = |last: &str| fs::write(scratch.path().join("links.csv"), format!("{rows}{last}")).unwrap();
    for (last, parts) in [
        ("합계,52.3,7.4,3.51\n", ["A5", "합계"]),
        ("계,52.3,7.4,\n", ["A5", "행을 삭제"]),
        ("Total,52.3,7.4,3.51\n", ["A5", "names a total"]),
        ("전부,52.3,7.4,3.51\n", ["B5", "the sums of those above"]),
    ] {
        with(last);
        refuses(&scratch, &text, &parts);
    }
    with("d,4.4,1.5,0.69\n");
    assert_eq!(both(&scratch, &text, "check").english.status, 0);
}

#[test]
fn refuses_a_unit_of_a_log_that_its_head_contradicts() {
    let scratch = Scratch::new("log-units");
    let rows = (1..=28).fold(
        "Time,경사 X (mm/m),기온 (°C),경사 (N)\n".to_owned(),
        |mut text, day| {
            let _ = writeln!(
                text,
                "2026-02-{day:02} 12:00,{:.3},{}.5,0.1",
                1.0 + f64::from(day) * 1e-3,
                day % 9
            );
            text
        },
    );
    fs::write(scratch.path().join("log.csv"), rows).unwrap();
    let watched = |column: &str, more: &str| {
        let text = format!(
            "schema = 1\nkind = \"survey\"\nname = \"Gate\"\n[watch.log.a]\nfile = \"log.csv\"\ncolumn = \"{column}\"\n{more}\n"
        );
        both(&scratch, &text, "watch")
    };
    let tilt = |unit: &str| format!("kind = \"tilt\"\ndirection = \"x\"\nunit = \"{unit}\"");
    for (column, more, stated) in [
        ("경사 X (mm/m)", tilt("deg"), "\"mm/m\""),
        ("기온 (°C)", tilt("mm/m"), "\"°C\""),
        ("경사 X (mm/m)", "kind = \"temperature\"".to_owned(), "\"mm/m\""),
    ] {
        let Both { english, korean } = watched(column, &more);
        assert_eq!((english.status, korean.status), (2, 2), "{}", english.stdout);
        assert!(
            english.stderr.contains(stated) && korean.stderr.contains("열 이름을 고친다"),
            "{}{}",
            english.stderr,
            korean.stderr
        );
    }
    for (column, unit) in [("경사 X (mm/m)", "mm/m"), ("경사 (N)", "mm/m")] {
        let english = watched(column, &tilt(unit)).english;
        assert_eq!(english.status, 0, "{column}: {}", english.stderr);
    }
}

#[test]
fn refuses_the_template_of_a_record_until_it_is_filled_in() {
    let scratch = Scratch::new("template");
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    let header = "{'descr': '<f8', 'fortran_order': False, 'shape': (4000, 1), }\n";
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.extend((0..4000_u32).flat_map(|i| (f64::from(i * i % 97) * 0.01).to_le_bytes()));
    fs::write(scratch.path().join("rec.npy"), bytes).unwrap();
    for language in ["en", "ko"] {
        let said = scratch
            .briefly(&format!("identify rec.npy --language {language}"))
            .stderr;
        let template = said[said.find("schema = 1").unwrap()..].to_owned();
        fs::write(scratch.path().join("p.toml"), &template).unwrap();
        let answer = scratch.briefly("identify p.toml");
        assert_eq!(answer.status, 2, "{template}{}", answer.stdout);
        assert!(answer.stderr.contains("sampling_rate"), "{}", answer.stderr);
        let rated = template.replace("? Hz", "200 Hz");
        fs::write(scratch.path().join("p.toml"), &rated).unwrap();
        let answer = scratch.briefly("check p.toml");
        assert!(
            answer.status == 2 && answer.stderr.contains("YYYY-MM-DD"),
            "{}",
            answer.stderr
        );
        fs::write(
            scratch.path().join("p.toml"),
            rated.replace("YYYY-MM-DD", "2025-04-02"),
        )
        .unwrap();
        assert_eq!(scratch.briefly("check p.toml").status, 0);
    }
}

#[test]
fn holds_a_damping_ratio_from_a_survey_calibrates_no_model() {
    let scratch = Scratch::new("calibrated");
    fs::write(scratch.path().join("r.csv"), "t,x\n0,1\n0.01,2\n").unwrap();
    let survey = "[survey.2025-04-02.records]\nfile = \"r.csv\"\nchannels = [{ column = \"x\", position = [0, 0, 5.5], direction = \"x\" }]\n";
    let identified = "{ value = 0.02, source = \"identified\", survey = \"2025-04-02\" }";
    let damped = POLE.replace("damping_ratio = 0.02", &format!("damping_ratio = {identified}"));
    let english = both(&scratch, &format!("{damped}{survey}"), "check").english;
    assert!(
        english.status == 0 && !english.words().contains("calibrated"),
        "{}{}",
        english.stdout,
        english.stderr
    );
    let stiff = POLE.replace(
        "{ stiffness = 900 }",
        &format!("{{ stiffness = {} }}", identified.replace("0.02", "900")),
    );
    let english = both(&scratch, &format!("{stiff}{survey}"), "check").english;
    assert!(
        english.words().contains("calibrated to 2025-04-02"),
        "{}{}",
        english.stdout,
        english.stderr
    );
}

#[test]
fn refuses_slips_of_signs_with_the_first_fault_first() {
    let scratch = Scratch::new("signs");
    let with = |old: &str, new: &str| {
        assert!(POLE.contains(old), "{old}");
        POLE.replace(old, new)
    };
    for (old, new, parts) in [
        (
            "3.1, centroid",
            "3.1 centroid",
            &[
                "a comma is missing before centroid",
                "centroid 앞에 ,를 쓴다",
                "p.toml:7:",
            ][..],
        ),
        (
            "]\njoints",
            "\njoints",
            &[
                "the list links that begins here is not closed",
                "write ] before line 10",
                "p.toml:6:9",
            ],
        ),
        (
            "0.7 },",
            "0.7,\n",
            &["the table of links that begins here is not closed", "p.toml:7:3"],
        ),
        ("30.2", "３０.２", &["write 30.2", "전각 문자"]),
        ("3.1,", "3.1，", &["write 3.1,"]),
        ("damping_ratio =", "damping_ratio ＝", &["write ="]),
        (
            "damping_ratio = ",
            "damping_ratio =　",
            &["full width", "보통 공백"],
        ),
        ("damping_ratio =", "damping_ratio\u{a0}=", &["does not break"]),
        (
            "weight = 30.2",
            "무게 = 30.2",
            &["is \"무게\" weight?", "weight인가?"],
        ),
        ("[{ stiffness", "[{ 강성", &["is \"강성\" stiffness?"]),
        ("{ length = \"m\"", "{ 길이 = \"m\"", &["is \"길이\" length?"]),
        (
            "damping_ratio = 0.02\n",
            "[survey.2025년 4월]\n",
            &["[survey.\"2025년 4월\"]"],
        ),
        (
            "damping_ratio = 0.02\n",
            "[combination.여름]\nweight = 1\n",
            &["[combination.\"여름\"]"],
        ),
        (
            "damping_ratio = 0.02\n",
            "[survey.2025.records]\nfile = \"데이터\\1차 계측.csv\"\n",
            &["\"데이터/1차 계측.csv\"", "경로는 /로 쓴다"],
        ),
        (
            "damping_ratio = 0.02\n",
            "[survey.2025.records]\nfile = \"C:\\Users\\r1.csv\"\n",
            &["\"C:/Users/r1.csv\"", "유니코드 번호"],
        ),
        ("weight = 30.2", "weight = \"3 tonf\"", &["did you mean \"tf\"?"]),
        ("weight = 30.2", "weight = \"3 ton\"", &["질량 1000 kg이면 \"t\""]),
        ("weight = 30.2", "weight = \"3 톤\"", &["or \"tf\""]),
        ("stiffness = 3000", "stiffness = \"3 kN.m/rad\"", &["\"kN*m\""]),
        (
            "force = \"kN\"",
            "force = \"N\"",
            &["units.force = \"N\"", "did you mean kN?"],
        ),
    ] {
        let text = with(old, new);
        refuses(&scratch, &text, parts);
        let errors = both(&scratch, &text, "check")
            .english
            .stderr
            .matches("error:")
            .count();
        assert!(errors <= 2, "{new}: {errors} errors");
    }
}

#[test]
fn holds_a_tilt_as_people_and_this_program_write_it() {
    let scratch = Scratch::new("tilts");
    let tilted = |tilt: &str| {
        let text = format!("{POLE}[survey.2025-04-02]\ntilt = {{ x = \"{tilt}\" }}\n");
        let found = both(&scratch, &text, "check").english;
        assert_eq!(found.status, 0, "{tilt}: {}", found.stderr);
        fs::write(scratch.path().join("p.toml"), text).unwrap();
        let json: serde_json::Value =
            serde_json::from_str(&scratch.briefly("check p.toml --json").stdout).unwrap();
        json.pointer("/state/tilts/0/tilt")
            .and_then(serde_json::Value::as_f64)
            .unwrap()
    };
    assert_eq!(tilted("-1/190"), -1.0 / 190.0);
    assert_eq!(tilted("−1/190"), -1.0 / 190.0); // the minus sign of our own tables
    assert_eq!(tilted("1:190"), 1.0 / 190.0);
}

#[test]
fn refuses_directions_and_ratios_that_mean_another() {
    let scratch = Scratch::new("directions");
    let survey = |frequencies: &str| format!("[survey.2025-04-02]\nfrequencies = {{ {frequencies} }}\n");
    for (text, parts) in [
        (format!("{BUILDING}{}", survey("X = [3.9]")), &["did you mean \"x\"?"][..]),
        (format!("{BUILDING}{}", survey("\"비틀림\" = [3.9]")), &["\"torsion\"을 쓰려던"]),
        (format!("{FRAME}{}", survey("bo = [0.8]")), &["did you mean \"boo\"?", "있는 방향: boo, do"]),
        (format!("{FRAME}{}", survey("DO = [0.8]")), &["did you mean \"do\"?"]),
        (BUILDING.replace("damping.ratio = 0.02", "damping_ratio = 0.02"), &["damping = { ratio = 0.02 }"]),
        (BUILDING.replace("damping.ratio = 0.02", "damping = 0.05"), &["damping = { ratio = 0.05 }"]),
        (
            "schema = 1\nkind = \"stack\"\nname = \"S\"\ndensity = \"2.65 g/cm3\"\nblocks = [{ name = \"a\", width = 1, height = 1 }]\n".to_owned(),
            &["\"1 t/m3\""],
        ),
        (
            "schema = 1\nkind = \"stack\"\nname = \"S\"\ndensity = 2650\njoint = { friction = 31 }\nblocks = [{ name = \"a\", width = 1, height = 1 }]\n".to_owned(),
            &["write 0.601", "마찰각 31°인가?"],
        ),
    ] {
        refuses(&scratch, &text, parts);
    }
    let answer = both(&scratch, &format!("{FRAME}{}", survey("boo = [0.8]")), "check").english;
    assert_ne!(answer.status, 2, "{}", answer.stderr);
}

#[test]
fn refuses_a_folder_whose_project_has_another_name() {
    let scratch = Scratch::new("other-names");
    for name in ["project.toml.txt", "Project.toml", "당간.toml"] {
        let folder = scratch.path().join(name.replace('.', "-"));
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join(name), POLE).unwrap();
        let answer = scratch.briefly(&format!("check {}", name.replace('.', "-")));
        assert!(
            answer.status == 2 && answer.stderr.contains(&format!("but \"{name}\"")),
            "{}",
            answer.stderr
        );
    }
    let wide: Vec<u8> = [0xff, 0xfe]
        .into_iter()
        .chain(POLE.bytes().flat_map(|byte| [byte, 0]))
        .collect();
    fs::write(scratch.path().join("wide.toml"), wide).unwrap();
    let answer = scratch.briefly("check wide.toml --language ko");
    assert!(
        answer.status == 2 && answer.stderr.contains("UTF-16"),
        "{}",
        answer.stderr
    );
    let records = "[survey.2025-04-02.records]\nfile = 'data\\r.csv'\n";
    fs::write(scratch.path().join("p.toml"), format!("{POLE}{records}")).unwrap();
    let answer = scratch.briefly("identify p.toml");
    assert!(answer.stderr.contains("\"data/r.csv\""), "{}", answer.stderr);
}

#[test]
fn refuses_a_variant_of_a_check_and_a_file_as_the_name_of_a_motion() {
    let scratch = Scratch::new("variants-of-checks");
    fs::write(scratch.path().join("p.toml"), POLE).unwrap();
    let answer = scratch.briefly("check p.toml --variant soft");
    assert!(
        answer.status == 2 && answer.stderr.contains("--full"),
        "{}",
        answer.stderr
    );
    let answer = scratch.briefly("simulate p.toml --motion 기록.csv --language ko");
    assert!(
        answer.stderr.contains("[motion.\"기록.csv\"]"),
        "{}",
        answer.stderr
    );
}

#[test]
fn holds_wind_may_be_in_kilometres_an_hour() {
    let scratch = Scratch::new("wind-kmh");
    let of = |speed: &str| {
        let wind = format!(
            "wind = {{ code = \"EN 1991-1-4\", speed = \"{speed}\", means = \"10 min\", terrain = \"II\", force_coefficient = 2.0 }}"
        );
        let answer = both(&scratch, &POLE.replace("wind = \"sheltered\"", &wind), "check").english;
        assert_ne!(answer.status, 2, "{}", answer.stderr);
        answer.stdout
    };
    assert_eq!(of("90 km/h"), of("25 m/s"));
}

#[test]
fn holds_a_table_of_pagodas_as_korean_excel_saves_it() {
    let scratch = Scratch::new("korean-ranks");
    let rank = |text: &str| {
        fs::write(scratch.path().join("t.csv"), text).unwrap();
        let output = Command::new(env!("CARGO_BIN_EXE_dolmen"))
            .args(["rank", "t.csv", "--json"])
            .current_dir(scratch.path())
            .output()
            .unwrap();
        Answer::of(&output)
    };
    let english = rank(
        "name,storeys,body_height_m,body_slenderness,taper_deg,body_base_height_ratio\na,5,4.4,3.9,8.0,3.1\nb,7,5.1,4.3,7,3.4\n",
    );
    let korean = rank(
        "이름;층수;탑신 높이 (m);몸돌세장비;체감각(도);body_base_height_ratio\na;5;4,4;3,9;8,0;3,1\nb;7;5,1;4,3;7;3,4\n",
    );
    assert_eq!(
        (english.status, korean.status),
        (0, 0),
        "{}{}",
        english.stderr,
        korean.stderr
    );
    assert_eq!(english.stdout, korean.stdout);
    let slip = rank(
        "name,storeys,body_height_m,body_slenderness,taper_deg,body_base_height_ratio\na,5,4400,3.9,8.0,3.1\n",
    );
    assert!(
        slip.status == 2 && slip.stderr.contains("is it in mm?"),
        "{}",
        slip.stderr
    );
}

#[test]
fn refuses_a_work_of_an_unknown_kind_once() {
    let scratch = Scratch::new("works-kind");
    let text = "schema = 1\nkind = \"survey\"\nname = \"Pole\"\n\
        watch.works = [{ date = \"2024-06-01\", kind = \"repiar\", what = \"joints\" }]\n\
        [survey.2024-01-01]\nfrequencies.x = [2.0]\n";
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let answer = scratch.briefly("watch project.toml");
    assert_eq!(answer.status, 2, "{}", answer.stdout);
    assert!(
        answer.stderr.contains("did you mean \"repair\"?") && !answer.stderr.contains("is missing"),
        "{}",
        answer.stderr
    );
}

#[test]
fn refuses_a_built_in_motion_as_a_file_and_says_how_it_is_given() {
    let scratch = Scratch::new("built-in-as-file");
    for words in [
        "motion el-centro-1940-ns",
        "motion el-centro-1940-ns --language ko",
    ] {
        let answer = scratch.dolmen(words);
        assert_eq!(answer.status, 2, "{}", answer.stdout);
        assert!(
            answer.stderr.contains("--motion el-centro-1940-ns"),
            "{}",
            answer.stderr
        );
    }
    assert_eq!(scratch.dolmen("motion --motion el-centro-1940-ns").status, 0);
}

/// Two sines in noise with one sample of a logger without a reading.
#[test]
fn refuses_a_record_whose_modes_a_sample_of_9999_hides_and_names_it() {
    let scratch = Scratch::new("spike-hides-modes");
    let mut random = dolmen::numeric::Random::new(20261129, 0);
    let mut text = "low,high\n".to_owned();
    for sample in 0..12_000 {
        let t = f64::from(sample) / 100.0;
        let moved = (7.1 * t).sin() + 0.5 * (19.3 * t).sin();
        let high = match sample {
            7001 => -9999.0,
            _ => moved + 0.3 * random.normal(),
        };
        writeln!(text, "{:.4},{high:.4}", 0.5 * moved + 0.3 * random.normal()).unwrap();
    }
    fs::write(scratch.path().join("r.csv"), text).unwrap();
    let channels = "channels = [{ column = \"low\", position = [0, 0, 4.8], direction = \"x\" }, { column = \"high\", position = [0, 0, 8.9], direction = \"x\" }]";
    let frame = "schema = 1\nkind = \"frame\"\nname = \"Gate\"\nunits = { mass = \"t\", stiffness = \"kN/mm\" }\nstoreys = [{ mass = 180, height = 4.8 }, { mass = 120, height = 4.1 }]\ndirection.x.stiffness = \"unknown\"\n";
    let file = format!(
        "{frame}[survey.2026-05-01.records]\nfile = \"r.csv\"\nunit = \"gal\"\nsampling_rate = 100\n{channels}\n"
    );
    fs::write(scratch.path().join("p.toml"), file).unwrap();
    let answer = scratch.dolmen("identify p.toml");
    assert_eq!(answer.status, 2, "{}", answer.stdout);
    for said in ["channel \"high\"", "70.01 s", "9999"] {
        assert!(answer.stderr.contains(said), "{said}: {}", answer.stderr);
    }
}
