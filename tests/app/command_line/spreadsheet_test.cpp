// What a table of any command says in names that people gave is run by no spreadsheet, and is read
// back as it was.
#include <doctest/doctest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/support/run_program.h"
#include "tests/support/spreadsheet.h"
#include "tests/support/temporary_folder.h"

namespace spreadsheet_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

// Names as JSON writes them, and themselves; each begins with another sign that a spreadsheet runs.
const std::vector<std::pair<std::string, std::string>>& names() {
    static const std::vector<std::pair<std::string, std::string>> kNames{
        {R"(=1+1|A)", "=1+1|A"},       {R"(+A,\"b\")", "+A,\"b\""},   {R"(-A;b)", "-A;b"},
        {R"(@SUM(A1))", "@SUM(A1)"},   {R"(\r=A1)", "\r=A1"},         {R"(\n=A2)", "\n=A2"},
        {R"(\t=A3)", "\t=A3"},         {R"(\uff1dcmd)", "\uff1dcmd"}, {R"(\uff0bcmd)", "\uff0bcmd"},
        {R"(\uff0dcmd)", "\uff0dcmd"}, {R"(\uff20cmd)", "\uff20cmd"}, {R"('=A4)", "'=A4"}};
    return kNames;
}

std::string set_text() {
    std::string text = R"x({"tactspace": 1, "name": "=set()", "duration_s": 0.1, "patterns": [)x";
    double hz = 40.0;
    for (const auto& [json, name] : names()) {
        text += std::string(hz > 40.0 ? "," : "") + R"x({"name": ")x" + json +
                R"(", "carriers": [{"frequency_hz": )" + std::to_string(hz) + "}]}";
        hz *= 1.2;
    }
    return text + R"(], "study": {"repetitions": 1, "attention_pairs": 1}})";
}

Words pattern_names() {
    Words all;
    for (const auto& [json, name] : names()) all.push_back(name);
    return all;
}

// Rated by people whose codes, devices, own fields and reasons are of the same kind.
struct Bench {
    TemporaryFolder folder;
    std::string set = folder.write("set.json", set_text()).string();
    std::string out = at("out");
    std::string people = at("people");
    Words codes{"=P1", "@P2", "\uff1dP3"};

    Bench() {
        ran({"study", set, "--simulate", "3", "--out", people});
        const Words stems{"S01", "S02", "S03"};
        for (std::size_t k = 0; k < stems.size(); ++k) {
            const fs::path file = fs::path(people) / (stems[k] + ".jsonl");
            std::string text = bytes_of(file);
            replace_in(text, "\"" + stems[k] + "\"", "\"" + codes[k] + "\"");
            replace_in(text, "none: simulated", "=device()");
            std::ofstream(file) << text;
        }
        ran({"study", set, "--collect", people, "--exclude", "=P1", "--because", "=because()"});
    }
    std::string at(const std::string& name) const { return (folder.path / name).string(); }
    std::string out_at(const std::string& name) const { return out + "/" + name; }
    static void ran(const Words& words) {
        const Ran ran = run_program(words);
        REQUIRE_MESSAGE(ran.exit_code == 0, ran.err);
    }
    static void replace_in(std::string& text, const std::string& what, const std::string& by) {
        const std::size_t at = text.find(what);
        REQUIRE(at != text.npos);
        text.replace(at, what.size(), by);
    }
    // Each table that is written; `wanted`: what has to be in it, of the files that are named.
    void check(const Words& words, const std::map<std::string, Words>& wanted) const {
        fs::remove_all(out);
        fs::create_directories(out);
        ran(words);
        std::set<std::string> seen;
        for (const auto& entry : fs::recursive_directory_iterator(out)) {
            if (entry.path().extension() != ".csv") continue;
            const std::string name = entry.path().filename().string();
            seen.insert(name);
            const auto named = wanted.find(name);
            check_table(words.front() + " " + name, bytes_of(entry.path()),
                        named == wanted.end() ? Words{} : named->second);
        }
        for (const auto& [name, cells] : wanted) CHECK_MESSAGE(seen.contains(name), name);
    }
};

using Checks = std::map<std::string, std::function<void(const Bench&)>>;

const Checks& checks() {
    static const Checks kChecks{
        {"predict",
         [](const Bench& b) {
             b.check({"predict", b.set, "--out", b.out_at("m.csv")}, {{"m.csv", pattern_names()}});
             check_table("predict", output_of({"predict", b.set}), pattern_names());
         }},
        {"space",
         [](const Bench& b) {
             b.check({"space", b.set, "--out", b.out_at("s.csv")}, {{"s.csv", pattern_names()}});
         }},
        {"compare",
         [](const Bench& b) {
             b.check({"compare", b.set, "--ratings", b.people, "--metric", "pm", "rmse", "--csv",
                      b.out_at("a.csv"), "--people-csv", b.out_at("b.csv"), "--differences-csv",
                      b.out_at("c.csv")},
                     {{"a.csv", {"=set()"}}, {"b.csv", {"=set()", "@P2"}}, {"c.csv", {"=set()"}}});
         }},
        {"train",
         [](const Bench& b) {
             b.check({"train", b.set, "--ratings", b.people, "--step", "0.5", "--csv",
                      b.out_at("t.csv"), "--out", b.out_at("model.json")},
                     {{"t.csv", {}}});
         }},
        {"study",
         [](const Bench& b) {
             const Words all = pattern_names();
             const Words who{"=P1", "@P2", "\uff1dP3"};
             b.check(
                 {"study", b.set, "--collect", b.people, "--everyone", "--out", b.out_at("a.csv"),
                  "--matrix", b.out_at("m.csv"), "--report", b.out_at("report"), "--weights", "2"},
                 {{"a.csv", {"=P1", "=device()", "=1+1|A", "\r=A1"}},
                  {"m.csv", all},
                  {"participants.csv", who},
                  {"answers.csv", who},
                  {"pairs.csv", all},
                  {"maps.csv", all},
                  {"weights.csv", {"@P2"}},
                  {"dimensions.csv", all}});
             b.check({"study", b.set, "--pack", "psychopy", "--participants", "1", "--out",
                      b.out_at("pack")},
                     {{"trials.csv", all}});
         }},
        {"paper",
         [](const Bench& b) {
             b.check({"paper", b.set, "--ratings", b.people, "--out", b.out_at("paper")},
                     {{"pairs.csv", pattern_names()}, {"maps.csv", pattern_names()}});
         }},
        {"plan",
         [](const Bench& b) {
             b.check({"plan", b.set, "--people", "3", "--studies", "20", "--csv", b.out_at("p.csv"),
                      "--preregister", b.out_at("plan")},
                     {{"p.csv", {}}});
         }},
        {"render",
         [](const Bench& b) {
             b.check({"render", b.set, "--rendered-by", "joy-con", "--out", b.out_at("r")},
                     {{"bands.csv", pattern_names()}, {"packets.csv", pattern_names()}});
             b.check({"render", b.set, "--format", "csv", "--out", b.out_at("r")}, {});
         }},
        {"stages",
         [](const Bench& b) {
             b.check({"stages", b.set, "--pattern", "=1+1|A", "--out", b.out_at("stages")}, {});
         }},
        {"findings",
         [](const Bench& b) {
             b.check({"findings", "--csv", b.out_at("f.csv")}, {{"f.csv", {}}});
         }},
        {"groups",
         [](const Bench& b) {
             b.check({"groups", b.set, "-n", "2", "--out", b.out_at("g.csv")},
                     {{"g.csv", pattern_names()}});
         }},
        {"export",
         [](const Bench& b) {
             b.check({"export", b.set, "--format", "csv", "--out", b.out_at("e")}, {});
         }},
        // No table of theirs says a name.
        {"subset", {}},
        {"separate", {}},
        {"steps", {}},
        {"edit", {}},
        {"snapshot", {}},
        {"report", {}},
        {"measure", {}},
        {"devices", {}},
        {"play", {}},
        {"phones", {}},
        {"calibrate", {}},
        {"generate", {}},
        {"from-sound", {}},
        {"library", {}},
        {"import", {}},
        {"lesson", {}},
        {"manual", {}},
    };
    return kChecks;
}

}  // namespace

TEST_CASE("spreadsheets: every command is known here, with the tables that it writes") {
    const std::string help = output_of({"--help"});
    std::istringstream lines(help.substr(help.find("Subcommands:")));
    const std::regex row("^  ([a-z-]+) .*");
    std::set<std::string> commands;
    std::string line;
    std::getline(lines, line);
    for (std::smatch match; std::getline(lines, line);) {
        if (std::regex_match(line, match, row)) commands.insert(match[1]);
    }
    std::set<std::string> known;
    for (const auto& [name, check] : checks()) known.insert(name);
    CHECK(commands == known);
}

TEST_CASE("spreadsheets: no cell of any table is run, and names are read back as they were" *
          doctest::test_suite("long")) {
    const Bench bench;
    for (const auto& [name, check] : checks()) {
        if (check) check(bench);
    }
}

}  // namespace spreadsheet_test
