#include "model/algebra/source_edits.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "model/set/layers.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kSilentShare = 0.01;  // of a recording's peak: -40 dB

Waveform waveform_of_source(const VibrationSource& source) {
    Vibration vibration;
    vibration.source = source;
    return waveform_of(vibration);
}

Waveform trimmed_samples(Waveform waveform) {
    std::vector<double>& samples = waveform.samples_g;
    const double floor_g = kSilentShare * peak_g(waveform);
    const auto sounds = [floor_g](double sample_g) { return std::abs(sample_g) > floor_g; };
    const auto first = std::ranges::find_if(samples, sounds);
    const auto last = std::find_if(samples.rbegin(), samples.rend(), sounds).base();
    if (first < last) samples = std::vector<double>(first, last);
    return waveform;
}

Expected<Waveform> faded_samples(Waveform waveform, double in_s, double out_s) {
    const double length_s = duration_s(waveform);
    const double longest_s = std::max(in_s, out_s);
    if (longest_s > length_s) {
        return Error{"expected at most the recording's " + significant_digits(length_s, 4) +
                     " s, got " + shortest_digits(longest_s) + " s"};
    }
    for (std::size_t n = 0; n < waveform.samples_g.size(); ++n) {
        const double t_s = static_cast<double>(n) / waveform.rate_hz;
        if (in_s > 0.0) waveform.samples_g[n] *= std::min(1.0, t_s / in_s);
        if (out_s > 0.0) waveform.samples_g[n] *= std::min(1.0, (length_s - t_s) / out_s);
    }
    return waveform;
}

Expected<Waveform> normalised_samples(Waveform waveform, double peak) {
    const double now_g = peak_g(waveform);
    if (now_g == 0.0) return Error{"expected a recording that is not silent"};
    for (double& sample_g : waveform.samples_g) sample_g *= peak / now_g;
    return waveform;
}

Expected<Waveform> appended(Waveform first, const Waveform& second, int times) {
    const double whole_s = duration_s(first) + times * duration_s(second);
    if (whole_s > limits::kDurationS.high) {
        return Error{"expected at most " + shortest_digits(limits::kDurationS.high) +
                     " s, it would last " + significant_digits(whole_s, 4) + " s"};
    }
    for (int k = 0; k < times; ++k) {
        first.samples_g.insert(first.samples_g.end(), second.samples_g.begin(),
                               second.samples_g.end());
    }
    return first;
}

Expected<Waveform> edited_samples(const Waveform& waveform, const Edit& edit) {
    switch (edit.kind) {
        case EditKind::reverse: {
            Waveform turned = waveform;
            std::ranges::reverse(turned.samples_g);
            return turned;
        }
        case EditKind::repeat:
            return appended(waveform, waveform, static_cast<int>(edit.number) - 1);
        case EditKind::join:
            return appended(waveform, waveform_of_source(*edit.other), 1);
        case EditKind::trim:
            return trimmed_samples(waveform);
        case EditKind::fade_in:
            return faded_samples(waveform, edit.number, 0.0);
        case EditKind::fade_out:
            return faded_samples(waveform, 0.0, edit.number);
        case EditKind::normalise:
            return normalised_samples(waveform, edit.number);
        default:
            return Error{"expected a pattern made of parameters, got a recording"};
    }
}

bool is_synthetic(const VibrationSource& source) {
    Vibration vibration;
    vibration.source = source;
    return tact::is_synthetic(vibration);
}

Expected<VibrationSource> edited_recording(const Measurement& measurement, const Edit& edit) {
    Expected<Waveform> samples = edited_samples(*measurement.waveform, edit);
    if (!samples) return samples.error();
    Measurement made;
    made.synthetic = measurement.synthetic || (edit.other && is_synthetic(*edit.other));
    made.waveform = std::make_shared<const Waveform>(*std::move(samples));
    return VibrationSource(std::move(made));
}

// All at once: what is there already, and the other one behind its layers.
Expected<VibrationSource> layered_with(LayeredPattern layered, const Edit& edit) {
    LayeredPattern more = as_layers(*edit.other);
    if (more.layers.size() == 1) more.layers[0].name = edit.other_name;
    for (Layer& layer : more.layers) layered.layers.push_back(std::move(layer));
    if (const std::string fault = fault_of(layered); !fault.empty()) return Error{fault};
    return VibrationSource(std::move(layered));
}

// The same edit of each layer that is made of parameters; a recording refuses what it cannot have.
Expected<LayeredPattern> with_each(LayeredPattern layered, const Edit& edit,
                                   const PhysiologyTables& tables) {
    for (std::size_t k = 0; k < layered.layers.size(); ++k) {
        Layer& layer = layered.layers[k];
        const std::string where = "layer \"" + name_of(layered, k) + "\": ";
        if (auto* pattern = std::get_if<Pattern>(&layer.source)) {
            Expected<Pattern> after = edited(*pattern, std::span(&edit, 1), tables);
            if (!after) return Error{where + after.error().message};
            *pattern = *std::move(after);
        } else {
            auto after = edited_recording(std::get<Measurement>(layer.source), edit);
            if (!after) return Error{where + after.error().message};
            layer.source = std::get<Measurement>(*std::move(after));
        }
    }
    return layered;
}

void turn_offsets(LayeredPattern& layered) {
    const double whole_s = duration_s(layered);
    for (Layer& layer : layered.layers) {
        layer.offset_s = std::max(0.0, whole_s - layer.offset_s - duration_s(layer));
    }
}

Expected<LayeredPattern> normalised_layers(LayeredPattern layered, double peak) {
    const double now_g = peak_g(render(layered));
    if (now_g == 0.0) return Error{"expected layers that are not silent"};
    for (std::size_t k = 0; k < layered.layers.size(); ++k) {
        double& gain = layered.layers[k].gain;
        gain *= peak / now_g;
        if (limits::kLayerGain.contains(gain)) continue;
        return Error{"layer \"" + name_of(layered, k) + "\": expected a gain of at most " +
                     shortest_digits(limits::kLayerGain.high) + ", it would be " +
                     significant_digits(gain, 4)};
    }
    return layered;
}

Expected<LayeredPattern> edited_layers(const LayeredPattern& layered, const Edit& edit,
                                       const PhysiologyTables& tables) {
    switch (edit.kind) {
        case EditKind::stretch: {
            auto after = with_each(layered, edit, tables);
            if (after) {
                for (Layer& layer : after->layers) layer.offset_s *= edit.number;
            }
            return after;
        }
        case EditKind::reverse: {
            LayeredPattern turned = layered;
            turn_offsets(turned);
            return with_each(std::move(turned), edit, tables);
        }
        case EditKind::stretch_notes:
        case EditKind::stretch_curves:
        case EditKind::transpose:
        case EditKind::thin:
        case EditKind::find_notes:
            return with_each(layered, edit, tables);
        case EditKind::normalise:
            return normalised_layers(layered, edit.number);
        default:
            return Error{"expected a pattern without layers: edit its layers one by one"};
    }
}

Expected<VibrationSource> with_one(const VibrationSource& source, const Edit& edit,
                                   const PhysiologyTables& tables) {
    const std::string begin = std::string(traits(edit.kind).key) + ": ";
    const auto told = [&begin](const Error& error) { return Error{begin + error.message}; };
    const auto* pattern = std::get_if<Pattern>(&source);
    const bool plain =
        pattern != nullptr && (!edit.other || std::holds_alternative<Pattern>(*edit.other));
    if (plain) {
        Expected<Pattern> after = edited(*pattern, std::span(&edit, 1), tables);
        if (after) return VibrationSource(*std::move(after));
        if (edit.kind != EditKind::mix) return after.error();
    }
    if (edit.kind == EditKind::mix) {
        auto after = layered_with(as_layers(source), edit);
        return after ? after : told(after.error());
    }
    if (const auto* layered = std::get_if<LayeredPattern>(&source)) {
        Expected<LayeredPattern> after = edited_layers(*layered, edit, tables);
        if (!after) return told(after.error());
        if (const std::string fault = fault_of(*after); !fault.empty()) return Error{begin + fault};
        return VibrationSource(*std::move(after));
    }
    // A pattern with a recording or layers behind it is samples from then on.
    Measurement samples;
    if (const auto* recording = std::get_if<Measurement>(&source)) {
        samples = *recording;
    } else {
        samples.waveform = std::make_shared<const Waveform>(waveform_of_source(source));
    }
    auto after = edited_recording(samples, edit);
    return after ? after : told(after.error());
}

}  // namespace

Expected<VibrationSource> edited_source(const Vibration& vibration, std::span<const Edit> edits,
                                        const PhysiologyTables& tables) {
    VibrationSource source = vibration.source;
    for (const Edit& edit : edits) {
        if (const std::string fault = fault_of(edit); !fault.empty()) return Error{fault};
        Expected<VibrationSource> next = with_one(source, edit, tables);
        if (!next) return next.error();
        source = *std::move(next);
    }
    auto* layered = std::get_if<LayeredPattern>(&source);
    if (layered != nullptr && layered->layers[0].name.empty()) {
        layered->layers[0].name = vibration.name;
    }
    return source;
}

}  // namespace tact
