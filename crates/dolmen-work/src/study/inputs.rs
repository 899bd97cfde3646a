//! Inputs of the cases: varied values, random values, and their columns.

use super::input_columns::{CaseInputs, InputColumn};
use super::shown_inputs::{bare_number, with_unit};
use crate::draws::Draws;
use crate::error::WorkError;
use dolmen::numeric::Random;
use dolmen_project::{HazardPart, ModelDamage, Override, Project, Quantity, StudyPart};
use dolmen_words::Unit;
use dolmen_words::message::Both;
use std::collections::BTreeMap;

/// Random values of one sample, by path.
#[derive(Clone, Debug, Default)]
pub(super) struct Drawn {
    values: Vec<(String, &'static str, f64)>,
    /// Unit of each in the file, with its size in SI.
    written_units: BTreeMap<String, (String, f64)>,
    by_path: BTreeMap<String, f64>,
}

impl Drawn {
    /// The value of an input: the random one, or its own.
    pub(super) fn pick(&self, quantity: &Quantity) -> f64 {
        self.by_path
            .get(&quantity.path)
            .copied()
            .unwrap_or(quantity.value)
    }
}

/// Draws the uncertain inputs in the order of the file. The values depend only on the seed and the number of the sample.
pub(super) fn drawn(project: &Project, seed: u64, sample: u64) -> Result<Drawn, WorkError> {
    let mut random = Random::new(seed, sample);
    let mut drawn = Drawn::default();
    let draws = Draws::of(project)?;
    for (input, value) in draws.inputs().iter().zip(draws.draw(&mut random)?) {
        let quantity = input.quantity;
        drawn.values.push((quantity.path.clone(), quantity.unit, value));
        drawn.by_path.insert(quantity.path.clone(), value);
        let unit = quantity.written_unit();
        drawn
            .written_units
            .extend(unit.map(|unit| (quantity.path.clone(), unit)));
    }
    Ok(drawn)
}

/// Cached results of reading a combination.
pub(super) struct ReadCombination {
    /// Fingerprint of everything that its model is built from.
    pub(super) model: String,
    /// Properties that its runs leave out.
    pub(super) left_out: Vec<Both>,
    /// Properties that its runs include in addition to the structure.
    pub(super) held: Vec<Both>,
    /// Damage of inspections in its model.
    pub(super) damage: Vec<ModelDamage>,
    /// Whether its runs have neither damping nor friction.
    pub(super) is_undamped: bool,
    /// Whether columns alone support a storey in its runs.
    pub(super) on_columns: bool,
    /// The allowable drift of a storey over its height.
    pub(super) drift_limit: Option<f64>,
    /// The hazard of its site.
    pub(super) hazard: Option<HazardPart>,
    /// The samples drawn.
    pub(super) samples: Vec<Drawn>,
    /// Value and SI unit of each varied input that is a quantity.
    pub(super) values: Vec<Option<(f64, &'static str)>>,
    /// Unit of each varied input in the file, with its size in SI.
    pub(super) written: Vec<Option<(String, f64)>>,
    /// Value and units of each input that the study sets.
    pub(super) set: Vec<Option<SetValue>>,
}

impl ReadCombination {
    /// Something of its runs; `None` if it was refused and has none.
    pub(super) fn of_runs<'a, T>(&self, of: &'a [T]) -> Option<&'a [T]> {
        (!self.model.is_empty()).then_some(of)
    }
}

/// Value and SI unit of a quantity at a path.
pub(super) fn value_at(project: Option<&Project>, path: &str) -> Option<(f64, &'static str)> {
    let quantity = project?.input(path)?;
    Some((quantity.value, quantity.unit))
}

/// A value that a study sets.
pub(super) struct SetValue {
    value: f64,
    /// Its unit in the file and its SI unit, each with its size in SI.
    units: Vec<(String, f64)>,
}

impl SetValue {
    /// The value at a path; `None` if it is no quantity.
    fn at(project: Option<&Project>, path: &str) -> Option<Self> {
        let quantity = project?.input(path)?;
        let si = (quantity.unit.to_owned(), 1.0);
        Some(SetValue {
            value: quantity.value,
            units: quantity.written_unit().into_iter().chain([si]).collect(),
        })
    }
}

/// Values and units of the inputs that a study sets.
pub(super) fn set_values(study: &StudyPart, project: Option<&Project>) -> Vec<Option<SetValue>> {
    let each = study.set.iter().map(|set| SetValue::at(project, &set.path));
    each.collect()
}

/// Units of the varied inputs in the file, each with its size in SI.
pub(super) fn written_units(study: &StudyPart, project: Option<&Project>) -> Vec<Option<(String, f64)>> {
    let each = study.vary.iter();
    each.map(|axis| project?.input(&axis.path)?.written_unit())
        .collect()
}

/// "pagoda.body_height = 3.0 m": the values that a study sets, as shown.
pub(super) fn set_shown(study: &StudyPart, read: &[ReadCombination]) -> Vec<String> {
    let each = study.set.iter().enumerate().map(|(index, set)| {
        let found = read.iter().find_map(|read| read.set.get(index)?.as_ref());
        let units = found.map_or(&[][..], |of| &of.units);
        let text = with_unit(&set.text, found.map(|of| of.value), units);
        format!("{} = {text}", set.path)
    });
    each.collect()
}

/// The columns of the inputs: varied ones, then random ones.
pub(super) fn input_columns(study: &StudyPart, read: &[ReadCombination]) -> Vec<InputColumn> {
    let mut columns = Vec::new();
    for (index, axis) in study.vary.iter().enumerate() {
        let unit = read
            .iter()
            .find_map(|read| Some(read.values.get(index).copied()??.1));
        let is_number = unit.is_some() || axis.values.iter().all(|value| bare_number(&value.text).is_some());
        let own = column(&axis.path, unit.unwrap_or_default(), is_number, false);
        let mut written_units: Vec<(String, f64)> = Vec::new();
        let written = read.iter().filter_map(|read| read.written.get(index)?.clone());
        for unit in written.chain([(own.unit.clone(), 1.0)]) {
            if !written_units.contains(&unit) {
                written_units.push(unit);
            }
        }
        columns.push(InputColumn { written_units, ..own });
    }
    let mut drawn: Vec<&str> = Vec::new();
    for (path, unit, _) in read
        .iter()
        .flat_map(|read| read.samples.iter().flat_map(|s| &s.values))
    {
        if !drawn.contains(&path.as_str()) {
            drawn.push(path);
            columns.push(column(path, unit, true, true));
        }
    }
    columns
}

/// A unit for each random input, by its path: that of the file, or of a size that suits its values.
pub(super) fn drawn_units(columns: &[InputColumn], read: &[ReadCombination]) -> BTreeMap<String, Unit> {
    let samples = || read.iter().flat_map(|read| &read.samples);
    let unit = |input: &InputColumn| {
        let written = samples().find_map(|sample| sample.written_units.get(&input.path));
        match written {
            Some((symbol, size)) => Unit {
                symbol: symbol.replace('*', "·"),
                factor: 1.0 / size,
            },
            None => {
                let values: Vec<f64> = samples()
                    .filter_map(|sample| sample.by_path.get(&input.path).copied())
                    .collect();
                Unit::of(&values, &input.unit)
            }
        }
    };
    let drawn = columns.iter().filter(|input| input.is_drawn);
    drawn.map(|input| (input.path.clone(), unit(input))).collect()
}

fn column(path: &str, unit: &str, is_number: bool, is_drawn: bool) -> InputColumn {
    let clean = |text: &str| -> String {
        let letters = text
            .chars()
            .map(|c| if c.is_ascii_alphanumeric() { c } else { '_' });
        let mut out: String = letters.collect();
        while out.contains("__") {
            out = out.replace("__", "_");
        }
        out.trim_matches('_').to_lowercase()
    };
    let drawn = if is_drawn { "drawn_" } else { "" };
    let unit_text = clean(unit);
    let name = clean(path);
    InputColumn {
        path: path.to_owned(),
        column: if unit_text.is_empty() {
            format!("{drawn}{name}")
        } else {
            format!("{drawn}{name}_{unit_text}")
        },
        unit: unit.to_owned(),
        written_units: Vec::new(),
        is_number,
        is_drawn,
    }
}

/// The inputs of one case in the order of the columns.
pub(super) fn case_inputs(
    (variant, values): (Option<&str>, &[&Override]),
    read: &ReadCombination,
    sample: &Drawn,
    columns: &[InputColumn],
) -> CaseInputs {
    let of = |(index, input): (usize, &InputColumn)| {
        if input.is_drawn {
            let value = sample.by_path.get(&input.path).copied();
            return (value, value.map_or(String::new(), |value| value.to_string()));
        }
        let text = values.get(index).map_or("", |value| &value.text);
        let value = match read.values.get(index).copied().flatten() {
            Some((value, _)) => Some(value),
            None => bare_number(text),
        };
        (value, text.trim_matches('"').to_owned())
    };
    let (values, texts) = columns.iter().enumerate().map(of).unzip();
    CaseInputs {
        variant: variant.map(str::to_owned),
        values,
        texts,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_columns_carry_their_unit() {
        for (path, unit, name) in [
            ("pagoda.body_height", "m", "pagoda_body_height_m"),
            ("joint.normal_stiffness", "Pa/m", "joint_normal_stiffness_pa_m"),
            ("links[2].weight", "N", "links_2_weight_n"),
            ("pagoda.storeys", "", "pagoda_storeys"),
        ] {
            assert_eq!(column(path, unit, true, false).column, name);
        }
        assert_eq!(
            column("density", "kg/m3", true, true).column,
            "drawn_density_kg_m3"
        );
    }
}
