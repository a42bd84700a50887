// File > Export vibrations: patterns as files of phones and other programs, and, computed in the
// background before anything is written, what that costs in perception.
//
// Input     the set as it is when the dialog opens: nothing changes it while that is open
// Output    whole files and the page export_report.html; the status line says where
// Left out  actuators from files, which "tactspace export --onto" takes.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/jobs/query.h"
#include "app/map/map_state.h"
#include "app/ui/ui.h"
#include "model/export/export_loss.h"

namespace tact {

enum class ExportWhich { all, selected, picked };

struct EffectChoice {
    TargetFormat format = TargetFormat::ahap;
    std::string actuator;  // a bundled one; empty: the format's own
    SampledAs sampled;     // of WAV and CSV
    ExportWhich which = ExportWhich::all;

    bool operator==(const EffectChoice&) const = default;
};

// The whole set is predicted even if only picked patterns are written: the others tell whether the
// picked ones are still the best.
struct LossRequest {
    std::uint64_t number = 0;                // each is another one
    std::shared_ptr<const PatternSet> part;  // what the format holds
    std::vector<std::size_t> written;        // of these, in order
    std::size_t recordings = 0;              // left out of the part
    ExportTarget target;
    std::size_t subset_count = 0;  // 0: the usual one
    SubsetObjective objective = SubsetObjective::max_min;
    std::shared_ptr<const LiveMap> known;  // whose prediction saves work; may be null
    std::string date;
};

struct LiveLoss {
    LossRequest request;
    ExportLoss loss;
};

std::optional<LiveLoss> compute_loss(const LossRequest& request, std::stop_token stop,
                                     std::atomic<float>& progress);

// The document when the dialog opened.
struct ExportGround {
    std::shared_ptr<const PatternSet> set;
    std::vector<std::size_t> selected;  // ascending
    std::vector<std::size_t> picked;
    std::size_t subset_count = 0;
    SubsetObjective objective = SubsetObjective::max_min;
    std::shared_ptr<const LiveMap> known;
};

struct EffectExport {
    EffectChoice choice;
    ExportGround ground;
    std::optional<EffectChoice> asked;  // what `request` is of
    LossRequest request;
    std::uint64_t opened = 0;  // of requests up to this another set was asked about
    bool large = false;        // it would take minutes: predicted when that is asked for
    bool without = false;      // nothing is predicted: large, or stopped by the person
    Query<LossRequest, LiveLoss> job;
    std::shared_ptr<const LiveLoss> answer;  // may be of an earlier request
    SpaceCamera camera;
    std::filesystem::path export_to;  // when the frame is done
};

// Where no actuator is chosen: as it was when the set's effects were read, or the format's own.
ExportTarget target_of(const EffectExport& effects);

// The menu's command; `picked` are names.
void export_effects_dialog(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                           const std::vector<std::string>& picked, std::size_t subset_count,
                           SubsetObjective objective, EffectExport& effects);

// Once a frame while the dialog is open: takes the answer, asks where the choice has changed.
void follow_effects(const Ui& ui, EffectExport& effects);
void predict_anyway(const Ui& ui, EffectExport& effects);
void stop_predicting(EffectExport& effects);
bool is_predicting_loss(const EffectExport& effects);

// The answer is that of what is chosen.
bool is_loss_current(const EffectExport& effects);

// Where to, and then the files.
void choose_effect_folder(Ui& ui, const Workspace& work, const EffectExport& effects);
void export_effects(EffectExport& effects, const std::filesystem::path& folder);

// Writes what is asked for: between two frames, as it draws a picture of the map.
void continue_effect_export(Ui& ui, EffectExport& effects);

void draw_effect_dialog(Ui& ui, const Workspace& work, EffectExport& effects);

}  // namespace tact
