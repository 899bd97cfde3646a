//! Results of two contact laws for one stack, side by side.

use super::ending::ending;
use crate::document::{Cell, Column, Document, Finding, Table, Tone};
use crate::simulated::{milli, seconds};
use dolmen::blocks::{ContactLaw, JointHistory};
use dolmen_words::{Digits, Quantity, Sentence, messages};
use dolmen_work::stack::{LeftOut, StackRuns, StackSimulation};

messages! {
    /// Two laws of contact.
    pub(crate) enum Laws in "stack-simulation.laws" {
        Both { springs: Sentence, rigid: Sentence } => {
            en: "with springs in the joints {springs} With rigid joints {rigid}",
            ko: "접촉 스프링 해석: {springs} 강체 접촉 해석: {rigid}",
        },
        Differ { springs: usize, rigid: usize } => {
            en: "The outcome depends on joint stiffness that nobody measured: DS{springs} with springs of the stiffness assumed, DS{rigid} with rigid joints. The worse one counts. Frequencies of a survey would tell which is nearer.",
            ko: "결과가 실측되지 않은 접합면 강성에 따라 달라진다. 가정한 강성의 접촉 스프링 해석은 DS{springs}, 강체 접촉 해석은 DS{rigid}이며 나쁜 쪽으로 판정한다. 고유진동수를 실측하면 어느 쪽에 가까운지 알 수 있다.",
        },
        DifferMeasured { springs: usize, rigid: usize, survey: String } => {
            en: "The outcome depends on the stiffness of the joints: DS{springs} with springs of the stiffness of the file, DS{rigid} with rigid joints. The worse one counts. «`dolmen identify`|The identification from vibration» says which stiffness the frequencies of survey {survey} ask for; put it into the model.",
            ko: "결과가 접합면 강성에 따라 달라진다. 파일의 강성을 쓴 접촉 스프링 해석은 DS{springs}, 강체 접촉 해석은 DS{rigid}이며 나쁜 쪽으로 판정한다. {survey} 조사의 고유진동수에 맞는 강성을 «`dolmen identify`|진동 평가»로 구하여 모델에 입력한다.",
        },
        TooLong { updates: Quantity, most: Quantity } => {
            en: "Joint stiffness is assumed, and rigid joints were not tried beside it: with so many stones that is slow, about {updates} updates of contact points, beyond {most}. It can be asked for all the same« (--law both)».",
            ko: "접합면 강성은 가정값이나 강체 접촉 해석은 함께 하지 않았다. 부재가 많아 접촉점 갱신이 약 {updates}회로 한도 {most}회를 넘어 오래 걸린다. 필요하면 지정하여 함께 해석할 수 있다«(--law both)».",
        },
        Refused { why: String } => {
            en: "Joint stiffness is assumed, and rigid joints could not be tried beside it: {why}",
            ko: "접합면 강성은 가정값이나 강체 접촉 해석을 함께 할 수 없었다: {why}",
        },
        NoSolution { at: Quantity } => {
            en: "Joint stiffness is assumed. Rigid joints were tried beside it, but their run found no solution at {at} and showed nothing worse until then.",
            ko: "접합면 강성은 가정값이다. 강체 접촉 해석도 하였으나 {at}에 해를 찾지 못하였으며, 그때까지 더 나쁜 결과는 없었다.",
        },
        Caption => { en: "Both laws of contact.", ko: "두 접촉 모델의 비교." },
        Meaning => {
            en: "The largest value of all joints. The worse one decides; details are of that one.",
            ko: "모든 접합면 중 최댓값. 나쁜 쪽으로 판정하며 상세 결과도 그 해석의 것이다.",
        },
        Joints => { en: "Joints", ko: "접촉 모델" },
        Springs => { en: "springs", ko: "접촉 스프링" },
        Rigid => { en: "rigid", ko: "강체 접촉" },
        State => { en: "damage", ko: "손상 상태" },
        Ds { state: usize } => { en: "DS{state}", ko: "DS{state}" },
        Opening => { en: "opening", ko: "벌어짐" },
        Slip => { en: "slip", ko: "미끄러짐" },
        SlipLeft => { en: "slip left", ko: "잔류 미끄러짐" },
    }
}

/// The outcome by each law that was run, beginning with a small letter.
pub(super) fn endings(runs: &StackRuns) -> Sentence {
    match of_both(runs) {
        Some([springs, rigid]) => Laws::Both {
            springs: ending(springs),
            rigid: ending(rigid),
        }
        .into(),
        None => ending(&runs.deciding),
    }
}

/// The runs on springs and with rigid joints, if both were made.
fn of_both(runs: &StackRuns) -> Option<[&StackSimulation; 2]> {
    let other = runs.other.as_ref()?;
    Some(match runs.deciding.law {
        ContactLaw::Springs(_) => [&runs.deciding, other],
        ContactLaw::Rigid(_) => [other, &runs.deciding],
    })
}

/// The difference of the laws, or why one was left out.
pub(super) fn finding(runs: &StackRuns) -> Option<Finding> {
    if let Some([springs, rigid]) = of_both(runs).filter(|_| runs.differing_states().is_some()) {
        let (springs, rigid) = (state(springs), state(rigid));
        let said = match runs.deciding.measured_by.clone() {
            Some(survey) => Laws::DifferMeasured {
                springs,
                rigid,
                survey,
            },
            None => Laws::Differ { springs, rigid },
        };
        return Some(Finding::key(Tone::Warn, said));
    }
    let said = match runs.left_out.as_ref()? {
        LeftOut::TooLong { updates, most } => {
            let count = |number: f64| Quantity::ratio(number, 2);
            Laws::TooLong {
                updates: count(*updates),
                most: count(*most),
            }
        }
        LeftOut::Refused { why } => Laws::Refused { why: why.clone() },
        LeftOut::NoSolution { at_s } => Laws::NoSolution { at: seconds(*at_s) },
    };
    Some(Finding::key(Tone::Plain, said))
}

fn state(run: &StackSimulation) -> usize {
    usize::from(run.counted_damage().number())
}

/// The result of each law, if both were run.
pub(super) fn section(document: &mut Document<'_>, runs: &StackRuns) {
    let Some(both) = of_both(runs) else {
        return;
    };
    let row = |run: &StackSimulation| {
        let most = |of: fn(&JointHistory) -> f64| {
            let joints = run.history.joints.iter();
            let most = joints.map(of).fold(0.0, f64::max);
            Cell::number(Quantity::new(most, milli("m"), Digits::Significant(3)))
        };
        let law = match run.law {
            ContactLaw::Springs(_) => Laws::Springs,
            ContactLaw::Rigid(_) => Laws::Rigid,
        };
        vec![
            Cell::words(law),
            Cell::words(Laws::Ds { state: state(run) }),
            most(|joint| joint.peak_opening_m),
            most(|joint| joint.peak_slip_m),
            most(|joint| joint.residual_slip_m()),
        ]
    };
    document.put(crate::document::Block::Table(Table {
        caption: vec![Laws::Caption.into(), Laws::Meaning.into()],
        columns: vec![
            Column::words(Laws::Joints),
            Column::words(Laws::State),
            Column::numbers(Laws::Opening, milli("m")),
            Column::numbers(Laws::Slip, milli("m")),
            Column::numbers(Laws::SlipLeft, milli("m")),
        ],
        rows: both.into_iter().map(row).collect(),
    }));
}
