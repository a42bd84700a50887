#include "model/text/json_fields.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "tests/support/temporary_folder.h"

namespace json_fields_test {

using namespace tact;

namespace {

std::string fault(const std::string& text) {
    const auto document = parse_json(text, "f.json");
    REQUIRE_FALSE(document);
    return document.error().message;
}

}  // namespace

TEST_CASE("json: a syntax error has a line, a column and what was expected") {
    CHECK(fault("{\n  \"a\": 1,\n  \"b\" 2\n}").starts_with("f.json, line 3, column 7: expected"));
    CHECK(fault("").starts_with("f.json, line 1, column 1: expected"));
    CHECK(fault("{\"a\": [1, 2").starts_with("f.json, line 1, column 12: expected"));
    CHECK(contains(fault("{\"a\": NaN}"), "line 1, column 7"));
    CHECK(contains(fault("[1e999]"), "1.8e308"));
    CHECK(contains(fault("[1] 2"), "line 1, column 5"));
    CHECK(fault("\"" + std::string(100'000, 'x')).size() < 300);
    for (const char* text :
         {"{", "nul", "[1,]", "{\"a\":}", "\"\\ud800\"", "\"\x01\"", "[Infinity]"}) {
        CAPTURE(text);
        CHECK(fault(text).starts_with("f.json, line 1, column "));
    }
}

TEST_CASE("json: nesting of any depth is refused, not followed") {
    const std::size_t deep = 200'000;
    CHECK(fault(std::string(deep, '[') + std::string(deep, ']')) ==
          "f.json, line 1, column 101: expected at most 100 levels of { and [");
    CHECK(contains(fault(std::string(deep, '[')), "at most 100 levels"));
    std::string objects;
    for (std::size_t k = 0; k < deep; ++k) objects += "{\"a\":\n";
    CHECK(contains(fault(objects), "f.json, line 101, column 1: expected at most 100 levels"));
    CHECK(parse_json(std::string(100, '[') + std::string(100, ']'), "f.json"));
    CHECK(parse_json("\"" + std::string(1000, '[') + "\"", "f.json"));
    CHECK(parse_json("\"\\\"" + std::string(1000, '{') + "\"", "f.json"));
}

TEST_CASE("json: an object of more keys than any set has is refused") {
    std::string text = "{\"k\":0";
    for (int k = 0; k < 30'000; ++k) text += ",\"" + std::to_string(k) + "\":0";
    CHECK(contains(fault(text + "}"), "at most 20,000 keys"));
}

TEST_CASE("json: a byte-order mark is accepted, bytes that are not UTF-8 are not") {
    CHECK(parse_json("\xEF\xBB\xBF[1]", "f.json"));
    CHECK(fault("[\n\"a\xFF\"]") == "f.json, line 2, column 3: expected text in UTF-8");
}

TEST_CASE("json: the first fault of a reading stays, with its place and what is there") {
    const Json document = Json::parse(R"({"a": "x", "b": [1, 2], "c": 1.5, "d": {"e": true}})");
    const auto fault_of = [&](auto read) {
        JsonReading reading{"f.json", {}};
        JsonObject object = object_at(reading, document, "/top");
        read(object);
        return reading.fault;
    };
    CHECK(fault_of([](JsonObject& o) {
              number_field(o, "a", 0, {0, 5});
          }) == "f.json: /top/a: expected a number from 0 to 5, got \"x\"");
    CHECK(fault_of([](JsonObject& o) {
              number_field(o, "c", 0, {2, 5});
          }) == "f.json: /top/c: expected a number from 2 to 5, got 1.5");
    CHECK(fault_of([](JsonObject& o) {
              whole_field(o, "c", 0, {0, 5});
          }) == "f.json: /top/c: expected a whole number from 0 to 5, got 1.5");
    CHECK(fault_of([](JsonObject& o) { yes_no_field(o, "c", true); }) ==
          "f.json: /top/c: expected true or false, got 1.5");
    CHECK(fault_of([](JsonObject& o) { text_field(o, "b", ""); }) ==
          "f.json: /top/b: expected a text, got an array of 2");
    CHECK(fault_of([](JsonObject& o) { object_field(o, "b"); }) ==
          "f.json: /top/b: expected an object, got an array of 2");
    CHECK(fault_of([](JsonObject& o) { array_field(o, "b", 3, 9); }) ==
          "f.json: /top/b: expected an array of 3 to 9, got an array of 2");
    CHECK(fault_of([](JsonObject& o) { array_field(o, "d", 0, 9); }) ==
          "f.json: /top/d: expected an array of 0 to 9, got an object");
    constexpr const char* kChoices[] = {"one", "two"};
    CHECK(fault_of([&](JsonObject& o) { choice_field(o, "a", 0, kChoices); }) ==
          "f.json: /top/a: expected \"one\" or \"two\", got \"x\"");
    CHECK(fault_of([](JsonObject& o) {
              JsonObject inner = object_field(o, "d");
              number_field(inner, "e", 0, kAnyNumber);
              text_field(o, "b", "");
          }) == "f.json: /top/d/e: expected a number, got true");
    CHECK(fault_of([](JsonObject& o) { number_field(o, "none", 0, {1, 2}); }).empty());
}

TEST_CASE("json: fields nobody asked for come back where they were") {
    const Json original = Json::parse(
        R"({"a": 1, "new": null, "list": [{"x": 1, "y": 2}, {"x": 3}], "part": {"z": 1, "q": [2]}})");
    const Json unknown =
        Json::parse(R"({"list": {"0": {"y": 2}, "7": {"y": 9}}, "part": {"q": [2]}})");
    Json printed = Json::parse(R"({"a": 1, "list": [{"x": 1}, {"x": 3}], "part": {"z": 1}})");
    restore_unknown(printed, unknown);
    JsonReading reading{"f.json", {}};
    JsonObject object = object_at(reading, original, "");
    for (const char* key : {"a", "list", "part"}) field(object, key);
    CHECK(unknown_fields(object).dump() == R"({"new":null})");
    restore_unknown(printed, unknown_fields(object));
    CHECK(nlohmann::json::parse(printed.dump()) == nlohmann::json::parse(original.dump()));
}

TEST_CASE("json: what the document says is not overruled by what was unknown once") {
    Json document = Json::parse(R"({"a": 1, "b": [1]})");
    restore_unknown(document, Json::parse(R"({"a": 2, "b": {"0": {"x": 1}, "x": {"y": 1}}})"));
    CHECK(document.dump() == R"({"a":1,"b":[1]})");
}

TEST_CASE("json: what would take a gigabyte is refused before anything of it is made" *
          doctest::test_suite("long")) {
    const auto fault = [](const std::string& text) {
        const auto document = parse_json(text, "a.json");
        REQUIRE_FALSE(document);
        return document.error().message;
    };
    // The least text for the most memory: arrays in arrays, of which each takes forty times its
    // two characters.
    const std::string deep = std::string(90, '[') + std::string(90, ']') + ",";
    std::string many = "[";
    while (many.size() < 30'000'000) many += deep;
    CHECK(contains(fault(many + "0]"), "expected a file that takes less than 1 GB"));
    std::string numbers = "[0";
    for (int k = 0; k < 25'000'000; ++k) numbers += ",0";
    CHECK(contains(fault(numbers + "]"), "less than 1 GB"));
    // Each key is compared with those before it: as many objects of 20,000 keys as one likes would
    // take for ever.
    std::string object = "{";
    for (int k = 0; k < 20'000; ++k) object += (k > 0 ? ",\"" : "\"") + std::to_string(k) + "\":0";
    object += "}";
    CHECK(contains(fault("[" + object + "," + object + "," + object + "]"), "fewer keys"));
    CHECK(parse_json("[" + std::string(1000, ' ') + "1]", "a.json"));
}

}  // namespace json_fields_test
