// Where masking noise goes, and what a study does without it.

#include "app/study/parts.h"

#include "app/study/study.h"
#include "devices/device/memory_device.h"
#include "tests/support/program.h"
#include "tests/support/quick_study.h"
#include "tests/support/temporary_folder.h"

namespace study_masking_test {

using namespace tact;

namespace {

DeviceInfo output(const std::string& name) {
    DeviceInfo info;
    info.id = "audio/test/" + name;
    info.name = name;
    info.channels = {"left", "right"};
    return info;
}

PlayState with_outputs(const std::vector<DeviceInfo>& all, const std::string& actuator) {
    PlayState play;
    play.listed = std::make_shared<const Listing>(all);
    play.choice.id = actuator;
    return play;
}

std::string why_not(const PlayState& play, const std::string& headphones) {
    const auto found = masking_output(play, headphones);
    return found ? "" : found.error().message;
}

// A run with noise on a device that keeps what it is given.
struct Masked : Program {
    TemporaryFolder folder;
    std::shared_ptr<MemoryDevice> noise = std::make_shared<MemoryDevice>(true);

    static PatternSet set() {
        PatternSet set = quick_study();
        set.study.masking = 0.3;
        return set;
    }
    Masked() : Program(set()) {
        set_study_folder(app.work, app.studying, folder.path / "people");
        app.studying.masking = noise;
        open_study(app.layout, app.studying);
        settle();
        click("button:run participant");
    }
    ~Masked() { stop_study(app.studying); }

    void to_instructions() {
        press_key(key::kEnter);
        press_key(key::kEnter);
        REQUIRE(at("study page").value == "instructions 0");
    }
    std::string file() const { return (folder.path / "people" / "P1.jsonl").string(); }
};

}  // namespace

TEST_CASE("masking: it goes to the output of the design, and to no other") {
    const PlayState play = with_outputs({output("coil"), output("ears")}, "audio/test/coil");
    REQUIRE(masking_output(play, "audio/test/ears"));
    CHECK(masking_output(play, "audio/test/ears")->name == "ears");
    CHECK(why_not(play, "") == "no output is chosen for the headphones in the study's design");
    CHECK(
        why_not(play, "audio/test/gone").starts_with("gone, the headphones' output, is not there"));
}

TEST_CASE("masking: the actuator's own output is none, not even where it is the only one") {
    const PlayState two = with_outputs({output("coil"), output("ears")}, "audio/test/coil");
    CHECK(why_not(two, "audio/test/coil") ==
          "the headphones' output is the actuator's: choose another one");
    const PlayState one = with_outputs({output("coil")}, "audio/test/coil");
    const std::string only =
        "the only sound output is the actuator's: headphones need a second one";
    CHECK(why_not(one, "audio/test/coil") == only);
    CHECK(why_not(one, "") == only);
    CHECK(why_not(with_outputs({}, ""), "audio/test/ears") == "there is no sound output");
}

TEST_CASE("masking: an output is the actuator's by whichever of its names it was chosen") {
    DeviceInfo usual = output("pulse");
    usual.server_output = "amplifier";
    DeviceInfo amplifier = output("amplifier");
    amplifier.server_output = "amplifier";
    DeviceInfo ears = output("ears");
    ears.server_output = "headset";
    const std::string refused = "the headphones' output is the actuator's: choose another one";
    CHECK(why_not(with_outputs({usual, amplifier, ears}, usual.id), amplifier.id) == refused);
    CHECK(why_not(with_outputs({usual, amplifier, ears}, amplifier.id), usual.id) == refused);
    CHECK(why_not(with_outputs({usual, amplifier, ears}, usual.id), ears.id).empty());
    const PlayState one = with_outputs({usual, amplifier}, usual.id);
    CHECK(why_not(one, amplifier.id) ==
          "the only sound output is the actuator's: headphones need a second one");
}

TEST_CASE("masking: a server that does not say where it plays might play on the actuator") {
    DeviceInfo server = output("somewhere");
    server.is_server = true;
    const PlayState play = with_outputs({output("coil"), server}, "audio/test/coil");
    CHECK(
        why_not(play, server.id)
            .starts_with("somewhere is a sound server that does not say which output it plays on"));
    server.server_output = "headset";
    CHECK(why_not(with_outputs({output("coil"), server}, "audio/test/coil"), server.id).empty());
}

TEST_CASE("masking: a controller as actuator leaves the only sound output to the headphones") {
    DeviceInfo pad;
    pad.id = "hid:pad";
    pad.kind = DeviceKind::hid;
    const PlayState play = with_outputs({output("ears"), pad}, pad.id);
    CHECK(masking_output(play, "audio/test/ears"));
    CHECK(why_not(play, pad.id).find("is the actuator's") != std::string::npos);
}

TEST_CASE("masking: a run begins with pink noise in a loop, which its file says") {
    Masked program;
    REQUIRE(program.noise->playing());
    CHECK(program.noise->looping());
    CHECK(program.noise->level() == 0.3);
    program.to_instructions();
    const auto record = read_study_file(program.file());
    REQUIRE(record);
    CHECK(record->header.device.masking.starts_with("pink noise at 30 % of full scale on "));
}

TEST_CASE("masking: where it stops by itself the study pauses, says so, and tries again") {
    Masked program;
    program.to_instructions();
    program.noise->pretend(0.0, 0.0, false, "ears are gone");
    program.noise->end();
    program.frame();
    CHECK(program.app.studying.run->is_asking);
    program.settle();
    const std::string said = "The masking noise stopped: ears are gone.";
    CHECK(program.at("study:warning").value.find(said) != std::string::npos);
    program.noise->pretend(0.0, 0.0, false);
    act(program.app.ui, program.app.work, program.app.play, program.app.studying,
        {StudyEvent::What::stay, 0, 0.0, {}, {}});
    program.settle();
    CHECK(program.noise->playing());
    CHECK_FALSE(program.app.studying.run->is_asking);
    if (program.shows("study:warning")) {
        CHECK(program.at("study:warning").value.find("masking") == std::string::npos);
    }
}

TEST_CASE("masking: without an output the file says why there was none") {
    Masked program;
    act(program.app.ui, program.app.work, program.app.play, program.app.studying,
        {StudyEvent::What::ask, 0, 0.0, {}, {}});
    act(program.app.ui, program.app.work, program.app.play, program.app.studying,
        {StudyEvent::What::leave, 0, 0.0, {}, {}});
    program.app.studying.masking.reset();
    program.settle();
    program.click("button:run participant");
    CHECK(program.at("study:warning").value.find("Rehearsal") != std::string::npos);
    program.to_instructions();
    const auto record = read_study_file(program.file());
    REQUIRE(record);
    CHECK(record->header.device.masking == "none: this program has no sound.");
}

}  // namespace study_masking_test
