// A folder of effects to search, and to take patterns from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/jobs/jobs.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/library/library.h"
#include "model/library/like.h"

namespace tact {

// What the window knows of the library that is open: a folder, not a part of the document.

using ShownLibrary = std::shared_ptr<const Library>;

struct LibraryRequest {
    std::filesystem::path folder;
};

// What feels like a pattern, of the whole library.
struct AlikeRequest {
    ShownLibrary library{};
    std::string wanted{};                // its name
    std::optional<std::size_t> entry{};  // the wanted one, where it is in the library
    LikeQuestion question{};
    std::string target{};  // key of the format that they are compared in; empty: as they are
};

struct Alike {
    AlikeRequest request;
    LikeAnswer answer;
    std::string fault;  // why there is no answer; or empty
};

// Entries that are read from their files: to be felt, or to be added to the set.
struct EntriesRequest {
    ShownLibrary library;
    std::vector<std::size_t> entries;
    std::uint64_t document = 0;  // that they are added to; 0: they are felt
};

struct EntriesRead {
    EntriesRequest request;
    std::vector<Vibration> vibrations;
    std::vector<std::string> faults;
};

enum class LibraryColumn { file, name, duration, peak, frequency, ticks, match };

// What rows are of.
struct LibraryAsked {
    ShownLibrary library;
    std::shared_ptr<const Alike> alike;
    std::string words;
    std::vector<double> drawn;
    LibraryColumn by = LibraryColumn::file;
    bool descending = false;

    bool operator==(const LibraryAsked&) const = default;
};

struct LibraryRow {
    std::size_t entry = 0;
    std::optional<double> match{};  // PM, or how far off the drawn shape it is
    bool is_felt = true;            // where PM says so
};

struct LibraryState {
    std::filesystem::path folder;  // empty: none was opened
    ShownLibrary library;
    std::string words;          // that are searched for
    std::vector<double> drawn;  // strengths by hand, kShapeParts of them; empty: none
    std::string target;         // key of a format, of the next question; empty: as they are
    std::shared_ptr<const Alike> alike;
    LibraryColumn by = LibraryColumn::file;
    bool descending = false;
    std::set<std::size_t> chosen;  // entries
    std::size_t last_chosen = 0;
    bool is_dragging = false;  // rows, out of the pane
    std::optional<LibraryAsked> asked;
    std::vector<LibraryRow> rows;
    std::optional<std::size_t> held;  // is felt as long as its row is pressed
    Query<LibraryRequest, Library> reader;
    Query<AlikeRequest, Alike> comparer;
    Query<EntriesRequest, EntriesRead> holder;
    Query<EntriesRequest, EntriesRead> adder;
};

// Opening a library, asking what in it is like a pattern, and adding what it holds to the set: all
// of it in the background.
//
// Input     folders (model/library), the pattern that is asked for
// Output    the library and answers in the state; vibrations in the set, as one step of undo

void open_library_dialog(Ui& ui, const Workspace& work, Layout& layout, LibraryState& state);
void show_library(Ui& ui, LibraryState& state, const std::filesystem::path& folder);
void read_library_again(Ui& ui, LibraryState& state);

// By the model of the set. The answer is of all entries, whatever the words narrow the list to.
void find_alike(const Ui& ui, const Workspace& work, LibraryState& state, const Vibration& wanted);
void find_alike_entry(const Ui& ui, const Workspace& work, LibraryState& state, std::size_t entry);
// The same question with the target that is chosen now.
void ask_alike_again(const Ui& ui, const Workspace& work, LibraryState& state);
// What is found goes, and what is under way is stopped.
void forget_alike(LibraryState& state);

// Its row is pressed: it is read, and felt once it is there.
void hold_entry(const Ui& ui, Workspace& work, LibraryState& state, std::size_t entry);

void add_entries(Ui& ui, const Workspace& work, LibraryState& state,
                 const std::vector<std::size_t>& entries);

// Once a frame: takes what has come.
void follow_library(Ui& ui, Workspace& work, LibraryState& state);

// Something is read or compared.
bool is_library_busy(const LibraryState& state);

// The rows as they are asked for now, kept while nothing that they depend on changes.
const std::vector<LibraryRow>& library_rows(LibraryState& state);

// The same column again turns the order round.
void sort_library(LibraryState& state, LibraryColumn column);

// The tab of the library: a list that is searched by words, by a drawn shape and by what feels like
// a pattern; what is chosen is added to the set, by a button, a double click or by dragging it out.

void draw_library_panel(Ui& ui, Workspace& work, Layout& layout, LibraryState& state);

}  // namespace tact
