//! `dolmen new`: shipped examples, and new projects copied from them.

use crate::bare::skeleton;
use crate::cli::{Kind, New};
use crate::manner::Manner;
use crate::outcome::Outcome;
use crate::say::say;
use crate::scanned;
use crate::typed_path::for_a_shell;
use crate::wrong::{CommandError, Noted};
use anyhow::Result;
use dolmen_records::{FileError, Files};
use include_dir::{Dir, File, include_dir};
use std::path::Path;

/// The folder `examples/` at build time.
static EXAMPLES: Dir = include_dir!("$CARGO_MANIFEST_DIR/../../examples");

/// A project in the report of `dolmen demo`.
pub(crate) struct Shown {
    /// The folder of the example.
    pub(crate) example: &'static str,
    /// Its project file.
    pub(crate) file: &'static str,
    /// The ground motion, by its name in the file.
    pub(crate) motion: Option<&'static str>,
}

/// Projects of `dolmen demo`, in order: a flagpole, a gate, a recorded building, a pagoda shaken at its site.
pub(crate) const DEMO: [Shown; 4] = [
    Shown::at_rest("naju_flagpole"),
    Shown::at_rest("heunginjimun_gate"),
    Shown::at_rest("palisaden"),
    Shown {
        example: "three_storey_pagoda",
        file: "at_its_site.toml",
        motion: Some("el-centro"),
    },
];

impl Shown {
    const fn at_rest(example: &'static str) -> Self {
        Shown {
            example,
            file: "project.toml",
            motion: None,
        }
    }
}

fn example_of(kind: Kind) -> &'static str {
    match kind {
        Kind::Flagpole => "naju_flagpole",
        Kind::Gate => "heunginjimun_gate",
        Kind::Pagoda => "three_storey_pagoda",
        Kind::Arch => "arch",
        Kind::Wall => "wall",
        Kind::Tower => "tower",
        Kind::Trilithon => "trilithon",
        Kind::Vault => "vault",
        Kind::Dome => "dome",
        Kind::Building => "twisting_floor",
        Kind::Survey => "palisaden",
    }
}

/// Writes the files of the example `name` into `directory`.
pub(crate) fn copy_example(name: &str, directory: &Path) -> Result<()> {
    let example = EXAMPLES.get_dir(name).ok_or_else(|| CommandError::NoExample {
        name: name.to_owned(),
    })?;
    let name = |file: &'static File<'static>| file.path().file_name().and_then(|name| name.to_str());
    let each = example
        .files()
        .filter_map(|file| Some((name(file)?, file.contents())));
    dolmen_folder::fill_fresh(directory, &each.collect::<Vec<_>>())
}

/// The files of an example.
pub(crate) struct Example(pub(crate) &'static str);

impl Files for Example {
    fn read(&self, name: &str, _most_bytes: u64) -> Result<Vec<u8>, FileError> {
        let found = EXAMPLES.get_file(format!("{}/{name}", self.0));
        match found {
            Some(file) => Ok(file.contents().to_vec()),
            None => Err(FileError::Absent {
                shown: format!("{}/{name}", self.0),
            }),
        }
    }
}

/// A text file of the example `name`.
pub(crate) fn example_text(name: &str, file: &str) -> Result<&'static str> {
    let found = EXAMPLES.get_file(format!("{name}/{file}"));
    found.and_then(include_dir::File::contents_utf8).ok_or_else(|| {
        CommandError::NoExample {
            name: format!("{name}/{file}"),
        }
        .into()
    })
}

pub(crate) fn run(options: &New, manner: &Manner) -> Result<Outcome> {
    if let Some(scan) = &options.of_scan.scan {
        return scanned::run(options, &options.of_scan, scan, manner);
    }
    let directory = &options.directory;
    let file = format!("{}/project.toml", directory.display());
    let said = match options.bare {
        true => {
            let text = skeleton(options.kind).as_bytes();
            dolmen_folder::fill_fresh(directory, &[("project.toml", text)])?;
            [Noted::Placeholders(file), Noted::NextOwnNumbers]
        }
        false => {
            let example = example_of(options.kind).to_owned();
            copy_example(&example, directory)?;
            [Noted::CopyOfExample { file, example }, Noted::NextNumbers]
        }
    };
    if !manner.quiet {
        let shown = directory.display();
        let mut lines: Vec<String> = said.into_iter().map(|one| one.text(manner)).collect();
        let verb = match options.kind {
            Kind::Flagpole
            | Kind::Pagoda
            | Kind::Arch
            | Kind::Wall
            | Kind::Tower
            | Kind::Trilithon
            | Kind::Vault
            | Kind::Dome
            | Kind::Building => "check",
            Kind::Gate if options.bare => "check",
            Kind::Gate | Kind::Survey => "identify",
        };
        let typed = for_a_shell(&shown.to_string());
        lines.push(format!("    dolmen {verb} {typed}"));
        let motion = match options.kind {
            Kind::Pagoda
            | Kind::Arch
            | Kind::Wall
            | Kind::Tower
            | Kind::Trilithon
            | Kind::Vault
            | Kind::Dome
            | Kind::Building => " --motion el-centro-1940-ns",
            Kind::Flagpole | Kind::Gate | Kind::Survey => "",
        };
        let page = for_a_shell(&format!("{shown}/report.html"));
        lines.push(format!("    dolmen report {typed}{motion} -o {page}"));
        say(&(lines.join("\n") + "\n"))?;
    }
    Ok(Outcome::Done)
}
