//! Results of `dolmen tune`, for text, JSON, figures and report.

use crate::part_limit::PartLimit;
use dolmen::damper::{Choice, Compared, Comparison, DesignEnd, FloorComparison, FloorDesign, Goal};
use dolmen_project::{BuiltDamper, Names};

/// The load on the building with the damper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TuneLoad {
    /// The same white-noise force on every floor, at its centre of mass.
    Force,
    /// The same force with the spectrum of gusts, whose density falls beyond a corner, Hz.
    Wind {
        /// Corner, Hz.
        corner_hz: f64,
    },
    /// The turbulent wind of the file, along x or along y.
    Gusts,
    /// White-noise acceleration of the base.
    Base,
    /// Acceleration of the ground after Clough & Penzien, with the frequency of the soil, Hz; its damping ratio is 0.6, and the second
    /// filter is at a tenth of its frequency.
    Ground {
        /// Frequency of the soil, Hz.
        ground_hz: f64,
    },
}

impl TuneLoad {
    /// Whether the base moves.
    pub fn is_base(self) -> bool {
        matches!(self, TuneLoad::Base | TuneLoad::Ground { .. })
    }

    /// Its name in JSON.
    pub fn name(self) -> &'static str {
        match self {
            TuneLoad::Force => "force",
            TuneLoad::Wind { .. } => "wind",
            TuneLoad::Gusts => "gusts",
            TuneLoad::Base => "base",
            TuneLoad::Ground { .. } => "ground",
        }
    }
}

/// A point whose motion is to be reduced.
#[derive(Clone, Debug, PartialEq)]
pub struct TunePoint {
    /// Its name.
    pub name: String,
    /// Its floor, from 1.
    pub floor: usize,
    /// Its place in plan, m.
    pub place_m: [f64; 2],
}

/// Fraction by which a stroke may exceed its bound, because both then print the same value.
const STROKE_KEPT: f64 = 5e-4;

/// The stroke of a damper of a row under a motion of the file.
#[derive(Clone, Debug, PartialEq)]
pub struct RowStroke {
    /// Index of the row in the comparison.
    pub row: usize,
    /// The damper.
    pub damper: String,
    /// The motion's name in the file; `None` for the spectrum of the site.
    pub motion: Option<String>,
    /// Its largest stroke, m.
    pub stroke_m: f64,
    /// Its room in each direction, m.
    pub room_m: f64,
}

/// The building with the dampers of a row under a motion of the file.
#[derive(Clone, Debug, PartialEq)]
pub struct RowRun {
    /// Index of the row in the comparison.
    pub row: usize,
    /// The motion's name in the file.
    pub motion: String,
    /// Drifts of storeys and strokes of dampers compared with their limits.
    pub parts: Vec<PartLimit>,
    /// Whether the drift of a storey is beyond the validity of small drifts.
    pub falls: bool,
}

/// Strokes under the motions of the file and the spectrum of its site, with the rooms of the dampers; empty where the file gives no room.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RoomCheck {
    /// Whether some damper has a room.
    pub has_room: bool,
    /// Whether the file has a motion or a site.
    pub is_judged: bool,
    /// Whether the file has a wind, which a check holds the rooms against.
    pub has_wind: bool,
    /// For every row, damper with a room, and motion.
    pub strokes: Vec<RowStroke>,
    /// For every row and motion.
    pub runs: Vec<RowRun>,
}

impl RoomCheck {
    /// The strokes that exceed their room.
    pub fn beyond(&self) -> impl Iterator<Item = &RowStroke> {
        self.strokes.iter().filter(|of| of.stroke_m > of.room_m)
    }

    /// Whether there is a room but no motion or site.
    pub fn is_unjudged(&self) -> bool {
        self.has_room && !self.is_judged
    }
}

/// One damper of a project, tuned.
#[derive(Clone, Debug, PartialEq)]
pub struct TuneAnswer {
    /// Path of the project file as the user named it.
    pub file: String,
    /// The building.
    pub name: Names,
    /// The variant of the file; `None`: as it is.
    pub variant: Option<String>,
    /// The damper's table.
    pub damper: String,
    /// Other dampers of the file, which are left out here.
    pub others: usize,
    /// Upper bound on the stroke of designed dampers, relative to that of the file's damper.
    pub stroke_most: Option<f64>,
    /// Relative error of the frequency that designs tolerate.
    pub off_by: f64,
    /// Its floor, from 1.
    pub floor: usize,
    /// Corners of the floor, m.
    pub corners_m: Vec<[f64; 2]>,
    /// The mode that the damper is for, from 1.
    pub mode: usize,
    /// Frequency of the mode, Hz.
    pub mode_frequency_hz: f64,
    /// Its own damping ratio.
    pub mode_damping_ratio: f64,
    /// Centre of the mode on that floor in plan, m; `None` if the floor does not turn.
    pub mode_centre_m: Option<[f64; 2]>,
    /// The load.
    pub load: TuneLoad,
    /// Its direction, degrees from x.
    pub load_direction_degrees: f64,
    /// The points.
    pub points: Vec<TunePoint>,
    /// Whether the points are the corners of the damper's floor, because the file gives none.
    pub points_are_corners: bool,
    /// Direction of their motion, degrees from x: that of the damper.
    pub direction_degrees: f64,
    /// The quantity to minimise.
    pub goal: Goal,
    /// The comparison.
    pub comparison: Comparison,
    /// Strokes under the motions of the file, in the order of the comparison's rows.
    pub room: RoomCheck,
    /// The damper on other floors, where they were asked for.
    pub floors: Option<TunedFloors>,
    /// Number of other floors with an outline; none of them was searched without `floors`.
    pub other_floors: usize,
}

/// A damper placed and tuned best on each of several floors.
#[derive(Clone, Debug, PartialEq)]
pub struct TunedFloors {
    /// The floors, from the lowest; that of the file is always one of them.
    pub comparison: FloorComparison,
    /// Floors that were asked for, but have no outline.
    pub without_outline: Vec<usize>,
    /// Strokes on the best floor under the motions of the file; row 0 is the damper there.
    pub room: RoomCheck,
}

impl TuneAnswer {
    /// The stroke of a row relative to that of the damper in the file.
    pub fn stroke_ratio(&self, row: &Compared) -> f64 {
        let stroke = |row: &Compared| row.judged.stroke_rms_m.first().copied().unwrap_or(f64::NAN);
        stroke(row) / self.comparison.row(Choice::Given).map_or(f64::NAN, stroke)
    }

    /// Whether a row was designed for a bound on the stroke, and exceeds it.
    pub fn is_beyond_stroke(&self, row: &Compared) -> bool {
        let kept = |most: f64| self.stroke_ratio(row) <= most * (1.0 + STROKE_KEPT);
        row.end.is_some() && !self.stroke_most.is_none_or(kept)
    }

    /// The quantity of the goal at each point relative to that without a damper: standard deviations, or largest amplitudes.
    pub fn ratios(&self, row: &Compared) -> Vec<f64> {
        self.over_without(&row.point_values)
    }

    /// Values of the points relative to those without a damper.
    pub fn over_without(&self, values: &[f64]) -> Vec<f64> {
        let each = values.iter().zip(&self.comparison.without);
        each.map(|(with, without)| with / without).collect()
    }

    /// The points with more motion than without a damper, and their ratios.
    pub fn worse(&self, row: &Compared) -> Vec<(&TunePoint, f64)> {
        let ratios = self.ratios(row);
        self.points
            .iter()
            .zip(ratios)
            .filter(|(_, ratio)| *ratio > 1.0)
            .collect()
    }

    /// The floors with the smallest goals, best first, and that of the file, if floors were compared.
    pub fn best_floors(&self, most: usize) -> Vec<&FloorDesign> {
        let Some(floors) = &self.floors else {
            return Vec::new();
        };
        let mut order: Vec<&FloorDesign> = floors.comparison.floors.iter().collect();
        order.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        let (first, rest) = order.split_at(most.min(order.len()));
        let own = rest.iter().filter(|of| of.floor == self.floor);
        first.iter().chain(own).copied().collect()
    }

    /// Relative excess of the goal of one choice over another: 0.02 for 2 % more.
    pub fn costs(&self, choice: Choice, than: Choice) -> Option<f64> {
        let of = |choice| self.comparison.row(choice).map(|row| row.cost);
        Some(of(choice)? / of(than)? - 1.0)
    }

    /// Relative increase of the goal if the frequency of the given damper (0) or the best one (1) is off by the factor nearest to `factor`.
    pub fn detuned(&self, which: usize, factor: f64) -> Option<f64> {
        let curve = &self.comparison.off_frequency[which];
        let near = |of: f64| {
            let each = curve.iter();
            each.min_by(|a, b| (a.factor - of).abs().total_cmp(&(b.factor - of).abs()))
        };
        Some(near(factor)?.cost / near(1.0)?.cost - 1.0)
    }
}

/// The dampers in a row of the comparison of all.
#[derive(Clone, Debug, PartialEq)]
pub enum TogetherChoice {
    /// No damper.
    Without,
    /// All, as in the file.
    Given,
    /// One alone, as in the file, by its name.
    Only(String),
    /// All but one, as in the file.
    AllBut(String),
    /// All at their places, tuned together.
    TunedBest,
    /// Masses and liquid columns with places and tunings optimised together, other dampers as tuned alone.
    Best,
    /// The same, with the total mass redistributed.
    BestShared,
}

impl TogetherChoice {
    /// Its name in JSON.
    pub fn name(&self) -> &'static str {
        match self {
            TogetherChoice::Without => "without",
            TogetherChoice::Given => "given",
            TogetherChoice::Only(_) => "only",
            TogetherChoice::AllBut(_) => "all_but",
            TogetherChoice::TunedBest => "tuned_best",
            TogetherChoice::Best => "best",
            TogetherChoice::BestShared => "best_shared",
        }
    }
}

/// One row of all dampers.
#[derive(Clone, Debug, PartialEq)]
pub struct TogetherRow {
    /// The choice of dampers.
    pub choice: TogetherChoice,
    /// The dampers, with their places and directions.
    pub dampers: Vec<BuiltDamper>,
    /// Standard deviation of each point along each direction, by assembled matrices.
    pub point_rms: Vec<f64>,
    /// Standard deviation of each stroke, m.
    pub stroke_rms_m: Vec<f64>,
    /// The goal.
    pub cost: f64,
    /// How the search ended; `None` without a search.
    pub end: Option<DesignEnd>,
}

/// All dampers of a project together.
#[derive(Clone, Debug, PartialEq)]
pub struct TogetherAnswer {
    /// Relative error of frequencies that the designs of single dampers tolerate; the designs here tolerate none.
    pub off_by: f64,
    /// Path of the project file as the user named it.
    pub file: String,
    /// The building.
    pub name: Names,
    /// The variant of the file; `None`: as it is.
    pub variant: Option<String>,
    /// The load.
    pub load: TuneLoad,
    /// Directions of the load, degrees from x, independent of each other.
    pub load_directions_degrees: Vec<f64>,
    /// Points, with the direction of their motion, degrees from x.
    pub points: Vec<(TunePoint, f64)>,
    /// The quantity to minimise: standard deviations.
    pub goal: Goal,
    /// Whether largest amplitudes were requested, which are not available for several dampers together.
    pub peaks_not_sought: bool,
    /// Upper bound on the strokes of designed dampers, relative to those of the file's dampers.
    pub stroke_most: Option<f64>,
    /// Without, given, each alone, all but each, tuned, placed, shared.
    pub rows: Vec<TogetherRow>,
    /// Strokes under the motions of the file, in the order of the rows.
    pub room: RoomCheck,
}

impl TogetherAnswer {
    /// Dampers of a row that were designed for a bound on the stroke and exceed it, each with its stroke relative to that in the file.
    pub fn beyond_stroke(&self, row: &TogetherRow) -> Vec<(String, f64)> {
        let given = self.rows.iter().find(|row| row.choice == TogetherChoice::Given);
        let (Some(most), Some(given), true) = (self.stroke_most, given, row.end.is_some()) else {
            return Vec::new();
        };
        let strokes = row.stroke_rms_m.iter().zip(&given.stroke_rms_m);
        let each = row.dampers.iter().zip(strokes.map(|(own, given)| own / given));
        let beyond = each.filter(|(_, ratio)| *ratio > most * (1.0 + STROKE_KEPT));
        beyond
            .map(|(damper, ratio)| (damper.name.clone(), ratio))
            .collect()
    }

    /// Standard deviations relative to those without dampers.
    pub fn ratios(&self, row: &TogetherRow) -> Vec<f64> {
        let without = self.rows.first().map_or(&[][..], |row| &row.point_rms);
        row.point_rms.iter().zip(without).map(|(a, b)| a / b).collect()
    }

    /// The goal relative to that without dampers.
    pub fn cost_ratio(&self, row: &TogetherRow) -> f64 {
        row.cost / self.rows.first().map_or(f64::NAN, |row| row.cost)
    }
}
