#include "app/python/documents.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace tact {

namespace py = pybind11;

namespace {

template <class Document>
py::object dict_or_list_of(const Document& document) {
    if (document.is_array()) {
        py::list list;
        for (const Document& one : document) list.append(python_of(one));
        return list;
    }
    py::dict dict;
    for (const auto& [key, value] : document.items()) dict[py::str(key)] = python_of(value);
    return dict;
}

template <class Document>
py::object any_of(const Document& document) {
    if (document.is_structured()) return dict_or_list_of(document);
    if (document.is_boolean()) return py::bool_(document.template get<bool>());
    if (document.is_number_unsigned()) return py::int_(document.template get<std::uint64_t>());
    if (document.is_number_integer()) return py::int_(document.template get<std::int64_t>());
    if (document.is_number()) return py::float_(document.template get<double>());
    if (document.is_string()) return py::str(document.template get<std::string>());
    return py::none();
}

std::string name_of_type(const py::handle& value) {
    return py::str(py::type::of(value).attr("__name__"));
}

[[noreturn]] void refuse_number(const std::string& name, const std::string& place,
                                const py::handle& value) {
    throw py::value_error(name + ": " + (place.empty() ? "/" : place) +
                          ": expected a finite number, got " + std::string(py::str(value)));
}

// Numbers, texts and None.
Json plain_of(const py::handle& value, const std::string& name, const std::string& place) {
    if (value.is_none()) return nullptr;
    if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
    if (py::isinstance<py::str>(value)) return value.cast<std::string>();
    if (py::isinstance<py::int_>(value)) {
        int too_large = 0;
        const auto whole = PyLong_AsLongLongAndOverflow(value.ptr(), &too_large);
        if (too_large != 0) refuse_number(name, place, value);
        return static_cast<std::int64_t>(whole);
    }
    if (py::isinstance<py::float_>(value)) {
        const auto number = value.cast<double>();
        if (!std::isfinite(number)) refuse_number(name, place, value);
        return number;
    }
    throw py::type_error(name + ": " + (place.empty() ? "/" : place) +
                         ": expected numbers, texts, lists and dicts, got " +
                         std::string(py::str(py::repr(value))) + " of type " + name_of_type(value));
}

Json document_of(const py::handle& value, const std::string& name, const std::string& place) {
    if (place.size() > 100 * kMaxJsonDepth) {
        throw py::value_error(name + ": expected a dict that does not hold itself");
    }
    if (py::isinstance<py::dict>(value)) {
        Json object = Json::object();
        for (const auto& [key, one] : value.cast<py::dict>()) {
            if (!py::isinstance<py::str>(key)) {
                throw py::type_error(name + ": " + (place.empty() ? "/" : place) +
                                     ": expected texts for keys, got " +
                                     std::string(py::str(py::repr(key))));
            }
            const auto text = key.cast<std::string>();
            object[text] = document_of(one, name, place + "/" + text);
        }
        return object;
    }
    if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
        Json array = Json::array();
        for (const py::handle one : value) {
            array.push_back(document_of(one, name, place + "/" + std::to_string(array.size())));
        }
        return array;
    }
    // NumPy's numbers and arrays stand for Python's.
    const bool is_numpy = py::hasattr(value, "tolist") && py::hasattr(value, "dtype");
    if (is_numpy) return document_of(value.attr("tolist")(), name, place);
    return plain_of(value, name, place);
}

}  // namespace

py::object python_of(const Json& document) { return any_of(document); }

py::object python_of(const nlohmann::json& document) { return any_of(document); }

Json json_of(const py::handle& document, const std::string& name) {
    return document_of(document, name, {});
}

}  // namespace tact
