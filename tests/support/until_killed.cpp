// until_killed WHAT FOLDER [TURNS]: starts as the window does, edits and writes as it does, over
// and over, until it is killed, or a write fails, or TURNS turns are over. For tests/faults.
//
// WHAT      save: the set FOLDER/set.tactspace.json by File > Save
//           autosave: unsaved changes of it, as frames keep them; each fifth turn is saved instead
//           answers: participants FOLDER/P1.jsonl, P2.jsonl, .., an answer at a time, ten each
// Input     XDG_STATE_HOME, where session and autosave are
// Output    "found N": the turn that the start brought back (0: none), or "found P N": the last
//           participant and how many answers; "unreadable P" where that file cannot be read; then
//           "wrote N", or "wrote P N", once it is on the disk. Exit code 1 with a sentence: it
//           could not be written, or what was found is no turn's.
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <utility>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/opening/opening.h"
#include "app/session/session.h"
#include "app/window/window.h"
#include "model/io/people/study_file.h"
#include "model/io/people/study_lines.h"

namespace {

using namespace tact;
namespace fs = std::filesystem;

void tell(const std::string& line) { std::cout << line << std::endl; }

int complain_of(const std::string& sentence) {
    std::cerr << sentence << std::endl;
    return 1;
}

// Every pattern is another one than a turn before: a file half old and half new is no turn's.
PatternSet set_of(long turn) {
    PatternSet set;
    set.name = std::to_string(turn);
    set.vibrations.resize(60);
    for (std::size_t k = 0; k < set.vibrations.size(); ++k) {
        Pattern pattern;
        pattern.amplitude_g = 0.5 + 0.001 * static_cast<double>(turn % 1'000);
        pattern.carriers[0].frequency_hz = 60.0 + static_cast<double>(k);
        set.vibrations[k].name = "p" + std::to_string(k + 1);
        set.vibrations[k].source = pattern;
    }
    give_looks(set);
    return set;
}

// 0: of no turn, such as the example of a first start; -1: broken.
long turn_of(const PatternSet& set) {
    long turn = 0;
    const char* const end = set.name.data() + set.name.size();
    const auto [last, fault] = std::from_chars(set.name.data(), end, turn);
    if (fault != std::errc{} || last != end) return 0;
    return set == set_of(turn) ? turn : -1;
}

void edit(App& app, long turn) {
    app.work.document.edit() = set_of(turn);
    document_changed(app.work);
}

// Killed between the file's renaming and the end of what was kept before, the start after it has
// what was kept, which a person may want or not: here they do.
void save_to(App& app, const fs::path& file) {
    app.work.document.path == file ? save(app.ui, app.work) : save_as(app.ui, app.work, file);
    const std::optional<Question> asked = std::exchange(app.ui.question, std::nullopt);
    if (!asked) return;
    for (const Answer& answer : asked->answers) {
        if (answer.label == "Overwrite") answer.run();
    }
}

// Frames until the change is kept.
void keep(App& app) {
    autosave_if_due(app.ui, app.work);  // notices it
    app.ui.time_s += 1.0;
    autosave_if_due(app.ui, app.work);  // begins
    wait_for_autosave(app.work);
    autosave_if_due(app.ui, app.work);  // hears how it went
}

// Starts as a person does: with the file if that was saved last, otherwise without.
std::string start(App& app, const fs::path& file, bool autosaves) {
    std::vector<fs::path> paths;
    if (!autosaves && fs::exists(file)) paths = {file};
    if (const auto started = start_session(app, paths); !started) return started.error().message;
    const Session& session = app.work.session;
    if (!session.remarks.empty()) return session.remarks[0];
    if (!session.is_first) return "another program has the state folder";
    if (app.ui.status.is_error) return app.ui.status.text;
    // Nothing is unsaved, and what was open is known of a good end only.
    const bool is_example = turn_of(app.work.document.set) == 0;
    if (autosaves && is_example && fs::exists(file))
        open_paths(app.ui, app.work, app.opening, {file});
    return app.ui.status.is_error ? app.ui.status.text : std::string();
}

int edit_on(const fs::path& folder, bool autosaves, long turns) {
    const fs::path file = folder / "set.tactspace.json";
    App app = make_app();
    if (const std::string fault = start(app, file, autosaves); !fault.empty())
        return complain_of(fault);
    const long first = turn_of(app.work.document.set);
    if (first < 0) return complain_of("a set of no turn came back: " + app.work.document.set.name);
    tell("found " + std::to_string(first));
    for (long turn = first + 1; turns == 0 || turn <= first + turns; ++turn) {
        edit(app, turn);
        app.ui.status = {};
        if (!autosaves || turn % 5 == 0) {
            save_to(app, file);
        } else {
            keep(app);
        }
        if (app.ui.status.is_error) return complain_of(app.ui.status.text);
        tell("wrote " + std::to_string(turn));
    }
    const auto closed = close_session(app.work.session);
    return closed ? 0 : complain_of(closed.error().message);
}

constexpr std::size_t kAnswers = 10;  // all pairs of five

std::string code_of(int person) { return "P" + std::to_string(person); }

fs::path file_of(const fs::path& folder, int person) {
    return folder / study_file_name(code_of(person));
}

StudyHeader header_of(int person) {
    StudyHeader header;
    header.program = "tactspace 1";
    header.set_name = "five";
    header.set_fingerprint = "0123456789abcdef";
    header.patterns = {"a", "b", "c", "d", "e"};
    header.participant = {code_of(person), {{"age", "27"}}};
    header.consented = true;
    header.begun = "2026-01-02T03:04:05Z";
    return header;
}

PairAnswer answer_of(std::size_t number) {
    std::size_t left = 0;
    std::size_t right = 1;
    for (std::size_t k = 0; k < number; ++k) {
        if (++right == 5) right = ++left + 1;
    }
    return {{left, right}, 54.0, 1, 3, 6.25, "2026-01-02T03:05:00Z"};
}

int answer_on(const fs::path& folder, long turns) {
    int person = 1;
    while (fs::exists(file_of(folder, person + 1))) ++person;
    StudyRecord record;
    std::optional<StudyLog> log;
    if (fs::exists(file_of(folder, person))) {
        auto read = read_study_file(file_of(folder, person));
        if (!read) {
            tell("unreadable " + std::to_string(person));
            ++person;
        } else {
            record = *std::move(read);
            tell("found " + std::to_string(person) + " " + std::to_string(record.answers.size()));
            auto resumed = StudyLog::resume(file_of(folder, person), record);
            if (!resumed) return complain_of(resumed.error().message);
            log.emplace(*std::move(resumed));
        }
    }
    for (long turn = 0; turns == 0 || turn < turns; ++turn) {
        if (log && record.answers.size() == kAnswers) {
            log.reset();
            ++person;
        }
        if (!log) {
            record = {};
            record.header = header_of(person);
            auto begun = StudyLog::begin(file_of(folder, person), record.header);
            if (!begun) return complain_of(begun.error().message);
            log.emplace(*std::move(begun));
            tell("wrote " + std::to_string(person) + " 0");
        }
        const std::size_t number = record.answers.size();
        record.answers.push_back(answer_of(number));
        const auto written = log->append(answer_line(record.header, number, record.answers.back()));
        if (!written) return complain_of(written.error().message);
        tell("wrote " + std::to_string(person) + " " + std::to_string(number + 1));
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string what = argc > 2 ? argv[1] : "";
    const long turns = argc > 3 ? std::strtol(argv[3], nullptr, 10) : 0;
    if (what == "save" || what == "autosave") return edit_on(argv[2], what == "autosave", turns);
    if (what == "answers") return answer_on(argv[2], turns);
    return complain_of("expected save, autosave or answers, and a folder");
}
