#include "tests/support/scene_steps.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>

#include "app/lesson/lesson.h"
#include "app/study/study.h"
#include "app/subset/subset.h"
#include "app/window/window.h"
#include "tests/support/temporary_folder.h"

namespace tact {

void wait_until(Program& program, const std::function<bool()>& is_so) {
    const auto until = end_of_patience();
    while (!is_so() && std::chrono::steady_clock::now() < until) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        program.frame();
    }
    program.settle();
}

void run(Program& program, std::string_view name) {
    const auto command = std::ranges::find(commands(), name, &Command::name);
    if (command == commands().end()) {
        throw std::invalid_argument("There is no command " + std::string(name) + ".");
    }
    carry_out(program.app, *command);
    program.settle();
    program.settle();
}

void click_if_there(Program& program, const std::string& name) {
    if (!program.shows(name)) return;
    program.click(name);
    program.settle();
}

void right_click(Program& program, const std::string& name) {
    if (!program.shows(name)) return;
    program.hover(program.at(name).middle());
    program.window.button(true, 1);
    program.settle();
    program.window.button(false, 1);
    program.settle();
}

void rest_on(Program& program, const std::string& name) {
    if (!program.shows(name)) return;
    program.hover(program.at(name).middle());
    for (int k = 0; k < 60; ++k) program.frame();
}

void make_fonts(Program& program) {
    ImGui::GetIO().Fonts->Clear();
    make_theme(program.app);
    program.settle();
}

void remake_fonts(Program& program) {
    if (program.app.ui.fonts_outdated) make_fonts(program);
}

void wait_for_lesson(Program& program) {
    wait_until(program, [&] { return answers_of(program.app.lesson) != nullptr; });
    program.wait_for_stages();
}

void open_tour(Program& program) {
    run(program, "Guided tour");
    wait_for_lesson(program);
}

void begin_presenting(Program& program) {
    run(program, "Present");
    make_fonts(program);
    wait_for_lesson(program);
}

void show_bench(Program& program, BenchTab tab) {
    program.app.layout.bench = tab;
    program.settle();
}

void show_subset(Program& program, SubsetView view) {
    program.app.picking.view = view;
    show_bench(program, BenchTab::subset);
    wait_until(program,
               [&] { return program.app.picking.pick && !is_picking(program.app.picking); });
}

void show_compare(Program& program, CompareView view) {
    program.app.comparing.panel.view = view;
    show_bench(program, BenchTab::compare);
}

void show_model(Program& program, ModelView view) {
    program.app.model_bench.panel.view = view;
    show_bench(program, BenchTab::model);
}

void show_dialog(Program& program, Dialog dialog) {
    program.app.ui.dialog = dialog;
    program.settle();
    program.settle();
}

void maximise(Program& program, Pane pane) {
    program.app.layout.maximised = pane;
    program.settle();
}

void wait_for_comparison(Program& program) {
    const Comparing& comparing = program.app.comparing;
    wait_until(program, [&] { return comparing.comparison && !comparing.comparison_job.busy(); });
}

void show_why(Program& program) {
    choose_pair(program.app.work, 0, 1);
    show_bench(program, BenchTab::why);
    const Comparing& comparing = program.app.comparing;
    wait_until(program, [&] { return comparing.difference && !comparing.difference_job.busy(); });
}

void open_people(Program& program, StudyKind kind) {
    // A study is of one set: another one has a folder of its own.
    static std::map<std::string, TemporaryFolder> folders;
    const TemporaryFolder& folder = folders[program.app.work.document.set.name];
    run(program, "Study");
    program.app.studying.kind = kind;
    set_study_folder(program.app.work, program.app.studying, folder.path);
    program.settle();
}

void wait_for_answers(Program& program) {
    const StudyState& studying = program.app.studying;
    wait_until(program, [&studying] {
        return studying.answers && studying.answers->question == studying.asked;
    });
}

void show_answers(Program& program, StudyKind kind, StudyShow show) {
    open_people(program, kind);
    App& app = program.app;
    wait_for_answers(program);
    for (std::size_t k = app.studying.answers->records.size(); k < 3; ++k) {
        simulate_participant(app.ui, app.work, app.shown_map, app.play, app.studying);
    }
    program.settle();
    wait_for_answers(program);
    wait_until(program, [&] { return app.studying.answers->results.has_value(); });
    app.studying.show = show;
    program.settle();
}

void compare_with_people(Program& program) {
    show_answers(program, StudyKind::pairwise, StudyShow::matrix);
    App& app = program.app;
    use_as_ratings(app.ui, app.work, app.layout, app.comparing, app.studying);
    program.wait_for_exact_map();
    wait_until(program, [&app] {
        return app.comparing.comparison && app.comparing.comparison->people.has_value();
    });
}

void show_participant(Program& program, StudyKind kind, StudyPage page) {
    open_people(program, kind);
    App& app = program.app;
    begin_participant(app.ui, app.work, app.timeline, app.play, app.studying);
    program.settle();
    if (!app.studying.run) throw std::runtime_error("The study does not begin.");
    StudyRun& running = *app.studying.run;
    running.page = page;
    if (page == StudyPage::trial) {
        running.trial = running.trials.front();
        running.given.plays_left = running.given.plays_right = 1;
        running.similarity = 62.0;
    } else if (page == StudyPage::sorting) {
        running.asked_groups = 3;
        for (std::size_t k = 0; k < running.record.header.patterns.size(); ++k) {
            running.groups.push_back(k % 4 < 3 ? k % 4 : kUnsorted);
        }
    }
    program.settle();
}

}  // namespace tact
