//! Builds the matrix of a conic programme from the possible forces.

use super::held_friction::HeldDisc;
use super::limit_pushes::{Column, Push};
use clarabel::algebra::CscMatrix;
use clarabel::solver::SupportedConeT;

/// Rows, cones and costs of a conic programme while it is built.
pub(super) struct Build {
    pub(super) columns: Vec<Column>,
    pub(super) costs: Vec<f64>,
    pub(super) cones: Vec<SupportedConeT<f64>>,
    pub(super) next: usize,
}

impl Build {
    /// Adds the forces of a push; of its stress blocks and discs, those that are chosen.
    pub(super) fn push(&mut self, push: &Push, chosen: &[usize], discs: &[HeldDisc]) {
        match push {
            Push::Cone(parts) => {
                for part in parts {
                    self.row(part);
                }
                self.cones.push(SupportedConeT::SecondOrderConeT(3));
            }
            Push::Normal(part) => {
                self.row(part);
                self.cones.push(SupportedConeT::NonnegativeConeT(1));
            }
            Push::Toes(toes) => {
                // the rate of crushing of the joint, weighted by its whole capacity
                self.bounded(1.0);
                self.cones.push(SupportedConeT::NonnegativeConeT(1));
                let variable = self.columns.len() - 1;
                for toe in chosen.iter().map(|&toe| &toes[toe]) {
                    self.columns[variable].push((self.next, -toe.share));
                    for part in &toe.parts {
                        self.row(part);
                    }
                    self.cones.push(SupportedConeT::SecondOrderConeT(3));
                }
            }
            Push::Held(held) => {
                // the slip rate of the joint, weighted by its whole friction
                self.costs.push(held.strength);
                self.columns.push(Vec::new());
                let variable = self.columns.len() - 1;
                for disc in discs {
                    self.columns[variable].push((self.next, -1.0));
                    self.next += 1;
                    for part in &disc.parts {
                        self.row(part);
                    }
                    self.cones.push(SupportedConeT::SecondOrderConeT(3));
                }
            }
            Push::Disc(parts, strength) => {
                if strength.is_finite() {
                    self.bounded(*strength);
                }
                for part in parts {
                    self.row(part);
                }
                self.cones.push(if strength.is_finite() {
                    SupportedConeT::SecondOrderConeT(3)
                } else {
                    SupportedConeT::ZeroConeT(2)
                });
            }
            Push::Pull(part, strength) => {
                if strength.is_finite() {
                    self.bounded(*strength);
                    let variable = self.columns.len() - 1;
                    self.columns[variable].push((self.next, -1.0));
                }
                self.row(part);
                let rows = if strength.is_finite() { 2 } else { 1 };
                self.cones.push(SupportedConeT::NonnegativeConeT(rows));
            }
        }
    }

    /// Adds a row for one component of force.
    pub(super) fn row(&mut self, part: &Column) {
        for &(row, value) in part {
            self.columns[row].push((self.next, -value));
        }
        self.next += 1;
    }

    /// Adds a row and a variable, the slip, which is weighted by its strength.
    pub(super) fn bounded(&mut self, strength: f64) {
        self.costs.push(strength);
        self.columns.push(vec![(self.next, -1.0)]);
        self.next += 1;
    }

    pub(super) fn matrix(&self) -> CscMatrix<f64> {
        let (mut starts, mut rows, mut values) = (vec![0], Vec::new(), Vec::new());
        for column in &self.columns {
            for &(row, value) in column {
                rows.push(row);
                values.push(value);
            }
            starts.push(rows.len());
        }
        CscMatrix::new(self.next, self.columns.len(), starts, rows, values)
    }
}
