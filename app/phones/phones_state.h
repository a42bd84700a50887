// Phones as actuators, raters and answer sheets: the server, who is connected, what is under way.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/jobs/query.h"
#include "app/phones/class_rating.h"
#include "app/phones/device_trials.h"
#include "app/phones/phone_cards.h"
#include "app/phones/phone_patterns.h"
#include "app/phones/qr_code.h"
#include "devices/http/network_interfaces.h"
#include "devices/phone/phone_server.h"

namespace tact {

// The patterns of a revision, to be made for phones.
struct PhonePatternsRequest {
    std::uint64_t document = 0;
    std::uint64_t revision = 0;
    std::shared_ptr<const PatternSet> set;

    bool operator==(const PhonePatternsRequest& other) const {
        return document == other.document && revision == other.revision;
    }
};

struct MadePhonePatterns {
    PhonePatternsRequest request;
    std::vector<PhonePattern> patterns;
    double full_scale_g = 1.0;
};

// The trials of one phone, and how they went.
struct PhoneTrials {
    int phone = 0;
    DeviceTrials trials;
    std::shared_ptr<const PatternSet> felt;  // the set as it was when they began
};

struct PhonesState {
    std::shared_ptr<PhoneServer> server;  // null: off
    QrCode code;                          // of its address
    std::string host;                     // it is to listen on; empty: the first private one
    std::vector<NetworkInterface> interfaces;
    std::string fault;                   // why it could not be opened; a sentence
    std::vector<ConnectedPhone> phones;  // of this frame

    Query<PhonePatternsRequest, MadePhonePatterns> patterns_job;
    std::optional<PhoneTrials> trials;
    std::uint64_t trials_document = 0;  // whose patterns they are
    int trials_asked = kUsualTrials;    // of the next ones
    std::uint64_t trials_begun = 0;     // since the program began: the seed of the next
    std::set<int> tried{};              // phones that were thanked for their trials
    std::optional<ClassRating> rating;
    std::uint64_t rating_document = 0;
    std::uint64_t ratings_begun = 0;
    int repetitions = 1;                 // of every pair, in the next one
    std::optional<ChoiceCard> question;  // of a lesson, while it asks
    // Options said to each question, by its id and the number of the phone.
    std::map<std::string, std::map<int, std::size_t>> said;
    bool cards_due = false;                             // something of it has changed
    std::shared_ptr<const MadePhonePatterns> cards_of;  // the patterns of the cards
    std::deque<PhoneAnswer> waiting;                    // to be taken, one after the other
};

}  // namespace tact
