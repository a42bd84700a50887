#include "model/lesson/number_words.h"

#include <array>

namespace tact {

namespace {

struct NumberWord {
    std::string_view english;
    std::string_view german;
    std::string_view korean;
};

// Korean has "of" and "less than" behind the number, hence signs in their place.
constexpr auto kNumberWords = std::to_array<NumberWord>(
    {{"sets of fibres", "Gruppen von Fasern", "\uc2e0\uacbd\uc12c\uc720 \uc9d1\ub2e8"},
     {"impulse a cycle", "Impuls je Schwingung", "\uc784\ud384\uc2a4/\uc8fc\uae30"},
     {"corpuscles", "K\u00f6rperchen", "\uc18c\uccb4"},
     {"corpuscle", "K\u00f6rperchen", "\uc18c\uccb4"},
     {"impulses/s", "Impulse/s", "\uc784\ud384\uc2a4/s"},
     {"less than ", "weniger als ", "< "},
     {"more than ", "mehr als ", "> "},
     {"at least ", "mindestens ", "\u2265 "},
     {"no type", "kein Typ", "\uc5c6\uc74c"},
     {" per mm", " je mm", "/mm"},
     {" and ", " und ", ", "},
     {" of ", " von ", "/"},
     {" to ", " bis ", "~"}});

}  // namespace

std::string number_in(std::string number, std::string_view language) {
    const std::string_view code = language.substr(0, language.find('-'));
    if (code != "de" && code != "ko") return number;
    for (const NumberWord& word : kNumberWords) {
        const std::string_view in_place = code == "de" ? word.german : word.korean;
        std::size_t at = 0;
        while ((at = number.find(word.english, at)) != std::string::npos) {
            number.replace(at, word.english.size(), in_place);
            at += in_place.size();
        }
    }
    return number;
}

}  // namespace tact
