//! What Typst can read: the source, its files and the fonts, and nothing else on the machine.

use crate::sheets::Sheets;
use dolmen_picture::FONTS;
use typst::diag::{FileError, FileResult};
use typst::foundations::{Bytes, Datetime};
use typst::syntax::{FileId, Source, VirtualPath};
use typst::text::{Font, FontBook};
use typst::utils::LazyHash;
use typst::{Library, LibraryExt, World};

/// New Computer Modern Math Regular (GUST Font License): formulas need a font with a mathematical table.
const MATHEMATICS: &[u8] = include_bytes!("../../../data/fonts/NewCMMath-Regular.otf");

pub(crate) struct Desk {
    library: LazyHash<Library>,
    book: LazyHash<FontBook>,
    fonts: Vec<Font>,
    main: Source,
    files: Vec<(FileId, Bytes)>,
}

impl Desk {
    pub(crate) fn new(sheets: Sheets) -> Self {
        let fonts: Vec<Font> = FONTS
            .iter()
            .chain([&MATHEMATICS])
            .flat_map(|font| Font::iter(Bytes::new(*font)))
            .collect();
        let id = |name: &str| FileId::new(None, VirtualPath::new(name));
        let files = sheets.files.into_iter();
        Desk {
            library: LazyHash::new(Library::default()),
            book: LazyHash::new(FontBook::from_fonts(&fonts)),
            fonts,
            main: Source::new(id("main.typ"), sheets.main),
            files: files
                .map(|(name, bytes)| (id(&name), Bytes::new(bytes)))
                .collect(),
        }
    }

    /// Characters that no font has, in order; spaces and direction marks need no glyph.
    pub(crate) fn without_glyph(&self) -> Vec<char> {
        let texts = self.files.iter().filter(|(_, bytes)| bytes.starts_with(b"<"));
        let texts = texts.filter_map(|(_, bytes)| bytes.as_str().ok());
        let characters = texts.chain([self.main.text()]).flat_map(str::chars);
        let known = |character: &char| {
            self.fonts
                .first()
                .is_none_or(|font| font.info().coverage.contains(u32::from(*character)))
        };
        let mut missing: Vec<char> = characters
            .filter(|character| !character.is_whitespace() && !character.is_control() && !known(character))
            .collect();
        missing.sort_unstable();
        missing.dedup();
        missing
    }

    fn bytes(&self, id: FileId) -> FileResult<Bytes> {
        let found = self.files.iter().find(|(of, _)| *of == id);
        let missing = || FileError::NotFound(id.vpath().as_rootless_path().to_owned());
        found.map(|(_, bytes)| bytes.clone()).ok_or_else(missing)
    }
}

impl World for Desk {
    fn library(&self) -> &LazyHash<Library> {
        &self.library
    }

    fn book(&self) -> &LazyHash<FontBook> {
        &self.book
    }

    fn main(&self) -> FileId {
        self.main.id()
    }

    fn source(&self, id: FileId) -> FileResult<Source> {
        if id == self.main.id() {
            return Ok(self.main.clone());
        }
        let bytes = self.bytes(id)?;
        let text = bytes.as_str().map_err(|_| FileError::InvalidUtf8)?;
        Ok(Source::new(id, text.to_owned()))
    }

    fn file(&self, id: FileId) -> FileResult<Bytes> {
        self.bytes(id)
    }

    fn font(&self, index: usize) -> Option<Font> {
        self.fonts.get(index).cloned()
    }

    fn today(&self, _offset: Option<i64>) -> Option<Datetime> {
        None
    }
}
