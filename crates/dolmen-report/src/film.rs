//! The animation of a simulation as binary glTF 2.0: one node per block, moved by keyframes.
//!
//! A root node rotates z up into glTF's y up. The mesh of each block is relative to its centroid; keyframes contain the
//! position of the centroid and the rotation of the block relative to the ground, so that the ground is at rest.

use crate::gltf::{ARRAY_BUFFER, Buffer, dull, upright};
use dolmen::blocks::{LooseStones, StackHistory};
use dolmen::structure::stack::{Block, Solid, Stack};
use dolmen_work::stack::{SettledRun, SettledSimulation, StackSimulation, SupportsRun, SupportsSimulation};
use serde_json::{Value, json};

/// Time between keyframes, s: 50 per second; viewers interpolate linearly. Our choice.
pub const FILM_STEP_S: f64 = 0.02;

/// Name of the scene of supports that move.
const SUPPORTS: &str = "supports move";
/// Name of the scene of loose stones that settle.
const SETTLES: &str = "stones settle";

/// Alternating colours of stones, linear light: similar, so that they separate stones without having a meaning.
const STONES: [[f64; 4]; 3] = [
    [0.64, 0.61, 0.56, 1.0],
    [0.55, 0.53, 0.49, 1.0],
    [0.71, 0.68, 0.62, 1.0],
];
/// Colour of the ground.
const EARTH: [f64; 4] = [0.33, 0.38, 0.30, 1.0];

/// Adds a mesh of flat triangles about `origin`.
fn mesh(buffer: &mut Buffer, name: &str, triangles: &[[[f64; 3]; 3]], material: usize) -> Value {
    let (mut places, mut normals) = (Vec::new(), Vec::new());
    for triangle in triangles {
        let normal = unit_normal(triangle).map(|part| part as f32);
        for corner in triangle {
            places.push(corner.map(|part| part as f32));
            normals.push(normal);
        }
    }
    let place = buffer.rows("VEC3", &places, Some(ARRAY_BUFFER));
    let normal = buffer.rows("VEC3", &normals, Some(ARRAY_BUFFER));
    json!({ "name": name, "primitives": [{
        "attributes": { "POSITION": place, "NORMAL": normal }, "material": material,
    }] })
}

fn unit_normal([a, b, c]: &[[f64; 3]; 3]) -> [f64; 3] {
    let minus = |p: &[f64; 3], q: &[f64; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    let (u, v) = (minus(b, a), minus(c, a));
    let normal = [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ];
    let length = normal.iter().map(|part| part * part).sum::<f64>().sqrt();
    normal.map(|part| part / length.max(f64::MIN_POSITIVE))
}

/// Triangles of a stone's hull, or of its pieces, about its centroid, outward; without those of zero area.
fn triangles(solid: &Solid) -> Vec<[[f64; 3]; 3]> {
    let centroid = solid.centroid_m();
    let fans = solid.drawn().into_iter().flat_map(|piece| {
        let at = |corner: usize| -> [f64; 3] {
            std::array::from_fn(|axis| piece.vertices_m()[corner][axis] - centroid[axis])
        };
        let faces = piece.faces().iter().flat_map(|face| {
            let fan = face.windows(2).skip(1);
            fan.map(|pair| [at(face[0]), at(pair[0]), at(pair[1])])
                .collect::<Vec<_>>()
        });
        faces.collect::<Vec<_>>()
    });
    let has_area = |triangle: &[[f64; 3]; 3]| unit_normal(triangle).iter().any(|part| part.abs() > 0.5);
    fans.filter(has_area).collect()
}

/// A square of ground under the stack, twice as wide as the stack.
fn ground(blocks: &[Block]) -> Vec<[[f64; 3]; 3]> {
    let far = blocks.iter().flat_map(|block| block.solid.bounds_m());
    let half = far.fold(0.0_f64, |most, at| most.max(at[0].abs()).max(at[1].abs())) * 2.0;
    let [a, b, c, d] =
        [[-half, -half], [half, -half], [half, half], [-half, half]].map(|p| [p[0], p[1], 0.0]);
    vec![[a, b, c], [a, c, d]]
}

/// The samples that become keyframes: the first of each [`FILM_STEP_S`], and the last.
fn keyframes(time_s: &[f64]) -> Vec<usize> {
    let mut kept: Vec<usize> = Vec::new();
    for (sample, time) in time_s.iter().enumerate() {
        let due = kept.last().is_none_or(|&last| {
            time - time_s[last] >= FILM_STEP_S * (1.0 - 1e-6) || sample + 1 == time_s.len()
        });
        if due {
            kept.push(sample);
        }
    }
    kept
}

/// A simulation as the bytes of a .glb file.
///
/// # Limits
/// Numbers have single precision, as glTF requires: positions are exact to about 1e-7 of the stack's size. Non-convex stones are shown by their
/// hull, without openings.
pub fn stack_film(simulation: &StackSimulation) -> Vec<u8> {
    let scene = [simulation.name.english(), simulation.motion.motion.name()];
    film_of(scene, &simulation.stack, &simulation.history)
}

/// The animation of a stack with moving supports, for one of its runs.
pub(crate) fn supports_film(of: &SupportsSimulation, run: &SupportsRun) -> Vec<u8> {
    let scene = [of.name.english(), SUPPORTS];
    film_of(scene, &of.stack, &run.moved.history)
}

/// The animations of loose stones by one law: how they settle, and what the motion does to them.
pub(crate) fn settled_films(of: &SettledSimulation, run: &SettledRun) -> Vec<(&'static str, Vec<u8>)> {
    let film = |stones: &LooseStones, start: &Stack, scene: &str| {
        film_of([of.name.english(), scene], start, &stones.history)
    };
    let settles = ("settles.glb", film(&run.settled, &of.drawn, SETTLES));
    let shaken = run.shaken.as_ref().zip(of.motion.as_ref());
    let film_of_motion = shaken.map(|(shaken, motion)| {
        let start = &run.settled.stack;
        ("film.glb", film(shaken, start, motion.motion.name()))
    });
    std::iter::once(settles).chain(film_of_motion).collect()
}

fn film_of([name, scene]: [&str; 2], stack: &Stack, history: &StackHistory) -> Vec<u8> {
    let blocks = stack.blocks();
    let samples = keyframes(&history.time_s);
    let mut film = Buffer::default();
    let mut meshes = vec![mesh(&mut film, "ground", &ground(blocks), STONES.len())];
    let mut nodes = vec![
        // z up to y up: a quarter turn about −x
        json!({
            "name": name, "rotation": upright(),
            "children": (1..blocks.len() + 2).collect::<Vec<_>>(),
        }),
        json!({ "name": "ground", "mesh": 0 }),
    ];
    let times: Vec<[f32; 1]> = samples.iter().map(|&s| [history.time_s[s] as f32]).collect();
    let (mut channels, mut samplers) = (Vec::new(), Vec::new());
    let time = film.rows("SCALAR", &times, None);
    for (number, block) in blocks.iter().enumerate() {
        meshes.push(mesh(
            &mut film,
            &block.name,
            &triangles(&block.solid),
            number % STONES.len(),
        ));
        let mut places: Vec<[f32; 3]> = Vec::with_capacity(samples.len());
        let mut turns: Vec<[f32; 4]> = Vec::with_capacity(samples.len());
        let mut before = [0.0, 0.0, 0.0, 1.0];
        for &sample in &samples {
            let pose = history.pose(sample, number);
            places.push(pose.centroid_m.map(|part| part as f32));
            let [w, x, y, z] = pose.rotation;
            // q and −q are the same rotation; neighbours must have the same sign, or viewers rotate the long way round
            let near: f64 = [x, y, z, w].iter().zip(before).map(|(a, b)| a * b).sum();
            let side = if near < 0.0 { -1.0 } else { 1.0 };
            before = [side * x, side * y, side * z, side * w];
            turns.push(before.map(|part| part as f32));
        }
        let node = nodes.len();
        let first = |rows: Option<&[f32; 3]>| rows.map(|row| row.to_vec());
        nodes.push(json!({
            "name": block.name, "mesh": number + 1,
            "translation": first(places.first()), "rotation": turns.first().map(|row| row.to_vec()),
        }));
        let outputs = [
            ("translation", film.rows("VEC3", &places, None)),
            ("rotation", film.rows("VEC4", &turns, None)),
        ];
        for (path, output) in outputs {
            channels.push(json!({ "sampler": samplers.len(), "target": { "node": node, "path": path } }));
            samplers.push(json!({ "input": time, "output": output, "interpolation": "LINEAR" }));
        }
    }
    let colours = STONES.iter().chain([&EARTH]);
    let materials: Vec<Value> = colours.map(|colour| dull(*colour)).collect();
    film.file(json!({
        "scene": 0, "scenes": [{ "name": scene, "nodes": [0] }],
        "nodes": nodes, "meshes": meshes, "materials": materials,
        "animations": [{ "name": scene, "channels": channels, "samplers": samplers }],
    }))
}
