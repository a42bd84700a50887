#include "model/io/set/spec_file.h"

#include <nlohmann/json.hpp>

#include "model/io/set/design_space_json.h"
#include "model/io/set/set_file.h"
#include "model/text/atomic_file.h"

namespace tact {

namespace {

Expected<Loaded> generator_alone(const std::filesystem::path& path, const Json& document) {
    JsonReading reading{path.string(), {}};
    JsonObject object = object_at(reading, document, "");
    Loaded loaded;
    PatternSet& set = loaded.set;
    Json unknown = Json::object();
    DesignSpace space = design_space_of(object, set.duration_s, unknown);
    if (!reading.fault.empty()) return Error{reading.fault};
    const auto* durations = std::get_if<std::vector<double>>(&space.duration_s);
    if (durations != nullptr && durations->size() == 1) set.duration_s = durations->front();
    set.name = path.stem().string();
    set.generator = std::move(space);
    if (!unknown.empty()) set.unknown_json = Json{{"generator", unknown}}.dump();
    return loaded;
}

void remark_unknown(const std::filesystem::path& path, Loaded& loaded) {
    const Json unknown = Json::parse(loaded.set.unknown_json, nullptr, false);
    if (!unknown.is_object() || !unknown.contains("generator")) return;
    const Json places = unknown["generator"].flatten();
    for (const auto& [place, value] : places.items()) {
        loaded.remarks.push_back(path.string() + ": " + place +
                                 " means nothing to a generator and was left aside");
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
