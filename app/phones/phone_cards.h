// What a phone shows, and what it answers: cards and answers as JSON.
//
// The page (assets/phone) puts every text of a card in place as text, never as markup.
//
// Output    JSON objects, of keys that the page knows; no value for an answer that does not fit its
// card
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/phones/phone_patterns.h"
#include "model/study/study_record.h"

namespace tact {

std::string wait_card();

// A list to tap, each of which is felt.
std::string feel_card(std::span<const PhonePattern> patterns);

struct ChoiceCard {
    std::string id;
    std::string ask;
    std::vector<std::string> options;
    std::vector<int> ms{};              // to be felt with the question; empty: nothing
    std::optional<std::size_t> mine{};  // what this phone has said
    bool revealed = false;              // then the three below are shown
    std::vector<std::size_t> right{};
    std::vector<int> votes{};  // of each option
    std::string reveal{};

    bool operator==(const ChoiceCard&) const = default;
};
std::string card_of(const ChoiceCard& card);
std::optional<std::size_t> option_answered(const std::string& json, std::size_t options);

// Three plays, of which one is another: which?
struct TrialCard {
    std::string id;
    int at = 1;  // of the trials, from 1
    int of = 1;
    std::vector<std::vector<int>> ms;
};
std::string card_of(const TrialCard& card);

struct PhoneTrial {
    int place = 0;  // of the one that was taken for another
    double response_s = 0.0;
};
// None unless all three were felt.
std::optional<PhoneTrial> trial_answered(const std::string& json);

// All trials of one rater, who is at `done`.
struct RatingCard {
    std::string id;
    std::span<const PhonePattern> patterns;
    std::span<const Trial> trials;
    std::size_t done = 0;
};
std::string card_of(const RatingCard& card);

struct PhoneRating {
    std::size_t at = 0;  // of the trials, from 0
    double similarity = 0.0;
    int plays_left = 0;
    int plays_right = 0;
    FeltFirst first = FeltFirst::unknown;
    double response_s = 0.0;
};
// None unless both sides were felt, and the similarity lies in 0..100.
std::optional<PhoneRating> rating_answered(const std::string& json);

std::string thanks_card(const std::string& text);

}  // namespace tact
