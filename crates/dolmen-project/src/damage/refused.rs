//! Why a damage cannot be included in the model.

use super::model_damage::ModelDamage;
use crate::error::Fault;
use crate::reader::Reader;
use crate::wrong::WrongDamage;

/// A fault at the damage.
pub(super) fn refused(reader: &mut Reader, of: &ModelDamage, why: WrongDamage, help: WrongDamage) {
    let place = reader.place(&of.path);
    let message = WrongDamage::NotCarried {
        part: of.part.clone(),
        survey: of.survey.clone(),
        why: why.into(),
    };
    reader.fault(Fault::new(place, &of.path, message).help(help));
}
