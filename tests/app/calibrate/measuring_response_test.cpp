// Calibrating the chosen device in the window, with a coil that gives 0.5 g per full scale.

#include "app/calibrate/calibrate.h"

#include <cmath>

#include "app/play/play.h"
#include "devices/calibration/calibration_file.h"
#include "model/io/recordings/wave_file.h"
#include "tests/support/felt_program.h"
#include "tests/support/patience.h"
#include "tests/support/temporary_folder.h"

namespace measuring_response_test {

using namespace tact;

namespace {

struct Measuring : Program {
    TemporaryFolder folder;
    MemoryDevice* device = nullptr;

    Measuring() : Program(short_patterns(2)) {
        app.work.session.folder = folder.path / "state";
        device = plug_in(app, "coil");
        app.play.choice.id = app.play.listed->front().id;
        app.play.choice.channel = 2;
        app.play.opened = app.play.choice;
        app.ui.dialog = kDevicesDialog;
        settle();
        click("link:calibrate");
        // A short one.
        app.calibrating.params.low_hz = 50.0;
        app.calibrating.params.high_hz = 200.0;
        app.calibrating.params.per_octave = 2;
        settle();
    }

    // What a sensor would have recorded of the signal.
    std::filesystem::path recorded(double g_per_full_scale) {
        Waveform heard;
        heard.samples_g.assign(3000, 0.0);
        for (const double sample : signal().samples) {
            heard.samples_g.push_back(g_per_full_scale * sample);
        }
        heard.samples_g.insert(heard.samples_g.end(), 2000, 0.0);
        const auto file = folder.path / "heard.wav";
        REQUIRE(write_wave_file(file, heard));
        return file;
    }
    Drive signal() const { return calibration_plan(app.calibrating.params).drive; }

    void wait_for_answer() {
        const auto until = end_of_patience();
        while (current_answer(app.calibrating) == nullptr) {
            REQUIRE(std::chrono::steady_clock::now() < until);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            frame();
        }
        settle();
    }
};

}  // namespace

TEST_CASE("measuring a response: the signal is played at full level, whatever the bar says") {
    Measuring program;
    program.click("button:play signal");
    REQUIRE(program.device->playing());
    CHECK(*program.device->playing() == program.signal());
    CHECK(program.device->level() == 1.0);
    program.click("button:stop signal");
    CHECK_FALSE(program.device->playing());
    play_test_buzz(program.app.ui, program.app.timeline, program.app.play);
    CHECK(program.device->level() == kFirstLevel);
}

TEST_CASE("measuring a response: the first Esc ends the signal, the second one leaves") {
    Measuring program;
    program.click("button:play signal");
    program.press_key(key::kEscape);
    CHECK_FALSE(program.device->playing());
    CHECK(program.app.ui.dialog == kCalibrateDialog);
    program.press_key(key::kEscape);
    CHECK(program.app.ui.dialog == kNoDialog);
}

TEST_CASE("measuring a response: leaving the dialog ends the signal") {
    Measuring program;
    program.click("button:play signal");
    program.click("button:cancel");
    CHECK_FALSE(program.device->playing());
}

TEST_CASE("measuring a response: a recording becomes the file of this device, used at once") {
    Measuring program;
    CHECK(program.shows("calibrate:waits"));
    read_calibration_recording(program.app.ui, program.app.calibrating, program.recorded(0.5));
    program.wait_for_answer();
    CHECK(program.shows("calibrate:response"));
    program.app.calibrating.about.actuator = "left coil";
    program.click("button:choose");
    REQUIRE(program.app.play.calibration);
    const Calibration& made = *program.app.play.calibration;
    CHECK(made.device == "audio/test/coil");
    CHECK(made.channel == 2);
    CHECK(made.actuator == "left coil");
    CHECK(made.date.size() == 10);
    REQUIRE(made.points.size() == 5);
    for (const ResponsePoint& point : made.points) {
        CHECK(std::abs(point.g_per_full_scale / 0.5 - 1.0) < 1e-3);
    }
    const std::filesystem::path file = program.app.play.choice.calibration;
    CHECK(file.parent_path() == program.app.work.session.folder / "calibrations");
    CHECK(*read_calibration(file) == made);
    CHECK(program.app.ui.status.text.find("Calibrated: left coil") == 0);
}

TEST_CASE("measuring a response: a second calibration leaves the first one's file as it is") {
    Measuring program;
    read_calibration_recording(program.app.ui, program.app.calibrating, program.recorded(0.5));
    program.wait_for_answer();
    save_and_use_calibration(program.app.ui, program.app.work, program.app.timeline,
                             program.app.rendered, program.app.play, program.app.calibrating);
    const std::filesystem::path first = program.app.play.choice.calibration;
    save_and_use_calibration(program.app.ui, program.app.work, program.app.timeline,
                             program.app.rendered, program.app.play, program.app.calibrating);
    CHECK(program.app.play.choice.calibration != first.string());
    CHECK(std::filesystem::exists(first));
}

TEST_CASE("measuring a response: what was saved is looked for where it is, also by one without") {
    Measuring program;
    read_calibration_recording(program.app.ui, program.app.calibrating, program.recorded(0.5));
    program.wait_for_answer();
    program.click("button:choose");
    const auto folder = program.app.work.session.folder / "calibrations";
    for (const bool is_in_use : {true, false}) {
        CAPTURE(is_in_use);
        program.app.ui.dialog = kDevicesDialog;
        program.settle();
        if (!is_in_use) program.click("link:no calibration");
        program.click("link:load calibration");
        REQUIRE(program.app.ui.chooser.is_open);
        CHECK(program.app.ui.chooser.listing.folder == folder);
        program.press_key(key::kEscape);
    }
}

TEST_CASE("measuring a response: the last tone is as high as was asked, and so says the table") {
    Measuring program;
    program.app.calibrating.params = {};
    CHECK(calibration_plan({}).tones.back().frequency_hz == program.app.calibrating.params.high_hz);
    program.app.calibrating.params.high_hz = 190.0;
    const auto tones = calibration_plan(program.app.calibrating.params).tones;
    CHECK(tones.front().frequency_hz == 20.0);
    CHECK(tones.back().frequency_hz == 190.0);
}

TEST_CASE("measuring a response: what is no recording of the signal is said, and not saved") {
    Measuring program;
    read_calibration_recording(program.app.ui, program.app.calibrating,
                               program.folder.write("heard.csv", "time_s,x_g\n0,0\n1,2\n"));
    program.wait_for_answer();
    CHECK_FALSE(program.at("calibrate:waits").value.empty());
    program.click("button:choose");
    CHECK_FALSE(program.app.play.calibration);
}

TEST_CASE("measuring a response: what is doubtful of the table is said beside it") {
    Measuring program;
    read_calibration_recording(program.app.ui, program.app.calibrating, program.recorded(0.5));
    program.wait_for_answer();
    CHECK_FALSE(program.shows("calibrate:remark 0"));
    ResponseAnswer doubted = *program.app.calibrating.job.latest();
    doubted.result.remarks = {"between 50 and 71 Hz strengths may be wrong by 2.0 dB"};
    program.app.calibrating.job = Query<ResponseQuestion, ResponseAnswer>();
    program.app.calibrating.job.ask(
        doubted.question, [doubted](const ResponseQuestion&, std::stop_token, std::atomic<float>&) {
            return std::optional(doubted);
        });
    while (!program.shows("calibrate:remark 0")) program.frame();
    CHECK(program.at("calibrate:remark 0").value == doubted.result.remarks.front());
}

TEST_CASE("measuring a response: a change of the signal asks again, what was said is no answer") {
    Measuring program;
    read_calibration_recording(program.app.ui, program.app.calibrating, program.recorded(0.5));
    program.wait_for_answer();
    program.click("calibrate:sweep");
    CHECK(program.app.calibrating.params.is_sweep);
    program.wait_for_answer();
    CHECK_FALSE(program.at("calibrate:waits").value.empty());
}

TEST_CASE("measuring a response: what a calibrated coil renders follows the calibration") {
    Measuring program;
    program.app.rendered.by.kind = ActuatorKind::voice_coil;
    program.settle();
    CHECK_FALSE(is_calibrated(program.app.rendered.by));
    read_calibration_recording(program.app.ui, program.app.calibrating, program.recorded(0.5));
    program.wait_for_answer();
    program.click("button:choose");
    CHECK(is_calibrated(program.app.rendered.by));
    use_calibration(program.app.ui, program.app.work, program.app.timeline, program.app.rendered,
                    program.app.play, {});
    program.settle();
    CHECK_FALSE(is_calibrated(program.app.rendered.by));
}

}  // namespace measuring_response_test
