#include "app/course/course.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <string>

#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// "finished, 2 of 3 right", "at step 3 of 5", "not begun".
std::string where_it_stands(const CourseState& state, const CourseLesson& lesson) {
    if (!lesson.lesson) return "cannot be read";
    const LessonProgress* progress = progress_of(state, lesson);
    if (progress == nullptr) return state.student.empty() ? "" : "not begun";
    const CourseScore score = score_of(*progress);
    std::string text = progress->reached >= progress->steps
                           ? "finished"
                           : "at step " + std::to_string(progress->reached) + " of " +
                                 std::to_string(progress->steps);
    if (score.asked > 0) {
        text +=
            ", " + std::to_string(score.right) + " of " + std::to_string(score.asked) + " right";
    }
    return text;
}

std::string length_of(const CourseLesson& lesson) {
    if (!lesson.lesson) return {};
    std::size_t questions = 0;
    for (const LessonStep& step : lesson.lesson->steps) questions += step.question ? 1 : 0;
    return counted(lesson.lesson->steps.size(), "step", "steps") + ", " +
           counted(questions, "question", "questions");
}

void draw_student(Ui& ui, CourseState& state) {
    draw_label(ui, "Student");
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::InputTextWithHint("##student", "no name: nothing is kept", &state.student);
    note_item(ui.rects, "course:student", state.student);
}

std::optional<std::size_t> draw_lessons(Ui& ui, const CourseState& state) {
    std::optional<std::size_t> begun;
    constexpr ImGuiTableFlags kFlags =
        ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_NoSavedSettings;
    if (!ImGui::BeginTable("lessons", 3, kFlags)) return begun;
    ImGui::TableSetupColumn("lesson", ImGuiTableColumnFlags_WidthStretch, 5.0F);
    ImGui::TableSetupColumn("length", ImGuiTableColumnFlags_WidthStretch, 3.0F);
    ImGui::TableSetupColumn("stands", ImGuiTableColumnFlags_WidthStretch, 3.0F);
    for (std::size_t k = 0; k < state.lessons.size(); ++k) {
        const CourseLesson& lesson = state.lessons[k];
        ImGui::TableNextColumn();
        const std::string name = std::to_string(k + 1) + "  " +
                                 (lesson.lesson ? lesson.lesson->name : state.course->lessons[k]);
        const std::string id = "course:lesson:" + std::to_string(k + 1);
        const std::string stands = where_it_stands(state, lesson);
        if (!lesson.lesson) {
            dim_text(ui, {.id = id, .text = name, .tip = lesson.fault, .value = stands});
        } else if (name_link(ui, {.id = id, .label = name, .value = stands})) {
            begun = k;
        }
        ImGui::TableNextColumn();
        dim_text(ui, length_of(lesson));
        ImGui::TableNextColumn();
        dim_text(ui, stands);
    }
    ImGui::EndTable();
    return begun;
}

void ask_for_answers_file(Ui& ui, const CourseState& state) {
    ask_for_file(
        ui,
        {.use = ChooserUse::save,
         .title = "Answers of the class",
         .extensions = {".csv"},
         .take = [&](const std::filesystem::path& file) { export_answers(ui, state, file); }},
        {}, state.course->name + " answers.csv");
}

const char* action_with(const CourseState& state, std::size_t next) {
    const bool has_begun = progress_of(state, state.lessons[next]) != nullptr;
    return has_begun ? "Continue with lesson " : "Begin with lesson ";
}

}  // namespace

std::optional<std::size_t> draw_course_dialog(Ui& ui, CourseState& state) {
    if (ui.dialog != kCourseDialog || !state.course) return std::nullopt;
    if (!begin_dialog(ui, state.course->name.c_str(), 720.0F)) return std::nullopt;
    if (!state.course->about.empty()) {
        ImGui::PushTextWrapPos(0.0F);
        dim_text(ui, state.course->about);
        ImGui::PopTextWrapPos();
        ImGui::Spacing();
    }
    draw_student(ui, state);
    ImGui::Spacing();
    std::optional<std::size_t> begun = draw_lessons(ui, state);
    if (!state.progress.empty()) {
        ImGui::Spacing();
        if (link(ui, {.id = "course:answers", .label = "Answers of all students as CSV..."})) {
            give_way(ui);
            ask_for_answers_file(ui, state);
            return std::nullopt;
        }
    }
    const auto next = next_lesson(state);
    const std::string action =
        next ? action_with(state, *next) + std::to_string(*next + 1) : std::string("Finished");
    if (begun) {
        give_way(ui);
        return begun;
    }
    if (draw_ends(ui, action.c_str(), next.has_value())) return next;
    return std::nullopt;
}

}  // namespace tact
