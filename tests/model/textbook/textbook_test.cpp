// The statements of the bundled textbook, and the files it refuses.
#include "model/textbook/textbook.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "assets/assets.h"
#include "model/io/lesson/lesson_file.h"
#include "model/lesson/lesson_numbers.h"
#include "model/text/csv.h"
#include "model/text/numbers.h"

namespace textbook_test {

using namespace tact;

namespace {

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

const TextbookFact& fact(const char* id) {
    const TextbookFact* found = fact_named(id);
    REQUIRE_MESSAGE(found != nullptr, id);
    return *found;
}

// The bundled text with a part of it replaced.
std::string told(const std::string& part, const std::string& instead) {
    std::string text(asset("physiology/textbook.json"));
    const std::size_t at = text.find(part);
    REQUIRE(at != std::string::npos);
    const auto facts = parse_textbook(text.replace(at, part.size(), instead), "book.json");
    return facts ? std::string() : facts.error().message;
}

// The cell of a column in the line that begins with two keys.
double fitted(const std::string& afferent, const std::string& hz, std::size_t column) {
    CsvReader reader{asset("physiology/rate_intensity_fits.csv")};
    for (CsvRecord record = next_record(reader); record.line > 0; record = next_record(reader)) {
        const auto& cells = record.fields;
        if (cells.size() <= column || cells[0] != afferent || cells[1] != hz) continue;
        return finite_number_in(cells[column]).value_or(NAN);
    }
    return NAN;
}

}  // namespace

TEST_CASE("textbook: every fact has a source, a unit, a place, and what was read for it") {
    REQUIRE(textbook().size() > 30);
    std::set<std::string> ids;
    for (const TextbookFact& one : textbook()) {
        CAPTURE(one.id);
        ids.insert(one.id);
        for (const std::string& text :
             {one.unit, one.source, one.cite, one.what, one.species, one.site, one.read}) {
            CHECK_FALSE(text.empty());
        }
        CHECK((one.low || one.high || !one.points.empty()));
        CHECK(holds(one.says, "{value}"));
        CHECK(one.says.ends_with('.'));
        // A fact that was looked up names what was read; one from memory does not.
        CHECK((one.sure == Sure::from_memory) == one.read.starts_with("nothing"));
        const bool dated = holds(one.source, "19") || holds(one.source, "20");
        CHECK((dated || holds(one.source, "Android Open Source Project")));
    }
    CHECK(ids.size() == textbook().size());
}

TEST_CASE("textbook: a number says its unit, how far it reaches, and that it is from memory") {
    CHECK(value_text(fact("frequency jnd")) == "18 to 25 %");
    CHECK(value_text(fact("impulses a cycle")) == "1 impulse a cycle");
    CHECK(value_text(fact("best band FA2")) == "at least 64 Hz");
    CHECK(value_text(fact("ruffini density")) == "less than 0.3 corpuscles/mm\u00b2");
    CHECK(value_text(fact("highest rate SA1")) ==
          "25 at 20, 46.5 at 50 and 48.8 impulses/s at 100 Hz");
    CHECK(value_text(fact("density SA2")) == "9 units/cm\u00b2 (from memory)");
    CHECK(source_text(fact("frequency jnd")) == "Israr and others 2006, human");
    CHECK(sentence_of(fact("flutter")) ==
          "What is felt as flutter lies at 10 to 50 Hz (Hern\u00e1ndez and others 1997, human and "
          "monkey).");
}

TEST_CASE("textbook: every sentence of a fact from memory says so") {
    int from_memory = 0;
    for (const TextbookFact& one : textbook()) {
        CAPTURE(one.id);
        const bool marked = holds(sentence_of(one), "(from memory)");
        CHECK(marked == (one.sure == Sure::from_memory));
        if (marked) ++from_memory;
    }
    CHECK(from_memory == 3);
}

TEST_CASE("textbook: values between two points lie on a line over log frequency") {
    const TextbookFact& rates = fact("highest rate FA1");
    CHECK(value_over(rates, 20.0) == doctest::Approx(51.6));
    CHECK(value_over(rates, 100.0) == doctest::Approx(158.8));
    // Halfway from 20 to 50 Hz on a logarithmic scale: the mean of both.
    CHECK(value_over(rates, std::sqrt(20.0 * 50.0)) == doctest::Approx(77.1));
    CHECK_FALSE(value_over(rates, 19.0));
    CHECK_FALSE(value_over(rates, 101.0));
    CHECK_FALSE(value_over(fact("flutter"), 20.0));
}

TEST_CASE("textbook: its highest rates are the plateaus of the table that the slopes are from") {
    const std::pair<const char*, const char*> names[] = {
        {"FA1", "RA"}, {"FA2", "PC"}, {"SA1", "SA1"}};
    for (const auto& [type, afferent] : names) {
        for (const auto& [hz, rate] : fact(("highest rate " + std::string(type)).c_str()).points) {
            CAPTURE(type);
            CAPTURE(hz);
            const std::string at = shortest_digits(hz);
            CHECK(rate == doctest::Approx(fitted(afferent, at, 4)));
            CHECK(fitted(afferent, at, 6) >= 3.0);  // with three points or more
        }
    }
}

TEST_CASE("textbook: the least amplitude felt is that of the second table of thresholds") {
    for (const auto& [hz, db] : fact("least amplitude felt").points) {
        double lowest = 1e9;
        for (const Curve& curve : aosp_thresholds()) lowest = std::min(lowest, at(curve, hz));
        CAPTURE(hz);
        CHECK(db == doctest::Approx(20.0 * lowest).epsilon(0.001));
    }
}

TEST_CASE("textbook: what is misspelt or missing is refused with its place and what was expected") {
    CHECK(told("\"unit\": \"impulse a cycle\",", "").find("book.json: /facts/0/unit: expected") ==
          0);
    CHECK(holds(told("\"sure\": \"looked up\"", "\"sure\": \"certain\""), "looked up"));
    CHECK(holds(told("\"value\": 1, \"unit\"", "\"unit\""), "expected a value"));
    CHECK(holds(told("\"value\": 1, \"unit\"", "\"low\": 2, \"high\": 1, \"unit\""),
                "in their order"));
    CHECK(holds(told("[50, 102.6]", "[10, 102.6]"), "ascend"));
    CHECK(holds(told("\"receptor\": \"FA1\"", "\"receptor\": \"RA\""), "FA1"));
    CHECK(holds(told("\"stages\": [\"spikes\"", "\"stages\": [\"spike\""), "stages"));
    CHECK(holds(told("\"species\"", "\"specis\""), "species"));
    CHECK(holds(told("\"impulses a cycle of flutter\"", "\"impulses a cycle\""), "no other fact"));
}

TEST_CASE("textbook: lessons take facts by their words, and are told which there are") {
    const PatternSet set;
    CHECK(placeholder_fault("fact | frequency jnd", set).empty());
    CHECK(placeholder_fault("source | frequency jnd", set).empty());
    CHECK(placeholder_fault("fact", set) == "expected a fact of the textbook behind it");
    const std::string fault = placeholder_fault("fact | loudness jnd", set);
    CHECK(fault.starts_with("the textbook has no fact \"loudness jnd\"; it has "));
    CHECK(holds(fault, "frequency jnd"));
}

TEST_CASE("textbook: no lesson that comes with the program shows a number from memory") {
    std::size_t lessons = 0;
    for (const Asset& file : assets()) {
        if (!file.path.starts_with("lessons/")) continue;
        const auto lesson = parse_lesson(file.text, std::string(file.path), {});
        REQUIRE(lesson);
        ++lessons;
        for (const LessonStep& step : lesson->steps) {
            for (const std::string& text : texts_of(step)) {
                CHECK_FALSE(holds(text, "(from memory)"));
                for (const std::string& placeholder : placeholders_in(text)) {
                    const std::size_t bar = placeholder.find('|');
                    if (trimmed(placeholder.substr(0, bar)) != "fact") continue;
                    CAPTURE(placeholder);
                    const TextbookFact* asked = fact_named(trimmed(placeholder.substr(bar + 1)));
                    REQUIRE(asked != nullptr);
                    CHECK(asked->sure != Sure::from_memory);
                }
            }
        }
    }
    CHECK(lessons >= 7);
}

}  // namespace textbook_test
