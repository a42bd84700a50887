#include "devices/phone/phone_requests.h"

#include <doctest/doctest.h>

#include <set>

#include "devices/phone/phone_names.h"

namespace phone_requests_test {

using namespace tact;

namespace {

const std::string kSecret(kSecretLength, 'A');

std::string with_phone(const std::string& rest) {
    return R"({"phone":")" + kSecret + "\"" + rest + "}";
}

std::optional<std::string> answer_of(const std::string& answer) {
    const auto tell = parse_tell(with_phone(R"(,"card":"q1","answer":)" + answer));
    return tell ? std::optional(tell->answer) : std::nullopt;
}

}  // namespace

TEST_CASE("phone requests: a join has a clean name, and what it does not tell is empty") {
    const auto join = parse_join(R"({"nickname":" Kim\n","vibrates":true,"language":"ko-KR"})");
    REQUIRE(join);
    CHECK(*join == JoinRequest{"", "Kim", true, "ko-KR"});
    CHECK(parse_join("{}") == JoinRequest{"", "Phone", false, ""});
    CHECK(parse_join(with_phone(R"(,"other":[{"x":1}])"))->phone == kSecret);
    CHECK(parse_join(R"({"phone":"short"})")->phone.empty());
    CHECK(parse_join(R"({"language":"<b>"})")->language.empty());
    CHECK_FALSE(parse_join(R"({"language":"abcdefghijklmnopqrstuvwxyzabcdefghij"})"));
}

TEST_CASE("phone requests: what is no JSON, no object or of another type is malformed") {
    for (const char* text :
         {"", "null", "[]", "3", "{", "{}}", R"({"nickname":3})", R"({"vibrates":1})",
          R"({"vibrates":"true"})", R"({"phone":null})", R"({"nickname":"\ud800"})",
          "{\"nickname\":\"\xff\"}", R"({"nickname":1e999})", R"({"language":[]})"}) {
        CAPTURE(text);
        CHECK_FALSE(parse_join(text));
    }
    for (const char* rest : {R"(,"card":-1)", R"(,"card":1.5)", R"(,"card":"1")", R"(,"play":null)",
                             R"(,"play":9007199254740993)", R"(,"card":1e3)"}) {
        CAPTURE(rest);
        CHECK_FALSE(parse_next(with_phone(rest)));
    }
    CHECK_FALSE(parse_next(R"({"card":1,"play":1})"));
    CHECK_FALSE(parse_next(R"({"phone":"AAAAAAAAAAAAAAAAAAAA==","card":1,"play":1})"));
    CHECK(parse_next(with_phone(R"(,"card":5,"play":18)")) == NextRequest{kSecret, 5, 18});
}

TEST_CASE("phone requests: depth and size are bounded") {
    const std::string deep = R"({"x":)" + std::string(2000, '[') + std::string(2000, ']') + "}";
    CHECK_FALSE(parse_join(deep));
    CHECK_FALSE(parse_join(R"({"nickname":")" + std::string(kMostBodyBytes, 'x') + "\"}"));
    CHECK(parse_join(R"({"nickname":")" + std::string(4000, 'x') + "\"}")->nickname.size() == 24);
}

TEST_CASE("phone requests: an answer keeps its known keys, each of its type and range") {
    CHECK(answer_of(R"({"option":1})") == R"({"option":1})");
    CHECK(answer_of(R"({"x":{"y":2},"plays":[1,1,2],"option":0,"response_ms":5200})") ==
          R"({"option":0,"plays":[1,1,2],"response_ms":5200})");
    CHECK(
        answer_of(R"({"k":4,"similarity":37.5,"plays":[2,1],"first":"left","response_ms":8000})") ==
        R"({"k":4,"similarity":37.5,"plays":[2,1],"first":"left","response_ms":8000})");
    for (const char* wrong :
         {"1", "[]", "{}", R"({"option":-1})", R"({"option":"1"})", R"({"option":1001})",
          R"({"similarity":101})", R"({"similarity":-0.1})", R"({"similarity":"5"})",
          R"({"option":1,"plays":[1,-1]})", R"({"option":1,"plays":3})",
          R"({"option":1,"first":"up"})", R"({"option":1,"response_ms":1e99})",
          R"({"option":1,"plays":[1,1,1,1,1,1,1,1,1,1,1]})", R"({"plays":[1]})"}) {
        CAPTURE(wrong);
        CHECK_FALSE(answer_of(wrong));
    }
    CHECK_FALSE(parse_tell(with_phone(R"(,"answer":{"option":1})")));  // of which card
    CHECK_FALSE(parse_tell(with_phone(R"(,"card":"q1")")));
    CHECK_FALSE(parse_tell(with_phone(R"(,"card":"q1","answer":{"option":1},"played":3)")));
    CHECK(parse_tell(with_phone(R"(,"played":18)"))->played == 18);
    CHECK_FALSE(
        parse_tell(with_phone(R"(,"answer":{"option":1},"card":")" + std::string(65, 'x') + "\"")));
}

TEST_CASE("phone names: what is not seen or steers what shows it is left out") {
    CHECK(cleaned_nickname("Kim") == "Kim");
    CHECK(cleaned_nickname("  Ann \t\n Lee  ") == "Ann Lee");
    CHECK(cleaned_nickname("a\xE2\x80\xAE"
                           "b\xE2\x81\xA6"
                           "c") == "abc");  // overrides
    CHECK(cleaned_nickname("a\xE2\x80\x8B"
                           "b\xEF\xBB\xBF"
                           "c\xC2\xAD") == "abc");  // no width
    CHECK(cleaned_nickname("a\x1b[31mb\x7f") == "a[31mb");
    CHECK(cleaned_nickname(std::string("a\0b", 3)) == "ab");
    CHECK(cleaned_nickname("a\xff\xc0\x80"
                           "b\xed\xa0\x80") == "ab");  // no UTF-8
    CHECK(cleaned_nickname("\xE3\x80\x80\xEA\xB9\x80\xC2\xA0") == "\xEA\xB9\x80");
    CHECK(cleaned_nickname("<b>\"x\"</b>") == "<b>\"x\"</b>");  // who shows it escapes it
    for (const char* nothing :
         {"", "   ", "\xE2\x80\x8B", "\xE3\x85\xA4", "\x01", "\xF3\xA0\x81\x81"}) {
        CHECK(cleaned_nickname(nothing) == "Phone");
    }
}

TEST_CASE("phone names: at most 24 characters, also with the number that makes them unique") {
    std::string hangul;
    for (int k = 0; k < 30; ++k) hangul += "\xEA\xB9\x80";
    const std::string cut = cleaned_nickname(hangul);
    CHECK(cut == hangul.substr(0, 72));
    CHECK(unique_nickname("Kim", {}) == "Kim");
    CHECK(unique_nickname("Kim", {"Kim", "Kim 2", "kim"}) == "Kim 3");
    CHECK(unique_nickname(cut, {cut}) == hangul.substr(0, 66) + " 2");
    std::set<std::string> taken;
    for (int k = 0; k < 400; ++k) {
        const std::string name = unique_nickname(cut, taken);
        CHECK(cleaned_nickname(name) == name);
        CHECK(taken.insert(name).second);
    }
}

TEST_CASE("phone token: secrets have their form, differ, and are compared whole") {
    std::set<std::string> all;
    std::set<char> letters;
    for (int k = 0; k < 1000; ++k) {
        const auto secret = random_secret();
        REQUIRE(secret);
        CHECK(is_secret(*secret));
        // 128 bits are 21 characters and 2 bits.
        CHECK(std::string("AQgw").find(secret->back()) != std::string::npos);
        letters.insert(secret->begin(), secret->end());
        CHECK(all.insert(*secret).second);
    }
    CHECK(letters.size() == 64);
    CHECK(is_same_secret("abc", "abc"));
    for (const char* other : {"abd", "bbc", "ab", "abcd", ""}) {
        CHECK_FALSE(is_same_secret("abc", other));
    }
    CHECK_FALSE(is_secret("AAAAAAAAAAAAAAAAAAAAA="));
    CHECK_FALSE(is_secret(std::string(21, 'A')));
}

}  // namespace phone_requests_test
