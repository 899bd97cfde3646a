// SOURCE     dolmen-records/tests/data/modes/modes_pyuff.uff: four modes written by pyuff 2.5.8, on nodes at 3, 6 and 9 m.
// GOAL       Modes in a file next to the project are modes of the survey, as if written in the project file; bad files are rejected in both
//            languages.
// TOLERANCE  2e-5: the six digits of a universal file.

use dolmen_project::{MemoryFiles, ModeKind, Project, ProjectError, Quantity, parse_project_with};

const SURVEY: &str =
    "schema = 1\nkind = \"survey\"\nname = \"Gate\"\n[survey.\"2026-04-02\"]\nmodes = { file = \"FILE\" }\n";

fn pyuff() -> String {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../dolmen-records/tests/data/modes/modes_pyuff.uff"
    );
    std::fs::read_to_string(path).unwrap()
}

fn parsed(file: &str, keys: &str, content: &str) -> Result<Project, ProjectError> {
    let mut files = MemoryFiles::default();
    files.files.insert(file.to_owned(), content.as_bytes().to_vec());
    let text = SURVEY.replace("FILE\"", &format!("{file}\"{keys}"));
    parse_project_with(&text, "p.toml", &files)
}

#[test]
fn agrees_modes_of_pyuff_by_direction() {
    let project = parsed("modes.uff", "", &pyuff()).unwrap();
    let modes = &project.surveys[0].modes;
    assert_eq!(modes.keys().collect::<Vec<_>>(), ["x", "y"]);
    let frequencies: Vec<f64> = modes["x"].iter().map(|mode| mode.frequency.value).collect();
    assert_eq!(frequencies.len(), 3);
    assert_eq!(frequencies[..2], [2.125, 6.5]);
    assert!((frequencies[2] / 9.25 - 1.0).abs() < 2e-5);
    assert_eq!(modes["y"][0].damping_ratio.as_ref().unwrap().value, 0.02);
    let shape: Vec<[f64; 2]> = modes["y"][0]
        .shape
        .iter()
        .map(|point| [point.height_m, point.displacement])
        .collect();
    assert_eq!(shape, [[3.0, 0.4], [6.0, 0.75], [9.0, 1.0]]);
    // the phase of the complex shape is chosen to make it as real as possible
    let shape: Vec<f64> = modes["x"][2]
        .shape
        .iter()
        .map(|point| point.displacement)
        .collect();
    let sign = shape[0].signum();
    for (found, expected) in shape.iter().zip([1.0, -0.9, 0.5]) {
        assert!((sign * found - expected).abs() < 2e-5, "{shape:?}");
    }
}

#[test]
fn exact_lengths_twists_and_modes_without_places() {
    let in_mm = ["3", "6", "9"]
        .iter()
        .fold(pyuff().replace("   164 ", "   999 "), |text, height| {
            text.replace(
                &format!("0.00000E+00  {height}.00000E+00"),
                &format!("0.00000E+00  {height}.00000E+03"),
            )
        });
    let in_mm = parsed("modes.UNV", ", length = \"mm\"", &in_mm).unwrap();
    assert_eq!(in_mm.surveys[0].modes["x"][0].shape[2].height_m, 9.0);
    // three nodes at one height with different motions
    let level = ["3.00000E+00", "6.00000E+00"]
        .iter()
        .fold(pyuff(), |text, height| {
            text.replace(&format!("0.00000E+00  {height}"), "0.00000E+00  9.00000E+00")
        });
    let twisting = parsed("modes.uff", "", &level).unwrap();
    let twisting = &twisting.surveys[0].modes["torsion"];
    assert!(!twisting.is_empty() && twisting.iter().all(|mode| mode.kind == ModeKind::Torsion));
    // no nodes: frequencies by direction alone
    let alone = pyuff().replace("    15\n", "   999\n");
    let alone = parsed("modes.uff", "", &alone).unwrap();
    let modes = &alone.surveys[0].modes;
    assert_eq!((modes["x"].len(), modes["y"].len()), (3, 1));
    assert!(modes["x"].iter().all(|mode| mode.shape.is_empty()));
}

#[test]
fn agrees_a_table_is_the_modes_that_it_stands_for() {
    for (table, sd) in [
        (
            "mode,frequency_hz,frequency_sd_hz,damping_ratio,damping_ratio_sd,phase_collinearity,accepted,direction,\"roof re\",\"roof im\"\n\
             1,2.125,0.004,0.0125,0.001,1,false,x,1,0\n2,2.75,,,,0.9,true,y,0.1,0\n3,6.5,,0.03,,1,false,torsion,1,0\n",
            0.004,
        ),
        (
            "direction,frequency (Hz),frequency_sd (Hz),damping_ratio\nx,2.125,0.004,0.0125\ny,2.75,,\ntorsion,6.5,0.01,0.03\n",
            0.004,
        ),
        (
            "direction,frequency,frequency_sd (kHz),damping_ratio\nx,2.125,4e-6,0.0125\ny,2.75,,\ntorsion,6.5,,0.03\n",
            0.004,
        ),
        (
            "방향;고유진동수 (Hz);감쇠비\nx;2.125;0.0125\ny;2.75;\ntorsion;6.5;0.03\n",
            0.0,
        ),
    ] {
        let project = parsed("modes.csv", "", table).unwrap();
        let modes = &project.surveys[0].modes;
        assert_eq!(modes["x"][0].frequency.value, 2.125, "{table}");
        let sd = sd - modes["x"][0].frequency.standard_deviation();
        assert!(sd.abs() < 1e-15, "{sd}");
        assert_eq!(modes["x"][0].damping_ratio.as_ref().unwrap().value, 0.0125);
        assert_eq!(
            (modes["y"][0].frequency.value, &modes["y"][0].damping_ratio),
            (2.75, &None)
        );
        assert_eq!(modes["torsion"][0].kind, ModeKind::Torsion);
        assert!(
            project.surveys[0]
                .measured_modes("torsion", &mut Quantity::nominal)
                .is_empty()
        );
    }
}

#[test]
fn refuses_files_that_are_no_modes_in_both_languages() {
    let uff = pyuff();
    let no_units = uff.replace("   164 ", "   999 ");
    let no_modes = uff.replace("    55 ", "   999 ");
    let no_place = uff.replace(
        "        13         0         0         1",
        "        14         0         0         1",
    );
    let table = "direction,frequency_hz\nx,2\n";
    for (file, keys, content, english, korean) in [
        (
            "modes.uff",
            "",
            no_units.as_str(),
            "not the unit of its lengths (dataset 164)",
            "길이의 단위(데이터셋 164)가 없다",
        ),
        (
            "modes.uff",
            ", length = \"kg\"",
            &no_units,
            "length = \"kg\" is no unit of length",
            "길이의 단위가 아니다",
        ),
        (
            "modes.uff",
            ", length = \"m\"",
            &uff,
            "tells the unit of its lengths itself",
            "에 길이의 단위가 있는데",
        ),
        (
            "modes.uff",
            "",
            &no_modes,
            "no modes (it holds datasets 999 (×4))",
            "모드가 없다",
        ),
        (
            "modes.uff",
            "",
            &no_place,
            "node 13 moves in a mode but has no place",
            "절점 13의 좌표",
        ),
        (
            "modes.uff",
            "",
            "no file of modes",
            "the −1 that begins a dataset",
            "데이터셋을 시작하는 −1",
        ),
        (
            "modes.uff",
            ", sheets = \"a\"",
            &uff,
            "has the key \"sheets\" beside file",
            "\"sheets\" 키가 있다",
        ),
        (
            "modes.csv",
            "",
            "frequency_hz\n2\n",
            "lacks the column direction or frequency_hz",
            "direction 열이나",
        ),
        (
            "modes.csv",
            "",
            "direction,frequency_hz,colour\nx,2,red\n",
            "\"colour\" is no column of modes",
            "modes의 열이 아니다",
        ),
        (
            "modes.csv",
            "",
            "direction,frequency_hz\nx,\n",
            "has no direction or no frequency",
            "방향이나 고유진동수가 없다",
        ),
        (
            "modes.csv",
            "",
            "direction,frequency_hz\nx,-2\n",
            "survey.2026-04-02.modes.x[1].frequency = -2",
            "survey.2026-04-02.modes.x[1].frequency = -2",
        ),
        ("modes.dat", "", table, "modes.dat", "modes.dat"),
    ] {
        let why = parsed(file, keys, content).expect_err(english);
        let message = &why.problems[0].message;
        assert!(message.english.contains(english), "{}", message.english);
        assert!(message.korean.contains(korean), "{}", message.korean);
        assert!(why.problems[0].line == 5, "{why}");
    }
    let missing = parse_project_with(
        &SURVEY.replace("FILE", "modes.uff"),
        "p.toml",
        &MemoryFiles::default(),
    );
    let said = missing.unwrap_err().to_string();
    assert!(
        said.contains("survey.2026-04-02.modes.file = \"modes.uff\""),
        "{said}"
    );
}
