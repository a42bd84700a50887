// What a phone's page sends: the bodies of its three requests, read with every bound.
//
// Input     bytes of anybody in the room. JSON of at most kMostBodyBytes, as deep as
//           model/text/json_fields.h allows; a key of another type than the one meant refuses the
//           whole, keys that nobody knows are passed over
// Output    values whose texts are bounded and whose numbers are in range; nothing: malformed
// Left out  whether the phone is known, and whether an answer fits its card: phone_desk.h
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "devices/http/request_bytes.h"

namespace tact {

inline constexpr std::size_t kMostCardIdBytes = 64;
inline constexpr std::size_t kMostPlaysTold = 10;  // patterns whose plays one answer counts

struct JoinRequest {
    std::string phone;     // its secret from before; empty: it has none
    std::string nickname;  // cleaned
    bool vibrates = false;
    std::string language;  // letters, digits and hyphens; empty: not told, or of another form

    bool operator==(const JoinRequest&) const = default;
};

struct NextRequest {
    std::string phone;
    std::int64_t card = 0;  // serials that the page has
    std::int64_t play = 0;

    bool operator==(const NextRequest&) const = default;
};

// One of both.
struct TellRequest {
    std::string phone;
    std::string card{};                    // the id of the card that is answered, and ...
    std::string answer{};                  // ... the answer, as JSON of known keys alone
    std::optional<std::int64_t> played{};  // the serial of a play that has begun

    bool operator==(const TellRequest&) const = default;
};

std::optional<JoinRequest> parse_join(std::string_view body);
std::optional<NextRequest> parse_next(std::string_view body);
std::optional<TellRequest> parse_tell(std::string_view body);

}  // namespace tact
