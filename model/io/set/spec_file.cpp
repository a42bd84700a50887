#include "model/io/set/spec_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "model/io/set/design_space_json.h"
#include "model/io/set/set_file.h"
#include "model/text/atomic_file.h"
#include "model/text/json_fields.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr std::size_t kMostNamed = 20;

Expected<Loaded> generator_alone(const std::filesystem::path& path, const Json& document) {
    JsonReading reading{path.string(), {}, UnknownKeys::kept};
    JsonObject object = object_at(reading, document, "");
    Loaded loaded;
    PatternSet& set = loaded.set;
    Json unknown = Json::object();
    DesignSpace space = design_space_of(object, set.duration_s, unknown);
    if (!reading.fault.empty()) return Error{reading.fault};
    const auto* durations = std::get_if<std::vector<double>>(&space.duration_s);
    if (durations != nullptr && durations->size() == 1) set.duration_s = durations->front();
    set.name = valid_utf8(path.stem().string());
    set.generator = std::move(space);
    if (!unknown.empty()) set.unknown_json = text_of_json(Json{{"generator", unknown}});
    return loaded;
}

// Where the values are that nothing is nested in. No more than are named, as their number times the
// length of a place has no bound.
void add_places(const Json& value, const std::string& place, std::vector<std::string>& places) {
    if (!value.is_structured() || value.empty()) {
        places.push_back(shortened(place, 100));
        return;
    }
    for (const auto& [key, part] : value.items()) {
        if (places.size() > kMostNamed) return;
        add_places(part, place + "/" + key, places);
    }
}

void remark_unknown(const std::filesystem::path& path, Loaded& loaded) {
    const Json unknown = kept_json(loaded.set.unknown_json);
    if (!unknown.is_object() || !unknown.contains("generator")) return;
    std::vector<std::string> places;
    add_places(unknown["generator"], "", places);
    for (std::size_t k = 0; k < std::min(places.size(), kMostNamed); ++k) {
        loaded.remarks.push_back(path.string() + ": " + places[k] +
                                 " means nothing to a generator and was left aside");
    }
    if (places.size() > kMostNamed) {
        loaded.remarks.push_back(path.string() + ": more keys mean nothing to a generator");
    }
}

}  // namespace

Expected<Loaded> read_spec_file(const std::filesystem::path& path) {
    const auto text = read_text_file(path);
    if (!text) return text.error();
    const auto document = parse_json(*text, path.string());
    if (!document) return document.error();
    const bool is_set = document->is_object() &&
                        (document->contains("tactspace") || document->contains("patterns") ||
                         document->contains("generator"));
    Expected<Loaded> loaded = is_set ? read_set_file(path) : generator_alone(path, *document);
    if (!loaded) return loaded;
    if (!loaded->set.generator) {
        return Error{path.string() +
                     ": this set has no \"generator\", expected one that says "
                     "which values parameters may take"};
    }
    remark_unknown(path, *loaded);
    return loaded;
}

}  // namespace tact
