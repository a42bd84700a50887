// What is false about who was asked reaches every output of every command: whatever the program
// prints or writes of a set whose ratings and model are of nobody says so, and what it makes of a
// study of which somebody is left out, and another only rehearsed.
#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace marked_outputs_test {

namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

constexpr const char* kPatterns = R"({"tactspace": 1, "name": "five", "duration_s": 0.1,
    "patterns": [
    {"name": "v1", "amplitude_g": 1.6}, {"name": "v2", "carriers": [{"frequency_hz": 150}]},
    {"name": "v3", "carriers": [{"frequency_hz": 250}]}, {"name": "v4", "amplitude_g": 0.3},
    {"name": "v5", "carriers": [{"frequency_hz": 40}]}],
    "study": {"repetitions": 1, "attention_pairs": 1})";

constexpr const char* kRatings = R"(, "ratings": [{"name": "S1", "labels": ["v1", "v2", "v3", "v4"],
    "condensed": [10, 20, 30, 40, 50, 60], "file": "synthetic, r.csv"}])";

constexpr const char* kModel =
    R"(, "model": {"nc_weight": 0.6, "trained_on": "Trained on r.csv.", "synthetic": true})";

std::string lower_case(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

// By the program's own words, so that a command that is new is missed here.
std::set<std::string> commands() {
    const std::string help = output_of({"--help"});
    std::istringstream lines(help.substr(help.find("Subcommands:")));
    std::set<std::string> names;
    std::string line;
    std::getline(lines, line);
    const std::regex row("^  ([a-z-]+) .*");
    for (std::smatch match; std::getline(lines, line);) {
        if (std::regex_match(line, match, row)) names.insert(match[1]);
    }
    return names;
}

// Files of these do not speak, or are no result: with the reason.
bool is_silent(const fs::path& file) {
    const std::string kind = file.extension().string();
    if (kind == ".png" || kind == ".py" || kind == ".R") return true;  // compared below; programs
    if (kind == ".ahap") return true;  // the pattern alone, which no model made
    // One pattern and its path through the model: model.txt beside them says it.
    return kind == ".csv" && file.parent_path().filename() == "stages";
}

// Cells of a table without quotes.
Words cells_of(const std::string& line) {
    Words cells(1);
    for (const char c : line) {
        if (c == ',') {
            cells.emplace_back();
        } else {
            cells.back() += c;
        }
    }
    return cells;
}

// Whether every line of a table has such columns.
bool has_counts(const std::string& text) {
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    const Words head = cells_of(line);
    const auto place_of = [&head](const char* name) {
        return static_cast<std::size_t>(std::ranges::find(head, name) - head.begin());
    };
    const std::size_t rehearsals = place_of("rehearsals");
    const bool is_of_folds = place_of("people_left_out") < head.size();  // "left_out": of a fold
    const std::size_t left_out = place_of(is_of_folds ? "people_left_out" : "left_out");
    if (std::max(left_out, rehearsals) >= head.size()) return false;
    while (std::getline(lines, line)) {
        const Words cells = cells_of(line);
        const std::size_t extra = cells.size() - head.size();  // commas within quotes before them
        const bool at_end = rehearsals + 1 == head.size();
        const std::size_t shift = at_end ? extra : 0;
        if (cells.at(left_out + shift) != "2" || cells.at(rehearsals + shift) != "1") return false;
    }
    return true;
}

bool says_left_out(const std::string& text) {
    const auto has = [&text](const char* what) { return text.find(what) != text.npos; };
    if (has("2 participants left out, 1 rehearsal among them")) return true;
    if (has("a rehearsal, nothing was felt") && has("fell asleep")) return true;
    if (has("\"left_out\":2") && has("\"rehearsals\":1")) return true;
    if (has("\"left_out\": 2") && has("\"rehearsals\": 1")) return true;
    if (has("\"people_left_out\":2") && has("\"rehearsals_left_out\":1")) return true;
    return has_counts(text);
}

struct Bench {
    TemporaryFolder folder;
    std::string of_nobody = write("of nobody.json", std::string(kRatings) + kModel);
    std::string rated = write("rated.json", kRatings);   // the model is the published one
    std::string modelled = write("model.json", kModel);  // without ratings
    std::string plain = write("plain.json", "");
    std::string out = (folder.path / "out").string();
    std::string people = (folder.path / "people").string();
    std::string matrix = (folder.path / "matrix.csv").string();  // of simulated people
    std::string mixed = (folder.path / "mixed").string();        // two, one left out, one rehearsal
    std::string mixed_matrix = (folder.path / "mixed.csv").string();

    Bench() {
        make_mixed();
        fs::create_directories(out);
        ran({"study", plain, "--simulate", "3", "--out", people});
        ran({"study", plain, "--collect", people, "--matrix", matrix});
    }
    std::string write(const char* name, const std::string& more) const {
        return folder.write(name, std::string(kPatterns) + more + "}").string();
    }
    // Four who were simulated, as if they had been asked.
    void make_mixed() const {
        ran({"study", plain, "--simulate", "4", "--out", mixed});
        for (const char* code : {"S01", "S02", "S03", "S04"}) {
            const fs::path file = fs::path(mixed) / (std::string(code) + ".jsonl");
            std::string text = bytes_of(file);
            replace_in(text, "\"synthetic\":true", "\"synthetic\":false");
            replace_in(text, "none: simulated",
                       code == std::string("S04") ? "no device" : "Voice coil");
            std::ofstream(file) << text;
        }
        ran({"study", plain, "--collect", mixed, "--exclude", "S03", "--because", "fell asleep"});
        ran({"study", plain, "--collect", mixed, "--matrix", mixed_matrix});
    }
    static void replace_in(std::string& text, const std::string& what, const std::string& by) {
        const std::size_t at = text.find(what);
        REQUIRE(at != text.npos);
        text.replace(at, what.size(), by);
    }
    static Ran ran(const Words& arguments) {
        Ran ran = run_program(arguments);
        std::string words;
        for (const std::string& word : arguments) words += word + " ";
        CHECK_MESSAGE(ran.exit_code == 0, words << ran.err);
        return ran;
    }
    // Whatever the command prints as its answer, or writes into `out`, says it.
    void check_says(const Words& arguments) const {
        std::string words;
        for (const std::string& word : arguments) words += word + " ";
        CAPTURE(words);
        fs::remove_all(out);
        fs::create_directories(out);
        const Ran answer = ran(arguments);
        if (!answer.out.empty()) CHECK(contains(lower_case(answer.out), "synthetic"));
        for (const auto& entry : fs::recursive_directory_iterator(out)) {
            if (!entry.is_regular_file() || is_silent(entry.path())) continue;
            CAPTURE(entry.path().string());
            CHECK(contains(lower_case(bytes_of(entry.path())), "synthetic"));
        }
    }
    // The same for people that the numbers leave out; `raw`: files with a line an answer of those
    // who count.
    void check_says_left_out(const Words& arguments, const std::set<std::string>& raw = {}) const {
        std::string words;
        for (const std::string& word : arguments) words += word + " ";
        CAPTURE(words);
        fs::remove_all(out);
        fs::create_directories(out);
        const Ran answer = ran(arguments);
        if (!answer.out.empty()) CHECK_MESSAGE(says_left_out(answer.out), answer.out);
        for (const auto& entry : fs::recursive_directory_iterator(out)) {
            if (!entry.is_regular_file() || is_silent(entry.path())) continue;
            if (raw.contains(entry.path().filename().string())) continue;
            CHECK_MESSAGE(says_left_out(bytes_of(entry.path())), entry.path().string());
        }
    }
    std::string at(const char* name) const { return (fs::path(out) / name).string(); }
};

// compare of these sets and ratings, with all of its tables, and as JSON.
std::array<Words, 2> comparing(const Bench& b, const Words& sets) {
    Words words{"compare"};
    words.insert(words.end(), sets.begin(), sets.end());
    words.insert(words.end(), {"--metric", "pm", "rmse"});
    Words tables = words;
    tables.insert(tables.end(), {"--csv", b.at("a.csv"), "--people-csv", b.at("b.csv"),
                                 "--differences-csv", b.at("c.csv"), "--methods"});
    words.push_back("--json");
    return {tables, words};
}

using Checks = std::map<std::string, std::function<void(const Bench&)>>;

// What each command is asked for, or why there is nothing to be marked.
const Checks& checks() {
    static const Checks kChecks{
        {"predict",
         [](const Bench& b) {
             b.check_says({"predict", b.modelled});
             b.check_says({"predict", b.modelled, "--json"});
             b.check_says(
                 {"predict", b.modelled, "--out", b.at("m.csv"), "--image", b.at("m.svg")});
         }},
        {"space",
         [](const Bench& b) {
             b.check_says({"space", b.modelled});
             b.check_says({"space", b.modelled, "--json"});
             b.check_says({"space", b.modelled, "--out", b.at("s.csv"), "--image", b.at("s.svg")});
             for (const Words& from :
                  {Words{b.rated, "--people"}, Words{b.plain, "--ratings", b.people},
                   Words{b.plain, "--matrix", b.matrix}}) {
                 Words words{"space"};
                 words.insert(words.end(), from.begin(), from.end());
                 b.check_says(words);
                 words.push_back("--json");
                 b.check_says(words);
                 words.insert(words.end(), {"--out", b.at("s.csv"), "--image", b.at("s.svg")});
                 b.check_says(words);
             }
             // The map itself is nobody's invention; what it is turned onto, and held against, is.
             const std::string other = (b.folder.path / "of nobody.csv").string();
             Bench::ran({"space", b.plain, "--ratings", b.people, "--out", other});
             b.check_says({"space", b.plain, "--align-to", other});
             b.check_says({"space", b.plain, "--align-to", other, "--json"});
             b.check_says({"space", b.plain, "--align-to", other, "--out", b.at("s.csv"), "--image",
                           b.at("s.svg")});
             const std::string turned = (b.folder.path / "turned.csv").string();
             Bench::ran({"space", b.plain, "--align-to", other, "--out", turned});
             b.check_says({"space", b.plain, "--align-to", turned});
         }},
        {"stages",
         [](const Bench& b) {
             b.check_says({"stages", b.modelled, "--pattern", "v1", "--out", b.at("stages")});
             b.check_says(
                 {"stages", b.modelled, "--pattern", "v1", "--out", b.at("stages"), "--json"});
             CHECK(fs::exists(b.at("stages/model.txt")));
         }},
        {"subset",
         [](const Bench& b) {
             for (const Words& from : {Words{b.modelled}, Words{b.plain, "--ratings", b.people},
                                       Words{b.plain, "--matrix", b.matrix}}) {
                 Words words{"subset", "-k", "2"};
                 words.insert(words.end(), from.begin(), from.end());
                 b.check_says(words);
                 words.push_back("--json");
                 b.check_says(words);
                 words.insert(words.end(), {"--report", b.at("report")});
                 fs::remove_all(b.out);
                 Bench::ran(words);
                 CHECK(contains(lower_case(bytes_of(b.at("report/report.html"))), "synthetic"));
             }
             b.check_says({"subset", b.of_nobody, "-k", "2", "--out", b.at("set.json"), "--report",
                           b.at("report")});
         }},
        {"report",
         [](const Bench& b) {
             b.check_says({"report", b.modelled, "--out", b.at("r.html")});
         }},
        {"groups",
         [](const Bench& b) {
             b.check_says({"groups", b.modelled, "--out", b.at("g.csv")});
             b.check_says({"groups", b.modelled, "--json"});
             b.check_says({"groups", b.plain, "--matrix", b.matrix, "--out", b.at("g.csv")});
         }},
        {"separate",
         [](const Bench& b) {
             b.check_says({"separate", b.modelled, "--pair", "v1,v4"});
             b.check_says({"separate", b.modelled, "--pair", "v1,v4", "--json"});
         }},
        {"steps",
         [](const Bench& b) {
             const Words words{"steps", b.modelled, "--from", "v1",    "--to",
                               "v4",    "-n",       "3",      "--out", b.at("steps.json")};
             b.check_says(words);
             Words json = words;
             json.push_back("--json");
             b.check_says(json);
         }},
        {"edit",
         [](const Bench& b) {
             const Words words{"edit",      b.modelled, "--pattern",      "v1",
                               "--reverse", "--out",    b.at("edit.json")};
             b.check_says(words);
             Words json = words;
             json.push_back("--json");
             b.check_says(json);
         }},
        {"compare",
         [](const Bench& b) {
             for (const Words& from : {Words{b.rated}, Words{b.plain, "--ratings", b.people},
                                       Words{b.plain, "--ratings", b.matrix}, Words{b.of_nobody}}) {
                 for (const Words& words : comparing(b, from)) b.check_says(words);
             }
         }},
        {"train",
         [](const Bench& b) {
             b.check_says({"train", b.rated, "--step", "0.5"});
             b.check_says({"train", b.plain, "--ratings", b.people, "--step", "0.5", "--json",
                           "--csv", b.at("t.csv"), "--out", b.at("model.json")});
         }},
        {"study",
         [](const Bench& b) {
             b.check_says({"study", b.plain, "--simulate", "2", "--out", b.at("two")});
             for (const Words& more : {Words{}, Words{"--json"}, Words{"--weights", "2"}}) {
                 Words words{"study",       b.plain,    "--collect",   b.people,   "--out",
                             b.at("a.csv"), "--matrix", b.at("m.csv"), "--report", b.at("report")};
                 words.insert(words.end(), more.begin(), more.end());
                 b.check_says(words);
             }
         }},
        {"paper",
         [](const Bench& b) {
             Bench::ran({"paper", b.plain, "--ratings", b.people, "--out", b.at("paper")});
             for (const char* file : {"paper.html", "table2.csv", "pairs.csv"}) {
                 CHECK(contains(lower_case(bytes_of(b.at("paper") + "/" + file)), "synthetic"));
             }
         }},
        {"plan",
         [](const Bench& b) {
             for (const Words& more : {Words{}, Words{"--json"}}) {
                 Words words{"plan", b.plain,     "--pilot", b.people, "--people",
                             "3",    "--studies", "20",      "--csv",  b.at("p.csv")};
                 words.insert(words.end(), more.begin(), more.end());
                 b.check_says(words);
             }
             b.check_says({"plan", b.plain, "--pilot", b.people, "--people", "3", "--studies", "20",
                           "--preregister", b.at("plan")});
         }},
        {"export",
         [](const Bench& b) {
             b.check_says({"export", b.modelled, "--format", "ahap", "--out", b.at("one")});
             b.check_says(
                 {"export", b.modelled, "--format", "ahap", "--out", b.at("two"), "--json"});
         }},
        {"measure",
         [](const Bench& b) {
             fs::remove_all(b.out);
             Bench::ran({"measure", b.plain, "--simulate", "--out", b.at("twins.tactspace.json")});
             CHECK(contains(bytes_of(b.at("twins.tactspace.json")), "\"synthetic\": true"));
         }},
        {"library",
         [](const Bench& b) {
             const std::string shelf = (b.folder.path / "shelf").string();
             fs::create_directories(shelf);
             Bench::ran({"measure", b.plain, "--simulate", "--out", shelf + "/t.tactspace.json"});
             b.check_says({"library", shelf});
             b.check_says({"library", shelf, "--like", "v1", "--json"});
             b.check_says({"library", shelf, "--like", "v1", "--out", b.at("l.tactspace.json")});
         }},
        {"snapshot",
         [](const Bench& b) {
             for (const char* view : {"space", "matrix", "window", "physiology"}) {
                 b.check_says({"snapshot", b.modelled, "--view", view, "--out", b.at("v.svg")});
             }
         }},
        {"render", {}},      // waveforms: no model, nobody's ratings
        {"devices", {}},     // what is plugged in
        {"play", {}},        // an actuator moves
        {"phones", {}},      // served until it is interrupted: what one person felt
        {"calibrate", {}},   // what an actuator did
        {"findings", {}},    // the bundled sets and the published model alone
        {"generate", {}},    // patterns from a design space, without a model
        {"import", {}},      // recordings that were made
        {"from-sound", {}},  // patterns of sounds, with the published model
        {"lesson", {}},      // a bundled set's numbers, with the published model
        {"manual", {}},      // text
    };
    return kChecks;
}

}  // namespace

TEST_CASE("marked outputs: every command is known here, with what it is asked for") {
    std::set<std::string> known;
    for (const auto& [name, check] : checks()) known.insert(name);
    CHECK(commands() == known);
}

TEST_CASE("marked outputs: all that a command prints or writes says that nobody was asked" *
          doctest::test_suite("long")) {
    const Bench bench;
    for (const auto& [name, check] : checks()) {
        if (check) check(bench);
    }
}

// Commands that make numbers of ratings; the others have no people to leave out.
const Checks& left_out_checks() {
    static const Checks kChecks{
        {"space",
         [](const Bench& b) {
             for (const Words& from :
                  {Words{b.plain, "--ratings", b.mixed}, Words{b.plain, "--matrix", b.mixed_matrix},
                   Words{b.plain, "--ratings", b.mixed_matrix}}) {
                 Words words{"space"};
                 words.insert(words.end(), from.begin(), from.end());
                 b.check_says_left_out(words);
                 words.push_back("--json");
                 b.check_says_left_out(words);
                 words.insert(words.end(), {"--out", b.at("s.csv"), "--image", b.at("s.svg")});
                 b.check_says_left_out(words);
             }
         }},
        {"subset",
         [](const Bench& b) {
             for (const Words& from : {Words{b.plain, "--ratings", b.mixed},
                                       Words{b.plain, "--matrix", b.mixed_matrix}}) {
                 Words words{"subset", "-k", "2"};
                 words.insert(words.end(), from.begin(), from.end());
                 b.check_says_left_out(words);
                 words.push_back("--json");
                 b.check_says_left_out(words);
                 words.insert(words.end(), {"--report", b.at("report")});
                 Bench::ran(words);
                 CHECK(says_left_out(bytes_of(b.at("report/report.html"))));
             }
         }},
        {"compare",
         [](const Bench& b) {
             for (const std::string& from : {b.mixed, b.mixed_matrix}) {
                 for (const Words& words : comparing(b, {b.plain, "--ratings", from})) {
                     b.check_says_left_out(words);
                 }
             }
         }},
        {"train",
         [](const Bench& b) {
             const Words words{"train", b.plain, "--ratings", b.mixed, "--step", "0.5"};
             b.check_says_left_out(words);
             Words files = words;
             files.insert(files.end(),
                          {"--json", "--csv", b.at("t.csv"), "--out", b.at("model.json")});
             b.check_says_left_out(files);
         }},
        {"paper",
         [](const Bench& b) {
             fs::remove_all(b.out);
             Bench::ran({"paper", b.plain, "--ratings", b.mixed, "--out", b.at("paper")});
             CHECK(says_left_out(bytes_of(b.at("paper") + "/paper.html")));
         }},
        {"plan",
         [](const Bench& b) {
             const Words words{"plan",     b.plain, "--pilot",   b.mixed,
                               "--people", "3",     "--studies", "20"};
             Words files = words;
             files.insert(files.end(), {"--csv", b.at("p.csv"), "--preregister", b.at("plan")});
             b.check_says_left_out(files);
             Words json = words;
             json.push_back("--json");
             b.check_says_left_out(json);
         }},
        {"study",
         [](const Bench& b) {
             for (const Words& more : {Words{}, Words{"--json"}, Words{"--weights", "2"}}) {
                 Words words{"study",       b.plain,    "--collect",   b.mixed,    "--out",
                             b.at("a.csv"), "--matrix", b.at("m.csv"), "--report", b.at("report")};
                 words.insert(words.end(), more.begin(), more.end());
                 b.check_says_left_out(words, {"a.csv"});
             }
         }},
    };
    return kChecks;
}

TEST_CASE("marked outputs: whatever takes ratings says whom its numbers leave out" *
          doctest::test_suite("long")) {
    for (const std::string& name : commands()) {
        const bool takes_people = contains(output_of({name, "--help"}), "--ratings") ||
                                  contains(output_of({name, "--help"}), "--collect");
        CHECK_MESSAGE(takes_people == left_out_checks().contains(name), name);
    }
    const Bench bench;
    for (const auto& [name, check] : left_out_checks()) check(bench);
}

TEST_CASE("marked outputs: a picture of pixels is another one where nobody was asked") {
    const Bench bench;
    std::string unmarked = bytes_of(bench.modelled);
    const std::string mark = ", \"synthetic\": true";
    unmarked.erase(unmarked.find(mark), mark.size());
    const std::string asked = bench.folder.write("asked.json", unmarked).string();
    const auto picture = [&bench](const Words& words, const std::string& set) {
        Words all = words;
        all.insert(all.begin() + 1, set);
        Bench::ran(all);
        return bytes_of(words.back());
    };
    for (const Words& words :
         {Words{"predict", "--out", bench.at("m.csv"), "--image", bench.at("m.png")},
          Words{"space", "--out", bench.at("s.csv"), "--image", bench.at("s.png")},
          Words{"snapshot", "--view", "space", "--out", bench.at("v.png")}}) {
        CHECK(picture(words, bench.modelled) != picture(words, asked));
    }
}

}  // namespace marked_outputs_test
