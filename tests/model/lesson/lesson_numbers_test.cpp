// Numbers in the texts of lessons: each is recomputed here from the model, in another way than the
// lessons do; none is typed.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "assets/assets.h"
#include "model/dtw/dtw.h"
#include "model/io/lesson/lesson_file.h"
#include "model/lesson/lesson_numbers.h"
#include "model/map/mds.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/perceptual_model/rhythm_envelope.h"
#include "model/physiology/firing.h"
#include "model/physiology/neural_coding.h"
#include "model/set/set_ratings.h"
#include "model/study/ratings.h"
#include "model/text/numbers.h"
#include "model/textbook/textbook.h"

namespace lesson_numbers_test {

using namespace tact;

namespace {

std::vector<Lesson> bundled() {
    std::vector<Lesson> lessons;
    for (const Asset& file : assets()) {
        if (!file.path.starts_with("lessons/")) continue;
        auto lesson = parse_lesson(file.text, std::string(file.path), {});
        REQUIRE_MESSAGE(lesson, (lesson ? "" : lesson.error().message));
        lessons.push_back(*std::move(lesson));
    }
    REQUIRE(lessons.size() == 9);
    return lessons;
}

std::vector<std::string> words_of(const std::string& placeholder) {
    std::vector<std::string> words;
    std::size_t from = 0;
    for (;;) {
        const std::size_t bar = placeholder.find('|', from);
        words.emplace_back(trimmed(placeholder.substr(from, bar - from)));
        if (bar == std::string::npos) return words;
        from = bar + 1;
    }
}

std::size_t type_of(const std::string& name) {
    const std::vector<std::string> names{"Meissner", "Pacinian", "Merkel", "Ruffini"};
    const auto at = std::ranges::find(names, name);
    REQUIRE(at != names.end());
    return static_cast<std::size_t>(at - names.begin());
}

// For numbers from 0.01 on.
std::string two_digits(double value) {
    return value < 100.0 ? significant_digits(value, 2)
                         : std::to_string(static_cast<int>(value + 0.5));
}

std::string three_digits(double value) {
    return value < 1000.0 ? significant_digits(value, 3)
                          : std::to_string(static_cast<int>(value + 0.5));
}

// Results of the set by direct calls: waveforms, codes, pairs.
struct Recomputed {
    PatternSet set;
    std::vector<Waveform> waveforms;
    std::vector<NeuralCodingStages> stages;

    explicit Recomputed(const PatternSet& of) : set(of), waveforms(model_waveforms(of)) {
        for (const Waveform& waveform : waveforms) {
            stages.push_back(neural_coding_stages(waveform, set.model.coding, KeepLayers::none));
        }
    }

    std::size_t place(const std::string& name) const { return place_named(set, name).value(); }

    const Pattern& pattern(const std::string& name) const {
        return std::get<Pattern>(set.vibrations[place(name)].source);
    }

    double nc(std::size_t a, std::size_t b) const {
        return nc_dissimilarity(stages[a].code, stages[b].code, set.model.channel_weight);
    }

    double oc(std::size_t a, std::size_t b) const {
        return dtw(rhythm_envelope(waveforms[a].samples_g, set.model.envelope),
                   rhythm_envelope(waveforms[b].samples_g, set.model.envelope));
    }

    int spikes(std::size_t type, const std::string& name) const {
        const ChannelStages& channel = stages[place(name)].channel[type];
        int sum = 0;
        for (std::size_t k = 0; k < channel.grid.receptors.size(); ++k) {
            const GridReceptor& receptor = channel.grid.receptors[k];
            if (receptor.column != 0 || receptor.row != 0) continue;
            for (const int count : channel.spike_count[k]) sum += count;
        }
        return sum;
    }

    // Percentage of the 5 ms steps in which the centre of a network sends at least this number.
    std::string share(std::size_t type, const std::string& name, int least) const {
        const std::vector<int>& counts = stages[place(name)].code.central_count[type];
        double steps = 0.0;
        for (const int count : counts) steps += count >= least ? 1.0 : 0.0;
        return significant_digits(100.0 * steps / static_cast<double>(counts.size()), 3) + " %";
    }

    double moved_um(const std::string& name) const {
        const Pattern& p = pattern(name);
        const double omega = 2.0 * std::numbers::pi * p.carriers[0].frequency_hz;
        return p.amplitude_g * p.carriers[0].weight * 9.80665e6 / (omega * omega);
    }
};

std::string of_pattern(const Recomputed& model, const std::vector<std::string>& words) {
    const std::string& name = words[1];
    const Pattern& p = model.pattern(name);
    if (words[0] == "frequency") return significant_digits(p.carriers[0].frequency_hz, 4) + " Hz";
    if (words[0] == "amplitude") return significant_digits(p.amplitude_g, 3) + " g";
    if (words[0] == "modulation") return significant_digits(p.modulation.frequency_hz, 3) + " Hz";
    if (words[0] == "duration") return significant_digits(p.duration_s, 3) + " s";
    if (words[0] == "displacement") return two_digits(model.moved_um(name)) + " \u00b5m";
    REQUIRE(words[0] == "felt");
    std::vector<std::string> felt;
    for (const char* type : {"Meissner", "Pacinian", "Merkel", "Ruffini"}) {
        const std::size_t place = model.place(name);
        const bool leaks =
            only_leaks(model.stages[place], model.set.model.coding, kReceptors[type_of(type)]);
        if (!leaks && model.spikes(type_of(type), name) > 0) felt.emplace_back(type);
    }
    REQUIRE_FALSE(felt.empty());
    std::string text = felt[0];
    for (std::size_t k = 1; k + 1 < felt.size(); ++k) text += ", " + felt[k];
    return felt.size() == 1 ? text : text + " and " + felt.back();
}

std::string of_type(const Recomputed& model, const std::vector<std::string>& words) {
    const std::size_t type = type_of(words[1]);
    const std::string& name = words[2];
    const Activation& activation = model.stages[model.place(name)].code.activation[type];
    const Pattern& p = model.pattern(name);
    const auto& code = model.stages[model.place(name)].code;
    if (words[0] == "threshold") {
        const Curve& curve = model.set.model.coding.tables.threshold[type];
        return significant_digits(std::pow(10.0, at(curve, p.carriers[0].frequency_hz)), 2) +
               " \u00b5m";
    }
    if (words[0] == "spikes") return std::to_string(model.spikes(type, name));
    if (words[0] == "per cycle") {
        return significant_digits(
            model.spikes(type, name) / (p.duration_s * p.carriers[0].frequency_hz), 2);
    }
    if (words[0] == "rate") return significant_digits(activation.rate_hz, 3) + " impulses/s";
    if (words[0] == "radius") return significant_digits(activation.radius_mm, 2) + " mm";
    if (words[0] == "on") return model.share(type, name, 1);
    if (words[0] == "at cap") return model.share(type, name, 50);
    REQUIRE(words[0] == "receptors");
    return std::to_string(activation.radius_mm > 0.0 ? code.activated[type] : 0);
}

std::string of_pair(const Recomputed& model, const Prediction& prediction,
                    const std::vector<std::string>& words) {
    const std::size_t a = model.place(words[1]);
    const std::size_t b = model.place(words[2]);
    if (words[0] == "nc") return significant_digits(model.nc(a, b), 3);
    if (words[0] == "oc") return three_digits(model.oc(a, b));
    if (words[0] == "pm") return significant_digits(prediction.pm(a, b), 3);
    REQUIRE(words[0] == "pm rank");
    int closer = 0;
    int pairs = 0;
    for (std::size_t i = 0; i < model.waveforms.size(); ++i) {
        for (std::size_t j = i + 1; j < model.waveforms.size(); ++j) {
            ++pairs;
            if (prediction.pm(i, j) < prediction.pm(a, b)) ++closer;
        }
    }
    return std::to_string(closer + 1) + " of " + std::to_string(pairs);
}

std::string of_table(const Recomputed& model, const std::vector<std::string>& words) {
    const std::size_t type = type_of(words[1]);
    constexpr std::array<double, 4> kPerMm2{1.4, 0.2, 0.7, 0.1};  // Table 1 of the paper
    if (words[0] == "density") return significant_digits(kPerMm2[type], 3) + " per mm\u00b2";
    if (words[0] == "interval")
        return significant_digits(1.0 / std::sqrt(kPerMm2[type]), 3) + " mm";
    return significant_digits(model.set.model.channel_weight[type], 3);
}

// K by its definition, from all distances of both maps.
double k_of(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    double ab = 0.0;
    double aa = 0.0;
    double bb = 0.0;
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
        for (Eigen::Index j = 0; j < i; ++j) {
            const double of_a = (a.row(i) - a.row(j)).norm();
            const double of_b = (b.row(i) - b.row(j)).norm();
            ab += of_a * of_b;
            aa += of_a * of_a;
            bb += of_b * of_b;
        }
    }
    return std::sqrt(1.0 - ab * ab / (aa * bb));
}

// Equal ranks share their mean; Pearson's correlation of them.
double rho_of(const std::vector<double>& a, const std::vector<double>& b) {
    const auto ranks = [](const std::vector<double>& values) {
        std::vector<double> all;
        for (const double v : values) {
            const auto below = std::ranges::count_if(values, [v](double w) { return w < v; });
            const auto equal = std::ranges::count(values, v);
            all.push_back(static_cast<double>(below) + 0.5 * static_cast<double>(equal));
        }
        return all;
    };
    const std::vector<double> x = ranks(a);
    const std::vector<double> y = ranks(b);
    const double mean = 0.5 * static_cast<double>(x.size());
    double xy = 0.0;
    double xx = 0.0;
    double yy = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        xy += (x[k] - mean) * (y[k] - mean);
        xx += (x[k] - mean) * (x[k] - mean);
        yy += (y[k] - mean) * (y[k] - mean);
    }
    return xy / std::sqrt(xx * yy);
}

// The ratings of a bundled lesson have its patterns in their order.
std::string of_maps(const Recomputed& model, const Prediction& prediction,
                    const std::vector<std::string>& words) {
    const Dissimilarity people = mean_ratings(*study_of(model.set));
    if (words[0] == "rho") {
        return significant_digits(rho_of(prediction.pm.condensed, people.condensed), 2);
    }
    const MdsParams params = standard_mds_params(model.waveforms.size(), 3);
    const PerceptualSpace pm = nonmetric_mds(prediction.pm, params);
    const PerceptualSpace rated = nonmetric_mds(people, params);
    if (words[0] == "k") return significant_digits(k_of(pm.points, rated.points), 2);
    return significant_digits(words[1] == "pm" ? pm.stress1 : rated.stress1, 2);
}

std::string recomputed(const Recomputed& model, const Prediction& prediction,
                       const std::string& placeholder) {
    const std::vector<std::string> words = words_of(placeholder);
    // Facts of the textbook are not numbers of the model: tests/model/textbook reads them again.
    if (words[0] == "fact" || words[0] == "source") {
        const TextbookFact* fact = fact_named(words[1]);
        REQUIRE(fact != nullptr);
        return words[0] == "fact" ? value_text(*fact) : source_text(*fact);
    }
    const bool of_map = words[0] == "stress" || words[0] == "k" || words[0] == "rho";
    if (of_map) return of_maps(model, prediction, words);
    if (words[0] == "excitatory layers") {
        return std::to_string(model.set.model.coding.excitatory_layers);
    }
    if (words[0] == "inhibitory layers") {
        return std::to_string(model.set.model.coding.inhibitory_layers);
    }
    if (words[0] == "density" || words[0] == "interval" || words[0] == "weight") {
        return of_table(model, words);
    }
    if (words.size() == 2) return of_pattern(model, words);
    const bool pair = words[0] == "nc" || words[0] == "oc" || words[0].starts_with("pm");
    return pair ? of_pair(model, prediction, words) : of_type(model, words);
}

std::string without(std::string text, const std::string& part, const std::string& instead) {
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part)) {
        text.replace(at, part.size(), instead);
    }
    return text;
}

}  // namespace

TEST_CASE("lessons: every number in a text of a bundled lesson is the model's, recomputed" *
          doctest::test_suite("long")) {
    for (const Lesson& lesson : bundled()) {
        CAPTURE(lesson.name);
        const LessonAnswers answers = lesson_answers(lesson);
        const Recomputed model(lesson.set);
        const auto prediction = predict(model.waveforms, lesson.set.model);
        REQUIRE(prediction);
        std::size_t numbers = 0;
        for (const LessonStep& step : lesson.steps) {
            for (const std::string& text : texts_of(step)) {
                for (const std::string& placeholder : placeholders_in(text)) {
                    CAPTURE(placeholder);
                    REQUIRE(answers.numbers.contains(placeholder));
                    CHECK(answers.numbers.at(placeholder) ==
                          recomputed(model, *prediction, placeholder));
                    ++numbers;
                }
                CHECK(filled(text, answers.numbers).find('{') == std::string::npos);
            }
        }
        CHECK(numbers > 5);
    }
}

TEST_CASE("lessons: no number is typed that the model could give") {
    for (const Lesson& lesson : bundled()) {
        CAPTURE(lesson.name);
        for (const LessonStep& step : lesson.steps) {
            for (std::string text : texts_of(step)) {
                for (const std::string& placeholder : placeholders_in(text)) {
                    text = without(text, "{" + placeholder + "}", "");
                }
                for (const Vibration& vibration : lesson.set.vibrations) {
                    text = without(text, vibration.name, "");
                }
                // The model's window, which is not a parameter, and an equation's number.
                text = without(without(text, "10 ms", ""), "Eq. 2", "");
                CAPTURE(text);
                CHECK(std::ranges::none_of(text, [](char c) { return c >= '0' && c <= '9'; }));
            }
        }
    }
}

TEST_CASE("lessons: a number is told where the stage that it belongs to is on screen") {
    // Numbers of parameters are allowed everywhere; "all" shows every stage.
    const std::map<std::string, std::string> stages{{"displacement", "spectrum filtered"},
                                                    {"threshold", "spectrum"},
                                                    {"felt", "receptors spikes"},
                                                    {"spikes", "receptors spikes"},
                                                    {"per cycle", "receptors spikes"},
                                                    {"rate", "receptors spikes"},
                                                    {"receptors", "receptors"},
                                                    {"radius", "receptors"},
                                                    {"density", "receptors"},
                                                    {"interval", "receptors"},
                                                    {"excitatory layers", "networks"},
                                                    {"inhibitory layers", "networks"},
                                                    {"on", "central brain"},
                                                    {"at cap", "networks central"},
                                                    {"weight", "brain"},
                                                    {"nc", "brain map"},
                                                    {"oc", "envelope brain map"},
                                                    {"pm", "brain envelope map"},
                                                    {"pm rank", "brain envelope map"},
                                                    {"stress", "map"},
                                                    {"k", "map"},
                                                    {"rho", "map"}};
    for (const Lesson& lesson : bundled()) {
        CAPTURE(lesson.name);
        for (const LessonStep& step : lesson.steps) {
            CAPTURE(step.title);
            std::set<std::string> told;  // patterns that the text gives numbers of
            for (const std::string& placeholder : placeholders_in(step.text)) {
                CAPTURE(placeholder);
                const std::vector<std::string> words = words_of(placeholder);
                const auto where = stages.find(words[0]);
                if (where != stages.end()) {
                    CHECK(
                        (step.view == "all" || where->second.find(step.view) != std::string::npos));
                }
                for (std::size_t k = 1; k < words.size(); ++k) {
                    if (place_named(lesson.set, words[k])) told.insert(words[k]);
                }
            }
            CHECK((told.empty() || told.contains(step.pattern) || told.contains(step.partner)));
        }
    }
}

TEST_CASE("lessons: how slow a step is said to be is how slow it is, and no count is spelt out") {
    const auto says = [](const std::string& text, const std::string& word) {
        const auto is_letter = [](char c) { return (c | 32) >= 'a' && (c | 32) <= 'z'; };
        for (std::size_t at = text.find(word); at != std::string::npos;
             at = text.find(word, at + 1)) {
            const std::size_t end = at + word.size();
            const bool begins = at == 0 || !is_letter(text[at - 1]);
            if (begins && (end == text.size() || !is_letter(text[end]))) return true;
        }
        return false;
    };
    int slow = 0;
    for (const Lesson& lesson : bundled()) {
        for (const LessonStep& step : lesson.steps) {
            CAPTURE(step.title);
            for (const std::string& text : texts_of(step)) {
                const bool tenth = text.find("ten times slower") != std::string::npos;
                const bool hundredth = text.find("hundred times slower") != std::string::npos;
                if (tenth) CHECK(step.speed == 0.1);
                if (hundredth) CHECK(step.speed == 0.01);
                slow += tenth || hundredth ? 1 : 0;
                // Two, three and four are items on the screen; larger numbers are the model's.
                for (const char* word : {"five", "six", "seven", "eight", "nine", "eleven",
                                         "twenty", "thirty", "forty", "fifty", "thousand"}) {
                    CHECK_FALSE(says(text, word));
                }
                if (says(text, "twelve")) CHECK(lesson.set.vibrations.size() == 12);
                if (says(text, "hundred")) CHECK(hundredth);
                if (says(text, "ten")) CHECK(tenth);
            }
        }
    }
    CHECK(slow >= 2);
}

TEST_CASE(
    "lessons: every step of a bundled lesson says where its facts are from, and was looked up") {
    for (const Lesson& lesson : bundled()) {
        for (const LessonStep& step : lesson.steps) {
            CAPTURE(step.title);
            CHECK_FALSE(step.source.empty());
            CHECK(step.source.find("not looked up") == std::string::npos);
            CHECK_FALSE(step.text.empty());
        }
    }
}

TEST_CASE("lessons: what a question is answered with is what the model ranks" *
          doctest::test_suite("long")) {
    for (const Lesson& lesson : bundled()) {
        const LessonAnswers answers = lesson_answers(lesson);
        const auto prediction = predict(model_waveforms(lesson.set), lesson.set.model);
        for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
            const auto& question = lesson.steps[k].question;
            if (!question || question->pairs.empty()) continue;
            CAPTURE(question->ask);
            REQUIRE_FALSE(answers.questions[k].right.empty());
            const auto pm = [&](const PatternPair& pair) {
                return prediction->pm(place_named(lesson.set, pair.a).value(),
                                      place_named(lesson.set, pair.b).value());
            };
            const double right = pm(question->pairs[answers.questions[k].right[0]]);
            for (const PatternPair& pair : question->pairs) {
                const bool closest = question->kind == QuestionKind::closest;
                CHECK((closest ? right <= pm(pair) : right >= pm(pair)));
            }
            // A question whose answers are all right asks nothing.
            CHECK(answers.questions[k].right.size() < question->pairs.size());
        }
    }
}

TEST_CASE("lessons: some of what can be chosen is wrong, and some right" *
          doctest::test_suite("long")) {
    for (const Lesson& lesson : bundled()) {
        const LessonAnswers answers = lesson_answers(lesson);
        for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
            if (!lesson.steps[k].question) continue;
            CAPTURE(lesson.steps[k].question->ask);
            CHECK(answers.questions[k].right.size() >= 1);
            CHECK(answers.questions[k].right.size() < answers.questions[k].options.size());
        }
    }
}

TEST_CASE("lessons: a pattern is placed next to the one that PM has nearest") {
    int placed = 0;
    for (const Lesson& lesson : bundled()) {
        for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
            const LessonStep& step = lesson.steps[k];
            if (!step.question || step.question->kind != QuestionKind::place) continue;
            ++placed;
            const QuestionAnswer answer = lesson_answers(lesson).questions[k];
            const auto prediction = predict(model_waveforms(lesson.set), lesson.set.model);
            const std::size_t at = place_named(lesson.set, step.pattern).value();
            REQUIRE(answer.right.size() == 1);
            CHECK(answer.options.size() == lesson.set.vibrations.size() - 1);
            const auto pm = [&](const std::string& name) {
                return prediction->pm(at, place_named(lesson.set, name).value());
            };
            for (const std::string& name : answer.options) {
                CHECK(name != step.pattern);
                CHECK(pm(answer.options[answer.right[0]]) <= pm(name));
            }
            // Before the pairs are computed, their numbers are missing.
            CHECK(lesson_answers(lesson, {}, false).questions[k].right.empty());
        }
    }
    CHECK(placed >= 1);
}

TEST_CASE("lessons: a placeholder that cannot be evaluated is told, with what is missing") {
    const PatternSet set = bundled()[0].set;
    const std::string name = set.vibrations[0].name;
    CHECK(placeholder_fault("nc | " + name + " | nobody", set).find("nobody") != std::string::npos);
    CHECK(placeholder_fault("spikes | Krause | " + name, set).find("Meissner") !=
          std::string::npos);
    CHECK(placeholder_fault("loudness | " + name, set).find("expected one of") == 0);
    CHECK(placeholder_fault("nc | " + name + " | " + name, set).find("differ") !=
          std::string::npos);
    CHECK(placeholder_fault("frequency | " + name, set).empty());
    CHECK(filled("a {b} c {d", {{"b", "2"}}) == "a 2 c {d");
    CHECK(filled("a {x}", {}) == "a \u2026");
}

TEST_CASE("lessons: a frequency that is drawn has no one number, and what needs one is refused") {
    PatternSet set;
    set.vibrations.resize(2);
    set.vibrations[0].name = "sweep";
    set.vibrations[1].name = "tone";
    Pattern sweep;
    sweep.frequency_curve = {{0.0, 20.0}, {1.0, 60.0}};
    set.vibrations[0].source = sweep;
    set.vibrations[1].source = Pattern{};
    for (const std::string word : {"frequency | ", "displacement | ", "threshold | Pacinian | ",
                                   "per cycle | Pacinian | "}) {
        CHECK(placeholder_fault(word + "sweep", set).find("drawn") != std::string::npos);
        CHECK(placeholder_fault(word + "tone", set).empty());
    }
    CHECK(placeholder_fault("amplitude | sweep", set).empty());
    CHECK(placeholder_fault("felt | sweep", set).empty());
}

TEST_CASE("lessons: in a set of twelve, nine places can be chosen, and the nearest is among them") {
    Lesson lesson;
    for (int k = 0; k < 12; ++k) {
        Pattern pattern;
        pattern.duration_s = 0.1;
        pattern.amplitude_g = 0.2 + 0.15 * ((5 * k) % 12);
        pattern.carriers[0].frequency_hz = 40.0 + 20.0 * ((7 * k) % 12);
        Vibration vibration;
        vibration.name = "p" + std::to_string(k);
        vibration.source = pattern;
        lesson.set.vibrations.push_back(vibration);
    }
    lesson.steps.resize(1);
    lesson.steps[0].pattern = "p11";
    lesson.steps[0].question.emplace();
    lesson.steps[0].question->kind = QuestionKind::place;
    lesson.steps[0].question->ask = "Where?";
    const LessonAnswers answers = lesson_answers(lesson);
    REQUIRE(answers.questions.size() == 1);
    const QuestionAnswer& answer = answers.questions[0];
    CHECK(answer.options.size() == 9);
    REQUIRE(answer.right.size() >= 1);
    const auto prediction = predict(model_waveforms(lesson.set), lesson.set.model);
    for (std::size_t k = 0; k < 11; ++k) {
        const std::size_t right = place_named(lesson.set, answer.options[answer.right[0]]).value();
        CHECK(prediction->pm(11, right) <= prediction->pm(11, k));
    }
}

TEST_CASE("lessons: a type that follows only what its filter leaks does not count as firing") {
    Lesson lesson;
    Pattern tone;
    tone.amplitude_g = 0.8;
    tone.carriers[0].frequency_hz = 70.0;
    Vibration vibration;
    vibration.name = "tone";
    vibration.source = tone;
    lesson.set.vibrations.push_back(vibration);
    lesson.steps.resize(1);
    lesson.steps[0].pattern = "tone";
    lesson.steps[0].text = "{felt | tone} {spikes | Merkel | tone}";
    lesson.steps[0].question.emplace();
    lesson.steps[0].question->kind = QuestionKind::receptors;
    lesson.steps[0].question->ask = "Who?";
    const LessonAnswers answers = lesson_answers(lesson);
    CHECK(answers.numbers.at("spikes | Merkel | tone") != "0");
    CHECK(answers.numbers.at("felt | tone").find("Merkel") == std::string::npos);
    CHECK(std::ranges::count(answers.questions[0].right, index_of(Receptor::merkel)) == 0);
    CHECK(answers.questions[0].model.find("leaks") != std::string::npos);
}

}  // namespace lesson_numbers_test
