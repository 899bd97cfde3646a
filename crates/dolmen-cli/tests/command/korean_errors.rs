// SOURCE     Our own sentences.
// GOAL       The command tells an error of a project file in the language that was asked for.
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
