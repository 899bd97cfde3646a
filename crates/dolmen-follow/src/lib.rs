//! Connects folders and a store of surveys: moves projects into the store and out of it, watches every structure, and turns the record files that
//! arrive in a folder into surveys of a structure, judging each.
//!
//! ```text
//! Follow (folder, store, structure) ─ follow ─→ Inbox ─ Reader ─→ Store ─ watch ─→ Listener, --on-alarm, metrics
//! ```
//!
//! A [`Listener`], such as a terminal or a service, receives the result of each file, and decides when to stop.

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
