//! The ground motion as named lines in the figures of a stack.

use super::ink::{BLACK, Line, PURPLE, VERMILLION};
use super::plot::{Key, Plot};
use super::words::{Shaken, say};
use dolmen::assess::demand::{ModalRatio, ShakenDirection, SiteDemand, StackDemandCheck};
use dolmen::stability::stack::{LimitKind, StackLimitStates};
use dolmen_words::{Language, number};

/// Levels of ground motion, in units of gravity; unknown ones are not drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shaking {
    /// Horizontal peak of the site demand.
    pub site: Option<f64>,
    /// Horizontal peak without vertical shaking that is equivalent to that of the site with it: multiplied by the
    /// capacity without over the capacity with vertical shaking. `None` if the site has no vertical shaking.
    pub site_with_vertical: Option<f64>,
    /// Demand of all modes on the joint that moves first on them, as a ground peak: the capacity of that joint, as the figures draw it, divided
    /// by the ratio of the modal check.
    pub site_by_modes: Option<f64>,
    /// Horizontal peak of the simulated motion.
    pub motion: Option<f64>,
}

/// A level of shaking, in units of gravity, with its line and its name.
pub(super) struct Level {
    pub(super) peak_g: f64,
    pub(super) line: Line,
    pub(super) words: Shaken,
}

impl Level {
    /// Its name in the legend; below the plot if it is beyond the end of the axis.
    pub(super) fn named(self, plot: &mut Plot, end_g: f64, language: Language) {
        let words = say(self.words, language);
        match self.peak_g <= end_g {
            true => plot.key(Key::Line(self.line), words),
            false => plot.note(say(Shaken::BeyondTheAxis { level: words }, language)),
        }
    }
}

impl Shaking {
    /// The levels of a site, and of the stack's comparison if known.
    pub fn of_site(
        site: &SiteDemand,
        stack: Option<&StackDemandCheck>,
        limits: &StackLimitStates,
        gravity_m_s2: f64,
    ) -> Self {
        let site_g = site.peak_ground_acceleration_m_s2.map(|peak| peak / gravity_m_s2);
        let row = stack.and_then(|stack| {
            stack
                .rows
                .iter()
                .find(|row| row.direction == ShakenDirection::Any)
        });
        let capacity_g = row
            .and_then(|row| row.capacity.as_ref())
            .map(|at| at.acceleration_g);
        let with_vertical = row.and_then(|row| row.capacity_with_vertical.as_ref());
        let is_lifted = stack.is_some_and(|stack| stack.vertical_acceleration_m_s2 != 0.0);
        let harder = capacity_g.zip(with_vertical).filter(|_| is_lifted);
        let by_modes = row.and_then(|row| row.by_modes.as_ref());
        let of_joint = |modes: &ModalRatio| match &modes.first {
            Some((kind, above)) => {
                let cut = limits.cuts.iter().find(|cut| cut.above == *above)?;
                let at = match kind {
                    LimitKind::Uplift => cut.uplift,
                    LimitKind::Sliding => cut.sliding,
                };
                Some(at?.acceleration_g / modes.ratio)
            }
            None => Some(capacity_g? / modes.ratio),
        };
        Shaking {
            site: site_g,
            site_with_vertical: site_g
                .zip(harder)
                .map(|(site, (capacity, with))| site * capacity / with.acceleration_g),
            site_by_modes: by_modes.and_then(of_joint),
            motion: None,
        }
    }

    /// The largest known peak of the ground, in units of gravity: of the site or the motion.
    pub(crate) fn ground_g(&self) -> Option<f64> {
        let known = [self.site, self.site_with_vertical, self.motion];
        known
            .into_iter()
            .flatten()
            .filter(|peak| peak.is_finite())
            .reduce(f64::max)
    }

    /// Each known level with its line.
    pub(super) fn levels(&self) -> Vec<Level> {
        let red = Line::new(VERMILLION, 1.8);
        let said = |peak: f64| format!("{}{}g", number::significant(peak, 3), number::NARROW_SPACE);
        let level = |peak: Option<f64>, line: Line, words: fn(String) -> Shaken| {
            let peak_g = peak.filter(|peak| peak.is_finite() && *peak > 0.0)?;
            Some(Level {
                peak_g,
                line,
                words: words(said(peak_g)),
            })
        };
        let all = [
            level(self.site, red, |peak| Shaken::Site { peak }),
            level(self.site_with_vertical, red.dashed(), |peak| {
                Shaken::WithVertical { peak }
            }),
            level(self.site_by_modes, Line::new(PURPLE, 1.8).dashed(), |peak| {
                Shaken::ByModes { peak }
            }),
            level(self.motion, Line::new(BLACK, 1.6), |peak| Shaken::Motion { peak }),
        ];
        all.into_iter().flatten().collect()
    }
}
