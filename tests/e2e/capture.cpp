// What a sound server was given, recorded and measured: the ear of the stories.
//
// Input     raw interleaved floats of 48 kHz; beside them a file of stamps: how many frames there
//           were when, in seconds of the monotonic clock
// Output    one line of findings; exit code 1 and a sentence where something is not as it must be
//
//     capture read CHANNELS RAW STAMPS          from standard input, stamped as it arrives
//     capture jack CHANNELS RAW STAMPS          as JACK's client "actuator", until SIGTERM; prints
//         "ready", and then how many channels have sounded so far, as often as that changes
//     capture lines RAW CHANNELS CHANNEL DURATION HZ:AMPLITUDE...    a sum of sines, and whole
//     capture middle RAW CHANNELS CHANNEL DURATION HZ:AMPLITUDE...   the same, 0.3 s from its ends
//     capture gap RAW CHANNELS CHANNEL          prints the longest silence within, in whole ms
//     capture peaks RAW CHANNELS CHANNEL        prints the largest sample of it, and of all others
//     capture onsets RAW CHANNELS CHANNEL       what sounds, apart by 100 ms of silence at least:
//         a line each: when half of its own peak is passed first, how long it lasts, in ms, peak
//     capture signal NUMBER PID                 sends it, prints when
//     capture now                               prints when
//     capture changes RAW STAMPS CHANNELS CHANNEL HZ SINCE...   a loop of this tone was made
//     stronger
//         or weaker at these times: how long after each that is heard, and never as a click
//     capture silent RAW STAMPS CHANNELS CHANNEL SINCE MS   nothing is heard MS after SINCE
//     capture rest RAW STAMPS CHANNELS CHANNEL SINCE   prints how many ms after SINCE the last
//     sound
//         was heard, and how many ms were recorded after that; exit code 1 where none was
#include <jack/jack.h>
#include <unistd.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "tests/e2e/heard_changes.h"
#include "tests/e2e/recorded.h"

namespace {

double monotonic_s() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Span {
    std::size_t first = 0;
    std::size_t last = 0;
    std::size_t count() const { return last - first + 1; }
};

// From the first sample that can be heard to the last one.
Span heard_in(const std::vector<double>& samples) {
    const auto loud = [](double sample) { return std::abs(sample) > kHeard; };
    const auto first = std::find_if(samples.begin(), samples.end(), loud);
    if (first == samples.end()) return {1, 0};
    const auto last = std::find_if(samples.rbegin(), samples.rend(), loud).base() - 1;
    return {static_cast<std::size_t>(first - samples.begin()),
            static_cast<std::size_t>(last - samples.begin())};
}

struct Line {
    double frequency_hz = 0.0;
    double amplitude = 0.0;
};

struct Fit {
    std::vector<Line> lines;
    double snr_db = 0.0;
};

// Least squares for amplitudes, phases and small corrections of the frequencies, all at once:
// a sin(w t) + b cos(w t), and its derivative by w, t (a cos(w t) - b sin(w t)).
Fit fitted(const std::vector<double>& samples, std::vector<Line> lines) {
    const auto rows = static_cast<Eigen::Index>(samples.size());
    const auto count = static_cast<Eigen::Index>(lines.size());
    const Eigen::Map<const Eigen::VectorXd> y(samples.data(), rows);
    Eigen::VectorXd found = Eigen::VectorXd::Zero(2 * count);
    Eigen::VectorXd rest;
    for (int round = 0; round < 6; ++round) {
        Eigen::MatrixXd basis(rows, round == 0 || round == 5 ? 2 * count : 3 * count);
        for (Eigen::Index k = 0; k < count; ++k) {
            const double w =
                2.0 * std::numbers::pi * lines[static_cast<std::size_t>(k)].frequency_hz;
            for (Eigen::Index n = 0; n < rows; ++n) {
                const double t =
                    (static_cast<double>(n) - 0.5 * static_cast<double>(rows)) / kRateHz;
                basis(n, 2 * k) = std::sin(w * t);
                basis(n, 2 * k + 1) = std::cos(w * t);
                if (basis.cols() == 2 * count) continue;
                basis(n, 2 * count + k) =
                    t * (found(2 * k) * basis(n, 2 * k + 1) - found(2 * k + 1) * basis(n, 2 * k));
            }
        }
        const Eigen::VectorXd all = (basis.transpose() * basis).ldlt().solve(basis.transpose() * y);
        found = all.head(2 * count);
        rest = y - basis.leftCols(2 * count) * found;
        for (Eigen::Index k = 0; k < all.size() - 2 * count; ++k) {
            lines[static_cast<std::size_t>(k)].frequency_hz +=
                all(2 * count + k) / (2.0 * std::numbers::pi);
        }
    }
    for (Eigen::Index k = 0; k < count; ++k) {
        lines[static_cast<std::size_t>(k)].amplitude = std::hypot(found(2 * k), found(2 * k + 1));
    }
    return {lines, 10.0 * std::log10((y - rest).squaredNorm() / rest.squaredNorm())};
}

int check_lines(const Fit& fit, const std::vector<Line>& expected) {
    for (std::size_t k = 0; k < expected.size(); ++k) {
        const double off_hz = fit.lines[k].frequency_hz - expected[k].frequency_hz;
        const double share = fit.lines[k].amplitude / expected[k].amplitude - 1.0;
        std::printf("%.5f Hz %.6f  ", fit.lines[k].frequency_hz, fit.lines[k].amplitude);
        if (std::abs(off_hz) > 0.01) return failed("a frequency is off by more than 0.01 Hz");
        if (std::abs(share) > 1e-3) return failed("an amplitude is off by more than 0.1 %");
    }
    std::printf("SNR %.1f dB\n", fit.snr_db);
    // A gap of a single frame in 2 s leaves less than 60 dB.
    return fit.snr_db < 90.0 ? failed("less than 90 dB of SNR") : 0;
}

// Without so much of both ends.
int lines(const std::vector<std::string>& words, std::size_t edge) {
    const std::vector<float> samples = samples_in(words[0]);
    const auto channels = static_cast<std::size_t>(std::stoi(words[1]));
    const auto channel = static_cast<std::size_t>(std::stoi(words[2])) - 1;
    const double duration_s = std::stod(words[3]);
    std::vector<Line> expected;
    for (std::size_t k = 4; k < words.size(); ++k) {
        const std::size_t colon = words[k].find(':');
        expected.push_back({std::stod(words[k]), std::stod(words[k].substr(colon + 1))});
    }
    for (std::size_t other = 0; other < channels; ++other) {
        const Span heard = heard_in(channel_of(samples, channels, other));
        if (other != channel && heard.last >= heard.first) return failed("another channel sounds");
    }
    const std::vector<double> one = channel_of(samples, channels, channel);
    const Span heard = heard_in(one);
    if (heard.last < heard.first) return failed("nothing was heard");
    const double length_s = static_cast<double>(heard.count()) / kRateHz;
    std::printf("%.4f s  ", length_s);
    // The filter rings for some ms before a sudden start and after a sudden end.
    if (std::abs(length_s - duration_s) > 0.012) return failed("it is not whole");
    return check_lines(fitted({one.begin() + static_cast<std::ptrdiff_t>(heard.first + edge),
                               one.begin() + static_cast<std::ptrdiff_t>(heard.last - edge)},
                              expected),
                       expected);
}

// What a server plays where it is given nothing. A recorder that loses samples leaves none.
int gap(const std::vector<std::string>& words) {
    const auto channels = static_cast<std::size_t>(std::stoi(words[1]));
    const auto channel = static_cast<std::size_t>(std::stoi(words[2])) - 1;
    const std::vector<double> one = channel_of(samples_in(words[0]), channels, channel);
    const Span heard = heard_in(one);
    std::size_t longest = 0;
    std::size_t run = 0;
    for (std::size_t n = heard.first; n <= heard.last && n < one.size(); ++n) {
        run = std::abs(one[n]) < 1e-6 ? run + 1 : 0;
        longest = std::max(longest, run);
    }
    std::printf("%d\n", static_cast<int>(1e3 * static_cast<double>(longest) / kRateHz));
    return 0;
}

int silent(const std::vector<std::string>& words) {
    const auto channels = static_cast<std::size_t>(std::stoi(words[2]));
    const auto channel = static_cast<std::size_t>(std::stoi(words[3])) - 1;
    const Span heard = heard_in(channel_of(samples_in(words[0]), channels, channel));
    if (heard.last < heard.first) return failed("nothing was heard before");
    std::ifstream stamps(words[1]);
    double frames = 0.0;
    double at_s = 0.0;
    while (stamps >> frames >> at_s && frames <= static_cast<double>(heard.last)) continue;
    if (frames <= static_cast<double>(heard.last)) return failed("it never fell silent");
    // Where stamps are exact, so is this; where they are of arrivals, it is later than the truth.
    const double late_s = at_s - std::stod(words[4]);
    std::printf("silent %.1f ms after the stop\n", 1e3 * late_s);
    if (late_s < 0.0) return failed("it was silent before");
    return 1e3 * late_s > std::stod(words[5]) ? failed("that is too late") : 0;
}

struct Stamp {
    double frames = 0.0;  // that were recorded ...
    double at_s = 0.0;    // ... by then
};

std::vector<Stamp> stamps_in(const std::string& file) {
    std::ifstream stream(file);
    std::vector<Stamp> stamps;
    for (Stamp stamp; stream >> stamp.frames >> stamp.at_s;) stamps.push_back(stamp);
    return stamps;
}

int last_sound(const std::vector<std::string>& words) {
    const auto channels = static_cast<std::size_t>(std::stoi(words[2]));
    const auto channel = static_cast<std::size_t>(std::stoi(words[3])) - 1;
    const std::vector<double> one = channel_of(samples_in(words[0]), channels, channel);
    const Span heard = heard_in(one);
    if (heard.last < heard.first) return failed("nothing was heard");
    const auto last = static_cast<double>(heard.last);
    const std::vector<Stamp> stamps = stamps_in(words[1]);
    const auto after =
        std::ranges::find_if(stamps, [&](const Stamp& s) { return s.frames > last; });
    if (after == stamps.end()) return failed("it never fell silent");
    std::printf("%.1f %.0f\n", 1e3 * (after->at_s - std::stod(words[4])),
                1e3 * (static_cast<double>(one.size()) - last - 1.0) / kRateHz);
    return 0;
}

int read_input(const std::vector<std::string>& words) {
    const std::size_t frame = sizeof(float) * static_cast<std::size_t>(std::stoi(words[0]));
    std::ofstream raw(words[1], std::ios::binary);
    std::ofstream stamps(words[2]);
    stamps.precision(12);
    std::array<char, 65'536> piece{};
    std::size_t bytes = 0;
    for (ssize_t count = 0; (count = ::read(STDIN_FILENO, piece.data(), piece.size())) > 0;) {
        bytes += static_cast<std::size_t>(count);
        stamps << bytes / frame << ' ' << monotonic_s() << '\n' << std::flush;
        raw.write(piece.data(), count);
        raw.flush();
    }
    return 0;
}

// A client of JACK's that keeps all it is given, up to a minute: the callback only copies.
struct JackRecorder {
    jack_client_t* client = nullptr;
    std::vector<jack_port_t*> ports;
    std::vector<float> samples;
    std::size_t used = 0;
    std::vector<Stamp> stamps;
    std::vector<std::atomic<bool>> has_sounded;
};

int jack_process(jack_nframes_t frames, void* self) {
    JackRecorder& recorder = *static_cast<JackRecorder*>(self);
    const std::size_t channels = recorder.ports.size();
    if (recorder.used + frames * channels > recorder.samples.size()) return 0;
    for (std::size_t channel = 0; channel < channels; ++channel) {
        const auto* from =
            static_cast<const float*>(jack_port_get_buffer(recorder.ports[channel], frames));
        for (std::size_t n = 0; n < frames; ++n) {
            recorder.samples[recorder.used + n * channels + channel] = from[n];
            if (static_cast<double>(std::abs(from[n])) > kHeard) {
                recorder.has_sounded[channel] = true;
            }
        }
    }
    recorder.used += frames * channels;
    // The block's end. JACK's own clock strays where cycles are late.
    if (recorder.stamps.size() < recorder.stamps.capacity()) {
        recorder.stamps.push_back(
            {static_cast<double>(recorder.used / channels), monotonic_s() + frames / kRateHz});
    }
    return 0;
}

void tell_sounding(const JackRecorder& recorder, const sigset_t& until) {
    constexpr timespec kLook{0, 20'000'000};
    std::ptrdiff_t told = 0;
    while (sigtimedwait(&until, nullptr, &kLook) < 0) {
        const auto sounding = std::ranges::count_if(
            recorder.has_sounded, [](const std::atomic<bool>& has) { return has.load(); });
        if (sounding == std::exchange(told, sounding)) continue;
        std::cout << sounding << std::endl;
    }
}

int record_jack(const std::vector<std::string>& words) {
    sigset_t wanted;
    sigemptyset(&wanted);
    sigaddset(&wanted, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &wanted, nullptr);
    JackRecorder recorder;
    const auto channels = static_cast<std::size_t>(std::stoi(words[0]));
    recorder.samples.resize(60 * 48'000 * channels);
    recorder.stamps.reserve(60'000);
    recorder.has_sounded = std::vector<std::atomic<bool>>(channels);
    recorder.client = jack_client_open("actuator", JackNoStartServer, nullptr);
    if (recorder.client == nullptr) return failed("no JACK server");
    for (std::size_t channel = 0; channel < channels; ++channel) {
        const std::string name = "in_" + std::to_string(channel + 1);
        recorder.ports.push_back(jack_port_register(recorder.client, name.c_str(),
                                                    JACK_DEFAULT_AUDIO_TYPE, JackPortIsInput, 0));
    }
    jack_set_process_callback(recorder.client, jack_process, &recorder);
    if (jack_activate(recorder.client) != 0) return failed("JACK does not take the client");
    std::cout << "ready" << std::endl;
    tell_sounding(recorder, wanted);
    jack_deactivate(recorder.client);
    std::ofstream raw(words[1], std::ios::binary);
    raw.write(reinterpret_cast<const char*>(recorder.samples.data()),
              static_cast<std::streamsize>(recorder.used * sizeof(float)));
    std::ofstream stamps(words[2]);
    stamps.precision(12);
    for (const auto& stamp : recorder.stamps) {
        stamps << stamp.frames << ' ' << stamp.at_s << '\n';
    }
    jack_client_close(recorder.client);
    return 0;
}

int peaks(const std::vector<std::string>& words) {
    std::ifstream raw(words[0], std::ios::binary);
    const auto channels = static_cast<std::size_t>(std::stoi(words[1]));
    const auto channel = static_cast<std::size_t>(std::stoi(words[2]) - 1);
    std::vector<float> frame(channels);
    float of_channel = 0.0F;
    float of_others = 0.0F;
    const auto bytes = static_cast<std::streamsize>(channels * sizeof(float));
    while (raw.read(reinterpret_cast<char*>(frame.data()), bytes)) {
        for (std::size_t k = 0; k < channels; ++k) {
            float& most = k == channel ? of_channel : of_others;
            most = std::max(most, std::abs(frame[k]));
        }
    }
    std::printf("%.7g %.7g\n", static_cast<double>(of_channel), static_cast<double>(of_others));
    return 0;
}

// By a share of each one's own peak: it does not hang on how strong it is.
int onsets(const std::vector<std::string>& words) {
    const auto channels = static_cast<std::size_t>(std::stoi(words[1]));
    const auto channel = static_cast<std::size_t>(std::stoi(words[2])) - 1;
    const std::vector<double> one = channel_of(samples_in(words[0]), channels, channel);
    const auto is_loud = [](double sample) { return std::abs(sample) > 100.0 * kHeard; };
    const auto rest = static_cast<std::ptrdiff_t>(0.1 * kRateHz);
    auto from = std::find_if(one.begin(), one.end(), is_loud);
    while (from != one.end()) {
        auto to = from;
        auto next = from;
        for (; next != one.end() && next - to < rest; ++next) to = is_loud(*next) ? next : to;
        double peak = 0.0;
        for (auto at = from; at != next; ++at) peak = std::max(peak, std::abs(*at));
        const auto half =
            std::find_if(from, next, [&](double x) { return std::abs(x) > 0.5 * peak; });
        std::printf("%.3f %.0f %.5f\n", 1e3 * static_cast<double>(half - one.begin()) / kRateHz,
                    1e3 * static_cast<double>(to - from) / kRateHz, peak);
        from = std::find_if(next, one.end(), is_loud);
    }
    return 0;
}

int send_signal(const std::vector<std::string>& words) {
    std::printf("%.6f\n", monotonic_s());
    return kill(std::stoi(words[1]), std::stoi(words[0])) == 0 ? 0 : 1;
}

int tell_now() {
    std::printf("%.6f\n", monotonic_s());
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    const std::string what = words.empty() ? "" : words[0];
    const std::vector<std::string> rest(words.begin() + (words.empty() ? 0 : 1), words.end());
    if (what == "read" && rest.size() == 3) return read_input(rest);
    if (what == "jack" && rest.size() == 3) return record_jack(rest);
    if (what == "lines" && rest.size() >= 5) return lines(rest, 1200);
    if (what == "middle" && rest.size() >= 5) return lines(rest, 14'400);
    if (what == "gap" && rest.size() == 3) return gap(rest);
    if (what == "peaks" && rest.size() == 3) return peaks(rest);
    if (what == "onsets" && rest.size() == 3) return onsets(rest);
    if (what == "signal" && rest.size() == 2) return send_signal(rest);
    if (what == "now" && rest.empty()) return tell_now();
    if (what == "changes" && rest.size() >= 6) return heard_changes(rest);
    if (what == "rest" && rest.size() == 5) return last_sound(rest);
    if (what == "silent" && rest.size() == 6) return silent(rest);
    std::cerr << "see the head of capture.cpp\n";
    return 2;
}
