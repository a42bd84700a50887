#include "model/export/exported_set.h"

#include <algorithm>
#include <iterator>

#include "model/algebra/one_pattern.h"
#include "model/common/parallel.h"
#include "model/io/formats/read_effects.h"
#include "model/io/formats/samples/samples.h"
#include "model/set/layers.h"

namespace tact {

namespace {

Expected<Effect> pair_back(const WrittenEffect& written, const std::string& name,
                           const ExportTarget& target) {
    const TargetTraits& format = traits(target.format);
    auto first = read_effects(written.text, name + format.ending, target.map);
    if (!first) return first.error();
    const auto second = read_effects(written.beside, name + format.beside, target.map);
    if (!second) return second.error();
    auto pair = format.join(*first, *second);
    if (!pair) return Error{"expected a pair, the files are two effects"};
    return std::move(pair->effects.front());
}

Expected<Effect> read_back(const WrittenEffect& written, const std::string& name,
                           const ExportTarget& target) {
    const TargetTraits& format = traits(target.format);
    const std::string path = name + format.ending;
    if (format.read_back != nullptr) {
        Budget budget;
        return format.read_back(written, {path, name, target.map, budget});
    }
    if (format.join != nullptr) return pair_back(written, name, target);
    auto read = read_effects(written.text, path, target.map);
    if (!read) return read.error();
    if (read->effects.empty()) return Error{path + ": expected an effect, found none"};
    return std::move(read->effects.front());
}

// What is read in the place of a format that has no reader.
WrittenEffect readable(const Pattern& pattern, const WrittenEffect& written,
                       const EffectTarget& effect, TargetFormat format) {
    const WriteEffect write_readable = traits(format).write_readable;
    if (write_readable == nullptr) return written;
    return write_readable(with_drawn_pitches(pattern), effect);
}

void add(std::vector<std::string>& remarks, std::vector<std::string> more) {
    std::ranges::move(more, std::back_inserter(remarks));
}

Pattern silence_like(const Pattern& pattern) {
    Pattern silence;
    silence.duration_s = pattern.duration_s;
    silence.amplitude_g = 0.0;
    return silence;
}

bool is_silent(const Pattern& pattern) { return !(peak_g(render(pattern)) > 0.0); }

ExportedPattern effect_exported(const Pattern& pattern, const std::string& name,
                                const ExportTarget& target, const std::string& date) {
    const EffectTarget effect{name, target.map, date, {}};
    WrittenEffect written = write_effect(target.format, pattern, effect);
    auto back = read_back(readable(pattern, written, effect, target.format), name, target);
    ExportedPattern result{std::move(written.text), std::move(written.beside), {}, {}, {}};
    std::vector<std::string>& remarks = result.remarks;
    if (back) {
        for (const std::string& remark : back->remarks) {
            // Nothing is lost of a pattern that was silent before.
            if (remark.starts_with("it is silent") && is_silent(pattern)) continue;
            remarks.push_back("as it is read back: " + remark);
        }
    }
    result.back = back ? std::move(back->pattern) : silence_like(pattern);
    result.error = envelope_error(pattern, std::get<Pattern>(result.back));
    if (is_lossy(*result.error)) add(remarks, std::move(written.coarse));
    add(remarks, std::move(written.remarks));
    add(remarks, words_of(*result.error));
    if (!back) remarks.push_back("nothing of it comes back: " + back.error().message);
    return result;
}

// Beds that sound at once, each with what it loses under its name.
ExportedPattern beds_exported(const LayeredPattern& meant, const std::vector<PlacedBed>& beds,
                              const std::string& name, const ExportTarget& target,
                              const std::string& date) {
    std::vector<Pattern> patterns;
    for (const PlacedBed& bed : beds) patterns.push_back(bed.pattern);
    WrittenEffect written =
        traits(target.format).write_at_once(patterns, {name, target.map, date, {}});
    auto back = read_back(written, name, target);
    ExportedPattern result{std::move(written.text), {}, {}, {}, {}};
    std::vector<std::string>& remarks = result.remarks;
    add(remarks, std::move(written.remarks));
    for (const PlacedBed& bed : beds) {
        for (const std::string& remark : bed.remarks) remarks.push_back(bed.name + ": " + remark);
    }
    if (!back || back->layers.size() != beds.size()) {
        const Pattern one = back ? back->pattern : silence_like(patterns.front());
        result.error = envelope_error(as_one_pattern(meant).pattern, one);
        add(remarks, words_of(*result.error));
        remarks.push_back(back ? "its " + std::to_string(beds.size()) +
                                     " layers come back as fewer, as some have one course"
                               : "nothing of it comes back: " + back.error().message);
        result.back = one;
        if (back && !back->layers.empty()) result.back = layers_of(std::move(back->layers));
        return result;
    }
    for (std::size_t k = 0; k < beds.size(); ++k) {
        const EnvelopeError error = envelope_error(beds[k].pattern, back->layers[k]);
        for (const std::string& words : words_of(error)) {
            remarks.push_back(beds[k].name + ": " + words);
        }
        if (!result.error || error.error_db > result.error->error_db) result.error = error;
    }
    LayeredPattern layered = layers_of(std::move(back->layers));
    for (std::size_t k = 0; k < beds.size(); ++k) layered.layers[k].name = beds[k].name;
    result.back = std::move(layered);
    return result;
}

ExportedPattern samples_exported(const Vibration& vibration, const ExportTarget& target) {
    const EffectTarget samples{vibration.name, {}, {}, target.sampled};
    const TargetTraits& format = traits(target.format);
    WrittenEffect written =
        format.write_samples(waveform_of(vibration, target.sampled.rate_hz), samples);
    auto back = format.read_samples(written, vibration.name + format.ending, samples);
    ExportedPattern result{
        std::move(written.text), std::move(written.beside), std::move(written.remarks), {}, {}};
    const auto* recording = std::get_if<Measurement>(&vibration.source);
    Measurement measurement = recording != nullptr ? *recording : Measurement{};
    measurement.synthetic = is_synthetic(vibration);
    if (!back) {
        result.remarks.push_back("nothing of it comes back: " + back.error().message);
        const std::size_t length = waveform_of(vibration).samples_g.size();
        back = Recording{{kModelRateHz, std::vector<double>(length)}, 1.0, {}};
    }
    for (const std::string& remark : back->remarks) {
        result.remarks.push_back("as it is read back: " + remark);
    }
    measurement.waveform = std::make_shared<const Waveform>(std::move(back->waveform));
    result.back = std::move(measurement);
    return result;
}

}  // namespace

bool is_held(const Vibration& vibration, TargetFormat format) {
    return is_sampled(format) || !std::holds_alternative<Measurement>(vibration.source);
}

ExportedPattern exported(const Pattern& pattern, const std::string& name,
                         const ExportTarget& target, const std::string& date) {
    Vibration vibration;
    vibration.name = name;
    vibration.source = pattern;
    return exported(vibration, target, date);
}

ExportedPattern exported(const Vibration& vibration, const ExportTarget& target,
                         const std::string& date) {
    if (is_sampled(target.format)) return samples_exported(vibration, target);
    if (const auto* layered = std::get_if<LayeredPattern>(&vibration.source)) {
        if (traits(target.format).write_at_once != nullptr) {
            const std::vector<PlacedBed> beds = as_placed_beds(*layered);
            if (!beds.empty()) {
                return beds_exported(*layered, beds, vibration.name, target, date);
            }
        }
        const OnePattern one = as_one_pattern(*layered);
        ExportedPattern result = effect_exported(one.pattern, vibration.name, target, date);
        result.remarks.insert(result.remarks.begin(), one.remarks.begin(), one.remarks.end());
        return result;
    }
    return effect_exported(std::get<Pattern>(vibration.source), vibration.name, target, date);
}

ExportTarget with_full_scale(ExportTarget target, const PatternSet& set, int threads,
                             std::stop_token stop) {
    SampledAs& as = target.sampled;
    if (target.format != TargetFormat::wav || as.full_scale_g > 0.0) return target;
    std::vector<double> peaks_g(set.vibrations.size());
    parallel_for(peaks_g.size(), threads, stop, [&](std::size_t k) {
        peaks_g[k] = peak_g(waveform_of(set.vibrations[k], as.rate_hz));
    });
    const double loudest_g = peaks_g.empty() ? 0.0 : std::ranges::max(peaks_g);
    as.full_scale_g = full_scale_of(loudest_g, as.encoding);
    return target;
}

std::optional<ExportedSet> exported_set(const PatternSet& set, const ExportTarget& target,
                                        int threads, std::stop_token stop,
                                        const std::string& date) {
    ExportedSet result{with_full_scale(target, set, threads, stop), {}, set, 0};
    result.patterns.resize(set.vibrations.size());
    const bool all = parallel_for(set.vibrations.size(), threads, stop, [&](std::size_t k) {
        const Vibration& one = set.vibrations[k];
        if (is_held(one, target.format)) result.patterns[k] = exported(one, result.target, date);
    });
    if (!all) return std::nullopt;
    for (std::size_t k = 0; k < result.patterns.size(); ++k) {
        if (result.patterns[k]) {
            result.back.vibrations[k].source = result.patterns[k]->back;
        } else {
            ++result.recordings;
        }
    }
    return result;
}

}  // namespace tact
