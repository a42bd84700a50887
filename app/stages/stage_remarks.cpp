#include "app/stages/stage_remarks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/physiology/firing.h"
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

// "Meissner 11.5, Pacinian 2": of types that fire more often than a fibre does.
std::string many_a_cycle(const LiveStages& live) {
    std::string text;
    for (const Receptor receptor : kReceptors) {
        if (only_leaks(live, receptor)) continue;
        const double times = impulses_a_cycle(live.neural, receptor);
        if (times <= kManyACycle) continue;
        text += std::string(text.empty() ? "" : ", ") + traits(receptor).name + " " +
                significant(times, 2);
    }
    return text;
}

// "Merkel 391 of 872": impulses that are fired where nothing moves.
std::string in_silence(const LiveStages& live) {
    std::string text;
    for (const Receptor receptor : kReceptors) {
        const auto [silent, all] =
            silent_firing(live.waveform, live.neural.channel[index_of(receptor)]);
        if (silent == 0) continue;
        text += std::string(text.empty() ? "" : ", ") + traits(receptor).name + " " +
                std::to_string(silent) + " of " + std::to_string(all);
    }
    return text;
}

std::string joined(const std::string& first, const std::string& second) {
    return first + (first.empty() || second.empty() ? "" : " ") + second;
}

std::string spike_text(const LiveStages& live) {
    std::string text = leak_text(live, true);
    if (const std::string many = many_a_cycle(live); !many.empty()) {
        text = joined(text, "Impulses a cycle: " + many +
                                ". A fibre fires about one; the model\u2019s rate knows no "
                                "cycles.");
    }
    const std::string silent = in_silence(live);
    if (silent.empty()) return text;
    return joined(text, "Paler: fired in silence, where the filters ring on (" + silent + ").");
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

std::string ring_text(const LiveStages& live) {
    const std::string silent = in_silence(live);
    if (silent.empty()) return {};
    return "What is sent in silence answers to filters that ring on (" + silent + " impulses).";
}

std::string on_text(const LiveStages& live) {
    const std::string on = shares_text(live, share_on);
    if (on.empty()) return {};
    return "Made of gates: on " + on + " of the time.";
}

}  // namespace

bool only_leaks(const LiveStages& live, Receptor receptor) {
    return only_leaks(live.waveform, live.neural, receptor);
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

std::string short_remark(const LiveStages& live, Stage stage) {
    std::string text;
    if (stage != Stage::spikes && stage != Stage::receptors) return text;
    for (const Receptor receptor : kReceptors) {
        if (!only_leaks(live, receptor) || !fires_at_all(live, receptor)) continue;
        text += std::string(text.empty() ? "" : "; ") + traits(receptor).name + ": filter leak";
    }
    const std::string many = stage == Stage::spikes ? many_a_cycle(live) : std::string();
    if (many.empty()) return text;
    return text + (text.empty() ? "" : "; ") + many + " a cycle";
}

std::string stage_remark(const LiveStages& live, Stage stage) {
    switch (stage) {
        case Stage::filtered:
            return leak_text(live, false);
        case Stage::spikes:
            return spike_text(live);
        case Stage::receptors: {
            const std::string beyond = beyond_text(live);
            return beyond.empty() ? leak_text(live, true) : beyond;
        }
        case Stage::networks:
            return gate_text(live);
        case Stage::central:
            return joined(gate_text(live), ring_text(live));
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
