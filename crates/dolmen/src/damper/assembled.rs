//! Assembles a structure and its dampers into one linear system.

use super::{AttachedDamper, DamperError, DamperKind};
use crate::dynamics::{LinearSystem, RandomInput, RandomLoad, ResponseRow};
use dolmen_linalg::Matrix;
use std::f64::consts::TAU;

/// Structure and dampers as one system. The degrees of freedom of the structure come first, then those of each damper in order: z of a mass
/// (relative to a moving base), w of a liquid (relative to its tube), z and w of a liquid column mass damper.
#[derive(Clone, Debug, PartialEq)]
pub struct DampedSystem {
    /// M, C and K of structure and dampers.
    pub system: LinearSystem,
    dampers: Vec<AttachedDamper>,
    first: Vec<usize>, // index of the first degree of freedom of each damper
    structure: usize,
}

impl DampedSystem {
    /// Assembles the structure with these dampers.
    ///
    /// ```text
    /// tuned mass      M: m ż²/2                      K, C: k, c of z − z₀
    /// liquid column   M: m ż₀²/2 + m α ż₀ ẇ + m ẇ²/2   K, C: m ω², 2 m ζ ω of w
    /// ```
    ///
    /// # Errors
    /// [`DamperError::Row`] for a row of the wrong length; [`DamperError::Argument`] for a damper outside its range.
    pub fn new(structure: &LinearSystem, dampers: &[AttachedDamper]) -> Result<Self, DamperError> {
        let n = structure.degrees_of_freedom();
        let mut size = n;
        let mut first = Vec::new();
        for (i, damper) in dampers.iter().enumerate() {
            check_row(i + 1, &damper.row, n)?;
            damper.kind.check()?;
            first.push(size);
            size += damper.kind.degrees_of_freedom();
        }
        let mut parts =
            [structure.mass(), structure.damping(), structure.stiffness()].map(|matrix| grown(matrix, size));
        for (damper, &at) in dampers.iter().zip(&first) {
            add(&mut parts, damper, at, n);
        }
        let [mass, damping, stiffness] = parts;
        Ok(DampedSystem {
            system: LinearSystem::new(mass, damping, stiffness)?,
            dampers: dampers.to_vec(),
            first,
            structure: n,
        })
    }

    /// Extends a row over the structure with zeros for the degrees of freedom of the dampers.
    pub fn row(&self, structure_row: &[f64]) -> Vec<f64> {
        let mut row = structure_row.to_vec();
        row.resize(self.system.degrees_of_freedom(), 0.0);
        row
    }

    /// Row over all degrees of freedom that gives the stroke of a damper (index from 0): z − z₀ of a mass, w of a liquid column, the
    /// elongation of a dashpot. `None` if there is no such damper.
    pub fn stroke_row(&self, damper: usize) -> Option<Vec<f64>> {
        let of = self.dampers.get(damper)?;
        let mut row = self.row(&[0.0].repeat(self.structure));
        let at = self.first[damper];
        match of.kind {
            DamperKind::TunedMass { .. } | DamperKind::LiquidColumnMass { .. } => {
                for (entry, a) in row.iter_mut().zip(&of.row) {
                    *entry = -a;
                }
                row[at] = 1.0;
            }
            DamperKind::LiquidColumn { .. } => row[at] = 1.0,
            DamperKind::Viscous { .. } => row[..self.structure].copy_from_slice(&of.row),
        }
        Some(row)
    }

    /// Stroke rows of all dampers in order, followed by the rows of the liquid rises in columns on springs.
    pub fn stroke_rows(&self) -> Vec<Vec<f64>> {
        let own = (0..self.dampers.len()).filter_map(|damper| self.stroke_row(damper));
        let apart = |k: &usize| matches!(self.dampers[*k].kind, DamperKind::LiquidColumnMass { .. });
        let liquids = (0..self.dampers.len()).filter(apart);
        own.chain(liquids.filter_map(|damper| self.liquid_row(damper)))
            .collect()
    }

    /// Extends a load on the structure to all degrees of freedom; a moving base also moves the dampers.
    pub fn load(&self, load: &RandomLoad) -> RandomLoad {
        let input = match &load.input {
            RandomInput::Force(force) => RandomInput::Force(self.row(force)),
            RandomInput::Base(influence) => RandomInput::Base(self.influence(influence)),
        };
        RandomLoad {
            input,
            spectrum: load.spectrum.clone(),
        }
    }

    /// Displacement of each degree of freedom for a unit base displacement: a mass on a spring moves with its position; a liquid does not move
    /// in its tube.
    pub fn influence(&self, structure: &[f64]) -> Vec<f64> {
        let mut all = self.row(structure);
        for (damper, &at) in self.dampers.iter().zip(&self.first) {
            if let DamperKind::TunedMass { .. } | DamperKind::LiquidColumnMass { .. } = damper.kind {
                all[at] = damper.row.iter().zip(structure).map(|(a, e)| a * e).sum();
            }
        }
        all
    }

    /// Row that gives the liquid rise w of a damper (index from 0); `None` if the damper has no liquid.
    pub fn liquid_row(&self, damper: usize) -> Option<Vec<f64>> {
        let at = match self.dampers.get(damper)?.kind {
            DamperKind::LiquidColumn { .. } => self.first[damper],
            DamperKind::LiquidColumnMass { .. } => self.first[damper] + 1,
            DamperKind::TunedMass { .. } | DamperKind::Viscous { .. } => return None,
        };
        let mut row = self.row(&[0.0].repeat(self.structure));
        row[at] = 1.0;
        Some(row)
    }

    /// Extends a response of the structure to all degrees of freedom.
    pub fn response(&self, response: &ResponseRow) -> ResponseRow {
        ResponseRow {
            row: self.row(&response.row),
            motion: response.motion,
        }
    }
}

pub(super) fn check_row(damper: usize, row: &[f64], needed: usize) -> Result<(), DamperError> {
    if row.len() != needed || row.iter().any(|a| !a.is_finite()) {
        return Err(DamperError::Row {
            damper,
            given: row.len(),
            needed,
        });
    }
    if row.iter().all(|a| *a == 0.0) {
        return Err(DamperError::Unmoved { damper });
    }
    Ok(())
}

fn grown(matrix: &Matrix, size: usize) -> Matrix {
    let n = matrix.rows();
    Matrix::from_fn(
        size,
        size,
        |i, j| if i < n && j < n { matrix[(i, j)] } else { 0.0 },
    )
}

/// Adds factor × a aᵀ for sparse a.
fn outer(matrix: &mut Matrix, a: &[(usize, f64)], factor: f64) {
    for &(i, x) in a {
        for &(j, y) in a {
            matrix[(i, j)] += factor * x * y;
        }
    }
}

fn add([mass, damping, stiffness]: &mut [Matrix; 3], damper: &AttachedDamper, at: usize, n: usize) {
    let place: Vec<(usize, f64)> = (0..n)
        .map(|i| (i, damper.row[i]))
        .filter(|(_, a)| *a != 0.0)
        .collect();
    // displacement of the mass relative to its position on the structure: z − z₀
    let relative = |own: usize| -> Vec<(usize, f64)> {
        let mut all: Vec<(usize, f64)> = place.iter().map(|(i, a)| (*i, -a)).collect();
        all.push((own, 1.0));
        all
    };
    let mut liquid = |carrier: &[(usize, f64)], own: usize, numbers: [f64; 4]| {
        let [m, alpha, omega, zeta] = numbers;
        // m (α ẋ + ẇ)²/2 + m (1 − α²) ẋ²/2
        let mut moving: Vec<(usize, f64)> = carrier.iter().map(|(i, a)| (*i, alpha * a)).collect();
        moving.push((own, 1.0));
        outer(mass, &moving, m);
        outer(mass, carrier, m * (1.0 - alpha * alpha));
        stiffness[(own, own)] += m * omega * omega;
        damping[(own, own)] += 2.0 * m * zeta * omega;
    };
    match damper.kind {
        DamperKind::TunedMass {
            mass_kg: m,
            frequency_hz,
            damping_ratio,
        } => {
            let omega = TAU * frequency_hz;
            mass[(at, at)] += m;
            outer(stiffness, &relative(at), m * omega * omega);
            outer(damping, &relative(at), 2.0 * m * damping_ratio * omega);
        }
        DamperKind::LiquidColumn {
            liquid_mass_kg,
            length_ratio,
            frequency_hz,
            damping_ratio,
        } => {
            liquid(
                &place,
                at,
                [liquid_mass_kg, length_ratio, TAU * frequency_hz, damping_ratio],
            );
        }
        DamperKind::LiquidColumnMass {
            container_mass_kg,
            liquid_mass_kg,
            length_ratio,
            frequency_hz,
            damping_ratio,
            liquid_frequency_hz,
            liquid_damping_ratio,
        } => {
            let whole = container_mass_kg + liquid_mass_kg;
            let omega = TAU * frequency_hz;
            let numbers = [
                liquid_mass_kg,
                length_ratio,
                TAU * liquid_frequency_hz,
                liquid_damping_ratio,
            ];
            liquid(&[(at, 1.0)], at + 1, numbers);
            mass[(at, at)] += container_mass_kg;
            outer(stiffness, &relative(at), whole * omega * omega);
            outer(damping, &relative(at), 2.0 * whole * damping_ratio * omega);
        }
        DamperKind::Viscous { coefficient_n_s_m } => outer(damping, &place, coefficient_n_s_m),
    }
}
