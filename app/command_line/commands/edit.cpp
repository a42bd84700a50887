// tactspace edit: patterns made of patterns.

#include <iostream>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "app/rendering/rendering.h"
#include "model/io/set/measured_files.h"
#include "model/io/set/set_file.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// Those that cannot be edited are told, where no pattern is named.
Expected<PatternSet> edited_set(const EditCommand& command, const PatternSet& set) {
    if (!command.as.empty()) {
        return with_edited_copy(set, command.patterns.front(), command.edits, command.as);
    }
    if (!command.patterns.empty()) return with_edits(set, command.patterns, command.edits);
    Expected<EditedSet> all = with_edits_of_all(set, command.edits);
    if (!all) return all.error();
    for (const std::string& one : all->left) {
        std::cerr << "tactspace: left as it was: " << one << "\n";
    }
    return std::move(all->set);
}

// The patterns of the result that were not in the set as they are now.
std::vector<const Vibration*> changed(const PatternSet& before, const PatternSet& after) {
    std::vector<const Vibration*> list;
    for (const Vibration& vibration : after.vibrations) {
        const auto place = place_named(before, vibration.name);
        if (!place || before.vibrations[*place].source != vibration.source) {
            list.push_back(&vibration);
        }
    }
    return list;
}

std::string rhythm_words(const Pattern& pattern) {
    if (pattern.rhythm.text.empty()) return "";
    constexpr std::size_t kShown = 32;
    const std::string& text = pattern.rhythm.text;
    return text.substr(0, kShown) + (text.size() > kShown ? "..., " : ", ") +
           significant_digits(pattern.rhythm.unit_s, 6) + " s a step";
}

// "2 layers", "recording": of what is no pattern made of parameters.
std::string kind_words(const Vibration& vibration) {
    const auto* layered = std::get_if<LayeredPattern>(&vibration.source);
    if (layered == nullptr) return "recording";
    return counted(layered->layers.size(), "layer", "layers");
}

std::string text_of(const std::vector<const Vibration*>& all) {
    std::vector<TextRow> rows{{"pattern", "s", "points", "ticks", "rhythm"}};
    for (const Vibration* vibration : all) {
        const auto* pattern = std::get_if<Pattern>(&vibration->source);
        if (pattern == nullptr) {
            rows.push_back({vibration->name, significant_digits(own_duration_s(*vibration), 6), "",
                            "", kind_words(*vibration)});
            continue;
        }
        const std::size_t points =
            pattern->amplitude_curve.size() + pattern->frequency_curve.size();
        rows.push_back({vibration->name, significant_digits(pattern->duration_s, 6),
                        std::to_string(points), std::to_string(pattern->transients.size()),
                        rhythm_words(*pattern)});
    }
    return aligned(rows);
}

nlohmann::json json_of(const std::vector<const Vibration*>& all) {
    nlohmann::json list = nlohmann::json::array();
    for (const Vibration* vibration : all) {
        const auto* pattern = std::get_if<Pattern>(&vibration->source);
        if (pattern == nullptr) {
            const auto* layered = std::get_if<LayeredPattern>(&vibration->source);
            list.push_back({{"pattern", vibration->name},
                            {"duration_s", own_duration_s(*vibration)},
                            {"layers", layered == nullptr ? 0 : layered->layers.size()},
                            {"recording", layered == nullptr}});
            continue;
        }
        list.push_back({{"pattern", vibration->name},
                        {"duration_s", pattern->duration_s},
                        {"amplitude_g", pattern->amplitude_g},
                        {"amplitude_points", pattern->amplitude_curve.size()},
                        {"frequency_points", pattern->frequency_curve.size()},
                        {"transients", pattern->transients.size()},
                        {"rhythm", pattern->rhythm.text},
                        {"rhythm_unit_s", pattern->rhythm.unit_s}});
    }
    return list;
}

}  // namespace

Expected<Done> run(const EditCommand& command) {
    if (const auto writable = writable_result(command.out); !writable) return writable;
    const Expected<PatternSet> set = load_as_meant(command.common);
    if (!set) return set.error();
    Expected<PatternSet> result = edited_set(command, *set);
    if (!result) return result.error();
    const Expected<Done> stored = store_measurements(*result, command.out, {});
    if (!stored) return stored;
    const Expected<Done> written = write_set_file(command.out, *result);
    if (!written) return written;
    const std::vector<const Vibration*> all = changed(*set, *result);
    const Labels labels{.mark = mark_of(*result)};
    return write_result({}, [&](std::ostream& stream) {
        if (!command.common.json) {
            stream << text_of(labels) << text_of(all);
            return;
        }
        nlohmann::json json{{"changed", json_of(all)}};
        add_labels(json, labels);
        stream << text_of_json(json) << "\n";
    });
}

}  // namespace tact
