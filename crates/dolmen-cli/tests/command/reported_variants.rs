//! A report has every input that decides, and of each variant what a check finds.

use super::verbs::Scratch;
use std::fs;

/// The text of a page without its marks, in one line.
fn page(scratch: &Scratch, project: &str, language: &str) -> String {
    let answer = scratch.dolmen(&format!(
        "report {project} --language {language} -o page.html --force"
    ));
    assert!(answer.status < 2, "{}", answer.stderr);
    let page = fs::read_to_string(scratch.path().join("page.html")).unwrap();
    let pieces = page.split('<').filter_map(|piece| piece.split_once('>'));
    let said: Vec<&str> = pieces
        .map(|(_, text)| text.trim())
        .filter(|text| !text.is_empty())
        .collect();
    said.join(" | ").replace('\u{202f}', " ")
}

#[test]
fn holds_a_report_has_the_stroke_of_a_damper_of_a_variant_in_the_wind() {
    let scratch = Scratch::with_examples("reported_damper");
    let full = scratch.dolmen("check examples/tower_in_wind");
    // the stroke of 68.18 mm in its room of 500 mm
    assert!(full.stdout.contains("68.18"), "{}", full.stdout);
    let english = page(&scratch, "examples/tower_in_wind", "en");
    assert!(english.contains("68.18"), "{english}");
    assert!(
        english.contains("Variant “With a tuned mass on the roof”"),
        "{english}"
    );
    assert!(
        !english.contains("no motion or site to hold it against"),
        "{english}"
    );
    let korean = page(&scratch, "examples/tower_in_wind", "ko");
    assert!(
        korean.contains("68.18") && !korean.contains("비교할 지반운동이나 부지 스펙트럼이 없다"),
        "{korean}"
    );
}

#[test]
fn holds_a_report_has_the_mechanism_of_an_unstable_variant() {
    let scratch = Scratch::with_examples("reported_arch");
    let korean = page(&scratch, "examples/arch", "ko");
    let (_, of_variant) = korean.rsplit_once("대안 ‘홍예석 두께 0.15 m’").unwrap();
    assert!(korean.contains("벌어지는 접합면"), "{korean}");
    assert!(
        of_variant.contains("arch.voussoirs") || korean.contains("arch.voussoirs | 15"),
        "{korean}"
    );
    // the x of the hinges at the springings
    assert!(korean.contains("1.650"), "{korean}");
}

#[test]
fn exact_all_that_decides_is_among_the_inputs_as_it_is_written() {
    let scratch = Scratch::with_examples("reported_inputs");
    let tower = page(&scratch, "examples/tower_in_wind", "en");
    for row in [
        "wind.drift_limit | 0.0025",
        "floors[1].count | 18",
        "floors[1].sides | [26, 20]",
        "gravity | 9.80665 m/s² (default)",
        "wind.density | 1.25 kg/m³ (default)",
        "damper.roof.direction | y",
        "damper.roof.tuning | warburton_force",
        "wind: allowed acceleration of the top floor",
    ] {
        assert!(tower.contains(row), "{row}: {tower}");
    }
    let walls = page(&scratch, "examples/tower", "ko");
    for row in [
        "tower.courses | 12",
        "tower.plan | square | round",
        "중력",
        "9.80665 m/s²(기본값)",
    ] {
        assert!(walls.contains(row), "{row}: {walls}");
    }
    let floor = page(&scratch, "examples/twisting_floor", "ko");
    for row in ["p_delta | false", "[10, 8]", "236.963108655"] {
        assert!(floor.contains(row), "{row}: {floor}");
    }
}

#[test]
fn exact_the_combination_with_the_earthquake_is_named_beside_the_earthquake() {
    let scratch = Scratch::with_examples("reported_combination");
    let tower = page(&scratch, "examples/tower_in_wind/loads.toml", "en");
    let (headline, _) = tower.split_once("Findings").unwrap();
    assert!(
        headline.contains("1.19") && headline.contains("1.11"),
        "{headline}"
    );
    assert!(tower.contains("1.34 % of the storey height"), "{tower}");
    for raw in ["wind.acceleration_limit to have", "[limits]", "torque | "] {
        assert!(!tower.contains(&format!("loads[2].{raw}")), "{raw}: {tower}");
    }
    assert!(tower.contains("load ‘crane on the roof’ torque"), "{tower}");
    assert!(tower.contains("load ‘footbridge’ force y"), "{tower}");
}
