// Small files that once came in wrong, or not at all: what happens to each, by which door, in which
// words. tests/golden/cases.tsv has a row a file and door: file, door, outcome, what is there, what
// is said. The files were made for this purpose; the letter before "_" is their kind.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "model/io/people/ratings_file.h"
#include "model/io/recordings/acceleration_file.h"
#include "model/io/recordings/sound_file.h"
#include "model/io/set/load.h"
#include "model/io/tables/matrix_file.h"
#include "model/text/numbers.h"
#include "tests/support/places.h"

namespace cases_test {

using namespace tact;

namespace {

namespace fs = std::filesystem;

const fs::path kCases = fs::path(kGoldenDir) / "cases";

struct Came {
    std::string outcome = "read";
    std::string what;  // numbers
    std::string said;
};

std::string joined(const std::vector<std::string>& texts) {
    std::string all;
    for (const std::string& text : texts) all += (all.empty() ? "" : "; ") + text;
    return all;
}

// Without the folder, which is this machine's.
std::string without_folder(std::string text) {
    const std::string folder = kCases.string() + "/";
    for (std::size_t at = text.find(folder); at != text.npos; at = text.find(folder)) {
        text.erase(at, folder.size());
    }
    return text;
}

Came refused(const Error& error) { return {"refused", "", without_folder(error.message)}; }

std::string length_and_peak(const Waveform& waveform) {
    return significant_digits(duration_s(waveform), 4) + " s, " +
           significant_digits(peak_g(waveform), 3) + " g";
}

Came came_as_matrix(const fs::path& file) {
    const auto read = read_matrix_file(file);
    if (!read) return refused(read.error());
    double sum = 0.0;
    for (const double value : read->dissimilarity.condensed) sum += value;
    return {"read",
            counted(read->labels.size(), "name", "names") + " from " + read->labels[0] + ", sum " +
                significant_digits(sum, 5),
            joined(read->remarks)};
}

Came came_as_ratings(const fs::path& file) {
    const auto read = read_ratings({&file, 1}, RatingScale::guess);
    if (!read) return refused(read.error());
    double sum = 0.0;
    for (const Judgement& judgement : read->study.judgements) {
        for (const double value : judgement.condensed) sum += value;
    }
    return {"read",
            counted(read->study.labels.size(), "name", "names") + " from " + read->study.labels[0] +
                ", " + counted(read->study.judgements.size(), "pass", "passes") + ", sum " +
                significant_digits(sum, 5),
            without_folder(joined(read->remarks))};
}

Came came_as_recording(const fs::path& file) {
    const auto read = read_acceleration_file(file);
    if (!read) return refused(read.error());
    return {"read", length_and_peak(read->waveform), joined(read->remarks)};
}

Came came_as_set(const fs::path& file) {
    const auto read = load_set(file);
    if (!read) return refused(read.error());
    std::string what;
    for (const Vibration& vibration : read->set.vibrations) {
        what += (what.empty() ? "" : "; ") + vibration.name + " " +
                length_and_peak(waveform_of(vibration));
    }
    std::vector<std::string> said = read->remarks;
    return {"read", what, without_folder(joined(said))};
}

Came came_by(const std::string& door, const fs::path& file) {
    if (door == "matrix") return came_as_matrix(file);
    if (door == "ratings") return came_as_ratings(file);
    if (door == "recording") return came_as_recording(file);
    REQUIRE(door == "set");
    return came_as_set(file);
}

std::vector<std::vector<std::string>> expected_rows() {
    std::ifstream stream(fs::path(kGoldenDir) / "cases.tsv");
    REQUIRE(stream.good());
    std::vector<std::vector<std::string>> rows;
    std::string line;
    std::getline(stream, line);  // names of the columns
    while (std::getline(stream, line)) {
        std::vector<std::string> cells(1);
        for (const char c : line) {
            if (c == '\t') {
                cells.emplace_back();
            } else {
                cells.back() += c;
            }
        }
        cells.resize(5);
        rows.push_back(cells);
    }
    return rows;
}

}  // namespace

TEST_CASE("cases: each file has the outcome, the numbers and the words of the table") {
    for (const auto& row : expected_rows()) {
        const Came came = came_by(row[1], kCases / row[0]);
        CHECK_MESSAGE((came.outcome == row[2] && came.what == row[3] && came.said == row[4]),
                      "now\t" << row[0] << "\t" << row[1] << "\t" << came.outcome << "\t"
                              << came.what << "\t" << came.said);
    }
}

TEST_CASE("cases: no file is without a row") {
    std::set<std::string> known;
    for (const auto& row : expected_rows()) known.insert(row[0]);
    for (const auto& entry : fs::directory_iterator(kCases)) {
        CHECK_MESSAGE(known.contains(entry.path().filename().string()), entry.path());
    }
}

}  // namespace cases_test
