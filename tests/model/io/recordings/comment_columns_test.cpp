// What comments before the numbers of a recording say: names of columns, its rate.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "model/io/recordings/acceleration_file.h"
#include "model/signal/waveform.h"
#include "tests/support/temporary_folder.h"

namespace comment_columns_test {

using namespace tact;

namespace {

double motion(int n) { return 0.5 * std::sin(0.1 * 3.14159265358979 * n); }

// 500 rows at 1 kHz; `cells` makes one of them.
template <class Cells>
std::string table(const std::string& head, const Cells& cells) {
    std::string text = head;
    for (int n = 0; n < 500; ++n) text += cells(n) + "\n";
    return text;
}

Expected<Recording> read(const std::string& text) {
    const TemporaryFolder folder;
    return read_acceleration_file(folder.write("a.txt", text));
}

bool remarks_have(const Recording& recording, const std::string& words) {
    for (const std::string& remark : recording.remarks) {
        if (remark.find(words) != remark.npos) return true;
    }
    return false;
}

std::string with_steps(int n) {
    return std::to_string(motion(n)) + " 0.000 1.000 " + (n % 2 == 0 ? "0.5" : "1.5");
}

}  // namespace

TEST_CASE("comment columns: the last comment names the columns, and a step is no time") {
    for (const char* head :
         {"# Accelerometer values\n\n# x value, y value, z value, time diff in ms\n",
          "% a logger\n%X Y Z dt_ms\n", "#x;y;z;Time step (ms)\n\n"}) {
        CAPTURE(head);
        const auto recording = read(table(head, with_steps));
        REQUIRE_MESSAGE(recording, recording.error().message);
        CHECK(duration_s(recording->waveform) == doctest::Approx(0.5).epsilon(0.01));
        CHECK(peak_g(recording->waveform) == doctest::Approx(0.5).epsilon(0.02));
    }
}

TEST_CASE("comment columns: names in the line before the numbers outdo those of a comment") {
    const auto cells = [](int n) {
        return std::to_string(0.001 * n) + "," + std::to_string(motion(n));
    };
    const auto recording = read(table("# x, time in ms\nt (s),x (g)\n", cells));
    REQUIRE_MESSAGE(recording, recording.error().message);
    CHECK(duration_s(recording->waveform) == doctest::Approx(0.5).epsilon(0.01));
    // A comment of as many words names nothing.
    const auto plain = read(table("# made, today\n", cells));
    REQUIRE_MESSAGE(plain, plain.error().message);
    CHECK(duration_s(plain->waveform) == doctest::Approx(0.5).epsilon(0.01));
}

TEST_CASE("comment columns: a rate in a comment is taken where no times are, and said") {
    const auto cells = [](int n) {
        return std::to_string(n) + "," + std::to_string(motion(n)) + ",0.000,1.000,12,3,4";
    };
    for (const char* rate : {"# sample rate: 1000 Hz\n", "# Sampling frequency = 1.0 kHz\n",
                             "# device 7\n# rate_hz=1000\n# note\n"}) {
        CAPTURE(rate);
        const auto recording =
            read(table(std::string(rate) + "count,a_x,a_y,a_z,g_x,g_y,g_z\n", cells));
        REQUIRE_MESSAGE(recording, recording.error().message);
        CHECK(duration_s(recording->waveform) == doctest::Approx(0.5).epsilon(0.01));
        CHECK(remarks_have(*recording, "rate of 1000 Hz, as a comment says"));
    }
    const auto timed = [](int n) {
        return std::to_string(0.002 * n) + "," + std::to_string(motion(n));
    };
    const auto recording = read(table("# rate 1000 Hz\nt (s),x\n", timed));
    REQUIRE_MESSAGE(recording, recording.error().message);
    CHECK(duration_s(recording->waveform) == doctest::Approx(1.0).epsilon(0.01));
}

}  // namespace comment_columns_test
