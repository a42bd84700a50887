#include "app/export/effect_files.h"

#include "app/session/folders.h"
#include "model/text/atomic_file.h"
#include "model/text/file_stem.h"
#include "model/text/unique_names.h"

namespace tact {

std::vector<std::string> effect_file_names(const PatternSet& set, TargetFormat format) {
    UnusedNames stems;
    std::vector<std::string> names;
    for (const Vibration& one : set.vibrations) {
        if (!std::holds_alternative<Pattern>(one.source)) continue;
        names.push_back(stems.unused(file_stem(one.name)) + traits(format).ending);
    }
    return names;
}

std::vector<std::string> taken_names(const std::filesystem::path& folder,
                                     const std::vector<std::string>& names) {
    std::vector<std::string> taken;
    for (const std::string& name : names) {
        if (is_there(folder / name)) taken.push_back(name);
    }
    return taken;
}

Expected<Done> write_files(const std::filesystem::path& folder,
                           const std::vector<TextFile>& files) {
    if (const Expected<Done> made = make_folder(folder); !made) return made;
    for (const TextFile& file : files) {
        if (const auto written = write_atomically(folder / file.name, file.text); !written) {
            return written;
        }
    }
    return Done{};
}

}  // namespace tact
