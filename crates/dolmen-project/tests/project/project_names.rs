// SOURCE     docs/project-file.md, "Names in two languages".
// GOAL       Names of parts, surveys and motions have a printed one in each language; what names nothing is refused with the nearest name.
// TOLERANCE  none.

use dolmen_project::parse_project;
use dolmen_words::Language;

const LAMP: &str = "schema = 1\nkind = \"stack\"\nname = \"Lamp\"\ndensity = 2600\n\
    blocks = [{ name = \"base\", width = 1, height = 0.5 }, { name = \"shaft\", width = 0.5, height = 1 }]\n\
    joint = { friction = 0.6, normal_stiffness = \"1e9 Pa/m\", shear_stiffness = \"4e8 Pa/m\", damping_ratio = 0.3 }\n\
    [survey.2026-04-02]\ntilt = { x = \"1/240\" }\n\
    [motion.strong]\nbuilt_in = \"el-centro-1940-ns\"\n\
    [variant.low]\nblocks = [{ name = \"base\", width = 1, height = 0.5 }]\n";

#[test]
fn exact_each_name_is_printed_in_its_language() {
    let table = "[names.ko]\n\"base\" = \"기단\"\n\"2026-04-02\" = \"봄 조사\"\n\"strong\" = \"강진\"\n\"shaft\" = \" 간주석 \"\n[names.en]\nbase = \"plinth\"\n";
    let project = parse_project(&format!("{LAMP}{table}"), "p.toml").unwrap();
    let all: Vec<(&str, Language, &str)> = project
        .printed_names
        .iter()
        .map(|of| (of.name.as_str(), of.language, of.printed.as_str()))
        .collect();
    let korean = Language::Korean;
    assert_eq!(
        all,
        [
            ("base", Language::English, "plinth"),
            ("2026-04-02", korean, "봄 조사"),
            ("base", korean, "기단"),
            ("shaft", korean, "간주석"),
            ("strong", korean, "강진"),
        ]
    );
    // the same structure, whatever it is called
    let plain = parse_project(LAMP, "p.toml").unwrap();
    assert_eq!(plain.structure.part_names(), project.structure.part_names());
    assert!(plain.printed_names.is_empty());
}

/// Every block that Dolmen names itself has a Korean name; one in the file counts more.
#[test]
fn exact_generated_blocks_have_korean_names() {
    let head = "schema = 1\nkind = \"stack\"\nname = \"S\"\ndensity = 2600\njoint = { friction = 0.6 }\n";
    let made = [
        "pagoda = { storeys = 3, body_height = 4.9 }",
        "arch = { span = 3, thickness = 0.45, depth = 1, voussoirs = 15, springing_height = 1.2, abutment = 1.5 }",
        "trilithon = { span = 1.2, post_width = 0.8, post_height = 3.2, lintel_height = 0.7 }",
        "wall = { length = 2.4, thickness = 0.6, courses = 4, course_height = 0.25, stone_length = 0.5, leaves = 2, \
         through_every = 2 }",
        "vault = { span = 3, thickness = 0.45, length = 2, voussoirs = 7, stones = 2, springing_height = 1 }",
        "dome = { span = 3, rise = 1, thickness = 0.3, rings = 3, stones = 12, drum_height = 1 }",
        "tower = { width = 2.4, courses = 3, course_height = 0.5, thickness = 0.5 }",
    ];
    for structure in made {
        let file = format!("{head}{structure}\n");
        let project = parse_project(&file, "p.toml").unwrap();
        let mut blocks = project.structure.part_names();
        blocks.retain(|block| {
            let has = project.printed_names.iter().any(|of| of.name == *block);
            !has
        });
        assert!(blocks.is_empty(), "{blocks:?}");
    }
    let file = format!("{head}{}\n[names.ko]\nkeystone = \"머릿돌\"\n", made[1]);
    let project = parse_project(&file, "p.toml").unwrap();
    let keystones: Vec<&str> = project
        .printed_names
        .iter()
        .filter(|of| of.name == "keystone")
        .map(|of| of.printed.as_str())
        .collect();
    assert_eq!(keystones, ["머릿돌"]);
}

#[test]
fn refuses_a_name_of_nothing_in_both_languages() {
    let refused = |table: &str| parse_project(&format!("{LAMP}{table}"), "p.toml").unwrap_err();
    let why = refused("[names.ko]\n\"shatf\" = \"간주석\"\n");
    assert_eq!((why.problems.len(), why.problems[0].line), (1, 14));
    for (language, says) in [
        (
            Language::English,
            [
                "names.ko has \"shatf\", which is no part, survey or motion of this file",
                "did you mean \"shaft\"?",
            ],
        ),
        (
            Language::Korean,
            [
                "names.ko의 \"shatf\"는 이 파일의 부재, 조사, 지반운동의 이름이 아니다",
                "\"shaft\"를 쓰려던 것인가?",
            ],
        ),
    ] {
        let said = why.text(language);
        assert!(says.iter().all(|of| said.contains(of)), "{said}");
    }
    let far = refused("[names.ko]\n\"zzz\" = \"간주석\"\n").to_string();
    assert!(
        far.contains("write the name on the left as the file has it"),
        "{far}"
    );
    let empty = refused("[names.ko]\n\"shaft\" = \" \"\n").to_string();
    assert!(empty.contains("is empty"), "{empty}");
    let other = refused("[names.jp]\n\"shaft\" = \"x\"\n").to_string();
    assert!(other.contains("jp"), "{other}");
}
