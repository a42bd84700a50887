// One question, one answer, for files: what the window exports and imports has the bytes of what
// the command line does, with what that costs.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "app/document/editing.h"
#include "app/export/export.h"
#include "app/measured/measured.h"
#include "app/window/window.h"
#include "model/export/exported_files.h"
#include "model/io/set/load.h"
#include "model/io/set/set_file.h"
#include "model/text/numbers.h"
#include "tests/support/patience.h"
#include "tests/support/program.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace same_files_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

PatternSet five() {
    PatternSet set = short_patterns(5);
    std::get<Pattern>(set.vibrations[1].source).amplitude_g = 3.0;
    std::get<Pattern>(set.vibrations[2].source).amplitude_g = 0.0;
    std::get<Pattern>(set.vibrations[4].source).rhythm.text = "x-x-";
    return set;
}

std::map<std::string, std::string> files_in(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator(folder)) {
        files[entry.path().filename().string()] = bytes_of(entry.path());
    }
    return files;
}

template <class Arrived>
void wait(Program& program, const Arrived& arrived) {
    const auto until = end_of_patience();
    while (!arrived()) {
        REQUIRE(std::chrono::steady_clock::now() < until);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        program.frame();
    }
}

}  // namespace

TEST_CASE("same answers: files of other programs, and what they cost" *
          doctest::test_suite("long")) {
    const TemporaryFolder folder;
    const std::string set = (folder.path / "set.tactspace.json").string();
    REQUIRE(write_set_file(set, five()));
    Program program(five());
    App& app = program.app;
    EffectExport& effects = app.exports.effects;
    program.compute_map();
    for (const TargetFormat format :
         {TargetFormat::ahap, TargetFormat::wav, TargetFormat::android_timings}) {
        const std::string key = traits(format).key;
        CAPTURE(key);
        export_effects_dialog(app.ui, app.work, app.shown_map, {}, 8, SubsetObjective::max_min,
                              effects);
        effects.choice.format = format;
        effects.choice.which = ExportWhich::all;
        wait(program, [&] { return is_loss_current(effects); });
        const fs::path ours = folder.path / (key + " window");
        effects.export_to = ours;
        continue_effect_export(app.ui, effects);
        const fs::path theirs = folder.path / (key + " terminal");
        (void)output_of({"export", set, "--format", key, "--out", theirs.string()});
        const auto window = files_in(ours);
        CHECK(window.size() >= 6);
        CHECK(window.contains(kExportReport));
        CHECK((window == files_in(theirs)));

        // Without what they cost, the same files without its page.
        stop_predicting(effects);
        effects.answer.reset();
        const fs::path alone = folder.path / (key + " alone");
        effects.export_to = alone;
        continue_effect_export(app.ui, effects);
        const fs::path told = folder.path / (key + " told");
        (void)output_of({"export", set, "--format", key, "--no-loss", "--out", told.string()});
        CHECK((files_in(alone) == files_in(told)));
        CHECK(files_in(alone).size() + 1 == window.size());
        app.ui.dialog = kNoDialog;
        program.frame();
    }
}

TEST_CASE("same answers: some of a set as files have the scale of all of it") {
    PatternSet set = five();
    const ExportTarget wav = *export_target_named("wav", "");
    ExportedFilesOptions options;
    options.without_loss = true;
    const auto all = exported_files(set, wav, "2026-01-01", options);
    options.written = {0, 3};
    const auto some = exported_files(set, wav, "2026-01-01", options);
    REQUIRE(all);
    REQUIRE(some);
    REQUIRE(some->names.size() == 2);
    CHECK(some->target == all->target);
    for (const TextFile& file : some->files) {
        CAPTURE(file.name);
        CHECK((std::ranges::find(all->files, file) != all->files.end()));
    }
}

TEST_CASE("same answers: a recording becomes the same twin, with the same remarks") {
    const TemporaryFolder folder;
    const std::string set = (folder.path / "set.tactspace.json").string();
    REQUIRE(write_set_file(set, five()));
    std::vector<fs::path> files;
    for (const std::size_t k : {0, 4}) {
        const Vibration vibration = five().vibrations[k];
        std::string text = "t,x (g)\n";
        const Waveform waveform = waveform_of(vibration);
        for (std::size_t n = 0; n < waveform.samples_g.size() + 100; ++n) {
            const double g = n < 100 ? 0.0 : waveform.samples_g[n - 100];
            text += shortest_digits(static_cast<double>(n) / kModelRateHz) + "," +
                    shortest_digits(g) + "\n";
        }
        files.push_back(folder.write(vibration.name + ".csv", text));
    }
    Program program(five());
    App& app = program.app;
    app.work.session.folder = folder.path / "state";
    begin_jobs(app);
    import_recordings(app.ui, app.work, app.importing, files);
    wait(program, [&] { return app.importing.answer != nullptr; });
    std::vector<std::vector<std::string>> remarks;
    for (const ImportedFile& one : app.importing.answer->files) {
        REQUIRE(one.fault == "");
        remarks.push_back(one.remarks);
    }
    take_recordings(app.ui, app.work, app.importing);
    wait(program, [&] { return !is_taking(app.importing); });

    const std::string out = (folder.path / "out.tactspace.json").string();
    const auto terminal = nlohmann::json::parse(
        output_of({"import", set, files[0].string(), files[1].string(), "--out", out, "--json"}));
    const auto with = load_set(out);
    REQUIRE(with);
    const PatternSet& window = app.work.document.set;
    REQUIRE(names_of(with->set) == names_of(window));
    REQUIRE(window.vibrations.size() == 7);
    for (std::size_t k = 0; k < window.vibrations.size(); ++k) {
        CHECK((waveform_of(with->set.vibrations[k]) == waveform_of(window.vibrations[k])));
        const auto* ours = std::get_if<Measurement>(&window.vibrations[k].source);
        const auto* theirs = std::get_if<Measurement>(&with->set.vibrations[k].source);
        REQUIRE((ours == nullptr) == (theirs == nullptr));
        if (ours == nullptr) continue;
        CHECK(ours->measures == theirs->measures);
        CHECK(ours->measures_version == theirs->measures_version);
    }
    for (std::size_t k = 0; k < remarks.size(); ++k) {
        CHECK(terminal[k].at("remarks") == remarks[k]);
    }
}

}  // namespace same_files_test
