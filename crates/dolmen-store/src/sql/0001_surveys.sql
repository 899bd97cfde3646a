-- Every row is named by what it says (BLAKE3) or by names of people, never by a running number: a row means the same in every
-- store, taking one over is an insert that passes over what is there, and nothing is ever updated or deleted.

-- This store itself.
create table store (
    only_row integer primary key check (only_row = 1),
    made_us integer not null
);

-- Files as they came, compressed in the folder beside the database under their hash.
create table raw (
    hash text primary key check (length(hash) = 64),
    bytes integer not null check (bytes >= 0),
    at_us integer not null
);

create table structure (
    name text primary key check (length(name) between 1 and 200),
    at_us integer not null,
    who text not null
);

-- A state of the project file with all the files that it names.
create table project (
    hash text primary key,
    structure text not null references structure,
    text_hash text not null references raw,
    kind text not null,
    english text not null,
    korean text not null,
    latitude_deg real check (latitude_deg between -90 and 90),
    longitude_deg real check (longitude_deg between -180 and 180),
    dolmen text not null
);
create index project_of_structure on project (structure);

create table project_file (
    project text not null references project,
    path text not null,
    hash text not null references raw,
    primary key (project, path)
);

-- Which state counts from when on: the latest. One that comes again is a further row.
create table adoption (
    structure text not null references structure,
    at_us integer not null,
    project text not null references project,
    who text not null,
    primary key (structure, at_us, project)
);

create table survey (
    hash text primary key,
    structure text not null references structure,
    name text not null,
    taken_on text,
    datum text,
    note text,
    source text
);
create index survey_of_structure on survey (structure, name);

create table project_survey (
    project text not null references project,
    position integer not null,
    survey text not null references survey,
    primary key (project, position)
);

-- Temperature, humidity, wind: what the air was like.
create table environment (
    survey text not null references survey,
    quantity text not null,
    value real not null,
    unit text not null,
    primary key (survey, quantity)
);

create table tilt (
    survey text not null references survey,
    direction text not null,
    ratio real not null,
    written text not null,
    datum text,
    primary key (survey, direction)
);

-- Modes that the file states.
create table stated_mode (
    survey text not null references survey,
    direction text not null,
    position integer not null,
    frequency_hz real not null,
    frequency_sd_hz real,
    damping_ratio real,
    damping_ratio_sd real,
    kind text not null,
    primary key (survey, direction, position)
);

create table stated_shape (
    survey text not null references survey,
    direction text not null,
    mode integer not null,
    position integer not null,
    height_m real not null,
    displacement real not null,
    displacement_sd real not null,
    primary key (survey, direction, mode, position)
);

-- Record files of a survey: one a setup, or several stations of one.
create table record (
    survey text not null references survey,
    setup integer not null,
    station integer not null,
    path text not null,
    hash text not null references raw,
    format text,
    sampling_rate_hz real,
    unit text,
    scale real,
    primary key (survey, setup, station)
);

create table channel (
    survey text not null references survey,
    setup integer not null,
    station integer not null,
    position integer not null,
    source_column text not null,
    name text,
    x_m real,
    y_m real,
    z_m real,
    direction_x real,
    direction_y real,
    direction_z real,
    scale real,
    is_left_out integer not null check (is_left_out in (0, 1)),
    primary key (survey, setup, station, position)
);

-- What the file says on how records are read and modes are sought, as JSON.
create table settings (
    hash text primary key,
    text text not null
);

-- Modes of the same records with the same settings by the same version of Dolmen are one analysis.
create table analysis (
    hash text primary key,
    records text not null,
    settings text not null references settings,
    version text not null,
    method text not null,
    duration_s real not null,
    at_us integer not null,
    who text not null,
    unique (records, settings, version)
);

create table survey_analysis (
    survey text not null references survey,
    analysis text not null references analysis,
    primary key (survey, analysis)
);

create table mode (
    analysis text not null references analysis,
    position integer not null,
    frequency_hz real not null,
    frequency_sd_hz real,
    damping_ratio real,
    damping_ratio_sd real,
    phase_collinearity real,
    primary key (analysis, position)
);

create table mode_point (
    analysis text not null references analysis,
    mode integer not null,
    position integer not null,
    channel text not null,
    real_part real not null,
    imaginary_part real not null,
    sd real,
    primary key (analysis, mode, position)
);

-- Taken out of use, or back into it: the latest row counts.
create table mark (
    structure text not null references structure,
    at_us integer not null,
    is_removed integer not null check (is_removed in (0, 1)),
    who text not null,
    why text not null,
    primary key (structure, at_us)
);

-- Who did what.
create table log (
    at_us integer not null,
    who text not null,
    verb text not null,
    subject text not null,
    detail text not null,
    primary key (at_us, who, verb, subject, detail)
);
