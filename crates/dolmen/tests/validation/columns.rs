// SOURCE     Hencky (1920) Der Eisenbau 11:437-452; Greenhill (1881) Proc. Cambridge Phil. Soc. 4:65-73.
// GOAL       A chain buckles where the closed form says; many short links become a column.
// PARAMETERS unit links with a unit weight at the top; a column H = 1, EI = 1 of n links.
// PUBLISHED  P L/k = 4 sin²(π/(2(2n+1))), 0.0810140528 for n = 5; q H³/EI → 7.837347, 7.827244 for n = 20.
// TOLERANCE  1e-12 for the closed form; half a unit of the last digit written; order of convergence 2 ± 0.02.

use dolmen::validation::{Case, cases};

fn of(source: &str) -> Vec<Case> {
    cases()
        .unwrap()
        .into_iter()
        .filter(|case| case.source == source)
        .collect()
}

#[test]
fn exact_hencky_chains() {
    let cases = of("Hencky (1920)");
    assert_eq!(cases.len(), 4);
    for case in &cases {
        assert!(
            case.agrees(),
            "{}: {} against {}",
            case.what,
            case.computed,
            case.published
        );
    }
    assert!((cases[2].computed - 0.0810140528).abs() < 0.5e-10);
}

#[test]
fn exact_chains_become_greenhills_column() {
    let cases = of("Greenhill (1881)");
    let errors: Vec<f64> = cases.iter().map(Case::difference).collect();
    assert!(
        (cases[0].computed - 7.827244).abs() < 0.5e-6,
        "{}",
        cases[0].computed
    );
    assert!(cases.iter().all(Case::agrees));
    let order = (errors[0] / errors[1]).log2() / 2.0; // 20 to 80 links
    assert!((order - 2.0).abs() < 0.02, "order {order}");
}
