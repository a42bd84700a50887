#include "model/training/prepared_training.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "model/common/parallel.h"

namespace tact {

namespace {

// A weight of one channel that makes no difference to another's is not lost on the way: forms are
// of spikes, before any weight.
std::optional<std::vector<std::vector<SpikeForm>>> forms_of(const TrainingSet& set,
                                                            const TrainingParams& params,
                                                            const std::function<void(double)>& at) {
    std::vector<std::vector<SpikeForm>> forms(kTrainedLayers);
    const std::size_t patterns = set.waveforms.size();
    std::size_t longest = 0;
    for (const Waveform& one : set.waveforms) longest = std::max(longest, one.samples_g.size());
    for (std::size_t layers = 0; layers < kTrainedLayers; ++layers) {
        NeuralCodingParams coding = params.model.coding;
        coding.excitatory_layers = layers_at(layers).excitatory;
        coding.inhibitory_layers = layers_at(layers).inhibitory;
        std::vector<PackedSpikes> spikes(patterns);
        const bool finished =
            parallel_for(patterns, params.threads, params.stop, [&](std::size_t k) {
                const Waveform whole = padded(set.waveforms[k], longest);
                spikes[k] = packed_spikes(neural_code(whole, coding, {params.stop}));
            });
        if (!finished || params.stop.stop_requested()) return std::nullopt;
        for (std::size_t i = 0; i < patterns; ++i) {
            for (std::size_t j = i + 1; j < patterns; ++j) {
                forms[layers].push_back(spike_form(spikes[i], spikes[j]));
            }
        }
        at(static_cast<double>(layers + 1) / static_cast<double>(kTrainedLayers));
    }
    return forms;
}

// The mean over the sets, then that over each all but one.
void add_objectives_of_sets(PreparedTraining& prepared) {
    std::vector<ColumnPlace> all;
    for (std::size_t s = 0; s < prepared.ratings.size(); ++s) {
        all.push_back(*add_ratings(prepared.problem, s, prepared.ratings[s].condensed));
    }
    prepared.problem.objectives.push_back(all);
    for (std::size_t s = 0; all.size() > 1 && s < all.size(); ++s) {
        std::vector<ColumnPlace> others = all;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(s));
        prepared.problem.objectives.push_back(others);
    }
}

void add_objectives_of_participants(PreparedTraining& prepared, std::span<const TrainingSet> sets) {
    const std::vector<ColumnPlace> all = prepared.problem.objectives.front();
    for (const std::string& participant : participants_of(sets)) {
        LeftOutRatings left_out{participant, prepared.problem.objectives.size(), {}};
        std::vector<ColumnPlace> others;
        for (std::size_t s = 0; s < sets.size(); ++s) {
            const RatingStudy rest = part_of(sets[s].study, participant, true);
            const RatingStudy own = part_of(sets[s].study, participant, false);
            left_out.ratings.push_back(own.judgements.empty() ? std::vector<double>()
                                                              : mean_ratings(own).condensed);
            if (own.judgements.empty()) {
                others.push_back(all[s]);
                continue;
            }
            const auto place = add_ratings(prepared.problem, s, mean_ratings(rest).condensed);
            if (place) others.push_back(*place);
        }
        if (others.empty()) continue;  // nobody else rated anything
        prepared.participants.push_back(std::move(left_out));
        prepared.problem.objectives.push_back(others);
    }
}

// Ratings of the pairs with a pattern, or of all the others; the rest NaN.
std::vector<double> of_pattern(const Dissimilarity& ratings, std::size_t pattern, bool others) {
    std::vector<double> part = ratings.condensed;
    std::size_t p = 0;
    for (std::size_t i = 0; i < ratings.size; ++i) {
        for (std::size_t j = i + 1; j < ratings.size; ++j, ++p) {
            if ((i == pattern || j == pattern) == others) part[p] = kNoRating;
        }
    }
    return part;
}

void add_objectives_of_patterns(PreparedTraining& prepared, std::span<const TrainingSet> sets) {
    const std::vector<ColumnPlace> all = prepared.problem.objectives.front();
    for (std::size_t s = 0; s < sets.size(); ++s) {
        const std::vector<std::string>& names = sets[s].study.labels;
        for (std::size_t k = 0; k < names.size(); ++k) {
            const std::vector<double> own = of_pattern(prepared.ratings[s], k, false);
            if (std::ranges::none_of(own, [](double value) { return std::isfinite(value); })) {
                continue;
            }
            const auto rest =
                add_ratings(prepared.problem, s, of_pattern(prepared.ratings[s], k, true));
            if (!rest) continue;  // without it, the set's ratings have no order
            std::vector<ColumnPlace> others = all;
            others[s] = *rest;
            LeftOutRatings left_out{sets.size() > 1 ? sets[s].name + ": " + names[k] : names[k],
                                    prepared.problem.objectives.size(),
                                    std::vector<std::vector<double>>(sets.size())};
            left_out.ratings[s] = own;
            prepared.patterns.push_back(std::move(left_out));
            prepared.problem.objectives.push_back(others);
        }
    }
}

}  // namespace

std::optional<PreparedTraining> prepared_training(std::span<const TrainingSet> sets,
                                                  const TrainingParams& params,
                                                  const std::function<void(double)>& progress) {
    PreparedTraining result;
    for (std::size_t s = 0; s < sets.size(); ++s) {
        const auto part = [&](double from, double width) {
            return [&progress, from, width, s, count = sets.size()](double share) {
                progress((static_cast<double>(s) + from + width * share) /
                         static_cast<double>(count));
            };
        };
        PredictOptions options;
        options.threads = params.threads;
        options.stop = params.stop;
        options.progress = part(0.0, 0.5);
        std::optional<Prediction> before = predict(sets[s].waveforms, params.model, options);
        if (!before) return std::nullopt;
        auto forms = forms_of(sets[s], params, part(0.5, 0.5));
        if (!forms) return std::nullopt;
        SearchSet set;
        set.samples = before->codes.front()->neural.samples;
        set.forms = *std::move(forms);
        set.oc_rank = before->oc_rank;
        result.problem.sets.push_back(std::move(set));
        result.before.push_back(*std::move(before));
        result.ratings.push_back(mean_ratings(sets[s].study));
    }
    add_objectives_of_sets(result);
    if (params.leave_out_participants) add_objectives_of_participants(result, sets);
    if (params.leave_out_patterns) add_objectives_of_patterns(result, sets);
    return result;
}

std::vector<std::string> participants_of(std::span<const TrainingSet> sets) {
    std::vector<std::string> names;
    for (const TrainingSet& set : sets) {
        for (const Judgement& judgement : set.study.judgements) {
            if (std::ranges::find(names, judgement.participant) == names.end()) {
                names.push_back(judgement.participant);
            }
        }
    }
    return names;
}

RatingStudy part_of(const RatingStudy& study, const std::string& participant, bool others) {
    RatingStudy part{study.labels, study.is_named, {}};
    std::ranges::copy_if(study.judgements, std::back_inserter(part.judgements),
                         [&](const Judgement& judgement) {
                             return (judgement.participant != participant) == others;
                         });
    return part;
}

}  // namespace tact
