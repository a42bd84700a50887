// How metrics agree with people: as text, CSV and a paper's words.
#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "app/command_line/commands.h"
#include "app/command_line/people/people.h"
#include "app/foreign/foreign.h"
#include "app/rendering/rendering.h"
#include "model/common/distributions.h"
#include "model/common/expected.h"
#include "model/evaluation/evaluation.h"
#include "model/evaluation/metric_comparison.h"
#include "model/perceptual_model/perceptual_model_params.h"
#include "model/set/pattern_set.h"
#include "model/study/agreement.h"
#include "model/study/who_counts.h"

namespace tact {

// How metrics agree with the people of one set, with all that has to be said of both.

struct SetAgreement {
    std::string name;
    std::size_t patterns = 0;  // rated ones
    RatedPeople people;
    std::vector<LeftOutParticipant> left_out;
    Labels labels;
    MetricTable table;
    InterRater raters;
    std::vector<ForeignMetric> foreign{};  // whose matrices stand behind those of the metrics
};

// Only the rated patterns.
inline const RatedSet& rated_of(const SetAgreement& set) { return rated_part(set.people.rated); }

inline std::size_t metric_count(const SetAgreement& set) { return set.table.matrices.size(); }

inline const char* key_of(const SetAgreement& set, std::size_t metric) {
    const std::size_t own = set.table.metrics.size();
    return metric < own ? traits(set.table.metrics[metric]).key
                        : set.foreign[metric - own].key.c_str();
}

// Agreement with people as tidy tables for R and Python: a row an observation, nothing for what is
// not defined, and on every row whose the numbers are.
//
// Exact     same input, same bytes.

// A row a metric.
void write_metrics_csv(std::ostream& stream, std::span<const SetAgreement> sets);

// A row a participant and metric.
void write_people_csv(std::ostream& stream, std::span<const SetAgreement> sets);

// A row a metric that PM is compared with, and a way to resample.
void write_differences_csv(std::ostream& stream, std::span<const SetAgreement> sets);

// Agreement with people as tables for people at a terminal, each with what it was made by.
//
// Exact     same input, same text.

// Who was asked, and every table of one set. `is_paper`: rho and K alone, as Table 2 has them.
std::string agreement_text(const SetAgreement& set, bool is_paper);

// Means of one metric over sets, and the table of all.
MeanAgreement mean_of(std::span<const SetAgreement> sets, std::size_t metric, Bookkeeping books);
std::string means_text(std::span<const SetAgreement> sets, Bookkeeping books);

// How far anything could agree, each bound with what it bounds; sentences of their own lines.
std::string ceilings_text(const Ceilings& ceilings);

// Sets with their ratings, and how metrics agree with these: the work behind compare and paper.

struct ComparedSet {
    PatternSet set;
    SetAgreement agreement;  // of its rated patterns
};

// In the order of the command's sets. Errors: as load_rated(); a metric or a nuisance that is not
// known or cannot be read.
Expected<std::vector<ComparedSet>> compared_sets(const CompareCommand& command);

// What the numbers of a table were made by: tests, sides, draws, seeds, what was resampled.
//
// Output    the line below a table; or a paragraph for a paper, with its references
// Exact     what is said here is what the parameters hold.

// Lines below each of the tables of a set.
std::string foot_of_table(const SetAgreement& set);
std::string foot_of_uncertainty(const SetAgreement& set);
std::string foot_of_differences(const SetAgreement& set);
std::string foot_of_people(const SetAgreement& set);
std::string foot_of_given(const SetAgreement& set);
std::string foot_of_paper_table(const SetAgreement& set);

std::string methods_text(std::span<const SetAgreement> sets);

// All of a study in a folder: tables, a page, and the scripts that compute their numbers again.

// Into the folder `command.report`, which is made; files that are there are replaced.
Expected<Done> write_study_report(const StudyCommand& command, const PatternSet& set,
                                  CollectedStudy study);

// Optional changes of the model, and their effect on its agreement with people and with the
// publication: a cost of waiting in the OC part, and other thresholds.
//
// Source    ratings: Rothkopf 1957, heard, not felt; the publication's findings
// Output    one outcome per model, the published one first; nothing when stopped
// Valid     two judges without a common pattern: the choice of one is tested by the other. Neither
//           is a rating of vibrations by touch.
// Exact     same input, same bits, on any number of threads.

struct ModelVariant {
    std::string name;
    PerceptualModelParams model;
};

// As published, with costs of waiting from 0.02 to 1, and with the thresholds of the Android Open
// Source Project without and with one.
std::vector<ModelVariant> model_variants();

struct VariantOutcome {
    std::string name;
    PerceptualModelParams model;
    double morse_pm = 0.0;  // Spearman's rho with the ratings
    Interval morse_interval;
    double morse_oc = 0.0;
    std::size_t oc_values = 0;  // distinct values
    std::size_t hold = 0;       // findings that hold
    std::vector<std::string> failing;
    double twelve_rho = 0.0;  // PM of the twelve patterns against the published model's; NaN: no
                              // order
    double twelve_k = 0.0;    // alienation of both maps; NaN: no map
};

struct VariantOptions {
    int threads = 0;  // 0: all cores
    std::stop_token stop = {};
    std::function<void(double)> progress = {};  // share of the work, 0..1
};

std::optional<std::vector<VariantOutcome>> check_variants(const VariantOptions& options);

// The choice of each judge alone; ties: the first.
const VariantOutcome& chosen_by_morse(std::span<const VariantOutcome> all);
const VariantOutcome& chosen_by_findings(std::span<const VariantOutcome> all);

}  // namespace tact
