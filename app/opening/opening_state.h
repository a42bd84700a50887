// What is being read for the document, in the background, and what could not be read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/jobs/query.h"
#include "model/common/expected.h"
#include "model/io/set/loaded.h"

namespace tact {

struct OpeningRequest {
    std::vector<std::filesystem::path> paths;
    bool adds = false;           // to the open set; default: in its place
    bool partly = false;         // of several paths, those that cannot be read are left out
    std::uint64_t document = 0;  // the number of the open one when it was asked for
    std::uint64_t number = 0;    // tells it from those before it
    double since_s = 0.0;        // on the clock of frames
};

struct OpeningAnswer {
    OpeningRequest request;
    // Whoever puts it into the document takes it away: recordings of a set may have a GB.
    std::shared_ptr<Expected<Loaded>> loaded;
    std::optional<std::uint64_t> file_mark;  // of a set file, before it was read
};

struct Opening {
    Query<OpeningRequest, OpeningAnswer> job;
    std::optional<OpeningRequest> asked;  // which is being read, or waits to be shown
    std::uint64_t requests = 0;           // that were numbered so far
    std::vector<std::string> left_out;    // of what was opened last, each "FILE: what was expected"
};

}  // namespace tact
