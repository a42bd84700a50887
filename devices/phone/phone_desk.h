// All that is known of the phones of a room: who they are, what each is shown and plays, what they
// answered. HTTP is another file's (phone_server.h).
//
// From any thread. Times are those of a clock that a test turns itself; only next() waits, and for
// no longer than it is told. `news` is called without a lock, from the thread that changed
// something.
//
// A phone that comes late gets the loop that plays, and nothing of a play that ends by itself. What
// is old is not played by a phone that slept. One page polls for a phone: a second poll of the same
// phone answers the first at once.
//
// Valid     at most `most_phones` at a time; where all are taken, the one that has been gone for
//           longest gives way if that is more than kGoneS. Answers wait for take_answers(): at most
//           kMostAnswers, then phones are told to try again
// Left out  that a phone has gone is told by nobody: phones() says so when it is asked
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "devices/phone/phone_requests.h"
#include "devices/phone/phone_state.h"

namespace tact {

inline constexpr double kGoneS = 300.0;
inline constexpr std::size_t kMostAnswers = 20'000;
inline constexpr BucketSize kRequestsOfPhone{20.0, 40.0};

inline constexpr int kPhoneGone = 410;
inline constexpr int kTooManyRequests = 429;
inline constexpr int kRoomIsFull = 503;

// A status of HTTP, and a body.
struct PhoneReply {
    int status = 200;
    std::string json{};

    bool operator==(const PhoneReply&) const = default;
};

double steady_now_s();

class PhoneDesk {
  public:
    explicit PhoneDesk(std::size_t most_phones, std::function<void()> news = {},
                       std::function<double()> now_s = steady_now_s);

    PhoneReply join(const JoinRequest& request);
    // Waits for something new, for `wait_s` at most.
    PhoneReply next(const NextRequest& request, double wait_s);
    // `handshake_s`: what the connection itself took, which is no part of a play's way.
    PhoneReply tell(const TellRequest& request, double handshake_s = 0.0);

    void show(PhoneCards cards);
    void show_one(int number, std::string card, bool is_there);
    void play(PhonePlay play);
    void set_side(int number, PhoneSide side);
    void close_phone(int number);
    void close();  // all of them, and those to come

    std::vector<ConnectedPhone> phones() const;
    std::vector<PhoneAnswer> take_answers();

  private:
    using Phone = std::shared_ptr<PhoneState>;

    Phone phone_with(const std::string& secret) const;
    Phone come_back(const JoinRequest& request, const Phone& phone);
    Phone new_phone(const JoinRequest& request, double now_s);
    bool has_room(double now_s);
    std::set<std::string> names_but(const PhoneState* own) const;
    void give_card(PhoneState& phone) const;
    const GivenPlayPtr& latest_for(PhoneSide side) const;
    PhoneReply take_answer(const PhoneState& phone, const TellRequest& request);
    void tell_news() const;

    const std::size_t most_phones_;
    const BucketSize joins_size_;
    const std::function<void()> news_;
    const std::function<double()> now_s_;

    mutable std::mutex mutex_;  // guards all of these
    std::vector<Phone> phones_;
    int last_number_ = 0;
    TokenBucket joins_;
    PhoneCards cards_;
    std::shared_ptr<const std::string> card_for_all_;
    std::array<GivenPlayPtr, 3> latest_;  // the last play of both sides, of a, of b
    std::vector<PhoneAnswer> answers_;
    bool is_closed_ = false;
};

}  // namespace tact
