//! Eurocode 8 (EN 1998-1:2004): elastic horizontal spectra with the recommended parameters.

use super::spectrum::{Branches, DampingFactor, STANDARD_GRAVITY_M_S2, Shape, within};
use super::{DesignSpectrum, Unverified, VerticalRatio};
use crate::assess::AssessError;

/// Year of the edition, quoted from memory and not compared with its text.
const YEAR: u16 = 2004;
/// S and T_B, T_C, T_D in s, for ground types A to E; first type 1, then type 2.
const PARAMETERS: [[[f64; 4]; 5]; 2] = [
    [
        [1.0, 0.15, 0.4, 2.0],
        [1.2, 0.15, 0.5, 2.0],
        [1.15, 0.2, 0.6, 2.0],
        [1.35, 0.2, 0.8, 2.0],
        [1.4, 0.15, 0.5, 2.0],
    ],
    [
        [1.0, 0.05, 0.25, 1.2],
        [1.35, 0.05, 0.25, 1.2],
        [1.5, 0.1, 0.25, 1.2],
        [1.8, 0.1, 0.3, 1.2],
        [1.6, 0.05, 0.25, 1.2],
    ],
];
/// Acceleration of the plateau over S a_g.
const PLATEAU: f64 = 2.5;
/// Vertical over horizontal ground acceleration of type 1 and 2, quoted from memory and not compared with the text of the
/// code.
const VERTICAL: [f64; 2] = [0.9, 0.45];
/// Largest accepted a_g, g: a larger value probably has a wrong unit. Our choice.
const GROUND_MOST_G: f64 = 2.0;

/// Type of the spectrum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EurocodeType {
    /// Earthquakes with a surface-wave magnitude above 5.5 govern.
    One,
    /// Earthquakes with a surface-wave magnitude up to 5.5 govern.
    Two,
}

/// Ground type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EurocodeGround {
    /// Rock.
    A,
    /// Very dense sand, gravel or very stiff clay.
    B,
    /// Dense sand, gravel or stiff clay.
    C,
    /// Loose soil.
    D,
    /// Several metres of C or D on rock.
    E,
}

/// Elastic horizontal spectrum of Eurocode 8 for a design ground acceleration on rock, a_g, in g.
///
/// ```text
/// A_0 = S a_g    A_p = 2.5 S a_g    η = √(10/(5 + ξ)) ≥ 0.55, ξ in percent    beyond T_D: η A_p T_C T_D/T²
/// a_v = 0.9 a_g (type 1), 0.45 a_g (type 2), without S; the ratio to A_0 is therefore 0.9/S, 0.45/S
/// ```
///
/// # Errors
/// [`AssessError::Numeric`] for a_g outside 0 … 2 g.
///
/// # Limits
/// Recommended parameters; a national annex may change them. The formula is also used beyond T = 4 s, where the code refers to
/// Recommended parameters; a national annex may change them. The formula is also used for T > 4 s, where the code refers to
/// its annex A. η and the vertical acceleration (table 3.4 as commonly cited) were not compared with the text of the code.
/// # Source
/// EN 1998-1:2004, 3.2.2.2, tables 3.2 and 3.3.
///
/// # Example
/// ```
/// use dolmen::assess::demand::{EurocodeGround, EurocodeType, eurocode_8};
/// let spectrum = eurocode_8(0.2, EurocodeType::One, EurocodeGround::C)?;
/// assert!((spectrum.acceleration_m_s2(0.4, 0.05)? / 9.80665 - 2.5 * 1.15 * 0.2).abs() < 1e-12);
/// # Ok::<(), dolmen::assess::AssessError>(())
/// ```
pub fn eurocode_8(
    ground_acceleration_g: f64,
    spectrum: EurocodeType,
    ground: EurocodeGround,
) -> Result<DesignSpectrum, AssessError> {
    let a_g = within(
        "ground_acceleration_g",
        ground_acceleration_g,
        [f64::MIN_POSITIVE, GROUND_MOST_G],
        "above 0 and at most 2: is it in g?",
    )?;
    let [soil, rise_s, plateau_s, displacement_s] = PARAMETERS[spectrum as usize][ground as usize];
    let ground_m_s2 = STANDARD_GRAVITY_M_S2 * soil * a_g;
    Ok(DesignSpectrum {
        source: format!(
            "EN 1998-1:{YEAR}, a_g = {a_g} g, type {}, ground {ground:?}",
            spectrum as usize + 1
        ),
        vertical: Some(VerticalRatio {
            ratio: VERTICAL[spectrum as usize] / soil,
            verified: false,
        }),
        unverified: vec![
            Unverified::Edition { year: YEAR },
            Unverified::VerticalRatio {
                ratio: VERTICAL[spectrum as usize] / soil,
            },
            Unverified::DampingFactor,
        ],
        shape: Shape::Branches(Branches {
            ground_m_s2,
            plateau_m_s2: PLATEAU * ground_m_s2,
            rise_s,
            plateau_s,
            displacement_s,
            damping: DampingFactor::Eurocode,
        }),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn published_every_branch_of_type_one_b_and_type_two_d() {
        let cases = [
            (EurocodeType::One, EurocodeGround::B, [1.2, 0.15, 0.5, 2.0]),
            (EurocodeType::Two, EurocodeGround::D, [1.8, 0.1, 0.3, 1.2]),
        ];
        for (kind, ground, [s, tb, tc, td]) in cases {
            let spectrum = eurocode_8(0.1, kind, ground).unwrap();
            let at =
                |t, zeta| spectrum.acceleration_m_s2(t, zeta).unwrap() / (0.1 * s * STANDARD_GRAVITY_M_S2);
            let wanted = [
                (0.0, 1.0),
                (0.5 * tb, 1.75),
                (tb, 2.5),
                (tc, 2.5),
                (td, 2.5 * tc / td),
                (2.0 * td, 2.5 * tc * td / (4.0 * td * td)),
            ];
            for (t, wanted) in wanted {
                assert!(
                    (at(t, 0.05) - wanted).abs() < 1e-12,
                    "{kind:?} {t}: {}",
                    at(t, 0.05)
                );
            }
            assert!((at(tc, 0.02) - 2.5 * (10.0_f64 / 7.0).sqrt()).abs() < 1e-12);
            assert!((at(tc, 0.3) - 2.5 * 0.55).abs() < 1e-12);
            assert!((at(0.0, 0.02) - 1.0).abs() < 1e-15);
        }
    }

    /// S, T_B, T_C, T_D as tables 3.2 and 3.3 list them.
    const TABLES: [(EurocodeType, &str); 2] = [
        (
            EurocodeType::One,
            "A 1 .15 .4 2; B 1.2 .15 .5 2; C 1.15 .2 .6 2; D 1.35 .2 .8 2; E 1.4 .15 .5 2",
        ),
        (
            EurocodeType::Two,
            "A 1 .05 .25 1.2; B 1.35 .05 .25 1.2; C 1.5 .1 .25 1.2; D 1.8 .1 .3 1.2; E 1.6 .05 .25 1.2",
        ),
    ];

    #[test]
    fn published_every_number_of_both_tables() {
        use EurocodeGround::{A, B, C, D, E};
        for (kind, table) in TABLES {
            for (ground, row) in [A, B, C, D, E].into_iter().zip(table.split(';')) {
                let mut cells = row.split_whitespace();
                assert_eq!(cells.next().unwrap(), format!("{ground:?}"));
                let [s, tb, tc, td] = [(); 4].map(|()| cells.next().unwrap().parse::<f64>().unwrap());
                let spectrum = eurocode_8(0.25, kind, ground).unwrap();
                let branches = spectrum.branches().unwrap();
                let peak = 0.25 * s * STANDARD_GRAVITY_M_S2;
                assert!(
                    (branches.ground_m_s2 / peak - 1.0).abs() < 1e-14,
                    "{kind:?} {ground:?}"
                );
                assert!(
                    (branches.plateau_m_s2 / peak - 2.5).abs() < 1e-14,
                    "{kind:?} {ground:?}"
                );
                assert_eq!(
                    [branches.rise_s, branches.plateau_s, branches.displacement_s],
                    [tb, tc, td],
                    "{kind:?} {ground:?}"
                );
                // the branches end exactly at these periods
                let at = |t: f64| spectrum.acceleration_m_s2(t, 0.05).unwrap() / (2.5 * peak);
                let beside = [
                    (1.0005 * tb, 1.0),
                    (0.9995 * tc, 1.0),
                    (1.0005 * tc, 1.0 / 1.0005),
                ];
                for (t, wanted) in beside {
                    assert!(
                        (at(t) - wanted).abs() < 1e-12,
                        "{kind:?} {ground:?} {t}: {}",
                        at(t)
                    );
                }
                assert!(at(0.9995 * tb) < 1.0 - 1e-4);
                let vertical = if kind == EurocodeType::One { 0.9 } else { 0.45 };
                assert_eq!(spectrum.vertical.unwrap().ratio, vertical / s);
            }
        }
    }

    #[test]
    fn refuses_accelerations_in_another_unit() {
        for a_g in [0.0, -0.1, 2.5, f64::NAN] {
            assert!(eurocode_8(a_g, EurocodeType::One, EurocodeGround::A).is_err());
        }
    }
}
