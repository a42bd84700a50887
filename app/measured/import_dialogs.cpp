// The dialogs on measurements: the pattern of each recording, and the settings of a simulation.

#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/measured/measured.h"
#include "app/progress/progress.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

void draw_twin(Ui& ui, Workspace& work, const Vibration& intended, const Twin& twin,
               const char* name) {
    draw_overlay(ui, {"import:preview", twin.alignment.waveform, name,
                      cached_waveform(work.cache, intended), "intended"});
}

// A list of the patterns that a recording can belong to, and an entry for no pattern. True if the
// choice changed.
bool draw_pattern_choice(Ui& ui, const Workspace& work, std::string& chosen, std::size_t row) {
    bool changed = false;
    const auto offer = [&](const char* words, const std::string& name) {
        if (!ImGui::Selectable(words, chosen == name)) return;
        changed = chosen != name;
        chosen = name;
    };
    const Item shown{.id = "import:pattern " + std::to_string(row),
                     .label = chosen.empty() ? "leave out" : chosen,
                     .value = chosen};
    drop_down(
        ui, shown, -1.0F,
        [&] {
            offer("leave out", "");
            for (const Vibration& vibration : work.document.set.vibrations) {
                if (measures_another(vibration)) continue;
                offer(label_of(vibration.name).c_str(), vibration.name);
            }
        },
        ImGuiComboFlags_HeightRegular);
    return changed;
}

const ImportedFile* answer_of(const ImportState& state, std::size_t k) {
    if (!state.answer || state.answer->request.files != state.files) return nullptr;
    return &state.answer->files[k];
}

void draw_file_row(Ui& ui, const Workspace& work, ImportState& importing, std::size_t k,
                   bool& changed) {
    ImGui::PushID(static_cast<int>(k));
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string name = importing.files[k].filename().string();
    ImGui::AlignTextToFramePadding();
    const Item item{.id = "import:file " + std::to_string(k), .label = name};
    if (option(ui, item, importing.shown == k)) importing.shown = k;
    ImGui::TableNextColumn();
    changed |= draw_pattern_choice(ui, work, importing.patterns[k], k);
    ImGui::TableNextColumn();
    const ImportedFile* file = answer_of(importing, k);
    std::string text;
    if (file == nullptr) {
        text = importing.import_job.failure().empty() ? "reading\u2026" : "not read";
    } else if (!file->fault.empty()) {
        text = "cannot be read";
    } else if (file->twin) {
        text = "alike " + with_decimals(file->twin->alignment.correlation, 2);
    }
    const bool odd =
        file != nullptr &&
        (!file->fault.empty() || (file->twin && file->twin->alignment.correlation < kLeastAlike));
    if (odd) ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.warning);
    ImGui::AlignTextToFramePadding();
    plain_text(ui, {.id = "import:result " + std::to_string(k),
                    .text = text,
                    .tip = "How alike the recording and its pattern are: 1 is the same but for "
                           "strength, below 0.3 it is hardly a recording of it."});
    if (odd) ImGui::PopStyleColor();
    ImGui::PopID();
}

bool draw_files(Ui& ui, const Workspace& work, ImportState& importing) {
    bool changed = false;
    const std::size_t rows = importing.files.size();
    const float height = ImGui::GetFrameHeightWithSpacing() *
                         static_cast<float>(std::clamp<std::size_t>(rows, 1, 6));
    constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingStretchProp;
    if (ImGui::BeginTable("files", 3, kFlags, {0.0F, height})) {
        ImGui::TableSetupColumn("file", ImGuiTableColumnFlags_WidthStretch, 0.42F);
        ImGui::TableSetupColumn("pattern", ImGuiTableColumnFlags_WidthStretch, 0.34F);
        ImGui::TableSetupColumn("result", ImGuiTableColumnFlags_WidthStretch, 0.24F);
        for (std::size_t k = 0; k < rows; ++k) draw_file_row(ui, work, importing, k, changed);
        ImGui::EndTable();
    }
    return changed;
}

bool draw_options(Ui& ui, ImportState& importing) {
    const bool has_wave = std::ranges::any_of(
        importing.files, [](const auto& file) { return extension_of(file) == ".wav"; });
    return draw_recording_fields(ui, importing.fields, has_wave);
}

void draw_shown_file(Ui& ui, Workspace& work, ImportState& importing) {
    if (importing.files.empty())
        return draw_empty_overlay(ui, "No recordings yet", "Add the files of an accelerometer.");
    importing.shown = std::min(importing.shown, importing.files.size() - 1);
    const ImportedFile* file = answer_of(importing, importing.shown);
    if (file == nullptr && draw_failure(ui, "import", importing.import_job.failure())) return;
    if (file == nullptr) return draw_empty_overlay(ui, "Reading\u2026", "");
    if (!file->fault.empty()) return draw_empty_overlay(ui, "Cannot be read", file->fault);
    const auto place = file->twin
                           ? place_named(work.document.set, importing.patterns[importing.shown])
                           : std::nullopt;
    if (!place) {
        return draw_empty_overlay(ui, "No pattern chosen",
                                  "Which one was played when this was recorded?");
    }
    draw_twin(ui, work, work.document.set.vibrations[*place], *file->twin, "measured");
    std::string remarks;
    for (const std::string& remark : file->remarks) {
        remarks += (remarks.empty() ? "" : "; ") + remark;
    }
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, {.id = "import:remarks", .text = remarks});
    ImGui::PopTextWrapPos();
}

// The number of twins that would come into the set; 0 while one of the recordings cannot.
std::size_t importable(const ImportState& state) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < state.files.size(); ++k) {
        if (state.patterns[k].empty()) continue;
        const ImportedFile* file = answer_of(state, k);
        if (file == nullptr || !file->fault.empty()) return 0;
        ++count;
    }
    return count;
}

// A recording that is left out need not be readable.
void drop_left_out(ImportState& state) {
    for (std::size_t k = state.files.size(); k-- > 0;) {
        if (!state.patterns[k].empty()) continue;
        state.files.erase(state.files.begin() + static_cast<std::ptrdiff_t>(k));
        state.patterns.erase(state.patterns.begin() + static_cast<std::ptrdiff_t>(k));
    }
}

// True if the dialog gives way to the one for the columns of the shown table.
bool draw_columns_button(Ui& ui, ImportState& importing) {
    const bool is_table = importing.shown < importing.files.size() &&
                          extension_of(importing.files[importing.shown]) != ".wav";
    if (!is_table) return false;
    const bool wanted =
        button(ui, {.id = "button:columns",
                    .label = "Columns...",
                    .tip = "Says which column of this table is the time and which are axes."});
    ImGui::SameLine();
    if (!wanted) return false;
    importing.columns_of = importing.files[importing.shown];
    give_way(ui);
    return true;
}

void draw_import_dialog(Ui& ui, Workspace& work, ImportState& importing) {
    if (!begin_dialog(ui, kImportDialog)) return;
    dim_text(ui, "Recordings by an accelerometer, and the pattern each measures");
    const bool changed = draw_files(ui, work, importing);
    if (draw_options(ui, importing) || changed) look_at_recordings(ui, work, importing);
    draw_shown_file(ui, work, importing);
    const std::size_t count = importable(importing);
    const std::string action =
        count == 1 ? "Import 1 recording" : "Import " + std::to_string(count) + " recordings";
    const bool more = button(ui, {.id = "button:add files", .label = "Add files..."});
    ImGui::SameLine();
    if (draw_columns_button(ui, importing)) return;
    if (more) {
        give_way(ui);
        importing.adding = true;
        return import_recordings_dialog(ui, work, importing);
    }
    if (!draw_ends(ui, action.c_str(), count > 0)) return;
    drop_left_out(importing);
    take_recordings(ui, work, importing);
}

bool draw_actuator(Ui& ui, ActuatorParams& actuator) {
    const ActuatorParams before = actuator;
    const ActuatorParams normal;
    const auto row = [&](const char* id, const char* label, double ActuatorParams::*number,
                         Range range, const char* unit) {
        draw_number_row(ui, {id, label, normal.*number, range, unit}, actuator.*number);
    };
    row("import:resonance", "Resonance", &ActuatorParams::resonance_hz, limits::kResonanceHz, "Hz");
    row("import:q", "Q", &ActuatorParams::q, limits::kResonanceQ,
        "how much stronger it moves there than far above");
    row("import:gain", "Gain", &ActuatorParams::gain, limits::kActuatorGain,
        "far above the resonance; below, it falls");
    row("import:onset", "Onset", &ActuatorParams::onset_s, limits::kOnsetS,
        "s until the motion begins");
    row("import:noise", "Noise", &ActuatorParams::noise_g, limits::kSensorNoiseG, "g rms");
    return actuator != before;
}

bool is_sound(const ActuatorParams& actuator) {
    return limits::kResonanceHz.contains(actuator.resonance_hz) &&
           limits::kResonanceQ.contains(actuator.q) &&
           limits::kActuatorGain.contains(actuator.gain) &&
           limits::kOnsetS.contains(actuator.onset_s) &&
           limits::kSensorNoiseG.contains(actuator.noise_g);
}

void draw_simulation_dialog(Ui& ui, Workspace& work, ImportState& importing) {
    if (!begin_dialog(ui, kSimulationDialog)) return;
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui,
             "What an accelerometer on a resonant actuator might record. It is computed, no "
             "recording: its twins are called synthetic wherever they are shown.");
    ImGui::PopTextWrapPos();
    const bool changed = draw_actuator(ui, importing.actuator);
    const bool sound = is_sound(importing.actuator);
    if (changed && sound) look_at_simulation(ui, work, importing);
    draw_label(ui, "Of");
    bool& all = importing.simulate_all;
    if (toggle(ui, {.id = "import:all", .label = "all patterns"}, all)) all = true;
    ImGui::SameLine(0.0F, 2.0F * ui.theme.scale);
    if (toggle(ui, {.id = "import:selected", .label = "the selected ones"}, !all)) all = false;
    const auto& shown = importing.simulated;
    if (shown && !shown->twins.empty()) {
        const Twin& twin = shown->twins.front();
        const auto place =
            place_named(work.document.set, std::get<Measurement>(twin.vibration.source).measures);
        if (place) draw_twin(ui, work, work.document.set.vibrations[*place], twin, "synthetic");
    } else if (shown || !draw_failure(ui, "simulation", importing.simulation_job.failure())) {
        draw_empty_overlay(ui, shown ? "No pattern selected" : "Computing\u2026",
                           shown ? "What measures another pattern has no twin itself." : "");
    }
    const bool any = all || (shown && !shown->twins.empty());
    if (draw_ends(ui, "Add synthetic twins", sound && any)) take_simulation(ui, work, importing);
}

}  // namespace

void draw_import_dialogs(Ui& ui, Workspace& work, ImportState& importing) {
    draw_import_dialog(ui, work, importing);
    draw_simulation_dialog(ui, work, importing);
}

}  // namespace tact
