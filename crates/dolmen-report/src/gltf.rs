//! Binary glTF 2.0 under construction: numbers in a buffer, and the two chunks of a .glb.

use serde_json::{Value, json};

/// Numbers of glTF 2.0.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
pub(crate) const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;
const MAGIC: u32 = 0x4654_6C67;
const JSON_CHUNK: u32 = 0x4E4F_534A;
const BINARY_CHUNK: u32 = 0x004E_4942;

/// A quarter turn about −x: z up becomes glTF's y up.
pub(crate) fn upright() -> [f64; 4] {
    [-(0.5_f64.sqrt()), 0.0, 0.0, 0.5_f64.sqrt()]
}

/// The numbers of a file, with their views and accessors.
#[derive(Default)]
pub(crate) struct Buffer {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Buffer {
    /// Adds rows of `N` numbers and returns their accessor; `target` marks them as vertices.
    pub(crate) fn rows<const N: usize>(
        &mut self,
        kind: &str,
        rows: &[[f32; N]],
        target: Option<u32>,
    ) -> usize {
        let start = self.bytes.len();
        let (mut least, mut most) = ([f32::INFINITY; N], [f32::NEG_INFINITY; N]);
        for row in rows {
            for (i, value) in row.iter().enumerate() {
                self.bytes.extend(value.to_le_bytes());
                least[i] = least[i].min(*value);
                most[i] = most[i].max(*value);
            }
        }
        self.view(start, target);
        self.accessors.push(json!({
            "bufferView": self.views.len() - 1, "componentType": FLOAT, "count": rows.len(), "type": kind,
            "min": least.to_vec(), "max": most.to_vec(),
        }));
        self.accessors.len() - 1
    }

    /// Adds the corners of triangles, three each, and returns their accessor.
    pub(crate) fn triangles(&mut self, triangles: &[[u32; 3]]) -> usize {
        let start = self.bytes.len();
        let corners = triangles.iter().flatten();
        self.bytes.extend(corners.flat_map(|corner| corner.to_le_bytes()));
        self.view(start, Some(ELEMENT_ARRAY_BUFFER));
        self.accessors.push(json!({
            "bufferView": self.views.len() - 1, "componentType": UNSIGNED_INT, "count": 3 * triangles.len(), "type": "SCALAR",
        }));
        self.accessors.len() - 1
    }

    fn view(&mut self, start: usize, target: Option<u32>) {
        let mut view = json!({ "buffer": 0, "byteOffset": start, "byteLength": self.bytes.len() - start });
        if let Some(target) = target {
            view["target"] = json!(target);
        }
        self.views.push(view);
    }

    /// The .glb file of these parts: `text` is everything except the asset, the buffer, its views and accessors.
    pub(crate) fn file(self, text: Value) -> Vec<u8> {
        let mut whole = json!({
            "asset": { "version": "2.0", "generator": concat!("dolmen ", env!("CARGO_PKG_VERSION")) },
        });
        if let (Some(parts), Value::Object(text)) = (whole.as_object_mut(), text) {
            parts.extend(text);
        }
        whole["buffers"] = json!([{ "byteLength": self.bytes.len() }]);
        whole["bufferViews"] = json!(self.views);
        whole["accessors"] = json!(self.accessors);
        container(whole.to_string().into_bytes(), self.bytes)
    }
}

/// A matt material of one colour in linear light.
pub(crate) fn dull(colour: [f64; 4]) -> Value {
    json!({ "pbrMetallicRoughness": {
        "baseColorFactor": colour, "metallicFactor": 0.0, "roughnessFactor": 0.95,
    } })
}

/// The two chunks of a .glb, each padded to a multiple of four bytes.
fn container(mut text: Vec<u8>, mut bytes: Vec<u8>) -> Vec<u8> {
    text.resize(text.len().next_multiple_of(4), b' ');
    bytes.resize(bytes.len().next_multiple_of(4), 0);
    let whole = 12 + 8 + text.len() + 8 + bytes.len();
    let mut out = Vec::with_capacity(whole);
    for word in [MAGIC, 2, whole as u32, text.len() as u32, JSON_CHUNK] {
        out.extend(word.to_le_bytes());
    }
    out.extend(text);
    for word in [bytes.len() as u32, BINARY_CHUNK] {
        out.extend(word.to_le_bytes());
    }
    out.extend(bytes);
    out
}
