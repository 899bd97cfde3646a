//! What the ground does, as named lines in the figures of a stack.

use super::ink::{BLACK, Line, PURPLE, VERMILLION};
use super::plot::{Key, Plot};
use super::words::{Shaken, say};
use dolmen::assess::demand::SiteDemand;
use dolmen::assess::demand::{ShakenDirection, StackDemandCheck};
use dolmen_words::{Language, number};

/// What the ground does, over gravity; what is not known is not drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shaking {
    /// Horizontal peak that the site demands.
    pub site: Option<f64>,
    /// The horizontal peak that would be as hard to bear without vertical shaking as the site's is with it: times the
    /// capacity without over that with it. `None` where the site has no vertical shaking.
    pub site_with_vertical: Option<f64>,
    /// What all modes ask of the weakest joint, as a peak of the ground: the capacity over the ratio by modes.
    pub site_by_modes: Option<f64>,
    /// Horizontal peak of the motion that was run.
    pub motion: Option<f64>,
}

/// A level of shaking, over gravity, with its line and its name.
pub(super) struct Level {
    pub(super) peak_g: f64,
    pub(super) line: Line,
    pub(super) words: Shaken,
}

impl Level {
    /// Its name in the legend; below the plot where it lies beyond the end of the axis.
    pub(super) fn named(self, plot: &mut Plot, end_g: f64, language: Language) {
        let words = say(self.words, language);
        match self.peak_g <= end_g {
            true => plot.key(Key::Line(self.line), words),
            false => plot.note(say(Shaken::BeyondTheAxis { level: words }, language)),
        }
    }
}

impl Shaking {
    /// Of a site, with a stack against it where that is known.
    pub fn of_site(site: &SiteDemand, stack: Option<&StackDemandCheck>, gravity_m_s2: f64) -> Self {
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
        Shaking {
            site: site_g,
            site_with_vertical: site_g
                .zip(harder)
                .map(|(site, (capacity, with))| site * capacity / with.acceleration_g),
            site_by_modes: capacity_g
                .zip(by_modes)
                .map(|(capacity, modes)| capacity / modes.ratio),
            motion: None,
        }
    }

    /// The peak up to which the ground alone moves a joint, over gravity: the largest of the site's and the motion's.
    pub(super) fn ground_g(&self) -> Option<f64> {
        let known = [self.site, self.site_with_vertical, self.motion];
        known
            .into_iter()
            .flatten()
            .filter(|peak| peak.is_finite())
            .reduce(f64::max)
    }

    /// Each level that is known, with its line.
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
