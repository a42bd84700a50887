#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/python/parts.h"
#include "model/algebra/source_edits.h"
#include "model/io/set/set_json.h"

namespace tact {

namespace py = pybind11;

py::array render_pattern(const py::object& pattern, const py::object& rate_hz) {
    Vibration drawn;
    drawn.source = pattern_of(pattern);
    return array_of(
        beside_python_or_alone([drawn, rate = rate_of(rate_hz)](const std::stop_token&) {
            return waveform_of(drawn, rate);
        }).samples_g);
}

namespace {

// "reverse", or with what it needs: ("stretch", 1.2), ("join", {...}).
Edit edit_of(const py::handle& given) {
    const bool is_key = py::isinstance<py::str>(given);
    if (!is_key && !py::isinstance<py::tuple>(given) && !py::isinstance<py::list>(given)) {
        throw py::type_error("edits: expected texts and tuples, got " + described(given));
    }
    const py::tuple words =
        is_key ? py::make_tuple(given) : py::tuple(py::reinterpret_borrow<py::object>(given));
    const auto kind = words.empty() ? std::nullopt : edit_kind(text_in(words[0], "edits"));
    if (!kind) {
        std::string keys;
        for (std::size_t k = 0; k < kEditKindCount; ++k) {
            keys += std::string(k == 0 ? "" : ", ") + traits(static_cast<EditKind>(k)).key;
        }
        throw py::value_error("edits: expected one of " + keys + ", got " +
                              py::repr(given).cast<std::string>());
    }
    const EditTraits& about = traits(*kind);
    const auto refuse = [&](const char* expected) {
        throw py::value_error(std::string(about.key) + ": expected " + expected + ", got " +
                              py::repr(given).cast<std::string>());
    };
    const bool is_pair = words.size() == 2;
    if (about.needs == EditNeeds::nothing) {
        if (words.size() != 1) refuse("nothing with it");
    } else if (about.needs == EditNeeds::pattern) {
        if (!is_pair || !py::isinstance<py::dict>(words[1])) refuse("a pattern with it");
    } else if (!is_pair || PyNumber_Check(words[1].ptr()) == 0) {
        refuse("a number with it");
    }
    Edit edit{*kind};
    if (about.needs == EditNeeds::pattern) {
        edit.other = pattern_of(words[1]);
    } else if (is_pair) {
        edit.number = words[1].cast<double>();
    }
    return edit;
}

}  // namespace

py::object edit_pattern(const py::object& pattern, const py::object& edits,
                        const py::object& model) {
    const PerceptualModelParams params = model_of(model);
    Vibration before;
    before.source = pattern_of(pattern);
    std::vector<Edit> all;
    if (py::isinstance<py::str>(edits) || !py::isinstance<py::sequence>(edits)) {
        throw py::type_error("edits: expected a list of edits, got " + described(edits));
    }
    for (const py::handle given : edits) all.push_back(edit_of(given));
    const VibrationSource after = value_of(beside_python_or_alone(
        [before, all, tables = params.coding.tables](const std::stop_token&) {
            return edited_source(before, all, tables);
        }));
    const double usual_s = Pattern().duration_s;
    if (const auto* layered = std::get_if<LayeredPattern>(&after)) {
        return python_of(json_of(*layered, usual_s, {}));
    }
    const auto* made = std::get_if<Pattern>(&after);
    if (made == nullptr) {
        throw py::value_error(
            "edits: expected what stays a pattern, a join with layers is samples");
    }
    return python_of(json_of(*made, usual_s));
}

}  // namespace tact
