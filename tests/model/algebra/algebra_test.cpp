// Laws of the algebra over random patterns: what an edit and its inverse leave, what parts sound
// like where they are put, and that whatever cannot be says so in one sentence.
#include "model/algebra/algebra.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "model/algebra/set_edits.h"
#include "model/design_space/spectral_lines.h"
#include "model/pattern/drawn_fault.h"

namespace algebra_test {

using namespace tact;

namespace {

constexpr int kPatterns = 200;

double between(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

std::string random_rhythm(std::mt19937& random, std::size_t steps) {
    std::string text;
    for (std::size_t k = 0; k < steps; ++k) {
        const bool can_hold = !text.empty() && text.back() != '-';
        const std::size_t mark = random() % 3;
        const char note = "x123456789ABAB"[random() % 14];
        text += mark == 0 ? note : mark == 1 && can_hold ? '=' : '-';
    }
    return text;
}

// `whole`: the duration is a number of steps, and notes and curves have no two slopes at once.
Pattern random_pattern(std::mt19937& random, bool whole = true) {
    Pattern pattern;
    pattern.amplitude_g = between(random, 0.1, 2.0);
    pattern.carriers[0].frequency_hz = between(random, 30.0, 300.0);
    if (random() % 2 == 0) pattern.carriers.push_back({between(random, 30.0, 300.0), 0.5, 1.0});
    const std::size_t steps = 1 + random() % 12;
    pattern.rhythm.unit_s = between(random, 0.02, 0.2);
    if (random() % 4 != 0) pattern.rhythm.text = random_rhythm(random, steps);
    pattern.rhythm.kinds = {{'A', {between(random, 0.0, 1.0), between(random, 0.5, 2.0)}},
                            {'B', {1.0, between(random, 0.5, 2.0)}}};
    pattern.duration_s = static_cast<double>(steps) * pattern.rhythm.unit_s;
    if (!whole) pattern.duration_s *= between(random, 0.7, 1.8);
    if (random() % 2 == 0) {
        pattern.attack_s = between(random, 0.0, 0.1);
        pattern.release_s = between(random, 0.0, 0.1);
    } else {
        for (int k = 0; k < 4; ++k) {
            const double time_s = pattern.duration_s * (k + between(random, 0.0, 0.9)) / 4.0;
            pattern.amplitude_curve.push_back({time_s, between(random, 0.0, 1.0)});
            pattern.frequency_curve.push_back({time_s, between(random, 50.0, 300.0)});
        }
    }
    pattern.transients.push_back({0.3 * pattern.duration_s, 0.5, 200.0, 0.005});
    pattern.transients.push_back({0.6 * pattern.duration_s, 0.7, 100.0, 0.005});
    return pattern;
}

Expected<Pattern> one(const Pattern& pattern, const Edit& edit) {
    return edited(pattern, std::vector<Edit>{edit}, default_tables());
}

Pattern made(const Pattern& pattern, const Edit& edit) {
    const Expected<Pattern> result = one(pattern, edit);
    INFO((result ? "" : result.error().message));
    REQUIRE(result);
    CHECK(!drawn_fault(*result));
    CHECK(rhythm_fault(result->rhythm.text).empty());
    return *result;
}

// Times at which neither an edge nor its rounding can be.
std::vector<double> times_in(const Pattern& pattern, std::mt19937& random) {
    std::vector<double> edges_s{0.0, pattern.duration_s};
    for (const Note& note : notes(pattern.rhythm, pattern.duration_s)) {
        edges_s.push_back(note.onset_s);
        edges_s.push_back(note.onset_s + note.length_s);
    }
    for (const AmplitudePoint& point : pattern.amplitude_curve) edges_s.push_back(point.time_s);
    std::vector<double> times_s;
    for (int k = 0; k < 60; ++k) {
        const double t_s = between(random, 0.0, pattern.duration_s);
        const bool clear = std::ranges::all_of(
            edges_s, [&](double edge_s) { return std::abs(edge_s - t_s) > 1e-6; });
        if (clear) times_s.push_back(t_s);
    }
    return times_s;
}

// How far two envelopes and two frequencies are apart where one's time is `at` of the other's.
template <class At>
double apart(const Pattern& a, const Pattern& b, std::mt19937& random, At at) {
    double most = 0.0;
    for (const double t_s : times_in(a, random)) {
        most = std::max(most, std::abs(envelope_g(a, t_s) - envelope_g(b, at(t_s))));
        if (envelope_g(a, t_s) == 0.0) continue;  // a rest has the pitch of the note before it
        const double hz = first_carrier_hz(a, t_s);
        most = std::max(most, std::abs(first_carrier_hz(b, at(t_s)) / hz - 1.0));
    }
    return most;
}

const auto kSameTime = [](double t_s) { return t_s; };

}  // namespace

TEST_CASE("algebra: reversed twice, stretched by a factor and its inverse, a pattern is itself") {
    std::mt19937 random(1);
    for (int k = 0; k < kPatterns; ++k) {
        CAPTURE(k);
        const Pattern pattern = random_pattern(random);
        const Pattern back = made(made(pattern, {EditKind::reverse}), {EditKind::reverse});
        CHECK(apart(pattern, back, random, kSameTime) < 1e-9);
        CHECK(std::abs(back.transients[0].time_s - pattern.transients[0].time_s) < 1e-9);
        const double factor = between(random, 0.5, 4.0);
        for (const EditKind kind : {EditKind::stretch, EditKind::stretch_notes}) {
            const Pattern again = made(made(pattern, {kind, factor}), {kind, 1.0 / factor});
            CHECK(apart(pattern, again, random, kSameTime) < 1e-9);
            CHECK(std::abs(again.duration_s - pattern.duration_s) < 1e-9);
            CHECK(again.rhythm.text == pattern.rhythm.text);
        }
        const double lower = between(random, 0.5, 2.0);
        const Pattern tuned =
            made(made(pattern, {EditKind::transpose, lower}), {EditKind::transpose, 1.0 / lower});
        CHECK(apart(pattern, tuned, random, kSameTime) < 1e-9);
    }
}

TEST_CASE("algebra: an edit in time sounds where it says, on the grid or drawn") {
    std::mt19937 random(2);
    for (int k = 0; k < kPatterns; ++k) {
        CAPTURE(k);
        const bool whole = k % 2 == 0;
        const Pattern pattern = random_pattern(random, whole);
        const double end_s = pattern.duration_s;
        const Pattern turned = made(pattern, {EditKind::reverse});
        CHECK(apart(pattern, turned, random, [&](double t_s) { return end_s - t_s; }) < 2e-3);
        if (whole) CHECK(turned.rhythm.text.size() == pattern.rhythm.text.size());
        CHECK(std::abs(turned.transients.front().time_s + 0.005 + pattern.transients.back().time_s -
                       end_s) < 1e-9);
        const Pattern slow = made(pattern, {EditKind::stretch, 3.0});
        CHECK(apart(pattern, slow, random, [](double t_s) { return 3.0 * t_s; }) < 2e-3);
        const Pattern three = made(pattern, {EditKind::repeat, 3.0});
        CHECK(std::abs(three.duration_s - 3.0 * end_s) < 1e-9);
        CHECK(three.transients.size() == 6);
        for (int turn = 0; turn < 3; ++turn) {
            const auto later = [&](double t_s) { return t_s + turn * end_s; };
            CHECK(apart(pattern, three, random, later) < 2e-3);
        }
    }
}

TEST_CASE("algebra: a join is its parts behind each other, of any strengths and frequencies") {
    std::mt19937 random(3);
    for (int k = 0; k < kPatterns; ++k) {
        CAPTURE(k);
        const Pattern first = random_pattern(random, k % 2 == 0);
        Pattern second = random_pattern(random, k % 3 == 0);
        const double factor = between(random, 0.5, 2.0);
        second.carriers = first.carriers;
        for (Carrier& carrier : second.carriers) carrier.frequency_hz *= factor;
        const Pattern both = made(first, {EditKind::join, 0.0, second});
        const double begin_s = first.duration_s;
        CHECK(both.duration_s == first.duration_s + second.duration_s);
        CHECK(apart(first, both, random, kSameTime) < 4e-3);
        CHECK(apart(second, both, random, [&](double t_s) { return t_s + begin_s; }) < 4e-3);
        CHECK(both.transients.size() == 4);
    }
}

TEST_CASE("algebra: on one grid joined, repeated and turned rhythms stay rhythms") {
    Pattern bar;
    bar.duration_s = 1.0;
    bar.rhythm = {"x==-x-x-", 0.125};
    bar.attack_s = 0.01;
    bar.release_s = 0.02;
    const Pattern turned = made(bar, {EditKind::reverse});
    CHECK(turned.rhythm.text == "-x-x-x==");
    CHECK(turned.attack_s == 0.02);
    CHECK(turned.release_s == 0.01);
    CHECK(made(bar, {EditKind::repeat, 4.0}).rhythm == bar.rhythm);
    Pattern other = bar;
    other.rhythm.text = "x---";
    other.duration_s = 0.5;
    const Pattern joined = made(bar, {EditKind::join, 0.0, other});
    CHECK(joined.rhythm.text == "x==-x-x-x---");
    CHECK(joined.amplitude_curve.empty());
    // A steady tone with ramps is a note of its own each time.
    Pattern swell;
    swell.duration_s = 0.5;
    swell.attack_s = 0.1;
    const Pattern twice = made(swell, {EditKind::repeat, 2.0});
    CHECK(notes(twice.rhythm, twice.duration_s) == std::vector<Note>{{0.0, 0.5}, {0.5, 0.5}});
    CHECK(twice.attack_s == 0.1);
}

TEST_CASE("algebra: a mix of two beds is the sum of their waves, and ticks come as they are") {
    std::mt19937 random(4);
    for (int k = 0; k < 20; ++k) {
        CAPTURE(k);
        Pattern first = random_pattern(random);
        first.transients.clear();
        first.frequency_curve.clear();
        Pattern second = first;
        second.amplitude_g = between(random, 0.2, 1.0);
        second.carriers = {{between(random, 30.0, 300.0), 1.0, 0.3}};
        const std::vector<double> sum = render(made(first, {EditKind::mix, 0.0, second})).samples_g;
        const std::vector<double> a = render(first).samples_g;
        const std::vector<double> b = render(second).samples_g;
        double most = 0.0;
        for (std::size_t n = 0; n < sum.size(); ++n) {
            most = std::max(most, std::abs(sum[n] - a[n] - b[n]));
        }
        CHECK(most < 1e-9);
    }
    Pattern ticks;
    ticks.amplitude_g = 0.0;
    ticks.duration_s = 2.0;
    ticks.transients = {{1.5, 0.5, 200.0, 0.01}};
    const Pattern bed = random_pattern(random);
    for (const Pattern& mix :
         {made(bed, {EditKind::mix, 0.0, ticks}), made(ticks, {EditKind::mix, 0.0, bed})}) {
        CHECK(mix.duration_s == 2.0);
        CHECK(mix.transients.size() == 3);
        CHECK(envelope_g(mix, 1.9) == 0.0);
        CHECK(apart(bed, mix, random, kSameTime) < 2e-3);
    }
    Pattern elsewhere = bed;
    elsewhere.rhythm.text = "x---x-";
    const auto refused = one(bed, {EditKind::mix, 0.0, elsewhere});
    REQUIRE(!refused);
    CHECK(
        refused.error().message.starts_with("mix: expected two patterns that differ in carriers"));
}

TEST_CASE("algebra: trimmed, a pattern begins and ends with what sounds, and that is the same") {
    Pattern late;
    late.duration_s = 1.0;
    late.rhythm = {"--x=-x--", 0.125};
    const Pattern trimmed = made(late, {EditKind::trim});
    CHECK(trimmed.duration_s == 0.5);
    CHECK(notes(trimmed.rhythm, 0.5) == std::vector<Note>{{0.0, 0.25}, {0.375, 0.125}});
    CHECK(made(trimmed, {EditKind::trim}) == trimmed);
    std::mt19937 random(5);
    int shorter = 0;
    for (int k = 0; k < kPatterns; ++k) {
        CAPTURE(k);
        const Pattern pattern = random_pattern(random, k % 2 == 0);
        const Pattern cut = made(pattern, {EditKind::trim});
        CHECK(cut.transients.size() == 2);
        const double before_s = pattern.transients[0].time_s - cut.transients[0].time_s;
        CHECK(before_s >= 0.0);
        shorter += cut.duration_s < pattern.duration_s - 1e-6 ? 1 : 0;
        CHECK(apart(cut, pattern, random, [&](double t_s) { return t_s + before_s; }) < 2e-3);
        for (const double t_s : times_in(pattern, random)) {
            const double then_s = t_s - before_s;
            if (then_s < -1e-6 || then_s > cut.duration_s + 1e-6)
                CHECK(envelope_g(pattern, t_s) == 0.0);
        }
    }
    CHECK(shorter > kPatterns / 4);
    Pattern silent;
    silent.amplitude_g = 0.0;
    CHECK(one(silent, {EditKind::trim}).error().message ==
          "trim: expected a pattern that is not silent");
}

TEST_CASE("algebra: fades are straight in strength, of curves within 0.1 %") {
    std::mt19937 random(6);
    for (int k = 0; k < kPatterns; ++k) {
        CAPTURE(k);
        const Pattern pattern = random_pattern(random);
        const double fade_s = 0.8 * pattern.duration_s;
        const Pattern in = made(pattern, {EditKind::fade_in, fade_s});
        const Pattern out = made(pattern, {EditKind::fade_out, fade_s});
        for (const double t_s : times_in(pattern, random)) {
            const double now_g = envelope_g(pattern, t_s);
            const double since_end_s = pattern.duration_s - t_s;
            CHECK(std::abs(envelope_g(in, t_s) - now_g * std::min(1.0, t_s / fade_s)) < 2.5e-3);
            CHECK(std::abs(envelope_g(out, t_s) - now_g * std::min(1.0, since_end_s / fade_s)) <
                  2.5e-3);
        }
    }
    CHECK(one(Pattern{}, {EditKind::fade_in, 2.0}).error().message ==
          "fade-in: expected at most the pattern's 1 s, got 2 s");
}

TEST_CASE("algebra: normalised, the peak or the level above threshold is what was asked for") {
    std::mt19937 random(7);
    for (int k = 0; k < 20; ++k) {
        CAPTURE(k);
        Pattern pattern = random_pattern(random);
        if (has_pitches(pattern.rhythm)) CHECK_FALSE(one(pattern, {EditKind::felt, 12.0}));
        for (auto& [letter, kind] : pattern.rhythm.kinds) kind.pitch = 1.0;
        const std::vector<double> samples_g =
            render(made(pattern, {EditKind::normalise, 0.7})).samples_g;
        double peak_g = 0.0;
        for (const double sample_g : samples_g) peak_g = std::max(peak_g, std::abs(sample_g));
        CHECK(std::abs(peak_g - 0.7) < 1e-9);
        Pattern plain = pattern;
        plain.frequency_curve.clear();
        plain.amplitude_curve.clear();
        plain.transients.clear();
        const Pattern felt = made(plain, {EditKind::felt, 12.0});
        const auto above_db = detectability_db(spectral_lines(felt), default_tables());
        REQUIRE(above_db);
        CHECK(std::abs(*above_db - 12.0) < 1e-6);
        // Under a curve it is the highest place that is felt so; ticks keep their share.
        Pattern drawn = pattern;
        drawn.frequency_curve.clear();
        if (drawn.amplitude_curve.empty()) drawn.amplitude_curve = {{0.0, 0.5}};
        double highest = 0.0;
        for (const AmplitudePoint& point : drawn.amplitude_curve) {
            highest = std::max(highest, point.value);
        }
        const Pattern under = made(drawn, {EditKind::felt, 12.0});
        CHECK(std::abs(under.amplitude_g * highest / felt.amplitude_g - 1.0) < 1e-9);
        CHECK(std::abs(under.transients[0].amplitude_g / under.amplitude_g /
                           (drawn.transients[0].amplitude_g / drawn.amplitude_g) -
                       1.0) < 1e-9);
    }
}

TEST_CASE("algebra: quantised, notes lie on the grid, each as near as it may, and stay there") {
    std::mt19937 random(8);
    for (int k = 0; k < kPatterns; ++k) {
        CAPTURE(k);
        Pattern pattern = random_pattern(random);
        const double grid_s = between(random, 0.02, 0.1);
        const Pattern on_grid = made(pattern, {EditKind::quantise, grid_s});
        CHECK(made(on_grid, {EditKind::quantise, grid_s}) == on_grid);
        const auto before = notes(pattern.rhythm, pattern.duration_s);
        const auto after = notes(on_grid.rhythm, on_grid.duration_s);
        if (!pattern.rhythm.text.empty()) {
            CHECK(after.size() <= before.size());
            for (const Note& note : after) {
                const bool near = std::ranges::any_of(before, [&](const Note& old) {
                    return std::abs(old.onset_s - note.onset_s) <= 0.5 * grid_s + 1e-9 ||
                           note.onset_s + grid_s >= pattern.duration_s;
                });
                CHECK(near);
            }
        }
        // To its own step, a rhythm is what it was.
        if (!pattern.rhythm.text.empty()) {
            const Pattern own = made(pattern, {EditKind::quantise, pattern.rhythm.unit_s});
            CHECK(notes(own.rhythm, own.duration_s) == before);
        }
    }
    Pattern bar;
    bar.rhythm = {"x-x-", 0.13};
    CHECK(made(bar, {EditKind::quantise_bpm, 120.0}).rhythm == Rhythm{"x-", 0.125});
    bar.duration_s = 50.0;
    bar.rhythm = {"x-x---x-x", 0.13013};
    CHECK(one(bar, {EditKind::quantise, 0.001})
              .error()
              .message.starts_with("quantise: expected a grid of at least "));
    CHECK(one(Pattern{}, {EditKind::quantise, 0.1}).error().message ==
          "quantise: expected notes or ticks, got neither");
}

TEST_CASE("algebra: thinned curves stay within what was allowed") {
    Pattern pattern;
    for (int k = 0; k <= 400; ++k) {
        const double t = k / 400.0;
        pattern.amplitude_curve.push_back({t, 0.5 + 0.4 * std::sin(9.0 * t)});
        pattern.frequency_curve.push_back({t, 200.0 + 100.0 * std::cos(7.0 * t)});
    }
    const Pattern thin = made(pattern, {EditKind::thin, 2.0});
    CHECK(thin.amplitude_curve.size() < 40);
    CHECK(thin.frequency_curve.size() < 40);
    for (int k = 0; k <= 1000; ++k) {
        const double t_s = k / 1000.0;
        CHECK(std::abs(amplitude_factor(thin, t_s) - amplitude_factor(pattern, t_s)) < 0.0201);
        CHECK(std::abs(first_carrier_hz(thin, t_s) - first_carrier_hz(pattern, t_s)) < 6.03);
    }
    CHECK(made(pattern, {EditKind::thin, 0.0}).amplitude_curve.size() > 390);
}

TEST_CASE("algebra: what goes out of range is one sentence that begins with the edit") {
    const auto says = [](const Pattern& pattern, const Edit& edit) {
        const auto result = one(pattern, edit);
        return result ? std::string("done") : result.error().message;
    };
    Pattern pattern;
    CHECK(says(pattern, {EditKind::stretch, 0.0}) ==
          "stretch: expected a number from 0.01 to 100, got 0");
    CHECK(says(pattern, {EditKind::stretch, 100.0}) ==
          "stretch: expected a duration from 0.001 to 60 s, got 100 s");
    CHECK(says(pattern, {EditKind::repeat, 2.5}) ==
          "repeat: expected a whole number from 1 to 1000, got 2.5");
    CHECK(says(pattern, {EditKind::repeat, 61.0}) ==
          "repeat: expected a duration of at most 60 s, got 61 s");
    CHECK(says(pattern, {EditKind::transpose, 100.0}) ==
          "transpose: expected a carrier from 0.1 to 1000 Hz, got 15000 Hz");
    CHECK(says(pattern, {EditKind::felt, 80.0}).starts_with("felt: expected an amplitude from"));
    CHECK(says(pattern, {EditKind::join}) == "join: expected another pattern");
    Pattern other;
    other.modulation.frequency_hz = 10.0;
    CHECK(says(pattern, {EditKind::join, 0.0, other}) ==
          "join: expected the same modulation of both, as a pattern has one");
    for (std::size_t k = 0; k < kEditKindCount; ++k) {
        const EditTraits& about = traits(static_cast<EditKind>(k));
        CAPTURE(about.key);
        CHECK(edit_kind(about.key) == static_cast<EditKind>(k));
        if (about.needs == EditNeeds::number) CHECK(about.range.contains(about.start));
    }
}

TEST_CASE("algebra: in a set edits go in their order, and leave all else as it was") {
    PatternSet set;
    std::mt19937 random(9);
    for (const char* name : {"a", "b", "c"}) {
        Vibration& vibration = set.vibrations.emplace_back();
        vibration.name = name;
        vibration.source = random_pattern(random);
    }
    set.vibrations[1].generated = true;
    set.vibrations[2].locked = true;
    const std::vector<NamedEdit> edits{{EditKind::repeat, 2.0}, {EditKind::stretch, 0.5}};
    const std::vector<std::string> names{"b"};
    const auto after = with_edits(set, names, edits);
    REQUIRE(after);
    CHECK(after->vibrations[0] == set.vibrations[0]);
    CHECK(after->vibrations[2] == set.vibrations[2]);
    CHECK(!after->vibrations[1].generated);
    const Pattern& before = std::get<Pattern>(set.vibrations[1].source);
    CHECK(std::get<Pattern>(after->vibrations[1].source) ==
          made(made(before, {EditKind::repeat, 2.0}), {EditKind::stretch, 0.5}));
    const auto copy = with_edited_copy(set, "b", edits, "a");
    REQUIRE(copy);
    CHECK(names_of(*copy) == std::vector<std::string>{"a", "b", "a 2", "c"});
    CHECK(copy->vibrations[2].source == after->vibrations[1].source);
    CHECK(copy->vibrations[1] == set.vibrations[1]);
    set.vibrations[0].source = Pattern{};
    std::get<Pattern>(set.vibrations[0].source).amplitude_g = 0.0;
    const auto all = with_edits_of_all(set, std::vector<NamedEdit>{{EditKind::trim}});
    REQUIRE(all);
    CHECK(all->left ==
          std::vector<std::string>{"\"a\", trim: expected a pattern that is not silent"});
    CHECK(all->set.vibrations[0] == set.vibrations[0]);
    CHECK(std::get<Pattern>(all->set.vibrations[1].source) == made(before, {EditKind::trim}));
    CHECK(all->set.vibrations[2] == set.vibrations[2]);
    set.vibrations.erase(set.vibrations.begin() + 1);
    CHECK(with_edits_of_all(set, std::vector<NamedEdit>{{EditKind::trim}}).error().message ==
          all->left.front());
    const auto message = [&](const char* name, const NamedEdit& edit) {
        const auto result = with_edits(set, std::vector<std::string>{name}, std::vector{edit});
        return result ? std::string() : result.error().message;
    };
    CHECK(message("c", {EditKind::reverse}) == "\"c\" is locked: unlock it to edit it");
    CHECK(message("d", {EditKind::reverse}) == "there is no pattern \"d\", expected one of a, c");
    CHECK(message("a", {EditKind::mix, 0.0, "z"}) ==
          "mix: there is no pattern \"z\", expected one of a, c");
    CHECK(message("a", {EditKind::stretch, 1000.0}) ==
          "\"a\", stretch: expected a number from 0.01 to 100, got 1000");
}

}  // namespace algebra_test
