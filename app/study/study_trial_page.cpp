// Training and trials: buttons to feel by, and the slider between totally different and the same.

#include <algorithm>
#include <cmath>

#include "app/study/study.h"
#include "app/ui/widgets.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

using What = StudyEvent::What;

constexpr float kFeelPx = 200.0F;
constexpr float kSliderPx = 560.0F;
constexpr float kTrialPx = 432.0F;  // the page's height, from its question to its button

void feel(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
          std::size_t button) {
    act(ui, work, play, studying, {What::play, button, 0.0, {}, {}});
}

void rate(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
          double similarity) {
    act(ui, work, play, studying, {What::rate, 0, similarity, {}, {}});
}

std::string waiting_text(const StudyRun& run, double now_s) {
    if (may_rate(run, now_s)) {
        return run.similarity ? "How similar do they feel?"
                              : "How similar? Click on the line, or press 0 to 9.";
    }
    if (run.playing) return "Feel ...";
    if (run.cut_short >= kCallAfter) return kCallText;
    if (run.feels_again) return "That was cut short: feel it once more";
    if (run.given.plays_left == 0 && run.given.plays_right == 0) return "Feel both, A and B";
    return run.given.plays_left == 0 ? "Now feel A" : "Now feel B";
}

void draw_slider_track(const Ui& ui, const StudyState& studying, const Rect& track, bool is_open) {
    const StudyRun& run = *studying.run;
    const Theme& theme = ui.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float y = track.centre().y;
    const float half = 3.0F * theme.scale;
    list.AddRectFilled({track.min.x, y - half}, {track.max.x, y + half}, theme.field, half);
    const ImU32 ink = is_open ? theme.dim_text : theme.line;
    for (int k = 0; k <= 4; ++k) {
        const float x = track.min.x + 0.25F * static_cast<float>(k) * track.width();
        draw_upright_line(list, x, y + 10.0F * theme.scale, y + 16.0F * theme.scale,
                          theme.hairline_px, ink);
    }
    const float words = y + 22.0F * theme.scale;
    draw_text(list, theme.fonts.regular, {track.min.x, words},
              is_open ? theme.text : theme.dim_text, "totally different");
    const float right = text_size(theme.fonts.regular, "the same").x;
    draw_text(list, theme.fonts.regular, {track.max.x - right, words},
              is_open ? theme.text : theme.dim_text, "the same");
    if (!run.similarity) return;
    const float x = track.min.x + static_cast<float>(*run.similarity / 100.0) * track.width();
    list.AddRectFilled({track.min.x, y - half}, {x, y + half}, theme.accent, half);
    draw_disc(list, theme, {x, y}, 10.0F * theme.scale, theme.accent);
    const std::string number = std::to_string(std::lround(*run.similarity));
    draw_text(list, theme.fonts.large,
              {x - 0.5F * text_size(theme.fonts.large, number).x, y - 40.0F * theme.scale},
              theme.text, number);
}

void draw_slider(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                 const Rect& area) {
    const bool is_open = may_rate(*studying.run, ui.time_s);
    ImGui::SetCursorScreenPos(area.min);
    ImGui::BeginDisabled(!is_open);
    ImGui::InvisibleButton("slider", area.size());
    const bool is_held = ImGui::IsItemActive();
    ImGui::EndDisabled();
    if (is_held && is_open) {
        const float share = (ImGui::GetIO().MousePos.x - area.min.x) / area.width();
        rate(ui, work, play, studying,
             std::round(100.0 * static_cast<double>(std::clamp(share, 0.0F, 1.0F))));
    }
    const auto& similarity = studying.run->similarity;
    note_rect(
        ui.rects, "study:slider", area.min, area.max,
        similarity ? std::to_string(std::lround(*similarity)) : (is_open ? "open" : "closed"));
    draw_slider_track(ui, studying, area, is_open);
}

// The slider by keyboard, put there as by a click: 0 to 9 to that tenth, Home and End to the ends.
// The arrows only move what has been put, by 1, or by 10 with Shift: wherever they began would be
// an anchor that those at the mouse do not have.
void take_slider_keys(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                      std::span<const KeyPress> pressed) {
    for (const KeyPress& press : pressed) {
        if (press.sign >= U'0' && press.sign <= U'9' && !press.ctrl) {
            rate(ui, work, play, studying, 10.0 * static_cast<double>(press.sign - U'0'));
        }
        const std::optional<double> now = studying.run->similarity;
        const double step = press.shift ? 10.0 : 1.0;
        if (press.code == key::kRight && now) rate(ui, work, play, studying, *now + step);
        if (press.code == key::kLeft && now) rate(ui, work, play, studying, *now - step);
        if (press.code == key::kHome) rate(ui, work, play, studying, 0.0);
        if (press.code == key::kEnd) rate(ui, work, play, studying, 100.0);
    }
}

// What is `height_px` high stands a little above the middle, as a page is looked at.
float top_of(const Rect& area, float height_px) {
    return area.min.y + 0.45F * std::max(0.0F, area.height() - height_px);
}

// Rows of at most six.
Rect training_cell(const Ui& ui, const Rect& area, std::size_t k, std::size_t count) {
    const std::size_t columns = std::min<std::size_t>(count, count <= 8 ? 4 : 6);
    const float gap = ui.theme.padding_px;
    const auto rows = static_cast<float>((count + columns - 1) / columns);
    const float room = area.height() - 90.0F * ui.theme.scale;
    const auto across = static_cast<float>(columns);
    const float side = std::min({120.0F * ui.theme.scale, (room / rows - gap) / 0.75F,
                                 (area.width() - gap * (across - 1.0F)) / across});
    const float width = static_cast<float>(columns) * (side + gap) - gap;
    const ImVec2 corner{
        area.centre().x - 0.5F * width + static_cast<float>(k % columns) * (side + gap),
        area.min.y + static_cast<float>(k / columns) * (0.75F * side + gap)};
    return rect_at(corner, {side, 0.75F * side});
}

void take_training_keys(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                        std::span<const KeyPress> pressed) {
    const std::size_t count = studying.run->training.size();
    const std::size_t at = studying.held.value_or(0);
    if (was_pressed(pressed, key::kRight)) studying.held = studying.held ? (at + 1) % count : 0;
    if (was_pressed(pressed, key::kLeft)) studying.held = (at + count - 1) % count;
    if (was_pressed(pressed, key::kSpace)) {
        if (!studying.held) studying.held = 0;
        feel(ui, work, play, studying, *studying.held);
    }
}

}  // namespace

void draw_training_page(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                        const Rect& page, std::span<const KeyPress> pressed) {
    take_training_keys(ui, work, play, studying, pressed);
    const StudyRun& run = *studying.run;
    const Theme& theme = ui.theme;
    const std::size_t count = run.training.size();
    const float head = 56.0F * theme.scale;
    const float foot = 40.0F * theme.scale;
    Rect buttons{{page.min.x, page.min.y + head}, page.max};
    const float height = training_cell(ui, buttons, count - 1, count).max.y - page.min.y + foot +
                         go_on_size(theme).y;
    const float top = top_of(page, height);
    const ImVec2 down{0.0F, top - page.min.y};
    buttons = {buttons.min + down, buttons.max + down};
    centred_text(theme.fonts.large, theme.text, page, top,
                 run.cut_short >= kCallAfter       ? kCallText
                 : run.feels_again && !run.playing ? "That was cut short: feel it once more"
                                                   : "Get to know them: feel each at least once");
    std::optional<std::size_t> chosen;
    for (std::size_t k = 0; k < count; ++k) {
        const Rect cell = training_cell(ui, buttons, k, count);
        const std::string id = "study:train " + std::to_string(k + 1);
        const FeelButton button{id.c_str(),  std::to_string(k + 1),
                                "",          run.playing == run.training[k],
                                run.felt[k], may_play(run, ui.time_s)};
        if (draw_feel_button(ui, studying, cell, button)) chosen = k;
        if (studying.held == k) {
            ImGui::GetWindowDrawList()->AddRect(cell.min, cell.max, theme.text,
                                                theme.pane_rounding_px, 0, 2.0F * theme.scale);
        }
    }
    if (chosen) feel(ui, work, play, studying, *chosen);
    const Rect last = training_cell(ui, buttons, count - 1, count);
    const float left = page.centre().x - 0.5F * go_on_size(theme).x;
    const float y = last.max.y + foot;
    draw_go_on(ui, work, play, studying, {{left, y}, {page.max.x, y}}, "Start rating");
}

void draw_trial_page(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                     const Rect& area, std::span<const KeyPress> pressed) {
    if (was_typed(pressed, U'a')) feel(ui, work, play, studying, 0);
    if (was_typed(pressed, U'b')) feel(ui, work, play, studying, 1);
    take_slider_keys(ui, work, play, studying, pressed);
    const StudyRun& run = *studying.run;
    const Theme& theme = ui.theme;
    // Smaller where the window is too low for it.
    const float s = std::min(theme.scale, area.height() / kTrialPx);
    const float head = top_of(area, kTrialPx * s);
    const std::string task = waiting_text(run, ui.time_s);
    centred_text(theme.fonts.large, theme.text, area, head, task);
    note_rect(ui.rects, "study:task", area.min, area.max, task);
    const float side = std::min(kFeelPx * s, 0.3F * area.width());
    const float gap = 0.4F * side;
    const float top = head + 64.0F * s;
    const bool is_ready = may_play(run, ui.time_s);
    // If the patterns are identical, only the button that was pressed fills.
    const bool is_left = run.playing && studying.pressed_button == 0;
    const bool is_right = run.playing && studying.pressed_button == 1;
    const Rect left = rect_at({area.centre().x - side - 0.5F * gap, top}, {side, 0.7F * side});
    const Rect right = rect_at({area.centre().x + 0.5F * gap, top}, {side, 0.7F * side});
    const bool feels_left = draw_feel_button(
        ui, studying, left, {"study:A", "A", "", is_left, run.given.plays_left, is_ready});
    const bool feels_right = draw_feel_button(
        ui, studying, right, {"study:B", "B", "", is_right, run.given.plays_right, is_ready});
    const float width = std::min(kSliderPx * theme.scale, area.width());
    const float y = left.max.y + 96.0F * s;
    draw_slider(ui, work, play, studying,
                rect_at({area.centre().x - 0.5F * width, y - 16.0F * s}, {width, 32.0F * s}));
    const ImVec2 foot{area.centre().x - 0.5F * go_on_size(theme).x, y + 84.0F * s};
    draw_go_on(ui, work, play, studying, {foot, {area.max.x, foot.y}}, "Next");
    if (feels_left) feel(ui, work, play, studying, 0);
    if (feels_right) feel(ui, work, play, studying, 1);
}

}  // namespace tact
