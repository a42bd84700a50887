#include "devices/phone/phone_routes.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "devices/phone/phone_names.h"

namespace tact {

namespace {

constexpr int kMalformedBody = 400;

// What lies behind "/TOKEN/"; nothing if that is not the token.
std::optional<std::string_view> below_token(std::string_view path, const std::string& token) {
    const std::string begin = "/" + token + "/";
    if (!is_same_secret(path.substr(0, begin.size()), begin)) return {};
    return path.substr(begin.size());
}

HttpReply page_file(const PhoneRoutes& routes, std::string_view name) {
    if (routes.page.empty()) return {};
    const auto found =
        name.empty()
            ? routes.page.begin()
            : std::ranges::find(routes.page.begin() + 1, routes.page.end(), name,
                                [](const PageFile& file) -> std::string_view { return file.name; });
    if (found == routes.page.end()) return {};
    return {200, found->type, found->text};
}

HttpReply json_reply(PhoneReply reply) {
    return {reply.status, reply.json.empty() ? "" : "application/json", std::move(reply.json)};
}

template <class Request, class Answer>
HttpReply asked(const std::optional<Request>& request, const Answer& answer) {
    if (!request) return {kMalformedBody};
    return json_reply(answer(*request));
}

}  // namespace

HttpReply routed_reply(const PhoneRoutes& routes, PhoneDesk& desk, const HttpCall& call) {
    const auto name = below_token(call.path, routes.token);
    if (!name) return {};
    if (call.method == "GET") return page_file(routes, *name);
    if (call.method != "POST") return {};
    if (*name == "join") {
        return asked(parse_join(call.body), [&](const auto& join) { return desk.join(join); });
    }
    if (*name == "next") {
        return asked(parse_next(call.body),
                     [&](const auto& next) { return desk.next(next, routes.poll_s); });
    }
    if (*name == "tell") {
        return asked(parse_tell(call.body),
                     [&](const auto& tell) { return desk.tell(tell, call.handshake_s); });
    }
    return {};
}

}  // namespace tact
