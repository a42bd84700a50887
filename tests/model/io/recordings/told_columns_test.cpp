// What somebody says of a table of accelerations, where its names say too little.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "model/io/recordings/acceleration_file.h"
#include "model/signal/waveform.h"
#include "tests/support/temporary_folder.h"

namespace told_columns_test {

using namespace tact;

namespace {

double sample(int n) { return 0.5 * std::sin(0.1 * 3.14159265358979 * n); }

std::string with_commas(std::string text) {
    for (char& c : text) c = c == '.' ? ',' : c;
    return text;
}

// A counter, a clock in ms and two axes, of which the second is the vibration.
std::string table(const std::string& head, char separator, bool has_commas = false) {
    std::string text = head.empty() ? "" : head + "\n";
    for (int n = 0; n < 500; ++n) {
        std::string row = std::to_string(7 + n) + ";" + std::to_string(1.0 * n) + ";" +
                          std::to_string(0.01 * (n % 3)) + ";" + std::to_string(sample(n));
        if (has_commas) row = with_commas(row);
        for (char& c : row) c = c == ';' ? separator : c;
        text += row + "\n";
    }
    return text;
}

Expected<Recording> read(const std::string& text, const std::string& columns,
                         std::optional<TimeUnit> unit = {}, const TableHints& written = {}) {
    const TemporaryFolder folder;
    AccelerationOptions options;
    const auto named = acceleration_columns(columns);
    REQUIRE(named);
    options.table = {*named, unit, written};
    return read_acceleration_file(folder.write("a.csv", text), options);
}

std::string fault_of(const Expected<Recording>& recording) {
    if (recording) return "";
    const std::string& all = recording.error().message;
    return all.substr(all.find("expected"));
}

}  // namespace

TEST_CASE("told columns: those that are named are read, by name or by number") {
    const std::string text = table("no;when;q;force", ';');
    const auto by_name = read(text, "time=when,x=force", TimeUnit::ms);
    REQUIRE_MESSAGE(by_name, by_name.error().message);
    CHECK(peak_g(by_name->waveform) == doctest::Approx(0.5).epsilon(0.01));
    CHECK(by_name->waveform.samples_g.size() == 5000);
    for (const char* columns : {"time=2,x=4", "time=2, x=force", "x=4,time=when"}) {
        CAPTURE(columns);
        const auto same = read(text, columns, TimeUnit::ms);
        REQUIRE_MESSAGE(same, same.error().message);
        CHECK(same->waveform.samples_g == by_name->waveform.samples_g);
    }
    const auto nameless = read(table("", ';'), "time=2,x=4", TimeUnit::ms);
    REQUIRE_MESSAGE(nameless, nameless.error().message);
    CHECK(nameless->waveform.samples_g == by_name->waveform.samples_g);
}

TEST_CASE("told columns: one that is not there is refused with those that are") {
    const std::string text = table("no;when;q;force", ';');
    CHECK(fault_of(read(text, "time=when,x=Force")) ==
          "expected a column \"Force\", the columns are no, when, q, force");
    CHECK(fault_of(read(text, "x=5")) ==
          "expected a column \"5\", the columns are no, when, q, force");
    CHECK(fault_of(read(text, "time=when,x=q,y=q")) ==
          "expected a column of its own for each, got \"q\" twice");
    CHECK(fault_of(read(text, "time=q,x=q")) ==
          "expected a column of its own for each, got \"q\" twice");
}

TEST_CASE("told columns: roles that nobody knows are refused") {
    for (const char* wrong : {"t=when", "x", "x=", "x=a,x=b", "=a", "x=a,,y=b"}) {
        CAPTURE(wrong);
        CHECK_FALSE(acceleration_columns(wrong));
    }
    CHECK(acceleration_columns("w=1").error().message ==
          "expected time, x, y and z, each once as ROLE=COLUMN, got \"w=1\"");
    CHECK(*acceleration_columns("") == AccelerationColumns{});
}

TEST_CASE("told columns: a unit of times agrees with the name, and needs times") {
    const std::string plain = table("no;when;q;force", ';');
    const auto ms = read(plain, "time=when,x=force", TimeUnit::ms);
    REQUIRE(ms);
    // The unit that is said puts an unknown one right.
    const auto ticks = read(table("no;time (ticks);q;force", ';'), "x=force", TimeUnit::ms);
    REQUIRE_MESSAGE(ticks, ticks.error().message);
    CHECK(ticks->waveform.samples_g == ms->waveform.samples_g);
    CHECK(read(table("no;time (ms);q;force", ';'), "x=force", TimeUnit::ms));
    CHECK(fault_of(read(table("no;time (ms);q;force", ';'), "x=force", TimeUnit::us)) ==
          "expected times in the unit that the column \"time (ms)\" says, got the unit us beside "
          "it");
    CHECK(fault_of(read("x\n0\n1\n0\n1\n", "", TimeUnit::ms)) ==
          "expected a column of times, as a unit of them is given, got none");
}

TEST_CASE("told columns: a separator and a decimal sign that somebody says hold") {
    const auto plain = read(table("no;when;q;force", ';'), "time=when,x=force", TimeUnit::ms);
    REQUIRE(plain);
    const auto german =
        read(table("no;when;q;force", ';', true), "time=when,x=force", TimeUnit::ms, {';', ','});
    REQUIRE_MESSAGE(german, german.error().message);
    CHECK(german->waveform.samples_g == plain->waveform.samples_g);
    // Two columns of decimal commas without names are doubtful until somebody says which.
    std::string doubtful;
    for (int n = 0; n < 500; ++n)
        doubtful += std::to_string(n) + "," + std::to_string(n % 2) + "\n";
    CHECK(fault_of(read(doubtful, "")) != "");
    CHECK(read(doubtful, "", TimeUnit::ms, {',', '.'}));
    // Points do not count if commas were said to be decimal.
    CHECK(fault_of(read(table("no;when;q;force", ';'), "time=when,x=force", TimeUnit::ms,
                        {',', {}})) != "");
}

TEST_CASE("told columns: a recording of sound takes none of them") {
    const TemporaryFolder folder;
    AccelerationOptions options;
    options.table.columns.x = "x";
    const auto wave = read_acceleration_file(folder.write("a.wav", "RIFF"), options);
    REQUIRE_FALSE(wave);
    CHECK(wave.error().message.ends_with("which belong to tables"));
    const std::filesystem::path both[] = {"a.wav", "b.csv"};
    CHECK(options_among(both[0], both, options).table == AccelerationTableOptions{});
    CHECK(options_among(both[1], both, options).table == options.table);
}

}  // namespace told_columns_test
