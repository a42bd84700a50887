// Filling the gap between the picked patterns: the question and its answer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/jobs/query.h"
#include "app/rendering/rendering_state.h"
#include "model/ask/gap.h"

namespace tact {

struct GapRequest {
    std::uint64_t revision = 0;  // document's revision
    std::shared_ptr<const PatternSet> set;
    std::vector<std::size_t> picked;       // places in the set
    std::vector<PatternParameter> free{};  // numbers that may change if there is no design space
    std::size_t missing = 1;
    std::uint64_t seed = 1;
    std::optional<RenderedBy> rendered_by{};

    bool operator==(const GapRequest&) const = default;
};

struct FoundGap {
    GapRequest request;
    std::vector<Pattern> chosen;
    GapAnswer answer;
    std::size_t candidates = 0;
    bool all_there_are = false;  // the design space is finite, and all of it was compared
    bool coarse = false;         // computed from coarse envelopes
};

// The search is under way while asked() has a request.
using GapQuery = Query<GapRequest, FoundGap>;

}  // namespace tact
