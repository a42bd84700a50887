// The tables of a study's report as CSV: who took part, how alike they rate, what metrics make of
// the same pairs, and the maps. The answers themselves: model/io/people/study_csv.h.
//
//     participants.csv  participant,counted,why,synthetic,rehearsal,answers,..,<their own fields>
//     reliability.csv   statistic,value,low,high,p,people,n,how,<marks>
//     pairs.csv         a,b,people,<a column a metric>,<marks>
//     table.csv         metric,rho,rho_low,rho_high,p,tau_b,K,..,<marks>
//     differences.csv   metric,against,resampled,rho_difference,se,low,high,p,p_holm,..,<marks>
//     maps.csv          map,pattern,x,y,z,<marks>
//     weights.csv       participant,dimension_1,..,explained,<marks>
//     dimensions.csv    pattern,dimension_1,..,<marks>: the map that the weights are of
//
// Output    "NA" where there is no number; the shortest digits that read back as the same.
//           <marks>: synthetic,left_out,rehearsals; `synthetic` is 1 where nobody was asked for
//           some of the ratings that a line rests on, `left_out` is the number of participants who
//           do not count; `rehearsals` of them felt nothing
// Exact     same input, same bytes.
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "model/evaluation/evaluation.h"
#include "model/evaluation/individuals.h"
#include "model/evaluation/nuisance.h"
#include "model/evaluation/uncertainty.h"
#include "model/study/agreement.h"
#include "model/study/study_results.h"

namespace tact {

// A metric against the mean ratings of the patterns that were rated.
struct MetricOfStudy {
    std::string key;
    Dissimilarity matrix;
    PerceptualSpace space;
    Evaluation evaluation;
};

struct StudyTables {
    std::vector<StudyRecord> records;
    StudyResults results;
    InterRater raters;
    OrderEffects effects;
    std::vector<std::string> labels;  // of the patterns that were rated, in the order of the set
    Mapped people;                    // mean ratings of these
    AlienationChance k_chance;
    std::vector<MetricOfStudy> metrics;
    Individuals individuals;   // of these metrics, in their order
    Uncertainty uncertainty;   // differences: from PM
    std::vector<Given> given;  // what of their agreement is left beside something simple
    IndividualWeights weights;
};

void write_participants_csv(std::ostream& stream, const StudyTables& tables);
void write_reliability_csv(std::ostream& stream, const StudyTables& tables);
void write_pairs_csv(std::ostream& stream, const StudyTables& tables);
void write_metrics_csv(std::ostream& stream, const StudyTables& tables);
void write_differences_csv(std::ostream& stream, const StudyTables& tables);
void write_maps_csv(std::ostream& stream, const StudyTables& tables);
void write_weights_csv(std::ostream& stream, const StudyTables& tables);
void write_dimensions_csv(std::ostream& stream, const StudyTables& tables);

}  // namespace tact
