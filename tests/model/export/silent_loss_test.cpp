// What a format does not hold is said: no remark means no loss above 0.1 dB and 1 ms, measured here
// by another way than the program's own, from waveforms as they are rendered.
#include <doctest/doctest.h>

#include <cmath>

#include "model/export/exported_set.h"
#include "tests/model/io/effects_out/written_patterns.h"
#include "tests/support/strength_off.h"

namespace silent_loss_test {

using namespace tact;
using namespace tact::written_patterns;

namespace {

// Anything that a pattern can be, also what no format holds.
Pattern wild_pattern(std::mt19937& random) {
    Pattern pattern = some_pattern(random, {});
    pattern.amplitude_g = between(random, 0.1, 4.0);
    if (whole(random, 0, 2) == 0) pattern.carriers.push_back({between(random, 20, 400), 0.7, 1.0});
    if (whole(random, 0, 2) == 0) pattern.modulation.frequency_hz = between(random, 1, 60);
    if (whole(random, 0, 1) == 0) pattern.modulation.kind = ModulationKind::am;
    if (whole(random, 0, 2) == 0) pattern.rhythm = {"x=-x", 0.0371};
    if (whole(random, 0, 2) == 0) pattern.attack_s = 0.013;
    if (whole(random, 0, 3) == 0) pattern.carriers.front().frequency_hz = between(random, 1, 900);
    if (whole(random, 0, 3) == 0) pattern.carriers.front().phase_rad = 1.0;
    for (Transient& one : pattern.transients) {
        if (whole(random, 0, 3) == 0) one.duration_s = between(random, 0.002, 0.1);
        if (whole(random, 0, 3) == 0) one.frequency_hz = between(random, 1, 900);
        if (whole(random, 0, 3) == 0) one.shape = TransientShape::square;
    }
    return pattern;
}

ExportTarget plain_target(TargetFormat format) { return {format, plain_map(), {}}; }

// What is said of any file of the format says nothing of this one.
bool says_nothing(const ExportedPattern& made) {
    return std::ranges::all_of(made.remarks, [](const std::string& remark) {
        return remark.starts_with("as it is read back: ");
    });
}

// The law, and whether it had anything to say.
bool check_law(const Pattern& pattern, TargetFormat format) {
    const ExportedPattern made = exported(pattern, "odd \"one\"", plain_target(format));
    if (!says_nothing(made)) return false;
    CAPTURE(made.text);
    const Pattern& back = std::get<Pattern>(made.back);
    CHECK(std::abs(back.duration_s - pattern.duration_s) <= 0.001 + 1e-9);
    CHECK(strength_off::largest_db(pattern, back) <= 0.1 + strength_off::kOtherWayDb);
    return true;
}

// What every format holds, but for the steps of timings.
Pattern mild_pattern() {
    Pattern pattern;
    pattern.amplitude_g = 0.8;
    pattern.carriers.front().frequency_hz = 150.0;
    pattern.amplitude_curve = {{0.0, 0.0}, {0.1, 1.0}, {0.2, 0.4}, {0.3, 0.8}, {0.4, 0.2}};
    pattern.duration_s = 0.4;
    return pattern;
}

Transient mild_transient(double time_s) {
    return transients_on(plain_map(), time_s, 0.9, 0.5).front();
}

// The mild pattern with one thing that some format cannot hold.
std::vector<Pattern> odd_patterns() {
    std::vector<Pattern> all;
    const auto add = [&](auto change) {
        Pattern pattern = mild_pattern();
        change(pattern);
        all.push_back(pattern);
    };
    add([](Pattern&) {});
    add([](Pattern& p) { p.amplitude_curve[2].time_s = 0.1; });
    add([](Pattern& p) { p.amplitude_curve[0].value = 0.5; });
    add([](Pattern& p) { p.amplitude_curve[2].time_s = 0.103; });
    add([](Pattern& p) { p.amplitude_curve[2].time_s = 0.20033; });
    add([](Pattern& p) { p.duration_s = p.amplitude_curve.back().time_s = 0.40033; });
    add([](Pattern& p) { p.carriers.push_back({200.0, 0.5, 0.0}); });
    add([](Pattern& p) { p.carriers.front().phase_rad = 1.0; });
    add([](Pattern& p) { p.carriers.front().frequency_hz = 150.4; });
    add([](Pattern& p) { p.carriers.front().frequency_hz = 420.0; });
    add([](Pattern& p) { p.frequency_curve = {{0.0, 100.0}, {0.4, 200.0}}; });
    add([](Pattern& p) { p.frequency_curve = {{0.2, 100.0}, {0.2, 200.0}}; });
    add([](Pattern& p) { p.amplitude_g = 3.0; });
    add([](Pattern& p) { p.modulation.frequency_hz = 4.0; });
    add([](Pattern& p) { p.modulation = {ModulationKind::am, 80.0, 0.5}; });
    add([](Pattern& p) { p.rhythm = {"x-", 0.1}; });
    add([](Pattern& p) { p.attack_s = 0.05; });
    add([](Pattern& p) { p.transients = {mild_transient(0.15)}; });
    add([](Pattern& p) { p.transients = {mild_transient(0.15), mild_transient(0.16)}; });
    add([](Pattern& p) { p.transients = {mild_transient(0.15033)}; });
    add([](Pattern& p) { p.transients = {mild_transient(0.4)}; });
    for (const double amplitude_g : {0.0, 0.8}) {
        add([&](Pattern& p) {
            p.amplitude_g = amplitude_g;
            p.transients = {mild_transient(0.1)};
            p.transients[0].amplitude_g = 0.3;
        });
    }
    add([](Pattern& p) {
        p.transients = {mild_transient(0.1)};
        p.transients[0].duration_s = 0.05;
    });
    add([](Pattern& p) {
        p.transients = {mild_transient(0.1)};
        p.transients[0].frequency_hz = 420.0;
    });
    add([](Pattern& p) {
        p.transients = {mild_transient(0.1)};
        p.transients[0].shape = TransientShape::square;
    });
    add([](Pattern& p) {
        for (int k = 0; k < 200; ++k) p.transients.push_back(mild_transient(0.002 * k));
    });
    return all;
}

}  // namespace

TEST_CASE("written: of one oddity at a time, each loss has its remark, and what is held has none") {
    const std::vector<Pattern> patterns = odd_patterns();
    for (std::size_t k = 0; k < patterns.size(); ++k) {
        CAPTURE(k);
        for (std::size_t f = 0; f < target_formats().size(); ++f) {
            const auto format = static_cast<TargetFormat>(f);
            if (is_sampled(format)) continue;
            CAPTURE(target_formats()[f].key);
            const bool quiet = check_law(patterns[k], format);
            const bool steps = format == TargetFormat::android_timings ||
                               format == TargetFormat::web ||
                               format == TargetFormat::hla;  // which say that Hz are left out
            if (k == 0) CHECK(quiet != steps);
            if (k > 2) continue;
            const ExportTarget target = plain_target(format);
            CHECK(exported(patterns[k], "again", target) == exported(patterns[k], "again", target));
        }
    }
}

TEST_CASE("written: no loss is silent" * doctest::test_suite("long")) {
    std::mt19937 random(29);
    int lossless = 0;
    for (int k = 0; k < 60; ++k) {
        CAPTURE(k);
        const Pattern pattern = wild_pattern(random);
        for (std::size_t f = 0; f < target_formats().size(); ++f) {
            const auto format = static_cast<TargetFormat>(f);
            if (is_sampled(format)) continue;
            CAPTURE(target_formats()[f].key);
            if (check_law(pattern, format)) ++lossless;
        }
    }
    CHECK(lossless > 10);
}

TEST_CASE("written: samples lose nothing in silence, at any rate and in any encoding" *
          doctest::test_suite("long")) {
    std::mt19937 random(41);
    int quiet = 0;
    for (int k = 0; k < 20; ++k) {
        CAPTURE(k);
        const Pattern pattern = wild_pattern(random);
        for (const TargetFormat format : {TargetFormat::wav, TargetFormat::csv}) {
            for (const double rate_hz : {10'000.0, 44'100.0, 48'000.0}) {
                for (const auto encoding :
                     {WaveEncoding::int16, WaveEncoding::int24, WaveEncoding::float32}) {
                    CAPTURE(rate_hz);
                    CAPTURE(static_cast<int>(encoding));
                    ExportTarget target = own_target(format);
                    target.sampled = {rate_hz, encoding, 0.0};
                    const ExportedPattern made = exported(pattern, "odd", target);
                    if (!says_nothing(made)) continue;
                    ++quiet;
                    const Waveform& back = *std::get<Measurement>(made.back).waveform;
                    const Waveform meant = render(pattern);
                    CHECK(std::abs(static_cast<double>(back.samples_g.size()) -
                                   static_cast<double>(meant.samples_g.size())) <= 10.0);
                    CHECK(strength_off::largest_db(meant, back) <= 0.1 + strength_off::kOtherWayDb);
                }
            }
        }
    }
    CHECK(quiet > 300);
}

// Zeros of a product lie between the whole ms of .he and the ticks of HJIF: that is said there.
TEST_CASE("written: a slow modulation is held to 0.1 dB wherever points can hold it") {
    for (const double hz : {1.3, 5.0, 8.0, 10.0, 12.4, 15.0, 20.0, 24.0}) {
        for (const ModulationKind kind : {ModulationKind::am, ModulationKind::product}) {
            if (kind == ModulationKind::product && hz > 12.5) continue;  // two maxima a turn
            Pattern pattern = mild_pattern();
            pattern.amplitude_curve.clear();
            pattern.modulation = {kind, hz, 1.0};
            for (const TargetFormat format :
                 {TargetFormat::haptic, TargetFormat::ahap, TargetFormat::pulsar,
                  TargetFormat::openxr, TargetFormat::hjif, TargetFormat::he}) {
                CAPTURE(hz);
                CAPTURE(std::string(traits(format).key));
                const ExportedPattern made = exported(pattern, "am", plain_target(format));
                REQUIRE(made.error);
                const bool said = std::ranges::any_of(made.remarks, [](const std::string& remark) {
                    return remark.find(" dB off where it is felt") != remark.npos;
                });
                CHECK(said == (made.error->error_db > 0.1));
                CHECK(made.error->error_db <= (kind == ModulationKind::am ? 0.1 : 2.5));
                CHECK(strength_off::largest_db(pattern, std::get<Pattern>(made.back)) < 0.2);
            }
        }
    }
}

TEST_CASE("written: at the edges of every range all comes back" * doctest::test_suite("long")) {
    std::mt19937 random(39);
    const auto edge = [&](Range range) {
        const int which = whole(random, 0, 3);
        if (which == 0) return range.low;
        if (which == 1) return range.high;
        return between(random, range.low, range.high);
    };
    for (int k = 0; k < 40; ++k) {
        CAPTURE(k);
        Pattern pattern = some_pattern(random, {});
        pattern.amplitude_g = edge(limits::kAmplitudeG);
        pattern.carriers.clear();
        const int carriers = whole(random, 1, 8);
        for (int n = 0; n < carriers; ++n) {
            pattern.carriers.push_back(
                {edge(limits::kCarrierHz), edge(limits::kCarrierWeight), edge({-7.0, 7.0})});
        }
        pattern.modulation.frequency_hz = edge(limits::kModulationHz);
        if (whole(random, 0, 1) == 0) pattern.modulation.kind = ModulationKind::am;
        pattern.attack_s = edge({0.0, 0.1});
        if (whole(random, 0, 3) == 0) pattern = with_duration(pattern, limits::kDurationS.low);
        for (Transient& one : pattern.transients) {
            one.amplitude_g = edge(limits::kAmplitudeG);
            one.frequency_hz = edge(limits::kCarrierHz);
            one.duration_s = edge({limits::kTransientS.low, 0.1});
        }
        REQUIRE(!drawn_fault(pattern));
        for (const TargetTraits& one : target_formats()) {
            CAPTURE(one.key);
            const ExportedPattern made =
                exported(pattern, "edge", own_target(*target_format_of(one.key)));
            for (const std::string& remark : made.remarks) {
                CAPTURE(remark);
                CHECK_FALSE(remark.starts_with("nothing of it comes back"));
            }
        }
    }
}

}  // namespace silent_loss_test
