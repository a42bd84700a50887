// What is printed is what is ranked: whoever ranks the numbers of a matrix file again gets the
// program's ranks, and so its Spearman correlations.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <sstream>

#include "model/dissimilarity/correlation.h"
#include "model/evaluation/metric_comparison.h"
#include "model/io/set/set_file.h"
#include "model/io/tables/matrix_file.h"
#include "tests/support/places.h"

namespace printed_ranks_test {

using namespace tact;

namespace {

// Mid-ranks of exact values, as any other program makes them.
std::vector<double> plain_ranks(const std::vector<double>& values) {
    std::vector<double> ranks;
    for (const double value : values) {
        const auto less = std::ranges::count_if(values, [&](double x) { return x < value; });
        const auto same = std::ranges::count(values, value);
        ranks.push_back(static_cast<double>(less) + 0.5 * static_cast<double>(same + 1));
    }
    return ranks;
}

double pearson(const std::vector<double>& a, const std::vector<double>& b) {
    const auto mean = [](const std::vector<double>& x) {
        return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
    };
    double both = 0.0;
    double of_a = 0.0;
    double of_b = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        const double da = a[k] - mean(a);
        const double db = b[k] - mean(b);
        both += da * db;
        of_a += da * da;
        of_b += db * db;
    }
    return both / std::sqrt(of_a * of_b);
}

// As a file holds it.
std::vector<double> printed(const PatternSet& set, Metric metric) {
    std::vector<Waveform> waveforms;
    std::vector<std::string> names;
    for (const Vibration& one : set.vibrations) {
        waveforms.push_back(waveform_of(one));
        names.push_back(one.name);
    }
    const auto matrix = metric_matrix(metric, waveforms, set.model);
    REQUIRE(matrix);
    std::ostringstream text;
    write_matrix_csv(text, names, as_ranked(metric, *matrix));
    const auto read = parse_matrix(text.str(), "printed.csv");
    REQUIRE(read);
    return read->dissimilarity.condensed;
}

PatternSet first_of(PatternSet set, std::size_t most) {
    set.vibrations.resize(std::min(set.vibrations.size(), most));
    return set;
}

bool is_slow(Metric metric) {
    return metric == Metric::dtw || metric == Metric::oc || metric == Metric::no_physiology ||
           metric == Metric::pm || metric == Metric::nc;
}

void check_set(const PatternSet& set, const std::vector<Metric>& metrics) {
    const auto compared = compared_matrices(set, metrics, nullptr, {});
    REQUIRE(compared);
    for (std::size_t m = 0; m < metrics.size(); ++m) {
        CAPTURE(std::string(traits(metrics[m]).key));
        const std::vector<double> file = printed(set, metrics[m]);
        CHECK(plain_ranks(file) == average_ranks((*compared)[m].condensed));
        // Ratings of nobody, with ties.
        std::vector<double> ratings;
        for (std::size_t k = 0; k < file.size(); ++k) {
            ratings.push_back(static_cast<double>(k * 7 % 5));
        }
        const double own = spearman((*compared)[m].condensed, ratings);
        const double theirs = pearson(plain_ranks(file), plain_ranks(ratings));
        CHECK(std::isnan(own) == std::isnan(theirs));
        if (!std::isnan(own)) CHECK(own == doctest::Approx(theirs).epsilon(1e-12));
    }
}

}  // namespace

TEST_CASE("printed: ranks of the printed numbers are the program's, of every metric and set" *
          doctest::test_suite("long")) {
    std::vector<Metric> quick;
    std::vector<Metric> slow;
    for (const Metric metric : kMetrics) (is_slow(metric) ? slow : quick).push_back(metric);
    CHECK(quick.size() + slow.size() == kMetricCount);
    std::size_t sets = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(kAssetsDir) + "/sets")) {
        if (!entry.path().string().ends_with(".tactspace.json")) continue;
        CAPTURE(entry.path().string());
        const auto loaded = read_set_file(entry.path());
        REQUIRE(loaded);
        check_set(loaded->set, quick);
        check_set(first_of(loaded->set, 4), slow);
        ++sets;
    }
    CHECK(sets >= 10);
}

}  // namespace printed_ranks_test
