#include "devices/phone/phone_server.h"

#include <utility>

#include "devices/http/connections.h"
#include "devices/http/http_answers.h"
#include "devices/phone/phone_desk.h"
#include "devices/phone/phone_names.h"
#include "devices/phone/phone_routes.h"

namespace tact {

namespace {

std::string host_of(const PhoneServerSettings& settings) {
    if (!settings.host.empty()) return settings.host;
    const auto all = network_interfaces();
    return all.empty() ? "127.0.0.1" : all.front().address;
}

}  // namespace

// Connections end first: they use all that stands before them.
struct PhoneServer::Works {
    std::string address;
    PhoneRoutes routes;
    PhoneDesk desk;
    HttpAnswers http;
    Connections connections;

    Works(OwnedSocket listening, std::string at, PhoneRoutes routes_of,
          const PhoneServerSettings& settings, std::function<void()> news)
        : address(std::move(at)),
          routes(std::move(routes_of)),
          desk(settings.most_phones, std::move(news)),
          http([this](const HttpCall& call) { return routed_reply(routes, desk, call); }),
          connections(std::move(listening),
                      {settings.most_connections, settings.request_s, settings.answer_s},
                      [this](const RequestBytes& request, double handshake) {
                          return http.answer(request, handshake);
                      }) {}
};

Expected<std::unique_ptr<PhoneServer>> PhoneServer::open(PhoneServerSettings settings,
                                                         std::function<void()> news) {
    auto token = random_secret();
    if (!token) return token.error();
    const std::string host = host_of(settings);
    auto listening = listening_socket(host, settings.port);
    if (!listening) return listening.error();
    std::string address =
        "http://" + host + ":" + std::to_string(port_of(*listening)) + "/" + *token + "/";
    PhoneRoutes routes{*std::move(token), std::move(settings.page), settings.poll_s};
    return std::unique_ptr<PhoneServer>(new PhoneServer(std::make_unique<Works>(
        *std::move(listening), std::move(address), std::move(routes), settings, std::move(news))));
}

PhoneServer::PhoneServer(std::unique_ptr<Works> works) : works_(std::move(works)) {}

PhoneServer::~PhoneServer() { works_->desk.close(); }

std::string PhoneServer::address() const { return works_->address; }

void PhoneServer::show(PhoneCards cards) { works_->desk.show(std::move(cards)); }

void PhoneServer::show_one(int number, std::string card, bool is_there) {
    works_->desk.show_one(number, std::move(card), is_there);
}

void PhoneServer::play(PhonePlay play) { works_->desk.play(std::move(play)); }

std::vector<ConnectedPhone> PhoneServer::phones() const { return works_->desk.phones(); }

std::vector<PhoneAnswer> PhoneServer::take_answers() { return works_->desk.take_answers(); }

void PhoneServer::set_side(int number, PhoneSide side) { works_->desk.set_side(number, side); }

void PhoneServer::close_phone(int number) { works_->desk.close_phone(number); }

}  // namespace tact
