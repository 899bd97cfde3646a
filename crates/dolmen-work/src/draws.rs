//! Random values of the inputs of a structure.

use crate::error::WorkError;
use dolmen::numeric::{MeanAndCov, OrderedPair, Random, lognormal_at};
use dolmen_project::{Project, Quantity};

/// The inputs of a structure that scatter, in the order of the file.
pub(crate) struct Draws<'a> {
    inputs: Vec<Scattered<'a>>,
    pairs: Vec<Pair>,
}

/// An input that scatters.
#[derive(Clone, Copy)]
pub(crate) struct Scattered<'a> {
    pub(crate) quantity: &'a Quantity,
    cov: f64,
}

/// Two inputs of which the first is never above the second, with their places among those that scatter; `None` for a known one.
struct Pair {
    places: [Option<usize>; 2],
    values: OrderedPair,
}

impl<'a> Draws<'a> {
    /// The inputs of a project that scatter.
    ///
    /// # Errors
    /// [`WorkError::ScatterCrosses`] if an input cannot stay below another one, as it must, with the scatter of both.
    pub(crate) fn of(project: &'a Project) -> Result<Self, WorkError> {
        let inputs = project.structure_inputs().into_iter();
        let inputs: Vec<Scattered<'a>> = inputs
            .filter_map(|quantity| {
                let cov = quantity.cov.filter(|cov| *cov > 0.0)?;
                Some(Scattered { quantity, cov })
            })
            .collect();
        let pairs = project.ordered_inputs().into_iter();
        let pairs = pairs.filter_map(|pair| Pair::of(&inputs, pair).transpose());
        let pairs = pairs.collect::<Result<_, WorkError>>()?;
        Ok(Draws { inputs, pairs })
    }

    /// The inputs that scatter, in the order of the file.
    pub(crate) fn inputs(&self) -> &[Scattered<'a>] {
        &self.inputs
    }

    /// One value of each, in the order of the file: a value depends on no use. Each takes one normal number, also in a pair.
    pub(crate) fn draw(&self, random: &mut Random) -> Result<Vec<f64>, WorkError> {
        let normal: Vec<f64> = self.inputs.iter().map(|_| random.normal()).collect();
        let each = self.inputs.iter().zip(&normal);
        let mut values = each
            .map(|(input, z)| Ok(lognormal_at(*z, input.quantity.value, input.cov)?))
            .collect::<Result<Vec<f64>, WorkError>>()?;
        for pair in &self.pairs {
            let z = pair.places.map(|place| place.map_or(0.0, |place| normal[place]));
            for (place, value) in pair.places.into_iter().zip(pair.values.at(z)?) {
                if let Some(place) = place {
                    values[place] = value;
                }
            }
        }
        Ok(values)
    }
}

impl Pair {
    /// A pair of inputs; `None` if neither scatters, if the smaller one is 0, or if it is larger in the file.
    fn of(inputs: &[Scattered<'_>], pair: [&Quantity; 2]) -> Result<Option<Self>, WorkError> {
        let places = pair.map(|own| inputs.iter().position(|input| input.quantity.path == own.path));
        // the file itself may be refused later
        let is_ordered = pair[0].value > 0.0 && pair[0].value <= pair[1].value;
        if places == [None, None] || !is_ordered {
            return Ok(None);
        }
        let [smaller, larger] = [0, 1].map(|i| MeanAndCov {
            mean: pair[i].value,
            cov: places[i].map_or(0.0, |place| inputs[place].cov),
        });
        let Some(values) = OrderedPair::of(smaller, larger)? else {
            return Err(WorkError::ScatterCrosses {
                smaller: pair[0].path.clone(),
                smaller_cov: smaller.cov,
                larger: pair[1].path.clone(),
                larger_cov: larger.cov,
            });
        };
        Ok(Some(Pair { places, values }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::opened::Opened;
    use dolmen_records::NoFiles;
    use std::sync::Arc;

    fn gate(stiffness: &str, friction: &str) -> Arc<Project> {
        let file = format!(
            "schema = 1\nkind = \"frame\"\nname = \"Gate\"\nunits = {{ stiffness = \"kN/mm\" }}\n\
             storeys = [{{ mass = {{ value = \"30 t\", cov = 0.1 }}, height = \"4 m\" }}]\n\
             [direction.x]\nstiffness = [{stiffness}]\ndamping_ratio = {{ value = 0.03, cov = 0.2 }}\n\
             [direction.x.friction]\ncoefficient = {{ value = 0.05, cov = 0.3 }}\n{friction}\n"
        );
        Opened::read(file, "gate".into(), &NoFiles).unwrap().project
    }

    fn drawn(project: &Project, samples: u64) -> Vec<Vec<f64>> {
        let draws = Draws::of(project).unwrap();
        let each = (0..samples).map(|sample| draws.draw(&mut Random::new(5, sample)).unwrap());
        each.collect()
    }

    /// Independent draws crossed in 27 %.
    #[test]
    fn exact_slipping_joints_stay_softer_with_the_means_of_the_file() {
        const SAMPLES: u64 = 20_000;
        for (cov_stuck, cov_slipping) in [(0.3, 0.3), (0.2, 0.3)] {
            let project = gate(
                &format!("{{ value = 1.2, cov = {cov_stuck} }}"),
                &format!("law = \"jenkins\"\nslipping_stiffness = [{{ value = 0.9, cov = {cov_slipping} }}]"),
            );
            let all = drawn(&project, SAMPLES);
            let paths: Vec<String> = Draws::of(&project)
                .unwrap()
                .inputs()
                .iter()
                .map(|of| of.quantity.path.clone())
                .collect();
            let at = |path: &str| paths.iter().position(|own| own == path).unwrap();
            let (stuck, slipping) = (
                at("direction.x.stiffness[1]"),
                at("direction.x.friction.slipping_stiffness[1]"),
            );
            assert!(all.iter().all(|values| values[slipping] < values[stuck]));
            for (place, mean_n_m, cov) in [(stuck, 1.2e6, cov_stuck), (slipping, 0.9e6, cov_slipping)] {
                let n = SAMPLES as f64;
                let mean = all.iter().map(|values| values[place]).sum::<f64>() / n;
                let variance = all
                    .iter()
                    .map(|values| (values[place] - mean).powi(2))
                    .sum::<f64>()
                    / n;
                // four standard errors of the mean
                assert!(
                    (mean / mean_n_m - 1.0).abs() < 4.0 * cov / n.sqrt(),
                    "{place} {mean}"
                );
                assert!(
                    (variance.sqrt() / mean_n_m / cov - 1.0).abs() < 0.05,
                    "{place} {variance}"
                );
            }
        }
    }

    #[test]
    fn exact_all_other_draws_are_lognormal_in_the_order_of_the_file() {
        let coulomb = gate("{ value = 1.2, cov = 0.3 }", "");
        let jenkins = gate(
            "{ value = 1.2, cov = 0.3 }",
            "law = \"jenkins\"\nslipping_stiffness = [{ value = 0.9, cov = 0.3 }]",
        );
        for (one, other) in
            drawn(&coulomb, 5)
                .iter()
                .zip(drawn(&jenkins, 5))
                .zip(0..)
                .map(|(both, sample)| {
                    let mut random = Random::new(5, sample);
                    let each = [(30e3, 0.1), (1.2e6, 0.3), (0.03, 0.2), (0.05, 0.3)];
                    let own: Vec<f64> = each
                        .map(|(mean, cov)| random.lognormal(mean, cov).unwrap())
                        .to_vec();
                    assert_eq!(*both.0, own);
                    both
                })
        {
            assert_eq!([one[0], one[2], one[3]], [other[0], other[2], other[3]]);
        }
    }

    /// Independent draws crossed in 19 %.
    #[test]
    fn holds_joints_slip_no_later_than_they_stick() {
        let project = gate("1.2", "static_coefficient = { value = 0.06, cov = 0.3 }");
        let all = drawn(&project, 1000);
        // mass, damping ratio, both coefficients
        assert!(all.iter().all(|values| values[2] < values[3]), "{:?}", all[0]);
        let same = gate("1.2", "static_coefficient = { value = 0.05, cov = 0.3 }");
        assert!(drawn(&same, 100).iter().all(|values| values[2] == values[3]));
    }

    #[test]
    fn refuses_scatter_with_which_they_must_cross() {
        let project = gate(
            "1.2",
            "law = \"jenkins\"\nslipping_stiffness = [{ value = 0.9, cov = 0.6 }]",
        );
        let Err(WorkError::ScatterCrosses { smaller, .. }) = Draws::of(&project) else {
            panic!("not refused")
        };
        assert_eq!(smaller, "direction.x.friction.slipping_stiffness[1]");
    }
}
