#include "model/io/recordings/acceleration_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "model/signal/resample.h"
#include "model/text/numbers.h"
#include "tests/support/golden.h"
#include "tests/support/mutations.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wave_bytes.h"

namespace acceleration_file_test {

using namespace tact;

namespace {

using Samples = std::vector<double>;

Samples sine(double frequency_hz, double rate_hz, std::size_t count, double amplitude = 1.0) {
    Samples samples;
    for (std::size_t n = 0; n < count; ++n) {
        const double t = static_cast<double>(n) / rate_hz;
        samples.push_back(amplitude * std::sin(2.0 * std::numbers::pi * frequency_hz * t));
    }
    return samples;
}

// A whole number of periods of 100 Hz at 10 kHz, in rows of text.
std::string table(const std::string& heading, const std::string& separator, double time_unit_s,
                  double offset, double scale, std::size_t axes = 1) {
    const Samples samples = sine(100.0, 1e4, 500);
    std::string text = heading;
    for (std::size_t n = 0; n < samples.size(); ++n) {
        if (time_unit_s > 0.0) text += shortest_digits(static_cast<double>(n) * 1e-4 / time_unit_s);
        for (std::size_t a = 0; a < axes; ++a) {
            if (a > 0 || time_unit_s > 0.0) text += separator;
            text += shortest_digits(offset + scale * (a == 0 ? samples[n] : 0.0));
        }
        text += "\n";
    }
    return text;
}

std::string with_decimal_commas(std::string text) {
    for (char& c : text) c = c == '.' ? ',' : c;
    return text;
}

struct Case {
    TemporaryFolder folder;

    Expected<Recording> read(const std::string& text, const AccelerationOptions& options = {},
                             const std::string& name = "a.csv") const {
        return read_acceleration_file(folder.write(name, text), options);
    }
    std::string fault(const std::string& text, const AccelerationOptions& options = {}) const {
        const auto recording = read(text, options);
        REQUIRE_FALSE(recording);
        return recording.error().message;
    }
};

// The sine of table() in g.
void check_is_the_sine(const Expected<Recording>& recording) {
    REQUIRE_MESSAGE(recording, recording.error().message);
    CHECK(recording->waveform.rate_hz == kModelRateHz);
    CHECK(golden::worst_difference(recording->waveform.samples_g, sine(100.0, 1e4, 500)) < 1e-12);
}

bool says(const Recording& recording, const std::string& part) {
    return std::ranges::any_of(recording.remarks,
                               [&](const std::string& remark) { return contains(remark, part); });
}

}  // namespace

TEST_CASE("acceleration file: however it is written, the same motion comes out") {
    const Case file;
    AccelerationOptions at_10khz;
    at_10khz.rate_hz = 1e4;
    check_is_the_sine(file.read(table("", "", 0.0, 0.0, 1.0), at_10khz));
    check_is_the_sine(file.read(table("time,a\n", ",", 1.0, 0.0, 1.0)));
    check_is_the_sine(file.read(table("time [ms];acc (g)\n", ";", 1e-3, 0.0, 1.0)));
    check_is_the_sine(file.read(table("t_us\ta_g\n", "\t", 1e-6, 0.0, 1.0)));
    check_is_the_sine(file.read(table("", " ", 1.0, 0.0, 1.0)));
    check_is_the_sine(file.read(table("Logger 7\n# 3 axes\n\nTime (s),Acc (m/s^2)\n", ",", 1.0, 0.0,
                                      kStandardGravityMPerS2)));
    check_is_the_sine(file.read(with_decimal_commas(table("t (ms);x\n", ";", 1e-3, 0.0, 1.0))));
    check_is_the_sine(
        file.read("\xEF\xBB\xBF" + table("# made, today\nt,x\n", ",", 1.0, 0.0, 1.0)));
}

TEST_CASE("acceleration file: gravity and a sensor's offset are no vibration") {
    const Case file;
    check_is_the_sine(file.read(table("t,x (g)\n", ",", 1.0, 1.0, 1.0)));
    AccelerationOptions adxl;
    adxl.unit = AccelerationUnit::volt;
    adxl.sensitivity_v_per_g = 0.4;
    adxl.offset_v = 0.9;
    check_is_the_sine(file.read(table("t,out\n", ",", 1.0, 0.9, 0.4), adxl));
    CHECK(says(*file.read(table("t,x\n", ",", 1.0, 0.0, 1.0)), "taken as g"));
    CHECK_FALSE(says(*file.read(table("t,x (g)\n", ",", 1.0, 0.0, 1.0)), "taken as g"));
}

TEST_CASE("acceleration file: volts without the sensor's sensitivity are refused") {
    const Case file;
    AccelerationOptions volts;
    volts.unit = AccelerationUnit::volt;
    for (const char* head : {"t,ax (V)\n", "t,ax [V]\n", "t,ax_V\n"}) {
        CHECK(contains(file.fault(table(head, ",", 1.0, 0.0, 0.4)), "sensitivity in V/g"));
    }
    CHECK(contains(file.fault(table("t,x\n", ",", 1.0, 0.0, 0.4), volts), "sensitivity in V/g"));
    volts.sensitivity_v_per_g = 0.4;
    check_is_the_sine(file.read(table("t,x\n", ",", 1.0, 0.0, 0.4), volts));
}

TEST_CASE("acceleration file: three axes are one of the same energy, or one is chosen") {
    const Case file;
    const std::string text = table("t,x,y,z\n", ",", 1.0, 0.0, 1.0, 3);
    check_is_the_sine(file.read(text));
    CHECK(says(*file.read(text), "DFT321"));
    AccelerationOptions second;
    second.axis = 2;
    CHECK(contains(file.fault(text, second), "silence"));
    second.axis = 4;
    CHECK(contains(file.fault(text, second), "expected axis 4, got a file of 3"));
    CHECK(contains(file.fault("t,x,y\n0,1,1\n0.001,2,2\n"), "expected 1 or 3 axes, got 2"));
}

TEST_CASE("acceleration file: columns beside the axes are passed over") {
    const Case file;
    const auto recording = file.read(
        "sample,time (ms),acc_x,acc_y,acc_z,temperature\n1,0,1,0,0,20\n2,0.1,-1,0,0,20\n");
    REQUIRE_MESSAGE(recording, recording.error().message);
    CHECK(std::abs(recording->waveform.samples_g[0] - 1.0) < 1e-12);
    CHECK(std::abs(recording->waveform.samples_g[1] + 1.0) < 1e-12);
}

TEST_CASE("acceleration file: a total of the axes is none of them, and others are named") {
    const Case files;
    const auto wide = [](const std::string& heading, std::size_t axes) {
        return table(heading, ",", 1.0, 0.0, 1.0, axes);
    };
    const auto three = files.read(wide("t,x (g),y (g),z (g)\n", 3));
    REQUIRE(three);
    for (const char* heading :
         {"Time (s),Linear Acceleration x (g),Linear Acceleration y (g),Linear Acceleration z (g),"
          "Absolute acceleration (g)\n",
          "time,gFx,gFy,gFz,TgF\n", "time,user acc x,user acc y,user acc z,Magnitude\n"}) {
        CAPTURE(heading);
        const auto read = files.read(wide(heading, 4));
        REQUIRE_MESSAGE(read, read.error().message);
        CHECK(read->waveform.samples_g == three->waveform.samples_g);
    }
    CHECK(contains(files.fault(wide("t,north,east,up,down\n", 4)),
                   "got 4 (north, east, up, down): one has to be chosen"));
}

TEST_CASE("acceleration file: encodings and the times of a clock are read, times alone refused") {
    const Case files;
    const std::string plain = table("t (s),x (g)\n", ",", 1.0, 0.0, 1.0);
    const auto read = files.read(plain);
    REQUIRE(read);
    std::string wide = "\xFF\xFE";
    for (const char one : plain) wide += std::string{one, '\0'};
    const auto utf16 = files.read(wide);
    REQUIRE_MESSAGE(utf16, utf16.error().message);
    CHECK(utf16->waveform.samples_g == read->waveform.samples_g);
    std::string old = plain;
    std::ranges::replace(old, '\n', '\r');
    const auto cr = files.read(old);
    REQUIRE_MESSAGE(cr, cr.error().message);
    CHECK(cr->waveform.samples_g == read->waveform.samples_g);
    std::string clock = "timestamp,x (g)\n";
    const Samples samples = sine(100.0, 1e4, 500);
    for (std::size_t n = 0; n < samples.size(); ++n) {
        char time[64];
        std::snprintf(time, sizeof time, "2026-01-02T10:00:%09.6fZ,", 59.98 + 1e-4 * double(n));
        if (n >= 200) {
            std::snprintf(time, sizeof time, "2026-01-02T10:01:%09.6fZ,", 1e-4 * double(n - 200));
        }
        clock += time + shortest_digits(samples[n]) + "\n";
    }
    const auto by_clock = files.read(clock);
    REQUIRE_MESSAGE(by_clock, by_clock.error().message);
    CHECK(by_clock->waveform.samples_g.size() == read->waveform.samples_g.size());
    CHECK(contains(files.fault("Timestamp,X,Y,Z\n0.000\n0.001\n0.002\n"), "got times alone"));
    CHECK(contains(files.fault("time (s)\n0.000\n0.001\n0.002\n"), "got times alone"));
}

TEST_CASE("acceleration file: times without a unit are seconds, unless no rate would be") {
    const Case file;
    CHECK(says(*file.read("t,x\n0,1\n2,2\n4,0\n"), "times taken as ms"));
    CHECK(says(*file.read("t,x\n0,1\n500,2\n1000,0\n"), "times taken as us"));
    CHECK(says(*file.read("t,x\n0,1\n1000000,2\n2000000,0\n"), "times taken as ns"));
    CHECK_FALSE(says(*file.read(table("t,x\n", ",", 1.0, 0.0, 1.0)), "times taken"));
}

TEST_CASE("acceleration file: times that two units would make a recording of are asked for") {
    const Case file;
    for (const double step : {0.02, 0.1, 0.5, 20.0, 50.0, 2e4}) {
        CAPTURE(step);
        std::string text = "TIME,X\n";
        for (int n = 0; n < 10; ++n) {
            text += shortest_digits(685271.0 + step * n) + "," + std::to_string(n % 2) + "\n";
        }
        CHECK(contains(file.fault(text), "whose name says their unit"));
    }
    CHECK(contains(file.fault("t,x\n0,1\n0.02,2\n0.04,0\n"), "50 Hz in s"));
    // A name that says it is believed, and held to the limits.
    CHECK(contains(file.fault("t (s),x\n0,1\n0.02,2\n0.04,0\n"), "expected a rate of 100 Hz"));
    CHECK(file.read("millis,ax\n0,1\n1,2\n2,0\n"));
    CHECK(file.read("t in ms,x\n0,1\n0.5,2\n1,0\n"));
    CHECK(contains(file.fault("t (min),x\n0,1\n1,2\n"), "got \"min\" in the name \"t (min)\""));
}

TEST_CASE("acceleration file: a unit that a column names is taken, and never overridden") {
    const Case file;
    const auto text = [](const std::string& name, double scale) {
        return table("t;" + name + "\n", ";", 1.0, 0.0, scale);
    };
    check_is_the_sine(file.read(text("Beschleunigung in m/s\u00b2", kStandardGravityMPerS2)));
    check_is_the_sine(file.read(text("x in m/s^2", kStandardGravityMPerS2)));
    const std::pair<const char*, const char*> unknown[] = {{"x (mg)", "mg"},
                                                           {"a_mg", "mg"},
                                                           {"x [gal]", "gal"},
                                                           {"accel (mm/s2)", "mm/s2"},
                                                           {"mV", "mv"},
                                                           {"a_counts", "counts"},
                                                           {"x in mg", "mg"},
                                                           {"acc (LSB)", "lsb"},
                                                           {"ax (ft/s2)", "ft/s2"},
                                                           {"adc", "adc"},
                                                           {"x (milli-g)", "milli-g"}};
    AccelerationOptions g;
    g.unit = AccelerationUnit::g;
    for (const auto& [name, unit] : unknown) {
        CAPTURE(name);
        const std::string named = std::string("got \"") + unit + "\"";
        CHECK(contains(file.fault(text(name, 1.0)), named));
        CHECK(contains(file.fault(text(name, 1.0), g), named));
    }
    for (const char* volts : {"V", "voltage", "Volt", "a (V)", "x_V", "Ch A in V"}) {
        CAPTURE(volts);
        CHECK(contains(file.fault(text(volts, 1.0)), "sensitivity in V/g"));
        CHECK(contains(file.fault(text(volts, 1.0), g), "got the unit g beside it"));
    }
    check_is_the_sine(file.read(text("x (g)", 1.0), g));
    CHECK(contains(file.fault("t,x (g),y (m/s2),z (g)\n0,1,1,1\n0.001,2,2,2\n"), "one unit"));
}

TEST_CASE("acceleration file: an option that the file has no use for is refused") {
    const Case file;
    const std::string text = table("t,x (g)\n", ",", 1.0, 0.0, 1.0);
    AccelerationOptions sensor;
    sensor.sensitivity_v_per_g = 0.1;
    CHECK(contains(file.fault(text, sensor), "with a recording in V alone"));
    CHECK(contains(file.fault(table("t,x\n", ",", 1.0, 0.0, 1.0), sensor), "V alone"));
    AccelerationOptions offset;
    offset.offset_v = 1.65;
    CHECK(contains(file.fault(text, offset), "with a recording in V alone"));
    AccelerationOptions full;
    full.full_scale = 2.0;
    CHECK(contains(file.fault(text, full), "belongs to .wav files"));
    AccelerationOptions rate;
    rate.rate_hz = 1e4;
    WaveBytes wave;
    wave.samples = {0.5, 0.25};
    const auto refused = file.read(wave.file(), rate, "a.wav");
    REQUIRE_FALSE(refused);
    CHECK(contains(refused.error().message, "expected no rate"));
}

TEST_CASE("acceleration file: silence, and counts of a converter, are no recording in g") {
    const Case file;
    CHECK(contains(file.fault("t,x\n0,0\n0.001,0\n0.002,0\n"), "got silence"));
    CHECK(contains(file.fault("t,x (g)\n0,1\n0.001,1\n0.002,1\n"), "got silence"));
    CHECK(contains(file.fault(table("t,x\n", ",", 1.0, 0.0, 16384.0)), "counts of a converter"));
    CHECK(file.read(table("t,x (g)\n", ",", 1.0, 0.0, 200.0)));
    CHECK(file.read(table("t,x\n", ",", 1.0, 2048.0, 3.0)));  // an offset is no vibration
}

TEST_CASE("acceleration file: uneven times are evened, little ones let be") {
    const Case file;
    const auto text = [](double jitter) {
        std::string rows = "t,x (g)\n";
        for (std::size_t n = 0; n < 1000; ++n) {
            const double t = 1e-4 * (static_cast<double>(n) + (n % 2 == 1 ? jitter : 0.0));
            rows += shortest_digits(t) + "," +
                    shortest_digits(std::sin(2.0 * std::numbers::pi * 50.0 * t)) + "\n";
        }
        return rows;
    };
    CHECK_FALSE(says(*file.read(text(0.004)), "evened"));
    const auto evened = file.read(text(0.3));
    CHECK(says(*evened, "evened out"));
    // Straight lines stray from a sine by up to (w h)^2 / 8, h a step.
    const auto expected = file.read(text(0.0));
    REQUIRE(evened->waveform.samples_g.size() == expected->waveform.samples_g.size());
    const auto inner = [](const Samples& all) { return Samples(all.begin() + 50, all.end() - 50); };
    CHECK(golden::worst_difference(inner(evened->waveform.samples_g),
                                   inner(expected->waveform.samples_g)) < 3e-3);
}

TEST_CASE("acceleration file: steps that stray by one part in a hundred are uneven, by less even") {
    const Case file;
    const auto is_evened = [&](double first_step) {
        std::string rows = "t,x (g)\n0,1\n" + shortest_digits(first_step) + ",2\n";
        for (int n = 2; n < 2000; ++n)
            rows += shortest_digits(n) + "," + std::to_string(n % 3) + "\n";
        return says(*file.read(rows), "evened");  // a mean step of 1 ms
    };
    CHECK_FALSE(is_evened(1.0));
    CHECK_FALSE(is_evened(1.0095));
    CHECK_FALSE(is_evened(0.9905));
    CHECK(is_evened(1.0105));
    CHECK(is_evened(0.9895));
}

TEST_CASE("acceleration file: decimal commas in a single column are decimals, not columns") {
    const Case file;
    AccelerationOptions at_10khz;
    at_10khz.rate_hz = 1e4;
    const std::string plain = table("accel (g)\n", "", 0.0, 0.0, 1.0);
    check_is_the_sine(file.read(with_decimal_commas(plain), at_10khz));
    const std::string few = "x\n0\n0,5\n-0,25\n+1\n";
    const auto recording = file.read(few, at_10khz);
    REQUIRE_MESSAGE(recording, recording.error().message);
    CHECK(recording->waveform.samples_g == Samples{-0.3125, 0.1875, -0.5625, 0.6875});
}

TEST_CASE("acceleration file: commas that may be decimal ones are not guessed at") {
    const Case file;
    AccelerationOptions rate;
    rate.rate_hz = 1e4;
    for (const char* text : {"0,0471\n0,0473\n-1,0022\n", "Logger 7\n0,0471\n0,0473\n",
                             "# two or one?\n1,5\n2,5\n", "t,x\n0,001,0,0471\n0,002,0,0473\n"}) {
        CAPTURE(text);
        CHECK(contains(file.fault(text, rate), "these commas may be decimal ones"));
    }
    CHECK(contains(file.fault("x (g)\n1.234,5\n1.234,6\n", rate), "names one column, got 2"));
    // Whatever tells: names, a decimal point, a sign, a blank, a number of columns.
    CHECK(file.read("t,x\n0,471\n1,473\n", rate));
    for (const char* rows : {"0,1\n1,2.5\n", "0,1\n1,-2\n", "0, 1\n1, 2\n", "0,1\n1,2e1\n",
                             "0,1,2\n1,2,3\n", "0;1\n1;2\n"}) {
        CAPTURE(rows);
        CHECK(file.read(rows, rate));
    }
}

TEST_CASE("acceleration file: points and commas together are no decimal signs") {
    const Case file;
    AccelerationOptions rate;
    rate.rate_hz = 1e4;
    CHECK(
        contains(file.fault("t;x\n0;0.5\n1;1,234\n", rate), "a.csv:3: expected one decimal sign"));
    CHECK(contains(file.fault("0,5\t1\n0.5\t2\n", rate), "a.csv:2: expected one decimal sign"));
    CHECK_FALSE(file.read("t;x\n0;1\n1;1.234,5\n", rate));
    CHECK(file.read("t;x;note\n0;0,5;1.1\n1;1,234;1.1\n", rate));  // columns nobody reads
}

TEST_CASE("acceleration file: no NaN comes in beside the numbers of the file") {
    const Case file;
    const double nan = std::nan("");
    for (double AccelerationOptions::*number :
         {&AccelerationOptions::sensitivity_v_per_g, &AccelerationOptions::offset_v}) {
        AccelerationOptions options;
        options.unit = AccelerationUnit::volt;
        options.*number = nan;
        CHECK(contains(file.fault("t,x\n0,0.5\n0.001,0.25\n", options), "got nan"));
    }
    AccelerationOptions options;
    options.full_scale = nan;
    CHECK(contains(file.fault("t,x\n0,0.5\n0.001,0.25\n", options), "got nan"));
    options.full_scale.reset();
    options.rate_hz = nan;
    CHECK(contains(file.fault("t,x\n0,0.5\n0.001,0.25\n", options), "got nan"));
}

TEST_CASE("acceleration file: a table after an accident is refused, or its numbers are kept") {
    std::size_t accepted = 0;
    for (unsigned seed = 0; seed < 300; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const std::string whole = seed % 2 == 0
                                      ? "time (ms),ax,ay,az\n0,1,-2,0.5\n0.1,3,4e-3,5\n0.2,5,6,7\n"
                                      : "t;x\n0;1,5\n0,1;-2,5\n0,2;3\n";
        const auto table = parse_acceleration_table(after_mishaps(whole, random), "a.csv", true);
        if (!table) {
            CHECK(contains(table.error().message, "a.csv:"));
            continue;
        }
        ++accepted;
        std::string text = table->time.empty() ? "" : "t";
        for (std::size_t a = 0; a < table->axes.size(); ++a) text += text.empty() ? "x" : ",x";
        text += "\n";
        for (std::size_t n = 0; n < table->axes[0].size(); ++n) {
            std::string row = table->time.empty() ? "" : shortest_digits(table->time[n]);
            for (const auto& axis : table->axes) {
                REQUIRE(std::isfinite(axis[n]));
                row += (row.empty() ? "" : ",") + shortest_digits(axis[n]);
            }
            text += row + "\n";
        }
        const auto again = parse_acceleration_table(text, "again.csv", true);
        REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
        CHECK(again->time == table->time);
        CHECK(again->axes == table->axes);
    }
    CHECK(accepted > 20);
}

TEST_CASE("acceleration file: a slow logger is resampled, and what it cannot say is said") {
    const Case file;
    AccelerationOptions phone;
    phone.rate_hz = 400.0;
    std::string text = "x (g)\n";
    const Samples slow = sine(50.0, 400.0, 400);
    for (const double sample : slow) text += shortest_digits(sample) + "\n";
    const auto recording = file.read(text, phone);
    REQUIRE_MESSAGE(recording, recording.error().message);
    CHECK(recording->waveform.samples_g.size() == 10'000);
    CHECK(says(*recording, "nothing above 160 Hz"));
    const Samples expected = sine(50.0, 1e4, 10'000);
    for (std::size_t n = 2000; n < 8000; ++n) {
        REQUIRE(std::abs(recording->waveform.samples_g[n] - expected[n]) < 1e-4);
    }
}

TEST_CASE("acceleration file: what is no recording is refused by its line") {
    const Case file;
    AccelerationOptions rate;
    rate.rate_hz = 1e4;
    CHECK(contains(file.fault("x\n1\nnan\n", rate), "a.csv:3: expected a finite number"));
    CHECK(contains(file.fault("nan,1\n0.1,2\n"), "a.csv:1: expected a time"));
    CHECK(contains(file.fault("t,x\n0,1\n0.001,2,3\n"), "a.csv:3: expected 2 columns"));
    CHECK(contains(file.fault("t,x\n0,1\n0.001,\n"), "a.csv:3: expected a finite number"));
    CHECK(contains(file.fault("t,x\n0,1\n0.001,2\n0.001,2\n"), "a.csv:4: expected a later time"));
    CHECK(file.read("t,x\n0,1\n0.001,2\n0.001,2\n", rate));
    CHECK(contains(file.fault("x\n1\n2\n"), "expected a time column or a rate"));
    CHECK(contains(file.fault(""), "expected a line of numbers"));
    CHECK(contains(file.fault("only words\n"), "expected a line of numbers"));
    rate.rate_hz = 50.0;
    CHECK(contains(file.fault("1\n2\n", rate), "expected a rate of 100 Hz to 10 MHz, got 50 Hz"));
    rate.rate_hz = 100.0;
    std::string long_one;
    for (int n = 0; n <= 6000; ++n) long_one += "0\n";
    CHECK(contains(file.fault(long_one, rate), "expected at most 60 s"));
    CHECK(contains(file.fault("x (g)\n1e300\n-1e300\n", rate), "at most 1,000,000 g"));
}

TEST_CASE("acceleration file: WAV of three channels is three axes") {
    const Case file;
    WaveBytes wave;
    wave.channels = 3;
    wave.is_float = true;
    wave.bits = 64;
    for (const double sample : sine(100.0, 1e4, 500)) {
        wave.samples.insert(wave.samples.end(), {0.0, sample / 8.0 + 0.25, 0.0});
    }
    AccelerationOptions options;
    options.full_scale = 8.0;
    check_is_the_sine(file.read(wave.file(), options, "a.WAV"));
    options.unit = AccelerationUnit::m_per_s2;
    options.full_scale = 8.0 * kStandardGravityMPerS2;
    check_is_the_sine(file.read(wave.file(), options, "a.wav"));
    CHECK(says(*file.read(wave.file(), {}, "a.wav"), "full scale taken as 1 g"));
    file.folder.write("b.wav.json", "{\"scale_g\": 8}");
    check_is_the_sine(file.read(wave.file(), {}, "b.wav"));
}

TEST_CASE("acceleration file: a clipped signal is told from a slow one of few digits") {
    Samples clipped = sine(100.0, 1e4, 1000, 3.0);
    for (double& sample : clipped) sample = std::clamp(sample, -2.0, 2.0);
    CHECK(samples_at_rail(clipped) > 300);
    Samples coarse = sine(20.0, 1e4, 1000);
    for (double& sample : coarse) sample = std::round(sample * 127.0);
    CHECK(samples_at_rail(coarse) == 0);
    CHECK(samples_at_rail(sine(100.0, 1e4, 1000)) == 0);
    CHECK(samples_at_rail(Samples(10, 0.0)) == 0);
    CHECK(samples_at_rail({}) == 0);
}

}  // namespace acceleration_file_test
