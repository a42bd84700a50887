// Which way the numbers of ratings run.
#pragma once

namespace tact {

enum class RatingScale {
    guess,  // similarities if identical pairs are rated higher than others, else dissimilarities
    dissimilarity,
    similarity  // 0 .. 100
};

}  // namespace tact
