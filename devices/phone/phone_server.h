// The page that phones of a room open: served on one interface, to who has its address.
//
// Nothing is encrypted, as no certificate is there for a computer in a room: whoever listens to the
// network reads along. The address holds a secret that is made at every start.
//
// Input     files of the page, cards and plays of the program; JSON of phones (phone_requests.h)
// Valid     bounds of connections.h, phone_desk.h and request_bytes.h
// Left out  logs: nothing is written anywhere
// Errors    an address that this computer does not have, a port that is taken
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "devices/http/network_interfaces.h"
#include "devices/phone/phone_values.h"
#include "model/common/expected.h"

namespace tact {

struct PhoneServerSettings {
    // The address of the interface to listen on. Default: the first private one of IPv4, or
    // 127.0.0.1.
    std::string host{};
    int port = 0;  // 0: any that is free
    std::size_t most_phones = 400;
    std::vector<PageFile> page{};  // index.html first
    std::size_t most_connections = 480;
    double request_s = 5.0;  // until a request must have come in
    double answer_s = 15.0;  // until an answer must have been taken
    double poll_s = 20.0;    // until a phone that waits hears that nothing is new
};

class PhoneServer {
  public:
    // `news` is called from a thread of the server whenever phones() or take_answers() have
    // changed, but for a phone that goes: phones() says so when it is asked.
    static Expected<std::unique_ptr<PhoneServer>> open(PhoneServerSettings settings,
                                                       std::function<void()> news = {});
    // Every phone is told 410, every thread is joined, within 1 s.
    ~PhoneServer();
    PhoneServer(const PhoneServer&) = delete;
    PhoneServer& operator=(const PhoneServer&) = delete;

    std::string address() const;  // with the token
    // A phone gets the card of its number, or that for all; its serial rises only if its own text
    // changed.
    void show(PhoneCards cards);
    // The card of one phone, in the place of what it had. `is_there`: its page has come to that by
    // itself, and gets it only if it loads again.
    void show_one(int number, std::string card, bool is_there);
    void play(PhonePlay play);  // to phones of that side
    std::vector<ConnectedPhone> phones() const;
    std::vector<PhoneAnswer> take_answers();
    void set_side(int number, PhoneSide side);
    void close_phone(int number);

  private:
    struct Works;
    explicit PhoneServer(std::unique_ptr<Works> works);
    std::unique_ptr<Works> works_;
};

}  // namespace tact
