// The bytes of one HTTP request, taken in as they drip, until they are whole or refused.
//
// Nothing else reads what a stranger sends before it is here as a whole and within its bounds. A
// request has one head of lines that end in CR LF, and a body of the length that its head declares.
//
// Source    RFC 9112. Refused are all that could make the length of a body a matter of opinion:
//           two lengths, signs, a transfer encoding, lines that are folded or end in LF alone
// Valid     heads of at most kMostHeadBytes and kMostHeadLines, bodies of kMostBodyBytes
// Left out  a second request on the same connection; ranges, compressed bodies, "Expect", of which
//           our page uses none
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tact {

inline constexpr std::size_t kMostHeadBytes = 8192;  // cookies of other programs on this address
inline constexpr std::size_t kMostHeadLines = 64;
inline constexpr std::size_t kMostBodyBytes = 4096;

struct RequestBytes {
    std::string bytes{};         // head and body, as they came
    std::size_t head_bytes = 0;  // with the empty line; 0: not whole yet
    std::size_t body_bytes = 0;  // as declared
    int refused = 0;             // the status to answer with; 0: not refused

    std::string_view head() const { return std::string_view(bytes).substr(0, head_bytes); }
    std::string_view body() const { return std::string_view(bytes).substr(head_bytes, body_bytes); }
};

// True: more is awaited. False: it is whole, or refused.
bool take_in(RequestBytes& request, std::string_view came);

// Nothing more comes: what is not whole is refused.
void end_of_bytes(RequestBytes& request);

}  // namespace tact
