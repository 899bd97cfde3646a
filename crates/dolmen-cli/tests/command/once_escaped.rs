// SOURCE     Past defects: names with formula characters, folders created silently, a binary at a fixed address.
// GOAL       They stay mended.
// TOLERANCE  none: words and bytes.

use super::verbs::Scratch;
use std::fs;

#[test]
fn holds_a_folder_that_is_made_for_an_output_is_said() {
    let scratch = Scratch::new("made-folder");
    assert_eq!(scratch.dolmen("new flagpole p").status, 0);
    let answer = scratch.dolmen("report p -o new/deep/r.html");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let said = "the folder new/deep was not there and is new";
    assert!(answer.stderr.contains(said), "{}", answer.stderr);
    let again = scratch.dolmen("report p -o new/deep/r.html");
    assert!(
        again.status == 0 && !again.stderr.contains("is new"),
        "{}",
        again.stderr
    );
}

#[test]
fn holds_a_name_puts_no_tags_into_a_page() {
    let scratch = Scratch::new("tags");
    let stack = "schema = 1\nkind = \"stack\"\nname = \"k_cr <b>of</b> k_min\"\ndensity = 2600\njoint = { friction = 0.6 }\n\
        blocks = [{ name = \"<i>base</i>\", width = 1.2, height = 0.4 }]\n";
    fs::write(scratch.path().join("project.toml"), stack).unwrap();
    assert_eq!(scratch.dolmen("report . -o r.html").status, 0);
    let page = fs::read_to_string(scratch.path().join("r.html")).unwrap();
    let title = "<title>k_cr &lt;b&gt;of&lt;/b&gt; k_min</title>";
    assert!(page.contains(title), "{}", &page[..page.len().min(2000)]);
    assert!(!page.contains("<b>of</b>") && !page.contains("<i>base</i>"));
}

/// A position-independent executable gets a random address at each start.
#[cfg(target_os = "linux")]
#[test]
fn holds_the_binary_is_position_independent() {
    const SHARED_OBJECT: u16 = 3;
    let bytes = fs::read(env!("CARGO_BIN_EXE_dolmen")).unwrap();
    assert!(bytes.starts_with(b"\x7fELF"));
    assert_eq!(u16::from_le_bytes([bytes[16], bytes[17]]), SHARED_OBJECT);
}

#[test]
fn holds_the_name_of_a_direction_does_not_become_a_path() {
    let scratch = Scratch::with_examples("direction");
    let gate = fs::read_to_string(scratch.path().join("examples/heunginjimun_gate/project.toml")).unwrap();
    let renamed = gate
        .replace("direction.weak", "direction.\"../../x\"")
        .replace("modes.weak", "modes.\"../../x\"");
    let folder = scratch.path().join("deep/inner");
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("project.toml"), renamed).unwrap();
    let run = "--variant soft_below --motion el-centro-1940-ns --duration 0.5";
    let answer = scratch.dolmen(&format!(
        "simulate deep/inner {run} --direction ../../x -o deep/inner/out"
    ));
    assert_eq!(answer.status, 3, "{}", answer.stderr);
    assert!(folder.join("out/%2E.%2F..%2Fx/simulation.json").is_file());
    assert!(!scratch.path().join("deep/x").exists() && !scratch.path().join("x").exists());
}
