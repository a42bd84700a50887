// What is to be said of several metrics, each thing once with all that it holds for.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace tact {

struct SaidOnce {
    std::vector<std::pair<std::string, std::string>> said;  // what, and of which, with commas

    void add(const std::string& what, const std::string& of) {
        const auto known =
            std::ranges::find(said, what, &std::pair<std::string, std::string>::first);
        if (known == said.end()) {
            said.emplace_back(what, of);
        } else {
            known->second += ", " + of;
        }
    }
};

}  // namespace tact
