// The menu bar, with the document's name at its end.

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "app/document/editing.h"
#include "app/document/files.h"
#include "app/document/rating_files.h"
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

void draw_examples(App& app) {
    const bool open = ImGui::BeginMenu(kExampleMenu);
    note_item(app.ui.rects, std::string("menu:") + kExampleMenu);
    if (!open) return;
    for (const Command& command : commands()) {
        if (std::string_view(command.menu) == kExampleMenu) draw_item(app, command);
    }
    ImGui::EndMenu();
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
            draw_item(app, command);
            if (std::string_view(command.name) != "Add to set...") continue;
            draw_recent(app);
            draw_examples(app);
        }
        ImGui::EndMenu();
    }
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
