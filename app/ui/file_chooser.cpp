#include "app/ui/file_chooser.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "app/ui/dialog.h"
#include "app/ui/widgets.h"

namespace tact {
namespace {

namespace fs = std::filesystem;
using Chosen = std::optional<fs::path>;

// In heights of the font.
constexpr float kDialogWidth = 44.0F;
constexpr float kDialogHeight = 30.0F;
constexpr float kPlacesWidth = 9.0F;
constexpr float kChangedWidth = 8.5F;
constexpr float kFormatWidth = 9.0F;

bool is_there(const fs::path& path) {
    std::error_code none;
    return fs::exists(path, none);
}

void go(FileChooser& chooser, const fs::path& folder) {
    // "a/" and "a" are one folder; the root keeps its slash.
    fs::path there = folder.lexically_normal();
    if (!there.has_filename() && there.has_relative_path()) there = there.parent_path();
    chooser.listing = list_folder(there, chooser.extensions);
    chooser.cursor.reset();
    chooser.name = chooser.offered;
    chooser.remark.clear();
    chooser.focus_name = true;
}

fs::path typed_path(const FileChooser& chooser, const std::string& text) {
    if (text == "~" || text.starts_with("~/")) {
        return (home_folder() / text.substr(std::min<std::size_t>(2, text.size())))
            .lexically_normal();
    }
    return (chooser.listing.folder / text).lexically_normal();  // an absolute one replaces it
}

Chosen accept_to_open(FileChooser& chooser, const fs::path& path) {
    if (is_there(path)) return path;
    chooser.remark = "There is no file " + path.string() + ".";
    chooser.focus_name = true;
    return std::nullopt;
}

Chosen accept_to_save(FileChooser& chooser, fs::path path) {
    if (!has_extension(path.filename().string(), chooser.extensions)) {
        path += chooser.extensions.front();
    }
    if (!is_folder(path.parent_path())) {
        chooser.remark = "There is no folder " + path.parent_path().string() + ".";
        chooser.focus_name = true;
        return std::nullopt;
    }
    if (!is_there(path)) return path;
    chooser.replacing = path;
    return std::nullopt;
}

// Asks before a file in the folder is replaced.
Chosen accept_folder(FileChooser& chooser, const fs::path& folder) {
    for (const std::string& name : chooser.file_names) {
        if (!is_there(folder / name)) continue;
        chooser.replacing = folder / name;
        return std::nullopt;
    }
    return folder;
}

Chosen accept_new_folder(FileChooser& chooser, const fs::path& path) {
    if (!is_there(path) && is_folder(path.parent_path())) return path;
    chooser.remark = is_there(path) ? path.string() + " is a file."
                                    : "There is no folder " + path.parent_path().string() + ".";
    chooser.focus_name = true;
    return std::nullopt;
}

// What Enter does with the name as it stands.
Chosen accept(FileChooser& chooser) {
    chooser.remark.clear();
    if (chooser.name.empty() && chooser.use == ChooserUse::save_folder) {
        return accept_folder(chooser, chooser.listing.folder);
    }
    if (chooser.name.empty()) {
        chooser.remark = "Type a name, or pick one from the list.";
        chooser.focus_name = true;
        return std::nullopt;
    }
    const fs::path path = typed_path(chooser, chooser.name);
    if (is_folder(path)) {
        go(chooser, path);
        // Of a folder that was saved into before, and not of one of the same name in it.
        const bool again = path.filename() == chooser.offered;
        if (chooser.use == ChooserUse::save_folder && again) chooser.name.clear();
        return std::nullopt;
    }
    switch (chooser.use) {
        case ChooserUse::open:
            return accept_to_open(chooser, path);
        case ChooserUse::save:
            return accept_to_save(chooser, path);
        case ChooserUse::save_folder:
            return accept_new_folder(chooser, path);
    }
    return std::nullopt;
}

void move_cursor(FileChooser& chooser, bool down) {
    const std::size_t count = chooser.listing.entries.size();
    if (count == 0) return;
    if (!chooser.cursor) {
        chooser.cursor = down ? 0 : count - 1;
    } else if (down) {
        chooser.cursor = std::min(*chooser.cursor + 1, count - 1);
    } else if (*chooser.cursor > 0) {
        --*chooser.cursor;
    }
    chooser.scroll_to_cursor = true;
}

// Up and down in the name field. ImGui lets an active field be changed only from inside.
int on_history(ImGuiInputTextCallbackData* field) {
    FileChooser& chooser = *static_cast<FileChooser*>(field->UserData);
    move_cursor(chooser, field->EventKey == ImGuiKey_DownArrow);
    if (!chooser.cursor) return 0;
    field->DeleteChars(0, field->BufTextLen);
    field->InsertChars(0, chooser.listing.entries[*chooser.cursor].name.c_str());
    return 0;
}

bool button(TabOrder& order, const char* label) {
    const bool pressed = ImGui::Button(label);
    note_stop(order);
    return pressed;
}

void note_place(TabOrder& order, FileChooser& chooser, const char* label, const fs::path& place) {
    ImGui::PushID(place.c_str());
    const bool here = chooser.listing.folder == place;
    if (ImGui::Selectable(label, here, ImGuiSelectableFlags_DontClosePopups)) go(chooser, place);
    note_stop(order);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", place.c_str());
    ImGui::PopID();
}

// The folders of the desktop, and those that were worked in lately.
void draw_places(FileChooser& chooser, TabOrder& order, float height_px) {
    ImGui::BeginChild("##places", {kPlacesWidth * ImGui::GetFontSize(), height_px});
    note_place(order, chooser, "Home", home_folder());
    for (const char* name : {"Desktop", "Documents", "Downloads"}) {
        if (is_folder(home_folder() / name)) note_place(order, chooser, name, home_folder() / name);
    }
    note_place(order, chooser, "Computer", "/");
    if (!chooser.recent.empty()) {
        ImGui::Spacing();
        ImGui::TextDisabled("Recent");
    }
    const std::vector<fs::path> recent = chooser.recent;
    for (const fs::path& place : recent) {
        note_place(order, chooser, place.filename().c_str(), place);
    }
    ImGui::EndChild();
}

// The head of a path elided: its end is what tells folders apart.
std::string end_of(const std::string& path, float room_px) {
    std::string shown = path;
    while (ImGui::CalcTextSize(shown.c_str()).x > room_px) {
        const std::size_t next = shown.find('/', shown.starts_with("\u2026/") ? 4 : 1);
        if (next == std::string::npos) break;
        shown = "\u2026" + shown.substr(next);
    }
    return shown;
}

void draw_way(FileChooser& chooser, TabOrder& order) {
    const fs::path here = chooser.listing.folder;
    if (button(order, "Up")) go(chooser, here.parent_path());
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(end_of(here.string(), ImGui::GetContentRegionAvail().x).c_str());
}

// One row; true if it was double-clicked.
bool draw_entry(FileChooser& chooser, std::size_t row) {
    const FolderEntry& entry = chooser.listing.entries[row];
    const bool is_current = chooser.cursor == row;
    bool opened = false;
    ImGui::PushID(static_cast<int>(row));
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    // A name may hold ImGui's own mark "##": it is written beside the row, not as its label.
    if (ImGui::Selectable("##row", is_current,
                          ImGuiSelectableFlags_AllowDoubleClick |
                              ImGuiSelectableFlags_DontClosePopups |
                              ImGuiSelectableFlags_SpanAllColumns)) {
        chooser.cursor = row;
        chooser.name = entry.name;
        chooser.focus_name = true;
        opened = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    }
    if (is_current && std::exchange(chooser.scroll_to_cursor, false)) ImGui::SetScrollHereY();
    ImGui::SameLine(0.0F, 0.0F);
    ImGui::TextUnformatted((entry.name + (entry.is_folder ? "/" : "")).c_str());
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", entry.changed.c_str());
    ImGui::PopID();
    return opened;
}

void draw_entries(FileChooser& chooser, bool& opened) {
    constexpr ImGuiTableFlags kFlags =
        ImGuiTableFlags_ScrollY | ImGuiTableFlags_NoSavedSettings | ImGuiTableFlags_PadOuterX;
    if (!ImGui::BeginTable("##entries", 2, kFlags, ImGui::GetContentRegionAvail())) return;
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("Name");
    ImGui::TableSetupColumn("Changed", ImGuiTableColumnFlags_WidthFixed,
                            kChangedWidth * ImGui::GetFontSize());
    ImGui::TableHeadersRow();
    ImGuiListClipper rows;
    rows.Begin(static_cast<int>(chooser.listing.entries.size()));
    if (chooser.cursor && chooser.scroll_to_cursor) {
        const int row = static_cast<int>(*chooser.cursor);
        rows.ForceDisplayRangeByIndices(row, row + 1);
    }
    while (rows.Step()) {
        for (int row = rows.DisplayStart; row < rows.DisplayEnd; ++row) {
            opened |= draw_entry(chooser, static_cast<std::size_t>(row));
        }
    }
    ImGui::EndTable();
}

const char* nothing_there(ChooserUse use) {
    return use == ChooserUse::open ? "Nothing here that can be opened."
                                   : "No folder and no file of this kind yet.";
}

Chosen draw_list(FileChooser& chooser, TabOrder& order) {
    const float below =
        2.0F * ImGui::GetFrameHeightWithSpacing() + ImGui::GetTextLineHeightWithSpacing();
    bool opened = false;
    draw_places(chooser, order, -below);
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
    const bool is_visible =
        ImGui::BeginChild("##list", {0.0F, -below}, false, ImGuiWindowFlags_NoNavInputs);
    ImGui::PopStyleColor();
    if (is_visible) {
        if (chooser.listing.entries.empty()) {
            ImGui::SetCursorPos(ImGui::GetStyle().WindowPadding);
            const std::string& fault = chooser.listing.fault;
            ImGui::TextWrapped("%s", fault.empty() ? nothing_there(chooser.use) : fault.c_str());
        } else {
            draw_entries(chooser, opened);
        }
    }
    ImGui::EndChild();
    return opened ? accept(chooser) : std::nullopt;
}

bool is_pressed(ImGuiKey which) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(which), false); }

// The folder itself, where that may be an answer.
Chosen whole_folder(FileChooser& chooser) {
    if (!chooser.folders_too || !chooser.listing.fault.empty()) return std::nullopt;
    if (chooser.use == ChooserUse::save_folder) {
        return accept_folder(chooser, chooser.listing.folder);
    }
    return chooser.listing.folder;
}

const char* name_hint(const FileChooser& chooser) {
    if (chooser.makes_folder) return "Name of a folder to make here";
    switch (chooser.use) {
        case ChooserUse::open:
            return "File name or path";
        case ChooserUse::save:
            return "New file's name or path";
        case ChooserUse::save_folder:
            return "New folder's name or path";
    }
    return "";
}

// The folder that was named, made here and gone to.
void make_folder(FileChooser& chooser) {
    const fs::path path = typed_path(chooser, chooser.name);
    std::error_code failure;
    const bool made = !chooser.name.empty() && fs::create_directory(path, failure);
    chooser.makes_folder = false;
    if (made) return go(chooser, path);
    chooser.name = chooser.offered;
    chooser.remark = failure ? path.string() + " was not made: " + failure.message() + "."
                             : "No folder was made: there is one of this name.";
}

// Where a file may be of several kinds: the ending of its name, by choice.
void draw_format(FileChooser& chooser) {
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-FLT_MIN);
    const auto& all = chooser.extensions;
    const auto ends = [&](const std::string& one) { return has_extension(chooser.name, {one}); };
    const auto shown = std::ranges::find_if(all, ends);
    if (!ImGui::BeginCombo("##format", shown == all.end() ? all[0].c_str() : shown->c_str()))
        return;
    for (const std::string& one : all) {
        if (!ImGui::Selectable(one.c_str(), ends(one))) continue;
        if (shown != all.end()) chooser.name.resize(chooser.name.size() - shown->size());
        chooser.name += one;
    }
    ImGui::EndCombo();
}

Chosen draw_name(FileChooser& chooser, WidgetRects& rects) {
    const bool was_empty = chooser.name.empty();
    const bool has_formats =
        chooser.use == ChooserUse::save && chooser.extensions.size() > 1 && !chooser.makes_folder;
    if (std::exchange(chooser.focus_name, false)) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(has_formats ? -kFormatWidth * ImGui::GetFontSize() : -FLT_MIN);
    const bool entered = ImGui::InputTextWithHint("##name", name_hint(chooser), &chooser.name,
                                                  ImGuiInputTextFlags_EnterReturnsTrue |
                                                      ImGuiInputTextFlags_CallbackHistory |
                                                      ImGuiInputTextFlags_AutoSelectAll,
                                                  on_history, &chooser);
    note_item(rects, "file name", chooser.name);
    const bool goes_up = was_empty && ImGui::IsItemActive() && is_pressed(ImGuiKey_Backspace);
    if (has_formats) draw_format(chooser);
    if (goes_up) go(chooser, chooser.listing.folder.parent_path());
    if (!entered) return std::nullopt;
    chooser.focus_name = true;  // Enter takes the focus from the field
    if (chooser.makes_folder) {
        make_folder(chooser);
        return std::nullopt;
    }
    return ImGui::GetIO().KeyCtrl && chooser.folders_too ? whole_folder(chooser) : accept(chooser);
}

// For a folder that is made here: the two buttons, and back to choosing.
void draw_making(FileChooser& chooser, TabOrder& order) {
    if (button(order, "Make the folder")) make_folder(chooser);
    ImGui::SameLine();
    if (!button(order, "Back") && !is_pressed(ImGuiKey_Escape)) return;
    chooser.makes_folder = false;
    chooser.name = chooser.offered;
    chooser.focus_name = true;
}

Chosen draw_buttons(FileChooser& chooser, TabOrder& order, const Theme& theme) {
    Chosen chosen;
    if (primary_button(theme, chooser.use == ChooserUse::open ? "Open" : "Save"))
        chosen = accept(chooser);
    note_stop(order);
    if (chooser.folders_too) {
        ImGui::SameLine();
        const bool saves = chooser.use == ChooserUse::save_folder;
        if (button(order, saves ? "Save into this folder" : "Open this folder")) {
            chosen = whole_folder(chooser);
        }
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s (Ctrl-Enter)",
                              saves ? "Makes no new folder in it" : "All files of the folder");
        }
    }
    ImGui::SameLine();
    if (button(order, "Cancel") || is_pressed(ImGuiKey_Escape)) chooser.is_open = false;
    if (chooser.use == ChooserUse::open) return chosen;
    const float width =
        ImGui::CalcTextSize("New folder...").x + 2.0F * ImGui::GetStyle().FramePadding.x;
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width);
    if (button(order, "New folder...")) {
        chooser.makes_folder = chooser.focus_name = true;
        chooser.name.clear();
    }
    return chosen;
}

Chosen draw_replace_question(FileChooser& chooser, TabOrder& order) {
    const fs::path path = chooser.replacing;
    const bool of_folder = chooser.use == ChooserUse::save_folder;
    ImGui::TextWrapped(of_folder ? "%s exists there. Replace it, and others of this export?"
                                 : "%s exists. Replace it?",
                       path.filename().c_str());
    const bool enter = is_pressed(ImGuiKey_Enter) && !order.is_on_button;
    const bool yes = button(order, "Replace") || enter;
    ImGui::SameLine();
    const bool no = button(order, "Keep it") || is_pressed(ImGuiKey_Escape);
    if (yes || no) {
        chooser.replacing.clear();
        chooser.focus_name = true;
    }
    if (!yes) return std::nullopt;
    return of_folder ? path.parent_path() : path;
}

Chosen draw_content(FileChooser& chooser, WidgetRects& rects, const Theme& theme) {
    TabOrder& order = rects.tab_order;
    const bool asks = !chooser.replacing.empty();
    ImGui::BeginDisabled(asks);
    draw_way(chooser, order);
    Chosen chosen = draw_list(chooser, order);
    if (!asks && !chosen) chosen = draw_name(chooser, rects);
    ImGui::EndDisabled();
    if (asks) return draw_replace_question(chooser, order);
    ImGui::TextWrapped("%s", chooser.remark.c_str());
    if (chooser.makes_folder) {
        draw_making(chooser, order);
    } else if (const Chosen pressed = draw_buttons(chooser, order, theme)) {
        chosen = pressed;
    }
    return chosen;
}

}  // namespace

void show(FileChooser& chooser, const fs::path& folder, const std::string& name) {
    std::error_code none;
    const fs::path absolute = fs::absolute(folder.empty() ? home_folder() : folder, none);
    chooser.is_open = chooser.appears = true;
    chooser.replacing.clear();
    chooser.makes_folder = false;
    go(chooser, is_folder(absolute) ? absolute : home_folder());
    chooser.name = chooser.offered = name;
}

Chosen draw(FileChooser& chooser, WidgetRects& rects, const Theme& theme) {
    if (!chooser.is_open) return std::nullopt;
    const std::string label = chooser.title + "###file chooser";
    if (std::exchange(chooser.appears, false)) ImGui::OpenPopup(label.c_str());
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowSize({std::min(kDialogWidth * em, 0.95F * screen.x),
                              std::min(kDialogHeight * em, 0.95F * screen.y)});
    ImGui::SetNextWindowPos({0.5F * screen.x, 0.5F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
    Chosen chosen;
    ImFont* const before = push_dialog_head(theme);
    const bool is_visible = ImGui::BeginPopupModal(
        label.c_str(), nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
    pop_dialog_head(before);
    if (is_visible) {
        chosen = draw_content(chooser, rects, theme);
        if (chosen) chooser.is_open = false;
        if (!chooser.is_open) ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
    }
    return chosen;
}

}  // namespace tact
