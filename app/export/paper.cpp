#include "app/export/export.h"

#include <set>
#include <sstream>
#include <system_error>
#include <utility>

#include "app/export/parts.h"
#include "app/session/session.h"
#include "app/ui/ui.h"
#include "model/io/set/load.h"
#include "model/io/set/set_file.h"
#include "model/text/atomic_file.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

// The last line that a program has said, without its name before it.
std::string last_line(const fs::path& said) {
    const Expected<std::string> text = read_text_file(said);
    std::istringstream lines(text ? *text : std::string());
    std::string last;
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty()) last = line;
    }
    const std::string_view name = "tactspace: ";
    return last.starts_with(name) ? last.substr(name.size()) : last;
}

// What was begun goes: a folder that was there before was empty.
void remove_begun(const PaperRequest& request, bool was_there) {
    std::error_code none;
    if (!was_there) {
        fs::remove_all(request.out, none);
        return;
    }
    for (const auto& entry : fs::directory_iterator(request.out, none)) {
        fs::remove_all(entry.path(), none);
    }
}

std::vector<std::string> words_of(const PaperRequest& request) {
    std::vector<std::string> words{request.program.string(), "paper"};
    for (const fs::path& set : request.sets) words.push_back(set.string());
    words.insert(words.end(), {"--out", request.out.string()});
    if (!request.along.empty()) words.insert(words.end(), {"--along", request.along});
    for (const std::string& from : request.metrics_from) {
        words.insert(words.end(), {"--metric-from", from});
    }
    return words;
}

std::optional<PaperMade> made_paper(const PaperRequest& request, const std::stop_token& stop) {
    const fs::path page = request.out / "paper.html";
    std::error_code none;
    const bool was_there = fs::exists(request.out, none);
    if (was_there && !fs::is_empty(request.out, none)) {
        return PaperMade{page,
                         request.out.string() + ": expected a folder that is empty or not there"};
    }
    const fs::path said = unused_file(fs::temp_directory_path(none), "tactspace-paper-", ".txt");
    const auto process = started(words_of(request), said);
    if (!process) return PaperMade{page, process.error().message};
    const std::optional<int> status = ended(*process, stop);
    const std::string fault = last_line(said);
    fs::remove(said, none);
    if (!request.written.empty()) fs::remove(request.written, none);
    if (status && *status == 0 && is_there(page)) return PaperMade{page, {}};
    remove_begun(request, was_there);
    if (!status) return std::nullopt;
    return PaperMade{page, fault.empty() ? "the program ended without a word" : fault};
}

// The file of the document, or one that is written with what the document has more than it.
Expected<fs::path> file_with(const Workspace& work, fs::path& written) {
    if (!work.unsaved && !work.document.path.empty()) return work.document.path;
    std::error_code none;
    PatternSet set = work.document.set;
    if (set.name.empty()) set.name = "Unsaved set";
    written = unused_file(fs::temp_directory_path(none), "tactspace-paper-", ".tactspace.json");
    if (const auto done = write_set_file(written, set); !done) return done.error();
    return written;
}

}  // namespace

std::string words_on_ratings(const PatternSet& set) {
    std::set<std::string> names;
    bool synthetic = false;
    for (const Ratings& one : set.ratings) {
        names.insert(one.name);
        synthetic |= one.mark.synthetic;
    }
    return counted(set.vibrations.size(), "pattern", "patterns") + ", " +
           (synthetic ? "synthetic ratings of " : "ratings of ") +
           (names.size() == 1 ? "one person, or of one mean"
                              : counted(names.size(), "person", "people"));
}

void open_paper(Ui& ui) { ui.dialog = kPaperDialog; }

void add_paper_set(Ui& ui, PaperState& paper, const fs::path& file) {
    ui.dialog = kPaperDialog;
    const Expected<Loaded> loaded = load_set(file);
    if (!loaded) return complain(ui, loaded.error().message);
    const PatternSet& set = loaded->set;
    if (set.ratings.empty()) {
        return complain(ui, file.filename().string() +
                                ": keeps no ratings; open it, then File > Load ratings..., and "
                                "save it");
    }
    PaperSet added{file, set.name.empty() ? file.filename().string() : set.name,
                   words_on_ratings(set)};
    std::erase_if(paper.more, [&](const PaperSet& known) { return known.file == file; });
    paper.more.push_back(std::move(added));
}

void write_paper(Ui& ui, const Workspace& work, PaperState& paper,
                 const std::vector<std::string>& metrics_from, const fs::path& folder) {
    PaperRequest request{paper.program, {}, {}, paper.along, metrics_from, folder};
    if (!work.document.set.ratings.empty()) {
        const Expected<fs::path> file = file_with(work, request.written);
        if (!file) return complain(ui, "Nothing was made: " + file.error().message);
        request.sets.push_back(*file);
    }
    for (const PaperSet& set : paper.more) request.sets.push_back(set.file);
    if (request.sets.empty() || paper.program.empty() || paper.job.busy()) return;
    paper.begun_s = ui.time_s;
    paper.job.ask(
        std::move(request),
        [](const PaperRequest& one, const std::stop_token& stop, std::atomic<float>&) {
            return made_paper(one, stop);
        },
        ui.wake, JobPolicy::finish);
}

bool is_writing_paper(const PaperState& paper) { return paper.job.busy(); }

void take_paper(Ui& ui, PaperState& paper) {
    const auto made = paper.job.latest();
    if (!made || made == paper.shown) return;
    paper.shown = made;
    if (!made->fault.empty()) return complain(ui, "Nothing was made: " + made->fault);
    say(ui, "The tables and figures are in " + made->page.string());
}

void draw_paper_progress(Ui& ui, PaperState& paper) {
    if (!is_writing_paper(paper)) return;
    const auto seconds = static_cast<int>(ui.time_s - paper.begun_s);
    const ProgressPlate plate{
        .text = "Making tables and figures, " + std::to_string(seconds) + " s",
        .cancel = "Cancel paper",
        .told = "Nothing is kept of what was made so far"};
    if (!draw_progress_plate(ui, plate)) return;
    paper.job.cancel();
    say(ui, "No tables and figures were made.");
}

}  // namespace tact
