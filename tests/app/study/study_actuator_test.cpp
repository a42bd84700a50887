// What is done when a study's actuator goes, is another, or is too weak for what is asked of it.

#include "app/study/parts.h"

#include <cmath>

#include "app/study/study.h"
#include "devices/device/memory_device.h"
#include "devices/device/playback.h"
#include "tests/support/patience.h"
#include "tests/support/program.h"
#include "tests/support/quick_study.h"
#include "tests/support/temporary_folder.h"

namespace study_actuator_test {

using namespace tact;

namespace {

PatternSet four_patterns() {
    PatternSet set = quick_study();
    set.study.repetitions = 1;
    return set;
}

// A study felt by a device that plays until it is told that it has come to the end.
struct Felt : StudyWindow {
    TemporaryFolder folder;
    std::shared_ptr<MemoryDevice> device = std::make_shared<MemoryDevice>(true);

    explicit Felt(const PatternSet& set = four_patterns()) : StudyWindow(set) {
        set_study_folder(app.work, app.studying, folder.path / "people");
        app.studying.device = device;
        open_study(app.layout, app.studying);
        settle();
    }
    ~Felt() { stop_study(app.studying); }

    const StudyRun& run() const { return *app.studying.run; }
    std::string page() const { return at("study page").value; }
    StudyRecord record() const { return *read_study_file(folder.path / "people" / "P1.jsonl"); }
    void wait(double seconds) {
        for (double t = 0.0; t < seconds; t += window.frame_s) frame();
    }
    void come_to_the_end() {
        wait(0.2);
        device->end();
        wait(0.2);
    }
    void feel(char32_t button) {
        press(button);
        come_to_the_end();
    }
    void begin() {
        click("button:run participant");
        press_key(key::kEnter);
        press_key(key::kEnter);
        press_key(key::kEnter);
        for (std::size_t k = 0; k < 4; ++k) {
            press_key(key::kRight);
            press_key(key::kSpace);
            come_to_the_end();
        }
        press_key(key::kEnter);
        REQUIRE(page() == "trial 0");
    }
    void answer() {
        press_key(key::kHome);
        press_key(key::kEnter);
    }
    void leave() {
        press_key(key::kEscape);
        press('q');
        REQUIRE_FALSE(is_study_running(app.studying));
    }
};

}  // namespace

TEST_CASE("actuator: a pattern is felt when the device has come to its end, not when time is up") {
    Felt program;
    program.begin();
    program.press('a');
    program.wait(0.5);  // five times as long as the pattern
    CHECK(program.run().given.plays_left == 0);
    CHECK(program.at("study:B").value == "waiting 0");
    program.device->end();
    program.wait(0.2);
    CHECK(program.run().given.plays_left == 1);
    CHECK(program.at("study:B").value == "ready 0");
}

TEST_CASE("actuator: one that goes pauses the study, says so, and the play does not count") {
    Felt program;
    program.begin();
    program.press('a');
    program.device->pretend(0.0, 0.0, false, "the coil is gone");
    program.frame();
    program.settle();
    CHECK(program.page() == "asking 0");
    CHECK(contains(program.at("study:warning").value, "The actuator stopped"));
    CHECK(contains(program.at("study:warning").value, "the coil is gone"));
    CHECK_FALSE(program.device->playing());
    // It is not back: whoever continues may try, and is stopped again.
    program.press_key(key::kEnter);
    program.wait(0.2);
    CHECK(program.page() == "trial 0");
    program.press('a');
    CHECK(program.page() == "asking 0");
    CHECK(program.run().given.plays_left == 0);
    program.device->pretend(0.0, 0.0, false);
    program.press_key(key::kEnter);
    program.wait(0.2);
    CHECK_FALSE(program.shows("study:warning"));
    program.feel('b');
    CHECK_FALSE(may_rate(program.run(), program.app.ui.time_s));
    program.feel('a');
    program.answer();
    REQUIRE(program.page() == "trial 1");
    const PairAnswer answer = program.record().answers.at(0);
    CHECK(answer.plays_left == 1);
    CHECK(answer.left.broken == 2);
    CHECK(answer.right.broken == 0);
}

TEST_CASE("actuator: what the device breaks off early does not count, without a word from it") {
    Felt program;
    program.begin();
    program.press('b');
    program.device->end();  // after a few frames, of a tenth of a second
    program.app.studying.run->playing_until_s = program.app.ui.time_s + 1.0;
    program.wait(0.3);
    CHECK(program.page() == "trial 0");
    CHECK(program.run().given.plays_right == 0);
    CHECK(program.run().given.right.broken == 1);
    program.feel('b');
    CHECK(program.run().given.plays_right == 1);
}

TEST_CASE("actuator: gaps and what was turned down are in the answer, of the side they were on") {
    Felt program;
    program.begin();
    program.press('a');
    program.device->drop_out();
    program.device->drop_out();
    program.come_to_the_end();
    CHECK(program.run().given.plays_left == 0);  // not whole
    program.feel('a');
    program.press('b');
    program.device->pretend(0.0, 0.0, true);
    program.come_to_the_end();
    program.device->pretend(0.0, 0.0, false);
    program.answer();
    const PairAnswer answer = program.record().answers.at(0);
    CHECK(answer.left.dropouts == 2);
    CHECK(answer.left.turned_down_db == 0.0);
    CHECK(answer.right.dropouts == 0);
    CHECK(answer.right.turned_down_db > 0.0);
}

TEST_CASE("actuator: where one pattern is too strong, all are turned down alike, and it is noted") {
    PatternSet set = four_patterns();
    std::get<Pattern>(set.vibrations[0].source).amplitude_g = 4.0;
    std::get<Pattern>(set.vibrations[1].source).amplitude_g = 0.5;
    Felt program(set);
    App& app = program.app;
    const std::vector<std::string> names = names_of(app.work.document.set);
    app.play.level = 0.1;
    const StudyActuator weak = study_actuator(app.play, app.studying, app.work.document.set, names);
    CHECK(weak.turned_down_db == 0.0);
    app.play.level = 1.0;
    const StudyActuator strong =
        study_actuator(app.play, app.studying, app.work.document.set, names);
    CHECK(std::ranges::max(strong.peaks) <= kCeiling);
    CHECK(std::ranges::max(strong.peaks) > 0.98 * kCeiling);
    const double factor = std::pow(10.0, -strong.turned_down_db / 20.0);
    for (std::size_t k = 0; k < names.size(); ++k) {
        for (std::size_t n = 0; n < weak.drives[k].samples.size(); n += 7) {
            CHECK(strong.drives[k].samples[n] ==
                  doctest::Approx(factor * weak.drives[k].samples[n]).epsilon(1e-9));
        }
    }
    program.click("button:run participant");
    CHECK(contains(program.at("study:warning").value, "All patterns are turned down by"));
    program.press_key(key::kEnter);
    program.press_key(key::kEnter);
    CHECK(contains(program.record().header.device.calibration, "all patterns turned down by"));
}

TEST_CASE("actuator: the buffer of the output is kept with the study, a new one from then on") {
    Felt program;
    program.app.play.whole_buffer_s = 0.25;
    program.begin();
    CHECK(program.record().header.device.buffer_ms == 250.0);
    program.feel('a');
    program.feel('b');
    program.answer();
    program.leave();
    program.wait_for("link:go on P1");
    program.app.play.whole_buffer_s = 0.5;
    program.click("link:go on P1");
    const StudyRecord record = program.record();
    REQUIRE(record.devices.size() == 1);
    CHECK(record.devices[0].before == 1);
    CHECK(record.devices[0].device.buffer_ms == 500.0);
}

TEST_CASE("actuator: going on with another device asks, and the file says what it is now") {
    Felt program;
    program.begin();
    program.feel('a');
    program.feel('b');
    program.answer();
    program.leave();
    program.wait_for("link:go on P1");
    // As it was: no question.
    program.click("link:go on P1");
    CHECK(is_study_running(program.app.studying));
    program.leave();
    CHECK(program.record().devices.empty());
    program.app.studying.device = std::make_shared<MemoryDevice>(false);
    program.wait_for("link:go on P1");
    program.click("link:go on P1");
    const std::string question = program.at("question").value;
    CHECK(contains(question, "were given with memory"));
    CHECK(contains(question, "no device: nothing would be felt"));
    CHECK(program.at("answer:Not yet").value == "marked");
    program.press_key(key::kEnter);
    CHECK_FALSE(is_study_running(program.app.studying));
    CHECK(program.record().devices.empty());
    program.click("link:go on P1");
    program.click("answer:Go on as it is now");
    REQUIRE(is_study_running(program.app.studying));
    const StudyRecord record = program.record();
    CHECK(record.header.device.name == "memory");
    REQUIRE(record.devices.size() == 1);
    CHECK(record.devices[0].before == 1);
    CHECK(is_rehearsal(record.devices[0].device));
    CHECK(program.run().record.devices == record.devices);
}

TEST_CASE("actuator: another level or full scale is another strength, and asks as well") {
    Felt program;
    program.begin();
    program.leave();
    for (const bool is_level : {true, false}) {
        PlayState& play = program.app.play;
        const auto before = std::pair(play.level, play.full_scale_g);
        (is_level ? play.level : play.full_scale_g) *= 2.0;
        program.wait_for("link:go on P1");
        program.click("link:go on P1");
        CHECK(program.shows("question"));
        CHECK_FALSE(is_study_running(program.app.studying));
        program.press_key(key::kEscape);
        std::tie(play.level, play.full_scale_g) = before;
    }
    program.click("link:go on P1");
    CHECK(is_study_running(program.app.studying));
}

TEST_CASE("actuator: nobody is asked at a level at which nothing is felt") {
    Felt program;
    program.app.play.level = 0.0;
    program.click("button:run participant");
    CHECK_FALSE(is_study_running(program.app.studying));
    CHECK(contains(program.at("button:run participant").value, "The level is 0"));
}

TEST_CASE("actuator: one that is listed but cannot play makes a rehearsal, and the file says so") {
    Felt program;
    program.device->pretend(0.0, 0.0, false, "another program has it");
    program.click("button:run participant");
    program.press_key(key::kEnter);
    program.press_key(key::kEnter);
    REQUIRE(program.page() == "instructions 0");
    CHECK(is_rehearsal(program.record().header.device));
}

}  // namespace study_actuator_test
