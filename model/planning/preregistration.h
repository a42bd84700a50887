// A study as it was planned before anybody was asked, and what of it was done otherwise.
//
// Input     the plan, frozen in a file (model/io/studies_out/preregistration_file.h), and the study
// Output    a line for everything that was planned: as planned, or not
// Left out  why: a person says that.
// Exact     same input, same answer.
#pragma once

#include <string>
#include <vector>

#include "model/planning/study_plan.h"
#include "model/study/study_design.h"
#include "model/study/study_results.h"

namespace tact {

struct Preregistration {
    std::string date;     // UTC
    std::string program;  // with its version
    std::string set_name;
    std::string set_fingerprint;    // of what is felt (model/set/set_ratings.h)
    std::string model_fingerprint;  // 16 hexadecimal digits
    std::vector<std::string> patterns;
    std::size_t people = 0;  // who count
    std::size_t pairs = 0;   // that each rates; 0: every pair
    int repetitions = 4;
    int attention_pairs = kAttentionPairs;
    AttentionRule attention{};
    StudyOrder order = StudyOrder::full;
    RatingScaling scaling = RatingScaling::none;
    std::string metric = "pm";
    std::string rival;  // a key of model/evaluation/metric.h
    PlanAssumptions assumed{};
    PlannedStudy expected{};  // of this number of people
};

// What the study is to show, and by which tests: sentences.
std::vector<std::string> hypotheses_of(const Preregistration& plan);
std::vector<std::string> tests_of(const Preregistration& plan);
std::vector<std::string> exclusion_rules_of(const Preregistration& plan);

// The study as it was done.
struct DoneStudy {
    std::string set_fingerprint;    // of what people felt
    std::string model_fingerprint;  // of the model that they were compared with
    std::vector<std::string> patterns;
    std::size_t people = 0;
    int repetitions = 0;
    int attention_pairs = 0;
    AttentionRule attention{};
    StudyOrder order = StudyOrder::full;
    RatingScaling scaling = RatingScaling::none;
    std::vector<std::string> left_out_by_hand{};  // participants, by no rule
};

struct PlannedAndDone {
    std::string what;
    std::string planned;
    std::string done;
    bool is_kept = false;
};

std::vector<PlannedAndDone> planned_and_done(const Preregistration& plan, const DoneStudy& study);

}  // namespace tact
