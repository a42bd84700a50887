#include "model/lesson/lesson_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "model/common/portable.h"
#include "model/common/units.h"
#include "model/lesson/lesson_pairs.h"
#include "model/pattern/pattern_parameter.h"
#include "model/physiology/firing.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"
#include "model/textbook/textbook.h"

namespace tact {

namespace {

enum class Arguments { none, fact, type, map, pattern, type_and_pattern, pair };

struct Word {
    const char* name;
    Arguments arguments;
};

constexpr auto kWords = std::to_array<Word>({{"frequency", Arguments::pattern},
                                             {"amplitude", Arguments::pattern},
                                             {"modulation", Arguments::pattern},
                                             {"duration", Arguments::pattern},
                                             {"displacement", Arguments::pattern},
                                             {"felt", Arguments::pattern},
                                             {"threshold", Arguments::type_and_pattern},
                                             {"spikes", Arguments::type_and_pattern},
                                             {"per cycle", Arguments::type_and_pattern},
                                             {"rate", Arguments::type_and_pattern},
                                             {"receptors", Arguments::type_and_pattern},
                                             {"radius", Arguments::type_and_pattern},
                                             {"on", Arguments::type_and_pattern},
                                             {"at cap", Arguments::type_and_pattern},
                                             {"nc", Arguments::pair},
                                             {"oc", Arguments::pair},
                                             {"pm", Arguments::pair},
                                             {"pm rank", Arguments::pair},
                                             {"density", Arguments::type},
                                             {"interval", Arguments::type},
                                             {"weight", Arguments::type},
                                             {"excitatory layers", Arguments::none},
                                             {"inhibitory layers", Arguments::none},
                                             {"stress", Arguments::map},
                                             {"k", Arguments::none},
                                             {"rho", Arguments::none},
                                             {"fact", Arguments::fact},
                                             {"source", Arguments::fact}});

std::vector<std::string> parts_of(std::string_view placeholder) {
    std::vector<std::string> parts;
    for (;;) {
        const std::size_t bar = placeholder.find('|');
        parts.emplace_back(trimmed(placeholder.substr(0, bar)));
        if (bar == std::string_view::npos) return parts;
        placeholder.remove_prefix(bar + 1);
    }
}

std::optional<Receptor> receptor_named(const std::string& name) {
    for (const Receptor receptor : kReceptors) {
        if (name == traits(receptor).name) return receptor;
    }
    return std::nullopt;
}

bool is_parametric(const std::string& word) {
    constexpr std::array<const char*, 7> kOfParameters{"frequency", "amplitude",    "modulation",
                                                       "duration",  "displacement", "threshold",
                                                       "per cycle"};
    return std::ranges::find(kOfParameters, word) != kOfParameters.end();
}

// Numbers that need a first carrier with a single frequency.
bool is_of_frequency(const std::string& word) {
    return word == "frequency" || word == "displacement" || word == "threshold" ||
           word == "per cycle";
}

std::string pattern_fault(const PatternSet& set, const std::string& name, const std::string& word) {
    const auto place = place_named(set, name);
    if (!place) return "there is no pattern " + in_quotes(name) + " in the lesson's set";
    if (!is_parametric(word)) return {};
    const auto* pattern = std::get_if<Pattern>(&set.vibrations[*place].source);
    if (pattern == nullptr) {
        return in_quotes(name) + " is no pattern made of parameters, so it has no carriers";
    }
    if (is_of_frequency(word) && !value_of(*pattern, PatternParameter::carrier)) {
        return "the frequency of " + in_quotes(name) + " is drawn, so it has no one number";
    }
    return {};
}

std::string fact_fault(const std::string& id) {
    if (fact_named(id) != nullptr) return {};
    std::string names;
    for (const TextbookFact& fact : textbook()) {
        names += (names.empty() ? "" : ", ") + fact.id;
    }
    return "the textbook has no fact " + in_quotes(id) + "; it has " + names;
}

std::size_t count_of(Arguments arguments) {
    if (arguments == Arguments::none) return 0;
    return arguments == Arguments::pair || arguments == Arguments::type_and_pattern ? 2 : 1;
}

std::string wanted_of(Arguments arguments) {
    switch (arguments) {
        case Arguments::none:
            return "expected nothing behind it";
        case Arguments::fact:
            return "expected a fact of the textbook behind it";
        case Arguments::type:
            return "expected a receptor type behind it";
        case Arguments::map:
            return "expected pm or people behind it";
        case Arguments::pattern:
            return "expected a pattern behind it";
        case Arguments::type_and_pattern:
            return "expected a receptor type and a pattern behind it";
        case Arguments::pair:
            break;
    }
    return "expected two patterns behind it";
}

constexpr const char* kNoRatings = "the lesson's set has no ratings";

bool needs_people(const std::string& word) { return word == "k" || word == "rho"; }

std::string map_fault(const std::string& of, const PatternSet& set) {
    if (of == "people") return set.ratings.empty() ? kNoRatings : "";
    return of == "pm" ? "" : "expected pm or people, got " + in_quotes(of);
}

std::string list_of_words() {
    std::string text;
    for (const Word& word : kWords) text += (text.empty() ? "" : ", ") + std::string(word.name);
    return text;
}

// ---- numbers of a pattern's stages ----

const ChannelStages& channel_of(const CodedPattern& coded, Receptor receptor) {
    return coded.stages.channel[index_of(receptor)];
}

int centre_spikes(const CodedPattern& coded, Receptor receptor) {
    const std::span<const int> counts = spikes_under_probe(channel_of(coded, receptor));
    return std::accumulate(counts.begin(), counts.end(), 0);
}

std::string share_text(const CodedPattern& coded, Receptor receptor, int least) {
    const auto& counts = coded.stages.code.central_count[index_of(receptor)];
    if (counts.empty()) return "0 %";
    const auto hits = std::ranges::count_if(counts, [least](int n) { return n >= least; });
    const double share = static_cast<double>(hits) / static_cast<double>(counts.size());
    return plain_digits(100.0 * share, 3) + " %";
}

std::string felt_text(const CodedPattern& coded) {
    std::vector<std::string> names;
    for (const Receptor receptor : kReceptors) {
        if (coded.firing[index_of(receptor)] == Firing::fires)
            names.emplace_back(traits(receptor).name);
    }
    if (names.empty()) return "no type";
    std::string text = names[0];
    for (std::size_t k = 1; k < names.size(); ++k) {
        text += (k + 1 == names.size() ? " and " : ", ") + names[k];
    }
    return text;
}

double displacement_of(const Pattern& pattern) {
    const Carrier& first = pattern.carriers[0];
    double most = pattern.amplitude_curve.empty() ? 1.0 : 0.0;
    for (const AmplitudePoint& point : pattern.amplitude_curve) most = std::max(most, point.value);
    return displacement_um(pattern.amplitude_g * most * std::abs(first.weight), first.frequency_hz);
}

std::string value_of_pattern(const std::string& word, const CodedPattern& coded,
                             const Vibration& vibration) {
    if (word == "felt") return felt_text(coded);
    const Pattern& pattern = std::get<Pattern>(vibration.source);
    if (word == "frequency") return plain_digits(pattern.carriers[0].frequency_hz, 4) + " Hz";
    if (word == "amplitude") return plain_digits(pattern.amplitude_g, 3) + " g";
    if (word == "modulation") return plain_digits(pattern.modulation.frequency_hz, 3) + " Hz";
    if (word == "duration") return plain_digits(pattern.duration_s, 3) + " s";
    return plain_digits(displacement_of(pattern), 2) + " \u00b5m";
}

std::string threshold_text(const PatternSet& set, Receptor receptor, const Vibration& vibration) {
    const double frequency_hz = std::get<Pattern>(vibration.source).carriers[0].frequency_hz;
    const Curve& curve = set.model.coding.tables.threshold[index_of(receptor)];
    return plain_digits(portable::pow(10.0, at(curve, frequency_hz)), 2) + " \u00b5m";
}

bool is_of_table(const std::string& word) {
    return word == "density" || word == "interval" || word == "weight";
}

// The model's constants of a type, independent of the pattern.
std::string value_of_table(const std::string& word, Receptor receptor, const PatternSet& set) {
    if (word == "density")
        return plain_digits(traits(receptor).density_per_mm2, 3) + " per mm\u00b2";
    if (word == "interval") return plain_digits(grid_interval_mm(receptor), 3) + " mm";
    return plain_digits(set.model.channel_weight[index_of(receptor)], 3);
}

std::string value_of_maps(const std::vector<std::string>& parts, const LessonMaps& maps) {
    if (parts[0] == "k") return maps.k ? plain_digits(*maps.k, 2) : "\u2026";
    if (parts[0] == "rho") return maps.rho ? plain_digits(*maps.rho, 2) : "\u2026";
    const auto& stress = parts[1] == "pm" ? maps.pm_stress : maps.people_stress;
    return stress ? plain_digits(*stress, 2) : "\u2026";
}

std::string value_of_type(const std::string& word, Receptor receptor, const CodedPattern& coded,
                          const PatternSet& set, const Vibration& vibration) {
    const std::size_t c = index_of(receptor);
    const Activation& activation = coded.stages.code.activation[c];
    if (word == "threshold") return threshold_text(set, receptor, vibration);
    const char* const leaks = coded.firing[c] == Firing::leaks ? " (its filter leaks)" : "";
    if (word == "spikes") return std::to_string(centre_spikes(coded, receptor)) + leaks;
    if (word == "rate") return plain_digits(activation.rate_hz, 3) + " impulses/s";
    if (word == "radius") return plain_digits(activation.radius_mm, 2) + " mm";
    if (word == "on") return share_text(coded, receptor, 1);
    if (word == "at cap") return share_text(coded, receptor, set.model.coding.spike_cap);
    if (word == "receptors") {
        const bool answers = activation.radius_mm > 0.0;
        return std::to_string(answers ? coded.stages.code.activated[c] : 0);
    }
    const Pattern& pattern = std::get<Pattern>(vibration.source);
    const double cycles = pattern.carriers[0].frequency_hz * pattern.duration_s;
    return plain_digits(centre_spikes(coded, receptor) / cycles, 2) + leaks;
}

}  // namespace

std::vector<std::string> placeholders_in(std::string_view text) {
    std::vector<std::string> found;
    for (;;) {
        const std::size_t open = text.find('{');
        if (open == std::string_view::npos) return found;
        const std::size_t close = text.find('}', open);
        if (close == std::string_view::npos) return found;
        found.emplace_back(text.substr(open + 1, close - open - 1));
        text.remove_prefix(close + 1);
    }
}

std::string placeholder_fault(const std::string& placeholder, const PatternSet& set) {
    const std::vector<std::string> parts = parts_of(placeholder);
    const auto word =
        std::ranges::find(kWords, parts[0], [](const Word& w) { return std::string(w.name); });
    if (word == kWords.end()) return "expected one of " + list_of_words();
    if (parts.size() != 1 + count_of(word->arguments)) return wanted_of(word->arguments);
    if (word->arguments == Arguments::none) {
        return needs_people(parts[0]) && set.ratings.empty() ? kNoRatings : "";
    }
    if (word->arguments == Arguments::map) return map_fault(parts[1], set);
    if (word->arguments == Arguments::fact) return fact_fault(parts[1]);
    const bool of_type =
        word->arguments == Arguments::type || word->arguments == Arguments::type_and_pattern;
    if (of_type && !receptor_named(parts[1])) {
        return "expected Meissner, Pacinian, Merkel or Ruffini, got " + in_quotes(parts[1]);
    }
    if (word->arguments == Arguments::type) return {};
    if (word->arguments == Arguments::pair) {
        const std::string fault = pattern_fault(set, parts[1], parts[0]);
        if (!fault.empty()) return fault;
        if (parts[1] == parts[2]) return "expected two patterns that differ";
    }
    return pattern_fault(set, parts.back(), parts[0]);
}

std::string filled(std::string_view text, const LessonNumbers& numbers) {
    std::string result;
    for (;;) {
        const std::size_t open = text.find('{');
        const std::size_t close = open == std::string_view::npos ? open : text.find('}', open);
        if (close == std::string_view::npos) return result + std::string(text);
        result += text.substr(0, open);
        const auto known = numbers.find(std::string(text.substr(open + 1, close - open - 1)));
        result += known == numbers.end() ? "\u2026" : known->second;
        text.remove_prefix(close + 1);
    }
}

std::string value_of(const std::string& placeholder, const PatternSet& set,
                     const LessonPairs& pairs) {
    const std::vector<std::string> parts = parts_of(placeholder);
    if (parts[0] == "fact") return value_text(*fact_named(parts[1]));
    if (parts[0] == "source") return source_text(*fact_named(parts[1]));
    const NeuralCodingParams& coding = set.model.coding;
    if (parts[0] == "excitatory layers") return std::to_string(coding.excitatory_layers);
    if (parts[0] == "inhibitory layers") return std::to_string(coding.inhibitory_layers);
    if (parts[0] == "stress" || needs_people(parts[0])) return value_of_maps(parts, pairs.maps);
    if (is_of_table(parts[0])) {
        return value_of_table(parts[0], *receptor_named(parts[1]), set);
    }
    const std::size_t last = place_named(set, parts.back()).value();
    const Vibration& vibration = set.vibrations[last];
    if (parts.size() == 2) return value_of_pattern(parts[0], pairs.coded[last], vibration);
    if (const auto receptor = receptor_named(parts[1])) {
        return value_of_type(parts[0], *receptor, pairs.coded[last], set, vibration);
    }
    return pair_text(parts[0], pairs, place_named(set, parts[1]).value(), last);
}

}  // namespace tact
