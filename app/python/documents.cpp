#include "app/python/parts.h"

#include <nlohmann/json.hpp>

#include <cmath>

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

namespace {

// Shared by this process: an interpreter ends once.
std::atomic<bool> is_ending = false;
std::atomic<std::thread::id> ends_it;
std::atomic<int> takers = 0;      // threads that have looked, and do not have the lock yet
std::atomic<int> left_alone = 0;  // works that nobody waits for

}  // namespace

void end_beside_python() {
    ends_it = std::this_thread::get_id();
    is_ending = true;
    const auto rest = [] {
        const pybind11::gil_scoped_release others_go_on;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    };
    while (takers > 0) rest();
    // The end of the process takes away what such a work still uses.
    while (left_alone > 0) {
        rest();
        if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
    }
}

bool take_lock_back(PyThreadState* own) {
    ++takers;
    if (is_ending && ends_it.load() != std::this_thread::get_id()) {
        --takers;
        return false;
    }
    PyEval_RestoreThread(own);
    --takers;
    return true;
}

void leave_alone(std::jthread worker) {
    ++left_alone;
    std::thread([worker = std::move(worker)]() mutable {
        worker.join();
        --left_alone;
    }).detach();
}

Progress::Progress(pybind11::object tell) : tell_(std::move(tell)) {
    if (tell_.is_none() || PyCallable_Check(tell_.ptr()) != 0) return;
    throw pybind11::type_error(
        "progress: expected a function of (share, text), True or None, got " +
        std::string(pybind11::str(pybind11::repr(tell_))));
}

std::function<void(double)> Progress::for_work(const char* what) const {
    if (tell_.is_none()) return {};
    return [reached = reached_, what](double share) {
        reached->share = share;
        reached->what = what;
    };
}

void Progress::tell_if_new() {
    const double share = reached_->share;
    const char* const what = reached_->what;
    if (what == nullptr || (share == told_share_ && what == told_what_)) return;
    told_share_ = share;
    told_what_ = what;
    tell_(share, what);
}

}  // namespace tact
