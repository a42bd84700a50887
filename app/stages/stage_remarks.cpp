#include "app/stages/parts.h"

#include <algorithm>
#include <cmath>

#include "model/physiology/firing.h"
#include "model/text/numbers.h"
#include "model/textbook/textbook.h"
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

bool leaks_impulses(const LiveStages& live, Receptor receptor) {
    return live.firing[index_of(receptor)] == Firing::leaks;
}

bool fires(const LiveStages& live, Receptor receptor) {
    return live.firing[index_of(receptor)] == Firing::fires;
}

// "Meissner 99 %, Pacinian 99 %": types that send anything.
std::string shares_text(const LiveStages& live, double (*share)(const LiveStages&, Receptor)) {
    std::string text;
    for (const Receptor receptor : kReceptors) {
        const double part = share(live, receptor);
        if (part <= 0.0) continue;
        text += std::string(text.empty() ? "" : ", ") + traits(receptor).name + " " +
                percent(part) + (leaks_impulses(live, receptor) ? " (filter leak)" : "");
    }
    return text;
}

std::string leak_text(const LiveStages& live, bool fires) {
    for (const Receptor receptor : kReceptors) {
        if (!live.only_leaks[index_of(receptor)] || (fires && !leaks_impulses(live, receptor)))
            continue;
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

// Impulses a cycle if there are more than a real fibre's; otherwise 0.
double many_times(const LiveStages& live, Receptor receptor) {
    if (!fires(live, receptor)) return 0.0;
    const double times = live.impulses_a_cycle[index_of(receptor)];
    return times > kManyACycle ? times : 0.0;
}

// "Meissner 11.5, Pacinian 2": types that fire more often than a real fibre.
std::string many_a_cycle(const LiveStages& live) {
    std::string text;
    for (const Receptor receptor : kReceptors) {
        const double times = many_times(live, receptor);
        if (times <= 0.0) continue;
        text += std::string(text.empty() ? "" : ", ") + traits(receptor).name + " " +
                significant(times, 2);
    }
    return text;
}

std::string cycles_text(const LiveStages& live) {
    const std::string many = many_a_cycle(live);
    if (many.empty()) return {};
    return "Impulses a cycle: " + many +
           ". A fibre fires about one; the model\u2019s rate knows no cycles.";
}

// If Ruffini's corpuscles fire: how rarely they were found.
std::string ruffini_text(const LiveStages& live) {
    if (!fires(live, Receptor::ruffini)) return {};
    return "Ruffini fires here. " + sentence_of(*fact_named("ruffini found"));
}

// "Merkel 391 of 872": impulses while nothing moves.
std::string in_silence(const LiveStages& live) {
    std::string text;
    for (const Receptor receptor : kReceptors) {
        const auto [silent, all] = live.silent_firing[index_of(receptor)];
        if (silent == 0) continue;
        text += std::string(text.empty() ? "" : ", ") + traits(receptor).name + " " +
                std::to_string(silent) + " of " + std::to_string(all);
    }
    return text;
}

std::string joined(const std::string& first, const std::string& second) {
    return first + (first.empty() || second.empty() ? "" : " ") + second;
}

// Remarks that the textbook's lines repeat; empty if those are shown.
std::string facts_text(const LiveStages& live, bool has_textbook) {
    return has_textbook ? std::string() : joined(cycles_text(live), ruffini_text(live));
}

std::string spike_text(const LiveStages& live, bool has_textbook) {
    const std::string text = joined(leak_text(live, true), facts_text(live, has_textbook));
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
    const auto add = [&](const std::string& more) {
        if (!more.empty()) text += (text.empty() ? "" : "; ") + more;
    };
    for (const Receptor receptor : kReceptors) {
        if (leaks_impulses(live, receptor))
            add(traits(receptor).name + std::string(": filter leak"));
    }
    if (const std::string many = many_a_cycle(live); !many.empty()) add(many + " a cycle");
    if (fires(live, Receptor::ruffini)) add("Ruffini: rare");
    return text;
}

std::string firing_note(const LiveStages& live, Receptor receptor) {
    if (leaks_impulses(live, receptor)) return "filter leak";
    const double times = many_times(live, receptor);
    return times > 0.0 ? significant(times, 2) + " a cycle" : std::string();
}

std::string stage_remark(const LiveStages& live, Stage stage, bool has_textbook) {
    switch (stage) {
        case Stage::filtered:
            return leak_text(live, false);
        case Stage::spikes:
            return spike_text(live, has_textbook);
        case Stage::receptors: {
            const std::string beyond = beyond_text(live);
            return joined(beyond.empty() ? leak_text(live, true) : beyond,
                          facts_text(live, has_textbook));
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
