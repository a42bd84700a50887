// Participants' files follow the document that they belong to. Declared in
// app/study/study_follow.h.

#include "app/document/editing.h"
#include "app/session/folders.h"
#include "app/study/study_follow.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

// Onto another disk they are copied, and the first ones stay: nobody can be asked again.
bool move_or_copy(const fs::path& from, const fs::path& to) {
    std::error_code fault;
    fs::rename(from, to, fault);
    if (!fault) return true;
    fault.clear();
    fs::copy(from, to, fs::copy_options::recursive, fault);
    if (!fault) return true;
    std::error_code none;
    fs::remove_all(to, none);
    return false;
}

}  // namespace

void keep_participants(Ui& ui, const Workspace& work, StudyState& studying,
                       const SavedFrom& place_before) {
    const fs::path before = study_folder(work, studying, place_before);
    const fs::path now = study_folder(work, studying);
    if (now == before || !contains_study(before)) return;
    ++studying.folder_revision;
    if (place_before.file.empty() && !is_there(now) && move_or_copy(before, now)) {
        return say(ui, ui.status.text + " Its participants are now in " + now.string() + ".");
    }
    set_study_folder(work, studying, before);
    say(ui, ui.status.text + " Its participants stay in " + before.string() +
                "; Study > Folder for participants... chooses another one.");
}

}  // namespace tact
