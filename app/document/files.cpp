#include <algorithm>
#include <chrono>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/jobs/jobs.h"
#include "app/session/session.h"
#include "app/ui/ui.h"
#include "assets/assets.h"
#include "model/common/expected.h"
#include "model/io/people/ratings_file.h"
#include "model/io/set/load.h"
#include "model/io/set/measured_files.h"
#include "model/io/set/set_file.h"
#include "model/set/felt_versions.h"
#include "model/set/measured_twin.h"
#include "model/set/set_ratings.h"
#include "model/text/atomic_file.h"
#include "model/text/names.h"

namespace tact {

namespace {

constexpr double kAutosaveRestS = 0.6;
constexpr double kMostUnkeptS = 1.0;
constexpr const char* kSetEnding = ".tactspace.json";

PatternSet parsed(const ExampleSet& example) {
    auto set = parse_set(asset(example.path), example.path, {});
    assert(set && "the compiled-in example set does not parse");
    return *std::move(set);
}

bool is_set_file(const std::filesystem::path& path) {
    return path.filename().string().ends_with(".json");
}

// What the person is told of a document that another of their windows has open as well.
constexpr const char* kOpenTwice =
    " It is also open in another window. You will be asked before either overwrites the other.";

// Recordings in a folder and effects of other programs are no set files.
bool has_set_file(const EditedDocument& document) {
    return is_set_file(document.path) && !holds_effects(document.path);
}

std::filesystem::path folder_of(const EditedDocument& document) {
    return document.path.empty() ? std::filesystem::path() : document.path.parent_path();
}

}  // namespace

std::string document_name(const Workspace& work) {
    const std::string file = work.document.path.filename().string();
    std::string title = work.document.set.name;
    if (title.empty()) title = file.empty() ? "Untitled" : file;
    if (!file.empty() && title != file) title += "  (" + file + ")";
    return title;
}

std::string document_title(const Workspace& work) {
    return document_name(work) + (work.unsaved ? " \u2022" : "");
}

// Another document takes the place of the open one; false: that one has to stay. Undo does not
// reach across: a set brought back by it would be saved over the wrong file.
bool show_document(Ui& ui, Workspace& work, Document document, std::string text) {
    const Expected<std::filesystem::path> aside = keep_unsaved(work);
    if (!aside) {
        refuse_to_replace(ui, aside.error().message);
        return false;
    }
    if (!aside->empty()) text += " Unsaved changes before it are kept in " + aside->string() + ".";
    // What is given at opening is no change of the document.
    give_looks(document.saved);
    give_looks(document.set);
    work.document.open(std::move(document));
    work.document_number = ++work.documents;
    work.side = Side::both;
    if (!hold_document(work.session, work.document.path)) text += kOpenTwice;
    work.changes = {};
    work.effects = {};
    work.selection = {};
    ui.fonts_outdated = true;  // its names may need other glyphs
    work.selection.partner.clear();
    document_changed(work);
    say(ui, text);
    return true;
}

void new_document(Ui& ui, Workspace& work) { show_document(ui, work, {}, "A new, empty set."); }

void open_example(Ui& ui, Workspace& work) {
    const PatternSet set = parsed(kExampleSets[0]);
    show_document(ui, work, {set, {}, set}, "The twelve patterns of Lim & Park 2023, section 6.1.");
}

void open_example_set(Ui& ui, Workspace& work, const ExampleSet& example) {
    const PatternSet set = parsed(example);
    show_document(ui, work, {set, {}, set}, "Opened the example set " + set.name + ".");
}

namespace {

// The document into the file, whatever is in it.
void write_document(Ui& ui, Workspace& work, const std::filesystem::path& target) {
    PatternSet set = work.document.kept().set;
    if (set.name.empty() && !has_set_file(work.document)) {
        set.name = target.filename().string();
        if (set.name.ends_with(kSetEnding)) set.name.resize(set.name.size() - 15);
    }
    const Expected<Done> stored = store_measurements(set, target, measured_folder(work.session));
    if (!stored) return complain(ui, "Not saved: " + stored.error().message);
    const Expected<Done> written = write_set_file(target, set);
    if (!written) return complain(ui, "Not saved: " + written.error().message);
    if (!work.changes.saved_from) {
        work.changes.saved_from = {work.document.path, work.document.set.name};
    }
    work.document.was_saved(target, set, content_mark(target));
    work.unsaved_revision = 0;  // look again
    // What was kept before is older than the file: a crash must not bring it back.
    wait_for_autosave(work);
    (void)autosave(work.session, work.document.kept());
    remember_file(work.session, target);
    std::string text = "Saved " + target.string() + ".";
    if (!hold_document(work.session, target)) text += kOpenTwice;
    say(ui, text);
}

void ask_to_overwrite(Ui& ui, Workspace& work, const std::filesystem::path& target) {
    ask(ui, {.title = "Changed by another program",
             .text = target.filename().string() +
                     " has been changed since it was opened here, by another program or another "
                     "window. To save here would lose those changes.",
             .answers = {{"Save as...", [&] { save_dialog(ui, work); }},
                         {"Overwrite", [&, target] { write_document(ui, work, target); }},
                         {"Cancel"}}});
}

}  // namespace

void save_as(Ui& ui, Workspace& work, const std::filesystem::path& path) {
    std::filesystem::path target = std::filesystem::absolute(path);
    if (!is_set_file(target)) target += kSetEnding;
    if (is_changed_outside(work.document.kept(), target)) return ask_to_overwrite(ui, work, target);
    write_document(ui, work, target);
}

void save(Ui& ui, Workspace& work) {
    // What has no set file becomes a set only under a name of its own.
    if (!has_set_file(work.document)) return save_dialog(ui, work);
    save_as(ui, work, work.document.path);
}

void save_dialog(Ui& ui, Workspace& work) {
    const std::string& name = work.document.set.name;
    ask_for_file(ui,
                 {.use = ChooserUse::save,
                  .title = "Save the set",
                  .extensions = {kSetEnding},
                  .take = [&](const std::filesystem::path& path) { save_as(ui, work, path); }},
                 folder_of(work.document),
                 file_stem(name.empty() ? "untitled" : name) + kSetEnding);
}

void load_tables_dialog(Ui& ui, Workspace& work) {
    ask_for_file(ui,
                 {.use = ChooserUse::open,
                  .title = "Load a table of slopes or of thresholds",
                  .extensions = {".csv"},
                  .take = [&](const std::filesystem::path& path) { load_tables(ui, work, path); }},
                 folder_of(work.document));
}

void load_tables(Ui& ui, Workspace& work, const std::filesystem::path& path) {
    const Expected<std::string> text = read_text_file(path);
    if (!text) return complain(ui, text.error().message);
    const bool thresholds = text->find("threshold_log10_um_peak") != std::string::npos;
    const auto curves = thresholds ? parse_thresholds(*text) : parse_slopes(*text);
    if (!curves) return complain(ui, path.filename().string() + ": " + curves.error().message);
    PhysiologyTables& tables = work.document.edit().model.coding.tables;
    (thresholds ? tables.threshold : tables.slope) = *curves;
    model_changed(work);
    commit_step(ui, work, thresholds ? "Load thresholds" : "Load slopes");
    say(ui, std::string(thresholds ? "Thresholds" : "Slopes") + " loaded from " + path.string());
}

namespace {

// Why the document could not be kept; empty: it is.
std::string fault_of(const Session& session, const Document& document) {
    try {
        const Expected<Done> written = autosave(session, document);
        return written ? std::string() : written.error().message;
    } catch (...) {
        return thrown_error().message;
    }
}

// Where to, without the locks: those are the program's to hold and to let go.
Session place_of(const Session& session) {
    Session place;
    place.folder = session.folder;
    place.autosave = session.autosave;
    return place;
}

// Once, not after each change.
void tell_if_unkept(Ui& ui, Workspace& work, const std::string& fault) {
    if (!fault.empty() && fault != work.autosave_error) {
        complain(ui, "Unsaved changes cannot be kept aside, save them: " + fault);
    }
    work.autosave_error = fault;
}

}  // namespace

void autosave_if_due(Ui& ui, Workspace& work) {
    if (work.unsaved_revision != work.revision) {
        work.unsaved = !(work.document.set == work.document.saved);
        work.unsaved_revision = work.revision;
        // A drag writes once it rests, and once a second as long as it lasts.
        if (!work.autosave_pending) work.unkept_since_s = ui.time_s;
        work.autosave_due_s =
            std::min(ui.time_s + kAutosaveRestS, work.unkept_since_s + kMostUnkeptS);
        work.autosave_pending = true;
    }
    if (has_ended(work.autosave_write)) tell_if_unkept(ui, work, work.autosave_write.get());
    // What changes while an autosave is under way is kept by the next.
    if (!work.autosave_pending || ui.time_s < work.autosave_due_s || is_autosaving(work)) return;
    work.autosave_pending = false;
    const bool has_text = work.unsaved && !work.session.folder.empty();
    if (!has_text) return tell_if_unkept(ui, work, fault_of(work.session, work.document.kept()));
    work.autosave_write =
        begun_beside([place = place_of(work.session), document = work.document.kept()] {
            return fault_of(place, document);
        });
}

bool is_autosaving(const Workspace& work) { return work.autosave_write.valid(); }

Expected<RatingStudy> study_for(const PatternSet& set, const LoadedRatings& loaded) {
    Expected<RatingStudy> study = matched(loaded.study, names_of(set));
    if (study && unrated_patterns(*study).empty() && study->gone.empty()) return study;
    // People rate the intended patterns, not what measures them.
    auto of_intended = matched(loaded.study, names_of(one_side(set, Side::intended)));
    return of_intended ? of_intended : study;
}

void take_ratings(Ui& ui, Workspace& work, Layout& layout, const std::filesystem::path& path,
                  const LoadedRatings& loaded) {
    const std::string file = path.filename().string();
    const Expected<RatingStudy> study = study_for(work.document.set, loaded);
    if (!study) return complain(ui, file + ": " + study.error().message);
    auto ratings = kept_ratings(*study, file);
    note_versions(ratings, *study, work.document.set);
    work.document.edit().ratings = std::move(ratings);
    document_changed(work);
    commit_step(ui, work, "Load ratings");
    layout.bench = BenchTab::compare;
    std::string text = "Ratings loaded from " + file;
    for (const std::string& remark : loaded.remarks) text += "; " + remark;
    const std::string unrated = remark_on_unrated(unrated_patterns(*study), study->labels.size());
    if (!unrated.empty()) text += "; " + unrated;
    if (!study->gone.empty()) text += "; " + words_on_gone(study->gone);
    say(ui, text + ".");
}

}  // namespace tact
