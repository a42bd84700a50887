#include "model/text/unused_names.h"

namespace tact {

std::string UnusedNames::unused(const std::string& wanted) {
    std::string name = wanted;
    while (!taken.insert(name).second) {
        int& number = last_number.try_emplace(wanted, 1).first->second;
        name = wanted + " " + std::to_string(++number);
    }
    return name;
}

}  // namespace tact
