//! Turns errors of a server into faults for the user, by their codes. Their texts may be in any language.

use crate::error::StoreError;
use crate::incoming::shown;
use dolmen_work::kept::StoreFault;
use postgres::Error;
use postgres::error::{DbError, SqlState};
use std::error::Error as _;

/// Whether the error came from connecting or from later work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SessionStage {
    Connecting,
    Working,
}

/// The fault for the user; `server` is the address without its password.
pub(crate) fn server_fault(server: &str, fault: &Error, when: SessionStage) -> StoreError {
    let server = server.to_owned();
    let why = || {
        shown(
            &fault
                .source()
                .map_or_else(|| fault.to_string(), ToString::to_string),
        )
    };
    match (fault.as_db_error(), when) {
        (Some(said), _) => said_by_server(server, said),
        (None, SessionStage::Connecting) if is_password_missing(fault) => {
            StoreFault::ServerPassword { shown: server }
        }
        (None, SessionStage::Connecting) => StoreFault::ServerDown {
            shown: server,
            why: why(),
        },
        (None, SessionStage::Working) if is_lost(fault) => StoreFault::ServerGone { shown: server },
        (None, SessionStage::Working) => StoreFault::Failed { why: why() },
    }
    .into()
}

fn said_by_server(server: String, said: &DbError) -> StoreFault {
    let why = || shown(said.message());
    let code = said.code();
    match code {
        _ if [
            SqlState::INVALID_PASSWORD,
            SqlState::INVALID_AUTHORIZATION_SPECIFICATION,
        ]
        .contains(code) =>
        {
            StoreFault::ServerRefused { shown: server }
        }
        _ if *code == SqlState::INVALID_CATALOG_NAME => StoreFault::ServerDatabase { shown: server },
        _ if *code == SqlState::TOO_MANY_CONNECTIONS => StoreFault::ServerFull { shown: server },
        _ if [
            SqlState::INSUFFICIENT_PRIVILEGE,
            SqlState::READ_ONLY_SQL_TRANSACTION,
        ]
        .contains(code) =>
        {
            StoreFault::ServerRights { shown: server }
        }
        _ if [
            SqlState::LOCK_NOT_AVAILABLE,
            SqlState::T_R_SERIALIZATION_FAILURE,
            SqlState::T_R_DEADLOCK_DETECTED,
        ]
        .contains(code) =>
        {
            StoreFault::Locked
        }
        _ if *code == SqlState::DISK_FULL => StoreFault::DiskFull,
        _ if *code == SqlState::CANNOT_CONNECT_NOW => StoreFault::ServerDown {
            shown: server,
            why: why(),
        },
        _ if [SqlState::ADMIN_SHUTDOWN, SqlState::CRASH_SHUTDOWN].contains(code)
            || code.code().starts_with("08") =>
        {
            StoreFault::ServerGone { shown: server }
        }
        _ if [SqlState::DATA_CORRUPTED, SqlState::INDEX_CORRUPTED].contains(code) => {
            StoreFault::Damaged { why: why() }
        }
        _ => StoreFault::Failed { why: why() },
    }
}

fn is_lost(fault: &Error) -> bool {
    let is_of_the_wire = fault.source().is_some_and(|source| source.is::<std::io::Error>());
    fault.is_closed() || is_of_the_wire
}

fn is_password_missing(fault: &Error) -> bool {
    let source = fault.source().map(ToString::to_string);
    source.is_some_and(|why| why == "password missing")
}

/// Whether the server is running and will accept connections soon.
pub(crate) fn is_starting(fault: &Error) -> bool {
    fault.code() == Some(&SqlState::CANNOT_CONNECT_NOW)
}
