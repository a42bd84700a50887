// A page cannot be served from a page.
#include "devices/phone/phone_server.h"

namespace tact {

struct PhoneServer::Works {};

Expected<std::unique_ptr<PhoneServer>> PhoneServer::open(PhoneServerSettings,
                                                         std::function<void()>) {
    return Error{"Phones cannot be served from a browser: install tactspace to serve them."};
}

// No server comes to be, so that none of these is ever called.
PhoneServer::PhoneServer(std::unique_ptr<Works> works) : works_(std::move(works)) {}
PhoneServer::~PhoneServer() = default;
std::string PhoneServer::address() const { return {}; }
void PhoneServer::show(PhoneCards) {}
void PhoneServer::show_one(int, std::string, bool) {}
void PhoneServer::play(PhonePlay) {}
std::vector<ConnectedPhone> PhoneServer::phones() const { return {}; }
std::vector<PhoneAnswer> PhoneServer::take_answers() { return {}; }
void PhoneServer::set_side(int, PhoneSide) {}
void PhoneServer::close_phone(int) {}

}  // namespace tact
