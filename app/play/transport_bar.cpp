// The bar under the menus: play and step, speed, position in time, and running computations.

#include <algorithm>
#include <array>
#include <cmath>

#include "app/document/editing.h"
#include "app/map/map.h"
#include "app/play/parts.h"
#include "app/play/play.h"
#include "app/progress/progress.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/icons.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

bool icon_button(Ui& ui, const char* id, Icon icon, bool lit, const char* tip) {
    const Theme& theme = ui.theme;
    const float side = ImGui::GetFrameHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton(id, {side * 1.15F, side});
    const bool over = ImGui::IsItemHovered() || ImGui::IsItemFocused();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (over || lit) {
        list.AddRectFilled(corner, corner + ImVec2{side * 1.15F, side},
                           lit ? faded(theme.accent, 0.28F) : theme.hover, theme.rounding_px);
    }
    draw_icon(list, icon, corner + ImVec2{side * 0.575F, side * 0.5F}, side * 0.46F,
              lit ? theme.accent : theme.text);
    say_of_last_item(
        ui, {.id = std::string("transport:") + id, .text = lit ? "on" : "off", .tip = tip});
    ImGui::SameLine(0.0F, ui.theme.gap_px * 0.5F);
    return pressed;
}

struct Speed {
    const char* text;
    double speed;
    const char* tip;
};
constexpr std::array<Speed, 3> kSpeeds{{{"1\u00d7", 1.0, "Real time"},
                                        {"1/10", 0.1, "Ten times slower"},
                                        {"1/100", 0.01, "A hundred times slower"}}};

void draw_speeds(Ui& ui, Workspace& work, Timeline& timeline, const ShownMap& shown_map,
                 PlayState& play) {
    for (const Speed& speed : kSpeeds) {
        const bool chosen = timeline.playhead.speed == speed.speed;
        if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, faded(ui.theme.accent, 0.35F));
        const Item item{.id = std::string("speed:") + speed.text,
                        .label = speed.text,
                        .tip = speed.tip,
                        .value = chosen ? "chosen" : ""};
        if (button(ui, item)) set_speed(ui, work, timeline, shown_map, play, speed.speed);
        if (chosen) ImGui::PopStyleColor();
        ImGui::SameLine(0.0F, ui.theme.gap_px * 0.5F);
    }
}

struct TimeTexts {
    std::string at;
    std::string whole;
    std::string range;  // empty: the whole pattern is shown
};

TimeTexts time_texts(const Workspace& work, const Timeline& timeline) {
    // The resolution of the read-outs of curves, at least a thousandth.
    const double duration_s = shown_duration_s(work);
    const TimeRange range = shown_range(timeline, duration_s);
    const double step_s = std::min(1e-3, range.length_s() / 500.0);
    const std::string at = stepped(timeline.playhead.at_s, step_s > 0.0 ? step_s : 1e-3) + " s";
    const std::string shown = is_zoomed_in(timeline, duration_s)
                                  ? significant_digits(range.start_s, 4) + "\u2013" +
                                        significant_digits(range.end_s, 4) + " s shown"
                                  : "";
    return {at, "of " + with_decimals(duration_s, 3) + " s", shown};
}

// The running computation, in a long and a short form; empty: none.
struct ComputingTexts {
    std::string full;
    std::string brief;
    const char* action = "";
};

ComputingTexts computing_texts(const Ui& ui, const Workspace& work, const ShownMap& shown_map) {
    if (shown_map.progress && work.document.set.vibrations.size() > 1) {
        const std::string done = percent_done(double{shown_map.progress->share});
        const std::string left =
            time_left_text(ui.time_s - shown_map.progress->since_s, shown_map.progress->share);
        return {"Computing the map, " + done + (left.empty() ? "" : ", " + left), done, "Cancel"};
    }
    if (shown_map.cancelled) return {"Map not computed", "No map", "Compute"};
    return {};
}

// Parts for which the bar has room, from the first to the last to be left out.
struct BarParts {
    bool computing_in_full = true;
    bool whole = true;
    bool range = true;
    bool pair_names = true;
    bool meter = true;
    bool speeds = true;
    bool steps = true;
    bool wide_device = true;
    bool loop = true;
    bool computing = true;
};
// The level and the stop button are never left out: they are visible at every size of text.
constexpr std::array<bool BarParts::*, 10> kFirstToGo{&BarParts::computing_in_full,
                                                      &BarParts::whole,
                                                      &BarParts::range,
                                                      &BarParts::pair_names,
                                                      &BarParts::meter,
                                                      &BarParts::speeds,
                                                      &BarParts::steps,
                                                      &BarParts::wide_device,
                                                      &BarParts::loop,
                                                      &BarParts::computing};

constexpr std::array<bool BarParts::*, 6> kButtonsToGo{&BarParts::pair_names,  &BarParts::meter,
                                                       &BarParts::speeds,      &BarParts::steps,
                                                       &BarParts::wide_device, &BarParts::loop};

constexpr const char* kShowAll = "Show all";

float width_of(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }

// Width of the playhead's time, so that what stands after it does not move while it runs.
float time_slot(const Ui& ui, const TimeTexts& time) {
    const ImFont* font = ui.theme.fonts.semibold;
    return std::max(text_size(font, time.at).x, text_size(font, "00.000 s").x);
}

// Everything before the time: independent of the state of playing and computing.
float buttons_width(const Ui& ui, const PlayState& play, const BarParts& parts) {
    const float gap = ui.theme.gap_px;
    const float icon = 1.15F * ImGui::GetFrameHeight() + 0.5F * gap;
    float sum = icon * (1.0F + (parts.steps ? 3.0F : 0.0F) + (parts.loop ? 1.0F : 0.0F));
    if (parts.loop) sum += alternate_width(ui, parts.pair_names) + 0.5F * gap;
    if (parts.speeds) {
        sum += ui.theme.padding_px;
        for (const Speed& speed : kSpeeds) sum += button_width(speed.text) + 0.5F * gap;
    }
    return sum + ui.theme.padding_px +
           sound_controls_width(ui, play, {parts.meter, parts.wide_device});
}

// The time, and the texts after it, which come and go.
float texts_width(const Ui& ui, const TimeTexts& time, const ComputingTexts& computing,
                  const BarParts& parts) {
    const float gap = ui.theme.gap_px;
    float sum = ui.theme.padding_px + time_slot(ui, time);
    if (parts.whole) sum += 0.75F * gap + width_of(time.whole);
    if (!time.range.empty()) {
        sum += ui.theme.padding_px + width_of(kShowAll);
        if (parts.range) sum += gap + width_of(time.range);
    }
    if (parts.computing && !computing.full.empty()) {
        sum += 2.0F * gap + width_of(parts.computing_in_full ? computing.full : computing.brief) +
               gap + width_of(computing.action);
    }
    return sum;
}

// Room for the buttons is found first, with the texts at their shortest, whether they are shown or
// not: buttons then stay in place while a map is computed or the time is zoomed. Texts get the
// rest.
BarParts fitting_parts(const Ui& ui, const Workspace& work, const Timeline& timeline,
                       const ShownMap& shown_map, const PlayState& play, float room_px) {
    const TimeTexts time = time_texts(work, timeline);
    const TimeTexts zoomed{time.at, {}, kShowAll};
    const ComputingTexts halted{"No map", "No map", "Compute"};
    BarParts parts;
    parts.computing_in_full = parts.whole = parts.range = false;
    for (const auto part : kButtonsToGo) {
        if (buttons_width(ui, play, parts) + texts_width(ui, zoomed, halted, parts) <= room_px)
            break;
        parts.*part = false;
    }
    parts.computing_in_full = parts.whole = parts.range = true;
    const ComputingTexts computing = computing_texts(ui, work, shown_map);
    for (const auto part : kFirstToGo) {
        if (buttons_width(ui, play, parts) + texts_width(ui, time, computing, parts) <= room_px)
            break;
        parts.*part = false;
    }
    return parts;
}

// "0.382 s of 1.000 s", with a fixed number of digits so that the text does not jump.
void draw_time(Ui& ui, const Workspace& work, Timeline& timeline, const BarParts& parts) {
    const TimeTexts time = time_texts(work, timeline);
    ImGui::PushFont(ui.theme.fonts.semibold);
    ImGui::AlignTextToFramePadding();
    plain_text(ui, {.id = "playhead", .text = time.at});
    ImGui::PopFont();
    const float rest_px = time_slot(ui, time) - ImGui::GetItemRectSize().x;
    ImGui::SameLine(0.0F, 0.0F);
    ImGui::Dummy({rest_px, 1.0F});
    if (parts.whole) {
        ImGui::SameLine(0.0F, ui.theme.gap_px * 0.75F);
        dim_text(ui, {.id = "bar:whole", .text = time.whole});
    }
    if (time.range.empty()) return;
    ImGui::SameLine(0.0F, ui.theme.padding_px);
    if (parts.range) {
        dim_text(ui, {.id = "bar:range", .text = time.range});
        ImGui::SameLine(0.0F, ui.theme.gap_px);
    }
    if (row_link(ui, {.id = "show all", .label = kShowAll})) timeline.range = {};
}

void draw_computing(Ui& ui, const Workspace& work, ShownMap& shown_map,
                    const RenderingState& rendered, const BarParts& parts) {
    const ComputingTexts texts = computing_texts(ui, work, shown_map);
    if (texts.full.empty() || !parts.computing) return;
    const std::string& text = parts.computing_in_full ? texts.full : texts.brief;
    const float right = ImGui::GetWindowWidth() - ui.theme.padding_px;
    const float width =
        ImGui::CalcTextSize(text.c_str()).x + ImGui::CalcTextSize(texts.action).x + ui.theme.gap_px;
    ImGui::SameLine(right - width);
    dim_text(ui, {.id = "bar:computing", .text = text});
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    if (row_link(ui, {.id = std::string("map:") + texts.action, .label = texts.action})) {
        if (shown_map.progress) {
            shown_map.full_job.cancel();
            shown_map.preview_job.cancel();
            shown_map.cancelled = true;
        } else {
            request_maps(ui, work, shown_map, rendered);
        }
    }
}

const char* play_tip(const Timeline& timeline, const PlayState& play) {
    if (is_sounding(play)) return "Stop (Space; Esc silences everything)";
    if (timeline.playhead.playing) return "Pause (Space)";
    if (!can_sound(play)) return "Play silently (Space)";
    return timeline.playhead.speed == 1.0
               ? "Play (Space)"
               : "Play silently, in slow motion; at 1\u00d7 it is felt (Space)";
}

void draw_buttons(Ui& ui, Workspace& work, Timeline& timeline, const ShownMap& shown_map,
                  PlayState& play, const BarParts& parts) {
    Playhead& playhead = timeline.playhead;
    const double duration_s = shown_duration_s(work);
    const bool playing = playhead.playing;
    const Icon halt = is_sounding(play) ? Icon::stop : Icon::pause;
    if (icon_button(ui, "play", playing ? halt : Icon::play, playing, play_tip(timeline, play))) {
        toggle_playing(ui, work, timeline, shown_map, play);
    }
    if (parts.steps) {
        if (icon_button(ui, "to start", Icon::to_start, false, "Back to the start (Home)")) {
            playhead.at_s = 0.0;
        }
        if (icon_button(ui, "back", Icon::back, false, "5 ms back ( , )")) {
            playhead = stepped(playhead, -1, duration_s);
        }
        if (icon_button(ui, "forward", Icon::forward, false, "5 ms forward ( . )")) {
            playhead = stepped(playhead, 1, duration_s);
        }
    }
    if (parts.loop && icon_button(ui, "loop", Icon::loop, playhead.loop, "Start over at the end")) {
        playhead.loop = !playhead.loop;
    }
    if (parts.loop) draw_alternate(ui, work, shown_map, play, parts.pair_names);
}

}  // namespace

float transport_height(const Ui& ui) { return ImGui::GetFrameHeight() + 1.5F * ui.theme.gap_px; }

void draw_transport_bar(Ui& ui, Workspace& work, Timeline& timeline, ShownMap& shown_map,
                        const RenderingState& rendered, PlayState& play, const Rect& area) {
    ImGui::SetNextWindowPos(area.min);
    ImGui::SetNextWindowSize(area.size());
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        ImVec2(ui.theme.padding_px, 0.75F * ui.theme.gap_px));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.theme.pane_rounding_px);
    if (ImGui::Begin("transport", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoScrollWithMouse |
                         ImGuiWindowFlags_NoBringToFrontOnFocus)) {
        const BarParts parts = fitting_parts(ui, work, timeline, shown_map, play,
                                             area.width() - 2.0F * ui.theme.padding_px);
        draw_buttons(ui, work, timeline, shown_map, play, parts);
        ImGui::SameLine(0.0F, ui.theme.padding_px);
        draw_sound_controls(ui, timeline, play, {parts.meter, parts.wide_device});
        if (parts.speeds) {
            ImGui::SameLine(0.0F, ui.theme.padding_px);
            draw_speeds(ui, work, timeline, shown_map, play);
        }
        ImGui::SameLine(0.0F, ui.theme.padding_px);
        draw_time(ui, work, timeline, parts);
        draw_computing(ui, work, shown_map, rendered, parts);
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

}  // namespace tact
