// Every option of the program that is a number, as the program itself lists them; and the help that
// options share.
#include <doctest/doctest.h>

#include <iostream>
#include <sstream>

#include "app/command_line/command_line.h"
#include "app/command_line/options.h"
#include "tests/support/format_words.h"

namespace number_options_test {

using namespace tact;

namespace {

struct NumberOption {
    std::string command;  // "" is the program itself
    std::string name;     // --level
    bool is_whole = false;
};

// Groups of options have no name of their own and are part of their command.
void collect(const CLI::App& app, const std::string& command, std::vector<NumberOption>& found) {
    for (const CLI::Option* option : app.get_options()) {
        const std::string type = option->get_type_name();
        const bool is_whole = type.starts_with("INT") || type.starts_with("UINT");
        if (!is_whole && !type.starts_with("FLOAT") && !type.starts_with("NUMBER")) continue;
        found.push_back({command, option->get_name(), is_whole});
    }
    for (const CLI::App* sub : app.get_subcommands(std::function<bool(const CLI::App*)>{})) {
        collect(*sub, sub->get_name().empty() ? command : sub->get_name(), found);
    }
}

std::vector<NumberOption> number_options() {
    CLI::App app;
    Commands commands;
    Chosen chosen;
    add_commands(app, commands, chosen);
    std::vector<NumberOption> found;
    collect(app, "", found);
    return found;
}

struct Said {
    int exit_code = 0;
    std::string err;
};

// In this process: two hundred programs would take their time.
Said said_to(const NumberOption& option, const std::string& value) {
    const std::vector<const char*> words{"tactspace", option.command.c_str(), option.name.c_str(),
                                         value.c_str()};
    std::ostringstream err;
    std::streambuf* const before = std::cerr.rdbuf(err.rdbuf());
    const int exit_code = run_command_line(static_cast<int>(words.size()), words.data(), nullptr);
    std::cerr.rdbuf(before);
    return {exit_code, err.str()};
}

void check_refusal(const NumberOption& option, const std::string& value) {
    CAPTURE(option.command);
    CAPTURE(option.name);
    CAPTURE(value);
    const Said said = said_to(option, value);
    CHECK(said.exit_code == 2);
    const std::string head = option.name + ": expected a number from ";
    CHECK_MESSAGE(said.err.starts_with(head), said.err);
    CHECK_MESSAGE(said.err.find("got \"" + value + "\"\n") != std::string::npos, said.err);
}

}  // namespace

TEST_CASE("options: no number of any command may be NaN, infinite, empty or in another notation" *
          doctest::test_suite("long")) {
    const std::vector<NumberOption> options = number_options();
    REQUIRE(options.size() > 50);  // or the list is not what the program has
    for (const NumberOption& option : options) {
        for (const char* value : {"nan", "NaN", "-nan", "inf", "-inf", "1e999", "-1e999", "0x1p1",
                                  "0x10", "", " ", "1,5", "one", "1 2", "1e300", "01"}) {
            check_refusal(option, value);
        }
    }
}

TEST_CASE("options: the help of SET names every format of effects that is read") {
    CHECK(read_formats_missing_in(kSetHelp) == std::vector<std::string>());
}

TEST_CASE("options: a number that is read is the number that was looked at") {
    double level = -1.0;
    int count = -1;
    const auto read = [&](const char* name, const char* text) {
        CLI::App app;
        app.add_option("--level", level)->check(within(0.0, 1000.0));
        app.add_option("--count", count)->check(within(0.0, 1000.0));
        const std::vector<const char*> words{"test", name, text};
        app.parse(static_cast<int>(words.size()), words.data());
    };
    read("--level", "-0");
    CHECK(level == 0.0);
    read("--level", "5e-324");
    CHECK(level == 5e-324);
    read("--level", "1e3");
    CHECK(level == 1000.0);
    read("--count", "10");
    CHECK(count == 10);
    CHECK_THROWS_AS(read("--count", "010"), CLI::ValidationError);  // to others it is eight
    CHECK_THROWS_AS(read("--count", "-010"), CLI::ValidationError);
    CHECK_THROWS_AS(read("--count", "1e2"), CLI::ConversionError);
    CHECK_THROWS_AS(read("--count", "2.5"), CLI::ConversionError);
    CHECK_THROWS_AS(read("--count", "1000.5"), CLI::ValidationError);
}

}  // namespace number_options_test
