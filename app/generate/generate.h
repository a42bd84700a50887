// Candidates from a design space.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/jobs/jobs.h"
#include "app/patterns/patterns.h"
#include "app/ui/ui.h"
#include "model/design_space/candidates.h"
#include "model/set/set_candidates.h"

namespace tact {

// What the dialog that generates candidates is left at, and what they would be.

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

// Over the window: which candidates to generate.

inline constexpr Dialog kGenerateDialog{.title = "Generate candidates", .is_of_document = true};
void draw_generate_dialog(Ui& ui, Workspace& work, GenerateState& generating);

// Candidates from the document's design space: what a draft would make, and making it.

// Opens the dialog on the document's generator, or on the draft that was left; the first time on
// the current pattern with some of its parameters varied.
void open_generate(Ui& ui, const Workspace& work, GenerateState& generating);

// The pattern's own values, all fixed.
DesignSpace space_around(const Pattern& pattern);

// The work of the dialog's job.
std::optional<GeneratePlan> plan_of(const GenerateRequest& request, std::stop_token stop);

// Asks for the plan of the draft where it is not what was asked for last.
void follow_generate(const Ui& ui, const Workspace& work, GenerateState& generating);

// The plan of the present draft and document; null while it is being made.
std::shared_ptr<const GeneratePlan> current_plan(const Workspace& work,
                                                 const GenerateState& generating);

// Puts the candidates of a plan into the document, with its generator: one step of undo. The first
// of them is selected.
void add_candidates(Ui& ui, Workspace& work, GenerateState& generating, const GeneratePlan& plan,
                    Before before);

}  // namespace tact
