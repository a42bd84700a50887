// One weakest pair has one number, whoever tells it: the matrix, the subset, the report, the
// export.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "model/export/loss_words.h"
#include "model/text/numbers.h"
#include "tests/support/five_patterns.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace weakest_pair_test {

using Json = nlohmann::json;

namespace {

std::string in_matrix(const std::string& path, const Json& pair) {
    const auto rows = cells_of(output_of({"predict", path}));
    const auto column_of = [&](const Json& name) {
        const auto at = std::ranges::find(rows.front(), name.get<std::string>());
        REQUIRE(at != rows.front().end());
        return static_cast<std::size_t>(at - rows.front().begin());
    };
    return rows[column_of(pair.at("a"))][column_of(pair.at("b"))];
}

std::string text_of(const std::string& path) { return bytes_of(path); }

}  // namespace

TEST_CASE("weakest pair: matrix, subset, report and every export tell one number of it" *
          doctest::test_suite("long")) {
    const tact::ShortSet set;
    const Json subset = Json::parse(output_of({"subset", set.path, "-k", "3", "--json"}));
    const Json weakest = subset.at("weakest");
    const double number = weakest.at("dissimilarity");
    CHECK(tact::shortest_digits(number) == in_matrix(set.path, weakest));
    const std::string shown = tact::loss_number(number);
    const std::string table = output_of({"subset", set.path, "-k", "3"});
    CHECK(contains(table, "weakest pair  " + tact::significant_digits(number, 6)));
    const std::string page = (set.folder.path / "page.html").string();
    output_of({"report", set.path, "-k", "3", "--out", page});
    CHECK(contains(text_of(page), "<b>PM " + shown + "</b>"));
    for (const char* format : {"ahap", "android-xml", "wav"}) {
        CAPTURE(format);
        const std::string out = (set.folder.path / format).string();
        std::vector<std::string> words{"export", set.path, "--format", format,
                                       "-k",     "3",      "--out",    out};
        const std::string said = output_of(words);
        CHECK(contains(said, shown + ", " + weakest.at("a").get<std::string>() + " and " +
                                 weakest.at("b").get<std::string>()));
        words.emplace_back("--json");
        words[7] += "2";
        const Json loss = Json::parse(output_of(words)).at("loss").at("subset");
        CHECK(loss.at("before").at("weakest") == weakest);
        // What is not on the scale of the set stands under a name that says so.
        CHECK_FALSE(loss.contains("best"));
    }
}

}  // namespace weakest_pair_test
