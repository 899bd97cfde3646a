//! Bytes to vibration records, ground motions and meshes, and back. Opens no file.

pub mod meshes;
pub mod motions;
pub mod records;
