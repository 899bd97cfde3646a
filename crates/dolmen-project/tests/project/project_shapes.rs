//! Stones from points and meshes, and pagodas from their factors: values, and the full text of every message.

use super::project::refused;
use dolmen::structure::stack::{PagodaFactors, PagodaSlenderness, Stack, pagoda};
use dolmen_project::{
    MemoryFiles, Project, Quantity, ShapePart, StackPart, Structure, WarningKind, parse_project,
    parse_project_with,
};
use dolmen_words::Language;

const HEAD: &str = "schema = 1\nkind = \"stack\"\nname = \"S\"\ndensity = 2600\n";

/// A cuboid of 0.8 × 0.6 × 1.0 m in mm, far from the origin, as from a scanner; `without` leaves out a triangle, `turned`
/// reverses all of them.
fn cuboid_obj(without: Option<usize>, turned: bool) -> String {
    let mut text = String::new();
    for corner in 0..8 {
        let at = |bit: usize, size: f64| if corner >> bit & 1 == 1 { size } else { 0.0 };
        let [x, y, z] = [
            5000.0 + at(0, 800.0),
            2000.0 + at(1, 600.0),
            100.0 + at(2, 1000.0),
        ];
        text += &format!("v {x} {y} {z}\n");
    }
    let quads = [
        [1, 3, 4, 2],
        [5, 6, 8, 7],
        [1, 2, 6, 5],
        [3, 7, 8, 4],
        [1, 5, 7, 3],
        [2, 4, 8, 6],
    ];
    let triangles = quads.iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]);
    for (i, [a, b, c]) in triangles.enumerate() {
        if without != Some(i) {
            text += &if turned {
                format!("f {a} {c} {b}\n")
            } else {
                format!("f {a} {b} {c}\n")
            };
        }
    }
    text
}

fn files() -> MemoryFiles {
    let files = [
        ("stone.obj", cuboid_obj(None, false).into_bytes()),
        ("hole.obj", cuboid_obj(Some(3), false).into_bytes()),
        ("turned.obj", cuboid_obj(None, true).into_bytes()),
        ("text.txt", b"hello".to_vec()),
    ];
    MemoryFiles {
        files: files.map(|(name, bytes)| (name.to_owned(), bytes)).into(),
    }
}

fn with_mesh(keys: &str) -> String {
    format!(
        "{HEAD}blocks = [\n  {{ name = \"base\", width = 1.2, height = 0.5 }},\n  {{ name = \"body\", shape = \"mesh\", {keys} }},\n]\n"
    )
}

fn read(text: &str) -> Result<Project, String> {
    parse_project_with(text, "project.toml", &files()).map_err(|error| error.to_string())
}

fn part(text: &str) -> StackPart {
    match read(text).unwrap().structure {
        Structure::Stack(part) => *part,
        other => panic!("{other:?}"),
    }
}

fn built(text: &str) -> Stack {
    part(text).build(&mut Quantity::nominal).unwrap()
}

fn assert_close(given: [[f64; 3]; 2], expected: [[f64; 3]; 2]) {
    for (given, expected) in given.iter().flatten().zip(expected.iter().flatten()) {
        assert!((given - expected).abs() < 1e-12, "{given} {expected}");
    }
}

#[test]
fn exact_a_mesh_in_millimetres_stands_on_the_stone_below() {
    let stack = built(&with_mesh(
        "file = \"stone.obj\", unit = \"mm\", offset = [\"10 mm\", 0]",
    ));
    let body = &stack.blocks()[1];
    assert_close(body.solid.bounds_m(), [[-0.39, -0.3, 0.5], [0.41, 0.3, 1.5]]);
    assert!((body.mass_kg() - 2600.0 * 0.48).abs() < 1e-9);
    assert_eq!(stack.joints().len(), 2);
    assert!((stack.joints()[1].patch.moments().area_m2 - 0.48).abs() < 1e-12);
    let ShapePart::Mesh(mesh) = &part(&with_mesh("file = \"stone.obj\", unit = \"mm\"")).blocks[1].shape
    else {
        panic!()
    };
    assert_eq!((mesh.file.as_str(), mesh.triangles), ("stone.obj", 12));
}

#[test]
fn exact_a_mesh_in_the_coordinates_of_the_site_stays_where_it_is() {
    let text = format!(
        "{HEAD}blocks = [\n  {{ name = \"base\", on = \"ground\", at = [5.4, 2.3], width = 1.2, height = 0.1 }},\n  \
         {{ name = \"body\", shape = \"mesh\", file = \"stone.obj\", unit = \"mm\", coordinates = \"site\" }},\n]\n"
    );
    let stack = built(&text);
    assert_close(
        stack.blocks()[1].solid.bounds_m(),
        [[5.0, 2.0, 0.1], [5.8, 2.6, 1.1]],
    );
}

#[test]
fn holds_a_mesh_in_too_large_a_unit_is_doubted_with_its_size_in_the_others() {
    let doubts = |text: &str| -> Vec<String> {
        let warnings = read(text).unwrap().warnings;
        let doubts = warnings
            .iter()
            .filter(|warning| warning.kind == WarningKind::Doubtful);
        doubts
            .map(|warning| warning.message.text(Language::English))
            .collect()
    };
    // 1000 high in the file: 1 m in mm, 10 m in cm
    assert!(doubts(&with_mesh("file = \"stone.obj\", unit = \"mm\"")).is_empty());
    let text = with_mesh("file = \"stone.obj\", unit = \"cm\"");
    let found = doubts(&text);
    assert_eq!(found.len(), 1, "{found:?}");
    for said in ["'body' is 10", "1 m, 1 m (mm)"] {
        assert!(found[0].contains(said), "{found:?}");
    }
    let allowed = text.replace("blocks = [", "allow = [\"blocks[2].file\"]\nblocks = [");
    assert!(doubts(&allowed).is_empty());
}

#[test]
fn refuses_open_turned_and_missing_meshes_by_the_name_of_the_block() {
    let hole = r#"
error: blocks[2].file = "hole.obj", the mesh of 'body': the mesh has a hole: the edge from vertex 4 (5, 2, 1.1) to vertex 6 (5, 2.6, 1.1) belongs to 1 triangle instead of 2, the first of 3 such edges: fill it, or join vertices that lie in one place
  --> project.toml:7:43
   |
 7 |   { name = "body", shape = "mesh", file = "hole.obj", unit = "mm" },
   |                                           ^^^^^^^^^^
"#;
    let said = read(&with_mesh("file = \"hole.obj\", unit = \"mm\"")).unwrap_err();
    assert_eq!(said.trim(), hole.trim());
    let cases = [
        (
            "file = \"turned.obj\", unit = \"mm\"",
            "blocks[2].file = \"turned.obj\", the mesh of 'body': the mesh is inverted: its volume is -0.480000 m³; turn all its \
             triangles round",
        ),
        ("file = \"no.obj\"", "the mesh of 'body': there is no no.obj"),
        (
            "file = \"text.txt\"",
            "the mesh of 'body': the file is no OBJ, STL or PLY",
        ),
        ("unit = \"mm\"", "blocks[2] has no \"file\", but a mesh needs it"),
        (
            "file = \"stone.obj\", unit = \"kg\"",
            "blocks[2].unit needs a length, but \"kg\" is a mass",
        ),
        (
            "file = \"stone.obj\"",
            "blocks[2].file: 'body' is 1000 m across, but stones are 0.005 to 50 m",
        ),
        (
            "file = \"stone.obj\", unit = \"mm\", width = 2",
            "blocks[2].width has no meaning in a mesh",
        ),
        (
            "file = \"stone.obj\", unit = \"mm\", coordinates = \"site\", at = [0, 0]",
            "blocks[2].at has no meaning with coordinates = \"site\"",
        ),
        (
            "file = \"stone.obj\", unit = \"mm\", height = 1",
            "blocks[2].height has no meaning in a mesh",
        ),
    ];
    for (keys, said) in cases {
        let answer = read(&with_mesh(keys)).unwrap_err();
        assert!(answer.contains(said), "{said}: {answer}");
    }
    let in_memory = parse_project(&with_mesh("file = \"stone.obj\", unit = \"mm\""), "project.toml");
    let said = in_memory.unwrap_err().to_string();
    assert!(said.contains("no files are read here"), "{said}");
}

#[test]
fn exact_a_frustum_of_points_and_its_scatter() {
    let text = format!(
        "{HEAD}blocks = [\n  {{ name = \"a\", shape = \"points\", points = [[0, 0, 1], [2, 0, 1], [2, 1, 1], [0, 1, 1],\n    \
         [0.5, 0.25, \"1500 mm\"], [1.5, 0.25, 1.5], [1.5, 0.75, 1.5], [0.5, 0.75, {{ value = 1.5, cov = 0.01 }}]] }},\n]\n"
    );
    let stack = built(&text);
    let solid = &stack.blocks()[0].solid;
    assert_close(solid.bounds_m(), [[-1.0, -0.5, 0.0], [1.0, 0.5, 0.5]]);
    // (A + a + √(A a)) h / 3
    assert!((solid.volume_m3() - 0.5 / 3.0 * (2.0 + 0.5 + 1.0)).abs() < 1e-12);
    let project = read(&text).unwrap();
    assert_eq!(project.input("blocks[1].points[8][3]").unwrap().cov, Some(0.01));
    assert_eq!(project.structure_inputs().len(), 25);
}

/// What is given says the shape: points need no `shape = "points"`, a file no `shape = "mesh"`.
#[test]
fn exact_a_shape_follows_from_points_or_a_file() {
    let text = format!(
        "{HEAD}blocks = [\n  {{ name = \"a\", points = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [0, 0, 1], [2, 0, 1], [2, 2, 1], [0, 2, 1]] }},\n  \
         {{ name = \"b\", file = \"stone.obj\", unit = \"mm\" }},\n]\n"
    );
    let stack = part(&text);
    let shapes: Vec<&ShapePart> = stack.blocks.iter().map(|block| &block.shape).collect();
    assert!(
        matches!(shapes[..], [ShapePart::Points { .. }, ShapePart::Mesh(_)]),
        "{shapes:?}"
    );
}

#[test]
fn refuses_points_that_make_no_stone() {
    let of = |points: &str| {
        refused(&format!(
            "{HEAD}blocks = [\n  {{ name = \"a\", shape = \"points\", {points} }},\n]\n"
        ))
    };
    for (points, said) in [
        (
            "height = 1",
            "blocks[1] has no \"points\", but a solid of points needs them",
        ),
        (
            "points = [[0, 0], [1, 0, 0], [1, 1, 0], [0, 0, 1]]",
            "blocks[1].points[1] has 2 numbers",
        ),
        (
            "points = [[0, 0, 0], [1, 0, 0], [0, 0, 1]]",
            "needs at least 4 points, but 3 points are given",
        ),
        (
            "points = [[0, 0, 0], [800, 0, 0], [0, 600, 0], [0, 0, 900]]",
            "'a' is 900 m across, but stones are 0.005 to 50 m",
        ),
    ] {
        let answer = of(points);
        assert!(answer.contains(said), "{said}: {answer}");
    }
}

const PAGODA: &str =
    "pagoda = { storeys = 5, body_height = 4.0, slenderness_angle = 0.385, taper = \"8 deg\" }\n";

#[test]
fn agrees_the_pagoda_of_the_science_with_its_names() {
    let text = format!(
        "{HEAD}{PAGODA}contacts = [{{ lower = \"upper base cover\", upper = \"storey 1 body\", joint = {{ friction = 0.4 }} }}]\n"
    );
    let stack = built(&text);
    let expected = pagoda(&PagodaFactors {
        storeys: 5,
        body_height_m: 4.0,
        slenderness: PagodaSlenderness::Angle(0.385),
        ..PagodaFactors::default()
    })
    .unwrap();
    assert_eq!(stack.blocks(), expected.blocks.as_slice());
    assert_eq!(stack.joints()[4].material.friction_static, 0.4);
    assert_eq!(stack.joints()[5].material.friction_static, 0.6);
    let project = read(&text).unwrap();
    let taper = project.input("pagoda.taper").unwrap();
    assert!((taper.value - 8.0_f64.to_radians()).abs() < 1e-15);
    // a picked height makes another pagoda
    let Structure::Stack(part) = &project.structure else {
        panic!()
    };
    let taller = part
        .build(&mut |q| {
            if q.path == "pagoda.body_height" {
                5.0
            } else {
                q.value
            }
        })
        .unwrap();
    assert!((taller.height_m() / stack.height_m() - 1.25).abs() < 1e-12);
}

#[test]
fn refuses_pagodas_that_cannot_be() {
    let of = |line: &str| refused(&format!("{HEAD}{line}\n"));
    let cases = [
        (
            "pagoda = { storeys = 3, body_height = 3 }\nblocks = []",
            "the file has both blocks and a pagoda",
        ),
        (
            "pagoda = { storeys = 14, body_height = 3 }",
            "pagoda.storeys = 14 is outside its range",
        ),
        (
            "pagoda = { storeys = 3, body_height = 3, body_slenderness = 3, slenderness_angle = 0.3 }",
            "pagoda has both body_slenderness and slenderness_angle",
        ),
        (
            "pagoda = { storeys = 3, body_height = 3000 }",
            "pagoda.body_height = 3000 m, but pagodas have 1 to 20 m",
        ),
        (
            "pagoda = { storeys = 3, body_height = 3, taper = \"30 deg\" }",
            "pagoda: taper_rad is 0.5236, but with the other factors of this pagoda its limit is 0.2613: change it or them",
        ),
        (
            "pagoda = { storeys = 3, body_height = 3, slenderness_angle = 3 }",
            "pagoda.slenderness_angle = 3, but pagodas have 0.2 to 0.6",
        ),
        (
            "pagoda = { body_height = 3 }",
            "pagoda has no \"storeys\", but needs it",
        ),
        ("joint = { friction = 0.5 }", "a stack needs blocks"),
    ];
    for (line, said) in cases {
        let answer = of(line);
        assert!(answer.contains(said), "{said}: {answer}");
        assert_eq!(answer.matches("error:").count(), 1, "{answer}");
    }
    let without = refused(&format!("{HEAD}{PAGODA}").replace("density = 2600\n", ""));
    assert!(
        without.contains("the stones of a pagoda need a density"),
        "{without}"
    );
}
