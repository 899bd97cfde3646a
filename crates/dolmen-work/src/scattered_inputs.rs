//! Adds the scatter of weights and dimensions to the standard deviation of an identified stiffness.

use crate::error::WorkError;
use crate::surveyed::StiffnessAnswer;
use dolmen::structure::StiffnessSolution;
use dolmen_project::{Pick, Project, Quantity};

/// Adds the variance from the inputs to that of each stiffness; the inputs are independent, and their effect is linearised:
///
/// ```text
/// σ_k² = σ_k²(modes) + Σ_i [(k(q_i + σ_i) − k(q_i − σ_i))/2]²
/// ```
///
/// If a solution vanishes when an input changes by one standard deviation, it has no linear deviation and loses its own. Tested by
/// `exact_the_weight_of_one_link_scatters_its_stiffness`.
pub(crate) fn add_scatter_of_inputs(
    project: &Project,
    mut answers: Vec<StiffnessAnswer>,
    identify: impl Fn(Pick<'_>) -> Result<Vec<StiffnessAnswer>, WorkError>,
) -> Vec<StiffnessAnswer> {
    let has_sd = |of: &StiffnessAnswer| {
        of.solutions
            .solutions
            .iter()
            .any(|one| one.stiffness_sd.is_some())
    };
    if !answers.iter().any(has_sd) {
        return answers;
    }
    for input in project.inputs().into_iter().filter(|input| is_of_body(input)) {
        let sd = input.standard_deviation();
        let moved = |by: f64| {
            identify(&mut |of: &Quantity| match of.path == input.path {
                true => of.value + by,
                false => of.value,
            })
        };
        let ends = [moved(sd), moved(-sd)].map(Result::ok);
        for (at, answer) in answers.iter_mut().enumerate() {
            let at_end =
                |end: &'_ Option<Vec<StiffnessAnswer>>| end.as_ref().and_then(|all| all.get(at).cloned());
            let ends = [at_end(&ends[0]), at_end(&ends[1])];
            for solution in &mut answer.solutions.solutions {
                add(solution, &ends);
            }
        }
    }
    answers
}

/// Whether an input with scatter is a weight, dimension or load. Stiffness is the unknown, and surveys have their own deviations.
fn is_of_body(input: &Quantity) -> bool {
    let path = input.path.as_str();
    let is_other = path.starts_with("survey.") || path.contains("stiffness") || path.contains("damping");
    input.standard_deviation() > 0.0 && !is_other
}

/// Adds the contribution of one input.
fn add(solution: &mut StiffnessSolution, ends: &[Option<StiffnessAnswer>; 2]) {
    let near = |end: &Option<StiffnessAnswer>| nearest(&solution.stiffness, end.as_ref()?);
    let [upper, lower] = [near(&ends[0]), near(&ends[1])];
    let Some((upper, lower)) = upper.zip(lower) else {
        solution.stiffness_sd = None;
        return;
    };
    let sd = solution.stiffness_sd.iter_mut().flatten();
    for (sd, (upper, lower)) in sd.zip(upper.iter().zip(&lower)) {
        *sd = sd.hypot(0.5 * (upper - lower));
    }
}

/// The solution nearest to a stiffness, by logarithms.
fn nearest(stiffness: &[f64], answer: &StiffnessAnswer) -> Option<Vec<f64>> {
    let apart = |of: &StiffnessSolution| -> f64 {
        let each = of.stiffness.iter().zip(stiffness);
        each.map(|(a, b)| (a / b).ln().powi(2)).sum()
    };
    let solutions = answer.solutions.solutions.iter();
    let nearest = solutions.min_by(|a, b| apart(a).total_cmp(&apart(b)));
    nearest.map(|of| of.stiffness.clone())
}

#[cfg(test)]
mod tests {
    use crate::kinds::stiffness;
    use crate::opened::Opened;
    use dolmen_project::Quantity;
    use dolmen_records::NoFiles;

    /// Relative deviation of the stiffness of a pole on one joint.
    fn relative_sd(weight: &str, sd_hz: f64) -> f64 {
        let file = format!(
            "schema = 1\nkind = \"chain\"\nname = \"Pole\"\njoints = \"unknown\"\n\
             links = [{{ weight = {weight}, length = 10, centroid = 5 }}]\n\
             [survey.2026-04-02]\nfrequencies.x = [{{ value = 0.5, sd = {sd_hz} }}]\n"
        );
        let project = Opened::read(file, "p".into(), &NoFiles).unwrap().project;
        let modes = project.surveys[0].measured_modes("x", &mut Quantity::nominal);
        let found = stiffness(&project, "x", &modes, &[]).unwrap();
        let one = &found[0].solutions.solutions[0];
        one.stiffness_sd.as_ref().unwrap()[0] / one.stiffness[0]
    }

    #[test]
    fn exact_the_weight_of_one_link_scatters_its_stiffness() {
        // k = W (h + I ω²/W): with only the weight uncertain, σ_k/k is its cov
        let of_modes = relative_sd("\"40 kN\"", 0.01);
        let of_both = relative_sd("{ value = \"40 kN\", cov = 0.06 }", 0.01);
        let exact = of_modes.hypot(0.06);
        assert!((of_both / exact - 1.0).abs() < 1e-6, "{of_both} {exact}");
        assert!(of_both > 1.3 * of_modes);
    }
}
