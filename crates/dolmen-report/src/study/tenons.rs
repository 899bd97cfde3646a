//! Tenons that crush in the runs of a study of a frame.

use super::words::{self, g};
use crate::document::{Finding, Tone};
use crate::simulated::millimetres;
use dolmen_words::{Quantity, Sentence, messages};
use dolmen_work::study::StudyAnswer;

messages! {
    /// Crushed tenons.
    pub(crate) enum Crushed in "study.tenons" {
        Crush { crushed: usize, scans: Sentence, least: Quantity, depth: Quantity } => {
            en: "In {crushed} of {scans} tenons crush, the weakest at {least}; the deepest is crushed by {depth}. That damage stays, and counts with the first state.",
            ko: "{scans} 중 {crushed}건에서 장부가 압괴하며, 그 최소 가속도는 {least}, 최대 압괴 깊이는 {depth}이다. 남는 손상이므로 첫째 손상상태로 센다.",
        },
        None { scans: Sentence, largest: Quantity } => {
            en: "In none of {scans} do tenons crush, up to {largest}.",
            ko: "{scans} 모두 {largest}까지 장부가 압괴하지 않는다.",
        },
    }
}

/// How many scans crush tenons, and from which peak; `None` if none of the runs has tenons that can.
pub(super) fn finding(answer: &StudyAnswer) -> Option<Finding> {
    let found = answer.crushed_tenons()?;
    let scans = words::scans(found.scans);
    Some(match found.least_m_s2 {
        Some(least) => Finding::key(
            Tone::Warn,
            Crushed::Crush {
                crushed: found.crushed,
                scans,
                least: g(answer, least),
                depth: millimetres(found.depth_m),
            },
        ),
        None => Finding::key(
            Tone::Plain,
            Crushed::None {
                scans,
                largest: g(answer, found.largest_m_s2),
            },
        ),
    })
}
