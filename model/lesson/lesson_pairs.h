// The results from which a lesson's numbers are read. Private to the lesson.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "model/lesson/lesson.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/physiology/firing.h"
#include "model/physiology/neural_coding.h"

namespace tact {

struct CodedPattern {
    NeuralCodingStages stages;  // without layers
    PerReceptor<Firing> firing{};
};

// Nullopt: not asked for, or undefined.
struct LessonMaps {
    std::optional<double> pm_stress;
    std::optional<double> people_stress;
    std::optional<double> k;
    std::optional<double> rho;
};

// People's ratings of the lesson's patterns, as a matrix of its set; nullopt: nobody rated them.
std::optional<Dissimilarity> people_of(const PatternSet& set);

LessonMaps lesson_maps(const PatternSet& set, const Prediction& prediction, std::stop_token stop);

struct LessonPairs {
    std::vector<CodedPattern> coded;       // one per pattern; empty if no text needs it
    std::optional<Prediction> prediction;  // if a text or a question needs pairs
    LessonMaps maps;                       // if a text needs maps
};

LessonPairs lesson_pairs(const Lesson& lesson, std::stop_token stop, bool with_pairs);

// NC, OC, PM or its rank among all pairs, from 1.
std::string pair_text(const std::string& word, const LessonPairs& pairs, std::size_t a,
                      std::size_t b);

// The value of a placeholder without fault.
std::string value_of(const std::string& placeholder, const PatternSet& set,
                     const LessonPairs& pairs);

}  // namespace tact
