//! Every published number and every exact law that this crate must reproduce; one file for one source.
