#include "app/command_line/tile_run.h"

#include <algorithm>
#include <iostream>
#include <mutex>
#include <thread>

#include "app/command_line/output.h"
#include "model/common/parallel.h"
#include "model/io/set/set_file.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"

namespace tact {

namespace {

// Shorter work is soon done again, and need not leave files about.
constexpr std::chrono::seconds kWorthKeeping{3};

std::size_t length_of(const Vibration& vibration) {
    return sample_count(own_duration_s(vibration), kModelRateHz);
}

PartTiles& made_of(TileRun& run, Part part) { return run.made[static_cast<std::size_t>(part)]; }

const char* work_on(Part part) {
    return part == Part::nc ? "comparing brain waveforms" : "comparing rhythms";
}

std::size_t finished_count(const TileRun& run) {
    std::size_t count = 0;
    for (const PartTiles& made : run.made) {
        count += static_cast<std::size_t>(std::ranges::count(made.is_finished, true));
    }
    return count;
}

// Dealt in the order of their costs, so that shares take as long as each other.
std::vector<std::size_t> tiles_of_share(const TileRun& run, std::span<const double> costs) {
    std::vector<std::size_t> own;
    const std::vector<std::size_t> all = by_cost(costs);
    for (std::size_t at = run.share.k - 1; at < all.size(); at += run.share.n) {
        own.push_back(all[at]);
    }
    return own;
}

std::size_t wanted_count(const TileRun& run) {
    // What tiles are made from is gone when the last of them is there.
    const std::size_t all =
        tile_count(run.made[static_cast<std::size_t>(run.parts[0])].matrix.size);
    return run.parts.size() * ((all - run.share.k + run.share.n) / run.share.n);
}

// Work without a checkpoint is better than none.
void give_up_keeping(TileKeeping& keeping, const Error& reason) {
    keeping.file.reset();
    keeping.is_given_up = true;
    std::cerr << "tactspace: " << reason.message << "; going on without keeping tiles\n";
}

void keep(TileKeeping& keeping, Part part, std::size_t tile, std::span<const double> values) {
    if (!keeping.file) return;
    const auto appended = keeping.file->append(part, tile, values);
    if (!appended) give_up_keeping(keeping, appended.error());
}

// Opens the file, with all in it that was finished before the work proved to be long.
void begin_keeping(TileRun& run) {
    TileKeeping& keeping = run.keeping;
    auto opened = Checkpoint::open(keeping.path, key_of(run.source));
    if (!opened) return give_up_keeping(keeping, opened.error());
    keeping.file.emplace(std::move(*opened));
    for (const Part part : run.parts) {
        const PartTiles& made = made_of(run, part);
        for (std::size_t k = 0; k < made.is_finished.size(); ++k) {
            if (!made.is_finished[k]) continue;
            keep(keeping, part, k, tile_of(made.matrix, tile_at(made.matrix.size, k)));
        }
    }
}

bool is_time_to_keep(const TileKeeping& keeping) {
    return !keeping.path.empty() && !keeping.file && !keeping.is_given_up &&
           std::chrono::steady_clock::now() - keeping.begin > kWorthKeeping;
}

Expected<Done> take_tiles(TileRun& run, const Checkpoint& file, const std::filesystem::path& path) {
    if (file.damaged_places() > 0) {
        std::cerr << "tactspace: " << shown_text(path.string()) << ": damaged in "
                  << counted(file.damaged_places(), "place", "places")
                  << "; what stood there is made again\n";
    }
    for (const Part part : run.parts) {
        PartTiles& made = made_of(run, part);
        const auto read = file.read(part, [&](std::size_t tile, auto values) {
            put_tile(made.matrix, tile_at(made.matrix.size, tile), values);
            made.is_finished[tile] = true;
        });
        if (!read) return read;
    }
    return Done{};
}

Expected<Done> take_up(TileRun& run) {
    TileKeeping& keeping = run.keeping;
    auto opened = Checkpoint::open(keeping.path, key_of(run.source));
    if (!opened) return opened.error();
    keeping.file.emplace(std::move(*opened));
    if (const auto read = take_tiles(run, *keeping.file, keeping.path); !read) return read;
    if (finished_count(run) > 0) {
        std::cerr << "tactspace: " << share_of_tiles(run) << " were finished before\n";
    }
    return Done{};
}

Error stopped(const TileRun& run) {
    const TileKeeping& keeping = run.keeping;
    if (keeping.file) {
        return Error{"stopped with " + share_of_tiles(run) + " finished and kept in " +
                     keeping.path.string() + "; the same command with --resume continues"};
    }
    std::error_code none;
    if (keeping.is_given_up && std::filesystem::exists(keeping.path, none)) {
        return Error{"stopped; " + keeping.path.string() +
                     " has what was finished before it could not be written to any more, and the "
                     "same command with --resume continues from there"};
    }
    if (keeping.path.empty()) {
        return Error{"stopped, and nothing is kept; a long run with --out FILE can be resumed"};
    }
    return Error{"stopped, and nothing is kept of so short a run"};
}

// Tiles of one part on rank 0, where all values come together.
void make_tiles_of(TileRun& run, Part part, const RankGroup& ranks) {
    PartTiles& made = made_of(run, part);
    const std::size_t patterns = pattern_count(run.source);
    const std::vector<double> costs = tile_costs(run.source, part);
    std::vector<std::size_t> open = tiles_of_share(run, costs);
    std::erase_if(open, [&](std::size_t k) { return made.is_finished[k]; });
    double open_cost = 0.0;
    for (const std::size_t k : open) open_cost += costs[k];
    const auto progress = progress_line(work_on(part));
    std::mutex mutex;
    std::size_t next = 0;  // in `open`
    double done_cost = 0.0;
    TileDesk desk;
    desk.next = [&](std::size_t) -> std::optional<std::size_t> {
        const std::scoped_lock lock(mutex);
        if (next == open.size() || run.stop.stop_requested()) return std::nullopt;
        return open[next++];
    };
    desk.done = [&](std::size_t tile, std::span<const double> values) {
        const std::scoped_lock lock(mutex);
        put_tile(made.matrix, tile_at(patterns, tile), values);
        made.is_finished[tile] = true;
        if (is_time_to_keep(run.keeping)) {
            begin_keeping(run);
        } else {
            keep(run.keeping, part, tile, values);
        }
        done_cost += costs[tile];
        if (!progress || run.stop.stop_requested()) return;
        progress(open_cost > 0.0 ? done_cost / open_cost : 1.0);
    };
    std::jthread server;
    if (ranks.count > 1) server = std::jthread([&] { ranks.serve(desk); });
    make_tiles(run.source, part, run.threads, desk, run.stop);
}

}  // namespace

Expected<TileSource> tile_source(const PatternSet& set, int threads, std::stop_token stop,
                                 const std::function<void(double)>& progress) {
    TileSource source;
    source.channel_weight = set.model.channel_weight;
    source.waiting_cost = set.model.envelope.waiting_cost;
    source.vibrations = vibrations_fingerprint(set);
    source.model = model_fingerprint(set);
    PredictOptions options;
    options.threads = threads;
    options.stop = stop;
    for (const Vibration& vibration : set.vibrations) {
        options.samples = std::max(options.samples, length_of(vibration));
    }
    constexpr std::size_t kAtOnce = 256;  // waveforms in memory
    for (std::size_t begin = 0; begin < set.vibrations.size(); begin += kAtOnce) {
        std::vector<Waveform> waveforms(std::min(kAtOnce, set.vibrations.size() - begin));
        parallel_for(waveforms.size(), threads, stop,
                     [&](std::size_t k) { waveforms[k] = waveform_of(set.vibrations[begin + k]); });
        for (const auto& code : pattern_codes(waveforms, set.model, options)) {
            add_pattern(source, *code);
        }
        if (stop.stop_requested()) return Error{"stopped before any pair was compared"};
        if (progress) {
            progress(static_cast<double>(pattern_count(source)) /
                     static_cast<double>(set.vibrations.size()));
        }
    }
    return source;
}

Expected<Done> begin_tiles(TileRun& run) {
    const std::size_t patterns = pattern_count(run.source);
    for (const Part part : run.parts) {
        made_of(run, part) = {{patterns, std::vector<double>(pair_count(patterns))},
                              std::vector<bool>(tile_count(patterns))};
    }
    return run.keeping.resume ? take_up(run) : Done{};
}

Expected<Done> make_all_tiles(TileRun& run, const RankGroup& ranks) {
    for (const Part part : run.parts) {
        if (ranks.rank == 0) {
            make_tiles_of(run, part, ranks);
        } else {
            make_tiles(run.source, part, run.threads, ranks.remote_desk(), run.stop);
            ranks.leave();
        }
        // Nobody asks for tiles of the next part before all have left this one.
        ranks.meet();
    }
    if (ranks.rank == 0 && finished_count(run) < wanted_count(run)) return stopped(run);
    return Done{};
}

std::string share_of_tiles(const TileRun& run) {
    return grouped_digits(finished_count(run)) + " of " + grouped_digits(wanted_count(run)) +
           " tiles";
}

Expected<Done> join_tiles(TileRun& run, const std::vector<std::filesystem::path>& files) {
    for (const std::filesystem::path& file : files) {
        const auto opened = Checkpoint::open(file, key_of(run.source));
        if (!opened) return opened.error();
        if (const auto taken = take_tiles(run, *opened, file); !taken) return taken;
    }
    if (finished_count(run) == wanted_count(run)) return Done{};
    return Error{share_of_tiles(run) +
                 " are there; a part that is missing, or was stopped, has to be run to its end"};
}

}  // namespace tact
