// What of a lesson's set its numbers are read from. Private to the lesson.
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

// That many digits that count, and of a larger number its whole part, as pictures have it: "2414"
// with three.
std::string plain_digits(double value, int count);

struct CodedPattern {
    NeuralCodingStages stages;  // without layers
    PerReceptor<Firing> firing{};
};

// None: not asked for, or there is none.
struct LessonMaps {
    std::optional<double> pm_stress;
    std::optional<double> people_stress;
    std::optional<double> k;
    std::optional<double> rho;
};

// What people said of the lesson's patterns, as a matrix of its set; empty: nobody rated them.
std::optional<Dissimilarity> people_of(const PatternSet& set);

LessonMaps lesson_maps(const PatternSet& set, const Prediction& prediction, std::stop_token stop);

struct LessonPairs {
    std::vector<CodedPattern> coded;       // of each pattern; empty where no text asks for any
    std::optional<Prediction> prediction;  // where a text or a question asks for pairs
    LessonMaps maps;                       // where a text asks for maps
};

LessonPairs lesson_pairs(const Lesson& lesson, std::stop_token stop, bool with_pairs);

// NC, OC, PM or its rank among all pairs, from 1.
std::string pair_text(const std::string& word, const LessonPairs& pairs, std::size_t a,
                      std::size_t b);

// Of a placeholder without fault.
std::string value_of(const std::string& placeholder, const PatternSet& set,
                     const LessonPairs& pairs);

}  // namespace tact
