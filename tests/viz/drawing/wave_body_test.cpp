#include "viz/drawing/wave_body.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/support/presence.h"
#include "viz/drawing/colour.h"

namespace tact::wave_body_test {
namespace {

constexpr double kRateHz = 10'000.0;

struct Tone {
    double frequency_hz = 150.0;
    double phase = 0.0;
    double modulation_hz = 0.0;
    double depth = 0.0;
};

double envelope_at(const Tone& tone, double time_s) {
    return 1.0 + tone.depth * std::sin(2 * std::numbers::pi * tone.modulation_hz * time_s);
}

std::vector<double> samples_of(const Tone& tone, double duration_s) {
    std::vector<double> samples(static_cast<std::size_t>(duration_s * kRateHz));
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double time_s = static_cast<double>(i) / kRateHz;
        const double angle = 2 * std::numbers::pi * tone.frequency_hz * time_s + tone.phase;
        samples[i] = envelope_at(tone, time_s) * std::sin(angle);
    }
    return samples;
}

// As a pane so wide and high draws the whole signal, from -reach to reach.
std::vector<Extremes> drawn(std::span<const double> samples, std::size_t width_px, double height_px,
                            double reach = 1.0) {
    return body_columns(samples, 0.0, static_cast<double>(samples.size()), width_px,
                        {6.0, 0.25 * 2.0 * reach / height_px});
}

double spread_px(const std::vector<Extremes>& columns, double Extremes::*edge, double height_px) {
    const auto [least, most] = std::ranges::minmax(columns, {}, edge);
    return (most.*edge - least.*edge) * height_px / 2.0;
}

}  // namespace

TEST_CASE("wave body: a steady tone is one even body wherever its periods are too narrow to see" *
          doctest::test_suite("long")) {
    int seen = 0;
    for (const double duration_s : {0.1, 0.5, 1.0, 3.7, 20.0}) {
        for (const double frequency_hz :
             {20.0, 37.3, 60.0, 82.4, 150.0, 200.0, 251.7, 333.3, 497.0, 499.9, 500.0}) {
            for (const double phase : {0.0, 1.1, 2.9, 4.6}) {
                const auto samples = samples_of({frequency_hz, phase}, duration_s);
                for (const std::size_t width_px : {60U, 75U, 203U, 610U, 1389U, 2600U}) {
                    const double period_px =
                        static_cast<double>(width_px) / (duration_s * frequency_hz);
                    if (period_px >= 6.0 || frequency_hz * duration_s < 4.0) continue;
                    for (const double height_px : {16.0, 90.0, 600.0}) {
                        const auto columns = drawn(samples, width_px, height_px);
                        const std::string what = std::to_string(frequency_hz) + " Hz of " +
                                                 std::to_string(duration_s) + " s on " +
                                                 std::to_string(width_px) + " px, phase " +
                                                 std::to_string(phase);
                        CHECK_MESSAGE(spread_px(columns, &Extremes::high, height_px) <= 1.0, what);
                        CHECK_MESSAGE(spread_px(columns, &Extremes::low, height_px) <= 1.0, what);
                        CHECK(columns[width_px / 2].high <= 1.0005);
                        ++seen;
                    }
                }
            }
        }
    }
    CHECK(seen > 1500);
}

TEST_CASE("wave body: a part of a tone is as even as the whole, from its first column on") {
    const auto samples = samples_of({180.0, 0.4}, 2.0);
    for (const double first : {1234.5, 4000.0, 9999.9}) {
        const auto columns = body_columns(samples, first, first + 5000.0, 300, {6.0, 0.0025});
        CHECK(spread_px(columns, &Extremes::high, 200.0) <= 1.0);
        CHECK(spread_px(columns, &Extremes::low, 200.0) <= 1.0);
    }
}

// Between crests the envelope may be anything it is within a period beside them.
TEST_CASE("wave body: of a modulated tone the modulation is drawn, at its frequency and depth") {
    int seen = 0;
    for (const double carrier_hz : {60.0, 150.0, 233.0, 480.0}) {
        for (const double modulation_hz : {2.0, 4.0, 13.0, 36.0}) {
            for (const double depth : {0.3, 1.0}) {
                for (const std::size_t width_px : {75U, 203U, 610U, 1389U}) {
                    const double per_s = static_cast<double>(width_px);  // of a pattern of 1 s
                    // At 6 px the carrier itself begins to be seen, and in the pauses first.
                    if (per_s / carrier_hz >= 5.0 || per_s / modulation_hz < 10.0) continue;
                    if (modulation_hz * 4.0 > carrier_hz) continue;
                    const Tone tone{carrier_hz, 0.3, modulation_hz, depth};
                    const auto columns = drawn(samples_of(tone, 1.0), width_px, 100.0, 2.0);
                    int crossings = 0;
                    for (std::size_t c = 0; c < width_px; ++c) {
                        double least = 9.0;
                        double most = 0.0;
                        for (double by = -1.2; by <= 1.2; by += 0.1) {
                            const double time_s =
                                (static_cast<double>(c) + 0.5) / per_s + by / carrier_hz;
                            least = std::min(least, envelope_at(tone, time_s));
                            most = std::max(most, envelope_at(tone, time_s));
                        }
                        // A column's own width besides: at 36 Hz on 610 px it is 0.37 rad.
                        const double within = std::numbers::pi * modulation_hz * depth / per_s;
                        CHECK_MESSAGE(columns[c].high >= least - within - 0.02, carrier_hz, " Hz, ",
                                      modulation_hz, " Hz, ", width_px, " px");
                        CHECK(columns[c].high <= most + within + 0.02);
                        CHECK(columns[c].low <= -least + within + 0.02);
                        CHECK(columns[c].low >= -most - within - 0.02);
                        if (c > 0 && (columns[c].high > 1.0) != (columns[c - 1].high > 1.0)) {
                            ++crossings;
                        }
                    }
                    // Twice a period; the ends may begin or end on one.
                    CHECK(std::abs(crossings - 2.0 * modulation_hz) <= 2.0);
                    ++seen;
                }
            }
        }
    }
    CHECK(seen > 40);
}

// Humps of a few columns: drawn one by one or as one body, never some of them.
TEST_CASE("wave body: waves about as narrow as can be seen have no beats that are not there") {
    int bodies = 0;
    int waves = 0;
    for (const double carrier_hz : {70.0, 120.0, 150.0, 240.0, 333.0}) {
        for (const double modulation_hz : {8.0, 12.0, 16.0, 20.0, 25.0, 31.0, 36.0}) {
            if (modulation_hz * 3.0 > carrier_hz) continue;
            const auto samples = samples_of({carrier_hz, 0.3, modulation_hz, 1.0}, 1.0);
            for (std::size_t width_px = 40; width_px <= 300; width_px += 5) {
                const double hump_px = static_cast<double>(width_px) / modulation_hz;
                if (hump_px < 3.5 || hump_px > 9.0) continue;
                const auto columns = drawn(samples, width_px, 12.0, 2.0);
                int crossings = 0;
                for (std::size_t c = 1; c < width_px; ++c) {
                    if ((columns[c].high > 1.0) != (columns[c - 1].high > 1.0)) ++crossings;
                }
                const bool is_body = crossings <= 2;
                CHECK_MESSAGE((is_body || std::abs(crossings - 2.0 * modulation_hz) <= 3.0),
                              carrier_hz, " Hz, ", modulation_hz, " Hz, ", width_px, " px");
                ++(is_body ? bodies : waves);
            }
        }
    }
    CHECK(bodies > 100);
    CHECK(waves > 100);
}

TEST_CASE("wave body: of waves too narrow to see the strength is known, a steady tone has all") {
    const auto shown = [](const Tone& tone, std::size_t width_px) {
        const auto samples = samples_of(tone, 1.0);
        return wave_body(samples, 0.0, 10'000.0, width_px, {6.0, 0.01});
    };
    const auto is_steady = [](const WaveBody& body) {
        return std::ranges::all_of(body.strength, [](double share) { return share > 0.95; });
    };
    for (const double frequency_hz : {37.3, 60.0, 150.0, 251.7, 497.0}) {
        for (const std::size_t width_px : {75U, 203U}) {
            if (static_cast<double>(width_px) / frequency_hz >= 6.0) continue;
            CHECK_MESSAGE(is_steady(shown({frequency_hz, 0.7}, width_px)), frequency_hz, " Hz on ",
                          width_px, " px");
        }
    }
    CHECK(is_steady(shown({20.0, 0.7}, 900)));
    // The tone of peak 1 + d that is as strong as (1 + d sin) has a peak of sqrt(1 + d d / 2).
    for (const double depth : {0.5, 1.0}) {
        const WaveBody body = shown({180.0, 0.3, 25.0, depth}, 100);
        const double share = std::sqrt(1.0 + depth * depth / 2.0) / (1.0 + depth);
        for (const double strength : body.strength) CHECK(std::abs(strength - share) <= 0.08);
    }
    // Waves that are seen are as strong as they look.
    for (const double strength : shown({180.0, 0.3, 4.0, 0.8}, 200).strength) {
        CHECK(strength >= 0.9);
    }
}

TEST_CASE("wave body: two tones show the beat of the slower one while that can be seen") {
    // 210 Hz is body, 30 Hz has 20 px a period.
    std::vector<double> samples = samples_of({30.0}, 1.0);
    const std::vector<double> fast = samples_of({210.0}, 1.0);
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i] += 0.3 * fast[i];
    const auto columns = drawn(samples, 600, 100.0, 1.3);
    const auto between = [&](double from, double to) {
        const auto at = [&](double share) {
            return columns.begin() + static_cast<std::ptrdiff_t>(share * 20.0);
        };
        return std::span(at(from), at(to));
    };
    for (double period = 3.0; period < 25.0; period += 1.0) {
        const auto crest = between(period, period + 0.5);
        const auto trough = between(period + 0.5, period + 1.0);
        CHECK(std::ranges::max(crest, {}, &Extremes::high).high > 1.1);
        CHECK(std::ranges::min(trough, {}, &Extremes::high).high < -0.5);
    }
    // On a fifth of the width both are.
    const auto narrow = drawn(samples, 120, 100.0, 1.3);
    CHECK(spread_px(narrow, &Extremes::high, 100.0) <= 1.0);
}

TEST_CASE("wave body: what can be seen is drawn sample by sample, and nothing is ever lost") {
    const auto slow = samples_of({20.0, 0.7}, 1.0);
    CHECK(drawn(slow, 900, 100.0) == extremes(slow, 0.0, 10'000.0, 900));
    std::vector<double> clicks(10'000, 0.0);
    clicks[5000] = 1.0;
    clicks[5030] = 1.0;
    clicks[7000] = -1.0;
    CHECK(drawn(clicks, 1000, 100.0) == extremes(clicks, 0.0, 10'000.0, 1000));
    const std::vector<double> silence(10'000, 0.0);
    CHECK(drawn(silence, 300, 100.0) == extremes(silence, 0.0, 10'000.0, 300));
    for (const std::size_t count : {1U, 2U, 3U, 4U, 5U, 7U}) {
        const std::vector<double> few(slow.begin(), slow.begin() + count);
        const auto length = static_cast<double>(count);
        CHECK(body_columns(few, 0.0, length, 1, {}) == extremes(few, 0.0, length, 1));
    }
    const auto tone = samples_of({170.0}, 1.0);
    const auto least = extremes(tone, 0.0, 10'000.0, 500);
    const auto columns = drawn(tone, 500, 100.0);
    for (std::size_t c = 0; c < 500; ++c) {
        CHECK(columns[c].high >= least[c].high);
        CHECK(columns[c].low <= least[c].low);
    }
}

TEST_CASE("wave body: pauses between bursts stay silent down to two pixels") {
    for (const std::size_t width_px : {75U, 150U, 300U}) {
        // A period of 8 px at least: bursts of 60 %, then nothing.
        const double period_s = 8.0 / static_cast<double>(width_px);
        auto samples = samples_of({250.0}, 1.0);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double time_s = static_cast<double>(i) / kRateHz;
            if (std::fmod(time_s, period_s) >= 0.6 * period_s) samples[i] = 0.0;
        }
        const auto columns = drawn(samples, width_px, 40.0);
        for (std::size_t burst = 1; burst + 1 < width_px / 8; ++burst) {
            CHECK(columns[8 * burst + 2].high > 0.6);
            CHECK(std::min(columns[8 * burst + 6].high, columns[8 * burst + 7].high) < 0.1);
        }
    }
}

TEST_CASE("wave body: a square wave and a clipped one do not grow beyond their samples") {
    auto samples = samples_of({200.0}, 1.0);
    for (double& sample : samples) sample = std::clamp(sample, -0.5, 0.5);
    for (const Extremes& e : drawn(samples, 400, 300.0)) CHECK(e.high <= 0.5);
    for (double& sample : samples) sample = sample > 0.0 ? 1.0 : -1.0;
    for (const Extremes& e : drawn(samples, 400, 300.0)) CHECK(e.high <= 1.0);
}

TEST_CASE("wave body: a minute is looked at once, in blocks that lose no crest") {
    auto samples = samples_of({497.0}, 60.0);
    samples[123'456] = 3.0;
    const auto columns = drawn(samples, 800, 100.0);
    CHECK(columns[123'456 * 800 / 600'000].high == 3.0);
    std::vector<Extremes> others;
    for (const Extremes& e : columns) {
        if (e.high < 2.0) others.push_back(e);
    }
    CHECK(others.size() >= 795);
    CHECK(spread_px(others, &Extremes::high, 100.0) <= 1.0);
}

// The pixels themselves: every column of a plain tone has as many, in thumbnails, too.
TEST_CASE("wave body: pictures of a tone have no beats, in rows and in thumbnails") {
    const ImU32 ink = IM_COL32(255, 0, 200, 255);
    for (const ImVec2 size : {ImVec2{75, 18}, ImVec2{610, 60}, ImVec2{1389, 220}}) {
        for (const double frequency_hz : {47.0, 150.0, 200.0, 421.0}) {
            const auto samples = samples_of({frequency_hz, 0.5}, 1.0);
            if (static_cast<double>(size.x) / frequency_hz >= 6.0) continue;
            const Rect area{{10, 10}, ImVec2{10, 10} + size};
            const Image image =
                draw_picture(static_cast<int>(size.x) + 20, static_cast<int>(size.y) + 20, {},
                             [&](const Theme& theme) {
                                 Plot plot;
                                 plot.area = area;
                                 plot.x = {0.0, 1.0, Scale::linear, area.min.x, area.max.x};
                                 plot.y = {-1.1, 1.1, Scale::linear, area.max.y, area.min.y};
                                 draw_signal(*ImGui::GetWindowDrawList(), theme, plot, samples,
                                             kRateHz, ink, TraceStyle::line);
                             });
            int fewest = 10'000;
            int most = 0;
            for (float x = area.min.x + 1.0F; x < area.max.x - 1.0F; x += 1.0F) {
                const int count =
                    count_pixels(image, {{x, area.min.y}, {x + 1.0F, area.max.y}}, ink, 120);
                fewest = std::min(fewest, count);
                most = std::max(most, count);
            }
            CHECK_MESSAGE(most - fewest <= 2, frequency_hz, " Hz at ", size.x);
            CHECK(fewest > 0.8F * size.y);
        }
    }
}

TEST_CASE("wave body: modulated faster than can be seen it is lighter, and outlined") {
    const ImU32 ink = IM_COL32(255, 0, 200, 255);
    const Rect area{{10, 10}, {85, 40}};
    const auto full_pixels = [&](const Tone& tone) {
        const auto samples = samples_of(tone, 1.0);
        const Image image = draw_picture(95, 50, {}, [&](const Theme& theme) {
            Plot plot;
            plot.area = area;
            plot.x = {0.0, 1.0, Scale::linear, area.min.x, area.max.x};
            plot.y = {-2.2, 2.2, Scale::linear, area.max.y, area.min.y};
            draw_signal(*ImGui::GetWindowDrawList(), theme, plot, samples, kRateHz, ink,
                        TraceStyle::line);
        });
        return std::pair{count_pixels(image, {{30, 22}, {60, 28}}, ink, 10),
                         count_pixels(image, {{30, 10}, {60, 22}}, ink, 120)};
    };
    const auto [steady_body, steady_edge] = full_pixels({150.0, 0.5});
    const auto [waves_body, waves_edge] = full_pixels({150.0, 0.5, 30.0, 1.0});
    CHECK(steady_body == 30 * 6);
    CHECK(waves_body == 0);
    CHECK(waves_edge >= 30);
    CHECK(steady_edge > waves_edge);
}

TEST_CASE(
    "wave body: in however narrow a view, a steady wave is a body if a wide one shows it so") {
    // 5.5 columns of 20 samples to a period.
    const Tone tone{kRateHz / 110.0};
    const std::vector<double> samples = samples_of(tone, 0.3);
    for (double first = 1000.0; first < 1110.0; first += 10.0) {
        for (const Extremes& column : body_columns(samples, first, first + 40.0, 2, {6.0, 0.01})) {
            CHECK(column.high > 0.99);
            CHECK(column.low < -0.99);
        }
    }
}

}  // namespace tact::wave_body_test
