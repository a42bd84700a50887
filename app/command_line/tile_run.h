// A matrix made tile by tile, with what is finished kept in a file once the work is long.
#pragma once

#include <array>
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/command_line/mpi.h"
#include "model/io/tables/checkpoint.h"
#include "model/perceptual_model/tiles.h"
#include "model/set/pattern_set.h"

namespace tact {

// Where finished tiles are kept. The file is made when the work has taken some seconds, or at once
// when the work is to be resumed.
struct TileKeeping {
    std::filesystem::path path;  // empty: nothing is kept
    bool resume = false;
    std::optional<Checkpoint> file;  // none: not yet, or given up after a failure
    bool is_given_up = false;
    std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
};

// The tiles of a matrix that one of several runs makes: the k-th of n, from 1 on.
struct TileShare {
    std::size_t k = 1;
    std::size_t n = 1;
};

struct PartTiles {
    Dissimilarity matrix;
    std::vector<bool> is_finished;  // by tile
};

struct TileRun {
    TileSource source;
    std::vector<Part> parts;
    int threads = 0;
    std::stop_token stop;
    TileKeeping keeping;
    TileShare share{};              // what is not of it is left to others
    std::array<PartTiles, 2> made;  // by Part
};

// The codes of all patterns, without the waveforms, which take as much memory as all the rest. An
// Error when stopped.
Expected<TileSource> tile_source(const PatternSet& set, int threads, std::stop_token stop,
                                 const std::function<void(double)>& progress);

// On rank 0, first: room for the matrices, and what an earlier run left if it is to continue.
Expected<Done> begin_tiles(TileRun& run);

// The tiles of files that runs of the same matrix have left. An Error names what is missing.
Expected<Done> join_tiles(TileRun& run, const std::vector<std::filesystem::path>& files);

// How many of the share's tiles there are: "120 of 1,920 tiles".
std::string share_of_tiles(const TileRun& run);

// Makes all tiles of its share that are missing, with the help of the other ranks; these see
// nothing but the tiles they were given. An Error when stopped says how to continue.
Expected<Done> make_all_tiles(TileRun& run, const RankGroup& ranks);

}  // namespace tact
