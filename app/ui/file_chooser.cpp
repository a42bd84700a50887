#include "app/ui/ui.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "app/ui/widgets.h"
#include "model/text/shown_text.h"
#include "viz/drawing/imgui_versions.h"

namespace tact {
namespace {

namespace fs = std::filesystem;
using Chosen = std::optional<fs::path>;

// Width and height of the dialog, in heights of the font.
constexpr float kDialogWidth = 44.0F;
constexpr float kDialogHeight = 30.0F;
constexpr float kPlacesWidth = 9.0F;
constexpr float kChangedWidth = 8.5F;
constexpr float kFormatWidth = 9.0F;

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

// Up and down in the name field. ImGui changes an active field only from inside its callback.
int on_history(ImGuiInputTextCallbackData* field) {
    FileChooser& chooser = *static_cast<FileChooser*>(field->UserData);
    move_cursor(chooser, field->EventKey == ImGuiKey_DownArrow);
    if (!chooser.cursor) return 0;
    field->DeleteChars(0, field->BufTextLen);
    field->InsertChars(0, chooser.listing.entries[*chooser.cursor].name.c_str());
    return 0;
}

bool button(Ui& ui, const char* label) {
    const bool pressed = ImGui::Button(label);
    note_stop(ui.rects.tab_order);
    return pressed;
}

void draw_place(Ui& ui, const char* label, const fs::path& place) {
    ImGui::PushID(place.c_str());
    const bool here = ui.chooser.listing.folder == place;
    if (ImGui::Selectable(label, here, ImGuiSelectableFlags_DontClosePopups))
        go_to_folder(ui.chooser, place);
    note_stop(ui.rects.tab_order);
    draw_tooltip(ui, place.c_str());
    ImGui::PopID();
}

// The folders of the desktop, and recently used ones.
void draw_places(Ui& ui, float height_px) {
    ImGui::BeginChild("##places", {kPlacesWidth * ImGui::GetFontSize(), height_px});
    // A chosen row reaches half of the spacing past its words.
    const ImVec2 spacing{2.0F * ui.theme.gap_px, ImGui::GetStyle().ItemSpacing.y};
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, spacing);
    ImGui::Indent(ui.theme.gap_px);
    if (ui.pick_files && ui.chooser.use == ChooserUse::open) {
        const Item item{.id = "chooser:device",
                        .label = "This device\u2026",
                        .tip = "Files of this device, picked in a dialog of the browser"};
        if (option(ui, item, false, ImGuiSelectableFlags_DontClosePopups)) {
            ui.chooser.is_open = false;
            ui.pick_files();
        }
    }
    draw_place(ui, "Home", home_folder());
    for (const char* name : {"Desktop", "Documents", "Downloads"}) {
        if (is_folder(home_folder() / name)) draw_place(ui, name, home_folder() / name);
    }
    draw_place(ui, "Computer", "/");
    const std::vector<fs::path> recent = ui.chooser.recent;
    if (!recent.empty()) {
        ImGui::Spacing();
        ImGui::TextDisabled("Recent");
    }
    for (const fs::path& place : recent) draw_place(ui, place.filename().c_str(), place);
    ImGui::PopStyleVar();
    ImGui::EndChild();
}

// The path with its beginning cut off: folders differ at its end.
std::string end_of(const std::string& path, float room_px) {
    std::string shown = path;
    while (ImGui::CalcTextSize(shown.c_str()).x > room_px) {
        const std::size_t next = shown.find('/', shown.starts_with("\u2026/") ? 4 : 1);
        if (next == std::string::npos) break;
        shown = "\u2026" + shown.substr(next);
    }
    return shown;
}

void draw_way(Ui& ui) {
    const fs::path here = ui.chooser.listing.folder;
    if (button(ui, "Up")) go_to_folder(ui.chooser, here.parent_path());
    draw_tooltip(ui, "To the folder that this one is in (Backspace in an empty name)");
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(
        end_of(shown_text(here.string()), ImGui::GetContentRegionAvail().x).c_str());
    draw_tooltip(ui, here.c_str());
}

// One row; true if it was double-clicked.
bool draw_entry(FileChooser& chooser, std::size_t row) {
    const FolderEntry& entry = chooser.listing.entries[row];
    const bool is_current = chooser.cursor == row;
    bool opened = false;
    ImGui::PushID(static_cast<int>(row));
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    // A name may contain ImGui's mark "##", so it is written beside the row, not as its label.
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
    ImGui::TextUnformatted(shown_text(entry.name + (entry.is_folder ? "/" : "")).c_str());
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
    if (const std::string lack = lack_of_files(chooser); !lack.empty()) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::PushTextWrapPos(0.0F);  // in some fonts a list of kinds is wider than the column
        ImGui::TextDisabled("%s", shown_text(lack).c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::EndTable();
}

Chosen draw_list(Ui& ui) {
    FileChooser& chooser = ui.chooser;
    const float below =
        2.0F * ImGui::GetFrameHeightWithSpacing() + ImGui::GetTextLineHeightWithSpacing();
    bool opened = false;
    draw_places(ui, -below);
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
    const bool is_visible =
        ImGui::BeginChild("##list", {0.0F, -below}, false, ImGuiWindowFlags_NoNavInputs);
    ImGui::PopStyleColor();
    if (is_visible) {
        if (chooser.listing.entries.empty()) {
            const std::string& fault = chooser.listing.fault;
            ImGui::SetCursorPos(ImGui::GetStyle().WindowPadding);
            wrapped_text(fault.empty() ? lack_of_files(chooser) : fault);
            note_rect(ui.rects, "nothing to choose", ImGui::GetItemRectMin(),
                      ImGui::GetItemRectMax(), fault.empty() ? lack_of_files(chooser) : fault);
        } else {
            draw_entries(chooser, opened);
        }
    }
    ImGui::EndChild();
    return opened ? accept_name(chooser) : std::nullopt;
}

bool is_pressed(ImGuiKey which) { return ImGui::IsKeyPressed(which, false); }

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

// A choice of extensions, if the file may be of several kinds.
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

Chosen draw_name(Ui& ui) {
    FileChooser& chooser = ui.chooser;
    const bool was_empty = chooser.name.empty();
    const bool has_formats =
        chooser.use == ChooserUse::save && chooser.extensions.size() > 1 && !chooser.makes_folder;
    if (std::exchange(chooser.focus_name, false)) focus_next_item();
    ImGui::SetNextItemWidth(has_formats ? -kFormatWidth * ImGui::GetFontSize() : -FLT_MIN);
    const bool entered = ImGui::InputTextWithHint("##name", name_hint(chooser), &chooser.name,
                                                  ImGuiInputTextFlags_EnterReturnsTrue |
                                                      ImGuiInputTextFlags_CallbackHistory |
                                                      ImGuiInputTextFlags_AutoSelectAll,
                                                  on_history, &chooser);
    note_item(ui.rects, "file name", chooser.name);
    const bool goes_up = was_empty && ImGui::IsItemActive() && is_pressed(ImGuiKey_Backspace);
    if (has_formats) draw_format(chooser);
    if (goes_up) go_to_folder(chooser, chooser.listing.folder.parent_path());
    if (!entered) return std::nullopt;
    chooser.focus_name = true;  // Enter takes the focus from the field
    if (chooser.makes_folder) {
        make_folder(chooser);
        return std::nullopt;
    }
    return ImGui::GetIO().KeyCtrl && chooser.folders_too ? accept_folder(chooser)
                                                         : accept_name(chooser);
}

// While a folder is being named: a button to make it, and one to return.
void draw_making(Ui& ui) {
    FileChooser& chooser = ui.chooser;
    if (button(ui, "Make the folder")) make_folder(chooser);
    ImGui::SameLine();
    if (!button(ui, "Back") && !is_pressed(ImGuiKey_Escape)) return;
    chooser.makes_folder = false;
    chooser.name = chooser.offered;
    chooser.focus_name = true;
}

// Opens or saves the named path; without a name, tells what is missing.
Chosen draw_choose(Ui& ui) {
    FileChooser& chooser = ui.chooser;
    const std::string lack = lack_of_name(chooser);
    const Item item{.id = "button:choose",
                    .label = chooser.use == ChooserUse::open ? "Open" : "Save",
                    .why_not = lack,
                    .value = lack};
    return primary_button(ui, item) ? accept_name(chooser) : std::nullopt;
}

Chosen draw_whole_folder(Ui& ui) {
    ImGui::SameLine();
    const bool saves = ui.chooser.use == ChooserUse::save_folder;
    const bool pressed = button(ui, saves ? "Save into this folder" : "Open this folder");
    draw_tooltip(ui, saves ? "Makes no new folder in it (Ctrl+Enter)"
                           : "All files of the folder (Ctrl+Enter)");
    return pressed ? accept_folder(ui.chooser) : std::nullopt;
}

Chosen draw_buttons(Ui& ui) {
    FileChooser& chooser = ui.chooser;
    Chosen chosen = draw_choose(ui);
    if (chooser.folders_too && !chosen) chosen = draw_whole_folder(ui);
    ImGui::SameLine();
    if (button(ui, "Cancel") || is_pressed(ImGuiKey_Escape)) chooser.is_open = false;
    if (chooser.use == ChooserUse::open) return chosen;
    constexpr const char* kNew = "New folder...";
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - button_width(kNew));
    if (button(ui, kNew)) {
        chooser.makes_folder = chooser.focus_name = true;
        chooser.name.clear();
    }
    return chosen;
}

Chosen draw_replace_question(Ui& ui) {
    FileChooser& chooser = ui.chooser;
    const fs::path path = chooser.replacing;
    const bool of_folder = chooser.use == ChooserUse::save_folder;
    ImGui::TextWrapped(of_folder ? "%s exists there. Replace it, and others of this export?"
                                 : "%s exists. Replace it?",
                       path.filename().c_str());
    const bool enter = is_pressed(ImGuiKey_Enter) && !ui.rects.tab_order.is_on_button;
    const bool yes = button(ui, "Replace") || enter;
    ImGui::SameLine();
    const bool no = button(ui, "Keep it") || is_pressed(ImGuiKey_Escape);
    if (yes || no) {
        chooser.replacing.clear();
        chooser.focus_name = true;
    }
    if (!yes) return std::nullopt;
    return of_folder ? path.parent_path() : path;
}

Chosen draw_content(Ui& ui) {
    FileChooser& chooser = ui.chooser;
    const bool asks = !chooser.replacing.empty();
    ImGui::BeginDisabled(asks);
    draw_way(ui);
    Chosen chosen = draw_list(ui);
    if (!asks && !chosen) chosen = draw_name(ui);
    ImGui::EndDisabled();
    if (asks) return draw_replace_question(ui);
    ImGui::TextWrapped("%s", shown_text(chooser.remark).c_str());
    if (chooser.makes_folder) {
        draw_making(ui);
    } else if (const Chosen pressed = draw_buttons(ui)) {
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
    go_to_folder(chooser, is_folder(absolute) ? absolute : home_folder());
    chooser.name = chooser.offered = name;
}

Chosen draw_file_chooser(Ui& ui) {
    FileChooser& chooser = ui.chooser;
    if (!chooser.is_open) return std::nullopt;
    const std::string label = chooser.title + "###file chooser";
    if (std::exchange(chooser.appears, false)) ImGui::OpenPopup(label.c_str());
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowSize({std::min(kDialogWidth * em, 0.95F * screen.x),
                              std::min(kDialogHeight * em, 0.95F * screen.y)});
    ImGui::SetNextWindowPos({0.5F * screen.x, 0.5F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImFont* const before = push_dialog_head(ui.theme);
    const bool is_visible = ImGui::BeginPopupModal(
        label.c_str(), nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
    pop_dialog_head(before);
    if (!is_visible) return std::nullopt;
    const Chosen chosen = draw_content(ui);
    if (chosen) chooser.is_open = false;
    if (!chooser.is_open) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return chosen;
}

void ask_for_file(Ui& ui, const FileQuestion& question, const std::filesystem::path& folder,
                  const std::string& name) {
    ui.take_chosen = question.take;
    ui.chooser.use = question.use;
    ui.chooser.title = question.title;
    ui.chooser.extensions = question.extensions;
    ui.chooser.folders_too = question.folders_too;
    ui.chooser.file_names = question.file_names;
    show(ui.chooser, folder, name);
}

}  // namespace tact
