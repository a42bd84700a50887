#include "app/manual/parts.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "app/manual/manual.h"
#include "app/report/report.h"
#include "assets/assets.h"
#include "devices/calibration/calibration_file.h"
#include "model/io/effects/actuator_file.h"
#include "model/io/formats/read_effects.h"
#include "model/io/formats/write_effect.h"
#include "model/io/lesson/course_file.h"
#include "model/io/lesson/lesson_file.h"
#include "model/io/people/exclusions_file.h"
#include "model/io/people/ratings_file.h"
#include "model/io/people/study_file.h"
#include "model/io/recordings/acceleration_file.h"
#include "model/io/recordings/text_waveform.h"
#include "model/io/recordings/wave_file.h"
#include "model/io/set/model_file.h"
#include "model/io/set/set_file.h"
#include "model/io/set/spec_file.h"
#include "model/io/tables/coordinates_file.h"
#include "model/io/tables/matrix_file.h"
#include "model/lesson/lesson_languages.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/times_in.h"

namespace manual_examples_test {

using namespace tact;

namespace {

constexpr std::string_view kFolder = "manual/examples/";

template <class Result>
std::string fault_of(const Result& result) {
    return result ? std::string() : result.error().message;
}

// Empty where the program reads the file as the manual says.
using Reader = std::string (*)(const std::string& text, const std::string& file);

std::string read_ratings_example(const std::string& text, const std::string& file) {
    const auto ratings = parse_ratings(text, file, RatingScale::guess);
    if (!ratings) return ratings.error().message;
    return ratings->study.labels.size() == 3 ? "" : "expected three patterns";
}

std::string read_sidecar(const std::string& text, const std::string& file) {
    const Waveform one{kModelRateHz, {0.0, 0.5, 1.0}};
    const auto recording = parse_wave({wave_bytes(one, 1.0), text}, file);
    if (!recording) return recording.error().message;
    return recording->scale_g == 2.0 ? "" : "expected its full scale";
}

std::string read_accelerations(const std::string& text, const std::string&) {
    const TemporaryFolder folder;
    const auto recording = read_acceleration_file(folder.write("accelerations.csv", text));
    if (!recording) return recording.error().message;
    return recording->waveform.samples_g.empty() ? "expected samples" : "";
}

std::string read_generator(const std::string& text, const std::string& file) {
    const TemporaryFolder folder;
    const auto spec = read_spec_file(folder.write(file, text));
    if (!spec) return spec.error().message;
    return spec->remarks.empty() ? "" : spec->remarks.front();
}

std::string read_effect_example(const std::string& text, const std::string& file) {
    const auto read = read_effects(text, file);
    if (!read) return read.error().message;
    return read->effects.size() == 1 ? "" : "expected one effect";
}

std::string read_set_example(const std::string& text, const std::string& file) {
    const auto set = parse_set(text, file, {});
    if (!set) return set.error().message;
    return set->unknown_json.empty() ? "" : "expected no unknown keys";
}

const std::map<std::string, Reader, std::less<>> kReaders{
    {"set.json", read_set_example},
    {"ratings.csv", read_ratings_example},
    {"square.csv", read_ratings_example},
    {"knock.wav.json", read_sidecar},
    {"accelerations.csv", read_accelerations},
    {"generator.json", read_generator},
    {"click.haps", read_effect_example},
    {"heartbeat.vibrate.json", read_effect_example},
    {"matrix.csv",
     [](const std::string& t, const std::string& f) { return fault_of(parse_matrix(t, f)); }},
    {"coordinates.csv",
     [](const std::string& t, const std::string& f) { return fault_of(parse_coordinates(t, f)); }},
    {"samples.txt", [](const std::string& t,
                       const std::string& f) { return fault_of(parse_text_waveform(t, f)); }},
    {"params.json",
     [](const std::string& t, const std::string& f) { return fault_of(parse_model(t, f)); }},
    {"coil.json",
     [](const std::string& t, const std::string& f) { return fault_of(parse_calibration(t, f)); }},
    {"phone.json",
     [](const std::string& t, const std::string& f) { return fault_of(parse_actuator(t, f)); }},
    {"exclusions.json",
     [](const std::string& t, const std::string& f) { return fault_of(parse_exclusions(t, f)); }},
    {"course.json",
     [](const std::string& t, const std::string& f) { return fault_of(parse_course(t, f)); }},
    {"lesson_de.json",
     [](const std::string& t, const std::string& f) {
         const auto lesson = parse_lesson(t, f, {});
         if (!lesson) return lesson.error().message;
         return std::string(translation_lacks(*lesson).size() == 1 ? "" : "expected one lack");
     }},
    {"lesson.json",
     [](const std::string& t, const std::string& f) { return fault_of(parse_lesson(t, f, {})); }},
    {"S01.jsonl",
     [](const std::string& t, const std::string& f) { return fault_of(parse_study(t, f)); }}};

}  // namespace

TEST_CASE("manual: the example of every format is read by the program's own reader, and shown") {
    const std::string chapter(asset("manual/formats.html"));
    std::size_t examples = 0;
    for (const Asset& file : assets()) {
        if (!file.path.starts_with(kFolder)) continue;
        ++examples;
        const std::string name(file.path.substr(kFolder.size()));
        CAPTURE(name);
        const auto reader = kReaders.find(name);
        REQUIRE(reader != kReaders.end());
        CHECK(reader->second(std::string(file.text), name) == "");
        CHECK(times_in(chapter, "{{example " + name + "}}") == 1);
        CHECK(example_html(name));
    }
    CHECK(examples == kReaders.size());
    CHECK_FALSE(example_html("no such file"));
}

TEST_CASE("manual: parameters and calibrations of the examples say something") {
    const auto text = [](const char* name) { return asset(std::string(kFolder) + name); };
    CHECK((parse_model(text("params.json"), "x")->model != PerceptualModelParams{}));
    CHECK(parse_calibration(text("coil.json"), "x")->points.size() == 3);
    CHECK(parse_study(text("S01.jsonl"), "x")->answers.size() == 3);
    CHECK((parse_set(text("set.json"), "x", {})->vibrations.size() == 3));
}

TEST_CASE(
    "manual: every format that effects are written to is shown, and what can be is read back") {
    CHECK(times_in(std::string(asset("manual/formats.html")), "{{effects}}") == 1);
    const std::string shown = effects_html();
    const std::set<std::string> unread{"android-kotlin", "openxr"};  // program text
    for (const TargetTraits& target : target_formats()) {
        const TargetFormat format = *target_format_of(target.key);
        if (is_sampled(format)) continue;
        CAPTURE(target.key);
        CHECK(times_in(shown, ", <code>swell" + html_escaped(target.ending) + "</code>") >= 1);
        CHECK(times_in(shown, "<summary>" + html_escaped(target.title) + ", ") == 1);
        const auto written =
            write_effect(format, manual_pattern(), {"swell", bundled_actuator(target.map)});
        if (unread.contains(target.key)) continue;
        const auto read = read_effects(written.text, std::string("swell") + target.ending);
        REQUIRE_MESSAGE(read, (read ? "" : read.error().message));
        CHECK(read->effects.size() == 1);
    }
    CHECK(times_in(shown, "WAV") == 0);
}

}  // namespace manual_examples_test
