// SOURCE     Our own sentences.
// GOAL       The command reports an error of a project file in the requested language.
// TOLERANCE  none. The sentences themselves are tested beside the reader.

use super::verbs::Scratch;
use std::fs;

#[test]
fn regress_an_error_of_a_project_file_is_told_in_the_language_asked_for() {
    let scratch = Scratch::with_examples("korean_error");
    let file = scratch.path().join("examples/naju_flagpole/project.toml");
    let text = fs::read_to_string(&file).unwrap();
    fs::write(&file, text.replacen("kind = \"chain\"", "kind = \"chian\"", 1)).unwrap();
    let korean = scratch.dolmen("check examples/naju_flagpole --language ko");
    for said in [
        "오류: kind = \"chian\"은 쓸 수 없는 값이다",
        "= 도움말: \"chain\"을 쓰려던 것인가?",
    ] {
        assert!(korean.stderr.contains(said), "{}", korean.stderr);
    }
    let english = scratch.dolmen("check examples/naju_flagpole --language en");
    assert!(
        english.stderr.contains("error: kind = \"chian\" is not known"),
        "{}",
        english.stderr
    );
    assert_eq!((korean.status, english.status), (2, 2));
}

#[test]
fn regress_a_misspelt_key_is_one_error() {
    let scratch = Scratch::with_examples("one_error");
    let file = scratch.path().join("examples/naju_flagpole/wind.toml");
    let text = fs::read_to_string(&file).unwrap();
    for (right, wrong) in [
        ("\nunits = ", "\nunit = "),
        ("\njoints = ", "\njoint = "),
        ("speed = { value = 30", "sped = { value = 30"),
        ("length = 3.68", "lenght = 3.68"),
        ("\nlinks = ", "\nlink = "),
    ] {
        assert!(text.contains(right), "{right}");
        fs::write(&file, text.replacen(right, wrong, 1)).unwrap();
        let said = scratch.dolmen("check examples/naju_flagpole/wind.toml --language en");
        let errors = said.stderr.lines().filter(|line| line.starts_with("error"));
        assert_eq!(errors.count(), 1, "{}", said.stderr);
    }
}
