// The tour and lessons, in the program's real frames.
#include "app/lesson/lesson.h"

#include <doctest/doctest.h>

#include "app/document/editing.h"
#include "app/window/app.h"
#include "app/window/window.h"
#include "model/io/lesson/lesson_file.h"
#include "tests/support/lesson_class.h"
#include "tests/support/temporary_folder.h"

namespace lesson_test {

using namespace tact;

namespace {

bool meet(const Place& a, const Place& b) {
    return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

}  // namespace

TEST_CASE("tour: it goes from start to end, and leaves the document and the view as they were") {
    Class program;
    program.app.timeline.range = {0.0, 0.05};
    program.app.physiology.view.open = Stage::envelope;
    program.frame();
    const auto document = program.app.work.document.set;
    program.click("start tour");
    CHECK(program.app.work.document.set.vibrations[0].name == "plain 100 Hz");
    program.wait_for_numbers();  // which would move the buttons when they arrive
    const std::size_t steps = program.lesson().lesson->steps.size();
    for (std::size_t step = 0; step + 1 < steps; ++step) {
        REQUIRE(program.lesson().step == step);
        if (hides_answer(program.lesson())) program.click("tour:next");
        program.click("tour:next");
    }
    program.click("tour:finish");
    CHECK_FALSE(program.shows("tour"));
    CHECK(program.app.physiology.view.open == Stage::envelope);
    CHECK(program.app.timeline.range == TimeRange{0.0, 0.05});
    CHECK(program.app.work.document.set == document);
    CHECK(program.app.work.document.history.undo_label() == nullptr);
    CHECK(program.lesson().left_at.empty());
}

TEST_CASE("tour: left half way, it is taken up there") {
    Class program;
    program.click("start tour");
    program.wait_for_numbers();
    for (int k = 0; k < 2; ++k) program.click("tour:next");
    program.press_key(key::kEscape);
    CHECK_FALSE(program.shows("tour"));
    program.wait_for_stages();  // as above: arrivals move the buttons
    program.click("start tour");
    CHECK(program.lesson().step == 2U);
    CHECK(program.app.physiology.view.open == Stage::spectrum);
}

TEST_CASE("tour: it begins with a plain tone") {
    const auto tour = bundled_lesson(kTourLesson);
    const auto place = place_named(tour->set, tour->steps[0].pattern);
    REQUIRE(place);
    const Pattern& first = std::get<Pattern>(tour->set.vibrations[*place].source);
    CHECK(first.carriers.size() == 1);
    CHECK(first.carriers[0].frequency_hz == 100.0);
    CHECK(first.modulation.frequency_hz == 0.0);
}

TEST_CASE("lesson: unsaved changes and undo steps of the document outlive it") {
    Class program;
    program.click("start tour");
    program.press_key(key::kEscape);
    remove_selected(program.app.ui, program.app.work);
    program.settle();
    const auto changed = program.app.work.document.set;
    REQUIRE(program.app.work.document.history.undo_label() != nullptr);
    const std::string label = *program.app.work.document.history.undo_label();
    program.begin(kBundledLessons[0].path);
    CHECK(program.app.work.document.history.undo_label() == nullptr);
    leave_lesson(lesson_context(program.app), program.lesson());
    program.settle();
    CHECK(program.app.work.document.set == changed);
    REQUIRE(program.app.work.document.history.undo_label() != nullptr);
    CHECK(*program.app.work.document.history.undo_label() == label);
    CHECK(program.app.work.unsaved);
}

TEST_CASE("lesson: another document opened meanwhile ends it and stays") {
    Class program;
    program.begin(kBundledLessons[1].path);
    open_example(program.app.ui, program.app.work);
    program.settle();
    CHECK_FALSE(program.shows("tour"));
    CHECK_FALSE(program.lesson().aside);
    CHECK(program.app.work.document.set.name == "PM 2023, twelve patterns");
}

TEST_CASE("presenting: a clicker's keys lead through the lesson, and Esc puts the view back") {
    Class program;
    const float scale = program.app.ui.text_scale;
    program.click("start tour");
    program.press_key(key::kF1 + 4);
    REQUIRE(is_presenting(program.lesson()));
    CHECK(program.app.ui.text_scale == kPresentScale);
    CHECK_FALSE(program.shows("menu:File"));
    CHECK_FALSE(program.shows("pane:Patterns"));
    CHECK(program.shows("pane:Physiology"));
    CHECK(program.lesson().step == 0U);
    for (const int code : {key::kPageDown, key::kRight}) program.press_key(code);
    CHECK(program.lesson().step == 2U);
    program.press_key(key::kSpace, false, false, U' ');  // reveals the answer of step 3 ...
    CHECK(program.lesson().step == 2U);
    program.press_key(key::kEnter);  // ... and goes to the next step
    CHECK(program.lesson().step == 3U);
    for (const int code : {key::kPageUp, key::kLeft, key::kUp}) program.press_key(code);
    CHECK(program.lesson().step == 0U);
    program.press('b');
    CHECK(program.lesson().blank);
    program.press_key(key::kPageDown);  // wakes the screen, and stays at the step
    CHECK_FALSE(program.lesson().blank);
    CHECK(program.lesson().step == 0U);
    program.press_key(key::kEscape);
    CHECK_FALSE(program.lesson().step);
    CHECK(program.app.ui.text_scale == scale);
    CHECK(program.app.work.document.set == short_patterns(3));
}

TEST_CASE("presenting: in the window, Page Up and Page Down alone are the lesson's") {
    Class program;
    program.click("start tour");
    program.press_key(key::kPageDown);
    CHECK(program.lesson().step == 1U);
    program.press_key(key::kRight);
    CHECK(program.lesson().step == 1U);
    program.press_key(key::kPageUp);
    CHECK(program.lesson().step == 0U);
}

TEST_CASE("lesson: the card stands beside what it points at, whatever the size and the edge" *
          doctest::test_suite("long")) {
    struct Screen {
        ImVec2 size;
        float scale;
    };
    std::vector<const char*> paths{kTourLesson};
    for (const BundledLesson& lesson : kBundledLessons) paths.push_back(lesson.path);
    for (const char* path : paths) {
        Class program;
        program.begin(path);
        toggle_presenting(lesson_context(program.app), program.lesson());
        for (const Screen& screen :
             {Screen{{1920.0F, 1080.0F}, 1.5F}, {{1920.0F, 1080.0F}, 2.0F}}) {
            program.resize(screen.size, screen.scale);
            for (const DockSide side : {DockSide::right, DockSide::bottom}) {
                program.lesson().dock = side;
                for (std::size_t k = 0; k < program.lesson().lesson->steps.size(); ++k) {
                    go_to_step(lesson_context(program.app), program.lesson(), k);
                    const LessonStep& step = program.lesson().lesson->steps[k];
                    if (step.view == "map") continue;  // its map may be on its way
                    program.wait_for_stages();
                    CAPTURE(step.title);
                    const Place card = program.at("tour");
                    CHECK(card.max.x <= screen.size.x);
                    CHECK(card.max.y <= screen.size.y);
                    CHECK_FALSE(meet(card, program.at("pane:Physiology")));
                    if (step.point_at.empty()) continue;
                    CHECK_FALSE(meet(card, program.at(step.point_at)));
                }
            }
        }
    }
}

TEST_CASE("lesson: at a side the card is no wider than its lines are read with ease") {
    Class program;
    program.begin(kTourLesson);
    program.lesson().card_share = 0.5F;
    program.resize({2560.0F, 1440.0F}, 1.0F);
    const Place card = program.at("tour");
    const float sixty =
        ImGui::GetFont()
            ->CalcTextSizeA(ImGui::GetFontSize(), 1e9F, 0.0F, std::string(60, 'n').c_str())
            .x;
    CHECK(card.max.x - card.min.x < sixty + 3.0F * program.app.ui.theme.padding_px);
    CHECK(card.max.x - card.min.x > 0.6F * sixty);
}

// Only a language whose letters are missing gets the warning.
TEST_CASE("lesson: letters of languages that are not shown are not asked for") {
    Class program;
    program.begin(kTourLesson);
    REQUIRE(program.lesson().lesson->languages.back() == "ko");
    const std::string drawn = drawn_text(program.lesson());
    CHECK(drawn.find("Pacinian") != std::string::npos);
    CHECK(drawn.find("\uc2b5\ub2c8\ub2e4") == std::string::npos);
    CHECK(program.lesson().lacking.empty());
    choose_language(program.app.ui, program.lesson(), "ko");
    program.settle();
    CHECK(drawn_text(program.lesson()).find("\uc2b5\ub2c8\ub2e4") != std::string::npos);
}

TEST_CASE("lesson: along the foot the card is as high as its words, and no higher") {
    Class program;
    program.begin(kTourLesson);
    program.resize({1600.0F, 1000.0F}, 1.0F);
    program.wait_for_numbers();
    program.lesson().dock = DockSide::bottom;
    program.settle();
    const Place card = program.at("tour");
    const float below = card.max.y - program.at("lesson:source").max.y;
    CHECK(below >= 0.5F * program.app.ui.theme.padding_px);
    CHECK(below <= 2.0F * program.app.ui.theme.padding_px);
    CHECK(card.min.y >= program.at("pane:Physiology").max.y);
}

TEST_CASE("presenting: all is as large on any screen, for those at the back of the room") {
    CHECK(presented_growth({1280.0F, 720.0F}) == 1.0F);
    CHECK(presented_growth({1600.0F, 1000.0F}) == 1.25F);
    CHECK(presented_growth({2560.0F, 1440.0F}) == 2.0F);
    CHECK(presented_growth({3840.0F, 2160.0F}) == 3.0F);
    CHECK(presented_growth({7680.0F, 4320.0F}) == 4.0F);
    Class program;
    program.click("start tour");
    program.press_key(key::kF1 + 4);
    program.app.ui.fonts_outdated = false;
    ImGui::GetIO().DisplaySize = {2560.0F, 1440.0F};
    program.frame();
    CHECK(program.app.ui.fonts_outdated);  // the window loads them again
}

TEST_CASE("lesson: the way on is in sight in a small window, at whatever edge the card stands") {
    Class program;
    program.begin(kTourLesson);
    program.resize({1280.0F, 720.0F}, 1.0F);
    for (const DockSide side : {DockSide::right, DockSide::bottom, DockSide::left, DockSide::top}) {
        program.lesson().dock = side;
        program.settle();
        const Place card = program.at("tour");
        for (const char* name : {"tour:back", "tour:next", "tour:leave", "lesson:move"}) {
            CAPTURE(name);
            CHECK(program.at(name).max.y <= card.max.y);
            CHECK(program.at(name).max.x <= card.max.x);
        }
        CHECK_FALSE(meet(program.at("tour:leave"), program.at("lesson:move")));
    }
}

TEST_CASE("lesson: number keys count hands until the answer is seen, and the score counts it") {
    Class program;
    program.begin(kBundledLessons[0].path);
    program.wait_for_numbers();
    program.go_to_question();
    const std::size_t at = *program.lesson().step;
    const std::size_t right = answers_of(program.lesson())->questions[at].right.at(0);
    const auto digit = static_cast<char32_t>(U'1' + right);
    program.press(digit);
    program.press(digit);
    CHECK(program.lesson().tallies[at].votes[right] == 2);
    CHECK_FALSE(program.shows("lesson:answer"));
    program.press_key(key::kPageDown);
    CHECK(program.lesson().step == at);
    CHECK(program.at("lesson:answer").value.find("1 of 1") != std::string::npos);
    CHECK(program.at("option:" + std::to_string(right + 1)).value == "2 right");
    program.press(digit);
    CHECK(program.lesson().tallies[at].votes[right] == 2);
    program.press_key(key::kPageDown);
    CHECK(program.lesson().step == at + 1);
}

TEST_CASE("lesson: one is made of what is on screen, saved, and opened again") {
    const TemporaryFolder folder;
    const auto file = folder.path / "mine.tactlesson.json";
    Class program;
    program.app.physiology.view.open = Stage::brain;
    new_lesson(lesson_context(program.app), program.lesson());
    program.settle();
    program.app.work.selection.current = 2;
    program.app.physiology.view.open = Stage::spikes;
    program.app.timeline.range = {0.01, 0.05};
    program.settle();
    program.click("lesson edit:add");
    const auto steps = program.lesson().lesson->steps;
    REQUIRE(steps.size() == 2);
    CHECK(steps[0].view == "brain");
    CHECK(steps[0].pattern == "p1");
    CHECK(steps[1].view == "spikes");
    CHECK(steps[1].pattern == "p3");
    CHECK(steps[1].from_s == 0.01);
    program.click("lesson edit:up");
    CHECK(program.lesson().lesson->steps[0].view == "spikes");
    CHECK(program.lesson().step == 0U);
    save_lesson(program.app.ui, program.app.work, program.lesson(), file);
    CHECK_FALSE(program.app.ui.status.is_error);
    const auto again = read_lesson_file(file);
    REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
    CHECK(again->steps == program.lesson().lesson->steps);
    CHECK(again->set == program.app.work.document.set);
    leave_lesson(lesson_context(program.app), program.lesson());
    open_lesson(lesson_context(program.app), program.lesson(), file);
    program.settle();
    CHECK(program.at("tour").value == "1 of 2");
}

TEST_CASE("lesson: the student sheet has every step, every question, the answers and the sources" *
          doctest::test_suite("long")) {
    const TemporaryFolder folder;
    const auto file = folder.path / "sheet.html";
    Class program;
    program.begin(kBundledLessons[1].path);
    program.wait_for_numbers();
    program.lesson().sheet_to = file;
    for (int k = 0; k < 40 && is_exporting(program.app); ++k) continue_exports(program.app);
    const std::string page = bytes_of(file);
    const Lesson& lesson = *program.lesson().lesson;
    for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
        CHECK(page.find(std::to_string(k + 1) + ". " + lesson.steps[k].title) != std::string::npos);
    }
    CHECK(page.find("<svg") != std::string::npos);
    CHECK(page.find("Answers") != std::string::npos);
    CHECK(page.find("Saal") != std::string::npos);
    CHECK(page.find("{") < page.find("</style>"));
    CHECK(page.find("\u2026") == std::string::npos);
}

TEST_CASE("lesson: notes stand in a second window where there is a second screen, or by N") {
    Class program;
    CHECK_FALSE(wants_notes_window(program.lesson(), true));
    program.click("start tour");
    program.press_key(key::kF1 + 4);
    program.wait_for_numbers();
    CHECK(wants_notes_window(program.lesson(), true));
    CHECK_FALSE(wants_notes_window(program.lesson(), false));
    program.press('n');
    CHECK(wants_notes_window(program.lesson(), false));
    program.lesson().shows_notes = true;  // the window is open
    program.press('n');
    CHECK_FALSE(wants_notes_window(program.lesson(), true));
    // Only the speaker sees the answer, and the minutes count from the beginning.
    program.go_to_question();
    const double begun_s = program.lesson().presenting_since_s;
    const auto notes = speaker_notes(program.lesson(), begun_s + 185.0);
    REQUIRE(notes);
    CHECK(notes->minutes == 3);
    CHECK(notes_wake_s(program.lesson(), begun_s + 185.0) == doctest::Approx(55.0).epsilon(0.001));
    CHECK_FALSE(notes->answer.empty());
    CHECK_FALSE(program.shows("lesson:answer"));
    const SideContent window = notes_window(*notes, true);
    const Image picture = window.draw(900, 540, 1.0F);
    CHECK(picture.width == 900);
    const Image other =
        notes_window(*speaker_notes(program.lesson(), begun_s), true).draw(900, 540, 1.0F);
    CHECK(picture != other);  // the minutes
}

TEST_CASE("lesson: what is told to who speaks has the note and what comes next") {
    Class program;
    program.click("start tour");
    program.press_key(key::kF1 + 4);
    program.wait_for_numbers();
    const std::string line = speaker_line(program.lesson());
    CHECK(line.find("1/") == 0);
    CHECK(line.find(program.lesson().lesson->steps[0].note) != std::string::npos);
    CHECK(line.find("next: " + program.lesson().lesson->steps[1].title) != std::string::npos);
    program.press_key(key::kEscape);
    CHECK(speaker_line(program.lesson()).empty());
}

}  // namespace lesson_test
