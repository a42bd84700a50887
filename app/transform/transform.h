// Patterns made of the selected ones: stretched, reversed, joined.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/jobs/jobs.h"
#include "app/ui/ui.h"
#include "model/algebra/source_edits.h"

namespace tact {

// State of the Transform dialog, and what its job has made.

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

// The dialog for edits of the selected patterns: stretch, reverse, join and so on.

// Enter applies the edit, Esc closes the dialog and changes nothing.
inline constexpr Dialog kTransformDialog{.title = "Transform", .is_of_document = true};
void draw_transform_dialog(Ui& ui, Workspace& work, TransformState& state);

// Edits of the selected patterns: asking for them, and taking them into the set.

void open_transform(Ui& ui, const Workspace& work, TransformState& state);

// Why nothing can be transformed, as a sentence; empty: something can.
std::string transform_obstacle(const Workspace& work, const TransformState& state);

// "buzz", "3 patterns", and how many of the selected ones stay unchanged.
std::string transformed_words(const Workspace& work);

// Asks where the question is not what was asked for last, while the dialog is open; stops the work
// when it is not.
void follow_transform(const Ui& ui, const Workspace& work, TransformState& state);

bool is_transforming(const TransformState& state);

// The answer to the question as it stands; null while it is being made.
std::shared_ptr<const Transformed> current_transform(const Workspace& work,
                                                     const TransformState& state);

// Whether any of the patterns could be edited.
bool can_be_applied(const Transformed& made);

// Puts the patterns in the place of the selected ones: one step of undo.
void apply_transform(Ui& ui, Workspace& work, const TransformState& state, const Transformed& made);

}  // namespace tact
