#include "app/sounds/sounds.h"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>

#include "app/document/editing.h"
#include "app/measured/measured.h"
#include "app/progress/progress.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/io/recordings/recording.h"
#include "model/io/recordings/sound_file.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"
#include "viz/drawing/marks.h"

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

void from_sound_dialog(Ui& ui, const Workspace& work, SoundsState& sounds) {
    ask_for_file(ui,
                 {.use = ChooserUse::open,
                  .title = "Make a pattern from a sound",
                  .extensions = {".wav", ".mp3", ".flac", ".ogg", ".opus", ".oga", ".aiff", ".aif",
                                 ".au", ".caf"},
                  .take = [&](const fs::path& file) { open_sounds(ui, work, sounds, {file}); }},
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
    ui.dialog = kSoundsDialog;
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

namespace {

constexpr float kSoundsDialogPx = 760.0F;
constexpr float kActuatorPx = 320.0F;
constexpr Range kSoundFullScaleG{0.0, limits::kScaleG.high};

const SoundMade* shown_sound(const SoundsState& sounds, const SoundsAnswer* answer) {
    if (answer == nullptr || answer->sounds.empty()) return nullptr;
    return &answer->sounds[std::min(sounds.shown, answer->sounds.size() - 1)];
}

// Only where there are several.
void draw_sound_rows(Ui& ui, SoundsState& sounds, const SoundsAnswer* answer) {
    const auto& files = sounds.wanted.files;
    if (files.size() < 2) return;
    const std::size_t rows = std::min<std::size_t>(files.size(), 6);
    if (!ImGui::BeginTable("sounds", 2, ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingStretchProp,
                           {0.0F, ImGui::GetFrameHeightWithSpacing() * static_cast<float>(rows)})) {
        return;
    }
    for (std::size_t k = 0; k < files.size(); ++k) {
        ImGui::PushID(static_cast<int>(k));
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        const std::string name = files[k].filename().string();
        const Item item{.id = "sounds:file " + std::to_string(k), .label = name};
        if (option(ui, item, sounds.shown == k)) sounds.shown = k;
        ImGui::TableNextColumn();
        const SoundMade* made = answer == nullptr ? nullptr : &answer->sounds[k];
        const bool is_bad = made != nullptr && !made->fault.empty();
        std::string words = is_bad ? "cannot be read" : "reading\u2026";
        if (made != nullptr && made->sound) {
            words = significant_digits(made->sound->made.pattern.duration_s, 3) + " s";
        }
        if (is_bad) ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.warning);
        ImGui::TextUnformatted(words.c_str());
        if (is_bad) ImGui::PopStyleColor();
        ImGui::PopID();
    }
    ImGui::EndTable();
}

void draw_actuator_choice(Ui& ui, SoundsRequest& wanted) {
    const ActuatorMap& map = bundled_actuator(wanted.actuator);
    draw_label(ui, "Actuator");
    drop_down(ui, {.id = "sounds:actuator", .label = map.name}, kActuatorPx * ui.theme.scale, [&] {
        for (const ActuatorMap& one : bundled_actuators()) {
            const Item item{
                .id = "sounds actuator:" + one.name, .label = one.name, .tip = one.source};
            if (option(ui, item, one.name == wanted.actuator)) wanted.actuator = one.name;
        }
    });
    const ActuatorMap& chosen = bundled_actuator(wanted.actuator);
    const std::string band = significant_digits(chosen.frequency_hz.low, 4) + " to " +
                             significant_digits(chosen.frequency_hz.high, 4) + " Hz. " +
                             chosen.source;
    ImGui::PushFont(ui.theme.fonts.small);
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, {.id = "sounds:band", .text = band});
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
}

void draw_sound_fields(Ui& ui, SoundsRequest& wanted) {
    draw_actuator_choice(ui, wanted);
    const std::string usual =
        "g; 0: the file's own, else " +
        significant_digits(bundled_actuator(wanted.actuator).full_scale_g, 3) + " g";
    draw_number_row(ui, {"sounds:full scale", "Full scale", 0.0, kSoundFullScaleG, usual.c_str()},
                    wanted.full_scale_g);
    draw_label(ui, "");
    check(ui,
          {.id = "sounds:accents",
           .label = "Onsets become accents",
           .tip = "What begins suddenly and is over within some 10 ms is drawn as a burst."},
          wanted.accents);
}

void draw_made(Ui& ui, const SoundsState& sounds, const SoundsAnswer* answer) {
    const SoundMade* made = shown_sound(sounds, answer);
    if (made == nullptr) {
        if (draw_failure(ui, "sounds", sounds.job.failure())) return;
        return draw_empty_overlay(ui, "Reading\u2026", "");
    }
    if (!made->sound) return draw_empty_overlay(ui, "No pattern can be made of it", made->fault);
    draw_overlay(ui, {"sounds:preview", made->sound->made.felt, "the sound in the band",
                      made->played, "the pattern"});
    std::string remarks;
    for (const std::string& remark : made->sound->remarks) {
        remarks += (remarks.empty() ? "" : "; ") + remark;
    }
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, {.id = "sounds:remarks", .text = remarks + ".", .value = remarks});
    ImGui::PopTextWrapPos();
}

}  // namespace

void draw_sounds_dialog(Ui& ui, Workspace& work, SoundsState& sounds) {
    if (!begin_dialog(ui, kSoundsDialog, kSoundsDialogPx)) return;
    const std::size_t files = sounds.wanted.files.size();
    dim_text(ui, files == 1 ? label_of(sounds.wanted.files.front().filename().string()) +
                                  ", as a pattern for an actuator"
                            : counted(files, "sound", "sounds") + ", as patterns for an actuator");
    const SoundsRequest before = sounds.wanted;
    std::shared_ptr<const SoundsAnswer> answer = current_sounds(sounds);
    draw_sound_rows(ui, sounds, answer.get());
    draw_sound_fields(ui, sounds.wanted);
    draw_made(ui, sounds, answer.get());
    if (sounds.wanted != before) want_sounds(ui, sounds);
    answer = current_sounds(sounds);
    if (answer && !answer->request.with_pm && sounds.job.busy()) {
        dim_text(ui, "How far it is from the sound, by PM: " +
                         std::to_string(static_cast<int>(100.0F * sounds.job.progress())) +
                         " %. It can be added before.");
    }
    const std::size_t count = answer ? sounds_made(*answer) : 0;
    const std::string action = "Add " + counted(count, "pattern", "patterns");
    if (draw_ends(ui, action.c_str(), count > 0)) take_sounds(ui, work, *answer);
    if (ui.dialog != kSoundsDialog) sounds.job.cancel();
}

}  // namespace tact
