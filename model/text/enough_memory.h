// Reading that ends in a sentence where the memory does.
#pragma once

#include <new>
#include <stdexcept>
#include <string>

#include "model/common/expected.h"

namespace tact {

// What `read` gives; an Error of this file where it needs more memory than there is.
template <class Read>
auto with_enough_memory(const std::string& file, const Read& read) -> decltype(read()) {
    try {
        return read();
    } catch (const std::bad_alloc&) {
        return Error{file + ": cannot be read: there is not enough memory"};
    } catch (const std::length_error&) {
        return Error{file + ": cannot be read: there is not enough memory"};
    }
}

}  // namespace tact
