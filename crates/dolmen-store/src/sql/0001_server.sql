-- What a server has of its own, before all else.

-- The number of the last schema file that was run.
create table schema_number (
    only_row integer primary key check (only_row = 1),
    number bigint not null
);

-- Files as they came, compressed, in pieces of at most 4 MiB, under the hash of their bytes.
create table raw_file (
    hash text collate "C" primary key check (length(hash) = 64),
    pieces bigint not null check (pieces >= 0)
);

create table raw_piece (
    hash text collate "C" not null references raw_file,
    position bigint not null check (position >= 1),
    bytes bytea not null,
    primary key (hash, position)
);
alter table raw_piece alter column bytes set storage external; -- compressed already

