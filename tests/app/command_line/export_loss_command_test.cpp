// What an export costs, on the command line, and predictions of what comes back.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "model/export/export_loss.h"
#include "model/export/loss_words.h"
#include "model/io/set/set_file.h"
#include "model/subset/subset.h"
#include "tests/support/five_patterns.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace export_loss_command_test {

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

// The line of a table that begins with this name.
std::string line_of(const std::string& text, const std::string& name) {
    const std::size_t at = text.find("\n" + name + "  ");
    REQUIRE(at != text.npos);
    return text.substr(at + 1, text.find('\n', at + 1) - at - 1);
}

std::vector<std::string> export_words(const tact::ShortSet& set, const std::string& out) {
    return {"export", set.path, "--format", "android-xml",
            "-k",     "3",      "--out",    (set.folder.path / out).string()};
}

}  // namespace

TEST_CASE("export command: the table and the JSON say the same of what it costs") {
    const tact::ShortSet set;
    const std::string table = output_of(export_words(set, "a"));
    std::vector<std::string> words = export_words(set, "b");
    words.emplace_back("--json");
    const Json loss = Json::parse(output_of(words)).at("loss");
    REQUIRE(loss.at("patterns").size() == 5);
    for (const Json& one : loss.at("patterns")) {
        const std::string line = line_of(table, one.at("pattern"));
        CHECK(contains(line, " " + tact::loss_number(one.at("rms_error_g"))));
        CHECK(line.ends_with(" " + tact::loss_number(one.at("moved"))));
        for (const Json& remark : one.at("remarks")) {
            CHECK(contains(table, "    " + remark.get<std::string>() + "\n"));
        }
    }
    for (const char* side : {"before", "after"}) {
        const Json& pair = loss.at("closest").at(side);
        CHECK(contains(line_of(table, "closest pair"), tact::loss_number(pair.at("dissimilarity")) +
                                                           ", " + pair.at("a").get<std::string>() +
                                                           " and " +
                                                           pair.at("b").get<std::string>()));
    }
    for (const Json& pair : loss.at("most_moved")) {
        const std::string line = line_of(
            table, pair.at("a").get<std::string>() + " and " + pair.at("b").get<std::string>());
        CHECK(line.ends_with(" " + tact::loss_number(pair.at("after"))));
    }
    const Json& subset = loss.at("subset");
    CHECK(subset.at("before").at("patterns").size() == 3);
    CHECK(contains(table, "The 3 most distinct, proven: "));
    CHECK(contains(table, "still the best for this target") == subset.at("still_best"));
    CHECK(loss.at("map").at("before").size() == 5);
}

TEST_CASE("export command: numbers are those of the library, the same on one thread") {
    const tact::ShortSet set;
    std::vector<std::string> words = export_words(set, "a");
    words.insert(words.end(), {"--json", "--threads", "1"});
    const Json loss = Json::parse(output_of(words)).at("loss");
    const auto loaded = tact::read_set_file(set.path);
    REQUIRE(loaded);
    tact::ExportLossOptions options;
    options.subset_count = 3;
    const auto meant =
        tact::export_loss(loaded->set, tact::own_target(tact::TargetFormat::android_xml), options);
    CHECK(loss.at("before") == Json(meant->before.condensed));
    CHECK(loss.at("after") == Json(meant->after.condensed));
    CHECK(loss.at("subset").at("still_best") == meant->subset->is_still_best);
}

TEST_CASE("export command: without the loss the files are the same") {
    const tact::ShortSet set;
    (void)output_of(export_words(set, "a"));
    std::vector<std::string> words = export_words(set, "b");
    words.erase(words.begin() + 4, words.begin() + 6);
    words.emplace_back("--no-loss");
    const std::string table = output_of(words);
    CHECK_FALSE(contains(table, "PM"));
    for (const auto& file : fs::directory_iterator(set.folder.path / "b")) {
        CAPTURE(file.path());
        CHECK(bytes_of(file.path()) == bytes_of(set.folder.path / "a" / file.path().filename()));
    }
    words.insert(words.end(), {"-k", "3"});
    CHECK(run_program(words).exit_code != 0);
}

TEST_CASE("--exported-as: predict, space and subset are of what comes back, and say so") {
    const tact::ShortSet set;
    const auto loaded = tact::read_set_file(set.path);
    const auto target = tact::export_target_named("haptic:console-pcm");
    const auto exported = tact::exported_set(loaded->set, *target);
    const auto prediction = tact::predict(tact::model_waveforms(exported->back), {});
    const Ran ran =
        run_program({"predict", set.path, "--exported-as", "haptic:console-pcm", "--json"});
    REQUIRE(ran.exit_code == 0);
    CHECK(Json::parse(ran.out).at("condensed") == Json(prediction->pm.condensed));
    CHECK(contains(ran.err, "the patterns as Meta .haptic for console-pcm holds them: "));
    CHECK(contains(ran.err, "is assumed: nobody publishes it"));
    CHECK(output_of({"space", set.path, "--exported-as", "haptic:console-pcm"}) !=
          output_of({"space", set.path}));
    std::vector<std::string> words{"subset", set.path,        "-k",
                                   "2",      "--exported-as", "haptic:console-pcm"};
    CHECK(output_of(words).starts_with("the patterns as Meta .haptic for console-pcm holds"));
    words.emplace_back("--json");
    const Json subset = Json::parse(output_of(words));
    CHECK(subset.at("exported_as") == "haptic");
    CHECK(subset.at("exported_onto") == "console-pcm");
    CHECK(contains(subset.at("exported_onto_source").get<std::string>(), "nobody publishes it"));
    const tact::SubsetAnswer best =
        *tact::most_distinct_subset(prediction->pm, {2, tact::SubsetObjective::max_min});
    CHECK(subset.at("weakest").at("dissimilarity") == best.best.weakest_dissimilarity);
}

TEST_CASE("--exported-as: a device plays what comes back, and both are said") {
    const tact::ShortSet set;
    const std::vector<std::string> words{
        "subset", set.path,        "-k",      "2",     "--exported-as",
        "hjif",   "--rendered-by", "joy-con", "--json"};
    const Json both = Json::parse(output_of(words));
    CHECK(both.at("exported_as") == "hjif");
    CHECK(both.at("rendered_by") == "joy-con");
    std::vector<std::string> text(words.begin(), words.end() - 1);
    const std::string out = output_of(text);
    CHECK(contains(out, "the patterns as MPEG HJIF for mpeg holds them: "));
    CHECK(contains(out, "the patterns as a Joy-Con plays them"));
}

TEST_CASE("--exported-as: compare holds what comes back against people, and says so") {
    const tact::ShortSet set;
    const std::string ratings =
        set.folder.write("mean.csv", output_of({"predict", set.path, "--metric", "nc"})).string();
    std::vector<std::string> words{"compare",  set.path, "--ratings",     ratings,
                                   "--metric", "nc",     "--exported-as", "hla"};
    CHECK(contains(output_of(words), "\nthe patterns as Hapticlabs .hla for android holds"));
    words.emplace_back("--json");
    const Json row = Json::parse(output_of(words)).at(0);
    CHECK(row.at("exported_as") == "hla");
    CHECK(row.at("rho") < 1.0);
}

TEST_CASE("--exported-as: what is no format, no actuator or no metric is refused") {
    const tact::ShortSet set;
    CHECK(contains(refusal_of({"predict", set.path, "--exported-as", "mp3"}),
                   "--exported-as: \"mp3\": expected a format that is written, one of haptic"));
    CHECK(contains(refusal_of({"space", set.path, "--exported-as", "ahap:no-such"}), "no-such"));
    CHECK(contains(
        refusal_of({"subset", set.path, "-k", "2", "--exported-as", "ahap", "--matrix", set.path}),
        "--exported-as is for a metric"));
}

}  // namespace export_loss_command_test
