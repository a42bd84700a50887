// State of the Transform dialog, and what its job has made.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/jobs/query.h"
#include "model/algebra/source_edits.h"

namespace tact {

struct TransformRequest {
    std::uint64_t document = 0;
    std::uint64_t revision = 0;
    std::vector<std::size_t> places;  // of the selected ones that may be edited
    Edit edit;
};

struct TransformTask {
    TransformRequest request;
    std::vector<Vibration> patterns;
    PhysiologyTables tables;
};

struct Transformed {
    TransformRequest request;
    std::vector<Vibration> before;
    std::vector<VibrationSource> after;  // as before where it cannot be edited
    std::size_t left = 0;                // number of those
    std::string fault;                   // of the first of these, as a sentence
};

struct TransformState {
    EditKind kind = EditKind::stretch;
    std::array<std::optional<double>, kEditKindCount> numbers;  // none: what is offered first
    std::string other;  // name of the pattern that is joined or mixed

    Query<TransformTask, Transformed> job;
};

}  // namespace tact
