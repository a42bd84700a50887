#include "app/command_line/mpi.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

#ifdef TACT_MPI
#include <mpi.h>

#include <array>
#include <chrono>
#include <iostream>
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

#ifdef TACT_MPI

namespace {

// Tags of messages.
constexpr int kAsk = 1;
constexpr int kValues = 2;
constexpr int kLeave = 3;
constexpr int kTile = 4;  // and up, by thread: what each asked for
constexpr std::int64_t kNoTile = -1;

// Asking for a tile: who asks, and the signal that its rank was stopped by, or 0.
using Question = std::array<int, 2>;

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

void wait_for(MPI_Request request) {
    for (int is_done = 0;; std::this_thread::sleep_for(kPause)) {
        MPI_Test(&request, &is_done, MPI_STATUS_IGNORE);
        if (is_done != 0) return;
    }
}

// The least value that any rank has.
template <class Number>
Number least(Number own, MPI_Datatype type) {
    Number of_all{};
    MPI_Request request;
    MPI_Iallreduce(&own, &of_all, 1, type, MPI_MIN, MPI_COMM_WORLD, &request);
    wait_for(request);
    return of_all;
}

std::string words_of(int rank, std::string words) {
    int size = static_cast<int>(words.size());
    MPI_Bcast(&size, 1, MPI_INT, rank, MPI_COMM_WORLD);
    words.resize(static_cast<std::size_t>(size));
    MPI_Bcast(words.data(), size, MPI_CHAR, rank, MPI_COMM_WORLD);
    return words;
}

std::optional<std::size_t> ask_for_tile(std::size_t of_thread) {
    const int thread = static_cast<int>(of_thread);
    {
        const Question question{thread, interrupting_signal()};
        const std::scoped_lock lock(mpi_mutex);
        MPI_Send(question.data(), 2, MPI_INT, 0, kAsk, MPI_COMM_WORLD);
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

void answer(const MPI_Status& status, const TileDesk& desk, Interrupt& interrupt) {
    Question question{};
    MPI_Recv(question.data(), 2, MPI_INT, status.MPI_SOURCE, kAsk, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    const auto [thread, signal] = question;
    if (signal != 0) interrupt.stop_by(signal);
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

Expected<RankGroup> RankGroup::join(Interrupt& interrupt) {
    RankGroup group(interrupt);
    if (processes_started() == 1) return group;
    int provided = MPI_THREAD_SINGLE;
    if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided) != MPI_SUCCESS) {
        return Error{"MPI cannot be started"};
    }
    if (provided < MPI_THREAD_SERIALIZED) {
        return Error{"this MPI knows no MPI_THREAD_SERIALIZED, which tactspace needs"};
    }
    MPI_Comm_rank(MPI_COMM_WORLD, &group.rank);
    MPI_Comm_size(MPI_COMM_WORLD, &group.count);
    if (group.count == 1) {
        return Error{
            "several processes were started, and MPI tells each that it is alone; expected mpirun "
            "of the MPI that this tactspace was built with, or srun --mpi=pmix"};
    }
    if (group.rank > 0) interrupt.be_silent();
    return group;
}

Expected<Done> RankGroup::agree(std::uint64_t number, const std::string& fault) const {
    if (count == 1) return fault.empty() ? Expected<Done>(Done{}) : Error{fault};
    const int faulty = least(fault.empty() ? count : rank, MPI_INT);
    if (faulty < count) {
        const std::string words = words_of(faulty, fault);
        return Error{faulty == 0 ? words : "rank " + std::to_string(faulty) + ": " + words};
    }
    // The least complement is that of the greatest.
    if (least(number, MPI_UINT64_T) == ~least(~number, MPI_UINT64_T)) return Done{};
    return Error{"the ranks read different sets, or were given different options"};
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
            answer(*status, desk, *interrupt_);
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
    if (count == 1) return;
    MPI_Request request;
    MPI_Ibarrier(MPI_COMM_WORLD, &request);
    wait_for(request);
}

Expected<Done> RankGroup::ended(const Expected<Done>& outcome) {
    if (count == 1) return outcome;
    if (rank == 0 && !outcome) std::cerr << "tactspace: " << outcome.error().message << "\n";
    const int signal = -least(-interrupting_signal(), MPI_INT);
    if (signal == 0) {
        MPI_Finalize();
    } else {
        interrupt_->stop_by(signal);
    }
    if (outcome && (rank == 0 || signal == 0)) return outcome;
    return Error{""};
}

#else

Expected<RankGroup> RankGroup::join(Interrupt& interrupt) {
    if (processes_started() > 1) {
        return Error{
            "this tactspace was built without MPI, and every process would do all the work; "
            "expected the package tactspace-mpi, or a build with cmake -DTACT_MPI=ON"};
    }
    return RankGroup(interrupt);
}

Expected<Done> RankGroup::agree(std::uint64_t, const std::string& fault) const {
    return fault.empty() ? Expected<Done>(Done{}) : Error{fault};
}

TileDesk RankGroup::remote_desk() const { return {}; }
void RankGroup::leave() const {}
void RankGroup::serve(const TileDesk&) const {}
void RankGroup::meet() const {}
Expected<Done> RankGroup::ended(const Expected<Done>& outcome) { return outcome; }

#endif

}  // namespace tact
