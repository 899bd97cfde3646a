//! Painting gives the same bytes each time, draws words, and refuses bad figures.

use crate::Painter;

fn svg(body: &str) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 60 30\" width=\"60\" height=\"30\" \
         font-family=\"'Noto Sans CJK KR',sans-serif\" font-size=\"20\">{body}</svg>"
    )
}

/// Width and height from the header of a PNG.
fn sides(png: &[u8]) -> [u32; 2] {
    assert!(png.starts_with(b"\x89PNG"));
    [16, 20].map(|at| u32::from_be_bytes(png[at..at + 4].try_into().unwrap()))
}

#[test]
fn holds_the_same_figure_gives_the_same_bytes_in_the_size_asked_for() {
    let figure = svg("<text x=\"2\" y=\"22\">석탑</text>");
    let once = Painter::new().png(&figure, 2.5).unwrap();
    assert_eq!(sides(&once), [150, 75]);
    assert_eq!(once, Painter::new().png(&figure, 2.5).unwrap());
}

#[test]
fn holds_words_are_painted_in_both_scripts() {
    let painter = Painter::new();
    let paint = |words: &str| {
        let figure = svg(&format!("<text x=\"2\" y=\"22\">{words}</text>"));
        painter.png(&figure, 1.0).unwrap()
    };
    let each = ["", "가", "나", "A", "⊕"].map(paint);
    for (at, one) in each.iter().enumerate() {
        assert!(!each[..at].contains(one), "picture {at} is that of other words");
    }
}

#[test]
fn refuses_what_is_no_figure_or_has_no_size() {
    let painter = Painter::new();
    assert!(painter.png("<html>", 1.0).is_err());
    for scale in [0.0, 1000.0, f32::NAN] {
        assert!(painter.png(&svg(""), scale).is_err(), "{scale}");
    }
}
