#include "app/document/files.h"

#include <algorithm>

#include "app/document/autosave.h"
#include "app/document/editing.h"
#include "app/ui/file_question.h"
#include "assets/assets.h"
#include "model/io/set/load.h"
#include "model/io/set/measured_files.h"
#include "model/io/set/set_file.h"
#include "model/text/atomic_file.h"

namespace tact {

namespace {

constexpr double kAutosaveRestS = 0.6;
constexpr const char* kExample = "sets/pm_2023_twelve.tactspace.json";
constexpr const char* kSetEnding = ".tactspace.json";

PatternSet example_set() {
    auto set = parse_set(asset(kExample), kExample, {});
    assert(set && "the compiled-in example set does not parse");
    return *std::move(set);
}

bool is_set_file(const std::filesystem::path& path) {
    return path.filename().string().ends_with(".json");
}

// Unsaved changes of the document that another one replaces go to a file of their own, which heads
// the recent ones: opening never asks, and nothing is lost. Empty: there were none.
std::filesystem::path keep_unsaved(App& app) {
    if (app.document.set == app.document.saved) return {};
    if (!autosave(app.session, app.document)) return {};
    const auto aside = set_autosave_aside(app.session);
    return aside ? *aside : std::filesystem::path();
}

std::string joined(const std::vector<std::string>& remarks) {
    constexpr std::size_t kMost = 3;
    std::string text;
    for (std::size_t k = 0; k < std::min(remarks.size(), kMost); ++k) {
        text += (k == 0 ? "" : "; ") + remarks[k];
    }
    if (remarks.size() > kMost) {
        text += "; and " + std::to_string(remarks.size() - kMost) + " more remarks";
    }
    return text;
}

std::filesystem::path folder_of(const Document& document) {
    return document.path.empty() ? std::filesystem::path() : document.path.parent_path();
}

std::string patterns_text(std::size_t count) {
    return count == 1 ? "1 pattern" : std::to_string(count) + " patterns";
}

}  // namespace

std::string document_title(const App& app) {
    const std::string file = app.document.path.filename().string();
    std::string title = app.document.set.name;
    if (title.empty()) title = file.empty() ? "Untitled" : file;
    if (!file.empty() && title != file) title += "  (" + file + ")";
    return title + (app.unsaved ? " \u2022" : "");
}

// Another document takes the place of the open one. Undo does not reach across: a set brought back
// by it would be saved over the wrong file.
void show_document(App& app, Document document, std::string text) {
    const std::filesystem::path aside = keep_unsaved(app);
    if (!aside.empty()) text += " Unsaved changes before it are kept in " + aside.string();
    app.document = std::move(document);
    app.selection = {};
    app.fonts_outdated = true;  // its names may need other glyphs
    ++app.document_number;      // what was asked for of the one before it is forgotten
    app.partner.clear();
    app.history.clear();
    app.committed = std::make_shared<const PatternSet>(app.document.set);
    document_changed(app);
    say(app, text);
}

void new_document(App& app) { show_document(app, {}, "A new, empty set."); }

void open_example(App& app) {
    const PatternSet set = example_set();
    show_document(app, {set, {}, set}, "The twelve patterns of Lim & Park 2023, section 6.1.");
}

void open_paths(App& app, const std::vector<std::filesystem::path>& paths) {
    if (paths.empty()) return;
    Expected<Loaded> loaded = load_sets(paths);
    if (!loaded) return complain(app, loaded.error().message);
    Document document;
    document.set = std::move(loaded->set);
    document.saved = document.set;
    if (paths.size() == 1) document.path = std::filesystem::absolute(paths[0]);
    for (const auto& path : paths) remember_file(app.session, std::filesystem::absolute(path));
    std::string text = "Opened " + patterns_text(document.set.vibrations.size());
    text += loaded->remarks.empty() ? "." : ": " + joined(loaded->remarks) + ".";
    show_document(app, std::move(document), text);
}

void save_as(App& app, const std::filesystem::path& path) {
    std::filesystem::path target = std::filesystem::absolute(path);
    if (!is_set_file(target)) target += kSetEnding;
    PatternSet set = app.document.set;
    if (set.name.empty()) {
        set.name = target.filename().string();
        if (set.name.ends_with(kSetEnding)) set.name.resize(set.name.size() - 15);
    }
    const Expected<Done> stored = store_measurements(set, target, measured_folder(app.session));
    if (!stored) return complain(app, "Not saved: " + stored.error().message);
    const Expected<Done> written = write_set_file(target, set);
    if (!written) return complain(app, "Not saved: " + written.error().message);
    app.document.set = set;  // with its name, and with files of measurements beside it
    app.document.path = target;
    app.document.saved = app.document.set;
    app.unsaved_revision = 0;  // look again
    remember_file(app.session, target);
    say(app, "Saved " + target.string());
}

void save(App& app) {
    // Recordings in a folder become a set only under a name of its own.
    if (!is_set_file(app.document.path)) return save_dialog(app);
    save_as(app, app.document.path);
}

void open_dialog(App& app) {
    ask_for_file(app,
                 {.purpose = ChooserPurpose::open_document,
                  .use = ChooserUse::open,
                  .title = "Open a set, a folder of recordings, or a recording",
                  .extensions = {".json", ".wav", ".txt"},
                  .folders_too = true},
                 folder_of(app.document));
}

void save_dialog(App& app) {
    std::string name = app.document.set.name.empty() ? "untitled" : app.document.set.name;
    std::ranges::replace(name, '/', '-');
    ask_for_file(app,
                 {.purpose = ChooserPurpose::save_document,
                  .use = ChooserUse::save,
                  .title = "Save the set",
                  .extensions = {kSetEnding}},
                 folder_of(app.document), name + kSetEnding);
}

void load_tables_dialog(App& app) {
    ask_for_file(app,
                 {.purpose = ChooserPurpose::load_tables,
                  .use = ChooserUse::open,
                  .title = "Load a table of slopes or of thresholds",
                  .extensions = {".csv"}},
                 folder_of(app.document));
}

void load_tables(App& app, const std::filesystem::path& path) {
    const Expected<std::string> text = read_text_file(path);
    if (!text) return complain(app, text.error().message);
    const bool thresholds = text->find("threshold_log10_um_peak") != std::string::npos;
    const auto curves = thresholds ? parse_thresholds(*text) : parse_slopes(*text);
    if (!curves) return complain(app, path.filename().string() + ": " + curves.error().message);
    PhysiologyTables& tables = app.document.set.model.coding.tables;
    (thresholds ? tables.threshold : tables.slope) = *curves;
    document_changed(app);
    commit_step(app, thresholds ? "Load thresholds" : "Load slopes");
    say(app, std::string(thresholds ? "Thresholds" : "Slopes") + " loaded from " + path.string());
}

void autosave_if_due(App& app) {
    if (app.unsaved_revision != app.revision) {
        app.unsaved = !(app.document.set == app.document.saved);
        app.unsaved_revision = app.revision;
        app.autosave_due_s = app.time_s + kAutosaveRestS;
        app.autosave_pending = true;
    }
    // A drag writes once it rests.
    if (!app.autosave_pending || app.time_s < app.autosave_due_s) return;
    app.autosave_pending = false;
    const Expected<Done> written = autosave(app.session, app.document);
    if (!written) complain(app, "Unsaved changes cannot be kept: " + written.error().message);
}

}  // namespace tact
