//! Notes, faults of channels and the history of a record, in words.

use super::words::listed;
use dolmen::modal::{Kurtosis, Note};
use dolmen::signal::{ChannelFault, LostSpan, Processing};
use dolmen_words::Language;
use dolmen_words::advice::Advice as _;
use dolmen_words::number;
use maud::{Markup, html};

pub(super) fn note_words(note: &Note, language: Language) -> String {
    let hertz = |value: &f64| format!("{value:.3}\u{202f}Hz");
    let korean = match note {
        Note::BlockRowsBounded { wished, taken } => format!(
            "행렬 크기를 제한하기 위해 블록 행을 {wished}개 대신 {taken}개로 하였다. 서로 가까운 모드의 구별이 어려워진다."
        ),
        Note::PeaksWithoutMode { frequency_hz } => {
            let all: Vec<String> = frequency_hz.iter().map(hertz).collect();
            format!(
                "{}에 스펙트럼 봉우리가 있으나 이를 설명하는 안정한 모드가 없다. 기계 진동이거나 이 기록에서는 너무 약한 모드이다.",
                all.join(", ")
            )
        }
        Note::FewBlocks { time_blocks } => format!(
            "기록이 짧아 표준편차를 시간 블록 {time_blocks}개에서 산정하였으며, 표준편차 자체의 정확도는 ± {:.0}\u{202f}%이다.",
            100.0 / (2.0 * (*time_blocks as f64 - 1.0)).sqrt()
        ),
        Note::Tones { tones } => {
            let spell = |k: &Option<Kurtosis>| k.map_or(String::new(), |k| running_share(&k));
            let all: Vec<String> = tones
                .iter()
                .map(|tone| format!("{}{}", hertz(&tone.frequency_hz), spell(&tone.kurtosis)))
                .collect();
            format!(
                "{}에 구조물로 보기에는 폭이 너무 좁거나 세기가 너무 일정한 스펙트럼 선이 있다. 기계 진동이다.",
                all.join(", ")
            )
        }
        Note::Harmonics { steady, removed } => {
            let all: Vec<String> = steady
                .iter()
                .map(|k| {
                    format!(
                        "{}(첨도 {:.2}){}",
                        hertz(&k.frequency_hz),
                        k.kurtosis,
                        running_share(k)
                    )
                })
                .collect();
            let what = if *removed {
                "모드에서 제외하였다"
            } else {
                "모드로 신뢰할 수 없다"
            };
            format!(
                "{}의 운동은 불규칙 외력에 의한 것으로 보기에는 세기가 너무 일정하다(불규칙 3, 정현파 1.5). 기계 진동이며 {what}.",
                all.join(", ")
            )
        }
        Note::NoDamping { frequency_hz } => {
            let all: Vec<String> = frequency_hz.iter().map(hertz).collect();
            format!(
                "{} 봉우리의 감쇠비는 제시하지 않는다. 다른 모드가 봉우리의 옆을 자르거나, 감쇠가 너무 빠르거나, 감쇠하는 진동수가 봉우리와 다르다. 가까운 모드는 부분공간법으로 구별한다.",
                all.join(", ")
            )
        }
        Note::ClosePairs { pairs } => {
            let all: Vec<String> = pairs
                .iter()
                .map(|[a, b]| format!("{}–{}", hertz(a), hertz(b)))
                .collect();
            format!(
                "{}의 모드는 대역폭보다 가까이 있다. 각 모드형상보다 두 형상이 이루는 평면이 더 정확하다.",
                all.join(", ")
            )
        }
        Note::NotPicked { frequency_hz } => {
            let all: Vec<String> = frequency_hz.iter().map(hertz).collect();
            format!("찾았으나 직접 선택하지 않은 모드: {}.", all.join(", "))
        }
        Note::OneQuantity { quantity } => {
            let one = match *quantity {
                "acceleration" => "가속도",
                "velocity" => "속도",
                _ => "변위",
            };
            format!("채널마다 계측한 물리량이 다르므로 모드형상은 각 모드의 진동수에서 {one}로 환산하였다.")
        }
        Note::StandsStill { channel, share } => format!(
            "채널 \"{channel}\"은(는) 모든 모드에서 최대 성분의 {:.1}\u{202f}% 미만으로 움직인다. 단단한 지반 위에 있거나 연결되지 않았다.",
            (100.0 * share).max(0.1)
        ),
        Note::PhaseOff {
            channel,
            degrees_at_hz,
        } => {
            let all: Vec<String> = degrees_at_hz
                .iter()
                .map(|[degrees, frequency_hz]| format!("{} {degrees:.0}°", hertz(frequency_hz)))
                .collect();
            format!(
                "채널 \"{channel}\"의 위상이 0° 또는 180°에서 벗어난다({}). 시계나 필터가 다른 채널과 다르며 어느 모드에서도 부호를 알 수 없다. 또는 모드가 서로 가깝다.",
                all.join(", ")
            )
        }
        Note::Channel(fault) => format!("{} 그대로 사용하였다.", fault_words(fault, language)),
        Note::FewCycles {
            frequency_hz,
            damping_floor,
        } => format!(
            "{} 모드는 관측 주기 수가 적어 감쇠비를 ± {:.0}\u{202f}%보다 정확히 알 수 없다.",
            hertz(frequency_hz),
            100.0 * damping_floor
        ),
        Note::FilteredAbove { asked_hz, passed_hz } => format!(
            "모드는 frequency_high_hz = {}가 아니라 {}까지 탐색하였다. 그 위는 표본율을 낮출 때 쓴 필터가 자르므로, 더 높은 모드를 보려면 decimate_factor를 줄여야 한다.",
            hertz(asked_hz),
            hertz(passed_hz)
        ),
        Note::ClockDrift {
            drifting,
            turn_degrees,
            frequency_hz,
            sampling_rate_hz,
        } => {
            let all: Vec<String> = drifting
                .iter()
                .map(|(channel, [ppm, sd])| {
                    let rate_hz = sampling_rate_hz * (1.0 + 1e-6 * ppm);
                    format!("\"{channel}\" {ppm:+.1} ± {sd:.1} ppm(sampling_rate = \"{rate_hz:.5} Hz\")")
                })
                .collect();
            format!(
                "기록계의 시계가 서로 다르게 간다: {}(± 표준편차). {}에서 기록 중 위상이 {turn_degrees:.0}° 돌아간다. 진동수와 감쇠비는 유효하나 이 채널은 모드형상에서 제외하였다. 해당 측점에 괄호 안의 표본율을 주면 포함된다.",
                all.join(", "),
                hertz(frequency_hz)
            )
        }
        Note::LateClocks { late } => {
            let all: Vec<String> = late
                .iter()
                .map(|clock| {
                    let or = clock
                        .or_s
                        .map_or(String::new(), |or_s| format!(", {or_s:+.4}\u{202f}s로도 설명됨"));
                    format!(
                        "\"{}\" {:+.4} ± {:.4}\u{202f}s(모드 {}개{or})",
                        clock.channel, clock.delay_s, clock.sd_s, clock.modes
                    )
                })
                .collect();
            format!(
                "기록계의 시계가 일정하게 늦다(−는 빠름): {}(± 표준편차). 위상이 지연처럼 진동수에 비례하여 커진다. 진동수와 감쇠비는 유효하나 이 채널은 모드형상에서 제외하였다. 해당 측점(stations)의 begins에 이 지연을 더하면 포함된다. 한 파일의 다른 채널과 함께 있으면 별도의 측점으로 나눈다.",
                all.join("; ")
            )
        }
        Note::FromPeaks { frequency_hz } => {
            let all: Vec<String> = frequency_hz.iter().map(hertz).collect();
            format!(
                "{} 모드는 안정 극점에는 나타나지 않으나, 스펙트럼 봉우리의 푸리에 선에 모드를 적합하여 얻었고 잘 맞는다. 모드형상의 표준편차는 없다.",
                all.join(", ")
            )
        }
        Note::NotFitted { frequency_hz } => {
            let all: Vec<String> = frequency_hz.iter().map(hertz).collect();
            format!(
                "{} 모드는 ssi-cov의 값 그대로이다. 주변 스펙트럼이 고른 힘을 받는 이 모드들만의 것과 다르거나(다른 모드, 기계, 진폭에 따라 변하는 강성), 푸리에 선이 너무 적다.",
                all.join(", ")
            )
        }
        Note::HiddenPairs { frequency_hz } => {
            let all: Vec<String> = frequency_hz.iter().map(hertz).collect();
            format!(
                "{}에서 스펙트럼의 특이값 두 개가 함께 솟지만 모드는 하나만 찾았다. 가까운 두 모드일 수 있으며, 그렇다면 진동수, 감쇠비, 모드형상은 둘이 섞인 것이다. ssi-cov와 ssi-data가 가까운 모드를 구별한다.",
                all.join(", ")
            )
        }
        Note::Blends { blends } => {
            let all: Vec<String> = blends
                .iter()
                .map(|[hz, zeta]| format!("{}(감쇠비 {:.1}\u{202f}%)", hertz(hz), 100.0 * zeta))
                .collect();
            format!(
                "{}: 낮은 차수에서만 나타나고 감쇠비가 다른 모드보다 훨씬 크므로 제외하였다. 이 기록으로는 구별되지 않는 여러 모드가 합쳐진 것이다.",
                all.join(", ")
            )
        }
    };
    language.pick(sentence(&note.advised()), korean)
}

/// Which part of the record a machine runs in, where it is not all of it.
fn running_share(kurtosis: &Kurtosis) -> String {
    let percent = 100.0 * kurtosis.share;
    match kurtosis.share < 1.0 {
        true => format!("(기록의 {percent:.0}\u{202f}%에서 가동)"),
        false => String::new(),
    }
}

pub(super) fn fault_words(fault: &ChannelFault, language: Language) -> String {
    let korean = match fault {
        ChannelFault::Constant { channel, value } => format!(
            "채널 \"{channel}\": 신호 없음. 모든 표본이 {value}이다. 제외하고 케이블을 점검해야 한다."
        ),
        ChannelFault::Faint {
            channel,
            deviation,
            typical,
        } => format!(
            "채널 \"{channel}\": 신호가 없거나 단위가 다르다. 표준편차가 {deviation:.3e}이나 같은 종류 채널의 중앙값은 {typical:.3e}이다. 제외하거나 단위를 바로잡아야 한다."
        ),
        ChannelFault::Stuck {
            channel,
            value,
            from_s,
            to_s,
        } => format!(
            "채널 \"{channel}\": {from_s:.2}초부터 {to_s:.2}초까지 값이 {value}에 멈춰 있다. 케이블 이탈이나 기록 중단이므로 그 구간을 잘라 내거나 채널을 제외해야 한다."
        ),
        ChannelFault::Faded {
            channel,
            factor,
            from_s,
            to_s,
        } => format!(
            "채널 \"{channel}\": 다른 채널에 대한 세기가 기록 중 {factor:.0}배 변한다({from_s:.0}~{to_s:.0}초에 최소). 접촉 불량이므로 그 구간을 잘라 내거나 채널을 제외해야 한다."
        ),
        ChannelFault::Alike {
            channel,
            other,
            correlation,
        } => format!(
            "채널 \"{channel}\"과(와) \"{other}\"의 신호가 거의 같다(증분의 상관계수 {correlation:.6}). 한 케이블이 두 입력에 연결되었거나 두 센서가 같은 위치에 있다."
        ),
        ChannelFault::Drifts { channel, rise } => format!(
            "채널 \"{channel}\": 기록 전체에 걸친 표류가 운동의 {rise:.0}배이다. 먼저 직선 추세를 제거해야 하며(detrend_degree = 1), 그렇지 않으면 낮은 모드와 감쇠비가 틀리게 된다."
        ),
        ChannelFault::Spikes {
            channel,
            count,
            first_s,
        } => format!(
            "채널 \"{channel}\": 주변보다 25배 이상 튀는 단일 표본이 {count}개 있다(첫 위치 {first_s:.2}초). 잡음이 되어 감쇠비가 틀리게 되므로 케이블을 점검해야 한다."
        ),
        ChannelFault::Clipped {
            channel,
            value,
            samples,
            first_s,
        } => format!(
            "채널 \"{channel}\": 측정 범위 초과(클리핑). 표본 {samples}개가 정확히 {value}에 머물며 처음은 {first_s}\u{202f}s이다. 범위 안의 구간만 쓰거나 채널을 제외해야 한다."
        ),
        ChannelFault::Duplicated {
            channel,
            other,
            factor,
        } => format!(
            "채널 \"{channel}\"과(와) \"{other}\"의 신호가 같다(배율 {factor:.6}). 한 케이블이 두 입력에 연결되었거나 같은 열이 중복되었으므로 하나를 제외해야 한다."
        ),
    };
    language.pick(sentence(&fault.advised()), korean)
}

/// With a capital at the start and a full stop.
pub(super) fn sentence(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters
        .next()
        .map(|c| c.to_uppercase().to_string())
        .unwrap_or_default();
    format!("{first}{}.", letters.as_str().trim_end_matches('.'))
}

pub(super) fn history(steps: &[Processing], language: Language) -> Markup {
    if steps.is_empty() {
        return html! {};
    }
    html! {
        p { (language.pick("What was done to the record, in this order:", "기록의 처리 이력(순서대로):")) }
        ol { @for step in steps { li { (step_words(step, language)) } } }
    }
}

fn step_words(step: &Processing, language: Language) -> String {
    let n = |value: f64| number::trimmed(value, 6);
    match step {
        Processing::Read { format, unit } if unit.is_empty() => language.pick(
            format!("read as {format}; the unit is unknown"),
            format!("{format} 형식으로 읽음; 단위 미상"),
        ),
        Processing::Read { format, unit } => language.pick(
            format!("read as {format} in {unit}"),
            format!("{format} 형식으로 읽음, 단위 {unit}"),
        ),
        Processing::LeftOut { channels } => {
            let channels = listed(channels, language);
            language.pick(
                format!("left out: {channels}"),
                format!("제외한 채널: {channels}"),
            )
        }
        Processing::Cut { from_s, to_s } => language.pick(
            format!("cut to {} to {}\u{202f}s", n(*from_s), n(*to_s)),
            format!("{}–{}\u{202f}s 구간만 사용", n(*from_s), n(*to_s)),
        ),
        Processing::Detrend { degree } => language.pick(
            format!("trend removed, polynomial of degree {degree}"),
            format!("추세 제거, {degree}차 다항식"),
        ),
        Processing::LowPass { corner_hz, order } => language.pick(
            format!(
                "low-pass at {}\u{202f}Hz, order {order}, zero phase",
                n(*corner_hz)
            ),
            format!("저역통과 {}\u{202f}Hz, {order}차, 영위상", n(*corner_hz)),
        ),
        Processing::BandPass {
            low_hz,
            high_hz,
            order,
        } => language.pick(
            format!(
                "band-pass {} to {}\u{202f}Hz, order {order}, zero phase",
                n(*low_hz),
                n(*high_hz)
            ),
            format!(
                "대역통과 {}–{}\u{202f}Hz, {order}차, 영위상",
                n(*low_hz),
                n(*high_hz)
            ),
        ),
        Processing::Decimate { factor } => language.pick(
            format!("decimated by {factor} after an anti-alias filter"),
            format!("앨리어싱 방지 필터 후 1/{factor}로 재표본화"),
        ),
        Processing::Scaled { factor } => language.pick(
            format!("multiplied by {}", n(*factor)),
            format!("{}배", n(*factor)),
        ),
        Processing::ChannelScaled { channel, factor } => language.pick(
            format!("{channel} multiplied by {}", n(*factor)),
            format!("채널 {channel}: {}배", n(*factor)),
        ),
        Processing::Interpolated {
            channel,
            offset_steps,
        } => language.pick(
            format!(
                "{channel} interpolated onto the times of the others, {} of a step beside its own",
                n(*offset_steps)
            ),
            format!(
                "채널 {channel}: 표본 간격의 {}만큼 어긋난 시각을 보간으로 맞춤",
                n(*offset_steps)
            ),
        ),
        Processing::Resampled {
            channel,
            from_hz,
            to_hz,
        } => language.pick(
            format!(
                "{channel} resampled from {} to {}\u{202f}Hz after an anti-alias filter",
                n(*from_hz),
                n(*to_hz)
            ),
            format!(
                "채널 {channel}: 앨리어싱 방지 필터 후 {}\u{202f}Hz에서 {}\u{202f}Hz로 재표본화",
                n(*from_hz),
                n(*to_hz)
            ),
        ),
        Processing::OffsetsLeft { most_steps } => language.pick(
            format!("times of the channels differ by up to {} of a step, left so", n(*most_steps)),
            format!("채널 간 시각 차이 최대 표본 간격의 {}, 그대로 둠", n(*most_steps)),
        ),
        Processing::LongestSpan {
            from_s,
            to_s,
            whole_s,
            gaps,
        } => {
            let each = gaps.iter().take(LostSpan::NAMED_MOST).map(|gap| {
                let channel = gap.channel.as_ref().map_or(String::new(), |name| format!("{name}, "));
                let (at, lost) = (n(gap.at_s), n(gap.lost_s));
                language.pick(
                    format!("{lost}\u{202f}s ({channel}after {at}\u{202f}s)"),
                    format!("{lost}\u{202f}s({channel}{at}\u{202f}s 이후)"),
                )
            });
            let each: Vec<String> = each.collect();
            let more = gaps.len().saturating_sub(LostSpan::NAMED_MOST);
            let (from, to, whole, kept) = (n(*from_s), n(*to_s), n(*whole_s), n(to_s - from_s));
            let others = match more {
                0 => String::new(),
                more => language.pick(format!(" and {more} more"), format!(" 외 {more}곳")),
            };
            language.pick(
                format!(
                    "samples are lost, {}{others}: only the longest whole span is used, {from} to {to}\u{202f}s, {kept} of {whole}\u{202f}s",
                    each.join(", ")
                ),
                format!(
                    "표본 누락 {}{others}: 누락이 없는 가장 긴 구간 {from}–{to}\u{202f}s만 사용({whole}\u{202f}s 중 {kept}\u{202f}s)",
                    each.join(", ")
                ),
            )
        }
        Processing::CommonTime { before_s, after_s } => language.pick(
            format!(
                "cut to the time that all channels share: {}\u{202f}s before and {}\u{202f}s after it are gone",
                n(*before_s),
                n(*after_s)
            ),
            format!(
                "모든 채널에 공통인 시간만 사용: 앞 {}\u{202f}s, 뒤 {}\u{202f}s 제외",
                n(*before_s),
                n(*after_s)
            ),
        ),
        // a record comes through none of these; no sentence yet
        Processing::HighPass { .. }
        | Processing::Matched { .. }
        | Processing::Tapered { .. }
        | Processing::Rotated { .. } => format!("{step:?}"),
    }
}
