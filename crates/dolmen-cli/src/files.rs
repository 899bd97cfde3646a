//! The only place that touches the disk: opening inputs with a clear error, and writing results whole or not at all.

use anyhow::{Context as _, Result, bail};
use dolmen_records::FileError;
use dolmen_report::files::NamedFile;
use std::fs;
use std::io::{Read as _, Write as _};
use std::path::{Path, PathBuf};

/// The project file that `path` means: itself, or `project.toml` in the folder it names.
pub(crate) fn project_file(path: &Path) -> Result<PathBuf> {
    if path.is_dir() {
        let file = path.join("project.toml");
        if !file.is_file() {
            bail!(
                "{} holds no project.toml: name the project file, or start one with `dolmen new flagpole DIR`",
                path.display()
            );
        }
        return Ok(file);
    }
    if !path.exists() {
        bail!(
            "{} does not exist: name a project file or its folder, or start one with `dolmen new flagpole DIR`",
            path.display()
        );
    }
    Ok(path.to_owned())
}

/// All bytes of a file.
pub(crate) fn read(path: &Path) -> Result<Vec<u8>> {
    fs::read(path).with_context(|| format!("cannot read {}", path.display()))
}

/// All bytes of a file that a project names, if they are not too many.
pub(crate) fn read_at_most(path: &Path, most: u64) -> Result<Vec<u8>, FileError> {
    let shown = || path.display().to_string();
    let unreadable = |why: std::io::Error| FileError::Unreadable {
        shown: shown(),
        why: why.to_string(),
    };
    let file = fs::File::open(path).map_err(unreadable)?;
    let bytes = file.metadata().map_err(unreadable)?.len();
    let too_large = |bytes: u64| FileError::TooLarge {
        shown: shown(),
        bytes,
        most,
    };
    if bytes > most {
        return Err(too_large(bytes));
    }
    let mut read = Vec::with_capacity(bytes as usize);
    file.take(most.saturating_add(1))
        .read_to_end(&mut read)
        .map_err(unreadable)?;
    match read.len() as u64 {
        bytes if bytes > most => Err(too_large(bytes)),
        _ => Ok(read),
    }
}

/// All of a text file, which must be UTF-8.
pub(crate) fn read_text(path: &Path) -> Result<String> {
    String::from_utf8(read(path)?).map_err(|fault| {
        let at = fault.utf8_error().valid_up_to();
        anyhow::anyhow!(
            "{} is not UTF-8 text (byte {at}): save it as UTF-8; Korean text saved as EUC-KR or CP949 must be converted",
            path.display()
        )
    })
}

/// Writes `bytes` to `path` whole or not at all: a temporary file beside it, then a rename. A device or a pipe is written to as it is.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    if fs::metadata(path).is_ok_and(|there| !there.is_file() && !there.is_dir()) {
        let opened = fs::OpenOptions::new().write(true).open(path);
        let written = opened.and_then(|mut file| file.write_all(bytes).and_then(|()| file.flush()));
        return written.with_context(|| format!("cannot write {}", path.display()));
    }
    let folder = path
        .parent()
        .filter(|p| !p.as_os_str().is_empty())
        .unwrap_or(Path::new("."));
    fs::create_dir_all(folder).with_context(|| format!("cannot make the folder {}", folder.display()))?;
    let name = path
        .file_name()
        .map(|n| n.to_string_lossy().into_owned())
        .unwrap_or_default();
    let temporary = folder.join(format!(".{name}.{}.part", std::process::id()));
    let written = fs::File::create(&temporary)
        .and_then(|mut file| file.write_all(bytes).and_then(|()| file.sync_all()))
        .and_then(|()| fs::rename(&temporary, path));
    if let Err(fault) = written {
        let _ = fs::remove_file(&temporary); // what is left of it, if anything
        return Err(fault).with_context(|| format!("cannot write {}", path.display()));
    }
    Ok(())
}

/// Prints results to standard output. A reader that has gone (`| head`) ends it quietly; a full disk is an error.
pub(crate) fn say(text: &str) -> Result<()> {
    match std::io::stdout().write_all(text.as_bytes()) {
        Err(fault) if fault.kind() == std::io::ErrorKind::BrokenPipe => Ok(()),
        written => written.context("cannot write to standard output"),
    }
}

/// Prints a value as JSON.
pub(crate) fn say_json(value: &serde_json::Value) -> Result<()> {
    say(&format!("{value:#}\n"))
}

/// Writes files into a folder.
pub(crate) fn write_all(folder: &Path, files: &[NamedFile]) -> Result<()> {
    for file in files {
        write(&folder.join(&file.name), &file.bytes)?;
    }
    Ok(())
}

/// Makes `path` a folder to be filled: refused if it holds anything, so that nothing is overwritten.
pub(crate) fn fresh_folder(path: &Path) -> Result<()> {
    if path.exists() && !path.is_dir() {
        bail!(
            "{} is a file: name a folder that does not exist yet",
            path.display()
        );
    }
    if path.is_dir() && fs::read_dir(path)?.next().is_some() {
        bail!(
            "{} is not empty: name a folder that does not exist yet, so that nothing is lost",
            path.display()
        );
    }
    fs::create_dir_all(path).with_context(|| format!("cannot make the folder {}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scratch(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("dolmen-files-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        folder
    }

    #[test]
    fn holds_a_failed_write_leaves_the_old_file_and_no_part() {
        let folder = scratch("write");
        let file = folder.join("report.html");
        write(&file, b"old").unwrap();
        let taken = folder.join("taken");
        fs::create_dir_all(taken.join("full")).unwrap();
        assert!(
            write(&taken, b"new").is_err(),
            "a folder that is not empty cannot be replaced by a file"
        );
        write(&file, b"new").unwrap();
        assert_eq!(fs::read(&file).unwrap(), b"new");
        let names: Vec<_> = fs::read_dir(&folder)
            .unwrap()
            .map(|e| e.unwrap().file_name())
            .collect();
        assert_eq!(names.len(), 2, "{names:?}");
        fs::remove_dir_all(folder).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn holds_a_device_is_written_to_and_stays_one() {
        use std::os::unix::fs::FileTypeExt as _;
        let full = Path::new("/dev/full");
        if !full.exists() {
            return; // not on every system
        }
        // through a link, so that nothing of the system can be lost whatever the code does
        let folder = scratch("device");
        let link = folder.join("report.html");
        std::os::unix::fs::symlink(full, &link).unwrap();
        let fault = write(&link, b"new").unwrap_err();
        assert!(fault.to_string().contains("cannot write"), "{fault}");
        let there = fs::metadata(&link).unwrap().file_type();
        assert!(there.is_char_device() && fs::symlink_metadata(&link).unwrap().is_symlink());
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn refuses_a_folder_without_a_project_and_says_how_to_start_one() {
        let folder = scratch("empty");
        let message = project_file(&folder).unwrap_err().to_string();
        assert!(message.contains("holds no project.toml"), "{message}");
        let message = fresh_folder(folder.parent().unwrap()).unwrap_err().to_string();
        assert!(message.contains("is not empty"), "{message}");
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn refuses_text_that_is_not_utf8() {
        let folder = scratch("text");
        let file = folder.join("project.toml");
        fs::write(&file, b"name = \"\xb3\xaa\xc1\xd6\"").unwrap();
        let message = read_text(&file).unwrap_err().to_string();
        assert!(message.contains("is not UTF-8 text (byte 8)"), "{message}");
        fs::remove_dir_all(folder).unwrap();
    }
}
