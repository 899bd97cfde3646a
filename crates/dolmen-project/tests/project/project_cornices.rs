//! Steps below a roof stone and a mast on a finial: mass, centre of mass, inertia and bed, and every error with its remedy.

use dolmen::structure::stack::{Block, Stack};
use dolmen_project::{Quantity, Structure, parse_project};

const PAGODA: &str = r#"schema = 1
kind = "stack"
name = "Roof and finial"
density = 2600
joint = { friction = 0.6, normal_stiffness = 1e9, shear_stiffness = 4e8 }
blocks = [
  { name = "body", width = 2.2, height = 1.4 },
  { name = "roof", shape = "frustum", width = 3.0, top_width = 2.0, height = 0.5, cornice = { steps = 4, height = 0.4, setback = 0.1 } },
  { name = "finial", width = 0.5, height = 0.4, mast = { height = 1.8, diameter = 0.08, density = 7850 } },
]
"#;

fn stack(text: &str) -> Stack {
    let project = parse_project(text, "pagoda.toml").unwrap();
    let Structure::Stack(part) = &project.structure else {
        panic!("no stack");
    };
    part.build(&mut Quantity::nominal).unwrap()
}

fn near(value: f64, wanted: f64, what: &str) {
    assert!((value / wanted - 1.0).abs() < 1e-12, "{what}: {value} {wanted}");
}

/// Mass, centre of mass above the ground, and moments of inertia about it across and about the vertical.
fn of(block: &Block) -> [f64; 4] {
    let inertia = block.solid.inertia_m5();
    let mass = block.mass_kg();
    let about = [inertia[0][0], inertia[2][2]].map(|of| of * block.density_kg_m3);
    [mass, block.solid.centroid_m()[2], about[0], about[1]]
}

#[test]
fn exact_a_roof_on_its_steps_is_the_sum_of_slices() {
    let stack = stack(PAGODA);
    let roof = &stack.blocks()[1];
    // widths by height: steps of 0.1 m, 2.2, 2.4, 2.6 and 2.8 m wide, and the roof from 3.0 to 2.0 m; Simpson's rule is exact for the volume,
    // the first and, with many slices, the other moments
    let mut sums = [0.0; 4]; // ∫ A, ∫ A z, ∫ (I + A z²), ∫ 2 I
    let mut slices = |from: f64, to: f64, width: &dyn Fn(f64) -> f64| {
        let count = 400;
        let h = (to - from) / f64::from(count);
        for i in 0..=count {
            let z = from + h * f64::from(i);
            let weight = match i {
                0 => 1.0,
                i if i == count => 1.0,
                i if i % 2 == 1 => 4.0,
                _ => 2.0,
            } * h
                / 3.0;
            let (area, second) = (width(z).powi(2), width(z).powi(4) / 12.0);
            sums[0] += weight * area;
            sums[1] += weight * area * z;
            sums[2] += weight * (second + area * z * z);
            sums[3] += weight * 2.0 * second;
        }
    };
    for step in 0..4 {
        let (from, wide) = (0.1 * f64::from(step), 2.2 + 0.2 * f64::from(step));
        slices(from, from + 0.1, &|_| wide);
    }
    slices(0.4, 0.9, &|z| 3.0 - 2.0 * (z - 0.4));
    let [mass, height, across, about] = of(roof);
    let middle = sums[1] / sums[0];
    near(mass, 2600.0 * sums[0], "mass");
    near(height, 1.4 + middle, "height");
    assert!((across / (2600.0 * (sums[2] - sums[0] * middle * middle)) - 1.0).abs() < 1e-10);
    assert!((about / (2600.0 * sums[3]) - 1.0).abs() < 1e-10);
    // the roof rests with its lowest step, and the finial on its top
    let bed = stack.joints().iter().find(|joint| joint.upper == 1).unwrap();
    near(bed.patch.moments().area_m2, 2.2 * 2.2, "bed");
    near(stack.blocks()[2].solid.bounds_m()[0][2], 1.4 + 0.9, "top");
    assert_eq!(roof.solid.drawn().len(), 5);
}

#[test]
fn exact_a_mast_of_iron_is_a_cylinder_on_its_finial() {
    let stack = stack(PAGODA);
    let [mass, height, across, about] = of(&stack.blocks()[2]);
    let (stone, iron) = (2600.0 * 0.1, 7850.0 * std::f64::consts::PI * 0.0016 * 1.8);
    near(mass, stone + iron, "mass");
    let middle = (stone * 0.2 + iron * 1.3) / (stone + iron);
    near(height, 2.3 + middle, "height");
    let own = stone * (0.25 + 0.16) / 12.0 + iron * (3.0 * 0.0016 + 3.24) / 12.0;
    let apart = stone * (0.2 - middle).powi(2) + iron * (1.3 - middle).powi(2);
    near(across, own + apart, "across");
    near(about, stone * 0.5 / 12.0 + iron * 0.0008, "about");
    // contact is that of the finial alone
    near(stack.blocks()[2].solid.bounds_m()[1][2], 2.7, "top");
    // without its own density the mast is of stone
    let stony = self::stack(&PAGODA.replace(", density = 7850", ""));
    near(of(&stony.blocks()[2])[0], stone + iron * 2600.0 / 7850.0, "stone");
}

#[test]
fn refuses_a_cornice_without_a_bed_and_a_mast_under_a_stone() {
    let cases = [
        ("setback = 0.1", "setback = 0.4", "leave no bed of a width of 3 m"),
        (
            "shape = \"frustum\", width = 3.0, top_width = 2.0,",
            "shape = \"drum\", diameter = 3.0,",
            "only boxes, frusta and prisms",
        ),
        ("steps = 4", "steps = 0", "steps"),
        (
            "cornice = {",
            "openings = [{ width = 0.2, height = 0.2, position = [0, 0, 0.1] }], cornice = {",
            "has openings as well",
        ),
        (
            "height = 1.4 }",
            "height = 1.4, mast = { height = 1, diameter = 0.1 } }",
            "stands where \"roof\" rests",
        ),
        ("diameter = 0.08", "diameter = -0.08", "mast.diameter"),
    ];
    for (from, to, wanted) in cases {
        let text = PAGODA.replacen(from, to, 1);
        assert_ne!(text, PAGODA);
        let said = parse_project(&text, "pagoda.toml").unwrap_err().to_string();
        assert!(said.contains(wanted), "{to}: {said}");
    }
}
