//! Meaning of the codes in messages and reports: the long explanation of a short note.

use crate::document::{TextStyle, wrapped};
use crate::explain_korean::EXPLANATIONS_KOREAN;
pub use crate::explanation::Explanation;
use crate::explanation::explanations;
use dolmen_words::Language;

/// Every code, in alphabetical order.
pub const EXPLANATIONS: &[Explanation] = explanations! {
    "assumed-input" "A value is assumed, not measured" => "\
The project file marks this value `source = \"assumed\"`. Every result that uses it rests on the assumption, and the
report says which do. Give the value a `cov` (coefficient of variation) and run `dolmen check --samples 10000` (of a
stack, `--sensitivity`) to see how much the verdict depends on it, or measure it and change the source to \"test\" or \"measured\".",
    "axial-double-count" "The axial force of the upper storey is counted twice in the lower" => "\
Equation 7 of Park & Min (2010) adds P2 to P1 in storey 1. The printed P1 = 5919 kN is already cumulative
(P1 − P2 = 2842 kN is the weight of 290 t), so P2 enters storey 1 twice and k1 rises from 203.4 to 203.9 kN/mm. Say
which force you give: `axial = \"storey\"` (all that the storey carries) or `axial = \"level\"` (what rests on its top).",
    "block-rows" "How many block rows the subspace method uses" => "\
Subspace methods see lags up to twice the block rows. If they span less than half a period of the lowest mode
(br < fs / (2 f1)) that mode is lost or its damping is wrong by 100 % and more. Dolmen takes the lowest peak of the
spectrum for f1, chooses block rows from it, says what it chose, and refuses values that cannot work. Decimating the
record makes the same span cheaper. plscf reads the same 2 br - 1 lags: they set how fine its lines are.",
    "cap-left-out" "The cap stone is not in the model" => "\
A chain without its top part weighs less and is lower than the structure: every limit is too low, which is
unconservative. Add the cap as a link, or to the weight and centroid of the top link.",
    "channel-fault" "A channel is dead, clipped or a copy of another" => "\
A dead channel (constant, or noise far below the others) adds a false row to every shape. A clipped one makes
harmonics. A copied one makes the shapes look surer than they are. Mend the cable and repeat, or leave the channel out
with `leave_out = true` on it in the project file.",
    "columns-apart" "The columns of a level do not move as one" => "\
One stiffness for a storey takes it that all its columns move together. Sensors side by side on one level, in one direction,
are compared in every mode, in amplitude and in phase, with the deviations of the shape and 2 % for the calibration of each
sensor. A floor that sways and turns is no fault. With at least three sensors on the level Dolmen names the column that moves as no
rigid floor does: its foot may be loose, its tenon open, or its sensor badly fixed. Exchange the sensor with that of
another column and measure again; then look at the column. With two sensors a turn of the floor looks the same.",
    "damage-states" "DS1 to DS4: how far a structure was damaged" => "\
Of a stack: DS1, a joint opens by 0.1 mm or slips by 0.5 mm. DS2, an offset of 0.5 % of the joint's width, or 10 mm, is left.
DS3, 2 % is left, a joint rocks to 0.35 of its slenderness angle, or a stone lies on the brink. DS4, falls: a stone came down. Of a
frame: DS1, a storey slips or a tenon crushes; falls, a storey leaned by more than 10 %. Of a chain: DS1, a joint opens or turns against its
friction; falls, a link leaned by 60°. Of a building: the first, second and third limit of its storey drift. DS3 and worse is
red, with exit status 1.",
    "damping-floor" "The least scatter any method can reach" => "\
With N_c = f T observed cycles, a long ambient record gives a frequency no better than sd(f)/f = √(ζ/2πN_c) and a
damping ratio no better than sd(ζ)/ζ = 1/√(2πζN_c) (Au 2014). Ten minutes of a 2 Hz mode with 1 % damping: ± 0.12 %
and ± 12 %. Only a longer record lowers it.",
    "demand" "What an earthquake asks for, and the words above, near, below demand" => "\
The site's spectrum is compared with the acceleration at which a stack begins to move, in two ways. As rigid blocks: against the
peak acceleration of the ground, soil included. On elastic joints, which amplify: the forces of all modes under the spectrum, on the
springs that the file gives or Dolmen assumes, on what is above each joint, against what weight and friction bear there. Beside it
stands the published way, S_a(T1, ζ) on all stones alike: not on the safe side, since the upper ones feel more. Capacities are those left while the whole vertical acceleration of
the site acts downwards on the ground, which is on the safe side. Words: above demand (at least 1.25 times), near demand (1 to
1.25 times), below demand (less); the threshold 1.25 is Dolmen's choice. Below demand means that something tips or slides. A stack
that does so mostly comes to rest again: whether it falls needs a time history (`dolmen simulate`). What of a code's numbers has
not been held against its text is listed; have it checked before a decision rests on it.",
    "earthquake" "A record that holds an earthquake" => "\
All channels (of four or more, a quarter may miss it) rise to eleven times their noise, by 3.5 within two seconds or to a
hundred times, for 1.5 s at least, and to 0.02 m/s² or 1 mm/s: no spike or footfall does that, and a free decay is at its largest when it begins and has
all its power in a few lines. A train or heavy lorry close by and a gust of more than ten times the wind before can look like one: look at the sensor on
the ground, and at the time. Before and after it modes are found as in any ambient record; in
it they are those above the channels marked as inputs, or the lowest mode is followed along its shape. A frequency that is lower in
the earthquake says nothing of damage: stone and timber soften with the strength of motion. One that stays lower does: minutes lie
between both, too few for the weather. The modes of the survey are those after it, else those before it. A blast, a crowd that
jumps or several blows in a row can be taken for an earthquake: earthquake = \"none\" in records.modal says that it is none.",
    "first-motion" "The acceleration at which a stack begins to move" => "\
The least horizontal acceleration of the ground, steady and in any direction, at which what stands on some joint tips over an
edge (rocks) or exceeds the friction of the joint (slides). Below it a stack of rigid stones moves with the ground. It is not
the acceleration of collapse: a stack that begins to rock mostly comes to rest again, the larger the stones the more so. A
vertical acceleration a_z of the ground scales it by 1 + a_z/g.",
    "free-decay" "Modes of a free decay, and what follows its amplitude" => "\
After a blow or a release a structure swings by itself. The eigensystem realization algorithm finds its modes, and a least
squares fit to all samples makes their deviations those of the Cramér-Rao bound for white noise. The record must begin when the
last force has ended. Joints that open or slip make a structure softer in large swings: the logarithmic decrement gives
frequency and damping by the size of the swings, and linear modes then explain less of the motion. Compare sizes with those of
ambient vibration, some thousand times smaller, before stiffness from the one is used for the other.",
    "gravity-margin" "How far the weight of a stack is from the edge of its joints" => "\
Without any shaking: of the way from the middle of a joint to its edge, the share that is left where the plumb line of all
that stands on it crosses it; or of its friction, where that is less. 1 is centred, 0 falls. Verdicts: stable (at least 1/3),
marginal (less), unstable (0 or less). The threshold 1/3 is Dolmen's choice: there a rectangular joint carries on half of its
width, and the other half gapes.",
    "harmonics" "Machines that look like modes" => "\
A motor or the mains makes a line in the spectrum that a subspace method takes for a mode of very low damping. Noise that
drives a mode makes its strength come and go (kurtosis 3 in a narrow band); a machine runs steadily (1.5). A peak that is
narrower than any structure's, or steadier than random forces make one by three deviations, in the whole record or in the
blocks of time in which it is strong (the answer gives their share of the record), is a machine and decides nothing. A
mode that is too steady stays, unless `harmonics = \"remove\"`. At least 36 independent strengths are needed to
tell: 96 minutes at 1 Hz, 14 minutes at 7 Hz. Random forces change the strength and the phase of a motion alike; what
changes in one more than in the other by five deviations is a machine whose speed or strength wanders. Switch the machine off and measure again if it stands on a mode.",
    "indistinguishable" "Several stiffnesses explain the measured frequencies equally well" => "\
Frequencies alone do not determine where a structure is stiff: two storeys have two answers, five joints at least
sixteen. All that were found are listed. They differ in their mode shapes: one measured shape (two sensors at
different heights, recorded together) usually chooses. Dolmen does not choose without one.",
    "joint-values" "What is known of friction, restitution and stiffness of stone joints" => "\
Friction, measured: flat faces of Hwangdeung granite (Korea) 29.4°, that is 0.563, single series within 2° of it; of Berea
sandstone 34.1°, 0.677, within 3° (Jang and others 2018). The default 0.6 lies above that granite: where sliding governs,
try 0.56 too. Classes of typical values, dry faces (stonewalls.ch): shale, slate, marl 0.36 to 0.51; sandstone, gneiss 0.51
to 0.67; granite, basalt, limestone 0.67 to 0.84. Hewn faces interlock and have more; wet, earthy or crumbling ones less.

Restitution, measured: a rocking block kept 0.97 (three times as high as wide) and 0.95 (five times) of the angular velocity
that a rigid block keeps, on concrete, and 0.67 on rubber (ElGawady and others): real blocks come to rest sooner.

Stiffness: K_n 1.0e9 and K_s 4.0e8 Pa/m are what Kim, Koo and Hong (2018) chose for a model. No measured stiffness or damping of a
stone joint could be read: try several, or find it from frequencies (`dolmen identify`). All rows with their conditions, and
what was sought and not read: data/joint_values.",
    "joints-unknown" "The stiffness is not known, so there is no verdict" => "\
Weights and lengths give the least stiffness that each joint needs, not the stiffness it has. Measure vibration and run
`dolmen identify`, or write assumed values with `source = \"assumed\"` and a `cov`.",
    "joints-unseen" "Joints that the measured modes do not see" => "\
A mode moves mostly on a few joints: its strain energy there is how much its frequency changes with their stiffness, and a
joint without energy may be as stiff or as soft as it likes. With m frequencies at most m combinations of factors are
fixed, however many joints there are. What is left: one factor for all joints; for each joint the least factor, which holds
whatever the others are; and a range that assumes every factor to lie within ten times the common one. Measure shapes at
many heights, or higher modes: points above and below a joint show how much it gives.",
    "limit-analysis" "Several stones move together" => "\
Where several stones carry one (posts and walls under a slab, an arch), equilibrium alone does not say how much each of them
bears, and the joints one by one give an upper bound. A conic programme then looks for any forces in the joints (pressure, friction
within its cone) that balance the stack; the least acceleration, of all directions, at which there are none is its limit. Where
friction decides it may be known to 2 % only: a note then gives both ends.",
    "load-factor" "The load factor λ, and the words of the verdict" => "\
λ is the smallest factor on gravity at which the stiffness matrix becomes singular: the structure falls when λ ≤ 1.
1/λ is the common factor on all stiffnesses at which it just stands. Verdicts: stable (λ ≥ 1.5), marginal (1 < λ < 1.5),
unstable (λ ≤ 1), unknown. The threshold 1.5 is Dolmen's choice, not a code's: a stiffness from frequencies is uncertain
by twice their error, and stone joints lose stiffness as they open. λ says nothing about overturning: a linear joint does
not open. The uplift limit (moment ≤ N b / 2) is a separate line.",
    "lost-samples" "The record has gaps" => "\
Time stamps, or blocks of a recorder, leave a gap of a sample or more. Samples put together across it would turn every mode's
phase there, so the longest span that is whole in all channels is used and the rest is cut; the warning says what is lost and how
long the rest is. Cut the record elsewhere with `conditioning.cut`, read the recorder again, or refuse such records with
`lost_samples = \"refuse\"`. Uneven steps below one and a half are no gap: they are refused.",
    "margin" "The margin of one joint" => "\
k_i / k_i,min, where k_i,min = k_i − 1/(b_iᵀ K⁻¹ b_i) is the least stiffness of joint i at which the structure stands,
with all other joints as they are. It is not k_i / E_i: the recursion's E_i tests stability and measures nothing (at
1.03 P·H on the Naju flagpole it would say 1.035 to 2.138 where the margins are 1.012 to 1.035).",
    "mode-missing" "A peak below the modes used is none of them" => "\
Stiffness is found from the lowest modes of a direction. A peak of the spectrum that lies below one of them and was not
found as a mode, or was not picked, may be the first mode: the stiffness would then be several times too large, and the
structure look safer than it is. Look at the peak (sensors in the direction, a longer record), pick it, or show that it
belongs to the other direction or to a machine.",
    "no-real-root" "No stiffness gives these frequencies" => "\
For two storeys with masses m1 (lower) and m2 (upper), real stiffnesses exist only if r + 1/r ≥ 2 √(1 + m2/m1), with
r = ω2/ω1. If the measured ratio is smaller, one of the frequencies is not a translation of this direction (a twisting
mode, a machine), a mass is wrong, or the structure is not two rigid storeys.",
    "no-wind" "The file of a pole or a frame says nothing of wind" => "\
The verdict is on weight alone. On a slender pole a gust can ask for more than its beds bear: the Naju flagpole stands with
a load factor of 2.9 and is on the edge of its lowest beds in a gust of 30 m/s. Give the wind, `wind = { speed = \"30 m/s\",
means = \"gust\", force_coefficient = 2.0 }`, or say that it stands out of it: `wind = \"sheltered\"`. A gate is pushed by its roof, which
no load factor sees: give its `areas`, too.",
    "probability" "What a probability from samples means" => "\
Inputs with a `cov` are drawn from lognormal distributions with that mean and cov, independently, N times; the count of
falls gives the probability, with its Clopper–Pearson interval. It is the probability given this model and these covs:
it knows nothing of decay, of vandals, of a wrong drawing. The same seed gives the same bits.",
    "sensor-slip" "What the sensors say against each other" => "\
Two sensors at one place in one direction must move alike; sensors on one rigid floor must move as it does. Where changing the
sign of one, or exchanging two, explains the lowest modes much better, that is probably what happened: correct direction,
position or column. A channel that moves by less than 0.3 % of the largest in every mode stands on the ground, is not connected,
or is in another unit: give its channel a scale (980.665 takes g to gal).",
    "setups" "Several setups of one survey, put together" => "\
Few sensors are moved from place to place while some stay. Each setup is identified by itself; its modes are paired with those
of the others by frequency and by their shapes at the sensors that stayed, scaled there by least squares and laid side by
side. Frequencies and damping ratios are means by inverse variance. A χ² test tells whether the setups agree: weather, the
strength of the motion and moved mass make them differ, and the deviation of the mean is then widened. A mode that not every
setup shows is left out, with a note. The assurance (MAC) of the shapes at the sensors that stayed must be near 1; a sensor that
stayed near a node scales badly.",
    "survey-change" "What changed from one survey to another, and what that proves" => "\
Modes of two surveys are paired by frequency and shape, all at once. The difference of each frequency is held against its
standard deviation (Student's t with Welch's degrees of freedom); since many modes are many chances to be wrong, the
probabilities are corrected for all of them together (Holm). No change shown is no proof that nothing changed: the least
change that would have been seen with 80 % probability stands beside it. A frequency follows temperature (0.1 % per °C is
common, frost and drying do more): where temperatures differ and [change] gives no coefficient, a change may be the
weather's. A coefficient comes from the surveys of several seasons (`temperature = \"fitted\"`, four before the later one)
or from a like structure. A frequency also falls with the strength of the motion, with moisture and with added mass.
Stiffness changes by twice the change of frequency only if it changed alike everywhere; damage in one joint moves some
modes and not others.",
    "swallowed-key" "A key stands below a [table] that it does not belong to" => "\
In TOML every key below `[survey.2010-05-12]` belongs to that table, up to the next [header], however it is indented.
Move keys of the top level (units, links, joints, storeys…) above the first [header].",
    "underdetermined" "Fewer measured modes than unknown stiffnesses" => "\
With m frequencies and n > m stiffnesses, n − m directions stay free: a continuous family explains the data. The
solutions shown are members of it, not an answer. The table of what the sensors see says which stiffness is determined
by how much. Measure shapes, or more modes. With as many data as stiffnesses one of them may still be seen so little that
it can only be said to lie above some value (a storey whose ends move alike) or within wide bounds: where a standard
deviation exceeds half of a stiffness, the bounds stand in place of the value.",
    "unit-slip" "A value looks a factor of a thousand off" => "\
The value is possible as a number but not as this structure: another unit was probably meant. Write the unit with the
value (\"1150 mm\", \"38.95 kN\"), or change `units`. If it is right as it stands, list its path under `allow`.",
    "unsafe-criterion" "The published critical stiffness is unsafe" => "\
Choi (2021, eqs 38–42) sets each diagonal term of the stiffness matrix to zero: k_cr,n = G_n, k_cr,i = G_i − k_cr,i+1.
A symmetric matrix with zeros on its diagonal and anything off it is indefinite, so a pole with those stiffnesses falls:
the Naju flagpole needs 4.7356 times as much at every joint. The exact test is that the whole matrix is positive
definite. Dolmen prints the published values because reports quote them, and the right ones beside them.",
};

/// The explanation of `code`, if there is one.
pub fn explain(code: &str) -> Option<&'static Explanation> {
    let code = match code.to_ascii_uppercase().as_str() {
        "DS0" | "DS1" | "DS2" | "DS3" | "DS4" => "damage-states",
        _ => code,
    };
    EXPLANATIONS.iter().find(|e| e.code == code)
}

/// The explanation of a code in a language.
pub fn explanation_in(code: &'static str, language: Language) -> Option<&'static Explanation> {
    match language {
        Language::English => explain(code),
        Language::Korean => EXPLANATIONS_KOREAN.iter().find(|e| e.code == code),
    }
}

/// The explanation of a code for a terminal, wrapped to its width.
pub fn explained_text(of: &Explanation, style: TextStyle) -> String {
    let mut out = wrapped(&format!("{}: {}", of.code, of.title), "", "  ", style.columns());
    for paragraph in of.text.split("\n\n") {
        out += "\n";
        out += &wrapped(&paragraph.replace('\n', " "), "", "", style.columns());
    }
    out
}

/// The known code most similar to `code`, as a suggestion.
pub fn nearest_code(code: &str) -> Option<&'static str> {
    const LIKENESS_LEAST: f64 = 0.6; // Jaro–Winkler; below it a suggestion is not helpful
    EXPLANATIONS
        .iter()
        .map(|e| (strsim::jaro_winkler(code, e.code), e.code))
        .filter(|(likeness, _)| *likeness >= LIKENESS_LEAST)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, code)| code)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_codes_are_sorted_and_found() {
        assert!(EXPLANATIONS.is_sorted_by(|a, b| a.code < b.code));
        assert_eq!(explain("margin").map(|e| e.code), Some("margin"));
        assert_eq!(explain("marginn"), None);
        assert_eq!(explain("DS2").map(|e| e.code), Some("damage-states"));
        assert_eq!(nearest_code("unsafe_criterion"), Some("unsafe-criterion"));
        assert_eq!(nearest_code("zzz"), None);
    }

    #[test]
    fn holds_joint_values_are_those_of_the_data() {
        let table = include_str!("../../../data/joint_values/joint_values.csv");
        let text = explain("joint-values").map_or("", |e| e.text);
        let docs = include_str!("../../../docs/stack.md");
        let mut rows = csv::Reader::from_reader(table.as_bytes());
        for row in rows.records().map(Result::unwrap) {
            let (quantity, value, low, high) = (&row[0], &row[2], &row[3], &row[4]);
            let printed = if value.is_empty() {
                vec![low, high]
            } else {
                vec![value]
            };
            assert!(printed.iter().all(|of| text.contains(of)), "{row:?}");
            assert!(printed.iter().all(|of| docs.contains(of)), "{row:?}");
            if quantity == "friction_angle" {
                let angle: f64 = value.parse().unwrap();
                let coefficient = format!("{:.3}", angle.to_radians().tan());
                assert!(
                    text.contains(&coefficient) && docs.contains(&coefficient),
                    "{coefficient}"
                );
            }
        }
    }

    #[test]
    fn holds_every_code_is_explained_in_korean_with_the_same_numbers() {
        let codes = |all: &[Explanation]| all.iter().map(|e| e.code).collect::<Vec<_>>();
        assert_eq!(codes(EXPLANATIONS), codes(EXPLANATIONS_KOREAN));
        // numbers with decimals, which no translation changes
        let numbers = |text: &str| {
            let words = text.split(|c: char| !c.is_ascii_digit() && c != '.');
            let mut all: Vec<String> = words
                .map(|word| word.trim_matches('.').to_owned())
                .filter(|word| word.contains('.'))
                .collect();
            all.sort();
            all
        };
        for (english, korean) in EXPLANATIONS.iter().zip(EXPLANATIONS_KOREAN) {
            assert_eq!(numbers(english.text), numbers(korean.text), "{}", english.code);
            assert!(
                korean.text.chars().any(|c| ('가'..='힣').contains(&c)),
                "{}",
                korean.code
            );
        }
    }
}
