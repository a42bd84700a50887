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

// So many digits that count: "120", not "1.2e+02".
std::string plain_digits(double value, int count);

struct CodedPattern {
    NeuralCodingStages stages;  // without layers
    PerReceptor<Firing> firing{};
};

struct LessonPairs {
    std::vector<CodedPattern> coded;       // of each pattern; empty where no text asks for any
    std::optional<Prediction> prediction;  // where a text or a question asks for pairs
};

LessonPairs lesson_pairs(const Lesson& lesson, std::stop_token stop, bool with_pairs);

// NC, OC, PM or its rank among all pairs, from 1.
std::string pair_text(const std::string& word, const LessonPairs& pairs, std::size_t a,
                      std::size_t b);

// Of a placeholder without fault.
std::string value_of(const std::string& placeholder, const PatternSet& set,
                     const LessonPairs& pairs);

}  // namespace tact
