//! Frequencies of a column of stones with bending: as one stone without joints or cracks (Choi 2021, Fig. 8), or with joint
//! springs.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | E, ν, ρ | `Stone` | elastic constants and density | Pa, , kg/m³ |
//! | h, b | `depth_m`, `breadth_m` | section along and across the motion, linear in height | m |
//! | A, I | `area_m2`, `second_moment_m4` | b h, b h³/12 | m², m⁴ |
//! | κ | `shear_coefficient` | share of A that carries shear | |
//! | N | `axial_n` | weight above | N |
//! | c, γ, ψ, y | `Shape` | curvature ψ', shear strain y' − ψ, rotation of the section, displacement | 1/m, , , |

use super::shaft::{Section, Shaft, Stone, taper};
use super::{Chain, Inertia, StructureError};
use crate::numeric::{gauss_legendre, integral, legendre, second_integral};
use dolmen_linalg::{LinalgError, Matrix, generalized_symmetric_eigen};

/// Deformations of a beam.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BeamTheory {
    /// Bending alone.
    BernoulliEuler,
    /// Bending, shear, and rotatory inertia of the sections.
    Timoshenko,
}

/// Connection between the shafts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Jointing<'a> {
    /// No joints: one stone, clamped at its foot.
    OneStone,
    /// A rotational spring below each shaft, N m/rad, lowest first.
    Springs(&'a [f64]),
}

/// A column of shafts of one material, lowest first.
#[derive(Clone, Debug, PartialEq)]
pub struct Pole {
    shafts: Vec<Shaft>,
    stone: Stone,
    gravity_m_s2: f64,
}

/// Frequencies of a beam, with the accuracy of the computation.
#[derive(Clone, Debug, PartialEq)]
pub struct BeamFrequencies {
    /// The lowest natural frequencies, Hz, ascending.
    pub frequencies_hz: Vec<f64>,
    /// Degree of the polynomials of curvature in each shaft.
    pub degree: usize,
    /// Largest relative change of a frequency from the previous degree.
    pub changed: f64,
}

/// Largest number of shafts: 100 give matrices of 700 rows.
pub const SHAFTS_MOST: usize = 100;
const MODES_MOST: usize = 10;
/// The search ends when the change of degree changes every frequency by less than this fraction; the remaining error is
/// smaller.
const CHANGE_MOST: f64 = 1e-7;
const DEGREES: [usize; 7] = [2, 4, 6, 8, 11, 14, 18];

impl Pole {
    /// Makes a column of shafts, lowest first.
    ///
    /// # Input
    /// * `gravity_m_s2` -- 0 leaves out the weight
    ///
    /// # Errors
    /// [`StructureError::Empty`]; [`StructureError::NotPositive`] for a size or property; [`StructureError::Negative`] for a
    /// size at a top, ν or gravity; [`StructureError::Part`] for more than 100 shafts.
    pub fn new(shafts: Vec<Shaft>, stone: Stone, gravity_m_s2: f64) -> Result<Self, StructureError> {
        if shafts.is_empty() {
            return Err(StructureError::Empty {
                kind: "pole",
                parts: "shafts",
            });
        }
        if shafts.len() > SHAFTS_MOST {
            return Err(StructureError::Part {
                part: "shaft",
                given: shafts.len(),
                most: SHAFTS_MOST,
            });
        }
        for (i, shaft) in shafts.iter().enumerate() {
            positive("shaft", i + 1, "length_m", shaft.length_m)?;
            positive("shaft", i + 1, "depth_m of the foot", shaft.foot.depth_m)?;
            positive("shaft", i + 1, "breadth_m of the foot", shaft.foot.breadth_m)?;
            not_negative("shaft", i + 1, "depth_m of the top", shaft.top.depth_m)?;
            not_negative("shaft", i + 1, "breadth_m of the top", shaft.top.breadth_m)?;
        }
        positive("stone", 1, "elastic_modulus_pa", stone.elastic_modulus_pa)?;
        positive("stone", 1, "density_kg_m3", stone.density_kg_m3)?;
        not_negative("stone", 1, "poisson_ratio", stone.poisson_ratio)?;
        not_negative("pole", 1, "gravity_m_s2", gravity_m_s2)?;
        Ok(Pole {
            shafts,
            stone,
            gravity_m_s2,
        })
    }

    /// The column of a chain: each link is a linearly tapered shaft with the mass, length and centre of mass of the link.
    ///
    /// ```text
    /// r = top/foot of both sizes:   (3 − 4q) r² + (2 − 4q) r + (1 − 4q) = 0,   q = l/L
    /// V = m/ρ = A_foot L (1 + r + r²)/3;   square, or of the link's breadth h at half its length, b = A/h there
    /// ```
    ///
    /// # Errors
    /// [`StructureError::Centroid`] if no linear taper has that centre of mass (below 1/4 or above 3/4 of the length), and
    /// the errors of [`Pole::new`].
    ///
    /// # Limits
    /// The moment of inertia of a link is not used; it follows from the shape of the shaft.
    pub fn of_chain(chain: &Chain, stone: Stone) -> Result<Self, StructureError> {
        let shafts = chain.links().iter().enumerate().map(|(i, link)| {
            let taper = taper(link.centroid_m / link.length_m).ok_or(StructureError::Centroid {
                link: i + 1,
                centroid_m: link.centroid_m,
                length_m: link.length_m,
            })?;
            let foot_m2 =
                3.0 * link.mass_kg / (stone.density_kg_m3 * link.length_m * (1.0 + taper + taper * taper));
            let half = 0.5 * (1.0 + taper); // size at half the length, of that of the foot
            let depth_m = match link.inertia {
                Inertia::Box { breadth_m } => breadth_m / half,
                Inertia::Given(_) | Inertia::ThinRod => foot_m2.sqrt(),
            };
            let foot = Section {
                depth_m,
                breadth_m: foot_m2 / depth_m,
            };
            Ok(Shaft {
                length_m: link.length_m,
                foot,
                top: Section {
                    depth_m: taper * foot.depth_m,
                    breadth_m: taper * foot.breadth_m,
                },
            })
        });
        let shafts = shafts.collect::<Result<Vec<_>, StructureError>>()?;
        Pole::new(shafts, stone, chain.gravity_m_s2())
    }

    /// The shafts, lowest first.
    pub fn shafts(&self) -> &[Shaft] {
        &self.shafts
    }

    /// The lowest natural frequencies under gravity; `None` if the column is unstable.
    ///
    /// ```text
    /// ω² = min  [∫ EI c² + κGA γ² − N y'² dz + Σ k_i φ_i²] / ∫ ρA y² + ρI ψ² dz
    /// ψ = Σ φ + ∫ c,  y = ∫ ψ + γ;   Bernoulli–Euler: γ = 0 and no ρI;   κ = 10(1 + ν)/(12 + 11ν),  G = E/2(1 + ν)
    /// ```
    ///
    /// Curvature and shear strain of each shaft are Legendre polynomials. Their degree increases until no frequency changes
    /// by more than 1e-7.
    ///
    /// # Errors
    /// [`StructureError::Part`] if the number of frequencies is not 1 to 10, [`StructureError::Count`],
    /// [`StructureError::NotPositive`] for a spring, [`StructureError::Linalg`].
    ///
    /// # Limits
    /// Small amplitudes, no cracks, a rigid base (except for its spring). The shear coefficient is constant, so a mode whose
    /// wavelength is as short as the depth is only an estimate.
    ///
    /// # Source
    /// Choi (2021) Fig. 8; Timoshenko, S. P. (1921) Phil. Mag. 41:744-746; κ: Cowper, G. R. (1966) J. Appl. Mech. 33:335-340.
    ///
    /// # Example
    /// ```
    /// use dolmen::structure::{BeamTheory, Jointing, Pole, Section, Shaft, Stone};
    /// let side = Section { depth_m: 0.5, breadth_m: 0.5 };
    /// let stone = Stone { elastic_modulus_pa: 40e9, poisson_ratio: 0.2, density_kg_m3: 2570.0 };
    /// let pole = Pole::new(vec![Shaft { length_m: 10.0, foot: side, top: side }], stone, 0.0)?;
    /// let found = pole.frequencies(BeamTheory::BernoulliEuler, Jointing::OneStone, 1)?.unwrap();
    /// let exact = 3.516015 * (40e9 * 0.25 / 12.0 / 2570.0_f64).sqrt() / (std::f64::consts::TAU * 100.0);
    /// assert!((found.frequencies_hz[0] / exact - 1.0).abs() < 1e-6);
    /// # Ok::<(), dolmen::structure::StructureError>(())
    /// ```
    pub fn frequencies(
        &self,
        theory: BeamTheory,
        jointing: Jointing<'_>,
        count: usize,
    ) -> Result<Option<BeamFrequencies>, StructureError> {
        if !(1..=MODES_MOST).contains(&count) {
            return Err(StructureError::Part {
                part: "mode",
                given: count,
                most: MODES_MOST,
            });
        }
        if let Jointing::Springs(springs) = jointing {
            self.check_springs(springs)?;
        }
        let mut before: Option<Vec<f64>> = None;
        for degree in DEGREES {
            let Some(frequencies_hz) = self.of_degree(theory, jointing, degree, count)? else {
                return Ok(None);
            };
            if let Some(before) = before.filter(|before| before.len() == count) {
                let pairs = frequencies_hz.iter().zip(&before);
                let changed = pairs
                    .map(|(now, then)| (now / then - 1.0).abs())
                    .fold(0.0, f64::max);
                if changed <= CHANGE_MOST {
                    return Ok(Some(BeamFrequencies {
                        frequencies_hz,
                        degree,
                        changed,
                    }));
                }
            }
            before = Some(frequencies_hz);
        }
        Err(LinalgError::NoConvergence {
            what: "frequencies of a pole",
        }
        .into())
    }

    fn check_springs(&self, springs: &[f64]) -> Result<(), StructureError> {
        if springs.len() != self.shafts.len() {
            return Err(StructureError::Count {
                quantity: "springs",
                given: springs.len(),
                kind: "pole",
                needed: self.shafts.len(),
                parts: "shafts",
            });
        }
        for (i, spring) in springs.iter().enumerate() {
            positive("joint", i + 1, "stiffness_n_m_rad", *spring)?;
        }
        Ok(())
    }

    /// The frequencies, Hz, with polynomials of one degree; `None` if the column is unstable.
    fn of_degree(
        &self,
        theory: BeamTheory,
        jointing: Jointing<'_>,
        degree: usize,
        count: usize,
    ) -> Result<Option<Vec<f64>>, StructureError> {
        let stations = self.stations(theory, degree);
        let shapes = self.shapes(theory, jointing, degree, &stations);
        let size = shapes.len();
        let (mut stiffness, mut mass) = (Matrix::zeros(size, size), Matrix::zeros(size, size));
        for i in 0..size {
            for j in 0..=i {
                let (mut bends, mut moves) = (0.0, 0.0);
                for (s, (a, b)) in stations.iter().zip(shapes[i].at.iter().zip(&shapes[j].at)) {
                    bends += s.bending * a.curvature * b.curvature + s.shear * a.strain * b.strain
                        - s.axial * (a.rotation + a.strain) * (b.rotation + b.strain);
                    moves += s.mass * a.moved * b.moved + s.rotary * a.rotation * b.rotation;
                }
                if i == j {
                    bends += shapes[i].spring;
                }
                (stiffness[(i, j)], stiffness[(j, i)]) = (bends, bends);
                (mass[(i, j)], mass[(j, i)]) = (moves, moves);
            }
        }
        // inverted, M φ = (1/ω²) K φ: the lowest frequencies become the largest eigenvalues, which rounding does not affect
        let inverse = match generalized_symmetric_eigen(&mass, &stiffness) {
            Err(LinalgError::NotPositiveDefinite { .. }) => return Ok(None),
            found => found?.values,
        };
        let lowest = inverse.iter().rev().take(count);
        Ok(Some(
            lowest.map(|s| 1.0 / (s.sqrt() * std::f64::consts::TAU)).collect(),
        ))
    }

    /// Quadrature points, lowest first, with their weights in the integrals.
    fn stations(&self, theory: BeamTheory, degree: usize) -> Vec<Station> {
        let points = gauss_legendre(degree + 4); // exact: ρA y² has the degree 2 + 2 (degree + 2)
        let Stone {
            elastic_modulus_pa: e,
            poisson_ratio: nu,
            density_kg_m3: rho,
        } = self.stone;
        let shear_coefficient = 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu);
        let shear_pa = 0.5 * e / (1.0 + nu);
        let volumes: Vec<f64> = self.shafts.iter().map(Shaft::volume_m3).collect();
        let mut stations = Vec::with_capacity(points.len() * self.shafts.len());
        for (i, shaft) in self.shafts.iter().enumerate() {
            let above_m3: f64 = volumes[i + 1..].iter().sum();
            for (place, weight) in &points {
                let section = shaft.section(0.5 * (1.0 + place));
                let (h, b) = (section.depth_m, section.breadth_m);
                let (area_m2, second_moment_m4) = (b * h, b * h * h * h / 12.0);
                let rest = Shaft {
                    length_m: shaft.length_m * 0.5 * (1.0 - place),
                    foot: section,
                    top: shaft.top,
                };
                let axial_n = rho * self.gravity_m_s2 * (above_m3 + rest.volume_m3());
                let dz = 0.5 * weight * shaft.length_m;
                let timoshenko = theory == BeamTheory::Timoshenko;
                stations.push(Station {
                    shaft: i,
                    place: *place,
                    bending: dz * e * second_moment_m4,
                    shear: dz * shear_coefficient * shear_pa * area_m2,
                    axial: dz * axial_n,
                    mass: dz * rho * area_m2,
                    rotary: if timoshenko {
                        dz * rho * second_moment_m4
                    } else {
                        0.0
                    },
                });
            }
        }
        stations
    }

    /// Trial shapes: one for each degree of curvature, each degree of shear strain, and each joint rotation.
    fn shapes(
        &self,
        theory: BeamTheory,
        jointing: Jointing<'_>,
        degree: usize,
        stations: &[Station],
    ) -> Vec<Shape> {
        let mut shapes = Vec::new();
        for (i, shaft) in self.shafts.iter().enumerate() {
            let half = 0.5 * shaft.length_m;
            let above = |station: &Station| self.rise_m(i + 1, station);
            if let Jointing::Springs(springs) = jointing {
                let at = |s: &Station| match s.shaft >= i {
                    true => At {
                        rotation: 1.0,
                        moved: self.rise_m(i, s),
                        ..At::default()
                    },
                    false => At::default(),
                };
                shapes.push(Shape {
                    at: stations.iter().map(at).collect(),
                    spring: springs[i],
                });
            }
            for k in 0..=degree {
                let (turned, moved) = (half * integral(k, 1.0), half * half * second_integral(k, 1.0));
                let bent = |s: &Station| match s.shaft.cmp(&i) {
                    std::cmp::Ordering::Less => At::default(),
                    std::cmp::Ordering::Equal => At {
                        curvature: legendre(k, s.place),
                        rotation: half * integral(k, s.place),
                        moved: half * half * second_integral(k, s.place),
                        ..At::default()
                    },
                    std::cmp::Ordering::Greater => At {
                        rotation: turned,
                        moved: moved + turned * above(s),
                        ..At::default()
                    },
                };
                shapes.push(Shape::free(stations.iter().map(bent).collect()));
                if theory == BeamTheory::BernoulliEuler {
                    continue;
                }
                let sheared = |s: &Station| match s.shaft.cmp(&i) {
                    std::cmp::Ordering::Less => At::default(),
                    std::cmp::Ordering::Equal => At {
                        strain: legendre(k, s.place),
                        moved: half * integral(k, s.place),
                        ..At::default()
                    },
                    std::cmp::Ordering::Greater => At {
                        moved: turned, // the same integral: of strain, not of curvature
                        ..At::default()
                    },
                };
                shapes.push(Shape::free(stations.iter().map(sheared).collect()));
            }
        }
        shapes
    }

    /// Height of a station above the foot of a shaft, m.
    fn rise_m(&self, shaft: usize, station: &Station) -> f64 {
        let between: f64 = self.shafts[shaft..station.shaft].iter().map(|s| s.length_m).sum();
        between + 0.5 * (1.0 + station.place) * self.shafts[station.shaft].length_m
    }
}

/// A quadrature point and its weights: dz times EI, κGA, N, ρA, ρI.
struct Station {
    shaft: usize,
    place: f64,
    bending: f64,
    shear: f64,
    axial: f64,
    mass: f64,
    rotary: f64,
}

/// Value and derivatives of a shape at a station.
#[derive(Clone, Copy, Default)]
struct At {
    curvature: f64,
    strain: f64,
    rotation: f64,
    moved: f64,
}

struct Shape {
    at: Vec<At>,
    spring: f64,
}

impl Shape {
    fn free(at: Vec<At>) -> Self {
        Shape { at, spring: 0.0 }
    }
}

fn positive(
    part: &'static str,
    number: usize,
    quantity: &'static str,
    given: f64,
) -> Result<(), StructureError> {
    match given > 0.0 && given.is_finite() {
        true => Ok(()),
        false => Err(StructureError::NotPositive {
            part,
            number,
            quantity,
            given,
        }),
    }
}

fn not_negative(
    part: &'static str,
    number: usize,
    quantity: &'static str,
    given: f64,
) -> Result<(), StructureError> {
    match given >= 0.0 && given.is_finite() {
        true => Ok(()),
        false => Err(StructureError::Negative {
            part,
            number,
            quantity,
            given,
        }),
    }
}
