#include "app/rendering/rendering.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <memory>
#include <stop_token>
#include <utility>
#include <variant>
#include <vector>

#include "devices/rumble/actuator_kind.h"
#include "model/common/parallel.h"
#include "model/set/layers.h"
#include "model/study/ratings.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "viz/drawing/plot.h"

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

namespace {

// What was made of the same vibration before; null: nothing was.
std::shared_ptr<const Waveform> known(const Vibration& vibration, std::size_t place,
                                      const RenderedBy& by, const RenderedSet* earlier) {
    if (earlier == nullptr || earlier->by != by) return nullptr;
    const auto& before = earlier->intended.vibrations;
    const auto waveform_at = [earlier](std::size_t k) {
        return std::get<Measurement>(earlier->played.vibrations[k].source).waveform;
    };
    if (place < before.size() && before[place].source == vibration.source)
        return waveform_at(place);
    const auto moved = place_named(earlier->intended, vibration.name);
    const bool same = moved && before[*moved].source == vibration.source;
    return same ? waveform_at(*moved) : nullptr;
}

// Nobody has measured any (devices/rumble/motor_envelope.h).
std::string words_on_motors(const RenderedBy& by) {
    const Language language = traits(by.kind).language;
    if (language == Language::on_off) {
        return "; its frequency, and how soon it starts and stops, are guessed";
    }
    const bool has_motors = language == Language::motor_pair || language == Language::intensity;
    return has_motors ? "; how fast its motors turn and how soon is a guess" : "";
}

}  // namespace

std::string words_on(const RenderedBy& by) {
    const std::string level = by.level == 1.0 ? "" : " at a level of " + exact_percent(by.level);
    return std::string("as a ") + traits(by.kind).name + " plays them" + level + ", " +
           (is_calibrated(by) ? "calibrated" : "uncalibrated");
}

std::string strength_words(const RenderedBy& by) {
    if (!is_calibrated(by)) {
        return "full scale stands for " + significant(by.full_scale_g) + " g" + words_on_motors(by);
    }
    const Calibration& made = *by.calibration;
    std::string words = "by the calibration";
    if (!made.actuator.empty()) words += " of " + made.actuator;
    return made.date.empty() ? words : words + ", " + made.date;
}

std::optional<RenderedSet> rendered_set(const PatternSet& set, const RenderedBy& by,
                                        const RenderedSet* earlier,
                                        const RenderSetOptions& options) {
    std::vector<std::shared_ptr<const Waveform>> waveforms(set.vibrations.size());
    const bool all =
        parallel_for(waveforms.size(), options.threads, options.stop, [&](std::size_t k) {
            const Vibration& vibration = set.vibrations[k];
            waveforms[k] = known(vibration, k, by, earlier);
            if (waveforms[k]) return;
            waveforms[k] =
                std::make_shared<const Waveform>(rendering(by, waveform_of(vibration)).waveform);
        });
    if (!all) return std::nullopt;
    RenderedSet made{set, by, set};
    for (std::size_t k = 0; k < waveforms.size(); ++k) {
        Measurement measurement;
        measurement.waveform = std::move(waveforms[k]);
        // A twin stays one, and what was computed stays computed.
        if (const auto* meant = std::get_if<Measurement>(&set.vibrations[k].source)) {
            measurement.measures = meant->measures;
        }
        measurement.synthetic = is_synthetic(set.vibrations[k]);
        made.played.vibrations[k].source = std::move(measurement);
    }
    return made;
}

namespace {

std::optional<LiveRendering> compute_live_rendering(const RenderingRequest& request,
                                                    std::stop_token stop,
                                                    std::atomic<float>& progress) {
    LiveRendering live;
    live.request = request;
    live.intended = waveform_of(request.vibration);
    live.rendering = rendering(request.by, live.intended);
    if (stop.stop_requested()) return std::nullopt;
    progress = 1.0F;
    return live;
}

}  // namespace

void follow_rendering(const Ui& ui, RenderingState& state, const Vibration* vibration) {
    if (!has_jobs(ui) || vibration == nullptr) return;
    RenderingRequest request{*vibration, state.by};
    if (request == state.asked) return;
    state.asked = request;
    state.job.ask(std::move(request), compute_live_rendering, ui.wake, JobPolicy::finish);
}

void take_rendering(RenderingState& state) {
    if (auto answer = state.job.latest()) state.shown = std::move(answer);
}

std::optional<RenderedBy> rendered_by(const RenderingState& state) {
    return state.on ? std::optional(state.by) : std::nullopt;
}

std::string rendered_words(const RenderingState& state) {
    return state.on ? words_on(state.by) : "";
}

}  // namespace tact
