// What the dialog that generates candidates is left at, and what they would be.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/jobs/query.h"
#include "app/patterns/rhythm_choice.h"
#include "model/design_space/candidates.h"
#include "model/set/set_candidates.h"

namespace tact {

// Above this many patterns in the set, candidates come only after a second word: the live map
// follows every edit, and would keep the person waiting.
inline constexpr std::size_t kMostUnasked = 200;

struct GenerateRequest {
    DesignSpace space;
    std::shared_ptr<const PatternSet> set;  // they would come to

    bool operator==(const GenerateRequest&) const = default;
};

// One of the two ends of the dialog: what it would add, and to what.
struct GenerateOutcome {
    std::vector<Candidate> fresh;
    std::size_t patterns_after = 0;
    double map_s = 0.0;  // by estimate
};

// What a design would make of a set: a snapshot.
struct GeneratePlan {
    GenerateRequest request;
    std::string fault;  // of the design; then there is nothing else
    Candidates found;
    GenerateOutcome add;
    GenerateOutcome replace;
    std::size_t generated_before = 0;  // patterns that `replace` takes away
};

struct GenerateState {
    DesignSpace draft;
    std::optional<DesignSpace> draft_of;  // the document's generator when the draft was begun
    bool begun = false;
    std::string typing;  // the entry that has the keyboard ...
    std::string text;    // ... and what stands in it
    DesignSpace draft_before_typing;
    bool takes_back = false;  // what is typed is no good, or was left by Esc
    std::string refused;      // the entry whose last text was no good ...
    std::string refusal;   // ... and why: it stands beside the entry until that is typed in again
    float rows_px = 0.0F;  // height of all parameters, in the last frame,
    float row_px = 0.0F;   // and width of the widest one
    RhythmChoice rhythms;
    std::optional<Before> asking;  // whether this many are really wanted
    Query<GenerateRequest, GeneratePlan> job;
};

}  // namespace tact
