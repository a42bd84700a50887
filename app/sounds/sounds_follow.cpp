#include "app/sounds/sounds_follow.h"

#include <algorithm>
#include <utility>

#include "app/document/editing.h"
#include "app/ui/file_question.h"
#include "model/io/recordings/recording.h"
#include "model/io/recordings/sound_file.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

SoundMade made_of(const fs::path& file, const FromSoundOptions& options) {
    auto sound = from_sound(file, options);
    if (!sound) return {sound.error().message, {}, {}};
    Waveform played = waveform_of(sound->vibration);
    return {{}, *std::move(sound), std::move(played)};
}

std::optional<SoundsAnswer> make_all(const SoundsRequest& request, std::stop_token stop,
                                     std::atomic<float>& progress) {
    SoundsAnswer answer{request, {}};
    const auto count = static_cast<float>(request.files.size());
    FromSoundOptions options;
    options.actuator = bundled_actuator(request.actuator);
    options.accents = request.accents;
    if (request.full_scale_g > 0.0) options.full_scale_g = request.full_scale_g;
    options.without_pm = !request.with_pm;
    options.stop = stop;
    for (const fs::path& file : request.files) {
        const auto before = static_cast<float>(answer.sounds.size());
        options.progress = [&progress, before, count](double share) {
            progress = (before + static_cast<float>(share)) / count;
        };
        answer.sounds.push_back(made_of(file, options));
        if (stop.stop_requested()) return std::nullopt;
        progress = (before + 1.0F) / count;
    }
    return answer;
}

SoundsRequest with_pm(SoundsRequest request) {
    request.with_pm = true;
    return request;
}

void ask_for(const Ui& ui, SoundsState& sounds, SoundsRequest request) {
    sounds.job.ask(std::move(request), make_all, ui.wake);
}

}  // namespace

void from_sound_dialog(Ui& ui, const Workspace& work) {
    ask_for_file(ui,
                 {.purpose = ChooserPurpose::from_sound,
                  .use = ChooserUse::open,
                  .title = "Make a pattern from a sound",
                  .extensions = {".wav", ".mp3", ".flac", ".ogg", ".opus", ".oga", ".aiff", ".aif",
                                 ".au", ".caf"}},
                 work.document.path.parent_path());
}

void open_sounds(Ui& ui, const Workspace& work, SoundsState& sounds,
                 const std::vector<fs::path>& files) {
    sounds.answer.reset();
    sounds.job.forget();
    sounds.shown = 0;
    sounds.wanted.document = work.document_number;
    sounds.wanted.files = files;
    sounds.wanted.full_scale_g = 0.0;
    ui.dialog = Dialog::from_sound;
    want_sounds(ui, sounds);
}

void want_sounds(const Ui& ui, SoundsState& sounds) { ask_for(ui, sounds, sounds.wanted); }

bool are_sounds(const std::vector<fs::path>& files) {
    return !files.empty() && std::ranges::all_of(files, [](const fs::path& file) {
        return extension_of(file) != ".wav" && is_sound_file(file);
    });
}

void follow_sounds(const Ui& ui, SoundsState& sounds) {
    auto answer = sounds.job.latest();
    if (!answer || answer == sounds.answer) return;
    sounds.answer = std::move(answer);
    const SoundsRequest& known = sounds.answer->request;
    if (known == sounds.wanted) ask_for(ui, sounds, with_pm(known));
}

std::shared_ptr<const SoundsAnswer> current_sounds(const SoundsState& sounds) {
    if (!sounds.answer) return {};
    const SoundsRequest& known = sounds.answer->request;
    return with_pm(known) == with_pm(sounds.wanted) ? sounds.answer : nullptr;
}

std::size_t sounds_made(const SoundsAnswer& answer) {
    const auto is_made = [](const SoundMade& made) { return made.sound.has_value(); };
    return static_cast<std::size_t>(std::ranges::count_if(answer.sounds, is_made));
}

void take_sounds(Ui& ui, Workspace& work, const SoundsAnswer& answer) {
    std::vector<Vibration> fresh;
    for (const SoundMade& made : answer.sounds) {
        if (made.sound) fresh.push_back(made.sound->vibration);
    }
    const std::size_t room =
        limits::kMaxPatterns - std::min(limits::kMaxPatterns, work.document.set.vibrations.size());
    const std::size_t count = std::min(fresh.size(), room);
    if (count == 0) {
        return complain(ui, "Nothing was added: a set has at most " +
                                grouped_digits(limits::kMaxPatterns) + " patterns");
    }
    const std::size_t left_out = answer.sounds.size() - count;
    fresh.resize(count);
    ui.fonts_outdated = true;  // names may need other glyphs
    add_vibrations(ui, work, std::move(fresh), "From sound");
    work.selection.scroll_to_current = true;
    say(ui,
        "Made " + counted(count, "pattern", "patterns") + " from " +
            (count == 1 ? "a sound" : "sounds") +
            (left_out > 0 ? "; " + counted(left_out, "file was", "files were") + " left out" : "") +
            ". Their notes say what was lost.");
}

}  // namespace tact
