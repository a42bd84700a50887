// Training in the model bench, in the program's real frames: from ratings to parameters in use.
#include <doctest/doctest.h>

#include <utility>

#include "app/model_bench/model_bench.h"
#include "model/io/set/set_file.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/set_ratings.h"
#include "model/training/training.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace training_panel_test {

using namespace tact;

namespace {

PerceptualModelParams planted_model() {
    PerceptualModelParams model;
    model.coding.excitatory_layers = 1;
    model.coding.inhibitory_layers = 2;
    model.channel_weight = {1.0, 0.5, 0.0, 0.2};
    model.nc_weight = 0.7;
    model.oc_weight = 0.2;
    return model;
}

// A set whose ratings are what a model with planted parameters predicts.
PatternSet planted_set(std::size_t count, const std::string& name) {
    PatternSet set = short_patterns(count);
    set.name = name;
    std::get<Pattern>(set.vibrations[0].source).rhythm.text = "x-";
    std::get<Pattern>(set.vibrations[1].source).amplitude_g = 0.4;
    const auto said = predict(model_waveforms(set), planted_model());
    RatingStudy study{names_of(set), true, {}};
    study.judgements.push_back({"P1", said->pm.condensed});
    study.judgements.push_back({"P2", said->pm.condensed});
    std::swap(study.judgements.back().condensed[0], study.judgements.back().condensed[1]);
    set.ratings = kept_ratings(study, "planted.csv");
    return set;
}

struct TrainingBench {
    TemporaryFolder folder;
    Program program;
    App& app = program.app;

    explicit TrainingBench(const PatternSet& set = planted_set(6, "planted")) : program(set) {
        app.work.session.folder = folder.path / "state";
        begin_jobs(app);
        app.layout.bench = BenchTab::model;
        app.model_bench.panel.view = ModelView::training;
        app.layout.maximised = Pane::matrix;  // all of it in view
        app.model_bench.training.units = 2;   // coarse: quick
        program.settle();
    }

    void wait_for_training() {
        const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        do {
            REQUIRE(std::chrono::steady_clock::now() < until);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            program.frame();
        } while (is_training(app.model_bench));
        program.settle();
    }

    void train() {
        program.click("button:train");
        wait_for_training();
        REQUIRE(app.model_bench.training.found);
        REQUIRE(app.model_bench.training.found->fault.empty());
    }

    // What the model does on a set by itself.
    Training by_hand(const std::vector<const PatternSet*>& sets) const {
        std::vector<TrainingSet> all;
        for (const PatternSet* set : sets) {
            all.push_back({set->name, model_waveforms(*set), *study_of(*set)});
        }
        TrainingParams params;
        params.model = app.work.document.set.model;
        params.units = app.model_bench.training.units;
        params.leave_out_participants = app.model_bench.training.leave_out_participants;
        return *tact::train(all, params);
    }
};

}  // namespace

TEST_CASE(
    "training panel: finds what the search finds; using it is one step that undo takes back") {
    TrainingBench bench;
    App& app = bench.app;
    const PerceptualModelParams before = app.work.document.set.model;
    const Training expected = bench.by_hand({&app.work.document.set});
    bench.train();
    const Training& found = app.model_bench.training.found->training;
    CHECK(found.best.value == expected.best.value);
    CHECK(found.model == expected.model);
    CHECK(found.best.points == expected.best.points);
    CHECK(found.best.value > found.value_before);
    CHECK(std::stod(bench.program.at("train:result").value) ==
          doctest::Approx(expected.best.value).epsilon(0.001));
    CHECK(bench.program.at("button:use trained").value == "enabled");
    for (const char* name : kTrainedNames)
        CHECK(bench.program.shows(std::string("profile:") + name));

    bench.program.click("button:use trained");
    CHECK(app.work.document.set.model == expected.model);
    CHECK(bench.program.at("button:use trained").value == "in use");
    CHECK_FALSE(bench.program.shows("train:stale"));  // the trained numbers alone have changed
    undo(app.ui, app.work);
    CHECK(app.work.document.set.model == before);
    CHECK(app.work.document.history.undo_label() == nullptr);
}

TEST_CASE("training panel: used parameters are kept for choosing, and say where they come from") {
    TrainingBench bench;
    App& app = bench.app;
    bench.train();
    bench.program.click("button:use trained");
    const PerceptualModelParams trained = app.work.document.set.model;
    app.model_bench.panel.view = ModelView::parameters;
    bench.program.settle();
    REQUIRE(kept_models(app.ui, app.work, app.model_bench).size() == 1);
    CHECK(bench.program.at("model:choice").value ==
          kept_models(app.ui, app.work, app.model_bench)[0].name);
    CHECK(bench.program.at("model:provenance")
              .value.starts_with("Trained on planted (6 patterns, 15 pairs, 2 people), "));
    bench.program.click("model:choice");
    bench.program.click("model option:As published");
    CHECK(app.work.document.set.model == PerceptualModelParams{});
    CHECK(bench.program.at("model:choice").value == "As published");
    CHECK_FALSE(bench.program.shows("model:provenance"));
    bench.program.click("model:choice");
    bench.program.click("model option:" + kept_models(app.ui, app.work, app.model_bench)[0].name);
    CHECK(app.work.document.set.model == trained);
    app.work.document.edit().model.nc_weight = 0.123;
    model_changed(app.work);
    bench.program.settle();
    CHECK(bench.program.at("model:choice").value == "Changed by hand");

    // Another run of the program finds them again; the same training is not kept twice.
    Program later(app.work.document.saved);
    later.app.work.session.folder = app.work.session.folder;
    CHECK(kept_models(later.app.ui, later.app.work, later.app.model_bench).size() == 1);
    bench.app.model_bench.panel.view = ModelView::training;
    undo(app.ui, app.work);
    bench.program.settle();
    use_trained(app.ui, app.work, app.model_bench);
    CHECK(kept_models(app.ui, app.work, app.model_bench).size() == 1);
}

TEST_CASE("training panel: saved parameters are those of --model, and load as one step") {
    TrainingBench bench;
    App& app = bench.app;
    bench.train();
    const auto file = bench.folder.path / "mine.model.json";
    save_trained(app.ui, app.model_bench, file);
    const auto read = read_model_file(file);
    REQUIRE(read);
    CHECK(read->model == app.model_bench.training.found->training.model);
    REQUIRE(read->training);
    CHECK(*read->training == app.model_bench.training.found->record);
    CHECK(app.work.document.history.undo_label() == nullptr);
    load_model(app.ui, app.work, app.model_bench, file);
    CHECK(app.work.document.set.model == read->model);
    CHECK(*app.work.document.history.undo_label() == "Use the parameters mine");
    const PerceptualModelParams loaded = app.work.document.set.model;
    load_model(app.ui, app.work, app.model_bench,
               bench.folder.write("odd.json", "{\"tactspace\": 1}"));
    CHECK(app.ui.status.is_error);
    CHECK(app.work.document.set.model == loaded);
}

TEST_CASE("training panel: what was found is stale once the ratings or the patterns change") {
    TrainingBench bench;
    App& app = bench.app;
    bench.train();
    CHECK_FALSE(bench.program.shows("train:stale"));
    const PatternSet before = app.work.document.set;
    app.work.document.edit().ratings[0].condensed[3] += 1.0;
    document_changed(app.work);
    bench.program.settle();
    CHECK(bench.program.shows("train:stale"));
    CHECK(bench.program.at("button:use trained").value == "stale");
    app.work.document.edit() = before;
    document_changed(app.work);
    bench.program.settle();
    CHECK_FALSE(bench.program.shows("train:stale"));
    app.work.document.edit().model.coding.spike_cap = 40;  // a choice that training does not make
    document_changed(app.work);
    bench.program.settle();
    CHECK(bench.program.shows("train:stale"));
}

TEST_CASE("training panel: what was found is stale while another search is chosen") {
    TrainingBench bench;
    bench.train();
    TrainingState& state = bench.app.model_bench.training;
    const auto is_stale = [&] {
        bench.program.settle();
        return bench.program.shows("train:stale");
    };
    const auto check_other = [&](auto& choice, auto other) {
        CHECK_FALSE(is_stale());
        const auto before = std::exchange(choice, other);
        CHECK(is_stale());
        CHECK(bench.program.at("button:use trained").value == "stale");
        choice = before;
        CHECK_FALSE(is_stale());
    };
    check_other(state.units, 20);
    check_other(state.leave_out_participants, !state.leave_out_participants);
    check_other(state.objective, TrainingObjective::mean_absolute_rho);
}

TEST_CASE("training panel: several sets, each of which may be left aside") {
    TrainingBench bench;
    App& app = bench.app;
    const PatternSet other = planted_set(5, "other");
    const auto file = bench.folder.path / "other.tactspace.json";
    REQUIRE(write_set_file(file, other));
    add_training_set(app.ui, app.work, app.model_bench, file);
    bench.program.settle();
    CHECK(bench.program.at("train on:other").value == "on");
    add_training_set(app.ui, app.work, app.model_bench, file);
    CHECK(app.ui.status.is_error);
    CHECK(app.model_bench.training.others.size() == 1);
    const Training expected = bench.by_hand({&app.work.document.set, &other});
    bench.train();
    CHECK(app.model_bench.training.found->training.model == expected.model);
    CHECK(app.model_bench.training.found->training.without_set.size() == 2);
    CHECK(bench.program.shows("trained set:other"));
    bench.program.click("train on:other");
    CHECK(bench.program.shows("train:stale"));
    bench.program.click("train on:planted");
    CHECK(bench.program.at("train on:planted").value == "off");
    CHECK(bench.program.at("train on:other").value == "off");
    CHECK(bench.program.at("button:train").value == "disabled");
    bench.program.click("link:remove other");
    CHECK_FALSE(bench.program.shows("train on:other"));

    PatternSet silent = other;
    silent.ratings.clear();
    const auto unrated = bench.folder.path / "unrated.tactspace.json";
    REQUIRE(write_set_file(unrated, silent));
    add_training_set(app.ui, app.work, app.model_bench, unrated);
    CHECK(app.ui.status.is_error);
    CHECK(app.model_bench.training.others.empty());
}

TEST_CASE("training panel: it says what is missing, and what cannot be fitted to") {
    TrainingBench bench(short_patterns(4));
    App& app = bench.app;
    CHECK(bench.program.shows("button:load ratings"));
    CHECK(bench.program.at("button:train").value == "disabled");
    RatingStudy study{names_of(app.work.document.set), true, {{"P1", {1, 1, 1, 1, 1, 1}}}};
    app.work.document.edit().ratings = kept_ratings(study, "flat.csv");
    document_changed(app.work);
    bench.program.settle();
    bench.program.click("button:train");
    bench.wait_for_training();
    CHECK(app.ui.status.is_error);
    CHECK(app.ui.status.text.ends_with("got the same for every pair"));
    CHECK_FALSE(bench.program.shows("train:result"));
    // One that is gone is left out; of two that stay there is nothing to be learnt.
    app.work.document.edit().ratings[0].labels[0] = "nobody";
    document_changed(app.work);
    bench.program.settle();
    CHECK_FALSE(bench.program.shows("train:fault"));
    CHECK(contains(bench.program.at("train:size").value, "1 rated one is gone"));
    app.work.document.edit().ratings[0].labels[1] = "nobody else";
    document_changed(app.work);
    bench.program.settle();
    CHECK(bench.program.shows("train:fault"));
}

TEST_CASE("training panel: a search is cancelled at once, and what was found before stays") {
    TrainingBench bench;
    App& app = bench.app;
    bench.train();
    const auto found = app.model_bench.training.found;
    app.model_bench.training.units = 20;
    bench.program.settle();
    bench.program.click("button:train");
    REQUIRE(is_training(app.model_bench));
    bench.program.click("link:cancel training");
    const auto asked = std::chrono::steady_clock::now();
    bench.wait_for_training();
    CHECK(std::chrono::steady_clock::now() - asked < std::chrono::seconds(5));
    CHECK(app.model_bench.training.found == found);
    CHECK(bench.program.shows("train:result"));
}

TEST_CASE("training panel: ratings nobody gave are called synthetic") {
    PatternSet set = planted_set(5, "drawn");
    for (Ratings& ratings : set.ratings) ratings.mark.synthetic = true;
    TrainingBench bench(set);
    CHECK(bench.program.shows("train on:drawn, synthetic ratings"));
    bench.train();
    const FoundTraining& found = *bench.app.model_bench.training.found;
    CHECK(bench.program.shows("trained set:drawn, synthetic ratings"));
    CHECK(found.record.sets.front().name == "drawn");
    CHECK(found.record.sets.front().mark.synthetic);
    CHECK(bench.program.at("train:synthetic").value.starts_with("synthetic mean rho"));
}

TEST_CASE("training panel: each person in turn is left out, on request") {
    TrainingBench bench;
    bench.program.click("train:leave out");
    bench.train();
    const Training expected = bench.by_hand({&bench.app.work.document.set});
    REQUIRE(expected.without_participant.size() == 2);
    for (const LeftOut& one : expected.without_participant) {
        const double shown = std::stod(bench.program.at("left out:" + one.name).value);
        CHECK(std::abs(shown - one.rho_after) <= 0.0005 + 1e-9);
    }
}

}  // namespace training_panel_test
