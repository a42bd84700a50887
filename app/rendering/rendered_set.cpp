#include "app/rendering/rendered_set.h"

#include <memory>
#include <utility>
#include <vector>

#include "devices/rumble/actuator_kind.h"
#include "model/common/parallel.h"
#include "model/set/layers.h"
#include "model/text/numbers.h"
#include "viz/drawing/plot.h"

namespace tact {

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

// Nobody has measured any (devices/rumble/motor_envelope.h, on_off_motor.h).
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

}  // namespace tact
