//! Events near a change in time.

use dolmen_project::WorkKind;
use dolmen_words::messages;
use dolmen_work::watched::WatchAnswer;

messages! {
    /// Why, or what stands near in time.
    pub(crate) enum Cause in "watch.cause" {
        Nothing => { en: "", ko: "" },
        Sensors { number: usize, what: String } => { en: ", and work {number} on the sensors fell into that time ({what})", ko: ". 그 사이에 센서 작업({number}번: {what})이 있었다" },
        Event { number: usize, what: String } => { en: ", as event {number} fell into that time ({what})", ko: ". 그 사이에 사건({number}번: {what})이 있었다" },
    }
}

/// The work between two days that may have caused a change; events precede work on sensors.
pub(super) fn cause(answer: &WatchAnswer, [from, to]: [f64; 2]) -> Cause {
    let within = |kind: WorkKind| {
        let mut all = answer.works.iter().enumerate();
        let found = all.find(|(_, (when, work))| work.kind == kind && (from..=to).contains(when));
        found.map(|(i, (_, work))| (i + 1, work.what.clone().unwrap_or_else(|| work.date.clone())))
    };
    match (within(WorkKind::Event), within(WorkKind::Sensors)) {
        (Some((number, what)), _) => Cause::Event { number, what },
        (None, Some((number, what))) => Cause::Sensors { number, what },
        (None, None) => Cause::Nothing,
    }
}
