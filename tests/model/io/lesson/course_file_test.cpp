// Course files, and the progress of a class.
#include "model/io/lesson/course_file.h"

#include <doctest/doctest.h>

#include "assets/assets.h"

namespace course_file_test {

using namespace tact;

namespace {

std::string fault_of(const std::string& text) {
    const auto course = parse_course(text, "c.json");
    REQUIRE_FALSE(course);
    return course.error().message;
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

ClassProgress two_students() {
    return {{"Ada",
             {{"lessons/beats.tactlesson.json",
               {3, 5, {{1, {"Which, \"a\"?", "=1+1", true, "2026-11-27T18:40:12Z"}}}}}}},
            {"Bo", {{"/home/x/mine.tactlesson.json", {1, 2, {}}}}}};
}

}  // namespace

TEST_CASE("course file: the one that comes with the program is stored as it is written") {
    const std::string text(asset("courses/touch.tactcourse.json"));
    const auto course = parse_course(text, "c.json");
    REQUIRE_MESSAGE(course, (course ? "" : course.error().message));
    CHECK(print_course(*course) == text);
    for (const std::string& lesson : course->lessons) {
        CHECK_FALSE(asset("lessons/" + lesson + ".tactlesson.json").empty());
    }
    CHECK(is_course_file("a.tactcourse.json"));
    CHECK_FALSE(is_course_file("a.tactlesson.json"));
}

TEST_CASE("course file: what is wrong is told with its place, and what is unknown is kept") {
    CHECK(holds(fault_of("{}"), "/tactcourse: expected the format"));
    CHECK(holds(fault_of(R"({"tactcourse": 1})"), "/lessons: expected at least one lesson"));
    CHECK(holds(fault_of(R"({"tactcourse": 1, "lessons": ["a", "a"]})"), "/lessons/1: expected"));
    CHECK(holds(fault_of(R"({"tactcourse": 1, "lessons": [3]})"), "/lessons/0: expected a text"));
    CHECK(holds(fault_of(R"({"tactcourse": 2, "lessons": ["a"]})"), "/tactcourse"));
    const auto newer = parse_course(R"({"tactcourse": 1, "lessons": ["a"], "room": 12})", "c");
    REQUIRE(newer);
    CHECK(holds(print_course(*newer), "\"room\": 12"));
}

TEST_CASE("progress: what students did comes back, and is a table") {
    const ClassProgress all = two_students();
    const auto again = parse_progress(print_progress(all), "p.json");
    REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
    CHECK(*again == all);
    // No spreadsheet takes an answer for a formula.
    CHECK(answers_csv(all) ==
          "student,lesson,step,question,answer,right,when\n"
          "Ada,beats,2,\"Which, \"\"a\"\"?\",'=1+1,1,2026-11-27T18:40\n");
}

}  // namespace course_file_test
