// tactspace predict: the dissimilarity of every pair; PM and its parts tile by tile.

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/command_line/commands.h"
#include "app/command_line/endings.h"
#include "app/command_line/mpi.h"
#include "app/command_line/output.h"
#include "app/command_line/tile_run.h"
#include "app/pictures/pictures.h"
#include "model/common/fingerprint.h"
#include "model/io/tables/matrix_file.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/tasks/set_pairs.h"
#include "model/text/atomic_file.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

// Whose numbers these are.
struct Named {
    std::vector<std::string> patterns;
    Labels labels;
};

struct Work {
    TileRun tiles;
    Named named;
    double nc_weight = 0.0;
    double oc_weight = 0.0;
    PictureSize image;
    std::vector<fs::path> joined{};  // files of tiles that go when the matrix is there
};

std::vector<Part> parts_of(const std::string& metric) {
    if (metric == "nc") return {Part::nc};
    if (metric == "oc") return {Part::oc};
    return {Part::nc, Part::oc};
}

// False of a pipe or a device, which nothing can be kept beside.
bool can_be_file(const fs::path& out) {
    std::error_code none;
    return !out.empty() && (fs::is_regular_file(out, none) || !fs::exists(out, none));
}

// "3/16" as its two numbers.
Expected<TileShare> share_in(const std::string& text) {
    const std::size_t bar = text.find('/');
    const auto k = finite_number_in(std::string_view(text).substr(0, bar));
    const auto n = bar == std::string::npos
                       ? std::nullopt
                       : finite_number_in(std::string_view(text).substr(bar + 1));
    constexpr double kMostParts = 1e6;
    if (!k || !n || *k != std::floor(*k) || *n != std::floor(*n) || *k < 1.0 || *k > *n ||
        *n > kMostParts) {
        return Error{"--part: expected K/N such as 3/16, got \"" + text + "\""};
    }
    return TileShare{static_cast<std::size_t>(*k), static_cast<std::size_t>(*n)};
}

fs::path part_file(const PredictCommand& command, const TileShare& share) {
    return command.out.string() + ".part-" + std::to_string(share.k) + "-of-" +
           std::to_string(share.n) + ".tiles";
}

// What runs with --part have kept beside the result, by name.
Expected<std::vector<fs::path>> kept_parts(const PredictCommand& command) {
    const std::string begin = command.out.filename().string() + ".part-";
    fs::path folder = command.out.parent_path();
    if (folder.empty()) folder = ".";
    std::vector<fs::path> files;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with(begin) && name.ends_with(".tiles")) files.push_back(entry.path());
    }
    std::ranges::sort(files);
    if (!files.empty()) return files;
    return Error{command.out.string() +
                 ": nothing to join; runs with --part K/N and this --out keep their tiles "
                 "beside it"};
}

// The file for finished tiles; empty where none can be kept. Refuses now what would fail after
// hours, and what would lose the hours of an earlier run.
Expected<fs::path> tiles_file(const PredictCommand& command) {
    if (!can_be_file(command.out)) {
        if (!command.part.empty() || command.join) {
            return Error{"--part and --join need --out FILE: tiles are kept beside it"};
        }
        if (!command.resume) return fs::path();
        return Error{"--resume needs --out FILE: finished tiles are kept in FILE.tiles"};
    }
    if (const auto writable = AtomicFile::open(command.out); !writable) return writable.error();
    if (command.join) return fs::path();
    fs::path file = command.out.string() + ".tiles";
    if (!command.part.empty()) {
        const Expected<TileShare> share = share_in(command.part);
        if (!share) return share.error();
        file = part_file(command, *share);
    }
    std::error_code none;
    if (!command.resume && fs::exists(file, none)) {
        return Error{file.string() +
                     ": holds what an earlier run finished; add --resume to continue it, or "
                     "remove it to start again"};
    }
    return file;
}

// With the format that the picture's name says, before any work.
Expected<PictureSize> picture_asked_for(const PredictCommand& command) {
    PictureSize image;
    if (command.image.empty()) return image;
    const Expected<PictureFormat> format = picture_format(command.image);
    if (!format) return format.error();
    image.format = *format;
    return image;
}

// Remarks about a set that every rank reads are wanted once.
Expected<FeltSet> load_on(const RankGroup& ranks, const CommonOptions& options) {
    if (ranks.rank == 0) return load_felt(options);
    std::streambuf* const console = std::cerr.rdbuf(nullptr);
    Expected<FeltSet> set = load_felt(options);
    std::cerr.rdbuf(console);
    return set;
}

Expected<Work> prepared(const PredictCommand& command, const RankGroup& ranks,
                        std::stop_token stop) {
    Work work;
    if (ranks.rank == 0) {
        const Expected<fs::path> file = tiles_file(command);
        if (!file) return file.error();
        work.tiles.keeping.path = *file;
        // A part is kept however soon it is done.
        work.tiles.keeping.resume = command.resume || !command.part.empty();
        const Expected<PictureSize> image = picture_asked_for(command);
        if (!image) return image.error();
        work.image = *image;
    }
    const Expected<FeltSet> loaded = load_on(ranks, command.common);
    if (!loaded) return loaded.error();
    const PatternSet& set = loaded->felt;
    if (const auto pair = need_a_pair(set, command.common); !pair) return pair.error();
    work.named = {names_of(set), loaded->labels};
    if (!command.part.empty()) work.tiles.share = *share_in(command.part);
    work.nc_weight = set.model.nc_weight;
    work.oc_weight = set.model.oc_weight;
    work.tiles.parts = parts_of(command.metric);
    work.tiles.threads = command.common.threads;
    work.tiles.stop = stop;
    auto source = tile_source(
        set, command.common.threads, stop,
        ranks.rank == 0 ? progress_line("coding patterns") : std::function<void(double)>{});
    if (!source) return source.error();
    work.tiles.source = std::move(*source);
    if (ranks.rank > 0) return work;
    if (const auto begun = begin_tiles(work.tiles); !begun) return begun.error();
    if (!command.join) return work;
    const Expected<std::vector<fs::path>> files = kept_parts(command);
    if (!files) return files.error();
    work.joined = *files;
    if (const auto joined = join_tiles(work.tiles, *files); !joined) return joined.error();
    return work;
}

// For a person who waits at a terminal: what takes a while and cannot say how far it is. Shown
// until something else is.
void show(const std::string& what, std::size_t pairs) {
    constexpr std::size_t kSlow = 2'000'000;  // half a second
    if (pairs < kSlow || isatty(STDERR_FILENO) == 0) return;
    std::fprintf(stderr, "\r%s\033[K", shown_text(what).c_str());
}

// PM in the place of NC: there may be no room for one more matrix.
Dissimilarity rank_sum(Work& work) {
    Dissimilarity& pm = work.tiles.made[static_cast<std::size_t>(Part::nc)].matrix;
    Dissimilarity& oc = work.tiles.made[static_cast<std::size_t>(Part::oc)].matrix;
    show("ranking " + grouped_digits(pm.condensed.size()) + " pairs", pm.condensed.size());
    replace_by_ranks(pm.condensed);
    replace_by_ranks(oc.condensed);
    for (std::size_t k = 0; k < pm.condensed.size(); ++k) {
        pm.condensed[k] = pm_of(pm.condensed[k], oc.condensed[k], work.nc_weight, work.oc_weight);
    }
    oc = {};
    return std::move(pm);
}

Dissimilarity matrix_of(Work& work) {
    const std::vector<Part>& parts = work.tiles.parts;
    if (parts.size() > 1) return rank_sum(work);
    return std::move(work.tiles.made[static_cast<std::size_t>(parts[0])].matrix);
}

// Number by number: as one value, JSON of a large matrix takes several times its memory.
void print_json(std::ostream& stream, const Named& named, const std::string& metric,
                const Dissimilarity& matrix) {
    stream << "{\"condensed\":";
    char before = '[';
    for (const double value : matrix.condensed) {
        stream << before << nlohmann::json(value);
        before = ',';
    }
    stream << "],\"labels\":" << nlohmann::json(named.patterns)
           << ",\"metric\":" << nlohmann::json(metric);
    if (!lines_of(named.labels).empty()) {
        nlohmann::json labels;
        add_labels(labels, named.labels);
        for (const auto& [key, value] : labels.items()) {
            stream << "," << nlohmann::json(key) << ":" << value;
        }
    }
    stream << "}\n";
}

Expected<Done> write_matrix(const PredictCommand& command, const Named& named,
                            const Dissimilarity& matrix, const PictureSize& image) {
    show("writing", matrix.condensed.size());
    const Expected<Done> written = write_result(command.out, [&](std::ostream& stream) {
        if (command.common.json) {
            print_json(stream, named, command.metric, matrix);
        } else {
            write_matrix_csv(stream, named.patterns, matrix, corner_of(named.labels));
        }
    });
    show("", matrix.condensed.size());
    if (!written || command.image.empty()) return written;
    const std::string quantity = traits(*metric_named(command.metric)).name;
    return write_picture(command.image, matrix_picture(named.patterns, matrix, quantity, image,
                                                       corner_of(named.labels)));
}

bool has_tiles(const std::string& metric) {
    return metric == "pm" || metric == "nc" || metric == "oc";
}

// The metric asked for, with options that fit it.
Expected<Metric> metric_of(const PredictCommand& command) {
    const Expected<Metric> metric = metric_named(command.metric);
    if (!metric) return metric;
    if (command.resume && !has_tiles(command.metric)) {
        return Error{"--resume is for pm, nc and oc: nothing is kept of a run with --metric " +
                     command.metric};
    }
    if ((!command.part.empty() || command.join) && !has_tiles(command.metric)) {
        return Error{"--part and --join are for pm, nc and oc, which are made tile by tile"};
    }
    if (command.first_as_reference && !traits(*metric).is_directional) {
        return Error{"--first-as-reference is for st-sim and spqi: " + command.metric +
                     " is the same both ways"};
    }
    return metric;
}

// A metric without tiles, the whole matrix at once.
Expected<Done> run_whole(const PredictCommand& command, Metric metric, std::stop_token stop) {
    if (const auto writable = writable_result(command.out); !writable) return writable;
    const Expected<PictureSize> image = picture_asked_for(command);
    if (!image) return image.error();
    const Expected<FeltSet> loaded = load_felt(command.common);
    if (!loaded) return loaded.error();
    const PatternSet& set = loaded->felt;
    if (const auto pair = need_a_pair(set, command.common); !pair) return pair;
    PairsRequest request{metric, false};
    request.options.threads = command.common.threads;
    request.options.stop = std::move(stop);
    request.options.progress = progress_line("comparing patterns");
    if (command.first_as_reference) request.options.direction = Direction::first_is_reference;
    const auto pairs = set_pairs(set, request);
    if (!pairs) return Error{"stopped, and nothing is kept of a metric other than pm, nc and oc"};
    return write_matrix(command, {names_of(set), loaded->labels}, pairs->apart, *image);
}

// The number that ranks agree in if they make tiles of one matrix.
std::uint64_t work_number(const Work& work) {
    const TileRun& run = work.tiles;
    std::uint64_t number = mixed(mixed(fingerprint(run.source), run.share.k), run.share.n);
    for (const Part part : run.parts) number = mixed(number, static_cast<std::uint64_t>(part));
    return number;
}

// The tiles, made by all ranks together.
Expected<Work> computed(const PredictCommand& command, const RankGroup& ranks,
                        std::stop_token stop) {
    Expected<Work> work = prepared(command, ranks, stop);
    // Before any of them waits for another in vain.
    const Expected<Done> agreed =
        work ? ranks.agree(work_number(*work), "") : ranks.agree(0, work.error().message);
    if (!agreed) return agreed.error();
    if (const auto made = make_all_tiles(work->tiles, ranks); !made) return made.error();
    work->tiles.source = {};
    return work;
}

// A part is kept for a run that joins all of them.
void say_kept(const PredictCommand& command, const TileRun& tiles) {
    std::cerr << "tactspace: " << share_of_tiles(tiles) << " of part " << command.part
              << " are kept in " << shown_text(tiles.keeping.path.string())
              << "; --join makes the matrix of all parts\n";
}

Expected<Done> run_tiles(const PredictCommand& command, Metric metric, const RankGroup& ranks,
                         std::stop_token stop) {
    Expected<Work> work = computed(command, ranks, std::move(stop));
    if (!work) return work.error();
    if (ranks.rank > 0) return Done{};
    if (!command.part.empty()) {
        say_kept(command, work->tiles);
        return Done{};
    }
    const Dissimilarity matrix = as_ranked(metric, matrix_of(*work));
    const Expected<Done> written = write_matrix(command, work->named, matrix, work->image);
    if (written && work->tiles.keeping.file) work->tiles.keeping.file->remove();
    std::error_code none;
    for (const fs::path& file : work->joined) {
        if (written) fs::remove(file, none);
    }
    return written;
}

Expected<Done> run_on(const PredictCommand& command, const RankGroup& ranks, std::stop_token stop) {
    const Expected<Metric> metric = metric_of(command);
    if (!metric) return metric.error();
    if (has_tiles(command.metric)) return run_tiles(command, *metric, ranks, std::move(stop));
    if (ranks.rank > 0) return Done{};
    if (ranks.count > 1) {
        std::cerr << "tactspace: " << command.metric
                  << " is not shared among ranks, and the first of " << ranks.count
                  << " works alone; pm, nc and oc are shared\n";
    }
    return run_whole(command, *metric, std::move(stop));
}

}  // namespace

Expected<Done> run(const PredictCommand& command) {
    Interrupt interrupt;  // first: threads, MPI's too, inherit what it blocks
    Expected<RankGroup> ranks = RankGroup::join(interrupt);
    if (!ranks) return ranks.error();
    return ranks->ended(run_on(command, *ranks, interrupt.token()));
}

}  // namespace tact
