// The page that phones open, as it is compiled in.
#pragma once

#include <vector>

#include "devices/phone/phone_server.h"

namespace tact {

std::vector<PageFile> phone_page();

}  // namespace tact
