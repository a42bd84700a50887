#include "devices/http/request_bytes.h"

#include <algorithm>
#include <array>
#include <optional>

#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr int kMalformed = 400;
constexpr int kTooLate = 408;
constexpr int kNoLength = 411;
constexpr int kTooLarge = 413;
constexpr int kEncoded = 415;
constexpr int kNoRanges = 416;
constexpr int kExpects = 417;
constexpr int kHeadTooLarge = 431;

struct RefusedHeader {
    std::string_view name;
    int status;
};

constexpr std::array kRefusedHeaders{
    RefusedHeader{"transfer-encoding", kNoLength}, RefusedHeader{"content-encoding", kEncoded},
    RefusedHeader{"range", kNoRanges}, RefusedHeader{"expect", kExpects}};

bool is_token_sign(char sign) {
    return (sign >= '0' && sign <= '9') || (sign >= 'A' && sign <= 'Z') ||
           (sign >= 'a' && sign <= 'z') ||
           std::string_view("!#$%&'*+-.^_`|~").find(sign) != std::string_view::npos;
}

// Neither NUL nor any other control, but a tab.
bool is_plain_line(std::string_view line) {
    return std::ranges::all_of(line, [](char sign) {
        const auto byte = static_cast<unsigned char>(sign);
        return sign == '\t' || (byte >= 0x20 && byte != 0x7F);
    });
}

std::string_view trimmed_value(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

std::optional<std::size_t> declared_length(std::string_view digits) {
    if (digits.empty() || digits.find_first_not_of("0123456789") != digits.npos) return {};
    std::size_t length = 0;
    for (const char digit : digits) {
        length = std::min(kMostBodyBytes + 1, 10 * length + static_cast<std::size_t>(digit - '0'));
    }
    return length;
}

// A status to refuse with, or 0.
int take_header(std::string_view line, std::optional<std::size_t>& length) {
    const std::size_t colon = line.find(':');
    if (colon == 0 || colon == line.npos) return kMalformed;
    if (!std::ranges::all_of(line.substr(0, colon), is_token_sign)) return kMalformed;
    const std::string name = lower_case(std::string(line.substr(0, colon)));
    for (const RefusedHeader& each : kRefusedHeaders) {
        if (name == each.name) return each.status;
    }
    if (name != "content-length") return 0;
    if (length) return kMalformed;
    length = declared_length(trimmed_value(line.substr(colon + 1)));
    if (!length) return kMalformed;
    return *length > kMostBodyBytes ? kTooLarge : 0;
}

int read_head(RequestBytes& request) {
    std::string_view rest = request.head();
    std::optional<std::size_t> length;
    for (std::size_t lines = 0; rest != "\r\n"; ++lines) {
        const std::size_t end = rest.find("\r\n");
        const std::string_view line = rest.substr(0, end);
        rest.remove_prefix(end + 2);
        if (lines > kMostHeadLines) return kHeadTooLarge;
        if (!is_plain_line(line)) return kMalformed;
        if (lines == 0) continue;  // the request's own line
        if (const int status = take_header(line, length)) return status;
    }
    request.body_bytes = length.value_or(0);
    return 0;
}

bool take_head(RequestBytes& request, std::size_t from) {
    const std::size_t end = request.bytes.find("\r\n\r\n", from);
    if (end == std::string::npos || end + 4 > kMostHeadBytes) {
        if (request.bytes.size() >= kMostHeadBytes) request.refused = kHeadTooLarge;
        return false;
    }
    request.head_bytes = end + 4;
    request.refused = read_head(request);
    return request.refused == 0;
}

}  // namespace

bool take_in(RequestBytes& request, std::string_view came) {
    const std::size_t before = request.bytes.size();
    request.bytes.append(came.substr(0, kMostHeadBytes + kMostBodyBytes));
    // Only what is new, and the three bytes before it, may end the head.
    if (request.head_bytes == 0 && !take_head(request, before < 3 ? 0 : before - 3)) {
        return request.refused == 0;
    }
    return request.bytes.size() < request.head_bytes + request.body_bytes;
}

void end_of_bytes(RequestBytes& request) {
    const bool is_whole =
        request.head_bytes > 0 && request.bytes.size() >= request.head_bytes + request.body_bytes;
    if (request.refused == 0 && !is_whole) request.refused = kTooLate;
}

}  // namespace tact
