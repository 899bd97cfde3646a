//! Scanned stones: the planes of their dressed faces, found in meshes whose vertices carry noise.

mod curvature;
mod fit;
mod half_spaces;
mod plane;
mod regions;
mod rounding;
mod surface;

pub(super) use fit::fitted;
pub(super) use plane::Plane;
pub(super) use surface::noise_of;
