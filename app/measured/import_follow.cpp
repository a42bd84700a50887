#include "app/measured/measured.h"

#include <algorithm>
#include <utility>

#include "app/document/editing.h"
#include "app/progress/progress.h"
#include "app/ui/ui.h"
#include "model/io/set/measured_files.h"
#include "model/tasks/set_import.h"
#include "model/text/atomic_file.h"
#include "model/text/names.h"
#include "model/text/utf8.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

bool is_measured_kind(const fs::path& path) {
    const std::string extension = extension_of(path);
    return extension == ".csv" || extension == ".txt" || extension == ".wav";
}

// A folder stands for the recordings inside it.
std::vector<fs::path> files_of(const std::vector<fs::path>& paths) {
    std::vector<fs::path> files;
    for (const fs::path& path : paths) {
        std::error_code fault;
        if (!fs::is_directory(path, fault)) {
            files.push_back(path);
            continue;
        }
        const std::size_t first = files.size();
        for (fs::directory_iterator entry(path, fault), end; !fault && entry != end;
             entry.increment(fault)) {
            if (is_measured_kind(entry->path())) files.push_back(entry->path());
        }
        std::sort(files.begin() + static_cast<std::ptrdiff_t>(first), files.end(),
                  [](const fs::path& a, const fs::path& b) {
                      return naturally_before(a.filename().string(), b.filename().string());
                  });
    }
    return files;
}

// Writes the waveform of a twin into a folder; returns the error, or an empty text.
std::string keep(Twin& twin, const fs::path& folder) {
    if (folder.empty()) return {};
    auto& measurement = std::get<Measurement>(twin.vibration.source);
    const auto file = store_waveform(*measurement.waveform, twin.vibration.name, folder);
    if (!file) return file.error().message;
    measurement.path = file->string();
    return {};
}

ImportedFile imported(const ImportRequest& request, std::size_t k) {
    auto read = read_twin(*request.set, place_named(*request.set, request.patterns[k]),
                          request.files[k], request.files, request.options);
    if (!read) return {read.error().message, {}, {}};
    ImportedFile file{{}, std::move(read->remarks), std::move(read->twin)};
    if (file.twin) file.fault = keep(*file.twin, request.keep_in);
    return file;
}

std::optional<ImportAnswer> import_all(const ImportRequest& request, std::stop_token stop,
                                       std::atomic<float>& progress) {
    ImportAnswer answer{request, {}};
    for (std::size_t k = 0; k < request.files.size(); ++k) {
        if (stop.stop_requested()) return std::nullopt;
        answer.files.push_back(imported(request, k));
        progress = static_cast<float>(k + 1) / static_cast<float>(request.files.size());
    }
    return answer;
}

std::optional<SimulationAnswer> simulate_all(const SimulationRequest& request, std::stop_token stop,
                                             std::atomic<float>&) {
    if (stop.stop_requested()) return std::nullopt;
    SimulationAnswer answer{
        request, synthetic_twins(*request.set, request.places, request.actuator), {}};
    for (Twin& twin : answer.twins) {
        if (answer.fault.empty()) answer.fault = keep(twin, request.keep_in);
    }
    return answer;
}

// Adds twins to the set that they were requested for, as one step of undo, and selects the first.
void take(Ui& ui, Workspace& work, std::uint64_t document, const std::vector<const Twin*>& twins,
          const std::string& label) {
    if (document != work.document_number) {
        return complain(ui, label +
                                ": nothing was added, as the set it was for is not open any "
                                "more. Open that one and ask again.");
    }
    PatternSet& set = work.document.edit();
    std::size_t count = 0;
    for (const Twin* twin : twins) {
        const std::string& name = std::get<Measurement>(twin->vibration.source).measures;
        if (!place_named(set, name) || set.vibrations.size() >= limits::kMaxPatterns) continue;
        const std::size_t at = insert_twin(set, twin->vibration);
        if (count++ == 0) select_only(work, at);
    }
    if (count == 0) return complain(ui, "Nothing was added: its patterns are gone.");
    work.selection.scroll_to_current = true;
    ui.fonts_outdated = true;  // names may need other glyphs
    document_changed(work);
    commit_step(ui, work, label);
    const std::size_t gone = twins.size() - count;
    say(ui, label + ": " + std::to_string(count) + (count == 1 ? " twin" : " twins") +
                " beside the intended patterns" +
                (gone > 0 ? ", without " + std::to_string(gone) +
                                " whose patterns are gone, or for which there is no room"
                          : "") +
                ". View > Intended and measured patterns shows one side alone.");
}

ImportRequest import_request(const Workspace& work, ImportState& importing,
                             const fs::path& keep_in) {
    return {++importing.asked,
            work.document_number,
            importing.files,
            importing.patterns,
            options_of(importing.fields),
            std::make_shared<const PatternSet>(work.document.set),
            keep_in};
}

SimulationRequest simulation_request(const Workspace& work, ImportState& importing,
                                     std::vector<std::size_t> places, const fs::path& keep_in) {
    return {++importing.asked,
            work.document_number,
            std::move(places),
            importing.actuator,
            std::make_shared<const PatternSet>(work.document.set),
            keep_in};
}

void ask_first(const Ui& ui, Takes<ImportRequest, ImportAnswer>& takes) {
    takes.job.ask(takes.waiting.front(), import_all, ui.wake, JobPolicy::finish);
}

void ask_first(const Ui& ui, Takes<SimulationRequest, SimulationAnswer>& takes) {
    takes.job.ask(takes.waiting.front(), simulate_all, ui.wake, JobPolicy::finish);
}

template <class Request, class Answer>
void ask_to_take(const Ui& ui, Takes<Request, Answer>& takes, Request request) {
    takes.waiting.push_back(std::move(request));
    if (takes.waiting.size() == 1) ask_first(ui, takes);
}

// Takes the answer to the current request once, and starts the next request.
template <class Request, class Answer>
std::shared_ptr<const Answer> next_taken(const Ui& ui, Takes<Request, Answer>& takes) {
    if (takes.waiting.empty()) return {};
    std::shared_ptr<const Answer> answer = takes.job.latest();
    if (!answer || answer->request.number != takes.waiting.front().number) return {};
    takes.waiting.pop_front();
    if (!takes.waiting.empty()) ask_first(ui, takes);
    return answer;
}

// Takes the error of the current request once, and starts the next request.
template <class Request, class Answer>
std::string next_failed(const Ui& ui, Takes<Request, Answer>& takes) {
    if (takes.waiting.empty()) return {};
    std::string failure = takes.job.failure();
    if (failure.empty()) return {};
    takes.waiting.pop_front();
    if (!takes.waiting.empty()) ask_first(ui, takes);
    return failure;
}

void take_import(Ui& ui, Workspace& work, const ImportAnswer& answer) {
    std::vector<const Twin*> twins;
    for (const ImportedFile& file : answer.files) {
        if (!file.fault.empty()) return complain(ui, "Not imported: " + file.fault);
        if (file.twin) twins.push_back(&*file.twin);
    }
    take(ui, work, answer.request.document, twins,
         twins.size() == 1 ? "Import recording" : "Import recordings");
}

void take_simulated(Ui& ui, Workspace& work, const SimulationAnswer& answer) {
    if (!answer.fault.empty()) return complain(ui, "Not simulated: " + answer.fault);
    std::vector<const Twin*> twins;
    for (const Twin& twin : answer.twins) twins.push_back(&twin);
    take(ui, work, answer.request.document, twins, "Simulate measurement");
}

}  // namespace

bool is_taking(const ImportState& importing) {
    return !(importing.import_takes.waiting.empty() && importing.simulation_takes.waiting.empty());
}

void follow_import(Ui& ui, Workspace& work, ImportState& importing) {
    if (auto answer = importing.import_job.latest()) importing.answer = std::move(answer);
    if (auto answer = importing.simulation_job.latest()) importing.simulated = std::move(answer);
    // The chooser was closed without a file.
    if (importing.adding && !ui.chooser.is_open && ui.dialog == kNoDialog) {
        importing.adding = false;
        ui.dialog = kImportDialog;
    }
    if (const auto taken = next_taken(ui, importing.import_takes)) take_import(ui, work, *taken);
    if (const auto taken = next_taken(ui, importing.simulation_takes)) {
        take_simulated(ui, work, *taken);
    }
    if (const auto failure = next_failed(ui, importing.import_takes); !failure.empty()) {
        complain(ui, "Not imported: " + failure + ".");
    }
    if (const auto failure = next_failed(ui, importing.simulation_takes); !failure.empty()) {
        complain(ui, "Not simulated: " + failure + ".");
    }
}

void import_recordings_dialog(Ui& ui, const Workspace& work, ImportState& importing) {
    ask_for_file(
        ui,
        {.use = ChooserUse::open,
         .title = "Import a recording, or a folder of them",
         .extensions = {".csv", ".txt", ".wav"},
         .folders_too = true,
         .take = [&](const fs::path& path) { import_recordings(ui, work, importing, {path}); }},
        work.document.path.parent_path());
}

void import_recordings(Ui& ui, const Workspace& work, ImportState& importing,
                       const std::vector<fs::path>& paths, const AccelerationOptions& told) {
    const std::vector<fs::path> files = files_of(paths);
    if (files.empty()) {
        return complain(ui, "No recording there: expected .csv, .txt or .wav files");
    }
    if (work.document.set.vibrations.empty()) {
        return complain(
            ui, "A recording is imported as a measurement of a pattern: add a pattern first");
    }
    if (!std::exchange(importing.adding, false)) {
        importing.files.clear();
        importing.patterns.clear();
        importing.answer.reset();
        importing.fields.options.table = told.table;
        if (told.unit) importing.fields.options.unit = told.unit;
    }
    importing.shown = importing.files.size();
    for (const fs::path& file : files) {
        const auto place = guessed_intended(work.document.set, valid_utf8(file.stem().string()));
        importing.files.push_back(file);
        importing.patterns.push_back(place ? work.document.set.vibrations[*place].name : "");
    }
    ui.dialog = kImportDialog;
    look_at_recordings(ui, work, importing);
}

bool are_accelerations(const std::vector<fs::path>& paths) {
    if (paths.empty() || extension_of(paths.front()) != ".csv") return false;
    const auto text = read_text_file(paths.front());
    return text && parse_acceleration_table(*text, "", true);
}

void simulate_measurement_dialog(Ui& ui, const Workspace& work, ImportState& importing) {
    ui.dialog = kSimulationDialog;
    importing.simulated.reset();
    look_at_simulation(ui, work, importing);
}

void look_at_recordings(const Ui& ui, const Workspace& work, ImportState& importing) {
    importing.import_job.ask(import_request(work, importing, {}), import_all, ui.wake);
}

void take_recordings(Ui& ui, const Workspace& work, ImportState& importing) {
    const fs::path folder = measured_folder(work.session);
    if (folder.empty()) return complain(ui, "Not imported: there is no folder to keep it in");
    ask_to_take(ui, importing.import_takes, import_request(work, importing, folder));
}

void look_at_simulation(const Ui& ui, const Workspace& work, ImportState& importing) {
    importing.simulation_job.ask(simulation_request(work, importing, {work.selection.current}, {}),
                                 simulate_all, ui.wake);
}

void take_simulation(Ui& ui, const Workspace& work, ImportState& importing) {
    const fs::path folder = measured_folder(work.session);
    if (folder.empty()) return complain(ui, "Not simulated: there is no folder to keep it in");
    std::vector<std::size_t> places;
    if (!importing.simulate_all) places = selected_indices(work);
    ask_to_take(ui, importing.simulation_takes,
                simulation_request(work, importing, places, folder));
}

}  // namespace tact
