//! Meshes and stacks of blocks: OBJ, STL and PLY to triangles; stacks to OBJ, JSON, 3DEC and ParaView.

mod error;
mod mesh;
mod obj;
mod ply;
mod read;
mod stl;
mod write;
mod write_ply;

pub use error::MeshError;
pub use mesh::Mesh;
pub use obj::read_obj;
pub use ply::read_ply;
pub use read::{MeshFormat, read_mesh};
pub use stl::read_stl;
pub use write::{
    BlockPose, PoseError, SeriesFile, poses_as_drawn, series_pvd, stack_3dec, stack_json, stack_obj,
    stack_vtu,
};
pub use write_ply::mesh_ply;
