// Which formats of effects a text leaves out.
#pragma once

#include <regex>
#include <string>
#include <vector>

#include "model/io/formats/formats.h"

namespace tact {

// Keys of formats that are read. A text names a format by its key as a word, in any case, that of
// browsers' on-off times also as theirs.
inline std::vector<std::string> read_formats_missing_in(const std::string& text) {
    std::vector<std::string> missing;
    for (const FormatFolder& folder : kFormatFolders) {
        for (const EffectFormat& format : folder.read) {
            const std::string key = format.key;
            const std::regex word("\\b" + (key == "web" ? "(web|browsers?)" : key) + "\\b",
                                  std::regex::icase);
            if (!std::regex_search(text, word)) missing.push_back(key);
        }
    }
    return missing;
}

}  // namespace tact
