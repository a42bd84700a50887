#include "model/set/measured_twin.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <set>

#include "model/common/random.h"
#include "model/set/felt_versions.h"

namespace tact {

namespace {

const Measurement* measurement_of(const Vibration& vibration) {
    return std::get_if<Measurement>(&vibration.source);
}

// Letters and digits in lower case: what people keep of a name in a file's.
std::string plain(std::string_view name) {
    std::string result;
    for (const char c : name) {
        if (c >= 'A' && c <= 'Z') {
            result += static_cast<char>(c - 'A' + 'a');
        } else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (c & 0x80) != 0) {
            result += c;
        }
    }
    return result;
}

// Whether a stem is a name with an addition that people make: "measured", the number of a take.
bool is_addition(std::string_view rest) {
    for (const std::string_view word : {"measured", "recording", "recorded", "take"}) {
        if (rest.starts_with(word)) rest.remove_prefix(word.size());
    }
    return rest.find_first_not_of("0123456789") == rest.npos;
}

Twin twin(const Vibration& intended, const Waveform& recording, bool synthetic) {
    Twin result;
    result.alignment = aligned(recording, waveform_of(intended));
    if (synthetic) result.alignment.gain_db = 0.0;  // as it was asked for: no unit is in doubt
    for (double& sample : result.alignment.waveform.samples_g) {
        sample = static_cast<double>(static_cast<float>(sample));
    }
    Measurement measurement;
    measurement.waveform = std::make_shared<const Waveform>(result.alignment.waveform);
    measurement.measures = intended.name;
    measurement.measures_version = version_of(intended);
    measurement.synthetic = synthetic;
    result.vibration.name = intended.name + (synthetic ? " synthetic" : " measured");
    result.vibration.colour = intended.colour;
    result.vibration.ring = !intended.ring;  // beside it, and yet another
    result.vibration.source = std::move(measurement);
    return result;
}

}  // namespace

Twin measured_twin(const Vibration& intended, const Waveform& recording) {
    return twin(intended, recording, false);
}

Twin synthetic_twin(const Vibration& intended, const ActuatorParams& params) {
    return twin(intended, simulated_measurement(waveform_of(intended), params), true);
}

bool measures_another(const Vibration& vibration) {
    const Measurement* measurement = measurement_of(vibration);
    return measurement != nullptr && !measurement->measures.empty();
}

std::size_t insert_twin(PatternSet& set, Vibration twin) {
    const std::string& name = std::get<Measurement>(twin.source).measures;
    const auto intended = place_named(set, name);
    assert(intended && "a twin of nothing");
    std::size_t place = *intended + 1;
    while (place < set.vibrations.size() && measures_another(set.vibrations[place]) &&
           measurement_of(set.vibrations[place])->measures == name) {
        ++place;
    }
    twin.name = unused_name(set, twin.name);
    set.vibrations.insert(set.vibrations.begin() + static_cast<std::ptrdiff_t>(place),
                          std::move(twin));
    return place;
}

std::vector<Twin> synthetic_twins(const PatternSet& set, const std::vector<std::size_t>& places,
                                  const ActuatorParams& params) {
    std::vector<Twin> twins;
    for (std::size_t k = 0; k < set.vibrations.size(); ++k) {
        if (measures_another(set.vibrations[k])) continue;
        if (!places.empty() && std::ranges::count(places, k) == 0) continue;
        ActuatorParams own = params;
        own.seed = random_bits(params.seed, k);
        twins.push_back(synthetic_twin(set.vibrations[k], own));
    }
    return twins;
}

PatternSet with_synthetic_twins(const PatternSet& set, const ActuatorParams& params) {
    PatternSet result = set;
    for (Twin& twin : synthetic_twins(set, {}, params)) {
        insert_twin(result, std::move(twin.vibration));
    }
    return result;
}

std::optional<std::size_t> guessed_intended(const PatternSet& set, std::string_view stem) {
    const std::string wanted = plain(stem);
    std::optional<std::size_t> found;
    std::size_t longest = 0;
    bool several = false;
    for (std::size_t k = 0; k < set.vibrations.size(); ++k) {
        if (measures_another(set.vibrations[k])) continue;
        if (set.vibrations[k].name == stem) return k;
        const std::string name = plain(set.vibrations[k].name);
        if (name.empty() || !wanted.starts_with(name)) continue;
        if (!is_addition(std::string_view(wanted).substr(name.size()))) continue;
        // "pulse 12" is the pattern of that number rather than take 2 of "pulse 1".
        if (name.size() > longest || !found) {
            found = k;
            longest = name.size();
            several = false;
        } else if (name.size() == longest) {
            several = true;
        }
    }
    return several ? std::nullopt : found;
}

PatternSet one_side(const PatternSet& set, Side side) {
    PatternSet result = set;
    if (side == Side::both) return result;
    std::erase_if(result.vibrations, [side](const Vibration& vibration) {
        return measures_another(vibration) != (side == Side::measured);
    });
    if (side == Side::intended) return result;
    std::map<std::string, std::string> first_twin;
    for (const Vibration& vibration : result.vibrations) {
        first_twin.emplace(measurement_of(vibration)->measures, vibration.name);
    }
    for (Ratings& ratings : result.ratings) {
        ratings.versions.clear();  // of patterns, which are on the other side
        for (std::string& label : ratings.labels) {
            const auto twin = first_twin.find(label);
            if (twin != first_twin.end()) label = twin->second;
        }
    }
    return result;
}

PatternSet measured_stand_ins(const PatternSet& set) {
    PatternSet result = one_side(set, Side::measured);
    result.ratings = set.ratings;
    for (Ratings& ratings : result.ratings) ratings.versions.clear();  // of what is stood in for
    std::set<std::string> seen;
    std::erase_if(result.vibrations, [&seen](const Vibration& vibration) {
        return !seen.insert(measurement_of(vibration)->measures).second;
    });
    for (Vibration& vibration : result.vibrations) {
        vibration.name = measurement_of(vibration)->measures;
    }
    return result;
}

}  // namespace tact
