#include "model/io/recordings/acceleration_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/io/recordings/wave_file.h"
#include "model/pattern/pattern.h"
#include "model/signal/resample.h"
#include "model/signal/simulated_measurement.h"
#include "model/signal/waveform.h"
#include "model/table/table.h"
#include "model/text/atomic_file.h"
#include "model/text/enough_memory.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

using Samples = std::vector<double>;

// Axes in the file's unit at one rate.
struct Axes {
    double rate_hz = 0.0;
    std::vector<Samples> samples;
    AccelerationUnit unit = AccelerationUnit::g;
    bool is_assumed = false;  // nothing says the unit
    std::vector<std::string> names{};
};

std::string printed(const char* format, double value) {
    char text[160];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

// What a recording of vibrations is sampled with where its times have no unit: above the upper end
// an hour of seconds looks like ms.
constexpr Range kPlainRateHz{kLowestRateHz, 1e4};

constexpr Range kGravityMPerS2{9.5, 10.1};  // of a sensor at rest, its own errors included
constexpr double kMuchG = 4.0;              // that few actuators reach

// Where the table does not say, the unit in which the rate is plain. Steps of a whole number are
// counted in it; a step of 0.02 may be 50 Hz in seconds as well as 50 kHz in ms, and is refused.
Expected<double> time_unit_s(const AccelerationTable& table, double mean_step,
                             std::vector<std::string>& remarks) {
    if (table.time_unit_s) return *table.time_unit_s;
    if (mean_step * kLowestRateHz <= 1.0) return 1.0;
    constexpr double kRounding = 1e-6;  // of a step, after sums of decimals
    struct Unit {
        const char* name;
        double seconds;
    };
    for (const Unit& unit : {Unit{"ms", 1e-3}, Unit{"us", 1e-6}, Unit{"ns", 1e-9}}) {
        const double rate_hz = 1.0 / (mean_step * unit.seconds);
        const bool counted = mean_step >= 1.0 - kRounding;
        if (!counted || rate_hz < kPlainRateHz.low * (1.0 - kRounding) ||
            rate_hz > kPlainRateHz.high * (1.0 + kRounding)) {
            continue;
        }
        remarks.push_back(std::string("times taken as ") + unit.name);
        return unit.seconds;
    }
    return Error{printed("expected times whose name says their unit (\"time (ms)\"): a step of "
                         "%.4g would be",
                         mean_step) +
                 printed(" %.4g Hz in s", 1.0 / mean_step) +
                 printed(" and %.4g Hz in ms; a recording has 100 Hz or more", 1e3 / mean_step)};
}

// The samples at even times, by straight lines between those there are.
Samples evened(const Samples& time, const Samples& samples, double step) {
    Samples result;
    result.reserve(samples.size());
    std::size_t right = 1;
    for (std::size_t n = 0; n < samples.size(); ++n) {
        const double t = time.front() + static_cast<double>(n) * step;
        while (right + 1 < time.size() && time[right] < t) ++right;
        const double share = (t - time[right - 1]) / (time[right] - time[right - 1]);
        result.push_back(std::lerp(samples[right - 1], samples[right], std::min(share, 1.0)));
    }
    return result;
}

// The rate that the times say; uneven samples are evened.
Expected<double> rate_of(AccelerationTable& table, std::vector<std::string>& remarks) {
    constexpr double kMostJitter = 0.01;
    const Samples& time = table.time;
    if (time.empty()) return Error{"expected a time column or a rate, got neither"};
    if (time.size() < 2) return Error{"expected at least two samples to tell the rate from"};
    const double step = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
    double jitter = 0.0;
    for (std::size_t n = 1; n < time.size(); ++n) {
        jitter = std::max(jitter, std::abs(time[n] - time[n - 1] - step) / step);
    }
    if (jitter >= kMostJitter) {
        for (Samples& samples : table.axes) samples = evened(time, samples, step);
        remarks.push_back(
            printed("steps between times stray by up to %.2g %%: evened out", 100.0 * jitter));
    }
    const Expected<double> unit_s = time_unit_s(table, step, remarks);
    if (!unit_s) return unit_s.error();
    return 1.0 / (step * *unit_s);
}

// What is wrong with the number of axes, or empty.
std::string axes_fault(std::size_t count, std::size_t axis,
                       const std::vector<std::string>& names = {}) {
    if (axis > count) {
        return "expected axis " + std::to_string(axis) + ", got a file of " + std::to_string(count);
    }
    if (axis == 0 && count != 1 && count != 3) {
        std::string all;
        for (const std::string& name : names) all += (all.empty() ? " (" : ", ") + name;
        return "expected 1 or 3 axes, got " + std::to_string(count) + all +
               (all.empty() ? "" : ")") + ": one has to be chosen";
    }
    return {};
}

const char* name_of(AccelerationUnit unit) {
    return kAccelerationUnits[static_cast<std::size_t>(unit)];
}

// What is wrong with a unit that is asked for beside the one that a column names, or empty.
std::string other_unit_fault(const AccelerationTable& table, const AccelerationOptions& options) {
    if (!options.unit || !table.unit || *options.unit == *table.unit) return {};
    return std::string("expected accelerations in ") + name_of(*table.unit) + ", as the column " +
           in_quotes(table.unit_column) + " says, got the unit " + name_of(*options.unit) +
           " beside it";
}

Expected<Axes> read_table(const fs::path& path, const AccelerationOptions& options,
                          std::vector<std::string>& remarks) {
    auto text = read_text_file(path, kMaxTableBytes);
    if (!text) return text.error();
    TableText decoded = table_text(*std::move(text));
    auto table =
        parse_acceleration_table(decoded.text, path.string(), !options.rate_hz, options.table);
    const TableEncoding encoding = decoded.encoding;
    decoded = {};  // what follows needs the memory
    if (!table) return table.error();
    const bool is_usual = table->dialect.separator == ' ' && table->dialect.decimal == '.' &&
                          encoding == TableEncoding::utf8;
    const std::string words = words_on(table->dialect, encoding);
    if (!words.empty() && !is_usual) remarks.push_back("read with " + words);
    Axes axes;
    if (options.rate_hz) {
        axes.rate_hz = *options.rate_hz;
    } else if (table->time.empty() && table->rate_hz) {
        axes.rate_hz = *table->rate_hz;
        remarks.push_back(printed("rate of %.6g Hz, as a comment says", axes.rate_hz));
    } else {
        const Expected<double> rate = rate_of(*table, remarks);
        if (!rate) return Error{path.string() + ": " + rate.error().message};
        axes.rate_hz = *rate;
    }
    if (options.full_scale) {
        return Error{path.string() + ": expected no full scale, which belongs to .wav files"};
    }
    if (const auto fault = other_unit_fault(*table, options); !fault.empty()) {
        return Error{path.string() + ": " + fault};
    }
    axes.is_assumed = !options.unit && !table->unit;
    if (axes.is_assumed) remarks.emplace_back("accelerations taken as g");
    axes.unit = options.unit.value_or(table->unit.value_or(AccelerationUnit::g));
    axes.names = std::move(table->axis_names);
    axes.samples = std::move(table->axes);
    if (const auto fault = axes_fault(axes.samples.size(), options.axis, axes.names);
        !fault.empty()) {
        return Error{path.string() + ": " + fault};
    }
    if (options.axis > 0) axes.samples = {std::move(axes.samples[options.axis - 1])};
    return axes;
}

Expected<Axes> read_wave(const fs::path& path, const AccelerationOptions& options,
                         std::vector<std::string>& remarks) {
    if (options.rate_hz) {
        return Error{path.string() + ": expected no rate, which a .wav file says itself"};
    }
    if (options.table != AccelerationTableOptions{}) {
        return Error{path.string() +
                     ": expected no columns, unit of times, separator or decimal sign, which "
                     "belong to tables"};
    }
    auto wave = read_wave_channels(path, options.axis, [&options](std::size_t channels) {
        return axes_fault(channels, options.axis);
    });
    if (!wave) return wave.error();
    Axes axes{wave->rate_hz, std::move(wave->channels), options.unit.value_or(AccelerationUnit::g),
              false};
    double full_scale = options.full_scale.value_or(1.0);
    if (!options.full_scale && wave->scale_g) {
        full_scale = *wave->scale_g;
        if (axes.unit != AccelerationUnit::g) {
            return Error{path.string() + ": expected g, as its sidecar says, got the unit " +
                         name_of(axes.unit) + " beside it"};
        }
        if (!wave->remark.empty()) remarks.push_back(wave->remark);
    } else if (!options.full_scale) {
        remarks.push_back(std::string("full scale taken as 1 ") + name_of(axes.unit));
    }
    for (Samples& samples : axes.samples) {
        for (double& sample : samples) sample *= full_scale;
    }
    return axes;
}

// What is wrong with the numbers that go with the file, or empty. NaN is in no range.
std::string fault_of(const AccelerationOptions& options) {
    const bool is_known = options.sensitivity_v_per_g != 0.0;
    if (is_known && !limits::kSensitivityVPerG.contains(options.sensitivity_v_per_g)) {
        return "expected a sensitivity of 1e-06 to 1e+06 V/g, got " +
               shortest_digits(options.sensitivity_v_per_g);
    }
    if (!limits::kOffsetV.contains(options.offset_v)) {
        return "expected an offset of -1e+06 to 1e+06 V, got " + shortest_digits(options.offset_v);
    }
    if (options.full_scale && !limits::kScaleG.contains(*options.full_scale)) {
        return "expected a full scale of 1e-06 to 1e+06, got " +
               shortest_digits(*options.full_scale);
    }
    return {};
}

// What is wrong with rate, length or unit, or empty.
std::string fault_of(const Axes& axes, const AccelerationOptions& options) {
    const std::size_t samples = axes.samples.front().size();
    if (!(axes.rate_hz >= kLowestRateHz && axes.rate_hz <= kHighestRateHz)) {
        return "expected a rate of 100 Hz to 10 MHz, got " + shortest_digits(axes.rate_hz) + " Hz";
    }
    if (static_cast<double>(samples) > limits::kDurationS.high * axes.rate_hz) {
        return "expected at most 60 s, got " + grouped_digits(samples) + " samples at " +
               shortest_digits(axes.rate_hz) + " Hz";
    }
    if (axes.unit == AccelerationUnit::volt && !(options.sensitivity_v_per_g > 0.0)) {
        return "expected the sensor's sensitivity in V/g, as the recording is in volts";
    }
    const bool has_sensor = options.sensitivity_v_per_g != 0.0 || options.offset_v != 0.0;
    if (axes.unit != AccelerationUnit::volt && has_sensor) {
        return std::string(
                   "expected a sensitivity and an offset with a recording in V alone, got "
                   "them with one ") +
               (axes.is_assumed ? "whose unit nothing says"
                                : std::string("in ") + name_of(axes.unit));
    }
    return {};
}

bool is_constant(const Samples& samples) {
    const auto [least, most] = std::ranges::minmax(samples);
    return least == most;
}

double mean_length(const std::vector<Samples>& axes) {
    double squares = 0.0;
    for (const Samples& samples : axes) {
        double sum = 0.0;
        for (const double sample : samples) sum += sample;
        const double mean = sum / static_cast<double>(samples.size());
        squares += mean * mean;
    }
    return std::sqrt(squares);
}

double swing_of(const Samples& samples) {
    const auto [least, most] = std::ranges::minmax(samples);
    return (most - least) / 2.0;
}

// What is wrong with the values, or empty.
std::string values_fault(const Axes& axes) {
    if (std::ranges::all_of(axes.samples, is_constant)) {
        return "expected a recording, got silence: all samples are alike";
    }
    if (!axes.is_assumed) return {};
    if (const double still = mean_length(axes.samples); kGravityMPerS2.contains(still)) {
        return "expected a name that says the unit (\"x (m/s2)\"): a mean of " +
               significant_digits(still, 3) + " is gravity in m/s2, no vibration in g";
    }
    for (const Samples& samples : axes.samples) {
        const double swing = swing_of(samples);
        if (swing <= limits::kAmplitudeG.high) continue;
        return "expected a name that says the unit (\"x (g)\"): swings of " +
               significant_digits(swing, 4) +
               printed(" are no vibration in g, which has at most %.3g g",
                       limits::kAmplitudeG.high) +
               "; counts of a converter have to be scaled first";
    }
    return {};
}

void convert_to_g(Axes& axes, const AccelerationOptions& options) {
    double scale = 1.0;
    double offset = 0.0;
    if (axes.unit == AccelerationUnit::m_per_s2) scale = 1.0 / kStandardGravityMPerS2;
    if (axes.unit == AccelerationUnit::volt) {
        scale = 1.0 / options.sensitivity_v_per_g;
        offset = options.offset_v;
    }
    for (Samples& samples : axes.samples) {
        for (double& sample : samples) sample = (sample - offset) * scale;
    }
}

void remark_on(const Axes& axes, std::vector<std::string>& remarks) {
    std::size_t at_rail = 0;
    for (const Samples& samples : axes.samples) at_rail += samples_at_rail(samples);
    if (at_rail > 0) {
        remarks.push_back(grouped_digits(at_rail) +
                          " samples look cut off, at the limit of the sensor");
    }
    double swing = 0.0;
    for (const Samples& samples : axes.samples) swing = std::max(swing, swing_of(samples));
    if (axes.is_assumed && swing > kMuchG) {
        remarks.push_back("swings of " + significant_digits(swing, 3) +
                          " are much for g: these may be m/s2");
    }
    // A sensor's own filter begins below half its rate.
    constexpr double kUsable = 0.4;
    if (kUsable * axes.rate_hz < limits::kCarrierHz.high) {
        remarks.push_back(printed("sampled at %.4g Hz", axes.rate_hz) +
                          printed(": says nothing above %.3g Hz", kUsable * axes.rate_hz));
    }
}

// The least distance between two values that are taken: what the last digit is worth.
double finest_step(Samples samples) {
    std::ranges::sort(samples);
    double step = samples.back() - samples.front();
    for (std::size_t n = 1; n < samples.size(); ++n) {
        const double distance = samples[n] - samples[n - 1];
        if (distance > 0.0) step = std::min(step, distance);
    }
    return step;
}

Expected<Recording> recording_of(const fs::path& path, const AccelerationOptions& options) {
    Recording recording;
    auto axes = recording_kind(path) == RecordingKind::wave
                    ? read_wave(path, options, recording.remarks)
                    : read_table(path, options, recording.remarks);
    if (!axes) return axes.error();
    const std::string fault = fault_of(*axes, options);
    if (!fault.empty()) return Error{path.string() + ": " + fault};
    if (const auto odd = values_fault(*axes); !odd.empty()) {
        return Error{path.string() + ": " + odd};
    }
    convert_to_g(*axes, options);
    remark_on(*axes, recording.remarks);
    for (Samples& samples : axes->samples) {
        samples = without_mean(samples);
        Waveform waveform{axes->rate_hz, std::move(samples)};
        if (!(peak_g(waveform) <= kMaxSampleG)) {
            return Error{path.string() + ": expected accelerations of at most 1,000,000 g"};
        }
        samples = resampled(waveform, kModelRateHz).samples_g;
    }
    const bool is_one = axes->samples.size() == 1;
    if (!is_one) recording.remarks.emplace_back("three axes made one by DFT321");
    recording.waveform.samples_g = is_one ? std::move(axes->samples[0]) : dft321(axes->samples);
    if (recording.waveform.samples_g.empty()) {
        return Error{path.string() + ": expected at least one sample at 10 kHz, got a shorter one"};
    }
    if (axes->rate_hz != kModelRateHz) {
        recording.remarks.push_back(printed("resampled from %.6g Hz to 10,000 Hz", axes->rate_hz));
    }
    return recording;
}

}  // namespace

std::size_t samples_at_rail(const Samples& samples) {
    constexpr std::size_t kLeastRun = 3;
    constexpr double kJumpSteps = 4.0;  // a peak as flat as three samples is entered by fewer
    if (samples.empty()) return 0;
    const auto [least, most] = std::ranges::minmax(samples);
    const double step = finest_step(samples);
    std::size_t count = 0;
    for (std::size_t begin = 0, end = 0; begin < samples.size(); begin = end) {
        end = begin + 1;
        if (samples[begin] != least && samples[begin] != most) continue;
        while (end < samples.size() && samples[end] == samples[begin]) ++end;
        const double before = begin > 0 ? std::abs(samples[begin] - samples[begin - 1]) : 0.0;
        const double after = end < samples.size() ? std::abs(samples[end] - samples[end - 1]) : 0.0;
        const bool jumps = std::max(before, after) > kJumpSteps * step;
        if (end - begin >= kLeastRun && jumps) count += end - begin;
    }
    return count;
}

AccelerationOptions options_among(const fs::path& file, std::span<const fs::path> all,
                                  AccelerationOptions options) {
    const auto is_wave = [](const fs::path& path) {
        return recording_kind(path) == RecordingKind::wave;
    };
    const bool is_of_wave = is_wave(file);
    const bool is_idle = is_of_wave ? options.rate_hz || options.table != AccelerationTableOptions{}
                                    : options.full_scale.has_value();
    if (!is_idle) return options;  // the others are not looked into for nothing
    const bool has_other =
        std::ranges::any_of(all, [&](const fs::path& path) { return is_wave(path) != is_of_wave; });
    if (!has_other) return options;
    if (is_of_wave) {
        options.rate_hz.reset();
        options.table = {};
    } else {
        options.full_scale.reset();
    }
    return options;
}

Expected<Recording> read_acceleration_file(const fs::path& path,
                                           const AccelerationOptions& options) {
    if (const std::string fault = fault_of(options); !fault.empty()) {
        return Error{path.string() + ": " + fault};
    }
    return with_enough_memory(path.string(), [&] { return recording_of(path, options); });
}

}  // namespace tact
