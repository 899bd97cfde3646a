//! Project files that are read: the examples, every form of a number, variants, allowed slips.

use dolmen_project::{
    Axial, Cap, Column, Evidence, ModeKind, Project, Quantity, RecordFormat, Structure, WarningKind,
    parse_project,
};
use dolmen_words::Language;
use std::path::Path;

/// A correct chain: each test breaks one thing.
pub(crate) const CHAIN: &str = r#"schema = 1
kind = "chain"
name = "Pole"
units = { force = "kN" }
links = [
  { weight = 38.95, length = 3.68, centroid = 1.64 },
  { weight = 15.13, length = 2.61, centroid = 1.18 },
  { weight = 6.78, length = 1.63, centroid = 0.78 },
]
joints = "unknown"
"#;

/// A correct frame.
pub(crate) const FRAME: &str = r#"schema = 1
kind = "frame"
name = "Gate"
units = { force = "kN", mass = "t", stiffness = "kN/mm" }
axial = "storey"
storeys = [
  { mass = 290, height = 5.84, axial_force = 5919 },
  { mass = 314, height = 7.69, axial_force = 3077 },
]
direction.weak.stiffness = [32.65, 96.14]
"#;

pub(crate) fn with(text: &str, changes: &[(&str, &str)]) -> String {
    changes.iter().fold(text.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    })
}

pub(crate) fn chain_with(changes: &[(&str, &str)]) -> String {
    with(CHAIN, changes)
}

pub(crate) fn frame_with(changes: &[(&str, &str)]) -> String {
    with(FRAME, changes)
}

/// The error of a rejected file.
pub(crate) fn refused(text: &str) -> String {
    parse_project(text, "project.toml").unwrap_err().to_string()
}

pub(crate) fn read(text: &str) -> Project {
    parse_project(text, "project.toml").unwrap_or_else(|error| panic!("{error}"))
}

pub(crate) fn example(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../examples")
        .join(name)
        .join("project.toml");
    std::fs::read_to_string(path).unwrap()
}

fn kinds(project: &Project) -> Vec<WarningKind> {
    project.warnings.iter().map(|warning| warning.kind).collect()
}

#[test]
fn published_flagpole_is_table_1_of_choi_2021() {
    let project = read(&example("naju_flagpole"));
    let Structure::Chain(part) = &project.structure else {
        panic!("{:?}", project.structure)
    };
    let chain = part.build(&mut Quantity::nominal).unwrap();
    let rows = [
        (38.95, 3.68, 1.64),
        (15.13, 2.61, 1.18),
        (6.78, 1.63, 0.78),
        (4.51, 1.54, 0.69),
        (2.93, 1.37, 0.66),
    ];
    assert_eq!(chain.links().len(), rows.len());
    for (link, (weight_kn, length_m, centroid_m)) in chain.links().iter().zip(rows) {
        assert!(
            (link.mass_kg * project.gravity_m_s2 - weight_kn * 1e3).abs() < 1e-9,
            "{link:?}"
        );
        assert_eq!((link.length_m, link.centroid_m), (length_m, centroid_m));
    }
    assert_eq!(part.stiffness_n_m_rad(&mut Quantity::nominal), None);
    assert_eq!(part.cap, Cap::LeftOut);
    let restored = &project.surveys[0];
    assert_eq!(restored.tilt["x"].written, "1/177");
    assert!((restored.tilt["y"].ratio - 1.0 / 540.0).abs() < 1e-15);
    // The paper has no frequency: each one in the file is marked as assumed.
    let mut frequencies = project
        .surveys
        .iter()
        .flat_map(|survey| survey.modes.values().flatten())
        .peekable();
    assert!(frequencies.peek().is_some());
    assert!(frequencies.all(|mode| mode.frequency.is_assumed()));
    for variant in &project.variants {
        let Structure::Chain(part) = &variant.project.structure else {
            panic!()
        };
        assert!(
            part.joints
                .iter()
                .flatten()
                .all(|joint| joint.stiffness.is_assumed()),
            "{}",
            variant.name
        );
        assert!(kinds(&variant.project).contains(&WarningKind::Assumed));
    }
    let [cap] = project
        .warnings
        .iter()
        .filter(|w| w.kind == WarningKind::CapLeftOut)
        .collect::<Vec<_>>()[..]
    else {
        panic!("{:?}", project.warnings)
    };
    assert!(
        cap.message.text(Language::English).contains("unsafe side"),
        "{cap:?}"
    );
}

#[test]
fn published_gate_is_that_of_park_and_min_2010() {
    let project = read(&example("heunginjimun_gate"));
    let Structure::Frame(part) = &project.structure else {
        panic!("{:?}", project.structure)
    };
    assert_eq!(part.axial, Axial::Storey);
    let frame = part.build(&mut Quantity::nominal).unwrap();
    let rows: Vec<_> = frame
        .storeys()
        .iter()
        .map(|s| (s.mass_kg, s.height_m, s.axial_n))
        .collect();
    assert_eq!(rows, [(290e3, 5.84, 5919e3), (314e3, 7.69, 3077e3)]);
    assert_eq!(part.stiffness_n_m("weak", &mut Quantity::nominal), None);
    let survey = &project.surveys[0];
    let weak: Vec<_> = survey.modes["weak"]
        .iter()
        .map(|mode| (mode.frequency.value, mode.kind))
        .collect();
    let (translation, torsion) = (ModeKind::Translation, ModeKind::Torsion);
    assert_eq!(weak, [(1.1, translation), (1.3, torsion), (4.2, translation)]);
    // The twisting mode is not used in the fit.
    let fitted = survey.measured_modes("weak", &mut Quantity::nominal);
    assert_eq!(
        fitted.iter().map(|mode| mode.frequency_hz).collect::<Vec<_>>(),
        [1.1, 4.2]
    );
    assert!((fitted[0].frequency_sd_hz - 0.029).abs() < 1e-12);
    assert_eq!(survey.measured_modes("strong", &mut Quantity::nominal).len(), 1);
    let names: Vec<_> = part
        .directions
        .iter()
        .map(|direction| direction.name.as_str())
        .collect();
    assert_eq!(names, ["weak", "strong"]);
}

#[test]
fn holds_each_way_to_write_a_number_is_the_same_number() {
    let length = |written: &str| {
        let project = read(&chain_with(&[("length = 2.61", &format!("length = {written}"))]));
        project.input("links[2].length").unwrap().clone()
    };
    for written in [
        "2.61",
        "\"2.61 m\"",
        "\"2610 mm\"",
        "\"261cm\"",
        "{ value = 2610, unit = \"mm\" }",
    ] {
        let quantity = length(written);
        assert!((quantity.value - 2.61).abs() < 1e-12, "{written}: {quantity:?}");
        assert_eq!(quantity.unit, "m");
    }
    assert_eq!(length("2.61").written, "2.61 m");
    assert_eq!(length("\"2610 mm\"").written, "2610 mm");
    let full =
        length("{ value = 2.61, cov = 0.1, source = \"test\", cov_source = \"assumed\", note = \"n\" }");
    assert_eq!(
        (full.cov, full.source, full.cov_source),
        (Some(0.1), Some(Evidence::Test), Some(Evidence::Assumed))
    );
    assert!(full.is_scatter_assumed() && !full.is_assumed());
    let by_sd = length("{ value = \"2610 mm\", sd = 0.0261 }");
    // sd is in the unit of value, here mm.
    assert!((by_sd.cov.unwrap() - 1e-5).abs() < 1e-15, "{by_sd:?}");
}

#[test]
fn holds_units_hold_for_bare_numbers_only() {
    let text = chain_with(&[(
        "units = { force = \"kN\" }",
        "units = { force = \"tf\", length = \"mm\" }",
    )]);
    let text = text
        .replace("3.68", "3680")
        .replace("1.64", "1640")
        .replace("2.61", "\"2.61 m\"")
        .replace("1.18", "1180")
        .replace("1.63", "1630")
        .replace("0.78", "780");
    let project = read(&text);
    assert_eq!(project.input("links[1].weight").unwrap().value, 38.95 * 9806.65);
    assert_eq!(project.input("links[1].length").unwrap().value, 3.68);
    assert_eq!(project.input("links[2].length").unwrap().value, 2.61);
}

#[test]
fn holds_pick_changes_one_input_and_no_other() {
    let project = read(CHAIN);
    let Structure::Chain(part) = &project.structure else {
        panic!()
    };
    let changed = part
        .build(&mut |quantity| {
            let factor = if quantity.path == "links[2].weight" {
                1.1
            } else {
                1.0
            };
            quantity.value * factor
        })
        .unwrap();
    let nominal = part.build(&mut Quantity::nominal).unwrap();
    assert!((changed.links()[1].mass_kg / nominal.links()[1].mass_kg - 1.1).abs() < 1e-12);
    assert_eq!(changed.links()[0], nominal.links()[0]);
    assert_eq!(changed.links()[2], nominal.links()[2]);
    // A sample may put the centre of mass above the top: that is an error of the build, not a panic.
    assert!(
        part.build(&mut |q| if q.path.ends_with("centroid") {
            9.0
        } else {
            q.value
        })
        .is_err()
    );
    let mut paths: Vec<_> = project.inputs().iter().map(|input| input.path.clone()).collect();
    assert_eq!(paths.len(), 9);
    paths.dedup();
    assert_eq!(paths.len(), 9);
}

#[test]
fn holds_axial_forces_of_levels_add_up_downwards() {
    let levels = frame_with(&[("\"storey\"", "\"level\""), ("5919", "2842")]);
    for text in [levels, FRAME.to_owned()] {
        let project = read(&text);
        let Structure::Frame(part) = &project.structure else {
            panic!()
        };
        let frame = part.build(&mut Quantity::nominal).unwrap();
        assert_eq!(
            frame.storeys().iter().map(|s| s.axial_n).collect::<Vec<_>>(),
            [5919e3, 3077e3]
        );
        assert_eq!(
            part.stiffness_n_m("weak", &mut Quantity::nominal).unwrap(),
            [32.65e6, 96.14e6]
        );
        assert_eq!(part.stiffness_n_m("strong", &mut Quantity::nominal), None);
    }
    let bare = frame_with(&[
        ("axial = \"storey\"\n", ""),
        (", axial_force = 5919", ""),
        (", axial_force = 3077", ""),
    ]);
    let project = read(&bare);
    let Structure::Frame(part) = &project.structure else {
        panic!()
    };
    let frame = part.build(&mut Quantity::nominal).unwrap();
    assert_eq!(frame.storeys()[1].axial_n, 314e3 * 9.80665);
    assert!((frame.storeys()[0].axial_n - 604e3 * 9.80665).abs() < 1e-6);
    assert_eq!(kinds(&project), [WarningKind::AxialFromMasses]);
}

#[test]
fn holds_a_variant_is_the_file_with_its_parts_changed() {
    let text = format!(
        "{CHAIN}\n[variant.low]\ntitle = \"낮은 중심\"\nlinks = {{ 2 = {{ centroid = 1.0 }} }}\n\
         [variant.stiff]\njoints = [ {{ stiffness = 1e6 }}, {{ stiffness = 4e5 }}, {{ stiffness = 5e4 }} ]\n"
    );
    let project = read(&text);
    let names: Vec<_> = project
        .variants
        .iter()
        .map(|variant| variant.name.as_str())
        .collect();
    assert_eq!(names, ["low", "stiff"]);
    let low = &project.variants[0];
    assert_eq!(low.title.as_ref().unwrap().korean(), "낮은 중심");
    assert_eq!(low.project.input("links[2].centroid").unwrap().value, 1.0);
    assert_eq!(low.project.input("links[2].length").unwrap().value, 2.61);
    assert_eq!(project.input("links[2].centroid").unwrap().value, 1.18);
    let Structure::Chain(stiff) = &project.variants[1].project.structure else {
        panic!()
    };
    assert_eq!(
        stiff.stiffness_n_m_rad(&mut Quantity::nominal).unwrap(),
        [1e6, 4e5, 5e4]
    );
}

#[test]
fn holds_a_variant_with_a_new_value_drops_the_old_scatter() {
    let text = chain_with(&[(
        "weight = 15.13",
        "weight = { value = \"15 kN\", cov = 0.5, source = \"test\" }",
    )]);
    let text = format!("{text}\n[variant.a]\nlinks = {{ 2 = {{ weight = {{ value = 16 }} }} }}\n");
    let project = read(&text);
    let weight = project.variants[0]
        .project
        .input("links[2].weight")
        .unwrap()
        .clone();
    assert_eq!((weight.value, weight.cov, weight.source), (16e3, None, None));
}

#[test]
fn holds_the_evidence_of_the_file_is_that_of_its_own_numbers_alone() {
    let text = chain_with(&[
        ("units", "evidence = \"literature\"\nunits"),
        (
            "weight = 15.13",
            "weight = { value = 15.13, cov = 0.1, source = \"test\" }",
        ),
        ("weight = 6.78", "weight = { value = 6.78, cov = 0.1 }"),
    ]);
    let text =
        format!("{text}\n[variant.a]\nlinks = {{ 1 = {{ centroid = 1.5, length = {{ value = 3.7 }} }} }}\n");
    let project = read(&text);
    let source = |project: &Project, path: &str| project.input(path).unwrap().source;
    assert_eq!(source(&project, "links[1].weight"), Some(Evidence::Literature));
    assert_eq!(source(&project, "links[2].weight"), Some(Evidence::Test));
    assert_eq!(
        project.input("links[2].weight").unwrap().cov_source,
        Some(Evidence::Test)
    );
    assert_eq!(
        project.input("links[3].weight").unwrap().cov_source,
        Some(Evidence::Literature)
    );
    let variant = &project.variants[0].project;
    assert_eq!(source(variant, "links[1].weight"), Some(Evidence::Literature));
    // A variant with a new number must give its source.
    assert_eq!(source(variant, "links[1].centroid"), None);
    assert_eq!(source(variant, "links[1].length"), None);
}

#[test]
fn holds_allow_lets_a_slip_pass_and_says_so() {
    let text = chain_with(&[
        ("15.13", "15130"),
        (
            "joints",
            "allow = [\"links[2].weight\", \"links[3].weight\"]\njoints",
        ),
    ]);
    let project = read(&text);
    assert_eq!(project.input("links[2].weight").unwrap().value, 15130e3);
    let said: Vec<_> = project
        .warnings
        .iter()
        .map(|w| (w.kind, w.line, w.message.text(Language::English)))
        .collect();
    assert_eq!(said[1].0, WarningKind::Allowed);
    assert_eq!(said[1].1, 7);
    assert_eq!(
        said[1].2,
        "links[2].weight = 15130 kN, 388 × the link below; the file allows it"
    );
    assert_eq!(said[2].0, WarningKind::AllowedInVain);
    assert!(said[2].2.contains("links[3].weight"));
}

#[test]
fn holds_real_structures_of_odd_proportions_pass() {
    let pass = |links: &str| {
        let text =
            format!("schema = 1\nkind = \"chain\"\nname = \"a\"\njoints = \"unknown\"\nlinks = [{links}]\n");
        read(&text);
    };
    // Stone drums 1.5 m wide below an iron finial 0.1 m wide.
    pass(
        "{ mass = 5600, length = 1, centroid = 0.5 }, { mass = 5600, length = 1, centroid = 0.5 }, \
          { mass = 92, length = 1.5, centroid = 0.7 }",
    );
    // A statue 1.4 m wide on its own, 1 m high.
    pass("{ mass = 4900, length = 1, centroid = 0.4 }");
    // A timber pole of 0.3 m and 12 m, in three pieces.
    pass(
        "{ mass = 170, length = 4, centroid = 2 }, { mass = 150, length = 4, centroid = 2 }, \
          { mass = 130, length = 4, centroid = 2 }",
    );
    // A leaning tower of 14 500 t and 58 m in two halves, and a plinth below.
    pass(
        "{ mass = 8e5, length = 2, centroid = 1 }, { mass = 7.5e6, length = 28, centroid = 13 }, \
          { mass = 6.2e6, length = 28, centroid = 13 }",
    );
    // The largest ratio of the flagpole: its top link with its bottom link only.
    pass(
        "{ weight = 38950, length = 3.68, centroid = 1.64 }, { weight = 2930, length = 1.37, centroid = 0.66 }",
    );
}

#[test]
fn holds_a_record_is_described_whole() {
    let text = format!(
        "{CHAIN}{}",
        r#"
[survey.2010-05-12]
temperature_c = 18
datum = "benchmark A"
tilt = { x = "0.32 deg", y = "5.65 mm/m", z = 0.001 }

[survey.2010-05-12.records]
file = "records/day.txt"
sampling_rate = "200 Hz"
unit = "mm/s"
delimiter = "\t"
time_column = "t"
channels = [
  { column = 2, name = "top x", position = [0, "150 mm", 12.3], direction = "-y" },
  { column = "ch3", direction = [3, 0, 4], leave_out = true },
]
conditioning = { cut = { from_s = 10, to_s = 610 }, detrend_degree = 1, band_pass = { low_hz = 0.5, high_hz = 20 }, decimate_factor = 4 }
modal = { frequency_high_hz = 10, order_most = 40, modes_wanted = 3, damping_least = 0.0005 }
"#
    );
    let project = read(&text);
    let survey = &project.surveys[0];
    assert!((survey.tilt["x"].ratio - 0.32_f64.to_radians().tan()).abs() < 1e-12);
    assert!((survey.tilt["y"].ratio - 0.00565).abs() < 1e-12);
    let records = survey.records.as_ref().unwrap();
    assert_eq!(
        (records.format, records.delimiter),
        (None::<RecordFormat>, Some('\t'))
    );
    assert_eq!(
        (records.sampling_rate_hz, records.unit.as_deref()),
        (Some(200.0), Some("mm/s"))
    );
    assert_eq!(records.time_column, Some(Column::Name("t".to_owned())));
    let [top, out] = &records.channels[..] else {
        panic!()
    };
    assert_eq!(
        (&top.column, top.position_m, top.direction),
        (
            &Column::Number(2),
            Some([0.0, 0.15, 12.3]),
            Some([0.0, -1.0, 0.0])
        )
    );
    assert_eq!((out.direction, out.leave_out), (Some([0.6, 0.0, 0.8]), true));
    let conditioning = &records.conditioning;
    assert_eq!(
        (conditioning.detrend_degree, conditioning.decimate_factor),
        (Some(1), Some(4))
    );
    assert_eq!(conditioning.band_pass.unwrap().order, 4);
    assert_eq!(records.modal.modes_wanted, Some(3));
    assert_eq!(
        (records.modal.damping_least, records.modal.damping_most),
        (Some(0.0005), None)
    );
    for (written, said) in [
        (
            "damping_least = 0.2",
            "damping_least = 0.2 is not below damping_most = 0.15",
        ),
        ("damping_least = 2", "must be 0 to 1"),
        (
            "damping_most = 0.1, method = \"fdd\"",
            "are not used by this method",
        ),
    ] {
        let fault = refused(&text.replace("damping_least = 0.0005", written));
        assert!(fault.contains(said), "{written}: {fault}");
    }
}
