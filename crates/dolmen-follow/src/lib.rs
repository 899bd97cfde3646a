//! Folders and a store of surveys together: projects into the store and out of it, every structure watched, and record files that
//! come into a folder, which become surveys of a structure, judged as they come.
//!
//! ```text
//! Follow (folder, store, structure) ─ follow ─→ Inbox ─ Reader ─→ Store ─ watch ─→ Listener, --on-alarm, metrics
//! ```
//!
//! A [`Listener`], a terminal or a service, hears what comes of each file, and says when to stop.

mod call;
mod clock;
mod following;
mod listener;
mod options;
mod read;
mod state;
mod stored;
mod wrong;

pub use call::{Call, call_for_alarming};
pub use clock::now_us;
pub use following::follow;
pub use listener::{FollowedRecord, Listener, Quarantined};
pub use options::Follow;
pub use stored::{add_project, export_project, take_over, watch_all};
pub use wrong::{ERRORS, FollowError, of_following};
