#include "app/library/library.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "app/document/editing.h"
#include "app/ui/ui.h"
#include "model/library/library_folder.h"
#include "model/text/names.h"
#include "model/text/numbers.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

std::optional<Library> read_whole(const LibraryRequest& request, std::stop_token stop,
                                  std::atomic<float>& progress) {
    auto library =
        open_library(request.folder, {.stop = stop, .progress = [&progress](double share) {
                                          progress = static_cast<float>(share);
                                      }});
    if (library) return *std::move(library);
    if (stop.stop_requested()) return std::nullopt;
    Library none;  // with the sentence that says why
    none.folder = request.folder;
    none.remarks.push_back(library.error().message);
    return none;
}

std::optional<Alike> compare(const AlikeRequest& request, std::stop_token stop,
                             std::atomic<float>& progress) {
    LikeQuestion question = request.question;
    if (request.entry) {
        auto wanted = vibration_of(*request.library, request.library->entries[*request.entry]);
        if (!wanted) return Alike{request, {}, wanted.error().message};
        question.wanted = *std::move(wanted);
    }
    auto answer = most_alike(*request.library, question,
                             {.stop = stop, .progress = [&progress](double share) {
                                  progress = static_cast<float>(share);
                              }});
    if (stop.stop_requested()) return std::nullopt;
    if (!answer) return Alike{request, {}, answer.error().message};
    return Alike{request, *std::move(answer), {}};
}

std::optional<EntriesRead> read_entries(const EntriesRequest& request, std::stop_token stop,
                                        std::atomic<float>& progress) {
    EntriesRead read{request, {}, {}};
    for (std::size_t k = 0; k < request.entries.size(); ++k) {
        if (stop.stop_requested()) return std::nullopt;
        const LibraryEntry& entry = request.library->entries[request.entries[k]];
        auto vibration = vibration_of(*request.library, entry);
        if (vibration) {
            read.vibrations.push_back(*std::move(vibration));
        } else {
            read.faults.push_back(vibration.error().message);
        }
        progress = static_cast<float>(k + 1) / static_cast<float>(request.entries.size());
    }
    return read;
}

// By the target that is chosen now.
void ask_alike(const Ui& ui, const Workspace& work, LibraryState& state, AlikeRequest request) {
    if (!state.library) return;
    request.library = state.library;
    request.target = state.target;
    LikeQuestion& question = request.question;
    question.model = work.document.set.model;
    question.among.resize(state.library->entries.size());
    std::iota(question.among.begin(), question.among.end(), std::size_t{0});
    question.target.reset();
    if (const auto format = target_format_of(state.target)) question.target = own_target(*format);
    state.comparer.ask(std::move(request), compare, ui.wake);
}

// What was found is of another reading: entries may stand elsewhere.
void take_library(Ui& ui, LibraryState& state, ShownLibrary library) {
    const bool is_same_folder = state.library && state.library->folder == library->folder;
    state.library = std::move(library);
    state.chosen.clear();
    state.held.reset();
    forget_alike(state);
    ui.fonts_outdated = true;  // names may need other glyphs
    const Library& now = *state.library;
    if (now.entries.empty()) {
        if (!now.remarks.empty()) complain(ui, now.remarks.front());
        return;
    }
    if (!is_same_folder || now.files_read > 0) {
        say(ui, "Opened the library " + now.folder.filename().string() + ": " +
                    counted(now.entries.size(), "entry", "entries") + ", " +
                    counted(now.files_read, "file", "files") + " read.");
    }
    if (!now.remarks.empty()) say(ui, now.remarks.front());
}

void take_entries(Ui& ui, Workspace& work, const EntriesRead& read) {
    std::vector<Vibration> fresh = read.vibrations;
    const std::size_t room =
        limits::kMaxPatterns - std::min(limits::kMaxPatterns, work.document.set.vibrations.size());
    const std::size_t count = std::min(fresh.size(), room);
    if (count == 0) {
        return complain(ui, read.faults.empty()
                                ? "Nothing was added: a set has at most " +
                                      grouped_digits(limits::kMaxPatterns) + " patterns"
                                : read.faults.front());
    }
    fresh.resize(count);
    const std::size_t left_out = read.request.entries.size() - count;
    ui.fonts_outdated = true;
    add_vibrations(ui, work, std::move(fresh), "Add from the library");
    work.selection.scroll_to_current = true;
    say(ui, "Added " + counted(count, "pattern", "patterns") + " from the library" +
                (left_out > 0 ? "; " + counted(left_out, "was", "were") + " left out" : "") + ".");
}

std::vector<LibraryRow> rows_of(const LibraryState& state) {
    const Library& library = *state.library;
    std::vector<std::size_t> found = found_by_words(library, state.words);
    std::vector<LibraryRow> rows;
    if (state.alike) {
        const std::set<std::size_t> within(found.begin(), found.end());
        for (const LikeHit& hit : state.alike->answer.hits) {
            if (within.contains(hit.entry)) rows.push_back({hit.entry, hit.pm, hit.is_felt});
        }
        return rows;
    }
    const auto shape = shape_through(state.drawn);
    for (const std::size_t entry : found) {
        LibraryRow row{entry};
        if (shape) row.match = shape_difference(*shape, library.entries[entry].shape);
        rows.push_back(row);
    }
    return rows;
}

// Silence has no frequency, and comes last either way.
double number_of(const LibraryEntry& entry, LibraryColumn column) {
    switch (column) {
        case LibraryColumn::duration:
            return entry.duration_s;
        case LibraryColumn::peak:
            return entry.peak_g;
        case LibraryColumn::frequency:
            return entry.mean_hz.value_or(std::numeric_limits<double>::quiet_NaN());
        default:
            return static_cast<double>(entry.ticks);
    }
}

bool is_before(const Library& library, const LibraryRow& a, const LibraryRow& b,
               LibraryColumn column, bool descending) {
    const LibraryEntry& one = library.entries[a.entry];
    const LibraryEntry& other = library.entries[b.entry];
    if (column == LibraryColumn::file) return descending ? b.entry < a.entry : a.entry < b.entry;
    if (column == LibraryColumn::name) {
        return descending ? naturally_before(other.name, one.name)
                          : naturally_before(one.name, other.name);
    }
    double x = number_of(one, column);
    double y = number_of(other, column);
    if (column == LibraryColumn::match) {
        x = a.match.value_or(0.0);
        y = b.match.value_or(0.0);
    }
    if (x != x || y != y) return x == x && y != y;
    return descending ? y < x : x < y;
}

}  // namespace

void open_library_dialog(Ui& ui, const Workspace& work, Layout& layout, LibraryState& state) {
    ask_for_file(ui,
                 {.use = ChooserUse::open,
                  .title = "Open a library: a folder of effects, recordings and sets",
                  .folders_too = true,
                  .take =
                      [&](const fs::path& folder) {
                          layout.bench = BenchTab::library;
                          show_library(ui, state, folder);
                      }},
                 work.document.path.parent_path());
}

void show_library(Ui& ui, LibraryState& state, const fs::path& folder) {
    std::error_code none;
    state.folder = fs::is_regular_file(folder, none) ? folder.parent_path() : folder;
    read_library_again(ui, state);
}

void read_library_again(Ui& ui, LibraryState& state) {
    state.reader.ask({state.folder}, read_whole, ui.wake);
}

void find_alike(const Ui& ui, const Workspace& work, LibraryState& state, const Vibration& wanted) {
    ask_alike(ui, work, state, {.wanted = wanted.name, .question = {.wanted = wanted}});
}

void find_alike_entry(const Ui& ui, const Workspace& work, LibraryState& state, std::size_t entry) {
    ask_alike(ui, work, state,
              {.wanted = state.library->entries[entry].name, .entry = entry, .question = {}});
}

void ask_alike_again(const Ui& ui, const Workspace& work, LibraryState& state) {
    if (state.alike) ask_alike(ui, work, state, state.alike->request);
}

void forget_alike(LibraryState& state) {
    state.alike.reset();
    state.comparer.forget();
    if (state.by == LibraryColumn::match && state.drawn.empty()) state.by = LibraryColumn::file;
}

void add_entries(Ui& ui, const Workspace& work, LibraryState& state,
                 const std::vector<std::size_t>& entries) {
    if (!state.library || entries.empty()) return;
    state.adder.ask({state.library, entries, work.document_number}, read_entries, ui.wake);
}

void follow_library(Ui& ui, Workspace& work, LibraryState& state) {
    ShownLibrary library = state.reader.latest();
    if (library && library != state.library) take_library(ui, state, std::move(library));
    auto alike = state.comparer.latest();
    const bool is_new = alike && alike != state.alike && alike->request.library == state.library;
    if (is_new && !alike->fault.empty()) {
        complain(ui, alike->fault);
        forget_alike(state);
    } else if (is_new) {
        state.alike = std::move(alike);
        state.by = LibraryColumn::match;
        state.descending = false;
    }
    if (const auto read = state.adder.latest()) {
        state.adder.forget();
        if (read->request.document == work.document_number) take_entries(ui, work, *read);
    }
}

const std::vector<LibraryRow>& library_rows(LibraryState& state) {
    const LibraryAsked wanted{state.library, state.alike, state.words,
                              state.drawn,   state.by,    state.descending};
    if (state.asked == wanted) return state.rows;
    state.asked = wanted;
    state.rows.clear();
    if (!state.library) return state.rows;
    state.rows = rows_of(state);
    std::ranges::stable_sort(state.rows, [&state](const LibraryRow& a, const LibraryRow& b) {
        return is_before(*state.library, a, b, state.by, state.descending);
    });
    return state.rows;
}

bool is_library_busy(const LibraryState& state) {
    return state.reader.busy() || state.comparer.busy();
}

void hold_entry(const Ui& ui, Workspace& work, LibraryState& state, std::size_t entry) {
    if (state.held != entry) {
        state.held = entry;
        state.holder.ask({state.library, {entry}, 0}, read_entries, ui.wake);
    }
    const auto read = state.holder.latest();
    const bool is_it = read && read->request.library == state.library &&
                       read->request.entries == std::vector<std::size_t>{entry};
    if (is_it && !read->vibrations.empty()) note_pressed(work, read->vibrations.front());
}

void sort_library(LibraryState& state, LibraryColumn column) {
    state.descending = state.by == column ? !state.descending : false;
    state.by = column;
}

}  // namespace tact
