-- What inspections found: one row an entry of a survey.
create table if not exists inspection_item (
    survey text not null references survey,
    position integer not null,
    part text not null,
    what text not null,
    what_korean text,
    name text,
    size_m real,
    size_sd_m real,
    limit_m real,
    severity text,
    x_m real,
    y_m real,
    z_m real,
    photo text,
    note text,
    primary key (survey, position)
);

-- Surveys that nobody measured.
create table if not exists made_up (
    survey text primary key references survey
);
insert into made_up (survey) select hash from survey where source like 'made up, not measured%' on conflict do nothing;
