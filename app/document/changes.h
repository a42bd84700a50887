// What was done to the document, for rooms that hold patterns by their names or files beside its
// own. The frame hands it on once what was asked for in it is done.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tact {

struct Renaming {
    std::string before, after;
};

// Where the document was before it was saved, and what it was called.
struct SavedFrom {
    std::filesystem::path file;  // empty: it had none
    std::string set_name;
};

struct DocumentChanges {
    std::vector<Renaming> renamings;  // in their order
    std::optional<SavedFrom> saved_from;
};

inline void follow(const Renaming& renaming, std::string& name) {
    if (name == renaming.before) name = renaming.after;
}

}  // namespace tact
