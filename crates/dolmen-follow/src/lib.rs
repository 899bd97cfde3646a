//! Record files that come into a folder become surveys of a structure in a store, judged as they come.
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
mod wrong;

pub use call::Call;
pub use clock::now_us;
pub use following::follow;
pub use listener::{FollowedRecord, Listener, Quarantined};
pub use options::Follow;
pub use wrong::{ERRORS, FollowError, of_following};
