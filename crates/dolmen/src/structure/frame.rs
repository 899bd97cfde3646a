//! Frame: rigid storeys with P-delta, as a timber gate (Park & Min 2010).
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | m_i | `mass_kg` | mass of storey i, 1 the lowest | kg |
//! | l_i | `height_m` | column height of storey i | m |
//! | N_i | `axial_n` | gravity load that storey i carries: its own level and all above | N |
//! | k_i | stiffness | lateral stiffness of storey i, by [`Convention`] | N/m |
//! | Y_i | | lateral displacement of level i relative to the ground | m |

use super::StructureError;

/// What the spring k_i acts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Convention {
    /// The storey drift Y_i − Y_{i−1}: a storey of columns.
    Drift,
    /// The displacement relative to the ground Y_i, as eq. 7 of the source is printed.
    Grounded,
}

/// One storey.
#[derive(Clone, Debug, PartialEq)]
pub struct Storey {
    /// Mass at its top, kg.
    pub mass_kg: f64,
    /// Column height, m.
    pub height_m: f64,
    /// Axial force in it, N: the gravity loads of its top and all above. 0 leaves P-delta out.
    pub axial_n: f64,
}

/// A frame of rigid storeys in one direction, lowest first, checked.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    storeys: Vec<Storey>,
    convention: Convention,
}

impl Frame {
    /// A frame of storeys, lowest first.
    ///
    /// # Errors
    /// [`StructureError::Empty`], [`StructureError::NotPositive`].
    pub fn new(storeys: Vec<Storey>, convention: Convention) -> Result<Self, StructureError> {
        if storeys.is_empty() {
            return Err(StructureError::Empty {
                kind: "frame",
                parts: "storeys",
            });
        }
        for (i, storey) in storeys.iter().enumerate() {
            for (quantity, given) in [("mass_kg", storey.mass_kg), ("height_m", storey.height_m)] {
                if !(given > 0.0 && given.is_finite()) {
                    return Err(StructureError::NotPositive {
                        part: "storey",
                        number: i + 1,
                        quantity,
                        given,
                    });
                }
            }
        }
        Ok(Frame { storeys, convention })
    }

    /// The storeys, lowest first.
    pub fn storeys(&self) -> &[Storey] {
        &self.storeys
    }

    /// What the springs act on.
    pub fn convention(&self) -> Convention {
        self.convention
    }
}
