#include "model/lesson/number_words.h"

#include <array>

namespace tact {

namespace {

struct GermanWord {
    std::string_view english;
    std::string_view german;
};

constexpr auto kGermanWords =
    std::to_array<GermanWord>({{"sets of fibres", "Gruppen von Fasern"},
                               {"impulse a cycle", "Impuls je Schwingung"},
                               {"corpuscles", "K\u00f6rperchen"},
                               {"corpuscle", "K\u00f6rperchen"},
                               {"impulses/s", "Impulse/s"},
                               {"less than ", "weniger als "},
                               {"more than ", "mehr als "},
                               {"no type", "kein Typ"},
                               {" per mm", " je mm"},
                               {" and ", " und "},
                               {" of ", " von "},
                               {" to ", " bis "}});

}  // namespace

std::string number_in(std::string number, std::string_view language) {
    if (language.substr(0, language.find('-')) != "de") return number;
    for (const GermanWord& word : kGermanWords) {
        std::size_t at = 0;
        while ((at = number.find(word.english, at)) != std::string::npos) {
            number.replace(at, word.english.size(), word.german);
            at += word.german.size();
        }
    }
    return number;
}

}  // namespace tact
