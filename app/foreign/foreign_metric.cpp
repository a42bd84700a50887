#include "app/foreign/foreign.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "app/session/session.h"
#include "assets/assets.h"
#include "model/io/tables/matrix_file.h"
#include "model/text/atomic_file.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

// "mine.py:apart" as its two parts; without a function: no metric in Python.
struct PythonMetric {
    std::string file;
    std::string function;
};

PythonMetric python_metric(const std::string& from) {
    const std::size_t colon = from.rfind(".py:");
    if (colon == std::string::npos) return {};
    return {from.substr(0, colon + 3), from.substr(colon + 4)};
}

// A folder that is gone with it.
struct ScratchFolder {
    fs::path path;
    ScratchFolder() {
        std::string name = (fs::temp_directory_path() / "tactspace-metric-XXXXXX").string();
        if (mkdtemp(name.data()) != nullptr) path = name;
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder() {
        std::error_code ignored;
        if (!path.empty()) fs::remove_all(path, ignored);
    }
};

// Runs it until it ends or is stopped; 0: well. What it says goes to a file.
Expected<int> run_program(std::vector<std::string> words, const fs::path& said,
                          const std::stop_token& stop) {
    const auto process = started(std::move(words), said);
    if (!process) return process.error();
    const int status = ended(*process, stop).value_or(-1);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string last_line(const fs::path& file) {
    std::ifstream stream(file);
    std::string last;
    for (std::string line; std::getline(stream, line);) {
        if (!line.empty()) last = line;
    }
    return valid_utf8(last);
}

void write_doubles(std::ofstream& stream, const std::vector<double>& values) {
    stream.write(reinterpret_cast<const char*>(values.data()),
                 static_cast<std::streamsize>(values.size() * sizeof(double)));
}

std::vector<double> read_doubles(const fs::path& file, std::size_t count) {
    std::vector<double> values(count);
    std::ifstream stream(file, std::ios::binary);
    const auto bytes = static_cast<std::streamsize>(count * sizeof(double));
    stream.read(reinterpret_cast<char*>(values.data()), bytes);
    if (stream.gcount() != bytes) values.clear();
    return values;
}

Expected<Dissimilarity> called(const PythonMetric& metric, const std::string& from,
                               const PatternSet& set, const std::stop_token& stop) {
    if (!fs::is_regular_file(metric.file)) {
        return Error{metric.file + ": there is no such file"};
    }
    const ScratchFolder scratch;
    if (scratch.path.empty()) {
        return Error{from + ": no folder for what Python needs can be made in " +
                     fs::temp_directory_path().string()};
    }
    const fs::path samples = scratch.path / "samples";
    const fs::path answer = scratch.path / "answer";
    const fs::path said = scratch.path / "said";
    {
        std::ofstream stream(samples, std::ios::binary);
        const std::size_t longest = longest_samples(set);
        for (const Vibration& one : set.vibrations) {
            write_doubles(stream, padded(waveform_of(one), longest).samples_g);
        }
        if (!stream.flush()) return Error{samples.string() + ": could not be written"};
    }
    const std::size_t n = set.vibrations.size();
    const auto ended =
        run_program({"python3", "-c", std::string(asset("metric/call_metric.py")), metric.file,
                     metric.function, samples.string(), answer.string(),
                     std::to_string(static_cast<int>(kModelRateHz)), std::to_string(n)},
                    said, stop);
    if (!ended) return Error{from + ": " + ended.error().message};
    if (*ended != 0) {
        const std::string words = last_line(said);
        return Error{from + ": " + (words.empty() ? "python3 was stopped" : words)};
    }
    Dissimilarity matrix{n, read_doubles(answer, pair_count(n))};
    if (matrix.condensed.empty() && n > 1) return Error{from + ": python3 gave no answer"};
    return matrix;
}

}  // namespace

ForeignMetric foreign_metric(const std::string& from) {
    const PythonMetric python = python_metric(from);
    const std::string name =
        python.function.empty() ? fs::path(from).stem().string() : python.function;
    return {name + " (foreign)", from};
}

Expected<Dissimilarity> foreign_matrix(const std::string& from, const PatternSet& set,
                                       const ForeignOptions& options) {
    const PythonMetric python = python_metric(from);
    if (!python.function.empty()) return called(python, from, set, options.stop);
    const Expected<LabelledMatrix> matrix = read_matrix_file(from, options.written);
    if (!matrix) return matrix.error();
    for (const std::string& remark : matrix->remarks) {
        if (options.remark) options.remark(from + ": " + remark);
    }
    return dissimilarities_of(*matrix, names_of(set), from);
}

std::vector<std::string> functions_in(const fs::path& file) {
    const Expected<std::string> text = read_text_file(file);
    std::istringstream lines(text ? *text : std::string());
    std::vector<std::string> names;
    for (std::string line; std::getline(lines, line);) {
        const std::string_view begin = "def ";
        const std::size_t end = line.find('(');
        if (!line.starts_with(begin) || end == std::string::npos) continue;
        const std::string name = line.substr(begin.size(), end - begin.size());
        if (!name.empty() && name.front() != '_') names.push_back(name);
    }
    return names;
}

}  // namespace tact
