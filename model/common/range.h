// The values that a number may have, both ends included.
#pragma once

namespace tact {

struct Range {
    double low;
    double high;

    bool contains(double value) const { return value >= low && value <= high; }
    bool operator==(const Range&) const = default;
};

}  // namespace tact
