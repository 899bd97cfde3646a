//! A table (CSV) of simulated designs for the training of a score.

use super::designs_error::ScoreDesignsError;
use crate::fingerprint::fingerprint;
use crate::wrong::DesignNeeds;
use dolmen::assess::{
    AssessError, Factor, Fragility, ScoreModel, SixFactors, SurfaceSettings, TrainedDesign,
};
use std::fmt::Write as _;

/// The states of a design, the mildest first, as columns and options name them.
pub const SCORE_STATES: [&str; 4] = ["ds1", "ds2", "ds3", "falls"];

/// The built-in designs; data/pagoda_score describes how they were made.
const SHIPPED: &str = include_str!("../../../../data/pagoda_score/designs.csv");

/// A simulated pagoda and its results for each state.
#[derive(Clone, Debug, PartialEq)]
pub struct ScoreDesign {
    /// Its factors.
    pub factors: SixFactors,
    /// Fragility over peak ground acceleration, m/s², for each state; `None` if the motions gave no curve.
    pub states: [Option<Fragility>; 4],
}

/// All designs of a study.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ScoreDesigns {
    /// The designs.
    pub designs: Vec<ScoreDesign>,
    /// Number of motions for each design, if the table gives it.
    pub motions: Option<usize>,
    /// Choice of the surface for each state, if the table gives it: DS1 to DS3, falls.
    pub settings: [Option<SurfaceSettings>; 4],
}

impl ScoreDesigns {
    /// The built-in designs.
    ///
    /// # Errors
    /// None for the table as shipped: a test reads it.
    pub fn shipped() -> Result<Self, ScoreDesignsError> {
        ScoreDesigns::read(SHIPPED.as_bytes())
    }

    /// Reads a table that [`ScoreDesigns::csv`] wrote.
    ///
    /// # Errors
    /// [`ScoreDesignsError`] with line and column.
    pub fn read(bytes: &[u8]) -> Result<Self, ScoreDesignsError> {
        let table = |why: csv::Error| ScoreDesignsError::Table { why: why.to_string() };
        let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(bytes);
        let head = reader.headers().map_err(table)?.clone();
        let place = |column: &str| {
            let found = head.iter().position(|name| name.trim() == column);
            found.ok_or_else(|| ScoreDesignsError::Column {
                column: column.to_owned(),
            })
        };
        let factors: Vec<usize> = Factor::ALL
            .iter()
            .map(|factor| place(factor.name()))
            .collect::<Result<_, _>>()?;
        let mut states = Vec::new();
        for state in SCORE_STATES {
            states.push([place(&theta(state))?, place(&beta(state))?]);
        }
        let mut designs = Vec::new();
        for row in reader.records() {
            let row = row.map_err(table)?;
            let line = row.position().map_or(0, |at| at.line() as usize);
            let text = |column: usize| row.get(column).unwrap_or_default().trim();
            let refuse = |column: usize, wanted: DesignNeeds| ScoreDesignsError::Value {
                line,
                column: head.get(column).unwrap_or_default().to_owned(),
                given: text(column).to_owned(),
                wanted: wanted.into(),
            };
            let number = |column: usize| {
                let value = text(column).parse::<f64>().ok().filter(|value| value.is_finite());
                value.ok_or_else(|| refuse(column, DesignNeeds::Number))
            };
            let storeys = text(factors[0]).parse();
            let mut found = [None; 4];
            for (state, [theta, beta]) in found.iter_mut().zip(&states) {
                if !text(*theta).is_empty() {
                    let curve = Fragility::new(number(*theta)?, number(*beta)?);
                    *state = Some(curve.map_err(|_| refuse(*theta, DesignNeeds::PositiveWithBeta))?);
                }
            }
            designs.push(ScoreDesign {
                factors: SixFactors {
                    storeys: storeys.map_err(|_| refuse(factors[0], DesignNeeds::WholeNumber))?,
                    body_height_m: number(factors[1])?,
                    slenderness_angle: number(factors[2])?,
                    body_slenderness: number(factors[3])?,
                    taper_rad: number(factors[4])?,
                    body_base_height_ratio: number(factors[5])?,
                },
                states: found,
            });
        }
        let mut found = ScoreDesigns {
            designs,
            ..ScoreDesigns::default()
        };
        found.read_remarks(&String::from_utf8_lossy(bytes));
        Ok(found)
    }

    /// The table: one row for each design, θ in m/s², empty without a curve.
    pub fn csv(&self) -> String {
        let mut out: Vec<String> = Factor::ALL
            .iter()
            .map(|factor| factor.name().to_owned())
            .collect();
        for state in SCORE_STATES {
            out.extend([theta(state), beta(state)]);
        }
        let mut out = self.remarks() + &out.join(",") + "\n";
        for design in &self.designs {
            let values: Vec<String> = design
                .factors
                .values()
                .iter()
                .map(|value| value.to_string())
                .collect();
            out += &values.join(",");
            for state in &design.states {
                let _ = match state {
                    Some(curve) => write!(out, ",{},{}", curve.theta(), curve.beta()),
                    None => write!(out, ",,"),
                };
            }
            out.push('\n');
        }
        out
    }

    /// Lines before the table: motions, and settings of the surfaces with the key of their designs.
    fn remarks(&self) -> String {
        let mut out = String::new();
        if let Some(motions) = self.motions {
            let _ = writeln!(out, "# motions {motions}");
        }
        for (state, settings) in self.settings.iter().enumerate() {
            if let Some(settings) = settings {
                let numbers = settings
                    .lengths
                    .iter()
                    .chain([&settings.noise, &settings.widened]);
                let numbers: Vec<String> = numbers.map(f64::to_string).collect();
                let _ = writeln!(
                    out,
                    "# surface {} {} of {}",
                    SCORE_STATES[state],
                    numbers.join(" "),
                    self.print_of(state)
                );
            }
        }
        out
    }

    /// Reads those lines; settings for other designs are left out.
    fn read_remarks(&mut self, text: &str) {
        for line in text.lines().map_while(|line| line.strip_prefix('#')) {
            match line.split_whitespace().collect::<Vec<_>>().as_slice() {
                ["motions", count] => self.motions = count.parse().ok().filter(|count| *count > 0),
                ["surface", name, numbers @ .., "of", print] => {
                    let state = SCORE_STATES.iter().position(|state| state == name);
                    let numbers: Vec<f64> = numbers.iter().filter_map(|word| word.parse().ok()).collect();
                    if let (Some(state), [lengths @ .., noise, widened]) = (state, numbers.as_slice())
                        && let Ok(lengths) = <[f64; 6]>::try_from(lengths)
                        && self.print_of(state) == *print
                    {
                        self.settings[state] = Some(SurfaceSettings {
                            lengths,
                            noise: *noise,
                            widened: *widened,
                        });
                    }
                }
                _ => {}
            }
        }
    }

    /// Key of the designs of a state.
    fn print_of(&self, state: usize) -> String {
        let of = |design: &TrainedDesign| -> Vec<u8> {
            let theta = design.fragility.theta();
            let values = design.factors.values().into_iter().chain([theta]);
            values.flat_map(f64::to_le_bytes).collect()
        };
        fingerprint(&self.of_state(state).iter().flat_map(of).collect::<Vec<u8>>())
    }

    /// Factors of all designs, with a curve or without.
    pub fn factors(&self) -> Vec<SixFactors> {
        self.designs.iter().map(|design| design.factors).collect()
    }

    /// The designs with a curve for a state, 0 to 3.
    pub fn of_state(&self, state: usize) -> Vec<TrainedDesign> {
        let found = self.designs.iter().filter_map(|design| {
            Some(TrainedDesign {
                factors: design.factors,
                fragility: (*design.states.get(state)?)?,
            })
        });
        found.collect()
    }

    /// The score of a state, 0 to 3.
    ///
    /// # Errors
    /// Those of [`ScoreModel::train`].
    pub fn model(&self, state: usize) -> Result<ScoreModel, AssessError> {
        let designs = self.of_state(state);
        match self.settings.get(state).copied().flatten() {
            Some(settings) => ScoreModel::of(&designs, self.motions, &settings),
            None => ScoreModel::train(&designs, self.motions),
        }
    }
}

fn theta(state: &str) -> String {
    format!("theta_{state}_m_s2")
}

fn beta(state: &str) -> String {
    format!("beta_{state}")
}
