//! The inputs of a study's runs.

/// One varied or random input of the runs.
#[derive(Clone, Debug, PartialEq)]
pub struct InputColumn {
    /// Its path in the project file.
    pub path: String,
    /// Its column in tables, the unit last.
    pub column: String,
    /// Its SI unit; empty without one.
    pub unit: String,
    /// Units of its values in the file, each with its size in SI; the SI unit last.
    pub written_units: Vec<(String, f64)>,
    /// Whether its values are numbers.
    pub is_number: bool,
    /// Whether it is random, not varied.
    pub is_drawn: bool,
}

/// The inputs of one case: a combination of varied values, and a sample.
#[derive(Clone, Debug, PartialEq)]
pub struct CaseInputs {
    /// The variant; `None` for the file as it is.
    pub variant: Option<String>,
    /// One value for each input, in SI; `None` if it is not a number or was refused.
    pub values: Vec<Option<f64>>,
    /// The same values as written.
    pub texts: Vec<String>,
}
