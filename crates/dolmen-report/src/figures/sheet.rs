//! Elevations side by side on one sheet: scale, ground, outlines, names.

use super::elevation::{Elevation, PartOutline};
use super::ink::{Anchor, BLACK, GREY, LIGHT, Label, Line, STONE, WHITE, text_width};
use super::scene::Scene;

/// Largest size of a drawn structure, px.
const HEIGHT_PX: f64 = 430.0;
const WIDTH_PX: f64 = 260.0;
/// Space above it, for headings and leaning parts.
const TOP_PX: f64 = 46.0;
/// Space to the left of the first view, for dimensions.
pub(super) const LEFT_PX: f64 = 124.0;
/// Largest width of names.
const NAMES_PX: f64 = 190.0;
/// Distance between two lines of names.
const LINE_PX: f64 = 13.5;

/// One view on the sheet.
pub(super) struct View {
    pub(super) elevation: Elevation,
    pub(super) scale: f64,
    origin_px: [f64; 2],
    origin_m: [f64; 2],
    /// Right edge of the outlines, px.
    pub(super) right_px: f64,
}

impl View {
    /// Converts a position across and up to the sheet.
    pub(super) fn px(&self, at: [f64; 2]) -> [f64; 2] {
        [
            self.origin_px[0] + (at[0] - self.origin_m[0]) * self.scale,
            self.origin_px[1] - (at[1] - self.origin_m[1]) * self.scale,
        ]
    }

    pub(super) fn left_px(&self) -> f64 {
        self.origin_px[0]
    }
}

/// Views side by side.
pub(super) struct Sheet {
    pub(super) views: Vec<View>,
    pub(super) width_px: f64,
    pub(super) ground_px: f64,
}

/// The views with space for names after the first; `None` if there is nothing to draw.
pub(super) fn sheet(elevations: Vec<Elevation>) -> Option<Sheet> {
    let bounds: Vec<[[f64; 2]; 2]> = elevations.iter().map(Elevation::bounds).collect();
    let height = bounds
        .iter()
        .map(|[least, most]| most[1] - least[1])
        .fold(0.0, f64::max);
    let width = bounds
        .iter()
        .map(|[least, most]| most[0] - least[0])
        .fold(0.0, f64::max);
    if !(height > 0.0 && width > 0.0 && height.is_finite() && width.is_finite()) {
        return None;
    }
    let scale = (HEIGHT_PX / height).min(WIDTH_PX / width);
    let ground_px = TOP_PX + height * scale;
    let mut left = LEFT_PX;
    let mut views = Vec::new();
    for (number, (elevation, [least, most])) in elevations.into_iter().zip(bounds).enumerate() {
        let right_px = left + (most[0] - least[0]) * scale;
        let names = match number {
            0 => {
                let widths = elevation.parts.iter().map(|part| text_width(&part.name, 11.0));
                widths.fold(0.0, f64::max).clamp(40.0, NAMES_PX) + 44.0
            }
            _ => 40.0,
        };
        views.push(View {
            elevation,
            scale,
            origin_px: [left, ground_px],
            origin_m: least,
            right_px,
        });
        left = right_px + names;
    }
    Some(Sheet {
        views,
        width_px: left.max(420.0),
        ground_px,
    })
}

/// The outlines of a view on their ground.
pub(super) fn put_outlines(scene: &mut Scene, view: &View, ground_px: f64) {
    let (left, right) = (view.left_px() - 14.0, view.right_px + 14.0);
    scene.line([left, ground_px], [right, ground_px], Line::new(GREY, 1.5));
    for part in &view.elevation.parts {
        for piece in std::iter::once(&part.corners_m).chain(&part.further_m) {
            let corners: Vec<[f64; 2]> = piece.iter().map(|corner| view.px(*corner)).collect();
            scene.polygon(&corners, STONE, Line::new(BLACK, 1.0));
        }
        for opening in &part.openings_m {
            let corners: Vec<[f64; 2]> = opening.iter().map(|corner| view.px(*corner)).collect();
            scene.polygon(&corners, WHITE, Line::new(BLACK, 1.0));
        }
    }
    let posts = &view.elevation.posts;
    for post in &posts.posts {
        let corners: Vec<[f64; 2]> = post.iter().map(|corner| view.px(*corner)).collect();
        scene.polygon(&corners, LIGHT, Line::new(GREY, 1.0));
    }
    for wedge in &posts.wedges {
        scene.line(view.px(wedge[0]), view.px(wedge[1]), Line::new(BLACK, 3.0));
    }
}

/// The names of all parts to the right of a view, each with a line to its part; if they do not all fit, every second, third…
pub(super) fn put_names(scene: &mut Scene, view: &View, ground_px: f64) {
    let mut parts: Vec<&PartOutline> = view.elevation.parts.iter().collect();
    parts.sort_by(|a, b| b.middle()[1].total_cmp(&a.middle()[1]));
    let room = ((ground_px - TOP_PX * 0.4) / LINE_PX).floor().max(1.0);
    let step = (parts.len() as f64 / room).ceil().max(1.0) as usize;
    let shown: Vec<&PartOutline> = parts.into_iter().step_by(step).collect();
    let wanted: Vec<f64> = shown.iter().map(|part| view.px(part.middle())[1]).collect();
    let x = view.right_px + 34.0;
    for (part, y) in shown.iter().zip(spread(&wanted, LINE_PX, ground_px)) {
        let [_, most] = part.bounds();
        let edge = view.px([most[0], part.middle()[1]]);
        scene.path(&[edge, [x - 14.0, y], [x - 3.0, y]], Line::new(GREY, 0.6));
        scene.text([x, y], &Label::new(part.name.clone(), Anchor::Start).small());
    }
}

/// Positions from the top down with a minimum distance, ending above `bottom`, near the wanted ones.
fn spread(wanted: &[f64], distance: f64, bottom: f64) -> Vec<f64> {
    let mut places = wanted.to_vec();
    for at in 1..places.len() {
        places[at] = places[at].max(places[at - 1] + distance);
    }
    let mut limit = bottom;
    for place in places.iter_mut().rev() {
        *place = place.min(limit);
        limit = *place - distance;
    }
    places
}

#[cfg(test)]
mod tests {
    use super::spread;

    #[test]
    fn holds_names_keep_their_distance_and_stay_above_the_ground() {
        let places = spread(&[10.0, 11.0, 12.0, 98.0, 99.0], 13.0, 100.0);
        assert!(
            places.windows(2).all(|pair| pair[1] - pair[0] >= 13.0 - 1e-12),
            "{places:?}"
        );
        assert!(places.iter().all(|place| *place <= 100.0));
        assert_eq!(spread(&[10.0, 50.0], 13.0, 100.0), [10.0, 50.0]);
    }
}
