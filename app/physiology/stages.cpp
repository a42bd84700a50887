#include "app/physiology/physiology.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "app/map/map.h"
#include "model/perceptual_model/rhythm_envelope.h"

namespace tact {

namespace {

constexpr std::array<StageText, kStages.size()> kTexts{{
    {"vibration", "Vibration", "Vibration", "acceleration at the skin, g",
     "A probe of 1 mm across presses on the fingertip and moves up and down: this is its "
     "acceleration.",
     "Every pattern of a set is brought to 10 kHz and padded with silence to the longest of them; "
     "its mean is taken away, as a constant push is no vibration.",
     "x(t) = A e(t) r(t) \u03a3 w sin(2\u03c0ft + \u03c6), Eq. 7 and section 3",
     "Static force, shear, temperature, the mechanics of the finger and of the actuator.",
     "Removing the mean; e(t) = 1 where the modulation frequency is 0, as Eq. 7 would be silent.",
     "Lim & Park 2023, section 3."},
    {"spectrum", "Spectrum", "Spectrum", "displacement over the thresholds, 1\u2013500 Hz",
     "Each receptor type answers to its own range of frequencies, and only above a threshold "
     "that depends on frequency.",
     "The Fourier transform gives the peak displacement of each component; what stands above a "
     "type's threshold drives it, with a rate that grows with the logarithm of the displacement.",
     "f0 = \u03a3 \u03b1 (log10 v \u2212 \u03b2) over the components above threshold, Eq. 2, "
     "section "
     "4.1",
     "Adaptation, plateaus of the rate, masking of one component by another.",
     "The conversion from g to \u00b5m; both tables, rebuilt from published rates; components "
     "below threshold count nothing.",
     "Four channels and their bands: Bolanowski, Gescheider, Verrillo & Checkosky 1988, J. Acoust. "
     "Soc. Am. 84, 1680. Drawn dashed: beyond the band that the paper gives a type (section 4.1), "
     "where the curve is our extrapolation."},
    {"filtered", "Filtered waveforms", "Filters", "what each receptor type follows, g",
     "The capsule around a nerve ending is a mechanical filter: a Pacinian corpuscle hardly "
     "notices slow bending, a Merkel cell hardly notices fast vibration.",
     "One Butterworth filter a type: 3\u2013100 Hz Meissner, 10\u2013500 Hz Pacinian, below 5 Hz "
     "Merkel, 15\u2013400 Hz Ruffini. The two fast-adapting types then perceive the change.",
     "band-pass or low-pass, then d/dt for FA1 and FA2, section 4.1",
     "Waves that travel through the skin with delays; the filters are the same at every depth.",
     "Order 10 in total; forward in time only: where a vibration begins or ends, a filter rings "
     "on. "
     "A type with nothing in its band still follows that ringing, which no skin has.",
     "The Pacinian capsule as a filter of many layers: Barrett-Snyder, Lane, Lazarus, Alberts & "
     "Hanrahan 2021, Printing a Pacinian corpuscle, Micromachines 12, 574."},
    {"receptors", "Receptors in the skin", "Receptors", "mean rate, to scale",
     "A vibration spreads over the fingertip and fades with distance, so a strong one reaches "
     "more receptors than a weak one.",
     "Receptors stand on a square grid of their type's density; within 1.5 mm each fires as at "
     "the probe, beyond it the rate falls to zero at r_max.",
     "V(r) = v (1.5/r)\u00b2, r_max = 1.5 \u00b7 10^(f0 / 2A), Eqs. 1, 3, 4, section 4.1",
     "The irregular mosaic of real skin, a second contact, the edge of the finger: receptors of "
     "the grid that lie beyond it are drawn grey, and the model counts them.",
     "One set of components counts for the whole grid; at least the centre receptor always "
     "counts.",
     "Fall with distance: Johnson 1974, as Lim & Park 2023 cite it. The edge of the finger, 20 mm "
     "wide and 25 mm long at most, is a round figure of ours."},
    {"spikes", "Spikes", "Spikes", "all receptors, nearest on top",
     "A nerve fibre answers with impulses that are all alike: the vibration is in how many there "
     "are and when.",
     "A receptor fires each time it has gathered its threshold of energy, looked at every 10 ms; "
     "the population's impulses are shared out by rate.",
     "E_thr = energy / fires, count = floor(gathered / E_thr), section 4.2",
     "Phase locking: below its limit a fibre fires once a cycle, in step with the vibration. The "
     "model counts in windows of 10 ms, which forget the step. Also refractory time, noise and "
     "adaptation: the same vibration gives the same spikes.",
     "In a window of n spikes the first half and one more fall into its first 5 ms.",
     "Impulses in step with the cycle: Freeman & Johnson 1982, Cutaneous mechanoreceptors in "
     "macaque monkey, J. Physiol."},
    {"networks", "Relay networks", "Networks", "every layer at the playhead",
     "On their way to the cortex impulses pass relay stations, where neurons gather from "
     "neighbours and inhibit each other.",
     "Three excitatory layers add up a cross of five neighbours, one inhibitory layer sharpens; "
     "no cell passes more than 50 impulses in 5 ms. That cap is the model's, one in every "
     "sample: 10,000 a second are more than any neuron fires. Most cells are at it or silent, "
     "so that a network works as a gate, nearly on or off.",
     "layer = min(50, layer * E), then * I clipped to 0\u202650, Eqs. 5, 6, section 4.3",
     "Delays, memory from step to step, the anatomy of cuneate nucleus and thalamus.",
     "The numbers of Eq. 6 are lost: I is a cross of \u22121 around 5.",
     "Lim & Park 2023, section 4.3."},
    {"central", "Central signals", "Centre", "spikes of each network's centre, per 5 ms",
     "On the way to the cortex signals of all types converge: neurons of the somatosensory cortex "
     "answer to more than one of them. A line of its own for each type is the older view.",
     "The model keeps the types apart, one channel each: the centre cell of the last layer speaks "
     "for its network, its count spread evenly over the 5 ms. The paper says winner-take-all: here "
     "no competition is computed, the centre is taken for the winner.",
     "unit spikes at start + floor(50 k / n), section 4.3",
     "Everything that the other cells of the last layer know; the convergence of types.",
     "Where within the 5 ms the spikes fall.",
     "Saal & Bensmaia 2014, Touch is a team effort, Trends in Neurosciences 37, 689."},
    {"brain", "Brain waveform", "Brain", "predicted, weighted sum of four channels",
     "Somatosensory cortex receives all four and makes one sensation of them.",
     "The four central signals are added with trained weights. Two patterns are as different as "
     "the root of the mean squared difference of these waveforms: NC. As the networks are nearly "
     "on "
     "or off, so is this.",
     "PBW = \u03a3 w s, w = 0.2 FA1, 0.7 FA2, 0 SA1, 0.5 SA2, section 4.3",
     "Attention, memory, what the vibration means.",
     "The weights were trained with the authors' own tables: with ours they are a starting "
     "point. Drawn: pauses of less than 6 pixels are filled, here and in the central signals, so "
     "that a comb of pulses in a wide pane is a block in a narrow one.",
     "Saal & Bensmaia 2014, Touch is a team effort, Trends in Neurosciences 37, 689."},
    {"envelope", "Rhythm envelope", "Rhythm", "mean of 10 ms, scaled to its peak",
     "Rhythm is felt beside strength and quality, and a pattern that is late is still the same "
     "pattern.",
     "A moving average of the absolute acceleration; two envelopes are compared by dynamic time "
     "warping, which forgives shifts: OC.",
     "y[n] = mean of |x| over the last 10 ms, section 5", "Metre, accents, expectation.",
     "Scaled to its own maximum, so that OC is about rhythm and not about strength; the average "
     "looks back, not ahead.",
     "Lim & Park 2023, section 5."},
}};

}  // namespace

const StageText& text_of(Stage stage) { return kTexts[index_of(stage)]; }

std::optional<Stage> stage_named(std::string_view key) {
    const auto found =
        std::ranges::find(kStages, key, [](Stage s) { return std::string_view(text_of(s).key); });
    if (found == kStages.end()) return std::nullopt;
    return *found;
}

namespace {

std::vector<double> population_hz(const ChannelStages& channel, std::size_t steps) {
    std::vector<double> rate_hz(steps, 0.0);
    for (const std::vector<int>& train : channel.spike_count) {
        for (std::size_t step = 0; step < steps; ++step) rate_hz[step] += train[step];
    }
    for (double& rate : rate_hz) rate *= kStepRateHz;
    return rate_hz;
}

std::vector<std::size_t> by_distance(const ReceptorGrid& grid) {
    std::vector<std::size_t> order(grid.receptors.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {},
                             [&grid](std::size_t k) { return grid.receptors[k].distance_mm; });
    return order;
}

void add_firing(LiveStages& live) {
    const NeuralCodingParams& params = live.request.model.coding;
    live.firing = firing_of(live.neural, params);
    for (const Receptor receptor : kReceptors) {
        const std::size_t c = index_of(receptor);
        const ChannelStages& channel = live.neural.channel[c];
        live.only_leaks[c] = only_leaks(live.neural, params, receptor);
        live.impulses_a_cycle[c] = impulses_a_cycle(live.neural, receptor);
        live.silent_steps[c] = silent_steps(live.waveform, channel);
        live.silent_firing[c] = silent_firing(live.waveform, channel);
    }
    const BesideInput input{live.waveform, live.neural, params.tables, live.firing};
    for (const Stage stage : kStages) {
        live.beside[index_of(stage)] = beside_the_model(text_of(stage).key, input);
    }
}

}  // namespace

LiveStagesRequest stages_request(const PatternSet& set, std::size_t index,
                                 const std::optional<RenderedBy>& rendered_by) {
    return {set.vibrations[index], longest_samples(set), set.model, rendered_by};
}

std::optional<LiveStages> compute_live_stages(const LiveStagesRequest& request,
                                              std::stop_token stop, std::atomic<float>& progress) {
    LiveStages live;
    live.request = request;
    Waveform waveform = waveform_of(request.vibration);
    if (request.rendered_by) waveform = rendering(*request.rendered_by, waveform).waveform;
    live.waveform = padded(std::move(waveform), request.samples);
    live.neural =
        neural_coding_stages(live.waveform, request.model.coding, KeepLayers::none, {stop});
    progress = 0.8F;
    if (stop.stop_requested()) return std::nullopt;
    add_firing(live);
    const NeuralCode& code = live.neural.code;
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        const std::vector<int>& counts = code.central_count[c];
        live.population_hz[c] = population_hz(live.neural.channel[c], counts.size());
        live.central_count[c].assign(counts.begin(), counts.end());
        for (const std::uint8_t mask : code.central_spikes) {
            live.central_spikes[c].push_back(mask >> c & 1U);
        }
        live.by_distance[c] = by_distance(live.neural.channel[c].grid);
    }
    live.brain_waveform = predicted_brain_waveform(code, request.model.channel_weight);
    live.envelope = rhythm_envelope(live.waveform.samples_g, request.model.envelope);
    progress = 1.0F;
    return live;
}

void take_stages(Physiology& physiology) {
    if (auto stages = physiology.stages_job.latest()) physiology.stages = std::move(stages);
    if (auto stages = physiology.pinned_job.latest()) physiology.pinned_stages = std::move(stages);
}

void follow_current(const Ui& ui, Workspace& work, const RenderingState& rendered,
                    Physiology& physiology) {
    const PatternSet& set = work.document.set;
    if (work.selection.current >= set.vibrations.size()) return;
    const auto want = [&](auto& job, std::size_t place) {
        if (!has_jobs(ui)) return;
        job.want(stages_request(set, place, rendered_by(rendered)), compute_live_stages, ui.wake,
                 JobPolicy::finish);
    };
    want(physiology.stages_job, work.selection.current);
    const auto pinned = place_named(set, work.selection.pinned);
    if (!pinned) return work.selection.pinned.clear();
    want(physiology.pinned_job, *pinned);
}

void follow_pair(const Workspace& work, const ShownMap& shown_map, Physiology& physiology) {
    physiology.view.pair_oc.reset();
    const auto pinned = place_named(work.document.set, work.selection.pinned);
    const std::size_t current = work.selection.current;
    if (!pinned || *pinned == current || map_state(work, shown_map) != MapState::exact) return;
    const Dissimilarity& oc = shown_map.transition.shown->oc;
    if (*pinned < oc.size && current < oc.size) physiology.view.pair_oc = oc(current, *pinned);
}

}  // namespace tact
