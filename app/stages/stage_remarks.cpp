#include "app/stages/stage_remarks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "viz/drawing/plot.h"
#include "viz/skin/fingertip.h"

namespace tact {

namespace {

double peak_of(std::span<const double> samples) {
    double peak = 0.0;
    for (const double sample : samples) peak = std::max(peak, std::abs(sample));
    return peak;
}

template <class Is>
double share_of_steps(const LiveStages& live, Receptor receptor, Is is) {
    const std::vector<double>& counts = live.central_count[index_of(receptor)];
    if (counts.empty()) return 0.0;
    const auto hits = std::ranges::count_if(counts, is);
    return static_cast<double>(hits) / static_cast<double>(counts.size());
}

bool fires_at_all(const LiveStages& live, Receptor receptor) {
    for (const std::vector<int>& train : live.neural.channel[index_of(receptor)].spike_count) {
        if (std::ranges::any_of(train, [](int count) { return count > 0; })) return true;
    }
    return false;
}

// "Meissner 99 %, Pacinian 99 %": of types that send anything.
std::string shares_text(const LiveStages& live, double (*share)(const LiveStages&, Receptor)) {
    std::string text;
    for (const Receptor receptor : kReceptors) {
        const double part = share(live, receptor);
        if (part <= 0.0) continue;
        char one[48];
        std::snprintf(one, sizeof one, "%s%s %.3g %%", text.empty() ? "" : ", ",
                      traits(receptor).name, 100.0 * part);
        text += one;
    }
    return text;
}

std::string leak_text(const LiveStages& live, bool fires) {
    for (const Receptor receptor : kReceptors) {
        if (!only_leaks(live, receptor) || (fires && !fires_at_all(live, receptor))) continue;
        const double peak_g = peak_of(live.neural.channel[index_of(receptor)].filtered_g);
        const std::string name = traits(receptor).name;
        const std::string leak =
            "what its filter leaks, and how it rings where the vibration "
            "begins and ends";
        if (fires) {
            return "What " + name + " fires here answers to " + leak +
                   ": the model\u2019s doing, not the skin\u2019s.";
        }
        return name + ": nothing in its band. The " + significant(peak_g, 2) + " g are " + leak +
               ": the model\u2019s doing, not the skin\u2019s.";
    }
    return {};
}

std::string beyond_text(const LiveStages& live) {
    std::string text;
    for (const Receptor receptor : kReceptors) {
        const std::size_t beyond = beyond_finger(live, receptor);
        if (beyond == 0) continue;
        text += (text.empty() ? "" : ", ") + std::to_string(beyond) + " " + traits(receptor).name;
    }
    if (text.empty()) return {};
    return "Grey: " + text + " beyond the finger\u2019s edge, which the model counts all the same.";
}

std::string gate_text(const LiveStages& live) {
    const std::string cap = shares_text(live, share_at_cap);
    if (cap.empty()) return {};
    return "A gate, nearly on or off: at the model\u2019s cap of " +
           std::to_string(live.request.model.coding.spike_cap) + " in 5 ms " + cap +
           " of the time.";
}

std::string on_text(const LiveStages& live) {
    const std::string on = shares_text(live, share_on);
    if (on.empty()) return {};
    return "Made of gates: on " + on + " of the time.";
}

}  // namespace

bool only_leaks(const LiveStages& live, Receptor receptor) {
    const ChannelStages& channel = live.neural.channel[index_of(receptor)];
    const double peak_g = peak_of(channel.filtered_g);
    if (channel.silent || peak_g <= 0.0) return false;
    if (peak_g > kLeakShare * peak_of(live.waveform.samples_g)) return false;
    double in_band_g = 0.0;
    double strongest_g = 0.0;
    for (const Component& component : live.neural.components) {
        strongest_g = std::max(strongest_g, component.amplitude_g);
        const bool in_band = component.frequency_hz >= traits(receptor).low_hz &&
                             component.frequency_hz <= traits(receptor).high_hz;
        if (in_band) in_band_g = std::max(in_band_g, component.amplitude_g);
    }
    return in_band_g <= kLeakShare * strongest_g;
}

double share_on(const LiveStages& live, Receptor receptor) {
    return share_of_steps(live, receptor, [](double count) { return count > 0.0; });
}

double share_at_cap(const LiveStages& live, Receptor receptor) {
    const auto cap = static_cast<double>(live.request.model.coding.spike_cap);
    return share_of_steps(live, receptor, [cap](double count) { return count >= cap; });
}

std::size_t beyond_finger(const LiveStages& live, Receptor receptor) {
    const ReceptorGrid& grid = live.neural.channel[index_of(receptor)].grid;
    return static_cast<std::size_t>(
        std::ranges::count_if(grid.receptors, [&grid](const GridReceptor& receptor_of) {
            return !is_on_fingertip(grid.x_mm(receptor_of), grid.y_mm(receptor_of));
        }));
}

std::string stage_remark(const LiveStages& live, Stage stage) {
    switch (stage) {
        case Stage::filtered:
            return leak_text(live, false);
        case Stage::spikes:
            return leak_text(live, true);
        case Stage::receptors: {
            const std::string beyond = beyond_text(live);
            return beyond.empty() ? leak_text(live, true) : beyond;
        }
        case Stage::networks:
        case Stage::central:
            return gate_text(live);
        case Stage::brain:
            return on_text(live);
        case Stage::spectrum:
            return "Dashed: beyond the band that the paper gives a type, where its curve is our "
                   "extrapolation.";
        case Stage::vibration:
        case Stage::envelope:
            break;
    }
    return {};
}

}  // namespace tact
