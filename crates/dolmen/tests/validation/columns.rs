// SOURCE     Hencky (1920) Der Eisenbau 11:437-452; Greenhill (1881) Proc. Cambridge Phil. Soc. 4:65-73;
//            Kirchhoff (1879) Monatsber. Akad. Wiss. Berlin 815-828; Huang (1961) J. Appl. Mech. 28:579-584.
// GOAL       A chain buckles where the closed form says; many short links become a column.
// PARAMETERS unit links with a unit weight at the top; a column H = 1, EI = 1 of n links.
// PUBLISHED  P L/k = 4 sin²(π/(2(2n+1))), 0.0810140528 for n = 5; q H³/EI → 7.837347, 7.827244 for n = 20.
// TOLERANCE  1e-12 for the closed form; half a unit of the last digit written; order of convergence 2 ± 0.02;
//            frequencies 1e-7, at which the search for the degree ends.

use super::published::of;
use dolmen::comparisons::Case;

#[test]
fn exact_hencky_chains() {
    let cases = of("Hencky (1920)");
    assert_eq!(cases.len(), 4);
    assert!((cases[2].computed - 0.0810140528).abs() < 0.5e-10);
}

#[test]
fn exact_chains_become_greenhills_column() {
    let cases = of("Greenhill (1881)");
    let errors: Vec<f64> = cases.iter().copied().map(Case::difference).collect();
    assert!(
        (cases[0].computed - 7.827244).abs() < 0.5e-6,
        "{}",
        cases[0].computed
    );
    let order = (errors[0] / errors[1]).log2() / 2.0; // 20 to 80 links
    assert!((order - 2.0).abs() < 0.02, "order {order}");
}

#[test]
fn exact_frequencies_of_uniform_and_pointed_cantilevers() {
    let mut cases = of("Euler (1744)");
    cases.extend(of("Kirchhoff (1879)"));
    cases.extend(of("Huang (1961)"));
    assert_eq!(cases.len(), 18);
    // Kirchhoff's wedge and cone, as handbooks print them
    for (case, printed) in [(3, 5.315), (4, 15.207), (6, 8.719), (7, 21.146)] {
        assert!(
            (cases[case].published - printed).abs() < 6e-4,
            "{}",
            cases[case].published
        );
    }
}

#[test]
fn exact_roots_of_the_uniform_cantilever() {
    for coefficient in dolmen::known::columns::UNIFORM_CANTILEVER {
        let beta = f64::sqrt(coefficient);
        assert!((beta.cos() + 1.0 / beta.cosh()).abs() < 1e-10);
    }
}
