// Which of three plays is another one: trials on one phone, one after the other.
//
// Source    model/told_apart: which pair is asked next, and what the answers say
// Output    what one person told apart on one phone; never a part of PM
// Left out  keeping it with the set
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/phones/phone_cards.h"
#include "app/phones/phone_patterns.h"
#include "model/set/pattern_set.h"
#include "model/told_apart/odd_trials.h"

namespace tact {

inline constexpr int kUsualTrials = 20;

struct DeviceTrials {
    TrialDesign design;
    std::vector<OddAnswer> answers;
    std::optional<OddOneOut> now;                  // none: all are answered
    std::map<std::string, std::vector<int>> ms{};  // of the patterns, by name
    std::string person;                            // the phone's nickname
};

// None without a pair that can be felt on a phone.
std::optional<DeviceTrials> device_trials(const TrialDesign& design,
                                          const std::vector<PhonePattern>& patterns,
                                          const std::string& person);

bool is_done(const DeviceTrials& trials);

// The card of the trial that is on, or thanks.
std::string card_of(const DeviceTrials& trials);

// True: it answers the trial that is on, with each of the three felt.
bool take_trial(DeviceTrials& trials, const std::string& card, const std::string& json);

// "Kim: trial 7 of 20".
std::string words_on(const DeviceTrials& trials);

// As the set keeps it, with the versions of the patterns.
ToldApart told_apart_of(const DeviceTrials& trials, const PatternSet& set);

}  // namespace tact
