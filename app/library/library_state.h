// What the window knows of the library that is open: a folder, not a part of the document.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/jobs/query.h"
#include "model/library/library.h"
#include "model/library/library_search.h"
#include "model/library/like.h"

namespace tact {

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

}  // namespace tact
