//! Numbers printed in Choi, J.-S. (2021) "A study on dynamic analysis model and stability of stone cultural properties
//! of inverted pendulum type with 5 joints", J. Korea Inst. Struct. Maint. Insp.; its formulas as printed. The pole is
//! the stone flagpole of Naju, lowest part first.

/// Table 1: weight of each part, kN.
pub const WEIGHT_KN: [f64; 5] = [38.95, 15.13, 6.78, 4.51, 2.93];
/// Table 1: length of each part, m.
pub const LENGTH_M: [f64; 5] = [3.68, 2.61, 1.63, 1.54, 1.37];
/// Table 1: height of each centre of mass above the part's lower joint, m.
pub const CENTROID_M: [f64; 5] = [1.64, 1.18, 0.78, 0.69, 0.66];

/// Table 1: critical stiffness of each joint, kN m/rad.
pub const CRITICAL_KN_M_RAD: [f64; 5] = [128.64, 43.24, 11.73, 5.69, 1.93];
/// Text below Table 2: k_b,cr / k_cr of the lowest and of the highest joint.
pub const BUCKLING_RATIO_ENDS: [f64; 2] = [5.7, 2.1];

/// Table 3: critical stiffness with the centre of mass of part 3 lowered by 20 %, kN m/rad.
pub const CRITICAL_LOWERED_3_KN_M_RAD: [f64; 5] = [127.58, 44.30, 10.67, 5.69, 1.93];
/// Table 3: its change, per cent.
pub const CHANGE_LOWERED_3_PERCENT: [f64; 5] = [-0.8, 2.4, -9.0, 0.0, 0.0];
/// Table 3: critical stiffness with the centre of mass of part 5 lowered by 20 %, kN m/rad.
pub const CRITICAL_LOWERED_5_KN_M_RAD: [f64; 5] = [128.25, 43.62, 11.34, 6.07, 1.54];
/// Table 3: its change, per cent.
pub const CHANGE_LOWERED_5_PERCENT: [f64; 5] = [-0.3, 0.9, -3.3, 6.8, -20.0];

/// Eqs 38–42 term by term, as printed: critical stiffness of five joints from weights w, lengths L and centroids l.
///
/// ```text
/// k_cr,1 = w_1 l_1 + w_2 (L_1 − l_2) + w_3 (L_1 − L_2 + l_3) + w_4 (L_1 − L_2 + L_3 − l_4)
///          + w_5 (L_1 − L_2 + L_3 − L_4 + l_5)                       and so on upwards; 5 values
/// ```
pub fn critical_stiffness(w: &[f64; 5], lengths: &[f64; 5], l: &[f64; 5]) -> [f64; 5] {
    let [l1, l2, l3, l4, _] = *lengths;
    [
        w[0] * l[0]
            + w[1] * (l1 - l[1])
            + w[2] * (l1 - l2 + l[2])
            + w[3] * (l1 - l2 + l3 - l[3])
            + w[4] * (l1 - l2 + l3 - l4 + l[4]),
        w[1] * l[1] + w[2] * (l2 - l[2]) + w[3] * (l2 - l3 + l[3]) + w[4] * (l2 - l3 + l4 - l[4]),
        w[2] * l[2] + w[3] * (l3 - l[3]) + w[4] * (l3 - l4 + l[4]),
        w[3] * l[3] + w[4] * (l4 - l[4]),
        w[4] * l[4],
    ]
}
