#include "tests/e2e/heard_changes.h"

#include <cmath>
#include <cstdio>
#include <utility>

#include "tests/e2e/recorded.h"

namespace {

struct Recorded {
    std::vector<double> samples;                    // of one channel
    std::vector<std::pair<double, double>> stamps;  // number of frames, when

    double at_s(std::size_t frame) const {
        const auto found = std::ranges::find_if(
            stamps, [&](const auto& stamp) { return stamp.first > static_cast<double>(frame); });
        return found == stamps.end() ? 1e12 : found->second;
    }
    std::size_t frames_before(double time_s) const {
        double frames = 0.0;
        for (const auto& [count, at] : stamps) {
            if (at <= time_s) frames = count;
        }
        return static_cast<std::size_t>(frames);
    }
};

double largest_step(const std::vector<double>& samples, std::size_t from, std::size_t to) {
    double largest = 0.0;
    for (std::size_t n = std::max<std::size_t>(1, from); n < std::min(to, samples.size()); ++n) {
        largest = std::max(largest, std::abs(samples[n] - samples[n - 1]));
    }
    return largest;
}

// Share of the tone after it that is no multiple of the tone before. A gap shifts all that follows.
double share_of_another(const std::vector<double>& samples, std::size_t before, std::size_t after,
                        std::size_t count) {
    double own = 0.0;
    double both = 0.0;
    double all = 0.0;
    for (std::size_t n = 0; n < count; ++n) {
        own += samples[before + n] * samples[before + n];
        both += samples[before + n] * samples[after + n];
        all += samples[after + n] * samples[after + n];
    }
    return own > 0.0 && all > 0.0 ? std::sqrt(std::max(0.0, 1.0 - both * both / (own * all))) : 1.0;
}

struct Change {
    double late_ms = 0.0;
    bool is_lost = false;  // in a gap, which tells nothing
    std::string fault{};
};

// The tone has been steady for three of its periods before `since_s`, and is so again 0.1 s after.
Change change_after(const Recorded& heard, std::size_t period, double since_s) {
    const std::vector<double>& x = heard.samples;
    const std::size_t from = heard.frames_before(since_s);
    if (from < 4 * period) return {.fault = "it is too early"};
    std::size_t n = from - 2 * period;
    while (n < x.size() && std::abs(x[n] - x[n - period]) <= kHeard) ++n;
    constexpr std::size_t kSettled = 4800;
    if (n + kSettled + period >= x.size()) return {.fault = "it was never heard"};
    const std::size_t before = n - 2 * period;
    const std::size_t after = before + (kSettled / period + 1) * period;
    if (share_of_another(x, before, after, period) > 0.01) return {.is_lost = true};
    const double steady =
        std::max(largest_step(x, before, before + period), largest_step(x, after, after + period));
    if (largest_step(x, before, after) > 1.1 * steady + kHeard)
        return {.fault = "there is a click"};
    return {.late_ms = 1e3 * (heard.at_s(n) - since_s)};
}

}  // namespace

int heard_changes(const std::vector<std::string>& words) {
    const auto channels = static_cast<std::size_t>(std::stoi(words[2]));
    const auto channel = static_cast<std::size_t>(std::stoi(words[3])) - 1;
    Recorded heard{channel_of(samples_in(words[0]), channels, channel), {}};
    std::ifstream stamps(words[1]);
    for (double frames = 0.0, at_s = 0.0; stamps >> frames >> at_s;) {
        heard.stamps.emplace_back(frames, at_s);
    }
    const auto period = static_cast<std::size_t>(std::lround(kRateHz / std::stod(words[4])));
    std::vector<double> late_ms;
    for (std::size_t k = 5; k < words.size(); ++k) {
        const Change change = change_after(heard, period, std::stod(words[k]));
        if (!change.fault.empty()) {
            return failed("change " + std::to_string(k - 4) + ": " + change.fault);
        }
        change.is_lost ? std::printf("gap ") : std::printf("%.1f ", change.late_ms);
        if (!change.is_lost) late_ms.push_back(change.late_ms);
    }
    if (2 * late_ms.size() < words.size() - 5) return failed("most of them were lost in gaps");
    std::ranges::sort(late_ms);
    std::printf("ms\n%zu changes: median %.1f ms, worst %.1f ms\n", late_ms.size(),
                late_ms[late_ms.size() / 2], late_ms.back());
    return 0;
}
