#include "model/export/effect_files.h"

#include "model/export/exported_set.h"
#include "model/io/folders/new_folder.h"
#include "model/text/atomic_file.h"
#include "model/text/file_stem.h"
#include "model/text/unique_names.h"

namespace tact {

std::vector<std::string> effect_file_names(const PatternSet& set, TargetFormat format) {
    UnusedNames stems;
    std::vector<std::string> names;
    for (const Vibration& one : set.vibrations) {
        if (!is_held(one, format)) continue;
        names.push_back(stems.unused(file_stem(one.name)) + traits(format).ending);
    }
    return names;
}

std::string name_beside(const std::string& name, TargetFormat format) {
    const std::string_view ending = traits(format).ending;
    return name.substr(0, name.size() - ending.size()) + traits(format).beside;
}

std::vector<std::string> with_second_files(const std::vector<std::string>& names,
                                           TargetFormat format) {
    std::vector<std::string> all;
    for (const std::string& name : names) {
        all.push_back(name);
        if (*traits(format).beside != '\0') all.push_back(name_beside(name, format));
    }
    return all;
}

void add_files(std::vector<TextFile>& files, const std::string& name, TargetFormat format,
               const std::string& text, const std::string& beside) {
    files.push_back({name, text});
    if (*traits(format).beside != '\0') files.push_back({name_beside(name, format), beside});
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
