//! Tenons with slack: a spring on either side of a gap, with faces that crush and lose stiffness.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | δ | `drift_m` | drift of the storey | m |
//! | g | `gap_m` | drift at which a face comes into contact, on its own side | m |
//! | k | `stiffness_n_m` | current stiffness of the joints of a storey in contact | N/m |
//! | f | `crushing_force_n` | force at which the faces crush | N |
//! | d | `crushed_m` | crushed depth of a face | m |
//! | s | `sign` | +1 if the face for positive drift is in contact, −1 for the other | – |
//!
//! ```text
//! free       −g₋ < δ < g₊          no force
//! bearing    s δ ≥ g_s             k_s (δ − s g_s), at most f
//! crushing   at f, s δ' > 0        s f, and g_s = s δ − f/k_s grows with δ
//! opening    s δ = g_s, s δ' < 0   k_s = k_0/(1 + d_s/d_½)
//! ```
//! A face softens when it opens, because it then stores no energy; softening therefore neither creates nor loses energy.

use super::DynamicsError;

/// All tenons of one storey together: two faces, equal as built.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tenon {
    /// Drift before contact, from the upright position to either side, m; 0 without slack.
    pub slack_m: f64,
    /// Stiffness after contact, parallel to the spring of the storey, N/m.
    pub stiffness_n_m: f64,
    /// Force at which the faces crush, N; `None` if they never crush.
    pub crushing_force_n: Option<f64>,
    /// Crushed depth, as drift, at which half of a face's stiffness remains, m; `None` if it does not change.
    pub half_stiffness_depth_m: Option<f64>,
}

impl Tenon {
    /// Secant stiffness at a drift before any crushing, N/m: force over drift.
    ///
    /// ```text
    /// k (1 − g/|δ|), at most f/|δ|
    /// ```
    pub fn secant_stiffness_n_m(&self, drift_m: f64) -> f64 {
        let bears_m = drift_m.abs() - self.slack_m;
        if bears_m <= 0.0 {
            return 0.0;
        }
        let force_n = (self.stiffness_n_m * bears_m).min(self.crushing_force_n.unwrap_or(f64::INFINITY));
        force_n / drift_m.abs()
    }

    pub(super) fn check(&self, storey: usize) -> Result<(), DynamicsError> {
        let refuse = |argument, given, allowed| {
            Err(DynamicsError::Storey {
                storey,
                argument,
                given,
                allowed,
            })
        };
        let positive = |x: f64| x > 0.0 && x.is_finite();
        if !(self.slack_m >= 0.0 && self.slack_m.is_finite()) {
            return refuse("slack_m", self.slack_m, "0 or a positive number");
        }
        let values = [
            ("stiffness_n_m", Some(self.stiffness_n_m)),
            ("crushing_force_n", self.crushing_force_n),
            ("half_stiffness_depth_m", self.half_stiffness_depth_m),
        ];
        for (argument, given) in values {
            if let Some(given) = given.filter(|given| !positive(*given)) {
                return refuse(argument, given, "a positive number");
            }
        }
        Ok(())
    }

    /// Remaining stiffness of a face with this crushed depth, N/m.
    fn left_n_m(&self, crushed_m: f64) -> f64 {
        match self.half_stiffness_depth_m {
            Some(half_m) => self.stiffness_n_m / (1.0 + crushed_m / half_m),
            None => self.stiffness_n_m,
        }
    }
}

/// State of the tenons of a storey.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Touch {
    /// No face is in contact.
    Free,
    /// The face of this side is in contact.
    Bearing(f64),
    /// The face of this side is being crushed.
    Crushing(f64),
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum TenonChange {
    /// The face of this side comes into contact.
    Bears(f64),
    /// The face opens.
    Opens,
    /// The face begins to crush.
    Crushes,
    /// The face stops crushing.
    Stops,
}

/// One face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TenonFace {
    /// Drift at which the face comes into contact, on its own side, m.
    pub gap_m: f64,
    /// Its crushed depth, as drift, m.
    pub crushed_m: f64,
    /// Stiffness, N/m.
    pub stiffness_n_m: f64,
}

/// Tenons of a storey in motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Joint {
    pub(super) law: Tenon,
    pub(super) touch: Touch,
    /// The face for positive drift, then the face for negative drift.
    pub(super) faces: [TenonFace; 2],
}

impl Joint {
    /// State at a drift; if the force exceeds the crushing force, the faces are already crushed.
    pub(super) fn at(law: Tenon, drift_m: f64) -> Self {
        let face = TenonFace {
            gap_m: law.slack_m,
            crushed_m: 0.0,
            stiffness_n_m: law.stiffness_n_m,
        };
        let mut joint = Joint {
            law,
            touch: Touch::Free,
            faces: [face; 2],
        };
        let sign = if drift_m < 0.0 { -1.0 } else { 1.0 };
        let bears_m = sign * drift_m - law.slack_m;
        if bears_m > 0.0 {
            joint.touch = Touch::Bearing(sign);
            if law
                .crushing_force_n
                .is_some_and(|most_n| law.stiffness_n_m * bears_m > most_n)
            {
                joint.crush_to(sign, drift_m);
            }
        }
        joint
    }

    pub(super) fn face(&self, sign: f64) -> &TenonFace {
        &self.faces[usize::from(sign < 0.0)]
    }

    fn face_mut(&mut self, sign: f64) -> &mut TenonFace {
        &mut self.faces[usize::from(sign < 0.0)]
    }

    /// Crushes the face on one side until it carries the crushing force at a drift.
    fn crush_to(&mut self, sign: f64, drift_m: f64) {
        let most_n = self.law.crushing_force_n.unwrap_or(f64::INFINITY);
        let face = self.face_mut(sign);
        let gap_m = sign * drift_m - most_n / face.stiffness_n_m;
        let crushed_m = (gap_m - face.gap_m).max(0.0);
        face.gap_m += crushed_m;
        face.crushed_m += crushed_m;
    }

    /// Current spring, N/m, and force at zero drift, N: total force = spring × drift + force at zero drift.
    pub(super) fn spring(&self) -> [f64; 2] {
        match self.touch {
            Touch::Free => [0.0, 0.0],
            Touch::Bearing(sign) => {
                let face = self.face(sign);
                [face.stiffness_n_m, -sign * face.stiffness_n_m * face.gap_m]
            }
            Touch::Crushing(sign) => [0.0, sign * self.law.crushing_force_n.unwrap_or(0.0)],
        }
    }

    pub(super) fn stored_j(&self, drift_m: f64) -> f64 {
        let (Touch::Bearing(sign) | Touch::Crushing(sign)) = self.touch else {
            return 0.0;
        };
        let [spring_n_m, at_zero_n] = self.spring();
        let force_n = spring_n_m * drift_m + at_zero_n;
        0.5 * force_n * force_n / self.face(sign).stiffness_n_m
    }

    /// Crushing power divided by the rate of the drift, N; 0 without crushing.
    pub(super) fn crushing_n(&self) -> f64 {
        match (self.touch, self.law.crushing_force_n) {
            (Touch::Crushing(_), Some(force_n)) => force_n,
            _ => 0.0,
        }
    }

    /// Changes the state at a drift.
    pub(super) fn change(&mut self, change: TenonChange, drift_m: f64) {
        self.touch = match (change, self.touch) {
            (TenonChange::Bears(sign), _) => Touch::Bearing(sign),
            (TenonChange::Opens, Touch::Bearing(sign)) => {
                let law = self.law;
                let face = self.face_mut(sign);
                face.stiffness_n_m = law.left_n_m(face.crushed_m);
                Touch::Free
            }
            (TenonChange::Crushes, Touch::Bearing(sign)) => Touch::Crushing(sign),
            (TenonChange::Stops, Touch::Crushing(sign)) => {
                self.crush_to(sign, drift_m);
                Touch::Bearing(sign)
            }
            (_, as_it_is) => as_it_is,
        };
    }

    /// State of the tenons of a frame at rest at a drift: a crushing face carries its force without further crushing.
    pub(super) fn resting_at(mut self, drift_m: f64) -> Self {
        let sign = if drift_m < 0.0 { -1.0 } else { 1.0 };
        let face = self.face(sign);
        let force_n = face.stiffness_n_m * (sign * drift_m - face.gap_m);
        self.touch = if force_n <= 0.0 {
            Touch::Free
        } else if self.law.crushing_force_n.is_some_and(|most_n| force_n > most_n) {
            Touch::Crushing(sign)
        } else {
            Touch::Bearing(sign)
        };
        self
    }

    /// The faces at a drift, including the current crushing.
    pub(super) fn faces_at(&self, drift_m: f64) -> [TenonFace; 2] {
        let mut joint = *self;
        joint.change(TenonChange::Stops, drift_m);
        joint.faces
    }
}
