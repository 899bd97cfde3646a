//! The direction of a measured mode.

use dolmen::modal::ObservedMode;

/// Smallest share of a shape's square along one direction for that to be its direction. Our choice.
const ALONG_FROM: f64 = 0.8;

/// The direction stated in the file, otherwise "x" or "y" from the shape at the sensors; `None` if neither is known.
pub(crate) fn direction_of(mode: &ObservedMode) -> Option<String> {
    if mode.direction.is_some() {
        return mode.direction.clone();
    }
    let squares = mode.shape.iter().filter_map(|point| {
        let [x, y, _] = point.channel.direction?;
        let square = point.component.norm_sqr();
        Some([square * x * x, square * y * y])
    });
    let [along_x, along_y] = squares.fold([0.0, 0.0], |sum, of| [sum[0] + of[0], sum[1] + of[1]]);
    let both = along_x + along_y;
    match both > 0.0 {
        true if along_x >= ALONG_FROM * both => Some("x".to_owned()),
        true if along_y >= ALONG_FROM * both => Some("y".to_owned()),
        _ => None,
    }
}
