// The words inside numbers, in another language.
#include "model/lesson/number_words.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "assets/assets.h"
#include "model/io/lesson/lesson_file.h"
#include "model/lesson/lesson_languages.h"
#include "model/lesson/lesson_numbers.h"

namespace number_words_test {

using namespace tact;

TEST_CASE("number words: those of a number are in the lesson's language, names and digits stay") {
    CHECK(number_in("3 of 28", "de") == "3 von 28");
    CHECK(number_in("18 to 25 %", "de-AT") == "18 bis 25 %");
    CHECK(number_in("Meissner, Pacinian and Ruffini", "de") == "Meissner, Pacinian und Ruffini");
    CHECK(number_in("1.4 per mm\u00b2", "de") == "1.4 je mm\u00b2");
    CHECK(number_in("3 of 28", "ko") == "3/28");
    CHECK(number_in("18 to 25 %", "ko-KR") == "18~25 %");
    CHECK(number_in("Meissner, Pacinian and Ruffini", "ko") == "Meissner, Pacinian, Ruffini");
    CHECK(number_in("1 impulse a cycle", "ko") == "1 \uc784\ud384\uc2a4/\uc8fc\uae30");
    CHECK(number_in("3 of 28", "en") == "3 of 28");
    CHECK(number_in("3 of 28", "") == "3 of 28");
    CHECK(number_in("3 of 28", "deu") == "3 of 28");
}

TEST_CASE(
    "number words: no English word is left in a number of a bundled lesson in another language" *
    doctest::test_suite("long")) {
    constexpr const char* kEnglish[] = {" of ", " to ", " and ", " than", "per ", "cycle"};
    int lessons = 0;
    for (const Asset& file : assets()) {
        if (!file.path.starts_with("lessons/")) continue;
        const auto lesson = parse_lesson(file.text, std::string(file.path), {});
        REQUIRE(lesson);
        CAPTURE(lesson->name);
        REQUIRE(lesson->languages == std::vector<std::string>{"en", "de", "ko"});
        CHECK(translation_lacks(*lesson).empty());
        for (std::size_t k = 1; k < lesson->languages.size(); ++k) {
            const auto other = in_language(std::make_shared<const Lesson>(*lesson), k);
            for (const auto& [placeholder, number] : lesson_answers(*other).numbers) {
                CAPTURE(placeholder);
                CAPTURE(number);
                for (const char* word : kEnglish) CHECK(number.find(word) == std::string::npos);
            }
        }
        ++lessons;
    }
    CHECK(lessons == 9);
}

}  // namespace number_words_test
