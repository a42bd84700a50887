#include "model/system/leading_number.h"

namespace tact {

std::optional<LeadingNumber> leading_number(std::string_view text) {
    return leading_number_by_c(text);
}

}  // namespace tact
