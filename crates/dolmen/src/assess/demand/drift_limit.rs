//! Allowable storey drift of codes under the design earthquake, as a ratio to the storey height.

/// Edition of the Korean code. Its table is quoted from memory, and was not compared with the text.
const KDS_41: &str = "KDS 41 17 00";
/// Allowable drift ratios of the seismic grades special, I and II: table 8.2-4 of KDS 41 17 00:2019.
const KDS_41_RATIOS: [f64; 3] = [0.010, 0.015, 0.020];
/// Edition of the European code.
const EUROCODE: &str = "EN 1998-1";
/// Limits of ν d_r over height for non-structural elements that are brittle, ductile, or do not interfere: EN 1998-1:2004,
/// 4.4.3.2 (1).
const EUROCODE_RATIOS: [f64; 3] = [0.005, 0.0075, 0.010];
/// ν of importance classes I to IV, recommended values: EN 1998-1:2004, 4.4.3.2 (2), note.
const EUROCODE_NU: [f64; 4] = [0.5, 0.5, 0.4, 0.4];

/// Drift ratio above which a storey does not count as standing, because models of small drifts are not valid there. Our choice,
/// as in [`FrameRun::drift_ratio_most`](crate::dynamics::FrameRun).
pub const DRIFT_RATIO_MOST: f64 = 0.1;

/// Seismic grade of KDS 41 17 00.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SeismicGrade {
    /// Grade special.
    Special,
    /// Grade I.
    First,
    /// Grade II.
    Second,
}

/// Importance class of EN 1998-1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImportanceClass {
    /// Class I.
    First,
    /// Class II.
    Second,
    /// Class III.
    Third,
    /// Class IV.
    Fourth,
}

/// Non-structural elements of a building by EN 1998-1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NonStructural {
    /// Brittle, attached to the structure.
    Brittle,
    /// Ductile.
    Ductile,
    /// None, or fixed so that they do not interfere.
    None,
}

/// An allowable storey drift and its source.
#[derive(Clone, Debug, PartialEq)]
pub enum DriftLimit {
    /// KDS 41 17 00.
    Kds41(SeismicGrade),
    /// EN 1998-1.
    Eurocode8 {
        /// Importance class of the building.
        importance: ImportanceClass,
        /// Type of the non-structural elements.
        non_structural: NonStructural,
    },
    /// A value given by the user.
    Given {
        /// Drift over height.
        ratio: f64,
        /// Source of the value, if given.
        source: Option<String>,
    },
}

impl DriftLimit {
    /// Largest allowed drift ratio under the design earthquake.
    ///
    /// ```text
    /// KDS 41 17 00:  Δ_a/h = 0.010, 0.015, 0.020 of grade special, I, II
    /// EN 1998-1:     d_r/h = (0.005, 0.0075, 0.010)/ν,  ν = 0.5 of classes I and II, 0.4 of III and IV
    /// ```
    ///
    /// # Limits
    /// For the elastic response to the full design spectrum, without a behaviour factor: d_s = d_e, and C_d δ_xe/I_E = δ_x.
    /// Neither table was compared with the text of its code.
    ///
    /// # Source
    /// KDS 41 17 00:2019, table 8.2-4; EN 1998-1:2004, 4.4.3.2 with the recommended ν.
    ///
    /// # Example
    /// ```
    /// use dolmen::assess::demand::{DriftLimit, ImportanceClass, NonStructural, SeismicGrade};
    /// assert_eq!(DriftLimit::Kds41(SeismicGrade::First).ratio(), 0.015);
    /// let brittle = DriftLimit::Eurocode8 {
    ///     importance: ImportanceClass::Third,
    ///     non_structural: NonStructural::Brittle,
    /// };
    /// assert!((brittle.ratio() - 0.0125).abs() < 1e-15);
    /// ```
    pub fn ratio(&self) -> f64 {
        match self {
            DriftLimit::Kds41(grade) => KDS_41_RATIOS[*grade as usize],
            DriftLimit::Eurocode8 {
                importance,
                non_structural,
            } => EUROCODE_RATIOS[*non_structural as usize] / EUROCODE_NU[*importance as usize],
            DriftLimit::Given { ratio, .. } => *ratio,
        }
    }

    /// Code and class, "KDS 41 17 00, I"; for a given value, the source stated by the user.
    pub fn source(&self) -> Option<String> {
        match self {
            DriftLimit::Kds41(grade) => {
                let grade = ["special", "I", "II"][*grade as usize];
                Some(format!("{KDS_41}, {grade}"))
            }
            DriftLimit::Eurocode8 { importance, .. } => {
                let class = ["I", "II", "III", "IV"][*importance as usize];
                Some(format!("{EUROCODE}, {class}"))
            }
            DriftLimit::Given { source, .. } => source.clone(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn published_limits_of_both_codes() {
        use SeismicGrade::{First, Second, Special};
        let korean = [Special, First, Second].map(|grade| DriftLimit::Kds41(grade).ratio());
        assert_eq!(korean, [0.010, 0.015, 0.020]);
        let european = |importance, non_structural| {
            DriftLimit::Eurocode8 {
                importance,
                non_structural,
            }
            .ratio()
        };
        use NonStructural::{Brittle, Ductile, None};
        assert_eq!(european(ImportanceClass::First, Brittle), 0.01);
        assert_eq!(european(ImportanceClass::Second, Ductile), 0.015);
        assert_eq!(european(ImportanceClass::Second, None), 0.02);
        assert!((european(ImportanceClass::Fourth, None) - 0.025).abs() < 1e-15);
    }
}
