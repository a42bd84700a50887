// What the window keeps of the manual.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/jobs/query.h"

namespace tact {

// The page that is to be made, by this program.
struct ManualRequest {
    std::filesystem::path program;
    std::filesystem::path page;
};

struct ManualMade {
    std::filesystem::path page;
    std::string fault;  // empty: it is there
};

struct ManualState {
    std::filesystem::path program;  // itself; empty: nothing is started, as in tests
    Query<ManualRequest, ManualMade> job;
    std::shared_ptr<const ManualMade> shown;  // the last that was opened
    std::vector<int> openers;                 // processes that opened it, until they have ended
    std::string wanted_keys;                  // what the list of keys is searched for
    float keys_height_px = 0.0F;              // of the whole list, as it was drawn last
};

}  // namespace tact
