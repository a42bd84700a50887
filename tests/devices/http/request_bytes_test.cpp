#include "devices/http/request_bytes.h"

#include <doctest/doctest.h>

#include <vector>

#include "devices/http/network_interfaces.h"
#include "devices/http/token_bucket.h"

namespace request_bytes_test {

using namespace tact;

namespace {

// As it drips, `step` bytes at a time; what comes after the end is not read.
RequestBytes taken(std::string_view bytes, std::size_t step) {
    RequestBytes request;
    while (!bytes.empty()) {
        const std::string_view some = bytes.substr(0, step);
        bytes.remove_prefix(some.size());
        if (!take_in(request, some)) return request;
    }
    end_of_bytes(request);
    return request;
}

int refusal(const std::string& bytes) {
    const int whole = taken(bytes, bytes.size()).refused;
    for (const std::size_t step : {1, 2, 3, 7, 1000}) {
        CHECK(taken(bytes, step).refused == whole);
    }
    return whole;
}

std::string post(const std::string& headers, const std::string& body) {
    return "POST /x HTTP/1.1\r\n" + headers + "\r\n" + body;
}

}  // namespace

TEST_CASE("http: a request is whole with the last byte of its body, however it drips") {
    const std::string bytes = post("Host: a\r\nContent-Length: 5\r\n", "hello");
    for (const std::size_t step : {1, 2, 3, 4, 5, 100}) {
        const RequestBytes request = taken(bytes + "more of another one", step);
        CHECK(request.refused == 0);
        CHECK(request.head() == bytes.substr(0, bytes.size() - 5));
        CHECK(request.body() == "hello");
    }
    CHECK(taken("GET / HTTP/1.1\r\n\r\n", 1).refused == 0);
    CHECK(taken("GET / HTTP/1.1\r\n\r\n", 1).body().empty());
}

TEST_CASE("http: what ends before it is whole is refused") {
    CHECK(refusal("G") == 408);
    CHECK(refusal("GET / HTTP/1.1\r\nHost: a\r\n") == 408);
    CHECK(refusal(post("Content-Length: 5\r\n", "hell")) == 408);
    CHECK(refusal("GET / HTTP/1.1\n\n") == 408);  // no end of a head
}

TEST_CASE("http: the length of a body is no matter of opinion") {
    CHECK(refusal(post("Content-Length: 4\r\nContent-Length: 5\r\n", "hello")) == 400);
    CHECK(refusal(post("Content-Length: 5\r\ncontent-length: 5\r\n", "hello")) == 400);
    for (const char* length : {"", "-1", "+5", "5 5", "0x5", "5,5", "5.0", "five"}) {
        CHECK(refusal(post("Content-Length: " + std::string(length) + "\r\n", "hello")) == 400);
    }
    CHECK(refusal(post("Content-Length : 5\r\n", "hello")) == 400);
    CHECK(refusal(post("Host: a\r\n Content-Length: 5\r\n", "hello")) == 400);  // folded
    CHECK(refusal(post("Transfer-Encoding: chunked\r\n", "5\r\nhello\r\n0\r\n\r\n")) == 411);
    CHECK(refusal(post("transfer-encoding: x\r\nContent-Length: 5\r\n", "hello")) == 411);
    CHECK(refusal(post("Host: a\nContent-Length: 5\r\n", "hello")) == 400);  // LF alone
}

TEST_CASE("http: bodies and heads have a largest size, declared or not") {
    const std::string most(kMostBodyBytes, 'x');
    CHECK(refusal(post("Content-Length: 4096\r\n", most)) == 0);
    CHECK(refusal(post("Content-Length: 4097\r\n", most + "x")) == 413);
    CHECK(refusal(post("Content-Length: 4097\r\n", "")) == 413);
    CHECK(refusal(post("Content-Length: 99999999999999999999999999\r\n", "")) == 413);
    CHECK(refusal("GET /" + std::string(kMostHeadBytes, 'x')) == 431);
    CHECK(refusal("GET / HTTP/1.1\r\nA: " + std::string(kMostHeadBytes, 'x') + "\r\n\r\n") == 431);
    std::string many = "GET / HTTP/1.1\r\n";
    for (std::size_t k = 0; k < kMostHeadLines; ++k) many += "A: b\r\n";
    CHECK(refusal(many + "\r\n") == 0);
    CHECK(refusal(many + "A: b\r\n\r\n") == 431);
}

TEST_CASE("http: controls, headers without a name, and what our page never sends are refused") {
    CHECK(refusal(std::string("GET /\0 HTTP/1.1\r\n\r\n", 20)) == 400);
    CHECK(refusal("GET / HTTP/1.1\r\nA: \x01\r\n\r\n") == 400);
    CHECK(refusal("GET / HTTP/1.1\r\n: b\r\n\r\n") == 400);
    CHECK(refusal("GET / HTTP/1.1\r\nA b\r\n\r\n") == 400);
    CHECK(refusal("GET / HTTP/1.1\r\nA b: c\r\n\r\n") == 400);
    CHECK(refusal(post("Content-Encoding: gzip\r\nContent-Length: 1\r\n", "x")) == 415);
    CHECK(refusal("GET / HTTP/1.1\r\nRange: bytes=0-1\r\n\r\n") == 416);
    CHECK(refusal(post("Expect: 100-continue\r\nContent-Length: 1\r\n", "x")) == 417);
}

TEST_CASE("http: a bucket allows a burst, then its rate") {
    const BucketSize size{20.0, 40.0};
    TokenBucket bucket = full_bucket(size, 100.0);
    for (int k = 0; k < 40; ++k) CHECK(take_token(bucket, size, 100.0));
    CHECK_FALSE(take_token(bucket, size, 100.0));
    CHECK_FALSE(take_token(bucket, size, 100.04));
    CHECK(take_token(bucket, size, 100.06));
    CHECK_FALSE(take_token(bucket, size, 99.0));  // a clock that goes back gives nothing
    int allowed = 0;
    for (int k = 0; k < 100; ++k) allowed += take_token(bucket, size, 1000.0) ? 1 : 0;
    CHECK(allowed == 40);
}

TEST_CASE("http: addresses of rooms are private ones") {
    for (const char* inside :
         {"10.0.0.1", "172.16.0.1", "172.31.255.255", "192.168.1.23", "10.255.0.0"}) {
        CHECK(is_private_address(inside));
    }
    for (const char* outside : {"11.0.0.1", "172.15.0.1", "172.32.0.1", "192.169.0.1", "127.0.0.1",
                                "8.8.8.8", "", "10.0.0", "fe80::1", "10.0.0.1 "}) {
        CHECK_FALSE(is_private_address(outside));
    }
    for (const NetworkInterface& each : network_interfaces()) {
        CHECK(is_private_address(each.address));
        CHECK_FALSE(each.name.empty());
    }
}

}  // namespace request_bytes_test
