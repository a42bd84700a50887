#include "app/python/parts.h"

#include <cerrno>
#include <system_error>

#include "model/signal/resample.h"
#include "model/text/numbers.h"

namespace tact {

namespace py = pybind11;

namespace {

[[noreturn]] void refuse_type(const std::string& name, const char* expected,
                              const py::handle& value) {
    PyErr_Clear();
    throw py::type_error(name + ": expected " + expected + ", got " + described(value));
}

double number_in(const py::handle& value, const std::string& name) {
    const double number = PyFloat_AsDouble(value.ptr());
    if (PyErr_Occurred() != nullptr) refuse_type(name, "a number", value);
    return number;
}

// What has more digits than fit is far outside of every range.
std::int64_t whole_in(const py::handle& value, const std::string& name) {
    const auto whole = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
    if (!whole) refuse_type(name, "a whole number", value);
    int too_large = 0;
    const auto number = PyLong_AsLongLongAndOverflow(whole.ptr(), &too_large);
    constexpr std::int64_t kBeyond = std::int64_t{1} << 62;
    return too_large == 0 ? static_cast<std::int64_t>(number) : too_large * kBeyond;
}

py::list elements_of(const py::object& value, const std::string& name, const char* expected) {
    if (py::isinstance<py::str>(value)) refuse_type(name, expected, value);
    auto list = py::reinterpret_steal<py::object>(PySequence_List(value.ptr()));
    if (!list) refuse_type(name, expected, value);
    return py::reinterpret_steal<py::list>(list.release());
}

double checked(double number, const std::string& name, Range range) {
    if (range.contains(number)) return number;
    throw py::value_error(name + ": expected " + shortest_digits(range.low) + " to " +
                          shortest_digits(range.high) + ", got " + shortest_digits(number));
}

// What the system says of a file, as model/text/atomic_file.h and those who make folders put it.
constexpr int kRefusals[] = {ENOENT, EACCES, EPERM, EISDIR, ENOTDIR, EEXIST,
                             ENOSPC, EROFS,  EIO,   EBUSY,  ELOOP,   ENAMETOOLONG};

struct Refused {
    int number = 0;
    std::string reason;
    std::string file;
};

std::optional<Refused> refused_by_system(const std::string& message) {
    for (const char* kind : {": is a folder, expected a file", ": there is no such file"}) {
        const std::string_view words(kind);
        if (!message.ends_with(words)) continue;
        return Refused{words.starts_with(": is") ? EISDIR : ENOENT, std::string(words.substr(2)),
                       message.substr(0, message.size() - words.size())};
    }
    const std::size_t verb = message.find(": cannot be ");
    if (verb == std::string::npos) return std::nullopt;
    for (const int number : kRefusals) {
        if (!message.ends_with(": " + std::generic_category().message(number))) continue;
        return Refused{number, message.substr(verb + 2), message.substr(0, verb)};
    }
    return std::nullopt;
}

}  // namespace

std::string described(const py::handle& value) {
    constexpr std::size_t kMostLetters = 60;
    std::string text = py::str(py::repr(value));
    if (text.size() > kMostLetters) return std::string(py::str(py::type::of(value)));
    return text + " of type " + std::string(py::str(py::type::of(value).attr("__name__")));
}

double within(const py::object& value, const std::string& name, Range range) {
    return checked(number_in(value, name), name, range);
}

int whole_within(const py::object& value, const std::string& name, Range range) {
    return static_cast<int>(checked(static_cast<double>(whole_in(value, name)), name, range));
}

std::optional<double> optional_within(const py::object& value, const std::string& name,
                                      Range range) {
    return value.is_none() ? std::nullopt : std::optional(within(value, name, range));
}

int threads_of(const py::object& threads) { return whole_within(threads, "threads", {0, 1024}); }

double rate_of(const py::object& rate_hz) {
    return within(rate_hz, "rate_hz", {kLowestRateHz, kHighestRateHz});
}

std::vector<int> wholes_within(const py::object& values, const std::string& name, Range range) {
    std::vector<int> result;
    for (const py::handle one : elements_of(values, name, "a list of whole numbers")) {
        result.push_back(whole_within(py::reinterpret_borrow<py::object>(one),
                                      name + "[" + std::to_string(result.size()) + "]", range));
    }
    return result;
}

std::vector<std::size_t> places_of(const py::object& places, const std::string& name,
                                   std::size_t count) {
    std::vector<std::size_t> result;
    for (const py::handle one : elements_of(places, name, "a list of places")) {
        const std::int64_t place = whole_in(one, name + "[" + std::to_string(result.size()) + "]");
        if (place < 0 || place >= static_cast<std::int64_t>(count)) {
            throw py::value_error(name + ": expected places 0 to " + std::to_string(count - 1) +
                                  ", got " + std::to_string(place));
        }
        result.push_back(static_cast<std::size_t>(place));
    }
    return result;
}

std::string text_in(const py::handle& value, const std::string& name) {
    if (!py::isinstance<py::str>(value)) refuse_type(name, "a text", value);
    return value.cast<std::string>();
}

// R makes one name a text, not a list of texts.
std::vector<std::string> texts_in(const py::object& value, const std::string& name) {
    if (py::isinstance<py::str>(value)) return {value.cast<std::string>()};
    std::vector<std::string> texts;
    for (const py::handle one : elements_of(value, name, "a list of texts")) {
        texts.push_back(text_in(one, name + "[" + std::to_string(texts.size()) + "]"));
    }
    return texts;
}

std::size_t choice_of(const py::object& text, const std::string& name,
                      std::span<const char* const> choices) {
    const std::string given = text_in(text, name);
    std::string expected;
    for (std::size_t k = 0; k < choices.size(); ++k) {
        if (given == choices[k]) return k;
        expected += (k == 0 ? "\"" : ", \"") + std::string(choices[k]) + "\"";
    }
    throw py::value_error(name + ": expected one of " + expected + ", got \"" + given + "\"");
}

std::filesystem::path path_in(const py::handle& value, const std::string& name) {
    PyObject* bytes = nullptr;
    if (PyUnicode_FSConverter(value.ptr(), &bytes) == 0) {
        if (PyErr_ExceptionMatches(PyExc_TypeError) == 0) throw py::error_already_set();
        refuse_type(name, "a text or a path", value);
    }
    return std::string(py::reinterpret_steal<py::bytes>(bytes));
}

void throw_error(const std::string& message) {
    const std::optional<Refused> refused = refused_by_system(message);
    if (!refused) throw py::value_error(message);
    const py::str file = py::reinterpret_steal<py::str>(PyUnicode_DecodeFSDefaultAndSize(
        refused->file.data(), static_cast<py::ssize_t>(refused->file.size())));
    // An instance: OSError itself chooses its kind, and pybind11 wants no other type than it was
    // told.
    const py::object error = py::handle(PyExc_OSError)(refused->number, refused->reason, file);
    PyErr_SetObject(py::type::of(error).ptr(), error.ptr());
    throw py::error_already_set();
}

}  // namespace tact
