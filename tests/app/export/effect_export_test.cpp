// File > Export vibrations: what it costs first, then the files, never over others unasked.
#include "app/export/export.h"

#include <algorithm>
#include <set>

#include "app/window/window.h"
#include "model/export/exported_files.h"
#include "model/export/loss_words.h"
#include "model/io/recordings/wave_file.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace effect_export_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

void run_command(Program& program, const std::string& name) {
    const auto all = commands();
    const auto found = std::ranges::find(all, name, &Command::name);
    REQUIRE(found != all.end());
    REQUIRE(found->enabled(program.app));
    found->run(program.app);
    program.settle();
}

PatternSet five_with_odd_names() {
    PatternSet set = short_patterns(5);
    set.vibrations[0].name = "a/b <i>";
    std::get<Pattern>(set.vibrations[1].source).amplitude_g = 3.0;
    return set;
}

std::optional<LiveLoss> wait_until_stopped(const LossRequest&, const std::stop_token& stop,
                                           std::atomic<float>&) {
    while (!stop.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return std::nullopt;
}

struct EffectDialog {
    TemporaryFolder folder;
    Program program;

    explicit EffectDialog(const PatternSet& set = five_with_odd_names(),
                          bool takes_for_ever = false)
        : program(set) {
        program.app.ui.motion = false;
        EditedDocument& document = program.app.work.document;
        document.open({document.set, folder.path / "test.tactspace.json", document.saved});
        program.compute_map();
        if (takes_for_ever) effects().job.begin(wait_until_stopped);
        run_command(program, "Export vibrations...");
    }

    EffectExport& effects() { return program.app.exports.effects; }

    template <class Condition>
    void wait_until(const Condition& holds) {
        const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (!holds()) {
            REQUIRE(std::chrono::steady_clock::now() < until);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            program.frame();
        }
        program.settle();
    }

    void wait_for_loss() {
        wait_until([this] { return program.at("export:loss").value == "current"; });
    }

    void choose_format(const std::string& key) {
        program.click("export:format");
        program.click("export format:" + key);
    }

    // Over the name that is offered.
    void answer_folder(const fs::path& path) {
        program.click("button:choose");
        REQUIRE(program.app.ui.chooser.is_open);
        program.window.type(path.string());
        program.settle();
        program.press_key(key::kEnter);
    }

    void write() {
        REQUIRE(is_exporting(program.app));
        program.frame();
        continue_exports(program.app);
        program.settle();
    }
};

std::set<std::string> file_names(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
        names.insert(entry.path().filename().string());
    }
    return names;
}

}  // namespace

TEST_CASE("export vibrations: what it costs is on screen before anything is written, then files") {
    EffectDialog dialog;
    dialog.wait_for_loss();
    CHECK(file_count(dialog.folder.path) == 0);
    const ExportLoss loss =
        *export_loss(dialog.program.app.work.document.set, own_target(TargetFormat::ahap));
    CHECK(dialog.program.at("export:summary").value == summary_of(loss));
    for (const PatternLoss& one : loss.patterns) {
        CHECK(dialog.program.at("export:loss of " + one.name).value == moved_text(one));
    }
    CHECK(dialog.program.shows("export:map"));
    const fs::path out = dialog.folder.path / "phone";
    dialog.answer_folder(out);
    dialog.write();
    CHECK(file_names(out) == std::set<std::string>{"a-b -i-.ahap", "p2.ahap", "p3.ahap", "p4.ahap",
                                                   "p5.ahap", kExportReport});
    CHECK(dialog.program.app.ui.status.text ==
          "Exported 5 patterns as AHAP for core-haptics holds them, into " + out.string());
    const auto& set = dialog.program.app.work.document.set;
    CHECK(bytes_of(out / "p2.ahap") == exported(std::get<Pattern>(set.vibrations[1].source), "p2",
                                                own_target(TargetFormat::ahap),
                                                dialog.effects().request.date)
                                           .text);
    const std::string page = bytes_of(out / kExportReport);
    CHECK(contains(page, "a/b &lt;i&gt;"));
    CHECK_FALSE(contains(page, "<i>"));
    CHECK(contains(page, "louder than full scale"));
    CHECK(contains(page, "nobody publishes it"));
    CHECK(contains(page, "<svg"));
}

TEST_CASE("export vibrations: an answer to an earlier choice looks stale and cannot be exported") {
    EffectDialog dialog;
    dialog.wait_for_loss();
    const std::string before = dialog.program.at("export:summary").value;
    dialog.choose_format("hjif");
    dialog.wait_for_loss();
    CHECK(dialog.program.at("export:actuator").value == "mpeg");
    CHECK(dialog.program.at("export:summary").value != before);
    // The state between the choice and its answer.
    dialog.effects().request.number += 1;
    dialog.program.settle();
    CHECK(dialog.program.at("export:loss").value == "stale");
    dialog.program.click("button:choose");
    CHECK_FALSE(dialog.program.app.ui.chooser.is_open);
    CHECK(dialog.program.app.ui.dialog == kExportEffectsDialog);
}

TEST_CASE("export vibrations: stopped, the files are written without the page, and that is said") {
    EffectDialog dialog(five_with_odd_names(), true);
    stop_predicting(dialog.effects());
    dialog.program.settle();
    REQUIRE(dialog.program.shows("button:predict loss"));
    CHECK(dialog.program.at("export:loss").value == "none");
    const fs::path out = dialog.folder.path / "alone";
    dialog.answer_folder(out);
    dialog.write();
    CHECK(file_count(out) == 5);
    CHECK_FALSE(fs::exists(out / kExportReport));
    CHECK(dialog.program.app.ui.status.text.ends_with("; what that costs was not predicted"));
    dialog.effects().job = Query<LossRequest, LiveLoss>();
    run_command(dialog.program, "Export vibrations...");
    dialog.wait_for_loss();
}

TEST_CASE("export vibrations: files that are there are not replaced unasked, the page neither") {
    EffectDialog dialog;
    dialog.wait_for_loss();
    dialog.folder.write(fs::path("phone") / kExportReport, "mine");
    const fs::path out = dialog.folder.path / "phone";
    dialog.answer_folder(out / "");
    dialog.program.press_key(key::kEnter, true);  // its content was shown: into this folder
    CHECK_FALSE(is_exporting(dialog.program.app));
    CHECK(dialog.program.app.ui.chooser.replacing.filename() == kExportReport);
    CHECK(bytes_of(dialog.folder.path / "phone" / kExportReport) == "mine");
    dialog.program.press_key(key::kEnter);
    dialog.write();
    CHECK(file_count(dialog.folder.path / "phone") == 6);
}

TEST_CASE("export vibrations: of picked ones all is predicted, of selected ones these alone") {
    EffectDialog dialog;
    EffectExport& effects = dialog.effects();
    effects.ground.picked = {1, 3};
    effects.ground.selected = {0, 2, 4};
    dialog.program.settle();
    dialog.program.click("export which:Picked");
    dialog.wait_for_loss();
    CHECK(effects.request.part->vibrations.size() == 5);
    CHECK(effects.request.written == std::vector<std::size_t>{1, 3});
    CHECK(dialog.program.at("export:loss of p4").min.y <
          dialog.program.at("export:loss of a/b <i>").min.y);
    CHECK(contains(dialog.program.at("export:summary").value, " of 2 patterns "));
    dialog.program.click("export which:Selected");
    dialog.wait_for_loss();
    CHECK(effects.request.part->vibrations.size() == 3);
    const fs::path out = dialog.folder.path / "some";
    dialog.program.click("export which:Picked");
    dialog.wait_for_loss();
    dialog.answer_folder(out);
    dialog.write();
    CHECK(file_names(out) == std::set<std::string>{"p2.ahap", "p4.ahap", kExportReport});
    CHECK(contains(bytes_of(out / kExportReport), "not written"));
}

TEST_CASE("export vibrations: recordings are left out, and that is said") {
    PatternSet set = five_with_odd_names();
    Measurement measurement;
    measurement.waveform = std::make_shared<const Waveform>(waveform_of(set.vibrations[1]));
    set.vibrations[1].source = measurement;
    EffectDialog dialog(set);
    dialog.wait_for_loss();
    CHECK(dialog.program.at("export:left out").value ==
          "1 recording is left out: no such file holds it");
    CHECK(dialog.effects().request.written.size() == 4);
}

TEST_CASE("export vibrations: a folder that cannot be written is one sentence") {
    EffectDialog dialog;
    dialog.wait_for_loss();
    dialog.folder.write("file", "");
    dialog.effects().export_to = dialog.folder.path / "file" / "below";
    dialog.write();
    CHECK(dialog.program.app.ui.status.is_error);
    CHECK(dialog.program.app.ui.status.text.starts_with("Not exported: "));
}

TEST_CASE("export vibrations: closing the dialog ends the work beside the window") {
    EffectDialog dialog;
    dialog.program.click("button:cancel");
    dialog.wait_until([&] { return !is_predicting_loss(dialog.effects()); });
    CHECK(dialog.program.app.ui.dialog == kNoDialog);
}

TEST_CASE(
    "export vibrations: WAV has a rate and bits in the place of an actuator, and recordings") {
    PatternSet set = five_with_odd_names();
    Measurement measurement;
    measurement.waveform = std::make_shared<const Waveform>(waveform_of(set.vibrations[1]));
    set.vibrations[1].source = measurement;
    EffectDialog dialog(set);
    dialog.choose_format("wav");
    CHECK_FALSE(dialog.program.shows("export:actuator"));
    CHECK(dialog.program.at("export:48 kHz").value == "chosen");
    CHECK(dialog.program.at("export:24 bits").value == "chosen");
    CHECK(dialog.program.at("export:left out").value.empty());
    dialog.program.click("export:10 kHz");
    dialog.program.click("export:16 bits");
    dialog.wait_for_loss();
    const fs::path out = dialog.folder.path / "waves";
    dialog.answer_folder(out);
    dialog.write();
    CHECK(file_count(out) == 11);
    const std::string status = dialog.program.app.ui.status.text;
    CHECK(contains(status, "as WAV of 10,000 Hz and 16 bits holds them"));
    CHECK(contains(status, " g, said in the .wav.json beside each file"));
    const auto read = read_wave_file(out / "p3.wav");
    REQUIRE(read);
    CHECK(read->remarks.empty());
    CHECK(peak_g(read->waveform) ==
          doctest::Approx(peak_g(waveform_of(set.vibrations[2]))).epsilon(1e-3));
    CHECK(contains(bytes_of(out / kExportReport), "Full scale: "));
    // The same without the prediction.
    stop_predicting(dialog.effects());
    dialog.effects().answer.reset();
    dialog.effects().export_to = dialog.folder.path / "again";
    dialog.write();
    CHECK(bytes_of(dialog.folder.path / "again" / "p3.wav") == bytes_of(out / "p3.wav"));
    CHECK(bytes_of(dialog.folder.path / "again" / "p3.wav.json") == bytes_of(out / "p3.wav.json"));
    run_command(dialog.program, "Export vibrations...");
    dialog.choose_format("csv");
    CHECK(dialog.program.at("export:10 kHz").value == "chosen");
    CHECK_FALSE(dialog.program.shows("export:16 bits"));
}

TEST_CASE("export vibrations: the map by which effects were read, where somebody chose it") {
    PatternSet set = five_with_odd_names();
    for (Vibration& one : set.vibrations) one.effect = {"haptic", "console-pcm"};
    EffectDialog dialog(set, true);
    dialog.choose_format("haptic");
    CHECK(dialog.program.at("export:actuator").value == "console-pcm");
    CHECK(dialog.effects().request.target.map.name == "console-pcm");
    dialog.program.click("export:actuator");
    dialog.program.click("export actuator:quest");
    CHECK(dialog.effects().request.target.map.name == "quest");
}

TEST_CASE("export report: the same loss is the same page, and names what was lost") {
    const PatternSet set = five_with_odd_names();
    const ExportLoss loss = *export_loss(set, own_target(TargetFormat::android_xml));
    const std::vector<std::size_t> written{0, 1, 2, 3, 4};
    const std::vector<std::string> files = effect_file_names(set, TargetFormat::android_xml);
    const std::string page = export_report({loss, set, written, files});
    CHECK(page == export_report({loss, set, written, files}));
    CHECK(contains(page, subset_verdict(loss).substr(0, 20)));
    for (const PatternLoss& one : loss.patterns) {
        CHECK(contains(page, loss_number(one.rms_error_g)));
        for (const std::string& remark : one.remarks) CHECK(contains(page, remark));
    }
    CHECK_FALSE(contains(page, "://"));
    CHECK_FALSE(contains(page, "<script"));
}

}  // namespace effect_export_test
