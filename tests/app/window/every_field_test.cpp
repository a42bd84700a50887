// Every number that is described has one range in the window, in files and in a terminal. What
// files take is tried in tests/model/io/set/every_number_test.cpp.

#include <cmath>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/command_line/command_line.h"
#include "app/model_bench/parts.h"
#include "app/study/parts.h"
#include "model/io/set/model_json.h"
#include "model/io/set/study_json.h"
#include "model/pattern/pattern_numbers.h"
#include "model/study/study_numbers.h"
#include "model/text/numbers.h"
#include "tests/support/typed_numbers.h"

namespace every_field_test {

using namespace tact;

namespace {

struct EditorField {
    const char* id;
    const Number& number;
    double (*value)(const Pattern&);
};

const std::vector<EditorField>& editor_fields() {
    using namespace numbers;
    static const std::vector<EditorField> kFields{
        {"amplitude_g", kAmplitude, [](const Pattern& p) { return p.amplitude_g; }},
        {"carrier_1_hz", kCarrier, [](const Pattern& p) { return p.carriers[0].frequency_hz; }},
        {"carrier_3_hz", kCarrier, [](const Pattern& p) { return p.carriers[2].frequency_hz; }},
        {"weight_2", kWeight, [](const Pattern& p) { return p.carriers[1].weight; }},
        {"modulation_hz", kModulation, [](const Pattern& p) { return p.modulation.frequency_hz; }},
        {"depth", kDepth, [](const Pattern& p) { return p.modulation.depth; }},
        {"unit_ms", kRhythmUnit, [](const Pattern& p) { return p.rhythm.unit_s; }},
        {"steps_a_beat", kStepsABeat,
         [](const Pattern& p) { return double(p.rhythm.meter.steps_a_beat); }},
        {"beats_a_bar", kBeatsABar,
         [](const Pattern& p) { return double(p.rhythm.meter.beats_a_bar); }},
        {"kind_strength_A", kVelocity,
         [](const Pattern& p) { return kind_of(p.rhythm, 'A').velocity; }},
        {"kind_pitch_A", kPitch, [](const Pattern& p) { return kind_of(p.rhythm, 'A').pitch; }},
        {"attack_ms", kAttack, [](const Pattern& p) { return p.attack_s; }},
        {"release_ms", kRelease, [](const Pattern& p) { return p.release_s; }},
        {"duration_s", kDuration, [](const Pattern& p) { return p.duration_s; }}};
    return kFields;
}

Pattern with_every_number() {
    Pattern pattern;
    pattern.carriers.resize(3);
    pattern.modulation = {ModulationKind::am, 5.0, 0.5};
    pattern.rhythm.text = "A-";
    return pattern;
}

// The error of a file with the number that the row has set, as the window shows it; empty: no
// error.
template <class Struct, class Read>
std::string file_fault(const DescribedField<Struct>& row, double shown, const Read& read) {
    Struct all;
    row.set(all, shown);
    const Json document = json_of(all);
    JsonReading reading{"F", {}};
    JsonObject object = object_at(reading, document, "");
    Json unknown;
    (void)read(object, unknown);
    return reading.fault;
}

template <class Struct, class Read>
void check_row(const DescribedField<Struct>& row, const Read& read) {
    CAPTURE(row.field.id);
    for (const double end : {row.field.typed.low, row.field.typed.high}) {
        Struct all;
        row.set(all, end);
        CHECK(row.get(all) == doctest::Approx(end).epsilon(1e-15));
        CHECK(file_fault(row, end, read) == "");
    }
    // A whole number's next is one more.
    const double high = row.field.typed.high;
    Struct all;
    row.set(all, std::nextafter(high, std::numeric_limits<double>::infinity()));
    const bool is_whole = row.get(all) == high;
    const double beyond = is_whole ? high + 1.0 : row.get(all);
    CHECK(file_fault(row, beyond, read).find(" to ") != std::string::npos);
}

std::string refusal_of_study(const char* option, double value) {
    const std::string text = shortest_digits(value);
    const char* words[] = {"tactspace", "study", option, text.c_str()};
    std::ostringstream err;
    std::streambuf* const before = std::cerr.rdbuf(err.rdbuf());
    (void)run_command_line(4, words, nullptr);
    std::cerr.rdbuf(before);
    return err.str();
}

}  // namespace

TEST_CASE("every number: a field of the editor takes what files take, and stops at their ends") {
    PatternSet set = short_patterns(1);
    set.vibrations[0].source = with_every_number();
    Program program(set);
    program.resize({1600.0F, 2600.0F}, 1.0F);  // the whole editor is in sight
    for (const EditorField& field : editor_fields()) {
        CAPTURE(field.id);
        const std::string entry = std::string("entry:") + field.id;
        const Range shown = field.number.shown(field.number.range);
        const auto typed = [&](double number) {
            program.app.ui.status = {};
            enter(program, entry, shortest_digits(number));
            return field.value(program.pattern(0));
        };
        CHECK(typed(shown.high) == field.number.range.high);
        CHECK(program.app.ui.status.text.find("taken") == std::string::npos);
        CHECK(typed(shown.high + 1.0) == field.number.range.high);
        CHECK(program.app.ui.status.text.find(", the most, was taken") != std::string::npos);
        CHECK(typed(shown.low) == field.number.range.low);
        CHECK(program.app.ui.status.text.find("taken") == std::string::npos);
        CHECK(typed(shown.low - 1.0) == field.number.range.low);
        CHECK(program.app.ui.status.text.find(", the least, was taken") != std::string::npos);
        edit_patterns(program.app.work, [](Pattern& pattern) { pattern = with_every_number(); });
        program.settle();
    }
}

TEST_CASE("every number: rows of the model and of a study end where files end") {
    for (const ModelNumber& row : trained_rows()) check_row(row, model_of);
    for (const ModelNumber& row : number_rows()) check_row(row, model_of);
    for (const StudyNumber& number : study_numbers()) check_row(number.row, study_design_of);
}

TEST_CASE("every number: options that stand for a study's numbers say the files' range") {
    const std::pair<const char*, Number> options[] = {{"--seed", numbers::kStudySeed},
                                                      {"--repetitions", numbers::kRepetitions},
                                                      {"--attention", numbers::kAttentionPairs}};
    for (const auto& [option, number] : options) {
        CAPTURE(option);
        const std::string expected = "expected " + range_words(number.range) + ", got";
        for (const double beyond : {number.range.low - 1.0, number.range.high + 1.0}) {
            CHECK(refusal_of_study(option, beyond).find(expected) != std::string::npos);
        }
        for (const double end : {number.range.low, number.range.high}) {
            CHECK(refusal_of_study(option, end).find(expected) == std::string::npos);
        }
    }
}

}  // namespace every_field_test
