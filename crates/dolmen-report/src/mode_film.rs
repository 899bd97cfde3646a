//! An animated mode shape as binary glTF 2.0: the sensors and the lines between them, blended by two shapes.
//!
//! ```text
//! x(t) = x₀ + s (Re φ cos ωt − Im φ sin ωt)        weights of the two shapes: cos ωt, −sin ωt
//! ```

use crate::figures::Wires;
use crate::gltf::{ARRAY_BUFFER, Buffer, dull, upright};
use dolmen::modal::Mode;
use serde_json::{Value, json};
use std::f64::consts::TAU;

/// Number of steps in a period, and its duration, s: every mode moves at the same pace.
const STEPS: usize = 24;
const PERIOD_S: f64 = 2.0;
/// Largest displacement, radius of the lines and of the sensors, relative to the diagonal of the structure.
const SWING: f64 = 0.12;
const LINE: f64 = 0.004;
const SENSOR: f64 = 0.012;
/// Colours in linear light: at rest, moving lines, sensors.
const COLOURS: [[f64; 4]; 3] = [
    [0.55, 0.57, 0.60, 1.0],
    [0.0, 0.17, 0.45, 1.0],
    [0.66, 0.11, 0.0, 1.0],
];

/// Triangles whose corners belong to positions.
#[derive(Default)]
struct Solid {
    corners: Vec<[f64; 3]>,
    places: Vec<usize>,
    triangles: Vec<[u32; 3]>,
}

impl Solid {
    fn corner(&mut self, at: [f64; 3], place: usize) -> u32 {
        self.corners.push(at);
        self.places.push(place);
        self.corners.len() as u32 - 1
    }

    /// A rod of four sides between two positions; nothing if they coincide.
    fn rod(&mut self, places: &[[f64; 3]], (a, b): (usize, usize), radius: f64) {
        let (from, to) = (places[a], places[b]);
        let along = sum(to, from, -1.0);
        let length = norm(along);
        if length < radius {
            return;
        }
        // across the line, along the axis least parallel to it
        let least = (0..3)
            .min_by(|i, j| along[*i].abs().total_cmp(&along[*j].abs()))
            .unwrap_or(0);
        let mut axis = [0.0; 3];
        axis[least] = 1.0;
        let u = cross(along, axis);
        let u = u.map(|part| part * radius / norm(u));
        let v = cross(along, u).map(|part| part / length);
        let ring = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
        let around = |end: [f64; 3], [p, q]: [f64; 2]| sum(sum(end, u, p), v, q);
        let first = ring.map(|side| self.corner(around(from, side), a));
        let last = ring.map(|side| self.corner(around(to, side), b));
        for side in 0..4 {
            let next = (side + 1) % 4;
            self.triangles.push([first[side], first[next], last[next]]);
            self.triangles.push([first[side], last[next], last[side]]);
        }
        for [i, j, k] in [[0, 2, 1], [0, 3, 2]] {
            self.triangles.push([first[i], first[j], first[k]]);
            self.triangles.push([last[i], last[k], last[j]]);
        }
    }

    /// An octahedron about a place.
    fn bead(&mut self, places: &[[f64; 3]], place: usize, radius: f64) {
        let mut ends = [[0_u32; 2]; 3];
        for (axis, both) in ends.iter_mut().enumerate() {
            for (side, end) in [1.0, -1.0].into_iter().zip(both) {
                let mut at = places[place];
                at[axis] += side * radius;
                *end = self.corner(at, place);
            }
        }
        for octant in 0..8 {
            let [i, j, k] = [octant & 1, octant >> 1 & 1, octant >> 2 & 1];
            let [x, y, z] = [ends[0][i], ends[1][j], ends[2][k]];
            // outward: reversed once for each negative side
            self.triangles.push(if (i + j + k) % 2 == 0 {
                [x, y, z]
            } else {
                [x, z, y]
            });
        }
    }

    /// The mesh; with `moved`, the real and the imaginary part of each position's motion as shapes to blend.
    fn mesh(
        &self,
        buffer: &mut Buffer,
        (name, material): (&str, usize),
        moved: Option<&[[[f64; 3]; 2]]>,
    ) -> Value {
        let single = |at: [f64; 3]| at.map(|part| part as f32);
        let places: Vec<[f32; 3]> = self.corners.iter().map(|at| single(*at)).collect();
        let place = buffer.rows("VEC3", &places, Some(ARRAY_BUFFER));
        let corners = buffer.triangles(&self.triangles);
        let mut primitive =
            json!({ "attributes": { "POSITION": place }, "indices": corners, "material": material });
        let mut mesh = json!({ "name": name });
        if let Some(moved) = moved {
            let targets = [0, 1].map(|part| {
                let rows: Vec<[f32; 3]> = self.places.iter().map(|at| single(moved[*at][part])).collect();
                json!({ "POSITION": buffer.rows("VEC3", &rows, Some(ARRAY_BUFFER)) })
            });
            primitive["targets"] = json!(targets);
            mesh["weights"] = json!([1.0, 0.0]);
        }
        mesh["primitives"] = json!([primitive]);
        mesh
    }
}

fn sum(a: [f64; 3], b: [f64; 3], factor: f64) -> [f64; 3] {
    std::array::from_fn(|i| a[i] + factor * b[i])
}

fn norm(a: [f64; 3]) -> f64 {
    a.iter().map(|part| part * part).sum::<f64>().sqrt()
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// Mode `number` at the sensors as the bytes of a .glb file: metres, y up, 24 steps per period. Grey parts are at rest. The largest
/// displacement is 0.12 of the diagonal of the structure; name and extras of the scene give it in metres.
pub(crate) fn mode_film(wires: &Wires, (number, mode): (usize, &Mode)) -> Vec<u8> {
    let bound = |axis: usize| {
        let values = wires.places.iter().map(|place| place[axis]);
        let (least, most) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| {
            (a.min(x), b.max(x))
        });
        most - least
    };
    let size_m = norm([0, 1, 2].map(bound));
    let shape: Vec<[f64; 2]> = mode.shape.iter().map(|z| [z.re, z.im]).collect();
    let most_m = SWING * size_m;
    let moved = wires.moved(&shape, most_m);
    let (mut lines, mut beads) = (Solid::default(), Solid::default());
    for wire in &wires.wires {
        for pair in wire.windows(2) {
            lines.rod(&wires.places, (pair[0], pair[1]), LINE * size_m);
        }
    }
    for sensor in 0..wires.sensors {
        beads.bead(&wires.places, sensor, SENSOR * size_m);
    }
    let mut buffer = Buffer::default();
    let (mut meshes, mut nodes, mut channels) = (Vec::new(), Vec::new(), Vec::new());
    let steps = 0..=STEPS;
    let times: Vec<[f32; 1]> = steps
        .clone()
        .map(|n| [(PERIOD_S * n as f64 / STEPS as f64) as f32])
        .collect();
    let weights: Vec<[f32; 1]> = steps
        .flat_map(|n| {
            let (sin, cos) = (TAU * n as f64 / STEPS as f64).sin_cos();
            [[cos as f32], [-sin as f32]]
        })
        .collect();
    let (input, output) = (
        buffer.rows("SCALAR", &times, None),
        buffer.rows("SCALAR", &weights, None),
    );
    let parts = [
        (&lines, ("at rest", 0), false),
        (&lines, ("lines", 1), true),
        (&beads, ("sensors", 2), true),
    ];
    for (solid, named, moves) in parts {
        if solid.triangles.is_empty() {
            continue;
        }
        meshes.push(solid.mesh(&mut buffer, named, moves.then_some(&moved[..])));
        nodes.push(json!({ "name": named.0, "mesh": meshes.len() - 1 }));
        if moves {
            channels.push(json!({ "sampler": 0, "target": { "node": nodes.len(), "path": "weights" } }));
        }
    }
    let name = format!(
        "mode {number}, {:.4} Hz; largest displacement {most_m:.3} m as drawn, {PERIOD_S} s a period",
        mode.frequency_hz
    );
    let root =
        json!({ "name": name, "rotation": upright(), "children": (1..=nodes.len()).collect::<Vec<_>>() });
    nodes.insert(0, root);
    buffer.file(json!({
        "scene": 0,
        "scenes": [{ "name": name, "nodes": [0], "extras": {
            "mode": number, "frequency_hz": mode.frequency_hz, "damping_ratio": mode.damping_ratio,
            "largest_displacement_m": most_m, "period_s": PERIOD_S,
        } }],
        "nodes": nodes, "meshes": meshes, "materials": COLOURS.map(dull),
        "animations": [{ "name": name, "channels": channels, "samplers": [
            { "input": input, "output": output, "interpolation": "LINEAR" },
        ] }],
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen::modal::{Identify, Modes, ReferenceCase, identify};

    fn modes() -> Modes {
        let record = ReferenceCase::ShearChain.made(1).unwrap().make().unwrap();
        let mut modes = identify(&record, &Identify::default()).unwrap().modes;
        for (i, channel) in modes.channels.iter_mut().enumerate() {
            channel.position_m = Some([0.0, 0.0, 4.0 * (1 + i) as f64]);
            channel.direction = Some([1.0, 0.0, 0.0]);
        }
        modes
    }

    /// Text and numbers of a .glb, read by the format description.
    fn opened(bytes: &[u8]) -> (Value, Vec<u8>) {
        let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
        assert_eq!((&bytes[..4], word(4), word(8)), (&b"glTF"[..], 2, bytes.len()));
        let text = word(12);
        assert_eq!(&bytes[16..20], b"JSON");
        assert_eq!(&bytes[24 + text..28 + text], b"BIN\0");
        assert_eq!(28 + text + word(20 + text), bytes.len());
        (
            serde_json::from_slice(&bytes[20..20 + text]).unwrap(),
            bytes[28 + text..].to_vec(),
        )
    }

    fn numbers(text: &Value, bytes: &[u8], accessor: &Value) -> Vec<f32> {
        let accessor = &text["accessors"][accessor.as_u64().unwrap() as usize];
        let view = &text["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
        let [start, length] = ["byteOffset", "byteLength"].map(|key| view[key].as_u64().unwrap() as usize);
        let words = bytes[start..start + length].chunks(4);
        words
            .map(|word| f32::from_le_bytes(word.try_into().unwrap()))
            .collect()
    }

    /// The blend of the two shapes equals the mode at each of 24 steps, with the stated largest displacement.
    #[test]
    fn exact_the_shapes_blend_to_the_motion_of_the_mode() {
        let mut modes = modes();
        let mode = &mut modes.modes[1];
        mode.shape[0].im = 0.4;
        let wires = Wires::of(&modes).unwrap();
        let mode = &modes.modes[1];
        let (text, bytes) = opened(&mode_film(&wires, (2, mode)));
        let extras = &text["scenes"][0]["extras"];
        let most = extras["largest_displacement_m"].as_f64().unwrap();
        assert!(
            (most - SWING * 8.0).abs() < 1e-12
                && text["scenes"][0]["name"].as_str().unwrap().contains("0.960 m")
        );
        let sampler = &text["animations"][0]["samplers"][0];
        let times = numbers(&text, &bytes, &sampler["input"]);
        let weights = numbers(&text, &bytes, &sampler["output"]);
        assert_eq!(
            (times.len(), weights.len(), times[STEPS]),
            (STEPS + 1, 2 * STEPS + 2, 2.0)
        );
        let beads = text["meshes"].as_array().unwrap().last().unwrap();
        let primitive = &beads["primitives"][0];
        let targets = [0, 1].map(|part| numbers(&text, &bytes, &primitive["targets"][part]["POSITION"]));
        let scale = most
            / [0, 1]
                .map(|at| mode.shape[at].norm())
                .into_iter()
                .fold(0.0, f64::max);
        for step in 0..=STEPS {
            let (sin, cos) = (TAU * step as f64 / STEPS as f64).sin_cos();
            for sensor in 0..2 {
                // six corners per sensor
                let x = 18 * sensor;
                let moved = weights[2 * step] * targets[0][x] + weights[2 * step + 1] * targets[1][x];
                let exact = scale * (mode.shape[sensor].re * cos - mode.shape[sensor].im * sin);
                assert!(
                    (f64::from(moved) - exact).abs() < 1e-5,
                    "{step} {sensor}: {moved} {exact}"
                );
                assert_eq!(targets[0][x + 1], 0.0);
            }
        }
        // z up becomes y up
        let turn = text["nodes"][0]["rotation"].as_array().unwrap();
        assert_eq!(
            (turn[0].as_f64(), turn[3].as_f64()),
            (Some(-(0.5_f64.sqrt())), Some(0.5_f64.sqrt()))
        );
    }

    /// Every triangle faces outward, away from the middle of its rod or bead.
    #[test]
    fn holds_rods_and_beads_look_outward() {
        let places = [[0.0, 0.0, 0.0], [1.0, 2.0, 3.0]];
        let (mut rod, mut bead) = (Solid::default(), Solid::default());
        rod.rod(&places, (0, 1), 0.1);
        bead.bead(&places, 1, 0.3);
        assert_eq!((rod.triangles.len(), bead.triangles.len()), (12, 8));
        for solid in [rod, bead] {
            let count = solid.corners.len() as f64;
            let middle = solid
                .corners
                .iter()
                .fold([0.0; 3], |all, at| sum(all, *at, 1.0 / count));
            for triangle in &solid.triangles {
                let [a, b, c] = triangle.map(|corner| solid.corners[corner as usize]);
                let normal = cross(sum(b, a, -1.0), sum(c, a, -1.0));
                let out = sum(a, middle, -1.0);
                assert!((0..3).map(|i| normal[i] * out[i]).sum::<f64>() > 0.0);
            }
        }
    }
}
