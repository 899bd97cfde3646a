//! Vectors and convex polygons in space.

pub(super) fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Twice the area of a triangle, along its normal.
pub(super) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    let part = |j: usize, k: usize| a[j] * b[k] - a[k] * b[j];
    [part(1, 2), part(2, 0), part(0, 1)]
}

fn length(a: [f64; 3]) -> f64 {
    a.iter().map(|part| part * part).sum::<f64>().sqrt()
}

/// The triangles of a convex polygon.
fn triangles(corners: &[[f64; 3]]) -> impl Iterator<Item = [[f64; 3]; 3]> {
    let fan = corners.windows(2).skip(1);
    fan.map(|pair| [corners[0], pair[0], pair[1]])
}

/// Unit normal of a convex polygon whose corners are counterclockwise about it.
pub(super) fn unit_normal(corners: &[[f64; 3]]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for [a, b, c] in triangles(corners) {
        let area = cross(minus(b, a), minus(c, a));
        sum = [sum[0] + area[0], sum[1] + area[1], sum[2] + area[2]];
    }
    let size = length(sum);
    sum.map(|part| part / size)
}

/// Centroid of the area of a convex polygon, m.
pub(super) fn centroid(corners: &[[f64; 3]]) -> [f64; 3] {
    let (mut area, mut first) = (0.0, [0.0; 3]);
    for [a, b, c] in triangles(corners) {
        let part = length(cross(minus(b, a), minus(c, a)));
        area += part;
        for axis in 0..3 {
            first[axis] += part * (a[axis] + b[axis] + c[axis]) / 3.0;
        }
    }
    first.map(|moment| moment / area)
}
