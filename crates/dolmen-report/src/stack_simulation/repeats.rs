//! Results of runs with small differences.

use crate::document::{Finding, Tone};
use crate::simulated::milli;
use dolmen::assess::DamageState;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::stack::{Repeat, Repeats, StackRuns};

messages! {
    /// Runs with small differences.
    pub(crate) enum Repeated in "stack-simulation.repeats" {
        Spread { runs: usize, differences: Sentence, opening: Sentence, slip: Sentence, left: Sentence, states: Sentence } => {
            en: "Of {runs} runs, each but the first with differences that nobody can measure ({differences}), median and range: opening {opening}, slip {slip}, slip left {left}; damage {states}.",
            ko: "잴 수 없는 작은 차이({differences})를 준 반복 해석 {runs}회(첫 회는 원래 값)의 중앙값과 범위: 벌어짐 {opening}, 미끄러짐 {slip}, 잔류 미끄러짐 {left}; 손상 상태 {states}.",
        },
        Differ { spread: Sentence } => {
            en: "{spread} The damage hangs on differences that nobody can measure: no single run is a verdict.",
            ko: "{spread} 손상이 잴 수 없는 차이에 따라 달라지므로 한 번의 해석으로 판정할 수 없다.",
        },
        Undecided { said: Sentence, runs: usize } => {
            en: "{said} Runs without a verdict, left out: {runs}.",
            ko: "{said} 판정에 이르지 못하여 제외한 해석: {runs}회.",
        },
        Stopped { said: Sentence, runs: usize } => {
            en: "It was stopped before {runs} of the runs were made. {said}",
            ko: "반복 해석 {runs}회를 하기 전에 중단되었다. {said}",
        },
        None { runs: usize } => {
            en: "None of {runs} runs with small differences came to a verdict.",
            ko: "작은 차이를 준 반복 해석 {runs}회 모두 판정에 이르지 못하였다.",
        },
        All { friction: Quantity, edges: Quantity, motion: Quantity } => {
            en: "friction ± {friction}, edges of beds ± {edges}, motion ± {motion}",
            ko: "마찰 ± {friction}, 접합면 모서리 ± {edges}, 지반운동 ± {motion}",
        },
        WithoutEdges { friction: Quantity, motion: Quantity } => {
            en: "friction ± {friction}, motion ± {motion}",
            ko: "마찰 ± {friction}, 지반운동 ± {motion}",
        },
        Range { median: Quantity, least: Quantity, most: Quantity } => {
            en: "{median} ({least} to {most})",
            ko: "{median}({least}~{most})",
        },
        Falls { falls: usize, runs: usize } => {
            en: "In {falls} of {runs} runs a stone fell (DS4), so that the verdict is that of a fall; the run as given is the next line.",
            ko: "해석 {runs}회 중 {falls}회에서 낙하가 발생하여(DS4) 낙하로 판정한다. 입력값 그대로의 해석은 다음 줄과 같다.",
        },
        Fallen { runs: usize } => { en: "DS4 (a stone fell) in {runs}", ko: "DS4(낙하) {runs}회" },
        State { state: usize, runs: usize } => { en: "DS{state} in {runs}", ko: "DS{state} {runs}회" },
        And { first: Sentence, next: Sentence } => { en: "{first}, {next}", ko: "{first}, {next}" },
    }
}

/// The runs in which a stone fell although none fell in the run as given.
pub(super) fn falls(runs: &StackRuns) -> Option<Finding> {
    let (falls, of) = (runs.falls_in_repeats(), runs.repeats.as_ref()?);
    (falls > 0).then(|| {
        let said = Repeated::Falls {
            falls,
            runs: of.runs.len(),
        };
        Finding::key(Tone::Bad, said)
    })
}

/// Their finding.
pub(super) fn finding(repeats: &Repeats) -> Finding {
    let states = repeats.states();
    let Some(said) = spread(repeats) else {
        let runs = repeats.undecided;
        return Finding::key(Tone::Unknown, Repeated::None { runs });
    };
    let (tone, said) = match states.len() > 1 {
        true => (Tone::Warn, Repeated::Differ { spread: said.into() }),
        false => (Tone::Plain, said),
    };
    match repeats.undecided {
        0 => Finding::key(tone, said),
        runs => {
            let said = said.into();
            match repeats.is_stopped {
                true => Finding::key(Tone::Warn, Repeated::Stopped { said, runs }),
                false => Finding::key(tone, Repeated::Undecided { said, runs }),
            }
        }
    }
}

fn spread(repeats: &Repeats) -> Option<Repeated> {
    let range = |of: fn(&Repeat) -> f64| -> Option<Sentence> {
        let spread = repeats.spread(of)?;
        let mm = |value: f64| Quantity::new(value, milli("m"), Digits::Fixed(1));
        let bare = |value: f64| Quantity::new(1e3 * value, Unit::ratio(), Digits::Fixed(1));
        Some(
            Repeated::Range {
                median: mm(spread.median),
                least: bare(spread.least),
                most: mm(spread.most),
            }
            .into(),
        )
    };
    let each = repeats.states().into_iter().map(|(state, runs)| {
        Sentence::from(match state {
            DamageState::Fallen => Repeated::Fallen { runs },
            DamageState::None | DamageState::Begun | DamageState::Offset | DamageState::Severe => {
                let state = usize::from(state.number());
                Repeated::State { state, runs }
            }
        })
    });
    let states = each.reduce(|first, next| Repeated::And { first, next }.into())?;
    Some(Repeated::Spread {
        runs: repeats.runs.len(),
        differences: differences(repeats).into(),
        opening: range(|run| run.peak_opening_m)?,
        slip: range(|run| run.peak_slip_m)?,
        left: range(|run| run.residual_slip_m)?,
        states,
    })
}

fn differences(repeats: &Repeats) -> Repeated {
    let of = &repeats.differences;
    let share = |value: f64| Quantity::new(value, Unit::percent(), Digits::Trimmed(1));
    let (friction, motion) = (share(of.friction_share), share(of.motion_share));
    match repeats.moves_edges {
        true => Repeated::All {
            friction,
            edges: Quantity::new(of.bed_edge_m, milli("m"), Digits::Trimmed(1)),
            motion,
        },
        false => Repeated::WithoutEdges { friction, motion },
    }
}
