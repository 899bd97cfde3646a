//! Photographs and drawings: reads their headers, without decoding them.

use imagesize::{ImageType, blob_size, image_type};

/// Largest size of a photograph, bytes. Our choice: a JPEG of a camera with 60 megapixels has 30 MB.
pub const PHOTO_BYTES_MOST: u64 = 32 << 20;
/// Largest number of pixels. Our choice: decoded they take 640 MB; a camera of 2026 has 60 to 151 million.
pub const PHOTO_PIXELS_MOST: u64 = 160_000_000;

/// The formats that pages, documents and browsers all show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PhotoFormat {
    /// JPEG.
    Jpeg,
    /// PNG.
    Png,
}

impl PhotoFormat {
    /// "image/jpeg".
    pub fn media_type(self) -> &'static str {
        match self {
            PhotoFormat::Jpeg => "image/jpeg",
            PhotoFormat::Png => "image/png",
        }
    }

    /// "jpg".
    pub fn extension(self) -> &'static str {
        match self {
            PhotoFormat::Jpeg => "jpg",
            PhotoFormat::Png => "png",
        }
    }
}

/// An image with its header.
#[derive(Clone, PartialEq, Eq)]
pub struct Photo {
    /// Its format.
    pub format: PhotoFormat,
    /// Pixels across, before the rotation in the EXIF data.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// The bytes of the file.
    pub bytes: Vec<u8>,
}

impl Photo {
    /// Quarters of a turn, clockwise, in the EXIF data (tag Orientation), 0 to 3; pages and PDF apply them.
    ///
    /// # Limits
    /// Mirrored images are not corrected; no camera writes them.
    pub fn quarter_turns(&self) -> u8 {
        match (self.format, orientation(&self.bytes)) {
            (PhotoFormat::Jpeg, Some(3)) => 2,
            (PhotoFormat::Jpeg, Some(6)) => 1,
            (PhotoFormat::Jpeg, Some(8)) => 3,
            _ => 0,
        }
    }
}

/// The tag Orientation of the first EXIF segment of a JPEG.
///
/// Source: CIPA DC-008 (2012) Exif 2.3, 4.5.4 and 4.6.4.
fn orientation(bytes: &[u8]) -> Option<u16> {
    const ORIENTATION: u16 = 0x0112;
    const ENTRY: usize = 12;
    let mut at = 2;
    // segments before the samples: FF, marker, length with its own two bytes
    let exif = loop {
        let head: [u8; 4] = bytes.get(at..at + 4)?.try_into().ok()?;
        let length = usize::from(u16::from_be_bytes([head[2], head[3]]));
        if head[0] != 0xff || head[1] == 0xda || length < 2 {
            return None;
        }
        let segment = bytes.get(at + 4..at + 2 + length)?;
        match (head[1], segment.strip_prefix(b"Exif\0\0")) {
            (0xe1, Some(exif)) => break exif,
            _ => at += 2 + length,
        }
    };
    let is_little = exif.starts_with(b"II");
    let u16_at = |at: usize| {
        let two: [u8; 2] = exif.get(at..at.checked_add(2)?)?.try_into().ok()?;
        Some(match is_little {
            true => u16::from_le_bytes(two),
            false => u16::from_be_bytes(two),
        })
    };
    let u32_at = |at: usize| {
        let [first, second] = [u16_at(at)?, u16_at(at.checked_add(2)?)?].map(u32::from);
        Some(match is_little {
            true => second << 16 | first,
            false => first << 16 | second,
        })
    };
    let list = usize::try_from(u32_at(4)?).ok()?;
    let entries = usize::from(u16_at(list)?);
    let mut each = (0..entries).map(|i| list.saturating_add(2 + ENTRY * i));
    let own = each.find(|at| u16_at(*at) == Some(ORIENTATION))?;
    u16_at(own.saturating_add(8))
}

impl std::fmt::Debug for Photo {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Photo({:?}, {} × {})", self.format, self.width, self.height)
    }
}

/// A file that is not a usable photograph.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PhotoError {
    /// The file has another format, or is not an image.
    NotAnImage {
        /// The first bytes.
        start: String,
    },
    /// The header does not give the size.
    Damaged,
    /// The end of the file is missing.
    CutShort,
    /// No pixels.
    Empty {
        /// Pixels across.
        width: u64,
        /// Pixels down.
        height: u64,
    },
    /// Too many pixels.
    TooManyPixels {
        /// Pixels across.
        width: u64,
        /// Pixels down.
        height: u64,
    },
}

/// Reads the header of a JPEG or PNG.
///
/// # Errors
/// [`PhotoError`]: no such image, no end, no pixels, or more than [`PHOTO_PIXELS_MOST`].
///
/// # Limits
/// The data between header and end are not checked: damage there appears when the image is drawn.
pub fn read_photo(bytes: Vec<u8>) -> Result<Photo, PhotoError> {
    const NAMED: usize = 8;
    let format = match image_type(&bytes) {
        Ok(ImageType::Jpeg) => PhotoFormat::Jpeg,
        Ok(ImageType::Png) => PhotoFormat::Png,
        _ => {
            let start: Vec<String> = bytes
                .iter()
                .take(NAMED)
                .map(|byte| format!("{byte:02x}"))
                .collect();
            let start = match start.as_slice() {
                [] => "none, the file is empty".to_owned(),
                some => some.join(" "),
            };
            return Err(PhotoError::NotAnImage { start });
        }
    };
    let size = blob_size(&bytes).map_err(|_| PhotoError::Damaged)?;
    let [width, height] = [size.width, size.height].map(|pixels| pixels as u64);
    if width == 0 || height == 0 {
        return Err(PhotoError::Empty { width, height });
    }
    if width.saturating_mul(height) > PHOTO_PIXELS_MOST {
        return Err(PhotoError::TooManyPixels { width, height });
    }
    if !has_end(&bytes, format) {
        return Err(PhotoError::CutShort);
    }
    let side = |pixels: u64| u32::try_from(pixels).map_err(|_| PhotoError::Damaged);
    Ok(Photo {
        format,
        width: side(width)?,
        height: side(height)?,
        bytes,
    })
}

/// Whether the end marker is in the last bytes: cameras add data after it.
fn has_end(bytes: &[u8], format: PhotoFormat) -> bool {
    let mark: &[u8] = match format {
        PhotoFormat::Jpeg => &[0xff, 0xd9],
        PhotoFormat::Png => b"IEND",
    };
    memchr::memmem::rfind(bytes, mark).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The signature and IHDR of a PNG by RFC 2083, then its end.
    fn png(width: u32, height: u32) -> Vec<u8> {
        let mut bytes = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR".to_vec();
        bytes.extend(width.to_be_bytes());
        bytes.extend(height.to_be_bytes());
        bytes.extend([8, 2, 0, 0, 0, 0, 0, 0, 0]);
        bytes.extend(b"\0\0\0\0IEND\xaeB`\x82");
        bytes
    }

    /// A JPEG with the frame of a thumbnail within APP1 before its own frame, as from cameras (ITU-T T.81, B.2.2).
    fn jpeg(width: u16, height: u16) -> Vec<u8> {
        let frame = |width: u16, height: u16| {
            let mut segment = vec![0xff, 0xc0, 0, 11, 8];
            segment.extend(height.to_be_bytes());
            segment.extend(width.to_be_bytes());
            segment.extend([1, 1, 0x11, 0]);
            segment
        };
        let thumbnail = frame(160, 120);
        let mut bytes = vec![0xff, 0xd8, 0xff, 0xe1];
        bytes.extend((thumbnail.len() as u16 + 2).to_be_bytes());
        bytes.extend(thumbnail);
        bytes.extend(frame(width, height));
        bytes.extend([0xff, 0xd9]);
        bytes
    }

    #[test]
    fn exact_the_size_stands_in_the_head() {
        let read = read_photo(png(4000, 3000)).unwrap();
        assert_eq!(
            (read.format, read.width, read.height),
            (PhotoFormat::Png, 4000, 3000)
        );
        let read = read_photo(jpeg(6000, 4000)).unwrap();
        assert_eq!(
            (read.format, read.width, read.height),
            (PhotoFormat::Jpeg, 6000, 4000)
        );
    }

    #[test]
    fn exact_the_turn_that_the_camera_noted() {
        // a TIFF head, one list of two entries, the second of them the orientation: byte orders II and MM
        let with = |orientation: u16, is_little: bool| {
            let [two, four] = match is_little {
                true => [u16::to_le_bytes as fn(u16) -> [u8; 2], u16::to_le_bytes],
                false => [u16::to_be_bytes as fn(u16) -> [u8; 2], u16::to_be_bytes],
            };
            let long = |value: u16| match is_little {
                true => [four(value), [0, 0]].concat(),
                false => [vec![0, 0], four(value).to_vec()].concat(),
            };
            let entry = |tag: u16, value: u16| {
                [
                    two(tag).to_vec(),
                    two(3).to_vec(),
                    long(1),
                    two(value).to_vec(),
                    vec![0, 0],
                ]
                .concat()
            };
            let mut exif = b"Exif\0\0".to_vec();
            exif.extend(if is_little { b"II" } else { b"MM" });
            exif.extend([two(42).to_vec(), long(8), two(2).to_vec()].concat());
            exif.extend([entry(0x0103, 6), entry(0x0112, orientation), vec![0; 4]].concat());
            let plain = jpeg(6000, 4000);
            let mut bytes = vec![0xff, 0xd8, 0xff, 0xe1];
            bytes.extend((exif.len() as u16 + 2).to_be_bytes());
            bytes.extend(exif);
            bytes.extend(&plain[2..]);
            read_photo(bytes).unwrap().quarter_turns()
        };
        for is_little in [true, false] {
            let turns = [1, 3, 6, 8, 0, 77].map(|of| with(of, is_little));
            assert_eq!(turns, [0, 2, 1, 3, 0, 0], "little: {is_little}");
        }
        assert_eq!(read_photo(jpeg(6000, 4000)).unwrap().quarter_turns(), 0);
    }

    #[test]
    fn refuses_what_is_no_image_and_one_that_is_too_large() {
        let told = |bytes: Vec<u8>| read_photo(bytes).unwrap_err().to_string();
        assert!(told(b"%PDF-1.7 and more".to_vec()).contains("first bytes are 25 50 44 46 2d 31 2e 37"));
        assert!(told(Vec::new()).contains("the file is empty"));
        assert!(told(b"<svg xmlns='http://www.w3.org/2000/svg'/>".to_vec()).contains("no JPEG or PNG"));
        assert_eq!(
            read_photo(png(20_000, 10_000)),
            Err(PhotoError::TooManyPixels {
                width: 20_000,
                height: 10_000
            })
        );
        assert!(read_photo(png(20_000, 8000)).is_ok());
        assert_eq!(
            read_photo(png(0, 7)),
            Err(PhotoError::Empty { width: 0, height: 7 })
        );
        assert_eq!(read_photo(png(4, 4)[..30].to_vec()), Err(PhotoError::CutShort));
        assert_eq!(read_photo(jpeg(4, 4)[..12].to_vec()), Err(PhotoError::Damaged));
    }
}
