// SOURCE     Our own sentences.
// GOAL       A Korean answer contains no English sentence: in its text, its page, and the words of its figures.
// TOLERANCE  Words of the project file, names, code and references are allowed.

use super::each_example::{Shown, examples, shown};
use super::english::english_in;
use super::verbs::Scratch;
use std::fs;
use std::path::Path;

/// Whether a line cites a work ("출처", authors, or a year in brackets).
fn cites(line: &str) -> bool {
    let is_year = |part: &str| {
        part.len() >= 5 && part.as_bytes()[..4].iter().all(u8::is_ascii_digit) && part.as_bytes()[4] == b')'
    };
    line.contains("출처") || line.contains(" & ") || line.split('(').skip(1).any(is_year)
}

/// Parts of a pagoda and an arch given by their proportions, and a made motion.
const NAMES: [&str; 5] = [
    "upper base cover",
    "lower base cover",
    "left abutment",
    "right abutment",
    "Ricker wavelet, period",
];

/// The strings of a project file or the cells of a table, longest first: these are the user's own words.
fn own_words(file: &Path) -> Vec<String> {
    let text = fs::read_to_string(file).unwrap_or_default();
    let parts: Vec<&str> = match file.extension().is_some_and(|kind| kind == "csv") {
        true => text.split([',', '\n']).collect(),
        false => text.split('"').skip(1).step_by(2).collect(),
    };
    let mut own: Vec<String> = parts.into_iter().chain(NAMES).map(str::to_owned).collect();
    own.retain(|word| word.contains(' '));
    own.sort_by_key(|word| std::cmp::Reverse(word.len()));
    own
}

fn without(text: &str, own: &[String]) -> String {
    let one_line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    own.iter()
        .fold(one_line, |text, word| text.replace(word.as_str(), "‘’"))
}

/// The texts between the tags of a page, including drawings, without code and scripts.
fn text_nodes(page: &str) -> Vec<String> {
    const CODE: [&str; 4] = ["script", "style", "pre", "code"];
    let mut nodes = Vec::new();
    let mut inside: Option<&str> = None;
    for piece in page.split('<').skip(1) {
        let (tag, text) = piece.split_once('>').unwrap_or((piece, ""));
        let name = tag
            .trim_start_matches('/')
            .split([' ', '\n'])
            .next()
            .unwrap_or_default();
        if let Some(code) = CODE.into_iter().find(|code| *code == name) {
            inside = (!tag.starts_with('/')).then_some(code);
        }
        if inside.is_none() && !text.trim().is_empty() {
            nodes.push(
                text.replace("&#39;", "'")
                    .replace("&quot;", "\"")
                    .replace("&amp;", "&"),
            );
        }
    }
    nodes
}

/// English text in the pages and drawings below a folder.
fn english_files(folder: &Path, own: &[String]) -> Vec<String> {
    let mut found = Vec::new();
    for path in fs::read_dir(folder)
        .into_iter()
        .flatten()
        .map(|entry| entry.unwrap().path())
    {
        if path.is_dir() {
            found.extend(english_files(&path, own));
        } else if path
            .extension()
            .is_some_and(|kind| kind == "svg" || kind == "html")
        {
            found.extend(english_page(&fs::read_to_string(&path).unwrap(), own));
        }
    }
    found
}

fn english_page(page: &str, own: &[String]) -> Vec<String> {
    let nodes = text_nodes(page).into_iter().filter(|node| !cites(node));
    let bare = nodes.map(|node| without(&node, own));
    bare.filter(|node| english_in(node).is_some()).collect()
}

/// English text in a printed answer, whose paragraphs are joined to one line.
fn english_answer(answer: &str, own: &[String]) -> Vec<String> {
    let paragraphs = answer
        .split("\n\n")
        .flat_map(|text| text.split("\n- "))
        .filter(|text| !cites(text));
    let bare = paragraphs.map(|text| without(text, own));
    bare.filter_map(|text| english_in(&text).map(|words| format!("{words}: {text}")))
        .collect()
}

#[test]
fn exact_what_is_english() {
    assert_eq!(
        english_in("이것은 Not one sentence.").as_deref(),
        Some("Not one sentence")
    );
    assert_eq!(
        english_in("접합면 ‘one two three four’ 및 k_cr El Centro 1940 NS"),
        None
    );
    assert_eq!(
        text_nodes("<p>하나<script>a b c</script><svg><text>둘</text></svg>"),
        ["하나", "둘"]
    );
    assert!(cites("Hwang and Kim (2022), eq. 3") && !cites("it is (202) g"));
}

#[test]
fn holds_a_korean_check_and_its_page_hold_no_english_sentence() {
    let scratch = Scratch::with_examples("korean");
    let mut found = Vec::new();
    for Shown { example, page, .. } in shown().iter().filter(|shown| shown.language == "ko") {
        let own = own_words(&scratch.path().join(example).join("project.toml"));
        let asked = format!("check {example} --language ko --allow-outside");
        let mut answer = scratch.dolmen(&format!("{asked} --sensitivity"));
        if answer.stderr.contains("--sensitivity") {
            answer = scratch.dolmen(&asked);
        }
        found.extend(english_answer(&answer.stdout, &own));
        found.extend(english_page(page, &own));
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// A stack whose study is short.
const STUDIED: &str = r#"
[study.tiny]
vary = { "joint.friction" = [0.3, 0.6] }
artificial = { count = 1, duration_s = 2, strong_s = 1, rise_s = 0.5 }
scale = { from = 1, to = 4, steps = 3 }
points = 4
"#;

#[test]
fn holds_the_korean_answer_and_figures_of_each_verb_hold_no_english_sentence() {
    let scratch = Scratch::with_examples("korean_verbs");
    let blocks = scratch.path().join("examples/piled_blocks/project.toml");
    let text = fs::read_to_string(&blocks).unwrap();
    fs::write(&blocks, text + STUDIED).unwrap();
    let ground = "--motion el-centro-1940-ns --duration 1";
    let verbs = [
        (
            "palisaden/project.toml",
            "identify examples/palisaden -o out".to_owned(),
        ),
        (
            "heunginjimun_gate/project.toml",
            "identify examples/heunginjimun_gate -o out".to_owned(),
        ),
        (
            "gate_through_the_seasons/project.toml",
            "compare examples/gate_through_the_seasons -o out".to_owned(),
        ),
        (
            "piled_blocks/project.toml",
            format!("simulate examples/piled_blocks {ground} -o out"),
        ),
        (
            "heunginjimun_gate/project.toml",
            format!("simulate examples/heunginjimun_gate --variant soft_below {ground} -o out"),
        ),
        (
            "naju_flagpole/project.toml",
            format!("simulate examples/naju_flagpole --variant wedged {ground} -o out"),
        ),
        (
            "twisting_floor/project.toml",
            format!("simulate examples/twisting_floor {ground} -o out"),
        ),
        (
            "piled_blocks/project.toml",
            "study examples/piled_blocks --study tiny -o out".to_owned(),
        ),
        (
            "twisting_floor/project.toml",
            "tune examples/twisting_floor --map 2 -o out".to_owned(),
        ),
        (
            "",
            "motion --make ricker --period 0.5 --peak 0.3g -o out".to_owned(),
        ),
        (
            "pagoda_score/project.toml",
            "score examples/pagoda_score".to_owned(),
        ),
        (
            "portfolio/pagodas.csv",
            "rank examples/portfolio/pagodas.csv --draws 20 -o out".to_owned(),
        ),
    ];
    let mut found = Vec::new();
    for (file, words) in verbs {
        let own = own_words(&scratch.path().join("examples").join(file));
        let answer = scratch.dolmen(&format!("{words} --language ko --allow-outside"));
        assert!(answer.status != 2, "{words}: {}", answer.stderr);
        let out = scratch.path().join("out");
        let english = [english_answer(&answer.stdout, &own), english_files(&out, &own)].concat();
        found.extend(english.into_iter().map(|text| format!("{words}: {text}")));
        let _ = fs::remove_dir_all(out);
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// Kinds of structure and keys, as a project file names them.
const OF_FILES: [&str; 2] = ["chain, frame, stack, building", "floor, place, direction"];

#[test]
fn holds_the_korean_of_each_verb_on_each_example_holds_no_english_sentence() {
    let scratch = Scratch::with_examples("korean_all");
    let verbs = [
        "draw EXAMPLE -o out",
        "identify EXAMPLE -o out",
        "compare EXAMPLE -o out",
        "watch EXAMPLE -o out",
        "simulate EXAMPLE --motion el-centro-1940-ns --duration 1 -o out",
        "tune EXAMPLE",
        "score EXAMPLE",
        "sensors EXAMPLE",
    ];
    let mut found = Vec::new();
    for example in examples() {
        let own = own_words(&scratch.path().join(&example).join("project.toml"));
        for verb in verbs {
            let words = verb.replace("EXAMPLE", &example);
            let answer = scratch.dolmen(&format!("{words} --language ko"));
            // refusals are Korean, too
            let refused = if answer.status == 2 {
                answer.stderr.as_str()
            } else {
                ""
            };
            let refused = OF_FILES
                .iter()
                .fold(refused.to_owned(), |text, name| text.replace(name, ""));
            let out = scratch.path().join("out");
            let english = [
                english_answer(&answer.stdout, &own),
                english_answer(&refused, &own),
                english_files(&out, &own),
            ];
            found.extend(
                english
                    .concat()
                    .into_iter()
                    .map(|text| format!("{words}: {text}")),
            );
            let _ = fs::remove_dir_all(out);
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn holds_the_korean_of_verbs_without_a_project_holds_no_english_sentence() {
    let scratch = Scratch::with_examples("korean_others");
    let own = own_words(&scratch.path().join("examples/naju_flagpole/project.toml"));
    let mut found = Vec::new();
    for words in [
        "explain",
        "motion --motion el-centro-1940-ns --spectrum",
        "survey add examples/naju_flagpole --name naju --store s.db",
        "survey list --store s.db",
        "survey show naju --store s.db",
        "survey verify --store s.db",
    ] {
        let answer = scratch.dolmen(&format!("{words} --language ko"));
        assert!(answer.status != 2, "{words}: {}", answer.stderr);
        let english = english_answer(&answer.stdout, &own).into_iter();
        found.extend(english.map(|text| format!("{words}: {text}")));
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}
