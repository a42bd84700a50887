#include "model/export/exported_set.h"

#include "model/common/parallel.h"
#include "model/export/openxr_back.h"
#include "model/io/effects/read_effects.h"

namespace tact {

namespace {

Expected<Effect> read_back(const WrittenEffect& written, const std::string& name,
                           const ExportTarget& target) {
    const std::string path = name + traits(target.format).ending;
    if (target.format == TargetFormat::openxr) {
        return openxr_back(written.text, {path, name, target.map});
    }
    auto read = read_effects(written.text, path, target.map);
    if (!read) return read.error();
    if (read->effects.empty()) return Error{path + ": expected an effect, there is none"};
    return std::move(read->effects.front());
}

// What is read in the place of a format that has no reader.
WrittenEffect readable(const Pattern& pattern, const WrittenEffect& written,
                       const EffectTarget& effect, TargetFormat format) {
    if (format != TargetFormat::android_kotlin) return written;
    return write_effect(TargetFormat::android_xml, pattern, effect);
}

Pattern silence_like(const Pattern& pattern) {
    Pattern silence;
    silence.duration_s = pattern.duration_s;
    silence.amplitude_g = 0.0;
    return silence;
}

}  // namespace

ExportedPattern exported(const Pattern& pattern, const std::string& name,
                         const ExportTarget& target, const std::string& date) {
    const EffectTarget effect{name, target.map, date};
    WrittenEffect written = write_effect(target.format, pattern, effect);
    auto back = read_back(readable(pattern, written, effect, target.format), name, target);
    ExportedPattern result{std::move(written.text), std::move(written.remarks), {}};
    if (!back) {
        result.remarks.push_back("nothing of it comes back: " + back.error().message);
        result.back = silence_like(pattern);
        return result;
    }
    for (std::string& remark : back->remarks) {
        result.remarks.push_back("as it is read back: " + std::move(remark));
    }
    result.back = std::move(back->pattern);
    return result;
}

std::optional<ExportedSet> exported_set(const PatternSet& set, const ExportTarget& target,
                                        int threads, std::stop_token stop,
                                        const std::string& date) {
    ExportedSet result{{}, set, 0};
    result.patterns.resize(set.vibrations.size());
    const bool all = parallel_for(set.vibrations.size(), threads, stop, [&](std::size_t k) {
        const Vibration& one = set.vibrations[k];
        const auto* pattern = std::get_if<Pattern>(&one.source);
        if (pattern != nullptr) result.patterns[k] = exported(*pattern, one.name, target, date);
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
