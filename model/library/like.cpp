#include "model/library/like.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>

#include "model/common/parallel.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/dtw/dtw.h"
#include "model/export/exported_set.h"
#include "model/io/set/load.h"
#include "model/library/library_folder.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// Reading and exporting take about this share of the time.
constexpr double kReadingShare = 0.3;

Waveform as_exported(const Vibration& vibration, const ExportTarget& target) {
    PatternSet alone;
    alone.vibrations.push_back(vibration);
    Vibration back = vibration;
    const ExportedPattern written = exported(vibration, with_full_scale(target, alone, 1));
    std::visit([&back](const auto& source) { back.source = source; }, written.back);
    return waveform_of(back);
}

// What is held against the wanted one, in the order of the question.
struct Others {
    std::vector<std::size_t> entry;
    std::vector<Waveform> waveforms;
};

struct ReadOther {
    std::optional<Waveform> waveform;
    std::string fault;
    bool is_held = true;
};

ReadOther read_other(const Library& library, std::size_t place, const LikeQuestion& question) {
    const auto vibration = vibration_of(library, library.entries[place]);
    if (!vibration) return {{}, vibration.error().message};
    if (!question.target) return {waveform_of(*vibration), {}};
    if (!is_held(*vibration, question.target->format)) return {{}, {}, false};
    return {as_exported(*vibration, *question.target), {}};
}

// None when stopped.
std::optional<Others> read_others(const Library& library, const LikeQuestion& question,
                                  const std::vector<std::size_t>& places, LikeAnswer& answer,
                                  const LikenessOptions& options) {
    std::vector<ReadOther> all(places.size());
    std::mutex counting;
    std::size_t done = 0;
    parallel_for(places.size(), options.threads, options.stop, [&](std::size_t k) {
        all[k] = read_other(library, places[k], question);
        const std::lock_guard lock(counting);
        ++done;
        if (options.progress) {
            options.progress(kReadingShare * static_cast<double>(done) /
                             static_cast<double>(places.size()));
        }
    });
    if (options.stop.stop_requested()) return std::nullopt;
    Others others;
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (!all[k].is_held) answer.not_held.push_back(places[k]);
        if (!all[k].fault.empty()) answer.unread.push_back(std::move(all[k].fault));
        if (!all[k].waveform) continue;
        others.entry.push_back(places[k]);
        others.waveforms.push_back(*std::move(all[k].waveform));
    }
    return others;
}

}  // namespace

std::size_t nearer_than_exported(const LikeAnswer& answer) {
    if (!answer.exported) return 0;
    return static_cast<std::size_t>(std::ranges::count_if(
        answer.hits, [&](const LikeHit& hit) { return hit.pm < answer.exported->pm; }));
}

Expected<LikeAnswer> most_alike(const Library& library, const LikeQuestion& question,
                                const LikenessOptions& options) {
    const Waveform wanted = waveform_of(question.wanted);
    LikeAnswer answer;
    std::vector<std::size_t> places;
    double samples = 0.0;
    for (const std::size_t place : question.among) {
        const LibraryEntry& entry = library.entries[place];
        if (!is_comparable(entry.duration_s, duration_s(wanted))) {
            answer.too_long.push_back(place);
            continue;
        }
        places.push_back(place);
        samples += entry.duration_s * kModelRateHz;
    }
    if (samples > static_cast<double>(kMaxSetSamples)) {
        return Error{"expected at most " + grouped_digits(kMaxSetSamples) +
                     " samples to compare: narrow the library by words"};
    }
    auto others = read_others(library, question, places, answer, options);
    if (!others) return Error{kLikeStopped};
    if (question.target && is_held(question.wanted, question.target->format)) {
        others->entry.push_back(library.entries.size());
        others->waveforms.push_back(as_exported(question.wanted, *question.target));
    }
    LikenessOptions rest = options;
    if (options.progress) {
        rest.progress = [&options](double share) {
            options.progress(kReadingShare + (1.0 - kReadingShare) * share);
        };
    }
    const auto row = likeness_row(wanted, others->waveforms, question.model, rest);
    if (!row) return Error{kLikeStopped};
    answer.is_wanted_felt = row->is_wanted_felt;
    for (std::size_t k = 0; k < others->entry.size(); ++k) {
        const LikeHit hit{others->entry[k], row->pm[k], row->nc[k], row->oc[k], row->felt[k]};
        if (hit.entry == library.entries.size()) {
            answer.exported = hit;
        } else {
            answer.hits.push_back(hit);
        }
    }
    std::ranges::stable_sort(answer.hits, {}, &LikeHit::pm);
    return answer;
}

namespace {

// Number of codes in memory at once.
constexpr std::size_t kAtOnce = 64;

// Coding is about this share of the work.
constexpr double kCodingShare = 0.4;

using Code = std::shared_ptr<const PatternCode>;

struct Row {
    const Waveform& wanted;
    Code own;  // of the wanted one at its own length
    const PerceptualModelParams& params;
    const LikenessOptions& options;
    LikenessRow result{};
};

// Null when stopped.
Code code_of(Waveform waveform, const Row& row) {
    const std::vector<Waveform> one{std::move(waveform)};
    const auto codes =
        pattern_codes(one, row.params, {.threads = 1, .stop = row.options.stop, .progress = {}});
    return codes.empty() ? nullptr : codes.front();
}

struct Pair {
    Code wanted;
    Code other;
};

Pair pair_of(const Row& row, const Waveform& other) {
    const std::size_t own = row.wanted.samples_g.size();
    const std::size_t samples = std::max(own, other.samples_g.size());
    return {samples == own ? row.own : code_of(padded(row.wanted, samples), row),
            code_of(padded(other, samples), row)};
}

// False when stopped.
bool add_to(Row& row, std::span<const Waveform> others,
            const std::function<void(double)>& progress) {
    const LikenessOptions& options = row.options;
    std::vector<Pair> pairs(others.size());
    parallel_for(others.size(), options.threads, options.stop,
                 [&](std::size_t k) { pairs[k] = pair_of(row, others[k]); });
    if (options.stop.stop_requested()) return false;
    if (progress) progress(kCodingShare);
    std::vector<SignalPair> envelopes;
    for (const Pair& pair : pairs) {
        row.result.nc.push_back(
            nc_dissimilarity(pair.wanted->neural, pair.other->neural, row.params.channel_weight));
        row.result.felt.push_back(is_felt(*pair.other));
        envelopes.push_back(envelopes_of(*pair.wanted, *pair.other));
    }
    DtwOptions warping{.threads = options.threads,
                       .waiting_cost = row.params.envelope.waiting_cost,
                       .stop = options.stop};
    if (progress) {
        warping.progress = [&progress](double share) {
            progress(kCodingShare + (1.0 - kCodingShare) * share);
        };
    }
    const std::vector<double> oc = dtw(envelopes, warping);
    row.result.oc.insert(row.result.oc.end(), oc.begin(), oc.end());
    return !options.stop.stop_requested();
}

}  // namespace

bool is_comparable(double duration_s, double with_duration_s) {
    return duration_s <= std::max(kLongestAlwaysS, kLongestTimes * with_duration_s);
}

std::optional<LikenessRow> likeness_row(const Waveform& wanted, std::span<const Waveform> others,
                                        const PerceptualModelParams& params,
                                        const LikenessOptions& options) {
    Row row{wanted, nullptr, params, options};
    row.own = code_of(wanted, row);
    if (!row.own) return std::nullopt;
    row.result.is_wanted_felt = is_felt(*row.own);
    for (std::size_t first = 0; first < others.size(); first += kAtOnce) {
        const auto some = others.subspan(first, std::min(kAtOnce, others.size() - first));
        std::function<void(double)> progress;
        if (options.progress) {
            progress = [&, here = some.size()](double share) {
                options.progress((static_cast<double>(first) + share * static_cast<double>(here)) /
                                 static_cast<double>(others.size()));
            };
        }
        if (!add_to(row, some, progress)) return std::nullopt;
    }
    LikenessRow& result = row.result;
    const std::vector<double> nc_rank = average_ranks(result.nc);
    const std::vector<double> oc_rank = average_ranks(result.oc);
    for (std::size_t k = 0; k < others.size(); ++k) {
        result.pm.push_back(pm_of(nc_rank[k], oc_rank[k], params.nc_weight, params.oc_weight));
    }
    return std::move(result);
}

}  // namespace tact
