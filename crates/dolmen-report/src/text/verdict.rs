//! The verdict of `dolmen check` as text: what decided it, and what speaks against it.

use super::stack::stack_verdict;
use dolmen::stability::Verdict;
use dolmen_words::Language;
use dolmen_words::number::beside_one;
use dolmen_work::judgement::VersionJudgement;
use dolmen_work::state::{Check, State, TiltCheck};
use std::fmt::Write as _;

/// A chance of falling whose upper bound is above this stands beside the verdict. Chosen here.
const SAID_LEAST: f64 = 0.01;
/// Load factors above this are asked about. Chosen here: measured timber frames and stone poles have 5 to 100.
const LOAD_FACTOR_USUAL_MOST: f64 = 500.0;

/// The words of the judgement, the reason of its word on weight, and what stands beside it.
pub(super) fn verdict_line(state: &State, judgement: &VersionJudgement) -> String {
    let verdict = state.verdict();
    let worst_tilt = state.tilts.iter().find(|tilt| tilt.verdict() == verdict);
    let why = match (state.stability_verdict(), state.load_factor()) {
        (_, None) if matches!(state.check, Check::Stack(_)) => match &state.check {
            Check::Stack(answer) => stack_verdict(answer),
            Check::Chain(_) | Check::Frame(_) | Check::Building(_) => String::new(),
        },
        (own, Some(factor)) if own != verdict && worst_tilt.is_some() => format!(
            "load factor {} upright, but it leans as measured below",
            beside_one(factor, 5)
        ),
        (_, Some(f64::INFINITY)) => {
            "no axial force is given, so P-delta says nothing of stability".to_owned()
        }
        (Verdict::Unknown, Some(_)) => {
            "the stiffness is not known in every direction [joints-unknown]".to_owned()
        }
        (Verdict::Unknown, None) => {
            "the stiffness is not known; the limits below say what it must be [joints-unknown]".to_owned()
        }
        (own, Some(factor)) if Verdict::of_load_factor(factor) == own => {
            format!(
                "load factor {}: {} [load-factor]",
                beside_one(factor, 5),
                threshold(own)
            )
        }
        (own, Some(stuck)) => format!(
            "load factor {} once its joints slip, {} while they stick: {} [load-factor]",
            state
                .slipping_load_factor()
                .map_or("-".to_owned(), |factor| beside_one(factor, 5)),
            beside_one(stuck, 5),
            match own {
                Verdict::Unstable => "friction alone keeps it from falling under its own weight".to_owned(),
                _ => threshold(own),
            }
        ),
        (_, None) => String::new(),
    };
    let but = match judgement.evidence.is_contradicted() {
        false => "",
        true => "; BUT a survey contradicts this model",
    };
    let words = judgement.words(Language::English).join("; ");
    let mut out = format!("\nVERDICT {words}: {why}{but}\n");
    if let Some(sampled) = state
        .sampled
        .as_ref()
        .filter(|sampled| sampled.unstable.upper > SAID_LEAST)
    {
        let falls = &sampled.unstable;
        let _ = writeln!(
            out,
            "  at the mean values; with the scatter given it falls under its own weight in {} of {} samples, {:.1} % [probability]",
            falls.count,
            falls.samples,
            100.0 * falls.estimate
        );
    }
    if let Some(factor) = state
        .load_factor()
        .filter(|factor| factor.is_finite() && *factor > LOAD_FACTOR_USUAL_MOST)
    {
        let _ = writeln!(
            out,
            "  UNUSUAL: a load factor of {} is far above what timber frames and stone poles have ({LOAD_FACTOR_USUAL_MOST} at most): are masses and \
             stiffness in\n  the units of the file? [unit-slip]",
            beside_one(factor, 5)
        );
    }
    for tilt in &state.tilts {
        out += &tilt_line(tilt, &state.check);
    }
    for c in &state.contradictions {
        let _ = writeln!(
            out,
            "CONTRADICTION: survey {} measured {:.4} Hz in direction {}, this model has {:.4} Hz: its stiffness or mass is \
             not that of the\n  structure that was measured, and the verdict is on the model",
            c.survey, c.measured_hz, c.direction, c.computed_hz
        );
    }
    out
}

/// What a measured tilt means for overturning, which the load factor does not see.
fn tilt_line(tilt: &TiltCheck, check: &Check) -> String {
    let measured = format!(
        "measured tilt 1/{:.0} ({}, survey {})",
        1.0 / tilt.tilt.abs(),
        tilt.direction,
        tilt.survey
    );
    match (tilt.uplift_tilt, tilt.verdict()) {
        (None, _) if matches!(check, Check::Frame(_) | Check::Building(_)) => {
            format!(
                "  {measured}: not used, storeys start plumb here; what leans pushes sideways with that share of its weight\n"
            )
        }
        (None, _) => {
            format!("  {measured}: not checked against overturning (needs joint stiffness and bed_width)\n")
        }
        (Some(limit), Verdict::Unstable) => {
            format!(
                "  {measured}: OVERTURNS, a bed is on its edge at 1/{:.0}\n",
                1.0 / limit
            )
        }
        (Some(limit), verdict) => {
            let opens = if 3.0 * tilt.tilt.abs() >= limit {
                "; beds have begun to open (a third of it)"
            } else {
                ""
            };
            format!(
                "  {measured}: {}, a bed is on its edge at 1/{:.0}{opens}\n",
                verdict.word(),
                1.0 / limit
            )
        }
    }
}

fn threshold(verdict: Verdict) -> String {
    let marginal = Verdict::MARGINAL_BELOW;
    match verdict {
        Verdict::Unstable => "it falls under its own weight (1 or less)".to_owned(),
        Verdict::Marginal => format!("it stands, with less than {marginal} in hand"),
        Verdict::Stable => format!("at least {marginal}"),
        Verdict::Unknown => String::new(),
    }
}
