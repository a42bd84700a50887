#include "app/command_line/people/study_packs.h"

#include <algorithm>
#include <iostream>
#include <utility>

#include "app/session/folders.h"
#include "model/io/people/study_file.h"
#include "model/io/studies_out/experiment_pack.h"
#include "model/io/studies_out/packed_answers.h"
#include "model/text/atomic_file.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

// The .csv files of folders, in the order of their names, and single ones.
std::vector<fs::path> answer_files(const std::vector<fs::path>& paths) {
    std::vector<fs::path> files;
    for (const fs::path& path : paths) {
        std::error_code none;
        if (!fs::is_directory(path, none)) {
            files.push_back(path);
            continue;
        }
        const std::size_t before = files.size();
        for (const auto& entry : fs::directory_iterator(path, none)) {
            if (entry.path().extension() == ".csv") files.push_back(entry.path());
        }
        std::sort(files.begin() + static_cast<std::ptrdiff_t>(before), files.end());
    }
    return files;
}

}  // namespace

Expected<Done> write_new_folder(const fs::path& folder, const std::vector<DatasetFile>& files) {
    std::error_code none;
    if (fs::exists(folder, none) && !fs::is_empty(folder, none)) {
        return Error{folder.string() + ": expected a folder that is empty or not there"};
    }
    for (const DatasetFile& file : files) {
        const fs::path path = folder / fs::path(file.path);
        if (const auto made = make_folder(path.parent_path()); !made) return made;
        if (const auto written = write_atomically(path, file.text); !written) return written;
    }
    return Done{};
}

Expected<Done> pack_study(const StudyCommand& command, const PatternSet& set) {
    if (command.out.empty()) return Error{"--pack: expected a folder as --out"};
    if (command.sorting || command.adaptive) {
        return Error{"--pack: expected pairs in the full order, which alone can be packed"};
    }
    const PackFor what = command.pack == kPackNames[0] ? PackFor::jspsych : PackFor::psychopy;
    const auto count = static_cast<std::size_t>(command.participants);
    const auto files = pack_files(set, what, count);
    if (!files) return files.error();
    if (const auto written = write_new_folder(command.out, *files); !written) return written;
    std::cerr << "tactspace: packed trials of " << counted(count, "participant", "participants")
              << " into " << command.out.string() << ", see README.txt there\n";
    return Done{};
}

Expected<Done> unpack_study(const StudyCommand& command, StudyHeader header) {
    if (command.out.empty()) return Error{"--unpack: expected a folder as --out"};
    header.device = {"not told", "uncalibrated", {}};
    std::vector<StudyRecord> records;
    for (const fs::path& file : answer_files(command.unpack)) {
        const Expected<std::string> text = read_text_file(file);
        if (!text) return text.error();
        Expected<std::vector<StudyRecord>> read = packed_answers(*text, file.string(), header);
        if (!read) return read.error();
        for (StudyRecord& record : *read) {
            const std::string& code = record.header.participant.code;
            const bool is_known = std::ranges::any_of(records, [&code](const StudyRecord& other) {
                return other.header.participant.code == code;
            });
            if (is_known) {
                return Error{file.string() + ": expected each participant in one file, got " +
                             in_quotes(code) + " again"};
            }
            records.push_back(std::move(record));
        }
    }
    if (records.empty()) return Error{"--unpack: expected .csv files, got none"};
    for (const StudyRecord& record : records) {
        if (record.header.set_fingerprint == header.set_fingerprint) continue;
        std::cerr << "tactspace: the patterns have changed since they were packed\n";
        break;
    }
    if (const auto made = make_folder(command.out); !made) return made;
    for (const StudyRecord& record : records) {
        const fs::path file = command.out / study_file_name(record.header.participant.code);
        std::error_code none;
        if (fs::exists(file, none)) {
            return Error{file.string() +
                         ": is there already, expected a folder without this "
                         "participant"};
        }
    }
    for (const StudyRecord& record : records) {
        const auto written =
            write_study_file(command.out / study_file_name(record.header.participant.code), record);
        if (!written) return written;
    }
    std::cerr << "tactspace: " << counted(records.size(), "participant", "participants") << " in "
              << command.out.string() << "\n";
    return Done{};
}

}  // namespace tact
