//! Errors of a site or a motion.

use dolmen_words::message::Both;
use dolmen_words::{Quantity, messages};

messages! {
    /// Errors of a site or a motion.
    pub(crate) enum WrongSite in "project.error.site" {
        HasBothFilesAnd { path: String, first: String, second: String } => {
            en: "{path} has both {first} and {second}",
            ko: "{path}에 {first}와(과) {second}이(가) 모두 있다",
        },
        HasNeitherFilesNor(path: String) => {
            en: "{path} has neither files, nor file, nor built_in",
            ko: "{path}에 files도 file도 built_in도 없다",
        },
        WriteFilesXRecord => {
            en: "write files = {{ x = \"record.at2\" }}, file = \"station.csv\" with columns = {{ x = \"EW\", y = \"NS\", z = \"UD\" }}, or built_in = \"el-centro-1940-ns\"",
            ko: "files = {{ x = \"record.at2\" }}, file = \"station.csv\"와 columns = {{ x = \"EW\", y = \"NS\", z = \"UD\" }}, 또는 built_in = \"el-centro-1940-ns\"를 쓴다",
        },
        ColumnsAndAzimuth(path: String) => {
            en: "{path} stands beside x_azimuth_deg: both say which channel is x",
            ko: "{path}이(가) x_azimuth_deg와 함께 있다. 둘 다 어느 채널이 x인지를 정한다",
        },
        KeepColumnsOrAzimuth => {
            en: "keep columns to take channels as x, y and z as they are, or x_azimuth_deg to turn channels that say which way they point",
            ko: "채널을 그대로 x, y, z로 쓰려면 columns만, 방향이 적힌 채널을 돌려서 쓰려면 x_azimuth_deg만 남긴다",
        },
        ColumnsEmpty(path: String) => { en: "{path} names no column", ko: "{path}에 열이 없다" },
        WriteColumns => {
            en: "write the names or numbers of the columns, {{ x = \"EW\", y = \"NS\", z = \"UD\" }}; at least one",
            ko: "{{ x = \"EW\", y = \"NS\", z = \"UD\" }}와 같이 열의 이름이나 번호를 하나 이상 쓴다",
        },
        ColumnWithoutFile { path: String, component: String } => {
            en: "{path} names a column for {component}, but files has no {component}",
            ko: "{path}에 {component} 성분의 열이 있는데 files에는 {component} 성분이 없다",
        },
        WriteFileOfColumns => {
            en: "if all columns stand in one file, write file = \"station.csv\" in the place of files",
            ko: "모든 열이 한 파일에 있으면 files 대신 file = \"station.csv\"를 쓴다",
        },
        OfFilesOnly { path: String, name: String } => {
            en: "{path} says how files are read, but \"{name}\" is in none: Dolmen carries it",
            ko: "{path}은(는) 파일을 읽는 방법인데 \"{name}\"은(는) 파일이 아니라 Dolmen에 들어 있다",
        },
        LeaveOfFilesOut => {
            en: "leave it out, or give file or files in the place of built_in",
            ko: "삭제하거나, built_in 대신 file 또는 files를 쓴다",
        },
        FactorCannotBe { path: String, factor: String } => {
            en: "{path} = {factor} cannot be",
            ko: "{path} = {factor}은(는) 쓸 수 없는 값이다",
        },
        GroundUnlikely(given: Quantity) => {
            en: "site.ground_acceleration is {given} g, which no map of a code has",
            ko: "site.ground_acceleration이 {given} g이다. 기준의 지진구역 지도에 없는 값이다",
        },
        GroundOfMaps => { en: "maps have 0.02 to 0.5 g: is it in g?", ko: "지도의 값은 0.02~0.5 g이다. g 단위인가?" },
        ImportanceUnlikely(given: Quantity) => {
            en: "site.importance_factor = {given} is none of a code",
            ko: "site.importance_factor = {given}은(는) 기준에 없는 값이다",
        },
        ImportanceOfCode => { en: "EN 1998-1 has 0.8 to 1.4", ko: "EN 1998-1의 값은 0.8~1.4이다" },
        PlateauUnlikely(given: Quantity) => {
            en: "the spectrum of the site is largest at {given} g, which no code asks for",
            ko: "부지 스펙트럼의 최댓값이 {given} g이다. 이런 값을 요구하는 기준은 없다",
        },
        UnitOfSpectrum => {
            en: "design spectra have 0.1 to 3 g: is the unit g, m/s2 or gal?",
            ko: "설계 스펙트럼의 최댓값은 0.1~3 g이다. 단위가 g, m/s2, gal 중 무엇인가?",
        },
        PeriodsUnlikely { longest: Quantity, largest: Quantity } => {
            en: "the periods of the site's spectrum go up to {longest} s, and it is largest from {largest} s on: earthquakes have no such periods",
            ko: "부지 스펙트럼의 주기가 {longest} s까지이고 최댓값이 {largest} s에서 시작한다. 이런 주기의 지반운동은 없다",
        },
        PeriodsInSeconds => {
            en: "periods are in seconds, design spectra are largest at 0.05 to 1.5 s: are these ms?",
            ko: "주기의 단위는 초이며 설계 스펙트럼은 0.05~1.5 s에서 가장 크다. ms 단위의 값인가?",
        },
        SpectrumRises { longest: Quantity, last_g: Quantity, first_g: Quantity } => {
            en: "the spectrum of the site has {last_g} g at its longest period, {longest} s, more than {first_g} g at its shortest: spectra fall towards long periods",
            ko: "부지 스펙트럼이 가장 긴 주기 {longest} s에서 {last_g} g로, 가장 짧은 주기의 {first_g} g보다 크다. 스펙트럼은 주기가 길어지면 작아진다",
        },
        FrequenciesForPeriods => {
            en: "are these frequencies in Hz, in place of periods in seconds?",
            ko: "주기(초)가 아니라 진동수(Hz)를 쓴 것인가?",
        },
        NotInKorea { path: String, latitude: Quantity, longitude: Quantity } => {
            en: "{path}: latitude {latitude}°, longitude {longitude}° is not in Korea",
            ko: "{path}: 위도 {latitude}°, 경도 {longitude}°는 한국이 아니다",
        },
        PlaceOfKorea => {
            en: "Korea has latitudes of 33 to 43° and longitudes of 124 to 132°: are the two exchanged, or is a digit missing?",
            ko: "한국은 위도 33~43°, 경도 124~132°이다. 둘을 바꾸어 쓰거나 숫자 하나를 빠뜨린 것인가?",
        },
        NeedsXYOr => { en: "needs x, y or z", ko: "x, y 또는 z가 필요하다" },
        WriteXRecordAt2 => { en: "write {{ x = \"record.at2\" }}", ko: "{{ x = \"record.at2\" }}와 같이 쓴다" },
        IsNoUnitOf { path: String, unit: String } => {
            en: "{path} = \"{unit}\" is no unit of acceleration",
            ko: "{path} = \"{unit}\"은(는) 가속도의 단위가 아니다",
        },
        MustBeGGal => {
            en: "must be \"g\", \"gal\", \"m/s2\" or the like",
            ko: "\"g\", \"gal\", \"m/s2\" 등이어야 한다",
        },
        ScaleCannotBe { path: String, scale: String } => {
            en: "{path}.scale = {scale} cannot be",
            ko: "{path}.scale = {scale}은(는) 쓸 수 없는 값이다",
        },
        MustBeNumberOther => { en: "must be a number other than 0", ko: "0이 아닌 수이어야 한다" },
        StandsAlone(path: String) => { en: "{path} stands alone", ko: "{path}만 있다" },
        GiveAsWell(other: String) => { en: "give {other} as well", ko: "{other}도 입력한다" },
        SiteLacksCode => { en: "site lacks code", ko: "site에 code가 없다" },
        GiveCodeKdsKds => {
            en: "give code = \"KDS 17 10 00\", \"KDS 41 17 00\", \"EN 1998-1\" or \"table\"",
            ko: "code = \"KDS 17 10 00\", \"KDS 41 17 00\", \"EN 1998-1\" 또는 \"table\"을 입력한다",
        },
        HasNoMeaningWith { path: String, code: String } => {
            en: "{path} has no meaning with code = \"{code}\"",
            ko: "{path}은(는) code = \"{code}\"에서 쓰지 않는다",
        },
        PeaksButReturnPeriods { peaks: String, periods: String } => {
            en: "{peaks} peaks, but {periods} return periods",
            ko: "최대가속도는 {peaks}개인데 재현주기는 {periods}개이다",
        },
        GiveEachPeakIts => { en: "give each peak its return period", ko: "최대가속도마다 재현주기를 입력한다" },
        OnePeakAloneTells => { en: "one peak alone tells no slope", ko: "최대가속도 하나로는 재해도 곡선의 기울기를 알 수 없다" },
        GiveSecondOneOr => { en: "give a second one, or k", ko: "하나를 더 주거나 k를 입력한다" },
        KGoesWithOne => { en: "k goes with one peak alone", ko: "k는 최대가속도가 하나일 때만 쓴다" },
        TakeItOutTwo => {
            en: "take it out: two peaks and more have slopes of their own",
            ko: "삭제한다. 최대가속도가 둘 이상이면 기울기가 정해진다",
        },
        PeaksRiseAndSo => { en: "peaks rise, and so do their return periods", ko: "최대가속도와 재현주기는 함께 커져야 한다" },
        Demand { key: String, why: Both } => { en: "{key}: {why}", ko: "{key}: {why}" },
        SiteHasNoBut { key: String, code: String } => {
            en: "site has no \"{key}\", but code = \"{code}\" needs it",
            ko: "code = \"{code}\"에 필요한 \"{key}\"이(가) site에 없다",
        },
        SiteHasBothZone => {
            en: "site has both zone and zone_factor",
            ko: "site에 zone과 zone_factor가 모두 있다",
        },
        KeepOneOfThem => {
            en: "keep one of them: zone I is 0.11 g, zone II 0.07 g",
            ko: "둘 중 하나만 남긴다. 지진구역 I은 0.11 g, II는 0.07 g이다",
        },
        WriteZoneIG => {
            en: "write zone = \"I\" (0.11 g), zone = \"II\" (0.07 g), or zone_factor = \"0.11 g\"",
            ko: "zone = \"I\"(0.11 g), zone = \"II\"(0.07 g) 또는 zone_factor = \"0.11 g\"를 쓴다",
        },
        WriteSoilS1Rock => {
            en: "write soil = \"S1\" (rock) to \"S5\" (deep and soft)",
            ko: "soil = \"S1\"(암반)~\"S5\"(깊고 연약한 지반)를 쓴다",
        },
        WriteReturnPeriodYears => {
            en: "write return_period_years = 50, 100, 200, 500, 1000, 2400 or 4800",
            ko: "return_period_years = 50, 100, 200, 500, 1000, 2400 또는 4800을 쓴다",
        },
        WriteSpectrumTypeSurface => {
            en: "write spectrum_type = 1 (surface-wave magnitudes above 5.5 govern) or 2",
            ko: "spectrum_type = 1(표면파 규모 5.5를 넘는 지진이 지배) 또는 2를 쓴다",
        },
        WriteGroundRockTo => {
            en: "write ground = \"A\" (rock) to \"E\"",
            ko: "ground = \"A\"(암반)~\"E\"를 쓴다",
        },
        WriteGroundAccelerationG => {
            en: "write ground_acceleration = \"0.2 g\", a_gR on type A ground",
            ko: "ground_acceleration = \"0.2 g\"와 같이 A 지반의 a_gR을 쓴다",
        },
        WriteUnitGOr => {
            en: "write unit = \"g\" or unit = \"m/s2\", the unit of its accelerations",
            ko: "가속도의 단위를 unit = \"g\" 또는 unit = \"m/s2\"로 쓴다",
        },
        SiteAccelerationsHasNumbers { accelerations: String, periods: String } => {
            en: "site.accelerations has {accelerations} numbers, but site.periods_s {periods}",
            ko: "site.accelerations의 수는 {accelerations}개인데 site.periods_s는 {periods}개이다",
        },
        MustBeOnePeriod => { en: "must be one a period", ko: "주기마다 하나씩 있어야 한다" },
        SiteHasBothFile => { en: "site has both a file and lists", ko: "site에 파일과 목록이 모두 있다" },
        KeepFileOrPeriods => {
            en: "keep the file, or periods_s and accelerations",
            ko: "파일만 남기거나 periods_s와 accelerations만 남긴다",
        },
        WritePeriodsSAnd => {
            en: "write periods_s = [0, 0.1, …] and accelerations = [ … ], or file = \"spectrum.csv\"",
            ko: "periods_s = [0, 0.1, …]과 accelerations = [ … ] 또는 file = \"spectrum.csv\"를 쓴다",
        },
        WriteAccelerationsOnePeriod => {
            en: "write accelerations = [ … ], one a period, in unit",
            ko: "accelerations = [ … ]를 unit의 단위로 주기마다 하나씩 쓴다",
        },
        SiteUnitIsNo(unit: String) => {
            en: "site.unit = \"{unit}\" is no unit of acceleration",
            ko: "site.unit = \"{unit}\"은(는) 가속도의 단위가 아니다",
        },
        MustBeGM => { en: "must be \"g\", \"m/s2\" or \"gal\"", ko: "\"g\", \"m/s2\" 또는 \"gal\"이어야 한다" },
        SiteFile { file: String, why: Both } => {
            en: "site.file = \"{file}\": {why}",
            ko: "site.file = \"{file}\"을(를) 읽을 수 없다: {why}",
        },
        LineIsNotPeriod(i: String) => {
            en: "line {i} is not a period, s, and an acceleration",
            ko: "{i}행이 주기(s)와 가속도가 아니다",
        },
        Hazard(message: Both) => { en: "site.hazard: {message}", ko: "site.hazard(재해도): {message}" },
    }
}
