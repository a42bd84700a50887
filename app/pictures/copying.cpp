#include "app/pictures/copying.h"

#include <imgui.h>

#include <string_view>
#include <utility>
#include <vector>

#include "app/document/editing.h"
#include "app/document/shown_side.h"
#include "model/io/set/set_file.h"

namespace tact {

namespace {

// What else lies on the clipboard of a desktop is not for us.
bool is_set_text(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    return begin != text.npos && text[begin] == '{' &&
           text.substr(begin, 400).find("\"tactspace\"") != text.npos;
}

}  // namespace

void copy_selected(Ui& ui, Workspace& work) {
    PatternSet copied;
    for (const std::size_t index : selected_indices(work)) {
        copied.vibrations.push_back(work.document.set.vibrations[index]);
    }
    work.clipboard_text = print_set(copied);
    work.clipboard = std::move(copied.vibrations);
    ImGui::SetClipboardText(work.clipboard_text.c_str());
    say(ui, work.clipboard.size() == 1 ? "Copied " + work.clipboard[0].name
                                       : "Copied " + patterns_text(work.clipboard.size()));
}

void paste(Ui& ui, Workspace& work) {
    const char* text = ImGui::GetClipboardText();
    std::vector<Vibration> pasted = work.clipboard;
    // From another window, or from an editor in which a set file is open.
    if (text != nullptr && text != work.clipboard_text && is_set_text(text)) {
        Expected<PatternSet> set = parse_set(text, "the clipboard", {});
        if (!set) return complain(ui, "Not pasted: " + set.error().message);
        pasted = std::move(set->vibrations);
    }
    if (pasted.empty()) {
        say(ui, "Nothing to paste: copy a pattern first, here or as the text of a set file");
        return;
    }
    const std::string what = pasted.size() == 1 ? pasted[0].name : patterns_text(pasted.size());
    insert_after_current(work, pasted);
    commit_step(ui, work, pasted.size() == 1 ? "Paste " + what : "Paste patterns");
    say(ui, "Pasted " + what);
}

}  // namespace tact
