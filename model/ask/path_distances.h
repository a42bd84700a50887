// How far places on the way from one pattern to another are apart, as the model sees them. Private
// to the room.
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "model/ask/steps.h"
#include "model/morph/morph.h"

namespace tact {

class PathDistances {
  public:
    PathDistances(const StepsQuestion& question, const StepsOptions& options);

    Pattern at(double share) const;

    // Makes the codes of these places, those not yet known, on several threads. False when stopped.
    bool prepare(const std::vector<double>& shares);

    // Distances of pairs of prepared places, in their order: exact, or with envelopes at 1 kHz for
    // a hundredth of the work. Infinite for some when stopped.
    using Pairs = std::vector<std::pair<double, double>>;
    std::vector<double> of(const Pairs& pairs, bool exact) const;

    // Takes the largest NC and OC of these pairs for 1; the largest OC is that of the pair whose
    // coarse one is largest, exactly. Before that, distances are 0.
    void scale_by(const Pairs& pairs);
    // Takes these for 1.
    void scale_to(double largest_nc, double largest_oc);

    // An NC and an OC as they are scaled.
    double sum_of(double nc, double oc) const { return nc_scale_ * nc + oc_scale_ * oc; }

  private:
    struct Place {
        std::shared_ptr<const PatternCode> code;
        std::vector<double> coarse;  // its envelope
    };
    std::vector<double> nc_of(const Pairs& pairs) const;
    std::vector<double> oc_of(const Pairs& pairs, bool exact) const;

    const StepsQuestion& question_;
    const StepsOptions& options_;
    std::size_t samples_ = 0;
    std::map<double, Place> places_;
    Morph morph_;
    double nc_scale_ = 0.0;
    double oc_scale_ = 0.0;
};

}  // namespace tact
