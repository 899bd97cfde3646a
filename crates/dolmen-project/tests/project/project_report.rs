//! Contents of a report from the engineer, and findings of inspections: values and errors.

use super::project::{CHAIN, chain_with, example, read, refused};
use dolmen_project::{
    DamageKind, GradeScale, MaterialMethod, PeriodicGrade, Severity, WarningKind, canonical_text,
};
use dolmen_words::Language;

fn chain_and(text: &str) -> String {
    format!("{CHAIN}\n{text}")
}

#[test]
fn holds_the_example_is_read_whole() {
    let project = read(&example("inspected_flagpole"));
    let report = project.report.as_ref().unwrap();
    assert_eq!(report.title.as_ref().unwrap().korean(), "구조안전성 검토 보고서");
    assert_eq!(report.authors.len(), 2);
    assert_eq!(report.location.as_ref().unwrap().degrees, Some([35.0, 127.0]));
    assert_eq!(report.photos[0].path, "report.photos[1].file");
    assert_eq!(
        report.material_tests[0].method,
        MaterialMethod::Ultrasonic(Some(3900.0))
    );
    assert_eq!(report.material_tests[0].strength.as_ref().unwrap().value, 98e6);
    let grade = report.grade.as_ref().unwrap();
    assert_eq!(
        (grade.value.english(), &grade.scale),
        ("C", &GradeScale::Periodic(PeriodicGrade::C))
    );
    let found = &project.surveys[1].inspections;
    assert_eq!(found.len(), 4);
    assert_eq!(
        (&found[0].what, found[0].severity),
        (&DamageKind::Crack, Some(Severity::Moderate))
    );
    assert!((found[0].size.as_ref().unwrap().value - 0.4e-3).abs() < 1e-15);
    assert_eq!(found[1].at, Some([0.1, 0.0, 9.46]));
    assert!(matches!(&found[3].what, DamageKind::Other(other) if other.korean == "철띠 주변 녹물"));
    assert!(
        project
            .variants
            .iter()
            .all(|variant| variant.project.report.is_none())
    );
}

#[test]
fn holds_a_kind_of_damage_is_known_by_either_language() {
    let of = |what: &str| {
        let text = format!("[survey.a]\ninspections = [{{ part = \"1\", what = \"{what}\" }}]");
        read(&chain_and(&text)).surveys[0].inspections[0].what.clone()
    };
    for (english, korean) in [
        ("crack", "균열"),
        ("Spalling", "박락"),
        ("exfoliation", "박리"),
        ("open joint", "이격"),
        ("settlement", "침하"),
    ] {
        assert_eq!(of(english), of(korean));
        assert!(!matches!(of(english), DamageKind::Other(_)), "{english}");
    }
}

#[test]
fn holds_a_crack_in_metres_is_asked_about() {
    let doubted = |what: &str, size: &str| -> Vec<String> {
        let entry = format!("{{ part = \"1\", what = \"{what}\", size = {size} }}");
        let project = read(&chain_and(&format!(
            "[survey.2024-03-05]\ninspections = [{entry}]"
        )));
        let doubted = project
            .warnings
            .iter()
            .filter(|of| of.kind == WarningKind::Doubtful);
        doubted.map(|of| of.message.text(Language::English)).collect()
    };
    let [said] = doubted("crack", "\"400 mm\"").try_into().unwrap();
    assert!(
        said.contains("survey.2024-03-05.inspections[1].size: a crack 0.4") && said.contains("is it in mm?"),
        "{said}"
    );
    for (what, size) in [
        ("균열", "\"0.4 mm\""),
        ("crack", "\"9 cm\""),
        ("loss", "\"400 mm\""),
    ] {
        assert_eq!(doubted(what, size), [] as [String; 0], "{what} {size}");
    }
}

#[test]
fn holds_no_run_of_a_study_depends_on_the_report() {
    let study = "[study.a]\nsamples = 3\n";
    let of = |text: &str| canonical_text(&chain_and(text), "p.toml", "a").unwrap();
    assert_eq!(of(study), of(&format!("{study}[report]\nclient = \"A\"\n")));
}

#[test]
fn refuses_what_a_report_cannot_say() {
    for (text, said) in [
        ("[report]\ntitle = \"  \"", "report.title is empty"),
        ("[report]\ntitle = {}", "report.title is empty"),
        (
            "[report]\ndate = \"2026-02-30\"",
            "report.date = \"2026-02-30\" is not a day",
        ),
        (
            "[report]\nlocation = { latitude = 35 }",
            "has one of latitude and longitude",
        ),
        (
            "[report]\nlocation = { latitude = 95, longitude = 127 }",
            "report.location.latitude = 95 is outside its range",
        ),
        ("[report]\nphotos = [{ caption = \"a\" }]", "file"),
        (
            "[report]\nphotos = [{ file = \"a.png\", of = \"shaft 9\" }]",
            "report.photos[1].of = \"shaft 9\" is no part of this structure",
        ),
        (
            "[report]\ngrade = { value = \"G\", reason = \"x\" }",
            "must be A, B, C, D, E or F",
        ),
        ("[report]\ngrade = { value = \"C\" }", "reason"),
        (
            "[report]\nmaterial_tests = [{ method = \"ultrasonic\", rebound_number = 40 }]",
            "has a reading of the other method",
        ),
        (
            "[report]\nmaterial_tests = [{ method = \"rebound\" }]",
            "report.material_tests[1] has no result",
        ),
        (
            "[report]\nmaterial_tests = [{ method = \"ultrasonic\", velocity_m_s = 3.9 }]",
            "must be 100 to 8000",
        ),
        ("[report]\nauthors = [{ role = \"a\" }]", "name"),
        ("[report]\nheadline = \"stable\"", "headline"),
        (
            "[survey.a]\ninspections = [{ part = \"7\", what = \"crack\" }]",
            "survey.a.inspections[1].part = \"7\" is no part of this structure",
        ),
        (
            "[survey.a]\ninspections = [{ part = \"1\", what = \"crack\", severity = \"bad\" }]",
            "severity",
        ),
        (
            "[survey.a]\ninspections = [{ part = \"1\", what = \"crack\", at = [1, 2] }]",
            "must be three: x right, y away, z up",
        ),
        (
            "[survey.a]\ninspections = [{ part = \"1\", what = \"crack\", size = \"-1 mm\" }]",
            "must be above 0",
        ),
        (
            "[variant.a]\nreport = { client = \"A\" }",
            "variant \"a\" cannot change report",
        ),
    ] {
        let told = refused(&chain_and(text));
        assert!(told.contains(said), "{text}\n{told}");
    }
    // the nearest name is offered
    let named = chain_with(&[("{ weight = 15.13,", "{ name = \"shaft 2\", weight = 15.13,")]);
    let told = refused(&format!(
        "{named}\n[report]\nphotos = [{{ file = \"a.png\", of = \"shaft2\" }}]"
    ));
    assert!(told.contains("did you mean \"shaft 2\"?"), "{told}");
}
