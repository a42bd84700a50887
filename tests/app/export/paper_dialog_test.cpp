// File > Paper: which sets take part, what is started, what is told of it. A script stands in the
// place of the program, which writes down what it was asked.
#include <filesystem>

#include "app/export/export.h"
#include "app/window/window.h"
#include "model/io/set/set_file.h"
#include "tests/support/compare_bench.h"
#include "tests/support/scene_steps.h"

namespace paper_dialog_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

struct Writing {
    CompareBench bench;
    Program& program = bench.program;
    PaperState& paper = program.app.exports.paper;
    fs::path out = bench.folder.path / "paper of it";

    explicit Writing(const std::string& script) {
        paper.program = bench.folder.write("stand-in", "#!/bin/sh\n" + script);
        fs::permissions(paper.program, fs::perms::owner_all);
    }

    void write() {
        write_paper(program.app.ui, program.app.work, paper, {"/mine.csv"}, out);
        wait_until(program, [this] { return !is_writing_paper(paper); });
        program.frame();
        program.settle();
    }
    const StatusLine& status() const { return program.app.ui.status; }
};

constexpr const char* kWrites = R"(for word in "$@"; do last=$out; out=$word; done
out=; all="$*"
while [ $# -gt 0 ]; do [ "$1" = --out ] && out=$2; shift; done
mkdir -p "$out" && echo "$all" > "$out/paper.html"
)";

}  // namespace

TEST_CASE("paper: without ratings there is nothing to write; with them the set takes part") {
    Writing writing(kWrites);
    run(writing.program, "Paper...");
    CHECK(writing.program.shows("paper:open set"));
    writing.write();
    CHECK_FALSE(fs::exists(writing.out));
    writing.program.press_key(key::kEscape);
    writing.bench.load(square_csv());
    writing.paper.along = "modulation";
    writing.write();
    const std::string asked = bytes_of(writing.out / "paper.html");
    CHECK_MESSAGE(asked.starts_with("paper "), asked);
    CHECK(contains(asked, "--along modulation"));
    CHECK(contains(asked, "--metric-from /mine.csv"));
    CHECK_FALSE(writing.status().is_error);
    CHECK(contains(writing.status().text, "paper.html"));
    // What the document has more than its file went along, and is gone again.
    const std::string given = asked.substr(6, asked.find(" --out") - 6);
    CHECK_FALSE(fs::exists(given));
}

TEST_CASE("paper: a set that is added must keep ratings, and is given as it is") {
    Writing writing(kWrites);
    const fs::path bare = writing.bench.folder.path / "bare.tactspace.json";
    REQUIRE(write_set_file(bare, short_patterns(4)));
    add_paper_set(writing.program.app.ui, writing.paper, bare);
    CHECK(writing.status().is_error);
    CHECK(contains(writing.status().text, "keeps no ratings"));
    CHECK(writing.paper.more.empty());
    writing.bench.load(square_csv());
    const fs::path rated = writing.bench.folder.path / "rated.tactspace.json";
    REQUIRE(write_set_file(rated, writing.program.app.work.document.set));
    add_paper_set(writing.program.app.ui, writing.paper, rated);
    add_paper_set(writing.program.app.ui, writing.paper, rated);  // once is enough
    REQUIRE(writing.paper.more.size() == 1);
    CHECK(writing.paper.more[0].words.starts_with(std::to_string(kRatedPatterns) + " patterns, "));
    writing.write();
    CHECK(contains(bytes_of(writing.out / "paper.html"), rated.string()));
}

TEST_CASE("paper: ratings that nobody gave are called so before anything is made of them") {
    PatternSet set = short_patterns(3);
    set.ratings.push_back({"P1", {"p1", "p2", "p3"}, {1.0, 2.0, 3.0}, {}});
    set.ratings.push_back({"P2", {"p1", "p2", "p3"}, {1.0, 2.0, 3.0}, {}});
    CHECK(words_on_ratings(set) == "3 patterns, ratings of 2 people");
    set.ratings[1].mark.synthetic = true;
    CHECK(words_on_ratings(set) == "3 patterns, synthetic ratings of 2 people");
}

TEST_CASE("paper: what the program says of a failure is told, and nothing is left") {
    Writing writing(
        "mkdir -p \"$7\" 2>/dev/null; echo 'comparing' >&2; "
        "echo 'tactspace: the third pattern is odd' >&2; exit 1\n");
    writing.bench.load(square_csv());
    writing.write();
    CHECK(writing.status().is_error);
    CHECK(writing.status().text == "Nothing was made: the third pattern is odd");
    CHECK_FALSE(fs::exists(writing.out));
    // A folder that holds something is left alone.
    fs::create_directories(writing.out);
    writing.bench.folder.write("paper of it/mine.txt", "mine");
    writing.write();
    CHECK(contains(writing.status().text, "expected a folder that is empty"));
    CHECK(bytes_of(writing.out / "mine.txt") == "mine");
}

TEST_CASE("paper: Cancel ends the work, and takes what was begun away") {
    Writing writing(
        "while [ $# -gt 0 ]; do [ \"$1\" = --out ] && mkdir -p \"$2\"; shift; done; sleep 600\n");
    writing.bench.load(square_csv());
    write_paper(writing.program.app.ui, writing.program.app.work, writing.paper, {}, writing.out);
    wait_until(writing.program, [&] { return fs::exists(writing.out); });
    wait_until(writing.program, [&] { return writing.program.shows("button:cancel paper"); });
    writing.program.click("button:cancel paper");
    wait_until(writing.program, [&] { return !is_writing_paper(writing.paper); });
    CHECK_FALSE(fs::exists(writing.out));
    CHECK(writing.status().text == "No tables and figures were made.");
}

}  // namespace paper_dialog_test
