// How metrics of a set agree with the people who rated it: the question behind the tables of the
// command line and of Python. The window asks for the same evaluations of matrices that it keeps
// (evaluations() in model/evaluation/metric_comparison.h).
//
// Source    Lim & Park 2023, Table 2
// Input     what people said, and matrices of the same patterns in their order
// Exact     same input, same bits, on any number of threads.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "model/evaluation/metric_comparison.h"
#include "model/study/agreement.h"
#include "model/study/ratings.h"

namespace tact {

struct PeopleAgreement {
    std::string fault;  // why there is nothing to compare with: what follows is empty then
    RatedPeople people;
    InterRater raters;
    MetricTable table;
};

// Nothing when stopped.
std::optional<PeopleAgreement> people_agreement(const RatingStudy& study, AgreementRequest request);

}  // namespace tact
