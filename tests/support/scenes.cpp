#include "tests/support/scenes.h"

#include <unistd.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>
#include <utility>

#include "app/ask/ask.h"
#include "app/lesson/lesson.h"
#include "app/library/library.h"
#include "app/map/map.h"
#include "app/planning/planning.h"
#include "app/sounds/sounds.h"
#include "app/study/study.h"
#include "app/subset/subset.h"
#include "app/tables/tables.h"
#include "app/wave_strip/wave_strip.h"
#include "app/window/window.h"
#include "model/io/recordings/wave_file.h"
#include "model/io/set/set_file.h"
#include "model/set/measured_twin.h"
#include "tests/support/places.h"
#include "tests/support/scene_steps.h"
#include "tests/support/temporary_folder.h"

namespace tact {

namespace {

PatternSet twelve_with_long_names(double duration_s, const std::string& sign) {
    const auto loaded =
        read_set_file(std::string(kAssetsDir) + "/sets/pm_2023_twelve.tactspace.json");
    PatternSet set = loaded ? loaded->set : PatternSet{};
    set.name =
        "Twelve " + sign + "patterns, under a name that is rather longer than it would have to be";
    if (set.vibrations.size() < 12) return set;
    set.duration_s = duration_s;
    for (Vibration& one : set.vibrations) {
        std::get<Pattern>(one.source) = with_duration(std::get<Pattern>(one.source), duration_s);
    }
    set.vibrations[1].name = "an " + sign + "alarm that comes in waves and does not stop";
    set.vibrations[7].name = "a " + sign + "slow heartbeat under a rising tone, second take";
    set.vibrations[2].locked = true;
    set.vibrations[4].dropped = true;
    return set;
}

// Beside a file that cannot be read.
void show_library_of_twelve(Program& p, bool like) {
    const TemporaryFolder folder;
    (void)write_set_file(folder.path / "twelve.tactspace.json", twelve_with_long_names(0.2, ""));
    folder.write("broken.ahap", "{");
    p.app.library = LibraryState{};  // of the scene before
    show_bench(p, BenchTab::library);
    show_library(p.app.ui, p.app.library, folder.path);
    wait_until(p, [&] {
        const ShownLibrary& shown = p.app.library.library;
        return shown && shown->folder == folder.path && !is_library_busy(p.app.library);
    });
    if (like) {
        p.app.library.target = "android-xml";
        find_alike(p.app.ui, p.app.work, p.app.library, p.app.work.document.set.vibrations[5]);
        wait_until(p, [&p] { return p.app.library.alike != nullptr; });
    }
    p.settle();
}

// Notes of unequal strength over a sweep, with ticks, and the drawing in sight whatever the size.
void draw_in_strip(Program& p, StripTool tool) {
    auto& pattern = std::get<Pattern>(p.app.work.document.edit().vibrations[0].source);
    pattern.rhythm = {"x===-7==--5=====", pattern.duration_s / 16.0};
    pattern.amplitude_curve = {
        {0.0, 0.4}, {0.5 * pattern.duration_s, 1.0}, {pattern.duration_s, 0.7}};
    pattern.frequency_curve = {{0.0, 60.0}, {pattern.duration_s, 250.0}};
    pattern.transients = {{0.3 * pattern.duration_s, 1.2, 180.0, 0.01},
                          {0.7 * pattern.duration_s, 0.9, 180.0, 0.01}};
    p.app.pattern_panes.strip.tool = tool;
    p.app.pattern_panes.editor.tab = EditorTab::drawing;
    document_changed(p.app.work);
    // While it is being computed a picture of it would be of another moment.
    wait_until(p, [&p] { return map_state(p.app.work, p.app.shown_map) == MapState::exact; });
    p.settle();
}

// One vibration, modulated or not, in the place of the first, with measured facts over its stages.
void show_with_textbook(Program& p, double frequency_hz, double modulated_hz,
                        std::optional<Stage> stage) {
    run(p, "Physiology");
    Pattern& pattern = std::get<Pattern>(p.app.work.document.edit().vibrations[0].source);
    pattern.carriers = {{.frequency_hz = frequency_hz}};
    pattern.modulation = {.frequency_hz = modulated_hz};
    pattern.amplitude_g = 0.8;
    ++p.app.work.revision;
    p.app.physiology.view.textbook = true;
    p.settle();
    p.wait_for_stages();
    p.app.physiology.view.open = stage;
    p.settle();
}

void add_textbook(std::vector<Scene>& all) {
    const auto add = [&all](double frequency_hz, double modulated_hz, std::optional<Stage> stage) {
        const std::string what = stage ? std::string("stage ") + text_of(*stage).key : "all stages";
        const std::string how = modulated_hz > 0.0 ? " modulated" : "";
        all.push_back(
            {"textbook, " + std::to_string(static_cast<int>(frequency_hz)) + " Hz" + how + ", " +
                 what,
             [=](Program& p) { show_with_textbook(p, frequency_hz, modulated_hz, stage); }});
    };
    add(30.0, 0.0, std::nullopt);
    for (const Stage stage : {Stage::spectrum, Stage::receptors, Stage::spikes, Stage::networks,
                              Stage::central, Stage::brain}) {
        add(30.0, 0.0, stage);
    }
    add(100.0, 0.0, Stage::receptors);
    add(100.0, 0.0, Stage::spikes);
    add(150.0, 5.0, std::nullopt);
    add(150.0, 5.0, Stage::spikes);
    all.push_back({"textbook, a pair's brain", [](Program& p) {
                       show_with_textbook(p, 30.0, 0.0, Stage::brain);
                       p.app.work.selection.pinned = "H-0-full";
                       p.settle();
                       p.wait_for_stages();
                   }});
    all.push_back({"textbook, explained", [](Program& p) {
                       show_with_textbook(p, 30.0, 0.0, Stage::receptors);
                       p.app.physiology.view.explained = Stage::receptors;
                       p.settle();
                   }});
}

// A beat under a bed, late ticks that are open, and a layer that is mute.
void draw_layers(Program& p) {
    draw_in_strip(p, StripTool::ticks);
    Vibration& vibration = p.app.work.document.edit().vibrations[0];
    Pattern beat = std::get<Pattern>(vibration.source);
    beat.transients.clear();
    Pattern bed;
    bed.amplitude_g = 0.3;
    bed.attack_s = 0.3 * beat.duration_s;
    bed.duration_s = beat.duration_s;
    Pattern ticks;
    ticks.amplitude_g = 0.0;
    ticks.duration_s = 0.7 * beat.duration_s;
    ticks.transients = {{0.1 * beat.duration_s, 1.2, 180.0, 0.01},
                        {0.5 * beat.duration_s, 0.9, 180.0, 0.01}};
    LayeredPattern layered{{{"bed", bed}, {"beat", beat, 0.6}, {"ticks", ticks}, {"hum", bed}}};
    layered.layers[2].offset_s = 0.2 * beat.duration_s;
    layered.layers[3].mute = true;
    vibration.source = layered;
    choose_layer(p.app.work, 2);
    p.app.pattern_panes.layers.is_folded = false;
    document_changed(p.app.work);
    wait_until(p, [&p] { return map_state(p.app.work, p.app.shown_map) == MapState::exact; });
    p.settle();
}

void add_arrangements(std::vector<Scene>& all) {
    all.push_back({"design", [](Program&) {}});
    all.push_back({"editor, notes", [](Program& p) { draw_in_strip(p, StripTool::notes); }});
    all.push_back({"editor, notes chosen", [](Program& p) {
                       draw_in_strip(p, StripTool::notes);
                       p.press('n', false);
                       p.press('a', true);
                   }});
    all.push_back({"editor, pitches and bars", [](Program& p) {
                       draw_in_strip(p, StripTool::notes);
                       edit_patterns(p.app.work, [](Pattern& pattern) {
                           pattern.rhythm = {"A=B-C==-",
                                             pattern.duration_s / 16.0,
                                             {{'A', {0.6, 0.6}}, {'C', {0.85, 1.5}}},
                                             {2, 4}};
                       });
                       commit_step(p.app.ui, p.app.work, "rhythm");
                       p.settle();
                       p.press('n', false);
                   }});
    all.push_back({"editor, layers", [](Program& p) { draw_layers(p); }});
    all.push_back({"editor, layers as there is room", [](Program& p) {
                       draw_layers(p);
                       p.app.pattern_panes.layers.is_folded.reset();
                       p.settle();
                   }});
    all.push_back({"editor, over a recording", [](Program& p) {
                       draw_in_strip(p, StripTool::curves);
                       PatternSet& set = p.app.work.document.edit();
                       Waveform wave = waveform_of(set.vibrations[2]);
                       Vibration twin;
                       twin.name = set.vibrations[0].name + " measured";
                       twin.source = Measurement{std::make_shared<const Waveform>(std::move(wave)),
                                                 {},
                                                 1.0,
                                                 set.vibrations[0].name};
                       insert_twin(set, twin);
                       document_changed(p.app.work);
                       p.wait_for_exact_map();
                       p.settle();
                   }});
    all.push_back({"editor, a tick", [](Program& p) {
                       draw_in_strip(p, StripTool::ticks);
                       choose_next(p.app.ui, p.app.work, p.app.pattern_panes.strip, 1);
                       choose_next(p.app.ui, p.app.work, p.app.pattern_panes.strip, 1);
                       p.settle();
                   }});
    all.push_back({"design, stages open", [](Program& p) {
                       p.app.layout.physiology = Fold::open;
                       p.wait_for_stages();
                   }});
    all.push_back({"select", [](Program& p) {
                       run(p, "Select");
                       wait_until(
                           p, [&p] { return p.app.picking.pick && !is_picking(p.app.picking); });
                   }});
    all.push_back({"physiology", [](Program& p) {
                       run(p, "Physiology");
                       p.wait_for_stages();
                   }});
    const auto show_pair = [](Program& p) {
        run(p, "Physiology");
        p.app.work.selection.pinned = "H-4-full";
        p.settle();
        p.wait_for_stages();
    };
    all.push_back({"physiology of a pair", show_pair});
    for (const Stage stage : {Stage::receptors, Stage::networks, Stage::central}) {
        all.push_back({"pair in stage " + std::to_string(static_cast<int>(stage)),
                       [show_pair, stage](Program& p) {
                           show_pair(p);
                           p.app.physiology.view.open = stage;
                           p.settle();
                       }});
    }
    for (const Stage stage : kStages) {
        all.push_back({"stage " + std::to_string(static_cast<int>(stage)), [stage](Program& p) {
                           run(p, "Physiology");
                           p.wait_for_stages();
                           p.app.physiology.view.open = stage;
                           p.settle();
                       }});
    }
    add_textbook(all);
    all.push_back({"lesson", open_tour});
    all.push_back({"lesson at the foot", [](Program& p) {
                       open_tour(p);
                       click_if_there(p, "lesson:move");
                   }});
    all.push_back({"lesson, written", [](Program& p) {
                       run(p, "New lesson from this set");
                       p.wait_for_stages();
                   }});
    all.push_back({"study, pairs", [](Program& p) {
                       run(p, "Study");
                       p.app.studying.kind = StudyKind::pairwise;
                       p.settle();
                       wait_for_answers(p);
                   }});
    all.push_back({"study, sorting", [](Program& p) {
                       run(p, "Study");
                       p.app.studying.kind = StudyKind::sorting;
                       p.settle();
                       wait_for_answers(p);
                   }});
    all.push_back({"present", begin_presenting});
    all.push_back({"present, a lesson", [](Program& p) {
                       open_tour(p);
                       begin_presenting(p);
                   }});
    all.push_back({"dialog, course", [](Program& p) {
                       run(p, "Course of all lessons");
                       p.app.course.student = "Ada";
                       p.app.course.progress["Ada"][p.app.course.lessons[0].key] = {
                           3, 18, {{2, {"Who fires?", "Meissner", true, ""}}}};
                       p.settle();
                   }});
    all.push_back({"lesson, written in two languages", [](Program& p) {
                       run(p, "New lesson from this set");
                       add_language(lesson_context(p.app), p.app.lesson, "de");
                       wait_for_lesson(p);
                   }});
    all.push_back({"study, results as a matrix",
                   [](Program& p) { show_answers(p, StudyKind::pairwise, StudyShow::matrix); },
                   true});
    all.push_back({"study, results as a map",
                   [](Program& p) { show_answers(p, StudyKind::pairwise, StudyShow::map); }, true});
    for (const auto& [page, name] : {std::pair{StudyPage::consent, "consent"},
                                     {StudyPage::instructions, "instructions"},
                                     {StudyPage::training, "training"},
                                     {StudyPage::trial, "trial"},
                                     {StudyPage::rest, "break"}}) {
        all.push_back({std::string("participant, ") + name,
                       [page](Program& p) { show_participant(p, StudyKind::pairwise, page); }});
    }
    all.push_back({"participant, sorting", [](Program& p) {
                       show_participant(p, StudyKind::sorting, StudyPage::sorting);
                   }});
    all.push_back({"participant, paused", [](Program& p) {
                       show_participant(p, StudyKind::pairwise, StudyPage::trial);
                       p.press_key(key::kEscape);
                   }});
    all.push_back({"maximised patterns", [](Program& p) { maximise(p, Pane::patterns); }});
    all.push_back({"maximised editor", [](Program& p) { maximise(p, Pane::editor); }});
    all.push_back({"maximised space", [](Program& p) { maximise(p, Pane::space); }});
    all.push_back({"maximised matrix", [](Program& p) { maximise(p, Pane::matrix); }});
    all.push_back({"maximised subset", [](Program& p) {
                       show_subset(p, SubsetView::pick);
                       maximise(p, Pane::matrix);
                   }});
    all.push_back({"maximised compare",
                   [](Program& p) {
                       show_compare(p, CompareView::table);
                       wait_for_comparison(p);
                       maximise(p, Pane::matrix);
                   },
                   true});
    all.push_back({"maximised why", [](Program& p) {
                       show_why(p);
                       maximise(p, Pane::matrix);
                   }});
}

// A tab with what it computes, in the view that it begins with.
void show_with_answer(Program& p, BenchTab tab) {
    if (tab == BenchTab::subset) return show_subset(p, SubsetView::pick);
    if (tab == BenchTab::why) return show_why(p);
    if (tab == BenchTab::model) return show_model(p, ModelView::parameters);
    if (tab == BenchTab::library) return show_library_of_twelve(p, false);
    if (tab == BenchTab::compare) {
        show_compare(p, CompareView::table);
        return wait_for_comparison(p);
    }
    show_bench(p, tab);
    if (tab != BenchTab::device) return;
    wait_until(p, [&p] { return p.app.rendered.shown != nullptr; });
}

void add_bench(std::vector<Scene>& all) {
    for (const BenchRow& row : kBenchTabs) {
        all.push_back({row.key, [tab = row.tab](Program& p) { show_with_answer(p, tab); }});
    }
    all.push_back({"too close", [](Program& p) { show_subset(p, SubsetView::confusable); }});
    all.push_back({"how sure", [](Program& p) { show_subset(p, SubsetView::stability); }});
    all.push_back({"groups", [](Program& p) {
                       show_subset(p, SubsetView::groups);
                       wait_until(p, [&] { return p.app.picking.groups != nullptr; });
                   }});
    all.push_back({"too close, a pair", [](Program& p) {
                       p.app.picking.too_close = TooClose::share;
                       show_subset(p, SubsetView::confusable);
                       open_pair(p.app.work, p.app.picking, "H-0-half", "H-0-full");
                       p.settle();
                   }});
    all.push_back({"compare with people", [](Program& p) { compare_with_people(p); }, true});
    all.push_back({"compare, pairs with people",
                   [](Program& p) {
                       compare_with_people(p);
                       show_compare(p, CompareView::scatter);
                   },
                   true});
    all.push_back({"compare, scatter",
                   [](Program& p) {
                       show_compare(p, CompareView::scatter);
                       wait_for_comparison(p);
                   },
                   true});
    all.push_back({"compare, findings", [](Program& p) {
                       p.app.comparing.findings.reset();
                       show_compare(p, CompareView::findings);
                   }});
    all.push_back({"compare, findings checked",
                   [](Program& p) {
                       show_compare(p, CompareView::findings);
                       click_if_there(p, "button:check findings");
                       wait_until(p, [&p] {
                           return p.app.comparing.findings && !p.app.comparing.findings_job.busy();
                       });
                   },
                   true});
    all.push_back({"library, none", [](Program& p) {
                       p.app.library = LibraryState{};
                       show_bench(p, BenchTab::library);
                       p.settle();
                   }});
    all.push_back({"library, like a pattern", [](Program& p) { show_library_of_twelve(p, true); }});
    all.push_back({"training", [](Program& p) { show_model(p, ModelView::training); }});
    all.push_back({"maximised device", [](Program& p) {
                       show_with_answer(p, BenchTab::device);
                       maximise(p, Pane::matrix);
                   }});
}

void add_states(std::vector<Scene>& all) {
    all.push_back({"empty set", [](Program& p) {
                       run(p, "New set");
                       p.settle();
                   }});
    all.push_back({"three selected", [](Program& p) {
                       select_only(p.app.work, 0);
                       toggle_selected(p.app.work, 3);
                       toggle_selected(p.app.work, 5);
                       p.settle();
                   }});
    all.push_back({"four selected in the matrix", [](Program& p) {
                       select_only(p.app.work, 1);
                       for (const std::size_t more : {2, 6, 9}) toggle_selected(p.app.work, more);
                       show_bench(p, BenchTab::matrix);
                   }});
    all.push_back({"locked", [](Program& p) {
                       select_only(p.app.work, 2);
                       p.settle();
                   }});
    all.push_back({"a search without a find", [](Program& p) {
                       p.app.work.selection.search = "nothing of the kind";
                       p.settle();
                   }});
    all.push_back({"a map of an earlier state", [](Program& p) {
                       p.app.shown_map.cancelled = true;
                       auto& first = p.app.work.document.edit().vibrations.front();
                       std::get<Pattern>(first.source).amplitude_g *= 2.0;
                       ++p.app.work.revision;
                       for (int k = 0; k < 25; ++k) p.frame();  // what is behind for 0.3 s looks it
                   }});
    all.push_back({"an error", [](Program& p) {
                       complain(p.app.ui,
                                "alarm.tactspace.json, line 12: \"amplitude_g\" is a word; a "
                                "number from 0 to 50 was expected.");
                       p.settle();
                   }});
}

void add_dialogs(std::vector<Scene>& all) {
    constexpr auto kDialogs = std::to_array<std::pair<const char*, const char*>>(
        {{"about", "About tactspace"},
         {"keys", "Keys and mouse"},
         {"palette", "Command palette"},
         {"open", "Open..."},
         {"save as", "Save as..."},
         {"export view", "Export view..."},
         {"export animation", "Export animation..."},
         {"export vibrations", "Export vibrations..."},
         {"paper", "Paper..."},
         {"plan", "Plan the study..."},
         {"generate", "Generate candidates..."},
         {"steps", "Steps between..."},
         {"transform", "Transform..."},
         {"tap a rhythm", "Tap a rhythm..."},
         {"simulate measurement", "Simulate measurement..."},
         {"import recordings", "Import recordings..."},
         {"actuator maps", "Actuator maps..."},
         {"devices", "Devices..."},
         {"phones", "Phones..."},
         {"save workspace", "Save workspace as..."}});
    for (const auto& [name, command] : kDialogs) {
        all.push_back({std::string("dialog, ") + name, [command](Program& p) { run(p, command); }});
    }
    for (const auto& [name, because] :
         {std::pair{"dialog, leave out", ""}, {"dialog, leave out with a reason", "wore gloves"}}) {
        all.push_back({name,
                       [because](Program& p) {
                           show_answers(p, StudyKind::pairwise, StudyShow::matrix);
                           ask_to_leave_out(
                               p.app.ui, p.app.studying,
                               p.app.studying.answers->records.front().header.participant.code);
                           p.app.studying.leaving_out.because = because;
                           p.settle();
                           p.settle();
                       },
                       true});
    }
    all.push_back({"dialog, all conduct rules", [](Program& p) {
                       ConductRule& rule = p.app.studying.rule.who.conduct;
                       rule.fast_below_s = 1.0;
                       rule.repeat_rho = 0.3;
                       rule.replays = 5.0;
                       show_dialog(p, kConductDialog);
                   }});
    all.push_back({"dialog, plan with an answer", [](Program& p) {
                       PlanChoice& choice = p.app.planning.choice;
                       choice.first = 4;
                       choice.last = 9;
                       choice.all_patterns = choice.all_pairs = false;
                       choice.decide = 5;
                       choice.pairs = 8;
                       simulate_plan(p.app.ui, p.app.work, p.app.planning);
                       wait_until(p, [&p] { return !is_planning(p.app.planning); });
                       run(p, "Plan the study...");
                   }});
    all.push_back({"dialog, open table", [](Program& p) {
                       const auto file = std::filesystem::temp_directory_path() /
                                         ("open table " + std::to_string(::getpid()) + ".csv");
                       std::ofstream(file) << "trial,left,right,how far,who\n1,p1,p2,30,S1\n"
                                              "2,p1,p3,80,S1\n";
                       open_table(p.app.ui, p.app.work, p.app.table, file);
                       wait_until(p, [&p] { return p.app.table.answer != nullptr; });
                       p.settle();
                       std::filesystem::remove(file);
                   }});
    all.push_back({"dialog, from sound", [](Program& p) {
                       const auto file = std::filesystem::temp_directory_path() /
                                         ("a sound " + std::to_string(::getpid()) + ".wav");
                       Pattern pattern;
                       pattern.rhythm = {"x=-x=---", 0.1};
                       pattern.transients = {{0.62, 0.7, 120.0, 0.03}};
                       (void)write_wave_file(file, render(pattern));
                       open_sounds(p.app.ui, p.app.work, p.app.sounds, {file});
                       wait_until(p, [&p] {
                           const auto made = current_sounds(p.app.sounds);
                           return made && made->request.with_pm;
                       });
                       p.settle();
                       std::filesystem::remove(file);
                   }});
    constexpr auto kOthers =
        std::to_array<std::pair<const char*, Dialog>>({{"calibrate", kCalibrateDialog},
                                                       {"import", kImportDialog},
                                                       {"conduct rules", kConductDialog}});
    all.push_back({"dialog, question", [](Program& p) {
                       ask(p.app.ui,
                           {.title = "Save the changes?",
                            .text = "\"Twelve patterns\" has changes that are in no file yet.",
                            .answers = {{"Save"}, {"Do not save"}, {"Cancel"}}});
                       p.settle();
                   }});
    for (const auto& [name, dialog] : kOthers) {
        all.push_back({std::string("dialog, ") + name,
                       [which = dialog](Program& p) { show_dialog(p, which); }});
    }
}

void add_menus(std::vector<Scene>& all) {
    all.push_back({"dialog, pad", [](Program& p) {
                       for (const std::size_t more : {1, 3}) toggle_selected(p.app.work, more);
                       run(p, "Mix on a pad...");
                   }});
    for (const char* menu : {"File", "Edit", "View", "Play", "Study", "Lesson", "Help"}) {
        all.push_back({std::string("menu ") + menu,
                       [menu](Program& p) { click_if_there(p, std::string("menu:") + menu); }});
    }
    all.push_back({"menu of the history", [](Program& p) {
                       for (const char* wave : {"Copy", "Paste", "Duplicate"}) run(p, wave);
                       click_if_there(p, "menu:Edit");
                       click_if_there(p, "menu:History");
                   }});
    all.push_back({"menu of examples", [](Program& p) {
                       click_if_there(p, "menu:File");
                       click_if_there(p, std::string("menu:") + kExampleMenu);
                   }});
    all.push_back({"menu of a row", [](Program& p) { right_click(p, "row name:L-0-half"); }});
    all.push_back({"menu of looks", [](Program& p) {
                       right_click(p, "row name:L-0-half");
                       click_if_there(p, "row menu:Colour and mark");
                   }});
    all.push_back({"menu of a member", [](Program& p) {
                       show_subset(p, SubsetView::pick);
                       right_click(p, "member:L-4-half");
                   }});
    all.push_back({"menu of a point", [](Program& p) { right_click(p, "point:L-0-half"); }});
    for (const char* pane : {"Patterns", "Editor", "Perceptual space", "Matrix"}) {
        all.push_back({std::string("menu of the pane ") + pane,
                       [pane](Program& p) { right_click(p, std::string("title:") + pane); }});
    }
    all.push_back({"menu of devices", [](Program& p) { click_if_there(p, "device"); }});
    all.push_back(
        {"popup look of the map", [](Program& p) { click_if_there(p, "link:map look"); }});
    all.push_back({"popup rhythms", [](Program& p) {
                       maximise(p, Pane::editor);
                       click_if_there(p, "link:rhythms");
                   }});
    all.push_back({"popup compare with", [](Program& p) {
                       run(p, "Physiology");
                       click_if_there(p, "compare with");
                   }});
    all.push_back({"popup free numbers", [](Program& p) {
                       run(p, "Vary");
                       click_if_there(p, "link:free numbers");
                   }});
    all.push_back({"tooltip of a locked pattern", [](Program& p) {
                       select_only(p.app.work, 2);
                       p.settle();
                       rest_on(p, "link:add carrier");
                   }});
    for (const char* thing :
         {"transport:play", "field label:amplitude_g", "button:duplicate", "workspace:Select"}) {
        all.push_back(
            {std::string("tooltip of ") + thing, [thing](Program& p) { rest_on(p, thing); }});
    }
}

std::vector<Scene> make_scenes() {
    std::vector<Scene> all;
    add_arrangements(all);
    add_bench(all);
    add_states(all);
    add_dialogs(all);
    add_menus(all);
    return all;
}

}  // namespace

SceneWindow::SceneWindow(double duration_s, const std::string& sign)
    : Program(twelve_with_long_names(duration_s, sign)) {
    app.ui.motion = false;
    compute_map();
    settle();  // how the map lies is part of the document
    document_ = app.work.document.kept();
}

void SceneWindow::leave_presentation() {
    const bool was_larger = app.lesson.presenting;
    leave_lesson(lesson_context(app), app.lesson);
    app.lesson.present_scale = kPresentScale;
    if (was_larger) make_fonts(*this);
}

void SceneWindow::resize(ImVec2 size, float scale) {
    leave_presentation();
    Program::resize(size, scale);
}

void SceneWindow::show(const Scene& scene) {
    leave_presentation();
    for (int k = 0; k < 3; ++k) press_key(key::kEscape);
    app.ui.dialog = kNoDialog;
    app.ui.question.reset();
    app.ui.chooser.is_open = false;
    app.palette.open = false;
    app.lesson.dock = DockSide::right;
    app.lesson.language.clear();
    app.course = {};
    close_study(app.studying);
    app.studying.run.reset();
    app.studying.log.reset();
    app.studying.folder = {};
    app.studying.leaving_out = {};
    app.studying.rule = {};
    app.layout = first_layout(Arrangement::design);
    app.workspaces = {};
    app.picking.view = SubsetView::pick;
    app.picking.too_close = SubsetState{}.too_close;
    app.picking.opened.reset();
    app.pattern_panes.strip = {};
    app.pattern_panes.editor.tab = {};
    app.physiology.view.open.reset();
    app.physiology.view.textbook = false;
    app.physiology.view.explained.reset();
    app.work.selection.pinned.clear();
    app.ui.status = {};
    app.shown_map.cancelled = false;
    app.work.selection.search.clear();
    select_only(app.work, 0);
    const bool is_another = !(app.work.document.set == document_.set);
    app.work.document.open(document_);
    if (is_another) {
        ++app.work.revision;
        request_maps(app.ui, app.work, app.shown_map, app.rendered);
    }
    window.move({-100.0F, -100.0F});
    wait_for_exact_map();
    wait_for_stages();  // of the scene before they may still be on screen
    remake_fonts(*this);
    scene.show(*this);
    // What the map is asked is told by a preview first, in longer words. If a scene shows work
    // under way, that continues behind it.
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(5);
    while (is_asking(app.proposals) && std::chrono::steady_clock::now() < until) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        frame();
    }
    remake_fonts(*this);
}

const std::vector<Scene>& scenes() {
    static const std::vector<Scene> all = make_scenes();
    return all;
}

}  // namespace tact
