#include "app/phones/phones.h"

#include <utility>

#include "devices/phone/on_off_times.h"
#include "model/set/set_told_apart.h"
#include "model/text/utc_time.h"

namespace tact {

namespace {

constexpr int kPlays = 3;

std::string id_of(const DeviceTrials& trials) {
    // Each round has its own, and so does each trial of it.
    return "trial " + std::to_string(trials.design.seed) + "." +
           std::to_string(trials.answers.size() + 1);
}

std::vector<std::vector<int>> plays_of(const DeviceTrials& trials) {
    const OddOneOut& now = *trials.now;
    std::vector<std::vector<int>> plays;
    for (int place = 0; place < kPlays; ++place) {
        const bool is_b = (place == now.odd_place) == now.odd_is_b;
        plays.push_back(trials.ms.at(is_b ? now.b : now.a));
    }
    return plays;
}

}  // namespace

std::optional<DeviceTrials> device_trials(const TrialDesign& design,
                                          const std::vector<PhonePattern>& patterns,
                                          const std::string& person) {
    DeviceTrials trials{design, {}, {}, {}, person};
    for (const PhonePattern& pattern : patterns) {
        if (is_ever_on(pattern.ms)) trials.ms[pattern.name] = pattern.ms;
    }
    std::erase_if(trials.design.pairs, [&](const TrialPair& pair) {
        return !trials.ms.contains(pair.a) || !trials.ms.contains(pair.b);
    });
    trials.now = next_trial(trials.design, trials.answers);
    if (!trials.now) return std::nullopt;
    return trials;
}

bool is_done(const DeviceTrials& trials) { return !trials.now; }

std::string card_of(const DeviceTrials& trials) {
    if (is_done(trials)) return thanks_card({});
    TrialCard card{id_of(trials), static_cast<int>(trials.answers.size()) + 1, trials.design.trials,
                   plays_of(trials)};
    return card_of(card);
}

bool take_trial(DeviceTrials& trials, const std::string& card, const std::string& json) {
    if (is_done(trials) || card != id_of(trials)) return false;
    const auto answer = trial_answered(json);
    if (!answer) return false;
    trials.answers.push_back({*trials.now, answer->place, answer->response_s});
    trials.now = next_trial(trials.design, trials.answers);
    return true;
}

std::string words_on(const DeviceTrials& trials) {
    if (is_done(trials)) return trials.person + ": all trials are done.";
    return trials.person + ": trial " + std::to_string(trials.answers.size() + 1) + " of " +
           std::to_string(trials.design.trials);
}

ToldApart told_apart_of(const DeviceTrials& trials, const PatternSet& set) {
    ToldApart told;
    told.device = "phone " + trials.person + " (web vibration)";
    told.person = trials.person;
    told.date = utc_now();
    told.seed = trials.design.seed;
    return noted_trials(set, std::move(told), trials.answers);
}

}  // namespace tact
