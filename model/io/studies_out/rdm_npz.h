// What each person said as representational dissimilarity matrices, in a file of NumPy arrays.
//
//     import numpy, rsatoolbox
//     a = numpy.load("rdms.npz")
//     rdms = rsatoolbox.rdm.RDMs(a["dissimilarities"],
//                                rdm_descriptors={"participant": a["participants"]},
//                                pattern_descriptors={"pattern": a["patterns"]})
//
// Source    .npy version 1.0 and .npz: numpy.lib.format; zip: APPNOTE 6.3, stored, CRC-32 by zlib
// Output    dissimilarities: people x pairs, float64, NaN where not rated, pairs (0,1), (0,2), ..;
//           participants and patterns: texts; synthetic: 1 where nobody was asked for some of them
// Exact     same input, same bytes: no time is written.
#pragma once

#include <string>

#include "model/study/ratings.h"

namespace tact {

// The bytes of the file; of each participant the mean over repetitions.
std::string rdm_npz(const RatingStudy& study);

}  // namespace tact
