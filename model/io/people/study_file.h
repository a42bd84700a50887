// One participant, one file: a line of JSON about the study, then one a trial, in UTF-8.
//
//     {"tactspace_study": 1, "program": "..", "kind": "pairwise", "set": {..}, "patterns": [..],
//      "device": {..}, "seed": 1, "participant": {..}, "consent": {..}, "design": {..}, ..}
//     {"trial": 1, "left": "a", "right": "b", "rating": 54, "plays_left": 1, "plays_right": 2,
//      "felt_first": "left", "left_plays": {"broken": 1, "dropouts": 3, "turned_down_db": 1.9}, ..}
//     {"device": {..}, "at": ".."}      where it is another from the next trial on
//
// Every line is on the disk before append() returns; the last one may be torn by a power cut and is
// then left out. A file of another participant is never written over: a file is new, or its own
// participant continues it.
//
// Output    errors as "FILE: what is wrong" or "FILE:LINE: expected .."
// Left out  encryption; several writers: the file is locked.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/study/study_record.h"
#include "model/system/open_file.h"

namespace tact {

inline constexpr const char* kStudyEnding = ".jsonl";

// "P 1/2" becomes "P_1_2.jsonl". Empty for a code without letters and digits.
std::string study_file_name(const std::string& participant);

Expected<StudyRecord> parse_study(std::string_view text, const std::string& file);
Expected<StudyRecord> read_study_file(const std::filesystem::path& path);

// The participants of a folder, by natural order of their files, each with why they are left out by
// whoever runs the study (exclusions_file.h). A folder that is not there, or has no such file, is
// an Error.
Expected<std::vector<StudyRecord>> read_study_folder(const std::filesystem::path& folder);

// The same of folders and of single files of participants.
Expected<std::vector<StudyRecord>> read_studies(std::span<const std::filesystem::path> paths);

// Who takes part in a folder, by the first line of each file: without answers, exclusions, and
// whoever's line is not whole. Empty of a folder that is not there.
std::vector<StudyRecord> study_heads(const std::filesystem::path& folder);

// What someone who is about to begin is asked otherwise than the first participant of the folder
// with the same kind of study (model/study/study_record.h); empty: nothing.
std::vector<std::string> changes_on_disk(const std::filesystem::path& folder,
                                         const StudyHeader& now);

// Whether the path is one of those: a folder with participants, or a participant's file.
bool is_study(const std::filesystem::path& path);

bool contains_study(const std::filesystem::path& folder);

// What parse_study() reads as the same record.
std::string print_study(const StudyRecord& record);

// A whole record as a new file; one that is there already is an Error.
Expected<Done> write_study_file(const std::filesystem::path& path, const StudyRecord& record);

// A participant's file being written.
class StudyLog {
  public:
    // Makes the file; one that is there already is an Error.
    static Expected<StudyLog> begin(const std::filesystem::path& path, const StudyHeader& header);

    // Goes on with a file whose content was `record`; what a power cut left torn is cut off.
    static Expected<StudyLog> resume(const std::filesystem::path& path, const StudyRecord& record);

    // A line, brought to the disk. After an Error the file ends where it did.
    Expected<Done> append(const std::string& line);

    const std::filesystem::path& path() const { return path_; }

  private:
    StudyLog(std::filesystem::path path, OpenFile file)
        : path_(std::move(path)), file_(std::move(file)) {}

    std::filesystem::path path_;
    OpenFile file_;
};

}  // namespace tact
