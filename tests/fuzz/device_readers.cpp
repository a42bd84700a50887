#include <algorithm>
#include <cstdint>
#include <cstring>

#include "devices/hid/haptic_page.h"
#include "devices/http/request_bytes.h"
#include "devices/phone/phone_names.h"
#include "devices/phone/phone_requests.h"
#include "devices/rumble/rumble_packets.h"
#include "tests/fuzz/readers.h"

namespace tact::fuzz {
namespace {

std::vector<std::uint8_t> packet_of(std::string_view bytes) {
    std::vector<std::uint8_t> packet(bytes.size());
    if (!bytes.empty()) std::memcpy(packet.data(), bytes.data(), bytes.size());
    return packet;
}

// The first byte: how many of the others are the descriptor; the rest is its waveform report.
bool descriptor(std::string_view bytes) {
    const auto all = packet_of(bytes);
    const std::span<const std::uint8_t> span = all;
    const std::size_t split =
        span.empty() ? 0 : std::min<std::size_t>(span.size(), 1 + std::size_t{4} * span[0]);
    const auto page = haptic_page(span.subspan(0, split));
    const auto whole = haptic_page(span);
    if (page) continuous_waveform(*page, span.subspan(split));
    if (whole) continuous_waveform(*whole, span);
    return page || whole;
}

std::vector<std::string> descriptor_seeds() {
    const auto bytes = [](std::initializer_list<int> values) {
        std::string text;
        for (const int value : values) text += static_cast<char>(value);
        return text;
    };
    // Usage page "haptics" (0x0e), a controller, its waveform list and a manual trigger.
    return {bytes({0x05, 0x0e, 0x09, 0x01, 0xa1, 0x01, 0x85, 0x01, 0x09, 0x10, 0xa1,
                   0x02, 0x05, 0x0a, 0x09, 0x03, 0x15, 0x00, 0x26, 0xff, 0x7f, 0x75,
                   0x10, 0x95, 0x01, 0xb1, 0x02, 0xc0, 0x05, 0x0e, 0x09, 0x21, 0x75,
                   0x08, 0x95, 0x01, 0x91, 0x02, 0x09, 0x23, 0x91, 0x02, 0xc0})};
}

bool acknowledgement(std::string_view bytes) {
    const auto packet = packet_of(bytes);
    bool any = false;
    for (int subcommand = 0; subcommand < 256; ++subcommand)
        any |= acknowledges(packet, subcommand);
    return any;
}

std::vector<std::string> acknowledgement_seeds() {
    return {std::string("\x21\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x80\x48", 15)};
}

// The body of any of the three requests of a phone's page.
bool phone_request(std::string_view bytes) {
    const auto join = parse_join(bytes);
    if (join) {
        hold(cleaned_nickname(join->nickname) == join->nickname, "a clean name is clean");
        hold(unique_nickname(join->nickname, {join->nickname}) != join->nickname, "names differ");
    }
    const auto tell = parse_tell(bytes);
    if (tell && !tell->played) {
        const auto again = parse_tell(R"({"phone":")" + tell->phone + R"(","card":"x","answer":)" +
                                      tell->answer + "}");
        hold(again && again->answer == tell->answer, "an answer is read again as the same");
    }
    return parse_next(bytes) || join || tell;
}

std::vector<std::string> phone_request_seeds() {
    const std::string phone = R"({"phone":"ABCDEFGHIJKLMNOPQRSTUV",)";
    return {R"({"nickname":"Kim","vibrates":true,"language":"ko"})",
            phone + R"("card":4,"play":17})", phone + R"("played":18})",
            phone + R"("card":"r1","answer":{"k":4,"similarity":50,"plays":[2,1],"first":"left",)"
                    R"("response_ms":8000}})"};
}

// Whole or byte by byte, a request is the same, and within its bounds.
bool http_request(std::string_view bytes) {
    RequestBytes whole;
    take_in(whole, bytes);
    end_of_bytes(whole);
    RequestBytes dripped;
    for (std::size_t k = 0; k < bytes.size() && take_in(dripped, bytes.substr(k, 1)); ++k) continue;
    end_of_bytes(dripped);
    hold(whole.refused == dripped.refused, "how bytes drip decides nothing");
    if (whole.refused != 0) return false;
    hold(whole.head() == dripped.head() && whole.body() == dripped.body(), "nor what is read");
    hold(whole.head_bytes <= kMostHeadBytes && whole.body_bytes <= kMostBodyBytes, "bounds hold");
    return true;
}

std::vector<std::string> http_request_seeds() {
    return {"POST /x/join HTTP/1.1\r\nHost: a\r\nContent-Length: 2\r\n\r\n{}",
            "GET /x/?a HTTP/1.1\r\nA: b\r\n\r\n"};
}

}  // namespace

std::span<const Reader> device_readers() {
    static const std::vector<Reader> all{
        {"descriptor", descriptor, descriptor_seeds, {}},
        {"acknowledgement", acknowledgement, acknowledgement_seeds, {}},
        {"phone_request",
         phone_request,
         phone_request_seeds,
         {"\"phone\"", "\"nickname\"", "\"answer\"", "\"plays\"", "\"similarity\"", "\\ud83d"}},
        {"http_request",
         http_request,
         http_request_seeds,
         {"Content-Length: ", "Transfer-Encoding: ", "\r\n", "\r\n\r\n"}}};
    return all;
}

}  // namespace tact::fuzz
