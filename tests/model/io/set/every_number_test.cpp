// Every number that is described is taken alike wherever it comes from: the same range to its ends,
// and the same sentence just beyond them.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "model/ask/steps.h"
#include "model/design_space/design_space.h"
#include "model/io/effects/actuator_file.h"
#include "model/io/lesson/lesson_json.h"
#include "model/io/set/design_space_json.h"
#include "model/io/set/model_json.h"
#include "model/io/set/set_json.h"
#include "model/io/set/study_json.h"
#include "model/lesson/step_numbers.h"
#include "model/pattern/pattern_numbers.h"
#include "model/perceptual_model/model_numbers.h"
#include "model/study/study_numbers.h"
#include "tests/support/temporary_folder.h"

namespace every_number_test {

using namespace tact;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class Struct>
std::map<std::string, Number> by_place(Of<Struct>) {
    std::map<std::string, Number> all;
    each_number(Struct{}, "", [&all](const std::string& place, const Number& number, double usual) {
        CAPTURE(place);
        CHECK(number.range.contains(usual));
        all.emplace(place, number);
    });
    return all;
}

bool is_bounded(const Number& number) {
    return number.range.high < std::numeric_limits<double>::max();
}

Json with(Json document, const std::string& place, double value) {
    document[Json::json_pointer("/" + place)] = value;
    return document;
}

// A pattern that has one of everything that has numbers.
Json full_pattern() {
    return Json::parse(R"({"carriers": [{}], "rhythm": {"text": "A-", "notes": {"A": {}}},
        "modulation": {"kind": "am"}, "transients": [{"time_s": 0}],
        "amplitude_curve": [{"time_s": 0, "value": 1}],
        "frequency_curve": [{"time_s": 0, "frequency_hz": 150}]})");
}

// The fault of a document, as `read` takes it; empty: it is taken.
using Door = std::function<std::string(const Json& document)>;

template <class Read>
Door json_door(const Read& read) {
    return [read](const Json& document) {
        JsonReading reading{"F", {}};
        JsonObject object = object_at(reading, document, "");
        Json unknown;
        read(object, unknown);
        return reading.fault;
    };
}

const Door kPatternDoor =
    json_door([](JsonObject& object, Json& unknown) { (void)pattern_of(object, 1.0, unknown); });

// "F: /carriers/0/weight: expected a number from -10 to 10, got 10.000000000000002"
std::string refusal(const std::string& place, const Number& number, double got, const char* kind) {
    return "F: /" + place + ": expected " + range_words(number.range, kind) + ", got " +
           text_of_json(Json(got));
}

void check_ends(const std::string& place, const Number& number, const Door& door,
                const Json& document) {
    CAPTURE(place);
    for (const double end : {number.range.low, number.range.high}) {
        CHECK(door(with(document, place, end)) == "");
    }
    for (const double beyond : {std::nextafter(number.range.low, -kInfinity),
                                std::nextafter(number.range.high, kInfinity)}) {
        const std::string fault = door(with(document, place, beyond));
        const bool is_refused = fault == refusal(place, number, beyond, "a number") ||
                                fault == refusal(place, number, beyond, "a whole number");
        CHECK_MESSAGE(is_refused, fault);
    }
}

template <class Struct>
void check_door(Of<Struct> which, const Door& door, const Json& document, std::size_t least) {
    const auto numbers = by_place(which);
    CHECK(numbers.size() >= least);
    for (const auto& [place, number] : numbers) {
        if (is_bounded(number)) check_ends(place, number, door, document);
    }
}

// Puts every number so far beyond its range.
template <class Struct>
struct Beyond : PassOver<Struct> {
    using PassOver<Struct>::operator();
    Struct& all;
    double by;

    Beyond(Struct& changed, double beyond) : all(changed), by(beyond) {}
    template <class Value>
    void operator()(const Number& number, Value Struct::*member) const {
        if constexpr (!std::is_same_v<Value, Range>) {
            all.*member =
                static_cast<Value>((by > 0.0 ? number.range.high : number.range.low) + by);
        }
    }
    template <class Part>
    void operator()(const char*, Part Struct::*part) const {
        describe(Of<Part>{}, Beyond<Part>(all.*part, by));
    }
    template <class One>
    void operator()(const char*, std::map<char, One> Struct::*by_letter) const {
        for (auto& [letter, one] : all.*by_letter) describe(Of<One>{}, Beyond<One>(one, by));
    }
    template <class One>
    void operator()(const ManyOf&, std::vector<One> Struct::*list) const {
        for (One& one : all.*list) describe(Of<One>{}, Beyond<One>(one, by));
    }
    void operator()(const ManyOf&, const Number& number, std::vector<int> Struct::*list) const {
        (all.*list).assign(1, static_cast<int>(number.range.high + by));
    }
};

}  // namespace

TEST_CASE(
    "every number: files take a pattern's to the ends of its range, and say what they refuse") {
    check_door(Of<Pattern>{}, kPatternDoor, full_pattern(), 21);
}

TEST_CASE("every number: files of models, studies, actuators and lessons do the same") {
    check_door(Of<PerceptualModelParams>{}, json_door(model_of), Json::object(), 17);
    check_door(Of<StudyDesign>{}, json_door(study_design_of), Json::parse(R"({"groups": [0]})"),
               10);
    const PatternSet set;
    check_door(Of<LessonStep>{}, json_door([&set](JsonObject& object, Json&) {
                   (void)step_of(object, LookUp{set, {}});
               }),
               Json::parse(R"({"camera": {}})"), 7);
    const Door actuator = [](const Json& document) {
        const auto map = parse_actuator(document.dump(), "F");
        return map ? std::string() : map.error().message;
    };
    check_door(Of<ActuatorMap>{}, actuator,
               Json::parse(R"({"actuator": "a", "frequency_hz": [0.1, 1000]})"), 11);
}

TEST_CASE("every number: a design space takes of a pattern's numbers what a pattern takes") {
    const Door door = json_door(
        [](JsonObject& object, Json& unknown) { (void)design_space_of(object, 1.0, unknown); });
    const Json space = Json::parse(R"({"carriers": [{}], "rhythm": {}, "modulation": {}})");
    const auto numbers = by_place(Of<Pattern>{});
    for (const char* place :
         {"amplitude_g", "carriers/0/frequency_hz", "carriers/0/weight", "modulation/frequency_hz",
          "modulation/depth", "rhythm/unit_s", "attack_s", "release_s", "duration_s"}) {
        REQUIRE(numbers.contains(place));
        check_ends(place, numbers.at(place), door, space);
    }
    // And what says whether a design can be run asks the same.
    DesignSpace edited;
    edited.mix.reset();
    for (const Factor factor : factors(edited)) {
        Values* values = values_of(edited, factor);
        if (values == nullptr) continue;
        const Values usual = *values;
        const Range range = range_of(factor.parameter);
        for (const double end : {range.low, range.high}) {
            *values = fixed(end);
            CHECK(design_fault(edited) == "");
            Pattern pattern;
            set_value(pattern, edited, factor, 0.0);
            CHECK(pattern == clamped(pattern));
        }
        *values = fixed(std::nextafter(range.high, kInfinity));
        CHECK(contains(design_fault(edited), "expected numbers from"));
        *values = usual;
    }
}

TEST_CASE("every number: what colours, varies, parts and steps goes as far as files do") {
    const std::map<PatternParameter, std::string> places{
        {PatternParameter::amplitude, "amplitude_g"},
        {PatternParameter::carrier, "carriers/0/frequency_hz"},
        {PatternParameter::second_carrier, "carriers/0/frequency_hz"},
        {PatternParameter::mix, "carriers/0/weight"},
        {PatternParameter::modulation, "modulation/frequency_hz"},
        {PatternParameter::depth, "modulation/depth"},
        {PatternParameter::rhythm_unit, "rhythm/unit_s"},
        {PatternParameter::attack, "attack_s"},
        {PatternParameter::release, "release_s"}};
    const auto numbers = by_place(Of<Pattern>{});
    Pattern pattern;
    pattern.carriers.resize(2);
    pattern.modulation.kind = ModulationKind::am;
    pattern.rhythm.text = "x-";
    const FeltSteps steps;
    for (const PatternParameter parameter : kPatternParameters) {
        const Number& number = numbers.at(places.at(parameter));
        CAPTURE(traits(parameter).key);
        CHECK(traits(parameter).range == number.range);
        CHECK(traits(parameter).slider == number.slider);
        for (const double end : {number.range.low, number.range.high}) {
            const Pattern there = with_value(pattern, parameter, end);
            CHECK(value_of(there, parameter) == end);
            CHECK(there == clamped(there));
            const auto reached = end_along(pattern, there, parameter);
            REQUIRE(reached);
            CHECK(*reached == there);
            CHECK(kPatternDoor(json_of(there, 1.0)) == "");
        }
        CHECK(value_of(with_value(pattern, parameter, 1e9), parameter) == number.range.high);
        CHECK(stepped(steps, parameter, number.range.high, 1.0) == number.range.high);
    }
}

TEST_CASE("every number: a clamp puts each to the end of its range, and leaves what files take") {
    const Json document = full_pattern();
    JsonReading reading{"F", {}};
    JsonObject object = object_at(reading, document, "");
    Json unknown;
    const Pattern usual = pattern_of(object, 1.0, unknown);
    for (const double by : {1.0, -1.0}) {
        Pattern pattern = usual;
        describe(Of<Pattern>{}, Beyond<Pattern>(pattern, by));
        pattern.amplitude_curve[0].time_s = pattern.frequency_curve[0].time_s = 0.0;
        pattern.transients[0].time_s = 0.0;
        const Pattern taken = clamped(pattern);
        const Json written = json_of(taken, 1.0);
        CHECK(kPatternDoor(written) == "");
        for (const auto& [place, number] : by_place(Of<Pattern>{})) {
            const Json::json_pointer pointer("/" + place);
            if (!is_bounded(number) || !written.contains(pointer)) continue;
            CAPTURE(place);
            CHECK(written[pointer] == (by > 0.0 ? number.range.high : number.range.low));
        }
        StudyDesign design;
        describe(Of<StudyDesign>{}, Beyond<StudyDesign>(design, by));
        clamp_numbers(design);
        CHECK(json_door(study_design_of)(json_of(design)) == "");
    }
}

TEST_CASE("every number: a slider lies in the range that may be typed, and words are not empty") {
    const auto look = [](auto which) {
        for (const auto& [place, number] : by_place(which)) {
            CAPTURE(place);
            CHECK(number.range.low < number.range.high);
            CHECK(number.slider.low < number.slider.high);
            CHECK(number.range.contains(number.slider.low));
            CHECK(number.range.contains(number.slider.high));
            CHECK((!number.logarithmic || number.slider.low > 0.0));
            CHECK(number.step > 0.0);
            CHECK(std::string(number.label) != "");
            REQUIRE(number.help != nullptr);
            CHECK(std::string(number.help) != "");
        }
    };
    look(Of<Pattern>{});
    look(Of<PerceptualModelParams>{});
    look(Of<StudyDesign>{});
    look(Of<LessonStep>{});
    look(Of<ActuatorMap>{});
}

}  // namespace every_number_test
