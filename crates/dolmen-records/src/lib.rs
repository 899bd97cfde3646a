//! Bytes to vibration records, ground motions and meshes, and back. Opens no file.

mod files;
pub mod meshes;
pub mod motions;
pub mod records;

pub use files::{
    FileError, Files, MESH_BYTES_MOST, MOTION_BYTES_MOST, MemoryFiles, NoFiles, RECORD_BYTES_MOST,
    TABLE_BYTES_MOST,
};
