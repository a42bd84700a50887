#include "model/io/studies_out/psych_ds.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "model/io/studies_out/rdm_npz.h"
#include "model/study/synthetic_study.h"
#include "model/text/json_fields.h"
#include "tests/support/golden.h"

namespace psych_ds_test {

using namespace tact;

namespace {

std::vector<DatasetFile> some_files() {
    return {{"dataset_description.json",
             R"({"@context": "https://schema.org", "@type": "Dataset", "name": "n",
                 "description": "d", "variableMeasured": ["a", {"name": "b"}]})"},
            {"data/raw/task-rating_data.csv", "a,b\n1,2\n"}};
}

bool says(const std::vector<DatasetFile>& files, const std::string& words) {
    return std::ranges::any_of(psych_ds_faults(files), [&words](const std::string& fault) {
        return fault.find(words) != std::string::npos;
    });
}

}  // namespace

TEST_CASE("psych-ds: each rule of the standard is missed where it is broken, and only there") {
    CHECK(psych_ds_faults(some_files()).empty());
    auto files = some_files();
    files[1].text = "a,c\n1,2\n";
    CHECK(says(files, "description of the column c"));
    files = some_files();
    files[1].path = "data/ratings.csv";
    CHECK(says(files, "got ratings.csv"));
    CHECK(says(files, "a data file below data"));
    files = some_files();
    files[1].path = "other/task-rating_data.csv";
    CHECK(says(files, "a data file below data"));
    files = some_files();
    files[0].path = "description.json";
    CHECK(says(files, "dataset_description.json in the root"));
    for (const auto& [from, to, words] : {std::tuple{"https://schema.org", "schema", "context"},
                                          {"Dataset", "Thing", "type Dataset"},
                                          {"\"n\"", "\"\"", "name"},
                                          {"\"description\"", "\"about\"", "description"},
                                          {"variableMeasured", "variables", "variableMeasured"}}) {
        files = some_files();
        files[0].text.replace(files[0].text.find(from), std::string(from).size(), to);
        CHECK_MESSAGE(says(files, words), words);
    }
}

TEST_CASE("rdm npz: a zip of arrays, the same bytes every time") {
    RatingStudy study;
    study.labels = {"a", "b", "\xed\x95\x9c"};
    study.judgements = {{"P1", {1.0, 2.0, kNoRating}}, {"P2", {3.0, 4.0, 5.0}}};
    const std::string bytes = rdm_npz(study);
    CHECK(bytes.starts_with("PK\x03\x04"));
    CHECK(bytes == rdm_npz(study));
    for (const char* name :
         {"dissimilarities.npy", "participants.npy", "patterns.npy", "synthetic.npy"}) {
        CHECK(bytes.find(name) != std::string::npos);
    }
    CHECK(bytes.find("'shape': (2, 3)") != std::string::npos);
    study.judgements[1].condensed[2] = 6.0;
    CHECK(bytes != rdm_npz(study));
}

}  // namespace psych_ds_test
