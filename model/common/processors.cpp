#include "model/common/processors.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <thread>

#include "model/system/process.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

constexpr double kNoQuota = std::numeric_limits<double>::infinity();

std::string text_of(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

// The first whole number above 0 of a text; 0 without one.
double number_of(std::string_view text) {
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && number > 0 ? static_cast<double>(number) : 0.0;
}

// "max 100000" or "200000 100000": microseconds of a period.
double quota_v2(const fs::path& folder) {
    const std::string text = text_of(folder / "cpu.max");
    const double quota = number_of(text);
    const auto space = text.find(' ');
    if (quota <= 0.0 || space == std::string::npos) return kNoQuota;
    const double period = number_of(std::string_view(text).substr(space + 1));
    return period > 0.0 ? quota / period : kNoQuota;
}

double quota_v1(const fs::path& folder) {
    const double quota = number_of(text_of(folder / "cpu.cfs_quota_us"));  // -1: none
    const double period = number_of(text_of(folder / "cpu.cfs_period_us"));
    return quota > 0.0 && period > 0.0 ? quota / period : kNoQuota;
}

// The least quota of a group and all around it, up to the root.
template <class Quota>
double least_quota(const fs::path& root, std::string_view group, const Quota& quota) {
    double least = kNoQuota;
    for (fs::path inner = fs::path(group).relative_path();; inner = inner.parent_path()) {
        least = std::min(least, quota(root / inner));
        if (inner.empty()) return least;
    }
}

int variable(const char* name) {
    const char* text = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
    return text == nullptr ? 0 : static_cast<int>(std::min(number_of(text), 1e6));
}

// What does not change while the program runs.
ProcessorLimits limits_of_process() {
    ProcessorLimits limits;
    limits.machine = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    limits.quota = processor_quota("/sys/fs/cgroup", text_of("/proc/self/cgroup"));
    limits.per_task = variable("SLURM_CPUS_PER_TASK");
    limits.ranks = std::max(1, variable("OMPI_COMM_WORLD_LOCAL_SIZE"));
    return limits;
}

}  // namespace

int usable_processors(const ProcessorLimits& limits) {
    int usable = std::min(limits.bound, limits.machine);
    // Part of a processor is one that is busy part of the time.
    if (limits.quota < usable) usable = static_cast<int>(std::ceil(limits.quota));
    if (limits.per_task > 0) usable = std::min(usable, limits.per_task);
    const bool share = limits.per_task == 0 && limits.bound >= limits.machine;
    if (share) usable /= std::max(limits.ranks, 1);
    return std::max(usable, 1);
}

double processor_quota(const fs::path& root, std::string_view own_groups) {
    double least = kNoQuota;
    std::istringstream lines{std::string(own_groups)};
    for (std::string line; std::getline(lines, line);) {
        const auto first = line.find(':');
        const auto second = line.find(':', first + 1);
        if (first == std::string::npos || second == std::string::npos) continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        const std::string_view group = std::string_view(line).substr(second + 1);
        if (controllers.empty()) least = std::min(least, least_quota(root, group, quota_v2));
        if (("," + controllers + ",").find(",cpu,") == std::string::npos) continue;
        least = std::min(least, least_quota(root / "cpu", group, quota_v1));
    }
    return least;
}

int usable_processors() {
    static const ProcessorLimits fixed = limits_of_process();
    ProcessorLimits limits = fixed;
    limits.bound = bound_processors(limits.machine);
    return usable_processors(limits);
}

std::string_view simd_wish() {
    static const std::string_view wish = [] {
        const char* name = std::getenv("TACTSPACE_SIMD");  // NOLINT(concurrency-mt-unsafe)
        return name == nullptr ? std::string_view{} : std::string_view{name};
    }();
    return wish;
}

}  // namespace tact
