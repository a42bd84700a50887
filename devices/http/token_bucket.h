// How many requests somebody may make: a number a second on average, some more at once.
#pragma once

#include <algorithm>

namespace tact {

struct TokenBucket {
    double tokens = 0.0;
    double at_s = 0.0;  // when that was so

    bool operator==(const TokenBucket&) const = default;
};

struct BucketSize {
    double rate_hz = 20.0;
    double burst = 40.0;
};

inline TokenBucket full_bucket(const BucketSize& size, double now_s) { return {size.burst, now_s}; }

// Whether one more is allowed now; then it counts.
inline bool take_token(TokenBucket& bucket, const BucketSize& size, double now_s) {
    const double since_s = std::max(0.0, now_s - bucket.at_s);
    bucket = {std::min(size.burst, bucket.tokens + size.rate_hz * since_s), now_s};
    if (bucket.tokens < 1.0) return false;
    bucket.tokens -= 1.0;
    return true;
}

}  // namespace tact
