// What a set can hold is what a file keeps: over random sets, and over files after accidents.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "model/dissimilarity/dissimilarity.h"
#include "model/io/set/measured_files.h"
#include "model/io/set/set_file.h"
#include "model/io/set/spec_file.h"
#include "tests/support/mutations.h"
#include "tests/support/temporary_folder.h"

namespace every_set_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

struct Dice {
    std::mt19937 random;

    std::size_t below(std::size_t count) { return any_below(random, count); }
    bool one_in(std::size_t count) { return below(count) == 0; }
    double share() { return static_cast<double>(random()) / 4294967295.0; }
    // Ends and what lies in between; of long digits.
    double within(Range range) {
        if (one_in(6)) return range.low;
        if (one_in(6)) return range.high;
        return std::clamp(std::lerp(range.low, range.high, share()), range.low, range.high);
    }
    int whole(Range range) { return static_cast<int>(std::floor(within(range))); }
    std::string text(std::size_t most) {
        static const std::vector<std::string> kPieces{
            "a",      "Z",      "7",      " ",          "\"",     "\\",      "/",
            ":",      ".",      "%41",    "-",          "\u00e9", "e\u0301", "\u0416",
            "\u6f22", "\u200b", "\u00a0", "\U0001f600", "\u2028", "\ufeff",  "\uffff"};
        std::string text;
        for (std::size_t k = below(most + 1); k > 0; --k) text += kPieces[below(kPieces.size())];
        return text;
    }
};

// Names that are long enough to be cut in the middle of a character wherever the cut is.
std::string name(Dice& dice, std::size_t k) {
    static const std::vector<std::string> kLetters{"\u00e9", "\u6f22", "\u0416", "\U0001f600", "x"};
    std::string name(dice.below(4), 'x');
    const std::size_t letters = dice.one_in(2) ? 60 : 0;
    const std::string& letter = kLetters[dice.below(kLetters.size())];
    for (std::size_t n = 0; n < letters; ++n) name += letter;
    return name + dice.text(12) + std::to_string(k);
}

Values values(Dice& dice, Range range) {
    if (dice.one_in(3)) {
        const double low = std::max(range.low, 0.01);
        Span span{low, std::max(low, dice.within(range)), 2 + dice.whole({0, 900}), dice.one_in(2)};
        if (dice.one_in(2)) span.multiple_of = 0.5;
        return span;
    }
    std::vector<double> levels;
    for (std::size_t k = 0; k <= dice.below(4); ++k) levels.push_back(dice.within(range));
    return levels;
}

DesignSpace design_space(Dice& dice) {
    DesignSpace space;
    space.amplitude_g = values(dice, limits::kAmplitudeG);
    space.carriers.resize(1 + dice.below(2));
    for (CarrierValues& carrier : space.carriers) {
        carrier.frequency_hz = values(dice, limits::kCarrierHz);
        carrier.weight = values(dice, limits::kCarrierWeight);
    }
    if (space.carriers.size() == 2 && dice.one_in(2)) space.mix = values(dice, limits::kMix);
    if (dice.one_in(2)) space.kinds = {ModulationKind::am, ModulationKind::product};
    space.modulation_hz = values(dice, limits::kModulationHz);
    space.depth = values(dice, limits::kDepth);
    if (dice.one_in(2)) space.rhythms = {"", "x=-"};
    space.duration_s = values(dice, limits::kDurationS);
    space.design = static_cast<Design>(dice.below(3));
    space.samples = dice.whole(limits::kSamples);
    space.seed = dice.whole(limits::kSeed);
    if (dice.one_in(2)) space.constraints.band_hz = Range{40.0, dice.within({40.0, 5000.0})};
    if (dice.one_in(2)) space.constraints.displacement_um = dice.within(limits::kDisplacementUm);
    if (dice.one_in(2)) space.constraints.detectable_db = dice.within(limits::kDetectableDb);
    return space;
}

void draw(Dice& dice, Pattern& pattern) {
    const Range times{0.0, pattern.duration_s};
    std::vector<double> times_s;
    for (std::size_t k = dice.below(8); k > 0; --k) times_s.push_back(dice.within(times));
    std::ranges::sort(times_s);
    for (const double time_s : times_s) {
        pattern.amplitude_curve.push_back({time_s, dice.within(limits::kCurveValue)});
        pattern.frequency_curve.push_back({time_s, dice.within(limits::kCarrierHz)});
        pattern.transients.push_back(
            {dice.within(times), dice.within(limits::kAmplitudeG), dice.within(limits::kCarrierHz),
             dice.within(limits::kTransientS), static_cast<TransientShape>(dice.below(2))});
    }
    pattern = clamped(std::move(pattern));  // of several points at one time two stay
}

Pattern pattern(Dice& dice) {
    Pattern pattern;
    pattern.amplitude_g = dice.within(limits::kAmplitudeG);
    pattern.carriers.resize(1 + dice.below(limits::kMaxCarriers));
    for (Carrier& carrier : pattern.carriers) {
        carrier = {dice.within(limits::kCarrierHz), dice.within(limits::kCarrierWeight),
                   dice.one_in(2) ? 0.0 : dice.within(limits::kPhaseRad)};
    }
    pattern.modulation = {static_cast<ModulationKind>(dice.below(2)),
                          dice.within(limits::kModulationHz), dice.within(limits::kDepth)};
    if (dice.one_in(2)) pattern.rhythm = {"x=--x-", dice.within(limits::kRhythmUnitS)};
    pattern.attack_s = dice.one_in(2) ? 0.0 : 5e-324;
    pattern.release_s = dice.within(limits::kRampS);
    pattern.duration_s = dice.within(limits::kDurationS);
    if (dice.one_in(2)) draw(dice, pattern);
    return pattern;
}

// As import makes them: numbers that a WAV file of 32 bits keeps.
Measurement twin(Dice& dice, const std::string& of) {
    Waveform waveform;
    for (std::size_t n = 0; n <= dice.below(50); ++n) {
        waveform.samples_g.push_back(static_cast<float>(dice.within({-3.0, 3.0})));
    }
    return {std::make_shared<const Waveform>(std::move(waveform)), "", 1.0, of, dice.one_in(2)};
}

Ratings ratings(Dice& dice, const std::vector<std::string>& labels) {
    constexpr double kHard[] = {0.0,     -0.0, 5e-324, -2.2e-308, 1.7976931348623157e308,
                                1.0 / 3, 1e15, -1.0,   100.0};
    Ratings one{dice.text(10), labels, {}, {}, dice.text(5)};
    for (std::size_t k = 0; k < pair_count(labels.size()); ++k) {
        one.condensed.push_back(dice.one_in(4) ? kUnrated : kHard[dice.below(std::size(kHard))]);
    }
    return one;
}

ToldApart told_apart(Dice& dice, const std::string& a, const std::string& b) {
    ToldApart told{dice.text(6),   dice.text(6), dice.text(6), dice.random(),
                   dice.one_in(2), {},           {},           {}};
    told.patterns = {a, b};
    told.versions = {dice.text(4), "0123456789abcdef"};
    for (std::size_t k = dice.below(41); k > 0; --k) {
        const auto place = [&dice] { return static_cast<int>(dice.below(3)); };
        told.answers.push_back({{a, b, dice.within(limits::kAskedPm), place(), dice.one_in(2)},
                                place(),
                                dice.share()});
    }
    if (dice.one_in(2)) told.unknown_json = R"({"mood":"good"})";
    return told;
}

StudyDesign study(Dice& dice, const std::vector<std::string>& names) {
    StudyDesign design;
    if (!names.empty() && dice.one_in(2)) design.patterns = {names.front()};
    design.repetitions = dice.whole(limits::kRepetitions);
    design.attention_pairs = dice.whole(limits::kAttentionPairs);
    design.seed = dice.whole(limits::kStudySeed);
    design.order = static_cast<StudyOrder>(dice.below(2));
    design.gap_s = dice.within(limits::kPauseS);
    design.rest_s = dice.within(limits::kPauseS);
    design.break_every = dice.whole(limits::kBreakEvery);
    design.masking = dice.share();
    design.headphones = dice.text(5);
    design.attention = {dice.within(limits::kSimilarity), dice.whole(limits::kAttentionPairs)};
    design.instructions = dice.text(20);
    design.consent = dice.text(20);
    for (std::size_t k = dice.below(4); k > 0; --k) {
        design.groups.push_back(dice.whole(limits::kGroups));
    }
    return design;
}

PatternSet random_set(Dice& dice, bool with_recordings) {
    constexpr const char* kUnknown = R"({"future":[1,null,{"deep":-0.0,"of":"\\u00e9"}]})";
    PatternSet set;
    set.name = dice.text(20);
    set.duration_s = dice.within(limits::kDurationS);
    for (std::size_t k = dice.below(6); k > 0; --k) {
        Vibration vibration;
        vibration.name = name(dice, k);
        vibration.source = pattern(dice);
        if (with_recordings && dice.one_in(2)) {
            vibration.source = twin(dice, set.vibrations.empty() ? "" : set.vibrations[0].name);
        }
        vibration.locked = dice.one_in(3);
        vibration.dropped = !vibration.locked && dice.one_in(3);
        vibration.generated = dice.one_in(3);
        if (dice.one_in(2)) vibration.colour = "#0072B2";
        vibration.ring = dice.one_in(3);
        vibration.note = dice.text(10);
        if (dice.one_in(3)) vibration.effect = {dice.text(3), "a" + dice.text(6)};
        if (dice.one_in(2)) vibration.unknown_json = kUnknown;
        set.vibrations.push_back(std::move(vibration));
    }
    for (std::size_t k = dice.below(4); k > 0; --k) {
        set.ratings.push_back(ratings(dice, names_of(set)));
    }
    for (std::size_t k = dice.below(3); k > 0 && set.vibrations.size() > 1; --k) {
        set.told_apart.push_back(told_apart(dice, set.vibrations[0].name, set.vibrations[1].name));
    }
    if (dice.one_in(2)) set.model.nc_weight = dice.share();
    if (dice.one_in(2)) set.model_origin = {dice.text(20), dice.one_in(2), dice.one_in(2)};
    if (dice.one_in(2)) set.study = study(dice, names_of(set));
    if (dice.one_in(2)) set.generator = design_space(dice);
    if (dice.one_in(2)) set.unknown_json = kUnknown;
    return set;
}

}  // namespace

TEST_CASE("every set: whatever the program can hold is saved, and opens as what it was" *
          doctest::test_suite("long")) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        Dice dice{std::mt19937(seed)};
        const TemporaryFolder folder;
        const fs::path file = folder.path / "s.tactspace.json";
        PatternSet set = random_set(dice, true);
        const auto stored = store_measurements(set, file);
        REQUIRE_MESSAGE(stored, (stored ? "" : stored.error().message));
        const auto written = write_set_file(file, set);
        REQUIRE_MESSAGE(written, (written ? "" : written.error().message));
        const auto again = read_set_file(file);
        REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
        CHECK(again->set == set);
        CHECK(print_set(again->set) == print_set(set));  // and -0 stays -0
    }
}

TEST_CASE("every set: all passes of many people are saved") {
    const TemporaryFolder folder;
    PatternSet set;
    for (int k = 0; k < 251 * 4; ++k) {
        set.ratings.push_back({"P" + std::to_string(k / 4), {"a", "b"}, {1.0 * k}, {}});
    }
    const fs::path file = folder.path / "s.tactspace.json";
    const auto written = write_set_file(file, set);
    REQUIRE_MESSAGE(written, (written ? "" : written.error().message));
    CHECK(read_set_file(file)->set == set);
}

TEST_CASE("every set: a file after an accident is refused, or its set can be saved again") {
    std::size_t accepted = 0;
    for (unsigned seed = 0; seed < 400; ++seed) {
        CAPTURE(seed);
        Dice dice{std::mt19937(seed)};
        const std::string text = after_mishaps(print_set(random_set(dice, false)), dice.random);
        const auto set = parse_set(text, "s.json", {});
        if (!set) {
            CHECK(contains(set.error().message, "s.json"));
            CHECK_FALSE(contains(set.error().message, "\n"));
            continue;
        }
        ++accepted;
        const auto again = parse_set(print_set(*set), "again.json", {});
        REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
        CHECK(*again == *set);
    }
    CHECK(accepted > 20);  // else nothing was looked at
}

TEST_CASE("every set: a generator's file after an accident is refused, or kept as it was read") {
    const TemporaryFolder folder;
    std::size_t accepted = 0;
    for (unsigned seed = 0; seed < 600; ++seed) {
        CAPTURE(seed);
        Dice dice{std::mt19937(seed)};
        const std::string whole = R"({"design": "sobol", "samples": 120, "seed": 1,
            "amplitude_g": [0.5, 1, 2], "carriers": [{"frequency_hz": {"from": 60, "to": 300,
            "steps": 5, "spacing": "log", "multiple_of": 1}, "weight": 1}],
            "modulation": {"kinds": ["product", "am"], "frequency_hz": [0, 4, 16], "depth": 1},
            "rhythm": {"texts": ["", "x=--"], "unit_s": 0.125}, "attack_s": 0,
            "constraints": {"band_hz": [40, 400], "displacement_um": 100, "detectable_db": 6}})";
        const fs::path file = folder.write("g.json", after_mishaps(whole, dice.random));
        const auto loaded = read_spec_file(file);
        if (!loaded) {
            CHECK(contains(loaded.error().message, "g.json"));
            continue;
        }
        ++accepted;
        const auto again = parse_set(print_set(loaded->set), "again.json", {});
        REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
        CHECK(*again == loaded->set);
    }
    CHECK(accepted > 20);
}

TEST_CASE(
    "every set: a generator with very many unknown keys of long names is read, and says few") {
    const TemporaryFolder folder;
    const std::string key(100'000, 'k');
    std::string text = R"({"design": "factorial", ")" + key + R"(": [)";
    for (int k = 0; k < 100'000; ++k) text += k == 0 ? "0" : ",0";
    const auto loaded = read_spec_file(folder.write("g.json", text + "]}"));
    REQUIRE_MESSAGE(loaded, (loaded ? "" : loaded.error().message));
    CHECK(loaded->remarks.size() < 30);
    for (const std::string& remark : loaded->remarks) CHECK(remark.size() < 1000);
}

}  // namespace every_set_test
