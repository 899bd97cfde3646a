//! Vaults and domes: from their keys, and to the stones that the library makes.

use super::file::{BondRaw, DomePieceRaw, DomeRaw, VaultRaw};
use super::made::{ABUTMENT, ANY_DENSITY_KG_M3, tried};
use super::made_part::{BondPart, DomePart, DomePiecePart, VaultPart};
use crate::file_number::At;
use crate::measure::{Bound, Measure};
use crate::quantity::{Pick, Quantity};
use crate::reader::Reader;
use dolmen::structure::stack::{
    Block, Bond, DomeFactors, DomePart as DomePiece, StackError, VaultFactors, dome, vault,
};

/// Most voussoirs of a section and stones of a course, as in the library.
const VOUSSOIRS_MOST: usize = 400;
const STONES_OF_COURSE_MOST: usize = 100;
/// Most rings, and least and most stones of a ring, as in the library.
const RINGS_MOST: usize = 40;
const STONES: (usize, usize) = (6, 48);

fn bond_part(raw: Option<&At<BondRaw>>) -> BondPart {
    match raw.map(|bond| bond.value) {
        Some(BondRaw::Straight) => BondPart::Straight,
        Some(BondRaw::Running) | None => BondPart::Running,
    }
}

impl BondPart {
    fn bond(self) -> Bond {
        match self {
            BondPart::Running => Bond::Running,
            BondPart::Straight => Bond::Straight,
        }
    }
}

/// A vault and the names of its stones; impossible dimensions are rejected here.
pub(super) fn vault_part(reader: &mut Reader, raw: &At<VaultRaw>) -> Option<(VaultPart, Vec<String>)> {
    reader.mark("vault", &raw.span);
    let before = reader.faults.len();
    let given = &raw.value;
    let voussoirs = reader.count(given.voussoirs.as_ref(), "vault.voussoirs", 2, VOUSSOIRS_MOST);
    let stones = reader.count(given.stones.as_ref(), "vault.stones", 1, STONES_OF_COURSE_MOST);
    let mut of =
        |raw, key: &str, bound| reader.quantity(raw, &format!("vault.{key}"), Measure::Length, bound);
    let span = of(given.span.as_ref(), "span", Bound::Positive);
    let rise = of(given.rise.as_ref(), "rise", Bound::Positive);
    let thickness = of(given.thickness.as_ref(), "thickness", Bound::Positive);
    let length = of(given.length.as_ref(), "length", Bound::Positive);
    let springing_height = of(
        given.springing_height.as_ref(),
        "springing_height",
        Bound::NotNegative,
    );
    let abutment = of(given.abutment.as_ref(), "abutment", Bound::Positive);
    (reader.faults.len() == before).then_some(())?;
    let count = |count: usize| u32::try_from(count).ok();
    let part = VaultPart {
        span: span?,
        rise,
        thickness: thickness?,
        length: length?,
        voussoirs: voussoirs.and_then(count)?,
        stones: stones.and_then(count)?,
        bond: bond_part(given.bond.as_ref()),
        springing_height,
        abutment,
    };
    let made = part.made(ANY_DENSITY_KG_M3, &mut Quantity::nominal);
    let names = tried(reader, raw.span.clone(), "vault", made)?;
    Some((part, names))
}

/// A dome and the names of its stones.
pub(super) fn dome_part(reader: &mut Reader, raw: &At<DomeRaw>) -> Option<(DomePart, Vec<String>)> {
    reader.mark("dome", &raw.span);
    let before = reader.faults.len();
    let given = &raw.value;
    let rings = reader.count(given.rings.as_ref(), "dome.rings", 1, RINGS_MOST);
    let stones = reader.count(given.stones.as_ref(), "dome.stones", STONES.0, STONES.1);
    let is_lune = given.part.as_ref().map(|part| part.value) == Some(DomePieceRaw::Lune);
    let mut of = |raw, key: &str, bound| reader.quantity(raw, &format!("dome.{key}"), Measure::Length, bound);
    let span = of(given.span.as_ref(), "span", Bound::Positive);
    let rise = of(given.rise.as_ref(), "rise", Bound::Positive);
    let thickness = of(given.thickness.as_ref(), "thickness", Bound::Positive);
    let oculus = of(given.oculus.as_ref(), "oculus", Bound::Positive);
    let drum_height = of(given.drum_height.as_ref(), "drum_height", Bound::NotNegative);
    let drum_thickness = of(given.drum_thickness.as_ref(), "drum_thickness", Bound::Positive);
    (reader.faults.len() == before).then_some(())?;
    let count = |count: usize| u32::try_from(count).ok();
    let part = DomePart {
        span: span?,
        rise,
        thickness: thickness?,
        rings: rings.and_then(count)?,
        stones: stones.and_then(count)?,
        piece: match is_lune {
            true => DomePiecePart::Lune,
            false => DomePiecePart::Whole(bond_part(given.bond.as_ref())),
        },
        oculus,
        drum_height,
        drum_thickness,
    };
    let made = part.made(ANY_DENSITY_KG_M3, &mut Quantity::nominal);
    let names = tried(reader, raw.span.clone(), "dome", made)?;
    Some((part, names))
}

impl VaultPart {
    /// Its stones, each dimension with the value that `pick` chooses.
    ///
    /// # Errors
    /// [`StackError`] for impossible dimensions.
    pub fn made(&self, density_kg_m3: f64, pick: Pick<'_>) -> Result<Vec<Block>, StackError> {
        let (span_m, thickness_m) = (pick(&self.span), pick(&self.thickness));
        vault(&VaultFactors {
            span_m,
            rise_m: self.rise.as_ref().map_or(0.5 * span_m, &mut *pick),
            thickness_m,
            length_m: pick(&self.length),
            voussoirs: self.voussoirs,
            stones: self.stones,
            bond: self.bond.bond(),
            springing_height_m: self.springing_height.as_ref().map_or(0.0, &mut *pick),
            abutment_m: self.abutment.as_ref().map_or(ABUTMENT * thickness_m, &mut *pick),
            density_kg_m3,
        })
    }

    pub(super) fn inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        all.push(&self.span);
        all.extend(&self.rise);
        all.extend([&self.thickness, &self.length]);
        all.extend(&self.springing_height);
        all.extend(&self.abutment);
    }
}

impl DomePart {
    /// Its stones, each dimension with the value that `pick` chooses.
    ///
    /// # Errors
    /// [`StackError`] for impossible dimensions.
    pub fn made(&self, density_kg_m3: f64, pick: Pick<'_>) -> Result<Vec<Block>, StackError> {
        let (span_m, thickness_m) = (pick(&self.span), pick(&self.thickness));
        dome(&DomeFactors {
            span_m,
            rise_m: self.rise.as_ref().map_or(0.5 * span_m, &mut *pick),
            thickness_m,
            rings: self.rings,
            stones: self.stones,
            part: match self.piece {
                DomePiecePart::Whole(bond) => DomePiece::Whole(bond.bond()),
                DomePiecePart::Lune => DomePiece::Lune,
            },
            oculus_m: self.oculus.as_ref().map(&mut *pick),
            drum_height_m: self.drum_height.as_ref().map_or(0.0, &mut *pick),
            drum_thickness_m: self
                .drum_thickness
                .as_ref()
                .map_or(ABUTMENT * thickness_m, &mut *pick),
            density_kg_m3,
        })
    }

    pub(super) fn inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        all.push(&self.span);
        all.extend(&self.rise);
        all.push(&self.thickness);
        all.extend(&self.oculus);
        all.extend(&self.drum_height);
        all.extend(&self.drum_thickness);
    }
}
