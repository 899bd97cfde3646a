//! Errors of project files, in both languages, one file per chapter.

mod building;
mod chain;
mod common;
mod damage;
mod damper;
mod faults;
mod frame;
mod framed;
mod keys;
mod limits;
mod loads;
mod log;
mod modes;
mod numbers;
mod parser;
mod records;
mod report;
mod said;
mod schema_words;
mod site;
mod slips;
mod stack;
mod stack_slips;
mod still_mode;
mod study;
mod survey;
mod tabled_surveys;
mod tables;
mod toml;
mod units;
mod whole;

pub(crate) use building::WrongBuilding;
pub(crate) use chain::WrongChain;
pub(crate) use common::Common;
pub(crate) use damage::WrongDamage;
pub(crate) use damper::WrongDamper;
pub(crate) use frame::WrongFrame;
pub(crate) use framed::Framed;
pub(crate) use keys::WrongKey;
pub(crate) use limits::WrongLimits;
pub(crate) use loads::WrongLoads;
pub(crate) use log::WrongLog;
pub(crate) use modes::WrongModes;
pub(crate) use numbers::WrongNumber;
pub(crate) use parser::{AtItsPlace, Expected, OfParser, of_parser};
pub(crate) use records::WrongRecords;
pub(crate) use report::WrongReport;
pub(crate) use said::said;
pub(crate) use schema_words::{Needed, korean, of_schema};
pub(crate) use site::WrongSite;
pub(crate) use slips::Slip;
pub(crate) use stack::WrongStack;
pub(crate) use stack_slips::StackSlip;
pub(crate) use still_mode::StillMode;
pub(crate) use study::WrongStudy;
pub(crate) use survey::WrongSurvey;
pub(crate) use tabled_surveys::WrongSurveys;
pub(crate) use tables::WrongTable;
pub(crate) use toml::WrongToml;
pub(crate) use units::WrongUnit;
pub(crate) use whole::WrongFile;

use crate::building::DamperFault;
use crate::stack::StackFault;
use dolmen_words::Template;
use dolmen_words::message::Both;

/// Words of the file, of which one is needed: "a or b".
pub(crate) fn either<T: AsRef<str>>(words: &[T]) -> Both {
    let words: Vec<&str> = words.iter().map(AsRef::as_ref).collect();
    Both {
        english: words.join(" or "),
        korean: words.join(" 또는 "),
    }
}

/// All templates of errors of project files.
pub const ERRORS: [&[Template]; 33] = [
    Framed::TEMPLATES,
    Common::TEMPLATES,
    WrongToml::TEMPLATES,
    WrongKey::TEMPLATES,
    WrongFile::TEMPLATES,
    WrongNumber::TEMPLATES,
    WrongUnit::TEMPLATES,
    Slip::TEMPLATES,
    WrongModes::TEMPLATES,
    WrongSurveys::TEMPLATES,
    WrongTable::TEMPLATES,
    Needed::TEMPLATES,
    WrongSite::TEMPLATES,
    WrongStack::TEMPLATES,
    StackSlip::TEMPLATES,
    WrongChain::TEMPLATES,
    WrongFrame::TEMPLATES,
    WrongBuilding::TEMPLATES,
    WrongDamage::TEMPLATES,
    WrongDamper::TEMPLATES,
    WrongLoads::TEMPLATES,
    WrongLog::TEMPLATES,
    WrongLimits::TEMPLATES,
    WrongStudy::TEMPLATES,
    WrongSurvey::TEMPLATES,
    OfParser::TEMPLATES,
    Expected::TEMPLATES,
    AtItsPlace::TEMPLATES,
    WrongRecords::TEMPLATES,
    WrongReport::TEMPLATES,
    StackFault::TEMPLATES,
    DamperFault::TEMPLATES,
    StillMode::TEMPLATES,
];
