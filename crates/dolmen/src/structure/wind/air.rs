//! Densities of air in codes.

/// Density of air of EN 1991-1-4:2005, 4.5, kg/m³.
pub const EUROCODE_AIR_KG_M3: f64 = 1.25;
/// Density of air of KDS 41 12 00, kg/m³.
pub const KDS_41_AIR_KG_M3: f64 = 1.225;
