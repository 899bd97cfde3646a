//! Which poles can be modes at all, and which come back from one model order to the next.

use super::Pole;
use super::indicators::assurance;

/// Criteria of [`stabilize`].
#[derive(Clone, Debug, PartialEq)]
pub struct Criteria {
    /// Lowest frequency, Hz; default 0.
    pub frequency_low_hz: f64,
    /// Highest frequency, Hz; default none (infinite).
    pub frequency_high_hz: f64,
    /// Largest damping ratio; default 0.15: above any structure in ambient motion without dampers (ours).
    pub damping_ratio_most: f64,
    /// Least modal phase collinearity, 0 to 1; default 0.4 (ours: of two modes 2 % apart, 10 minutes show shapes
    /// that are not quite real).
    pub phase_collinearity_least: f64,
    /// Largest mean phase deviation over a right angle, 0 to 1; default 0.45 (ours).
    pub phase_deviation_most: f64,
    /// Largest change of frequency to the order below, relative; default 0.01 (Peeters & De Roeck 1999).
    pub frequency_change_most: f64,
    /// Largest change of damping ratio to the order below, relative; default 0.3 (ours: its scatter is that wide in
    /// 10 minutes).
    pub damping_change_most: f64,
    /// Least assurance of the shape with the order below; default 0.95 (ours; Peeters & De Roeck take 0.98).
    pub assurance_least: f64,
}

impl Default for Criteria {
    fn default() -> Self {
        Criteria {
            frequency_low_hz: 0.0,
            frequency_high_hz: f64::INFINITY,
            damping_ratio_most: 0.15,
            phase_collinearity_least: 0.4,
            phase_deviation_most: 0.45,
            frequency_change_most: 0.01,
            damping_change_most: 0.3,
            assurance_least: 0.95,
        }
    }
}

/// What the criteria say of one pole: the first that it fails, in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stability {
    /// Passes all.
    Stable,
    /// Outside the frequency range: cannot be a mode looked for.
    OutOfRange,
    /// Damping ratio not between 0 and the largest allowed: cannot be a mode.
    Damping,
    /// Shape too far from a real one (collinearity or phase deviation): taken as noise.
    Complex,
    /// No pole of like frequency at the order below.
    FrequencyMoved,
    /// Frequency came back, damping did not.
    DampingMoved,
    /// Frequency and damping came back, the shape did not.
    ShapeMoved,
}

impl Stability {
    /// Whether the pole passes what a mode must have by itself, whatever the order below holds.
    pub fn possible(self) -> bool {
        !matches!(
            self,
            Stability::OutOfRange | Stability::Damping | Stability::Complex
        )
    }
}

/// One pole and what the criteria say of it.
#[derive(Clone, Debug, PartialEq)]
pub struct JudgedPole {
    /// The pole.
    pub pole: Pole,
    /// The verdict.
    pub stability: Stability,
}

/// The stabilisation diagram: every pole of every order with its verdict.
#[derive(Clone, Debug, PartialEq)]
pub struct Stabilization {
    /// By order, then by frequency.
    pub poles: Vec<JudgedPole>,
    /// What they were judged by.
    pub criteria: Criteria,
}

/// Judges each pole: hard criteria by itself, soft ones against the possible poles of the order below.
pub fn stabilize(poles: &[Pole], criteria: &Criteria) -> Stabilization {
    let mut judged: Vec<JudgedPole> = Vec::with_capacity(poles.len());
    let (mut below, mut below_order) = (0..0, 0);
    let mut start = 0;
    for pole in poles {
        if judged.last().is_some_and(|last| last.pole.order != pole.order) {
            (below, below_order) = (start..judged.len(), judged[start].pole.order);
            start = judged.len();
        }
        let stability = hard(pole, criteria).unwrap_or_else(|| {
            let neighbours = judged[below.clone()].iter().filter(|j| j.stability.possible());
            if below_order + 2 == pole.order {
                soft(pole, neighbours.map(|j| &j.pole), criteria)
            } else {
                Stability::FrequencyMoved
            }
        });
        judged.push(JudgedPole {
            pole: pole.clone(),
            stability,
        });
    }
    Stabilization {
        poles: judged,
        criteria: criteria.clone(),
    }
}

fn hard(pole: &Pole, c: &Criteria) -> Option<Stability> {
    let in_range = (c.frequency_low_hz..=c.frequency_high_hz).contains(&pole.frequency_hz);
    let damped = pole.damping_ratio > 0.0 && pole.damping_ratio <= c.damping_ratio_most;
    let real = pole.phase_collinearity >= c.phase_collinearity_least
        && pole.phase_deviation <= c.phase_deviation_most;
    match (in_range, damped, real) {
        (false, ..) => Some(Stability::OutOfRange),
        (_, false, _) => Some(Stability::Damping),
        (.., false) => Some(Stability::Complex),
        _ => None,
    }
}

fn soft<'a>(pole: &Pole, below: impl Iterator<Item = &'a Pole>, c: &Criteria) -> Stability {
    let rank = |s: &Stability| match s {
        Stability::Stable => 3,
        Stability::ShapeMoved => 2,
        Stability::DampingMoved => 1,
        _ => 0,
    };
    below
        .map(|other| {
            let frequency = (pole.frequency_hz / other.frequency_hz - 1.0).abs();
            let damping = (pole.damping_ratio / other.damping_ratio - 1.0).abs();
            if frequency > c.frequency_change_most {
                Stability::FrequencyMoved
            } else if damping > c.damping_change_most {
                Stability::DampingMoved
            } else if assurance(&pole.shape, &other.shape) < c.assurance_least {
                Stability::ShapeMoved
            } else {
                Stability::Stable
            }
        })
        .max_by_key(rank)
        .unwrap_or(Stability::FrequencyMoved)
}
