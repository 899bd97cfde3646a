//! Any bytes are a mesh whose triangles name its vertices, or an error; any mesh is a solid or an error.

use dolmen_records::meshes::{read_mesh, read_obj, read_ply, read_stl};

pub(super) fn run(bytes: &[u8]) {
    let _ = (read_obj(bytes), read_ply(bytes), read_stl(bytes));
    if let Ok(mesh) = read_mesh(bytes) {
        let named = mesh.triangles.iter().flatten();
        assert!(named.into_iter().all(|&corner| corner < mesh.vertices.len()));
        let _ = dolmen::structure::stack::Solid::mesh(&mesh.vertices, &mesh.triangles);
    }
}
