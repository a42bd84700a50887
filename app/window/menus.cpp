// The menu bar, with the document's name at its end.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "app/document/editing.h"
#include "app/document/files.h"
#include "app/document/rating_files.h"
#include "app/study/study_follow.h"
#include "app/ui/widgets.h"
#include "app/window/commands.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

void draw_item(App& app, const Command& command) {
    const bool checked = command.checked != nullptr && command.checked(app);
    const std::string text = item_text(app, command);
    if (ImGui::MenuItem(text.c_str(), shortcut_text(command.shortcut).c_str(), checked,
                        command.enabled(app))) {
        carry_out(app, command);
    }
    note_item(app.ui.rects, std::string("menu:") + command.name);
    const char* lack = what_lacks(app, command);
    if (lack != nullptr && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
        ImGui::SetTooltip("%s", lack);
    }
}

void draw_recent(App& app) {
    if (!ImGui::BeginMenu("Open recent", !app.work.session.recent_files.empty())) return;
    // A copy: opening a file changes the list.
    const std::vector<RecentFile> recent = recent_files(app.work.session);
    for (const RecentFile& file : recent) {
        const std::string text = file.path.string() + (file.missing ? "  (not found)" : "");
        if (ImGui::MenuItem(text.c_str(), nullptr, false, !file.missing)) {
            open_paths(app.ui, app.work, {file.path});
        }
    }
    ImGui::EndMenu();
}

void draw_own_workspaces(App& app) {
    if (!ImGui::BeginMenu("Own workspaces", !app.workspaces.own.empty())) return;
    std::string forgotten;
    for (const auto& [name, layout] : app.workspaces.own) {
        if (ImGui::MenuItem(name.c_str(), nullptr, app.workspaces.shown == name)) {
            close_study(app.studying);
            show_own(name, app.layout, app.workspaces);
        }
        note_item(app.ui.rects, "workspace:" + name);
    }
    ImGui::Separator();
    for (const auto& [name, layout] : app.workspaces.own) {
        if (ImGui::MenuItem(("Forget " + name).c_str())) forgotten = name;
    }
    if (forgotten == app.workspaces.shown) app.workspaces.shown.clear();
    app.workspaces.own.erase(forgotten);
    ImGui::EndMenu();
}

void draw_examples(App& app) {
    const bool open = ImGui::BeginMenu(kExampleMenu);
    note_item(app.ui.rects, std::string("menu:") + kExampleMenu);
    if (!open) return;
    for (const Command& command : commands()) {
        if (std::string_view(command.menu) == kExampleMenu) draw_item(app, command);
    }
    ImGui::EndMenu();
}

// Before these a menu has a line.
constexpr auto kGroups = std::to_array<std::string_view>({"Save",
                                                          "Load ratings...",
                                                          "Export view...",
                                                          "Quit",
                                                          "New pattern",
                                                          "Steps between...",
                                                          "Rename",
                                                          "Copy",
                                                          "Save workspace as...",
                                                          "Stages in the middle",
                                                          "Reset view of the space",
                                                          "Dark",
                                                          "Matrix",
                                                          "Intended and measured",
                                                          "Larger text",
                                                          "Back to the start",
                                                          "In real time",
                                                          "Loop",
                                                          "Play on hover in the map",
                                                          "Simulate measurement...",
                                                          "Use answers as the set's ratings",
                                                          "New lesson from this set",
                                                          "Student sheet...",
                                                          "Move the card",
                                                          "Manual",
                                                          "About tactspace"});

bool begins_group(const Command& command) {
    return std::ranges::find(kGroups, std::string_view(command.name)) != kGroups.end();
}

// Commands of the View menu.
constexpr std::array kWorkspaceTabs{"Design", "Select", "Physiology", "Study", "Present"};

const Command& view_command(std::string_view name) {
    return *std::ranges::find_if(commands(), [name](const Command& one) {
        return std::string_view(one.menu) == "View" && one.name == name;
    });
}

// Where there is no room for all of them, the View menu has them.
void draw_workspace_tabs(App& app) {
    const Theme& theme = app.ui.theme;
    const float gap = 2.0F * theme.gap_px;
    float wanted = -gap;
    for (const char* tab : kWorkspaceTabs) wanted += ImGui::CalcTextSize(tab).x + gap;
    const float begin = ImGui::GetCursorPosX() + 2.0F * theme.padding_px;
    const float window = ImGui::GetWindowWidth();
    if (begin + wanted + theme.padding_px > window) return;
    ImGui::SetCursorPosX(std::max(begin, std::round(0.5F * (window - wanted))));
    for (const char* tab : kWorkspaceTabs) {
        const Command& command = view_command(tab);
        const bool lit = command.checked(app);
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const ImVec2 size{ImGui::CalcTextSize(tab).x, ImGui::GetFrameHeight()};
        // A menu has the same name.
        const std::string id = std::string("workspace ") + tab;
        if (ImGui::InvisibleButton(id.c_str(), size)) carry_out(app, command);
        const bool over = ImGui::IsItemHovered() || ImGui::IsItemFocused();
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddText({corner.x, corner.y + ImGui::GetStyle().FramePadding.y},
                     lit || over ? theme.text : theme.dim_text, tab);
        if (lit) {
            list.AddRectFilled({corner.x, corner.y + size.y - 2.0F * theme.scale}, corner + size,
                               theme.accent);
        }
        note_item(app.ui.rects, std::string("workspace:") + tab, lit ? "on" : "off");
        draw_tooltip(app.ui, shortcut_text(command.shortcut).c_str());
        ImGui::SameLine(0.0F, gap);
    }
}

}  // namespace

std::string item_text(const App& app, const Command& command) {
    if (std::string_view(command.name) == "Undo") {
        return menu_text("Undo", app.work.history.undo_label());
    }
    if (std::string_view(command.name) == "Redo") {
        return menu_text("Redo", app.work.history.redo_label());
    }
    return command.name;
}

void draw_menus(App& app) {
    if (!ImGui::BeginMainMenuBar()) return;
    for (const char* menu : {"File", "Edit", "View", "Play", "Study", "Lesson", "Help"}) {
        const bool open = ImGui::BeginMenu(menu);
        note_item(app.ui.rects, std::string("menu:") + menu);
        if (!open) continue;
        for (const Command& command : commands()) {
            if (std::string_view(command.menu) != menu) continue;
            if (begins_group(command)) ImGui::Separator();
            draw_item(app, command);
            if (std::string_view(command.name) == "Save workspace as...") draw_own_workspaces(app);
            if (std::string_view(command.name) != "Add to set...") continue;
            draw_recent(app);
            draw_examples(app);
        }
        ImGui::EndMenu();
    }
    draw_workspace_tabs(app);
    const std::string title = document_title(app.work);
    const float right = ImGui::GetWindowWidth() - 2.0F * app.ui.theme.padding_px;
    const float room = right - ImGui::GetCursorPosX() - app.ui.theme.padding_px;
    const std::string shown = shortened(app.ui.theme.fonts.regular, title, std::max(0.0F, room));
    ImGui::SameLine(right - ImGui::CalcTextSize(shown.c_str()).x);
    dim_text(app.ui, shown);
    note_item(app.ui.rects, "document", title);
    ImGui::EndMainMenuBar();
}

}  // namespace tact
