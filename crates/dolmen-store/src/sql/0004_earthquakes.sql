-- The earthquake that the records of a survey hold, as an analysis of them found it.
create table if not exists earthquake (
    analysis text primary key references analysis,
    peak_m_s2 real,
    changed real,
    changed_sd real
);

-- The earthquake that the file states for a survey.
create table if not exists stated_earthquake (
    survey text primary key references survey,
    peak_m_s2 real,
    changed real,
    changed_sd real
);
