-- Records that came by themselves after the project was stored.

-- Each is a survey: it has the settings of a survey of the project, and its record in the place of that one's. `text` is its table as a
-- project file writes it, `units` the units of the project that it was read with.
create table arrival (
    survey text primary key references survey,
    structure text not null references structure,
    name text not null,
    path text not null,
    raw text not null references raw,
    came_as text not null,
    text text not null,
    units text not null,
    at_us integer not null,
    who text not null,
    unique (structure, name),
    unique (structure, raw)
);

-- What looked wrong with channels of a record.
create table channel_fault (
    survey text not null references survey,
    channel text not null,
    fault text not null,
    primary key (survey, channel, fault)
);

create index project_of_survey on project_survey (survey, project);
