// Meta's .haptic, version 1.
//
// Source    .haptic File Specification 1.0: at least two points of amplitude, an emphasis at one of
//           them and not weaker than it, no frequency behind the end. Its renderer ducks what is
//           beneath an emphasis and cuts it with the next one.

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "model/io/effects_out/shares.h"
#include "model/io/effects_out/written_text.h"
#include "model/io/formats/haptic/haptic.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

struct HapticPoint {
    double time_s = 0.0;
    double amplitude = 0.0;
    std::optional<TapShares> emphasis;
};

// What the emphases cost, as the renderer plays them.
struct EmphasisLosses {
    std::size_t raised = 0;
    std::size_t ducking = 0;
    std::size_t cut = 0;
};

std::vector<HapticPoint> points_with(const Shares& shares, EmphasisLosses& losses) {
    std::vector<HapticPoint> points;
    auto next = shares.amplitude.begin();
    const auto add_until = [&](double time_s) {
        for (; next != shares.amplitude.end() && next->time_s <= time_s; ++next) {
            points.push_back({next->time_s, next->value, std::nullopt});
        }
    };
    for (TapShares tap : shares.taps) {
        add_until(tap.time_s);
        const bool is_there =
            !points.empty() && points.back().time_s == tap.time_s && !points.back().emphasis;
        if (!is_there) {
            const double beneath = sides_at(shares.amplitude, tap.time_s).behind;
            points.push_back({tap.time_s, beneath, std::nullopt});
        }
        HapticPoint& point = points.back();
        if (tap.amplitude < point.amplitude) ++losses.raised;
        if (point.amplitude > 0.0) ++losses.ducking;
        tap.amplitude = std::max(tap.amplitude, point.amplitude);
        point.emphasis = tap;
    }
    add_until(std::numeric_limits<double>::infinity());
    return points;
}

void remark_emphases(const EmphasisLosses& losses, const ActuatorMap& map,
                     std::vector<std::string>& remarks) {
    if (losses.raised > 0) {
        remarks.push_back(transients_text(losses.raised) +
                          ": raised to the amplitude beneath, as the format has none weaker");
    }
    if (losses.ducking > 0 && map.ducking != 1.0) {
        remarks.push_back("what is beneath " + transients_text(losses.ducking) + " is ducked to " +
                          significant_digits(map.ducking, 3) + " by its player");
    }
    if (losses.cut > 0) remarks.push_back(transients_text(losses.cut) + ": cut by the next one");
}

Json haptic_json(const EffectTarget& target, const std::vector<HapticPoint>& points,
                 const Shares& shares) {
    Json amplitude = Json::array();
    for (const HapticPoint& point : points) {
        Json one{{"time", point.time_s}, {"amplitude", point.amplitude}};
        if (point.emphasis) {
            one["emphasis"] = {{"amplitude", point.emphasis->amplitude},
                               {"frequency", point.emphasis->frequency}};
        }
        amplitude.push_back(std::move(one));
    }
    Json frequency = Json::array();
    if (shares.frequency.front().time_s > 0.0) {
        frequency.push_back({{"time", 0.0}, {"frequency", shares.frequency.front().value}});
    }
    for (const AmplitudePoint& point : shares.frequency) {
        frequency.push_back({{"time", point.time_s}, {"frequency", point.value}});
    }
    return {
        {"version", {{"major", 1}, {"minor", 0}, {"patch", 0}}},
        {"metadata", {{"editor", "tactspace"}, {"project", valid_utf8(target.name)}}},
        {"signals",
         {{"continuous", {{"envelopes", {{"amplitude", amplitude}, {"frequency", frequency}}}}}}}};
}

}  // namespace

WrittenEffect write_haptic(const Pattern& pattern, const EffectTarget& target) {
    WrittenEffect written;
    const Shares shares = as_shares(as_curves(pattern, written), target.map, written);
    EmphasisLosses losses;
    const std::vector<HapticPoint> points = points_with(shares, losses);
    for (std::size_t k = 0; k + 1 < shares.taps.size(); ++k) {
        const double length_s = burst_duration_s(target.map, shares.taps[k].frequency);
        const double room_s = shares.taps[k + 1].time_s - shares.taps[k].time_s;
        if (room_s < length_s * (1.0 - 1e-9)) ++losses.cut;
    }
    remark_emphases(losses, target.map, written.remarks);
    if (points.back().emphasis) {
        written.remarks.push_back("its player holds it 0.1 s longer for the transient at its end");
    }
    written.text = printed(haptic_json(target, points, shares));
    return written;
}

}  // namespace tact
