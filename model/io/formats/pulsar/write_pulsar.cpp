// Presets of Pulsar (Software Mansion).
//
// Source    its documentation: times in ms, amplitude and frequency from 0 to 1.

#include <algorithm>
#include <nlohmann/json.hpp>

#include "model/io/effects_out/shares.h"
#include "model/io/effects_out/written_text.h"
#include "model/io/formats/pulsar/pulsar.h"
#include "model/pattern/curves.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

Json preset_points(const AmplitudeCurve& curve) {
    Json points = Json::array();
    for (const AmplitudePoint& point : curve) {
        points.push_back({{"time", 1e3 * point.time_s}, {"value", point.value}});
    }
    return points;
}

// A preset's length is where events begin to end: its last tick sounds on.
void remark_last_tick(const Shares& shares, const ActuatorMap& map,
                      std::vector<std::string>& coarse) {
    double end_s = shares.duration_s;
    for (const TapShares& tap : shares.taps) {
        for (const Transient& burst :
             transients_on(map, tap.time_s, tap.amplitude, tap.frequency)) {
            if (burst.amplitude_g > 0.0) end_s = std::max(end_s, tap.time_s + burst.duration_s);
        }
    }
    if (!(end_s > shares.duration_s + 1e-9)) return;
    coarse.emplace_back("its last tick is whole, and ends behind the preset's length");
}

}  // namespace

WrittenEffect write_pulsar(const Pattern& pattern, const EffectTarget& target) {
    WrittenEffect written;
    const Shares shares = as_shares(as_curves(pattern, written), target.map, written);
    remark_last_tick(shares, target.map, written.coarse);
    Json taps = Json::array();
    for (const TapShares& tap : shares.taps) {
        taps.push_back({{"time", 1e3 * tap.time_s},
                        {"amplitude", tap.amplitude},
                        {"frequency", tap.frequency}});
    }
    const bool continuous = peak_value(shares.amplitude) > 0.0;
    const AmplitudeCurve none;
    written.text = printed(
        {{"name", valid_utf8(target.name)},
         {"description", "written by tactspace"},
         {"tags", Json::array()},
         {"duration", 1e3 * shares.duration_s},
         {"continuousPattern",
          {{"amplitude", preset_points(continuous || taps.empty() ? shares.amplitude : none)},
           {"frequency", preset_points(continuous ? shares.frequency : none)}}},
         {"discretePattern", taps}});
    return written;
}

}  // namespace tact
