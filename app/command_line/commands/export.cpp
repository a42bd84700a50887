// tactspace export: patterns as files of other programs, and in words what each loses.
//
// Nothing is written where a file is in the way, unless it may be replaced.

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "app/session/folders.h"
#include "model/io/effects/actuator_map.h"
#include "model/io/effects_out/write_effect.h"
#include "model/text/atomic_file.h"
#include "model/text/file_stem.h"
#include "model/text/unique_names.h"
#include "model/text/utc_time.h"

namespace tact {

namespace {

struct ExportedFile {
    std::string pattern;
    std::filesystem::path path;
    WrittenEffect written;
};

// Of those asked for, in the set's order; of all but recordings where none is.
Expected<std::vector<const Vibration*>> asked_for(const PatternSet& set,
                                                  const std::vector<std::string>& names) {
    std::vector<bool> wanted(set.vibrations.size(), names.empty());
    for (const std::string& name : names) {
        const auto at = place_of(set, name);
        if (!at) return at.error();
        if (!std::holds_alternative<Pattern>(set.vibrations[*at].source)) {
            return Error{"--pattern: expected a pattern, \"" + name + "\" is a recording"};
        }
        wanted[*at] = true;
    }
    std::vector<const Vibration*> asked;
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        const Vibration& one = set.vibrations[k];
        if (wanted[k] && std::holds_alternative<Pattern>(one.source)) asked.push_back(&one);
    }
    if (asked.empty()) return Error{"expected patterns to export, the set has recordings alone"};
    return asked;
}

void print_table(const std::vector<ExportedFile>& files) {
    for (const ExportedFile& file : files) {
        std::cout << file.path.string() << "\n";
        for (const std::string& remark : file.written.remarks)
            std::cout << "    " << remark << "\n";
        if (file.written.remarks.empty()) std::cout << "    nothing lost\n";
    }
}

void print_json(const std::vector<ExportedFile>& files, const ActuatorMap& map,
                TargetFormat format) {
    nlohmann::json list = nlohmann::json::array();
    for (const ExportedFile& file : files) {
        list.push_back({{"pattern", file.pattern},
                        {"file", file.path.string()},
                        {"remarks", file.written.remarks}});
    }
    const nlohmann::json answer{{"format", traits(format).key},
                                {"actuator", map.name},
                                {"actuator_source", map.source},
                                {"files", list}};
    std::cout << answer.dump() << "\n";
}

}  // namespace

Expected<Done> run(const ExportCommand& command) {
    const TargetFormat format = target_format_of(command.format).value();
    const std::string own_map = traits(format).map;
    const auto map = actuator_named(command.onto.empty() ? own_map : command.onto);
    if (!map) return map.error();
    const Expected<PatternSet> set = load_as_meant(command.common);
    if (!set) return set.error();
    const auto asked = asked_for(*set, command.patterns);
    if (!asked) return asked.error();
    const std::string date = utc_now().substr(0, 10);
    UnusedNames stems;
    std::vector<ExportedFile> files;
    for (const Vibration* one : *asked) {
        const std::string stem = stems.unused(file_stem(one->name));
        const auto path = command.out / (stem + traits(format).ending);
        if (is_there(path) && !command.overwrite) {
            return Error{path.string() + ": is there already, expected another folder or " +
                         "--overwrite"};
        }
        files.push_back(
            {one->name, path,
             write_effect(format, std::get<Pattern>(one->source), {one->name, *map, date})});
    }
    if (const Expected<Done> made = make_folder(command.out); !made) return made;
    for (const ExportedFile& file : files) {
        if (const auto written = write_atomically(file.path, file.written.text); !written) {
            return written;
        }
    }
    const std::size_t left_out = set->vibrations.size() - asked->size();
    std::cerr << "tactspace: wrote " << files.size() << " files to " << command.out.string()
              << "; actuator " << map->name << ": " << map->source << "\n";
    if (command.patterns.empty() && left_out > 0) {
        std::cerr << "tactspace: " << left_out << " recordings are left out\n";
    }
    command.common.json ? print_json(files, *map, format) : print_table(files);
    return Done{};
}

}  // namespace tact
