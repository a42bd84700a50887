// The current pattern as an actuator plays it: intended and rendered waveforms, and the lost energy
// in each band.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "app/document/editing.h"
#include "app/map/map.h"
#include "app/play/parts.h"
#include "app/play/play.h"
#include "app/progress/progress.h"
#include "app/timeline/timeline.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

// Maximum width of a table, so that a row's numbers stay close together.
float read_width(const Theme& theme) {
    constexpr float kMostPx = 560.0F;
    return std::min(ImGui::GetContentRegionAvail().x, kMostPx * theme.scale);
}

// A number and its "%" stay on one line.
std::string unbroken(std::string text) {
    for (std::size_t at = 0; (at = text.find(" %", at)) != std::string::npos;) {
        text.replace(at, 1, "\u00A0");
    }
    return text;
}

void draw_kind(Ui& ui, Workspace& work, RenderingState& rendered) {
    const float wide = 190.0F * ui.theme.scale;
    const Item shown{.id = "combo:device kind", .label = traits(rendered.by.kind).name};
    drop_down(ui, shown, std::min(wide, ImGui::GetContentRegionAvail().x), [&] {
        for (const ActuatorKind kind : kActuatorKinds) {
            const bool chosen = rendered.by.kind == kind;
            const Item item{.id = std::string("choose:") + traits(kind).key,
                            .label = traits(kind).name,
                            .tip = std::string("Keeps ") + traits(kind).keeps + "."};
            if (!option(ui, item, chosen) || chosen) continue;
            rendered.by.kind = kind;
            if (rendered.on) predictions_changed(work);
        }
    });
}

void draw_switch(Ui& ui, Workspace& work, RenderingState& rendered) {
    constexpr const char* kLabel = "Predict from this";
    flow_on(check_width(ui.theme, kLabel), 1.5F * ui.theme.gap_px);
    const Item item{
        .id = "rendered",
        .label = kLabel,
        .tip =
            "Stages, matrix, map and metrics of what the device plays, instead of what was "
            "meant. Titles say so; the document does not change."};
    if (check(ui, item, rendered.on)) predictions_changed(work);
}

void draw_full_scale(Ui& ui, Workspace& work, RenderingState& rendered) {
    Field field{.id = "rendering_full_scale_g",
                .label = "Full scale",
                .format = "%.2f g",
                .slider = {0.1, 10.0},
                .typed = kFullScaleRangeG,
                .step = 0.1,
                .logarithmic = true,
                .help =
                    "The acceleration that the device's strongest is taken for. "
                    "Uncalibrated: nobody has measured it."};
    field.normal = RenderingState{}.by.full_scale_g;
    if (!ImGui::BeginTable("full scale", 1, 0, {read_width(ui.theme), 0.0F})) return;
    ImGui::TableNextColumn();
    const FieldEdit edit = draw_field(ui, field, rendered.by.full_scale_g);
    ImGui::EndTable();
    if (edit.changed && rendered.on) predictions_changed(work);
}

void take_level(Workspace& work, RenderingState& rendered, double level) {
    if (std::exchange(rendered.by.level, level) != level && rendered.on) predictions_changed(work);
}

void draw_level(Ui& ui, Workspace& work, RenderingState& rendered, const PlayState& play) {
    const Item item{
        .id = "rendering:at bar level",
        .label = "At the playback level, " + exact_percent(play.level),
        .tip =
            "As strong as it is played now, by the level at the top of the window: a weak "
            "motor's dead zone included. When it is off, patterns are taken at "
            "full level, with the strength that they say."};
    if (check(ui, item, rendered.at_bar_level)) {
        take_level(work, rendered, rendered.at_bar_level ? play.level : 1.0);
    }
}

// The larger peak of both, so that the weaker looks weaker.
void draw_waves(Ui& ui, const Workspace& work, Timeline& timeline, const LiveRendering& live,
                bool stale, const Rect& area) {
    const double largest = std::max(peak_g(live.intended), peak_g(live.rendering.waveform));
    const ImFont* small = ui.theme.fonts.small;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float caption = small == nullptr ? 0.0F : small->FontSize + 2.0F * ui.theme.scale;
    const float each = (area.height() - time_axis_height(ui)) / 2.0F;
    const auto draw = [&](const char* id, const char* words, const Waveform& waveform, ImU32 colour,
                          Rect place, bool last) {
        // A low plot has room for one number on its axis.
        const std::string caption_text =
            std::string(words) + ", peak " + significant(peak_g(waveform), 2) + " g";
        draw_text(list, small, place.min, ui.theme.dim_text, caption_text);
        note_rect(ui.rects, std::string("device caption:") + id, place.min, place.max,
                  caption_text);
        place.min.y += caption;
        TimeRow row;
        row.id = id;
        row.samples = waveform.samples_g;
        row.rate_hz = waveform.rate_hz;
        row.colour = colour;
        row.largest = largest;
        row.unit = "g";
        row.large = true;
        row.time_axis = last;
        row.stale = stale;
        draw_time_row(ui, work, timeline, place, row);
    };
    const float split = area.min.y + each;
    draw("intended", "meant", live.intended, ui.theme.dim_text, {area.min, {area.max.x, split}},
         false);
    draw("rendered", "played", live.rendering.waveform, ui.theme.series,
         {{area.min.x, split}, area.max}, true);
}

std::string band_words(const BandEnergy& band, bool is_last) {
    const std::string low = with_decimals(band.low_hz, 0);
    const std::string high = with_decimals(band.high_hz, 0);
    if (band.low_hz <= 0.0) return "below " + high + " Hz";
    return is_last ? "above " + low + " Hz" : low + "\u2013" + high + " Hz";
}

void draw_band(Ui& ui, const BandEnergy& band, double whole_g2, bool is_last) {
    const auto cell = [](const std::string& text) {
        ImGui::TableNextColumn();
        right_aligned(text);
    };
    const std::string lost =
        band.intended_g2 > 1e-4 * whole_g2 ? percent(band.share_lost) : "\u2013";
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string words = band_words(band, is_last);
    plain_text(ui, {.id = "band:" + words, .text = words, .value = lost});
    cell(percent(band.intended_g2 / whole_g2));
    cell(percent(band.rendered_g2 / whole_g2));
    const bool much = band.share_lost > 0.5 && band.intended_g2 > 0.05 * whole_g2;
    if (much) ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.warning);
    cell(lost);
    if (much) ImGui::PopStyleColor();
}

void draw_bands(Ui& ui, const Rendering& rendering) {
    double whole_g2 = 0.0;
    for (const BandEnergy& band : rendering.bands) whole_g2 += band.intended_g2;
    if (!(whole_g2 > 0.0)) return dim_text(ui, "Silence: there is nothing to lose.");
    ImGui::PushFont(ui.theme.fonts.small);
    if (ImGui::BeginTable("bands", 4, ImGuiTableFlags_SizingStretchProp,
                          {read_width(ui.theme), 0.0F})) {
        ImGui::TableSetupColumn("band", 0, 1.3F);
        for (const char* name : {"meant", "played", "lost of it"}) ImGui::TableSetupColumn(name);
        ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.dim_text);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted("energy");
        for (const char* name : {"meant", "played", "lost of it"}) {
            ImGui::TableNextColumn();
            right_aligned(name);
        }
        ImGui::PopStyleColor();
        for (const BandEnergy& band : rendering.bands) {
            draw_band(ui, band, whole_g2, &band == &rendering.bands.back());
        }
        ImGui::EndTable();
    }
    ImGui::PopFont();
}

// Sentences under the numbers: facts that the curves do not show.
std::vector<std::string> remarks_on(const Rendering& rendering) {
    std::vector<std::string> remarks;
    for (const std::string& warning : rendering.warnings) {
        remarks.push_back("The pattern " + warning + ".");
    }
    if (traits(rendering.by.kind).language == Language::on_off) {
        remarks.emplace_back(
            "Uncalibrated: its 165 Hz, and how soon it starts and stops, are guessed.");
    }
    const auto of_frames = [&](auto which) {
        return static_cast<std::size_t>(std::ranges::count_if(rendering.frames, which));
    };
    const std::string frames = " of " + std::to_string(rendering.frames.size()) + " packets";
    if (rendering.clipped && rendering.warnings.empty()) {
        remarks.emplace_back("Stronger than full scale: the device plays it weaker than meant.");
    }
    if (const auto folded = of_frames([](const RenderedFrame& f) { return f.folded; })) {
        remarks.push_back(std::to_string(folded) + frames +
                          " hold a tone below 41 Hz, played as swells of 160 Hz.");
    }
    if (const auto noise = of_frames([](const RenderedFrame& f) { return f.noise; })) {
        remarks.push_back(std::to_string(noise) + frames +
                          " hold noise or a click, played as tones of its level.");
    }
    return remarks;
}

void draw_summary(Ui& ui, const Rendering& rendering, bool at_bar_level) {
    const bool loses = rendering.share_lost > 0.005;
    std::string text = loses ? percent(rendering.share_lost) + " of its energy is lost"
                             : "None of its energy is lost";
    if (rendering.share_added > 0.005) {
        text += loses ? ", and " : "; ";
        text += percent(rendering.share_added) + " is added at other frequencies";
    }
    text += ".";
    ImGui::PushTextWrapPos(0.0F);
    plain_text(ui, {.id = "rendering:summary", .text = unbroken(text), .value = text});
    ImGui::PushFont(ui.theme.fonts.small);
    for (const std::string& remark : remarks_on(rendering)) dim_text(ui, remark);
    const std::string origin =
        std::string("This kind keeps ") + traits(rendering.by.kind).keeps +
        (is_calibrated(rendering.by) ? ". Computed from its measured response"
                                     : ". Computed from how it is told, not measured") +
        ", at a level of " + exact_percent(rendering.by.level) +
        (at_bar_level ? ", the playback level." : ", not the playback level.");
    dim_text(ui, {.id = "rendering:origin", .text = unbroken(origin), .value = origin});
    ImGui::PopFont();
    ImGui::PopTextWrapPos();
}

void draw_report(Ui& ui, const Workspace& work, Timeline& timeline,
                 const RenderingState& rendered) {
    const Vibration* const current = current_vibration(work);
    const std::shared_ptr<const LiveRendering> live = rendered.shown;
    const bool failed = draw_failure(ui, "device", rendered.job.failure());
    if (failed && !live) return;
    if (current == nullptr || !live) {
        const Rect area = rest_of_pane();
        if (area.empty()) return;
        draw_empty(*ImGui::GetWindowDrawList(), ui.theme, area,
                   current == nullptr ? "No pattern" : "Computing",
                   "What the device plays will stand here, beside what was meant.");
        return;
    }
    const bool behind = live->request != RenderingRequest{*current, rendered.by};
    const bool stale = looks_stale(ui, "device", live, behind);
    draw_summary(ui, live->rendering, rendered.at_bar_level);
    const float rows = static_cast<float>(live->rendering.bands.size()) + 1.0F;
    const float line = ui.theme.fonts.small == nullptr
                           ? ImGui::GetTextLineHeightWithSpacing()
                           : ui.theme.fonts.small->FontSize + ImGui::GetStyle().ItemSpacing.y;
    const float least = 130.0F * ui.theme.scale;
    const float room = rest_of_pane().height() - rows * line - ui.theme.gap_px;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const Rect waves = rect_at(corner, {ImGui::GetContentRegionAvail().x, std::max(least, room)});
    ImGui::Dummy(waves.size());
    draw_waves(ui, work, timeline, *live, stale, waves);
    draw_bands(ui, live->rendering);
}

}  // namespace

void follow_level(Workspace& work, RenderingState& rendered, const PlayState& play) {
    if (rendered.at_bar_level) take_level(work, rendered, play.level);
}

void draw_device_panel(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                       const PlayState& play) {
    // The content is higher than a low pane.
    ImGui::BeginChild("device report", ImGui::GetContentRegionAvail());
    draw_kind(ui, work, rendered);
    draw_switch(ui, work, rendered);
    draw_level(ui, work, rendered, play);
    if (is_calibrated(rendered.by)) {
        ImGui::PushTextWrapPos(0.0F);
        dim_text(ui, {.id = "rendering:calibrated", .text = calibration_text(play)});
        ImGui::PopTextWrapPos();
    } else {
        draw_full_scale(ui, work, rendered);
    }
    draw_report(ui, work, timeline, rendered);
    ImGui::EndChild();
}

}  // namespace tact
