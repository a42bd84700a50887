#include "app/document/unsaved.h"

#include <utility>

#include "app/document/autosave.h"
#include "app/document/document_file.h"
#include "app/document/editing.h"
#include "app/document/files.h"
#include "app/document/folders.h"
#include "app/study/study_follow.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

void leave_study(App& app) {
    using What = StudyEvent::What;
    for (const What what : {What::ask, What::leave}) act(app, {what, 0, 0.0, {}, {}});
}

void discard_and_quit(App& app) {
    app.document.set = app.document.saved;  // or the end would try to keep it once more
    app.quit = true;
}

std::string with_stop(std::string text) {
    if (!text.empty() && text.back() != '.') text += '.';
    return text;
}

bool is_same_file(const fs::path& a, const fs::path& b) {
    std::error_code none;
    return a == b || fs::equivalent(a, b, none);
}

}  // namespace

Expected<fs::path> keep_unsaved(App& app) {
    if (app.document.set == app.document.saved) return fs::path{};
    if (const Expected<Done> kept = autosave(app.session, app.document); !kept) return kept.error();
    return set_autosave_aside(app.session);
}

void refuse_to_replace(App& app, const std::string& reason) {
    complain(app,
             "This document stays open: its unsaved changes cannot be kept aside. Save it first, "
             "with File > Save as... " +
                 with_stop(reason));
}

bool may_close(App& app) {
    if (is_study_running(app)) leave_study(app);
    const Expected<Done> kept = autosave(app.session, app.document);
    if (kept) return true;
    ask(app,
        {.title = "Unsaved changes",
         .text = "The unsaved changes of " + document_name(app) +
                 " cannot be kept for the next start, and would be lost. " +
                 with_stop(kept.error().message),
         .answers = {
             {"Save as...", save_dialog}, {"Discard and quit", discard_and_quit}, {"Cancel"}}});
    return false;
}

void quit(App& app) {
    if (may_close(app)) app.quit = true;
}

bool is_changed_outside(const Document& document, const fs::path& file) {
    if (!document.file_mark || document.path.empty() || !is_there(file)) return false;
    if (!is_same_file(file, document.path)) return false;
    return content_mark(file) != document.file_mark;
}

void tell_of_start(App& app) {
    std::string text;
    for (const std::string& remark : app.session.remarks) {
        text += (text.empty() ? "" : " ") + with_stop(remark);
    }
    const std::vector<fs::path>& recovered = app.session.recovered;
    for (const fs::path& file : recovered) {
        text += std::string(text.empty() ? "" : " ") +
                "Unsaved changes of a window that did not end as it should are kept in " +
                file.string() + ".";
    }
    if (text.empty()) return;
    if (recovered.size() != 1) return tell(app, "Before you begin", text);
    ask(app, {.title = "Before you begin",
              .text = text,
              .answers = {{"Open them", [file = recovered[0]](App& to) { open_paths(to, {file}); }},
                          {"Not now"}}});
}

}  // namespace tact
