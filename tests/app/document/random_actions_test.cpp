// Random actions of a person, and the laws that a document keeps whatever was done to it: every
// state is undone and done again, the mark tells whether the file differs, a kill at any frame
// loses a second at most, what is saved is what opens, and the window's matrix is the command
// line's.
//
// A walk that breaks a law is made shorter as long as it breaks one, and told as its actions.
// TACTSPACE_ACTIONS and TACTSPACE_SEED walk longer, or elsewhere.
#include <doctest/doctest.h>

#include <cstdlib>
#include <deque>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "app/ask/ask.h"
#include "app/document/editing.h"
#include "app/generate/generate.h"
#include "app/opening/opening.h"
#include "app/session/session.h"
#include "app/subset/subset.h"
#include "app/window/window.h"

#include "model/io/set/load.h"
#include "model/io/set/set_file.h"
#include "tests/support/program.h"
#include "tests/support/scene_steps.h"
#include "tests/support/temporary_folder.h"

namespace random_actions_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

// What is drawn at random of an action; the walk before it decides what it comes to.
struct Action {
    unsigned kind = 0, which = 0, value = 0;
};
using Walk = std::vector<Action>;

struct Broken {
    std::string law;
};

void law(bool holds, const std::string& what) {
    if (!holds) throw Broken{what};
}

PatternSet without_places(PatternSet set) {
    set.map_places = {};
    return set;
}

std::string printed(const PatternSet& set) { return print_set(without_places(set)); }

class Person {
  public:
    Person() : program_(short_patterns(4)) {
        App& app = program_.app;
        app.work.session = open_session(folder_.path / "state");
        begin_jobs(app);
        request_maps(app.ui, app.work, app.shown_map, app.rendered);
        save_as(app.ui, app.work, folder_.path / "walk.tactspace.json");
        files_.push_back(app.work.document.path);
        program_.settle();
        begin();
        program_.after_frame = [this] {
            note_time();
            check_kill();
        };
    }
    ~Person() {
        program_.after_frame = {};
        wait_for_autosave(program_.app.work);
        (void)close_session(program_.app.work.session);
    }
    Person(const Person&) = delete;
    Person& operator=(const Person&) = delete;

    void act(const Action& action) {
        const Done& done = kDone[action.kind % kDone.size()];
        is_time_travel_ = false;
        (this->*done.act)(action);
        program_.settle();
        look();
    }

    // Every state backwards and forwards, the file, what opens of it, and the matrix.
    void check_all() {
        App& app = program_.app;
        const std::size_t last = app.work.document.history.done();
        for (std::size_t k = last; k-- > 0;) {
            undo(app.ui, app.work);
            law(printed(app.work.document.set) == states_[k], "undo gives another state");
        }
        law(app.work.document.history.undo_label() == nullptr,
            "there is more to undo than was done");
        for (std::size_t k = 1; k < states_.size(); ++k) {
            redo(app.ui, app.work);
            law(printed(app.work.document.set) == states_[k], "redo gives another state");
        }
        for (std::size_t k = states_.size() - 1; k > last; --k) undo(app.ui, app.work);
        program_.settle();
        look_around();
        save(app.ui, app.work);
        program_.settle();
        law(!app.ui.status.is_error, "a save fails: " + app.ui.status.text);
        look_around();
        const auto opened = load_set(app.work.document.path);
        law(static_cast<bool>(opened), "what was saved does not open");
        law(opened->set == app.work.document.set, "what opens is not what was saved");
        check_matrix(opened->set);
    }

    static std::string name_of(const Action& action) {
        return kDone[action.kind % kDone.size()].name;
    }

  private:
    struct Done {
        const char* name;
        void (Person::*act)(const Action&);
    };
    static const std::vector<Done> kDone;

    Workspace& work() { return program_.app.work; }
    Ui& ui() { return program_.app.ui; }
    std::size_t count() { return work().document.set.vibrations.size(); }
    std::size_t row(unsigned which) { return which % count(); }

    void select(const Action& action) {
        if (count() > 0) select_only(work(), row(action.which));
    }
    void select_two(const Action& action) {
        if (count() > 0) toggle_selected(work(), row(action.which));
    }
    void add(const Action&) {
        if (count() < 8) add_pattern(ui(), work());
    }
    void twice(const Action&) {
        if (count() < 8) duplicate_selected(ui(), work());
    }
    void remove(const Action&) {
        if (count() > selected_indices(work()).size() + 1) remove_selected(ui(), work());
    }
    void reorder(const Action& action) {
        if (count() > 1) move_vibration(ui(), work(), row(action.which), row(action.value));
    }
    void rename(const Action& action) {
        static constexpr const char* kNames[] = {"n", "ü", "a b ", "q\"", "<b>", "z,", "=1+"};
        if (count() == 0) return;
        rename_vibration(ui(), work(), row(action.which),
                         kNames[action.value % 7] + std::to_string(action.value % 100));
    }
    void lock(const Action&) {
        if (count() > 0) toggle_locked(ui(), work());
    }
    void drop(const Action&) {
        if (count() > 0) toggle_dropped(ui(), work());
    }
    void colour(const Action& action) {
        static constexpr const char* kColours[] = {"#112233", "#AA0000", "#00FF7F"};
        if (count() > 0)
            change_look(ui(), work(), kColours[action.value % 3], action.value % 2 == 0);
    }
    void generate(const Action& action) {
        App& app = program_.app;
        if (count() == 0 || count() > 4 || editable_pattern(current()) == nullptr) return;
        DesignSpace space = space_around(std::get<Pattern>(current().source));
        space.amplitude_g = std::vector<double>{0.5, 1.0};
        const auto set = std::make_shared<const PatternSet>(work().document.set);
        const auto plan = plan_of({space, set}, {});
        if (!plan || !plan->fault.empty()) return;
        const bool replaces = action.value % 2 == 0 && plan->generated_before > 0;
        add_candidates(ui(), work(), app.generating, *plan,
                       replaces ? Before::replaced : Before::kept);
    }
    void mix(const Action& action) {
        if (count() < 2 || count() > 7) return;
        select_only(work(), row(action.which));
        select_all(work());
        if (pad_corners(work()).size() < 2) return;
        open_pad(ui(), work(), program_.app.pad);
        program_.settle();
        program_.press_key(action.value % 4 == 0 ? key::kEscape : key::kEnter);
    }
    void vary_one(const Action& action) {
        App& app = program_.app;
        if (!can_vary(work())) return;
        wait_for_map();
        vary(ui(), work(), app.proposals);
        wait_for([&app] { return found_variants(app.proposals) || !is_asking(app.proposals); });
        if (const auto found = found_variants(app.proposals); found && !found->patterns.empty()) {
            take_variant(ui(), work(), app.proposals, action.value % found->patterns.size());
        }
        stop_varying(app.proposals);
    }
    void put_steps_between(const Action& action) {
        App& app = program_.app;
        if (count() < 2 || count() > 5) return;
        const auto name = [this](unsigned which) {
            return work().document.set.vibrations[row(which)].name;
        };
        open_steps(ui(), work(), app.steps, name(action.which), name(action.which + 1));
        app.steps.count = 3;
        program_.frame();
        if (steps_obstacle(work(), app.steps).empty()) {
            wait_for([this, &app] {
                return current_steps(work(), app.steps) || !is_placing(app.steps);
            });
            const auto found = current_steps(work(), app.steps);
            if (found) add_steps(ui(), work(), app.steps, *found);
        }
        ui().dialog = kNoDialog;
    }
    void separate(const Action& action) {
        if (count() == 0) return;
        const std::size_t place = row(action.which);
        const Vibration& one = work().document.set.vibrations[place];
        if (editable_pattern(one) == nullptr) return;
        Separation change;
        change.from = std::get<Pattern>(one.source).amplitude_g;
        change.to = 0.1 + 0.1 * static_cast<double>(action.value % 20);
        apply_separation(ui(), work(), place, change);
    }
    void copy(const Action&) { program_.press('c', true); }
    void paste(const Action&) {
        if (count() < 8) program_.press('v', true);
    }
    void take_back(const Action&) {
        is_time_travel_ = true;
        program_.press('z', true);
    }
    void do_again(const Action&) {
        is_time_travel_ = true;
        program_.press('z', true, true);
    }
    void type_number(const Action& action) {
        static constexpr const char* kTyped[] = {"0",          "1",  "0.05", "60",   "149.5",
                                                 "+10%",       "*2", "-3dB", "1e-3", "99999",
                                                 "12.3456789", "-1", "abc",  "/3"};
        std::vector<std::string> fields;
        for (const auto& [name, place] : program_.places) {
            const bool is_seen = place.max.y < 960.0F && place.min.y > 30.0F;
            if (name.starts_with("entry:") && name != "entry:duration_s" && is_seen)
                fields.push_back(name);
        }
        if (fields.empty()) return;
        program_.click(fields[action.which % fields.size()]);
        program_.type(kTyped[action.value % 14]);
        program_.press_key(action.value % 5 == 0 ? key::kEscape : key::kEnter);
    }
    void slide(const Action& action) {
        std::vector<std::string> bars;
        for (const auto& [name, place] : program_.places) {
            const bool is_seen = place.max.y < 960.0F && place.min.y > 30.0F;
            if (name.starts_with("slider:") && name != "slider:duration_s" && is_seen)
                bars.push_back(name);
        }
        if (bars.empty()) return;
        const Place& bar = program_.at(bars[action.which % bars.size()]);
        const float share = static_cast<float>(action.value % 101) / 100.0F;
        program_.window.click({bar.min.x + share * (bar.max.x - bar.min.x), bar.middle().y});
    }
    void tune_model(const Action& action) {
        work().document.edit().model.nc_weight = 0.1 * static_cast<double>(action.value % 11);
        model_changed(work());
        commit_step(ui(), work(), "Change the model");
    }
    void save_now(const Action&) { program_.press('s', true); }
    void save_elsewhere(const Action& action) {
        const std::string name = "file" + std::to_string(action.value % 3) + ".tactspace.json";
        save_as(ui(), work(), folder_.path / name);
        if (ui().question) ui().question.reset();
        files_.push_back(work().document.path);
    }
    void open_one(const Action& action) {
        open_paths(ui(), work(), program_.app.opening, {files_[action.which % files_.size()]});
        program_.wait_for_opening();
        begin();
    }
    void add_file(const Action& action) {
        if (count() >= 5) return;
        add_paths(ui(), work(), program_.app.opening, {files_[action.which % files_.size()]});
        program_.wait_for_opening();
    }
    void wait_for_map() {
        const ShownMap& map = program_.app.shown_map;
        wait_for([this, &map] { return map_state(work(), map) == MapState::exact; });
        law(map_state(work(), map) == MapState::exact, "the exact map does not come");
    }
    template <class Condition>
    void wait_for(const Condition& condition) {
        const auto until = std::chrono::steady_clock::now() + std::chrono::minutes(1);
        while (!condition() && std::chrono::steady_clock::now() < until) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            program_.frame();
        }
    }
    const Vibration& current() { return *current_vibration(work()); }
    void rest(const Action& action) {
        for (unsigned k = 0; k < action.value % 80; ++k) program_.frame();
    }
    void steps_through_command(const Action& action) {
        static constexpr const char* kCommands[] = {"Add a point of amplitude at the playhead",
                                                    "Add a transient at the playhead",
                                                    "Select all",
                                                    "Matrix",
                                                    "Map",
                                                    "Table of candidates"};
        const auto found = std::ranges::find(
            commands(), std::string_view(kCommands[action.value % 6]), &Command::name);
        if (found != commands().end()) carry_out(program_.app, *found);
    }

    void begin() {
        number_ = work().document_number;
        states_ = {printed(work().document.set)};
        note_time();  // what was there a moment ago is not lost either
    }

    void note_time() {
        const std::string now = printed(work().document.set);
        if (!recent_.empty()) recent_.back().until_s = program_.window.now_s;
        if (recent_.empty() || recent_.back().text != now)
            recent_.push_back({now, program_.window.now_s});
        while (recent_.size() > 1 && recent_.front().until_s < program_.window.now_s - kMostLostS)
            recent_.pop_front();
    }

    void look() {
        const auto& document = work().document;
        if (ui().question) {
            ui().question.reset();
            program_.settle();
        }
        law(document.set == *document.committed, "a gesture ended and is no step");
        const std::string now = printed(document.set);
        const std::size_t at = document.history.done();
        if (is_time_travel_) {
            law(document.history.size() + 1 == states_.size(), "undo or redo forgets a step");
            law(at < states_.size() && now == states_[at], "undo or redo gives another state");
        } else if (at >= states_.size() || now != states_[at]) {
            law(at == document.history.size(), "a change keeps what could be redone");
            law(at > 0 && at <= states_.size(), "a change is no step of its own");
            states_.resize(at);
            states_.push_back(now);
        } else if (document.history.size() + 1 != states_.size()) {
            law(at == document.history.size(), "a step is lost");
            states_.resize(at + 1);
        }
        look_around();
        note_time();
        check_kill();
    }

    // The mark and the bytes.
    void look_around() {
        const auto& document = work().document;
        const std::string file = bytes_of(document.path);
        const std::string would = print_set(document.kept().set, document.path.parent_path());
        law(work().unsaved == (file != would),
            work().unsaved ? "the mark is there, and the file has the same bytes"
                           : "the mark is gone, and the file has other bytes");
    }

    // What the next start would show.
    void check_kill() {
        wait_for_autosave(work());
        Session later = work().session;
        later.document = work().document.path;
        const Restored restored = restore(later);
        law(restored.document.has_value(), "a kill loses the document: " + restored.remark);
        const std::string back = printed(restored.document->set);
        for (const Shown& shown : recent_) {
            if (shown.text == back) return;
        }
        throw Broken{"a kill loses more than a second"};
    }

    void check_matrix(const PatternSet& file) {
        if (file.vibrations.size() < 2) return;
        request_maps(program_.app.ui, work(), program_.app.shown_map, program_.app.rendered);
        wait_for_map();
        const auto own = predict(model_waveforms(file), file.model);
        law(program_.app.shown_map.transition.shown->prediction.pm.condensed == own->pm.condensed,
            "the window's matrix is not that of the file");
    }

    struct Shown {
        std::string text;
        double until_s;
    };
    static constexpr double kMostLostS = 1.1;  // a second, and the frame that looks

    TemporaryFolder folder_;
    Program program_;
    std::vector<fs::path> files_;
    std::uint64_t number_ = 0;
    std::vector<std::string> states_;  // by the number of steps that are done
    std::deque<Shown> recent_;
    bool is_time_travel_ = false;
};

const std::vector<Person::Done> Person::kDone{
    {"select", &Person::select},
    {"select", &Person::select},
    {"select another too", &Person::select_two},
    {"add", &Person::add},
    {"duplicate", &Person::twice},
    {"remove", &Person::remove},
    {"reorder", &Person::reorder},
    {"rename", &Person::rename},
    {"lock", &Person::lock},
    {"drop", &Person::drop},
    {"colour", &Person::colour},
    {"generate", &Person::generate},
    {"mix", &Person::mix},
    {"vary", &Person::vary_one},
    {"steps between", &Person::put_steps_between},
    {"separate", &Person::separate},
    {"copy", &Person::copy},
    {"paste", &Person::paste},
    {"undo", &Person::take_back},
    {"undo", &Person::take_back},
    {"undo", &Person::take_back},
    {"redo", &Person::do_again},
    {"redo", &Person::do_again},
    {"type a number", &Person::type_number},
    {"type a number", &Person::type_number},
    {"type a number", &Person::type_number},
    {"slide", &Person::slide},
    {"slide", &Person::slide},
    {"tune the model", &Person::tune_model},
    {"save", &Person::save_now},
    {"save elsewhere", &Person::save_elsewhere},
    {"open", &Person::open_one},
    {"add a file", &Person::add_file},
    {"rest", &Person::rest},
    {"command", &Person::steps_through_command},
};

Walk random_walk(unsigned seed, std::size_t actions) {
    std::mt19937 random(seed);
    Walk walk(actions);
    for (Action& action : walk) {
        action.kind = static_cast<unsigned>(random());
        action.which = static_cast<unsigned>(random());
        action.value = static_cast<unsigned>(random());
    }
    return walk;
}

// The law that is broken; none: all hold.
std::optional<std::string> broken_by(const Walk& walk) {
    Person person;
    try {
        for (const Action& action : walk) person.act(action);
        person.check_all();
    } catch (const Broken& broken) {
        return broken.law;
    }
    return std::nullopt;
}

// Without all that is not needed to break the same law.
Walk shortened(Walk walk, const std::string& law) {
    int tries = 200;
    for (std::size_t part = walk.size() / 2; part > 0; part /= 2) {
        for (std::size_t from = 0; from + part <= walk.size() && tries > 0;) {
            Walk shorter = walk;
            const auto first = shorter.begin() + static_cast<std::ptrdiff_t>(from);
            shorter.erase(first, first + static_cast<std::ptrdiff_t>(part));
            --tries;
            if (broken_by(shorter) == law) {
                walk = shorter;
            } else {
                from += part;
            }
        }
    }
    return walk;
}

std::string told(const Walk& walk) {
    std::string text;
    for (const Action& action : walk) {
        text += "\n  " + Person::name_of(action) + " " + std::to_string(action.which) + " " +
                std::to_string(action.value);
    }
    return text;
}

unsigned number_in(const char* name, unsigned fallback) {
    const char* text = std::getenv(name);
    return text == nullptr ? fallback : static_cast<unsigned>(std::strtoul(text, nullptr, 10));
}

}  // namespace

TEST_CASE("document: whatever a person does, nothing is lost and every state comes back" *
          doctest::test_suite("long")) {
    constexpr unsigned kWalk = 60;  // fewer than the steps that undo reaches
    const unsigned actions = number_in("TACTSPACE_ACTIONS", 300);
    const unsigned seed = number_in("TACTSPACE_SEED", 1);
    for (unsigned k = 0; k * kWalk < actions; ++k) {
        INFO("seed " << seed + k);
        const Walk walk = random_walk(seed + k, kWalk);
        const auto broken = broken_by(walk);
        if (!broken) continue;
        const Walk shorter = shortened(walk, *broken);
        FAIL_CHECK("seed " << seed + k << ": " << *broken << told(shorter));
    }
}

}  // namespace random_actions_test
