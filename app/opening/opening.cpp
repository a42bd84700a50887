#include "app/opening/opening.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/progress/progress.h"
#include "app/session/session.h"
#include "model/common/expected.h"
#include "model/io/formats/read_effects.h"
#include "model/io/recordings/recording.h"
#include "model/io/set/load.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

// What is read within this time needs no word of its own.
constexpr double kSoonS = 0.3;

bool is_json(const fs::path& path) { return extension_of(path) == ".json"; }

std::string name_of(const OpeningRequest& request) {
    if (request.paths.size() > 1) return grouped_digits(request.paths.size()) + " files";
    return valid_utf8(request.paths[0].filename().string());
}

OpeningAnswer read_files(const OpeningRequest& request, const std::stop_token& stop,
                         std::atomic<float>& progress) {
    OpeningAnswer answer{request, {}};
    LoadOptions options;
    options.partly = request.partly;
    options.stop = stop;
    options.progress = [&progress](double share) { progress = static_cast<float>(share); };
    answer.loaded = std::make_shared<Expected<Loaded>>(load_sets(request.paths, options));
    return answer;
}

std::string joined(const std::vector<std::string>& remarks) {
    constexpr std::size_t kMost = 3;
    std::string text;
    for (std::size_t k = 0; k < std::min(remarks.size(), kMost); ++k) {
        text += (k == 0 ? "" : "; ") + remarks[k];
    }
    if (remarks.size() > kMost) {
        text += "; and " + grouped_digits(remarks.size() - kMost) + " more remarks";
    }
    return text;
}

// "Opened 35 patterns; 35 files read, 7 not: buzz.wav: resampled."
std::string told(const std::string& done, std::size_t patterns, const Loaded& loaded) {
    const std::string counts = counts_text(loaded);
    return done + patterns_text(patterns) + (counts.empty() ? "" : "; " + counts) +
           (loaded.remarks.empty() ? "." : ": " + joined(loaded.remarks) + ".");
}

void note_left_out(Ui& ui, Opening& opening, std::vector<std::string> left_out) {
    opening.left_out = std::move(left_out);
    if (opening.left_out.empty()) return;
    ui.status.more = "Show files not read";
    ui.status.show_more = [&ui, &opening] { tell_left_out(ui, opening); };
}

// A set file alone; what was made of effects has their files to be read again.
bool is_set_file(const OpeningRequest& request, const Loaded& loaded) {
    return request.paths.size() == 1 && is_json(request.paths[0]) && !loaded.effects;
}

void show_read(Ui& ui, Workspace& work, Opening& opening, const OpeningAnswer& answer) {
    const OpeningRequest& request = answer.request;
    Loaded loaded = std::move(**answer.loaded);
    Document document;
    document.set = std::move(loaded.set);
    document.saved = document.set;
    if (request.paths.size() == 1) {
        document.path = fs::absolute(request.paths[0]);
        document.file_mark = loaded.mark;
    }
    const std::string text = told("Opened ", document.set.vibrations.size(), loaded);
    const std::vector<Vibration> read = document.set.vibrations;
    if (!show_document(ui, work, std::move(document), text)) return;
    if (!is_set_file(request, loaded)) note_effect_files(work, request.paths, read);
    for (const auto& path : request.paths) remember_file(work.session, fs::absolute(path));
    note_left_out(ui, opening, std::move(loaded.left_out));
}

// What is wrong with so much more in the open set, or empty.
std::string fault_with(const PatternSet& set, const PatternSet& more) {
    if (set.vibrations.size() + more.vibrations.size() > limits::kMaxPatterns) {
        return "a set has at most " + grouped_digits(limits::kMaxPatterns) + " patterns.";
    }
    return samples_fault(recorded_samples(set) + recorded_samples(more));
}

void add_read(Ui& ui, Workspace& work, Opening& opening, const OpeningAnswer& answer) {
    const OpeningRequest& request = answer.request;
    if (request.document != work.document_number) {
        return complain(ui, "Nothing was added: the set it was for is not open any more.");
    }
    Loaded loaded = std::move(**answer.loaded);
    const std::string fault = fault_with(work.document.set, loaded.set);
    if (!fault.empty()) return complain(ui, "Nothing was added: " + fault);
    const std::size_t count = loaded.set.vibrations.size();
    const std::string text = told("Added ", count, loaded);
    if (!is_set_file(request, loaded)) {
        note_effect_files(work, request.paths, loaded.set.vibrations);
    }
    add_vibrations(ui, work, std::move(loaded.set.vibrations), "Add " + patterns_text(count));
    say(ui, text);
    note_left_out(ui, opening, std::move(loaded.left_out));
}

void take(Ui& ui, Workspace& work, Opening& opening, const OpeningAnswer& answer) {
    opening.asked.reset();
    if (!*answer.loaded) return complain(ui, answer.loaded->error().message);
    answer.request.adds ? add_read(ui, work, opening, answer)
                        : show_read(ui, work, opening, answer);
}

void begin(Ui& ui, Workspace& work, Opening& opening, OpeningRequest request) {
    if (request.paths.empty()) return;
    request.document = work.document_number;
    request.number = ++opening.requests;
    request.since_s = ui.time_s;
    opening.asked = request;
    if (has_jobs(ui)) return opening.job.ask(std::move(request), read_files, ui.wake);
    std::atomic<float> progress;
    take(ui, work, opening, read_files(request, {}, progress));
}

}  // namespace

void open_paths(Ui& ui, Workspace& work, Opening& opening, const std::vector<fs::path>& paths,
                bool partly) {
    begin(ui, work, opening, {.paths = paths, .adds = false, .partly = partly});
}

void add_paths(Ui& ui, Workspace& work, Opening& opening, const std::vector<fs::path>& paths,
               bool partly) {
    if (is_opening(opening)) {
        return complain(ui, "Nothing was added: " + name_of(*opening.asked) +
                                " is still being read. Wait for it, or cancel it by Esc.");
    }
    begin(ui, work, opening, {.paths = paths, .adds = true, .partly = partly});
}

void ask_for_vibrations(Ui& ui, const Workspace& work, const std::string& title,
                        const std::function<void(const fs::path&)>& take) {
    std::vector<std::string> extensions{".json", ".wav", ".txt", ".xml", ".zip"};
    for (std::string& ending : effect_endings()) extensions.push_back(std::move(ending));
    ask_for_file(ui, {.title = title, .extensions = extensions, .folders_too = true, .take = take},
                 work.document.path.parent_path());
}

void add_dialog(Ui& ui, Workspace& work, Opening& opening) {
    ask_for_vibrations(ui, work, "Add a set, a recording, an effect file, or a folder of them",
                       [&](const fs::path& path) { add_paths(ui, work, opening, {path}); });
}

void follow_opening(Ui& ui, Workspace& work, Opening& opening, bool is_free) {
    if (!opening.asked || !is_free) return;
    // Before its answer is looked for: one that comes in between is taken by the next frame.
    const bool is_busy = opening.job.busy();
    const auto answer = opening.job.latest();
    if (answer && answer->request.number == opening.asked->number) {
        take(ui, work, opening, *answer);
    } else if (!is_busy) {
        opening.asked.reset();
        const std::string failure = opening.job.failure();
        if (!failure.empty()) complain(ui, "Nothing was opened: " + failure);
    }
}

bool is_opening(const Opening& opening) { return opening.asked.has_value(); }

void cancel_opening(Ui& ui, Opening& opening) {
    if (!opening.asked) return;
    const std::string done = opening.asked->adds ? "added" : "opened";
    opening.asked.reset();
    opening.job.forget();
    say(ui, "Nothing was " + done + ": reading was cancelled.");
}

bool draw_opening(Ui& ui, Opening& opening) {
    if (!opening.asked || ui.time_s - opening.asked->since_s < kSoonS) return false;
    const std::string doing = "Reading " + name_of(*opening.asked);
    if (draw_progress(ui, {doing.c_str(), opening.job.progress(), "reading"})) {
        cancel_opening(ui, opening);
    }
    return true;
}

void tell_left_out(Ui& ui, const Opening& opening) {
    std::string text;
    for (const std::string& one : opening.left_out) text += (text.empty() ? "" : "\n\n") + one;
    tell(ui, "Files not read", text.empty() ? "All files were read." : text);
}

}  // namespace tact
