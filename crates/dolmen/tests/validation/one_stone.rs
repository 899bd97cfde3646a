// SOURCE     Choi (2021) Fig. 8, a pole as one tapered stone; Timoshenko (1921); Greenhill (1881).
// GOAL       Frequencies of columns of tapered shafts, with and without joints, against three other methods.
// PARAMETERS the links of the Naju flagpole as shafts, E 40 GPa, ν 0.2, 2570 kg/m³; a uniform column.
// TOLERANCE  1e-6, as the search promises; 1e-5 if stones a million times stiffer represent rigid ones.
//
//   three other methods: a two-point boundary problem integrated by Runge–Kutta from the top; the chain of rigid links, whose
//   matrices have nothing in common with the beam's; the buckling load of a uniform column, at which its frequency is zero.

use dolmen::known::columns::GREENHILL_COLUMN;
use dolmen::structure::{
    BeamTheory, Chain, Inertia, Jointing, Link, Pole, Section, Shaft, Stone, StructureError,
};

const GRANITE: Stone = Stone {
    elastic_modulus_pa: 40e9,
    poisson_ratio: 0.2,
    density_kg_m3: 2570.0,
};

fn flagpole() -> Pole {
    Pole::of_chain(&crate::choi_2021::naju(), GRANITE).unwrap()
}

fn without_weight(pole: &Pole) -> Pole {
    Pole::new(pole.shafts().to_vec(), GRANITE, 0.0).unwrap()
}

/// Displacement and rotation at the foot for two motions with a free top, as a determinant, which is 0 at a natural
/// frequency.
fn foot(pole: &Pole, shear: bool, omega: f64) -> f64 {
    const STEPS: usize = 400; // a shaft
    let ends = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]].map(|mut state: [f64; 4]| {
        for shaft in pole.shafts().iter().rev() {
            let h = -shaft.length_m / STEPS as f64;
            for i in 0..STEPS {
                let at = |part: f64| 1.0 - (i as f64 + part) / STEPS as f64;
                let slope = |part: f64, [y, psi, m, q]: [f64; 4]| {
                    let mix = |foot: f64, top: f64| foot + at(part) * (top - foot);
                    let depth = mix(shaft.foot.depth_m, shaft.top.depth_m);
                    let area = depth * mix(shaft.foot.breadth_m, shaft.top.breadth_m);
                    let second = area * depth * depth / 12.0;
                    let (e, nu, rho) = (40e9, 0.2, 2570.0);
                    let kappa_g_a = 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu) * e / (2.0 + 2.0 * nu) * area;
                    let of_shear = if shear { 1.0 } else { 0.0 };
                    [
                        psi + of_shear * q / kappa_g_a,
                        m / (e * second),
                        -q - of_shear * rho * second * omega * omega * psi,
                        -rho * area * omega * omega * y,
                    ]
                };
                let add = |a: [f64; 4], b: [f64; 4], f: f64| -> [f64; 4] {
                    std::array::from_fn(|i| a[i] + f * b[i])
                };
                let k1 = slope(0.0, state);
                let k2 = slope(0.5, add(state, k1, 0.5 * h));
                let k3 = slope(0.5, add(state, k2, 0.5 * h));
                let k4 = slope(1.0, add(state, k3, h));
                state =
                    std::array::from_fn(|i| state[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
            }
        }
        state
    });
    ends[0][0] * ends[1][1] - ends[0][1] * ends[1][0]
}

#[test]
fn agrees_with_a_boundary_problem_integrated_from_the_top() {
    let pole = without_weight(&flagpole());
    for (theory, shear) in [
        (BeamTheory::BernoulliEuler, false),
        (BeamTheory::Timoshenko, true),
    ] {
        let found = pole.frequencies(theory, Jointing::OneStone, 3).unwrap().unwrap();
        for f in found.frequencies_hz {
            let omega = std::f64::consts::TAU * f;
            let [below, above] = [1.0 - 1e-6, 1.0 + 1e-6].map(|part| foot(&pole, shear, part * omega));
            assert!(below * above < 0.0, "{theory:?} {f} Hz: {below} {above}");
        }
    }
}

#[test]
fn holds_the_shafts_have_weight_and_centre_of_mass_of_their_links() {
    let chain = crate::choi_2021::naju();
    for (shaft, link) in flagpole().shafts().iter().zip(chain.links()) {
        const SLICES: usize = 2000;
        let (mut mass, mut moment) = (0.0, 0.0);
        for i in 0..SLICES {
            let share = (i as f64 + 0.5) / SLICES as f64;
            let mix = |foot: f64, top: f64| foot + share * (top - foot);
            let area =
                mix(shaft.foot.depth_m, shaft.top.depth_m) * mix(shaft.foot.breadth_m, shaft.top.breadth_m);
            let slice = 2570.0 * area * shaft.length_m / SLICES as f64;
            mass += slice;
            moment += slice * share * shaft.length_m;
        }
        assert!((mass / link.mass_kg - 1.0).abs() < 1e-6);
        assert!((moment / mass / link.centroid_m - 1.0).abs() < 1e-6);
    }
}

/// J of a shaft about its centre of mass, by slices.
fn inertia_kg_m2(shaft: &Shaft, centroid_m: f64) -> f64 {
    const SLICES: usize = 20_000;
    let slice = |i: usize| {
        let share = (i as f64 + 0.5) / SLICES as f64;
        let mix = |foot: f64, top: f64| foot + share * (top - foot);
        let depth = mix(shaft.foot.depth_m, shaft.top.depth_m);
        let area = depth * mix(shaft.foot.breadth_m, shaft.top.breadth_m);
        let mass = 2570.0 * area * shaft.length_m / SLICES as f64;
        mass * ((share * shaft.length_m - centroid_m).powi(2) + depth * depth / 12.0)
    };
    (0..SLICES).map(slice).sum()
}

#[test]
fn agrees_with_the_chain_where_stones_are_rigid() {
    let chain = crate::choi_2021::naju();
    let shafts = flagpole();
    let links: Vec<Link> = chain
        .links()
        .iter()
        .zip(shafts.shafts())
        .map(|(link, shaft)| Link {
            inertia: Inertia::Given(inertia_kg_m2(shaft, link.centroid_m)),
            ..link.clone()
        })
        .collect();
    let chain = Chain::new(links, chain.gravity_m_s2()).unwrap();
    let springs = [2219.1e3, 629.6e3, 193.7e3, 64.95e3, 12.04e3];
    let rigid = Stone {
        elastic_modulus_pa: 40e15,
        ..GRANITE
    };
    let pole = Pole::new(shafts.shafts().to_vec(), rigid, chain.gravity_m_s2()).unwrap();
    let jointing = Jointing::Springs(&springs);
    let found = pole
        .frequencies(BeamTheory::Timoshenko, jointing, 5)
        .unwrap()
        .unwrap();
    for (f, mode) in found
        .frequencies_hz
        .iter()
        .zip(chain.natural_modes(&springs).unwrap())
    {
        assert!(
            (f / mode.frequency_hz - 1.0).abs() < 1e-5,
            "{f} {}",
            mode.frequency_hz
        );
    }
    // flexible stones lower the frequency of every mode, and a single stone has a higher frequency than both
    let bending = shafts
        .frequencies(BeamTheory::Timoshenko, jointing, 5)
        .unwrap()
        .unwrap();
    let whole = shafts
        .frequencies(BeamTheory::Timoshenko, Jointing::OneStone, 5)
        .unwrap()
        .unwrap();
    for i in 0..5 {
        assert!(bending.frequencies_hz[i] < found.frequencies_hz[i]);
        assert!(bending.frequencies_hz[i] < whole.frequencies_hz[i]);
    }
    // springs too soft to support it
    let soft = springs.map(|k| k / 100.0);
    let falls = shafts
        .frequencies(BeamTheory::Timoshenko, Jointing::Springs(&soft), 1)
        .unwrap();
    assert!(falls.is_none());
}

#[test]
fn exact_a_column_falls_at_greenhills_height() {
    let side = Section {
        depth_m: 0.1,
        breadth_m: 0.2,
    };
    let (height_m, gravity) = (10.0_f64, 9.81);
    let line_load = 2570.0 * 0.02 * gravity;
    let second = 0.2 * 0.1_f64.powi(3) / 12.0;
    let critical_pa = line_load * height_m.powi(3) / (GREENHILL_COLUMN * second);
    let shaft = Shaft {
        length_m: height_m,
        foot: side,
        top: side,
    };
    let of = |modulus: f64| {
        let stone = Stone {
            elastic_modulus_pa: modulus,
            ..GRANITE
        };
        let pole = Pole::new(vec![shaft], stone, gravity).unwrap();
        pole.frequencies(BeamTheory::BernoulliEuler, Jointing::OneStone, 1)
    };
    assert!(of(critical_pa * (1.0 - 1e-6)).unwrap().is_none());
    assert!(of(critical_pa * (1.0 + 1e-6)).unwrap().is_some());
}

#[test]
fn exact_a_split_shaft_and_a_turned_section() {
    let whole = without_weight(&flagpole()).shafts()[0];
    let middle = Section {
        depth_m: 0.5 * (whole.foot.depth_m + whole.top.depth_m),
        breadth_m: 0.5 * (whole.foot.breadth_m + whole.top.breadth_m),
    };
    let halves = vec![
        Shaft {
            length_m: 0.5 * whole.length_m,
            top: middle,
            ..whole
        },
        Shaft {
            length_m: 0.5 * whole.length_m,
            foot: middle,
            ..whole
        },
    ];
    let of = |shafts: Vec<Shaft>| {
        let pole = Pole::new(shafts, GRANITE, 9.81).unwrap();
        let found = pole.frequencies(BeamTheory::Timoshenko, Jointing::OneStone, 3);
        found.unwrap().unwrap().frequencies_hz
    };
    for (one, two) in of(vec![whole]).iter().zip(of(halves)) {
        assert!((one / two - 1.0).abs() < 1e-7);
    }
}

#[test]
fn refuses_shafts_that_no_link_is() {
    let link = |centroid_m: f64| Link {
        mass_kg: 1000.0,
        length_m: 2.0,
        centroid_m,
        inertia: Inertia::ThinRod,
        bed_width_m: None,
    };
    let of = |centroid_m| Pole::of_chain(&Chain::new(vec![link(centroid_m)], 9.81).unwrap(), GRANITE);
    assert!(of(0.5).is_ok());
    for centroid_m in [0.49, 1.5] {
        assert!(matches!(
            of(centroid_m),
            Err(StructureError::Centroid { link: 1, .. })
        ));
    }
    let pole = of(1.0).unwrap();
    let refused = |jointing, count| {
        let found = pole.frequencies(BeamTheory::Timoshenko, jointing, count);
        found.unwrap_err().to_string()
    };
    assert_eq!(
        refused(Jointing::OneStone, 11),
        "mode 11 was asked for, but they are numbered from 1 at the bottom to 10"
    );
    assert_eq!(
        refused(Jointing::Springs(&[-1.0]), 1),
        "joint 1: stiffness_n_m_rad is -1, but must be a positive number"
    );
    assert_eq!(
        refused(Jointing::Springs(&[1.0, 1.0]), 1),
        "springs has 2 values, but the pole has 1 shafts"
    );
}
