// Tiles shared among the processes that mpirun started, on one machine or on many.
//
// Rank 0 keeps the matrix and hands out tiles, one at a time, so that slow machines take fewer; it
// computes too. Every rank reads the set itself. Built with -DTACT_MPI=ON; without, a process is
// always alone.
//
// Exact     same matrix for any number of ranks and threads.
// Left out  ranks that die: mpirun ends the others then, and a new run continues from the
//           checkpoint.
#pragma once

#include <cstdint>
#include <optional>

#include "model/common/expected.h"
#include "model/perceptual_model/tiles.h"

namespace tact {

class RankGroup {
  public:
    // Alone unless mpirun started the program.
    static Expected<RankGroup> join();

    int rank = 0;
    int count = 1;

    // True on every rank if all of them gave the same number; 0 stands for none and never agrees.
    bool agrees(std::uint64_t number) const;

    // Where the threads of a rank above 0 get their tiles and bring the values. To be used up, then
    // left by leave().
    TileDesk remote_desk() const;
    void leave() const;

    // On rank 0: answers the others from `desk` until all of them left.
    void serve(const TileDesk& desk) const;

    // All ranks wait for each other here.
    void meet() const;

    RankGroup(RankGroup&& other) noexcept;
    RankGroup& operator=(RankGroup&&) = delete;
    ~RankGroup();

  private:
    RankGroup() = default;
    bool is_joined_ = false;
};

}  // namespace tact
