// A folder or zip file of recordings and of other programs' effects as a set: a vibration of each
// recording, named by its stem; of an effect file as many as it holds.
//
// Source    the layout of the files that the paper's authors publish (testVibration_0.txt ..)
// Output    vibrations in natural order of their files' names: 2 before 10. An effect whose name is
//           taken is named by its whole file name. Two files of an AHAP pair are one effect
//           A recording whose name is taken is named likewise, with a remark. What cannot be read
//           is left out with its reason (Loaded::left_out), and never refuses the rest
// Valid     1 to 10,000 files of kMaxSetSamples in all (load.h), folders within the folder too,
//           as model/io/folders lists them
// Left out  sets
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/io/effects/actuator_map.h"
#include "model/io/folders/folder_files.h"
#include "model/io/recordings/recording.h"
#include "model/io/set/load.h"

namespace tact {

// All .txt and .wav files of a folder or zip file, and what reads as an effect; the remarks count
// the others. An Error where nothing could be read, and where the reading was cancelled.
Expected<Loaded> read_waveform_folder(const std::filesystem::path& folder,
                                      const LoadOptions& options = {});

// Only the .txt files.
Expected<Loaded> read_text_folder(const std::filesystem::path& folder);

// A recording from the disk, or out of a zip file, with the sidecar that lies beside it.
Expected<Recording> recording_in(const FileAccess& access, const std::filesystem::path& path,
                                 const RecordingOptions& options = {});

// One recording as a vibration. Remarks get the file's name.
struct FileRemark {
    std::string file;
    std::string text;

    bool operator==(const FileRemark&) const = default;
};
Expected<Vibration> vibration_from(const std::filesystem::path& path,
                                   std::vector<FileRemark>& remarks,
                                   const FileAccess& access = files_on_disk());

// The effects of a file, with a note of where each comes from; none: it holds none. With `second`,
// the two of an AHAP pair, as one effect where the rule of model/io/formats/ahap/ahap_pair.h holds.
// Remarks get the file's name, the actuator map among them.
Expected<std::vector<Vibration>> effects_from(const std::filesystem::path& path,
                                              const LoadOptions& options,
                                              std::vector<FileRemark>& remarks,
                                              const std::filesystem::path& second = {},
                                              const FileAccess& access = files_on_disk());

// The same of whatever a file is: a recording, effects; none of what is neither.
Expected<std::vector<Vibration>> vibrations_in(const std::filesystem::path& path,
                                               const LoadOptions& options,
                                               std::vector<FileRemark>& remarks,
                                               const std::filesystem::path& second = {});

// Files in their order; of an AHAP pair both at the place of the first one.
struct NamedFiles {
    std::filesystem::path path;
    std::filesystem::path second;  // empty: none
};
std::vector<NamedFiles> with_pairs(std::span<const std::filesystem::path> files);

// Equal remarks of many files as one: "a.wav and 11 more: full scale taken as 1 g".
std::vector<std::string> joined(const std::vector<FileRemark>& remarks);

}  // namespace tact
