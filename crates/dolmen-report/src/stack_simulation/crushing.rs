//! Edges and corners of stones that crush in a run.

use super::ending::lower_words;
use crate::document::{Finding, Tone};
use crate::simulated::{kilo, seconds};
use crate::stack::megapascals;
use dolmen::blocks::{PeakBearing, StackHistory};
use dolmen::structure::stack::{Body, Stack};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// Crushing in a run.
    pub(crate) enum Crushed in "stack-simulation.crushing" {
        Crushes { upper: String, lower: Sentence, at: Quantity, ratio: Quantity, force: Quantity, x: Quantity, y: Quantity, z: Quantity, strength: Quantity } => {
            en: "The stone crushes between '{upper}' and '{lower}': at {at} they press with {force} at x = {x}, y = {y}, z = {z}, {ratio} times what the bed bears there with a strength of {strength}.",
            ko: "‘{upper}’와(과) ‘{lower}’ 사이의 석재가 압괴한다: {at}에 x = {x}, y = {y}, z = {z}에서 {force}의 힘이 작용하며, 이는 압축강도 {strength}로 그 위치의 접합면이 지지하는 힘의 {ratio}배이다.",
        },
        Others { joints: usize } => {
            en: "Further joints whose edges crush: {joints}.",
            ko: "모서리가 압괴하는 그 밖의 접합면: {joints}개.",
        },
        Bears { upper: String, lower: Sentence, at: Quantity, ratio: Quantity } => {
            en: "No edge crushes: the most loaded bed, of '{upper}' on '{lower}', bears {ratio} of what it can, at {at}.",
            ko: "압괴하는 모서리는 없다: 하중이 가장 큰 ‘{lower}’ 위 ‘{upper}’의 접합면은 {at}에 지지할 수 있는 힘의 {ratio}배를 받는다.",
        },
    }
}

/// The joint with the largest load over what its bed bears, in any of the runs, and the number of the others that crush; nothing without a strength.
pub(super) fn findings(stack: &Stack, histories: &[&StackHistory]) -> Vec<Finding> {
    let peak_of = |joint: usize| {
        let each = histories.iter();
        let peaks = each.filter_map(|history| history.joints.get(joint)?.bearing);
        peaks.max_by(|a, b| a.ratio.total_cmp(&b.ratio))
    };
    let peaks: Vec<(usize, PeakBearing)> = (0..stack.joints().len())
        .filter_map(|joint| Some((joint, peak_of(joint)?)))
        .collect();
    let Some((joint, peak)) = peaks.iter().max_by(|a, b| a.1.ratio.total_cmp(&b.1.ratio)) else {
        return Vec::new();
    };
    let of = &stack.joints()[*joint];
    let upper = stack.name(Body::Block(of.upper)).to_owned();
    let lower = lower_words(stack.name(of.lower));
    let (at, ratio) = (seconds(peak.at_s), Quantity::beside_one(peak.ratio, 3));
    if !peak.crushes() {
        return vec![Finding::new(
            Tone::Plain,
            Crushed::Bears {
                upper,
                lower,
                at,
                ratio,
            },
        )];
    }
    let metres = |value_m: f64| Quantity::new(value_m, Unit::si("m"), Digits::Fixed(3));
    let said = Crushed::Crushes {
        upper,
        lower,
        at,
        ratio,
        force: Quantity::new(peak.force_n, kilo("N"), Digits::Significant(3)),
        x: metres(peak.place_m[0]),
        y: metres(peak.place_m[1]),
        z: metres(peak.place_m[2]),
        strength: megapascals(of.material.compressive_strength_pa.unwrap_or_default()),
    };
    let mut all = vec![Finding::key(Tone::Warn, said)];
    let joints = peaks.iter().filter(|(_, peak)| peak.crushes()).count() - 1;
    if joints > 0 {
        all.push(Finding::key(Tone::Warn, Crushed::Others { joints }));
    }
    all
}
