// How many processors this process may use at once: what the system bound it to, what its control
// group grants, and what a batch system gave it; all of them may be less than the machine has.
//
// Source    sched_setaffinity(2); Linux "Control Group v2", cpu.max, and v1, cpu.cfs_quota_us;
//           sbatch(1), SLURM_CPUS_PER_TASK; Open MPI, OMPI_COMM_WORLD_LOCAL_SIZE.
// Left out  MPICH's ranks that are not bound
#pragma once

#include <algorithm>
#include <filesystem>
#include <limits>
#include <span>
#include <string_view>

namespace tact {

struct ProcessorLimits {
    int machine = 1;                                         // processors of the machine
    int bound = 1;                                           // ... that this process is bound to
    double quota = std::numeric_limits<double>::infinity();  // of its control group
    int per_task = 0;                                        // Slurm's; 0: not told
    int ranks = 1;                                           // of MPI on this machine
};

// At least 1. Ranks share the processors, unless each is bound to some of its own.
int usable_processors(const ProcessorLimits& limits);

// The least quota of a control group and of those around it, in processors; infinity without one.
// `own_groups` is the text of /proc/self/cgroup, `root` is /sys/fs/cgroup.
double processor_quota(const std::filesystem::path& root, std::string_view own_groups);

// Processors of this process. The quota and the environment are read once.
int usable_processors();

// Which of several kernels, one per instruction set, is in use.
//
// A kernel has a `name`: avx512, avx2 or baseline, as the environment variable TACTSPACE_SIMD has
// it.

// What TACTSPACE_SIMD names, or nothing. It is read once.
std::string_view simd_wish();

// The kernel of that name; default: the first, which is the fastest.
template <class Kernel>
const Kernel& kernel_of(std::span<const Kernel> kernels, std::string_view name) {
    const auto named = std::ranges::find(kernels, name, &Kernel::name);
    return named == kernels.end() ? kernels.front() : *named;
}

}  // namespace tact
