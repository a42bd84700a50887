// The view of studies and a participant's pages, in the program's real frames.
#include <filesystem>
#include <fstream>

#include "app/document/editing.h"
#include "app/study/parts.h"
#include "app/study/study.h"
#include "devices/device/memory_device.h"
#include "tests/support/patience.h"
#include "tests/support/program.h"
#include "tests/support/quick_study.h"
#include "tests/support/temporary_folder.h"

namespace study_window_test {

using namespace tact;

namespace {

PatternSet study_set() {
    PatternSet set = quick_study();
    set.study.repetitions = 1;
    set.study.attention.failures_allowed = 1;
    return set;
}

struct StudyProgram : StudyWindow {
    TemporaryFolder folder;

    explicit StudyProgram(const PatternSet& set = study_set()) : StudyWindow(set) {
        set_study_folder(app.work, app.studying, folder.path / "people");
        app.studying.device = std::make_shared<MemoryDevice>(true);  // else it is a rehearsal
    }
    ~StudyProgram() { stop_study(app.studying); }

    // The device ends what it plays half-way, which is after the patterns of these sets.
    void wait(double seconds) {
        for (double t = 0.0; t < 0.5 * seconds; t += window.frame_s) frame();
        if (auto* device = dynamic_cast<MemoryDevice*>(app.studying.device.get())) device->end();
        for (double t = 0.0; t < 0.5 * seconds; t += window.frame_s) frame();
    }
    std::string page() const { return at("study page").value; }
    void key(int code) { press_key(code); }

    // From the view to the first trial, by keyboard.
    void begin() {
        click("button:run participant");
        key(key::kEnter);
        key(key::kEnter);
        REQUIRE(page() == "instructions 0");
        key(key::kEnter);
        for (std::size_t k = 0; k < 4; ++k) {
            key(key::kRight);
            key(key::kSpace);
            wait(0.3);
        }
        key(key::kEnter);
        REQUIRE(page() == "trial 0");
    }
    void answer(double similarity) {
        press('a');
        wait(0.3);
        press('b');
        wait(0.3);
        key(key::kHome);
        for (double at = 0.0; at < similarity; at += 1.0) key(key::kRight);
        key(key::kEnter);
    }
};

}  // namespace

TEST_CASE("study window: a whole study by keyboard becomes the ratings of the set") {
    StudyProgram program;
    program.press('4', true);
    CHECK(program.shows("pane:Study"));
    CHECK(program.at("study:prediction").value.starts_with("7 trials"));
    program.begin();
    for (int k = 0; k < 7; ++k) {
        CHECK(program.page() == "trial " + std::to_string(k));
        program.answer(k);
    }
    CHECK(program.page() == "finished 7");
    program.key(key::kEscape);  // nothing is left to pause
    CHECK(program.page() == "finished 7");
    program.key(key::kEnter);
    program.wait_for("participant:P1");
    CHECK(program.at("participant:P1").value == "7 of 7, counts");
    CHECK(program.shows("study matrix"));
    program.click("button:use as ratings");
    CHECK(program.app.work.document.set.ratings.size() == 1);
    CHECK(program.app.work.document.set.ratings[0].name == "P1");
    CHECK_FALSE(program.app.studying.is_open);
    program.press('z', true);
    CHECK(program.app.work.document.set.ratings.empty());
}

TEST_CASE("study window: nothing is rated until the slider is put somewhere, by keys as by mouse") {
    StudyProgram program;
    program.press('4', true);
    program.begin();
    program.press('a');
    program.wait(0.3);
    program.press('b');
    program.wait(0.3);
    REQUIRE(program.at("study:slider").value == "open");
    // Wherever the arrows began would be an anchor.
    program.key(key::kRight);
    program.key(key::kLeft);
    CHECK(program.at("study:slider").value == "open");
    program.key(key::kEnter);
    CHECK(program.page() == "trial 0");
    program.press('7');
    CHECK(program.at("study:slider").value == "70");
    program.key(key::kLeft);
    CHECK(program.at("study:slider").value == "69");
    program.key(key::kEnd);
    CHECK(program.at("study:slider").value == "100");
    program.key(key::kEnter);
    CHECK(program.page() == "trial 1");
    CHECK(program.at("study:slider").value == "closed");
}

TEST_CASE("study window: a participant's page grows with the window, and the panes do not") {
    StudyProgram program;
    const auto enlarge = [&](ImVec2 window_px) {
        program.resize(window_px, 1.0F);
        program.resize(window_px, 1.0F);  // the fonts that the first frames asked for
        return program.app.ui.theme.scale;
    };
    CHECK(enlarge({2560.0F, 1440.0F}) == 1.0F);
    program.press('4', true);
    program.click("button:run participant");
    CHECK(enlarge({800.0F, 500.0F}) == 1.0F);
    const float small = enlarge({1280.0F, 720.0F});
    const float large = enlarge({2560.0F, 1440.0F});
    CHECK(small > 1.0F);
    CHECK(large > 2.0F * small);
    // In the middle of the window.
    const Place code = program.at("study field:code");
    CHECK(code.min.y > 0.25F * 1440.0F);
    CHECK(code.max.y < 0.6F * 1440.0F);
    program.key(key::kEscape);
    const Place stay = program.at("button:stay");
    CHECK(stay.max.y - stay.min.y > 0.06F * 1440.0F);
    program.press('q');
    CHECK(enlarge({2560.0F, 1440.0F}) == 1.0F);
}

TEST_CASE("study window: the design says how many blind answers pass its identical pairs") {
    StudyProgram program;
    program.app.work.document.edit().study.attention = {};
    program.press('4', true);
    program.settle();
    CHECK(program.at("study:chance").value.starts_with("20 % of those who answer blindly"));
    program.app.work.document.edit().study.attention_pairs = 3;
    program.settle();
    CHECK(program.at("study:chance").value ==
          "0.78 % of those who answer blindly would pass the identical pairs.");
}

TEST_CASE("study window: every answer is in the file before the next trial is on the screen") {
    StudyProgram program;
    program.press('4', true);
    program.begin();
    const auto file = program.folder.path / "people" / "P1.jsonl";
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(read_study_file(file)->answers.size() == k);
        program.answer(5);
        CHECK(program.page() == "trial " + std::to_string(k + 1));
    }
    CHECK(read_study_file(file)->answers.size() == 3);
    CHECK(read_study_file(file)->header.consented);
    // Esc, leave: it continues later.
    program.key(key::kEscape);
    CHECK(program.page() == "asking 3");
    program.press('q');
    program.wait_for("link:go on P1");
    CHECK(program.at("participant:P1").value == "3 of 7, unfinished, 3 of 7 trials");
    program.click("link:go on P1");
    program.key(key::kEnter);
    CHECK(program.page() == "trial 3");
}

TEST_CASE("study window: buttons and slider by mouse, only when it is their turn") {
    StudyProgram program;
    program.press('4', true);
    program.begin();
    const auto& run = *program.app.studying.run;
    program.click("study:slider");
    CHECK_FALSE(run.similarity);
    program.click("study:A");
    program.click("study:B");  // A still plays
    program.wait(0.3);
    CHECK(run.given.plays_left == 1);
    CHECK(run.given.plays_right == 0);
    program.click("study:B");
    program.wait(0.3);
    program.click("study:slider");
    CHECK(run.similarity == 50.0);
    program.click("study:go on");
    CHECK(program.page() == "trial 1");
}

TEST_CASE("study window: the design is part of the document, a change one undo step") {
    StudyProgram program;
    program.press('4', true);
    const ImVec2 at = program.at("slider:study_repetitions").middle();
    program.drag(at, at + ImVec2{60.0F, 0.0F}, 6);
    CHECK(program.app.work.document.set.study.repetitions > 1);
    program.press('z', true);
    CHECK(program.app.work.document.set == study_set());
    program.click("study:patterns");
    program.click("study pattern:p2");
    CHECK(program.app.work.document.set.study.patterns ==
          std::vector<std::string>{"p1", "p3", "p4"});
    program.click("study pattern:p2");
    CHECK(program.app.work.document.set.study.patterns.empty());
    program.press('1', true);
    CHECK(program.shows("pane:Patterns"));
}

TEST_CASE("study window: a code that is taken is told beside its field, before anything begins") {
    StudyProgram program;
    program.press('4', true);
    std::filesystem::create_directories(program.folder.path / "people");
    std::ofstream(program.folder.path / "people" / study_file_name("Zo,b")) << "x";
    program.click("button:run participant");
    CHECK_FALSE(program.shows("study field:code fault"));
    program.type("Zo;b");  // another code with the same file
    program.app.studying.agrees = true;
    program.settle();
    CHECK(program.at("study field:code fault").value == "This code is taken: choose another.");
    program.key(key::kEnter);
    CHECK(program.page() == "consent 0");
    CHECK(program.app.studying.run->trouble.empty());
}

TEST_CASE("study window: what is typed on the first page is the code, without a click or Tab") {
    StudyProgram program;
    program.press('4', true);
    program.click("button:run participant");
    program.type("Zoe 7");
    CHECK(program.at("study field:code").value == "Zoe 7");
    program.key(key::kEnter);
    program.key(key::kEnter);
    CHECK(program.page() == "instructions 0");
    CHECK(program.app.studying.run->record.header.participant.code == "Zoe 7");
}

TEST_CASE("study window: sorting by keyboard and by mouse") {
    PatternSet set = study_set();
    set.study.groups = {2};
    StudyProgram program(set);
    program.press('4', true);
    program.click("study kind:Sort into groups");
    program.click("button:run participant");
    program.key(key::kEnter);
    program.key(key::kEnter);
    program.key(key::kEnter);
    REQUIRE(program.page() == "sorting 0");
    program.drag(program.at("study:token 1").middle(), program.at("study:group 2").middle(), 4);
    CHECK(program.at("study:token 1").value == "2");
    for (int k = 0; k < 3; ++k) {
        program.key(key::kRight);
        program.press(k == 0 ? U'2' : U'1');
    }
    CHECK(unsorted_count(*program.app.studying.run) == 0);
    program.key(key::kEnter);
    CHECK(program.page() == "sorting 0");  // nothing was felt
    for (std::size_t k = 0; k < study_set().vibrations.size(); ++k) {
        program.key(key::kRight);
        program.key(key::kSpace);
        program.wait(0.3);
    }
    program.key(key::kEnter);
    CHECK(program.page() == "finished 1");
    program.key(key::kEnter);
    program.wait_for("participant:P1");
    CHECK(program.at("participant:P1").value == "1 of 1, counts");
}

TEST_CASE("study window: everything keeps within its pane, in small windows with large text") {
    StudyProgram program;
    program.press('4', true);
    const auto check_inside = [&](const char* pane, std::initializer_list<const char*> things) {
        const Place& around = program.at(pane);
        for (const char* thing : things) {
            CAPTURE(thing);
            CHECK(program.at(thing).min.x >= around.min.x);
            CHECK(program.at(thing).max.x <= around.max.x);
        }
    };
    for (const float scale : {0.75F, 1.0F, 2.0F}) {
        for (const ImVec2 size : {ImVec2{1600, 1000}, ImVec2{1000, 640}}) {
            CAPTURE(scale);
            CAPTURE(size.x);
            program.resize(size, scale);
            check_inside("pane:Study", {"entry:study_repetitions", "study:prediction",
                                        "study kind:Sort into groups", "study order:Adaptive"});
            check_inside("pane:Participants", {"button:run participant", "button:simulate",
                                               "link:study folder", "study:device"});
            program.click("button:run participant");
            CHECK(program.at("study field:hand").max.x <= size.x);
            // What does not fit scrolls.
            program.hover(size * 0.5F);
            push(program.window.input, {program.window.now_s, MouseWheel{0.0F, -30.0F}});
            program.settle();
            CHECK(program.at("study:go on").max.y <= size.y);
            program.key(key::kEscape);
            program.press('q');
        }
    }
}

TEST_CASE("study window: a trial fits into any window, at any size of text") {
    StudyProgram program;
    program.press('4', true);
    program.begin();
    for (const float scale : {0.75F, 1.0F, 2.0F}) {
        for (const ImVec2 size : {ImVec2{1600, 1000}, ImVec2{1000, 640}}) {
            CAPTURE(scale);
            CAPTURE(size.x);
            program.resize(size, scale);
            CHECK(program.at("study:A").max.x <= program.at("study:B").min.x);
            CHECK(program.at("study:A").max.y <= program.at("study:slider").min.y);
            CHECK(program.at("study:slider").max.y <= program.at("study:go on").min.y);
            CHECK(program.at("study:go on").max.y <= size.y);
        }
    }
}

TEST_CASE("study window: after its first participant a changed design is another study") {
    StudyProgram program;
    program.press('4', true);
    program.begin();
    program.answer(30);
    program.key(key::kEscape);
    program.press('q');
    program.wait_for("participant:P1");
    CHECK_FALSE(program.shows("study:another design"));
    program.app.work.document.edit().study.repetitions = 2;
    document_changed(program.app.work);
    commit_step(program.app.ui, program.app.work, "study: repetitions");
    program.wait_for("study:another design");
    CHECK(contains(program.at("study:another design").value, "repetitions 2, not 1"));
    CHECK(contains(program.at("button:run participant").value, "repetitions 2, not 1"));
    program.click("button:run participant");
    CHECK_FALSE(program.app.studying.run);
    // Back as it was, and forth again, into a folder of its own.
    program.click("link:design back");
    CHECK(program.app.work.document.set.study.repetitions == 1);
    CHECK_FALSE(program.shows("study:another design"));
    program.press('z', true);
    program.wait_for("study:another design");
    program.click("link:another study");
    program.wait_for("button:run participant");
    CHECK(program.at("link:study folder").value.ends_with("people 2"));
    program.click("button:run participant");
    REQUIRE(program.app.studying.run);
    program.key(key::kEscape);
    program.press('q');
    // The same design finds its folder again, and another one another.
    set_study_folder(program.app.work, program.app.studying, program.folder.path / "people");
    begin_another_study(program.app.ui, program.app.work, program.app.studying);
    CHECK(study_folder(program.app.work, program.app.studying).filename() == "people 2");
}

TEST_CASE("study window: nobody begins a changed study before the folder has been read") {
    StudyProgram program;
    StudyRecord record;
    record.header = study_header(program.app.work, program.app.play, program.app.studying, "P1");
    record.header.design.gap_s = 2.0;
    std::filesystem::create_directories(program.folder.path / "people");
    REQUIRE(write_study_file(program.folder.path / "people" / "P1.jsonl", record));
    begin_participant(program.app.ui, program.app.work, program.app.timeline, program.app.play,
                      program.app.studying);
    CHECK_FALSE(program.app.studying.run);
    CHECK(contains(program.app.ui.status.text, "gap 0.05 s, not 2 s"));
}

TEST_CASE("study window: a simulated participant says everywhere that it is none") {
    StudyProgram program;
    program.compute_map();
    program.press('4', true);
    program.click("button:simulate");
    program.wait_for("participant:synthetic P1");
    CHECK(program.at("participant:synthetic P1").value == "7 of 7, synthetic");
    CHECK(contains(program.at("study:agreement").value, "Synthetic: nobody was asked."));
    CHECK(read_study_folder(program.folder.path / "people")->front().header.synthetic);
}

}  // namespace study_window_test
