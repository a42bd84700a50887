// A folder of recordings as a set: one vibration a file, named by its stem.
//
// Source    the layout of the files that the paper's authors publish (testVibration_0.txt ..)
// Output    vibrations in natural order of their names: 2 before 10
// Valid     1 to 10,000 files of kMaxSetSamples in all (loaded.h)
// Left out  folders within the folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/io/recordings/recording.h"
#include "model/io/set/loaded.h"

namespace tact {

// All .txt and .wav files of a folder; the remarks count the others.
Expected<Loaded> read_waveform_folder(const std::filesystem::path& folder);

// Only the .txt files.
Expected<Loaded> read_text_folder(const std::filesystem::path& folder);

// One recording as a vibration. Remarks get the file's name.
struct FileRemark {
    std::string file;
    std::string text;
};
Expected<Vibration> vibration_from(const std::filesystem::path& path,
                                   std::vector<FileRemark>& remarks);

// Equal remarks of many files as one: "a.wav and 11 more: full scale taken as 1 g".
std::vector<std::string> joined(const std::vector<FileRemark>& remarks);

}  // namespace tact
