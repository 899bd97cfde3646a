// SOURCE     EN 1991-1-4:2005, 4.3 to 4.5; equilibrium of a leaning chain.
// GOAL       Moments in the joints of chains under wind equal those from a quadrature of the pressure over the height, and from equilibrium
//            of each joint in the leaning shape.
//
//        ─→ │ q(z) C_f b_i          M_j = ∫_{z_j} q C_f b (z − z_j) dz + Σ_{i ≥ j} w_i (x_i − x_j)
//       ─→  │                       x from θ_i = θ_{i−1} + M_i/k_i, turn by turn until nothing changes
//
// PARAMETERS 200 random chains of 1 to 8 links, seed below; terrains 0 to IV; load factor 2 to 12.
// PUBLISHED  The formula of the code, written out here with its own constants.
// TOLERANCE  1e-10 relative: Gauss quadrature with 8 points on 40 intervals per link, split at z_min; the iteration converges to rounding.

use crate::draws::Draws;
use dolmen::stability::{BedEdge, ChainLoading, JointHold, LinkLoad, chain_stability, chain_under_loads};
use dolmen::structure::Chain;
use dolmen::structure::wind::{EurocodeTerrain, EurocodeWind, Wind, WindBody, WindPressure};

const RHO: f64 = 1.25;

/// Terrain, z_0, z_min.
const TERRAINS: [(EurocodeTerrain, f64, f64); 5] = [
    (EurocodeTerrain::Zero, 0.003, 1.0),
    (EurocodeTerrain::I, 0.01, 1.0),
    (EurocodeTerrain::Ii, 0.05, 2.0),
    (EurocodeTerrain::Iii, 0.3, 5.0),
    (EurocodeTerrain::Iv, 1.0, 10.0),
];

/// Gauss–Legendre of 8 points on [−1, 1]: half of the nodes, and their weights.
const GAUSS: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_5),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_3),
];

/// q_p(z) of the code.
fn peak_pa(speed_m_s: f64, z0: f64, z_min: f64, z: f64) -> f64 {
    let z = z.max(z_min);
    let k_r = 0.19 * (z0 / 0.05_f64).powf(0.07);
    let mean = speed_m_s * k_r * (z / z0).ln();
    let intensity = 1.0 / (z / z0).ln();
    (1.0 + 7.0 * intensity) * 0.5 * RHO * mean * mean
}

/// ∫ f dz over [from, to], split at `knee`.
fn integral(from: f64, to: f64, knee: f64, f: &dyn Fn(f64) -> f64) -> f64 {
    const PIECES: usize = 40;
    let knee = knee.clamp(from, to);
    let mut sum = 0.0;
    for [a, b] in [[from, knee], [knee, to]] {
        let half = (b - a) / PIECES as f64 / 2.0;
        for piece in 0..PIECES {
            let middle = a + (2 * piece + 1) as f64 * half;
            for (node, weight) in GAUSS {
                sum += weight * half * (f(middle - node * half) + f(middle + node * half));
            }
        }
    }
    sum
}

fn relative(a: f64, b: f64) -> f64 {
    (a - b).abs() / b.abs().max(1e-300)
}

/// Wind on each link of a chain by the closed forms of the crate.
fn link_loads(chain: &Chain, pressure: &WindPressure, widths_m: &[f64], coefficient: f64) -> Vec<LinkLoad> {
    let pairs = chain
        .joint_heights_m()
        .into_iter()
        .zip(chain.links())
        .zip(widths_m);
    let of = |(i, ((bottom_m, link), width_m)): (usize, ((f64, &dolmen::structure::Link), &f64))| {
        let strip = pressure.strip(bottom_m, bottom_m + link.length_m);
        let force_n = coefficient * width_m * strip.force_n_m;
        LinkLoad {
            link: i + 1,
            height_m: 0.0,
            force_n,
            moment_n_m: coefficient * width_m * strip.moment_n - force_n * bottom_m,
        }
    };
    pairs.enumerate().map(of).collect()
}

#[test]
fn holds_joint_moments_of_200_chains_in_wind_are_those_of_a_quadrature() {
    let mut draw = Draws::new(41);
    for case in 0..200 {
        let chain = draw.chain(1 + case % 8);
        let n = chain.links().len();
        let (terrain, z0, z_min) = TERRAINS[case % 5];
        let speed_m_s = draw.between(15.0, 45.0);
        let coefficient = draw.between(0.7, 2.2);
        let widths: Vec<f64> = (0..n).map(|_| draw.between(0.2, 0.8)).collect();
        let wind = Wind::Eurocode(EurocodeWind {
            basic_speed_m_s: speed_m_s,
            terrain,
            orography: 1.0,
            air_density_kg_m3: RHO,
        });
        let stiff = WindBody {
            height_m: chain.height_m(),
            breadth_m: 0.4,
            frequency_hz: Some(6.0),
            damping_ratio: None,
        };
        let pressure = wind.pressure(&stiff).unwrap();
        let loads = link_loads(&chain, &pressure, &widths, coefficient);
        let scattered: Vec<f64> = chain
            .necessary_n_m_rad()
            .iter()
            .map(|m| m * draw.between(0.5, 4.0))
            .collect();
        let now = chain_stability(&chain, &scattered).unwrap().load_factor;
        let factor = draw.between(2.0, 12.0);
        let k: Vec<f64> = scattered.iter().map(|k| k * factor / now).collect();
        let holds = vec![JointHold::Unknown; n];
        let loading = ChainLoading {
            loads: &loads,
            holds: &holds,
            tilt_rad: 0.0,
        };
        let found = chain_under_loads(&chain, Some(&k), &loading).unwrap();

        // by quadrature: moments of the upright chain about each joint
        let joints = chain.joint_heights_m();
        let lengths: Vec<f64> = chain.links().iter().map(|link| link.length_m).collect();
        let upright: Vec<f64> = (0..n)
            .map(|j| {
                let on = |i: usize| {
                    let q =
                        |z: f64| peak_pa(speed_m_s, z0, z_min, z) * coefficient * widths[i] * (z - joints[j]);
                    integral(joints[i], joints[i] + lengths[i], z_min, &q)
                };
                (j..n).map(on).sum()
            })
            .collect();
        // and by iteration: the lean adds the moment of the weight
        let mut moments = upright.clone();
        for _ in 0..400 {
            let mut theta = vec![0.0; n];
            let mut turned = 0.0;
            for j in 0..n {
                turned += moments[j] / k[j];
                theta[j] = turned;
            }
            let mut x = vec![0.0; n + 1];
            for i in 0..n {
                x[i + 1] = x[i] + lengths[i] * theta[i];
            }
            for j in 0..n {
                let lean = |i: usize| {
                    let link = &chain.links()[i];
                    chain.gravity_m_s2() * link.mass_kg * (x[i] + link.centroid_m * theta[i] - x[j])
                };
                moments[j] = upright[j] + (j..n).map(lean).sum::<f64>();
            }
        }
        for (j, joint) in found.joints.iter().enumerate() {
            let rigid = relative(joint.rigid_moment_n_m, upright[j]);
            let leaning = relative(joint.moment_n_m.unwrap(), moments[j]);
            assert!(
                rigid < 1e-10 && leaning < 1e-10,
                "{case} {j}: {rigid:e} {leaning:e}"
            );
        }
    }
}

#[test]
fn exact_a_tilt_is_the_moment_of_what_leans() {
    // one link: k/(k − m g l) times m g l t
    let mut draw = Draws::new(42);
    for _ in 0..50 {
        let chain = draw.chain(1);
        let gravity = chain.gravity_moments_n_m_rad()[0];
        let k = gravity * draw.between(1.5, 9.0);
        let bed = JointHold::Bed(BedEdge {
            width_m: 0.5,
            depth_m: Some(0.5),
            strength_pa: None,
        });
        let push = LinkLoad {
            link: 1,
            height_m: 0.5 * chain.height_m(),
            force_n: 100.0,
            moment_n_m: 7.0,
        };
        let loading = ChainLoading {
            loads: &[push],
            holds: &[bed],
            tilt_rad: 0.002,
        };
        let found = chain_under_loads(&chain, Some(&[k]), &loading).unwrap();
        let grown = k / (k - gravity);
        let weight = chain.links()[0].mass_kg * chain.gravity_m_s2();
        let moment = grown * (50.0 * chain.height_m() + 7.0);
        let tilt = grown * gravity * 0.002;
        let joint = found.joints[0];
        assert!(relative(joint.moment_n_m.unwrap(), moment) < 1e-12);
        assert!(relative(joint.tilt_moment_n_m, tilt) < 1e-12);
        let factor = (0.25 * weight - tilt).max(0.0) / moment;
        assert!((found.factor.unwrap() - factor).abs() < 1e-12 * factor.max(1.0));
    }
}

#[test]
fn holds_a_chain_that_falls_bears_nothing_and_one_without_stiffness_the_least() {
    let mut draw = Draws::new(43);
    let chain = draw.chain(4);
    let push = LinkLoad {
        link: 4,
        height_m: 0.0,
        force_n: 50.0,
        moment_n_m: 0.0,
    };
    let holds = [JointHold::Held; 4];
    let loading = ChainLoading {
        loads: &[push],
        holds: &holds,
        tilt_rad: 0.0,
    };
    let weak: Vec<f64> = chain.necessary_n_m_rad().iter().map(|m| 0.5 * m).collect();
    let falls = chain_under_loads(&chain, Some(&weak), &loading).unwrap();
    assert_eq!((falls.factor, falls.second_order), (Some(0.0), false));
    let unknown = chain_under_loads(&chain, None, &loading).unwrap();
    let top = chain.joint_heights_m()[3];
    assert!((unknown.joints[0].rigid_moment_n_m / (50.0 * top) - 1.0).abs() < 1e-14);
    assert_eq!((unknown.joints[0].moment_n_m, unknown.factor), (None, None));
}
