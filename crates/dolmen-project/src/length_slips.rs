//! A wrong unit of length for the whole file: one fault at `units.length` instead of one for each stone.

use super::content::Structure;
use super::error::Fault;
use super::quantity::Quantity;
use super::reader::Reader;
use super::wrong::Slip;
use std::collections::BTreeMap;

/// Number of suspicious lengths from which they count as one slip. Our choice: two may be separate slips.
const SLIPS_LEAST: usize = 3;
/// Share of suspicious bare lengths from which the unit of the file is the cause. Our choice.
const SHARE_LEAST: f64 = 0.25;
/// Units of length that a slip may propose.
const UNITS: [&str; 3] = ["mm", "cm", "m"];

/// Replaces many faults by one, where most of them propose the same other unit of length.
pub(super) fn one_for_all(reader: &mut Reader, text: &str, structure: &Structure) {
    let span = reader.place("units.length");
    let given = text.get(span.clone()).filter(|_| !span.is_empty());
    let unit = given.map_or("m", |written| written.trim_matches(['"', '\'']));
    let inputs = structure.inputs();
    let is_bare = |input: &&&Quantity| {
        let written = text.get(reader.place(&input.path)).unwrap_or("a");
        input.unit == "m" && !written.chars().any(char::is_alphabetic)
    };
    let bare: Vec<&str> = inputs
        .iter()
        .filter(is_bare)
        .map(|input| input.path.as_str())
        .collect();
    let mut asked: BTreeMap<&str, usize> = BTreeMap::new();
    let mut slips = 0;
    for fault in &reader.faults {
        if !bare.contains(&fault.path.as_str()) {
            continue;
        }
        let meant = UNITS
            .into_iter()
            .filter(|meant| fault.asks_for(meant) && *meant != unit);
        let meant: Vec<&str> = meant.collect();
        slips += usize::from(!meant.is_empty());
        for one in meant {
            *asked.entry(one).or_default() += 1;
        }
    }
    let Some((meant, votes)) = asked.into_iter().max_by_key(|(_, votes)| *votes) else {
        return;
    };
    let is_of_all = slips >= SLIPS_LEAST && 2 * votes > slips;
    if !is_of_all || (slips as f64) < SHARE_LEAST * bare.len() as f64 {
        return;
    }
    let (unit, meant) = (unit.to_owned(), meant.to_owned());
    let bare: Vec<String> = bare.into_iter().map(str::to_owned).collect();
    let is_of_length =
        |fault: &Fault| bare.contains(&fault.path) && UNITS.into_iter().any(|of| fault.asks_for(of));
    reader.faults.retain(|fault| !is_of_length(fault));
    let message = Slip::LengthsAllOff { count: slips, unit };
    let fault = Fault::new(span.clone(), "units.length", message).help(Slip::MeantUnitOfLength(meant));
    reader.fault(match span.is_empty() {
        true => fault.at_top(),
        false => fault,
    });
}
