// What a format does not hold is said.
#include <doctest/doctest.h>

#include "tests/model/io/effects_out/written_patterns.h"

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

bool is_plain(const Pattern& pattern) {
    return pattern.carriers.size() == 1 && pattern.modulation.frequency_hz == 0.0 &&
           pattern.carriers.front().phase_rad == 0.0;
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

bool is_source_text(TargetFormat format) {
    return format == TargetFormat::android_kotlin || format == TargetFormat::openxr;
}

}  // namespace

TEST_CASE("written: of one oddity at a time, each loss has its remark, and what is held has none") {
    const std::vector<Pattern> patterns = odd_patterns();
    for (std::size_t k = 0; k < patterns.size(); ++k) {
        CAPTURE(k);
        for (std::size_t f = 0; f < target_formats().size(); ++f) {
            const auto format = static_cast<TargetFormat>(f);
            if (is_source_text(format) || is_sampled(format)) continue;
            CAPTURE(target_formats()[f].key);
            const auto written = write_effect(format, patterns[k], {"odd", plain_map()});
            const Pattern back = read_back(format, written).effects.front().pattern;
            const bool held = is_plain(patterns[k]) && is_equal(patterns[k], back);
            if (written.remarks.empty() && format != TargetFormat::hjif) CHECK(held);
            if (written.remarks.empty() && is_plain(patterns[k])) CHECK(held);
            if (k == 0 && format != TargetFormat::android_timings && format != TargetFormat::hla) {
                CHECK(written.remarks.empty());
            }
        }
    }
}

TEST_CASE("written: no loss is silent" * doctest::test_suite("long")) {
    std::mt19937 random(29);
    int lossless = 0;
    for (int k = 0; k < 300; ++k) {
        CAPTURE(k);
        const Pattern pattern = wild_pattern(random);
        for (std::size_t f = 0; f < target_formats().size(); ++f) {
            const auto format = static_cast<TargetFormat>(f);
            CAPTURE(target_formats()[f].key);
            const auto written = write_effect(format, pattern, {"wild \"one\"", plain_map()});
            CHECK(written == write_effect(format, pattern, {"wild \"one\"", plain_map()}));
            if (!written.remarks.empty()) continue;
            CAPTURE(written.text);
            const bool source =
                format == TargetFormat::android_kotlin || format == TargetFormat::openxr;
            if (source || is_sampled(format)) continue;
            const Pattern back = read_back(format, written).effects.front().pattern;
            if (format != TargetFormat::hjif) CHECK(is_plain(pattern));
            if (is_plain(pattern)) CHECK(is_equal(pattern, back));
            ++lossless;
        }
    }
    CHECK(lossless > 50);
}

}  // namespace silent_loss_test
