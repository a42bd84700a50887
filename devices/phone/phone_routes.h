// Which answer belongs to which request: the page's files, and its three questions to the desk.
//
// All routes lie below the token. Everything else, of whatever method, with a wrong token or a
// right one, gets one and the same answer: 404, empty.
#pragma once

#include <string>
#include <vector>

#include "devices/http/http_answers.h"
#include "devices/phone/phone_desk.h"
#include "devices/phone/phone_values.h"

namespace tact {

struct PhoneRoutes {
    std::string token;
    std::vector<PageFile> page;  // the first one is at the address itself
    double poll_s = 20.0;        // until a poll is answered without anything new
};

HttpReply routed_reply(const PhoneRoutes& routes, PhoneDesk& desk, const HttpCall& call);

}  // namespace tact
