// Values of Python and of the model, both ways.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include "model/common/expected.h"
#include "model/common/units.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/io/set/load.h"
#include "model/perceptual_model/perceptual_model_params.h"
#include "model/set/pattern_set.h"
#include "model/signal/waveform.h"
#include "model/study/ratings.h"
#include "model/text/json_fields.h"

namespace tact {

// Work of the model while Python continues: its other threads run meanwhile, Ctrl+C stops it, and a
// function of Python is told how far it is.
//
// Python tells of signals only who asks, and only its main thread: the thread that called asks
// every few hundredths of a second, on behalf of the one that works.

// Says that the interpreter ends, for its atexit: until this returns, who was about to take the
// lock back has it. Later the interpreter would end such a thread in the middle of our frames.
// Work that was left alone comes to its end first, unless a signal's handler raises.
void end_beside_python();

// Takes the interpreter's lock back for this thread; false, and without it, if the interpreter ends
// and the thread is not the one that ends it.
bool take_lock_back(PyThreadState* own);

// How far the work is, for a function of Python: tell(share from 0 to 1, what is done). The work
// calls for_work(), from any thread; who called asks tell_if_new(), with the lock.
class Progress {
  public:
    // None: nobody is told.
    explicit Progress(pybind11::object tell);
    std::function<void(double)> for_work(const char* what) const;
    void tell_if_new();

  private:
    struct Reached {
        std::atomic<double> share = 0.0;
        std::atomic<const char*> what = nullptr;
    };
    pybind11::object tell_;
    std::shared_ptr<Reached> reached_ = std::make_shared<Reached>();
    double told_share_ = -1.0;
    const char* told_what_ = nullptr;
};

// Joins the thread in another one, and counts it until then.
void leave_alone(std::jthread worker);

// Parks a thread that the interpreter no longer waits for. Its work is stopped, and it sleeps until
// the process is over.
template <class Answer>
void stay_behind(std::jthread& worker, std::future<Answer>& answer) {
    worker.request_stop();
    answer.wait();
    for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
}

// Work on a thread of its own.
template <class Answer>
struct Running {
    std::future<Answer> answer;
    std::jthread worker;

    // Whether it comes to its end within some hundredths of a second, in which Python continues.
    bool ends_soon() {
        PyThreadState* const own = PyEval_SaveThread();
        const bool done =
            answer.wait_for(std::chrono::milliseconds(20)) == std::future_status::ready;
        if (!take_lock_back(own)) stay_behind(worker, answer);
        return done;
    }

    // Until its end, or throws what a signal's handler or `progress` raised.
    void wait(Progress* progress) {
        while (!ends_soon()) {
            if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
            if (progress != nullptr) progress->tell_if_new();
        }
        if (progress != nullptr) progress->tell_if_new();
    }
};

template <class Work>
auto begun(Work work) {
    using Answer = std::invoke_result_t<Work, std::stop_token>;
    std::packaged_task<Answer(std::stop_token)> task(std::move(work));
    std::future<Answer> answer = task.get_future();
    return Running<Answer>{std::move(answer), std::jthread(std::move(task))};
}

// What work(stop_token) returns, or throws. `work` must not touch Python. Where a signal's handler
// raises (KeyboardInterrupt), or the function that is told of progress, the work is stopped, waited
// for, and that is thrown instead.
template <class Work>
auto beside_python(Work work, Progress* progress = nullptr) {
    auto running = begun(std::move(work));
    try {
        running.wait(progress);
    } catch (...) {
        running.worker.request_stop();
        while (!running.ends_soon()) continue;
        throw;
    }
    return running.answer.get();
}

// The same of work that may take seconds to heed a stop, and so must own all that it uses: it is
// waited for a moment, then left alone, and what it finds is dropped.
template <class Work>
auto beside_python_or_alone(Work work, Progress* progress = nullptr) {
    auto running = begun(std::move(work));
    try {
        running.wait(progress);
    } catch (...) {
        running.worker.request_stop();
        constexpr int kPatience = 10;
        for (int k = 0; k < kPatience; ++k) {
            if (running.ends_soon()) throw;
        }
        leave_alone(std::move(running.worker));
        throw;
    }
    return running.answer.get();
}

// Dicts that Python hands over as parts of a set: models, patterns, ratings; and ratings as a dict.
//
// Input     the keys of a set file, or those that read_ratings() gives
// Output    TypeError where the type is wrong, else ValueError: "NAME: expected .., got .."
// Valid     to be called with the interpreter's lock held

pybind11::dict dict_in(const pybind11::handle& value, const std::string& name);
// A list of them, "NAME[0]" and so on.
std::vector<pybind11::dict> dicts_in(const pybind11::object& value, const std::string& name);

// None: the defaults.
PerceptualModelParams model_of(const pybind11::object& model);
// With the keys of a set file for its origin, which model_of() passes over.
pybind11::dict python_of(const PerceptualModelParams& model, const ModelOrigin& origin);
ModelOrigin origin_in(const pybind11::object& model);
VibrationSource pattern_of(const pybind11::handle& pattern, const std::string& name = "pattern");

// What read_ratings() gives; or dissimilarities, as of one voice.
RatingStudy study_of(const pybind11::object& ratings);
pybind11::dict python_of(const RatingStudy& study);

// Documents of the model as dicts, and dicts as documents: what a set file has for a pattern or a
// model, and what the command line prints behind --json.
//
// Input     dicts with texts for keys, lists, tuples, arrays, texts, numbers of Python and NumPy
// Output    NaN stays NaN, a number without a point an int. Errors name the place:
//           "model: /nc_weight: expected .., got ..", as TypeError where the type is wrong
// Valid     to be called with the interpreter's lock held

pybind11::object python_of(const Json& document);
pybind11::object python_of(const nlohmann::json& document);

Json json_of(const pybind11::handle& document, const std::string& name);

// The functions of the module that take what people said, patterns and files, or write them
// (help.h).
//
// Output    TypeError where the type is wrong, else ValueError: "NAME: expected .., got .."

pybind11::dict compare(const pybind11::object& matrix, const pybind11::object& ratings,
                       const pybind11::object& metric, const pybind11::object& threads,
                       const pybind11::object& given, const pybind11::object& progress);

pybind11::dict paper(const pybind11::object& given, const pybind11::object& threads,
                     const pybind11::object& progress);

pybind11::dict plan_study(const pybind11::object& matrix, const pybind11::object& rival,
                          const pybind11::object& people, const pybind11::object& rho,
                          const pybind11::object& reliability, const pybind11::object& pilot,
                          const pybind11::object& pairs, const pybind11::object& studies,
                          const pybind11::object& seed, const pybind11::object& threads,
                          const pybind11::object& progress);

pybind11::dict train_sets(const pybind11::object& given, const pybind11::object& objective,
                          const pybind11::object& step, const pybind11::object& leave_out,
                          const pybind11::object& rate_hz, const pybind11::object& threads,
                          pybind11::object model, const pybind11::object& progress);

pybind11::array render_pattern(const pybind11::object& pattern, const pybind11::object& rate_hz);

pybind11::object edit_pattern(const pybind11::object& pattern, const pybind11::object& edits,
                              const pybind11::object& model);

pybind11::dict separate(const pybind11::object& given, const pybind11::object& pair,
                        const pybind11::object& change, const pybind11::object& among,
                        const pybind11::object& closest, const pybind11::object& threshold,
                        const pybind11::object& threads, const pybind11::object& progress);

pybind11::dict report(const pybind11::object& given, const pybind11::object& count,
                      const pybind11::object& closer_than, const pybind11::object& include_unfelt,
                      const pybind11::object& threads, const pybind11::object& time_limit_s,
                      const pybind11::object& progress);

pybind11::dict steps(const pybind11::object& given, const pybind11::object& start,
                     const pybind11::object& end, const pybind11::object& count,
                     const pybind11::object& parameter, const pybind11::object& metric,
                     const pybind11::object& threads, const pybind11::object& progress);

pybind11::dict groups(const pybind11::object& given, const pybind11::object& count,
                      const pybind11::object& cut, const pybind11::object& threads,
                      const pybind11::object& progress);

pybind11::dict export_set(const pybind11::object& given, const pybind11::object& folder,
                          const pybind11::object& format, const pybind11::object& patterns,
                          const pybind11::object& onto, const pybind11::object& rate_hz,
                          const pybind11::object& bits, const pybind11::object& count,
                          const pybind11::object& loss, const pybind11::object& overwrite,
                          const pybind11::object& threads, const pybind11::object& progress);

pybind11::dict read_set(const pybind11::object& path, const pybind11::object& actuator,
                        const pybind11::object& progress);

void write_set(const pybind11::object& path, const pybind11::object& set);

pybind11::dict read_ratings_file(const pybind11::object& path, const pybind11::object& names,
                                 const pybind11::object& scale);

// Numbers, texts and paths that Python hands over.
//
// Output    TypeError where the type is wrong, else ValueError: "NAME: expected .., got .."
// Valid     to be called with the interpreter's lock held

// "2.5 of type float": what was got, for a TypeError.
std::string described(const pybind11::handle& value);

// The number, if it may have this value. Whole ones are Python's and NumPy's integers.
double within(const pybind11::object& value, const std::string& name, Range range);
int whole_within(const pybind11::object& value, const std::string& name, Range range);
std::vector<int> wholes_within(const pybind11::object& values, const std::string& name,
                               Range range);
std::optional<double> optional_within(const pybind11::object& value, const std::string& name,
                                      Range range);

int threads_of(const pybind11::object& threads);
double rate_of(const pybind11::object& rate_hz);

// Whole numbers of a list, a range or an array, each below `count`: places of objects.
std::vector<std::size_t> places_of(const pybind11::object& places, const std::string& name,
                                   std::size_t count);

std::string text_in(const pybind11::handle& value, const std::string& name);
// A list of texts, or a single one.
std::vector<std::string> texts_in(const pybind11::object& value, const std::string& name);

// Position of the text among the choices.
std::size_t choice_of(const pybind11::object& text, const std::string& name,
                      std::span<const char* const> choices);

std::filesystem::path path_in(const pybind11::handle& value, const std::string& name);

// Throws an OSError of its kind (FileNotFoundError, PermissionError ..) if the system refused a
// file, with errno and the file's name; a ValueError otherwise.
[[noreturn]] void throw_error(const std::string& message);

template <class Value>
Value value_of(Expected<Value> expected) {
    if (!expected) throw_error(expected.error().message);
    return *std::move(expected);
}

// Sets as dicts: what read_set() gives, and what write_set() and others take.
//
// Output    TypeError where the type is wrong, else ValueError: "NAME: expected .., got .."
// Valid     to be called with the interpreter's lock held

// With the whole set file behind "document", without samples.
pybind11::dict dict_of(const Loaded& loaded);

// Names, patterns, waves of recordings, model, ratings, locked and dropped of the dict; all else of
// its "document", each pattern's by the name. Recordings have no file yet. Left out: layers that
// are recordings, which are refused.
PatternSet pattern_set_of(const pybind11::object& set);

// The pattern of this name, or at this place.
std::size_t place_in(const pybind11::object& pattern, const PatternSet& set,
                     const std::string& name);

// Arrays that Python hands over as values of the model, and values of the model as arrays.
//
// Input     arrays: anything that NumPy makes an array of real numbers, of any type, order and
//           stride. Distances of all pairs: a square, or condensed as SciPy's squareform has it,
//           (0,1),(0,2)..(0,n-1),(1,2)..
// Output    TypeError where the type is wrong, else ValueError: "NAME: expected .., got .."
// Valid     to be called with the interpreter's lock held

using Numbers = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

// Whatever NumPy would have cast in silence (complex numbers, texts) is a TypeError.
Numbers numbers_of(const pybind11::object& object, const std::string& name);
std::string shape_of(const pybind11::array& array);

// Samples in g at this rate: of one, and of the rows of an array or the elements of a list.
Waveform wave_of(const pybind11::object& wave, const std::string& name, double rate_hz);
std::vector<Waveform> waves_of(const pybind11::object& waves, double rate_hz);
// Those that a stop came before keep their rate.
std::vector<Waveform> at_model_rate(std::vector<Waveform> waves, const std::stop_token& stop);

// NaN: not known. At least two objects.
Dissimilarity dissimilarities_of(const pybind11::object& matrix, const std::string& name);

pybind11::array_t<double> array_of(std::span<const double> numbers);
pybind11::array_t<int> array_of(std::span<const int> numbers);
pybind11::array_t<double> array_of(const Eigen::MatrixXd& matrix);
pybind11::array_t<double> square_array(const Dissimilarity& dissimilarity);

// A UserWarning, unless there is nothing to say.
void warn(const std::string& sentence);

}  // namespace tact
