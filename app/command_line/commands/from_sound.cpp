// tactspace from-sound: sounds as patterns for an actuator.

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "model/io/folders/path_json.h"
#include "model/io/set/set_file.h"
#include "model/sound/from_sound.h"
#include "model/text/json_fields.h"
#include "model/text/shown_text.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

// One pattern, and the file that it came from.
struct MadeOfSound {
    std::string file;
    FromSound sound;
};

std::string text_of(const std::vector<MadeOfSound>& all) {
    std::string text;
    for (const MadeOfSound& one : all) {
        text += shown_text(one.sound.vibration.name);
        for (const std::string& remark : one.sound.remarks) {
            text += (&remark == &one.sound.remarks.front() ? ": " : "; ") + remark;
        }
        text += "\n";
    }
    return text;
}

nlohmann::json json_of(const MadeOfSound& one, const std::string& actuator) {
    const FromSound& sound = one.sound;
    const SoundPattern& made = sound.made;
    nlohmann::json fields = {{"name", sound.vibration.name},
                             {"sound", path_json(one.file)},
                             {"actuator", actuator},
                             {"full_scale_g", sound.full_scale_g},
                             {"duration_s", made.pattern.duration_s},
                             {"accents", made.pattern.transients.size()},
                             {"outside_share", made.outside_share},
                             {"other_share", made.other_share},
                             {"amplitude_error_g", made.amplitude_error_g},
                             {"frequency_error_hz", made.frequency_error_hz},
                             {"frequency_is_a_guess", made.frequency_is_a_guess},
                             {"remarks", sound.remarks}};
    if (sound.moved) {
        fields["pm"] = {{"yardstick", sound.moved->yardstick},
                        {"section_s", sound.moved->section_s},
                        {"sections", sound.moved->pm},
                        {"closest_pair", sound.moved->closest_pm},
                        {"farthest_pair", sound.moved->farthest_pm}};
    }
    return fields;
}

}  // namespace

Expected<Done> run(const FromSoundCommand& command) {
    FromSoundOptions options;
    if (!command.actuator.empty()) {
        auto actuator = actuator_named(command.actuator);
        if (!actuator) return actuator.error();
        options.actuator = *std::move(actuator);
    }
    options.accents = !command.no_accents;
    options.full_scale_g = command.full_scale_g;
    options.without_pm = command.without_loss;
    options.threads = command.threads;
    if (const auto fine = writable_result(command.out); !fine) return fine;
    PatternSet set;
    set.name = valid_utf8(command.sounds.front().stem().string());
    std::vector<MadeOfSound> all;
    for (const auto& path : command.sounds) {
        auto made = from_sound(path, options);
        if (!made) return made.error();
        made->vibration.name = unused_name(set, made->vibration.name);
        set.vibrations.push_back(made->vibration);
        all.push_back({path.string(), *std::move(made)});
    }
    set.duration_s = longest_s(set);
    const auto written = write_set_file(command.out, set);
    if (!written) return written;
    return write_result({}, [&](std::ostream& stream) {
        if (!command.json) {
            stream << text_of(all);
            return;
        }
        nlohmann::json list = nlohmann::json::array();
        for (const MadeOfSound& one : all) list.push_back(json_of(one, options.actuator.name));
        stream << text_of_json(list) << "\n";
    });
}

}  // namespace tact
