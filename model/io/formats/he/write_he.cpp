// RichTap's .he, version 2.
//
// Source    files of its editor, and OpenHarmony's limits of the sibling format: times in whole ms,
//           at most 128 events, 5 s a continuous one, 4 to 16 points in its curve, intensities and
//           frequencies of events whole from 0 to 100; a curve's intensity multiplies its event's,
//           its frequency, a whole number, is added.
// Guessed   that times of a curve have to rise: jumps become ramps of 1 ms.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "model/io/effects_out/knots.h"
#include "model/io/effects_out/shares.h"
#include "model/io/effects_out/written_text.h"
#include "model/io/formats/he/he.h"
#include "model/pattern/curves.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr std::size_t kMostEvents = 128;
constexpr std::size_t kMostContinuous = 64;
constexpr std::size_t kMostHePoints = 16;
constexpr std::size_t kLeastHePoints = 4;
constexpr double kLongestEventMs = 5000.0;

std::int64_t whole_ms(double t_s) { return std::llround(1e3 * t_s); }
std::int64_t percent(double share) { return std::llround(100.0 * share); }

Knot middle_of(const Knot& a, const Knot& b, double t_s) {
    const double share = (t_s - a.time_s) / (b.time_s - a.time_s);
    return {t_s, a.amplitude + share * (b.amplitude - a.amplitude),
            a.frequency + share * (b.frequency - a.frequency)};
}

// No two of them farther apart than an event may last.
std::vector<Knot> with_short_segments(const std::vector<Knot>& knots) {
    std::vector<Knot> result{knots.front()};
    for (std::size_t k = 1; k < knots.size(); ++k) {
        while (1e3 * (knots[k].time_s - result.back().time_s) > kLongestEventMs + 1e-6) {
            const double next_s = result.back().time_s + kLongestEventMs / 1e3;
            result.push_back(middle_of(result.back(), knots[k], next_s));
        }
        result.push_back(knots[k]);
    }
    return result;
}

// More points on the longest lines, until there are enough; twice the last where no ms is left.
void fill_up(std::vector<Knot>& knots) {
    while (knots.size() < kLeastHePoints) {
        std::size_t longest = 1;
        for (std::size_t k = 1; k < knots.size(); ++k) {
            const double own_s = knots[k].time_s - knots[k - 1].time_s;
            if (own_s > knots[longest].time_s - knots[longest - 1].time_s) longest = k;
        }
        const Knot& from = knots[longest - 1];
        const Knot& to = knots[longest];
        const std::int64_t ms = (whole_ms(from.time_s) + whole_ms(to.time_s)) / 2;
        if (ms == whole_ms(from.time_s)) {
            knots.push_back(knots.back());
            continue;
        }
        knots.insert(knots.begin() + static_cast<std::ptrdiff_t>(longest),
                     middle_of(from, to, static_cast<double>(ms) / 1e3));
    }
}

Json he_event(const char* type, std::int64_t time_ms, Json parameters) {
    Json event{{"Type", type}, {"RelativeTime", time_ms}};
    event["Index"] = 0;
    event["Parameters"] = std::move(parameters);
    return event;
}

Json continuous_event(std::vector<Knot> knots) {
    fill_up(knots);
    const std::int64_t start_ms = whole_ms(knots.front().time_s);
    const std::int64_t base = percent(knots.front().frequency);
    Json curve = Json::array();
    for (const Knot& knot : knots) {
        const std::int64_t own = percent(knot.frequency);
        curve.push_back({{"Time", whole_ms(knot.time_s) - start_ms},
                         {"Intensity", knot.amplitude},
                         {"Frequency", own - base}});
    }
    Json event = he_event("continuous", start_ms,
                          {{"Intensity", 100}, {"Frequency", base}, {"Curve", curve}});
    event["Duration"] = whole_ms(knots.back().time_s) - start_ms;
    return event;
}

// Events of at most 16 points and 5 s, as many in each as can be, each from the last one's last
// point on; none for silence.
std::vector<Json> continuous_events(const std::vector<Knot>& knots) {
    std::vector<Json> events;
    std::size_t first = 0;
    while (first + 1 < knots.size()) {
        const std::size_t lines = knots.size() - 1 - first;
        const std::size_t parts = (lines + kMostHePoints - 2) / (kMostHePoints - 1);
        const std::size_t most = (lines + parts - 1) / parts;
        std::size_t last = first + 1;
        while (last + 1 < knots.size() && last - first < most &&
               1e3 * (knots[last + 1].time_s - knots[first].time_s) <= kLongestEventMs + 1e-6) {
            ++last;
        }
        const std::vector<Knot> part(knots.begin() + static_cast<std::ptrdiff_t>(first),
                                     knots.begin() + static_cast<std::ptrdiff_t>(last + 1));
        const bool sounds =
            std::ranges::any_of(part, [](const Knot& knot) { return knot.amplitude > 0.0; });
        if (sounds) events.push_back(continuous_event(part));
        first = last;
    }
    return events;
}

Json tap_event(const TapShares& tap) {
    return he_event("transient", whole_ms(tap.time_s),
                    {{"Intensity", percent(tap.amplitude)}, {"Frequency", percent(tap.frequency)}});
}

void remark_steps(const Shares& shares, std::vector<std::string>& coarse) {
    coarse.push_back("frequency is in steps of 1/100 of the band");
    if (shares.taps.empty()) return;
    coarse.push_back("transients are in steps of 1/100 of the intensity and at whole ms");
}

}  // namespace

WrittenEffect write_he(const Pattern& pattern, const EffectTarget& target) {
    WrittenEffect written;
    std::vector<std::string>& remarks = written.remarks;
    Shares shares = as_shares(as_curves(pattern, written), target.map, written);
    std::vector<Json> events;
    if (peak_value(shares.amplitude) > 0.0 || shares.taps.empty()) {
        KnotRules rules;
        rules.most = kMostContinuous * (kMostHePoints - 1) / 2;  // 5 s may cut an event before
        rules.least_gap_s = 0.001;
        rules.tolerance = 1e-9;
        rules.felt = [&](const Knot& knot) {
            return FeltTone{continuous_g(target.map, knot.amplitude),
                            frequency_hz(target.map, knot.frequency)};
        };
        const FittedKnots fit =
            fitted_knots(shares.amplitude, shares.frequency, shares.duration_s, rules);
        remark_fit(fit, rules, written.coarse);
        const std::vector<Knot> knots = with_short_segments(fit.knots);
        events = continuous_events(knots);
        if (events.empty()) events.push_back(continuous_event({knots[0], knots[1]}));
    }
    keep_strongest(shares.taps, kMostEvents - events.size(), remarks);
    for (const TapShares& tap : shares.taps) events.push_back(tap_event(tap));
    remark_steps(shares, written.coarse);
    std::ranges::stable_sort(
        events, {}, [](const Json& event) { return event["RelativeTime"].get<std::int64_t>(); });
    Json list = Json::array();
    for (Json& event : events) list.push_back({{"Event", std::move(event)}});
    const Json part{{"AbsoluteTime", 0}, {"Pattern", std::move(list)}};
    written.text = printed(
        {{"Metadata",
          {{"Version", 2}, {"Created", target.date}, {"Description", valid_utf8(target.name)}}},
         {"PatternList", Json::array({part})}});
    return written;
}

}  // namespace tact
