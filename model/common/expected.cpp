#include "model/common/expected.h"

#include <exception>
#include <new>
#include <stdexcept>

namespace tact {

namespace {

Error words_of_thrown() {
    const Error no_memory{
        "there is not enough memory for this; fewer or shorter patterns and fewer threads need "
        "less"};
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return no_memory;
    } catch (const std::length_error&) {
        return no_memory;  // more than a container can hold
    } catch (const std::exception& thrown) {
        return Error{std::string("the work failed: ") + thrown.what()};
    } catch (...) {
        return Error{"the work failed"};
    }
}

}  // namespace

Error thrown_error() {
    try {
        return words_of_thrown();
    } catch (...) {
        return Error{"out of memory"};  // not even enough for a sentence: these need none
    }
}

}  // namespace tact
