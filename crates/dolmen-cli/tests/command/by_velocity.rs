// SOURCE     Kim, Koo & Hong (2018), eqs 1 to 3 and Fig. 17; Housner (1963); the stack P10 on KDS 17 10 00, soil S4.
// GOAL       The check prints the demand of the spectral velocity on the part that lifts first, beside the published forms, and the
//            frequencies of pagodas of other heights.
// PARAMETERS plateau 0.748 g to T_s 0.576471 s, as the section of the site prints them.
// TOLERANCE  1e-5: the digits printed; ratios of the forms 1e-12; a law of similar pagodas 1e-9.

use super::verbs::Scratch;
use serde_json::Value;
use std::f64::consts::TAU;
use std::fs;

/// The first value of a key, wherever it is.
fn first<'a>(of: &'a Value, key: &str) -> Option<&'a Value> {
    match of {
        Value::Object(map) => map
            .get(key)
            .filter(|value| !value.is_null())
            .or_else(|| map.values().find_map(|value| first(value, key))),
        Value::Array(list) => list.iter().find_map(|value| first(value, key)),
        _ => None,
    }
}

#[test]
fn exact_the_spectral_velocity_of_the_site_against_the_part_that_lifts_first() {
    let scratch = Scratch::with_examples("by_velocity");
    let path = scratch.path().join("examples/p10/project.toml");
    let site = "\n[site]\ncode = \"KDS 17 10 00\"\nzone = \"I\"\nreturn_period_years = 2400\nsoil = \"S4\"\n";
    fs::write(&path, fs::read_to_string(&path).unwrap() + site).unwrap();
    let answer = scratch.dolmen("--json check examples/p10");
    let whole: Value = serde_json::from_str(&answer.stdout).unwrap();
    let found = first(&whole, "by_velocity").unwrap();
    let number = |key: &str| found[key].as_f64().unwrap_or_else(|| panic!("{key}: {found}"));
    let s_v = 0.748 * 9.80665 * 0.576471 / TAU;
    assert!(
        (number("spectral_velocity_m_s") / s_v - 1.0).abs() < 1e-5,
        "{found}"
    );
    let critical = number("critical_slenderness_rad");
    let p = number("frequency_parameter_rad_s");
    assert!((critical * 9.80665 / (number("spectral_velocity_m_s") * p) - 1.0).abs() < 1e-12);
    assert!((number("published_2a_m_s2") / critical / 9.80665 - 1.0).abs() < 1e-12);
    let of_three = number("spectral_velocity_m_s") / (9.80665 * number("radius_m")).sqrt();
    assert!((number("published_3_rad") / of_three - 1.0).abs() < 1e-12);
    assert!(number("published_3_rad") > critical, "M R²/I₀ is below 1");
    assert!((number("ratio") - number("slenderness_rad") / critical).abs() < 1e-12);
    let english = scratch.dolmen("check examples/p10").stdout;
    assert!(
        english.contains("By spectral velocity (Housner)") && english.contains("eq. 3 as published"),
        "{english}"
    );
    let korean = scratch.dolmen("check examples/p10 --language ko").stdout;
    assert!(korean.contains("스펙트럼 속도에 의한 검토"), "{korean}");
}

#[test]
fn holds_pagodas_of_other_heights_and_storeys_have_their_frequencies() {
    let scratch = Scratch::with_examples("frequency_by_height");
    let whole: Value = serde_json::from_str(
        &scratch
            .dolmen("--json check examples/pagodas_of_figure_19")
            .stdout,
    )
    .unwrap();
    let grid = first(&whole, "frequency_by_height").unwrap().as_array().unwrap();
    let lines: Vec<Vec<[f64; 2]>> = grid
        .iter()
        .map(|of| {
            let points = of["points"].as_array().unwrap().iter();
            points
                .map(|point| ["body_height_m", "frequency_hz"].map(|key| point[key].as_f64().unwrap()))
                .collect()
        })
        .collect();
    assert_eq!(
        grid.iter()
            .map(|of| of["storeys"].as_u64().unwrap())
            .collect::<Vec<_>>(),
        [3, 5, 7]
    );
    for line in &lines {
        assert_eq!(line.len(), 9);
        // similar towers on beds with the same stiffness per area: K in force grows with s², in moment with s⁴, M with s³, so f with s^−½
        for [height, hz] in line {
            let [first_height, first_hz] = line[0];
            let similar = first_hz * (first_height / height).sqrt();
            assert!((hz / similar - 1.0).abs() < 1e-6, "{height}: {hz} {similar}");
        }
    }
    // the file itself: 5 storeys, 6 m
    let own = first(&whole, "frequencies").unwrap();
    let modes = first(own, "modes").and_then(Value::as_array).unwrap();
    let lowest = modes
        .iter()
        .map(|mode| mode["frequency_hz"].as_f64().unwrap())
        .fold(f64::INFINITY, f64::min);
    let of_file = lines[1].iter().find(|[height, _]| *height == 6.0).unwrap()[1];
    assert!((of_file / lowest - 1.0).abs() < 1e-9, "{of_file} {lowest}");
    let english = scratch.dolmen("check examples/pagodas_of_figure_19").stdout;
    assert!(
        english.contains("First frequency of swaying against the height of the body"),
        "{english}"
    );
}
