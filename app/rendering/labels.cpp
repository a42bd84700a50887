#include "app/rendering/labels.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <variant>

#include "app/rendering/rendered_set.h"
#include "model/set/layers.h"
#include "model/study/ratings.h"
#include "model/text/shown_text.h"

namespace tact {

bool has_synthetic_patterns(const PatternSet& set) {
    return std::ranges::any_of(set.vibrations, is_synthetic);
}

std::string sentence_on(const RenderedBy& by) {
    return "the patterns " + words_on(by) + ": " + strength_words(by);
}

std::string sentence_on(const ExportTarget& target) {
    const bool sampled = is_sampled(target.format);
    return "the patterns " + words_on(target) + ": " +
           (sampled ? meaning_of(target) : target.map.source);
}

std::vector<std::string> lines_of(const Labels& labels) {
    std::vector<std::string> lines;
    if (labels.exported) lines.push_back(sentence_on(*labels.exported));
    if (labels.by) lines.push_back(sentence_on(*labels.by));
    if (labels.only != Side::both) {
        lines.push_back(std::string("only the ") +
                        kSideNames[static_cast<std::size_t>(labels.only)] + " patterns");
    }
    NumberMark mark = labels.mark;
    if (labels.by) mark.uncalibrated = false;  // its sentence has said so
    const bool has_names = mark.stale && !labels.edited.empty();
    mark.stale = mark.stale && !has_names;
    for (std::string& line : sentences_of(mark)) lines.push_back(std::move(line));
    if (has_names) {
        lines.push_back(corner_text({.stale = true}) + "; " + words_on_edited(labels.edited));
    }
    if (!labels.gone.empty()) lines.push_back(words_on_gone(labels.gone));
    return lines;
}

std::string text_of(const Labels& labels) {
    std::string text;
    for (const std::string& line : lines_of(labels)) text += shown_text(line) + "\n";
    return text;
}

std::string corner_of(const Labels& labels) {
    std::string corner;
    for (const std::string& line : lines_of({.mark = labels.mark, .edited = labels.edited})) {
        corner += (corner.empty() ? "" : "; ") + line;
    }
    return corner;
}

NumberMark mark_of(const ModelOrigin& origin) { return {.synthetic_model = origin.synthetic}; }

NumberMark mark_of(const PatternSet& set) {
    return mark_of(set.model_origin) |
           NumberMark{.synthetic_patterns = has_synthetic_patterns(set)};
}

void add_labels(nlohmann::json& json, const Labels& labels) {
    const NumberMark& mark = labels.mark;
    json["synthetic_patterns"] = mark.synthetic_patterns;
    json["synthetic_model"] = mark.synthetic_model;
    if (mark.synthetic) json["synthetic"] = true;
    if (mark.rehearsal) json["rehearsal"] = true;
    if (mark.left_out > 0) json["people_left_out"] = mark.left_out;
    if (mark.rehearsals > 0) json["rehearsals_left_out"] = mark.rehearsals;
    if (mark.stale) json["changed_since_felt"] = true;
    if (!labels.edited.empty()) json["edited_since_felt"] = labels.edited;
    if (!labels.gone.empty()) json["gone_since_felt"] = labels.gone;
    if (labels.only != Side::both) {
        json["only"] = kSideNames[static_cast<std::size_t>(labels.only)];
    }
    if (!labels.actuators.empty()) json["actuators"] = labels.actuators;
    if (labels.exported) {
        json["exported_as"] = traits(labels.exported->format).key;
        if (is_sampled(labels.exported->format)) {
            json["exported_rate_hz"] = labels.exported->sampled.rate_hz;
        } else {
            json["exported_onto"] = labels.exported->map.name;
            json["exported_onto_source"] = labels.exported->map.source;
        }
    }
    if (!labels.by) return;
    json["rendered_by"] = traits(labels.by->kind).key;
    json["calibrated"] = is_calibrated(*labels.by);
    if (!is_calibrated(*labels.by)) json["full_scale_g"] = labels.by->full_scale_g;
    json["level"] = labels.by->level;
}

}  // namespace tact
