#include "model/sound/from_sound.h"

#include <algorithm>

#include "assets/assets.h"
#include "model/io/recordings/sound_file.h"
#include "model/io/set/set_file.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr const char* kYardstick = "sets/pm_2023_twelve.tactspace.json";
constexpr double kNothingG = 1e-4;  // the peak of what nobody feels

std::string name_from(const std::filesystem::path& path) {
    const std::string stem = valid_utf8(path.stem().string());
    return stem.empty() ? "sound" : stem;
}

std::string note_of(const std::string& file, const FromSound& result,
                    const FromSoundOptions& options) {
    std::string note = "From the sound " + file + ", for " + options.actuator.name + ", " +
                       significant_digits(result.full_scale_g, 4) + " g at full scale";
    for (const std::string& remark : result.remarks) note += "; " + remark;
    return note + ".";
}

}  // namespace

Expected<FromSound> from_sound(const std::filesystem::path& path, const FromSoundOptions& options) {
    auto sound = read_sound_file(path);
    if (!sound) return sound.error();
    FromSound result;
    result.full_scale_g =
        options.full_scale_g.value_or(sound->scale_g.value_or(options.actuator.full_scale_g));
    SoundOptions how;
    how.band_hz = options.actuator.frequency_hz;
    how.full_scale_g = result.full_scale_g;
    how.accents = options.accents;
    result.made = pattern_of_sound(sound->waveform, how);
    if (!(peak_g(result.made.felt) > kNothingG * result.full_scale_g * peak_g(sound->waveform))) {
        return Error{path.string() + ": nothing of it lies in the " +
                     significant_digits(how.band_hz.low, 4) + " to " +
                     significant_digits(how.band_hz.high, 4) + " Hz of " + options.actuator.name};
    }
    // At the file's own rate; the curves were made at 10 kHz.
    result.made.pattern = with_duration(std::move(result.made.pattern), sound->duration_s);
    result.remarks = std::move(sound->remarks);
    for (std::string& words : words_of(result.made, how)) {
        result.remarks.push_back(std::move(words));
    }
    if (!options.without_pm && !options.stop.stop_requested()) {
        const auto yardstick = parse_set(asset(kYardstick), kYardstick, {});
        if (!yardstick) return yardstick.error();
        result.moved = sound_moved(result.made.felt, result.made.pattern, *yardstick,
                                   {options.threads, options.stop, options.progress});
        if (result.moved) result.remarks.push_back(words_on(*result.moved));
    }
    if (options.stop.stop_requested()) return Error{path.string() + ": was stopped"};
    result.vibration.name = name_from(path);
    result.vibration.source = result.made.pattern;
    result.vibration.note = note_of(valid_utf8(path.filename().string()), result, options);
    return result;
}

}  // namespace tact
