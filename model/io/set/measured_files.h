// The files of measured twins, which lie beside the set file in a folder of their own.
//
// Source    the set file's layout: "waveform": "measured/NAME.wav"
// Output    WAV, 32 bits float, in g; each file whole or not at all; names by
//           model/text/names.h
// Left out  removing files that no set names any more
#pragma once

#include <filesystem>

#include "model/common/expected.h"
#include "model/set/pattern_set.h"

namespace tact {

// Writes recordings that have no file yet, or one in `kept_in` until now, to measured/ beside the
// set file, and names them in the set. A file there that holds something else is left alone: the
// new one gets a number. An Error leaves the set as it is.
Expected<Done> store_measurements(PatternSet& set, const std::filesystem::path& set_file,
                                  const std::filesystem::path& kept_in = {});

// The same for one waveform, in any folder; gives the file's absolute path.
Expected<std::filesystem::path> store_waveform(const Waveform& waveform, const std::string& name,
                                               const std::filesystem::path& folder);

}  // namespace tact
