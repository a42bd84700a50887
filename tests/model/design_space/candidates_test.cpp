#include "model/design_space/candidates.h"
#include "model/set/set_candidates.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <set>

#include "model/design_space/sobol.h"
#include "model/design_space/spectral_lines.h"
#include "model/pattern/same_vibration.h"

namespace candidates_test {

using namespace tact;

namespace {

Candidates made(const DesignSpace& space) {
    auto found = candidates(space, default_tables());
    REQUIRE_MESSAGE(found, (found ? "" : found.error().message));
    return *std::move(found);
}

Values levels(std::vector<double> values) { return values; }

// Amplitude, frequency, modulation and rhythm: 2 x 3 x 2 x 2.
DesignSpace four_factors() {
    DesignSpace space;
    space.amplitude_g = levels({0.5, 1.0});
    space.carriers[0].frequency_hz = Span{60.0, 240.0, 3, true, 0.0};
    space.modulation_hz = levels({0.0, 8.0});
    space.rhythms = {"", "x=--"};
    return space;
}

DesignSpace sample_of(Design design, int samples, int seed) {
    DesignSpace space;
    space.design = design;
    space.samples = samples;
    space.seed = seed;
    space.amplitude_g = Span{0.5, 2.0, 3, false, 0.0};
    space.carriers[0].frequency_hz = Span{50.0, 400.0, 3, true, 0.0};
    space.modulation_hz = Span{1.0, 50.0, 3, false, 0.0};
    return space;
}

// How far along its range an amplitude of sample_of() is.
double amplitude_share(const Candidate& candidate) {
    return (candidate.pattern.amplitude_g - 0.5) / 1.5;
}

std::vector<std::string> names_in(const Candidates& found) {
    std::vector<std::string> names;
    for (const Candidate& candidate : found.kept) names.push_back(candidate.name);
    return names;
}

}  // namespace

TEST_CASE("candidates: a full factorial has every combination once, the last parameter fastest") {
    const DesignSpace space = four_factors();
    CHECK(combination_count(space) == 24.0);
    const Candidates found = made(space);
    CHECK(found.combinations == 24);
    CHECK(found.doubles == 0);
    REQUIRE(found.kept.size() == 24);
    CHECK(found.kept[0].name == "0.5 g 60 Hz mod 0 Hz steady");
    CHECK(found.kept[1].name == "0.5 g 60 Hz mod 0 Hz x=--");
    CHECK(found.kept[23].name == "1 g 240 Hz mod 8 Hz x=--");
    std::set<double> frequencies;
    std::set<std::string> names;
    for (const Candidate& candidate : found.kept) {
        frequencies.insert(candidate.pattern.carriers[0].frequency_hz);
        names.insert(candidate.name);
    }
    CHECK(names.size() == 24);
    REQUIRE(frequencies.size() == 3);
    CHECK(*frequencies.begin() == 60.0);  // ends are exact
    CHECK(std::abs(*std::next(frequencies.begin()) - 120.0) < 1e-12);
    CHECK(*frequencies.rbegin() == 240.0);
}

TEST_CASE("candidates: counts are products of levels, whatever the parameters") {
    DesignSpace space;
    space.carriers = {{levels({60.0, 80.0}), fixed(1.0)},
                      {levels({150.0, 200.0, 250.0}), fixed(1)}};
    space.mix = levels({0.25, 0.5, 0.75});
    space.kinds = {ModulationKind::product, ModulationKind::am};
    space.modulation_hz = levels({4.0, 16.0});
    space.depth = fixed(0.5);
    space.unit_s = fixed(0.1);
    space.rhythms = {"x-", "x==-"};
    space.attack_s = levels({0.01, 0.02});
    space.release_s = levels({0.0, 0.01, 0.02});
    space.duration_s = levels({0.5, 1.0});
    const Candidates found = made(space);
    CHECK(found.kept.size() == 2 * 3 * 3 * 2 * 2 * 2 * 2 * 3 * 2);
    CHECK(found.kept[0].name ==
          "60+150 Hz mix 0.25 ring mod 4 Hz x- attack 10 ms release 0 ms 0.5 s");
}

TEST_CASE("candidates: combinations that make no difference are doubles, counted once") {
    DesignSpace space;
    space.modulation_hz = levels({0.0, 8.0});
    space.kinds = {ModulationKind::product, ModulationKind::am};
    space.depth = levels({0.5, 1.0});
    // Without modulation 1; product 1, as it has no depth; am 2.
    Candidates found = made(space);
    CHECK(found.combinations == 8);
    CHECK(found.kept.size() == 4);
    CHECK(found.doubles == 4);

    space = {};
    space.carriers = {{levels({70.0, 150.0}), fixed(1)}, {levels({70.0, 150.0}), fixed(1)}};
    space.mix = levels({0.3, 0.7});
    // 70+150 at two mixes, 70 alone, 150 alone.
    found = made(space);
    CHECK(found.combinations == 8);
    CHECK(found.kept.size() == 4);

    space = {};
    space.rhythms = {"x-", "x-x-", "", "x="};
    CHECK(made(space).kept.size() == 2);
}

TEST_CASE("candidates: Sobol's sequence, its ranges and levels") {
    const Candidates found = made(sample_of(Design::sobol, 64, 0));
    REQUIRE(found.kept.size() == 64);
    for (std::uint32_t k = 0; k < 64; ++k) {
        CHECK(std::abs(amplitude_share(found.kept[k]) - sobol_coordinate(k, 0)) < 1e-12);
        const double f_hz = found.kept[k].pattern.carriers[0].frequency_hz;
        CHECK(std::abs(std::log(f_hz / 50.0) / std::log(8.0) - sobol_coordinate(k, 1)) < 1e-12);
    }
    DesignSpace space = sample_of(Design::sobol, 64, 0);
    space.amplitude_g = levels({0.5, 1.0, 1.5, 2.0});
    std::map<double, int> uses;
    for (const Candidate& candidate : made(space).kept) ++uses[candidate.pattern.amplitude_g];
    CHECK(uses == std::map<double, int>{{0.5, 16}, {1.0, 16}, {1.5, 16}, {2.0, 16}});
}

TEST_CASE("candidates: a Latin hypercube uses every part of every range once") {
    constexpr std::size_t kSamples = 50;
    for (const int seed : {0, 1, 77}) {
        const Candidates found = made(sample_of(Design::latin_hypercube, kSamples, seed));
        REQUIRE(found.kept.size() == kSamples);
        std::set<int> amplitudes;
        std::set<int> frequencies;
        std::set<int> modulations;
        for (const Candidate& candidate : found.kept) {
            const Pattern& p = candidate.pattern;
            const double f_share = std::log(p.carriers[0].frequency_hz / 50.0) / std::log(8.0);
            const double m_share = (p.modulation.frequency_hz - 1.0) / 49.0;
            amplitudes.insert(static_cast<int>(amplitude_share(candidate) * kSamples));
            frequencies.insert(static_cast<int>(f_share * kSamples));
            modulations.insert(static_cast<int>(m_share * kSamples));
        }
        CHECK(amplitudes.size() == kSamples);
        CHECK(frequencies.size() == kSamples);
        CHECK(modulations.size() == kSamples);
    }
}

TEST_CASE("candidates: a seed makes the same sample again, another seed another one") {
    for (const Design design : {Design::latin_hypercube, Design::sobol}) {
        const auto names = [design](int seed) {
            return names_in(made(sample_of(design, 20, seed)));
        };
        CHECK(names(3) == names(3));
        CHECK(names(3) != names(4));
    }
}

TEST_CASE("candidates: values of a range are moved to multiples, and stay inside") {
    DesignSpace space = sample_of(Design::sobol, 200, 1);
    space.carriers[0].frequency_hz = Span{52.0, 399.0, 3, true, 5.0};
    for (const Candidate& candidate : made(space).kept) {
        const double f_hz = candidate.pattern.carriers[0].frequency_hz;
        const bool whole = std::abs(f_hz / 5.0 - std::round(f_hz / 5.0)) < 1e-12;
        CHECK((whole || f_hz == 52.0 || f_hz == 399.0));
        CHECK(Range{52.0, 399.0}.contains(f_hz));
    }
}

TEST_CASE("candidates: constraints keep what keeps to them, and count the rest by reason") {
    DesignSpace space = four_factors();
    const Candidates all = made(space);
    space.constraints = {Range{55.0, 245.0}, 50.0, 10.0};
    const Candidates found = made(space);
    CHECK(found.kept.size() + total(found.rejected) == 24);
    CHECK(found.rejected.band == 8);  // 60 - 8 and 240 + 8, at two amplitudes and rhythms each
    CHECK(found.rejected.displacement == 2);  // 60 Hz, 1 g: 69 um
    for (const Candidate& candidate : found.kept) {
        const auto lines = spectral_lines(candidate.pattern);
        for (const SpectralLine& line : lines) CHECK(Range{55, 245}.contains(line.frequency_hz));
        CHECK(most_displacement_um(lines) <= 50.0);
        CHECK(*detectability_db(lines, default_tables()) >= 10.0);
    }
    space.constraints = {std::nullopt, std::nullopt, 200.0};
    CHECK(design_fault(space).empty());
    CHECK(made(space).rejected.detectability == 24);
    CHECK(all.kept.size() == 24);
}

TEST_CASE("candidates: a design that is too large or makes no sense is refused in words") {
    DesignSpace space = four_factors();
    const auto fault = [](const DesignSpace& s) { return candidates(s, {}).error().message; };
    space.amplitude_g = Span{0.0, 1.0, 1000, false, 0.0};
    CHECK(fault(space) ==
          "the full factorial has 12,000 combinations, at most 10,000 can be made: use fewer "
          "levels, or a sample");
    space.design = Design::sobol;
    CHECK(design_fault(space).empty());
    space.samples = 10'001;
    CHECK(fault(space) == "expected 1 to 10,000 samples");
    space = four_factors();
    space.amplitude_g = levels({});
    CHECK(fault(space) == "Amplitude: no levels, expected at least one");
    space.amplitude_g = levels({1.0, 51.0});
    CHECK(fault(space) == "Amplitude: expected numbers from 0 to 50");
    space.amplitude_g = Span{0.0, 1.0, 3, true, 0.0};
    CHECK(fault(space) == "Amplitude: a range spaced in ratios must begin above 0");
    space.amplitude_g = Span{1.0, 0.5, 3, false, 0.0};
    CHECK(fault(space) == "Amplitude: the range ends before it begins");
    space = four_factors();
    space.rhythms = {"x", "=x"};
    CHECK(fault(space) == "Rhythm: \"=x\" is no rhythm: step 1 is =, which must follow x or =");
    space = four_factors();
    space.mix = fixed(0.5);
    CHECK(fault(space).find("two carriers") != std::string::npos);
}

TEST_CASE("candidates: added behind what a set has, under free names, none twice") {
    PatternSet set;
    Vibration own;
    own.name = "1g";  // taken, and another vibration
    own.source = Pattern{};
    std::get<Pattern>(own.source).carriers[0].frequency_hz = 77.0;
    set.vibrations.push_back(own);
    own.name = "mine";  // is a candidate already
    own.source = Pattern{};
    std::get<Pattern>(own.source).amplitude_g = 0.5;
    set.vibrations.push_back(own);
    DesignSpace space;
    space.amplitude_g = levels({0.5, 1.0, 1.5});

    const auto fresh = new_to(set, made(space).kept, Before::kept);
    CHECK(fresh.size() == 2);
    const PatternSet more = *with_candidates(set, space, fresh, Before::kept);
    CHECK(names_of(more) == std::vector<std::string>{"1g", "mine", "A01", "A02"});
    CHECK(level_words(space, std::get<Pattern>(more.vibrations[3].source)) == "1.5 g");
    CHECK(more.generator == space);
    CHECK_FALSE(more.vibrations[1].generated);
    CHECK(more.vibrations[3].generated);

    SUBCASE("again: nothing is new") { CHECK(new_to(more, fresh, Before::kept).empty()); }
    SUBCASE("replaced: what was generated goes, but for locked ones") {
        PatternSet locked = more;
        locked.vibrations[3].locked = true;
        space.amplitude_g = levels({1.0, 1.5, 3.0});
        const auto others = new_to(locked, made(space).kept, Before::replaced);
        const PatternSet after = *with_candidates(locked, space, others, Before::replaced);
        CHECK(names_of(after) == std::vector<std::string>{"1g", "mine", "A02", "B01", "B02"});
    }
}

TEST_CASE("candidates: short names count as far as they must") {
    PatternSet set;
    ShortNames few(set, 9);
    CHECK(few.next() == "A01");
    set.vibrations.resize(2);
    set.vibrations[0].name = "A1";     // of another generation
    set.vibrations[1].name = "Alarm";  // of a person
    ShortNames many(set, 192);
    CHECK(many.next() == "B001");
    CHECK(many.next() == "B002");
}

TEST_CASE("candidates: a set never gets more patterns than it can have") {
    PatternSet set;
    set.vibrations.resize(limits::kMaxPatterns);
    const auto full = with_candidates(set, {}, {{"one", Pattern{}}}, Before::kept);
    REQUIRE_FALSE(full);
    CHECK(full.error().message ==
          "the set would have 10,001 patterns, at most 10,000 are possible");
}

}  // namespace candidates_test
