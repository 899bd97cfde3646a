//! Files that a project names: how their bytes come to the reader, which opens none itself.

use std::fmt;
use std::rc::Rc;

type Load = dyn Fn(&str) -> Result<Vec<u8>, String>;

/// What gives the bytes of a file by the name that the project file writes, relative to itself.
#[derive(Clone, Default)]
pub struct Files {
    load: Option<Rc<Load>>,
}

impl Files {
    /// No files: a project that names one is refused.
    pub fn none() -> Self {
        Files::default()
    }

    /// From a function of the name as written. Its error is a sentence that says what went wrong.
    pub fn from_loader(load: impl Fn(&str) -> Result<Vec<u8>, String> + 'static) -> Self {
        Files {
            load: Some(Rc::new(load)),
        }
    }

    /// The bytes of a file.
    pub(super) fn read(&self, name: &str) -> Result<Vec<u8>, String> {
        match &self.load {
            Some(load) => load(name),
            None => Err("no files are read here, only the text of the project".to_owned()),
        }
    }
}

impl fmt::Debug for Files {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.load.is_some() {
            "Files"
        } else {
            "Files(none)"
        })
    }
}
