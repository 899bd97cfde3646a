//! Any bytes are a photograph of a size that can be shown, or an error.

use dolmen_records::{PHOTO_PIXELS_MOST, read_photo};

pub(super) fn run(bytes: &[u8]) {
    if let Ok(photo) = read_photo(bytes.to_vec()) {
        let pixels = u64::from(photo.width) * u64::from(photo.height);
        assert!((1..=PHOTO_PIXELS_MOST).contains(&pixels) && photo.quarter_turns() < 4);
        assert!(photo.bytes == bytes);
    }
}
