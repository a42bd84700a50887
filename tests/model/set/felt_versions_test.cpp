#include "model/set/felt_versions.h"

#include <doctest/doctest.h>

#include "model/io/set/set_file.h"
#include "model/set/measured_twin.h"
#include "model/set/set_ratings.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/three_tones.h"

namespace felt_versions_test {

using namespace tact;

namespace {

using Names = std::vector<std::string>;

PatternSet four() {
    PatternSet set;
    set.duration_s = 0.1;
    for (const char* name : {"a", "b", "c", "d"}) {
        set.vibrations.push_back(named_tone(name, 100.0 + 30.0 * (name[0] - 'a')));
    }
    return set;
}

RatingStudy said_of(const PatternSet& set) {
    return {names_of(set), true, {{"P1", {1, 2, 3, 4, 5, 6}}, {"P2", {2, 2, 3, 4, 5, 5}}}};
}

// Rated in the versions that it has.
PatternSet rated() {
    PatternSet set = four();
    set.ratings = kept_ratings(said_of(set), "people.csv");
    note_versions(set.ratings, said_of(set), set);
    return set;
}

Pattern& pattern(PatternSet& set, std::size_t k) {
    return std::get<Pattern>(set.vibrations[k].source);
}

}  // namespace

TEST_CASE("felt versions: whatever changes a sample is another version, and nothing else is") {
    const Vibration felt = named_tone("a", 150.0);
    Vibration looks = felt;
    looks.name = "b";
    looks.colour = "#123456";
    looks.note = "soft";
    looks.locked = true;
    CHECK(version_of(looks) == version_of(felt));
    const auto is_another = [&felt](const auto& change) {
        Vibration edited = felt;
        change(std::get<Pattern>(edited.source));
        return version_of(edited) != version_of(felt);
    };
    CHECK(is_another([](Pattern& p) { p.amplitude_g *= 1.0001; }));
    CHECK(is_another([](Pattern& p) { p.duration_s += 0.001; }));
    CHECK(is_another([](Pattern& p) { p.carriers[0].frequency_hz += 0.01; }));
    CHECK(is_another([](Pattern& p) { p.modulation.frequency_hz = 7.0; }));
}

TEST_CASE("felt versions: an edited pattern, one that is gone and their twins are told by name") {
    PatternSet set = rated();
    insert_twin(set, synthetic_twin(set.vibrations[0], {}).vibration);  // "a synthetic", behind it
    insert_twin(set, synthetic_twin(set.vibrations[4], {}).vibration);  // of d
    CHECK(stale_patterns(set) == StalePatterns{});
    const PatternSet before = set;
    pattern(set, 0).amplitude_g *= 0.5;
    set.vibrations.erase(set.vibrations.begin() + 4);
    const StalePatterns stale = stale_patterns(set);
    CHECK(stale.edited == Names{"a"});
    CHECK(stale.gone == Names{"d"});
    CHECK(stale.unrecorded.empty());
    CHECK(stale.twins == Names{"a synthetic"});
    CHECK(stale.lone_twins == Names{"d synthetic"});
    CHECK(words_on_twin(stale, "a synthetic") == ", which was edited since");
    CHECK(words_on_twin(stale, "d synthetic") == ", which is no longer in the set");
    // The rest continues with what is there.
    const auto study = study_of(set);
    REQUIRE(study);
    CHECK(study->gone == Names{"d"});
    CHECK(study->edited == Names{"a"});
    CHECK(mark_of(*study) == NumberMark{.stale = true});
    CHECK(mean_ratings(*study)(0, 2) == doctest::Approx(1.5));
    CHECK(words_on_gone(study->gone) == "1 rated pattern is not in the set, and left out: \"d\"");
    // As it was, it is what was felt.
    pattern(set, 0).amplitude_g = std::get<Pattern>(before.vibrations[0].source).amplitude_g;
    CHECK(stale_patterns(set).edited.empty());
    CHECK(stale_patterns(set).twins.empty());
}

TEST_CASE("felt versions: of a file of before the first edit keeps what was there until then") {
    PatternSet old = four();
    old.ratings = kept_ratings(said_of(old), "people.csv");
    CHECK(stale_patterns(old).edited.empty());
    CHECK(stale_patterns(old).unrecorded == names_of(old));
    PatternSet edited = old;
    edited.vibrations[2].note = "no other samples";
    keep_versions(old, edited);
    CHECK(edited.ratings[0].versions.empty());
    pattern(edited, 1).amplitude_g *= 2.0;
    keep_versions(old, edited);
    CHECK(stale_patterns(edited).edited == Names{"b"});
    CHECK(stale_patterns(edited).unrecorded == Names{"a", "c", "d"});
    PatternSet again = edited;
    pattern(again, 1).amplitude_g *= 2.0;
    keep_versions(edited, again);  // the version that was felt stays that
    CHECK(again.ratings[0].versions == edited.ratings[0].versions);
    // A twin of before likewise.
    PatternSet twins = four();
    Vibration twin = synthetic_twin(twins.vibrations[0], {}).vibration;
    std::get<Measurement>(twin.source).measures_version.clear();
    insert_twin(twins, twin);
    CHECK(words_on_twin(stale_patterns(twins), "a synthetic") == ", version not recorded");
    PatternSet after = twins;
    pattern(after, 0).amplitude_g *= 0.2;
    keep_versions(twins, after);
    CHECK(stale_patterns(after).twins == Names{"a synthetic"});
}

TEST_CASE("felt versions: a set file keeps them, and one of before stays as it was") {
    const TemporaryFolder folder;
    PatternSet set = rated();
    pattern(set, 0).amplitude_g *= 0.5;
    const auto file = folder.path / "set.json";
    REQUIRE(write_set_file(file, set));
    const auto back = read_set_file(file);
    REQUIRE(back);
    CHECK(back->set.ratings == set.ratings);
    CHECK(stale_patterns(back->set).edited == Names{"a"});
    PatternSet old = four();
    old.ratings = kept_ratings(said_of(old), "people.csv");
    REQUIRE(write_set_file(folder.path / "old.json", old));
    CHECK_FALSE(contains(bytes_of(folder.path / "old.json"), "version"));
    const auto odd = folder.write("odd.json", R"({"tactspace": 1, "patterns": [], "ratings": [
        {"labels": ["a", "b"], "condensed": [1], "versions": ["x"]}]})");
    CHECK(contains(read_set_file(odd).error().message,
                   "expected a version for each of 2 labels, got 1"));
}

TEST_CASE("felt versions: ratings of a study are of what was felt in it, as far as it tells") {
    PatternSet set = four();
    RatingStudy study = said_of(set);
    StudyHeader header;
    describe_set(header, set);
    pattern(set, 3).amplitude_g *= 0.5;
    const auto edited = [&set](RatingStudy of) {
        note_edited(of, set);
        return of.edited;
    };
    CHECK(edited(study).empty());  // nothing is told
    study.fingerprint = header.set_fingerprint;
    CHECK(edited(study) == names_of(set));  // some, nobody knows which
    study.versions = header.versions;
    CHECK(edited(study) == Names{"d"});
    set.ratings = kept_ratings(study, "study");
    note_versions(set.ratings, study, set);
    CHECK(stale_patterns(set).edited == Names{"d"});
    // On the way to a set of other patterns, each keeps its own.
    const auto moved = matched(study, {"d", "x", "b", "a"});
    REQUIRE(moved);
    CHECK(moved->versions == Names{header.versions[3], "", header.versions[1], header.versions[0]});
    CHECK(moved->gone == Names{"c"});
}

TEST_CASE("felt versions: another side of the set is not another version") {
    PatternSet set = rated();
    for (const std::string& name : names_of(four())) {
        insert_twin(set, synthetic_twin(set.vibrations[*place_named(set, name)], {}).vibration);
    }
    for (const Side side : {Side::intended, Side::measured}) {
        const auto study = study_of(one_side(set, side));
        REQUIRE(study);
        CHECK(study->edited.empty());
    }
    CHECK(study_of(measured_stand_ins(set))->edited.empty());
}

}  // namespace felt_versions_test
