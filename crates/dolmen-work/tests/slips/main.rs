//! What Dolmen notices: the slips of `data/slips.csv`, each made in a shipped example, and plausible structures that it must let pass.

mod caught;
mod edit;
mod folder;
mod plausible;
