// Files as they are after an accident: by seed, so that a failure can be looked at again.
#pragma once

#include <cstddef>
#include <random>
#include <string>
#include <vector>

inline std::size_t any_below(std::mt19937& random, std::size_t count) {
    return static_cast<std::size_t>(random()) % count;
}

// The bytes with one to four mishaps: a bit turned over, an end cut off, a piece twice (keys,
// lines, chunks), a piece gone, a number replaced by one that is hard to keep.
inline std::string after_mishaps(std::string bytes, std::mt19937& random) {
    static const std::vector<std::string> kHard{"1e308",
                                                "1e309",
                                                "-1e999",
                                                "5e-324",
                                                "-0",
                                                "-0.0",
                                                "0.1000000000000000055",
                                                "nan",
                                                "inf",
                                                "null",
                                                "\"1\"",
                                                "123456789012345678901234567890",
                                                "-1",
                                                "1e-400"};
    for (std::size_t k = 0, count = 1 + any_below(random, 4); k < count && !bytes.empty(); ++k) {
        const std::size_t at = any_below(random, bytes.size());
        const std::size_t length = 1 + any_below(random, 40);
        switch (any_below(random, 5)) {
            case 0:
                bytes[at] = static_cast<char>(bytes[at] ^ (1 << any_below(random, 8)));
                break;
            case 1:
                bytes.erase(bytes.size() - any_below(random, 20) % bytes.size());
                break;
            case 2:
                bytes.insert(at, bytes.substr(at, length));
                break;
            case 3:
                bytes.erase(at, length);
                break;
            default: {
                const std::size_t begin = bytes.find_first_of("0123456789", at);
                if (begin == bytes.npos) break;
                const std::size_t end = bytes.find_first_not_of("0123456789.", begin);
                bytes.replace(begin, end == bytes.npos ? 1 : end - begin,
                              kHard[any_below(random, kHard.size())]);
            }
        }
    }
    return bytes;
}
