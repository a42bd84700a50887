#include "app/manual/manual.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "app/command_line/command_line.h"
#include "app/command_line/commands.h"
#include "app/manual/parts.h"
#include "app/report/report.h"
#include "app/ui/widgets.h"
#include "app/window/window.h"
#include "assets/assets.h"
#include "model/io/set/set_file.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/text/numbers.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/times_in.h"

namespace manual_test {

using namespace tact;

namespace {

std::string page_made_now() {
    const TemporaryFolder folder;
    const auto file = folder.path / "manual.html";
    const auto made = run(ManualCommand{file});
    REQUIRE_MESSAGE(made, (made ? "" : made.error().message));
    return bytes_of(file);
}

const std::string& page() {
    static const std::string made = page_made_now();
    return made;
}

// What stands behind each `name="`, up to the next quote.
std::vector<std::string> values_of(const std::string& html, const std::string& name) {
    std::vector<std::string> values;
    const std::string start = " " + name + "=\"";
    for (std::size_t at = html.find(start); at != html.npos; at = html.find(start, at + 1)) {
        const std::size_t from = at + start.size();
        values.push_back(html.substr(from, html.find('"', from) - from));
    }
    return values;
}

Expected<std::string> shouted(std::string_view word, std::string_view rest) {
    if (word != "shout") return Error{"expected shout, got \"" + std::string(word) + "\""};
    return std::string(rest) + "!";
}

}  // namespace

TEST_CASE("manual: what stands between braces is made, and what nobody makes is an error") {
    CHECK(*filled("a {{shout b c}} d {{shout}}", "x", shouted) == "a b c! d !");
    CHECK(*filled("plain } { text", "x", shouted) == "plain } { text");
    CHECK(filled("one\ntwo {{whisper}}", "x.html", shouted).error().message ==
          "x.html:2: expected shout, got \"whisper\"");
    CHECK(filled("{{shout", "x", shouted).error().message == "x:1: expected }} on the line of {{");
    CHECK_FALSE(filled("{{shout\n}}", "x", shouted));
    KnownNumbers numbers;
    for (const char* what : {"", "nothing", "no_such_set stress1", "pm_2023_twelve",
                             "pm_2023_twelve likeness", "pm_2023_twelve picked some"}) {
        CAPTURE(what);
        CHECK_FALSE(number_text(numbers, what));
    }
    CHECK_FALSE(table_html("furniture"));
}

TEST_CASE("manual: the page is whole, and the same each time" * doctest::test_suite("long")) {
    CHECK(times_in(page(), "{{") == 0);
    for (const ManualChapter& chapter : manual_chapters()) {
        CAPTURE(std::string(chapter.id));
        CHECK(times_in(page(), "<section id=\"" + std::string(chapter.id) + "\">") == 1);
    }
    CHECK((page_made_now() == page()));
}

TEST_CASE("manual: every link within the page leads somewhere, and no name is given twice" *
          doctest::test_suite("long")) {
    const std::vector<std::string> ids = values_of(page(), "id");
    const std::set<std::string> known(ids.begin(), ids.end());
    CHECK(known.size() == ids.size());
    std::size_t inner = 0;
    for (const std::string& target : values_of(page(), "href")) {
        CAPTURE(target);
        if (target.starts_with("#")) {
            ++inner;
            CHECK(known.contains(target.substr(1)));
        } else {
            CHECK(target.starts_with("https://"));
        }
    }
    CHECK(inner > manual_chapters().size());
    for (const char* fetched : {" src=", "url(http", "@import", "<script", "<link"}) {
        CHECK(times_in(page(), fetched) == 0);
    }
}

TEST_CASE("manual: its pictures are drawn for both themes, and say what they show") {
    std::size_t asked = 0;
    for (const ManualChapter& chapter : manual_chapters()) {
        asked += times_in(std::string(asset(std::string("manual/") + chapter.id + ".html")),
                          "{{picture ");
    }
    CHECK(asked > 0);
    CHECK(times_in(page(), "<figure id=\"picture-") == asked);
    CHECK(times_in(page(), "<svg role=\"img\" aria-label=\"") == 2 * asked);
    CHECK(times_in(page(), "aria-label=\"\"") == 0);
    CHECK(times_in(page(), "Nothing picked yet") == 0);
}

TEST_CASE("manual: every command of the command line is there with its options") {
    const auto all = command_help();
    CHECK(all.size() > 15);
    for (const CommandHelp& command : all) {
        CAPTURE(command.name);
        CHECK(times_in(page(), "id=\"command-" + command.name + "\"") == 1);
        CHECK_FALSE(command.summary.empty());
        CHECK((times_in(page(), html_escaped(command.text)) == 1));
        CHECK(contains(command.text, "Usage: tactspace " + command.name));
    }
}

TEST_CASE("manual: every key and every command of the window is there") {
    for (const KeyRow& row : keys_and_mouse()) {
        CAPTURE(std::string(row.keys));
        CHECK(contains(page(),
                       "<td>" + html_escaped(row.keys) + "</td><td>" + html_escaped(row.what)));
    }
    for (const Command& command : commands()) {
        const std::string_view menu = command.menu;
        if (menu.empty()) continue;
        if (menu == kExampleMenu) {
            CHECK(contains(page(), "<li>" + html_escaped(command.name) + "</li>"));
            continue;
        }
        CAPTURE(std::string(command.name));
        const std::string keys = shortcut_text(command.shortcut);
        CHECK(contains(page(), "<td>" + html_escaped(command.name) + "</td>" +
                                   "<td class=\"number\">" +
                                   (keys.empty() ? "</td>" : "<kbd>" + html_escaped(keys))));
    }
}

TEST_CASE("manual: every tab of the lower right pane is explained, in the order of the tabs") {
    const std::string panes(asset("manual/panes.html"));
    std::size_t last = panes.find("<h3 id=\"pane-matrix\">");
    REQUIRE(last != panes.npos);
    for (const BenchRow& row : kBenchTabs) {
        CAPTURE(row.label);
        const std::size_t at = panes.find("<dt>" + html_escaped(row.label) + "</dt><dd>", last + 1);
        REQUIRE(at != panes.npos);
        last = at;
    }
}

TEST_CASE("manual: no number that the model gives is typed by hand") {
    const std::regex made("\\{\\{[^}]*\\}\\}|<pre>[^<]*</pre>");
    const std::regex typed(
        "PM (is |of )?\\.?[0-9]|stress[-1a-z ]{0,12} \\.?[0-9]|rho (is |of )?\\.?[0-9]|"
        "[0-9]+ (patterns|pairs|signals|metrics|combinations|sets)\\b");
    CHECK(std::regex_search("whose pair has PM 31.25", typed));
    for (const ManualChapter& chapter : manual_chapters()) {
        CAPTURE(std::string(chapter.id));
        const std::string text(asset(std::string("manual/") + chapter.id + ".html"));
        std::smatch found;
        const std::string left = std::regex_replace(text, made, "");
        CHECK_MESSAGE(!std::regex_search(left, found, typed), found.str());
    }
}

TEST_CASE("manual: its numbers are the model's" * doctest::test_suite("long")) {
    const char* file = "sets/pm_2023_twelve.tactspace.json";
    const PatternSet set = *parse_set(asset(file), file, {});
    const Dissimilarity pm = predict(model_waveforms(set), set.model)->pm;
    KnownNumbers numbers;
    const auto number = [&](const char* key) {
        return *number_text(numbers, std::string("pm_2023_twelve ") + key);
    };
    CHECK(number("patterns") == std::to_string(set.vibrations.size()));
    CHECK(number("pairs") == std::to_string(pm.condensed.size()));
    const auto [least, most] = std::ranges::minmax(pm.condensed);
    CHECK(number("nearest_pm") == significant_digits(least, 4));
    CHECK(number("farthest_pm") == significant_digits(most, 4));
    // The two most distinct patterns are those that are farthest apart.
    CHECK(number("weakest 2") == number("farthest_pm"));
    CHECK(number("picked 2") == number("farthest"));
    CHECK(number("picked 12").starts_with("L-0-half, L-0-full, "));
    CHECK(number("weakest 12") == number("nearest_pm"));
}

}  // namespace manual_test
