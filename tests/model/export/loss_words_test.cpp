// The loss of an export in words.
#include "model/export/loss_words.h"

#include <doctest/doctest.h>

namespace loss_words_test {

using namespace tact;

namespace {

ExportLoss three_patterns() {
    ExportLoss loss;
    loss.patterns = {{"a", false, {"thinned"}, 0.1, 20.04, 9.0},
                     {"b", false, {}, 0.0, {}, 0.0},
                     {"c", true, {}, 0.0, {}, 0.0}};
    loss.after = {3, {2.0, 3.0, 1.25}};
    loss.closest_before = ConfusablePair{0, 1, 4.5};
    loss.closest_after = ConfusablePair{1, 2, 1.25};
    SubsetChange change;
    change.problem.count = 2;
    change.meant.best = {{0, 1}, {0, 1}, 4.5, 4.5};
    change.meant.proof = SubsetProof::optimal;
    change.weakest = {0, 1, 2.0};
    change.kept = {{0, 1}, {0, 1}, 2.0, 2.0};
    change.best.best = {{0, 2}, {0, 2}, 3.0, 3.0};
    change.best.proof = SubsetProof::optimal;
    change.is_still_best = false;
    loss.subset = change;
    return loss;
}

}  // namespace

TEST_CASE("loss in words: the verdict names what would be better, and by how much") {
    ExportLoss loss = three_patterns();
    CHECK(subset_verdict(loss) ==
          "The 2 most distinct, proven: a, b. For this target they are not the best: c in place of "
          "b, proven: its weakest pair is at 3 in place of 2");
    // The numbers are on the scale of the table: where that has no gain, none is shown.
    loss.after.condensed = {2.0, 2.0, 1.25};
    CHECK(subset_verdict(loss).ends_with("b, proven, by PM of the exported set alone"));
    loss.subset->is_still_best = true;
    loss.subset->best.proof = SubsetProof::open;
    CHECK(subset_verdict(loss) ==
          "The 2 most distinct, proven: a, b. They are still the best for this target, the best "
          "found in time");
    loss.subset.reset();
    loss.no_subset = "too few";
    CHECK(subset_verdict(loss) == "No subset: too few");
}

TEST_CASE("loss in words: the verdict names what the target silences") {
    ExportLoss loss = three_patterns();
    loss.subset->silenced = {1};
    CHECK(subset_verdict(loss) ==
          "The 2 most distinct, proven: a, b. For this target they are not the best: c in place of "
          "b, proven; nothing can be felt there of b");
    loss.patterns[1].silenced = true;
    CHECK(
        summary_of(loss).starts_with("1 of 2 patterns loses something; nothing can be felt of 1"));
}

TEST_CASE("loss in words: a better sum alone is not called a better weakest pair") {
    ExportLoss loss = three_patterns();
    loss.subset->best.best.weakest_dissimilarity = 2.0;
    CHECK(subset_verdict(loss).find("the sum of its pairs is at 3 in place of 2") !=
          std::string::npos);
}

TEST_CASE("loss in words: the summary counts patterns that lose, and those that went far") {
    ExportLoss loss = three_patterns();
    CHECK(summary_of(loss) ==
          "1 of 2 patterns loses something; 1 is farther from what was meant than the closest pair "
          "is apart");
    loss.patterns[0].remarks.clear();
    loss.patterns[0].moved = 4.5;
    CHECK(summary_of(loss) == "None of 2 patterns loses anything");
}

TEST_CASE("loss in words: what is not written is not counted, and comes after what is") {
    const ExportLoss loss = three_patterns();
    const std::vector<std::size_t> written{1};
    CHECK(summary_of(loss, written) == "None of 1 pattern loses anything");
    CHECK(written_first(loss, written) == std::vector<std::size_t>{1, 0, 2});
}

TEST_CASE("loss in words: before and after with the pairs they are of") {
    const ExportLoss loss = three_patterns();
    CHECK(before_after_rows(loss) ==
          std::vector<BeforeAfter>{{"closest pair", "4.5, a and b", "1.25, b and c"},
                                   {"weakest pair of the 2 picked", "4.5, a and b", "2, a and b"}});
    CHECK(psnr_text(loss.patterns[0]) == "20");
    CHECK(psnr_text(loss.patterns[1]) == "-");
}

}  // namespace loss_words_test
