#include "app/command_line/mpi.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>

#ifdef TACT_MPI
#include <mpi.h>

#include <chrono>
#include <mutex>
#include <thread>
#endif

namespace tact {

namespace {

// How many processes were started together: by Open MPI, by MPICH and its relatives, by Slurm.
int processes_started() {
    for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"}) {
        const char* count = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
        if (count != nullptr) return std::max(1, std::atoi(count));
    }
    return 1;
}

}  // namespace

RankGroup::RankGroup(RankGroup&& other) noexcept
    : rank(other.rank), count(other.count), is_joined_(std::exchange(other.is_joined_, false)) {}

#ifdef TACT_MPI

namespace {

// Tags of messages.
constexpr int kAsk = 1;
constexpr int kValues = 2;
constexpr int kLeave = 3;
constexpr int kTile = 4;  // and up, by thread: what each asked for
constexpr std::int64_t kNoTile = -1;

// MPI's own waiting keeps a core busy; tiles take longer than this.
constexpr std::chrono::microseconds kPause{100};

// Calls are made by one thread at a time: not every MPI allows more.
std::mutex mpi_mutex;

// A message that has come, if any.
std::optional<MPI_Status> incoming(int source, int tag) {
    int has_come = 0;
    MPI_Status status;
    MPI_Iprobe(source, tag, MPI_COMM_WORLD, &has_come, &status);
    if (has_come == 0) return std::nullopt;
    return status;
}

std::optional<std::size_t> ask_for_tile(std::size_t of_thread) {
    const int thread = static_cast<int>(of_thread);
    {
        const std::scoped_lock lock(mpi_mutex);
        MPI_Send(&thread, 1, MPI_INT, 0, kAsk, MPI_COMM_WORLD);
    }
    for (;; std::this_thread::sleep_for(kPause)) {
        const std::scoped_lock lock(mpi_mutex);
        if (!incoming(0, kTile + thread)) continue;
        std::int64_t tile = kNoTile;
        MPI_Recv(&tile, 1, MPI_INT64_T, 0, kTile + thread, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        if (tile == kNoTile) return std::nullopt;
        return static_cast<std::size_t>(tile);
    }
}

void bring_values(std::size_t tile, std::span<const double> values) {
    // One message, so that it stays together: the tile's index is exact as a double.
    std::vector<double> message{static_cast<double>(tile)};
    message.insert(message.end(), values.begin(), values.end());
    const std::scoped_lock lock(mpi_mutex);
    MPI_Send(message.data(), static_cast<int>(message.size()), MPI_DOUBLE, 0, kValues,
             MPI_COMM_WORLD);
}

void answer(const MPI_Status& status, const TileDesk& desk) {
    int thread = 0;
    MPI_Recv(&thread, 1, MPI_INT, status.MPI_SOURCE, kAsk, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    const auto next = desk.next(0);
    const std::int64_t tile = next ? static_cast<std::int64_t>(*next) : kNoTile;
    MPI_Send(&tile, 1, MPI_INT64_T, status.MPI_SOURCE, kTile + thread, MPI_COMM_WORLD);
}

void take_values(const MPI_Status& status, const TileDesk& desk) {
    int size = 0;
    MPI_Get_count(&status, MPI_DOUBLE, &size);
    std::vector<double> message(static_cast<std::size_t>(size));
    MPI_Recv(message.data(), size, MPI_DOUBLE, status.MPI_SOURCE, kValues, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    desk.done(static_cast<std::size_t>(message[0]), std::span(message).subspan(1));
}

}  // namespace

Expected<RankGroup> RankGroup::join() {
    RankGroup group;
    if (processes_started() == 1) return group;
    int provided = MPI_THREAD_SINGLE;
    if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided) != MPI_SUCCESS) {
        return Error{"MPI cannot be started"};
    }
    group.is_joined_ = true;
    if (provided < MPI_THREAD_SERIALIZED) {
        return Error{"this MPI knows no MPI_THREAD_SERIALIZED, which tactspace needs"};
    }
    MPI_Comm_rank(MPI_COMM_WORLD, &group.rank);
    MPI_Comm_size(MPI_COMM_WORLD, &group.count);
    return group;
}

RankGroup::~RankGroup() {
    if (is_joined_) MPI_Finalize();
}

bool RankGroup::agrees(std::uint64_t number) const {
    if (count == 1) return number != 0;
    // The least of all numbers, and of all complements: the complement of the greatest.
    const std::uint64_t own[2]{number, ~number};
    std::uint64_t least[2]{};
    MPI_Allreduce(own, least, 2, MPI_UINT64_T, MPI_MIN, MPI_COMM_WORLD);
    return least[0] == ~least[1] && number != 0;
}

TileDesk RankGroup::remote_desk() const { return {ask_for_tile, bring_values}; }

void RankGroup::leave() const {
    const std::scoped_lock lock(mpi_mutex);
    MPI_Send(nullptr, 0, MPI_INT, 0, kLeave, MPI_COMM_WORLD);
}

void RankGroup::serve(const TileDesk& desk) const {
    for (int others = count - 1; others > 0;) {
        const auto status = incoming(MPI_ANY_SOURCE, MPI_ANY_TAG);
        if (!status) {
            std::this_thread::sleep_for(kPause);
        } else if (status->MPI_TAG == kAsk) {
            answer(*status, desk);
        } else if (status->MPI_TAG == kValues) {
            take_values(*status, desk);
        } else {
            MPI_Recv(nullptr, 0, MPI_INT, status->MPI_SOURCE, kLeave, MPI_COMM_WORLD,
                     MPI_STATUS_IGNORE);
            --others;
        }
    }
}

void RankGroup::meet() const {
    if (count > 1) MPI_Barrier(MPI_COMM_WORLD);
}

#else

Expected<RankGroup> RankGroup::join() {
    if (processes_started() > 1) {
        return Error{
            "this tactspace was built without MPI, and every process would do all the work; "
            "expected a build with cmake -DTACT_MPI=ON"};
    }
    return RankGroup();
}

RankGroup::~RankGroup() = default;
bool RankGroup::agrees(std::uint64_t number) const { return number != 0; }
TileDesk RankGroup::remote_desk() const { return {}; }
void RankGroup::leave() const {}
void RankGroup::serve(const TileDesk&) const {}
void RankGroup::meet() const {}

#endif

}  // namespace tact
