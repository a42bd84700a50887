// The menu bar, with the document's name at its end.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/document/editing.h"
#include "app/lesson/lesson.h"
#include "app/study/study.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "app/window/window.h"
#include "model/lesson/lesson_languages.h"
#include "viz/drawing/icons.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

// Signs of menu rows, the same as on buttons and lists.
std::optional<Icon> icon_of(const Command& command) {
    constexpr auto kIcons = std::to_array<std::pair<std::string_view, Icon>>({
        {"Play or stop", Icon::play},
        {"Back to the start", Icon::to_start},
        {"5 ms forward", Icon::forward},
        {"5 ms back", Icon::back},
        {"Loop", Icon::loop},
        {"Lock", Icon::locked},
        {"Exclude", Icon::dropped},
    });
    const auto* found = std::ranges::find(kIcons, std::string_view(command.name),
                                          &std::pair<std::string_view, Icon>::first);
    return found == kIcons.end() ? std::nullopt : std::optional(found->second);
}

// "~/haptics": a short form of the folder's path.
std::string folder_text(const std::filesystem::path& file) {
    const std::string folder = file.parent_path().string();
    const std::string home = home_folder().string();
    const bool is_below = folder == home || folder.starts_with(home + "/");
    return is_below && home.size() > 1 ? "~" + folder.substr(home.size()) : folder;
}

void draw_item(App& app, const Command& command) {
    const bool checked = command.checked != nullptr && command.checked(app);
    const std::string text = item_text(app, command);
    const std::string keys = shortcut_text(command.shortcut);
    if (draw_menu_row(app.ui.theme, {text.c_str(), keys.c_str(), checked, command.enabled(app),
                                     icon_of(command)})) {
        carry_out(app, command);
    }
    note_item(app.ui.rects, std::string("menu:") + command.name);
    const char* lack = what_lacks(app, command);
    if (lack != nullptr) draw_tooltip(app.ui, lack);
}

void draw_recent(App& app) {
    if (!ImGui::BeginMenu("Open recent", !app.work.session.recent_files.empty())) return;
    // A copy: opening a file changes the list.
    const std::vector<RecentFile> recent = recent_files(app.work.session);
    for (const RecentFile& file : recent) {
        const std::string name = file.path.filename().string();
        const std::string where = file.missing ? "not found" : folder_text(file.path);
        ImGui::PushID(file.path.c_str());
        if (ImGui::MenuItem(label_of(name).c_str(), label_of(where).c_str(), false,
                            !file.missing)) {
            open_file(app, file.path);
        }
        ImGui::PopID();
    }
    ImGui::EndMenu();
}

// The newest step first, with a tick at the present one.
void draw_history(App& app) {
    const History<PatternSet>& history = app.work.document.history;
    constexpr std::size_t kMost = 24;
    const bool open = ImGui::BeginMenu("History", history.size() > 0);
    note_item(app.ui.rects, "menu:History");
    if (!open) return;
    const std::size_t done = history.done();
    const std::size_t last = std::min(history.size(), done + kMost / 2);
    const std::size_t first = last > kMost ? last - kMost : 0;
    std::optional<std::size_t> wanted;
    for (std::size_t k = last; k > first; --k) {
        const Item step{.id = "history:" + std::to_string(k), .label = history.label(k - 1)};
        if (menu_item(app.ui, step, nullptr, k == done)) wanted = k;
    }
    const Item opened{.id = "history:0", .label = "As it was opened"};
    if (first == 0 && menu_item(app.ui, opened, nullptr, done == 0)) wanted = 0;
    ImGui::EndMenu();
    if (!wanted) return;
    app.ui.waiting.emplace_back([&app, step = *wanted] {
        while (app.work.document.history.done() > step) undo(app.ui, app.work);
        while (app.work.document.history.done() < step) redo(app.ui, app.work);
    });
}

void draw_own_workspaces(App& app) {
    if (!ImGui::BeginMenu("My workspaces", !app.workspaces.own.empty())) return;
    std::string forgotten;
    for (const auto& [name, layout] : app.workspaces.own) {
        const Item item{.id = "workspace:" + name, .label = name};
        if (menu_item(app.ui, item, nullptr, app.workspaces.shown == name)) {
            close_study(app.studying);
            show_own(name, app.layout, app.workspaces);
        }
    }
    draw_divider(app.ui.theme);
    for (const auto& [name, layout] : app.workspaces.own) {
        if (ImGui::MenuItem(label_of("Forget " + name).c_str())) forgotten = name;
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

// The languages of the lesson, and those that can be added to it.
void draw_languages(App& app) {
    LessonState& state = app.lesson;
    const bool has_any = state.step && (state.editing || !state.lesson->languages.empty());
    const bool open = ImGui::BeginMenu("Language", has_any);
    note_item(app.ui.rects, "menu:Language");
    if (!open) {
        if (!state.step) return draw_tooltip(app.ui, "no lesson is open");
        return has_any ? void() : draw_tooltip(app.ui, "the lesson is in one language");
    }
    const Lesson lesson = *state.lesson;  // a copy: choosing may change it
    const std::size_t shown = shown_language(state);
    const auto later = [&app](auto act) {
        app.ui.waiting.emplace_back([&app, act] { act(lesson_context(app), app.lesson); });
    };
    for (std::size_t k = 0; k < lesson.languages.size(); ++k) {
        const std::string& code = lesson.languages[k];
        const Item item{.id = "language:" + code,
                        .label = language_name(code),
                        .value = k == shown ? "shown" : ""};
        if (menu_item(app.ui, item, k == 0 ? "first" : nullptr, k == shown)) {
            later([code](const LessonContext& context, LessonState& s) {
                choose_language(context.ui, s, code);
            });
        }
    }
    if (!lesson.languages.empty() && state.editing) draw_divider(app.ui.theme);
    const bool adds = state.editing && ImGui::BeginMenu("Add a language");
    if (state.editing) note_item(app.ui.rects, "menu:Add a language");
    if (adds) {
        for (const NamedLanguage& one : kNamedLanguages) {
            const bool is_there =
                std::ranges::find(lesson.languages, one.code) != lesson.languages.end();
            const bool is_english = lesson.languages.empty() && one.code == std::string_view("en");
            if (is_there || is_english) continue;  // the default is English
            const Item item{.id = std::string("add language:") + one.code, .label = one.name};
            if (menu_item(app.ui, item)) {
                later([code = one.code](const LessonContext& context, LessonState& s) {
                    add_language(context, s, code);
                });
            }
        }
        ImGui::EndMenu();
    }
    if (state.editing && lesson.languages.size() > 1 && shown > 0) {
        const Item item{.id = "remove language",
                        .label = "Remove " + language_name(lesson.languages[shown])};
        if (menu_item(app.ui, item)) later(remove_language);
    }
    ImGui::EndMenu();
}

constexpr const char* kMaximise = "Maximise or restore";

// Groups with a line above them in the menu.
constexpr auto kGroups = std::to_array<std::string_view>({"Save",
                                                          "Load ratings...",
                                                          "Export view...",
                                                          "Quit",
                                                          "New pattern",
                                                          "Steps between...",
                                                          "Add a layer",
                                                          "Tap a rhythm...",
                                                          "Rename",
                                                          "Copy",
                                                          "Save workspace as...",
                                                          kMaximise,
                                                          "Stages in the middle",
                                                          "Reset view of the space",
                                                          "Dark",
                                                          kBenchTabs.front().command,
                                                          "Intended and measured",
                                                          "Back to the start",
                                                          "In real time",
                                                          "Loop",
                                                          "Play on hover in the map",
                                                          "Simulate measurement...",
                                                          "Use answers as the set's ratings",
                                                          "New lesson from this set",
                                                          "Student sheet...",
                                                          "Move the card",
                                                          kBundledLessons[0].name,
                                                          "Manual",
                                                          "About tactspace"});

bool begins_group(const Command& command) {
    return std::ranges::find(kGroups, std::string_view(command.name)) != kGroups.end();
}

// Actions on a pane as a whole.
std::span<const std::string_view> commands_of(Pane pane) {
    static constexpr auto kOfPatterns = std::to_array<std::string_view>(
        {"New pattern", "Paste", "Select all", "Generate candidates...", "Copy table"});
    static constexpr auto kOfSpace =
        std::to_array<std::string_view>({"Reset view of the space", "Lock the view of the space",
                                         "Copy picture", "Export view..."});
    static constexpr auto kOfMatrix =
        std::to_array<std::string_view>({"Copy table", "Copy picture", "Export view..."});
    static constexpr auto kOfStages =
        std::to_array<std::string_view>({"Copy picture", "Export view...", "Export stage as CSV...",
                                         "Stages in the middle", "Stages in one row", "No stages"});
    static constexpr auto kOfEditor = std::to_array<std::string_view>({"Undo", "Redo", "Rename"});
    static constexpr auto kOfStudy = std::to_array<std::string_view>(
        {"Run a participant...", "Export answers as CSV...", "Folder for participants..."});
    switch (pane) {
        case Pane::patterns:
            return kOfPatterns;
        case Pane::editor:
            return kOfEditor;
        case Pane::physiology:
            return kOfStages;
        case Pane::space:
            return kOfSpace;
        case Pane::matrix:
            return kOfMatrix;
        case Pane::start:
            return kOfPatterns;
        case Pane::study_design:
        case Pane::study_people:
        case Pane::study_answers:
            return kOfStudy;
    }
    return {};
}

// Commands of the View menu.
struct WorkspaceTab {
    const char* name;
    const char* help;
};
constexpr auto kWorkspaceTabs = std::to_array<WorkspaceTab>(
    {{"Design", "make and edit patterns, beside their map and their matrix"},
     {"Select", "a big map, the table of candidates and the most distinct subset"},
     {"Physiology", "every stage from the skin to the cortex"},
     {"Study", "ask people how alike the patterns feel"},
     {"Present", "large, for a room: a lesson, step by step"}});

const Command& view_command(std::string_view name) {
    return *std::ranges::find_if(commands(), [name](const Command& one) {
        return std::string_view(one.menu) == "View" && one.name == name;
    });
}

// Without room for all of them, the View menu has them.
void draw_workspace_tabs(App& app) {
    const Theme& theme = app.ui.theme;
    const float gap = 2.0F * theme.gap_px;
    float wanted = -gap;
    for (const auto& [tab, help] : kWorkspaceTabs) wanted += ImGui::CalcTextSize(tab).x + gap;
    const float begin = ImGui::GetCursorPosX() + 2.0F * theme.padding_px;
    const float window = ImGui::GetWindowWidth();
    if (begin + wanted + theme.padding_px > window) return;
    ImGui::SetCursorPosX(std::max(begin, std::round(0.5F * (window - wanted))));
    for (const auto& [tab, help] : kWorkspaceTabs) {
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
        const std::string keys = shortcut_text(command.shortcut);
        draw_tooltip(app.ui, (std::string(tab) + ": " + help + " (" + keys + ")").c_str());
        ImGui::SameLine(0.0F, gap);
    }
}

// Long groups are submenus of their menu, keyed by their first command.
const char* submenu_of(const Command& command) {
    constexpr auto kSubmenus = std::to_array<std::pair<std::string_view, const char*>>({
        {"Add a layer", "Layers"},
        {"Tap a rhythm...", "Draw"},
        {kMaximise, "Pane size"},
        {"Stages in the middle", "Stages"},
        {"Reset view of the space", "Map"},
        {kBenchTabs.front().command, "Panes"},
        {"Intended and measured", "Intended and measured patterns"},
        {"Dark", "Appearance"},
    });
    const auto* found = std::ranges::find(kSubmenus, std::string_view(command.name),
                                          &std::pair<std::string_view, const char*>::first);
    return found == kSubmenus.end() ? nullptr : found->second;
}

}  // namespace

std::span<const std::string_view> menu_groups() { return kGroups; }

std::string menu_path(const Command& command) {
    std::string path = command.menu;
    const char* submenu = nullptr;
    for (const Command& other : commands()) {
        if (std::string_view(other.menu) != command.menu) continue;
        if (begins_group(other)) submenu = submenu_of(other);
        if (&other == &command) break;
    }
    if (submenu != nullptr) path += std::string(" > ") + submenu;
    return path + " > " + command.name;
}

std::string item_text(const App& app, const Command& command) {
    if (std::string_view(command.name) == "Undo") {
        return menu_text("Undo", app.work.document.history.undo_label());
    }
    if (std::string_view(command.name) == "Redo") {
        return menu_text("Redo", app.work.document.history.redo_label());
    }
    return command.name;
}

void draw_pane_menu(App& app, Pane pane) {
    constexpr ImGuiPopupFlags kWhere = ImGuiPopupFlags_MouseButtonRight |
                                       ImGuiPopupFlags_NoOpenOverItems |
                                       ImGuiPopupFlags_NoOpenOverExistingPopup;
    if (!ImGui::BeginPopupContextWindow("pane menu", kWhere)) return;
    if (!is_narrow(app.ui.theme)) {
        auto& maximised = app.layout.maximised;
        const std::string keys = shortcut_text(view_command(kMaximise).shortcut);
        if (draw_menu_row(app.ui.theme, {maximised ? "Restore" : "Maximise", keys.c_str()}))
            maximised = maximised ? std::nullopt : std::optional(pane);
        note_item(app.ui.rects, "pane menu:maximise");
        draw_divider(app.ui.theme);
    }
    for (const std::string_view name : commands_of(pane)) {
        draw_item(app, *std::ranges::find(commands(), name, &Command::name));
    }
    ImGui::EndPopup();
}

namespace {

void draw_rows(App& app, std::string_view menu) {
    bool within = false;  // the submenu ...
    bool open = false;    // ... and whether it is open
    const auto leave = [&within, &open] {
        if (within && open) ImGui::EndMenu();
        within = false;
    };
    for (const Command& command : commands()) {
        if (std::string_view(command.menu) != menu) continue;
        if (begins_group(command)) {
            leave();
            if (const char* name = submenu_of(command)) {
                const bool first =
                    std::string_view(name) == "Stages" || std::string_view(name) == "Layers";
                if (first) draw_divider(app.ui.theme);
                within = true;
                open = ImGui::BeginMenu(name);
                note_item(app.ui.rects, std::string("menu:") + name);
            } else {
                draw_divider(app.ui.theme);
            }
        }
        if (within && !open) continue;
        draw_item(app, command);
        if (std::string_view(command.name) == "Redo") draw_history(app);
        if (std::string_view(command.name) == "Edit the lesson") draw_languages(app);
        if (std::string_view(command.name) == "Save workspace as...") draw_own_workspaces(app);
        if (std::string_view(command.name) != "Add to set...") continue;
        draw_recent(app);
        draw_examples(app);
    }
    leave();
}

}  // namespace

void draw_menus(App& app) {
    if (!ImGui::BeginMainMenuBar()) return;
    for (const char* menu : {"File", "Edit", "View", "Play", "Study", "Lesson", "Help"}) {
        const bool open = ImGui::BeginMenu(menu);
        note_item(app.ui.rects, std::string("menu:") + menu);
        if (!open) continue;
        draw_rows(app, menu);
        ImGui::EndMenu();
    }
    draw_workspace_tabs(app);
    const std::string title = document_title(app.work);
    const float right = ImGui::GetWindowWidth() - 2.0F * app.ui.theme.padding_px;
    const float room = right - ImGui::GetCursorPosX() - app.ui.theme.padding_px;
    const std::string mark = title.substr(document_name(app.work).size());
    const float mark_px = ImGui::CalcTextSize(mark.c_str()).x;
    const std::string shown = shortened(app.ui.theme.fonts.regular, document_name(app.work),
                                        std::max(0.0F, room - mark_px)) +
                              mark;
    ImGui::SameLine(right - ImGui::CalcTextSize(shown.c_str()).x);
    dim_text(app.ui, {.id = "document", .text = shown, .value = title});
    ImGui::EndMainMenuBar();
}

}  // namespace tact
