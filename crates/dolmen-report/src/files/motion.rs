//! Measured motions as files.

use super::named::NamedFile;
use crate::figures::motion_figures;
use crate::json::motion_report_json;
use dolmen_words::{Language, keeping_names};
use dolmen_work::motion::MotionReport;

/// Figures, JSON and, if spectra were computed, their table.
pub fn motion_files(report: &MotionReport, language: Language) -> Vec<NamedFile> {
    let figures = motion_figures(report, language).into_iter();
    let mut files: Vec<NamedFile> = figures.map(NamedFile::figure).collect();
    files.push(NamedFile::json(
        "motion.json",
        &keeping_names(|| motion_report_json(report)),
    ));
    if report.series.iter().any(|one| !one.spectrum.is_empty()) {
        files.push(NamedFile::new("spectrum.csv", spectrum_csv(report)));
    }
    files
}

fn spectrum_csv(report: &MotionReport) -> String {
    let mut out = "series,period_s,damping_ratio,displacement_m,displacement_at_samples_m,at_s,pseudo_velocity_m_s,pseudo_acceleration_m_s2\n".to_owned();
    for one in &report.series {
        let name = format!("\"{}\"", one.name.replace('"', "'"));
        for o in &one.spectrum {
            out += &format!(
                "{name},{},{},{},{},{},{},{}\n",
                o.period_s,
                o.damping_ratio,
                o.displacement_m,
                o.displacement_at_samples_m,
                o.at_s,
                o.pseudo_velocity_m_s(),
                o.pseudo_acceleration_m_s2()
            );
        }
    }
    out
}
