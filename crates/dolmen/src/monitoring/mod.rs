//! The history of a structure over the years: tracking of modes through many surveys, the effect of weather, changes with their dates, and
//! alarms from new surveys.

mod alarm;
mod bends;
mod between;
mod changes;
mod critical;
mod daily;
mod error;
mod ewma;
mod gram;
mod growth;
mod history;
mod logged;
mod logged_faults;
mod lost;
mod made;
mod online;
mod outliers;
mod pooled;
mod regression;
mod scan;
mod sensors;
mod series;
mod t_squared;
mod table;
mod tilt;
mod tilt_marks;
mod tilt_outliers;
mod tilt_signs;
mod tracking;
mod unknown_temperatures;
mod watch;
mod watched_mode;
mod wave;
mod weather;
mod whitening;

pub use alarm::{AlarmKind, Judged, JudgedMode, ModeAlarm, NotJudged};
pub use critical::{NullSeries, null_statistics};
pub use daily::{DailyReadings, daily_medians};
pub use error::MonitoringError;
pub use ewma::{ewma_limit, ewma_run_length};
pub use growth::{GrowthOptions, GrowthSeries, growth};
pub use history::{History, HistorySurvey, TiltReading, Work};
pub use logged::{
    LoggedChange, LoggedLevel, LoggedOptions, LoggedSeries, LoggedTrend, NoSlope, logged_trend,
};
pub use logged_faults::LoggedJump;
pub use lost::LostMode;
pub use made::{MadeHistory, made_history};
pub use pooled::pooled;
pub use scan::ChangeForm;
pub use sensors::SensorChange;
pub use t_squared::SurveyTSquared;
pub use tilt::{SlopeLimit, TiltChange, TiltReach, TiltSeries, TiltSlope, TiltTrend, TiltWork};
pub use tilt_outliers::TiltOutlier;
pub use tracking::{Jumped, Track, Tracked, Tracking, track};
pub use watch::{ANSWERED_DAYS, StructureAlarm, WatchOptions, Watched, watch};
pub use watched_mode::{ChangeThere, LastOff, WatchedChange, WatchedMode, WeatherEffect, WorkEffect};
pub use weather::{Wave, WeatherKnown};
pub use whitening::Disturbance;
