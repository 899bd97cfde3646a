//! The figures of reports as files: SVG, PNG, and their numbers as CSV.

use super::named::NamedFile;
use crate::document::{Block, Figure, Numbers, csv_row, figure_label, series_csv};
use crate::html::project_name;
use crate::whole::whole_document;
use dolmen_words::{Language, keeping_names};
use dolmen_work::answer::ProjectReport;

/// A figure that could not be painted.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{figure} could not be painted: {why}")]
pub struct NotDrawn {
    /// "Figure 2.1".
    pub figure: String,
    /// Reason.
    pub why: String,
}

/// Every figure of the reports, named by its number: SVG, PNG by `paint`, and its data as CSV; and the list of all with their captions. With several
/// projects, each has a folder.
///
/// # Errors
/// [`NotDrawn`].
pub fn figure_files(
    answers: &[ProjectReport],
    language: Language,
    paint: &dyn Fn(&str) -> Result<Vec<u8>, String>,
) -> Result<Vec<NamedFile>, NotDrawn> {
    let mut files = Vec::new();
    for (at, answer) in answers.iter().enumerate() {
        let alone = answers.len() == 1;
        let mut numbers = match alone {
            true => Numbers::alone(),
            false => Numbers::of_project(at + 1),
        };
        let folder = format!("{} {}", at + 1, project_name(answer, language));
        let own = of_project(answer, &mut numbers, language, paint)?;
        files.extend(own.into_iter().map(|file| match alone {
            true => file,
            false => file.within(&folder),
        }));
    }
    Ok(files)
}

fn of_project(
    answer: &ProjectReport,
    numbers: &mut Numbers,
    language: Language,
    paint: &dyn Fn(&str) -> Result<Vec<u8>, String>,
) -> Result<Vec<NamedFile>, NotDrawn> {
    let mut files = Vec::new();
    let mut list = format!(
        "\u{feff}{}",
        csv_row(["figure", "caption", "files"].map(str::to_owned).into_iter())
    );
    for block in whole_document(answer).blocks {
        match block {
            Block::Heading(_) => {
                numbers.section();
            }
            Block::Figures(figures) => {
                for figure in figures {
                    let number = numbers.figure();
                    let own = of_figure(&figure, &number, language, paint)?;
                    let caption: Vec<String> = figure.caption.iter().map(|one| one.text(language)).collect();
                    let names: Vec<&str> = own.iter().map(|file| file.name.as_str()).collect();
                    let row = [number, caption.join(" "), names.join(" ")];
                    list += &csv_row(row.into_iter());
                    files.extend(own);
                }
            }
            // photographs are separate files, and are numbered with the figures
            Block::Photos(photos) => {
                for _ in photos.iter().filter(|photo| photo.image.is_some()) {
                    numbers.figure();
                }
            }
            _ => {}
        }
    }
    files.push(NamedFile::new("figures.csv", list));
    Ok(files)
}

fn of_figure(
    figure: &Figure<'_>,
    number: &str,
    language: Language,
    paint: &dyn Fn(&str) -> Result<Vec<u8>, String>,
) -> Result<Vec<NamedFile>, NotDrawn> {
    let svg = (figure.draw)(language);
    let painted = paint(&svg).map_err(|why| NotDrawn {
        figure: figure_label(number, language),
        why,
    })?;
    let name = format!("figure-{number}");
    Ok(vec![
        NamedFile::svg(&name, &svg),
        NamedFile::new(&format!("{name}.png"), painted),
        NamedFile::new(
            &format!("{name}.csv"),
            keeping_names(|| series_csv(&(figure.series)(), language)),
        ),
    ])
}
