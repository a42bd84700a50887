#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <sstream>

#include "assets/assets.h"
#include "devices/calibration/calibration_file.h"
#include "model/io/effects/actuator_file.h"
#include "model/io/folders/percent_code.h"
#include "model/io/formats/ahap/ahap_pair.h"
#include "model/io/formats/read_effects.h"
#include "model/io/formats/write_effect.h"
#include "model/io/lesson/course_file.h"
#include "model/io/lesson/lesson_file.h"
#include "model/io/people/exclusions_file.h"
#include "model/io/people/ratings_file.h"
#include "model/io/people/study_file.h"
#include "model/io/people/study_lines.h"
#include "model/io/recordings/acceleration_table.h"
#include "model/io/recordings/text_waveform.h"
#include "model/io/set/model_file.h"
#include "model/io/set/set_file.h"
#include "model/io/tables/coordinates_file.h"
#include "model/io/tables/matrix_file.h"
#include "model/pattern/drawn_fault.h"
#include "model/pattern/rhythm.h"
#include "model/pattern/rhythm_edit.h"
#include "model/physiology/mechanoreceptor.h"
#include "model/text/numbers.h"
#include "model/text/typed_number.h"
#include "tests/fuzz/readers.h"

namespace tact::fuzz {
namespace {

using Seeds = std::vector<std::string>;

// What reads a text and what prints what it read.
template <class Read, class Print>
bool round_trip(const Read& read, const Print& print, std::string_view bytes) {
    const auto once = read(bytes);
    if (!is_read(once)) return false;
    const std::string text = print(*once);
    const auto twice = read(text);
    hold(twice, "what was printed is read");
    hold(print(*twice) == text, "what is read again is the same");
    return true;
}

bool set(std::string_view bytes) {
    return round_trip([](std::string_view text) { return parse_set(text, "fuzz.json", "/"); },
                      [](const PatternSet& set) { return print_set(set); }, bytes);
}

PatternSet drawn_set() {
    PatternSet set;
    set.name = "drawn";
    Pattern pattern;
    pattern.amplitude_curve = {{0.0, 0.0}, {0.5, 1.0}};
    pattern.frequency_curve = {{0.0, 80.0}, {1.0, 200.0}};
    pattern.transients = {{0.25, 1.0}};
    pattern.rhythm = Rhythm{"x-xx=--x"};
    pattern.modulation.frequency_hz = 4.0;
    set.vibrations.resize(2);
    set.vibrations[0].name = "plain";
    set.vibrations[1].name = "drawn";
    set.vibrations[1].source = pattern;
    return set;
}

Seeds set_seeds() { return {print_set(PatternSet{}), print_set(drawn_set())}; }

bool lesson(std::string_view bytes) {
    return round_trip([](std::string_view text) { return parse_lesson(text, "fuzz.json", "/"); },
                      [](const Lesson& read) { return print_lesson(read, {}); }, bytes);
}

Seeds lesson_seeds() {
    Lesson own;
    own.set = drawn_set();
    own.steps.resize(2);
    own.steps[1].camera.emplace();
    LessonQuestion& question = own.steps[1].question.emplace();
    question.ask = "Which?";
    question.options = {"this", "that"};
    own.languages = {"en", "de"};
    own.words = {{"Eine", ""}};
    own.steps[1].words = {{"Titel", "", "", "Welche?", {"", "jene"}, ""}};
    return {print_lesson(own, {}), std::string(asset("lessons/twins.tactlesson.json"))};
}

bool course(std::string_view bytes) {
    const bool is_course = round_trip(
        [](std::string_view text) { return parse_course(text, "fuzz.json"); }, print_course, bytes);
    const bool is_class =
        round_trip([](std::string_view text) { return parse_progress(text, "fuzz.json"); },
                   print_progress, bytes);
    return is_course || is_class;
}

Seeds course_seeds() {
    const ClassProgress students{
        {"Ada",
         {{"lessons/beats.tactlesson.json", {3, 5, {{1, {"Which?", "This", true, "2026"}}}}}}}};
    return {std::string(asset("courses/touch.tactcourse.json")), print_progress(students)};
}

bool model(std::string_view bytes) {
    return round_trip([](std::string_view text) { return parse_model(text, "fuzz.json"); },
                      print_model, bytes);
}

Seeds model_seeds() {
    ModelFile trained;
    trained.training.emplace();
    trained.training->date = "2026-01-02T03:04:05Z";
    trained.training->sets = {{"four", "0123456789abcdef", 4, 6, 20}};
    return {print_model({}), print_model(trained)};
}

bool study(std::string_view bytes) {
    return round_trip([](std::string_view text) { return parse_study(text, "P1.jsonl"); },
                      print_study, bytes);
}

bool exclusions(std::string_view bytes) {
    return round_trip(
        [](std::string_view text) { return parse_exclusions(text, "exclusions.json"); },
        print_exclusions, bytes);
}

Seeds exclusion_seeds() { return {print_exclusions({{"S20", "asleep", "2026-11-23T10:00:00Z"}})}; }

Seeds study_seeds() {
    StudyRecord record;
    record.header.program = "tactspace 1";
    record.header.set_name = "three";
    record.header.set_fingerprint = "0123456789abcdef";
    record.header.patterns = {"low", "mid", "high"};
    record.header.participant = {"P1", {{"age", "27"}}};
    record.header.consented = true;
    record.header.begun = "2026-01-02T03:04:05Z";
    const std::string header = print_study(record);
    record.answers = {PairAnswer{{0, 2}, 54.0, 1, 3, 6.25, "2026-01-02T03:05:00Z"}};
    return {header, print_study(record)};
}

bool ratings(std::string_view bytes) {
    bool accepted = false;
    for (const auto scale :
         {RatingScale::guess, RatingScale::dissimilarity, RatingScale::similarity}) {
        accepted |= is_read(parse_ratings(bytes, "fuzz.csv", scale));
    }
    return accepted;
}

Seeds ratings_seeds() {
    return {"participant,first,second,rating\nP1,a,b,30\nP1,a,c,70\nP1,b,c,50\n",
            ",a,b,c\na,0,3,7\nb,3,0,5\nc,7,5,0\n", "0 3 7\n3 0 5\n7 5 0\n"};
}

bool matrix(std::string_view bytes) {
    const auto once = parse_matrix(bytes, "fuzz.csv");
    if (!is_read(once)) return false;
    std::ostringstream text;
    write_matrix_csv(text, once->labels, once->dissimilarity);
    const auto twice = parse_matrix(text.str(), "fuzz.csv");
    hold(twice, "a matrix that was printed is read");
    hold(twice->labels == once->labels, "labels are kept");
    return true;
}

Seeds matrix_seeds() { return {",a,b,c\na,0,3,7\nb,3,0,5\nc,7,5,0\n"}; }

bool coordinates(std::string_view bytes) {
    const auto once = parse_coordinates(bytes, "fuzz.csv");
    if (!is_read(once)) return false;
    std::ostringstream text;
    write_coordinates_csv(text, once->labels, once->points);
    const auto twice = parse_coordinates(text.str(), "fuzz.csv");
    hold(twice, "coordinates that were printed are read");
    hold(twice->points == once->points, "coordinates are kept");
    return true;
}

Seeds coordinates_seeds() { return {"pattern,x,y,z\na,0,1,2\nb,3,4.5,-5e-3\n"}; }

bool text_waveform(std::string_view bytes) {
    return is_read(parse_text_waveform(bytes, "fuzz.txt"));
}
Seeds text_waveform_seeds() { return {"0\n0.5\n-1e-3\n1\n", "# rate 8000\n0.1\n0.2\n"}; }

bool acceleration(std::string_view bytes) {
    const bool any_time = is_read(parse_acceleration_table(bytes, "fuzz.csv", false));
    const bool rising = is_read(parse_acceleration_table(bytes, "fuzz.csv", true));
    hold(any_time || !rising, "the stricter reader accepts no more");
    return any_time;
}

Seeds acceleration_seeds() {
    return {"time (s),x (g)\n0,0.1\n0.001,0.2\n", "t_ms;ax m/s2\n0;1,5\n1;2,5\n", "1 2 3\n4 5 6\n"};
}

bool calibration(std::string_view bytes) {
    return round_trip([](std::string_view text) { return parse_calibration(text, "fuzz.json"); },
                      print_calibration, bytes);
}

Seeds calibration_seeds() {
    Calibration measured;
    measured.points = {{50.0, 0.5, 0.9, 1.0, 0.1, true}, {150.0, 2.0, 0.95, 2.0, 0.1, true}};
    return {print_calibration(measured)};
}

bool actuator(std::string_view bytes) {
    return round_trip([](std::string_view text) { return parse_actuator(text, "fuzz.acf"); },
                      print_actuator, bytes);
}

Seeds actuator_seeds() { return {print_actuator({})}; }

// What an effect file gives is a pattern that a set can hold.
bool effects(std::string_view bytes) {
    const auto read = read_effects(bytes, "fuzz.ahap");
    if (!is_read(read) || read->effects.empty()) return false;
    PatternSet set;
    for (const Effect& effect : read->effects) {
        set.vibrations.emplace_back();
        set.vibrations.back().name = effect.name;
        set.vibrations.back().source = effect.pattern;
    }
    hold(parse_set(print_set(set), "fuzz.json", "/"), "effects can be saved");
    return true;
}

// Both files in one text, an empty byte between.
bool ahap_pair(std::string_view bytes) {
    const std::size_t end = std::min(bytes.find('\0'), bytes.size());
    const auto first = read_effects(bytes.substr(0, end), "fuzz_continuous.ahap");
    const std::string_view rest = bytes.substr(std::min(end + 1, bytes.size()));
    const auto second = read_effects(rest, "fuzz_transients.ahap");
    if (!is_read(first) || !is_read(second)) return false;
    const auto pair = joined_pair(*first, *second);
    if (!pair) return false;
    PatternSet set;
    Vibration vibration;
    vibration.name = pair->effects.front().name;
    vibration.source = pair->effects.front().pattern;
    set.vibrations.push_back(vibration);
    hold(!drawn_fault(pair->effects.front().pattern), "a pair is a pattern without fault");
    hold(parse_set(print_set(set), "fuzz.json", "/"), "a pair can be saved");
    return true;
}

Seeds ahap_pair_seeds() {
    Pattern pattern;
    pattern.duration_s = 0.3;
    pattern.amplitude_curve = {{0.0, 1.0}, {0.1, 0.5}, {0.3, 0.5}};
    pattern.transients = {{0.2, 0.5, 150.0, 0.022}};
    const EffectTarget target{"x", bundled_actuator("core-haptics")};
    const auto written = write_effect(TargetFormat::ahap_pair, pattern, target);
    return {written.text + '\0' + written.beside};
}

Seeds effects_seeds() {
    return {
        R"({"Version":1,"Pattern":[{"Event":{"Time":0,"EventType":"HapticTransient","EventParameters":[{"ParameterID":"HapticIntensity","ParameterValue":0.8}]}},{"ParameterCurve":{"ParameterID":"HapticIntensityControl","Time":0,"ParameterCurveControlPoints":[{"Time":0,"ParameterValue":1}]}}]})",
        R"({"version":{"major":1,"minor":0,"patch":0},"signals":{"continuous":{"envelopes":{"amplitude":[{"time":0,"amplitude":0.5,"emphasis":{"amplitude":1,"frequency":0.5}},{"time":1,"amplitude":0}],"frequency":[{"time":0,"frequency":0.5},{"time":1,"frequency":0}]}}}})",
        R"({"Metadata":{"Version":1},"PatternList":[{"AbsoluteTime":0,"Pattern":[{"Event":{"Type":"continuous","RelativeTime":0,"Duration":500,"Parameters":{"Intensity":80,"Frequency":50,"Curve":[{"Time":0,"Intensity":0,"Frequency":0},{"Time":500,"Intensity":1,"Frequency":20}]}}}]}]})",
        R"({"timings":[100,50,100],"amplitudes":[255,0,128],"repeat":-1})",
        R"([0,40,15,10.5,200])",
        R"(<vibration-effect><waveform-envelope-effect><control-point amplitude="0.5" frequencyHz="150" durationMs="100"/></waveform-envelope-effect></vibration-effect>)",
        R"(<vibration-effect><waveform-effect><waveform-entry durationMs="100" amplitude="200"/><repeating><waveform-entry durationMs="10" amplitude="0"/></repeating></waveform-effect></vibration-effect>)"};
}

bool rhythm(std::string_view bytes) {
    if (!rhythm_fault(bytes).empty()) return false;
    PatternSet set = drawn_set();
    std::get<Pattern>(set.vibrations[1].source).rhythm = Rhythm{std::string(bytes)};
    hold(parse_set(print_set(set), "fuzz.json", "/"), "a rhythm can be saved");
    return true;
}

Seeds rhythm_seeds() { return {"x-x-", "xx==--x=", "x"}; }

bool typed(std::string_view bytes) {
    bool accepted = false;
    for (const NumberRules& rules :
         {NumberRules{{0.0, 10.0}, "g"}, NumberRules{{1.0, 1000.0}, "Hz"},
          NumberRules{{0.0, 60.0}, "s"}, NumberRules{{0.0, 20.0}, "", true}}) {
        const auto number = typed_number(bytes, 1.0, rules);
        if (!is_read(number)) continue;
        accepted = true;
        hold(rules.allowed.low <= number->value && number->value <= rules.allowed.high,
             "a typed number is within its range");
    }
    return accepted;
}

Seeds typed_seeds() { return {"1.5", "+3dB", "*2", "-10%", "1,5 g", "0.8g"}; }

// A value of the command line, and every number of a table.
bool number(std::string_view bytes) {
    const auto once = finite_number_in(bytes);
    if (!once) return false;
    hold(std::isfinite(*once), "a number is finite");
    hold(finite_number_in(shortest_digits(*once)) == once, "a number's digits read back");
    return true;
}

Seeds number_seeds() { return {"1.5", " +3e-2 ", "-0", "1e308", "010"}; }

bool percent(std::string_view bytes) {
    const std::string text(bytes);
    hold(percent_decoded(percent_encoded(text)) == text, "any bytes can be a name");
    const auto decoded = percent_decoded(text);
    if (!decoded) return false;
    hold(percent_decoded(percent_encoded(*decoded)) == decoded, "a name is kept");
    return true;
}

Seeds percent_seeds() { return {"a.wav", "%25", "gr%C3%BCn", "\xc3\xbc"}; }

bool tables(std::string_view bytes) {
    const bool slopes = is_read(parse_slopes(std::string(bytes)));
    return is_read(parse_thresholds(std::string(bytes))) || slopes;
}

Seeds tables_seeds() {
    return {std::string(asset("physiology/firing_rate_slopes.csv")),
            std::string(asset("physiology/absolute_thresholds.csv"))};
}

}  // namespace

std::span<const Reader> text_readers() {
    static const std::vector<Reader> all{
        {"set", set, set_seeds, {"\"patterns\"", "\"rhythm\"", "\"carriers\"", "\"ratings\""}},
        {"lesson",
         lesson,
         lesson_seeds,
         {"\"steps\"", "\"question\"", "\"pairs\"", "{nc | ", "\"languages\"", "\"de\""}},
        {"course", course, course_seeds, {"\"lessons\"", "\"students\"", "\"answers\""}},
        {"model", model, model_seeds, {"\"training\"", "\"sets\"", "\"weights\""}},
        {"exclusions", exclusions, exclusion_seeds, {"\"excluded\"", "\"because\""}},
        {"study", study, study_seeds, {"\"answer\"", "\"sorting\"", "\"groups\"", "\"pair\""}},
        {"ratings", ratings, ratings_seeds, {"participant", "first", "second", "rating", "felt"}},
        {"matrix", matrix, matrix_seeds, {",0", "nan", "\"\""}},
        {"coordinates", coordinates, coordinates_seeds, {"pattern", ",x", "1e308"}},
        {"text_waveform", text_waveform, text_waveform_seeds, {"rate", "#", "1e-308"}},
        {"acceleration", acceleration, acceleration_seeds, {"time", "(s)", "ms", "m/s2", "V"}},
        {"calibration", calibration, calibration_seeds, {"\"points\"", "\"gain_g\""}},
        {"actuator", actuator, actuator_seeds, {"\"transient\"", "\"law\""}},
        {"ahap_pair", ahap_pair, ahap_pair_seeds, {"\"HapticContinuous\"", "\"Project\""}},
        {"effects",
         effects,
         effects_seeds,
         {"\"Pattern\"", "\"Event\"", "\"ParameterCurve\"", "\"envelopes\"", "\"emphasis\"",
          "\"perceptions\"", "\"keyframes\"", "<repeating>", "<waveform-entry", "durationMs=\"1\"",
          "\"timings\"", "\"PatternList\"", "\"m_vibration\"", "\"Curve\""}},
        {"rhythm", rhythm, rhythm_seeds, {"x", "-", "="}},
        {"typed_number", typed, typed_seeds, {"dB", "Hz", "ms", "%", "*", "/"}},
        {"number", number, number_seeds, {"e-3", "inf", "nan", "0x"}},
        {"percent", percent, percent_seeds, {"%25", "%zz"}},
        {"tables", tables, tables_seeds, {"merkel", "pacinian", "nan", "1e9"}}};
    return all;
}

}  // namespace tact::fuzz
