-- Modes that the user insists on though a test refused them.
alter table mode add column is_accepted integer not null default 0 check (is_accepted in (0, 1));
