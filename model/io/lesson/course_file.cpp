#include "model/io/lesson/course_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "model/io/lesson/lesson_file.h"
#include "model/io/tables/matrix_file.h"
#include "model/lesson/lesson.h"
#include "model/text/atomic_file.h"
#include "model/text/enough_memory.h"
#include "model/text/json_fields.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostStudents = 10'000;
constexpr std::size_t kMostLessons = 1'000;

void need_format(JsonObject& object, const char* key, int format) {
    if (object.reading->fault.empty() && field(object, key) == nullptr) {
        refuse(*object.reading, std::string("/") + key, "the format of the file, 1", Json());
    }
    whole_field(object, key, format, {1.0, static_cast<double>(format)});
}

Course course_of(JsonReading& reading, const Json& document) {
    Course course;
    JsonObject object = object_at(reading, document, "");
    need_format(object, "tactcourse", kCourseFormat);
    course.name = name_field(object, "name", "");
    course.about = text_field(object, "about", "");
    const auto lessons = array_field(object, "lessons", 1, kMaxCourseLessons);
    if (lessons.empty()) refuse(reading, "/lessons", "at least one lesson", Json());
    for (std::size_t k = 0; k < lessons.size() && may_go_on(reading); ++k) {
        const std::string place = "/lessons/" + std::to_string(k);
        const std::string lesson = name_at(reading, *lessons[k], place);
        const bool is_there = std::ranges::find(course.lessons, lesson) != course.lessons.end();
        if (lesson.empty() || is_there) refuse(reading, place, "a lesson, each once", *lessons[k]);
        course.lessons.push_back(lesson);
    }
    const Json unknown = unknown_fields(object);
    if (!unknown.empty()) course.unknown_json = text_of_json(unknown);
    return course;
}

GivenAnswer answer_of(JsonObject object) {
    GivenAnswer answer;
    answer.question = text_field(object, "question", "");
    answer.answer = text_field(object, "answer", "");
    answer.right = yes_no_field(object, "right", false);
    answer.at = name_field(object, "at", "");
    return answer;
}

constexpr Range kSteps{0.0, static_cast<double>(limits::kMaxSteps)};

LessonProgress progress_of(JsonObject object) {
    LessonProgress progress;
    progress.reached = static_cast<std::size_t>(whole_field(object, "reached", 0, kSteps));
    progress.steps = static_cast<std::size_t>(whole_field(object, "steps", 0, kSteps));
    for (const Json* value : array_field(object, "answers", 0, limits::kMaxSteps)) {
        JsonObject answer = object_at(*object.reading, *value, place_of(object, "answers"));
        const int step = whole_field(answer, "step", 0, kSteps);
        progress.answers[static_cast<std::size_t>(step)] = answer_of(answer);
    }
    return progress;
}

Json json_of(const LessonProgress& progress) {
    Json answers = Json::array();
    for (const auto& [step, answer] : progress.answers) {
        answers.push_back({{"step", step},
                           {"question", answer.question},
                           {"answer", answer.answer},
                           {"right", answer.right},
                           {"at", answer.at}});
    }
    return {{"reached", progress.reached}, {"steps", progress.steps}, {"answers", answers}};
}

// "lessons/beats.tactlesson.json" is "beats".
std::string lesson_name(const std::string& key) {
    std::string name = fs::path(key).filename().string();
    if (name.ends_with(kLessonEnding))
        name.resize(name.size() - std::string_view(kLessonEnding).size());
    return name;
}

}  // namespace

bool is_course_file(const fs::path& path) {
    return path.filename().string().ends_with(kCourseEnding);
}

Expected<Course> parse_course(std::string_view text, const std::string& name_for_messages) {
    return with_enough_memory(name_for_messages, [&]() -> Expected<Course> {
        const auto document = parse_json(text, name_for_messages);
        if (!document) return document.error();
        JsonReading reading{name_for_messages, {}, UnknownKeys::kept};
        Course course = course_of(reading, *document);
        if (!reading.fault.empty()) return Error{reading.fault};
        return course;
    });
}

Expected<Course> read_course_file(const fs::path& path) {
    const auto text = read_text_file(path);
    if (!text) return text.error();
    return parse_course(*text, path.string());
}

std::string print_course(const Course& course) {
    Json document = Json::object();
    document["tactcourse"] = kCourseFormat;
    document["name"] = course.name;
    if (!course.about.empty()) document["about"] = course.about;
    document["lessons"] = course.lessons;
    if (!course.unknown_json.empty()) restore_unknown(document, kept_json(course.unknown_json));
    return text_of_json(document, 2) + "\n";
}

Expected<ClassProgress> parse_progress(std::string_view text,
                                       const std::string& name_for_messages) {
    return with_enough_memory(name_for_messages, [&]() -> Expected<ClassProgress> {
        const auto document = parse_json(text, name_for_messages);
        if (!document) return document.error();
        JsonReading reading{name_for_messages, {}, UnknownKeys::passed_over};
        ClassProgress progress;
        JsonObject object = object_at(reading, *document, "");
        need_format(object, "students_format", 1);
        for (const Json* value : array_field(object, "students", 0, kMostStudents)) {
            JsonObject student = object_at(reading, *value, "/students");
            StudentProgress& own = progress[name_field(student, "name", "")];
            for (const Json* one : array_field(student, "lessons", 0, kMostLessons)) {
                JsonObject lesson = object_at(reading, *one, "/students/lessons");
                const std::string key = text_field(lesson, "lesson", "");
                own[key] = progress_of(lesson);
            }
        }
        if (!reading.fault.empty()) return Error{reading.fault};
        return progress;
    });
}

std::string print_progress(const ClassProgress& progress) {
    Json students = Json::array();
    for (const auto& [name, lessons] : progress) {
        Json own = Json::array();
        for (const auto& [key, lesson] : lessons) {
            Json one = json_of(lesson);
            one["lesson"] = key;
            own.push_back(std::move(one));
        }
        Json student = Json::object();
        student["name"] = name;
        student["lessons"] = std::move(own);
        students.push_back(std::move(student));
    }
    Json document = Json::object();
    document["students_format"] = 1;
    document["students"] = std::move(students);
    return text_of_json(document, 1) + "\n";
}

std::string answers_csv(const ClassProgress& progress) {
    constexpr std::size_t kToTheMinute = 16;  // letters of "2026-11-21T18:40"
    std::string csv = "student,lesson,step,question,answer,right,when\n";
    for (const auto& [student, lessons] : progress) {
        for (const auto& [key, lesson] : lessons) {
            for (const auto& [step, answer] : lesson.answers) {
                csv += csv_field(student) + "," + csv_field(lesson_name(key)) + "," +
                       std::to_string(step + 1) + "," + csv_field(answer.question) + "," +
                       csv_field(answer.answer) + "," + (answer.right ? "1" : "0") + "," +
                       csv_field(answer.at.substr(0, kToTheMinute)) + "\n";
            }
        }
    }
    return csv;
}

}  // namespace tact
