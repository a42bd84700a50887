// The dialog before a pattern becomes another program's effect.

#include <algorithm>
#include <array>

#include "app/export/export.h"
#include "app/export/parts.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"

namespace tact {

namespace {

constexpr float kEffectDialogPx = 1060.0F;
constexpr float kRowsPx = 275.0F;  // of the dialog, besides the pane
constexpr float kPanePx = 420.0F;
constexpr float kDropDownPx = 320.0F;

void draw_format(Ui& ui, EffectChoice& choice) {
    draw_label(ui, "Format");
    const TargetTraits& shown = traits(choice.format);
    drop_down(ui, {.id = "export:format", .label = shown.title, .value = shown.key},
              kDropDownPx * ui.theme.scale, [&] {
                  for (const TargetTraits& one : target_formats()) {
                      const TargetFormat format = *target_format_of(one.key);
                      const bool chosen = format == choice.format;
                      const Item item{.id = std::string("export format:") + one.key,
                                      .label = one.title};
                      if (!option(ui, item, chosen) || chosen) continue;
                      choice.format = format;
                      choice.actuator.clear();
                      choice.sampled = own_target(format).sampled;
                  }
              });
}

// The format's own is the first one.
void draw_actuator(Ui& ui, EffectExport& effects) {
    EffectChoice& choice = effects.choice;
    const ActuatorMap map_in_use = target_of(effects).map;
    const std::string usual = usual_target(choice.format, *effects.ground.set).map.name;
    draw_label(ui, "Actuator");
    const bool is_own = usual == traits(choice.format).map;
    const std::string own =
        usual + (is_own ? ", the format's own" : ", by which the effects were read");
    const Item shown{
        .id = "export:actuator",
        .label = choice.actuator.empty() ? own : choice.actuator,
        .tip = "What 0 to 1 of the files mean in Hz and g: the device that they are for.",
        .value = map_in_use.name};
    drop_down(ui, shown, kDropDownPx * ui.theme.scale, [&] {
        if (ImGui::Selectable(own.c_str(), choice.actuator.empty())) choice.actuator.clear();
        for (const ActuatorMap& map : bundled_actuators()) {
            if (map.name == usual) continue;
            const Item item{.id = "export actuator:" + map.name, .label = map.name};
            if (option(ui, item, map.name == choice.actuator)) choice.actuator = map.name;
        }
    });
    draw_label(ui, "");
    ImGui::PushFont(ui.theme.fonts.small);
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, map_in_use.source);
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
}

constexpr std::array kRates{Choice{10'000.0, "10 kHz"}, Choice{44'100.0, "44.1 kHz"},
                            Choice{48'000.0, "48 kHz"}};
constexpr std::array kEncodings{Choice{WaveEncoding::int16, "16 bits"},
                                Choice{WaveEncoding::int24, "24 bits"},
                                Choice{WaveEncoding::float32, "Floats"}};

// In the place of an actuator: samples are in g.
void draw_sampled(Ui& ui, EffectChoice& choice) {
    draw_label(ui, "Rate");
    draw_segments(ui, kRates, choice.sampled.rate_hz, "export:");
    draw_label(ui, choice.format == TargetFormat::wav ? "Samples" : "");
    if (choice.format != TargetFormat::wav) {
        return dim_text(ui, "A line a sample: time in s, acceleration in g.");
    }
    draw_segments(ui, kEncodings, choice.sampled.encoding, "export:");
    ImGui::SameLine(0.0F, 1.5F * ui.theme.gap_px);
    dim_text(ui, "The loudest is full scale: a .wav.json beside each file says its g.");
}

void draw_which(Ui& ui, EffectExport& effects) {
    draw_label(ui, "Patterns");
    const ExportGround& ground = effects.ground;
    const auto draw = [&](ExportWhich which, const char* name, std::size_t count) {
        const Item item{.id = std::string("export which:") + name,
                        .label = std::string(name) + " (" + std::to_string(count) + ")",
                        .enabled = count > 0,
                        .value = std::to_string(count)};
        if (segment(ui, item, effects.choice.which == which)) effects.choice.which = which;
        ImGui::SameLine(0.0F, 0.0F);
    };
    draw(ExportWhich::all, "All", ground.set->vibrations.size());
    draw(ExportWhich::selected, "Selected", ground.selected.size());
    draw(ExportWhich::picked, "Picked", ground.picked.size());
    const std::size_t recordings = effects.request.recordings;
    std::string note;
    if (recordings == 1) note = "1 recording is left out: no such file holds it";
    if (recordings > 1) {
        note = std::to_string(recordings) + " recordings are left out: no such file holds them";
    } else if (note.empty() && effects.choice.which == ExportWhich::picked) {
        note = "all of the set is predicted, these are written";
    }
    ImGui::SameLine(0.0F, 1.5F * ui.theme.gap_px);
    dim_text(ui, {.id = "export:left out", .text = note});
}

}  // namespace

void draw_effect_dialog(Ui& ui, const Workspace& work, EffectExport& effects) {
    if (ui.dialog != kExportEffectsDialog) return;
    follow_effects(ui, effects);
    if (!begin_dialog(ui, kExportEffectsDialog, kEffectDialogPx)) return;
    draw_format(ui, effects.choice);
    if (is_sampled(effects.choice.format)) {
        draw_sampled(ui, effects.choice);
    } else {
        draw_actuator(ui, effects);
    }
    draw_which(ui, effects);
    draw_divider(ui.theme);
    const float s = ui.theme.scale;
    const float room = 0.9F * ImGui::GetIO().DisplaySize.y - kRowsPx * s;
    draw_loss_pane(ui, work, effects, std::clamp(room, 120.0F * s, kPanePx * s));
    const bool chosen_is_asked = effects.asked == effects.choice;
    const bool ready = is_loss_current(effects) || effects.without;
    const bool enabled = chosen_is_asked && ready && !effects.request.written.empty();
    const bool go = draw_ends(ui, "Choose a folder...", enabled);
    if (ui.dialog != kExportEffectsDialog) effects.job.cancel();
    if (go) choose_effect_folder(ui, work, effects);
}

}  // namespace tact
