// The bar under the menus: play and step, how fast, where in time, and what is being computed.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/editing.h"
#include "app/map_follow.h"
#include "app/panels/panels.h"
#include "app/panels/time_rows.h"
#include "app/widgets.h"
#include "viz/colour.h"
#include "viz/marks.h"

namespace tact {

namespace {

enum class Icon { play, pause, to_start, back, forward, loop };

void draw_triangle(ImDrawList& list, ImVec2 centre, float size, float way, ImU32 colour) {
    const float half = size * 0.5F;
    list.AddTriangleFilled({centre.x - way * half, centre.y - half},
                           {centre.x + way * half, centre.y},
                           {centre.x - way * half, centre.y + half}, colour);
}

void draw_icon(ImDrawList& list, Icon icon, ImVec2 at, float size, ImU32 colour) {
    const float bar = size * 0.22F;
    const float half = size * 0.5F;
    const auto upright = [&](float x) {
        list.AddRectFilled({x - bar * 0.5F, at.y - half}, {x + bar * 0.5F, at.y + half}, colour);
    };
    switch (icon) {
        case Icon::play:
            return draw_triangle(list, at, size, 1.0F, colour);
        case Icon::pause:
            upright(at.x - size * 0.25F);
            return upright(at.x + size * 0.25F);
        case Icon::to_start:
            upright(at.x - half);
            return draw_triangle(list, {at.x + bar * 0.5F, at.y}, size * 0.9F, -1.0F, colour);
        case Icon::back:
            upright(at.x + half);
            return draw_triangle(list, {at.x - bar, at.y}, size * 0.7F, -1.0F, colour);
        case Icon::forward:
            upright(at.x - half);
            return draw_triangle(list, {at.x + bar, at.y}, size * 0.7F, 1.0F, colour);
        case Icon::loop:
            list.PathArcTo(at, half, -0.3F, 4.9F, 18);
            list.PathStroke(colour, ImDrawFlags_None, std::max(1.0F, size * 0.13F));
            const ImVec2 tip{at.x + half * std::cos(4.9F), at.y + half * std::sin(4.9F)};
            return draw_triangle(list, tip, size * 0.5F, 1.0F, colour);
    }
}

bool icon_button(App& app, const char* id, Icon icon, bool lit, const char* tip) {
    const Theme& theme = app.theme;
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
    note_item(app.rects, std::string("transport:") + id);
    draw_tooltip(app, tip);
    ImGui::SameLine(0.0F, app.theme.gap_px * 0.5F);
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

void draw_speeds(App& app) {
    for (const Speed& speed : kSpeeds) {
        const bool chosen = app.playhead.speed == speed.speed;
        if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, faded(app.theme.accent, 0.35F));
        if (ImGui::Button(speed.text)) app.playhead.speed = speed.speed;
        if (chosen) ImGui::PopStyleColor();
        note_item(app.rects, std::string("speed:") + speed.text, chosen ? "chosen" : "");
        draw_tooltip(app, speed.tip);
        ImGui::SameLine(0.0F, app.theme.gap_px * 0.5F);
    }
}

// "0.382 s of 1.000 s": digits that do not dance.
void draw_time(App& app) {
    char at[32];
    char whole[48];
    std::snprintf(at, sizeof at, "%.3f s", app.playhead.at_s);
    std::snprintf(whole, sizeof whole, "of %.3f s", shown_duration_s(app));
    ImGui::PushFont(app.theme.fonts.semibold);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(at);
    ImGui::PopFont();
    note_item(app.rects, "playhead", at);
    ImGui::SameLine(0.0F, app.theme.gap_px * 0.75F);
    dim_text(app, whole);
    const TimeRange& range = app.time_range;
    const bool zoomed_in =
        range.length_s() > 0.0 && range.length_s() < shown_duration_s(app) - 1e-9;
    if (!zoomed_in) return;
    ImGui::SameLine(0.0F, app.theme.padding_px);
    char shown[64];
    std::snprintf(shown, sizeof shown, "%.4g\u2013%.4g s shown", range.start_s, range.end_s);
    dim_text(app, shown);
    ImGui::SameLine(0.0F, app.theme.gap_px);
    if (link(app, "show all", "Show all")) app.time_range = {};
    note_item(app.rects, "show all");
}

void draw_computing(App& app) {
    const float right = ImGui::GetWindowWidth() - app.theme.padding_px;
    const bool busy = app.full_job && app.full_job->busy();
    std::string text;
    if (busy) {
        char percent[64];
        std::snprintf(percent, sizeof percent, "computing the map, %.0f %%",
                      static_cast<double>(100.0F * app.full_job->progress()));
        text = percent;
    } else if (app.map_cancelled) {
        text = "map not computed";
    }
    if (text.empty()) return;
    const char* action = busy ? "Cancel" : "Compute";
    const float width =
        ImGui::CalcTextSize(text.c_str()).x + ImGui::CalcTextSize(action).x + app.theme.gap_px;
    if (right - width < ImGui::GetCursorPosX()) return;
    ImGui::SameLine(right - width);
    dim_text(app, text);
    ImGui::SameLine(0.0F, app.theme.gap_px);
    if (link(app, "map action", action)) {
        if (busy) {
            app.full_job->cancel();
            app.preview_job->cancel();
            app.map_cancelled = true;
        } else {
            request_maps(app);
        }
    }
    note_item(app.rects, std::string("map:") + action);
}

}  // namespace

float transport_height(const App& app) { return ImGui::GetFrameHeight() + 1.5F * app.theme.gap_px; }

void draw_transport_bar(App& app, const Rect& area) {
    ImGui::SetNextWindowPos(area.min);
    ImGui::SetNextWindowSize(area.size());
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        ImVec2(app.theme.padding_px, 0.75F * app.theme.gap_px));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, app.theme.pane_rounding_px);
    if (ImGui::Begin("transport", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoScrollWithMouse |
                         ImGuiWindowFlags_NoBringToFrontOnFocus)) {
        Playhead& playhead = app.playhead;
        const double duration_s = shown_duration_s(app);
        const bool playing = playhead.playing;
        if (icon_button(app, "play", playing ? Icon::pause : Icon::play, playing,
                        playing ? "Pause (Space)" : "Play silently (Space)")) {
            toggle_playing(app);
        }
        if (icon_button(app, "to start", Icon::to_start, false, "Back to the start (Home)")) {
            playhead.at_s = 0.0;
        }
        if (icon_button(app, "back", Icon::back, false, "5 ms back ( , )")) {
            playhead = stepped(playhead, -1, duration_s);
        }
        if (icon_button(app, "forward", Icon::forward, false, "5 ms on ( . )")) {
            playhead = stepped(playhead, 1, duration_s);
        }
        if (icon_button(app, "loop", Icon::loop, playhead.loop, "Start over at the end")) {
            playhead.loop = !playhead.loop;
        }
        ImGui::SameLine(0.0F, app.theme.padding_px);
        draw_speeds(app);
        ImGui::SameLine(0.0F, app.theme.padding_px);
        draw_time(app);
        draw_computing(app);
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

}  // namespace tact
