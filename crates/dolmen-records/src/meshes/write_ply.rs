//! Triangles as a PLY file.

use super::Mesh;

/// A mesh as a binary PLY file, its coordinates to the last bit.
pub fn mesh_ply(mesh: &Mesh) -> Vec<u8> {
    let head = format!(
        "ply\nformat binary_little_endian 1.0\ncomment metres\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        mesh.vertices.len(),
        mesh.triangles.len()
    );
    let mut bytes = head.into_bytes();
    for vertex in &mesh.vertices {
        bytes.extend(vertex.iter().flat_map(|value| value.to_le_bytes()));
    }
    for triangle in &mesh.triangles {
        bytes.push(3);
        let corners = triangle.map(|corner| u32::try_from(corner).unwrap_or(u32::MAX)); // a file of 2 GiB holds fewer
        bytes.extend(corners.iter().flat_map(|corner| corner.to_le_bytes()));
    }
    bytes
}
