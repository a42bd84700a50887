// A recording is cut, and traced as a pattern, in the editor.

#include "app/patterns/parts.h"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

#include "app/document/editing.h"
#include "app/map/map.h"
#include "app/workspaces/workspaces.h"
#include "model/io/set/set_file.h"
#include "model/text/numbers.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"
#include "viz/drawing/plot.h"

namespace recording_editor_test {

using namespace tact;

namespace {

Measurement swell() {
    Pattern pattern;
    pattern.duration_s = 0.5;
    pattern.carriers[0].frequency_hz = 180.0;
    pattern.amplitude_curve = {{0.0, 0.0}, {0.25, 1.0}, {0.5, 0.0}};
    Waveform samples = render(pattern);
    for (double& sample_g : samples.samples_g) {
        sample_g = static_cast<double>(static_cast<float>(sample_g));
    }
    Measurement recording;
    recording.waveform = std::make_shared<const Waveform>(samples);
    return recording;
}

PatternSet with_recording() {
    PatternSet set = short_patterns(2);
    set.vibrations.push_back({});
    set.vibrations.back().name = "tap";
    set.vibrations.back().source = swell();
    set.vibrations.back().note = "Of a phone.";
    return set;
}

struct Recorded : Program {
    Recorded() : Program(with_recording()) {
        select_only(app.work, 2);
        app.layout.maximised = Pane::editor;  // all of it is visible
        settle();
    }
    const Vibration& recording() const { return app.work.document.set.vibrations[2]; }
    const Measurement& measured() const { return std::get<Measurement>(recording().source); }
    void enter(const std::string& entry, const std::string& text) {
        click(entry);
        type(text);
        press_key(key::kEnter);
    }
    void wait_for(const std::string& name) {
        for (int k = 0; k < 4000 && !shows(name); ++k) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            frame();
        }
        REQUIRE(shows(name));
    }
};

}  // namespace

TEST_CASE("recording: gain, part and fades are of the recording as it came, one step each") {
    Recorded program;
    const Waveform before = *program.measured().waveform;
    program.enter("entry:gain_db", "6");
    CHECK(peak_g(*program.measured().waveform) ==
          doctest::Approx(std::pow(10.0, 0.3) * peak_g(before)).epsilon(1e-6));
    program.enter("entry:gain_db", "0");
    CHECK(*program.measured().waveform == before);
    CHECK(program.recording().note == "Of a phone.");
    program.enter("entry:from_ms", "100");
    program.enter("entry:to_ms", "300");
    CHECK(duration_s(*program.measured().waveform) == doctest::Approx(0.2));
    CHECK(program.measured().waveform->samples_g[7] == before.samples_g[1007]);
    program.enter("entry:fade_in_ms", "50");
    CHECK(program.measured().waveform->samples_g[0] == 0.0);
    CHECK(program.recording().note.starts_with("Of a phone. Cut: 0.1 to 0.3 s, fades of 50"));
    CHECK(*program.app.work.document.history.undo_label() == "Change fade of tap");
    undo(program.app.ui, program.app.work);
    undo(program.app.ui, program.app.work);
    undo(program.app.ui, program.app.work);
    program.settle();
    CHECK(*program.measured().waveform == before);
    CHECK(program.at("entry:to_ms").value.find("500") != std::string::npos);
}

TEST_CASE("recording: what was cut has a file of its own when it is saved, and the other is kept") {
    const TemporaryFolder folder;
    Recorded program;
    const auto file = folder.path / "set.tactspace.json";
    save_as(program.app.ui, program.app.work, file);
    const std::string first = program.measured().path;
    CHECK(std::filesystem::exists(first));
    program.settle();
    program.enter("entry:gain_db", "-6");
    CHECK(program.measured().path.empty());
    CHECK(program.recording().note.find(first) != std::string::npos);
    save(program.app.ui, program.app.work);
    CHECK(program.measured().path != first);
    CHECK(std::filesystem::exists(first));
    const auto again = read_set_file(file);
    REQUIRE(again);
    CHECK(again->set.vibrations[2].source == program.recording().source);
}

TEST_CASE("recording: made parametric it stands beside its pattern, and PM between them is told") {
    Recorded program;
    begin_jobs(program.app);
    document_changed(program.app.work);
    program.wait_for("traced");
    CHECK(program.at("traced").value.find("points of amplitude") != std::string::npos);
    program.click("button:make parametric");
    const auto& all = program.app.work.document.set.vibrations;
    REQUIRE(all.size() == 4);
    CHECK(all[3].name == "tap parametric");
    CHECK(program.app.work.selection.current == 3);
    CHECK(program.app.work.selection.partner == "tap");
    CHECK(all[3].note.starts_with("Traced from tap: "));
    const auto& traced = std::get<Pattern>(all[3].source);
    CHECK(traced.carriers[0].frequency_hz == doctest::Approx(180.0).epsilon(0.01));
    CHECK(envelope_g(traced, 0.25) == doctest::Approx(1.0).epsilon(0.05));
    CHECK(*program.app.work.document.history.undo_label() == "Make tap parametric");
    program.wait_for("editor:partner");
    for (int k = 0; k < 4000; ++k) {
        const auto& map = program.app.shown_map.transition.shown;
        if (map && map_state(program.app.work, program.app.shown_map) == MapState::exact) break;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        program.frame();
    }
    const auto& map = program.app.shown_map.transition.shown;
    REQUIRE(map);
    // A percentage of the largest PM, as everywhere.
    CHECK(program.at("editor:partner").value ==
          "PM of tap parametric to tap: " + significant(map->prediction.pm(2, 3)) + " of " +
              significant(map->sorted_pm.back()));
}

TEST_CASE("recording: fewer points are asked for, and the worse fit is said") {
    Recorded program;
    program.wait_for("traced");
    const std::string fine = program.at("traced").value;
    program.enter("entry:trace_points", "4");
    for (int k = 0; k < 4000 && (!program.shows("traced") || program.at("traced").value == fine);
         ++k) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        program.frame();
    }
    CHECK(program.at("traced").value.starts_with("4 points of amplitude"));
}

TEST_CASE("recording: a locked one is not cut") {
    Recorded program;
    program.app.work.document.edit().vibrations[2].locked = true;
    program.settle();
    program.click("entry:gain_db");
    program.type("6");
    program.press_key(key::kEnter);
    CHECK(*program.measured().waveform == *swell().waveform);
}

TEST_CASE("recording: the note of a cut names all that was done, and nothing else") {
    CHECK(cut_note({0.0, {0.0, 1.0}, 0.0, 0.0}, 1.0, "a.wav").empty());
    CHECK(cut_note({3.0, {0.0, 1.0}, 0.0, 0.0}, 1.0, "a.wav") == "Cut from a.wav: +3 dB.");
    CHECK(cut_note({-3.0, {0.2, 1.0}, 0.01, 0.02}, 1.0, "") ==
          "Cut: -3 dB, 0.2 to 1 s, fades of 10 and 20 ms.");
}

TEST_CASE("recording: in the arrangement for design its stages are the editor's foot, too") {
    Recorded program;
    program.resize({1600.0F, 1000.0F}, 1.0F);
    program.app.layout = first_layout(Arrangement::design);
    begin_jobs(program.app);
    program.wait_for("stages:unfold");
    for (const std::size_t place : {0U, 2U}) {
        select_only(program.app.work, place);
        program.settle();
        REQUIRE(program.shows("stages:unfold"));
        const Place& foot = program.at("stages:unfold");
        const Place& pane = program.at("pane:Editor");
        CHECK(foot.min.y > 0.5F * (pane.min.y + pane.max.y));
        CHECK(foot.max.y < pane.max.y);
    }
}

}  // namespace recording_editor_test
