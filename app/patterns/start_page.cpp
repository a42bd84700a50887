#include "app/patterns/patterns.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string>
#include <utility>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/ui/widgets.h"
#include "assets/assets.h"
#include "model/io/set/set_file.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kMostPx = 760.0F;
constexpr std::size_t kColumns = 4;

// One example of each kind that a designer looks for first.
constexpr std::array kCards{"Press low", "Heartbeat fast", "Take-off", "Alarm urgent",
                            "Bounce",    "Purr",           "Rain",     "Charge"};

void read_cards(StartPage& page) {
    constexpr const char* kLibrary = "library/library.tactspace.json";
    auto set = parse_set(asset(kLibrary), kLibrary, {});
    assert(set && "the compiled-in library does not parse");
    for (const char* name : kCards) {
        const auto found = std::ranges::find(set->vibrations, name, &Vibration::name);
        assert(found != set->vibrations.end() && "the library has every card");
        page.cards.push_back(std::move(*found));
    }
}

// Its picture over its own length, its name and its duration. True when pressed.
bool draw_card(Ui& ui, Workspace& work, const Vibration& card, ImU32 colour, ImVec2 size) {
    const Theme& theme = ui.theme;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton(card.name.c_str(), size);
    note_item(ui.rects, "start:" + card.name);
    const bool lit = ImGui::IsItemHovered() || (ui.keyboard_mode && ImGui::IsItemFocused());
    if (ImGui::IsItemActive()) note_pressed(work, card);
    draw_tooltip(ui, (std::string(kHoldHelp) + ". A click adds it to the set.").c_str());
    if (lit) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Rect all = rect_at(corner, size);
    list.AddRectFilled(all.min, all.max, lit ? theme.hover : theme.field, theme.pane_rounding_px);
    const float pad = theme.gap_px;
    const float line = text_size(theme.fonts.regular, "0").y;
    const Rect picture{all.min + ImVec2{pad, pad},
                       {all.max.x - pad, all.max.y - line - 2.0F * pad}};
    draw_thumbnail(ui, work, picture, card, colour, 0.0);
    const float y = all.max.y - pad - line;
    const std::string length = length_text(own_duration_s(card));
    const float length_px = text_size(theme.fonts.small, length).x;
    draw_text(list, theme.fonts.small, {all.max.x - pad - length_px, y + 0.15F * line},
              theme.dim_text, length);
    draw_text(list, theme.fonts.regular, {all.min.x + pad, y}, theme.text,
              shortened(theme.fonts.regular, card.name, size.x - length_px - 3.0F * pad));
    return pressed;
}

// Two rows; returns their height.
float draw_cards(Ui& ui, Workspace& work, const StartPage& page) {
    const Rect room = rest_of_pane();
    const float gap = ui.theme.gap_px;
    const float width = (room.width() - gap * (kColumns - 1)) / kColumns;
    const ImVec2 size{width, std::min(0.62F * width, 0.24F * room.height())};
    for (std::size_t k = 0; k < page.cards.size(); ++k) {
        const ImVec2 place{static_cast<float>(k % kColumns), static_cast<float>(k / kColumns)};
        ImGui::SetCursorScreenPos(room.min +
                                  ImVec2{place.x * (size.x + gap), place.y * (size.y + gap)});
        const Vibration& card = page.cards[k];
        if (!draw_card(ui, work, card, pattern_look(ui.theme, k).colour, size)) continue;
        ui.waiting.emplace_back(
            [&ui, &work, card] { add_vibrations(ui, work, {card}, "Add " + card.name); });
    }
    return 2.0F * size.y + gap;
}

// Looks for the files once per list: a slow disk would delay every frame.
void follow_recent(const Session& session, StartPage& page) {
    if (page.recent_of == session.recent_files) return;
    page.recent_of = session.recent_files;
    page.recent = recent_files(session);
}

std::optional<StartAction> draw_recent(Ui& ui, const StartPage& page) {
    constexpr std::size_t kMost = 5;
    std::optional<StartAction> done;
    std::size_t count = 0;
    for (const RecentFile& file : page.recent) {
        if (file.missing || count == kMost) continue;
        if (count++ == 0) {
            ImGui::Dummy({1.0F, ui.theme.gap_px});
            dim_text(ui, "Opened lately");
        }
        const std::string name = file.path.filename().string();
        ImGui::PushID(file.path.c_str());
        if (name_link(ui, {.id = "start:recent " + name, .label = name}))
            done = StartAction{StartAction::Way::recent, file.path};
        ImGui::PopID();
    }
    return done;
}

}  // namespace

std::optional<StartAction> draw_start_page(Ui& ui, Workspace& work, StartPage& page) {
    if (page.cards.empty()) read_cards(page);
    follow_recent(work.session, page);
    const Theme& theme = ui.theme;
    const Rect rest = rest_of_pane();
    const float width = std::min(rest.width(), kMostPx * theme.scale);
    const float left = std::round(rest.centre().x - 0.5F * width);
    std::optional<StartAction> done;
    ImGui::SetCursorScreenPos({left, rest.min.y});
    ImGui::BeginChild("start", {width, rest.height()});
    ImGui::Dummy({1.0F, std::max(0.0F, 0.06F * rest.height())});
    ImGui::PushFont(theme.fonts.large);
    ImGui::TextUnformatted("Begin with a vibration");
    ImGui::PopFont();
    dim_text(ui, "A click adds it. Two or more make a map of how different they feel.");
    ImGui::Dummy({1.0F, theme.gap_px});
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float cards_px = draw_cards(ui, work, page);
    ImGui::SetCursorScreenPos({corner.x, corner.y + cards_px + 2.0F * theme.gap_px});
    if (primary_button(ui, {.id = "button:new pattern", .label = "New pattern"})) {
        ui.waiting.emplace_back([&ui, &work] { add_pattern(ui, work); });
    }
    const auto way = [&](const char* words, const char* noted, StartAction::Way what,
                         const char* help) {
        flow_on(button_width(words), theme.gap_px);
        if (button(ui, {.id = noted, .label = words, .tip = help})) done = StartAction{what};
    };
    way("Open...", "start:open", StartAction::Way::open,
        "A set, a recording, an effect file, or a folder of them (Ctrl+O). They can be dropped "
        "here, too.");
    way("Generate...", "start:generate", StartAction::Way::generate,
        "Every combination of some numbers (Ctrl+G).");
    if (const auto recent = draw_recent(ui, page)) done = recent;
    ImGui::EndChild();
    return done;
}

}  // namespace tact
