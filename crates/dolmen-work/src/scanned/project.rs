//! The text of the project file.

use super::answer::{ScanUnit, ScannedStone};
use dolmen::structure::stack::SlicedBed;
use std::fmt::Write as _;

/// Data for the text of the file.
pub(super) struct Cut<'a> {
    /// Name of the file of the scan.
    pub(super) file: &'a str,
    pub(super) unit: ScanUnit,
    /// Displacement of the stones, m.
    pub(super) moved_m: [f64; 3],
    /// The beds in the coordinates of the scan.
    pub(super) beds: &'a [SlicedBed],
    /// The stones, lowest first.
    pub(super) stones: &'a [ScannedStone],
}

/// The project file for the stones of a scan; it marks assumed values as such.
pub(super) fn project_text(cut: &Cut<'_>) -> String {
    let file = one_line(cut.file);
    let beds: Vec<String> = cut.beds.iter().map(|bed| metres(bed.at_m)).collect();
    let mut text = format!(
        "# Stones cut from one scan, {file} (read as {}), at the beds {} m.\n\
         # The beds are planes because they were cut: the outside of a scan shows neither how rough a joint is, nor how much of it bears,\n\
         # nor what is inside of a stone. Look at drawing.svg, and put your own numbers in place of what is assumed below.\n\
         schema = 1\n\
         kind = \"stack\"\n\
         name = {{ en = \"Scanned tower\", ko = \"스캔한 탑\" }}\n\
         source = \"Cut from {file}\"\n\
         evidence = \"assumed\"                # where every number comes from that does not say it itself\n\
         density = 2600                      # kg/m3, granite; a block may have its own\n\n\
         # What acts in every joint that does not say it itself.\n\
         joint = {{ friction = 0.6, normal_stiffness = \"1e9 Pa/m\", shear_stiffness = \"4e8 Pa/m\", damping_ratio = 0.3 }}\n\n",
        cut.unit.symbol(),
        beds.join(", "),
    );
    if cut.moved_m != [0.0; 3] {
        let [x, y, z] = cut.moved_m.map(metres);
        let _ = writeln!(
            text,
            "# The stones stand where the scan has them, moved by [{x}, {y}, {z}] m, so that the ground is at 0."
        );
    }
    text += "blocks = [\n";
    for stone in cut.stones {
        let _ = writeln!(
            text,
            "  {{ name = \"{}\", shape = \"mesh\", file = \"{}\", coordinates = \"site\" }},",
            stone.name, stone.file
        );
    }
    text + "]\n"
}

fn metres(value: f64) -> String {
    let text = format!("{value:.4}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    match short {
        "-0" => "0".to_owned(),
        _ => short.to_owned(),
    }
}

/// A name that can stand in a comment and in a string.
fn one_line(name: &str) -> String {
    let plain = |c: char| match c {
        '"' | '\\' => '_',
        c if c.is_control() => '_',
        c => c,
    };
    name.chars().map(plain).collect()
}
