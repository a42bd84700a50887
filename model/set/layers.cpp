#include "model/set/layers.h"

#include <algorithm>

#include "model/pattern/accents.h"
#include "model/signal/resample.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

Waveform carriers_of(const Layer& layer, double rate_hz) {
    if (const auto* pattern = std::get_if<Pattern>(&layer.source)) {
        return pattern->accents == Accents::added ? render(*pattern, rate_hz)
                                                  : render_carriers(*pattern, rate_hz);
    }
    return resampled(*std::get<Measurement>(layer.source).waveform, rate_hz);
}

// They sound to their end, where other layers last as long.
void add_transients(std::vector<Transient>& all, const Layer& layer) {
    const auto* pattern = std::get_if<Pattern>(&layer.source);
    if (pattern == nullptr || pattern->accents == Accents::added) return;
    for (Transient one : pattern->transients) {
        one.time_s += layer.offset_s;
        one.amplitude_g *= layer.gain;
        all.push_back(one);
    }
}

}  // namespace

bool sounds(const LayeredPattern& layered, std::size_t k) {
    const bool any_solo = std::ranges::any_of(layered.layers, &Layer::solo);
    return any_solo ? layered.layers[k].solo : !layered.layers[k].mute;
}

double duration_s(const Layer& layer) {
    if (const auto* pattern = std::get_if<Pattern>(&layer.source)) return pattern->duration_s;
    return duration_s(*std::get<Measurement>(layer.source).waveform);
}

double duration_s(const LayeredPattern& layered) {
    double end_s = 0.0;
    for (const Layer& layer : layered.layers) {
        end_s = std::max(end_s, layer.offset_s + duration_s(layer));
    }
    return end_s;
}

Waveform render(const LayeredPattern& layered, double rate_hz) {
    Waveform sum{rate_hz, std::vector<double>(sample_count(duration_s(layered), rate_hz))};
    std::vector<Transient> transients;
    for (std::size_t k = 0; k < layered.layers.size(); ++k) {
        if (!sounds(layered, k)) continue;
        const Layer& layer = layered.layers[k];
        const Waveform own = carriers_of(layer, rate_hz);
        const std::size_t first = sample_count(layer.offset_s, rate_hz);
        for (std::size_t n = 0; n < own.samples_g.size(); ++n) {
            if (first + n >= sum.samples_g.size()) break;
            sum.samples_g[first + n] += layer.gain * own.samples_g[n];
        }
        add_transients(transients, layer);
    }
    add_accents(sum, std::move(transients));
    return sum;
}

std::string fault_of(const LayeredPattern& layered) {
    const std::size_t count = layered.layers.size();
    if (count < 1 || count > limits::kMaxLayers) {
        return "expected 1 to " + std::to_string(limits::kMaxLayers) + " layers, got " +
               std::to_string(count);
    }
    const double length_s = duration_s(layered);
    if (limits::kDurationS.contains(length_s)) return {};
    return "expected layers that end within " + shortest_digits(limits::kDurationS.high) +
           " s, the last ends at " + significant_digits(length_s, 6) + " s";
}

std::string name_of(const LayeredPattern& layered, std::size_t k) {
    const std::string& name = layered.layers[k].name;
    return name.empty() ? "layer " + std::to_string(k + 1) : name;
}

std::vector<Measurement*> recordings_in(Vibration& vibration) {
    std::vector<Measurement*> all;
    if (auto* measurement = std::get_if<Measurement>(&vibration.source)) all.push_back(measurement);
    if (auto* layered = std::get_if<LayeredPattern>(&vibration.source)) {
        for (Layer& layer : layered->layers) {
            if (auto* own = std::get_if<Measurement>(&layer.source)) all.push_back(own);
        }
    }
    return all;
}

std::vector<const Measurement*> recordings_in(const Vibration& vibration) {
    std::vector<const Measurement*> all;
    if (const auto* measurement = std::get_if<Measurement>(&vibration.source)) {
        all.push_back(measurement);
    }
    if (const auto* layered = std::get_if<LayeredPattern>(&vibration.source)) {
        for (const Layer& layer : layered->layers) {
            if (const auto* own = std::get_if<Measurement>(&layer.source)) all.push_back(own);
        }
    }
    return all;
}

bool is_synthetic(const Vibration& vibration) {
    return std::ranges::any_of(recordings_in(vibration), &Measurement::synthetic);
}

std::vector<const Pattern*> patterns_in(const Vibration& vibration) {
    std::vector<const Pattern*> all;
    if (const auto* pattern = std::get_if<Pattern>(&vibration.source)) all.push_back(pattern);
    if (const auto* layered = std::get_if<LayeredPattern>(&vibration.source)) {
        for (const Layer& layer : layered->layers) {
            if (const auto* own = std::get_if<Pattern>(&layer.source)) all.push_back(own);
        }
    }
    return all;
}

LayeredPattern as_layers(const VibrationSource& source) {
    if (const auto* layered = std::get_if<LayeredPattern>(&source)) return *layered;
    Layer only;
    if (const auto* pattern = std::get_if<Pattern>(&source)) {
        only.source = *pattern;
    } else {
        only.source = std::get<Measurement>(source);
    }
    return {{std::move(only)}};
}

LayeredPattern layers_of(std::vector<Pattern> patterns) {
    LayeredPattern layered;
    for (Pattern& pattern : patterns) {
        Layer layer;
        layer.source = std::move(pattern);
        layered.layers.push_back(std::move(layer));
    }
    return layered;
}

VibrationSource without_needless_layers(LayeredPattern layered) {
    if (layered.layers.size() != 1) return layered;
    Layer& only = layered.layers.front();
    const bool plain = only.gain == 1.0 && only.offset_s == 0.0 && sounds(layered, 0);
    if (!plain) return layered;
    if (auto* pattern = std::get_if<Pattern>(&only.source)) return std::move(*pattern);
    return std::move(std::get<Measurement>(only.source));
}

Measurement flattened(const LayeredPattern& layered) {
    Measurement sum;
    sum.waveform = std::make_shared<const Waveform>(render(layered));
    Vibration whole;
    whole.source = layered;
    sum.synthetic = is_synthetic(whole);
    return sum;
}

}  // namespace tact
