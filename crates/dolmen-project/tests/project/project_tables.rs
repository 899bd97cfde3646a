//! Lists of parts in a table next to the file: the same project as with lists in the file, and the errors of
//! tables.

use dolmen_project::{MemoryFiles, Project, Structure, WarningKind, parse_project_with};
use dolmen_words::Language;

const STACK: &str =
    "schema = 1\nkind = \"stack\"\nname = \"A\"\nUNITS\nblocks = { file = \"stones.csv\" }\ndensity = 2600\n";

fn files(table: &str) -> MemoryFiles {
    let mut files = MemoryFiles::default();
    files
        .files
        .insert("stones.csv".to_owned(), table.as_bytes().to_vec());
    files
}

fn read(units: &str, table: &str) -> Project {
    let text = STACK.replace("UNITS", units);
    parse_project_with(&text, "p.toml", &files(table)).unwrap_or_else(|why| panic!("{why}"))
}

fn refused(units: &str, table: &str) -> String {
    let text = STACK.replace("UNITS", units);
    parse_project_with(&text, "p.toml", &files(table))
        .unwrap_err()
        .to_string()
}

#[test]
fn agrees_a_table_is_the_list_that_it_stands_for() {
    let written = STACK.replace("UNITS", "").replace(
        "{ file = \"stones.csv\" }",
        "[{ name = \"base\", width = \"1200 mm\", height = \"400 mm\" }, { name = \"body\", width = \"950 mm\", height = \"600 mm\" }]",
    );
    let written = parse_project_with(&written, "p.toml", &files("")).unwrap();
    let Structure::Stack(written) = &written.structure else {
        panic!("no stack")
    };
    for table in [
        "name,width (mm),height (mm)\nbase,1200,400\nbody,950,600\n",
        "이름;폭(mm);높이 [mm]\nbase;1200;400\nbody;950;600\n",
        "Name,Width,Height\nbase,1200 mm,400 mm\nbody,950 mm,600 mm\n",
    ] {
        let read = read("", table);
        let Structure::Stack(read) = &read.structure else {
            panic!("no stack")
        };
        assert_eq!(read.blocks, written.blocks, "{table}");
    }
    // bare numbers are in the units of the file
    let bare = read(
        "units = { length = \"mm\" }",
        "name,width,height\nbase,1200,400\nbody,950,600\n",
    );
    assert!((bare.input("blocks[2].width").unwrap().value - 0.95).abs() < 1e-12);
}

#[test]
fn holds_columns_of_no_part_are_left_out_and_named() {
    let bare = read("", "name,width,height\nbase,1.2,0.4\nbody,0.95,0.6\n");
    let more = read(
        "",
        "번호,이름,폭,높이,비고,무게 (kN)\n1,base,1.2,0.4,,12\n2,body,0.95,0.6,깨짐,9\n",
    );
    let (Structure::Stack(bare), Structure::Stack(told)) = (&bare.structure, &more.structure) else {
        panic!("no stacks")
    };
    assert_eq!(told.blocks, bare.blocks);
    let said = more
        .warnings
        .iter()
        .find(|warning| warning.kind == WarningKind::ColumnsLeftOut);
    let said = said.map(|warning| (warning.path.clone(), warning.message.text(Language::English)));
    let expected = "stones.csv: the model does not use the columns 번호 and 비고";
    assert_eq!(said, Some(("blocks".to_owned(), expected.to_owned())));
    // numbers stand in the first lines of every answer
    let doubted = more
        .warnings
        .iter()
        .find(|warning| warning.kind == WarningKind::Doubtful);
    let doubted = doubted.unwrap().message.text(Language::English);
    assert!(
        doubted.starts_with("stones.csv: the model does not use the numbers of 무게 (kN)"),
        "{doubted}"
    );
}

#[test]
fn refuses_tables_by_their_cell() {
    for (units, table, said) in [
        (
            "",
            "name,width,hieght\nbase,1,1\n",
            "stones.csv, cell C1: \"hieght\" is no column of blocks",
        ),
        (
            "",
            "이름,폭,높이,기울기 (도)\nbase,1,1,2\n",
            "stones.csv, cell D1: \"기울기 (도)\" is no column of blocks",
        ),
        (
            "",
            "이름,폭,높이,수량(개)\nbase,1,1,2\n",
            "stones.csv, cell D1: \"수량(개)\" is no column of blocks",
        ),
        (
            "",
            "이름,폭,높이,편심(mm)\nbase,1,1,0\nbody,1,1,120\n",
            "stones.csv, cell D1: \"편심(mm)\" is no column of blocks",
        ),
        (
            "",
            "name,width,폭\nbase,1,1\n",
            "stones.csv, cell C1: the column \"width\" is there twice",
        ),
        (
            "",
            "name,width (kg)\nbase,1\n",
            "stones.csv, cell B1: the column \"width\" needs a length",
        ),
        (
            "units = { length = \"m\" }",
            "name,width (mm)\nbase,1200\n",
            "stones.csv, cell B1: the column \"width\" is in mm, but units.length of the file is m",
        ),
        ("", "name,width,height\nbase,=1+1,1\n", "cell B2 holds a formula"),
        ("", "name,width,height\nbase,1,-2\n", "(stones.csv, cell C2)"),
        (
            "",
            "name,width,height\nbase,1,1\nbody,wide,1\n",
            "(stones.csv, cell B3)",
        ),
        (
            "",
            "name,width,height\nbase,1,1,7\n",
            "stones.csv, cell D2: stands under no head",
        ),
        ("", "name,width,height\n", "holds no rows"),
    ] {
        let told = refused(units, table);
        assert!(told.contains(said), "{table}\n{told}");
    }
    let missing = STACK.replace("UNITS", "").replace("stones.csv", "other.xlsx");
    let told = parse_project_with(&missing, "p.toml", &files(""))
        .unwrap_err()
        .to_string();
    assert!(told.contains("blocks.file = \"other.xlsx\""), "{told}");
    let more = STACK
        .replace("UNITS", "")
        .replace("\"stones.csv\"", "\"stones.csv\", rows = 3");
    let told = parse_project_with(&more, "p.toml", &files(""))
        .unwrap_err()
        .to_string();
    assert!(told.contains("must be file and sheet alone"), "{told}");
}
