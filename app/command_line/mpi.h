// Tiles shared among the processes that mpirun started, on one machine or on many.
//
// Rank 0 keeps the matrix and hands out tiles, one at a time, so that slow machines take fewer; it
// computes too, and is the only one that speaks. Every rank reads the set itself. Built with
// -DTACT_MPI=ON; without, a process is always alone.
//
// A signal to any rank stops all of them, with one exit code. mpirun sends its own to every rank,
// and kills them a second later; since it answers none of them from then on, a rank that was
// stopped ends without MPI_Finalize.
//
// Exact     same matrix for any number of ranks and threads.
// Left out  ranks that die: mpirun ends the others then, and a new run continues from the
//           checkpoint.
#pragma once

#include <cstdint>
#include <string>

#include "app/command_line/endings.h"
#include "model/common/expected.h"
#include "model/perceptual_model/tiles.h"

namespace tact {

class RankGroup {
  public:
    // Alone unless mpirun started the program. `interrupt` has to live longer.
    static Expected<RankGroup> join(Interrupt& interrupt);

    int rank = 0;
    int count = 1;

    // All ranks meet here: each with the number that stands for its work, or the fault that keeps
    // it from working. On all of them the Error of the lowest rank that has a fault, or the word
    // that numbers differ.
    Expected<Done> agree(std::uint64_t number, const std::string& fault) const;

    // Where the threads of a rank above 0 get their tiles and bring the values. To be used up, then
    // left by leave().
    TileDesk remote_desk() const;
    void leave() const;

    // On rank 0: answers the others from `desk` until all of them left.
    void serve(const TileDesk& desk) const;

    // All ranks wait for each other here.
    void meet() const;

    // Last of all, on all ranks: rank 0 tells its Error, then all meet, so that none ends before:
    // mpirun ends the others soon. The outcome of this rank, without the words that were told.
    Expected<Done> ended(const Expected<Done>& outcome);

  private:
    explicit RankGroup(Interrupt& interrupt) : interrupt_(&interrupt) {}
    [[maybe_unused]] Interrupt* interrupt_;  // not used without MPI
};

}  // namespace tact
