#include "app/document/unsaved.h"

#include <utility>

#include "app/document/editing.h"
#include "app/session/autosave.h"
#include "app/session/document_file.h"
#include "app/session/folders.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

bool is_same_file(const fs::path& a, const fs::path& b) {
    std::error_code none;
    return a == b || fs::equivalent(a, b, none);
}

}  // namespace

std::string with_stop(std::string text) {
    if (!text.empty() && text.back() != '.') text += '.';
    return text;
}

void wait_for_autosave(const Workspace& work) {
    if (work.autosave_write.valid()) work.autosave_write.wait();
}

Expected<fs::path> keep_unsaved(Workspace& work) {
    wait_for_autosave(work);
    if (work.document.set == work.document.saved) return fs::path{};
    if (const Expected<Done> kept = autosave(work.session, work.document.kept()); !kept)
        return kept.error();
    return set_autosave_aside(work.session);
}

void refuse_to_replace(Ui& ui, const std::string& reason) {
    complain(ui,
             "This document stays open: its unsaved changes cannot be kept aside. Save it first, "
             "with File > Save as... " +
                 with_stop(reason));
}

bool is_changed_outside(const Document& document, const fs::path& file) {
    if (!document.file_mark || document.path.empty() || !is_there(file)) return false;
    if (!is_same_file(file, document.path)) return false;
    return content_mark(file) != document.file_mark;
}

}  // namespace tact
